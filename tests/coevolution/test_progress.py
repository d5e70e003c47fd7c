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
    assert out.getvalue().splitlines() == [
        " 30%  00:07 left, 100 matches/s, 300 of 1.00k, evaders",
        " 60%  00:03 left, 125 matches/s, 600 of 1.00k, evaders",
    ]


def test_progress_lines_of_a_job():
    out = io.StringIO()
    lines = ProgressBar(stream=out)
    for done in range(0, 101, 5):
        runs = {"seed-1": Progress("generation 1", done, 200)}
        what = "1 of 4 runs, 1 failed" if done > 50 else "1 of 4 runs"
        lines(Progress(what, done, 100, 0, runs))
    said = out.getvalue().splitlines()
    assert len(said) == 10
    assert re.fullmatch(
        r" 10%  .* left, .* matches/s, 10.0 of 100, 1 of 4 runs, seed-1 5%", said[0]
    )
    assert said[-1].endswith(", 1 of 4 runs, 1 failed, seed-1 50%")


def test_bars_in_a_terminal_have_a_line_for_each_run_in_work():
    out = Terminal()
    with ProgressBar(stream=out, clock=iter([0.0, 0.1, 1.0]).__next__) as bar:
        runs = {f"seed-{seed}": Progress("generation 1", 10, 100) for seed in range(2)}
        bar(Progress("0 of 3 runs", 20, 300, 0, runs))
        bar(Progress("too early", 21, 300, 0, runs))
        del runs["seed-0"]
        bar(Progress("1 of 3 runs", 150, 300, 0, runs))
    said = out.getvalue()
    assert "seed-0: generation 1" in said
    assert "too early" not in said
    assert re.search(r" 50%\|[#█]{8} {8}\| .* left, .*matches/s, 150 of 300, 1 of 3 runs", said)
