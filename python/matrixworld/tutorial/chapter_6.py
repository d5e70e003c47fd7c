"""Exercises of notebook 6, "Running in circles"."""

from __future__ import annotations

from collections.abc import Callable
from numbers import Integral
from typing import Any

import numpy as np
from numpy.typing import NDArray

from matrixworld import analysis
from matrixworld.coevolution.types import FloatArray
from matrixworld.tutorial.checks import NUMBER, array, function, tried, value
from matrixworld.tutorial.course import Exercise, Prediction

ROCK_PAPER_SCISSORS = np.array([[0.5, 0.0, 1.0], [1.0, 0.5, 0.0], [0.0, 1.0, 0.5]])
WELL = np.array(
    [[0.5, 0.0, 1.0, 0.0], [1.0, 0.5, 0.0, 1.0], [0.0, 1.0, 0.5, 0.0], [1.0, 0.0, 1.0, 0.5]]
)
"""Rock, paper, scissors, well."""
OF_A_MATRIX = "For a matrix of {matrix.shape[0]} x {matrix.shape[1]}"


def _unseen_matrices() -> list[tuple[FloatArray]]:
    """Return small matrices of capture rates, square and not square."""
    rng = np.random.default_rng(6)
    pennies = np.array([[0.9, 0.1], [0.2, 0.8]])
    shapes = ((2, 3), (4, 4), (6, 5), (9, 9))
    drawn = [rng.random(shape) for shape in shapes]
    return [(matrix,) for matrix in (ROCK_PAPER_SCISSORS, pennies, pennies[::-1], *drawn)]


def _why_count(found: float, right: int, matrix: FloatArray) -> str:
    if right and found in (2 * right, 4 * right):
        return f"That is {found / right:g} times too many: each square must count once."
    if found < right:
        return (
            "That is too few. Either of the two pursuers may be the one who wins against the "
            "first evader. And the rows of a square need not be neighbours."
        )
    return "That is too many. In a checkerboard two cells are wins and two are not."


count = function(
    NUMBER,
    lambda matrix: analysis.checkerboards(matrix).count,
    _unseen_matrices,
    case=OF_A_MATRIX,
    otherwise=_why_count,
)


def _mean_subtracted_twice(matrix: FloatArray) -> float:
    rest = matrix - matrix.mean(axis=1, keepdims=True) - matrix.mean(axis=0)
    return float(1.0 - (rest**2).sum() / ((matrix - matrix.mean()) ** 2).sum())


share = function(
    NUMBER,
    lambda matrix: analysis.transitive_share(matrix),
    _unseen_matrices,
    case=OF_A_MATRIX,
    clues=(
        (
            lambda matrix: 1.0 - analysis.transitive_share(matrix),
            "This is the share of the rest. What is one minus it?",
        ),
        (
            _mean_subtracted_twice,
            "Row means and column means both contain the mean of the matrix, so you subtract it "
            "twice. All rows and columns of the rest must have the sum 0.",
        ),
    ),
    otherwise="Check first that all rows and columns of your rest have the sum 0.",
    within=1e-6,
)


def _well(matrix: NDArray[np.float64]) -> str | None:
    if not np.allclose(matrix[:3, :3], ROCK_PAPER_SCISSORS):
        return "The first three rows and columns should be plain rock-paper-scissors."
    if not np.allclose(matrix + matrix.T, 1.0):
        return "What one hand wins the other one loses: matrix + matrix.T is 1 everywhere."
    wrong = np.count_nonzero(~np.isclose(matrix[3], WELL[3]))
    if wrong:
        return f"{wrong} of the four cells in the row of the well are wrong. Whom does it beat?"
    return None


NEWEST, OLDER = 1, 4
DRAWS = 300


