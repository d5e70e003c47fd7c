"""Opponent samplers: which archived opponents the learning team plays against in an epoch.

All schedules use one interface. There are `available` archived opponents, numbered from the oldest;
the sampler chooses some of them for each epoch::

    sampler = opponents.HallOfFame(newest=1, sampled=4)
    chosen = sampler.sample(available, epoch, rng)      # numbers; the caller holds the genomes
    sampler.tell(chosen, scores)                        # (n, len(chosen)): n candidates

================  ================================================================================
samplers          the interface `OpponentSampler`; `Latest`, `Uniform`, `RoundRobin`, `HallOfFame`
prioritized       `Prioritized`: by win rate, with `hard` or `even` (Vinyals et al. 2019)
shared_sampling   `SharedSampling`: strong and different opponents (Rosin & Belew 1997)
pareto            `Archive`, and the Pareto archives `MaxSolve` (de Jong 2005), `IPCA` (2004) and
                  `LAPCA` (2007)
generalist        `Generalist`: better against all opponents or not at all (Simione & Nolfi 2021)
archive_sampler   `ArchiveSampler`: the newest opponent beside those that an archive has kept
registry          `SAMPLERS` by name; `SCHEDULES`, which name a sampler for each team
own               samplers from outside the package, with checked results
================  ================================================================================

A sampler or archive belongs to one team and does not know which: with `swapped` payoffs the other
team gets the mirror image. Archived members are read-only copies. All that changes is saved and
restored by ``state`` and ``restore`` as plain arrays, and all random numbers come from the
generator of the caller, so that a restored run continues bit for bit. Nothing here knows a world.
"""

from __future__ import annotations

from matrixworld.coevolution.opponents.archive_sampler import ArchiveSampler
from matrixworld.coevolution.opponents.generalist import Generalist, maximally_different
from matrixworld.coevolution.opponents.pareto import (
    IPCA,
    LAPCA,
    Archive,
    MaxSolve,
    PayoffFunction,
    layers_of,
    read_only,
    swapped,
)
from matrixworld.coevolution.opponents.prioritized import Prioritized, Weighting, even, hard
from matrixworld.coevolution.opponents.registry import SAMPLERS
from matrixworld.coevolution.opponents.samplers import (
    HallOfFame,
    Latest,
    OpponentSampler,
    RoundRobin,
    Stateless,
    Uniform,
)
from matrixworld.coevolution.opponents.shared_sampling import SharedSampling, shared_sample

__all__ = [
    "IPCA",
    "LAPCA",
    "SAMPLERS",
    "Archive",
    "ArchiveSampler",
    "Generalist",
    "HallOfFame",
    "Latest",
    "MaxSolve",
    "OpponentSampler",
    "PayoffFunction",
    "Prioritized",
    "RoundRobin",
    "SharedSampling",
    "Stateless",
    "Uniform",
    "Weighting",
    "even",
    "hard",
    "layers_of",
    "maximally_different",
    "read_only",
    "shared_sample",
    "swapped",
]
