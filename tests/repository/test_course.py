"""The course: notebooks run from top to bottom, and their exercises can be solved and failed."""

import hashlib
import json
import os
import re
import runpy
from datetime import datetime
from pathlib import Path

import pytest

from course import UnansweredError, check, outcome, predict
from course.questions import CHAPTERS, EDITION, Exercise, Prediction, exercises
from notebooks import NOTEBOOKS, TUTORIALS, cells, source

SOLUTIONS = sorted((TUTORIALS / "solutions").glob("[0-9]*.py"))
SECONDS_A_CELL = 300
LARGEST = 1_000_000  # bytes

SLOW, NIGHTLY = pytest.mark.slow, pytest.mark.nightly
each_notebook = pytest.mark.parametrize("path", NOTEBOOKS, ids=[path.stem for path in NOTEBOOKS])
each_solution = pytest.mark.parametrize("path", SOLUTIONS, ids=[path.stem for path in SOLUTIONS])


def chapter(path):
    return int(path.name[:2])


def own(path):
    """Return what a notebook asks; two parts of a chapter share its exercises."""
    text = "\n".join(source(cell) for cell in cells(TUTORIALS / f"{path.stem}.ipynb", "code"))
    table = exercises(chapter(path))
    return {name: table[name] for name in re.findall(r'(?:check|outcome)\("([\d.a-z]+)"', text)}


RUN = runpy.run_path(str(TUTORIALS / "run.py"))


def printed(cell):
    shown = [output.get("data", {}) | {"": output.get("text", "")} for output in cell["outputs"]]
    return " ".join("".join(text) for o in shown for kind, text in o.items() if "/png" not in kind)


@each_notebook
def test_what_a_student_s_notebook_shows_gives_no_answer(path):
    """From the first prediction on there are no outputs; above it, none of the replies to one."""
    code = cells(path, "code")
    first = next(n for n, cell in enumerate(code) if source(cell).startswith("predict("))
    assert all(not cell["outputs"] and cell["execution_count"] is None for cell in code[first:])
    assert path.stat().st_size < LARGEST
    kept = [cell for cell in code[:first] if cell["outputs"]]
    assert any("image/png" in o.get("data", {}) for cell in kept for o in cell["outputs"])
    text = " ".join(" ".join(map(printed, kept)).split())
    assert "image/gif" not in text
    for each in own(path).values():
        assert each.explanation not in text
        assert not isinstance(each, Exercise) or each.hints[-1] not in text
    assert not any(re.search(r"hidden = \{|do not look", source(cell)) for cell in code)


# The solutions of all exercises are always run.
@pytest.mark.parametrize(
    "path",
    [
        pytest.param(path, id=path.stem, marks=SLOW if chapter(path) == 1 else NIGHTLY)
        for path in NOTEBOOKS
    ],
)
@pytest.mark.filterwarnings("default")  # Jupyter has warnings of its own
def test_a_notebook_runs_and_the_teacher_s_copy_has_all_outputs(path, tmp_path, monkeypatch):
    import nbformat

    monkeypatch.setenv("TMPDIR", str(tmp_path))
    monkeypatch.setenv("MATRIXWORLD_QUICK", "1")
    executed = RUN["execute"](nbformat.read(path, as_version=4), timeout=SECONDS_A_CELL)
    RUN["write"](RUN["for_teachers"](executed, path.stem), tmp_path / path.name)
    assert (tmp_path / path.name).stat().st_size < LARGEST
    code = cells(tmp_path / path.name, "code")
    assert [cell["execution_count"] for cell in code] == [*range(1, len(code) + 1)]
    outputs = [output for cell in code for output in cell["outputs"]]
    assert "error" not in {output["output_type"] for output in outputs}
    pictures = [output["metadata"] for output in outputs if "image/png" in output.get("data", {})]
    assert all(len(metadata["image/png"]["alt"]) > 20 for metadata in pictures)
    outcomes = [each for each in own(path).values() if isinstance(each, Prediction)]
    shown = " ".join(" ".join(map(printed, code)).split())
    assert all(each.explanation in shown for each in outcomes)
    assert shown.count("✓ As you predicted") == len(outcomes)


