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
from matrixworld.explorer.runs_page import archives_of, kept_generations, run_data, training_curve
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


def as_read(run: SavedRun) -> dict[str, Any]:
    """Return the data of a run as the page reads them."""
    plain: dict[str, Any] = json.loads(json.dumps(run_data("a run", run), allow_nan=False))
    return plain


def test_results_seeds_and_world_are_those_of_the_evaluation(race: SavedRun) -> None:
    data, payoff, settings = as_read(race), race.payoff(), race.settings
    assert data["payoff"]["first"] == [0, 0]
    assert data["payoff"]["capture_rate"] == payoff.capture_rate.tolist()
    rates = np.array(data["payoff"]["capture_rates"], np.float32)
    np.testing.assert_array_equal(rates, payoff.capture_rates)
    np.testing.assert_array_equal(data["payoff"]["lengths"], payoff.lengths)
    assert [[int(seed) for seed in row] for row in data["seeds"]] == [
        [evaluation_seed(settings.seed, g, h) for h in range(3)] for g in range(3)
    ]
    assert WorldConfig.from_json(data["world"]).to_json() == settings.world.to_json()
    shown = {each["name"]: each for each in data["settings"]}
    assert shown["world.rows"]["value"] == "6"
    changed = [shown[name]["changed"] for name in ("world.rows", "learner", "seed")]
    assert changed == [True, False, False]


def test_verdicts_are_those_of_the_commands(race: SavedRun) -> None:
    found = as_read(race)["findings"]
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
            raw = np.frombuffer(archives.blobs[f"genomes-{number}-{team}"], "<f4")
            np.testing.assert_array_equal(raw.reshape(population.genomes.shape), population.genomes)
            assert teams[team]["kept"] == [0, 1, 2]


def test_a_limit_of_size_keeps_some_generations_of_all_runs(race: SavedRun) -> None:
    population = race.teams["pursuer"]
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
    data, payoff = as_read(single), single.payoff()
    learns_first = data["learning"] == ["pursuer"]
    assert data["payoff"]["shape"] == ([4, 1] if learns_first else [1, 4])
    assert data["payoff"]["first"] == ([3, 0] if learns_first else [0, 3])
    assert data["payoff"]["capture_rate"] == payoff.capture_rate.tolist()
    assert data["findings"] is None
    assert not data["race"]
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
    monkeypatch.setattr("matrixworld.explorer.runs_page.MOST_POINTS", 2)
    short = training_curve(log, single.settings)
    means = [log["capture_rate"][:3].mean(), log["capture_rate"][3:].mean()]
    assert short["epochs"] == 3
    np.testing.assert_allclose(short["capture_rate"], means, atol=1e-4)
