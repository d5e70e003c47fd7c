"""``matrixworld solve``: what it prints, and worlds that it refuses."""

import json

import pytest

import matrixworld as mw
from command_line import matrixworld_command
from matrixworld.coevolution import evolve
from matrixworld.solve import States, expected_payoff, guarantees
from tiny_race import settings_of

SMALL = ("--rows", 4, "--cols", 4, "--pursuers", 2, "--evaders", 1)


def solved(*words: object) -> tuple[dict, str]:
    """Return the numbers that the command writes, and what it prints."""
    result = matrixworld_command("solve", *words, "--json", "-")
    return json.loads(result.stdout), result.stderr


def test_the_numbers_of_two_pursuers_on_4_x_4():
    found, said = solved("--variant", "O", *SMALL, "--steps", 5)
    assert found["value"] == pytest.approx(0.838, abs=0.005)
    assert found["value"] == found["value_by_step"][5]
    assert found["gap"] < 1e-9
    assert (found["states"], found["world"]["max_steps"]) == (1922, 5)
    assert "capture rate after 5 steps" in said
    assert "capture_time" not in found


@pytest.mark.parametrize(("pursuers", "time"), [(2, 3), (1, None)])
def test_cops_and_robbers(pursuers, time):
    found, said = solved("--variant", "to", *SMALL, "--pursuers", pursuers)
    assert found["capture_time"] == time
    assert ("never: the evaders can escape" in said) == (time is None)


def test_exploit_exact_prints_what_the_functions_return_and_writes_nothing(tmp_path):
    quick = {"generations": 1, "pursuer_epochs": 1, "evader_epochs": 1, "population": 2}
    small = {"rows": 3, "cols": 3, "n_pursuers": 2, "n_evaders": 1, "max_steps": 2}
    settings = [settings_of(**small, **quick, seed=seed) for seed in (0, 1)]
    runs = evolve(settings, tmp_path / "job")
    before = sorted(tmp_path.rglob("*"))
    said = matrixworld_command("exploit", "job", "--champion", "evader", "--exact").stdout
    states = States(settings[0].world)
    gains = []
    for seed, run in enumerate(runs):
        truth = guarantees(states, run.teams)
        pursuers, evaders = (
            mw.Population(each.genomes[-1:], each.network) for each in run.teams.values()
        )
        met = expected_payoff(states, pursuers, evaders)
        short = truth.exploitability["evader"][-1]
        assert truth.nash_conv == pytest.approx(sum(truth.exploitability.values()))
        numbers = (met, truth.evaders[-1], truth.evaders[-1] - met, short)
        assert [str(seed), *(f"{number:.3f}" for number in numbers)] in map(
            str.split, said.splitlines()
        )
        gains.append(truth.evaders[-1] - met)
    assert f"{sum(gains) / 2:.3f}" in said.split("mean", 1)[1]
    assert f"is {truth.value:.3f}." in said
    assert sorted(tmp_path.rglob("*")) == before


def test_exploit_exact_refuses_networks_that_do_not_see_the_board(tmp_path):
    world = {"rows": 3, "cols": 3, "n_pursuers": 1, "n_evaders": 1, "max_steps": 2, "fov": 3}
    evolve([settings_of(**world, schedule="against", epochs=1, population=2)], tmp_path / "job")
    said = matrixworld_command("exploit", "job", "--champion", "pursuer", "--exact", code=2).stderr
    assert "expected a network that sees the whole world from every cell" in said
