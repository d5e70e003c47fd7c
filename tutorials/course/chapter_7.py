"""Exercises of notebook 7, "When one side gives up"."""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np

from course.checks import Mistake, array, compare, function, near, number
from course.toys import hosts_and_parasites
from matrixworld.coevolution import reduced_virulence
from matrixworld.coevolution.types import FloatArray


def exercise_1(answer: Any) -> None:
    """Write the fitness of parasites of reduced virulence."""
    compare(
        answer,
        reduced_virulence,
        _wins_of_parasites(),
        partial(_row, name="a fitness for each of 25 parasites", count=25),
        clues={
            "x is not the number of wins: it is the wins divided by the largest number of wins in "
            "the population.": _virulence_of,
            "x is relative to the best parasite of the population, which need not win all five.": (
                lambda wins, virulence: _virulence_of(wins / 5.0, virulence)
            ),
        },
        otherwise=_why_not_restrained,
    )


def _row(value: Any, name: str, count: int) -> FloatArray:
    return array(value, name, count)


def _wins_of_parasites() -> list[tuple[FloatArray, float]]:
    rng = np.random.default_rng(71)
    cases = []
    for virulence in (1.0, 0.75, 0.6):
        wins = np.minimum(rng.integers(0, 6, 25), 4).astype(float)
        wins[0] = 4.0
        cases.append((wins, virulence))
    return [*cases, (np.zeros(25), 0.75)]


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


def exercise_2(answer: Any) -> None:
    """Find the largest virulence at which 4 wins of 5 are as good as 5."""
    virulence = number(answer, "a number between 0.5 and 1")
    inside = 0.5 <= virulence <= 1.0
    near(
        virulence,
        0.9,
        0.002,
        clues={
            0.8: "At v = 0.8 the fitness is largest for 4 of 5 wins. But 4 wins may be as good as "
            "5 at a larger v."
        },
        low="There, 4 wins are at least as good as 5. There is a larger v with this property."
        if inside
        else "Virulence lies between 0.5 and 1.",
        high="There, 5 wins are still better than 4."
        if inside
        else "Virulence lies between 0.5 and 1.",
    )


FEWEST_ONES = 85.0
TRIALS, TRIAL_GENERATIONS = range(700, 703), 200


def exercise_3(answer: Any) -> None:
    """Write a fitness of parasites with which the hosts climb."""
    array(
        function(answer)(np.array([0.0, 1.0, 2.0, 5.0])),
        "4 fitness values for 4 numbers of wins",
        4,
    )

    def fitness(wins: FloatArray) -> FloatArray:
        return np.asarray(answer(wins.copy()), dtype=np.float64)

    races = [hosts_and_parasites(fitness, s, generations=TRIAL_GENERATIONS) for s in TRIALS]
    ones = [float(race.final_objective[0]) for race in races]
    if min(ones) < FEWEST_ONES:
        raise Mistake(
            f"With your parasites the hosts end with {', '.join(f'{one:.0f}' for one in ones)} "
            f"ones in three races of {TRIAL_GENERATIONS} generations; expected at least "
            f"{FEWEST_ONES:.0f} in each."
        )
