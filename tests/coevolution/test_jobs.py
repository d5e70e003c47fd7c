"""Many runs at one call: the same bytes as one by one, whatever happens to them."""

import os
import subprocess
import sys
import warnings
from concurrent.futures import BrokenExecutor, Executor, Future, ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from matrixworld.coevolution.schedules import ALL_SCHEDULES

from executors import Reversed
from matrixworld._util.files import load_json, save_json
from matrixworld.coevolution import (
    DamagedFileError,
    DisengagementWarning,
    FailedRunsError,
    LockedError,
    OtherVersionError,
    evolve,
    finish,
    jobs,
    open_run,
    start,
)
from matrixworld.coevolution.jobs import (
    JOB,
    RUNNING,
    check_job,
    group_of,
    job_of,
    open_job,
    save_job,
    shares,
)
from matrixworld.coevolution.storage import RunWriter
from tiny_race import directory_in_memory, results, tiny_race, tiny_single

posix = pytest.mark.skipif(sys.platform == "win32", reason="needs signals")

SETTINGS = [
    tiny_race(seed=1),
    tiny_race(seed=2),
    tiny_race(seed=1, schedule="hall-of-fame", contemporaries=1, hall_sample=1),
    tiny_race(seed=3, learner="cma"),
    tiny_single(seed=1, team="evader", learner="ga"),
]
LONG = {"generations": 10, "pursuer_epochs": 200, "evader_epochs": 200}
"""Several seconds: tests stop such a run in its middle."""


@pytest.fixture(scope="module")
def straight():
    """All files that `finish` makes of each of the settings, by name of the run."""
    with directory_in_memory() as directory:
        job = job_of(SETTINGS)
        for name, settings in job.items():
            finish(settings, directory / name, threads=1)
        yield {name: files_in(directory / name) for name in job}


def files_in(directory):
    """Return all files of a run directory, but the lock."""
    return {path.name: path.read_bytes() for path in directory.iterdir() if path.name != ".lock"}


def check_equal(directory, straight):
    """Compare all runs of a job, and what lies beside them."""
    assert {name: files_in(directory / name) for name in straight} == straight
    tops = {name.partition("/")[0] for name in straight}
    assert {path.name for path in directory.iterdir()} == {*tops, JOB, ".lock"}


@pytest.mark.parametrize("executor", [ThreadPoolExecutor(2), Reversed(len(SETTINGS))])
def test_files_are_those_of_runs_one_by_one(executor, straight, tmp_path):
    save_job(tmp_path, job_of(SETTINGS))
    (tmp_path / f"{RUNNING}old").mkdir()  # left by a job that was killed
    runs = evolve(SETTINGS, tmp_path, executor=executor)
    check_equal(tmp_path, straight)
    # Finished runs are only opened: an executor that is no class of its own can do nothing.
    again = evolve(SETTINGS, tmp_path, executor=Executor())
    for made in runs, again:
        assert [run.settings for run in made] == SETTINGS
    check_equal(tmp_path, straight)


def test_processes_give_the_same_files(straight, tmp_path):
    seen = []
    runs = evolve(SETTINGS, tmp_path / "job", threads=2, report=seen.append)
    assert [run.settings for run in runs] == SETTINGS
    check_equal(tmp_path / "job", straight)
    assert (seen[0].what, seen[-1].what) == ("0 of 5 runs", "5 of 5 runs")
    assert seen[-1].done == seen[-1].total
    assert not seen[-1].runs


def test_the_job_knows_all_runs_before_any_begins(tmp_path):
    class Refuses(Executor):
        def submit(self, fn, /, *args, **kwargs):
            raise RuntimeError("no workers")

    with pytest.raises(RuntimeError, match="no workers"):
        evolve(SETTINGS, tmp_path / "job", executor=Refuses())
    assert [*open_job(tmp_path / "job").values()] == SETTINGS
    assert {path.name for path in (tmp_path / "job").iterdir()} == {JOB, ".lock"}


def test_a_job_is_played_by_one_process_at_a_time(tmp_path):
    seen = []

    def report(progress):
        with pytest.raises(LockedError):
            evolve(SETTINGS, tmp_path, executor=ThreadPoolExecutor(1))
        seen.append(progress)

    evolve(SETTINGS, tmp_path, executor=ThreadPoolExecutor(1), report=report)
    assert seen


