"""Exercises of notebook 10, "How far from perfect?"."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.figure import Figure
from scipy.stats import spearmanr

from course.checks import Mistake, array, comparison, near, number
from course.toys import PAYOFF, replicators
from matrixworld.coevolution.types import FloatArray

STAKES = np.array([[0.5, 0.25, 1.0], [0.75, 0.5, 0.25], [0.0, 0.75, 0.5]])
"""Rock, paper, scissors: rock always beats scissors, and the other winners win 3 of 4 matches."""
SAFE = 0.495
"""What a mixture has to score against each hand."""
HALLS, GENERALISTS = 0.8305, 0.8431
"""NashConv of the last generations of the kept races, means over seeds; a test computes them."""


def agreement(stored: Mapping[str, FloatArray], team: str, measure: str) -> list[float]:
    """Return the rank correlation with the truth for each seed, a mean over its five races."""
    said, truth = stored[f"{team}: {measure}"], stored[f"{team}: truth"]
    races = (zip(said[:, seed], truth[:, seed], strict=True) for seed in range(said.shape[1]))
    return [
        float(np.mean([spearmanr(*pair).statistic for pair in each if min(map(np.ptp, pair)) > 0]))
        for each in races
    ]


def draw_shares(rock: float) -> tuple[Figure, str]:
    """Draw two populations that play rock-paper-scissors, with so much rock in the first one."""
    times, first = replicators(PAYOFF, (rock, *[(1 - rock) / 2] * 2), time=100, points=801)
    means = first.cumsum(axis=0) / np.arange(1, 802)[:, None]
    figure, (above, below) = plt.subplots(2, figsize=(7, 4.5), sharex=True, layout="constrained")
    for hand, shares, line in zip(("rock", "paper", "scissors"), first.T, "-:-", strict=True):
        above.plot(times, shares, line, label=hand)
    for name, shares, line in (("now", first, "-"), ("mean so far", means, "--")):
        below.plot(times, 0.5 - (shares @ PAYOFF).min(axis=1), line, label=name)
    above.set(ylabel="share", ylim=(0, 1), title="first population")
    below.set(xlabel="time", ylabel="exploitability", ylim=(0, 0.5))
    for axes in (above, below):
        axes.legend(loc="upper right", ncols=3)
    return figure, f"Rock begins at {rock:.0%}: shares rise and fall, the mean falls towards 0"


# ---- Exercises -----------------------------------------------------------------------------------

exercise_1 = comparison(
    lambda stones, most: stones % (most + 1),
    [(stones, most) for most in (3, 1, 2, 5) for stones in range(1, 18)],
    case="With {stones} stones, and at most {most} in a move,",
    clues={
        "That is a move; but does it leave what loses for the other player?": (
            lambda stones, most: min(stones, most)
        )
    },
    otherwise="Go backwards: which numbers of stones lose for who is to move?",
)
"""Play Nim perfectly."""

_rng = np.random.default_rng(101)
SHAPES = ((3, 3), (2, 5), (6, 4))
DRAWN = [(_rng.random(shape), _rng.dirichlet(np.ones(shape[0]))) for shape in SHAPES]

exercise_2 = comparison(
    lambda payoff, mixture: float((mixture @ payoff).min()),
    [(STAKES, np.full(3, 1 / 3)), *DRAWN],
    clues={
        "That is the score against the opponent that the mixture likes best.": (
            lambda payoff, mixture: float((mixture @ payoff).max())
        ),
        "That is the mean over all opponents. Who knows your mixture does not draw by lot.": (
            lambda payoff, mixture: float((mixture @ payoff).mean())
        ),
        "That is the worst single entry: you looked at one row at a time, not at the "
        "mixture.": lambda payoff, mixture: float(payoff.min()),
    },
    otherwise="Weight the rows by the mixture: that gives one score against each opponent.",
)
"""Compute what a mixture guarantees."""


def exercise_3(answer: Any) -> None:
    """Find a safe mixture of rock, paper and scissors with stakes."""
    shares = array(answer, "the shares of rock, paper and scissors", 3)
    if min(shares) < 0.0 or abs(sum(shares) - 1.0) > 1e-6:
        raise Mistake("Three shares are not negative, and their sum is 1.")
    scores = shares @ STAKES
    if scores.min() < SAFE:
        worst = ("rock", "paper", "scissors")[int(scores.argmin())]
        raise Mistake(
            f"Against {worst} this mixture scores {scores.min():.3f}; it has to reach {SAFE}."
        )


def exercise_4(answer: Any) -> None:
    """Compute the NashConv of races with halls of fame."""
    near(
        number(answer),
        HALLS,
        0.001,
        clues={
            GENERALISTS: "That is the NashConv of generalists.",
            1.0 - HALLS: "That is what both teams guarantee together. How much is missing?",
        },
        low="Best responses gain more. The exploitabilities of both teams are added.",
        high="A team falls short of what perfect play guarantees: of the value or of 1 - value.",
    )
