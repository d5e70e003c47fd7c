"""The benchmark of the judgement: races whose truth is known, counts, tables and files."""

import numpy as np
import pytest

import judgement_tables as tables
from judgement_races import SyntheticRace, synthetic_races
from judgement_truths import truths
from matrixworld.analysis import CONDITIONS


def held(found):
    return {condition: truth.holds for condition, truth in found.items()}


def what_holds(kind, window="whole", **options):
    """Return, for each condition, what is true of ten races of a kind."""
    found = [truths(synthetic_races(kind, 40, seed, **options)[0], window) for seed in range(10)]
    return [{one[condition].holds for one in found} for condition in CONDITIONS]


T, F, OPEN, ANY = {True}, {False}, {None}, None


@pytest.mark.parametrize(
    ("kind", "window", "expected"),
    [
        ("pure race", "whole", [F, T, F, F, F, F, F]),
        ("two skills", "last half", [F, T, F, F, F, F, F]),
        ("only pursuers rise", "first half", [F, F, T, F, F, F, F]),
        ("cycle", "whole", [F, F, F, T, T, T, F]),
        ("cycle on a climb", "whole", [F, T, F, T, T, T, F]),
        ("wave, then race", "last half", [F, T, F, F, F, F, F]),
        ("noise only, .1", "whole", [F, F, F, F, F, F, T]),
        ("early stagnation", "last half", [F, F, F, F, F, F, T]),
        ("disengagement, .95", "last half", [F, F, F, F, F, F, T]),
        ("disengagement, .985", "last half", [T, OPEN, OPEN, OPEN, OPEN, OPEN, OPEN]),
        # Losses are forgetting and no arms race; a jump and chance are no arms race.
        ("decline", "last half", [ANY, F, T, F, F, T, ANY]),
        ("single jump", "whole", [ANY, F, F, F, F, ANY, ANY]),
        ("drift", "whole", [ANY, F, F, F, F, ANY, ANY]),
        ("fluctuation", "whole", [ANY, F, F, F, F, ANY, ANY]),
        ("period 2", "whole", [ANY, ANY, ANY, T, T, ANY, ANY]),
    ],
)
def test_what_is_true_of_kinds(kind, window, expected):
    # Whether the played strength rises in a steady way depends on the nuisance parameters.
    known = dict(zip(CONDITIONS, what_holds(kind, window), strict=True))
    del known["rise"]
    for (condition, found), wanted in zip(known.items(), expected, strict=True):
        # Nuisance parameters may leave a few races open, and never turn the truth round.
        assert wanted is ANY or wanted <= found <= wanted | OPEN, condition


@pytest.mark.parametrize("kind", ["switch of style", "three styles", "slow turn", "new styles"])
def test_what_does_not_return_is_no_cycle(kind):
    circles, cycling = what_holds(kind)[4:6]
    assert True not in cycling
    assert kind == "slow turn" or True in circles <= T | OPEN


def test_truth_of_a_return_by_hand():
    # Both teams change sides: after one generation the opposite, after two the same.
    sign = np.array([1.0, -1.0] * 4)
    still = np.zeros(8)
    race = SyntheticRace(0.5 + 0.3 * np.outer(sign, sign), still, still)
    assert truths(race, "whole")["cycling"] == (True, pytest.approx(1.0))


def test_truth_of_a_rise_by_hand():
    def arms_race(course):
        rates = 0.5 + (course[:, None] - course) / 20
        return truths(SyntheticRace(rates, course, course), "whole")["arms race"].holds

    even, jump = np.arange(8.0), (np.arange(8) >= 4) * 4.0
    burst = np.array([0, 1, 1, 1, 1, 5, 6, 7])  # neither steady nor a single jump
    found = [arms_race(course) for course in (even, jump, burst, -even, 0 * even)]
    assert found == [True, False, None, False, False]


def test_truth_of_a_drop_by_hand():
    rates = np.full((8, 8), 0.5)
    rates[6:] -= 0.2  # pursuers lose .2 in half of the later half
    race = SyntheticRace(rates, np.zeros(8), np.zeros(8))
    assert truths(race, "whole")["forgetting"] == (True, pytest.approx(0.1))
    assert truths(race, "first half")["forgetting"] == (False, 0.0)


def judgement(kind, found, **setting):
    return {
        "source": "synthetic", "kind": kind, "seed": 0, "changes": [],
        "setting": {"noise": "win or loss, 10", "runs": "1", "episodes known": "unknown"} | setting,
        "found": found,
        "with_outliers": [
            [w, name, holds, v] for w, name, holds, _, v in found if name in tables.PROGRESS
        ],
    }  # fmt: skip


def test_counts_by_hand():
    both = [
        judgement("cycle", [["last half", "cycling", True, 0.1, "present"]]),
        judgement("cycle", [["last half", "cycling", True, 0.1, "absent"]]),
        judgement("decline", [["whole", "cycling", False, 0.0, "present"]]),
        judgement("decline", [["last half", "cycling", None, 0.0, "present"]]),
    ]
    counts = tables.count_verdicts(both)
    assert tables.totals(counts, truth="True") == {"present": 1, "absent": 1, "cannot tell": 0}
    assert [row["sample"] for row in counts] == ["development", "held back"]
    # Only the whole race.
    by_setting = tables.count_by_setting(both)
    assert tables.totals(by_setting, truth="True")["present"] == 0
    assert tables.totals(by_setting, setting="runs", value="1")["present"] == 1
    text = tables.report([], counts, by_setting, [], [])
    assert "| cycling | development | 2 | 50.0% | 50.0% | 0.0% | 0 | - | - | - | - |" in text
    assert "| cycling | held back | decline | whole | 1 of 1 | 100.0% | yes |" in text


def test_a_race_counts_once():
    race = [
        [window, "arms race", truth, 0.1, "present"]
        for window, truth in (("whole", True), ("first half", False), ("last half", False))
    ]
    wrong = [["whole", "arms race", False, 0, "absent"], ["whole", "cycling", False, 0, "present"]]
    rows = tables.count_races([judgement("pure race", race), judgement("drift", wrong, runs="3")])
    counted = {(r["kind"], r["runs"]): [*map(int, list(r.values())[3:])] for r in rows}
    assert counted == {
        ("drift", "2 or 3"): [1, 0, 0, 1, 0, 0],
        ("pure race", "1"): [1, 1, 1, 1, 1, 1],
    }
