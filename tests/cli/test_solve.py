"""``matrixworld solve``: the numbers that it prints and writes."""

import json

import pytest

from command_line import matrixworld_command
from matrixworld.coevolution import TEAMS, evolve
from matrixworld.solver import States, best_response, expected_payoff, solve
from tiny_race import settings_of

SMALL = ("--rows", 4, "--cols", 4, "--n-evaders", 1)


@pytest.mark.parametrize(
    ("game", "value"), [(("O", 2), 0.838), (("to", 2), None), (("to", 1), None)]
)
def test_the_numbers_of_a_small_world(game, value):
    variant, pursuers = game
    words = ("--variant", variant, "--n-pursuers", pursuers, "--steps", 5)
    result = matrixworld_command("solve", *SMALL, *words, "--json", "-")
    found, said = json.loads(result.stdout), result.stderr
    assert found["value"] == found["value_by_step"][-1]
    assert found["gap"] < 1e-9
    assert value is None or found["value"] == pytest.approx(value, abs=0.005)
    assert "the mean capture rate over all starts" in said


def test_the_best_opponents_of_runs(tmp_path):
    quick = {"generations": 1, "pursuer_epochs": 1, "evader_epochs": 1, "population": 2}
    small = {"rows": 4, "cols": 4, "n_pursuers": 2, "n_evaders": 1, "max_steps": 3, "fov": 7}
    settings = [settings_of(rules="TO", **small, **quick, seed=seed) for seed in (0, 1)]
    runs = evolve(settings, tmp_path / "job", threads=1)
    before = sorted(tmp_path.rglob("*"))
    result = matrixworld_command("solve", "--run", "job", "--json", "-")
    (group,) = json.loads(result.stdout)["groups"].values()
    states = States(settings[0].game.world)
    assert group["seeds"] == [0, 1]
    assert group["value"] == solve(states).value
    for number, run in enumerate(runs):
        teams = {team: run.last(team) for team in TEAMS}
        met = expected_payoff(states, *teams.values())
        for champion in TEAMS:
            best = best_response(states, teams[champion], champion).value
            sign = 1 if champion == "evader" else -1  # the score of the champion's opponent
            numbers = {name: each[number] for name, each in group[f"{champion}s"].items()}
            assert numbers["gain"] == pytest.approx(sign * (best - met))
            assert numbers["exploitability"] == pytest.approx(sign * (best - group["value"]))
            assert min(numbers["gain"], numbers["exploitability"]) > -1e-9
            row = [str(number), *(f"{each:.3f}" for each in numbers.values())]
            assert row in [line.split() for line in result.stderr.splitlines()]
    for text in ("exact capture rate against the last evaders", "exact escape rate", "mean"):
        assert text in result.stderr
    assert sorted(tmp_path.rglob("*")) == before
