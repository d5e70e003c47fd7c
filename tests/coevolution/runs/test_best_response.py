"""Best responses to champions."""

from __future__ import annotations

import json
import re
import shutil
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from command_line import matrixworld_command
from matrixworld.cli import exploit
from matrixworld.coevolution import (
    Against,
    EvolutionStrategySettings,
    best_response,
    open_run,
    resume,
    start,
)
from matrixworld.coevolution.jobs.best_responses import settings_of_responses
from matrixworld.coevolution.jobs.job import job_of, save_job
from matrixworld.coevolution.runs.best_response import response_settings
from matrixworld.coevolution.seeding import evaluation_seed
from matrixworld.coevolution.types import other
from matrixworld.play.rollout import Matches, rollout
from matrixworld.world.policy import Population
from tiny_race import StopAt, results, tiny_race, tiny_single

BUDGET = 450  # matches: 9 epochs of 48
EPISODES = 12


@pytest.fixture(scope="module")
def race(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("races") / "race"
    start(tiny_race(), path, threads=1).run()
    return path


def last(run: Any, team: str) -> Population:
    return Population(run.teams[team].genomes[-1], run.teams[team].network)


@pytest.mark.parametrize("champion", ["pursuer", "evader"])
def test_what_is_played(race, tmp_path, champion):
    run, learner = open_run(race), other(champion)
    result = best_response(run, champion, BUDGET, tmp_path / "x", evaluation_episodes=EPISODES)
    response = open_run(tmp_path / "x")
    assert response.settings.schedule.team == learner
    assert np.array_equal(response.teams[champion].genomes, last(run, champion).genomes)
    assert result.gain.budget == 9 * 48 == response.files.summary()["training_matches"]
    log = response.files.log()
    assert set(log["team"]) == {learner}
    assert log["matches"][-1] == result.gain.budget

    def rates(pursuers: Population, evaders: Population, seed: int) -> np.ndarray:
        config, match = run.settings.world, Matches.of(0, 0, np.uint64(seed))
        scores = rollout(config, pursuers, evaders, match, episodes=EPISODES)
        captured = scores.capture_rate[0].astype(float)
        return captured if learner == "pursuer" else 1 - captured

    before = {team: last(run, team) for team in ("pursuer", "evader")}
    after = {**before, learner: last(response, learner)}
    stage = (1, 0) if learner == "pursuer" else (0, 1)
    assert np.array_equal(result.before, rates(*before.values(), evaluation_seed(5, 0, 0)))
    assert np.array_equal(result.after, rates(*after.values(), evaluation_seed(5, *stage)))
    gain = result.gain.gain
    assert gain.value == pytest.approx(result.after.mean() - result.before.mean())
    assert gain.low <= gain.value <= gain.high
    told = json.loads((tmp_path / "x" / "best_response.json").read_text())
    assert told["budget_matches"] == result.gain.budget
    assert told["evaluation_matches"] == 2 * EPISODES


@pytest.mark.parametrize("call", [0, 4, 9])
def test_an_interrupted_response_continues(race, tmp_path, call):
    run = open_run(race)
    arguments: dict[str, Any] = {
        "evaluation_episodes": EPISODES,
        "schedule": Against(archive_every=2),
    }
    straight = best_response(run, "pursuer", BUDGET, tmp_path / "straight", **arguments)
    with pytest.raises(KeyboardInterrupt):
        best_response(run, "pursuer", BUDGET, tmp_path / "x", play=StopAt(call), **arguments)
    resumed = best_response(run, "pursuer", BUDGET, tmp_path / "x", **arguments)
    assert results(tmp_path / "x") == results(tmp_path / "straight")
    assert resumed.gain == straight.gain
    again = best_response(run, "pursuer", BUDGET, tmp_path / "x", **arguments)
    assert again.gain == straight.gain


def test_a_weak_champion_is_exploited(tmp_path):
    """An untrained team hardly moves: its response learns to capture far more."""
    settings = tiny_race(
        fov=5, hidden=(), train_steps=20, max_steps=20, generations=1, pursuer_epochs=1,
        evader_epochs=1, population=2, sigma=1e-6, learning_rate=1e-6, initial_head=0.01,
    )  # fmt: skip
    start(settings, tmp_path / "race").run()
    result = best_response(
        open_run(tmp_path / "race"), "evader", 9600, tmp_path / "x", evaluation_episodes=300,
        learner=EvolutionStrategySettings(population=48, learning_rate=0.05, sigma=0.2),
    )  # fmt: skip
    assert result.gain.gain.low > 0.05
    assert f"evolved for {9600:,} matches gains" in str(result.gain)


def test_settings_are_the_run_s_world_and_the_budget(race):
    run = open_run(race)
    settings = response_settings(run, "evader", 1000)
    schedule = settings.schedule
    assert (schedule.team, schedule.epochs, settings.learner.population) == ("pursuer", 20, 48)
    assert settings.world == run.settings.world
    assert settings.network == run.settings.network
    assert (settings.train_steps, settings.seed) == (12, 5)
    changed = response_settings(
        run, "evader", 1000, match_episodes=3, train_steps=4,
        learner=EvolutionStrategySettings(population=10),
    )  # fmt: skip
    assert (changed.schedule.epochs, changed.train_steps) == (33, 4)
    with pytest.raises(ValueError, match=r"matches: expected at least 48 \(one epoch\), got 47"):
        response_settings(run, "evader", 47)


def test_a_scripted_champion_is_refused(tmp_path):
    start(tiny_single(opponent="fleer"), tmp_path / "run").run()
    run = open_run(tmp_path / "run")
    with pytest.raises(ValueError, match=r"team: expected one that learned in .*run, got 'evader'"):
        best_response(run, "evader", BUDGET, tmp_path / "x")
    assert not (tmp_path / "x").exists()
    result = best_response(run, "pursuer", BUDGET, tmp_path / "x", evaluation_episodes=2)
    assert result.gain.budget == 432


def test_another_response_in_the_directory_is_refused(race, tmp_path):
    run = open_run(race)
    best_response(run, "pursuer", 48, tmp_path / "x", evaluation_episodes=2)
    with pytest.raises(ValueError, match="holds a run with other settings: evaluation_episodes$"):
        best_response(run, "pursuer", 48, tmp_path / "x", evaluation_episodes=3)
    with pytest.raises(ValueError, match="holds a run with other settings: schedule.epochs$"):
        best_response(run, "pursuer", 96, tmp_path / "x", evaluation_episodes=2)
    with pytest.raises(ValueError, match="holds a run with other settings: .*schedule.team"):
        best_response(run, "evader", 48, tmp_path / "x", evaluation_episodes=2)
    start(tiny_race(generations=1), tmp_path / "other").run()
    with pytest.raises(ValueError, match="holds a run against another champion"):
        best_response(
            open_run(tmp_path / "other"), "pursuer", 48, tmp_path / "x", evaluation_episodes=2
        )


# ---- The command -----------------------------------------------------------------------------


def test_the_command(race, tmp_path):
    run = Path(shutil.copytree(race, tmp_path / "race"))
    command = ["exploit", run, "--champion", "pursuer", "--matches", 100, "--episodes", 20]
    told = matrixworld_command(*command).stdout
    job = tmp_path / "race-response-to-pursuers-100x20-seed0"
    made = job / "seed-5"
    result = best_response(open_run(run), "pursuer", 100, made, evaluation_episodes=20, seed=0)
    before, after = f"{result.before.mean():.3f}", f"{result.after.mean():.3f}"
    assert re.search(rf"5 +{before} +{after}  {re.escape(str(result.gain.gain))}\n", told)
    assert "96 matches of evolution and 40 of evaluation" in told
    assert f"matrixworld replay {made}" in told
    before = {path: path.read_bytes() for path in made.iterdir()}
    refused = matrixworld_command(*command, code=2).stderr
    assert f"{job}: exists; --continue goes on with the response in it" in refused
    assert {path: path.read_bytes() for path in made.iterdir()} == before
    assert matrixworld_command(*command, "--continue").stdout == told
    matrixworld_command("replay", made)


def test_the_command_goes_on_after_ctrl_c(race, tmp_path, monkeypatch):
    run = Path(shutil.copytree(race, tmp_path / "race"))
    command = ["exploit", run, "--champion", "evader", "--matches", 200, "--out", tmp_path / "x"]

    def interrupted(*args: Any, **options: Any) -> Any:
        chosen = {"matches": 200, "evaluation_episodes": 100, "seed": 0}
        settings = settings_of_responses({"seed-5": open_run(run)}, "evader", **chosen)
        (tmp_path / "x").mkdir()
        save_job(tmp_path / "x", job_of(settings))
        start(settings["seed-5"], tmp_path / "x" / "seed-5", play=StopAt(2)).run()

    monkeypatch.setattr(exploit, "best_responses", interrupted)
    stopped = matrixworld_command(*command, code=130)
    assert f"--continue goes on with the runs in {tmp_path / 'x'}." in stopped.stderr
    monkeypatch.undo()
    assert "192 matches of evolution" in matrixworld_command(*command, "--continue").stdout


def test_words_for_a_gain_and_for_none(race, tmp_path):
    result = best_response(
        open_run(race), "pursuer", BUDGET, tmp_path / "x", evaluation_episodes=EPISODES
    )
    low = result.gain.gain.low
    words = exploit._in_words(result)
    assert words.startswith("A best response evolved for 432 matches gains ")
    assert ("exploitability is at least" in words) == (low > 0)
    assert ("no weakness was found" in words) == (low <= 0)


@pytest.mark.parametrize(
    ("options", "code", "message"),
    [
        ([], 2, "Missing option '--champion'"),
        (["--champion", "pursuer", "--matches", "47"], 2, "expected at least 48 (one epoch)"),
        (
            ["--champion", "pursuer", "--out", "{race}", "--continue"],
            1,
            "expected a new or empty directory for a new run",
        ),
        (
            ["--champion", "pursuer", "--out", "new", "--continue"],
            2,
            "--continue: expected a response in new, which holds no run",
        ),
    ],
)
def test_the_command_refuses(race, options, code, message):
    args = [option.format(race=race) for option in options]
    assert message in matrixworld_command("exploit", race, *args, code=code).stderr


def test_it_is_a_run_like_any_other(race, tmp_path):
    best_response(open_run(race), "evader", 48, tmp_path / "x", evaluation_episodes=2)
    assert resume(tmp_path / "x").files.finished
