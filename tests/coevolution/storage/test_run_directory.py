"""Run directories: stages, checkpoints, locks, and readers beside a writer."""

from __future__ import annotations

import itertools
import multiprocessing
import shutil
import sys
import time
import warnings
from pathlib import Path

import numpy as np
import pytest

from matrixworld.coevolution import (
    DamagedFileError,
    RunDirectory,
    open_run,
    start,
)
from matrixworld.coevolution.storage import COLUMNS
from tiny_race import tiny_race, tiny_single

SETTINGS = {
    "race": tiny_race(),
    "hall-of-fame": tiny_race(schedule="hall-of-fame", contemporaries=1, hall_sample=1),
    "single": tiny_single(team="evader", learner="ga"),
}


def row(epoch):
    values = {int: epoch, float: epoch / 3, str: "evader"}
    return {name: values[kind] for name, kind in COLUMNS.items()}


def archive(generations):
    """One genome of five genes per generation, all equal to the generation."""
    genomes = np.repeat(np.arange(generations, dtype=np.float32)[:, None], 5, axis=1)
    return {"pursuer": genomes, "evader": -genomes}


def save(files_of_run, stage):
    """Save a stage with one generation and one row of the log."""
    rows = [row(stage - 1)] if stage else []
    files_of_run.save(stage, archive(1 + stage), rows, {"matches": stage}, {"state": [stage]})


def new_run(path):
    made = RunDirectory.create(path, {"seed": 1})
    save(made, 0)
    made.write_config()
    return made


@pytest.fixture
def run(tmp_path):
    """A directory with three stages: the untrained generation and two more."""
    made = new_run(tmp_path / "run")
    save(made, 1)
    save(made, 2)
    return made


def cut(path):
    path.write_bytes(path.read_bytes()[:-10])


def alter(path):
    content = bytearray(path.read_bytes())
    content[-10] ^= 1
    path.write_bytes(bytes(content))


def test_stages_come_back(run):
    restored = RunDirectory.open(run.path).restore()
    assert [int(stage["matches"]) for stage in restored.stages] == [0, 1, 2]
    assert restored.state["state"].tolist() == [2]
    assert np.array_equal(restored.archive["pursuer"], archive(3)["pursuer"])
    assert np.array_equal(run.archive()["evader"], archive(3)["evader"])
    assert run.log()["epoch"].tolist() == [0, 1]
    assert run.log()["stage"].tolist() == [1, 2]
    assert run.log()["fitness_best"] == pytest.approx([0.0, 1 / 3])


@pytest.mark.parametrize("damage", [cut, alter])
@pytest.mark.parametrize("name", ["stage-0002.npz", "checkpoint-0002.npz"])
def test_the_stage_before_is_used_if_the_newest_one_is_damaged(run, name, damage):
    damage(run.path / name)
    reopened = RunDirectory.open(run.path)
    with pytest.warns(UserWarning, match=f"{name}: (cut|altered).*; continuing from the stage"):
        restored = reopened.restore()
    assert restored.state["state"].tolist() == [1]
    assert len(restored.archive["evader"]) == 2
    save(reopened, 2)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert len(RunDirectory.open(run.path).restore().stages) == 3
    assert len(run.archive()["evader"]) == 3
    assert (run.path / f"{name}.damaged").exists()
    damage(run.path / "checkpoint-0002.npz")
    cut(run.path / "checkpoint-0001.npz")
    with pytest.raises(DamagedFileError, match=r"checkpoint-0002.npz: .*checkpoint-0001.npz: cut"):
        RunDirectory.open(run.path).restore()


def test_a_stage_costs_the_same_in_every_generation(tmp_path):
    """A stage writes two files of the same size, removes one, and touches no other."""
    run = new_run(tmp_path / "run")
    sizes = []
    for stage in range(1, 60):
        before = {path: path.stat() for path in run.path.iterdir()}
        save(run, stage)
        after = {path: path.stat() for path in run.path.iterdir()}
        changed = [path for path in after if after[path] != before.get(path)]
        assert {path.name.split("-")[0] for path in changed} == {"stage", "checkpoint"}
        assert len(changed) == 2
        assert len(before.keys() - after.keys()) == (stage > 1)
        sizes.append(sum(path.stat().st_size for path in changed))
    assert max(sizes) - min(sizes) < 100  # numbers in the log have one digit or more


