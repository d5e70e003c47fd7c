"""The code that called the package, from whatever depth inside it."""

from __future__ import annotations

import inspect
import warnings

IMPORTERS = ("importlib", "runpy")  # modules that run others
PACKAGE = __name__.partition(".")[0]


def warn_caller(message: str, category: type[Warning] = UserWarning) -> None:
    """Warn at the line outside the package that called it."""
    level = 1
    frame = inspect.currentframe()
    while frame is not None and _is_inside(frame.f_globals.get("__name__", "")):
        frame = frame.f_back
        level += 1
    warnings.warn(message, category, stacklevel=level)


def calling_modules() -> tuple[str, ...]:
    """Return the names of the modules outside the package that called it, the innermost first."""
    names: dict[str, None] = {}
    frame = inspect.currentframe()
    while frame is not None:
        name = frame.f_globals.get("__name__", "")
        if not _is_inside(name) and name.partition(".")[0] not in IMPORTERS:
            names[name] = None
        frame = frame.f_back
    return tuple(names)


def _is_inside(module: str) -> bool:
    return module.partition(".")[0] == PACKAGE
