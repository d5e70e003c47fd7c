"""Many runs at one call: the same bytes as one by one, whatever happens to them."""

import io
import re
import sys
import warnings
from concurrent.futures import Executor, Future, ThreadPoolExecutor
from pathlib import Path

import pytest

import own_code
from executors import Reversed
from matrixworld import coevolution as co
from matrixworld.coevolution.jobs import job as jobs
from matrixworld.coevolution.jobs.job import (
    change_settings,
    check_job,
    create_job,
    found_job,
    job_of,
)
from scripts import python
from tiny_race import hall_of_fame, played, results, straight, tiny_race, tiny_single

posix = pytest.mark.skipif(sys.platform == "win32", reason="needs signals")

SETTINGS = [
    tiny_race(seed=1),
    tiny_race(seed=2),
    hall_of_fame(seed=1, generations=2),
    tiny_race(seed=3, learner="cma"),
    tiny_single(seed=1, team="evader", learner="ga"),
]


def files_in(directory):
    return {path.name: path.read_bytes() for path in directory.iterdir() if path.name != ".lock"}


def check_equal(directory):
    """Compare all runs of the job with runs one by one, and what lies beside them."""
    job = job_of(SETTINGS)
    for name, settings in job.items():
        assert results(directory / name) == straight(settings)
    assert {path.name for path in directory.iterdir()} == {name.split("/")[0] for name in job}


@pytest.mark.parametrize("executor", [ThreadPoolExecutor(2), Reversed(len(SETTINGS))])
def test_files_are_those_of_runs_one_by_one(executor, tmp_path):
    runs = co.evolve(SETTINGS, tmp_path, executor=executor)
    check_equal(tmp_path)
    # Finished runs are only opened: an executor that is no class of its own can do nothing.
    again = co.evolve(SETTINGS, tmp_path, executor=Executor())
    for made in runs, again:
        assert [run.settings for run in made] == SETTINGS
    check_equal(tmp_path)


def test_processes_give_the_same_files_and_tell_each_row_and_how_far_they_are(tmp_path):
    seen, rows = [], []
    progress = {"report": seen.append, "on_epoch": rows.append}
    runs = co.evolve(SETTINGS, tmp_path / "job", threads=2, **progress)
    check_equal(tmp_path / "job")
    for run in runs:
        name = run.path.relative_to(tmp_path / "job").as_posix()
        told = [row for row in rows if row["run"] == name]
        assert told == [{"run": name, "seed": run.settings.seed, **row} for row in run.rows(0)]
    assert (seen[0].what, seen[-1].what) == ("0 of 5 runs", "5 of 5 runs")
    assert [each.done for each in seen] == sorted(each.done for each in seen)
    assert seen[-1].done == seen[-1].total == seen[0].total
    assert seen[-1].before == 0


def test_a_single_run_is_played_in_its_directory_by_this_process(tmp_path, monkeypatch):
    monkeypatch.setattr("matrixworld.coevolution.jobs.play.processes", None)
    seen, rows = [], []
    run = co.evolve(SETTINGS[0], tmp_path / "run", report=seen.append, on_epoch=rows.append)
    assert (run.settings, run.path) == (SETTINGS[0], tmp_path / "run")
    assert results(run.path) == straight(SETTINGS[0])
    assert "pursuers" in seen[0].what or "stage 0" in seen[0].what  # what the run does
    assert seen[-1].done == seen[-1].total
    places = [(row["run"], row["seed"], row["stage"], row["epoch"]) for row in rows]
    assert places == [("run", 1, row["stage"], row["epoch"]) for row in run.rows(0)]
    co.evolve(SETTINGS[0], tmp_path / "run")
    assert results(run.path) == straight(SETTINGS[0])
    [again] = co.evolve({"other/seed-1": SETTINGS[0]}, tmp_path / "named")
    assert files_in(again.path) == files_in(run.path)


def test_a_job_is_stopped_by_a_callback_and_goes_on(tmp_path):
    before, after = [], []

    def stop(row):
        before.append(row)
        raise co.StopRun

    with ThreadPoolExecutor(1) as executor, pytest.raises(co.StopRun):
        co.evolve(SETTINGS, tmp_path, executor=executor, on_epoch=stop)
    # What had begun has ended, and nothing else has begun.
    assert sum(co.open_run(tmp_path / name).finished for name in job_of(SETTINGS)) < len(SETTINGS)
    co.evolve(SETTINGS, tmp_path, executor=ThreadPoolExecutor(2), on_epoch=after.append)
    places = [(row["run"], row["team"], row["generation"], row["epoch"]) for row in before + after]
    assert len(set(places)) == len(places) > 20  # no row comes twice
    check_equal(tmp_path)


def failures_of(settings, directory, **options):
    """Return the failures of a job by name of the run, and the directories of the finished runs."""
    with pytest.raises(co.FailedRunsError) as raised:
        co.evolve(settings, directory, **options)
    error = raised.value
    names = {path.relative_to(directory).as_posix(): each for path, each in error.failures.items()}
    for path in error.failures:
        assert f"\n{path}: " in str(error)
    return names, [run.path.relative_to(directory).as_posix() for run in error.finished]


