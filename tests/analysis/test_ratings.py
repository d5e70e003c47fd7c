"""Elo and multidimensional Elo recover known ratings and cycles."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import minimize

from matrices import ROCK_PAPER_SCISSORS, staircase
from matrixworld import analysis
from matrixworld.analysis.ratings import RIDGE

EXACT = {"ridge": 0.0, "shrinkage": 1e-9}


def sigmoid(x: np.ndarray) -> np.ndarray:
    return 1 / (1 + np.exp(-x))


def planted(rows: int, columns: int) -> tuple[np.ndarray, np.ndarray, float]:
    rng = np.random.default_rng(rows)
    a, b = rng.normal(0, 1, rows), rng.normal(0, 1, columns)
    return a - a.mean(), b - b.mean(), 0.4


def test_elo_recovers_known_ratings() -> None:
    a, b, c = planted(7, 5)
    matrix = sigmoid(a[:, None] - b + c)
    found = analysis.elo(matrix, **EXACT)
    np.testing.assert_allclose(found.pursuers, a, atol=1e-6)
    np.testing.assert_allclose(found.evaders, b, atol=1e-6)
    assert found.offset == pytest.approx(c, abs=1e-6)
    np.testing.assert_allclose(found.predict(), matrix, atol=1e-6)
    assert analysis.log_loss(matrix, found.predict()) < 1e-10


def test_elo_minimises_its_documented_objective() -> None:
    """Compare with a general minimiser of the objective."""
    rng = np.random.default_rng(3)
    matrix = rng.random((3, 4))
    x = 0.01 + 0.98 * matrix

    def objective(parameters: np.ndarray) -> float:
        a, b, c = parameters[:3], parameters[3:7], parameters[7]
        p = sigmoid(a[:, None] - b + c)
        cross = -(x * np.log(p) + (1 - x) * np.log(1 - p)).sum()
        return float(cross + RIDGE / 2 * (a @ a + b @ b))

    best = minimize(objective, np.zeros(8), method="BFGS", options={"gtol": 1e-7}).x
    found = analysis.elo(matrix)
    np.testing.assert_allclose(found.pursuers, best[:3], atol=1e-4)
    np.testing.assert_allclose(found.evaders, best[3:7], atol=1e-4)
    assert found.offset == pytest.approx(best[7], abs=1e-4)


def test_ratings_stay_finite_if_a_generation_always_wins() -> None:
    for matrix in (np.ones((3, 4)), staircase(31), np.eye(2)):
        found = analysis.elo(matrix)
        assert np.abs(found.logits).max() < 30
    assert analysis.elo(np.ones((3, 4))).offset == pytest.approx(np.log(0.99 / 0.01))


def test_elo_rates_rock_paper_scissors_equal() -> None:
    found = analysis.elo(ROCK_PAPER_SCISSORS)
    np.testing.assert_allclose([*found.pursuers, *found.evaders, found.offset], 0, atol=1e-9)
    np.testing.assert_allclose(found.predict(), 0.5)
    cyclic = analysis.elo(ROCK_PAPER_SCISSORS, cycles=1)
    np.testing.assert_allclose(cyclic.predict(), ROCK_PAPER_SCISSORS, atol=1e-9)


def test_multi_elo_reproduces_a_known_cycle() -> None:
    a, b, c = planted(9, 6)
    turn = 2 * np.pi * (np.arange(9)[:, None] / 9 - np.arange(6) / 6)
    cycle = 0.8 * np.cos(turn)
    matrix = sigmoid(a[:, None] - b + c + cycle)
    found = analysis.elo(matrix, cycles=1, **EXACT)
    # Elo weights cells, so it takes up a little of the cycle, though its row means are 0.
    assert np.abs(found.u @ found.v.T - cycle).max() < 0.35
    assert analysis.log_loss(matrix, found.predict()) < 0.05 * analysis.log_loss(
        matrix, analysis.elo(matrix, **EXACT).predict()
    )
    pure = analysis.elo(sigmoid(cycle), cycles=1, **EXACT)
    np.testing.assert_allclose(pure.u @ pure.v.T, cycle, atol=1e-6)


def test_more_dimensions_fit_better_and_all_of_them_exactly() -> None:
    matrix = np.random.default_rng(5).random((6, 6))
    losses = [analysis.log_loss(matrix, analysis.elo(matrix, cycles=k).predict()) for k in range(4)]
    assert losses[0] > losses[1] > losses[2] > losses[3]
    assert losses[3] < 1e-12


def test_log_loss_by_hand() -> None:
    assert analysis.log_loss([[0.3, 1.0]], [[0.3, 1.0]]) == 0.0
    assert analysis.log_loss([[1.0]], [[0.5]]) == pytest.approx(np.log(2))
    assert analysis.log_loss([[0.25]], [[0.5]]) == pytest.approx(
        0.25 * np.log(0.5) + 0.75 * np.log(1.5)
    )
    assert analysis.log_loss([[0.5]], [[0.0]]) == np.inf
