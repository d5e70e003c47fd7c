"""Small worlds and payoff matrices as games of OpenSpiel."""

import importlib

import numpy as np
import pytest

import matrixworld as mw
from matrixworld.solver import solve

WORLDS = {
    "all at once": mw.WorldConfig("O", rows=1, cols=4, n_pursuers=1, n_evaders=1, max_steps=2),
    "team at once": mw.WorldConfig("R", rows=1, cols=4, n_pursuers=2, n_evaders=1, max_steps=1),
    "agent turns": mw.WorldConfig("TO", rows=2, cols=3, n_pursuers=1, n_evaders=1, max_steps=2),
}


@pytest.fixture
def games():
    """The recipe; tests are skipped one by one without the library, for .ci/run to repeat them."""
    pytest.importorskip("pyspiel")
    return importlib.import_module("openspiel_games")


@pytest.mark.slow
@pytest.mark.parametrize("config", WORLDS.values(), ids=WORLDS)
def test_value_iteration_finds_the_solution(config, games):
    pytest.importorskip("cvxpy")
    found = pytest.importorskip("open_spiel.python.algorithms.value_iteration")
    game = games.WorldGame(config)
    values = found.value_iteration(game, -1, 1e-9)
    start = game.new_initial_state()
    mean = sum(share * values[str(start.child(draw))] for draw, share in start.chance_outcomes())
    assert mean == pytest.approx(solve(config).value, abs=1e-6)


@pytest.mark.parametrize("config", WORLDS.values(), ids=WORLDS)
def test_a_world_passes_the_tests_of_the_library(config, games):
    game = games.WorldGame(config)
    games.pyspiel.random_sim_test(game, num_sims=5, serialize=False, verbose=False)
    state = game.new_initial_state()
    state.apply_action(0)
    assert sum(state.observation_tensor(0)) == config.n_agents + 2  # places, turn, all rounds


def test_a_payoff_is_a_matrix_game(games):
    rates = np.array([[0.1, 0.9, 0.4], [0.8, 0.2, 0.5]])
    game = games.matrix_game(rates)
    np.testing.assert_array_equal(game.row_utilities(), rates)
    np.testing.assert_array_equal(game.col_utilities(), -rates)
