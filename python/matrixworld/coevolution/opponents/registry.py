"""Opponent selection by name, for settings and the command line."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from matrixworld.coevolution.opponents.archive_sampler import ArchiveSampler
from matrixworld.coevolution.opponents.generalist import Generalist
from matrixworld.coevolution.opponents.ipca import IPCA
from matrixworld.coevolution.opponents.lapca import LAPCA
from matrixworld.coevolution.opponents.maxsolve import MaxSolve
from matrixworld.coevolution.opponents.prioritized import Prioritized, even, hard
from matrixworld.coevolution.opponents.samplers import (
    HallOfFame,
    Latest,
    OpponentSampler,
    RoundRobin,
    Uniform,
)
from matrixworld.coevolution.opponents.shared_sampling import SharedSampling

SAMPLERS: dict[str, Callable[[int, int], OpponentSampler]] = {
    "latest": lambda count, size: Latest(count),
    "uniform": lambda count, size: Uniform(count),
    "round-robin": lambda count, size: RoundRobin(count),
    "hall-of-fame": lambda count, size: HallOfFame(newest=count // 2, sampled=count - count // 2),
    "prioritized-hard": lambda count, size: Prioritized(hard(), count=count),
    "prioritized-even": lambda count, size: Prioritized(even, count=count),
    "shared-sampling": lambda count, size: SharedSampling(count),
    "maxsolve": lambda count, size: ArchiveSampler(MaxSolve(size), Uniform(count)),
    "ipca": lambda count, size: ArchiveSampler(IPCA(), Uniform(count)),
    "lapca": lambda count, size: ArchiveSampler(LAPCA(size), Uniform(count)),
    "generalist": lambda count, size: ArchiveSampler(
        Generalist(np.zeros(size, dtype=np.intp), sample=size), Uniform(count)
    ),
}
"""name -> (opponents an epoch, size of an archive) -> a new selection.

Of `hall-of-fame` half are the newest and half, or one more, drawn from the older ones. The size is
MaxSolve's candidates, LAPCA's layers, Generalist's team and the opponents that it learns against.
"""
