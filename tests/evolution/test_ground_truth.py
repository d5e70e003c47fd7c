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


def numbers_of_races(said):
    """Return races of 12 seeds in three worlds, half of which rise; a measure says what it says."""
    rising = np.linspace(0.1, 0.2, 21) * np.ones((12, 2, 1))
    truth = np.where(np.arange(12)[:, None, None] % 2, rising, 0.1)
    kinds = [f"{world}, generalists" for world in ground_truth.WORLDS]
    return {
        f"{kind} / {name}": each
        for kind in kinds
        for name, each in {
            "truth": truth,
            **dict.fromkeys(ground_truth.MEASURES | ground_truth.RATINGS, said(truth)),
        }.items()
    }


def cells_of(table, row):
    line = next(line for line in table.splitlines() if line.startswith(f"| {row}"))
    return [cell.strip() for cell in line.strip("|").split("|")][1:]


def test_a_measure_that_says_the_truth_has_hits_alone_and_its_opposite_false_alarms():
    honest, liar = numbers_of_races(lambda x: x), numbers_of_races(lambda x: 0.3 - x)
    alarmed = numbers_of_races(lambda x: np.linspace(0, 1, 21) * np.ones_like(x))
    for numbers, hits, alarms, at_equal_hits, area in (
        (honest, "1.00", "0.00", "0.00", "1.00"), (liar, "0.00", "0.00", "1.00", "0.00"),
        (alarmed, "1.00", "1.00", "1.00", "0.50"),
    ):  # fmt: skip
        cells = cells_of(ground_truth.table_of_rises(numbers), "held-out")
        assert [cell.split()[0] for cell in cells] == [hits, alarms, at_equal_hits, area] * 2
        _, areas, _, false = ground_truth.table_of_worlds(numbers)
        *worlds, over_worlds, more = cells_of(areas, "Soft")
        assert cells_of(false, "held-out")[:-2] == [alarms] * 8
        # Only races of the five worlds have ratings; here they say what all measures say.
        assert worlds == ["-"] * 3 + [area] * 5
        assert (over_worlds, more) == (area, "+0.00")
    control = cells_of(ground_truth.table_of_control(alarmed), "Elo")
    assert [cell.split()[0] for cell in control] == ["1.00", "1.00"]


def test_ratings_count_clones_once_and_find_who_wins_all_votes():
    hands = np.array([[0.5, 0.0, 1.0], [1.0, 0.5, 0.0], [0.0, 1.0, 0.5]])
    twice = hands[np.ix_([0, 0, 1, 2], [0, 0, 1, 2])]  # rock is there twice
    worse = np.vstack([twice, twice[3] - 0.1])
    ratings = ground_truth.deviation_ratings(worse)
    assert ratings == pytest.approx([0.5, 0.5, 0.5, 0.5, 0.4], abs=1e-3)
    best, *others = ground_truth.soft_condorcet(np.array([[0.6] * 3, [0.5, 0.7, 0.5], [0.4] * 3]))
    assert best > max(others)


def test_a_choice_by_the_truth_loses_nothing_and_one_by_its_opposite_all():
    for said, lost, order in ((lambda x: x, 0.0, 1.0), (lambda x: 0.3 - x, 0.05, -1.0)):
        cells = cells_of(ground_truth.table_of_choices(numbers_of_races(said)), "held-out")
        found = [float(cell.split()[0]) for cell in cells]
        assert found == pytest.approx([lost, lost, order, order], abs=1e-3)


@pytest.mark.nightly
def test_the_script_plays_solves_and_goes_on_where_it_stopped(tmp_path):
    options = ("--threads", "1", "--kinds", "chase-generalists")
    printed = run_quickly("validation/ground_truth", tmp_path, *options)
    results = tmp_path / "ground_truth" / "quick"
    assert printed.startswith(read(results / "table.md"))
    run = open_run(tmp_path / "runs/ground_truth/quick/chase-generalists/1")
    last = run.last("evader")
    best = best_response(run.settings.world, last, "evader").value
    kept = run.path.with_suffix(".json")
    assert json.loads(read(kept))["truth"][1][-1] == pytest.approx(1 - best)
    written = kept.stat().st_mtime_ns
    assert run_quickly("validation/ground_truth", tmp_path, *options) == printed
    assert kept.stat().st_mtime_ns == written
