"""Teams that learn in several worlds: one of them in each epoch."""

import numpy as np
import pytest

from command_line import matrixworld_command
from matrixworld.coevolution import RaceSettings, score
from tiny_race import WORLDS, Listening, played, results, tiny_race, tiny_single

RACE = tiny_race(training_worlds=WORLDS)


def test_fields_that_are_not_given_are_those_of_the_world_and_of_training():
    rows = [(w.rows, w.n_pursuers, w.density, w.max_steps) for w in RACE.game.training_worlds]
    assert rows == [(6, 1, 0.0, 8), (5, 2, 0.0, 8), (6, 2, 0.1, 5)]
    assert RaceSettings.from_json(RACE.to_json()) == RACE


def test_the_world_itself_changes_nothing(tmp_path):
    played(tiny_race(), tmp_path / "plain")
    played(tiny_race(training_worlds=[{}]), tmp_path / "one")
    plain, one = results(tmp_path / "plain"), results(tmp_path / "one")
    assert plain.pop("config.json") != one.pop("config.json")
    assert plain == one


def test_worlds_are_drawn_by_their_shares(tmp_path):
    play = Listening()
    shares = {"training_worlds": WORLDS, "training_shares": (6, 1, 1)}
    settings = tiny_single(**shares, epochs=80, archive_every=80)
    played(settings, tmp_path / "run", play)
    *training, evaluation = [config for config, *_ in play.calls]
    counts = [training.count(world) for world in settings.game.training_worlds]
    assert sum(counts) == 80
    # Three standard deviations of a binomial number of 80 epochs, with the share 3/4.
    assert counts[0] == pytest.approx(60, abs=12)
    assert min(counts) > 0
    assert evaluation == settings.game.world


def test_scores_in_every_world_of_training(tmp_path):
    run = played(tiny_single(training_worlds=WORLDS), tmp_path / "run")
    told = matrixworld_command("score", run.path, "--episodes", 2).output
    assert "in a world of training: 5 x 6, 2 v 3\n" in told
    assert "in a world of training: 6 x 6, 2 v 3, with obstacles" in told
    small = run.settings.game.training_worlds[0]
    found = score(run, world=small, episodes=2)["pursuer"]
    # One evader is captured, or none.
    assert {*np.unique(found.rates)} <= {0.0, 1.0}
