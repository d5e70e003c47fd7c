"""Maps that evolve: what edits do, what is played where, and that races on them resume."""

from dataclasses import replace
from functools import partial

import numpy as np
import pytest

import matrixworld as mw
from maps.archive import MAP_FITNESS, edited, playable, random_map
from maps.held_out import GENERATORS, held_out_maps
from maps.race import MapRace, MapSettings
from matrixworld.coevolution import TEAMS
from matrixworld.solver import States, best_response
from tiny_race import Listening, playing, results, stop_and_continue, tiny_race


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


@pytest.mark.parametrize("shape", [(2, 2), (6, 6), (5, 9), (40, 30)])
def test_held_out_maps_are_open_and_connected(shape):
    maps = held_out_maps(*shape, 12)
    assert all(playable(walls, -(-walls.size // 2)) for walls in maps)
    assert np.array_equal(held_out_maps(*shape, 5), maps[:5])
    if shape != (2, 2):
        assert not np.array_equal(held_out_maps(*shape, 12, seed=1), maps)
        kinds = len(GENERATORS)
        assert all(maps[kind::kinds].any() for kind in range(kinds))


RACE = tiny_race(
    rules="TO", rows=4, cols=4, n_pursuers=2, n_evaders=1, fov=7, max_steps=6, train_steps=6,
    match_episodes=3, obstacles=0.1,
)  # fmt: skip
N_NEW = 4 + 3 + 2


def settings_of(fitness, **changes):
    small = MapSettings(RACE, fitness, maps=4, children=3, fresh=2, matches=2, seed=5)
    return replace(small, **changes)


class Watched(MapRace):
    """A race that lists its maps generation by generation."""

    def learn(self, stage):
        super().learn(stage)
        if stage % 2:
            self.archives = [*getattr(self, "archives", []), vars(self.maps)]


def played(settings, directory):
    """Return the arguments and scores of all matches, the maps of each generation, and the race."""
    listening = Listening()
    race = playing(Watched(settings, directory), listening)
    race.run()
    return listening.calls, race.archives, race


@pytest.mark.parametrize("fitness", MAP_FITNESS)
def test_teams_learn_on_archived_maps_and_are_evaluated_in_the_world(tmp_path, fitness):
    calls, archives, race = played(settings_of(fitness), tmp_path / "run")
    assert all(playable(walls, 3) for each in archives for walls in each["maps"])
    per_map = N_NEW if MAP_FITNESS[fitness].plays else 0
    generation = 5 + per_map
    # Epochs are played on the maps of the generation before.
    known = [walls.tobytes() for walls in archives[0]["maps"]]
    second = calls[generation : generation + 5]
    assert all(world.map.tobytes() in known for world, *_ in second)
    assert len({world.map.tobytes() for world, *_ in second}) > 1
    assert {world.density for world, *_ in calls[-3:]} == {0.1}
    matches = sum(scores.length.size for *_, scores in calls[:-3])
    assert matches == race.files.log()["matches"][-1]


def test_regret_is_how_far_both_champions_fall_short(tmp_path):
    _, archives, race = played(settings_of("regret"), tmp_path / "run")
    pair = [
        mw.Population(race.archive[team][-1][None], race.settings.evaluation_game.policy)
        for team in TEAMS
    ]
    for walls, score in zip(archives[-1]["maps"], archives[-1]["scores"], strict=True):
        states = States(replace(RACE.training_game.world, obstacles=walls))
        low, high = (best_response(states, *each).value for each in zip(pair, TEAMS, strict=True))
        assert score == pytest.approx(high - low)


@pytest.mark.parametrize(
    ("fitness", "call"), [("learnability", 7), ("regret", 9), ("none", 6), ("max-monte-carlo", 12)]
)
def test_a_stopped_race_ends_as_if_never_stopped(tmp_path, fitness, call):
    make = partial(MapRace, settings_of(fitness))
    make(tmp_path / "straight", threads=3).run()
    stop_and_continue(make, call, tmp_path / "run")
    assert results(tmp_path / "run") == results(tmp_path / "straight")
    with pytest.raises(ValueError, match="holds a race on maps of other settings"):
        MapRace(settings_of(fitness, edits=9), tmp_path / "run")
