"""Exercises of notebook 4: the Red Queen, and instruments that see progress."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from course.checks import Mistake, about, array, comparison
from course.shown import film
from course.toys import BITS, GAMES, beats
from matrixworld import colors, replay


def film_of_hands(hands: Mapping[str, NDArray[np.int_]]) -> replay.Animation:
    """Show the hands of both teams after each turn: first the pursuers learn, then the evaders."""
    figure = Figure(figsize=(4.4, 1.8), dpi=70)

    def draw(turn: int) -> None:
        figure.clear()
        figure.text(0.5, 0.8, f"after turn {turn}", ha="center", size="large")
        chosen = hands["pursuer"][(turn + 1) // 2], hands["evader"][turn // 2]
        for team, hand, y in zip(("pursuers", "evaders"), chosen, (0.5, 0.2), strict=True):
            text, color = f"{team}: {('rock', 'paper', 'scissors')[hand]}", colors.TEAMS[y < 0.5]
            figure.text(0.25, y, text, color=color, size="x-large")

    return film(figure, draw, range(24), fps=2, alt="rock-paper-scissors, played in turns")


def exercise_1(answer: Any) -> None:
    """Draw two races with equal diagonals: both teams get better, or both get worse."""
    if not isinstance(answer, tuple | list) or len(answer) != 2:
        raise Mistake("Expected two matrices: `answer = better, worse`.")
    for name, matrix, sign in zip(("better", "worse"), answer, (1, -1), strict=True):
        with about(name):
            _judge_race(array(matrix, "4 x 4 numbers", 4, 4), sign)


def _judge_race(rates: NDArray[np.float64], sign: int) -> None:
    """Judge a race in which both teams get better (1) or worse (-1)."""
    if not ((rates >= 0) & (rates <= 1)).all():
        raise Mistake("Expected capture rates between 0 and 1.")
    if not np.allclose(np.diag(rates), 0.5):
        raise Mistake(f"Expected 0.5 everywhere on the diagonal, got {np.diag(rates).tolist()}.")
    for line, axis, growth, why in (
        ("row", 1, sign, "They are the strengths of the pursuers"),
        ("column", 0, -sign, "They say how often the evaders are captured"),
    ):
        means = rates.mean(axis=axis)
        if not (growth * np.diff(means) > 1e-9).all():
            raise Mistake(
                f"The means of the {line}s are {means.round(3).tolist()}. {why}, and should "
                f"{'grow' if growth > 0 else 'fall'} from {line} to {line}."
            )


_rng = np.random.default_rng(4)
MATRICES = [_rng.random(shape).round(3) for shape in ((6, 6), (5, 8), (9, 4))]
"""Payoff matrices whose best generations, rows and columns all differ."""


exercise_2 = comparison(
    lambda payoff, g: payoff[g, :g].mean(),
    [(matrix, g) for matrix in MATRICES[:2] for g in range(1, len(matrix))],
    case="For generation {g}",
    clues={
        "It contains the current evaders; only earlier ones were asked for.": (
            lambda payoff, g: payoff[g, : g + 1].mean()
        ),
        "These are earlier pursuers against evaders of this generation: a column.": (
            lambda payoff, g: payoff[:g, g].mean()
        ),
        "It contains later evaders, too.": lambda payoff, g: payoff[g].mean(),
    },
    otherwise="Expected another number: the pursuers of this generation are one row.",
)
"""Score a generation against its opponents' ancestors."""


def _why_not_best(found: list[float], right: list[int], payoff: NDArray[np.float64]) -> str:
    rows, columns = payoff.mean(axis=1), payoff.mean(axis=0)
    if found == [right[0], columns.argmax()]:
        return "The evaders of that generation are captured most often."
    if found[0] == columns.argmax() or found[1] == rows.argmin():
        return "Which axis holds the pursuers? Their opponents are along the other one."
    if any(generation >= size for generation, size in zip(found, payoff.shape, strict=True)):
        return "There are not so many generations; the first one is 0."
    return "Expected other generations."


exercise_3 = comparison(
    lambda payoff: [payoff.mean(axis=1).argmax(), payoff.mean(axis=0).argmin()],
    [(matrix,) for matrix in MATRICES],
    lambda value: array(value, "two generations", 2).tolist(),
    case="For a matrix of {payoff.shape[0]} x {payoff.shape[1]}",
    otherwise=_why_not_best,
)
"""Find the best generation of each team."""


def _share_of_wins(beats: Any, individuals: NDArray[Any], opponents: NDArray[Any]) -> float:
    return float(np.mean([beats(a[None], b[None])[0] for a in individuals for b in opponents]))


def _games() -> list[tuple[Any, ...]]:
    rng = np.random.default_rng(44)
    return [
        (
            partial(beats, game),
            rng.integers(0, most // 2 + 1, size=(7, BITS // most)),
            rng.integers(0, most + 1, size=(5, BITS // most)),
        )
        for game in GAMES.values()
        for most in (BITS // game.genome_size("pursuer"),)
    ]


exercise_4 = comparison(
    _share_of_wins,
    _games(),
    case="For 7 individuals and 5 opponents",
    clues={
        "That is the share of pairs that the opponents win.": (
            lambda beats, one, many: _share_of_wins(beats, many, one)
        ),
        "That is one opponent for each individual; expected every individual against all.": (
            lambda beats, one, many: beats(one[: len(many)], many).mean()
        ),
    },
    otherwise="Expected another number: a share, from 0 to 1, of 35 pairs.",
)
"""Score individuals against held-out opponents."""
