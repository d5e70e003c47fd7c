"""Games: equilibria by hand and by their properties, and best responses."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from matrices import ROCK_PAPER_SCISSORS, payoffs
from matrixworld import analysis
from matrixworld.analysis.games import game_value


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
def test_games_worked_out_by_hand(matrix, value, pursuers, evaders):
    found = analysis.nash_averaging(matrix)
    assert found.value == pytest.approx(value)
    np.testing.assert_allclose(found.pursuers, pursuers, atol=1e-7)
    np.testing.assert_allclose(found.evaders, evaders, atol=1e-7)
    assert game_value(matrix) == pytest.approx(value)


@given(payoffs(parts=8))
def test_mixtures_are_an_equilibrium(matrix):
    found = analysis.nash_averaging(matrix)
    assert found.pursuers.min() >= 0.0
    assert found.pursuers.sum() == pytest.approx(1.0)
    # The other team finds its own weights in its own payoffs.
    swapped = analysis.nash_averaging(1.0 - matrix.T)
    np.testing.assert_allclose(swapped.evaders, found.pursuers, atol=1e-6)
    gains = analysis.exploitability(matrix, found.pursuers, found.evaders)
    assert gains.total < 1e-6
    assert (found.pursuer_averages <= found.value + 1e-6).all()
    assert (found.evader_averages <= 1 - found.value + 1e-6).all()
    np.testing.assert_allclose(found.pursuer_averages, matrix @ found.evaders)


@given(payoffs(parts=8), st.data())
def test_copies_change_nothing_and_share_weight(matrix, data):
    row = data.draw(st.integers(0, len(matrix) - 1))
    found = analysis.nash_averaging(matrix)
    copied = analysis.nash_averaging(np.vstack([matrix, matrix[row]]))
    assert copied.value == pytest.approx(found.value)
    assert copied.pursuers[row] == pytest.approx(copied.pursuers[-1], abs=1e-6)
    np.testing.assert_allclose(copied.pursuer_averages[:-1], found.pursuer_averages, atol=1e-5)
    np.testing.assert_allclose(copied.evaders, found.evaders, atol=1e-5)


def test_exploitability_by_hand():
    gains = analysis.exploitability(ROCK_PAPER_SCISSORS, [1, 0, 0], [0.5, 0.25, 0.25])
    # Rock gets .5 * .5 + .25 = .5; the answer to rock takes all of it; paper gets .5 + .125.
    assert gains.pursuers == pytest.approx(0.5)
    assert gains.evaders == pytest.approx(0.125)
    assert gains.total == pytest.approx(0.625)
