"""The lesson: its games, its data, and a walk through the page as a student takes it."""

import hashlib
import json
import sys
from itertools import chain
from pathlib import Path

import numpy as np
import pytest

from class_tournament.votes import count_votes, read_predictions
from course.questions import EDITION, Prediction, exercises
from course.toys import GAMES, beats, race_of_hands
from node import run_node
from scripts import wait_until

DOCS = Path(__file__).parents[2] / "docs"
PAGE = DOCS / "lesson.html"


@pytest.fixture(scope="module")
def lesson():
    sys.path.insert(0, str(DOCS))
    import lesson_page

    yield lesson_page
    sys.path.remove(str(DOCS))


def test_the_page_in_docs_is_the_present_one(lesson):
    kept = PAGE.read_text(encoding="utf-8")
    races = lesson.races_of_page(kept)
    assert kept == lesson.lesson_page(races), "run python docs/make_pages.py"
    assert len(kept) < 5e6
    assert [run["schedule"] for run in races.runs] == lesson.LESSON["races"]


def test_questions_have_answers_and_those_of_the_course_are_the_same(lesson):
    races = lesson.races_of_page(PAGE.read_text(encoding="utf-8"))
    parts = list(chain.from_iterable(each["parts"] for each in lesson.LESSON["sections"]))
    asked = [lesson._filled(part, races) for part in parts if "question" in part]
    for part in (each for each in asked if "predict" in each):
        name = part["predict"]
        assert part["outcome"] in part["options"], name
        if not name.startswith("0."):
            known = exercises(int(name[0]))[name]
            assert isinstance(known, Prediction)
            assert tuple(part["options"]) == known.options
            assert part["outcome"] == known.outcome
    names = [each.get("predict") or each.get("exercise") or "exit" for each in asked]
    assert len(set(names)) == len(names)
    guess = next(each for each in asked if each.get("predict") == "0.f")
    assert lesson.LESSON["races"]["abc".index(guess["outcome"])] == "specialist-specialist"


def test_texts_show_no_names_of_claims(lesson):
    given = Path(lesson.__file__).with_name("lesson.toml").read_text(encoding="utf-8")
    assert "<!--set-->" in given
    assert "<!--" not in json.dumps([lesson.LESSON, lesson.COURSE])


def test_letters_of_an_edition_stay_and_any_may_be_right(lesson):
    """If this fails, raise the edition in ``exercises.toml``, and write down its digest here."""
    races = lesson.races_of_page(PAGE.read_text(encoding="utf-8"))
    parts = chain.from_iterable(each["parts"] for each in lesson.LESSON["sections"])
    asked = [lesson._filled(part, races) for part in parts if "predict" in part]
    letters = json.dumps([[part["predict"], part["question"], part["options"]] for part in asked])
    digest = hashlib.sha256(letters.encode()).hexdigest()[:8]
    assert (lesson.COURSE["edition"], digest) == (4, "bac26d82")
    assert {part["outcome"] for part in asked} == {"a", "b", "c"}
    first, again = (next(p for p in asked if p["predict"] == name) for name in ("0.a", "0.h"))
    assert (again["again"], again["options"]) == ("0.a", first["options"])


def saved(choices, pupil, edition=2):
    common = {"edition": edition, "pupil": pupil}
    lines = [{"prediction": name, "choice": choice, **common} for name, choice in choices.items()]
    return "".join(json.dumps(line) + "\n" for line in lines)


def test_the_page_counts_votes_as_the_class_does():
    """A pupil counts once, whatever the names of the files; the page knows its options, too."""
    options = {name: dict.fromkeys("abc", "") for name in ("0.a", "0.b")}
    whole = saved({"0.a": "a", "0.b": "c"}, "0000000a")
    files = {
        "predictions.jsonl": saved({"0.a": "a"}, "0000000a"),  # an earlier save
        "predictions (1).jsonl": whole,
        "predictions (2).jsonl": saved({"0.a": "b"}, "0000000b"),  # another pupil
        "predictions (3).jsonl": whole,
        "old.jsonl": saved({"0.a": "b"}, "0000000c", edition=1),
        "two.jsonl": saved({"0.a": "a"}, "0000000d") + saved({"0.b": "a"}, "0000000e"),
        "text.jsonl": "hello",
    }
    given = [{"name": name, "text": text} for name, text in files.items()]
    unknown = {"name": "option.jsonl", "text": saved({"0.a": "z"}, "0000000f")}
    page = run_node("votes.mjs", {"files": [*given, unknown], "edition": 2, "options": options})
    votes, reasons = count_votes((name, name, text.encode()) for name, text in files.items())
    assert votes == {"0.a": {"a": 1, "b": 1}, "0.b": {"c": 1}}
    assert page["pupils"] == 2
    counts = page["votes"].items()
    assert {name: {k: n for k, n in each.items() if n} for name, each in counts} == votes
    left = {each["file"]: each["reason"] for each in page["left"]}
    assert left.pop("option.jsonl") == 'line 1: expected one of a, b, c for 0.a, got "z"'
    assert left.pop("old.jsonl") == "line 1: expected edition 2 of the course, got 1"
    assert "expected edition 2 of the course" in reasons.pop("old.jsonl")
    assert left == reasons
    assert reasons["predictions (3).jsonl"].startswith("double: the same content as")
    assert reasons["predictions.jsonl"] == "double: the pupil of predictions (1).jsonl"


