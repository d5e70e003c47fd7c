"""Names of games of your own, ``module:object``, by which other processes find them."""

from __future__ import annotations

import sys
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any

from matrixworld._util.plugins import imported

if TYPE_CHECKING:
    from matrixworld.coevolution.games.game import Game

MAIN = ("__main__", "__mp_main__")
"""Names of the script that runs, and of its copy in processes that it has started."""


def code_of(game: Game) -> str:
    """Return the name of a game, a global variable of a module; ValueError of others.

    The module is that of its function `play`, or one of those in which the game was made.
    """
    places = dict.fromkeys((getattr(game.play, "__module__", ""), *game.made_in))
    modules = [sys.modules[name] for name in places if name in sys.modules]
    for module in modules:
        for name, value in vars(module).items():
            if value is game:
                return f"{_file_of(module) or module.__name__}:{name}"
    raise ValueError(
        "game: expected a global variable of the module that makes it, so that a run can find it "
        f"again, got one that is none of {' or '.join(places)}"
    )


def object_of(code: str) -> Any:
    """Return the object of a name; errors are those of `imported`."""
    module, _, name = code.partition(":")
    main = sys.modules["__main__"]
    # Imported once more, a script that runs would begin anew.
    running = main if module in ("__main__", _file_of(main)) else None
    return getattr(running, name, None) or imported(code)


def in_notebook(code: str) -> bool:
    """Return whether a name is of a notebook or a prompt, which no other process can import."""
    return code.partition(":")[0] == "__main__"


def _file_of(module: ModuleType) -> str:
    """Return by what name other processes import a script that runs; empty without such a name."""
    if module.__name__ not in MAIN:
        return ""
    spec = getattr(module, "__spec__", None)  # python -m package.module
    name: str = spec.name if spec else Path(getattr(module, "__file__", None) or "").stem
    return name if all(part.isidentifier() for part in name.split(".")) else ""
