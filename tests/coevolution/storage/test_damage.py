"""Damaged run directories: reported in one line or repaired, never a wrong result."""

from __future__ import annotations

import os
import shutil
from pathlib import Path

import pytest

from command_line import MAIN_JOB, PLACES, RACE, matrixworld_command, words
from matrixworld._util import files
from matrixworld.cli import report
from matrixworld.cli.console import INTERRUPTED
from matrixworld.coevolution import (
    OtherVersionError,
    Race,
    RunDirectory,
    open_run,
    resume,
)
from tiny_race import StopAt, results, tiny_race

FILES = {
    "straight": (
        ".lock", "config.json", "stage-0000.npz", "stage-0003.npz", "stage-0004.npz",
        "checkpoint-0003.npz", "checkpoint-0004.npz", "payoff.npz", "summary.json",
    ),
    "stopped": (
        ".lock", "config.json", "stage-0000.npz", "stage-0001.npz", "stage-0002.npz",
        "checkpoint-0001.npz", "checkpoint-0002.npz",
    ),
}  # fmt: skip
"""Files of a finished run, and of a run that was stopped in its third stage."""
OF_EITHER = [(run, name) for run, names in FILES.items() for name in names]
PREVIOUS = ("checkpoint-0003.npz", "checkpoint-0001.npz")
"""The state before the newest one: it is needed only if the newest one is damaged."""


@pytest.fixture(autouse=True)
def no_figures(monkeypatch):
    """Leave out the figures, which are not tested here."""
    monkeypatch.setattr(report, "draw", lambda planned: None)


@pytest.fixture(scope="module")
def straight(tmp_path_factory):
    """A finished race."""
    directory = tmp_path_factory.mktemp("straight") / "run"
    Race(tiny_race(), directory, threads=1).run()
    return directory


@pytest.fixture(scope="module")
def stopped(tmp_path_factory):
    """The same race, stopped in its second to last team phase."""
    directory = tmp_path_factory.mktemp("stopped") / "run"
    race = Race(tiny_race(), directory, threads=1, play=StopAt(6))
    with pytest.raises(KeyboardInterrupt):
        race.run()
    return directory


@pytest.fixture(scope="module")
def foreign(tmp_path_factory):
    """A finished race of another seed."""
    directory = tmp_path_factory.mktemp("foreign") / "run"
    Race(tiny_race(seed=6), directory, threads=1).run()
    return directory


@pytest.fixture(params=["straight", "stopped"])
def copy(request, tmp_path):
    """A copy of the finished or of the stopped race, to be damaged."""
    return Path(shutil.copytree(request.getfixturevalue(request.param), tmp_path / "run"))


def resumed(directory):
    """Resume by the command line; return exit code and output."""
    try:
        return 0, matrixworld_command("evolve", "--resume", directory).output
    except AssertionError:  # of the exit code
        return 1, matrixworld_command("evolve", "--resume", directory, code=1).stderr


def check_reported_or_repaired(directory, name, straight):
    """After damage to a file, expect the true result or an error that names the file."""
    code, said = resumed(directory)
    if code == 0:
        found, expected = results(directory), results(straight)
        if name in PREVIOUS:
            found.pop(name, None)
            expected.pop(name, None)
        assert found == expected
    else:
        assert "Error: " in said
        assert f"{directory}/{name}: " in said
    return code


