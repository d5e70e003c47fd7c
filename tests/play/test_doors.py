"""Every call that takes players takes every kind of them, or says why not."""

from pathlib import Path

import pytest

import doors

PAGE = Path(__file__).parents[2] / "docs" / "players.md"


@pytest.mark.parametrize("kind", doors.KINDS)
def test_the_table_of_doors_is_what_happens(kind):
    if not doors.available(kind):
        pytest.skip("torch is not installed")
    assert doors.row(kind) in PAGE.read_text(encoding="utf-8").splitlines()


def test_the_table_has_all_calls():
    assert doors.HEAD in PAGE.read_text(encoding="utf-8")
