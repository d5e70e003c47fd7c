"""Games: equilibria by hand and by their properties, best responses, alpha-Rank, replicators."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import minimize

from matrices import ROCK_PAPER_SCISSORS, logistic, payoffs, staircase
from matrixworld import analysis
from matrixworld.analysis.games import effective_diversity_over_episodes, game_value

PENNIES = np.eye(2)


def entropy(p: np.ndarray) -> float:
    used = p[p > 0]
    return float(-(used * np.log(used)).sum())


@pytest.mark.parametrize(
    ("matrix", "value", "pursuers", "evaders"),
    [
        # Equalise: .8 p + .3 (1 - p) = .1 p + .6 (1 - p) at p = .3; .8 q + .1 (1 - q) = .3 q + ...
        ([[0.8, 0.1], [0.3, 0.6]], 0.45, [0.3, 0.7], [0.5, 0.5]),
        # A saddle point: the second row and first column dominate.
        ([[0.1, 0.9], [0.4, 0.5]], 0.4, [0.0, 1.0], [1.0, 0.0]),
        (ROCK_PAPER_SCISSORS, 1 / 2, [1 / 3] * 3, [1 / 3] * 3),
        (np.full((3, 2), 0.7), 0.7, [1 / 3] * 3, [1 / 2] * 2),
        # Row 0 may have any weight up to a quarter; maximum entropy takes a quarter.
        ([[0.5, 0.2], [0.5, 0.6]], 0.5, [0.25, 0.75], [1.0, 0.0]),
    ],
)
def test_games_worked_out_by_hand(
    matrix: object, value: float, pursuers: list[float], evaders: list[float]
) -> None:
    found = analysis.nash_averaging(matrix)  # type: ignore[arg-type]
    assert found.value == pytest.approx(value)
    np.testing.assert_allclose(found.pursuers, pursuers, atol=1e-7)
    np.testing.assert_allclose(found.evaders, evaders, atol=1e-7)
    assert game_value(matrix) == pytest.approx(value)  # type: ignore[arg-type]


@given(payoffs(parts=8))
def test_mixtures_are_an_equilibrium(matrix: np.ndarray) -> None:
    found = analysis.nash_averaging(matrix)
    assert found.pursuers.min() >= 0.0
    assert found.pursuers.sum() == pytest.approx(1.0)
    gains = analysis.exploitability(matrix, found.pursuers, found.evaders)
    assert gains.total < 1e-6
    assert (found.pursuer_averages <= found.value + 1e-6).all()
    assert (found.evader_averages <= 1 - found.value + 1e-6).all()
    np.testing.assert_allclose(found.pursuer_averages, matrix @ found.evaders)


@given(payoffs(parts=8), st.data())
def test_copies_change_nothing_but_share_their_weight(
    matrix: np.ndarray, data: st.DataObject
) -> None:
    row = data.draw(st.integers(0, len(matrix) - 1))
    found = analysis.nash_averaging(matrix)
    copied = analysis.nash_averaging(np.vstack([matrix, matrix[row]]))
    assert copied.value == pytest.approx(found.value)
    assert copied.pursuers[row] == pytest.approx(copied.pursuers[-1], abs=1e-6)
    np.testing.assert_allclose(copied.pursuer_averages[:-1], found.pursuer_averages, atol=1e-5)
    np.testing.assert_allclose(copied.evaders, found.evaders, atol=1e-5)


@given(payoffs(parts=8))
def test_no_other_equilibrium_has_more_entropy(matrix: np.ndarray) -> None:
    """Compare with a general optimiser over the optimal mixtures, from two starts."""
    found = analysis.nash_averaging(matrix)
    rows = len(matrix)
    constraints = [
        {"type": "eq", "fun": lambda p: p.sum() - 1},
        {"type": "ineq", "fun": lambda p: p @ matrix - found.value + 1e-9},
    ]
    for start in (found.pursuers, np.full(rows, 1 / rows)):
        other = minimize(
            lambda p: float(np.sum(p * np.log(np.maximum(p, 1e-12)))),
            start,
            method="SLSQP",
            bounds=[(0, 1)] * rows,
            constraints=constraints,
            options={"maxiter": 300},
        )
        p = np.maximum(other.x, 0)
        if abs(p.sum() - 1) < 1e-6 and (p @ matrix).min() > found.value - 1e-6:
            assert entropy(p) < entropy(found.pursuers) + 1e-3


# ---- exploitability -----------------------------------------------------------------------------


def test_exploitability_by_hand() -> None:
    gains = analysis.exploitability(ROCK_PAPER_SCISSORS, [1, 0, 0], [0.5, 0.25, 0.25])
    # Rock gets .5 * .5 + .25 = .5; the answer to rock takes all of it; paper gets .5 + .125.
    assert gains.pursuers == pytest.approx(0.5)
    assert gains.evaders == pytest.approx(0.125)
    assert gains.total == pytest.approx(0.625)


# ---- alpha-Rank against the Markov chain built state by state ------------------------------------


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


@pytest.mark.parametrize(("alpha", "population"), [(0.1, 2), (2.0, 10), (0.5, 50)])
def test_shares_are_the_stationary_distribution_of_the_chain(alpha: float, population: int) -> None:
    rng = np.random.default_rng(0)
    for matrix in (rng.random((3, 4)), rng.integers(0, 5, (4, 3)) / 4, ROCK_PAPER_SCISSORS):
        found = analysis.alpha_rank(matrix, alpha=alpha, population=population)
        expected = by_brute_force(matrix, alpha, population)
        np.testing.assert_allclose(found.pairs, expected, atol=1e-10)
        np.testing.assert_allclose(found.pursuers, expected.sum(axis=1), atol=1e-10)
        np.testing.assert_allclose(found.evaders, expected.sum(axis=0), atol=1e-10)


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


# ---- Effective diversity -------------------------------------------------------------------------


def test_diversity_worked_out_by_hand() -> None:
    assert analysis.effective_diversity(ROCK_PAPER_SCISSORS) == pytest.approx(3 * 0.5 / 9)
    assert analysis.effective_diversity(PENNIES) == pytest.approx(2 * 0.5 / 4)
    # The best generation of a transitive race is not diverse.
    assert analysis.effective_diversity(logistic(9)) == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize(
    ("rates", "diverse"),
    [(np.full((9, 9), 0.5), False), (logistic(9, 0.5), False),
     (0.1 + 0.8 * np.kron(np.ones((3, 3)), ROCK_PAPER_SCISSORS), True)],
)  # fmt: skip
def test_noise_is_not_taken_for_diversity(rates: np.ndarray, diverse: bool) -> None:
    truth, rng = analysis.effective_diversity(rates), np.random.default_rng(0)
    scores = [(rng.random((9, 9, 20)) < rates[..., None]).astype(float) for _ in range(6)]
    found = [effective_diversity_over_episodes(each) for each in scores]
    # The number of the measured matrix is too large.
    assert np.mean([analysis.effective_diversity(s.mean(axis=2)) for s in scores]) > truth + 0.001
    assert sum(one.ends[0] > 0 for one in found) == (len(found) if diverse else 0)
    assert sum(one.ends[0] <= truth + 1e-9 <= one.ends[1] + 2e-9 for one in found) >= 5


# ---- Replicator dynamics: beside a plain integrator, and what is known of zero-sum games ---------


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
