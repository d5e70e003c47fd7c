"""The runs of a job: their names, the file that lists them, and settings as text."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from matrixworld._util.files import load_json, save_json
from matrixworld.coevolution import DamagedFileError, OtherVersionError
from matrixworld.coevolution.jobs.evolve import (
    JOB,
    group_of,
    job_of,
    open_job,
    save_job,
)
from matrixworld.coevolution.schedules import ALL_SCHEDULES
from tiny_race import tiny_race, tiny_single

SETTINGS = [
    tiny_race(obstacles=["......"] * 5 + [".#...."], sigma=np.float32(0.3)),
    tiny_race(learner="own_code:HillClimber", settings={"sigma": 0.2, "shrink": 0.5}),
    tiny_race(seed=2**63 - 1, learner="cma"),
    tiny_single(team="evader", opponent="hunter"),
]


def test_settings_come_back_equal_from_the_file(tmp_path):
    runs = {f"{n}/seed-{each.seed}": each for n, each in enumerate(SETTINGS)}
    runs |= {f"{n}/seed-1": replace(each, seed=1) for n, each in enumerate(SETTINGS)}
    save_job(tmp_path, runs)
    assert open_job(tmp_path) == runs


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


BAD = [
    ([], ValueError, "expected at least one run"),
    ({}, ValueError, "expected at least one run"),
    ([3], TypeError, "expected RaceSettings, got 3"),
    ({"a": None}, TypeError, "expected RaceSettings, got None"),
    ([tiny_race(), tiny_race(sigma=0.2)], ValueError, "got two of generalist-generalist/seed-5"),
    ({"a": tiny_race(), "b": tiny_race()}, ValueError, "expected different runs, got a and b"),
    ({"a": tiny_race(), "a/b": tiny_race(seed=1)}, ValueError, "got a/b in a run"),
    *(
        ({name: tiny_race()}, ValueError, "expected names such as")
        for name in ("", ".", "..", "../a", "a/../b", "/a", "a/", "a/b/c", ".a", JOB, "a\n", "a@b")
    ),
]


@pytest.mark.parametrize(("settings", "kind", "message"), BAD, ids=range(len(BAD)))
def test_bad_jobs(settings, kind, message):
    with pytest.raises(kind, match=message):
        job_of(settings)


def test_a_thousand_seeds_take_little_more_than_one(tmp_path):
    save_job(tmp_path, job_of([tiny_race(seed=seed) for seed in range(1000)]))
    assert (tmp_path / JOB).stat().st_size < 60_000
    assert [each.seed for each in open_job(tmp_path).values()] == [*range(1000)]


def test_files_that_are_damaged_or_of_another_version(tmp_path):
    assert open_job(tmp_path) is None
    save_job(tmp_path, job_of([tiny_race()]))
    values = load_json(tmp_path / JOB)
    content = (tmp_path / JOB).read_text()
    (tmp_path / JOB).write_text(content.replace('"seed-5"', '"seed-6"').replace(": 5", ": 6"))
    with pytest.raises(DamagedFileError, match=r"job\.json: altered"):
        open_job(tmp_path)
    [group] = values["groups"]
    expected = "expected settings of matrixworld"
    for change, message in (
        ({"format": 9}, "expected format 1, got 9"),
        ({"groups": []}, expected),
        ({"groups": [{"settings": {}}]}, expected),
        ({"groups": [{**group, "seeds": 3}]}, expected),
        ({"groups": [{**group, "seeds": {"../../elsewhere": 5}}]}, "expected names such as"),
    ):
        save_json(tmp_path / JOB, {**values, **change})
        with pytest.raises(OtherVersionError, match=message):
            open_job(tmp_path)
