"""Teams that rate moves by different inputs: settings, files, learners, what is said of them."""

import json

import numpy as np
import pytest

import matrixworld as mw
from matrixworld.cli.setting_options import parsed
from matrixworld.coevolution import RaceSettings, open_run
from matrixworld.coevolution.settings.race_settings import SettingError
from matrixworld.coevolution.types import TEAMS
from tiny_race import begun, check_resumes, played, tiny_race, tiny_single

PAIR = (("adversary", "room"), ("parity", "adversary", "escapes"))


def race(policy="rating", learner="es", inputs=PAIR, **changes):
    hidden = {} if policy == "program" else {"hidden": ()}
    return tiny_race(policy=policy, learner=learner, inputs=inputs, **hidden, **changes)


@pytest.mark.parametrize("learner", ["es", "ga", "cma", "gp"])
def test_each_team_has_its_inputs(tmp_path, learner):
    policy = "program" if learner == "gp" else "rating"
    settings = race(policy, learner, population=6)
    run = played(settings, tmp_path / "run")
    config = json.loads((tmp_path / "run" / "config.json").read_text())
    assert config["settings"]["policy"]["inputs"] == [list(names) for names in PAIR]
    assert RaceSettings.from_json(config["settings"]) == settings == open_run(run.path).settings
    for team, names in zip(TEAMS, PAIR, strict=True):
        plays, told = run.teams[team], run.explain(team, episodes=2)
        assert plays.policy.inputs == run.policy(team).policy.inputs == names
        assert plays.genomes.shape == (3, plays.policy.genome_size)
        assert {term.input for term in told.terms} <= {*names}
    # The evaluation's matches, by the policies of the run.
    sides = [mw.Population(run.teams[team].genomes, run.teams[team].policy) for team in TEAMS]
    assert mw.rollout(settings.game.world, *sides, mw.Matches.of(2, 2, 5)).length.shape == (1, 1)


def test_a_pair_of_equal_lists_is_one_list(tmp_path):
    """Genomes and scores are the same bit by bit."""
    one, two = ((tmp_path / name) for name in "ab")
    first, second = played(race(inputs=PAIR[1]), one), played(race(inputs=(PAIR[1],) * 2), two)
    for team in TEAMS:
        np.testing.assert_array_equal(first.teams[team].genomes, second.teams[team].genomes)
    np.testing.assert_array_equal(first.payoff().matrix, second.payoff().matrix)


@pytest.mark.parametrize("call", [2, 5])
def test_an_interrupted_race_goes_on(tmp_path, call):
    check_resumes(race(), call, tmp_path / "run")


def test_a_genome_to_start_from_has_the_inputs_of_its_team(tmp_path):
    path = str(played(race(), tmp_path / "race").path)
    shape = {"policy": "rating", "hidden": (), "start": path}
    begun(tiny_single(**shape, inputs=PAIR, team="evader"), tmp_path / "evaders").run()
    with pytest.raises(ValueError, match=r"^start: expected a genome of Rating\(inputs=\('adver"):
        begun(tiny_single(**shape, inputs=PAIR[::-1], team="evader"), tmp_path / "others")


def test_options_take_a_pair():
    text = '[["adversary", "room"], ["parity", "adversary", "escapes"]]'
    assert race(inputs=parsed(text)).game.policy.inputs == PAIR


@pytest.mark.parametrize(
    "inputs", [["wall"], [["room"]], [["room"], ["wall"]], [["room"], "exits"], [["room"]] * 3,
               [["room"], []], [["room"], ["exits", "exits"]], "room"],
)  # fmt: skip
def test_other_inputs_are_refused(inputs):
    expected = r"inputs: expected a sequence of different ones of adversary, .*; or two, the purs"
    with pytest.raises(SettingError, match=expected):
        race(inputs=inputs)
