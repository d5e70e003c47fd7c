"""alpha-Rank against the Markov chain built state by state."""

from __future__ import annotations

import math

import numpy as np
import pytest

from matrices import ROCK_PAPER_SCISSORS, logistic, staircase
from matrixworld import analysis
from matrixworld.analysis.games import fixation_probability


def by_brute_force(matrix: np.ndarray, alpha: float, m: int) -> np.ndarray:
    """Compute the chain from the published formulas, and its stationary eigenvector."""
    rows, columns = matrix.shape
    states = [(p, e) for p in range(rows) for e in range(columns)]
    chain = np.zeros((len(states), len(states)))
    eta = 1 / (rows + columns - 2)
    for i, (p, e) in enumerate(states):
        for j, (p2, e2) in enumerate(states):
            if (p != p2) == (e != e2):
                continue
            before, after = matrix[p, e], matrix[p2, e2]
            d = after - before if p != p2 else (1 - after) - (1 - before)
            rho = (1 - math.exp(-alpha * d)) / (1 - math.exp(-m * alpha * d)) if d else 1 / m
            chain[i, j] = eta * rho
        chain[i, i] = 1 - chain[i].sum()
    values, vectors = np.linalg.eig(chain.T)
    stationary = np.real(vectors[:, np.argmin(np.abs(values - 1))])
    return (stationary / stationary.sum()).reshape(matrix.shape)


@pytest.mark.parametrize(("alpha", "population"), [(0.1, 2), (1.0, 5), (2.0, 10), (0.5, 50)])
def test_shares_are_the_stationary_distribution_of_the_chain(alpha: float, population: int) -> None:
    rng = np.random.default_rng(0)
    for matrix in (rng.random((3, 4)), rng.integers(0, 5, (4, 3)) / 4, ROCK_PAPER_SCISSORS):
        found = analysis.alpha_rank(matrix, alpha=alpha, population=population)
        expected = by_brute_force(matrix, alpha, population)
        np.testing.assert_allclose(found.pairs, expected, atol=1e-10)
        np.testing.assert_allclose(found.pursuers, expected.sum(axis=1), atol=1e-10)
        np.testing.assert_allclose(found.evaders, expected.sum(axis=0), atol=1e-10)


def test_blocks_of_states_do_not_matter() -> None:
    matrix = np.random.default_rng(1).random((12, 11))  # 132 states: three blocks
    found = analysis.alpha_rank(matrix, alpha=1.0, population=5)
    np.testing.assert_allclose(found.pairs, by_brute_force(matrix, 1.0, 5), atol=1e-9)


@pytest.mark.parametrize("alpha", [0.1, 100.0, 1e6, math.inf])
def test_rock_paper_scissors_is_uniform(alpha: float) -> None:
    found = analysis.alpha_rank(ROCK_PAPER_SCISSORS, alpha=alpha)
    np.testing.assert_allclose(found.pursuers, 1 / 3)
    np.testing.assert_allclose(found.evaders, 1 / 3)


@pytest.mark.parametrize("alpha", [100.0, 1e6, math.inf])
def test_strong_selection_keeps_the_best_pair(alpha: float) -> None:
    found = analysis.alpha_rank(logistic(9), alpha=alpha)
    assert found.pairs[8, 8] > 0.97
    assert analysis.alpha_rank([[0.5]], alpha=alpha).pairs.tolist() == [[1.0]]
    # Pursuers 8 capture all evaders, so evaders drift; when they are at 0, pursuers drift, too.
    drifting = analysis.alpha_rank(staircase(9), alpha=alpha)
    assert drifting.pursuers.argmax() == 8
    assert drifting.pairs[8].sum() > 0.9
    assert drifting.pairs[0, 1:].sum() < 2e-3


def test_infinite_alpha_is_the_limit_of_large_alpha() -> None:
    matrix = np.random.default_rng(2).integers(0, 6, (6, 5)) / 5
    limit = analysis.alpha_rank(matrix, alpha=math.inf)
    np.testing.assert_allclose(analysis.alpha_rank(matrix, alpha=1e4).pairs, limit.pairs, atol=1e-9)


def test_fixation_probability_has_no_jump_at_zero_and_no_overflow() -> None:
    gains = [0.0, 1e-320, 1e-300, -1e-300, 1e-15, -1e-15]
    found = fixation_probability(gains, alpha=1.0, population=50)
    np.testing.assert_allclose(found, 1 / 50, rtol=1e-12)
    extreme = fixation_probability([-1.0, 1.0], alpha=1e300, population=50)
    assert extreme.tolist() == [0.0, 1.0]
    limit = fixation_probability([[-0.1, 0.0, 0.1]], alpha=math.inf, population=4)
    assert limit.tolist() == [[0.0, 0.25, 1.0]]
