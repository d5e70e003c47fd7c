"""Opponent selection: whom a learning team meets, by one interface.

A schedule that lets one team learn and one that lets both learn ask alike: there are `available`
archived opponents, numbered from the oldest; which of them in this epoch? ::

    selection = opponents.HallOfFame(newest=1, sampled=4)
    met = selection.choose(available, epoch, rng)       # numbers; the genomes are the caller's
    selection.tell(met, scores)                         # (n, len(met)): n candidates

================  ================================================================================
selection         the interface; `Latest`, `Uniform`, `RoundRobin` (the paper's), `HallOfFame`
prioritized       by win rate (Vinyals et al. 2019): `Prioritized` with `hard` or `even`
shared_sampling   strong and different ones (Rosin & Belew 1997): `SharedSampling`
archive           what is kept of both teams, by outcomes alone: the interface of the next three
maxsolve          `MaxSolve`: the candidates that solve most tests (de Jong 2005)
ipca              `IPCA`: the candidates that none dominates, and the tests that show it (2004)
lapca             `LAPCA`: the same in layers, bounded (2007); both use `distinctions`
generalist        `Generalist`: better against all or not at all (Simione & Nolfi 2021)
from_archive      `ArchiveSampler`: an archive as a selection
choices           `SAMPLERS`: all of them by name
================  ================================================================================

A selection or archive belongs to one team and does not know which: with `swapped` outcomes the
other team gets the mirror image. What is archived is copied and cannot be written to. Whatever
changes goes through ``state`` and ``restore`` as plain arrays, and all random numbers come from
the generator handed in, so that a restored run goes on bit for bit. Nothing here knows a world.
"""

from __future__ import annotations

from matrixworld.coevolution.opponents.archive_sampler import ArchiveSampler
from matrixworld.coevolution.opponents.generalist import Generalist, maximally_different
from matrixworld.coevolution.opponents.ipca import IPCA
from matrixworld.coevolution.opponents.lapca import LAPCA, layers_of
from matrixworld.coevolution.opponents.maxsolve import MaxSolve
from matrixworld.coevolution.opponents.pareto import (
    Archive,
    Members,
    PayoffFunction,
    protected,
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
from matrixworld.coevolution.types import Indices, State

__all__ = [
    "IPCA",
    "LAPCA",
    "SAMPLERS",
    "Archive",
    "ArchiveSampler",
    "Generalist",
    "HallOfFame",
    "Indices",
    "Latest",
    "MaxSolve",
    "Members",
    "OpponentSampler",
    "PayoffFunction",
    "Prioritized",
    "RoundRobin",
    "SharedSampling",
    "State",
    "Stateless",
    "Uniform",
    "Weighting",
    "even",
    "hard",
    "layers_of",
    "maximally_different",
    "protected",
    "shared_sample",
    "swapped",
]
