"""Best responses to the champions of runs, and the command that evolves them."""

import json
import shutil
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from matrixworld.coevolution.responses import BestResponse, response_settings

from command_line import matrixworld_command
from matrixworld.analysis import interval_over_runs
from matrixworld.cli import exploit
from matrixworld.coevolution import (
    SavedRun,
    best_responses,
    evolve,
    finish,
    open_run,
)
from matrixworld.coevolution.learners.evolution_strategy import EvolutionStrategySettings
from matrixworld.coevolution.seeding import evaluation_seed
from matrixworld.coevolution.types import other
from matrixworld.play.rollout import Matches, rollout
from matrixworld.world.policy import Population
from tiny_race import tiny_race, tiny_single

pytestmark = pytest.mark.usefixtures("no_processes")
BUDGET = 100  # matches: 2 epochs of 48
EPISODES = 12
CHOSEN = {"evaluation_episodes": EPISODES, "seed": 0}
COMMAND = ("--champion", "pursuer", "--matches", BUDGET, "--episodes", EPISODES)
SCHEDULE = "generalist-generalist"


@pytest.fixture(scope="module")
def job(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("jobs") / "job"
    evolve([tiny_race(schedule=SCHEDULE, seed=seed) for seed in (0, 1, 2)], path, threads=1)
    return path


def respond(run: SavedRun, *args: Any, **changes: Any) -> BestResponse:
    [response] = best_responses({"x": run}, *args, **changes).values()
    return response


def last(run: Any, team: str) -> Population:
    return Population(run.teams[team].genomes[-1], run.teams[team].network)


@pytest.mark.parametrize("champion", ["pursuer", "evader"])
def test_what_is_played(race, tmp_path, champion):
    run, learner = open_run(race), other(champion)
    result = respond(run, champion, 150, tmp_path, evaluation_episodes=EPISODES)
    response = open_run(tmp_path / "x")
    assert response.settings.schedule.team == learner
    assert np.array_equal(response.teams[champion].genomes, last(run, champion).genomes)
    assert result.budget == 3 * 48 == response.summary()["training_matches"]
    assert set(response.log()["team"]) == {learner}

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
    gain = result.gain
    assert gain.value == pytest.approx(result.after.mean() - result.before.mean())
    assert gain.low <= gain.value <= gain.high
    told = json.loads((tmp_path / "x" / "best_response.json").read_text())
    assert told["budget_matches"] == result.budget
    assert told["evaluation_matches"] == 2 * EPISODES
    words = exploit._in_words(result)
    assert words.startswith("A best response evolved for 144 matches gains ")


def test_a_weak_champion_is_exploited(tmp_path):
    """An untrained team hardly moves: its response learns to capture far more."""
    settings = tiny_race(
        fov=5, hidden=(), train_steps=20, max_steps=20, generations=1, pursuer_epochs=1,
        evader_epochs=1, population=2, sigma=1e-6, learning_rate=1e-6, initial_head=0.01,
    )  # fmt: skip
    result = respond(
        finish(settings, tmp_path / "race"), "evader", 9600, tmp_path / "responses",
        evaluation_episodes=300,
        learner=EvolutionStrategySettings(population=48, learning_rate=0.05, sigma=0.2),
    )  # fmt: skip
    assert result.gain.low > 0.05  # surely, not by luck of the episodes
    assert f"evolved for {9600:,} matches gains" in str(result)
    assert "exploitability is at least" in exploit._in_words(result)


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


def test_a_scripted_champion_is_refused(race, tmp_path):
    run = finish(tiny_single(opponent="fleer"), tmp_path / "run")
    runs = {"a": open_run(race), "b": run}
    with pytest.raises(ValueError, match=r"team: expected one that learned in .*run, got 'evader'"):
        best_responses(runs, "evader", BUDGET, tmp_path / "x")
    assert not (tmp_path / "x").exists()
    result = respond(run, "pursuer", BUDGET, tmp_path / "x", evaluation_episodes=2)
    assert result.budget == 96


# The command:


def test_the_command(job: Path, tmp_path: Path) -> None:
    copy = Path(shutil.copytree(job, tmp_path / "job"))
    command = ["exploit", copy, *COMMAND]
    told = matrixworld_command(*command).stdout
    beside = tmp_path / f"job-response-to-pursuers-{BUDGET}x{EPISODES}-seed0"
    runs = {f"{SCHEDULE}/seed-{n}": open_run(copy / SCHEDULE / f"seed-{n}") for n in range(3)}
    # What the command has finished is only read.
    found = best_responses(runs, "pursuer", BUDGET, beside, **CHOSEN)
    for response in found.values():
        assert str(response.gain) in told
    gains = [response.gain.value for response in found.values()]
    mean = interval_over_runs(gains, bounds=(-1.0, 1.0))
    assert f"{mean.value:.3f} ({mean.low:.3f} to {mean.high:.3f})" in told
    assert matrixworld_command(*command).stdout == told
    assert (
        "expected the runs in its job.json, got others"
        in matrixworld_command(*command, "--seed", 3, "--out", beside, code=2).stderr
    )
