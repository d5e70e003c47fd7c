"""Opponent samplers: which archived opponents the learning team plays against in an epoch.

All schedules use one interface. There are `available` archived opponents, numbered from the oldest;
the sampler chooses some of them for each epoch::

    sampler = opponents.HallOfFame(newest=1, sampled=4)
    chosen = sampler.sample(available, epoch, rng)      # numbers; the caller holds the genomes
    sampler.tell(chosen, scores)                        # (n, len(chosen)): n candidates

`samplers` has the interface `OpponentSampler`, the samplers that use only the number of opponents,
and those that use scores: `Prioritized` (Vinyals et al. 2019), `SharedSampling` (Rosin & Belew
1997). `archives` has the Pareto archives `MaxSolve` (de Jong 2005), `IPCA` and `LAPCA` (both 2004),
`Generalist` (Simione & Nolfi 2021), the `ArchiveSampler` of what an archive has kept, and
`MetaStrategy` (PSRO: Lanctot et al. 2017).

A sampler or archive belongs to one team and does not know which: with payoffs ``1 - payoff``,
transposed, the other team gets the mirror image. Archived members are read-only copies. All that
changes is saved and restored by ``state`` and ``restore`` as plain arrays, and all random numbers
come from the generator of the caller, so that a restored run continues bit for bit. Nothing here
knows a world. Values out of range, and scores or payoffs of another shape, raise a ValueError that
names them.
"""

from __future__ import annotations

from matrixworld.coevolution.opponents.archives import (
    IPCA,
    LAPCA,
    Archive,
    ArchiveSampler,
    Generalist,
    MaxSolve,
    MetaStrategy,
)
from matrixworld.coevolution.opponents.samplers import (
    HallOfFame,
    Latest,
    OpponentSampler,
    Prioritized,
    RoundRobin,
    SharedSampling,
    Stateless,
    Uniform,
    even,
    hard,
)

__all__ = [
    "IPCA",
    "LAPCA",
    "Archive",
    "ArchiveSampler",
    "Generalist",
    "HallOfFame",
    "Latest",
    "MaxSolve",
    "MetaStrategy",
    "OpponentSampler",
    "Prioritized",
    "RoundRobin",
    "SharedSampling",
    "Stateless",
    "Uniform",
    "even",
    "hard",
]
