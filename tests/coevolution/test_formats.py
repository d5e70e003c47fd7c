"""Runs of older formats: payoff, log and genomes stay readable; only going on needs the newest.

`formats` has two runs of each format, made by `keep` when the format was new.
"""

import json
import shutil
from pathlib import Path

import numpy as np
import pytest

from matrixworld import coevolution as co
from matrixworld.coevolution.runs import stored_files
from own_games import numbers, short_race
from tiny_race import played, tiny_race

FORMATS = Path(__file__).with_name("formats")
KINDS = ("race", "game")
KEPT = [(path.name, kind) for path in sorted(FORMATS.iterdir()) for kind in KINDS]


def settings_of(kind):
    if kind == "game":
        return short_race(numbers, generations=2)
    return tiny_race(policy="rating", inputs=("adversary", "room"))


def keep():
    """Make the runs of the newest format, and what can be read of them."""
    for kind in KINDS:
        path = FORMATS / str(stored_files.FORMAT) / kind
        run = played(settings_of(kind), path)
        (path / "read.json").write_text(json.dumps(read(run)))


def read(run):
    """Return what is read of a run, as plain values."""
    log = {name: column.tolist() for name, column in run.log().items()}
    payoff = {name: np.asarray(array).tolist() for name, array in run.payoff().arrays().items()}
    genomes = {team: array.tolist() for team, array in run.archive().items()}
    return {"log": log, "payoff": payoff, "genomes": genomes}


@pytest.fixture(params=KEPT, ids="-".join)
def kept(request, tmp_path):
    name, kind = request.param
    return Path(shutil.copytree(FORMATS / name / kind, tmp_path / kind))


def test_every_format_since_the_oldest_one_is_kept():
    assert {name for name, _ in KEPT} == set(
        map(str, range(stored_files.OLDEST, stored_files.FORMAT + 1))
    )


def test_payoff_log_and_genomes_can_be_read(kept):
    expected = json.loads((kept / "read.json").read_text())
    assert read(co.SavedRun(kept)) == expected


def test_they_can_be_read_where_the_settings_have_other_names_by_now(kept):
    config = json.loads((kept / "config.json").read_text())
    config["settings"]["learner"] = {"kind": "a learner of the past", "rate": 1}
    (kept / "config.json").write_text(json.dumps(config))
    run = co.SavedRun(kept)
    assert read(run) == json.loads((kept / "read.json").read_text())
    with pytest.raises(
        co.OtherVersionError, match=r"learner: expected one of es, ga.*, got 'a lea"
    ):
        _ = run.settings


def test_a_column_of_an_unknown_type_is_damage_and_shifts_no_other_one(kept):
    config = json.loads((kept / "config.json").read_text())
    config["game"]["columns"]["epoch"] = "complex"
    (kept / "config.json").write_text(json.dumps(config))
    with pytest.raises(co.DamagedFileError, match=r"epoch: expected one of int.*got 'complex'"):
        co.SavedRun(kept).log()


def test_only_going_on_needs_the_newest_format(kept, monkeypatch):
    monkeypatch.setattr(stored_files, "FORMAT", stored_files.FORMAT + 1)
    monkeypatch.setattr("matrixworld.coevolution.runs.writer.FORMAT", stored_files.FORMAT)
    assert read(co.SavedRun(kept)) == json.loads((kept / "read.json").read_text())
    before = {path.name: path.read_bytes() for path in kept.iterdir()}
    for go_on in (co.Run, lambda path: co.open_run(path).extend(9)):
        with pytest.raises(co.OtherVersionError, match="to go on, got .* goes on"):
            go_on(kept)
    assert before == {p.name: p.read_bytes() for p in kept.iterdir() if p.name in before}


@pytest.fixture
def older(race, tmp_path):
    """A folder with a run of today and one of a format that cannot be read."""
    for name in ("today", "older"):
        shutil.copytree(race, tmp_path / name)
    path = tmp_path / "older" / "config.json"
    config = json.loads(path.read_text())
    path.write_text(json.dumps({**config, "format": 11, "matrixworld": "0.2.0"}))
    return tmp_path


def test_runs_of_earlier_formats_are_left_out_of_a_folder_and_refused_alone(older):
    version = "expected format .*, got 11, which matrixworld 0.2.0 has written and reads"
    with pytest.warns(UserWarning, match=f"left out: .*older.*{version}") as warned:
        [group] = co.open_groups(older)
    assert [each.filename for each in warned] == [__file__]  # where it was called
    assert [run.path.name for run in group.runs] == ["today"]
    for open_older in (co.open_groups, co.open_run, co.Run):
        with pytest.raises(co.OtherVersionError, match=version):
            open_older(older / "older")


def test_a_race_is_played_as_when_it_was_kept(tmp_path):
    kept = json.loads((FORMATS / str(stored_files.FORMAT) / "race" / "read.json").read_text())
    assert read(played(settings_of("race"), tmp_path / "run")) == kept
