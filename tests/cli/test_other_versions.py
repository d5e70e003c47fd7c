"""Commands on runs of an earlier version: told in one line, and left out beside runs of today."""

import json
import re
import shutil
from pathlib import Path

import pytest

from command_line import evolved, matrixworld_command, run_together
from matrixworld._util.files import read_json
from matrixworld.coevolution import open_run
from matrixworld.coevolution.runs.stored_files import FORMAT

EARLIER = {"format": 11, "matrixworld": "0.2.0", "settings": {"world": {"rows": 6}, "seed": 3}}
SENTENCE = f"config.json: expected format {FORMAT}, got 11, which matrixworld 0.2.0 has written"
READING = [
    ("judge", "--json", "found.json", "--force"),
    ("explore", "--no-open", "--force", "--out", "page.html"),
    ("explore", "--figures", "--force"),
    ("score", "--episodes", 2, "--json", "found.json", "--force"),
]


def make_earlier(path):
    """Make the directory of a run as the version before has written it, but for its stages."""
    path.mkdir(parents=True)
    (path / "config.json").write_text(json.dumps(EARLIER, indent=2))
    return path


@pytest.fixture
def beside(seeds):
    """A job of today with one run of an earlier version."""
    job = Path(shutil.copytree(seeds / "generalist-generalist", "job"))
    shutil.rmtree(job / "seed-3")  # which has not begun
    make_earlier(job / "seed-3")
    return job


def warnings_of(done):
    return [line for line in done.stderr.splitlines() if line.startswith("Warning:")]


@pytest.mark.parametrize("words", READING, ids=lambda words: " ".join(map(str, words[:2])))
def test_one_run_of_an_earlier_version_is_left_out_with_one_line(beside, words):
    command, *options = words
    done = matrixworld_command(command, beside, *options)
    assert warnings_of(done) == [f"Warning: left out: {beside / 'seed-3'}/{SENTENCE} and reads"]
    # The same as without it.
    shutil.rmtree(beside / "seed-3")
    found = Path("found.json").read_bytes() if "found.json" in words else b""
    again = matrixworld_command(command, beside, *options)
    assert warnings_of(again) == []
    assert not found or read_json(Path("found.json"))["groups"].keys() == {str(beside)}
    if command != "explore":
        numbers = [*json.loads(found)["groups"].values()]
        assert numbers == [*read_json(Path("found.json"))["groups"].values()]


def test_each_of_several_is_told_once(beside):
    make_earlier(beside / "seed-4")
    told = warnings_of(matrixworld_command("judge", beside))
    assert [re.findall(r"seed-\d", line) for line in told] == [["seed-3"], ["seed-4"]]


@pytest.mark.parametrize("words", [
    *(each[:1] for each in READING), ("tournament",), ("replay", "--race", "seed-3"), ("explain",),
    ("evolve", "--resume"), ("solve", "--run"),
], ids=" ".join)  # fmt: skip
def test_earlier_runs_alone_are_refused_in_that_sentence(words):
    job = Path("job")
    earlier = make_earlier(job / "seed-3")
    if words[0] in ("judge", "score", "explore"):
        make_earlier(job / "seed-4")
    before = sorted(job.rglob("*"))
    place = [job, *words[1:]] if words[0] == "replay" else [*words[1:], job]
    told = matrixworld_command(words[0], *place, code=1).stderr
    assert f"Error: {earlier}/{SENTENCE} and reads\n" in told
    assert told.count("0.2.0") == 1
    assert sorted(job.rglob("*")) == before


def test_settings_of_an_earlier_run_are_refused_with_the_version_that_reads_them():
    config = make_earlier(Path("earlier")) / "config.json"
    told = run_together(evolved("--config", config, "--out", "out", code=2).stderr)
    expected = f"expected a run of format {FORMAT} in {config}, got format 11, which matrixworld "
    assert f"'--config': {expected}0.2.0 reads" in told
    assert not Path("out").exists()


@pytest.mark.parametrize("found", [FORMAT + 1, "12", None, [12]])
def test_settings_of_other_formats_are_refused_as_well(found):
    Path("config.json").write_text(json.dumps({**EARLIER, "format": found, "matrixworld": "9.9"}))
    told = run_together(evolved("--config", "config.json", "--out", "out", code=2).stderr)
    assert f"got format {found}, which matrixworld 9.9 reads" in told


def test_a_run_of_today_is_read_again(run):
    """The file of a run has more than the settings: none of it is taken for one."""
    config = read_json(run / "config.json")
    assert (config["format"], config["game"]["teams"]) == (FORMAT, ["pursuers", "evaders"])
    assert open_run(run).settings.to_json() == config["settings"]


def test_a_tournament_leaves_a_run_of_an_earlier_version_out(beside):
    done = matrixworld_command("tournament", beside, "--episodes", 2)
    assert warnings_of(done) == [f"Warning: left out: {beside / 'seed-3'}/{SENTENCE} and reads"]
    written = {path.parent.name for path in beside.glob("*/tournament-*.npz")}
    assert written == {path.name for path in beside.glob("seed-*")} - {"seed-3"}