def test_temporary_files_and_old_checkpoints_of_killed_writers_are_removed(run):
    shutil.copy(run.path / "checkpoint-0001.npz", run.path / "checkpoint-0000.npz")
    (run.path / ".123.tmp").write_bytes(b"half")
    run.restore()
    names = {path.name for path in run.path.glob("*")}
    assert "checkpoint-0000.npz" not in names
    assert ".123.tmp" not in names


# Files of several moments beside each other:


@pytest.fixture(scope="module", params=SETTINGS)
def life(request, tmp_path_factory):
    """Copies of a run: before its first stage, after each stage, and finished."""
    parent = tmp_path_factory.mktemp(request.param)
    run = start(SETTINGS[request.param], parent / "run", threads=1)
    copies = [Path(shutil.copytree(parent / "run", parent / "0"))]
    save_stage = run.files.save

    def save_and_copy(*args):
        save_stage(*args)
        copies.append(Path(shutil.copytree(parent / "run", parent / str(len(copies)))))

    run.files.save = save_and_copy
    run.run()
    return [*copies, parent / "run"]


def seen(directory):
    """Return what readers see of a run: its genomes and its log."""
    run = open_run(directory)
    log = {name: column.tolist() for name, column in run.files.log().items()}
    return {team: each.tolist() for team, each in run.files.archive().items()}, log


def test_the_copies_at_the_end_hold_what_the_stages_hold(life):
    *_, before, finished = life
    assert seen(before) == seen(finished)
    for team, genomes in open_run(finished).files.archive().items():
        if len(genomes):
            assert np.array_equal(np.load(finished / f"{team}s.npy"), genomes)
        else:
            assert not (finished / f"{team}s.npy").exists()
    header, *rows = (finished / "log.csv").read_text().splitlines()
    assert header == ",".join(COLUMNS)
    assert len(rows) == len(seen(finished)[1]["epoch"])


@pytest.mark.parametrize("count", [1, 2])
def test_a_partial_copy_is_refused_or_a_whole_moment(life, tmp_path, count):
    moments = [seen(copy) for copy in life]
    for copy in life:
        names = [path.name for path in copy.glob("*-*.npz")]
        for missing in itertools.combinations(names, min(count, len(names))):
            partial = Path(shutil.copytree(copy, tmp_path / "partial"))
            for name in missing:
                (partial / name).unlink()
            try:
                assert seen(partial) in moments
            except DamagedFileError as error:
                assert error.path.name in missing  # noqa: PT017, others are not refused
            shutil.rmtree(partial)


def save_all_the_time(path, made):
    run = new_run(path)
    made.set()
    for stage in itertools.count(1):
        time.sleep(0.02)  # so that the reader is faster than the run grows
        save(run, stage)


@pytest.mark.skipif(sys.platform == "win32", reason="Windows does not replace open files")
def test_a_reader_beside_a_writer_never_fails(tmp_path):
    context = multiprocessing.get_context("spawn")
    made = context.Event()
    writer = context.Process(target=save_all_the_time, args=(tmp_path / "run", made), daemon=True)
    writer.start()
    assert made.wait(60)
    generations = 0
    try:
        until = time.monotonic() + 60
        while generations < 20 and time.monotonic() < until:
            run = RunDirectory.open(tmp_path / "run")
            found, log = run.archive(), run.log()
            assert np.array_equal(found["pursuer"], archive(len(found["pursuer"]))["pursuer"])
            assert len(found["pursuer"]) == len(found["evader"]) >= generations
            generations = len(found["pursuer"])
            assert log["epoch"].tolist() == list(range(len(log["epoch"])))
            assert len(log["epoch"]) >= generations - 1
    finally:
        writer.kill()
        writer.join()
    assert generations >= 20
