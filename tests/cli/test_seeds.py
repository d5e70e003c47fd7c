"""``matrixworld evolve --seeds``: layout, what is printed, interruptions and failures."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from command_line import MAIN_JOB, RACE, evolved, words
from matrixworld.coevolution import evolve
from matrixworld.coevolution.jobs import found_job
from matrixworld.coevolution.storage import find_runs
from scripts import group_lives, wait_until
from tiny_race import results, tiny_race

ONE = {name: value for name, value in RACE.items() if name != "seed"}


def test_a_directory_for_each_schedule_and_seed(undrawn):
    chosen = ["--schedule", MAIN_JOB[0], "--schedule", MAIN_JOB[2]]
    said = evolved("--out", "out", "--seeds", "2,10", *chosen, *words(ONE))
    names = [f"{name}/seed-{n}" for name in (MAIN_JOB[0], MAIN_JOB[2]) for n in (2, 10)]
    assert find_runs(Path("out")) == [Path("out") / name for name in names]
    assert find_runs(Path("out") / MAIN_JOB[2]) == [Path("out") / name for name in names[2:]]
    assert [*found_job(Path("out"))] == names
    evolve(tiny_race(seed=10, schedule=MAIN_JOB[2]), "alone")
    assert results(Path("out") / names[3]) == results(Path("alone"))
    assert "[4/4] evaders" in said.stderr
    before = {path: path.read_bytes() for path in Path("out").rglob("*.*") if path.is_file()}
    again = evolved("--resume", "out")
    # The first line has the time.
    assert again.stdout.splitlines()[1:] == said.stdout.splitlines()[1:]
    assert {path: path.read_bytes() for path in before} == before
    part = evolved("--resume", f"out/{MAIN_JOB[0]}")
    assert part.stdout.startswith("2 races done")
    assert f"seed-2 {MAIN_JOB[2]}" not in part.stdout


def test_a_failed_run_is_named_and_the_others_are_reported(monkeypatch):
    reported = []

    def keep(job, root, runs, *rest):
        reported.append([run.path for run in runs])

    monkeypatch.setattr("matrixworld.cli.evolve.report", keep)
    evolved("--out", "out", "--seeds", "0-2", "--schedule", MAIN_JOB[2], *words(ONE))
    runs = find_runs(Path("out"))
    for name in ("payoff.npz", "summary.json"):
        (runs[1] / name).unlink()
    (runs[1] / "stage-0001.npz").write_bytes(b"PK")
    said = evolved("--resume", "out", code=1)
    assert f"Error: 1 of 3 runs failed:\n  {runs[1]}: " in said.stderr
    assert "To try them again:\n  matrixworld evolve --resume out\n" in said.stderr
    assert reported[-1] == [runs[0], runs[2]]


def process_of(*args):
    """Start a command in a process of its own, with a group that a terminal would stop."""
    return subprocess.Popen(
        [sys.executable, "-m", "matrixworld", "evolve", *map(str, args)],
        stderr=subprocess.PIPE,
        text=True,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
        # In a background job SIGINT may be ignored, and child processes inherit that.
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
        start_new_session=True,
    )


@pytest.mark.slow
@pytest.mark.skipif(sys.platform == "win32", reason="needs signals")
@pytest.mark.parametrize("send", [os.killpg, os.kill], ids=["to all processes", "to the parent"])
def test_stopped_and_killed_and_resumed_ends_the_same(send, monkeypatch):
    """Ctrl-C in the first runs leaves no process; a kill loses nothing."""
    monkeypatch.setattr("matrixworld.cli.evolve.report", lambda *args, **timed: None)
    longer = {**ONE, "generations": 6, "pursuer_epochs": 40, "evader_epochs": 40}
    chosen = ["--seeds", "0-2", "--schedule", MAIN_JOB[0], *words(longer)]
    process = process_of("--out", "out", *chosen)
    wait_until(lambda: [*Path("out").glob("*/*/stage-0001.npz")], "a stage")
    send(process.pid, signal.SIGINT)  # a terminal sends it to all
    _, errors = process.communicate(timeout=60)
    assert process.returncode == 130
    assert "matrixworld evolve --resume out\n" in errors
    assert "Traceback" not in errors
    wait_until(lambda: not group_lives(process.pid), "end of all processes", 10.0)
    assert {path.name for path in Path("out").iterdir()} <= {MAIN_JOB[0], "explorer.html"}

    process = process_of("--resume", "out")
    later = Path("out").glob  # a fast machine may end before the kill, which is no failure
    wait_until(lambda: [*later("*/*/stage-0005.npz")] or process.poll() is not None, "a stage")
    process.kill()
    process.communicate()
    wait_until(lambda: not group_lives(process.pid), "end of all processes", 10.0)
    evolved("--resume", "out")
    settings = tiny_race(**{**longer, "hidden": (4,)}, schedule=MAIN_JOB[0], seed=1)
    evolve(settings, "straight")
    assert results(Path(f"out/{MAIN_JOB[0]}/seed-1")) == results(Path("straight"))


def test_runs_that_were_put_together_by_hand_are_continued(undrawn):
    for seed in (0, 1):
        evolve(tiny_race(seed=seed), f"mine/{seed}")
    Path("mine/1/summary.json").unlink()
    before = Path("mine/0/summary.json").read_bytes()
    said = evolved("--resume", "mine").stdout
    assert Path("mine/1/summary.json").exists()
    assert Path("mine/0/summary.json").read_bytes() == before
    assert "2 races done" in said
