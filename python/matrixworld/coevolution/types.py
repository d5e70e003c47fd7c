"""Types that the modules of co-evolution share: teams, genomes, arrays by dtype, and payoffs.

Whatever a game calls its teams, its first team is the pursuers here, and the second the evaders.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import DTypeLike, NDArray

from matrixworld._util.readable import Parts, Readable, matrix_table
from matrixworld._util.teams import BOTH as BOTH
from matrixworld._util.teams import TEAMS as TEAMS
from matrixworld._util.teams import Team as Team
from matrixworld._util.teams import other as other
from matrixworld.analysis.payoffs import Payoffs, read_payoffs


def team_size(team: Any) -> int:
    """Return how many candidates a team has: its genomes, or one."""
    return len(team.genomes) if hasattr(team, "genomes") else 1


Genome = NDArray[Any]
"""What a member of a team is, such as the weights of its policy, shape (genes,) of float32; of
other objects the text, shape (1,)."""
Genomes = NDArray[Any]  # one genome a row, shape (n, genes)
Seeds = NDArray[np.uint64]  # seeds of matches
Rng = np.random.Generator  # what all random numbers are drawn from

Row = dict[str, Any]  # an epoch in the log, by column
Archive = dict[str, Genomes]  # the genomes of each team

LOGGED: dict[str, type] = {
    "stage": int,
    "generation": int,
    "team": str,
    "epoch": int,
    "opponent": int,
    "fitness_mean": float,
    "fitness_std": float,
    "fitness_best": float,
}
"""Columns of the log, one row per epoch, and their types, before those of the game
(`Game.columns`).

`stage` counts the stages of the run from 1; `opponent` is the opponent's generation (-1: several
opponents); `fitness_*` are over the candidates of the epoch; `capture_rate` or `score`, `length`
and `*_faults` (agent-steps at fault in a collision) are means over its episodes; `matches` and
`steps` are the training episodes and world steps played so far in the run. Matches after the last
epoch of a generation, which choose its champion, count in the row of that epoch.
"""
SEVERAL = -1  # value of `opponent` in the log of an epoch with several opponents

Indices = NDArray[np.intp]
FloatArray = NDArray[np.float64]
BoolArray = NDArray[np.bool_]
IntArray = NDArray[np.int64]
Matches: TypeAlias = tuple[NDArray[Any], NDArray[Any], Seeds]
"""M matches: numbers of both players (M,) in their populations, and seeds (M,)."""


@dataclass(frozen=True, eq=False, repr=False)
class Payoff(Readable):
    """Results of G members of the first team against H of the second, in n episodes a pair.

    `scores` (G, H, n) are those of the first team, row g against column h, in [0, 1]; the second
    team has `others` (G, H, n), or else 1 - score. A score is called `words`, the teams have names
    (`teams`), and in an `exact` game more episodes would have the same scores.

    What else the game tells are `extras`, each (G, H, ...). Of pursuit: ``lengths`` (G, H, n), the
    steps of each episode, int32; and means over the episodes, float64: ``collisions`` and
    ``faults`` (G, H, 2, 3), agent-steps in which an agent was involved, or at fault, in a
    collision, by team and kind (obstacle, teammate, adversary); ``agent_steps`` (G, H, 2), steps of
    living agents; ``pursuer_survivors`` and ``evader_survivors``, agents alive at the end.
    """

    scores: NDArray[np.float32]
    extras: Mapping[str, NDArray[Any]] = field(default_factory=dict)
    teams: tuple[str, str] = BOTH
    exact: bool = False
    words: str = "capture rate"
    others: NDArray[np.float32] | None = None

    def _parts(self) -> Parts:
        episodes = self.scores.shape[2]
        first, second = self.teams
        played = f"{episodes} episode{'' if episodes == 1 else 's'} a pair"
        against = "each other" if first == second else second
        head = f"{self.words.capitalize()}s of {first} (rows) against {against}, {played}:"
        return [head, matrix_table(self.matrix)]

    def __array__(self, dtype: DTypeLike | None = None, copy: bool | None = None) -> NDArray[Any]:
        """Return the payoff matrix, so that figures and measures take the results as they are."""
        if copy is False:
            raise ValueError("copy: expected True or None, as means are a new array, got False")
        return np.asarray(self.matrix, dtype)

    @property
    def matrix(self) -> FloatArray:
        """Payoff matrix (G, H): mean scores of the first team."""
        # In float64: the sum of many float32 rates would round.
        return np.asarray(self.scores.mean(axis=2, dtype=np.float64))

    def payoffs(self) -> Payoffs:
        """Return what the analysis reads of it."""
        return payoffs_of([self])

    def arrays(self) -> dict[str, NDArray[Any]]:
        """Return scores, their `mean` and `std` over episodes, and the extras: payoff.npz."""
        spread = np.asarray(self.scores.std(axis=2, dtype=np.float64))
        more: dict[str, NDArray[Any]] = {} if self.others is None else {"others": self.others}
        if self.others is not None or self.teams[0] == self.teams[1]:  # what a judgement must know
            more["teams"] = np.array(self.teams)
        return {"scores": self.scores, "mean": self.matrix, "std": spread, **more, **self.extras}


def payoffs_of(runs: Sequence[Payoff]) -> Payoffs:
    """Return the payoffs of runs with the same settings as the analysis reads them."""
    scores = np.stack([run.scores for run in runs])
    first = runs[0]
    others = None
    if first.others is not None:
        others = np.stack([run.others for run in runs if run.others is not None])
    payoffs = read_payoffs(
        scores, per_episode=True, exact=first.exact, teams=first.teams, others=others
    )
    if first.teams == BOTH:
        return payoffs
    names = [name for name, values in first.extras.items() if values.ndim == 2]
    extras = {name: np.stack([run.extras[name] for run in runs]) for name in names}
    return replace(payoffs, extras=extras)
