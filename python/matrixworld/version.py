"""The package's version, the name under which it is installed, and its extras.

Modules import them from here, which does not import the whole package. The build reads
`__version__` from this file, and the name is the one in ``pyproject.toml``.
"""

from importlib import import_module
from typing import Any

__version__ = "0.3.0"

#: What ``pip`` installs. `matrixworld` on the Python package index is another project.
DISTRIBUTION = "matrixworld-pursuit"


class MissingExtraError(ImportError):
    """An optional part of the package is not installed; the message says how to install it."""


def install_hint(extra: str) -> str:
    """Return the shell command that installs an extra of ``pyproject.toml``, such as "video"."""
    return f"pip install '{DISTRIBUTION}[{extra}]'"


def imported(module: str, extra: str) -> Any:
    """Return a module that an extra installs; MissingExtraError if it is not installed."""
    try:
        return import_module(module)
    except ModuleNotFoundError as error:
        raise MissingExtraError(
            f"expected the module {error.name}, which is not installed: {install_hint(extra)}"
        ) from error
