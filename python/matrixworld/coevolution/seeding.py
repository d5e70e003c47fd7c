"""Who is who, and which random numbers belong to whom.

Every random number of a run is drawn from a generator made from a key: the run's seed, a purpose,
and a position (team, generation, epoch). No generator is ever carried along, so a run that was
stopped and resumed draws what it would have drawn, and there is no generator state to save.
"""

from __future__ import annotations

from enum import IntEnum

import numpy as np

from matrixworld.coevolution.seed_sequence import seeds_of_keys
from matrixworld.coevolution.types import Seeds, Team
from matrixworld.rollout import match_seed


class Purpose(IntEnum):
    """What a generator is for; generators of two purposes are independent."""

    INITIAL = 1
    NOISE = 2
    LEARN = 3
    OPPONENTS = 4


class Phase(IntEnum):
    """Which matches a seed is for. Evaluation seeds carry no phase (see `evaluation_seed`)."""

    PURSUERS_LEARN = 1
    EVADERS_LEARN = 2
    BOTH_LEARN = 3
    HELD_OUT = 4
    ARCHIVE = 5


def learning_phase(team: Team) -> Phase:
    """Return the phase in which `team` learns and the other stands still."""
    return Phase.PURSUERS_LEARN if team == "pursuer" else Phase.EVADERS_LEARN


def keyed_generator(seed: int, purpose: Purpose, *key: int) -> np.random.Generator:
    """Return the generator of one purpose at one position of a run.

    Parameters
    ----------
    seed : the run's seed.
    purpose : what the numbers are for.
    key : non-negative integers, such as (team index, generation, epoch).
    """
    sequence = np.random.SeedSequence(seed, spawn_key=(int(purpose), *key))
    return np.random.Generator(np.random.SFC64(sequence))


def evaluation_seed(run_seed: int, pursuer_generation: int, evader_generation: int) -> int:
    """Return the match seed of one cell of a run's payoff matrix.

    World `j` of that match is its episode `j`, so
    ``record(config, pursuers, evaders, seed=evaluation_seed(s, g, h), pursuer=g, evader=h,
    episode=j)`` plays one counted episode again.
    """
    return match_seed(run_seed, pursuer_generation, evader_generation)


def training_seeds(
    run_seed: int,
    pursuer_generation: int,
    evader_generation: int,
    phase: Phase,
    epoch: int,
    count: int,
) -> Seeds:
    """Return the seeds, (count,) uint64, of the matches of one epoch of training.

    That of match i is ``match_seed`` of the other arguments and i.
    """
    key = (run_seed, pursuer_generation, evader_generation, int(phase), epoch)
    return seeds_of_keys(key, count)
