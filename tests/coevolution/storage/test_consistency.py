"""Files of several moments of a run beside each other: refused by readers, repaired by resuming."""

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

from command_line import matrixworld_command
from matrixworld._util.reading import read_npz
from matrixworld.coevolution import (
    DamagedFileError,
    HallOfFameRace,
    Race,
    RunDirectory,
    SingleTeam,
    open_run,
    resume,
)
from matrixworld.coevolution.storage import consistency
from matrixworld.coevolution.storage.genome_file import HEAD
from matrixworld.coevolution.storage.run_log import COLUMNS
from tiny_race import GENOMES, RESULTS, StopAt, directory_in_memory, results, tiny_race, tiny_single

CHECKPOINTS = ("checkpoint.npz", "checkpoint.previous.npz")
GROWN = ("log.csv", *GENOMES)
FILES = (*CHECKPOINTS, *GROWN)
ALL_OF_A_MOMENT = {"checkpoint.npz", *GROWN}
KINDS = {
    "race": (Race, tiny_race()),
    "hall-of-fame": (
        HallOfFameRace,
        tiny_race(schedule="hall-of-fame", contemporaries=1, hall_sample=1),
    ),
    "single": (SingleTeam, tiny_single(team="evader", learner="ga")),
}


@pytest.fixture
def place():
    """A directory for many files, which are all synced."""
    with directory_in_memory() as directory:
        yield directory


@pytest.fixture(scope="module", params=list(KINDS))
def life(request, tmp_path_factory):
    """Copies of a run: before its first stage, after each stage, and finished."""
    parent = tmp_path_factory.mktemp(request.param)
    kind, settings = KINDS[request.param]
    run = kind(settings, parent / "run", threads=1)
    copies = [shutil.copytree(parent / "run", parent / "0")]
    save = run.files.save

    def save_and_copy(*args):
        save(*args)
        copies.append(shutil.copytree(parent / "run", parent / str(len(copies))))

    run.files.save = save_and_copy
    run.run()
    return [*copies, parent / "run"]


def mixture(new, old, names, place):
    """Return a copy of a run in which some files are those of an earlier copy."""
    directory = Path(shutil.copytree(new, place / "run", dirs_exist_ok=True))
    for name in names:
        (directory / name).unlink(missing_ok=True)
        if (old / name).exists():
            shutil.copy(old / name, directory / name)
    return directory


def seen(directory):
    """Return what readers see of a run: its genomes and its log."""
    run = open_run(directory)
    log = {name: column.tolist() for name, column in run.files.log().items()}
    genomes = {team: run.files.archive()[team].tolist() for team in ("pursuer", "evader")}
    return genomes, log


def test_every_moment_is_readable(life):
    lengths = [len(seen(copy)[1]["epoch"]) for copy in life[1:]]
    assert lengths == sorted(lengths)
    assert lengths[-1] == lengths[-2]


@pytest.mark.parametrize("count", [1, 2, 3, 4])
def test_a_partial_copy_is_refused_or_complete(life, place, count):
    """Readers see what they see of the old copy or of the new one, or raise an error."""
    refused = 0
    for (i, old), (j, new) in itertools.combinations(list(enumerate(life))[1:], 2):
        wholes = [seen(old), seen(new)]
        for names in itertools.combinations(FILES, count):
            directory = mixture(new, old, names, place)
            try:
                found = seen(directory)
            except (DamagedFileError, FileNotFoundError):
                refused += 1
            else:
                # A process may have been killed between neighbours. All of a moment are the old
                # run; a team that a script plays has no file.
                moment = {name for name in ALL_OF_A_MOMENT if (old / name).exists()}
                is_old = found == wholes[0] and (j == i + 1 or set(names) >= moment)
                assert found == wholes[1] or is_old, names
            shutil.rmtree(directory)
    assert refused


@pytest.mark.parametrize(
    ("names", "message"),
    [
        (["pursuers.npy"], r"pursuers\.npy: cut or older than the checkpoint: expected \d+ bytes"),
        (["evaders.npy"], r"evaders\.npy: cut or older than the checkpoint: expected \d+ bytes"),
        (["checkpoint.npz"], r"checkpoint\.npz: older than summary\.json, expected stage 4, got 2"),
        (["log.csv"], r"log\.csv: cut or older than the checkpoint: expected \d+ bytes, got \d+"),
    ],
)
def test_the_older_file_of_a_finished_run_is_named(names, message, place):
    finished, old = race_and_copy(place)
    directory = mixture(finished, old, names, place)
    with pytest.raises(DamagedFileError, match=message):
        seen(directory)
    said = matrixworld_command("plot", directory, code=1).stderr
    assert "older than" in said
    assert len(said.strip().splitlines()) == 1


