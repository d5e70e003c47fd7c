"""Alternating schedules: whom the learning team meets.

`k` is the generation that learns (from 1), `i` the epoch inside it (from 0). The archives begin
with the untrained `p[0]` and `e[0]`; in each generation the pursuers learn first, then the
evaders, so that the pursuers of generation `k` can meet `e[0..k-1]` and the evaders `p[0..k]`. The
paper's three:

==========================  =======================  =====================
schedule                    pursuers of k meet       evaders of k meet
==========================  =======================  =====================
specialist-specialist       ``e[k - 1]``             ``p[k]``
generalist-specialist       ``e[i mod k]``           ``p[k]``
generalist-generalist       ``e[i mod k]``           ``p[i mod (k + 1)]``
==========================  =======================  =====================

Specialists meet the `Latest` opponents, generalists all of them by `RoundRobin`.
"""

from __future__ import annotations

from dataclasses import dataclass

from matrixworld.coevolution.opponents.registry import SAMPLERS
from matrixworld.coevolution.opponents.samplers import OpponentSampler
from matrixworld.coevolution.types import Team


@dataclass(frozen=True)
class Schedule:
    """An alternating schedule: by what name of `SAMPLERS` each team selects whom it meets."""

    pursuers_meet: str
    evaders_meet: str

    def meets(self, team: Team) -> str:
        """Return the name of a team's selection."""
        return self.pursuers_meet if team == "pursuer" else self.evaders_meet

    def selection(self, team: Team) -> OpponentSampler:
        """Return a new selection of one opponent an epoch."""
        return SAMPLERS[self.meets(team)](1, 1)


SCHEDULES: dict[str, Schedule] = {
    "specialist-specialist": Schedule("latest", "latest"),
    "generalist-specialist": Schedule("round-robin", "latest"),
    "generalist-generalist": Schedule("round-robin", "round-robin"),
}
"""The paper's."""
ALTERNATING = "alternating"
"""Name of the schedule whose samplers are settings of their own."""
HALL_OF_FAME = "hall-of-fame"
"""Name of the schedule in which both teams learn at the same time (module `hall_of_fame`)."""


def available(team: Team, k: int) -> int:
    """Return how many opponents there are when `team` learns its generation `k`, in alternation."""
    if k < 1:
        raise ValueError(f"generation: expected at least 1, got {k}")
    return k if team == "pursuer" else k + 1
