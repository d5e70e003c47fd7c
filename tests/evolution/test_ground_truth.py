"""Races whose perfect play is known: what is true of them, and which measure says so."""

import json

import numpy as np
import pytest

import ground_truth
from evolution_scripts import read, run_quickly
from matrixworld.coevolution import open_run
from matrixworld.solver import best_response

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


def test_ratings_count_clones_once_and_find_who_wins_all_votes():
    hands = np.array([[0.5, 0.0, 1.0], [1.0, 0.5, 0.0], [0.0, 1.0, 0.5]])
    twice = hands[np.ix_([0, 0, 1, 2], [0, 0, 1, 2])]  # rock is there twice
    worse = np.vstack([twice, twice[3] - 0.1])
    ratings = ground_truth.deviation_ratings(worse)
    assert ratings == pytest.approx([0.5, 0.5, 0.5, 0.5, 0.4], abs=1e-3)
    best, *others = ground_truth.soft_condorcet(np.array([[0.6] * 3, [0.5, 0.7, 0.5], [0.4] * 3]))
    assert best > max(others)


@pytest.mark.nightly
def test_the_script_plays_solves_and_goes_on_where_it_stopped(tmp_path):
    options = ("--threads", "1", "--kinds", "chase-generalists")
    printed = run_quickly("validation/ground_truth", tmp_path, *options)
    results = tmp_path / "ground_truth" / "quick"
    assert printed.startswith(read(results / "table.md"))
    run = open_run(tmp_path / "runs/ground_truth/quick/chase-generalists/1")
    last = run.last("evader")
    best = best_response(run.settings.game.world, last, "evader").value
    kept = run.path.with_suffix(".json")
    assert json.loads(read(kept))["truth"][1][-1] == pytest.approx(1 - best)
    written = kept.stat().st_mtime_ns
    assert run_quickly("validation/ground_truth", tmp_path, *options) == printed
    assert kept.stat().st_mtime_ns == written
