"""A callback gets the rows of the log while runs train, may stop them, and changes no byte."""

import sys
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from matrixworld.coevolution import RaceSettings, StopRun, evolve, finish, jobs, open_run
from run_curves import tensorboard_writer, wandb_writer
from tiny_race import results, tiny_race, tiny_single

Row = dict[str, Any]
SETTINGS = {
    "race": tiny_race(seed=1),
    "hall": tiny_race(seed=2, schedule="hall-of-fame", contemporaries=1, hall_sample=1),
    "alone": tiny_single(seed=3, team="evader", learner="ga"),
}


def logged(directory: Path, run: str, seed: int) -> list[Row]:
    """Return the rows that a callback should have got."""
    columns = open_run(directory).log()
    values = zip(*(column.tolist() for column in columns.values()), strict=True)
    return [{"run": run, "seed": seed, **dict(zip(columns, row, strict=True))} for row in values]


def stop_after(rows: list[Row], count: int) -> Any:
    def on_epoch(row: Row) -> None:
        rows.append(dict(row))
        row.clear()  # what the caller does with it is not the run's business
        if len(rows) == count:
            raise StopRun

    return on_epoch


@pytest.mark.parametrize("name", ["hall", "alone"])
def test_finish_tells_each_epoch_and_can_be_stopped(name: str, tmp_path: Path) -> None:
    settings, rows = SETTINGS[name], list[Row]()
    finish(settings, tmp_path / "without", threads=1)
    expected = logged(tmp_path / "without", "with", settings.seed)
    with pytest.raises(StopRun):
        finish(settings, tmp_path / "with", threads=1, on_epoch=stop_after(rows, 3))
    assert len(rows) == 3 < len(expected)
    assert not open_run(tmp_path / "with").finished
    finish(settings, tmp_path / "with", threads=1, on_epoch=stop_after(rows, -1))
    by_epoch = {(row["stage"], row["team"], row["epoch"]): row for row in rows}
    # Selection among elites plays matches that the log counts later.
    assert [without_counts(row) for row in by_epoch.values()] == [
        pytest.approx(without_counts(row), rel=1e-8) for row in expected
    ]
    assert results(tmp_path / "with") == results(tmp_path / "without")


def without_counts(row: Row) -> dict[str, float]:
    assert row["team"] in ("pursuer", "evader")
    return {k: v for k, v in row.items() if k not in ("matches", "steps", "run", "team")}


def test_jobs_tell_each_row_once(tmp_path: Path) -> None:
    rows: list[Row] = []
    evolve(SETTINGS, tmp_path, executor=ThreadPoolExecutor(2), on_epoch=rows.append)
    for name, settings in SETTINGS.items():
        told = [row for row in rows if row["run"] == name]
        assert told == logged(tmp_path / name, name, settings.seed)


def test_a_job_is_stopped_and_goes_on(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(jobs, "SECONDS", 0.01)  # else such a job may end before it is stopped
    before, after = list[Row](), list[Row]()
    job = {f"seed-{n}": tiny_race(seed=n, generations=10, pursuer_epochs=40) for n in (1, 2)}
    with pytest.raises(StopRun):
        evolve(job, tmp_path, executor=ThreadPoolExecutor(2), on_epoch=stop_after(before, 2))
    assert not all(open_run(tmp_path / name).finished for name in job)
    evolve(job, tmp_path, executor=ThreadPoolExecutor(2), on_epoch=after.append)
    places = [(row["run"], row["team"], row["generation"], row["epoch"]) for row in before + after]
    assert len(set(places)) == len(places) > 100  # no row comes twice


class Kept:
    """What stands for a writer of TensorBoard and for a run of Weights & Biases."""

    made: list["Kept"]

    def __init__(self, *name: str, **settings: Any) -> None:
        self.name, self.settings, self.calls, self.ended = name, settings, list[Any](), False
        self.made.append(self)

    def __enter__(self) -> "Kept":
        return self

    def __exit__(self, *error: object) -> None:
        self.ended = True

    def add_scalar(self, *call: Any) -> None:
        self.calls.append(call)

    def log(self, values: dict[str, float]) -> None:
        self.calls += [(k, v, values["matches"]) for k, v in values.items() if k != "matches"]

    def define_metric(self, name: str, step_metric: str) -> None:
        assert (name, step_metric) == ("*", "matches")


@pytest.fixture
def made(monkeypatch: pytest.MonkeyPatch) -> Iterator[list[Kept]]:
    Kept.made = []
    monkeypatch.setitem(sys.modules, "tensorboardX", SimpleNamespace(SummaryWriter=Kept))
    monkeypatch.setitem(sys.modules, "wandb", SimpleNamespace(init=Kept))
    return Kept.made


def test_writers_get_a_curve_of_each_measure_and_team(made: list[Kept], tmp_path: Path) -> None:
    job: dict[str, RaceSettings] = {"a/seed-1": tiny_race(seed=1), "b/seed-2": tiny_race(seed=2)}
    with (
        tensorboard_writer(tmp_path / "curves") as write,
        wandb_writer(project="races") as log,
    ):
        for name, settings in job.items():
            run = finish(settings, tmp_path / name, threads=1, on_epoch=write)
            for row in logged(tmp_path / name, name, settings.seed):
                log(row)
        assert not any(each.ended for each in made)
    columns = run.log()
    own = columns["team"] == "evader"
    for kept in made:
        curve = [call[1:] for call in kept.calls if call[0] == "evader/capture_rate"]
        assert len(curve) == own.sum() > 2
        assert not {name for name, *_ in kept.calls} & {"evader/epoch", "evader/seed"}
        assert kept.ended
    assert curve == list(zip(columns["capture_rate"][own], columns["matches"][own], strict=True))
    of_wandb = [each.settings for each in made if each.settings.get("project")]
    assert [(each["name"], each["config"]) for each in of_wandb] == [
        ("a/seed-1", {"seed": 1}), ("b/seed-2", {"seed": 2}),
    ]  # fmt: skip
