"""Run directories: checkpoints, the log, locks, and files that are damaged."""

from __future__ import annotations

import hashlib
import os
import warnings

import numpy as np
import pytest

from matrixworld import files
from matrixworld.coevolution import (
    DamagedFileError,
    LockedError,
    OtherVersionError,
    RunDirectory,
)
from matrixworld.coevolution.storage.run_log import COLUMNS, RunLog, read_log


def row(epoch):
    values = {int: epoch, float: epoch / 3, str: "evader"}
    return {name: values[kind] for name, kind in COLUMNS.items()}


def archive(generations):
    """One genome of five genes per generation, all equal to the generation."""
    genomes = np.repeat(np.arange(generations, dtype=np.float32)[:, None], 5, axis=1)
    return {"pursuer": genomes, "evader": -genomes}


@pytest.fixture
def run(tmp_path):
    """A directory with two checkpoints: two generations, then three, one row of the log each."""
    made = RunDirectory.create(tmp_path / "run", "race", {"seed": 1})
    made.save(archive(1), [], {"stage": 0})
    made.write_config()
    made.save(archive(2), [row(0)], {"stage": 1})
    made.save(archive(3), [row(1)], {"stage": 2})
    return made


def cut(path):
    path.write_bytes(path.read_bytes()[: path.stat().st_size * 2 // 3])


def alter(path):
    content = bytearray(path.read_bytes())
    content[-len(content) // 8] ^= 1
    path.write_bytes(bytes(content))


def test_new_run_wants_an_empty_directory(tmp_path):
    (tmp_path / "notes.txt").write_text("mine")
    with pytest.raises(FileExistsError, match=r"expected a new or empty directory.*notes.txt"):
        RunDirectory.create(tmp_path, "race", {})
    assert [item.name for item in tmp_path.iterdir()] == ["notes.txt"]


def test_directory_without_a_run_is_refused(tmp_path):
    with pytest.raises(FileNotFoundError, match=r"holds no run, expected a file config.json"):
        RunDirectory.open(tmp_path)


def test_other_format_is_refused(run):
    config = run.config()
    files.save_json(run.path / "config.json", {**config, "format": 99, "matrixworld": "9.1"})
    expected = r"expected format 6, got 99 \(written by matrixworld 9.1"
    with pytest.raises(OtherVersionError, match=expected):
        RunDirectory.open(run.path).config()


def test_checkpoint_comes_back(run):
    saved = RunDirectory.open(run.path).restore()
    assert int(saved.state["stage"]) == 2
    assert np.array_equal(saved.archive["pursuer"], archive(3)["pursuer"])
    assert np.array_equal(run.archive()["evader"], archive(3)["evader"])
    assert run.log()["epoch"].tolist() == [0, 1]
    assert run.log()["fitness_best"] == pytest.approx([0.0, 1 / 3])


@pytest.mark.parametrize("damage", [cut, alter])
@pytest.mark.parametrize("name", ["checkpoint.npz", "archive.npz", "log.csv"])
def test_the_checkpoint_before_is_used_if_a_file_is_damaged(run, name, damage):
    damage(run.path / name)
    reopened = RunDirectory.open(run.path)
    with pytest.warns(UserWarning, match=f"{name}: (cut|altered)"):
        saved = reopened.restore()
    assert int(saved.state["stage"]) == 1
    assert len(saved.archive["evader"]) == 2
    assert reopened.log()["epoch"].tolist() == [0]
    reopened.save(archive(3), [row(1)], {"stage": 2})
    assert int(RunDirectory.open(run.path).restore().state["stage"]) == 2


@pytest.mark.parametrize("name", ["checkpoint", "archive"])
def test_an_error_is_raised_if_both_checkpoints_are_damaged(run, name):
    cut(run.path / f"{name}.npz")
    alter(run.path / f"{name}.previous.npz")
    with pytest.raises(DamagedFileError, match=rf"{name}.npz: cut.*{name}.previous.npz"):
        RunDirectory.open(run.path).restore()


def test_damaged_archive_is_not_shown_to_readers(run):
    alter(run.path / "archive.npz")
    with pytest.raises(DamagedFileError, match=r"archive\.npz: "):
        run.archive()


@pytest.mark.parametrize("renames", range(1, 5))
def test_kill_between_two_renames(run, monkeypatch, renames):
    """A save consists of four renames; after any of them there is an intact checkpoint."""
    replace, left = os.replace, [renames]

    def killed(source, target):
        if not left[0]:
            raise KeyboardInterrupt
        left[0] -= 1
        replace(source, target)

    monkeypatch.setattr(os, "replace", killed)
    if renames < 4:
        with pytest.raises(KeyboardInterrupt):
            run.save(archive(4), [row(2)], {"stage": 3})
    else:
        run.save(archive(4), [row(2)], {"stage": 3})
    monkeypatch.setattr(os, "replace", replace)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        saved = RunDirectory.open(run.path).restore()
    stage = int(saved.state["stage"])
    assert stage == (3 if renames == 4 else 2)
    assert len(saved.archive["pursuer"]) == stage + 1
    assert len(run.log()["epoch"]) == stage


def test_temporary_files_of_killed_writers_are_removed(run):
    left = run.path / ".archive.npz.123.tmp"
    left.write_bytes(b"half")
    run.restore()
    assert not left.exists()


def test_one_writer_at_a_time(run):
    again = RunDirectory.open(run.path)
    with run.lock(), pytest.raises(LockedError, match="another process is running"), again.lock():
        pass
    with again.lock():
        assert run.config()["kind"] == "race"


def test_log_is_truncated_to_the_checkpoint(tmp_path):
    log = RunLog(tmp_path / "log.csv")
    log.append([row(0), row(1)])
    length, checksum = log.length, log.checksum
    log.append([row(2)])
    again = RunLog(tmp_path / "log.csv")
    again.truncate(length, checksum)
    assert read_log(tmp_path / "log.csv", length, checksum)["epoch"].tolist() == [0, 1]
    again.append([row(2)])
    assert (again.length, again.checksum) == (log.length, log.checksum)


def test_a_file_that_is_not_a_log_is_refused(tmp_path):
    path = tmp_path / "log.csv"
    content = b"generation,team\n1,evader\n"
    path.write_bytes(content)
    with pytest.raises(DamagedFileError, match=r"log\.csv: altered, cannot be read as a log"):
        read_log(path, len(content), hashlib.sha256(content).hexdigest())