def test_a_single_run_is_played_in_this_process(straight, tmp_path, monkeypatch):
    monkeypatch.setattr(jobs, "play_in_process", None)
    seen = []
    [run] = evolve(SETTINGS[0], tmp_path / "job", report=seen.append)
    assert run.settings == SETTINGS[0]
    name = "generalist-generalist/seed-1"
    assert files_in(tmp_path / "job" / name) == straight[name]
    assert "pursuers" in seen[0].what  # what the run does: there is no other one
    assert (seen[-1].what, seen[-1].done) == ("1 of 1 runs", seen[-1].total)


# Stopping


def stop_at(share, seen):
    """Return a report that presses Ctrl-C when a run is so far."""

    def report(progress):
        seen.append(progress)
        if any(each.share >= share for each in progress.runs.values()):
            raise KeyboardInterrupt

    return report


@pytest.mark.slow
def test_ctrl_c_ends_all_runs_and_the_same_call_continues(tmp_path, monkeypatch):
    monkeypatch.setattr(jobs, "SECONDS", 0.02)  # else such runs may end before they are stopped
    settings = [tiny_race(seed=seed, **LONG) for seed in range(2)]
    paths = [tmp_path / name for name in job_of(settings)]
    seen = []
    # In processes of this machine, and by an executor.
    for share, chosen in ((0.2, {"threads": 2}), (0.5, {"executor": ThreadPoolExecutor(2)})):
        with pytest.raises(KeyboardInterrupt):
            evolve(settings, tmp_path, report=stop_at(share, seen), **chosen)
        assert not list(tmp_path.glob(f"{RUNNING}*"))
        for path in filter(Path.exists, paths):
            with RunWriter(path).lock():  # nobody plays it
                assert len(open_run(path).archive()["pursuer"]) < 11
    # What the first call played does not count for the rate of the second.
    assert seen[-1].before > 0.05 * seen[-1].total
    assert seen[-1].total == pytest.approx(2 * next(iter(seen[-1].runs.values())).total)
    evolve(settings, tmp_path, threads=1)
    finish(settings[0], tmp_path / "straight", threads=1)
    assert results(paths[0]) == results(tmp_path / "straight")


# Failures


def failures_of(settings, directory, **options):
    """Return the failures of a job by name of the run, and the directories of the finished runs."""
    with pytest.raises(FailedRunsError) as raised:
        evolve(settings, directory, **options)
    error = raised.value
    names = {path.relative_to(directory).as_posix(): each for path, each in error.failures.items()}
    for path in error.failures:
        assert f"\n{path}: " in str(error)
    return names, [run.path.relative_to(directory).as_posix() for run in error.finished]


def test_bad_runs_are_named_and_the_others_finish(straight, tmp_path):
    job = job_of(SETTINGS)
    save_job(tmp_path, job)
    cut, foreign, altered, held, *others = job
    start(job[cut], tmp_path / cut)
    (tmp_path / cut / "stage-0000.npz").write_bytes(b"PK")
    finish(tiny_race(seed=77), tmp_path / foreign)
    finish(job[altered], tmp_path / altered)
    (tmp_path / altered / "payoff.npz").write_bytes(b"PK")
    before = {name: files_in(tmp_path / name) for name in (foreign, altered)}
    with start(job[held], tmp_path / held).files.lock():
        failures, finished = failures_of(SETTINGS, tmp_path, executor=ThreadPoolExecutor(1))
    # The payoff of a finished run is read when somebody asks for it.
    assert {name: type(error) for name, error in failures.items()} == {
        foreign: ValueError, cut: DamagedFileError, held: LockedError,
    }  # fmt: skip
    assert {name: files_in(tmp_path / name) for name in (foreign, altered)} == before
    assert finished == [altered, *others]
    assert {name: files_in(tmp_path / name) for name in others} == {n: straight[n] for n in others}


@pytest.mark.slow
@posix
def test_a_run_whose_process_dies_is_played_once_more_and_then_named(tmp_path):
    bad = tiny_race(learner="own_code:Dies")
    once = {"learner": "own_code:Dies", "settings": {"marker": str(tmp_path / "dead")}}
    settings = {"bad": bad, "once": tiny_race(**once), "good": tiny_race(seed=9)}
    failures, finished = failures_of(settings, tmp_path / "job", threads=2)
    assert {*failures} == {"bad"}
    assert isinstance(failures["bad"], BrokenExecutor)
    assert finished == ["once", "good"]
    assert (tmp_path / "dead").exists()
    for name in finished:
        finish(settings[name], tmp_path / name)
        assert results(tmp_path / name) == results(tmp_path / "job" / name)


