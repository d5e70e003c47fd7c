"""Exercises of notebook 6, "Running in circles"."""

from __future__ import annotations

from collections.abc import Callable
from numbers import Integral, Real
from typing import Any

import numpy as np

from matrixworld import analysis
from matrixworld.coevolution.types import FloatArray
from matrixworld.tutorial.exercises import Exercise, Prediction

ROCK_PAPER_SCISSORS = np.array([[0.5, 0.0, 1.0], [1.0, 0.5, 0.0], [0.0, 1.0, 0.5]])
WELL = np.array(
    [[0.5, 0.0, 1.0, 0.0], [1.0, 0.5, 0.0, 1.0], [0.0, 1.0, 0.5, 0.0], [1.0, 0.0, 1.0, 0.5]]
)
"""Rock, paper, scissors, well."""
NEWEST, OLDER = 1, 4
DRAWS = 300
CLOSE = 1e-6


def unseen_matrices() -> list[FloatArray]:
    """Return small matrices of capture rates, square and not square."""
    rng = np.random.default_rng(6)
    pennies = np.array([[0.9, 0.1], [0.2, 0.8]])
    shapes = ((2, 3), (4, 4), (6, 5), (9, 9))
    return [ROCK_PAPER_SCISSORS, pennies, pennies[::-1], *(rng.random(shape) for shape in shapes)]


def _number(value: Any) -> str | None:
    if isinstance(value, bool) or not isinstance(value, Real):
        return f"Your function returned {value!r}; expected a number."
    return None


def _count(answer: Any) -> str | None:
    if not callable(answer):
        return "Expected a function of a matrix."
    for matrix in unseen_matrices():
        found, right = answer(matrix.copy()), analysis.checkerboards(matrix).count
        problem = _number(found)
        if problem:
            return problem
        if found != right:
            return _wrong_count(matrix, float(found), right)
    return None


def _wrong_count(matrix: FloatArray, found: float, right: int) -> str:
    counted = f"In a matrix of {len(matrix)} x {matrix.shape[1]} your function counts {found:g}"
    if right and found in (2 * right, 4 * right):
        return f"{counted}, {found / right:g} times too many: each square must count once."
    if found < right:
        return (
            f"{counted}, which is too few. Either of the two pursuers may be the one who wins "
            "against the first evader. And the rows of a square need not be neighbours."
        )
    return f"{counted}, which is too many. In a checkerboard two cells are wins and two are not."


def _share(answer: Any) -> str | None:
    if not callable(answer):
        return "Expected a function of a matrix."
    for matrix in unseen_matrices():
        found, right = answer(matrix.copy()), analysis.transitive_share(matrix)
        problem = _number(found)
        if problem:
            return problem
        if not abs(found - right) < CLOSE:
            return _wrong_share(matrix, float(found), right)
    return None


def _wrong_share(matrix: FloatArray, found: float, right: float) -> str:
    if abs(found - (1.0 - right)) < CLOSE:
        return "This is the share of the rest. What is one minus it?"
    rows = matrix.mean(axis=1, keepdims=True)
    twice = matrix - rows - matrix.mean(axis=0)
    total = ((matrix - matrix.mean()) ** 2).sum()
    if abs(found - (1.0 - (twice**2).sum() / total)) < CLOSE:
        return (
            "Row means and column means both contain the mean of the matrix, so you subtract it "
            "twice. All rows and columns of the rest must have the sum 0."
        )
    return (
        f"For a matrix of {len(matrix)} x {matrix.shape[1]} it returned {found:.3f}. Check first "
        "that all rows and columns of your rest have the sum 0."
    )


def _well(answer: Any) -> str | None:
    try:
        matrix = np.asarray(answer, dtype=np.float64)
    except (TypeError, ValueError):
        return "Expected four rows of four numbers."
    if matrix.shape != WELL.shape:
        return f"Expected 4 x 4 numbers, got an array of shape {matrix.shape}."
    if not np.allclose(matrix[:3, :3], ROCK_PAPER_SCISSORS):
        return "The first three rows and columns should be plain rock-paper-scissors."
    if not np.allclose(matrix + matrix.T, 1.0):
        return "What one hand wins the other one loses: matrix + matrix.T is 1 everywhere."
    if np.allclose(matrix, WELL):
        return None
    wrong = int((~np.isclose(matrix[3], WELL[3])).sum())
    return f"{wrong} of the four cells in the row of the well are wrong. Whom does it beat?"


