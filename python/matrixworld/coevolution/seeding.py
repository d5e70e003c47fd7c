"""The key of every random number of a run.

Every random number is drawn from a generator made from a key: the run's seed, a purpose, and a
position (team, generation, epoch). No generator is carried from one epoch to the next. A resumed
run therefore draws what an uninterrupted one would have drawn, and a checkpoint holds no generator.

=====================  ===========================================================================
random numbers         key
=====================  ===========================================================================
untrained genomes      run seed, `Purpose.INITIAL`, team
noise table            run seed, `Purpose.NOISE`, team
first weights of       run seed, `Purpose.NOISE`, team (actor-critic, which has no noise table)
critics
candidates of an       run seed, `Purpose.LEARN`, team, generation, epoch
epoch
opponents of an epoch  run seed, `Purpose.OPPONENTS`, team, generation, epoch (both teams of a
                       hall-of-fame race: team 0)
world of an epoch      run seed, `Purpose.WORLD`, team, generation, epoch (as opponents)
training matches       run seed, generation of the pursuers and of the evaders, `Phase`, epoch
matches that choose a  run seed, generation twice, `Phase.RETEST`, team
champion
matches of PSRO        run seed, generation of the pursuers and of the evaders, `Phase.ARCHIVE`,
                       0
held-out matches       seed of the scores, team, number of the opponent, `Phase.HELD_OUT`
matches that explain   seed of the explanation, number, 0, `Phase.EXPLAIN`; the result is the seed
                       of held-out matches, or of the matches in which inputs are seen
evaluation matches     run seed, generation of the pursuers and of the evaders
=====================  ===========================================================================

The team is its index in `TEAMS`. Keys of evaluation matches have three numbers; the others have the
phase as the fourth, and some a fifth. So of one seed no two kinds of matches have the same key.
"""

from __future__ import annotations

from enum import IntEnum
from typing import cast

import numpy as np

from matrixworld._util import checks
from matrixworld.coevolution.types import Seeds


class Purpose(IntEnum):
    """What a generator is for; generators of two purposes are independent."""

    INITIAL = 1
    NOISE = 2
    LEARN = 3
    OPPONENTS = 4
    WORLD = 5


class Phase(IntEnum):
    """What the matches of a seed are for. Evaluation seeds have no phase (`evaluation_seed`)."""

    PURSUERS_LEARN = 1
    EVADERS_LEARN = 2
    BOTH_LEARN = 3
    HELD_OUT = 4
    ARCHIVE = 5
    RETEST = 6
    EXPLAIN = 7


def keyed_generator(seed: int, purpose: Purpose, *key: int) -> np.random.Generator:
    """Return a new generator for one purpose at one position, such as (team, generation, epoch)."""
    # A spawn key keeps these generators apart from match seeds, which have plain keys.
    sequence = np.random.SeedSequence(seed, spawn_key=(purpose, *key))
    return np.random.Generator(np.random.SFC64(sequence))


def match_seed(run_seed: int, *key: int) -> int:
    """Return the seed of a match, 64 bits, from the run's seed and numbers that tell it apart."""
    # A SeedSequence mixes all numbers, so that near keys give unrelated seeds.
    entropy = [
        checks.check_integer("match seed", part, 0, checks.SEED_MAX) for part in (run_seed, *key)
    ]
    words = np.random.SeedSequence(entropy).generate_state(1, np.uint64)
    return int(words[0])


def evaluation_seed(run_seed: int, pursuer_generation: int, evader_generation: int) -> int:
    """Return the seed of a cell of a run's payoff: world `j` is episode `j` of the cell."""
    return match_seed(run_seed, pursuer_generation, evader_generation)


def explanation_seed(seed: int, number: int) -> int:
    """Return the seed of a numbered set of matches that explain a policy."""
    return match_seed(seed, number, 0, Phase.EXPLAIN)


def training_seeds(run_seed: int, g: int, h: int, phase: Phase, epoch: int, count: int) -> Seeds:
    """Return the seeds (count,) of an epoch; `g` and `h` are the generations of both teams.

    Seed `i` does not depend on `count`.
    """
    # One sequence for all matches: to make one for each takes a noticeable share of a run.
    key = (run_seed, g, h, phase, epoch)
    # NumPy's stubs also allow for words of 32 bits.
    return cast("Seeds", np.random.SeedSequence(key).generate_state(count, np.uint64))
