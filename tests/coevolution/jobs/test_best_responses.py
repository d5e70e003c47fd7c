"""Best responses to the champions of many runs."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from command_line import matrixworld_command
from matrixworld.analysis import interval_over_runs
from matrixworld.coevolution import (
    best_response,
    best_responses,
    evolve,
    open_run,
    start,
)
from tiny_race import results, tiny_race, tiny_single

CHOSEN = {"evaluation_episodes": 12, "seed": 0}
BUDGET = 100  # matches: 2 epochs of 48
COMMAND = ("--champion", "pursuer", "--matches", BUDGET, "--episodes", 12)
SCHEDULE = "generalist-generalist"


@pytest.fixture(scope="module")
def job(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("jobs") / "job"
    evolve([tiny_race(schedule=SCHEDULE, seed=seed) for seed in (0, 1, 2)], path, threads=2)
    return path


def test_each_response_is_the_one_of_its_run_alone(job: Path, tmp_path: Path) -> None:
    runs = {f"x/seed-{n}": open_run(job / SCHEDULE / f"seed-{n}") for n in (0, 1, 2)}
    found = best_responses(runs, "evader", BUDGET, tmp_path / "many", threads=2, **CHOSEN)
    assert list(found) == list(runs)
    for name, run in runs.items():
        alone = best_response(run, "evader", BUDGET, tmp_path / name, threads=1, **CHOSEN)
        assert found[name].gain == alone.gain
        here, there = results(tmp_path / "many" / name), results(tmp_path / name)
        # The configurations differ in the name of the opponents, and checksums with them.
        for file in ("pursuers.npy", "evaders.npy"):
            assert here[file] == there[file]
        assert np.array_equal(found[name].after, alone.after)
    again = best_responses(runs, "evader", BUDGET, tmp_path / "many", threads=1, **CHOSEN)
    assert {name: each.gain for name, each in again.items()} == {
        name: each.gain for name, each in found.items()
    }


def test_a_champion_that_did_not_learn_is_refused_before_anything_is_written(
    job: Path, tmp_path: Path
) -> None:
    start(tiny_single(opponent="fleer"), tmp_path / "single").run()
    runs = {"a": open_run(job / SCHEDULE / "seed-0"), "b": open_run(tmp_path / "single")}
    with pytest.raises(ValueError, match=r"team: expected one that learned in .*, got 'evader'"):
        best_responses(runs, "evader", BUDGET, tmp_path / "out")
    assert not (tmp_path / "out").exists()


def test_the_command_on_a_job_of_seeds(job: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    told = matrixworld_command("exploit", job, *COMMAND, "--out", out).stdout
    gains = []
    for seed in (0, 1, 2):
        run = open_run(job / SCHEDULE / f"seed-{seed}")
        response = best_response(run, "pursuer", BUDGET, out / SCHEDULE / f"seed-{seed}", **CHOSEN)
        gains.append(response.gain.gain.value)
        line = rf"^ +{seed}  +{response.before.mean():.3f} +{response.after.mean():.3f}  "
        assert re.search(line + re.escape(str(response.gain.gain)), told, re.MULTILINE)
    mean = interval_over_runs(gains, bounds=(-1.0, 1.0))
    assert f"{mean.value:.3f} ({mean.low:.3f} to {mean.high:.3f})" in told
    assert "288 matches of evolution" in told
    again = matrixworld_command("exploit", job, *COMMAND, "--out", out, code=2)
    assert "exists; --continue goes on" in again.stderr
    assert matrixworld_command("exploit", job, *COMMAND, "--out", out, "--continue").stdout == told


def test_the_responses_to_a_job_lie_beside_it(tmp_path: Path) -> None:
    settings = [tiny_race(schedule=SCHEDULE, seed=seed) for seed in (0, 1)]
    evolve(settings, tmp_path / "job", threads=2)
    matrixworld_command("exploit", tmp_path / "job", *COMMAND)
    beside = tmp_path / f"job-response-to-pursuers-{BUDGET}x12-seed0"
    assert (beside / SCHEDULE / "seed-1" / "best_response.json").exists()


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (("--matches", 47), "expected at least 48 (one epoch), got 47"),
        (("--continue",), "--continue: expected a response in"),
    ],
)
def test_the_command_refuses_before_it_writes(
    job: Path, tmp_path: Path, options: tuple[object, ...], message: str
) -> None:
    out = tmp_path / "out"
    told = matrixworld_command("exploit", job, *COMMAND, "--out", out, *options, code=2)
    assert message in told.stderr
    assert not out.exists()
