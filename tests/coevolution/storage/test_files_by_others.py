"""Files by others: every reader refuses them with one error, in little memory and time."""

from __future__ import annotations

import shutil
import signal
import sys
from pathlib import Path

import numpy as np
import pytest

import matrixworld as mw
from attacks import (
    JSON_ATTACKS,
    NOT_FILES,
    NPY_ATTACKS,
    NPZ_ATTACKS,
    forge,
    larger_than,
    little_memory,
    nested_with_checksum,
    npy,
    npz,
    random_npz,
    sealed,
)
from command_line import matrixworld_command
from matrixworld import analysis
from matrixworld._util import files
from matrixworld._util.reading import read_json, read_npz
from matrixworld.cli import report
from matrixworld.coevolution import (
    DamagedFileError,
    OtherVersionError,
    Race,
    RunDirectory,
    SingleTeam,
    last_generation,
    open_run,
    resume,
)
from tiny_race import GENOMES, directory_in_memory, tiny_race, tiny_single

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs FIFOs")

REFUSED = (DamagedFileError, OtherVersionError, FileNotFoundError)
"""Errors for files by others. A run without a regular config.json is no run: FileNotFoundError."""
SECONDS = 20


@pytest.fixture(autouse=True)
def in_time():
    """Fail instead of waiting for ever."""

    def late(number, frame):
        raise TimeoutError(f"expected an answer within {SECONDS} seconds")

    before = signal.signal(signal.SIGALRM, late)
    signal.alarm(SECONDS)
    yield
    signal.alarm(0)
    signal.signal(signal.SIGALRM, before)


@pytest.fixture(autouse=True)
def no_figures(monkeypatch):
    """Leave out the figures, which are not tested here."""
    monkeypatch.setattr(report, "draw_run", lambda path: [])


@pytest.fixture
def place():
    """A directory in memory."""
    with directory_in_memory() as directory:
        yield directory


@pytest.fixture(scope="module")
def race(tmp_path_factory):
    """A finished race."""
    directory = tmp_path_factory.mktemp("race") / "run"
    Race(tiny_race(), directory, threads=1).run()
    return directory


@pytest.fixture(scope="module")
def single(tmp_path_factory):
    """A finished run of one team."""
    directory = tmp_path_factory.mktemp("single") / "run"
    SingleTeam(tiny_single(team="evader"), directory, threads=1).run()
    return directory


@pytest.fixture
def copy(race, place):
    """A copy of the race."""
    return Path(shutil.copytree(race, place / "run"))


def refuse_in_one_line(*words):
    """Run a command, and expect a message of one line and exit code 1 or 2."""
    try:
        said = matrixworld_command(*words, code=1).stderr
    except AssertionError:
        said = matrixworld_command(*words, code=2).stderr
    lines = said.strip().splitlines()
    assert lines[-1].startswith("Error: ")
    assert len(lines[-1]) < 1500
    return lines[-1]


# Single files:

SINGLE_FILES = {
    "Episode.load": ("x.npz", mw.Episode.load, ["replay"]),
    "read_payoffs of npz": ("x.npz", analysis.read_payoffs, ["analyze"]),
    "read_payoffs of csv": ("x.csv", analysis.read_payoffs, ["diagnose"]),
    "read_map": ("x.map", mw.read_map, None),
    "read_npz": ("x.npz", read_npz, None),
    "read_json": ("x.json", read_json, None),
}
ATTACKS_ON = {".npz": NPZ_ATTACKS, ".npy": NPY_ATTACKS, ".json": JSON_ATTACKS}
LARGE = {".csv": larger_than("CSV"), ".map": larger_than("map")}


def attacks_on(name):
    suffix = Path(name).suffix
    found = {**NOT_FILES, **ATTACKS_ON.get(suffix, {})}
    return found | ({"too large": LARGE[suffix]} if suffix in LARGE else {})


@pytest.mark.parametrize(
    ("reader", "attack"),
    [
        (reader, attack)
        for reader, (name, _, _) in SINGLE_FILES.items()
        for attack in attacks_on(name)
        if (reader, attack) != ("read_npz", "no members")  # an empty file is one of no arrays
    ],
)
def test_single_files(reader, attack, place):
    name, read, command = SINGLE_FILES[reader]
    attacks_on(name)[attack](place / name)
    with little_memory():
        error = DamagedFileError if attack != "no members" else ValueError
        with pytest.raises(error, match=str(place / name)) as caught:
            read(place / name)
        assert len(str(caught.value).splitlines()) == 1
        if command:
            refuse_in_one_line(*command, place / name)


@pytest.mark.parametrize("seed", range(300))
def test_random_alterations_of_npz_files(seed, place):
    random_npz(place / "x.npz", seed)
    with little_memory():
        try:
            read_npz(place / "x.npz")
        except DamagedFileError:
            return


def test_maps_of_worlds_are_read_within_limits(place):
    NOT_FILES["FIFO"](place / "x.map")
    with pytest.raises(DamagedFileError, match="expected a regular file, got a FIFO"):
        mw.WorldConfig(obstacles=place / "x.map")