@pytest.mark.parametrize(
    ("names", "message"),
    [
        (["pursuers.npy"], r"pursuers\.npy: cut or older than the checkpoint: expected \d+ bytes"),
        (["evaders.npy"], r"evaders\.npy: cut or older than the checkpoint: expected \d+ bytes"),
        (
            ["checkpoint.npz"],
            r"checkpoint\.npz: older than log\.csv, expected no rows after stage 3",
        ),
        (
            [*GENOMES, "checkpoint.npz"],
            r"checkpoint\.npz: older than log\.csv, expected no rows after stage 3",
        ),
        (
            ["log.csv", "checkpoint.npz"],
            r"checkpoint\.npz: older than pursuers\.npy, expected a file of \d+ bytes, got \d+",
        ),
        (["log.csv"], r"log\.csv: cut or older than the checkpoint: expected \d+ bytes, got \d+"),
    ],
)
def test_the_older_file_of_a_run_that_trains_is_named(names, message, place):
    finished, old = race_and_copy(place)
    directory = mixture(finished, old, names, place)
    for name in ("summary.json", "payoff.npz"):
        (directory / name).unlink()
    with pytest.raises(DamagedFileError, match=message):
        seen(directory)


def race_and_copy(place):
    """Return a finished race of four stages, and a copy after its second one."""
    race = Race(tiny_race(), place / "finished", threads=1, play=StopAt(5))
    with pytest.raises(KeyboardInterrupt):
        race.run()
    old = Path(shutil.copytree(place / "finished", place / "old"))
    resume(place / "finished", threads=1).run()
    return place / "finished", old


@pytest.mark.filterwarnings("ignore::UserWarning")
@pytest.mark.parametrize(
    "names", [*itertools.combinations(FILES, 1), CHECKPOINTS, GROWN, ("log.csv", *CHECKPOINTS)]
)
def test_resuming_repairs_mixtures(life, place, names):
    """Readers accept the directory as soon as it is restored, and again when it is finished."""
    finished = life[-1]
    checkpoints = [CheckpointOf(finished / name) for name in reversed(CHECKPOINTS)]
    for old in life[1:-1]:
        directory = mixture(finished, old, names, place)
        for name in ("summary.json", "payoff.npz"):
            (directory / name).unlink()
        # Neither checkpoint fits to a file that is older than both.
        if not set(names) & set(CHECKPOINTS) and not any(
            each.fits(old, names) for each in checkpoints
        ):
            with pytest.raises(DamagedFileError, match="older than the checkpoint"):
                resume(directory)
        else:
            run = resume(directory, threads=1)
            seen(directory)
            run.run()
            assert results(directory) == results(finished)
            seen(directory)
        shutil.rmtree(directory)


class CheckpointOf:
    """What a checkpoint counts of the files that grow."""

    def __init__(self, path):
        state = read_npz(path)
        bytes_of = {name: 4 * int(np.prod(state[name[:-4]])) for name in GENOMES}
        # A team that a script plays has no file.
        sizes = {name: HEAD + size if size else 0 for name, size in bytes_of.items()}
        self.sizes = {**sizes, "log.csv": int(state["log_length"])}

    def fits(self, copy, names):
        """Return whether the files of a copy are long enough."""
        found = [(copy / name).stat().st_size if (copy / name).exists() else 0 for name in names]
        return all(size >= self.sizes[name] for name, size in zip(names, found, strict=True))


def test_a_mixture_is_reported_when_the_run_is_resumed(place):
    """Files of the moment before: the previous checkpoint fits."""
    race = Race(tiny_race(), place / "run", threads=1, play=StopAt(5))
    with pytest.raises(KeyboardInterrupt):
        race.run()
    old = Path(shutil.copytree(place / "run", place / "old"))
    race = resume(place / "run", threads=1, play=StopAt(2))
    with pytest.raises(KeyboardInterrupt):
        race.run()
    directory = mixture(place / "run", old, ["pursuers.npy"], place / "mixed")
    with pytest.warns(UserWarning, match=r"pursuers\.npy: cut or older .*; continuing from the"):
        resume(directory, threads=1)
    seen(directory)


