"""What commands print while they work: progress as lines or as a bar, and warnings."""

from __future__ import annotations

import io
import re
import warnings
from collections.abc import Iterator

import pytest
from tqdm import tqdm

from matrixworld.cli.console import ProgressLines, progress, warnings_as_notes
from matrixworld.coevolution import DisengagementWarning, ProgressBar
from matrixworld.coevolution.progress import LAYOUT


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


def test_progress_lines_without_a_terminal():
    seconds: Iterator[float] = iter([0.0, 2.0, 4.0])
    out = io.StringIO()
    lines = ProgressLines(out, clock=lambda: next(seconds))
    for done in (100, 150, 300, 350, 600):
        lines("evaders", done, 1000)
    assert out.getvalue().splitlines() == [
        " 30%  300 of 1,000 matches, 100 a second, 00:07 left (evaders)",
        " 60%  600 of 1,000 matches, 125 a second, 00:03 left (evaders)",
    ]


def test_progress_bar_in_a_terminal():
    with progress(Terminal()) as report_bar, progress(io.StringIO()) as report_lines:
        assert isinstance(report_bar, ProgressBar)
        assert isinstance(report_lines, ProgressLines)


@pytest.mark.parametrize("columns", [60, 100])
def test_a_narrow_terminal_shows_bar_and_time_left(columns):
    meter = tqdm.format_meter(
        116_000,
        260_000,
        45.3,
        ncols=columns,
        prefix="[2/3] pursuers, generation 12 of 30",
        unit=" matches",
        unit_scale=True,
        bar_format=LAYOUT,
    )
    assert len(meter) <= columns
    assert re.match(r" 45%\|█{7}. {8}\| 00:56 left, 2.56k matches/s", meter)


def test_warnings_for_users_are_lines_of_their_own(capsys):
    with warnings_as_notes():
        warnings.warn("the pursuers win nearly everything", DisengagementWarning, stacklevel=1)
    assert capsys.readouterr().err == "Warning: the pursuers win nearly everything\n"
    with pytest.raises(DeprecationWarning), warnings_as_notes():
        warnings.warn("for developers", DeprecationWarning, stacklevel=1)