EPISODE = mw.record(
    mw.WorldConfig(rows=5, cols=6, n_pursuers=2, n_evaders=3, max_steps=4),
    "chaser",
    "fleer",
    seed=1,
)


@pytest.mark.parametrize(
    "change",
    [
        lambda entries: entries.pop("positions"),
        lambda entries: entries.update(config=np.array("[" * 100_000)),
        lambda entries: entries.update(config=np.array("[]")),
        lambda entries: entries.update(n_pursuers=np.array(np.inf)),
        lambda entries: entries.update(n_pursuers=np.array([1, 2])),
        lambda entries: entries.update(positions=entries["positions"] + 100),
        lambda entries: entries.update(last_positions=entries["last_positions"] - 100),
        lambda entries: entries.update(map=np.zeros((0, 0), bool)),
        lambda entries: entries.update(format=np.array("x" * 10**6)),
    ],
)
def test_forged_episodes(change, place):
    path = place / "x.npz"
    EPISODE.save(path)
    entries = read_npz(path)
    change(entries)
    np.savez(path, **entries)
    with pytest.raises(DamagedFileError, match=r"x\.npz: "):
        mw.Episode.load(path)
    refuse_in_one_line("replay", path)
    refuse_in_one_line("replay", path, "--out", place / "y.png")


# Files of runs:

RUN_FILES = {
    "config.json": ([open_run, resume], ["replay", "diagnose", "evolve --resume", "plot"]),
    "pursuers.npy": ([open_run, resume], ["replay", "score", "tournament", "evolve --resume"]),
    "evaders.npy": ([open_run], ["replay"]),
    "checkpoint.npz": ([lambda path: open_run(path).files.log()], ["plot"]),
    "log.csv": ([lambda path: open_run(path).files.log(), resume], ["plot"]),
    "payoff.npz": ([lambda path: open_run(path).payoff()], ["diagnose", "analyze", "plot"]),
    "summary.json": ([lambda path: open_run(path).files.summary()], ["evolve --resume"]),
}


def check_refused(copy, name):
    """Expect that everything that reads a file of a run refuses it."""
    readers, commands = RUN_FILES[name]
    for read in readers:
        with pytest.raises(REFUSED) as caught:
            read(copy)
        assert len(str(caught.value).splitlines()) == 1
    for command in commands:
        refuse_in_one_line(*command.split(), copy)


@pytest.mark.parametrize(
    ("name", "attack"),
    [(name, attack) for name in RUN_FILES for attack in attacks_on(name)],
)
def test_files_of_runs(name, attack, copy):
    (copy / name).unlink()
    attacks_on(name)[attack](copy / name)
    with little_memory():
        check_refused(copy, name)


@pytest.mark.filterwarnings("ignore::UserWarning")  # of damage, which is part of the output
@pytest.mark.parametrize("attack", [*NOT_FILES, *NPZ_ATTACKS])
def test_runs_to_resume(attack, copy, race):
    """A bad checkpoint is replaced by the one before it; two bad ones are refused."""
    attacks = {**NOT_FILES, **NPZ_ATTACKS}
    (copy / "checkpoint.npz").unlink()
    attacks[attack](copy / "checkpoint.npz")
    again = Path(shutil.copytree(race, copy.parent / "again"))
    for each in ("checkpoint.npz", "checkpoint.previous.npz"):
        (again / each).unlink()
        attacks[attack](again / each)
    with little_memory():
        resume(copy, threads=1).run()
        with pytest.raises(DamagedFileError, match="no intact checkpoint to continue from"):
            resume(again)
        refuse_in_one_line("evolve", "--resume", again)
    for name in (*GENOMES, "log.csv", "checkpoint.npz"):
        assert (copy / name).read_bytes() == (race / name).read_bytes()


def owner(run, name):
    return "" if name == "config.json" else RunDirectory.open(run)._owner_of(name.split(".npz")[0])


def without(key):
    return lambda values: values.pop(key)


def with_entry(key, value):
    return lambda values: values.update({key: value})


def setting(key, value):
    return lambda values: values["settings"].update({key: value})


