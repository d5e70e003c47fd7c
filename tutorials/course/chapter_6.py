"""Exercises of notebook 6, "Running in circles"."""

from __future__ import annotations

from typing import Any

import numpy as np

from course.checks import Mistake, array, comparison, function
from course.toys import AT_ONCE, PAYOFF, WEIGHTED, WEIGHTED_HANDS, BestHand
from matrixworld import analysis
from matrixworld.coevolution import TEAMS, RaceSettings, Training
from matrixworld.coevolution.training.loops import run_stage
from matrixworld.coevolution.types import FloatArray

# ---- Cures, in a toy -----------------------------------------------------------------------------

NASH = {"kind": "nash", "episodes": 1}
SOURCES: dict[str, dict[str, Any]] = {
    "latest": {"hall_sample": 1, "pursuers_meet": "latest", "evaders_meet": "latest"},
    "hall": {"hall_sample": 5},
    "nash": {"hall_sample": 5, "pursuers_meet": NASH, "evaders_meet": NASH},
}
"""Where opponents come from: schedules of races, beside `AT_ONCE`."""


def race(source: str, budget: int, seed: int) -> FloatArray:
    """Return (matches so far, exploitability) after each round of the weighted game.

    A race is judged by the mixture of all hands that were played, and that of `nash` by its own.
    """
    schedule = {**AT_ONCE, **SOURCES[source], "generations": budget}
    settings = RaceSettings.of(
        game=WEIGHTED_HANDS, learner=BestHand(), schedule=schedule, seed=seed
    )
    run, course = Training(settings, threads=1), []
    while run.counts["matches"] < budget:
        run_stage(run)
        hands = [np.argmax(run.archive[team], axis=1) for team in TEAMS]
        p, q = (np.bincount(played, minlength=3) / len(played) for played in hands)
        if source == "nash":
            found = analysis.nash_averaging(WEIGHTED[np.ix_(*hands)])
            p, q = map(np.bincount, hands, (found.pursuers, found.evaders), (3, 3))
        course.append((run.counts["matches"], (WEIGHTED @ q).max() - (p @ WEIGHTED).min()))
    return np.array(course)


# ---- Exercises -----------------------------------------------------------------------------------

OF_A_MATRIX = "For a matrix of {matrix.shape[0]} x {matrix.shape[1]}"
PENNIES = np.array([[0.9, 0.1], [0.2, 0.8]])
DRAW = np.array([[0.5, 0.1], [0.2, 0.8]])
_rng = np.random.default_rng(6)
DRAWN = [_rng.random(shape) for shape in ((2, 3), (4, 4), (6, 5), (9, 9))]
MATRICES = [(matrix,) for matrix in (PAYOFF, PENNIES, PENNIES[::-1], DRAW, *DRAWN)]
"""Small matrices of capture rates, square and not square."""


def _count_of_strict_losses(matrix: FloatArray) -> int:
    """Return how many checkerboards there are if a rate of 0.5 is neither a win nor a loss."""
    wins, losses = (matrix > 0.5).astype(int), (matrix < 0.5).astype(int)
    # A square has two wins, and is found from each of them.
    return int(np.einsum("ax,by,ay,bx->", wins, wins, losses, losses)) // 2


def _why_count(found: float, right: int, matrix: FloatArray) -> str:
    if right and found in (2 * right, 4 * right):
        return f"That is {found / right:g} times too many: each square must count once."
    if found < right:
        return (
            "That is too few. Either of the two pursuers may be the one who wins against the "
            "first evader. And the rows of a square need not be neighbours."
        )
    return "That is too many. In a checkerboard two cells are wins and two are not."


exercise_1 = comparison(
    lambda matrix: analysis.checkerboards(matrix).count,
    MATRICES,
    case=OF_A_MATRIX,
    clues={
        "A rate of exactly 0.5 is no win, so it counts as a loss.": _count_of_strict_losses,
        "A rate of exactly 0.5 is a loss: pursuers win above 0.5 only.": (
            lambda matrix: analysis.checkerboards(matrix + 1e-9).count
        ),
    },
    otherwise=_why_count,
)
"""Count checkerboards."""


def _mean_subtracted_twice(matrix: FloatArray) -> float:
    rest = matrix - matrix.mean(axis=1, keepdims=True) - matrix.mean(axis=0)
    return float(1.0 - (rest**2).sum() / ((matrix - matrix.mean()) ** 2).sum())


exercise_2 = comparison(
    lambda matrix: analysis.transitive_share(matrix),
    MATRICES,
    case=OF_A_MATRIX,
    clues={
        "This is the share of the rest. What is one minus it?": (
            lambda matrix: 1.0 - analysis.transitive_share(matrix)
        ),
        "Row means and column means both contain the mean of the matrix, so you subtract it "
        "twice. All rows and columns of the rest must have the sum 0.": _mean_subtracted_twice,
    },
    otherwise="Check first that all rows and columns of your rest have the sum 0.",
    within=1e-6,
)
"""Compute the transitive share."""


MOST_MET = 5
"""Opponents in an epoch: the newest and four older ones."""
DRAWS = 300


def exercise_3(answer: Any) -> None:
    """Choose opponents from a hall of fame."""
    rng = np.random.default_rng(4)
    for available in (1, 2, 4, 5, 12):
        seen: set[int] = set()
        for _ in range(DRAWS):
            found = array(function(answer)(available, rng), "several whole numbers", ...)
            if (found % 1).any():
                raise Mistake(f"Expected several whole numbers, got {found.tolist()}.")
            chosen = found.astype(int).tolist()
            problems = {
                f"the numbers go from 0 to {available - 1}": not {*chosen} <= {*range(available)},
                "somebody is there twice": len({*chosen}) < len(chosen),
                "the newest one is missing": available - 1 not in chosen,
                f"these are {len(chosen)} opponents": len(chosen) != min(MOST_MET, available),
            }
            for problem, occurs in problems.items():
                if occurs:
                    raise Mistake(f"With available = {available} it returned {chosen}: {problem}.")
            seen.update(chosen)
        if len(seen) < available:
            raise Mistake(
                f"With {available} opponents some of them were never met in {DRAWS} epochs."
            )
