"""Replicator dynamics: against a plain integrator, and what is known about zero-sum games."""

import numpy as np
import pytest
from hypothesis import given, settings

from matrices import ROCK_PAPER_SCISSORS, payoffs
from matrixworld import analysis

THIRDS = [1 / 3] * 3


def slow_path(a: np.ndarray, b: np.ndarray, time: float, steps: int) -> tuple[np.ndarray, ...]:
    """Integrate the replicator equation as it is written, by the method of Runge and Kutta."""

    def change(x: np.ndarray, y: np.ndarray) -> np.ndarray:
        up, down = a @ y, x @ b
        return np.array([*(x * (up - x @ up)), *(y * (down - down @ y))])

    n, h = len(a), time / steps
    state = np.concatenate([np.full(n, 1 / n), np.full(a.shape[1], 1 / a.shape[1])])
    for _ in range(steps):
        one = change(state[:n], state[n:])
        two = change(*np.split(state + h / 2 * one, [n]))
        three = change(*np.split(state + h / 2 * two, [n]))
        four = change(*np.split(state + h * three, [n]))
        state = state + h / 6 * (one + 2 * two + 2 * three + four)
    return state[:n], state[n:]


def test_a_path_is_that_of_the_replicator_equation() -> None:
    a = np.random.default_rng(3).normal(0, 1, (4, 3))
    path = analysis.replicator_dynamics(a, time=7, points=3)
    x, y = slow_path(a, -a, 7, 2000)
    np.testing.assert_allclose(path.pursuers[-1], x, atol=1e-8)
    np.testing.assert_allclose(path.evaders[-1], y, atol=1e-8)
    np.testing.assert_array_equal(path.times, [0, 3.5, 7])


def test_shares_of_rock_paper_scissors_go_round_for_ever() -> None:
    starts = {"pursuers": [0.5, 0.3, 0.2], "evaders": [0.1, 0.2, 0.7]}
    path = analysis.replicator_dynamics(ROCK_PAPER_SCISSORS, **starts, time=200, points=1001)
    away = path.divergence(THIRDS, THIRDS)
    np.testing.assert_allclose(away, away[0], rtol=1e-8)  # conserved
    by_hand = sum(np.log(1 / 3 / np.array(start)).mean() for start in starts.values())
    assert away[0] == pytest.approx(by_hand)
    # They do not come near the equilibrium, but their time average does.
    assert np.abs(path.pursuers - 1 / 3).max(axis=1).min() > 0.05
    np.testing.assert_allclose(path.pursuers.mean(axis=0), THIRDS, atol=0.02)


@settings(max_examples=10)
@given(payoffs(least=2, parts=8))
def test_shares_never_move_away_from_an_equilibrium(matrix: np.ndarray) -> None:
    nash = analysis.nash_averaging(matrix)
    away = analysis.replicator_dynamics(matrix).divergence(nash.pursuers, nash.evaders)
    assert np.diff(away).max() < 1e-5  # mixtures are known to the tolerance of linear programmes