FORGED = [
    *[("checkpoint.npz", without(key)) for key in ("pursuers", "evaders_checksum")],
    ("checkpoint.npz", with_entry("evaders", np.array([3, 2]))),
    ("checkpoint.npz", with_entry("evaders", np.array([2**62, 2**62]))),
    ("checkpoint.npz", with_entry("evaders", np.array([2**62, 0]))),
    ("checkpoint.npz", with_entry("pursuers", np.array([-1, 9]))),
    ("checkpoint.npz", with_entry("pursuers", np.array([0, 2**62]))),
    ("checkpoint.npz", with_entry("pursuers", np.array([1.5, 2.5]))),
    ("checkpoint.npz", with_entry("pursuers", np.array(3))),
    ("checkpoint.npz", with_entry("pursuers_checksum", np.int64(5))),
    *[("checkpoint.npz", without(key)) for key in ("stage", "log_length", "log_checksum")],
    ("checkpoint.npz", with_entry("log_length", np.int64(2**62))),
    ("checkpoint.npz", with_entry("log_length", np.int64(-5))),
    ("checkpoint.npz", with_entry("log_checksum", np.int64(5))),
    *[("payoff.npz", without(key)) for key in ("capture_rates", "lengths", "agent_steps")],
    ("payoff.npz", with_entry("capture_rates", np.full((3, 3, 3), np.nan, np.float32))),
    ("payoff.npz", with_entry("capture_rates", np.full((3, 3, 3), 7, np.float32))),
    ("payoff.npz", with_entry("capture_rates", np.zeros((0, 0, 0), np.float32))),
    ("payoff.npz", with_entry("lengths", np.zeros((3, 3), np.int32))),
    ("summary.json", without("stages")),
    ("summary.json", with_entry("training_matches", None)),
    ("config.json", without("kind")),
    ("config.json", without("settings")),
    ("config.json", with_entry("kind", ["race"])),
    ("config.json", with_entry("settings", [])),
    ("config.json", with_entry("format", "\x1b[31m" * 1000)),
    ("config.json", with_entry("matrixworld", "\ud800\n\x1b[31m")),
    ("config.json", setting("rows", 10**400)),
    ("config.json", setting("sigma", 10**400)),
    ("config.json", setting("hidden", {"a": "b"})),
    ("config.json", setting("variant", {"a": "b"})),
    ("config.json", setting("variant", [])),
]


@pytest.mark.parametrize(("name", "change"), FORGED)
def test_forged_files_of_runs(name, change, copy):
    forge(copy / name, owner(copy, name), change)
    check_refused(copy, name)


@pytest.mark.parametrize("key", ["matches", "steps", "stage_capture_rates", "pursuer.step"])
def test_forged_checkpoints_of_learners(key, copy):
    path = copy / "checkpoint.npz"
    names = files.load_arrays(path, owner=owner(copy, path.name))
    key = key if key in names else next(name for name in names if name.startswith("pursuer."))
    forge(path, owner(copy, path.name), without(key))
    with pytest.raises(DamagedFileError, match="checkpoint.npz: expected the state of a run"):
        resume(copy)
    refuse_in_one_line("evolve", "--resume", copy)


@pytest.mark.parametrize("value", [None, [], {}, {"hidden": [4]}, {"hidden": 4, "activation": "x"}])
def test_forged_network_of_opponents(value, race, place):
    directory = place / "single"
    SingleTeam(tiny_single(team="evader", against=str(race)), directory, threads=1).run()
    config = files.load_json(directory / "config.json")
    kept = {
        name: files.load_arrays(directory / f"{name}.npz", owner=owner(directory, f"{name}.npz"))
        for name in ("checkpoint",)
    }
    summary = RunDirectory.open(directory).summary()
    files.save_json(directory / "config.json", {**config, "opponent_network": value})
    for name, arrays in kept.items():
        path = directory / f"{name}.npz"
        files.save_arrays(path, arrays, owner=owner(directory, path.name))
    files.save_json(directory / "summary.json", summary, owner=owner(directory, "summary.json"))
    for read in (open_run, resume, lambda path: last_generation(path, "pursuer")):
        with pytest.raises(DamagedFileError, match="opponent_network"):
            read(directory)


@pytest.mark.parametrize("key", ["capture_rate", "capture_rate_low", "length_std"])
def test_forged_summary_of_one_team(key, single, place):
    copy = Path(shutil.copytree(single, place / "run"))
    forge(copy / "summary.json", owner(copy, "summary.json"), without(key))
    assert "summary.json" in refuse_in_one_line("evolve", "--resume", copy)


@pytest.mark.parametrize("attack", [*NOT_FILES, *JSON_ATTACKS, "forged"])
def test_scores_by_others_are_played_again(attack, copy):
    """They are no result of the run, but kept only to save time."""
    matrixworld_command("evolve", "--resume", copy)
    scores, true = copy / "scores.json", (copy / "scores.json").read_bytes()
    if attack == "forged":
        digest = files.json_digest(RunDirectory.open(copy).config())
        forge(scores, f"{digest}/scores.json", with_entry("pursuers", {"mean": []}))
    else:
        scores.unlink()
        {**NOT_FILES, **JSON_ATTACKS}[attack](scores)
    if attack in NOT_FILES:
        assert "scores.json: expected a file, got " in refuse_in_one_line(
            "evolve", "--resume", copy
        )
    else:
        matrixworld_command("evolve", "--resume", copy)
        assert scores.read_bytes() == true


def test_nested_values_with_a_checksum_are_refused(copy):
    (copy / "config.json").write_bytes(nested_with_checksum(100))
    with pytest.raises(DamagedFileError, match=r"config\.json: expected at most 64 levels"):
        open_run(copy)


def test_bombs_with_a_checksum_are_refused(copy):
    content = npz({"pursuers": npy((2_000_000, 1_000_000))})
    sealed(copy / "checkpoint.npz", content, owner(copy, "checkpoint.npz"))
    refused = r"checkpoint\.npz: .*expected 8,000,000,000,000 bytes"
    with pytest.raises(DamagedFileError, match=refused):
        open_run(copy)
