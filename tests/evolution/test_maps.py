"""Maps: what edits do, against a flood fill written down again; the archive; held-out maps."""

from dataclasses import replace

import numpy as np
import pytest

import matrixworld as mw
from maps.archive import MapArchive, edited, playable, random_map
from maps.held_out import GENERATORS, held_out_maps, regrets
from matrixworld.coevolution import TEAMS
from matrixworld.solver import States, best_response, solve

WORLD = mw.WorldConfig("TO", rows=4, cols=4, n_pursuers=2, n_evaders=1, max_steps=8, fov=7)


def reachable(walls):
    """Return whether steps to the four sides lead from one free cell to all others."""
    free = {(int(row), int(col)) for row, col in np.argwhere(~walls)}
    found, left = set(), [min(free)]
    while left:
        row, col = left.pop()
        if (row, col) in free and (row, col) not in found:
            found.add((row, col))
            left += [(row + 1, col), (row - 1, col), (row, col + 1), (row, col - 1)]
    return found == free


@pytest.mark.parametrize("shape", [(6, 6), (1, 7), (3, 5)])
def test_maps_stay_connected_with_room_for_all(shape):
    rng = np.random.default_rng(1)
    changes = set()
    for share in (0.0, 0.2, 0.9):
        walls = random_map(shape, share, 3, rng)
        for _ in range(100):
            child = edited(walls, 3, rng)
            changes.add((int((child & ~walls).sum()), int((walls & ~child).sum())))
            assert (~child).sum() >= 3
            assert reachable(child)
            assert playable(child, 3)
            walls = child
    assert changes == {(1, 0), (0, 1), (1, 1)}  # added, removed, moved


def test_better_maps_are_offered_more_often_and_equal_ones_alike():
    archive = MapArchive([np.zeros((2, 2), bool)] * 4)
    assert np.allclose(archive.weights, 0.25)
    archive.scores = np.array([0.1, 0.4, 0.1, 0.2])
    assert np.allclose(archive.weights * (1 + 1 / 2 + 2 / 3), [1 / 3, 1, 1 / 3, 1 / 2])
    archive.keep_best(3)
    assert archive.scores.tolist() == [0.4, 0.2, 0.1]


@pytest.mark.parametrize("shape", [(2, 2), (6, 6), (5, 9), (40, 30)])
def test_held_out_maps_are_open_and_connected(shape):
    maps = held_out_maps(*shape, 12)
    assert all(playable(walls, -(-walls.size // 2)) for walls in maps)
    assert np.array_equal(held_out_maps(*shape, 5), maps[:5])
    if shape != (2, 2):
        assert not np.array_equal(held_out_maps(*shape, 12, seed=1), maps)
        kinds = len(GENERATORS)
        assert all(maps[kind::kinds].any() for kind in range(kinds))


def test_regret_on_maps_is_what_best_responses_gain():
    maps, teams = held_out_maps(4, 4, 3), {"pursuer": "chaser", "evader": "random"}
    found = regrets(teams, WORLD, maps)
    for number, walls in enumerate(maps):
        states = States(replace(WORLD, obstacles=walls))
        value = solve(states).value
        for team, sign in zip(TEAMS, (1, -1), strict=True):
            best = best_response(states, teams[team], team).value
            assert found[team][number] == pytest.approx(sign * (value - best))
