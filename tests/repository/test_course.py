"""The course: notebooks run from top to bottom, and their exercises can be solved and failed."""

import os
import re
import runpy
from operator import attrgetter
from pathlib import Path

import pytest

from matrixworld.tutorial import check
from matrixworld.tutorial.course import Exercise, Prediction, exercises
from notebooks import NOTEBOOKS, TUTORIALS, cells, source
from slow import quickly

SOLUTIONS = sorted((TUTORIALS / "solutions").glob("[0-9]*.py"))
SECONDS_A_CELL = 300
LARGEST = 1_000_000  # bytes

each_notebook = pytest.mark.parametrize("path", NOTEBOOKS, ids=[path.stem for path in NOTEBOOKS])
each_solution = pytest.mark.parametrize("path", SOLUTIONS, ids=[path.stem for path in SOLUTIONS])


def chapter(path: Path) -> int:
    return int(path.name[:2])


def test_every_notebook_has_solutions() -> None:
    assert [path.stem for path in SOLUTIONS] == [path.stem for path in NOTEBOOKS]


# The rules. The solutions of all exercises are always run.
@quickly("path", NOTEBOOKS, lambda path: chapter(path) == 1, attrgetter("stem"))
@pytest.mark.filterwarnings("default")  # Jupyter has warnings of its own
def test_notebook_runs(path: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    import nbformat
    from nbclient import NotebookClient

    monkeypatch.setenv("TMPDIR", str(tmp_path))
    monkeypatch.setenv("MATRIXWORLD_QUICK", "1")
    notebook = nbformat.read(path, as_version=4)
    place = {"metadata": {"path": str(tmp_path)}}
    NotebookClient(
        notebook, timeout=SECONDS_A_CELL, kernel_name="python3", resources=place
    ).execute()
    ran = [cell for cell in notebook.cells if cell.cell_type == "code"]
    assert ran
    assert all(cell.execution_count for cell in ran)


@each_notebook
def test_notebooks_begin_alike_and_are_kept_with_their_outputs(path: Path) -> None:
    """The first code cell installs the package where it is missing."""
    assert path.stat().st_size < LARGEST
    code = cells(path, "code")
    assert source(code[0]) == source(cells(NOTEBOOKS[0], "code")[0])
    assert [cell["execution_count"] for cell in code] == [*range(1, len(code) + 1)]
    kinds = {output["output_type"] for cell in code for output in cell["outputs"]}
    assert "error" not in kinds
    assert {"display_data", "execute_result"} & kinds


@each_notebook
def test_every_exercise_of_a_notebook_is_asked(path: Path) -> None:
    code = [source(cell) for cell in cells(path, "code")]
    text = "\n".join(code)
    checked = re.findall(r'check\("([\d.a-z]+)"', text)
    table = exercises(chapter(path))
    assert checked == list(table)
    assert 3 <= sum(isinstance(each, Exercise) for each in table.values()) <= 5
    assert any(isinstance(each, Prediction) for each in table.values())


@each_notebook
def test_predictions_are_made_before_their_experiments(path: Path) -> None:
    """Between the cell for a prediction and its check there is an experiment."""
    code = [source(cell) for cell in cells(path, "code")]
    asked = [number for number, text in enumerate(code) if text.startswith("prediction = ...")]
    checked = [number for number, text in enumerate(code) if ", prediction)" in text]
    table = exercises(chapter(path))
    assert len(checked) == sum(isinstance(each, Prediction) for each in table.values())
    assert len(asked) == len(checked)
    for first, last, before in zip(asked, checked, [-1, *checked], strict=False):
        assert before < first
        assert last - first >= 2


def test_the_page_of_the_course_has_a_row_for_each_notebook() -> None:
    text = (TUTORIALS / "README.md").read_text("utf-8")
    assert [text.count(f"({path.name})") for path in NOTEBOOKS] == [1] * len(NOTEBOOKS)


@each_solution
def test_solutions_are_right(path: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A file of solutions has one function or value ``exercise_<n>`` for each exercise."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setitem(os.environ, "MATRIXWORLD_QUICK", "1")
    solved = runpy.run_path(str(path))
    for name, exercise in exercises(chapter(path)).items():
        if isinstance(exercise, Exercise):
            reply = check(name, solved[f"exercise_{name.partition('.')[2]}"])
            assert reply.right is True, reply.text


@pytest.mark.parametrize("number", range(1, 10))
def test_replies_to_predictions(number: int) -> None:
    for name, each in exercises(number).items():
        if isinstance(each, Prediction):
            assert len(each.options) >= 2, name
            for option in each.options:
                assert check(name, option).right is (option == each.outcome)
            assert check(name, "an answer that is not offered").right is None
        assert check(name, ...).right is None
