"""The option --cluster of the commands."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import pytest

from command_line import RACE, matrixworld_command, run_together, words
from dask_cluster import DaskCluster, dask_cluster, group_lives, kill_group, wait_until
from matrixworld.cli import options
from matrixworld.coevolution import RaceSettings, evolve, finish, open_run
from tiny_race import results, tiny_race

pytest.importorskip("distributed")

SCHEDULE = {"schedule": "generalist-generalist"}


@pytest.fixture(scope="module")
def dask(tmp_path_factory: pytest.TempPathFactory) -> Iterator[DaskCluster]:
    with dask_cluster(tmp_path_factory.mktemp("dask"), workers=2) as running:
        yield running


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("runs") / "run"
    finish(tiny_race(), path, threads=1)
    return path


@pytest.mark.parametrize(
    ("arguments", "problem"),
    [
        (
            ("--cluster", "nowhere"),
            "expected auto, an address such as tcp://HOST:8786 or",
        ),
        (("--cluster", "auto"), "--cluster: expected several runs, such as --seeds 0-9, got one"),
        (("--cluster", "auto", "--seeds", "0-1", "--threads", "2"), "--threads: expected "),
    ],
)
def test_bad_use_is_refused(tmp_path: Path, arguments: tuple[str, ...], problem: str) -> None:
    settings = words({**RACE, **SCHEDULE})
    settings = settings[: settings.index("--seed")] + settings[settings.index("--seed") + 2 :]
    done = matrixworld_command("evolve", tmp_path / "out", *settings, *arguments, code=2)
    assert problem in run_together(done.output)
    assert not (tmp_path / "out").exists()


def test_without_dask_the_extra_is_named(
    run: Path, dask: DaskCluster, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "distributed", None)
    done = matrixworld_command("tournament", run, "--cluster", dask.file, code=1)
    assert "pip install 'matrixworld-pursuit[cluster]'" in done.output


def test_a_tournament_is_the_same(run: Path, dask: DaskCluster, tmp_path: Path) -> None:
    files = [tmp_path / "alone.npz", tmp_path / "shared.npz"]
    for file, where in zip(files, ((), ("--cluster", dask.file)), strict=True):
        matrixworld_command("tournament", run, "--episodes", 4, "--out", file, *where)
    with np.load(files[0]) as alone, np.load(files[1]) as shared:
        assert alone.files == shared.files
        for name in alone.files:
            np.testing.assert_array_equal(alone[name], shared[name], strict=True)


def test_scores_are_the_same(run: Path, dask: DaskCluster, tmp_path: Path) -> None:
    files = [tmp_path / "alone.json", tmp_path / "shared.json"]
    for file, where in zip(files, ((), ("--cluster", dask.address)), strict=True):
        options = ("--episodes", 5, "--generation", "all", "--json", file)
        matrixworld_command("score", run, *options, *where)
    assert json.loads(files[0].read_text()) == json.loads(files[1].read_text())


def test_responses_are_the_same(dask: DaskCluster, tmp_path: Path) -> None:
    job = tmp_path / "job"
    evolve([tiny_race(**SCHEDULE, seed=seed) for seed in (0, 1)], job, threads=1)
    command = ("exploit", job, "--champion", "evader", "--matches", 100, "--episodes", 5)
    outs = [tmp_path / "alone", tmp_path / "shared"]
    for out, where in zip(outs, ((), ("--cluster", dask.address)), strict=True):
        matrixworld_command(*command, "--out", out, *where)
    for seed in (0, 1):
        alone, shared = (results(out / SCHEDULE["schedule"] / f"seed-{seed}") for out in outs)
        assert alone == shared


def test_one_response_takes_no_cluster(run: Path, tmp_path: Path) -> None:
    command = ("exploit", run, "--champion", "evader", "--out", tmp_path / "out")
    done = matrixworld_command(*command, "--cluster", "auto", code=2)
    assert "--cluster: expected several runs, got one" in run_together(done.output)
    assert not (tmp_path / "out").exists()


@pytest.mark.slow
def test_a_cluster_of_this_machine_stops_at_ctrl_c_and_continues(tmp_path: Path) -> None:
    out = tmp_path / "out"
    # Several seconds: it is stopped in its middle.
    long = {"generations": 20, "pursuer_epochs": 250, "evader_epochs": 250}
    settings = {**RACE, **SCHEDULE, **long}
    del settings["seed"]
    command = [sys.executable, "-m", "matrixworld", "evolve"]
    begin = [*command, str(out), "--seeds", "0-1", "--cluster", "auto", *words(settings)]
    process = subprocess.Popen(
        begin,
        stderr=subprocess.PIPE,
        start_new_session=True,
        # A shell lets programs in the background ignore Ctrl-C.
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
        env={**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, sys.path))},
    )
    try:
        wait_until(lambda: len(list(out.glob("*/*/stage-0001.npz"))) >= 1, "a race")
        os.killpg(process.pid, signal.SIGINT)  # as a terminal does it: to all processes
        _, told = process.communicate(timeout=60)
        wait_until(lambda: not group_lives(process.pid), "end of all processes")
    finally:
        kill_group(process.pid)
    assert process.returncode == 130, told.decode()
    assert f"matrixworld evolve --resume {out}" in told.decode()
    assert "Traceback" not in told.decode()
    matrixworld_command("evolve", "--resume", out)
    for seed in (0, 1):
        path = out / "generalist-generalist" / f"seed-{seed}"
        settings_of = open_run(path).settings
        assert isinstance(settings_of, RaceSettings)
        finish(settings_of, tmp_path / f"{seed}", threads=1)
        assert results(path) == results(tmp_path / f"{seed}")


@pytest.mark.parametrize(
    ("learner", "alike"), [("cma", True), ("actor-critic", True), ("es", False)]
)
def test_some_learners_want_same_processors(
    monkeypatch: pytest.MonkeyPatch, learner: str, alike: bool
) -> None:
    asked: list[bool] = []

    @contextmanager
    def recorded(where: str, *, same_processors: bool, **options: object) -> Iterator[None]:
        asked.append(same_processors)
        yield

    monkeypatch.setattr(options, "cluster", recorded)
    with options.on_cluster("auto", None, settings=[tiny_race(), tiny_race(learner=learner)]):
        assert asked == [alike]
