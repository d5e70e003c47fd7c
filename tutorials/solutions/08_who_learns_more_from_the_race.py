"""Solutions of notebook 8, "Who learns more from the race?".

Try each exercise before you read on.
"""

from __future__ import annotations

import numpy as np

from matrixworld import analysis

# 8.1  How many matches do the evaders of a race learn from, and how many epochs has each of four
# stages with the same budget?
#
# 20 generations of 50 epochs are 1000 epochs. In each of them 32 candidates play one match.

exercise_1 = (20 * 50 * 32, 20 * 50 / 4)

# 8.2  The mean score of each seed against the races of all other seeds.
#
# The sum of the row without the number on the diagonal, divided by how many are left.


def exercise_2(rates):
    """Return one number for each row of a square table."""
    return (rates.sum(axis=1) - np.diag(rates)) / (len(rates) - 1)


# 8.3  A verdict from two lists of scores with the same seeds.
#
# Seeds belong together, so the interval is that of the paired differences.


def exercise_3(one, other):
    """Return whether the first is better or worse, or that these seeds cannot tell."""
    found = analysis.difference_of_runs(one, other, paired=True)
    if found.low > 0:
        return "better"
    if found.high < 0:
        return "worse"
    return "cannot tell"


# 8.4  Which word fits?
#
# A: only one side learns. B: a person decides the sequence, and the tasks do not learn. C and E:
# rivals that learn set each other's tasks. D: both learn, but they are partners.

exercise_4 = {
    "A": "none of these",
    "B": "curriculum by hand",
    "C": "autocurriculum",
    "D": "co-evolution",
    "E": "autocurriculum",
}
