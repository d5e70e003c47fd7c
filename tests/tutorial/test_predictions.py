"""Predictions: the options in the text of a notebook are those that `check` knows."""

from __future__ import annotations

import re

import pytest

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