@posix
@pytest.mark.slow
def test_processes_that_cannot_begin_end_the_job(tmp_path):
    """Such as those of a script that plays a job whenever it is imported."""
    (tmp_path / "script.py").write_text(
        "import sys\n"
        "from matrixworld.coevolution import evolve\n"
        "from tiny_race import tiny_race\n"
        "evolve([tiny_race(seed=seed) for seed in range(2)], sys.argv[1], threads=2)\n"
    )
    done = subprocess.run(
        [sys.executable, tmp_path / "script.py", tmp_path / "job"],
        capture_output=True,
        text=True,
        timeout=120,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
    )
    last = done.stderr.splitlines()[-1]
    assert last.endswith('or a script has no `if __name__ == "__main__":`')
    assert not list((tmp_path / "job").glob("*/*"))


def test_a_worker_that_does_not_see_the_directory_is_told_of(tmp_path):
    class Elsewhere(ThreadPoolExecutor):
        def submit(self, fn, /, settings, path, told, threads):
            there = tmp_path / "elsewhere" / told.name
            return super().submit(fn, settings, path, there, threads)

    failures, _ = failures_of(SETTINGS[:2], tmp_path / "job", executor=Elsewhere(1))
    assert {type(error) for error in failures.values()} == {FileNotFoundError}
    assert not list((tmp_path / "job").glob("*/*"))


def test_disengagements_are_warned_of_with_the_name_of_the_run(tmp_path):
    settings = [tiny_race(seed=1, generations=6, rows=40, cols=40, train_steps=1, max_steps=1)]

    class Silent(Executor):
        """Does a task without its warnings, which appear in another process."""

        def submit(self, fn, /, *args, **kwargs):
            future = Future()
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                future.set_result(fn(*args, **kwargs))
            return future

    with pytest.warns(DisengagementWarning, match=r"^generalist-generalist/seed-1: "):
        evolve(settings, tmp_path / "job", executor=Silent())


# Bad input


BAD = [
    ({"executor": 3}, TypeError, "executor"),
    ({"threads": 0}, ValueError, "threads"),
    ({"executor": ThreadPoolExecutor(1), "threads": 2}, ValueError, "threads"),
    ({"settings": [tiny_race(), tiny_race()]}, ValueError, "settings"),
    ({"settings": [tiny_race(learner="nowhere:Learner")]}, ValueError, "nowhere"),
    ({"settings": [tiny_single(opponent="nowhere")]}, FileNotFoundError, "nowhere"),
    ({"settings": [tiny_race(population=2 * 10**9, rows=40, cols=40)]}, ValueError, "run.*memory"),
]


@pytest.mark.parametrize(("bad", "kind", "message"), BAD, ids=range(len(BAD)))
def test_bad_input_is_refused_before_anything_is_written(bad, kind, message, tmp_path):
    with pytest.raises(kind, match=message):
        evolve(**{"settings": SETTINGS, "directory": tmp_path / "job", **bad})
    assert list(tmp_path.iterdir()) == []


def test_memory_is_that_of_the_runs_that_play_at_one_time(tmp_path, monkeypatch):
    for module in ("_util.checks", "coevolution.settings"):
        monkeypatch.setattr(f"matrixworld.{module}.available_memory", lambda: 300_000_000)
    for module in ("jobs", "settings"):
        place = f"matrixworld.coevolution.{module}.run_memory"
        monkeypatch.setattr(place, lambda settings: {"candidates": 10**8})
    check_job(job_of(SETTINGS), tmp_path, 2)
    with pytest.raises(
        ValueError,
        match=r"^5 runs .* 0\.6 of this would fit, with less pol",
    ):
        check_job(job_of(SETTINGS), tmp_path, 3)
    check_job(job_of(SETTINGS), tmp_path, None, elsewhere=True)


def test_a_directory_with_something_else_is_refused_and_stays(tmp_path):
    (tmp_path / "mine").touch()
    with pytest.raises(FileExistsError):
        evolve(SETTINGS, tmp_path)
    (tmp_path / "mine").unlink()
    evolve(SETTINGS[:2], tmp_path, executor=ThreadPoolExecutor(1))
    before = {path: path.stat().st_mtime_ns for path in tmp_path.rglob("*")}
    for other in (SETTINGS, SETTINGS[:1], [tiny_race(seed=1), tiny_race(seed=2, sigma=0.3)]):
        with pytest.raises(ValueError, match=r"expected the runs in its job\.json, got others: \w"):
            evolve(other, tmp_path)
    # Not even written again.
    assert {path: path.stat().st_mtime_ns for path in tmp_path.rglob("*")} == before


