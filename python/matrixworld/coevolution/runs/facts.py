"""Facts of a game: what the files of a run say of it, so that they are read without its settings.

Payoff, log and genomes need nothing else of a game, neither an import of it nor what its settings
are called in this version.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

from matrixworld.coevolution.games.game import Game, GameSettings
from matrixworld.coevolution.types import LOGGED

TYPES: dict[str, type] = {"int": int, "float": float, "str": str}
"""Types of columns by their names in files."""


class Facts(NamedTuple):
    """What the files of a run say of its game."""

    teams: tuple[str, str]  # what they are called
    keys: tuple[str, str]  # their names in logs and mappings
    exact: bool  # whether equal genomes always have equal scores
    score: str  # what the score of the first team is called
    columns: dict[str, str]  # of the log, and the names of their types

    @property
    def one_population(self) -> bool:
        """Whether one population plays both sides: both teams have one name."""
        return self.teams[0] == self.teams[1]

    @classmethod
    def of(cls, settings: GameSettings, game: Game) -> Facts:
        """Return the facts of a game that is raced by these settings."""
        columns = {**LOGGED, **game.columns}
        type_names = {name: kind.__name__ for name, kind in columns.items()}
        score, _ = game.score_words
        return cls(settings.teams, settings.keys, game.deterministic, score, type_names)

    @classmethod
    def read(cls, plain: Mapping[str, Any]) -> Facts:
        """Return the facts that config.json holds; KeyError, TypeError or ValueError if bad."""
        first_team, second_team = plain["teams"]
        first_key, second_key = plain["keys"]
        columns = dict(plain["columns"])
        for name, kind in columns.items():
            if kind not in TYPES:
                raise ValueError(f"{name}: expected one of {', '.join(TYPES)}, got {kind!r}")
        return cls(
            teams=(first_team, second_team),
            keys=(first_key, second_key),
            exact=plain["exact"],
            score=plain["score"],
            columns=columns,
        )
