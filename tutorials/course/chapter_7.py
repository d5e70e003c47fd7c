"""Exercises of notebook 7, "When one side gives up"."""

from __future__ import annotations

from typing import Any

import numpy as np

from course.checks import Mistake, array, comparison, function, near, number
from course.toys import hosts_and_parasites, reduced_virulence
from matrixworld.coevolution.types import FloatArray

_rng = np.random.default_rng(71)
WINS = [(_rng.integers(0, 5, 25).astype(float), v) for v in (1.0, 0.75, 0.6)]
"""Of parasites that win 4 of 5 matches at most, and their virulence."""


def _virulence_of(share: FloatArray, virulence: float) -> FloatArray:
    return 2.0 * share / virulence - (share / virulence) ** 2


def _why_not_restrained(
    found: FloatArray, right: FloatArray, wins: FloatArray, virulence: float
) -> str:
    if not wins.any():
        return "If no parasite wins, the largest number of wins is 0. Then all fitness is 0."
    each = int(np.abs(np.nan_to_num(found, nan=np.inf) - right).argmax())
    return (
        f"With v = {virulence}, {wins[each]:.0f} wins and at most {wins.max():.0f} wins of any "
        f"parasite, your fitness is {found[each]:.3g}; expected {right[each]:.3g}."
    )


exercise_1 = comparison(
    reduced_virulence,
    [*WINS, (np.zeros(25), 0.75)],
    lambda value: array(value, "a fitness for each of 25 parasites", 25, finite=False),
    clues={
        "x is not the number of wins: it is the wins divided by the largest number of wins in "
        "the population.": _virulence_of,
        "x is relative to the best parasite of the population, which need not win all five.": (
            lambda wins, virulence: _virulence_of(wins / 5.0, virulence)
        ),
    },
    otherwise=_why_not_restrained,
)
"""Write the fitness of parasites of reduced virulence."""


def exercise_2(answer: Any) -> None:
    """Find the largest virulence at which 4 wins of 5 are as good as 5."""
    virulence = number(answer, "a number between 0.5 and 1")
    if not 0.5 <= virulence <= 1.0:
        raise Mistake("Virulence lies between 0.5 and 1.")
    near(
        virulence,
        0.9,
        0.002,
        clues={
            0.8: "At v = 0.8 the fitness is largest for 4 of 5 wins. But 4 wins may be as good as "
            "5 at a larger v."
        },
        low="There, 4 wins are at least as good as 5. There is a larger v with this property.",
        high="There, 5 wins are still better than 4.",
    )


FEWEST_ONES = 85.0
TRIALS, TRIAL_GENERATIONS = range(700, 703), 200


def exercise_3(answer: Any) -> None:
    """Write a fitness of parasites with which the hosts climb."""
    fitness = function(answer)
    array(fitness(np.array([0.0, 1.0, 2.0, 5.0])), "4 fitness values for 4 numbers of wins", 4)
    races = [hosts_and_parasites(fitness, s, generations=TRIAL_GENERATIONS) for s in TRIALS]
    ones = [float(race.final_objective[0]) for race in races]
    if min(ones) < FEWEST_ONES:
        raise Mistake(
            f"With your parasites the hosts end with {', '.join(f'{one:.0f}' for one in ones)} "
            f"ones in three races of {TRIAL_GENERATIONS} generations; expected at least "
            f"{FEWEST_ONES:.0f} in each."
        )
