"""The data of a page are those of the run, exactly."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from matrixworld import analysis
from matrixworld.coevolution import TEAMS, SavedRun, open_run, start
from matrixworld.coevolution.seeding import evaluation_seed
from matrixworld.explorer.run_data import archives_of, kept_generations, run_data, training_curve
from matrixworld.world.config import WorldConfig
from tiny_race import tiny_race, tiny_single

SCHEDULES = ("generalist-generalist", "hall-of-fame")


def played(settings: Any, directory: Path) -> SavedRun:
    start(settings, directory, threads=1).run()
    return open_run(directory)


@pytest.fixture(scope="module", params=SCHEDULES)
def race(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> SavedRun:
    settings = tiny_race(schedule=request.param, obstacles=0.1)
    return played(settings, tmp_path_factory.mktemp("race") / "run")


@pytest.fixture(scope="module", params=TEAMS)
def single(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> SavedRun:
    return played(tiny_single(team=request.param), tmp_path_factory.mktemp("single") / "run")


def as_read(data: dict[str, Any]) -> dict[str, Any]:
    """Return data as the page reads them."""
    plain: dict[str, Any] = json.loads(json.dumps(data, allow_nan=False))
    return plain


def test_results_of_a_race(race: SavedRun) -> None:
    data, payoff = as_read(run_data("race", race)), race.payoff()
    assert data["payoff"]["first"] == [0, 0]
    assert data["payoff"]["capture_rate"] == payoff.capture_rate.tolist()
    rates = np.array(data["payoff"]["capture_rates"], np.float32)
    np.testing.assert_array_equal(rates, payoff.capture_rates)
    np.testing.assert_array_equal(data["payoff"]["lengths"], payoff.lengths)


def test_seeds_are_those_of_the_evaluation(race: SavedRun) -> None:
    seeds = as_read(run_data("race", race))["seeds"]
    assert [[int(seed) for seed in row] for row in seeds] == [
        [evaluation_seed(race.settings.seed, g, h) for h in range(3)] for g in range(3)
    ]


def test_the_world_is_that_of_the_evaluation(race: SavedRun) -> None:
    plain = as_read(run_data("race", race))["world"]
    config = race.settings.world
    assert WorldConfig.from_json(plain).to_json() == config.to_json()


def test_verdicts_are_those_of_the_commands(race: SavedRun) -> None:
    found = as_read(run_data("race", race))["findings"]
    judgement = analysis.judge(race.payoff().capture_rates, per_episode=True)
    assert found["headline"] == analysis.headline(judgement)
    assert [tuple(row) for row in found["table"]] == analysis.judgement_table(judgement)
    assert found["reasons"] == analysis.explain(judgement).splitlines()


def test_genomes_are_exact(race: SavedRun) -> None:
    archives = archives_of([race, race])
    for team in TEAMS:
        for number, teams in enumerate(archives.teams):
            assert teams[team]["genomes"] == f"genomes-{number}-{team}"
            population = race.teams[team]
            assert not isinstance(population, str)
            raw = np.frombuffer(archives.blobs[f"genomes-{number}-{team}"], "<f4")
            np.testing.assert_array_equal(raw.reshape(population.genomes.shape), population.genomes)
            assert teams[team]["kept"] == [0, 1, 2]


def test_a_limit_of_size_keeps_some_generations_of_all_runs(race: SavedRun) -> None:
    population = race.teams["pursuer"]
    assert not isinstance(population, str)
    # Room for two of the three generations of both teams.
    archives = archives_of([race], most=4 * population.genomes[0].nbytes)
    assert archives.step == 2
    assert [archives.teams[0][team]["kept"] for team in TEAMS] == [[0, 2], [0, 2]]


@pytest.mark.parametrize(
    ("count", "step", "kept"), [(1, 1, [0]), (5, 1, [0, 1, 2, 3, 4]), (6, 2, [0, 2, 4, 5])]
)
def test_first_and_last_generation_are_always_kept(count: int, step: int, kept: list[int]) -> None:
    assert kept_generations(count, step) == kept


def test_a_single_team_has_one_cell_at_its_last_generation(single: SavedRun) -> None:
    data, payoff = as_read(run_data("single", single)), single.payoff()
    learns_first = data["learning"] == ["pursuer"]
    assert data["payoff"]["shape"] == ([4, 1] if learns_first else [1, 4])
    assert data["payoff"]["first"] == ([3, 0] if learns_first else [0, 3])
    assert data["payoff"]["capture_rate"] == payoff.capture_rate.tolist()
    assert data["findings"] is None
    assert not data["race"]


def test_the_script_of_a_single_team_is_named(single: SavedRun) -> None:
    [teams] = archives_of([single]).teams
    scripts = [teams[team]["script"] for team in TEAMS]
    assert sorted(scripts, key=str) == [None, "random"]


def test_a_long_training_curve_has_means_of_neighbouring_epochs(
    monkeypatch: pytest.MonkeyPatch, single: SavedRun
) -> None:
    log = single.files.log()
    whole = training_curve(log, single.settings)
    assert whole["epochs"] == 1
    np.testing.assert_allclose(whole["capture_rate"], log["capture_rate"], atol=1e-4)
    monkeypatch.setattr("matrixworld.explorer.run_data.MOST_POINTS", 2)
    short = training_curve(log, single.settings)
    means = [log["capture_rate"][:3].mean(), log["capture_rate"][3:].mean()]
    assert short["epochs"] == 3
    np.testing.assert_allclose(short["capture_rate"], means, atol=1e-4)


def test_changed_settings_are_marked(race: SavedRun) -> None:
    settings = {each["name"]: each for each in run_data("race", race)["settings"]}
    assert settings["rows"]["changed"]
    assert settings["rows"]["value"] == "6"
    assert not settings["learner"]["changed"]
    assert not settings["seed"]["changed"]
