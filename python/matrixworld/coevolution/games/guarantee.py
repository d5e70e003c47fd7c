"""Pursuit and evasion against the best response: what a team guarantees is its score, exactly.

A team that learns so needs no opponents. Its world has to be small enough to be solved.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any, ClassVar

import numpy as np

from matrixworld._util.sections import SettingError
from matrixworld.coevolution.games.game import Scores
from matrixworld.coevolution.games.policies import Cells, Programs, Ratings, inputs_of
from matrixworld.coevolution.games.pursuit import (
    BEST_RESPONSE,
    GUARANTEE,
    Pursuit,
    PursuitSettings,
    WorldConfig,
)
from matrixworld.coevolution.types import TEAMS, FloatArray, Matches, Team, other
from matrixworld.episodes.episode import Episode
from matrixworld.solver import Solution, States, best_response
from matrixworld.world.states import states_size, why_not_solved

DRAWN = ("ahead", "search")
"""Inputs that each episode draws: what reads them has no table."""
KEPT = 2
"""Worlds whose states are kept in memory."""
FEW = 20_000
"""With fewer states threads would wait for each other longer than one takes."""


@dataclass(frozen=True, eq=False)
class Guaranteed(Pursuit):
    """Pursuit and evasion in which the best response plays against a `team`.

    The score of a match is the capture rate of a genome against the best that the other team can do
    if it knows the genome and sees the whole world (`matrixworld.solver.best_response`). It has no
    chance: seeds and episodes make no difference.
    """

    deterministic: bool = True
    team: Team = "pursuer"

    single: ClassVar[tuple[str, ...]] = ()
    counters: ClassVar[tuple[str, ...]] = ()

    @property
    def columns(self) -> dict[str, type]:
        """Columns that logs have of an epoch, and their types."""
        return {"capture_rate": float, "matches": int}

    @property
    def means(self) -> tuple[str, ...]:
        """What a payoff holds means of: nothing."""
        return ()

    def opponent_named(self, team: Team, name: str) -> str:
        """Return the opponent, which no name changes."""
        return BEST_RESPONSE

    def opponent_without_genomes(self, team: Team, name: str, program: Any) -> str:
        """Return the opponent of a run."""
        return BEST_RESPONSE

    def response(self, champions: Any, number: int, threads: int | None = None) -> Solution:
        """Return the best response to one of some genomes of the team, or to what else plays."""
        if hasattr(champions, "genomes"):
            champions = replace(champions, genomes=champions.genomes[[number]])
        return best_response(_states(self.world, threads), champions, self.team)

    def rollout(
        self, first: Any, second: Any, matches: Matches, *, episodes: int, threads: int | None
    ) -> Scores:
        """Return the capture rate of M matches, each against the best response."""
        side = TEAMS.index(self.team)
        numbers, of_matches = np.unique(matches[side], return_inverse=True)
        rates = [self.response((first, second)[side], n, threads).value for n in numbers]
        return Scores(np.repeat(np.array(rates)[of_matches, np.newaxis], episodes, axis=1))

    def values(self, scores: Scores, team: Team, measure: str, *, raw: bool = False) -> FloatArray:
        """Return what a team is selected by, (M, N): what it guarantees, without a penalty."""
        return scores.of(team)

    def row(self, scores: Scores) -> dict[str, float]:
        """Return the values of an epoch in `columns`, without what is counted."""
        return {"capture_rate": float(scores.scores.mean())}

    def counted(self, scores: Scores) -> dict[str, int]:
        """Return what the matches add to `counters`: nothing."""
        return {}

    def record(self, pursuers: Any, evaders: Any, **match: Any) -> Episode:
        """Record an episode of a genome against the best response to it, or what else is given."""
        sides = {"pursuer": pursuers, "evader": evaders}
        rival = other(self.team)
        if sides[rival] == BEST_RESPONSE:
            response = self.response(sides[self.team], match.get(self.team, 0))
            sides[rival] = response.policy(rival)
        return super().record(sides["pursuer"], sides["evader"], **match)


@lru_cache(maxsize=KEPT)
def _states(world: WorldConfig, threads: int | None) -> States:
    """Return the states of a world, which all matches in it share."""
    count, _ = states_size(world)
    return States(world, threads=1 if count < FEW else threads)


def check_guarantee(game: PursuitSettings) -> None:
    """Raise SettingError unless best responses to what learns in a game can be computed."""
    policy = game.policy
    why = f"with the measure {GUARANTEE}"
    if isinstance(game.world.obstacles, float) and game.world.obstacles:
        raise SettingError("world.obstacles", f"0 or a map {why}", f"{game.world.obstacles:g}")
    if got := why_not_solved(game.world):
        raise SettingError("world", f"one that can be solved {why}", got)
    if game.training_worlds:
        raise SettingError("training_worlds", f"none {why}", f"{len(game.training_worlds)}")
    if isinstance(policy, Cells) and policy.memory != "none":
        raise SettingError("policy.memory", f"none {why}", repr(policy.memory))
    if isinstance(policy, Ratings | Programs):
        read = {name for team in TEAMS for name in inputs_of(team, policy.inputs)}
        for name in DRAWN:
            if name in read:
                expected = f"inputs that no episode draws {why}"
                raise SettingError("policy.inputs", expected, name)
