"""Races whose perfect play is known: what is true of them, and which measure says so."""

import json
from pathlib import Path

import numpy as np
import pytest

import ground_truth
from evolution_scripts import DOCS, RESULTS, read, run_quickly
from matrixworld.coevolution import open_run
from matrixworld.solve import best_response

UP, FLAT, DOWN = np.linspace(0.1, 0.2, 21), np.full(21, 0.1), np.linspace(0.2, 0.1, 21)


@pytest.mark.parametrize(
    ("pursuers", "evaders", "arms", "one_sided", "rise", "stagnation"),
    [
        (UP, UP, True, False, True, False),
        (UP, DOWN, False, True, True, False),
        (FLAT, UP, False, True, True, False),
        (FLAT, DOWN, False, False, False, False),
        (FLAT, FLAT + 0.001, False, False, False, True),
        (UP, FLAT + (UP - 0.1) / 10, None, None, True, False),
        (FLAT, FLAT + (UP - 0.1) / 10, False, None, None, None),
    ],
)
def test_what_is_true_of_a_race_follows_from_what_its_teams_guarantee(
    pursuers, evaders, arms, one_sided, rise, stagnation
):
    truth = np.array([pursuers, evaders])
    found = {name: holds for name, (holds, _) in ground_truth.truths_of(truth, "whole").items()}
    expected = (arms, one_sided, rise, stagnation)
    names = ("arms race", "one-sided progress", "rise", "stagnation")
    assert found == dict(zip(names, expected, strict=True))


def test_a_measure_that_says_the_truth_correlates_and_its_opposite_does_not():
    skills = np.random.default_rng(0).uniform(0.1, 0.9, (3, 8))  # of schedules and seeds
    courses = np.linspace(0.0, skills, 3, axis=-1)
    for sign in (1, -1):
        said = 0.5 + sign * courses
        assert ground_truth.between_races(said[..., -1], skills).value == pytest.approx(sign)
        changes = map(ground_truth.linear_change, (said, courses))
        assert ground_truth.between_races(*changes).value == pytest.approx(sign)
        assert ground_truth.within_races(said, courses).value == pytest.approx(sign)


@pytest.mark.slow
def test_intervals_of_correlations_over_races_hold_without_a_relation():
    """Of 100 samples of ten seeds without a relation, few intervals exclude 0."""
    missed = 0
    for sample in range(100):
        both = np.random.default_rng(sample).uniform(0.1, 0.9, (2, 4, 10))
        found = ground_truth.between_races(*both)
        missed += not found.low <= 0.0 <= found.high
    assert missed <= 12


def test_the_page_shows_the_published_tables():
    told, page = read(RESULTS / "ground_truth" / "table.md"), read(DOCS / "ground_truth.md")
    for heading in ("What the teams guarantee", "Correlations with the truth"):
        table = told.split(f"## {heading}", 1)[1].split("\n\n| ", 1)[1].split("\n\n", 1)[0]
        assert table.strip() in page


@pytest.mark.nightly
def test_the_script_plays_solves_and_goes_on_where_it_stopped(tmp_path: Path):
    options = ("--threads", "1", "--kinds", "generalist-generalist")
    printed = run_quickly("validation/ground_truth", tmp_path, *options)
    results = tmp_path / "ground_truth" / "quick"
    assert printed.startswith(read(results / "table.md"))
    run = open_run(tmp_path / "runs/ground_truth/quick/generalist-generalist/1")
    last = run.last("evader")
    best = best_response(run.settings.world, last, "evader").value
    kept = run.path.with_suffix(".json")
    assert json.loads(read(kept))["truth"][1][-1] == pytest.approx(1 - best)
    written = kept.stat().st_mtime_ns
    assert run_quickly("validation/ground_truth", tmp_path, *options) == printed
    assert kept.stat().st_mtime_ns == written
