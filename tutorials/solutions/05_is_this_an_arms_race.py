"""Solutions of notebook 5, "Is this an arms race?"."""

from __future__ import annotations

import numpy as np

from course import kept
from matrixworld import analysis

# 5.1  Which of the four races is which?
#
# A: the evaders' curve rises to the end, that of the pursuers is level: one side only.
# B: both curves are level from the start, and the matrix has diagonal stripes. Whoever is good
#    against one generation is bad against another one: a cycle.
# C: both curves rise to the end: an arms race that goes on.
# D: both curves rise for a third of the race and are level then: an equilibrium.
exercise_1 = {"A": "one side only", "B": "cycle", "C": "arms race", "D": "equilibrium"}


# 5.2  Which pursuers do generalist evaders of generation k meet in epoch i?
#
# The pursuers of generation k have learned already. So the archive holds the generations 0 to k,
# which are k + 1, and the evaders meet them in turn.
def exercise_2(k: int, i: int) -> int:
    """Return the generation of the pursuers."""
    return i % (k + 1)


# 5.3  How much more do generalists capture at lag +5 than at lag +1?
#
# One number for each race, then an interval over the ten numbers. The episodes and the cells of one
# race are no sample of other races.
def gain_by_lag(matrix: np.ndarray) -> float:
    """Return the mean capture rate at lag +5 minus that at lag +1."""
    profile = analysis.lag_profile(matrix)
    early, late = (profile.means[profile.lags == lag][0] for lag in (1, 5))
    return float(late - early)


races = kept("paper_races")
matrices = (races["generalist_generalist"] / int(races["evaders"])).mean(axis=3)
found = analysis.interval_over_runs([gain_by_lag(matrix) for matrix in matrices])
exercise_3 = (found.low, found.high)


# 5.4  A rule that finds arms races and is seldom fooled.
#
# The strength of each team must follow a rising line. A single last generation is a matter of luck;
# the correlation with time uses all of them. Noise, a cycle and drift have a low one, and a team
# that stands still has one near 0. Both teams must rise.
def exercise_4(scores: np.ndarray) -> bool:
    """Return whether both teams became stronger."""
    strength = analysis.generalization(scores.mean(axis=2))
    return all(
        np.corrcoef(np.arange(len(curve)), curve)[0, 1] > 0.8
        for curve in (strength.pursuers, strength.evaders)
    )
