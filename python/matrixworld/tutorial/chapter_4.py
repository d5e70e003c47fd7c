"""Exercises of notebook 4: the Red Queen, and instruments that see progress."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from matrixworld._util.checks import shown
from matrixworld.toys import GAMES
from matrixworld.tutorial.exercises import NO_DEFINITION, Exercise, Prediction

NUMBERS = (int, float, np.integer, np.floating)


def _two_races(answer: Any) -> str | None:
    if not isinstance(answer, tuple | list) or len(answer) != 2:
        return "Expected two matrices: `answer = better, worse`."
    for name, matrix, sign in zip(("better", "worse"), answer, (1.0, -1.0), strict=True):
        mistake = _one_race(name, matrix, sign)
        if mistake:
            return mistake
    return None


def _one_race(name: str, matrix: Any, sign: float) -> str | None:
    try:
        rates = np.asarray(matrix, dtype=np.float64)
    except (TypeError, ValueError):
        return f"{name}: expected 4 x 4 numbers, got {shown(matrix)}."
    if rates.shape != (4, 4):
        return f"{name}: expected 4 x 4 numbers, got the shape {rates.shape}."
    if not ((rates >= 0) & (rates <= 1)).all():
        return f"{name}: expected capture rates between 0 and 1."
    if not np.allclose(np.diag(rates), 0.5):
        return f"{name}: expected 0.5 everywhere on the diagonal, got {np.diag(rates).tolist()}."
    rows, columns = sign * rates.mean(axis=1), sign * rates.mean(axis=0)
    if not (np.diff(rows) > 1e-9).all():
        change = "grow" if sign > 0 else "fall"
        return (
            f"{name}: the means of the rows are {rates.mean(axis=1).round(3).tolist()}. They are "
            f"the strengths of the pursuers, and should {change} from row to row."
        )
    if not (np.diff(columns) < -1e-9).all():
        change = "fall" if sign > 0 else "grow"
        return (
            f"{name}: the means of the columns are {rates.mean(axis=0).round(3).tolist()}. They "
            f"say how often the evaders are captured, and should {change} from column to column."
        )
    return None


def _matrices() -> list[NDArray[np.float64]]:
    """Return payoff matrices whose best generations, rows and columns all differ."""
    rng = np.random.default_rng(4)
    return [rng.random((n, m)).round(3) for n, m in ((6, 6), (5, 8), (9, 4))]


def _ancestors(answer: Any) -> str | None:
    if not callable(answer):
        return NO_DEFINITION
    for matrix in _matrices()[:2]:
        for g in range(1, len(matrix)):
            found = answer(matrix.copy(), g)
            if not isinstance(found, NUMBERS):
                return f"For generation {g} expected a number, got {shown(found)}."
            mistake = _not_ancestors(matrix, g, float(found))
            if mistake:
                return f"For generation {g} the result is {found:.3f}. {mistake}"
    return None


def _not_ancestors(matrix: NDArray[np.float64], g: int, found: float) -> str | None:
    if math.isclose(found, matrix[g, :g].mean(), abs_tol=1e-9):
        return None
    if math.isclose(found, matrix[g, : g + 1].mean(), abs_tol=1e-9):
        return "It contains the current evaders; only earlier ones were asked for."
    if math.isclose(found, matrix[:g, g].mean(), abs_tol=1e-9):
        return "These are earlier pursuers against evaders of this generation: a column."
    if math.isclose(found, matrix[g].mean(), abs_tol=1e-9):
        return "It contains later evaders, too."
    return "Expected another number: the pursuers of this generation are one row."


def _best(answer: Any) -> str | None:
    if not callable(answer):
        return NO_DEFINITION
    for matrix in _matrices():
        found = answer(matrix.copy())
        if not isinstance(found, tuple | list | np.ndarray) or len(found) != 2:
            return f"Expected two generations, got {shown(found)}."
        right = int(matrix.mean(axis=1).argmax()), int(matrix.mean(axis=0).argmin())
        if tuple(np.asarray(found).tolist()) == right:
            continue
        case = f"For a matrix of {len(matrix)} x {matrix.shape[1]} the result is {tuple(found)}."
        if found[0] == right[0] and found[1] == int(matrix.mean(axis=0).argmax()):
            return f"{case} The evaders of that generation are captured most often."
        if found[0] == matrix.mean(axis=0).argmax() or found[1] == matrix.mean(axis=1).argmin():
            return f"{case} Which axis holds the pursuers? Their opponents are along the other one."
        if any(value >= size for value, size in zip(found, matrix.shape, strict=True)):
            return f"{case} There are not so many generations; the first one is 0."
        return f"{case} Expected other generations."
    return None


def _held_out(answer: Any) -> str | None:
    if not callable(answer):
        return NO_DEFINITION
    rng = np.random.default_rng(44)
    for name, game in GAMES.items():
        dimensions, bits = game.shape
        one = rng.integers(0, bits // 2 + 1, size=(7, dimensions))
        many = rng.integers(0, bits + 1, size=(5, dimensions))
        won = np.array([[game.beats(a[None], b[None])[0] for b in many] for a in one])
        found = answer(game.beats, one.copy(), many.copy())
        case = f"For 7 individuals and 5 opponents of the {name} game"
        if not isinstance(found, NUMBERS):
            return f"{case} expected a number, got {shown(found)}."
        if not math.isclose(found, won.mean(), abs_tol=1e-9):
            mistake = _not_held_out(game.beats, one, many, float(found))
            return f"{case} the result is {found:.3f}. {mistake}"
    return None


def _not_held_out(beats: Any, one: Any, many: Any, found: float) -> str:
    lost = np.array([[beats(b[None], a[None])[0] for b in many] for a in one]).mean()
    pairs = beats(one[: len(many)], many).mean()
    if math.isclose(found, lost, abs_tol=1e-9):
        return "That is the share of pairs that the opponents win."
    if math.isclose(found, pairs, abs_tol=1e-9):
        return "That is one opponent for each individual; expected every individual against all."
    if found > 1:
        return "Expected a share, between 0 and 1."
    return "Expected another number: there are 35 pairs."


EXERCISES: dict[str, Exercise | Prediction] = {
    "4.a": Prediction(
        ("a", "b", "c"),
        "b",
        "Every hand beats one of the three hands, loses against one, and draws with one. Thirty "
        "victories in turn have led nowhere.",
    ),
    "4.b": Prediction(
        ("a", "b", "c", "d"),
        "d",
        "All three curves stay around one half. Both sides are in the same game, so what one side "
        "gains, the other gains as well.",
    ),
    "4.1": Exercise(
        _two_races,
        "The same diagonal, and all that differs is off the diagonal, where generations meet that "
        "never meet while the race goes on.",
        (
            "Below the diagonal, later pursuers meet earlier evaders. What if they are better?",
            "Let a cell depend on the lag g - h only: 0.5 + 0.1 * (g - h).",
            "`worse` is `better` with its rows and columns exchanged: `better.T`.",
        ),
    ),
    "4.2": Exercise(
        _ancestors,
        "A row of the matrix, up to the diagonal and without it.",
        (
            "The pursuers of generation g are row g.",
            "payoff[g, :g] are the columns 0 to g - 1 of this row.",
        ),
    ),
    "4.3": Exercise(
        _best,
        "Good pursuers have rows with a high mean, good evaders columns with a low mean.",
        (
            "payoff.mean(axis=1) has one number for each generation of pursuers.",
            "The matrix holds what pursuers gain. Evaders want it low: argmin.",
        ),
    ),
    "4.4": Exercise(
        _held_out,
        "Everybody meets the same opponents, so the shares of different races can be compared.",
        (
            "Make all pairs first: each individual m times, and the opponents n times over.",
            "np.repeat(individuals, m, axis=0) and np.tile(opponents, (n, 1)) fit together.",
        ),
    ),
    "4.c": Prediction(
        ("a", "b", "c"),
        "c",
        "They have learned to escape. The diagonal hid it, because the pursuers have learned, too.",
    ),
}
"""Exercises and predictions in the order of the notebook."""
