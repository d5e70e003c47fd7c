"""A game of your own in the settings of a race: by its name, with a digest of its source."""

from __future__ import annotations

from functools import cached_property
from typing import Any, ClassVar

from matrixworld._util import checks
from matrixworld._util.plugins import PATH
from matrixworld._util.sections import OWN, SettingError, section, setting
from matrixworld.coevolution.games.game import Game, GameSettings
from matrixworld.coevolution.games.names import code_of, object_of


@section(OWN)
class OwnGame(GameSettings):
    """A game of your own: its name, and what a run must know of it without an import."""

    base: ClassVar[type] = Game

    code: str = setting("", "module:object")
    genes: tuple[int, ...] = setting((), "length of the genomes of each team")
    # Under the names that config.json has for `teams` and `deterministic` of the game.
    names: tuple[str, ...] = setting((), "names of the teams")
    exact: bool = setting(False, "whether equal genomes always have equal scores")
    texts: bool = setting(False, "whether genomes are objects, held as text")
    score_of: str = setting("one", "whether teams have one score or both")
    one_population: bool = setting(False, "whether one population plays both sides")
    extras: tuple[str, ...] = setting((), "what else the game tells of a match")
    digest: str = setting("", "digest of its source")

    @classmethod
    def named(cls, game: Game) -> dict[str, Any]:
        """Return the name of a game; ValueError of one that cannot be found by a name."""
        return {"code": code_of(game)}

    def check(self) -> None:
        """Import a game that is given by its name alone, and set the other fields from it.

        Errors are those of `evaluation`.
        """
        if not PATH.fullmatch(self.code):
            raise SettingError("code", "module:object", checks.shown(self.code))
        if self.digest:  # of a run, which is read without an import
            return
        game = self._imported()
        for name, field in FIELDS.items():
            object.__setattr__(self, name, getattr(game, field))
        object.__setattr__(self, "digest", game.digest)

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
        kinds = {field: getattr(self, name) for name, field in FIELDS.items()}
        kinds["genes"] = kinds.pop("sizes")
        missing = _not_imported
        if kinds.pop("texts"):
            kinds |= {"genes": None, "initial": missing, "mutate": missing}
        return Game(missing, **kinds)

    def evaluation(self) -> Game:
        """Return the game; ValueError if there is none of this name, or one with other fields."""
        game = self._imported()
        for name, field in FIELDS.items():
            expected, got = getattr(self, name), getattr(game, field)
            if got != expected:
                what = "genes" if field == "sizes" else field
                raise ValueError(f"{self.code}: expected a game with {what} {expected}, got {got}")
        return game

    def training(self, *, alone: bool) -> Game:
        """Return the game, which is the same in training."""
        return self.evaluation()

    def changed(self) -> str:
        """Return in words that the source of the game has changed; empty if it has not."""
        if self.evaluation().digest == self.digest:
            return ""
        return f"{self.code}: expected the source of the game as it was, got a changed one"

    def _imported(self) -> Game:
        game = object_of(self.code)
        if not isinstance(game, Game):
            raise ValueError(f"{self.code}: expected a Game, got {checks.shown(game)}")
        object.__setattr__(game, "found_as", self.code)
        return game


FIELDS = {
    "genes": "sizes", "names": "teams", "exact": "deterministic", "texts": "texts",
    "score_of": "scores", "one_population": "symmetric", "extras": "extras",
}  # fmt: skip
"""What a run must know of a game without an import, and where the game has it."""


def _not_imported(*_: Any) -> Any:
    raise TypeError("play: expected a game that is imported")
