"""The option --cluster, on a real Dask cluster of two processes; what docs/cluster.md shows."""

import os
import re
import signal
import subprocess
import sys
from concurrent.futures import Executor, Future
from contextlib import suppress
from pathlib import Path
from types import SimpleNamespace
from unittest.mock import MagicMock

import pytest

from command_line import RACE, matrixworld_command, run_together, words
from matrixworld.cli import cluster
from matrixworld.coevolution import evolve, open_runs
from tiny_race import results, tiny_race

SCHEDULE = ("--schedule", "generalist-generalist")
OPTIONS = (*SCHEDULE, *words({name: value for name, value in RACE.items() if name != "seed"}))


@pytest.fixture(scope="module")
def dask():
    """A cluster; on exit no process is left."""
    distributed = pytest.importorskip("distributed")
    local = {"dashboard_address": "127.0.0.1:0", "silence_logs": "CRITICAL", "memory_limit": 0}
    with distributed.LocalCluster(2, threads_per_worker=1, **local) as running:
        yield running


def test_without_dask_the_command_that_installs_it_is_named(race, monkeypatch):
    monkeypatch.setitem(sys.modules, "distributed", None)
    told = matrixworld_command("tournament", race, "--cluster", "auto", code=1).output
    assert "pip install 'matrixworld-pursuit[cluster]'" in told


@pytest.mark.slow
def test_workers_of_another_version_are_refused(race, dask, monkeypatch):
    monkeypatch.setattr(cluster, "__version__", "9")
    address = dask.scheduler_address
    done = matrixworld_command("tournament", race, "--cluster", address, code=1)
    assert "--cluster: expected workers with the versions ('9', " in done.output


def test_a_worker_of_another_version_that_comes_later_does_nothing():
    assert cluster.call_in(cluster.versions(), max, 1, 2) == 2
    with pytest.raises(cluster.OtherWorkerError, match=r"the versions \('9', '9'\) of matrixworld"):
        cluster.call_in(("9", "9"), max, 1, 2)


class Cancelling(Executor):
    """Dask's executor after the scheduler was lost."""

    def submit(self, function, /, *args, **kwargs):
        future = Future()
        future.cancel()
        future.set_running_or_notify_cancel()
        return future


class Interrupted(Executor):
    def submit(self, function, /, *args, **kwargs):
        raise KeyboardInterrupt


@pytest.mark.usefixtures("undrawn")
@pytest.mark.parametrize(
    ("executor", "code", "message"),
    [(Cancelling, 1, "--cluster: the scheduler was lost"), (Interrupted, 130, "Stopped. ")],
)
def test_a_lost_or_interrupted_cluster_is_told(executor, code, message, monkeypatch):
    client = MagicMock()
    client.__enter__.return_value.run.return_value = {}
    client.__enter__.return_value.get_executor.return_value = executor()
    dask = SimpleNamespace(Client=lambda *args, **options: client)
    monkeypatch.setattr(cluster, "imported", lambda *names: dask)
    typed = ("--seeds", "0-1", *OPTIONS, "--cluster", "tcp://nowhere:1", "--out", "job")
    told = run_together(matrixworld_command("evolve", *typed, code=code).stderr)
    assert message in told
    assert "matrixworld evolve --resume job Runs that have begun go on at the workers;" in told
    refused = matrixworld_command("tournament", "job", "--cluster", "tcp://nowhere:1", code=code)
    assert message in refused.stderr


COMMANDS = {
    "evolve": ("--seeds", "0-1", *OPTIONS),
    "score": ("{job}", "--episodes", 5, "--generation", "all"),
}
"""Commands that a cluster plays, and their arguments."""


@pytest.mark.slow
@pytest.mark.usefixtures("undrawn")
@pytest.mark.parametrize("name", COMMANDS)
def test_a_cluster_gives_the_same_files(name, race, dask, tmp_path):
    job = tmp_path / "job"
    if "{job}" in COMMANDS[name]:
        evolve([tiny_race(seed=seed) for seed in (0, 1)], job, threads=1)
    arguments = [str(each).format(job=job, race=race) for each in COMMANDS[name]]
    out = "--json" if name == "score" else "--out"
    made = [tmp_path / "alone.npz", tmp_path / "shared.npz"]
    shared = ("--cluster", "auto" if name == "evolve" else dask.scheduler_address)
    for target, where in zip(made, ((), shared), strict=True):
        matrixworld_command(name, *arguments, out, target, *where)
    alone, shared = (_files_in(target) for target in made)
    assert alone
    assert alone == shared


@pytest.mark.slow
def test_a_cluster_plays_the_same_tournament(race, dask):
    file, found = Path(race) / "tournament-4-seed0.npz", []
    for where in ((), ("--cluster", dask.scheduler_address)):
        matrixworld_command("tournament", race, "--episodes", 4, "--force", *where)
        found.append(file.read_bytes())
    assert found[0] == found[1]


def _files_in(target):
    """Return the content of a file, or of all run directories in a directory."""
    if target.is_file():
        return {"": target.read_bytes()}
    return {
        f"{config.parent.relative_to(target)}/{name}": content
        for config in target.rglob("config.json")
        for name, content in results(config.parent).items()
    }


PAGE = (Path(__file__).parents[2] / "docs/cluster.md").read_text(encoding="utf-8")
SCRIPTS = re.findall(r"^```sh\n(#!/bin/bash\n.*?)^```", PAGE, re.M | re.S)
TINY = {"world.rows": 8, "world.n_evaders": 2, "schedule.generations": 1}


@pytest.mark.slow
def test_the_example_in_python_runs(tmp_path):
    [code] = re.findall(r"^```python\n(.*?)^```", PAGE, re.M | re.S)
    (tmp_path / "script.py").write_text(code)
    subprocess.run([sys.executable, "script.py"], cwd=tmp_path, check=True)
    assert len(open_runs(tmp_path / "many")) == 4


@pytest.mark.nightly
@pytest.mark.skipif(sys.platform != "linux", reason="scripts of batch systems of Linux")
@pytest.mark.parametrize("script", SCRIPTS, ids=["array", "cluster"])
def test_scripts_for_batch_systems_run(script, tmp_path):
    settings = f"RaceSettings.of({{**{TINY}, 'schedule': schedule, 'seed': seed}})"
    sets = "".join(f" --set {path}={value}" for path, value in TINY.items())
    changes = {
        "RaceSettings(schedule=schedule, seed=seed)": settings,
        "--seeds 0-999": f"--seeds 0-1 --schedule generalist-generalist{sets}",
        "/shared": str(tmp_path),
        "ib0": "lo",
    }
    for old, new in changes.items():
        script = script.replace(old, new)
    path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    found = {**os.environ, "PATH": path, "SLURM_ARRAY_TASK_ID": "0", "SLURM_JOB_ID": "7"}
    begin = 'srun() { "$@"; }; matrixworld() { python -m matrixworld "$@"; }\n'
    task = subprocess.Popen(["bash", "-c", begin + script], env=found, start_new_session=True)
    try:
        assert task.wait(300) == 0
    finally:
        with suppress(ProcessLookupError):  # of the array; a cluster leaves scheduler and worker
            os.killpg(task.pid, signal.SIGKILL)
    assert open_runs(tmp_path / "my-races")
