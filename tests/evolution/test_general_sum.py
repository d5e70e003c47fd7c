"""The benchmark of games with scores of both teams, and of one population: truths and tables."""

import sys

import numpy as np
import pytest

import general_sum as benchmark
from evolution_scripts import RESULTS, read
from general_sum import ONE, ONE_GENERAL, SECOND, TWO, Race
from judgement_tables import read_counts

T, F, OPEN = True, False, None


def ahead(generations, size):
    """Return how far g is ahead of h: rows beat the columns before them."""
    return size * np.subtract.outer(np.arange(generations), np.arange(generations))


def test_truths_of_a_dilemma_by_hand():
    # Each generation gains .04 and takes .1 from the other team.
    g, h = np.indices((6, 6))
    race = Race(0.7 + 0.04 * g - 0.1 * h, 0.7 + 0.04 * h - 0.1 * g, drifts=True)
    assert benchmark.truths(TWO, [race]) == {
        "joint rise": F, "joint fall": T, "cycling": F, "progress": T, f"progress{SECOND}": T,
        "rise": T, f"rise{SECOND}": T, "forgetting": F, f"forgetting{SECOND}": F,
    }  # fmt: skip
    # Pairs of contemporaries after the first one: (k, k) with .7 - .06 k, two others with .03 more.
    assert benchmark.joint_course(race)[:3] == pytest.approx([0.7, 0.66, 0.6])


def test_truths_of_a_circle_by_hand():
    scores = 0.5 + 0.3 * np.sin(ahead(12, np.pi / 3))  # 12 generations: twice around
    race = Race(scores, 1.0 - scores, cycles=True)
    assert benchmark.truths(ONE, [race]) == {
        "intransitivity": T, "cycling": T, "progress": F, "rise": F, "forgetting": T,
        "stagnation": F,
    }  # fmt: skip


def test_truths_of_a_regress_by_hand():
    course = np.array([0.1, 0.4, 0.4, 0.2, 0.1, 0.0])
    scores = 0.3 + course[:, None] + np.zeros(6)  # what one does is all the same to the other
    race = Race(scores, scores.T, drifts=None)
    assert benchmark.late_drop(scores) == pytest.approx(0.3)
    assert benchmark.truths(ONE_GENERAL, [race]) == {
        "joint rise": F, "joint fall": T, "cycling": F, "progress": OPEN, "rise": F,
        "forgetting": T,
    }  # fmt: skip


def test_truths_of_groups():
    still, rises = (Race(0.5 + ahead(6, x), 0.5 - ahead(6, x), drifts=x > 0) for x in (0.0, 0.05))
    rise = [
        benchmark.truths(ONE, races)["rise"]
        for races in ([still, rises, rises], [rises] * 3, [still] * 5 + [rises], [still] * 7)
    ]
    assert rise == [OPEN, T, F, F]  # of six a sixth of .25
    assert benchmark.truths(ONE, [still])["stagnation"] is T


def test_matches_of_one_population_are_mirrored():
    race = benchmark.one_constant(5, benchmark.Draws(3), own=benchmark.walk)
    setting = benchmark.Setting("5", "1", "4", "smooth")
    scores = benchmark.play(ONE, [race], setting, np.random.default_rng(0)).scores
    assert scores + scores.swapaxes(1, 2) == pytest.approx(np.ones((1, 5, 5, 4)))
    both = benchmark.play(ONE_GENERAL, [race], setting, np.random.default_rng(0))
    assert np.array_equal(both.others, both.scores.swapaxes(1, 2))


def test_means_of_matches_are_the_rates():
    race = benchmark.two_teams(4, benchmark.Draws(1), own=benchmark.rise)
    for noise in benchmark.SETTINGS["noise"]:
        setting = benchmark.Setting("4", "1", "4000", noise)
        played = benchmark.play(TWO, [race], setting, np.random.default_rng(0))
        assert played.matrices[0] == pytest.approx(race.first, abs=0.04)
        assert played.others.mean(axis=3)[0] == pytest.approx(race.second, abs=0.04)


def test_a_short_run_writes_tables_that_follow_from_its_counts(tmp_path, monkeypatch, capsys):
    few = {TWO: ("dilemma",), ONE: ("no change",), ONE_GENERAL: ("styles return",)}
    chosen = {game: {n: benchmark.OPTIONS[game][n] for n in names} for game, names in few.items()}
    monkeypatch.setattr(benchmark, "OPTIONS", chosen)
    monkeypatch.setattr(sys, "argv", ["general_sum.py", "--races", "2", "--out", str(tmp_path)])
    benchmark.main()
    assert "| joint fall |" in capsys.readouterr().out
    assert read(tmp_path / "table.md") == benchmark.report_of(tmp_path)
    rows = read_counts(tmp_path / "counts.csv")
    falls = [row for row in rows if row["condition"] == "joint fall" and row["game"] == TWO]
    lacks, _, has, *_ = benchmark.cells(falls, by="family")
    assert int(lacks) + int(has) == 2


def test_counts_by_hand():
    def row(truth, present, absent, cannot_tell):
        return {"truth": truth, "present": present, "absent": absent, "cannot tell": cannot_tell}

    rows = [row("True", "6", "1", "3"), row("False", "0", "5", "0"), row("False", "1", "4", "0")]
    assert benchmark.cells(rows) == [
        "10", "10.0% (0.3 to 44.5)", "10", "10.0% (0.3 to 44.5)", "60.0% (26.2 to 87.8)",
    ]  # fmt: skip
    assert benchmark.share(0, 0) == "-"


def test_the_published_table_follows_from_the_published_counts():
    published = RESULTS / "general_sum"
    assert read(published / "table.md") == benchmark.report_of(published)
