"""Held-out maps, and what teams do on them."""

from dataclasses import replace

import numpy as np
import pytest

import matrixworld as mw
from matrixworld.coevolution import TEAMS, held_out_maps, score_on_maps
from matrixworld.coevolution.evaluation.map_scores import GENERATORS
from matrixworld.coevolution.maps import playable
from matrixworld.solve import States, best_response, expected_payoff, solve

WORLD = mw.WorldConfig("TO", rows=4, cols=4, n_pursuers=2, n_evaders=1, max_steps=8, fov=7)


@pytest.mark.parametrize("shape", [(2, 2), (6, 6), (5, 9), (40, 30)])
def test_held_out_maps_are_open_and_connected(shape):
    maps = held_out_maps(*shape, 12)
    assert all(playable(walls, -(-walls.size // 2)) for walls in maps)
    assert np.array_equal(held_out_maps(*shape, 5), maps[:5])
    if shape != (2, 2):
        assert not np.array_equal(held_out_maps(*shape, 12, seed=1), maps)
        kinds = len(GENERATORS)
        assert all(maps[kind::kinds].any() for kind in range(kinds))


def test_scores_are_exact_where_they_are_asked_for():
    maps = held_out_maps(4, 4, 3)
    teams = {"pursuer": "chaser", "evader": "random"}
    found = score_on_maps(teams, WORLD, maps, exact=True, episodes=4000)
    assert score_on_maps(teams, WORLD, maps, episodes=4000, threads=1).regret == {}
    for number, walls in enumerate(maps):
        states = States(replace(WORLD, obstacles=walls))
        value = solve(states).value
        captured = expected_payoff(states, *teams.values())
        assert found.capture_rate[number] == pytest.approx(captured, abs=0.04)
        for team, sign in zip(TEAMS, (1, -1), strict=True):
            best = best_response(states, teams[team], team).value
            assert found.regret[team][number] == pytest.approx(sign * (value - best))


def test_wrong_arguments_are_refused():
    teams = {"pursuer": "chaser", "evader": "random"}
    with pytest.raises(TypeError, match="teams: expected a mapping with the keys"):
        score_on_maps({"pursuer": "chaser"}, WORLD, held_out_maps(4, 4, 1))
    with pytest.raises(ValueError, match="maps: expected at least one, got none"):
        score_on_maps(teams, WORLD, [])
    with pytest.raises(ValueError, match=r"obstacle map: expected shape \(4, 4\)"):
        score_on_maps(teams, WORLD, held_out_maps(5, 4, 1))
    with pytest.raises(ValueError, match="rows: expected"):
        held_out_maps(1, 4, 1)
