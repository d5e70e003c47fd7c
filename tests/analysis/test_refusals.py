"""Arguments that are wrong are refused in one sentence: what was expected and what came."""

from collections.abc import Callable
from functools import partial

import numpy as np
import pytest

from matrices import ROCK_PAPER_SCISSORS, logistic
from matrixworld import analysis
from matrixworld.analysis.payoffs import check_payoff
from matrixworld.analysis.runs import race_bands
from rliable_numbers import ONE, TASK

PENNIES = np.eye(2)

MATRICES = [
    (np.zeros((2, 2, 2)), ValueError, r"2 dimension.*got shape \(2, 2, 2\)"),
    ([[0.1, 0.2], [0.3]], ValueError, "rows of equal length"),
    ([[0.0, np.nan]], ValueError, r"got nan at index \(0, 1\)"),
    ([[1.5, 0.0]], ValueError, r"\[0, 1\], got 1.5 at index \(0, 0\)"),
    ([["a", "b"]], TypeError, "real numbers, got dtype <U1"),
]


@pytest.mark.parametrize(("bad", "error", "message"), MATRICES)
def test_bad_matrices_are_refused(bad: object, error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        check_payoff(bad)  # type: ignore[arg-type]


judge, over_runs = analysis.judge, analysis.interval_over_runs
exploit = partial(analysis.exploitability, ROCK_PAPER_SCISSORS, evaders=[1 / 3] * 3)

CALLS: list[tuple[Callable[[], object], str]] = [
    (lambda: analysis.checkerboards(PENNIES, margin=-0.1), r"margin in \[0, 1\), got -0.1"),
    (lambda: analysis.alpha_rank(PENNIES, population=1), "population of at least 2, got 1"),
    (lambda: analysis.alpha_rank(np.zeros((65, 65))), "at most 4096 pairs .*, got 4225"),
    (lambda: exploit([0.5, 0.5]), "3 weights of the pursuers, got 2"),
    (lambda: exploit([0.5, 0.5, 0.5]), "weights of the pursuers with sum 1, got 1.5"),
    (lambda: analysis.response_gain([0], [1], budget=0), "budget of at least 1 match, got 0"),
    (lambda: analysis.global_progress(np.zeros((1, 1, 4, 4))), "at least 2 runs, got 1"),
    (lambda: analysis.dominance_tournament(np.zeros((2, 2, 1))), "at least 2 episodes a cell"),
    (lambda: analysis.disengagements([[0.5] * 3]), r"shape \(K, 2\), got \(1, 3\)"),
    (lambda: analysis.elo(ROCK_PAPER_SCISSORS, cycles=2), r"cycles from 0 to 1 .*\(3, 3\), got 2"),
    (lambda: over_runs([]), r"values of runs of shape \(k,\), k >= 1, got \(0,\)"),
    (lambda: analysis.difference_of_runs([0.1], [0.1, 0.2], paired=True), "1 paired runs, got 2"),
    (lambda: analysis.interquartile_mean([0.1]), r"scores of shape \(runs, opponents\)"),
    (lambda: analysis.probability_of_improvement(ONE, TASK), "the same 5 opponents, got 1"),
    (lambda: race_bands([]), "at least one run, got none"),
    (lambda: analysis.report(np.zeros((1, 5))), r"at least 2 x 2 generations, got \(1, 5\)"),
    (lambda: analysis.MEASURES["swing"].of(PENNIES, "x"), "^window: expected one of whole, first"),
    (lambda: judge(logistic(8), level=1.5), r"level in \(0, 1\), got 1.5"),
    (lambda: judge(logistic(8), episodes=0), "episodes: expected"),
    (lambda: judge(np.zeros((8, 8, 3)), per_episode=True, episodes=5), "the 3 episodes of each"),
]


@pytest.mark.parametrize(("call", "message"), CALLS)
def test_a_wrong_argument_is_refused(call: Callable[[], object], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        call()