def test_what_follows_the_checkpoint_must_be_one_stage(place):
    """Genomes beyond the checkpoint are legal only behind rows of the next stage."""
    run = RunDirectory.create(place / "run", "race", {"seed": 1})
    run.save(archive(1), [], {"stage": 0})
    run.write_config()
    kept = {path: path.read_bytes() for path in run.path.iterdir()}
    run.save(archive(2), [row(0)], {"stage": 1})
    log, genomes = run.path / "log.csv", run.path / "pursuers.npy"
    (run.path / "checkpoint.npz").write_bytes(kept[run.path / "checkpoint.npz"])
    rows, whole = log.read_bytes(), genomes.read_bytes()
    for cut in range(len(rows) + 1):
        log.write_bytes(rows[:cut])
        complete = cut > rows.index(b"\n") + 1
        if complete:
            assert len(run.archive()["pursuer"]) == 1
        else:
            with pytest.raises(DamagedFileError, match=r"checkpoint\.npz: older than pursuers"):
                run.archive()
    for cut in range(len(whole)):
        genomes.write_bytes(whole[:cut])
        if cut < len(kept[genomes]):
            with pytest.raises(DamagedFileError, match=r"pursuers\.npy: cut or older than the ch"):
                run.archive()
        else:
            assert len(run.archive()["pursuer"]) == 1
    for more, blamed in {
        rows + rows.splitlines()[1].replace(b"1,", b"2,", 1): "older than log",
        rows + b"x": "older than log",
    }.items():
        log.write_bytes(more)
        with pytest.raises(DamagedFileError, match=blamed):
            run.archive()


# A reader beside a writer:


def row(epoch):
    values = {int: epoch, float: epoch / 3, str: "evader"}
    return {name: values[kind] for name, kind in COLUMNS.items()}


def archive(generations):
    """One genome of five genes per generation, all equal to the generation."""
    genomes = np.repeat(np.arange(generations, dtype=np.float32)[:, None], 5, axis=1)
    return {"pursuer": genomes, "evader": -genomes}


def save_all_the_time(path, made):
    run = RunDirectory.create(path, "race", {"seed": 1})
    run.save(archive(1), [], {"stage": 0})
    run.write_config()
    made.set()
    for stage in itertools.count(1):
        time.sleep(0.001)  # longer runs would take longer to read
        run.save(archive(1 + stage), [row(stage)], {"stage": stage})


@pytest.mark.skipif(sys.platform == "win32", reason="Windows does not replace open files")
def test_a_reader_beside_a_writer_never_fails(place):
    context = multiprocessing.get_context("spawn")
    made = context.Event()
    writer = context.Process(target=save_all_the_time, args=(place / "run", made), daemon=True)
    writer.start()
    assert made.wait(60)
    generations = 0
    try:
        for _ in range(60):
            files = RunDirectory.open(place / "run")
            found, log = files.archive(), files.log()
            assert np.array_equal(found["pursuer"], archive(len(found["pursuer"]))["pursuer"])
            assert len(found["pursuer"]) >= generations
            generations = len(found["pursuer"])
            assert len(log["epoch"]) >= generations - 1
    finally:
        writer.kill()
        writer.join()
    assert generations > 1


def test_errors_of_a_directory_that_nobody_changes_are_raised_at_once(place):
    (place / "x").touch()
    calls = []

    def read():
        calls.append(1)
        raise DamagedFileError(place / "x", "damaged")

    with pytest.raises(DamagedFileError):
        consistency.steady(read, [place / "x", place / "missing"])
    assert len(calls) == 1


def test_reads_are_repeated_a_limited_number_of_times(place):
    def read():
        (place / "x").write_bytes((place / "x").read_bytes() + b".")
        raise DamagedFileError(place / "x", "damaged")

    (place / "x").touch()
    with pytest.raises(DamagedFileError):
        consistency.steady(read, [place / "x"])
    assert (place / "x").stat().st_size == consistency.TRIES + 1


def test_reading_a_mixture_changes_nothing(place):
    finished, old = race_and_copy(place)
    directory = mixture(finished, old, ["pursuers.npy"], place)
    before = {path: path.read_bytes() for path in directory.iterdir()}
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(DamagedFileError):
            seen(directory)
    assert {path: path.read_bytes() for path in directory.iterdir()} == before
    assert set(RESULTS) <= {path.name for path in before}
