"""What texts of the course tell follows from their toys and games."""

import runpy
import sys

import pytest

from course import kept
from notebooks import TUTORIALS


@pytest.mark.slow
def test_kept_numbers_are_those_of_their_seeds():
    make = TUTORIALS / "make"
    sys.path.append(str(make))  # scripts of one directory import each other
    told = kept("told")
    for name, (numbers, seeds) in runpy.run_path(str(make / "told.py"))["SOURCES"].items():
        for key, value in numbers(seeds[0]).items():
            assert told[f"{name}: {key}"].shape == (len(seeds),)
            assert told[f"{name}: {key}"][0] == pytest.approx(value), (name, key)
