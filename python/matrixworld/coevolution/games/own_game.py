"""A game of your own in the settings of a race: by its name, with a digest of its source."""

from __future__ import annotations

import inspect
import sys
from collections.abc import Iterator, Mapping, Set
from functools import cached_property, partial
from hashlib import sha256
from pathlib import Path
from types import CodeType, FunctionType, MethodType, ModuleType
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike

from matrixworld._util import checks
from matrixworld._util.plugins import PATH, imported
from matrixworld._util.sections import OWN, SettingError, section, setting
from matrixworld.coevolution.games.game import Game, GameSettings
from matrixworld.coevolution.types import Genomes, Rng


@section(OWN)
class OwnGame(GameSettings):
    """A game of your own: its name, and what a run must know of it without an import."""

    base: ClassVar[type] = Game

    code: str = setting("", "module:object")
    genes: tuple[int, ...] = setting((), "length of the genomes of each team")
    # Under the names that config.json has for `teams` and `deterministic` of the game.
    names: tuple[str, ...] = setting((), "names of the teams")
    exact: bool = setting(False, "whether equal genomes always have equal scores")
    digest: str = setting("", "digest of its source")

    @classmethod
    def named(cls, game: Game) -> dict[str, Any]:
        """Return the name of a game, a global of its function's module; ValueError of others."""
        module = sys.modules.get(getattr(game.play, "__module__", ""))
        names = [name for name, value in vars(module).items() if value is game] if module else []
        if module is None or not names:
            raise ValueError(
                "game: expected a global variable of the module of its function, so that a run can "
                f"find it again, got one that is none of {getattr(module, '__name__', 'a module')}"
            )
        return {"code": f"{_file_of(module) or module.__name__}:{names[0]}"}

    def check(self) -> None:
        """Import a game that is given by its name alone, and set the other fields from it.

        Errors are those of `evaluation`.
        """
        if not PATH.fullmatch(self.code):
            raise SettingError("code", "module:object", checks.shown(self.code))
        if self.digest:  # of a run, which is read without an import
            return
        game = self._imported()
        fields = {
            "genes": game.genes,
            "names": game.teams,
            "exact": game.deterministic,
            "digest": digest_of(game),
        }
        for name, value in fields.items():
            object.__setattr__(self, name, value)

    @property
    def variant(self) -> str:
        """The name of the game in its module."""
        return self.code.partition(":")[2]

    @property
    def source(self) -> str:
        """Where the game is found: its ``module:object``."""
        return self.code

    @cached_property
    def known(self) -> Game:
        """What is known of the game without an import: all but its functions."""
        genes: Any = self.genes
        names: Any = self.names
        return Game(_not_imported, genes, names, deterministic=self.exact)

    def evaluation(self) -> Game:
        """Return the game; ValueError if there is none of this name, or one with other fields."""
        game = self._imported()
        fields = {"genes": self.genes, "teams": self.names, "deterministic": self.exact}
        for name, expected in fields.items():
            got = getattr(game, name)
            if got != expected:
                raise ValueError(f"{self.code}: expected a game with {name} {expected}, got {got}")
        return game

    def training(self, *, alone: bool) -> Game:
        """Return the game, which is the same in training."""
        return self.evaluation()

    def changed(self) -> str:
        """Return in words that the source of the game has changed; empty if it has not."""
        if digest_of(self.evaluation()) == self.digest:
            return ""
        return f"{self.code}: expected the source of the game as it was, got a changed one"

    def _imported(self) -> Game:
        module, _, name = self.code.partition(":")
        main = sys.modules["__main__"]
        # Imported once more, a script that runs would begin anew.
        running = main if module in ("__main__", _file_of(main)) else None
        game = getattr(running, name, None) or imported(self.code)
        if not isinstance(game, Game):
            raise ValueError(f"{self.code}: expected a Game, got {checks.shown(game)}")
        return game


def _not_imported(a: Genomes, b: Genomes, rng: Rng) -> ArrayLike:
    raise TypeError("play: expected a game that is imported")