def test_bad_runs_are_named_and_the_others_finish(tmp_path):
    job, seen = job_of(SETTINGS), []
    create_job(job, tmp_path)
    cut, altered, held, *others = job
    (tmp_path / cut / "stage-0000.npz").write_bytes(b"PK")
    played(job[altered], tmp_path / altered)
    (tmp_path / altered / "payoff.npz").write_bytes(b"PK")
    before = files_in(tmp_path / altered)
    with co.Run(tmp_path / held).files.lock():
        failures, finished = failures_of(
            SETTINGS, tmp_path, executor=ThreadPoolExecutor(1), report=seen.append
        )
    # The payoff of a finished run is read when somebody asks for it.
    assert {name: type(error) for name, error in failures.items()} == {
        cut: co.DamagedFileError, held: co.LockedError,
    }  # fmt: skip
    assert seen[-1].what == "3 of 5 runs, 2 failed"
    assert files_in(tmp_path / altered) == before
    assert finished == [altered, *others]
    assert all(results(tmp_path / name) == straight(job[name]) for name in others)


def test_an_error_of_own_code_is_that_of_its_run(tmp_path, monkeypatch):
    monkeypatch.setattr(own_code.Fails, "told", 0)
    settings = {"bad": tiny_race(learner="own_code:Fails"), "good": tiny_single()}
    failures, finished = failures_of(settings, tmp_path / "job", executor=ThreadPoolExecutor(1))
    assert ({*failures}, finished) == ({"bad"}, ["good"])
    told = str(co.FailedRunsError({Path("bad"): failures["bad"]}))
    assert told.startswith("1 run failed:\nbad: ZeroDivisionError: ")
    assert isinstance(failures["bad"], ZeroDivisionError)


@posix
def test_the_runs_of_a_process_that_dies_go_on_from_what_is_saved(tmp_path):
    once = {"learner": "own_code:Dies", "learner.settings": {"marker": str(tmp_path / "dead")}}
    settings = {"once": tiny_race(**once), "good": tiny_race(seed=9)}
    with pytest.warns(UserWarning, match="a process has died; its runs go on from what is saved"):
        runs = co.evolve(settings, tmp_path / "job", threads=4)
    assert (tmp_path / "dead").exists()
    for run in runs:
        assert results(run.path) == straight(run.settings)


@posix
@pytest.mark.slow
def test_processes_that_cannot_begin_end_the_job(tmp_path):
    (tmp_path / "script.py").write_text(
        "import sys\n"
        "from matrixworld.coevolution import evolve\n"
        "from tiny_race import tiny_race\n"
        "evolve([tiny_race(seed=seed) for seed in range(2)], sys.argv[1], threads=4)\n"
    )
    last = python(tmp_path / "script.py", tmp_path / "job").stderr.splitlines()[-1]
    assert 'or a script has no `if __name__ == "__main__":`' in last
    assert {run.newest() for run in map(co.open_run, (tmp_path / "job").glob("*/*"))} == {0}


def test_a_worker_that_does_not_see_the_directory_is_told_of(tmp_path):
    class Elsewhere(ThreadPoolExecutor):
        def submit(self, fn, /, path, threads):
            assert found_job(tmp_path / "job") == job_of(SETTINGS[:2])  # all, before any begins
            return super().submit(fn, tmp_path / "elsewhere" / path.name, threads=threads)

    failures, _ = failures_of(SETTINGS[:2], tmp_path / "job", executor=Elsewhere(1))
    assert {type(error) for error in failures.values()} == {FileNotFoundError}
    assert not (tmp_path / "elsewhere").exists()


def test_disengagements_are_warned_of_with_the_name_of_the_run(tmp_path):
    settings = [tiny_race(seed=1, generations=6, rows=40, cols=40, train_steps=1, max_steps=1)]

    class Silent(Executor):  # as if the warnings of tasks appeared in another process
        def submit(self, fn, /, *args, **kwargs):
            future = Future()
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                future.set_result(fn(*args, **kwargs))
            return future

    with pytest.warns(co.DisengagementWarning, match=r"^generalist-generalist/seed-1: ") as warned:
        co.evolve(settings, tmp_path / "job", executor=Silent())
    assert {each.filename for each in warned} == {__file__}  # where it was called


BAD = [
    ({"executor": 3}, TypeError, "executor"),
    ({"threads": 0}, ValueError, "threads"),
    ({"executor": ThreadPoolExecutor(1), "threads": 2}, ValueError, "threads"),
    ({"settings": [tiny_race(), tiny_race(sigma=0.2)]}, ValueError, "got two of .*/seed-5"),
    ({"settings": {"a": tiny_race(), "b": tiny_race()}}, ValueError, "different runs, got a and b"),
    *(
        ({"settings": {name: tiny_race()}}, ValueError, "expected names such as")
        for name in ("", "../a", "/a", "a/b/c", "a\n")
    ),
    ({"settings": tiny_race(learner="nowhere:Learner")}, ValueError, "nowhere"),
    ({"settings": [tiny_single(opponent="nowhere")]}, ValueError, "got .nowhere"),
]


