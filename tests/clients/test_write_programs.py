"""The loop that writes programs: its archive is exact, goes on, and survives a cut line."""

import json
import random

import pytest

import matrixworld as mw
import write_programs
from pages import read
from write_programs import INPUTS, LONGEST, propose


def loop(monkeypatch, archive, team="pursuer", minutes="0.05"):
    arguments = ["write_programs.py", team, str(archive), "--minutes", minutes]
    monkeypatch.setattr("sys.argv", arguments)
    write_programs.main()
    return [json.loads(line) for line in archive.read_text().splitlines()]


@pytest.fixture
def two_worlds(monkeypatch):
    suite = mw.SUITE
    small = type(suite)(suite.name, suite.version, suite.worlds[:2])
    monkeypatch.setattr(write_programs, "graded", lambda text, team: _graded(text, team, small))


def _graded(text, team, suite, grade=mw.grade):
    try:
        found = grade(text, team, worlds=suite).teams[team]
    except ValueError as error:
        return {"program": text, "error": str(error)}
    return {"program": text, "grade": found.share, "losses": [str(loss) for loss in found.losses]}


def test_the_archive_goes_on_from_where_it_was_cut(monkeypatch, tmp_path, two_worlds):
    random.seed(1)
    file = tmp_path / "archive.jsonl"
    first = loop(monkeypatch, file)
    assert first[0]["program"] == "-adversary"
    file.write_text(file.read_text() + '{"program": "cut')
    both = loop(monkeypatch, file)
    assert both[: len(first)] == first
    assert len(both) > len(first)
    programs = [each["program"] for each in both]
    assert len({*programs}) == len(programs)
    best = max((each for each in both if "grade" in each), key=lambda each: each["grade"])
    again = mw.grade(best["program"], "pursuer", worlds=mw.SUITE.worlds[:2]).teams["pursuer"]
    assert again.share == pytest.approx(best["grade"], abs=1e-12)
    assert best["grade"] >= first[0]["grade"]


def test_a_program_is_graded_in_the_suite():
    found = write_programs.graded("-adversary", "pursuer")
    assert found["grade"] == mw.grade("-adversary", "pursuer").teams["pursuer"].share
    assert len(found["losses"]) == 3
    assert "expression" in write_programs.graded("adversary +", "pursuer")["error"]


def test_most_edits_are_programs():
    random.seed(0)
    program = mw.Program(inputs=tuple(mw.INPUTS), length=500)
    kept = 0
    for _ in range(200):
        text = propose(["-adversary - 0.2 * unclaimed", "max(0.5 * exits, room)"], [0, 0], [[], []])
        assert any(name in text for name in INPUTS) or text.replace(".", "").strip("-").isdigit()
        try:
            program.genome(text)
        except ValueError:
            continue
        kept += len(text) <= LONGEST
    assert kept > 120


def test_the_page_names_it():
    assert "](clients/write_programs.py)" in read("docs/players.md")