def test_a_few_runs_have_two_threads_each_and_of_more_the_last_does_not_play_alone():
    asked = [(1, 2), (2, 2), (3, 2), (3, 1), (3, 4), (3, 8), (4, 2), (5, 4), (9, 4)]
    expected = [(1, 2), (1, 2), (1, 2), (1, 1), (2, 2), (3, 2), (2, 1), (5, 1), (4, 1)]
    assert [shares(runs, cores) for runs, cores in asked] == expected


# Names and the file of a job:


KINDS = [
    tiny_race(obstacles=["......"] * 5 + [".#...."], sigma=np.float32(0.3)),
    tiny_race(learner="own_code:HillClimber", settings={"sigma": 0.2, "shrink": 0.5}),
    tiny_race(seed=2**63 - 1, learner="cma"),
    tiny_single(team="evader", opponent="hunter"),
]


def test_settings_come_back_equal_from_the_file(tmp_path):
    assert open_job(tmp_path) is None
    runs = {f"{n}/seed-{each.seed}": each for n, each in enumerate(KINDS)}
    runs |= {f"{n}/seed-1": replace(each, seed=1) for n, each in enumerate(KINDS)}
    save_job(tmp_path, runs)
    assert open_job(tmp_path) == runs
    # Many seeds take little more than one.
    save_job(tmp_path, job_of([tiny_race(seed=seed) for seed in range(200)]))
    assert (tmp_path / JOB).stat().st_size < 15_000


def test_names_and_what_was_asked_for():
    races = [tiny_race(schedule=name, seed=n) for n in (3, 12) for name in ALL_SCHEDULES[:2]]
    job = job_of([*races, tiny_single(seed=7)])
    first, second = ALL_SCHEDULES[:2]
    assert [*job] == [
        f"{first}/seed-3", f"{second}/seed-3", f"{first}/seed-12", f"{second}/seed-12",
        "pursuer-against-random/seed-7",
    ]  # fmt: skip
    named = job_of({"sigma-0.1": tiny_race(), "sigma-0.2/seed-5": tiny_race(sigma=0.2)})
    assert [*map(group_of, named)] == ["sigma-0.1", "sigma-0.2"]


def test_paths_of_opponents_mean_the_same_to_workers_elsewhere(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    job = job_of([tiny_single(opponent="runs/my first/seed-3", start="/other")])
    settings = job["pursuer-against-my-first/seed-5"]
    assert settings.schedule.opponent == str(tmp_path / "runs/my first/seed-3")
    assert settings.schedule.start == str(Path("/other"))


BAD_JOBS = [
    ([], ValueError, "expected at least one run"),
    ([3], TypeError, "expected RaceSettings, got 3"),
    ({"a": None}, TypeError, "expected RaceSettings, got None"),
    ([tiny_race(), tiny_race(sigma=0.2)], ValueError, "got two of generalist-generalist/seed-5"),
    ({"a": tiny_race(), "b": tiny_race()}, ValueError, "expected different runs, got a and b"),
    *(
        ({name: tiny_race()}, ValueError, "expected names such as")
        for name in ("", ".", "../a", "a/../b", "/a", "a/", "a/b/c", "a\n", "a@b")
    ),
]


@pytest.mark.parametrize(("settings", "kind", "message"), BAD_JOBS, ids=range(len(BAD_JOBS)))
def test_bad_jobs(settings, kind, message):
    with pytest.raises(kind, match=message):
        job_of(settings)


def test_files_that_are_damaged_or_of_another_version(tmp_path):
    save_job(tmp_path, job_of([tiny_race()]))
    values = load_json(tmp_path / JOB)
    content = (tmp_path / JOB).read_text()
    (tmp_path / JOB).write_text(content.replace('"seed-5"', '"seed-6"').replace(": 5", ": 6"))
    with pytest.raises(DamagedFileError, match=r"job\.json: altered"):
        open_job(tmp_path)
    [group] = values["groups"]
    for change in (
        {"format": 9},
        {"groups": []},
        {"groups": [{"settings": {}}]},
        {"groups": [{**group, "seeds": {"../../elsewhere": 5}}]},
    ):
        save_json(tmp_path / JOB, {**values, **change})
        with pytest.raises(OtherVersionError):
            open_job(tmp_path)
