"""Progress of a job: lines, or bars in a terminal."""

import io
import re
from collections.abc import Iterator

from matrixworld.coevolution import Progress, ProgressBar


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


def test_progress_lines_without_a_terminal():
    seconds: Iterator[float] = iter([0.0, 1.0, 2.0, 3.0, 4.0])
    out = io.StringIO()
    lines = ProgressBar(stream=out, clock=lambda: next(seconds))
    for done in (100, 150, 300, 350, 600):
        lines(Progress("evaders", done, 1000, 100))
    assert out.getvalue().splitlines() == ["evaders:  30%  00:07 left", "evaders:  60%  00:03 left"]


def test_a_bar_in_a_terminal_begins_with_what_is_done():
    out = Terminal()
    with ProgressBar(stream=out, clock=iter([0.0, 0.1, 1.0]).__next__) as bar:
        bar(Progress("0 of 3 runs", 20, 300))
        bar(Progress("too early", 21, 300))
        bar(Progress("1 of 3 runs", 150, 300))
    said = out.getvalue()
    assert "too early" not in said
    assert re.search(r"\r1 of 3 runs:  50%\|[#█]{8} {8}\| .* left", said)