@pytest.mark.parametrize(("bad", "kind", "message"), BAD, ids=range(len(BAD)))
def test_bad_input_is_refused_before_anything_is_written(bad, kind, message, tmp_path):
    with pytest.raises(kind, match=message):
        co.evolve(**{"settings": SETTINGS, "out": tmp_path / "job", **bad})
    assert list(tmp_path.iterdir()) == []


def test_memory_is_that_of_the_runs_that_play_at_one_time(tmp_path, monkeypatch):
    monkeypatch.setattr("matrixworld._util.checks.available_memory", lambda: 300_000_000)
    monkeypatch.setattr(jobs, "run_memory", lambda settings: {"candidates": 10**8})
    check_job(job_of(SETTINGS), tmp_path, 2)
    with pytest.raises(ValueError, match=r"^5 runs at one time: expected .* 0\.3 GB .* 0\.5 GB"):
        check_job(job_of(SETTINGS), tmp_path, 3)
    check_job(job_of(SETTINGS), tmp_path, None, elsewhere=True)


def test_a_directory_with_something_else_is_refused_and_stays(tmp_path):
    (tmp_path / "mine").touch()
    with pytest.raises(FileExistsError, match="found mine"):
        co.evolve(SETTINGS, tmp_path)
    (tmp_path / "mine").unlink()
    co.evolve(SETTINGS[:2], tmp_path, executor=ThreadPoolExecutor(1))
    before = {path: path.stat().st_mtime_ns for path in tmp_path.rglob("*")}
    for other, message in (
        (SETTINGS[:1], r"runs of this job, got others: generalist-generalist/seed-2$"),
        (SETTINGS, r"expected all runs of this job, got a directory without hall-of-fame/seed-1, "),
        (SETTINGS[0], r"runs of this job, got others: generalist-generalist/seed-1, "),
        ([tiny_race(seed=1), tiny_race(seed=2, sigma=0.3)], "other settings: learner.sigma$"),
    ):
        with pytest.raises(ValueError, match=message):
            co.evolve(other, tmp_path)
    # Not even written again.
    assert {path: path.stat().st_mtime_ns for path in tmp_path.rglob("*")} == before


def test_paths_of_opponents_mean_the_same_to_workers_elsewhere(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    job = job_of([tiny_single(opponent="runs/my first/seed-3", start="/other")])
    settings = job["pursuer-against-my-first/seed-5"]
    assert settings.schedule.opponent == str(tmp_path / "runs/my first/seed-3")
    assert settings.schedule.start == str(Path("/other"))


class Terminal(io.StringIO):
    def isatty(self):
        return True


def test_a_bar_in_a_terminal_begins_with_what_is_done():
    out = Terminal()
    with co.ProgressBar(stream=out, clock=iter([0.0, 0.0, 0.1, 1.0]).__next__) as bar:
        bar(co.Progress("0 of 3 runs", 20, 300))
        bar(co.Progress("too early", 21, 300))
        bar(co.Progress("1 of 3 runs", 150, 300))
    said = out.getvalue()
    assert "too early" not in said
    assert re.search(r"\r1 of 3 runs:  50%\|[#█]{8} {8}\| .* left", said)


def test_rows_come_at_once_where_runs_are_played_in_this_process(tmp_path, monkeypatch):
    monkeypatch.setattr("matrixworld._util.imports.HAS_PROCESSES", False)
    rows = []

    def look(row):
        stages = [*(tmp_path / row["run"]).glob("stage-*.npz")]
        rows.append((row["run"], row["stage"], len(stages)))

    runs = co.evolve(SETTINGS, tmp_path, on_epoch=look)
    check_equal(tmp_path)
    assert len(rows) == sum(len(run.rows(0)) for run in runs)
    assert all(saved == stage for _, stage, saved in rows)  # stage 0, and those before this one


@pytest.mark.parametrize("stop", [co.StopRun, ZeroDivisionError, ValueError])
@pytest.mark.parametrize("argument", ["on_epoch", "report"])
def test_what_a_callback_raises_is_no_failure_of_a_run(stop, argument, tmp_path, monkeypatch):
    monkeypatch.setattr("matrixworld._util.imports.HAS_PROCESSES", False)

    def fail(_):
        raise stop

    with pytest.raises(stop):
        co.evolve(SETTINGS, tmp_path, **{argument: fail})
    co.evolve(SETTINGS, tmp_path)
    check_equal(tmp_path)


def test_races_of_a_job_become_longer_all_or_none(tmp_path):
    settings = tiny_race(generations=1)
    annealed = settings.changed({"learner": "es", "learner.anneal": True})
    co.evolve({"a": settings, "b": annealed}, tmp_path)
    before = [files_in(tmp_path / name) for name in "ab"]
    with pytest.raises(ValueError, match="anneal"):
        change_settings(tmp_path, generations=3)
    assert [files_in(tmp_path / name) for name in "ab"] == before
