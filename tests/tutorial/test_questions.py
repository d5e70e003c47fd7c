"""Predictions have the options in the text of their notebook, and hints get more explicit."""

from __future__ import annotations

import re

import pytest

from matrixworld.tutorial import hint
from matrixworld.tutorial.course import Prediction, exercises
from notebooks import NOTEBOOKS, cells, source


@pytest.mark.parametrize("chapter", [1, 2])
def test_options_are_written_out(chapter: int) -> None:
    texts = [source(cell) for cell in cells(NOTEBOOKS[chapter - 1])]
    places = [at for at, text in enumerate(texts) if text.startswith("prediction = ...")]
    offered = [
        (re.findall(r'^- `"(\w)"`:', texts[at - 1], re.MULTILINE), re.findall(r'"(\w)"', texts[at]))
        for at in places
    ]
    known = [each for each in exercises(chapter).values() if isinstance(each, Prediction)]
    assert offered == [(list(each.options), list(each.options)) for each in known]


@pytest.mark.parametrize("name", ["1.4", "3.1"])
def test_hints_get_more_explicit(name: str) -> None:
    *hints, again = (hint(name).text for _ in range(4))
    assert [text[:13] for text in hints] == [f"Hint {number} of 3: " for number in (1, 2, 3)]
    assert len(set(hints)) == 3
    assert again == hints[-1]
