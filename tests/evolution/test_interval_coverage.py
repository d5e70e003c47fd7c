"""Coverage of the package's intervals: the committed counts, and the script that makes them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import interval_coverage as coverage
from evolution_scripts import RESULTS, read, run_quickly
from matrixworld.analysis import MEASURES, read_payoffs
from matrixworld.analysis.judge import RULES

PUBLISHED = RESULTS / "coverage"
SCORES = read_payoffs(np.random.default_rng(0).random((14, 14, 9)), per_episode=True)


def test_committed_table_follows_from_committed_counts() -> None:
    counts = coverage.read_counts(PUBLISHED / "coverage.csv")
    assert read(PUBLISHED / "coverage.md") == coverage.table(counts) + "\n"
    assert all(0 <= row.covered <= row.given <= row.repetitions == 400 for row in counts)


def test_normal_runs_are_covered_in_93_to_97_percent() -> None:
    counts = coverage.read_counts(PUBLISHED / "coverage.csv")
    for interval in ("mean of runs", "difference of runs"):
        rows = [row for row in counts if (row.interval, row.data) == (interval, "normal")]
        assert [row.samples for row in rows] == [2, 3, 5, 10, 20]
        covered, given = (sum(getattr(row, name) for row in rows) for name in ("covered", "given"))
        assert 0.93 < covered / given < 0.97


def test_intervals_over_episodes_cover_at_least_90_percent() -> None:
    counts = coverage.read_counts(PUBLISHED / "coverage.csv")
    published = {row.interval for row in counts}
    # The measures of the evaders are those of the pursuers on the swapped matrix.
    decided = {name for names, _ in RULES.values() for name in names}
    unbiased = {
        name
        for name, one in MEASURES.items()
        if name not in decided and one.of(SCORES).across == "episodes"
    }
    assert {name.replace("evader", "pursuer") for name in unbiased} <= published
    for row in counts:
        # A flat matrix has no true transitive share, and hardly ever gets an interval.
        if (row.interval, row.data.split(",")[0]) == ("transitive_share", "flat"):
            assert row.given <= 0.1 * row.repetitions, row
        elif row.interval in unbiased and row.given >= 100:
            assert row.covered >= 0.9 * row.given, row


def test_aggregates_over_runs_are_withheld_below_six_and_cover_from_ten_on() -> None:
    counts = coverage.read_counts(PUBLISHED / "coverage.csv")
    for interval in ("interquartile mean", "performance profile", "probability of improvement"):
        rows = [row for row in counts if row.interval == interval]
        assert {row.samples for row in rows} == {3, 5, 6, 10, 20}
        assert len({row.data.split(", profile")[0] for row in rows}) == 4
        assert not any(row.given for row in rows if row.samples < 6)
        assert all(row.covered >= 0.9 * row.given for row in rows if row.samples >= 10)
        assert all(row.given >= 0.85 * row.repetitions for row in rows if row.samples >= 6)


@pytest.mark.slow
def test_the_script_writes_counts_and_their_table(tmp_path: Path) -> None:
    printed = run_quickly("interval_coverage", tmp_path)
    counts = coverage.read_counts(tmp_path / "coverage/coverage.csv")
    assert printed.startswith(coverage.table(counts))
    assert read(tmp_path / "coverage/coverage.md") == coverage.table(counts) + "\n"
    assert {row.repetitions for row in counts} == {20}
    assert min(row.given for row in counts if row.interval == "mean of episodes") == 20


def test_a_table_lists_the_worst_case_and_exceptions() -> None:
    counts = [
        coverage.Count("mean", "even", 0, 5, 200, 200, 190),
        coverage.Count("mean", "odd", 8, 5, 200, 100, 80),
        coverage.Count("mean", "rare", 0, 5, 200, 10, 0),
    ]
    lines = coverage.table(counts).splitlines()
    assert lines[2] == "| mean | 5 | 52% | 87.1% | 80.0% | odd, 8 x 8 |"
    assert lines[-1] == "- mean, odd, 8 x 8: 80.0% at 5"
    assert "- " not in coverage.table(counts[:1]).split("Exceptions")[1]
