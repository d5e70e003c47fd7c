"""Arguments that are wrong are refused in one sentence: what was expected and what came."""

from collections.abc import Callable
from functools import partial

import numpy as np
import pytest

from matrices import ROCK_PAPER_SCISSORS, logistic
from matrixworld import analysis
from matrixworld.analysis.intervals import (
    linear_over_episodes,
)
from matrixworld.analysis.payoffs import check_payoff
from matrixworld.analysis.runs import race_bands
from rliable_numbers import ONE, TASK

PENNIES = np.eye(2)

MATRICES = [
    ([0.1, 0.2], ValueError, r"2 dimension.*got shape \(2,\)"),
    (np.zeros((2, 2, 2)), ValueError, r"got shape \(2, 2, 2\)"),
    (np.zeros((0, 3)), ValueError, r"got shape \(0, 3\)"),
    (0.5, ValueError, r"got shape \(\)"),
    ([[0.1, 0.2], [0.3]], ValueError, "rows of equal length"),
    ([[0.0, np.nan]], ValueError, r"got nan at index \(0, 1\)"),
    ([[0.0], [np.inf]], ValueError, r"got inf at index \(1, 0\)"),
    ([[0.0, -0.01]], ValueError, r"\[0, 1\], got -0.01 at index \(0, 1\)"),
    ([[1.5, 0.0]], ValueError, r"\[0, 1\], got 1.5 at index \(0, 0\)"),
    ([["a", "b"]], TypeError, "real numbers, got dtype <U1"),
    ([[1j]], TypeError, "real numbers, got dtype complex128"),
    ([[None]], TypeError, "real numbers, got dtype object"),
]


@pytest.mark.parametrize(("bad", "error", "message"), MATRICES)
def test_bad_matrices_are_refused(bad: object, error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        check_payoff(bad)  # type: ignore[arg-type]


stretches = analysis.disengagements
over_runs, difference = analysis.interval_over_runs, analysis.difference_of_runs
band, judge = analysis.band_over_runs, analysis.judge
mean, linear = analysis.mean_over_episodes, linear_over_episodes
middle, profile = analysis.interquartile_mean, analysis.performance_profile
dominance, cross = analysis.dominance_tournament, analysis.global_progress
alpha_rank = partial(analysis.alpha_rank, ROCK_PAPER_SCISSORS)
elo = partial(analysis.elo, ROCK_PAPER_SCISSORS)
boards = partial(analysis.checkerboards, PENNIES)
exploit = partial(analysis.exploitability, ROCK_PAPER_SCISSORS, evaders=[1 / 3] * 3)

CALLS: list[tuple[Callable[[], object], str]] = [
    # Cycles
    (lambda: boards(margin=-0.1), r"margin in \[0, 1\), got -0.1"),
    (lambda: elo(shrinkage=0.0), r"shrinkage in \(0, 0.5\), got 0.0"),
    # Games
    (lambda: alpha_rank(alpha=0.0), "alpha above 0, got 0.0"),
    (lambda: alpha_rank(population=1), "population of at least 2, got 1"),
    (lambda: analysis.alpha_rank(np.zeros((65, 65))), "at most 4096 pairs .*, got 4225"),
    (lambda: exploit([0.5, 0.5]), "3 weights of the pursuers, got 2"),
    (lambda: exploit([0.5, 0.5, 0.5]), "weights of the pursuers with sum 1, got 1.5"),
    (lambda: analysis.response_gain([0], [1], budget=0), "budget of at least 1 match, got 0"),
    # Progress, dominance
    (lambda: cross(np.zeros((2, 3, 4, 4))), r"\(runs, runs, n, m\), got \(2, 3, 4, 4\)"),
    (lambda: cross(np.zeros((1, 1, 4, 4))), "at least 2 runs, got 1"),
    (lambda: dominance(np.zeros((2, 2, 1))), "at least 2 episodes a cell, got 1"),
    (lambda: dominance(np.zeros((2, 2, 2)), level=0.6), "got 0.6"),
    # Engagement
    (lambda: stretches([[0.5, 0.5, 0.5]]), r"shape \(K, 2\), got \(1, 3\)"),
    # Strength, ratings
    (lambda: analysis.forgetting(PENNIES, [[0.5]]), r"of shape \(2, 2\), got \(1, 1\)"),
    (lambda: elo(ridge=-1.0), "ridge of at least 0, got -1.0"),
    (lambda: elo(cycles=2), r"cycles from 0 to 1 for a matrix of \(3, 3\), got 2"),
    (lambda: analysis.log_loss([[0.5, 0.5]], [[0.5]]), r"of shape \(1, 2\), got \(1, 1\)"),
    # Intervals
    (lambda: over_runs([]), r"values of runs of shape \(k,\), k >= 1, got \(0,\)"),
    (lambda: over_runs([0.1, np.nan]), "finite values of runs, got"),
    (lambda: difference([0.1], [0.1, 0.2], paired=True), "expected 1 paired runs, got 2"),
    (lambda: band([[0.1, np.nan], [0.2, np.nan]]), "a run with a value at each point"),
    (lambda: linear(np.zeros((2, 2, 1)), np.mean), "at least 2 episodes a cell, got 1"),
    (lambda: mean([0.5]), "at least 2 episodes, got 1"),
    # Several runs
    (lambda: middle([0.1]), r"scores of shape \(runs, opponents\), got \(1,\)"),
    (lambda: middle(ONE, resamples=9), "resamples: expected at least 100"),
    (lambda: profile(ONE, [[1]]), r"thresholds of shape \(k,\)"),
    (lambda: profile(ONE, [1, 0]), "ascending thresholds"),
    (lambda: analysis.probability_of_improvement(ONE, TASK), "the same 5 opponents, got 1"),
    (lambda: race_bands([]), "at least one run, got none"),
    # Reports and the judgement
    (lambda: analysis.report(np.zeros((1, 5))), r"at least 2 x 2 generations, got \(1, 5\)"),
    (lambda: analysis.report([PENNIES] * 2, cross=[PENNIES]), r"\(2, 2, 2, 2\), got \(1, 2, 2\)"),
    (lambda: analysis.MEASURES["swing"].of(PENNIES, "x"), "^window: expected one of whole, first"),
    (lambda: judge(logistic(8), level=1.5), r"level in \(0, 1\), got 1.5"),
    (lambda: judge(logistic(8), episodes=0), "episodes: expected"),
    (
        lambda: judge(np.zeros((8, 8, 3)), per_episode=True, episodes=5),
        "the 3 episodes of each cell that the payoffs hold, got",
    ),
]


@pytest.mark.parametrize(("call", "message"), CALLS)
def test_a_wrong_argument_is_refused(call: Callable[[], object], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        call()


def test_episodes_are_a_whole_number() -> None:
    with pytest.raises(TypeError, match="episodes: expected an integer"):
        judge(np.zeros((8, 8, 3)), episodes=True)
