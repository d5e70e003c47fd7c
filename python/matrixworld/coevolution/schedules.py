"""The paper's three schedules: whom the learning team meets.

`k` is the generation that learns (from 1), `i` the epoch inside it (from 0). The archives begin
with the untrained `p[0]` and `e[0]`; in each generation the pursuers learn first, then the
evaders, so that the pursuers of generation `k` can meet `e[0..k-1]` and the evaders `p[0..k]`.

==========================  =======================  =====================
schedule                    pursuers of k meet       evaders of k meet
==========================  =======================  =====================
specialist-specialist       ``e[k - 1]``             ``p[k]``
generalist-specialist       ``e[i mod k]``           ``p[k]``
generalist-generalist       ``e[i mod k]``           ``p[i mod (k + 1)]``
==========================  =======================  =====================
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from matrixworld.coevolution.keys import Team

Meets = Callable[[int, int], int]
"""(generation k, epoch i) -> the opponent's generation."""


def newest_before(k: int, i: int) -> int:
    """Meet the opponents of the generation before this one."""
    return k - 1


def newest(k: int, i: int) -> int:
    """Meet the opponents of this generation."""
    return k


def all_before_in_turn(k: int, i: int) -> int:
    """Meet the opponents of all generations before this one in turn, one an epoch."""
    return i % k


def all_in_turn(k: int, i: int) -> int:
    """Meet the opponents of all generations up to this one in turn, one an epoch."""
    return i % (k + 1)


@dataclass(frozen=True)
class Schedule:
    """One alternating schedule: the opponent of each team in each epoch."""

    pursuers_meet: Meets
    evaders_meet: Meets

    def opponent(self, team: Team, k: int, i: int) -> int:
        """Return the generation that `team`, learning its generation `k`, meets in epoch `i`."""
        if k < 1 or i < 0:
            raise ValueError(f"expected generation >= 1 and epoch >= 0, got {k} and {i}")
        return (self.pursuers_meet if team == "pursuer" else self.evaders_meet)(k, i)


SCHEDULES: dict[str, Schedule] = {
    "specialist-specialist": Schedule(newest_before, newest),
    "generalist-specialist": Schedule(all_before_in_turn, newest),
    "generalist-generalist": Schedule(all_before_in_turn, all_in_turn),
}
HALL_OF_FAME = "hall-of-fame"
"""Name of the schedule in which both teams learn at the same time (module `hall_of_fame`)."""
