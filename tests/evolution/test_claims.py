"""Numbers in texts follow from kept tables; how claims are found, read and written."""

import re

import numpy as np
import pytest

import claims
from claims import Claim, Folder

TEXTS = [pytest.param(path, id=str(path.relative_to(claims.ROOT))) for path in claims.texts()]


@pytest.fixture
def kept(tmp_path, monkeypatch):
    """A folder with numbers and a table, whose two claims are the only ones."""
    np.savez(tmp_path / "numbers.npz", rates=[0.25, 0.5, 0.75], found=[True, True, False])
    table = "### Small\n\n| world | captured |\n|---|---|\n| a | 0.5 [0.25, 1,234] |\n"
    (tmp_path / "table.md").write_text(table + "\n### Large\n\n" + table.split("\n\n", 1)[1])
    folder = Folder(tmp_path)
    known = {
        "here.mean": Claim(folder, "numbers['rates'].mean()", "{:.2f}"),
        "here.found": Claim(folder, "numbers['found'].sum(), numbers['found'].size", "{} of {}"),
        "here.cell": Claim(folder, "cell('a', 'captured', 'Small')", "{:+.3f} [{:.2f}, {:,.0f}]"),
        "here.table": Claim(folder, "'| a |\\n|---|\\n| 1.5 |'"),
    }
    monkeypatch.setattr(claims, "claims", lambda: known)
    return folder


@pytest.mark.parametrize("path", TEXTS)
def test_a_text_says_what_its_tables_say(path):
    text = path.read_text(encoding="utf-8")
    assert claims.written(text) == text


@pytest.mark.parametrize("path", TEXTS)
def test_a_measured_number_has_a_claim(path):
    assert [each for passage in claims.passages(path) for each in claims.unclaimed(passage)] == []


def test_each_claim_is_said_somewhere():
    told = "".join(path.read_text(encoding="utf-8") for path in claims.texts())
    marks = (*claims.MARK.finditer(told), *claims.TABLE.finditer(told))
    assert claims.claims().keys() - {mark["name"] for mark in marks} == set()


def test_digits_and_tables_are_written(kept):
    text = """A mean of
    0.1<!--here.mean-->, 9 of 9<!--here.found--> and +1 [2,
    3]<!--here.cell-->.

<!--table: here.table-->
| b |
|---|

Rest.
"""
    told = """A mean of
    0.50<!--here.mean-->, 2 of 3<!--here.found--> and +0.500 [0.25, 1,234]<!--here.cell-->.

<!--table: here.table-->
| a |
|---|
| 1.5 |

Rest.
"""
    assert claims.written(text) == told
    assert claims.written(told) == told
    assert claims.unclaimed(told) == []


def test_a_table_may_end_a_file(kept):
    told = "<!--table: here.table-->\n| a |\n|---|\n| 1.5 |\n"
    assert claims.written(told.strip()) == claims.written(told) == told


def test_a_line_break_within_digits_stays(kept):
    text = "so +0.500 [0.25,\n1,234]<!--here.cell--> it is"
    assert claims.written(text) == text


@pytest.mark.parametrize(
    "text",
    [
        "a rate of 0.25", "a rate of .25", "by +0.250.", "12 % of them", "12% of them", "in 3 of 5",
        "in 3 of\n5", "99 % of them", "95 % of them",
        "| 0.5 |", "[0.25, 0.5]", "p = 0.016", "p < 0.001 (<br>)", "1,234.5 steps",
    ],
)  # fmt: skip
def test_a_number_without_a_claim_is_found(text):
    assert claims.unclaimed(text)


def test_numbers_of_a_sentence_can_be_chosen_or_cited():
    text = "Of 0.3 and 0.4<!--set--> none. Theirs is 0.5 (<!--cited: Elo 1978-->)."
    assert claims.unclaimed(text) == []
    assert len(claims.unclaimed("It is 0.25. So " + text)) == 1


@pytest.mark.parametrize(
    "text",
    [
        "in 2024", "8 pursuers", "`0.25`", "```\n0.25\n```", "[a](x_0.25.md)", "arXiv:2307.14854",
        "a 95 % interval", "Python 3.10", "notebook 4.a", "at least 0.1.2", "1 of them",
    ],
)  # fmt: skip
def test_other_numbers_need_no_claim(text):
    assert claims.unclaimed(text) == []


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("0.5<!--here.gone-->", "expected the name of a claim, got here.gone"),
        ("<!--table: here.gone-->\n| 1 |", "expected the name of a claim, got here.gone"),
        ("0.5 or so<!--here.mean-->", "expected '{:.2f}' before here.mean, got '0.5 or so'"),
    ],
)
def test_a_claim_that_does_not_fit_is_refused(kept, text, problem):
    with pytest.raises(ValueError, match=re.escape(problem)):
        claims.written(text)


@pytest.mark.parametrize(("row", "under", "found"), [("b", "Small", 0), ("a", "", 2)])
def test_a_cell_has_to_be_the_only_one(kept, row, under, found):
    with pytest.raises(ValueError, match=f"expected one cell in row '{row}'.*found {found}"):
        kept.cell(row, "captured", under)