@each_notebook
def test_the_teacher_s_copy_is_the_notebook_with_solutions(path, tmp_path):
    import nbformat

    RUN["write"](RUN["for_teachers"](nbformat.read(path, 4), path.stem), tmp_path / path.name)
    asked = [source(cell) for cell in cells(path, "code")]
    moved = [source(cell) for cell in cells(tmp_path / path.name, "code")]
    assert asked == [text.replace("%run ../", "%run ").replace("../..", "..") for text in moved]
    text = "\n".join(source(cell) for cell in cells(tmp_path / path.name))
    for name, each in own(path).items():
        if isinstance(each, Exercise):
            below = text.partition(f'\ncheck("{name}"')[2].partition("```python")[2]
            answer = rf"\n(def )?exercise_{name.partition('.')[2]}\b"
            assert re.search(answer, below.partition("```")[0]), name


@pytest.mark.parametrize("number", CHAPTERS)
def test_every_exercise_of_a_chapter_is_asked(number):
    parts = [own(path) for path in NOTEBOOKS if chapter(path) == number]
    table = exercises(number)
    assert [name for part in parts for name in part] == list(table)
    assert 3 <= sum(isinstance(each, Exercise) for each in table.values()) <= 5
    for part in parts:
        assert {type(each) for each in part.values()} == {Exercise, Prediction}


@each_notebook
def test_predictions_are_made_before_their_experiments(path):
    """The first line of an experiment is its prediction; the cells after it tell the outcome."""
    code = [source(cell) for cell in cells(path, "code")]
    asked = [text for text in code if "predict(" in text]
    assert all(re.match(r'predict\("[\d.a-z]+", \.\.\.\).*\n+.', text) for text in asked)
    order = re.findall(r'(predict|outcome)\("([\d.a-z]+)"', "\n".join(code))
    table = own(path)
    names = [name for name, each in table.items() if isinstance(each, Prediction)]
    assert order == [(what, name) for name in names for what in ("predict", "outcome")]


@each_solution
def test_solutions_are_right(path, tmp_path, monkeypatch):
    """A file of solutions has one function or value ``exercise_<n>`` for each exercise."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setitem(os.environ, "MATRIXWORLD_QUICK", "1")
    solved = runpy.run_path(str(path))
    for name, exercise in own(path).items():
        if isinstance(exercise, Exercise):
            reply = check(name, solved[f"exercise_{name.partition('.')[2]}"])
            assert reply.right is True, reply.text


@pytest.mark.parametrize("number", CHAPTERS)
def test_replies_to_choices(number, tmp_path, monkeypatch):
    """A choice is written down first; the reply is to the last one, and the file keeps all."""
    monkeypatch.chdir(tmp_path)
    for name, each in exercises(number).items():
        if not isinstance(each, Prediction):
            with pytest.raises(ValueError, match="expected a prediction such as"):
                predict(name, "a")
            continue
        for given in (..., "an option that is not offered", 7):
            with pytest.raises(UnansweredError):
                predict(name, given)
        with pytest.raises(UnansweredError, match="No prediction yet"):
            outcome(name)
        assert len(each.options) >= 2, name
        for option in (*each.options, each.options[-1]):
            predict(name, option)
            assert outcome(name).right is (option == each.outcome)
        with pytest.raises(ValueError, match="is a prediction"):
            check(name, each.outcome)
    lines = [json.loads(line) for line in Path("predictions.jsonl").read_text().splitlines()]
    assert [(each["prediction"], each["choice"]) for each in lines] == [
        (name, option)
        for name, each in exercises(number).items()
        if isinstance(each, Prediction)
        for option in each.options
    ]
    assert all(datetime.fromisoformat(each["time"]).tzinfo for each in lines)
    assert {each["edition"] for each in lines} == {EDITION}


def test_letters_of_an_edition_stay():
    """If this fails, raise the edition in ``exercises.toml``, and write down its digest here."""
    asked = [
        (name, each.options, each.outcome)
        for number in CHAPTERS
        for name, each in exercises(number).items()
        if isinstance(each, Prediction)
    ]
    digest = hashlib.sha256(json.dumps(asked).encode()).hexdigest()[:8]
    assert (EDITION, digest) == (4, "fb34d44f")


def test_a_notebook_stops_at_an_open_question():
    """Its cell shows the text and no traceback, and Jupyter runs none of those below."""
    shell = pytest.importorskip("IPython.core.interactiveshell").InteractiveShell()
    cell = 'from course import predict\npredict("1.a", ...)\nseen = True'
    result = shell.run_cell(cell, silent=True)
    assert isinstance(result.error_in_exec, UnansweredError)
    assert "seen" not in shell.user_ns
    shown = result.error_in_exec._render_traceback_()
    assert shown[0].startswith("No prediction yet")
    assert "Traceback" not in shown[0]