def _hall_of_fame(answer: Callable[..., Any]) -> str | None:
    rng = np.random.default_rng(4)
    for available in (1, 2, 4, 5, 12):
        seen: set[int] = set()
        for _ in range(DRAWS):
            found = answer(available, rng)
            problem = _bad_opponents(found, available)
            if problem:
                return f"With available = {available} it returned {found!r}{problem}."
            seen.update(map(int, found))
        if len(seen) < available:
            return f"With {available} opponents some of them were never met in {DRAWS} epochs."
    return None


def _bad_opponents(found: Any, available: int) -> str:
    """Return what is wrong with one choice of opponents; empty if nothing is."""
    if not isinstance(found, list | tuple | np.ndarray) or not all(
        isinstance(each, Integral) and not isinstance(each, bool) for each in found
    ):
        return "; expected several whole numbers"
    if not all(0 <= each < available for each in found):
        return f"; the numbers go from 0 to {available - 1}"
    if len(set(found)) < len(found):
        return ": somebody is there twice"
    if available - 1 not in found:
        return ": the newest one is missing"
    if len(found) != min(NEWEST + OLDER, available):
        return f", which are {len(found)} opponents"
    return ""


EXERCISES: dict[str, Exercise | Prediction] = {
    "6.1": Exercise(
        count,
        "Rock-paper-scissors has 3 of 9 possible ones: each pair of hands is a checkerboard with "
        "one pair of opponents. `analysis.checkerboards` counts the same.",
        (
            "`itertools.combinations(range(n), 2)` gives all pairs of numbers below n, each once.",
            "For rows a, b and columns x, y look at the four wins [a, x], [a, y], [b, x], [b, y].",
            "It is one if [a, x] equals [b, y], [a, y] equals [b, x], and the two are different.",
        ),
    ),
    "6.2": Exercise(
        share,
        "The strengths are row means and column means without the mean of all, so the rest has "
        "the sum 0 in all rows and columns.",
        (
            "With `keepdims=True` the row means are a column that NumPy subtracts from each row.",
            "rest = matrix - row means - column means + mean of all cells",
        ),
    ),
    "6.a": Prediction(
        "b",
        "A sum of strengths is a plane, and wins that are clear are a staircase, which no plane "
        "follows. So a share below 1 is no proof of a circle.",
    ),
    "6.b": Prediction(
        "c",
        "One match is a coin toss with a bias. Noise belongs to no generation, so it all goes into "
        "the rest, which then is larger than the strengths.",
    ),
    "6.c": Prediction(
        "c",
        "With strong selection only the direction counts: who beats whom. Each hand is soon "
        "replaced by the one that beats it, whatever the stakes are. The Nash mixture weighs the "
        "stakes: paper has less to fear now, and therefore rock has more.",
    ),
    "6.3": Exercise(
        value(array("four rows of four numbers", 4, 4), _well),
        "Now the well, paper and scissors form the circle. In the Nash mixture rock has no weight: "
        "the well does all that rock does, and beats rock. alpha-Rank still visits it.",
        (
            "The row of a hand holds its payoff against rock, paper, scissors, well.",
            "Fill the row of the well first. Its column is one minus the row.",
        ),
    ),
    "6.d": Prediction(
        "b",
        "The specialists' hands go round whatever the stakes are, so their average never changes. "
        "Answers to many hands of the past, or to their Nash mixture, follow the stakes.",
    ),
    "6.4": Exercise(
        tried(_hall_of_fame),
        "This is `opponents.HallOfFame(newest=1, sampled=4)`. With a class around it (see "
        "docs/coevolution.md) races use it by name.",
        (
            "The older ones are the numbers 0 to available - 2.",
            "`rng.choice(n, size, replace=False)` draws `size` different numbers below n.",
            "How many older ones are there if `available` is 1, 2 or 3? `min` helps.",
        ),
    ),
    "6.e": Prediction(
        "a",
        "Not to go round is one thing, to be strong another one. In these short races the "
        "specialists' evaders escape most often, although their races show forgetting.",
    ),
}