def _file_of(module: ModuleType) -> str:
    """Return by what name other processes import a script that runs; empty without such a name."""
    if module.__name__ not in MAIN:
        return ""
    spec = getattr(module, "__spec__", None)  # python -m package.module
    name: str = spec.name if spec else Path(getattr(module, "__file__", None) or "").stem
    return name if all(part.isidentifier() for part in name.split(".")) else ""


MAIN = ("__main__", "__mp_main__")
"""Names of the script that runs, and of its copy in processes that it has started."""


def digest_of(game: Game) -> str:
    """Return a digest of a game's fields and functions, the same in every process.

    It is of the source of its functions, and of all that they name in their own module: functions,
    numbers, text, arrays, collections of these, and the fields of objects that play. Of a function
    from another module it is of the source alone, of classes and modules of nothing.
    """
    lines = []
    for name in ("genes", "teams", "bounds", "deterministic", "play", "initial", "show"):
        value = getattr(game, name)
        texts: dict[str, str] = {}
        _add_texts(f"<{name}>", value, _module_of(value), texts)
        lines += [f"{key}\n{texts[key]}" for key in sorted(texts)]
    return sha256("\n".join(lines).encode()).hexdigest()[:16]


def _add_texts(name: str, value: Any, module: str, texts: dict[str, str]) -> None:
    """Add to `texts` those of a value, of what it is made of, and of what it names in a module.

    A global variable is added by its name, a part of a value by the name of the value and a number.
    """
    if name in texts:
        return
    function = _function_of(value)
    if function is None:
        texts[name] = _text_of(value)
        for number, part in enumerate(_parts_of(value)):
            _add_texts(f"{name}.{number}", part, module, texts)
        return
    texts[name] = _source_of(function)  # before the rest: a function may name itself
    if function.__module__ != module:
        return
    if isinstance(value, MethodType) and not isinstance(value.__self__, type):
        _add_texts(f"{name}.self", getattr(value.__self__, "__dict__", {}), module, texts)
    for used in sorted({*_names(function.__code__)} & function.__globals__.keys()):
        part = function.__globals__[used]
        if not isinstance(part, ModuleType | type):
            _add_texts(used, part, module, texts)


def _module_of(value: Any) -> str:
    """Return the name of the module that a function, or an object that plays, is defined in."""
    while isinstance(value, partial):
        value = value.func
    return getattr(value, "__module__", "")


def _function_of(value: Any) -> FunctionType | None:
    """Return a function as it is written, without its decorators; None of other values."""
    function = inspect.unwrap(getattr(value, "__func__", value))
    return function if isinstance(function, FunctionType) else None


def _source_of(function: FunctionType) -> str:
    """Return the source of a function; of a lambda it is that of its whole line."""
    try:
        return inspect.getsource(function)
    except OSError:  # typed at a prompt that keeps no source
        code = function.__code__
        return f"{code.co_code.hex()} {code.co_consts} {code.co_names}"


def _text_of(value: Any) -> str:
    """Return a text of a value; of what has parts, and of other objects, that of its type."""
    if isinstance(value, np.ndarray | np.generic):
        return repr(value.tolist())
    if isinstance(value, Set):  # its order differs from process to process
        return repr(sorted(map(_text_of, value)))
    if isinstance(value, int | float | complex | str | bytes | None):
        return repr(value)
    return type(value).__qualname__


def _parts_of(value: Any) -> list[Any]:
    """Return what a collection, a partial or an object that plays is made of."""
    if isinstance(value, Mapping):
        return list(value.items())
    if isinstance(value, tuple | list):
        return list(value)
    if isinstance(value, partial):
        return [value.func, value.args, value.keywords]
    call = getattr(type(value), "__call__", None)  # noqa: B004, of its class
    return [call, getattr(value, "__dict__", {})] if isinstance(call, FunctionType) else []


def _names(code: CodeType) -> Iterator[str]:
    """Yield the names that a function uses, with those of the functions inside it."""
    yield from code.co_names
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _names(constant)
