"""Exercises of notebook 6, "Running in circles"."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np

from course.checks import Mistake, array, comparison, function
from course.toys import PAYOFF
from matrixworld import analysis
from matrixworld.coevolution.types import FloatArray

# ---- Cures, in a toy -----------------------------------------------------------------------------

WEIGHTED = np.array([[0.5, 0.0, 1.0], [1.0, 0.5, 0.4], [0.0, 0.6, 0.5]])
"""Scissors beat paper in 60 % of the matches only."""
Played = tuple[list[int], list[int]]
"""The hands of both teams, from the first one on."""
Source = Callable[[Played, int, np.random.Generator], tuple[FloatArray, float]]
"""Takes hands and a team; returns a mixture of opponents, and the matches that it costs."""


_mixture = partial(np.bincount, minlength=3)


def latest(played: Played, team: int, rng: np.random.Generator) -> tuple[FloatArray, float]:
    """Answer the newest hand."""
    return _mixture(played[team][-1:]), 3


def hall(played: Played, team: int, rng: np.random.Generator) -> tuple[FloatArray, float]:
    """Answer up to five hands drawn from all earlier ones."""
    chosen = rng.choice(played[team], min(5, len(played[team])), replace=False)
    return _mixture(chosen) / len(chosen), 3 * len(chosen)


def nash(played: Played, team: int, rng: np.random.Generator) -> tuple[FloatArray, float]:
    """Answer the Nash mixture of the earlier hands; the teams share the cost of new cells."""
    found = analysis.nash_averaging(WEIGHTED[np.ix_(*played)])
    weights = (found.pursuers, found.evaders)[team]
    cells = 2 * len(played[0]) - 1
    return _mixture(played[team], weights), 3 * np.count_nonzero(weights > 1e-6) + cells / 2


def race(source: Source, budget: int, seed: int) -> FloatArray:
    """Return (matches so far, exploitability) after each round.

    A race is judged by the mixture of all hands that were played, and that of `nash` by its own.
    """
    played: Played = ([0], [0])
    rng, matches, course = np.random.default_rng(seed), 0.0, []
    while matches < budget:
        (x, cost_x), (y, cost_y) = (source(played, team, rng) for team in (0, 1))
        p, q = (x, y) if source is nash else (_mixture(each) / len(each) for each in played)
        matches += cost_x + cost_y
        course.append((matches, (WEIGHTED @ q).max() - (p @ WEIGHTED).min()))
        for team, values in enumerate((WEIGHTED @ y, -(x @ WEIGHTED))):
            played[team].append(rng.choice(np.flatnonzero(values > values.max() - 1e-9)))
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
