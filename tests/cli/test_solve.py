"""``matrixworld solve`` and ``exploit --exact``: the numbers that they print and write."""

import json

import pytest

import matrixworld as mw
from command_line import matrixworld_command
from matrixworld.coevolution import TEAMS, evolve, held_out_maps, score_on_maps
from matrixworld.solve import States, expected_payoff, guarantees
from tiny_race import settings_of

SMALL = ("--rows", 4, "--cols", 4, "--n-evaders", 1)


@pytest.mark.parametrize(
    ("game", "value", "time"),
    [(("O", 2), 0.838, "none"), (("to", 2), None, 3), (("to", 1), None, None)],
)
def test_the_numbers_of_a_small_world(game, value, time):
    variant, pursuers = game
    words = ("--variant", variant, "--n-pursuers", pursuers, "--steps", 5)
    result = matrixworld_command("solve", *SMALL, *words, "--json", "-")
    found, said = json.loads(result.stdout), result.stderr
    assert found["value"] == found["value_by_step"][-1]
    assert found["gap"] < 1e-9
    assert value is None or found["value"] == pytest.approx(value, abs=0.005)
    assert "the mean capture rate over all starts" in said
    # Only where teams take turns there is a time; None is infinite.
    assert found.get("capture_time", "none") == time
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
        gains.append(truth.evaders[-1] - met)
        numbers = (met, truth.evaders[-1], gains[-1], truth.exploitability["evader"][-1])
        row = [str(seed), *(f"{number:.3f}" for number in numbers)]
        assert row in [line.split() for line in said.splitlines()]
    assert f"{sum(gains) / 2:.3f}" in said.split("mean", 1)[1]
    assert f"is {truth.value:.3f}." in said
    assert sorted(tmp_path.rglob("*")) == before


def test_score_on_held_out_maps_prints_and_writes_what_the_function_returns(tmp_path):
    quick = {"generations": 1, "pursuer_epochs": 1, "evader_epochs": 1, "population": 2}
    small = {"rules": "TO", "rows": 4, "cols": 4, "n_pursuers": 2, "n_evaders": 1, "max_steps": 4}
    settings = [settings_of(**small, **quick, fov=7, seed=seed) for seed in (0, 1)]
    runs = evolve(settings, tmp_path / "job")
    words = ("--maps", 3, "--regret", "--episodes", 5, "--seed", 2)
    result = matrixworld_command("score", "job", *words, "--json", "-")
    (group,) = json.loads(result.stdout)["groups"].values()
    maps = held_out_maps(4, 4, 3)
    for number, run in enumerate(runs):
        teams = {team: run.last(team) for team in TEAMS}
        world = run.settings.world
        expected = score_on_maps(teams, world, maps, exact=True, episodes=5, seed=2)
        assert group["capture rate"][number] == expected.capture_rate.tolist()
        for team in TEAMS:
            assert group[f"regret of the {team}s"][number] == expected.regret[team].tolist()
        assert f"{expected.regret['pursuer'].mean():.3f}" in result.stderr
    for wrong, says in (
        (("--regret",), "--regret: expected --maps beside it"),
        (("--maps", 2, "--generation", 1), "--maps: expected no --generation"),
    ):
        assert says in matrixworld_command("score", "job", *wrong, code=2).output
