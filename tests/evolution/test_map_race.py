"""Races on maps that evolve: what is played where, what is kept, and that they resume."""

from dataclasses import replace
from functools import partial

import pytest

import matrixworld as mw
from maps.archive import MAP_FITNESS, playable
from maps.race import MapSettings, MapTraining, begun
from matrixworld.coevolution import TEAMS
from matrixworld.solver import States, best_response
from tiny_race import Listening, playing, results, stop_and_continue, tiny_race

RACE = tiny_race(
    rules="TO", rows=4, cols=4, n_pursuers=2, n_evaders=1, fov=7, max_steps=6, train_steps=6,
    match_episodes=3, obstacles=0.1,
)  # fmt: skip
N_NEW = 4 + 3 + 2


def settings_of(fitness, **changes):
    small = MapSettings(RACE, fitness, maps=4, children=3, fresh=2, matches=2, seed=5)
    return replace(small, **changes)


class Watched(MapTraining):
    """A race that lists its maps generation by generation."""

    def end_stage(self):
        super().end_stage()
        if self.stage % 2 == 0:
            self.archives = [*getattr(self, "archives", []), vars(self.maps)]


def played(settings, directory):
    """Return the arguments and scores of all matches, the maps of each generation, and the race."""
    listening = Listening()
    race = playing(begun(settings, directory, training=Watched), listening)
    race.run()
    return listening.calls, race.training.archives, race


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
        mw.Population(
            race.training.archive[team][-1][None], race.settings.evaluation_game.policies[team]
        )
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
    make = partial(begun, settings_of(fitness))
    make(tmp_path / "straight", threads=3).run()
    stop_and_continue(make, call, tmp_path / "run")
    assert results(tmp_path / "run") == results(tmp_path / "straight")
    with pytest.raises(ValueError, match="holds a race on maps of other settings"):
        begun(settings_of(fitness, edits=9), tmp_path / "run")
