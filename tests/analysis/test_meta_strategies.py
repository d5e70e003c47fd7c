"""Meta-solvers: by hand, and against SciPy."""

import numpy as np
import pytest
from hypothesis import given, settings
from scipy.optimize import linprog

from matrices import ROCK_PAPER_SCISSORS, payoffs
from matrixworld import analysis
from matrixworld.analysis.games import (
    META_SOLVERS,
    MetaSolver,
    projected_replicator_dynamics,
    rectified_nash,
)


def loss_limit(matrix: np.ndarray) -> float:
    """Return the least that the column player can hold the rows to, by its own programme."""
    n, m = matrix.shape
    found = linprog(
        np.append(np.zeros(m), 1.0),
        np.hstack([matrix, -np.ones((n, 1))]),
        np.zeros(n),
        np.append(np.ones(m), 0.0)[None],
        [1.0],
        [(0, None)] * m + [(None, None)],
    )
    return float(found.fun)


@settings(max_examples=15)
@given(payoffs(parts=10))
def test_a_nash_meta_strategy_holds_every_row_to_the_value(matrix: np.ndarray) -> None:
    weights = META_SOLVERS["nash"](matrix)
    assert (matrix @ weights).max() == pytest.approx(loss_limit(matrix), abs=1e-6)
    # The other team finds its own weights in its own payoffs.
    swapped = META_SOLVERS["nash"](1.0 - matrix.T)
    np.testing.assert_allclose(swapped, analysis.nash_averaging(matrix).pursuers, atol=1e-6)


@settings(max_examples=6)
@given(payoffs(parts=10))
def test_mean_mixtures_of_replicators_approach_an_equilibrium(matrix: np.ndarray) -> None:
    p, q = projected_replicator_dynamics(matrix, steps=1000, rate=0.02)
    for mixture in (p, q):
        assert mixture.min() >= 0.0
        assert mixture.sum() == pytest.approx(1.0)
    # The regret of replicators with such steps: log n / (rate steps) and rate / 2 for each team.
    bound = np.log(matrix.size) / 20 + 0.02
    assert analysis.exploitability(matrix, p, q).total < bound


def test_replicators_by_hand() -> None:
    # One step: row 0 gains .1 (.8 - .5) of its half; column 0 loses as much.
    p, q = projected_replicator_dynamics([[1.0, 0.6], [0.4, 0.0]], steps=1, rate=0.1)
    np.testing.assert_allclose(p, [(0.5 + 0.515) / 2, (0.5 + 0.485) / 2])
    np.testing.assert_allclose(q, [(0.5 + 0.49) / 2, (0.5 + 0.51) / 2])
    # The uniform mixture is a rest point of rock-paper-scissors.
    np.testing.assert_allclose(projected_replicator_dynamics(ROCK_PAPER_SCISSORS)[0], [1 / 3] * 3)
    # A dominated row falls to the smallest weight, from 1/2 along a logistic curve.
    p, _ = projected_replicator_dynamics([[1.0], [0.0]], steps=500, rate=0.02, least=0.1)
    assert p[1] == pytest.approx(0.1, abs=0.06)


def test_rectified_nash_by_hand() -> None:
    # Scissors, the newest, beat paper and tie scissors, which have equal weights.
    np.testing.assert_allclose(rectified_nash(ROCK_PAPER_SCISSORS), [0.0, 0.5, 0.5], atol=1e-9)
    # A newest generation that always loses has no weight, and meets the whole equilibrium.
    weak = np.vstack([ROCK_PAPER_SCISSORS, np.zeros(3)])
    np.testing.assert_allclose(rectified_nash(weak), [1 / 3] * 3, atol=1e-9)
    # With a value of .6, a rate of .5 is no tie.
    np.testing.assert_allclose(rectified_nash([[0.7, 0.5], [0.5, 0.7]]), [0.0, 1.0], atol=1e-9)


# The loop with exact responses


def loop(game: np.ndarray, solver: MetaSolver, rounds: int) -> tuple[list[float], np.ndarray]:
    """Return the NashConv of the meta-strategies of each round, and the last one of the rows."""
    rows, columns, gaps = [0], [0], []
    for _ in range(rounds):
        part = game[np.ix_(rows, columns)]
        p = np.bincount(rows, solver(1.0 - part.T), len(game))
        q = np.bincount(columns, solver(part), len(game.T))
        p, q = p / p.sum(), q / q.sum()
        gaps.append(analysis.exploitability(game, p, q).total)
        rows.append(int((game @ q).argmax()))
        columns.append(int((p @ game).argmin()))
    return gaps, p


def ladder(levels: int) -> np.ndarray:
    """Return rock-paper-scissors on each level of a transitive game: a higher level wins."""
    level, hand = np.divmod(np.arange(3 * levels), 3)
    higher = level[:, None] - level
    same = ROCK_PAPER_SCISSORS[hand][:, hand]
    return np.where(higher == 0, same, higher > 0)


def test_double_oracle_ends_in_an_equilibrium() -> None:
    gaps, _ = loop(ROCK_PAPER_SCISSORS, META_SOLVERS["nash"], 4)
    np.testing.assert_allclose(gaps, [1.0, 1.0, 0.0, 0.0], atol=1e-9)
    gaps, p = loop(ladder(4), META_SOLVERS["nash"], 13)
    assert gaps[-1] < 1e-6
    np.testing.assert_allclose(p[-3:], [1 / 3] * 3, atol=1e-6)  # the highest cycle has all weight


def test_rectified_responses_miss_an_equilibrium() -> None:
    """The example of McAleer et al. (2020), "Pipeline PSRO": a strategy that beats all a little."""
    payoff = np.array([[0, -1, 1, -0.4], [1, 0, -1, -0.4], [-1, 1, 0, -0.4], [0.4, 0.4, 0.4, 0]])
    game = (1.0 + payoff) / 2.0
    gaps, _ = loop(game, rectified_nash, 12)
    assert min(gaps) > 0.3
    assert loop(game, META_SOLVERS["nash"], 12)[0][-1] < 1e-6