def _meet(answer: Any) -> str | None:
    if not callable(answer):
        return "Expected a function of `available` and a generator."
    rng = np.random.default_rng(4)
    for available in (1, 2, 4, 5, 12):
        seen: set[int] = set()
        for _ in range(DRAWS):
            problem = _bad_opponents(answer, available, rng, seen)
            if problem:
                return problem
        if len(seen) < available:
            return f"With {available} opponents some of them were never met in {DRAWS} epochs."
    return None


def _bad_opponents(
    answer: Callable[..., Any], available: int, rng: np.random.Generator, seen: set[int]
) -> str | None:
    """Return what is wrong with one choice of opponents; add it to those seen."""
    found = answer(available, rng)
    with_this = f"With available = {available}"
    if not isinstance(found, list | tuple | np.ndarray) or not all(
        isinstance(each, Integral) and not isinstance(each, bool) for each in found
    ):
        return f"{with_this} it returned {found!r}; expected several whole numbers."
    chosen = [int(each) for each in found]
    if not all(0 <= each < available for each in chosen):
        return f"{with_this} it returned {chosen}; the numbers go from 0 to {available - 1}."
    if len(set(chosen)) < len(chosen):
        return f"{with_this} it returned {chosen}: somebody is there twice."
    if available - 1 not in chosen:
        return f"{with_this} it returned {chosen}: the newest one is missing."
    if len(chosen) != min(NEWEST + OLDER, available):
        return f"{with_this} it returned {len(chosen)} opponents: {chosen}."
    seen.update(chosen)
    return None


EXERCISES: dict[str, Exercise | Prediction] = {
    "6.1": Exercise(
        _count,
        "Rock-paper-scissors has 3 of 9 possible ones: each pair of hands is a checkerboard with "
        "one pair of opponents. `analysis.checkerboards` counts the same.",
        (
            "`itertools.combinations(range(n), 2)` gives all pairs of numbers below n, each once.",
            "For rows a, b and columns x, y look at the four wins [a, x], [a, y], [b, x], [b, y].",
            "It is one if [a, x] equals [b, y], [a, y] equals [b, x], and the two are different.",
        ),
    ),
    "6.2": Exercise(
        _share,
        "The strengths are row means and column means without the mean of all, so the rest has "
        "the sum 0 in all rows and columns.",
        (
            "With `keepdims=True` the row means are a column that NumPy subtracts from each row.",
            "rest = matrix - row means - column means + mean of all cells",
        ),
    ),
    "6.a": Prediction(
        ("a", "b", "c"),
        "b",
        "A sum of strengths is a plane, and wins that are clear are a staircase, which no plane "
        "follows. So a share below 1 is no proof of a circle.",
    ),
    "6.b": Prediction(
        ("a", "b", "c"),
        "c",
        "One match is a coin toss with a bias. Noise belongs to no generation, so it all goes into "
        "the rest, which then is larger than the strengths.",
    ),
    "6.c": Prediction(
        ("a", "b", "c"),
        "c",
        "With strong selection only the direction counts: who beats whom. Each hand is soon "
        "replaced by the one that beats it, whatever the stakes are. The Nash mixture weighs the "
        "stakes: paper has less to fear now, and therefore rock has more.",
    ),
    "6.3": Exercise(
        _well,
        "Now the well, paper and scissors form the circle. In the Nash mixture rock has no weight: "
        "the well does all that rock does, and beats rock. alpha-Rank still visits it.",
        (
            "The row of a hand holds its payoff against rock, paper, scissors, well.",
            "Fill the row of the well first. Its column is one minus the row.",
        ),
    ),
    "6.d": Prediction(
        ("a", "b", "c"),
        "b",
        "The specialists' hands go round whatever the stakes are, so their average never changes. "
        "Answers to many hands of the past, or to their Nash mixture, follow the stakes.",
    ),
    "6.4": Exercise(
        _meet,
        "This is `opponents.HallOfFame(newest=1, sampled=4)`. With a class around it (see "
        "docs/coevolution.md) races use it by name.",
        (
            "The older ones are the numbers 0 to available - 2.",
            "`rng.choice(n, size, replace=False)` draws `size` different numbers below n.",
            "How many older ones are there if `available` is 1, 2 or 3? `min` helps.",
        ),
    ),
    "6.e": Prediction(
        ("a", "b", "c"),
        "a",
        "Not to go round is one thing, to be strong another one. In these short races the "
        "specialists' evaders escape most often, although their races show forgetting.",
    ),
}
