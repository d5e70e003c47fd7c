"""The option --cluster, on a real Dask cluster of two processes."""

import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from command_line import RACE, evolved, matrixworld_command, run_together, words
from matrixworld.cli import cluster
from matrixworld.coevolution import evolve, finish, open_run
from scripts import group_lives, kill_group, wait_until
from tiny_race import results, tiny_race

distributed = pytest.importorskip("distributed")

SCHEDULE = ("--schedule", "generalist-generalist")
AUTO = ("--cluster", "auto")
OPTIONS = (*SCHEDULE, *words({name: value for name, value in RACE.items() if name != "seed"}))


@pytest.fixture(scope="module")
def dask() -> Iterator[Any]:
    """A cluster; on exit no process is left."""
    local = {"dashboard_address": "127.0.0.1:0", "silence_logs": "CRITICAL", "memory_limit": 0}
    with distributed.LocalCluster(2, threads_per_worker=1, **local) as running:
        yield running


@pytest.mark.parametrize(
    ("arguments", "problem"),
    [
        (("evolve", "--cluster", "nowhere"), "expected auto, an address such as tcp://HOST:8786"),
        (("evolve", *SCHEDULE, *AUTO), "--cluster: expected several runs, such as --seeds 0-9"),
        (("evolve", *AUTO, "--seeds", "0-1", "--threads", "2"), "--threads: expected "),
        (("exploit", "{race}", "--champion", "evader", *AUTO), "--cluster: expected several runs"),
    ],
)
def test_bad_use_is_refused(
    race: Path, tmp_path: Path, arguments: tuple[str, ...], problem: str
) -> None:
    out = tmp_path / "out"
    command = [each.format(race=race) for each in arguments]
    assert problem in run_together(matrixworld_command(*command, "--out", out, code=2).output)
    assert not out.exists()


@pytest.mark.parametrize("content", ["{}", '{"address": 3}', "no json"])
def test_a_file_of_no_scheduler_is_refused(race: Path, tmp_path: Path, content: str) -> None:
    scheduler = tmp_path / "scheduler.json"
    scheduler.write_text(content)
    done = matrixworld_command("tournament", race, "--cluster", scheduler, code=1)
    assert "scheduler.json: " in done.output


def test_without_dask_the_extra_is_named(race: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "distributed", None)
    done = matrixworld_command("tournament", race, *AUTO, code=1)
    assert "pip install 'matrixworld-pursuit[cluster]'" in done.output


def test_workers_of_another_version_are_refused(
    race: Path, dask: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(cluster, "__version__", "9")
    address = dask.scheduler_address
    done = matrixworld_command("tournament", race, "--cluster", address, code=1)
    assert "--cluster: expected workers with the versions ('9', " in done.output


COMMANDS = {
    "evolve": ("--seeds", "0-3", *OPTIONS),
    "exploit": ("{job}", "--champion", "evader", "--matches", 100, "--episodes", 5),
    "score": ("{job}", "--episodes", 5, "--generation", "all"),
    "tournament": ("{race}", "--episodes", 4),
}
"""Commands that a cluster plays, and their arguments."""


@pytest.mark.slow
@pytest.mark.usefixtures("undrawn")
@pytest.mark.parametrize("name", COMMANDS)
def test_a_cluster_gives_the_same_files(name: str, race: Path, dask: Any, tmp_path: Path) -> None:
    job = tmp_path / "job"
    if "{job}" in COMMANDS[name]:
        evolve([tiny_race(seed=seed) for seed in (0, 1)], job, threads=1)
    arguments = [str(each).format(job=job, race=race) for each in COMMANDS[name]]
    out = {"evolve": "--out", "exploit": "--out", "score": "--json", "tournament": "--out"}[name]
    made = [tmp_path / "alone.npz", tmp_path / "shared.npz"]
    for target, where in zip(made, ((), ("--cluster", dask.scheduler_address)), strict=True):
        matrixworld_command(name, *arguments, out, target, *where)
    alone, shared = (_files_in(target) for target in made)
    assert alone
    assert alone == shared


def _files_in(target: Path) -> dict[str, bytes]:
    """Return the content of a file, or of all run directories in a directory."""
    if target.is_file():
        return {"": target.read_bytes()}
    return {
        f"{config.parent.relative_to(target)}/{name}": content
        for config in target.rglob("config.json")
        for name, content in results(config.parent).items()
    }


@pytest.mark.slow
def test_a_killed_worker_loses_no_run(dask: Any, tmp_path: Path) -> None:
    settings = [tiny_race(seed=n, generations=10, pursuer_epochs=100) for n in (0, 1)]
    killed: list[int] = []

    def kill_one(progress: Any) -> None:
        if not killed and any(each.share > 0.1 for each in progress.runs.values()):
            killed.append(next(iter(client.run(os.getpid).values())))
            os.kill(killed[0], signal.SIGKILL)

    with distributed.Client(dask.scheduler_address, set_as_default=False) as client:
        executor = client.get_executor(pure=False)
        runs = evolve(settings, tmp_path / "job", executor=executor, report=kill_one)
    assert killed
    for run, each in zip(runs, settings, strict=True):
        finish(each, tmp_path / f"{each.seed}", threads=1)
        assert results(run.path) == results(tmp_path / f"{each.seed}")


@pytest.mark.slow
@pytest.mark.usefixtures("undrawn")
def test_a_cluster_of_this_machine_stops_at_ctrl_c_and_continues(tmp_path: Path) -> None:
    out = tmp_path / "out"
    # Several seconds: it is stopped in its middle.
    long = words({"generations": 10, "pursuer_epochs": 100, "evader_epochs": 100})
    command = [sys.executable, "-m", "matrixworld", "evolve", "--out", str(out), "--seeds", "0-1"]
    process = subprocess.Popen(
        [*command, *AUTO, *OPTIONS, *long],
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
        # The workers of the cluster, too.
        wait_until(lambda: not group_lives(process.pid), "end of all processes")
    finally:
        kill_group(process.pid)
    assert process.returncode == 130, told.decode()
    assert f"matrixworld evolve --resume {out}" in told.decode()
    assert "Traceback" not in told.decode()
    evolved("--resume", out)
    path = out / "generalist-generalist" / "seed-0"
    finish(open_run(path).settings, tmp_path / "straight", threads=1)
    assert results(path) == results(tmp_path / "straight")
