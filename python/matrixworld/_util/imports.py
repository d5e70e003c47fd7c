"""Imports: what waits for its first use, and stand-ins in a browser.

A browser (Pyodide) has no processes, and so no locks or memory between them, which Gymnasium and
`concurrent.futures` import. DEAP imports a compiled package for several objectives. Stand-ins make
these imports work; nothing calls them there.
"""

from __future__ import annotations

import ast
import sys
from collections.abc import Callable, Mapping
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from types import ModuleType
from typing import Any

HAS_PROCESSES = find_spec("_multiprocessing") is not None

_LOCK = type("SemLock", (), {"SEM_VALUE_MAX": 1})
_STAND_INS: dict[str, dict[str, Any]] = {
    "_multiprocessing": {"SemLock": _LOCK, "sem_unlink": None},
    "_posixshmem": {"shm_unlink": None},
    "moocore": {},
}

if not HAS_PROCESSES:
    for _name in filter(lambda name: find_spec(name) is None, _STAND_INS):
        sys.modules[_name] = ModuleType(_name)
        vars(sys.modules[_name]).update(_STAND_INS[_name])


def lazy(
    package: str, file: str, meant: Mapping[str, str]
) -> tuple[Callable[[str], Any], Callable[[], list[str]], list[str]]:
    """Return ``__getattr__``, ``__dir__`` and ``__all__`` of a package that imports what is used.

    The stub beside `file` lists its names: ``from module import name as name``, and
    ``from . import name as name`` for packages in it, which ``__all__`` leaves out. `meant` has the
    right calls for names that are not there.
    """
    stub = ast.parse(Path(file).with_suffix(".pyi").read_text(encoding="utf-8"))
    imports = [node for node in stub.body if isinstance(node, ast.ImportFrom)]
    homes = {each.name: node.module for node in imports for each in node.names}
    public = sorted(name for name, home in homes.items() if home)

    def get(name: str) -> Any:
        if name not in homes:
            raise no_attribute(sys.modules[package], f"module {package!r}", name, meant)
        if (home := homes[name]) is None:
            return import_module(f"{package}.{name}")
        value = getattr(__import__(home, fromlist=[name]), name)
        setattr(sys.modules[package], name, value)  # found without this function from now on
        return value

    return get, lambda: sorted({*vars(sys.modules[package]), *homes}), public


def no_attribute(owner: Any, what: str, name: str, meant: Mapping[str, str]) -> AttributeError:
    """Return the error of a name that `owner` lacks, with the right call for it if one is known."""
    hint = f"; did you mean {meant[name]}?" if name in meant else ""
    return AttributeError(f"{what} has no attribute {name!r}{hint}", name=name, obj=owner)
