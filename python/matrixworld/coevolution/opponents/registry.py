"""Opponent samplers by name, and the alternating schedules that name one for each team.

`k` is the generation that learns (from 1), `i` the epoch inside it (from 0). The archives begin
with the untrained `p[0]` and `e[0]`. In each generation the pursuers learn first, then the evaders:
the opponents of the pursuers of generation `k` are among `e[0..k-1]`, those of the evaders among
`p[0..k]`. The paper's three schedules (Sun et al. 2023, "MatrixWorld", arXiv:2307.14854):

==========================  =========================  =========================
schedule                    opponents of the pursuers  opponents of the evaders
==========================  =========================  =========================
specialist-specialist       ``e[k - 1]``               ``p[k]``
generalist-specialist       ``e[i mod k]``             ``p[k]``
generalist-generalist       ``e[i mod k]``             ``p[i mod (k + 1)]``
==========================  =========================  =========================

The opponents of specialists are the `Latest`, those of generalists all by `RoundRobin`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from matrixworld.coevolution.opponents.archive_sampler import ArchiveSampler
from matrixworld.coevolution.opponents.generalist import Generalist
from matrixworld.coevolution.opponents.own import new_own_sampler
from matrixworld.coevolution.opponents.pareto import IPCA, LAPCA, MaxSolve
from matrixworld.coevolution.opponents.prioritized import Prioritized, even, hard
from matrixworld.coevolution.opponents.samplers import (
    HallOfFame,
    Latest,
    OpponentSampler,
    RoundRobin,
    Uniform,
)
from matrixworld.coevolution.opponents.shared_sampling import SharedSampling
from matrixworld.coevolution.plugins import OPPONENT, find
from matrixworld.coevolution.types import Team

SAMPLERS: dict[str, Callable[[int, int], OpponentSampler]] = {
    "latest": lambda count, size: Latest(count),
    "uniform": lambda count, size: Uniform(count),
    "round-robin": lambda count, size: RoundRobin(count),
    "hall-of-fame": lambda count, size: HallOfFame(newest=count // 2, sampled=count - count // 2),
    "prioritized-hard": lambda count, size: Prioritized(hard(), count=count),
    "prioritized-even": lambda count, size: Prioritized(even, count=count),
    "shared-sampling": lambda count, size: SharedSampling(count),
    "maxsolve": lambda count, size: ArchiveSampler(MaxSolve(size), count),
    "ipca": lambda count, size: ArchiveSampler(IPCA(), count),
    "lapca": lambda count, size: ArchiveSampler(LAPCA(size), count),
    "generalist": lambda count, size: ArchiveSampler(
        # All members are generation 0 at the start.
        Generalist(np.zeros(size, dtype=np.intp), sample_size=size),
        count,
    ),
}
"""Name -> factory: (opponents an epoch, size of an archive) -> a new sampler.

Half of the opponents of `hall-of-fame` are the newest; the other half, or one more, are drawn from
the older ones. With one opponent it draws from all, as `uniform` does. Samplers with an archive
play against the newest opponent, too (`ArchiveSampler`). The size is the candidates of MaxSolve,
the layers of LAPCA, and the team and the kept opponents of Generalist.

A name that is not in the table is one of a sampler from outside the package (see `plugins`). To add
a sampler to the package, write a class with the interface `OpponentSampler` and add a row.
"""


def new_sampler(settings: Any, team: Team) -> OpponentSampler:
    """Return a new opponent sampler of the kind that the settings name for a team.

    Parameters
    ----------
    settings : RaceSettings
        Settings of the race.
    team : {"pursuer", "evader"}
        Team that learns.

    Returns
    -------
    OpponentSampler
        The sampler.

    Raises
    ------
    ValueError
        If a sampler from outside the package cannot be imported, or refuses its settings.
    PluginError
        If its code fails.
    """
    name = settings.sampler_name(team)
    # A hall-of-fame race without sampled opponents has samplers, too, but never asks them.
    count = max(1, settings.opponents_per_epoch)
    if name in SAMPLERS:
        return SAMPLERS[name](count, settings.archive_size)
    plugin = find(f"{team}s_meet", name, SAMPLERS, OPPONENT)
    return new_own_sampler(plugin, count, settings.sampler_settings(team))


@dataclass(frozen=True)
class Schedule:
    """An alternating schedule: the sampler of each team.

    Parameters
    ----------
    pursuers_meet, evaders_meet : str
        Names in `SAMPLERS` of the samplers of the pursuers' and of the evaders' opponents.
    """

    pursuers_meet: str
    evaders_meet: str

    def sampler_name(self, team: Team) -> str:
        """Return the name of a team's sampler."""
        return self.pursuers_meet if team == "pursuer" else self.evaders_meet

    def sampler(self, team: Team) -> OpponentSampler:
        """Return a new sampler of one opponent an epoch."""
        # The samplers of schedules have no archive, so the size does not matter.
        return SAMPLERS[self.sampler_name(team)](1, 1)


SCHEDULES: dict[str, Schedule] = {
    "specialist-specialist": Schedule("latest", "latest"),
    "generalist-specialist": Schedule("round-robin", "latest"),
    "generalist-generalist": Schedule("round-robin", "round-robin"),
}
"""The paper's schedules by name."""
ALTERNATING = "alternating"
"""Name of the alternating schedule whose samplers are given by settings."""
HALL_OF_FAME = "hall-of-fame"
"""Name of the schedule in which both teams learn at the same time."""


def available(team: Team, k: int) -> int:
    """Return the number of opponents when a team learns one of its generations in alternation.

    Parameters
    ----------
    team : {"pursuer", "evader"}
        The team that learns.
    k : int
        Number of the generation that it learns, from 1.

    Returns
    -------
    int
        The archived generations of the other team.

    Raises
    ------
    ValueError
        If `k` is below 1.
    """
    # Generation 0 is untrained.
    if k < 1:
        raise ValueError(f"generation: expected at least 1, got {k}")
    # The pursuers learn first, so the evaders can play against generation k already.
    return k if team == "pursuer" else k + 1
