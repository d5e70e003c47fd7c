"""Run directories: checkpoints, the log, locks, and files that are damaged."""

from __future__ import annotations

import hashlib
import os
import shutil
import warnings

import numpy as np
import pytest

from matrixworld._util import files
from matrixworld.coevolution import (
    DamagedFileError,
    LockedError,
    OtherVersionError,
    RunDirectory,
)
from matrixworld.coevolution.storage.appended_file import Position
from matrixworld.coevolution.storage.genome_file import HEAD
from matrixworld.coevolution.storage.run_log import COLUMNS, RunLog, read_log
from tiny_race import GENOMES


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
    path.write_bytes(path.read_bytes()[:-10])


def alter(path):
    content = bytearray(path.read_bytes())
    content[-10] ^= 1
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
    expected = r"expected format 8, got 99 \(written by matrixworld 9.1"
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
@pytest.mark.parametrize("name", ["checkpoint.npz", "pursuers.npy", "evaders.npy", "log.csv"])
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


def test_an_error_is_raised_if_both_checkpoints_are_damaged(run):
    cut(run.path / "checkpoint.npz")
    alter(run.path / "checkpoint.previous.npz")
    with pytest.raises(DamagedFileError, match=r"checkpoint.npz: cut.*checkpoint.previous.npz"):
        RunDirectory.open(run.path).restore()


@pytest.mark.parametrize("name", GENOMES)
def test_an_error_is_raised_if_an_early_genome_is_damaged(run, name):
    """There is one copy of it: neither checkpoint fits."""
    content = bytearray((run.path / name).read_bytes())
    content[HEAD] ^= 1
    (run.path / name).write_bytes(bytes(content))
    with pytest.raises(DamagedFileError, match=f"{name}: altered"):
        RunDirectory.open(run.path).restore()
    assert (run.path / name).read_bytes() == content


@pytest.mark.parametrize("name", ["pursuers.npy", "evaders.npy", "log.csv", "checkpoint.npz"])
def test_readers_refuse_altered_bytes_and_other_lengths(run, name):
    """Every byte and every length of genomes, some of the other files."""
    path, step = run.path / name, 1 if name in GENOMES else 11
    whole = path.read_bytes()

    def refused(content):
        path.write_bytes(content)
        with pytest.raises(DamagedFileError, match=r"\.(npy|csv|npz): "):
            run.archive(), run.log()

    for place in range(0, len(whole), step):
        refused(whole[:place] + bytes([whole[place] ^ (1 << place % 8)]) + whole[place + 1 :])
        refused(whole[:place])
    for more in (b"\0", b"2", b"4,", whole):
        refused(whole + more)
    path.write_bytes(whole)
    assert len(run.archive()["evader"]) == 3


@pytest.mark.parametrize("name", GENOMES)
def test_numpy_reads_the_genomes(run, name):
    sign = 1 if name == "pursuers.npy" else -1
    expected = archive(3)["pursuer"] * sign
    assert np.array_equal(np.load(run.path / name), expected)
    assert np.array_equal(np.load(run.path / name, mmap_mode="r"), expected)
    plain = run.path / "plain.npy"
    np.save(plain, expected)
    assert plain.read_bytes() == (run.path / name).read_bytes()


def test_a_team_that_a_script_plays_has_no_file(tmp_path):
    run = RunDirectory.create(tmp_path / "run", "single", {"seed": 1})
    run.save({"pursuer": archive(1)["pursuer"], "evader": []}, [], {"stage": 0})
    run.write_config()
    assert run.archive()["evader"].shape == (0, 0)
    assert not (run.path / "evaders.npy").exists()
    shutil.copy(run.path / "pursuers.npy", run.path / "evaders.npy")
    with pytest.raises(DamagedFileError, match=r"older than evaders\.npy"):
        run.archive()


def test_damaged_genomes_are_not_shown_to_readers(run):
    alter(run.path / "pursuers.npy")
    with pytest.raises(DamagedFileError, match=r"pursuers\.npy: altered or from another run"):
        run.archive()


def test_a_save_costs_the_same_in_every_generation(tmp_path):
    """Only new genomes are written, not those that are there."""
    run = RunDirectory.create(tmp_path / "run", "race", {"seed": 1})
    run.save(archive(1), [], {"stage": 0})
    run.write_config()
    sizes, tails = [], []
    for stage in range(1, 100):
        before = (run.path / "pursuers.npy").read_bytes()
        run.save(archive(1 + stage), [row(stage)], {"stage": stage})
        after = (run.path / "pursuers.npy").read_bytes()
        assert after[HEAD : len(before)] == before[HEAD:]
        tails.append(len(after) - len(before))
        files_of = run.path.glob("*.npz")
        sizes.append(max(path.stat().st_size for path in files_of))
    assert set(tails) == {4 * 5}
    assert len(set(sizes[1:])) == 1


@pytest.mark.parametrize("renames", range(1, 3))
def test_kill_between_two_renames(run, monkeypatch, renames):
    """A save consists of two renames; after any of them there is an intact checkpoint."""
    replace, left = os.replace, [renames]

    def killed(source, target):
        if not left[0]:
            raise KeyboardInterrupt
        left[0] -= 1
        replace(source, target)

    monkeypatch.setattr(os, "replace", killed)
    if renames < 2:
        with pytest.raises(KeyboardInterrupt):
            run.save(archive(4), [row(2)], {"stage": 3})
    else:
        run.save(archive(4), [row(2)], {"stage": 3})
    monkeypatch.setattr(os, "replace", replace)
    assert len(run.archive()["pursuer"]) == (4 if renames == 2 else 3)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        saved = RunDirectory.open(run.path).restore()
    stage = int(saved.state["stage"])
    assert stage == (3 if renames == 2 else 2)
    assert len(saved.archive["pursuer"]) == stage + 1
    assert len(run.log()["epoch"]) == stage


def test_temporary_files_of_killed_writers_are_removed(run):
    left = run.path / ".checkpoint.npz.123.tmp"
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
    position = log.position
    log.append([row(2)])
    again = RunLog(tmp_path / "log.csv")
    again.truncate(position)
    assert read_log(tmp_path / "log.csv", position)["epoch"].tolist() == [0, 1]
    again.append([row(2)])
    assert again.position == log.position


def test_a_file_that_is_not_a_log_is_refused(tmp_path):
    path = tmp_path / "log.csv"
    content = b"generation,team\n1,evader\n"
    path.write_bytes(content)
    with pytest.raises(DamagedFileError, match=r"log\.csv: altered, cannot be read as a log"):
        read_log(path, Position(len(content), hashlib.sha256(content).hexdigest()))