# That every cut and every altered byte is found, the tests of sealed files show.
@pytest.mark.filterwarnings("ignore::UserWarning")  # of damage, which are part of the output
@pytest.mark.parametrize("damage", ["half", "deleted", "of another run", "of another name"])
@pytest.mark.parametrize(("copy", "name"), OF_EITHER, indirect=["copy"])
def test_damage_is_repaired_or_reported(copy, straight, foreign, name, damage):
    others = [path for path in copy.glob(f"{name[:5]}*.npz") if path.name != name]
    # Intact files of the right form: of the other run there are only the newest checkpoints.
    intact = {
        "of another run": foreign / name.replace("-0001", "-0003").replace("-0002", "-0004"),
        "of another name": others[0] if others else copy / "stage-0001.npz",
    }
    if damage == "deleted":
        (copy / name).unlink()
    elif damage in intact:
        shutil.copy(intact[damage], copy / name)
    else:
        whole = (copy / name).read_bytes()
        (copy / name).write_bytes(whole[: len(whole) // 2])
    if name != "config.json":
        code = check_reported_or_repaired(copy, name, straight)
        # A stage can be played again if the one before it has its checkpoint.
        if name.startswith("stage"):
            assert code == (name in ("stage-0000.npz", "stage-0001.npz", "stage-0003.npz"))
        assert code == 0 or name != ".lock"
    elif damage == "deleted":
        matrixworld_command("evolve", "--resume", copy, code=2)
        again = matrixworld_command("evolve", "--out", copy, "--schedule", MAIN_JOB[0], code=2)
        assert "expected a new or empty directory" in again.stderr
    else:
        # The other files do not belong to the settings of another run.
        blamed = "stage-0000.npz" if damage == "of another run" else name
        check_reported_or_repaired(copy, blamed, straight)


def rewritten(directory, change):
    """Change config.json as another version would have written it, with a correct checksum."""
    config = files.load_json(directory / "config.json")
    change(config)
    files.save_json(directory / "config.json", config)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda config: config.update(format=99, matrixworld="9.9"), r"written by matrixworld 9.9"),
        (lambda config: config.pop("format"), r"expected format 9, got None"),
        (lambda config: config["settings"].pop("seed"), "seed: expected a value, got none"),
        (lambda config: config["settings"].update(speed=1), "speed: expected one of the settings"),
        (lambda config: config["settings"]["world"].update(rows="many"), "rows"),
    ],
)
def test_another_version_s_files(copy, change, message):
    before = {path: path.read_bytes() for path in copy.iterdir() if path.name != "config.json"}
    rewritten(copy, change)
    for read in (resume, open_run):
        with pytest.raises(OtherVersionError, match=message):
            read(copy)
    for command in (["evolve", "--resume"], ["replay"], ["tournament"]):
        result = matrixworld_command(*command, copy, code=1)
        assert "Error: " in result.stderr
        assert "config.json" in result.stderr
    assert all(path.read_bytes() == content for path, content in before.items())


# Directories that are incomplete or cannot be written to:


@pytest.mark.parametrize("left_over", ["notes.txt", "log.csv", "stage-0001.npz"])
def test_other_files_are_not_replaced(straight, tmp_path, left_over):
    directory = tmp_path / "run"
    directory.mkdir()
    for name in (".lock", "stage-0000.npz", left_over):
        (directory / name).write_bytes(b"mine")
    with pytest.raises(FileExistsError, match=f"found {left_over}"):
        Race(tiny_race(), directory)
    (directory / left_over).unlink()
    (directory / ".lock").unlink()  # without it, the file may be the user's own
    with pytest.raises(FileExistsError, match=r"found stage-0000\.npz"):
        Race(tiny_race(), directory)
    assert (directory / "stage-0000.npz").read_bytes() == b"mine"


def test_a_command_stopped_while_it_makes_a_run_can_be_repeated(straight, tmp_path, monkeypatch):
    directory = tmp_path / "run"
    command = ["evolve", "--out", directory, *words(RACE), "--schedule", MAIN_JOB[-1]]
    with monkeypatch.context() as patch:
        patch.setattr(RunDirectory, "write_config", interrupted)
        matrixworld_command(*command, code=INTERRUPTED)
    run = directory / PLACES[-1]
    assert not (run / "config.json").exists()
    assert "that holds a run" in matrixworld_command("evolve", "--resume", run, code=2).stderr
    matrixworld_command("evolve", "--resume", directory)
    assert results(run) == results(straight)


def interrupted(*args, **options):
    raise KeyboardInterrupt


def test_a_full_disk_is_reported_with_the_next_command(stopped, straight, tmp_path, monkeypatch):
    copy = Path(shutil.copytree(stopped, tmp_path / "run"))

    def full(handle):
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr(os, "fsync", full)
        said = matrixworld_command("evolve", "--resume", copy, code=1).stderr
    assert f"Error: [Errno 28] No space left on device: '{copy}" in said
    assert f"matrixworld evolve --resume {copy}\n" in said
    matrixworld_command("evolve", "--resume", copy)
    assert results(copy) == results(straight)
