"""Bars of the progress of runs, and of parts of them."""

import io

from matrixworld import coevolution as co
from matrixworld.coevolution.progress import part_of


def test_a_bar_shows_runs_and_then_shares_of_other_work():
    out = io.StringIO()
    with co.ProgressBar(stream=out, clock=iter([0.0, 1.0, 2.0, 3.0, 4.0]).__next__) as bar:
        bar(co.Progress("", 3, 3))
        bar.share("", 0.5)
        bar.share("", 0.75)
        bar.share("scores", 0.0)
    assert out.getvalue().splitlines()[0].startswith(" 75%")


def test_a_part_of_a_whole_counts_what_was_played_before():
    reports = []
    part_of(reports.append, 1, 4, "run 2: ")(co.Progress("scores", 5, 10, before=3))
    assert reports == [co.Progress("run 2: scores", 15, 40, before=3)]
