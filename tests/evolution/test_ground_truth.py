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
    row = {"truth": {"pursuer": list(pursuers), "evader": list(evaders)}}
    found = {name: holds for name, (holds, _) in ground_truth.truths_of(row, "whole").items()}
    expected = (arms, one_sided, rise, stagnation)
    names = ("arms race", "one-sided progress", "rise", "stagnation")
    assert found == dict(zip(names, expected, strict=True))


def made(seed: int, skill: float, said: float) -> ground_truth.Row:
    """A race of three generations that ends with this skill, and what a measure says of it."""
    course, measured = np.linspace(0.0, skill, 3), np.linspace(0.5, said, 3)
    row = {"schedule": "psro", "seed": seed, "truth": {}, "measures": {}}
    for team in ("pursuer", "evader"):
        row["truth"][team], row["measures"][team] = list(course), {"all": list(measured)}
    return row


def test_a_measure_that_says_the_truth_correlates_and_its_opposite_does_not():
    rng = np.random.default_rng(0)
    skills = rng.uniform(0.1, 0.9, 24)
    for sign in (1, -1):
        rows = [made(k // 3, skill, 0.5 + sign * skill) for k, skill in enumerate(skills)]
        for number in (ground_truth.last_of, ground_truth.linear_change):
            found = ground_truth.between_races(rows, "evader", "all", number)
            assert found.value == pytest.approx(sign)
        assert ground_truth.within_races(rows, "pursuer", "all").value == pytest.approx(sign)
    assert ground_truth.between_races(rows, "evader", "elo", ground_truth.last_of) is None


@pytest.mark.slow
def test_intervals_of_correlations_over_races_hold_without_a_relation():
    """Of 100 samples of ten seeds without a relation, few intervals exclude 0."""
    missed = 0
    for sample in range(100):
        skills, said = np.random.default_rng(sample).uniform(0.1, 0.9, (2, 40))
        rows = [made(k // 4, *both) for k, both in enumerate(zip(skills, said, strict=True))]
        found = ground_truth.between_races(rows, "pursuer", "all", ground_truth.last_of)
        missed += not found.low <= 0.0 <= found.high
    assert missed <= 12


def test_the_page_shows_the_published_tables():
    told, page = read(RESULTS / "ground_truth" / "measures.md"), read(DOCS / "ground_truth.md")
    for heading in ("What the teams guarantee", "Correlations with the truth"):
        table = told.split(f"## {heading}", 1)[1].split("\n\n| ", 1)[1].split("\n\n", 1)[0]
        assert table.strip() in page


@pytest.mark.nightly
def test_the_script_plays_solves_and_goes_on_where_it_stopped(tmp_path: Path):
    options = ("--threads", "1", "--responses", "--schedules", "generalist-generalist")
    printed = run_quickly("validation/ground_truth", tmp_path, *options)
    results = tmp_path / "ground_truth"
    assert {path.name for path in results.iterdir()} == {
        "races.json",
        "measures.md",
        "measures.png",
    }
    assert printed.startswith(read(results / "measures.md"))
    run = open_run(tmp_path / "runs/ground_truth/generalist-generalist/seed-1")
    last = run.last("evader")
    best = best_response(run.settings.world, last, "evader").value
    kept = tmp_path / "runs/ground_truth/numbers/generalist-generalist-1.json"
    assert json.loads(read(kept))["truth"]["evader"][-1] == pytest.approx(1 - best)
    written = kept.stat().st_mtime_ns
    assert run_quickly("validation/ground_truth", tmp_path, *options) == printed
    assert kept.stat().st_mtime_ns == written
