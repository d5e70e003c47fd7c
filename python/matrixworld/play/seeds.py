"""Seeds of matches, which worlds, runs and scripts share."""

from __future__ import annotations

import numpy as np

from matrixworld._util.checks import SEED_MAX, check_integer


def match_seed(run_seed: int, *key: int) -> int:
    """Return the seed of a match.

    Parameters
    ----------
    run_seed : int
        The seed of the run.
    *key : int
        Numbers that distinguish the match from others of the run, for example epoch and pair.

    Returns
    -------
    int
        A 64-bit seed from `numpy.random.SeedSequence`, the same on every machine and version.

    Raises
    ------
    ValueError
        If a number is below 0.
    TypeError
        If a number is not an integer.
    """
    # A SeedSequence mixes all numbers, so that near keys give unrelated seeds.
    entropy = [check_integer("match seed", part, 0, SEED_MAX) for part in (run_seed, *key)]
    words = np.random.SeedSequence(entropy).generate_state(1, np.uint64)
    return int(words[0])
