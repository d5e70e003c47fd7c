"""Small worlds and payoff matrices as games of OpenSpiel."""

from typing import Any

import numpy as np
import pytest

import matrixworld as mw
from matrixworld.analysis.games import META_SOLVERS
from matrixworld.integrations.openspiel import matrix_game, world_game
from matrixworld.solve import solve

WORLDS = {
    "all at once": mw.WorldConfig("O", rows=1, cols=4, n_pursuers=1, n_evaders=1, max_steps=2),
    "team at once": mw.WorldConfig("R", rows=1, cols=4, n_pursuers=2, n_evaders=1, max_steps=1),
    "agent turns": mw.WorldConfig("TO", rows=2, cols=3, n_pursuers=1, n_evaders=1, max_steps=2),
}


@pytest.fixture(autouse=True)
def pyspiel() -> Any:
    """The library; the tests are skipped without it, one by one."""
    return pytest.importorskip("pyspiel")


@pytest.mark.slow
@pytest.mark.parametrize("config", WORLDS.values(), ids=WORLDS)
def test_value_iteration_of_the_library_finds_the_solution(config: mw.WorldConfig) -> None:
    pytest.importorskip("cvxpy")
    found = pytest.importorskip("open_spiel.python.algorithms.value_iteration")
    game = world_game(config)
    values = found.value_iteration(game, -1, 1e-9)
    start = game.new_initial_state()
    mean = sum(share * values[str(start.child(draw))] for draw, share in start.chance_outcomes())
    assert mean == pytest.approx(solve(config).value, abs=1e-6)


@pytest.mark.parametrize("config", WORLDS.values(), ids=WORLDS)
def test_a_world_passes_the_tests_of_the_library(config: mw.WorldConfig, pyspiel: Any) -> None:
    game = world_game(config)
    pyspiel.random_sim_test(game, num_sims=5, serialize=False, verbose=False)
    state = game.new_initial_state()
    state.apply_action(0)
    assert sum(state.observation_tensor(0)) == config.n_agents + 2  # places, turn, all rounds


def test_a_payoff_is_a_matrix_game() -> None:
    rates = np.array([[0.1, 0.9, 0.4], [0.8, 0.2, 0.5]])
    game = matrix_game(rates)
    np.testing.assert_array_equal(game.row_utilities(), rates)
    np.testing.assert_array_equal(game.col_utilities(), -rates)
    with pytest.raises(ValueError, match=r"^payoff: expected shape \(G, H\), got \(2,\)"):
        matrix_game(rates[:, 0])


@pytest.mark.parametrize("shape", [(2, 2), (3, 5), (8, 7)])
def test_mixtures_are_those_of_the_library(shape: tuple[int, int]) -> None:
    strategies = pytest.importorskip("open_spiel.python.algorithms.psro_v2.meta_strategies")
    matrix = np.random.default_rng(0).random(shape)
    solver = type("Solver", (), {"get_meta_game": lambda self: [matrix, -matrix]})()
    # Random payoffs have one equilibrium.
    expected = strategies.META_STRATEGY_METHODS["nash"](solver)
    np.testing.assert_allclose(META_SOLVERS["nash"](matrix), expected[1], atol=1e-6)