def test_the_games_are_as_they_were_and_as_in_the_package():
    """A slow Python version, which stood here at commit 8e1a8000, has drawn the same."""
    memories, generations, seed = [1, 2, 5, 1000], 400, 3
    settings = {"population": 6, "mutation": 0.02, "opponents": 4, "hall": 3}
    games = [{"game": name, "settings": settings, "generations": 12} for name in GAMES]
    given = {"memories": memories, "generations": generations, "seed": seed, "games": games}
    found = run_node("toys.mjs", given)
    drawn = json.dumps([found["hands"], [game["ones"] for game in found["games"]]])
    assert hashlib.sha256(drawn.encode()).hexdigest()[:8] == "460f4fa9"
    specialists = race_of_hands("specialists", generations)
    assert found["hands"][0] == {f"{team}s": each for team, each in specialists.items()}
    for last, every in zip(found["hands"][0].values(), found["hands"][-1].values(), strict=True):
        assert last[1:-3] == last[4:]
        shares = np.bincount(every) / len(every)
        assert shares == pytest.approx([1 / 3] * 3, abs=0.04)
    for given_game, game in zip(games, found["games"], strict=True):
        name = str(given_game["game"])
        a, b = (np.array(each) for each in game["ones"])
        first, second = (each.ravel() for each in np.indices((6, 6)))
        pairs = (a[first], b[second]), (b[second], a[first])
        won, lost = (beats(GAMES[name], *each) for each in pairs)
        assert game["score"] == pytest.approx(np.mean((1.0 + won - lost) / 2))


CHOOSE = """(([name, choice]) => {
  const form = document.getElementById(`prediction-${name}`);
  if (choice) form.querySelector(`input[value="${choice}"]`).click();
  form.requestSubmit();
  return form.textContent;
})(arguments[0])"""
"""Make a prediction, or none, and return what its part then says."""
ANSWER = """(([name, answer]) => {
  const form = document.getElementById(`exercise-${name}`);
  form.querySelector("input").value = answer;
  form.requestSubmit();
  return form.querySelector(".reply").textContent;
})(arguments[0])"""
TEXT = "document.querySelector(arguments[0]).textContent"
CHOICES = {
    "0.a": "a", "4.a": "b", "0.b": "c", "0.c": "a", "0.d": "b", "0.e": "a", "0.f": "b", "5.a": "a",
    "0.g": "a", "0.h": "c",
}  # fmt: skip


@pytest.mark.nightly
def test_a_walk_through_the_page(browser, tmp_path):
    """Nothing is told before the prediction; answers are checked; all comes back and is saved."""
    folder = {"behavior": "allow", "downloadPath": str(tmp_path)}
    browser.driver.execute_cdp_cmd("Browser.setDownloadBehavior", folder)
    browser.open(PAGE)
    for section in ("#hands", "#numbers", "#races"):
        assert "goes on with your prediction." in browser.js(TEXT, section)
    assert "policy cycle" not in browser.js(TEXT, "main")
    assert "Choose one first" in browser.js(CHOOSE, ["4.a", ""])
    for name, choice in CHOICES.items():
        said = browser.js(CHOOSE, [name, choice])
    assert "At the beginning you predicted: Neither" in said
    browser.wait("document.querySelector('.chase canvas').width > 300")
    browser.js("document.querySelector('.evolve').click()")
    browser.wait("document.querySelector('.evolving .lane').dataset.state === 'ended'", 120)
    assert browser.js("document.querySelectorAll('.waiting').length") == 0
    assert "It contains the current evaders" in browser.js(ANSWER, ["4.2", "0,65"])
    assert "✓ Right" in browser.js(ANSWER, ["4.2", "0.7"])
    browser.wait("document.querySelector('#races .match-card').dataset.played")
    assert browser.js(TEXT, "#races .check") == "As in the evaluation"
    browser.js("document.querySelector('#numbers .widget .primary').click()")
    browser.wait(
        "/after 600 generations/.test(document.querySelector('#numbers').textContent)", 120
    )
    said = "They got better, or the others got worse: play against the team of a month ago."
    browser.js("document.querySelector('#exit-answer').focus()")
    browser.press(said)
    browser.reload()
    assert browser.js("document.querySelector('#exit-answer').value") == said
    browser.js("document.querySelector('#exit-answer').form.requestSubmit()")
    assert "A good answer has" in browser.js(TEXT, "#exit")
    browser.js("document.querySelector('.save').click()")
    file = tmp_path / "predictions.jsonl"
    wait_until(file.exists, "a file of predictions", 10)
    choices, pupil, edition = read_predictions(file.read_bytes())
    assert (choices, len(pupil), edition) == (CHOICES, 8, EDITION)
    assert browser.errors() == []
