"""Notebook 7: whether what it says is true."""

from __future__ import annotations

import numpy as np
import pytest

from matrixworld import analysis, toys
from matrixworld.coevolution import competitive_sharing, reduced_virulence
from matrixworld.tutorial import kept
from matrixworld.tutorial.chapter_7 import (
    UNKNOWN,
    is_disengaged,
    reveal,
    unknown_races,
    verdict_of,
)


def test_four_of_five_wins_are_as_good_as_five_up_to_nine_tenths() -> None:
    four, five = reduced_virulence([4, 5], 0.9)
    assert four == pytest.approx(five)
    same = [toys.hosts_and_parasites(v, 0, generations=60).ones for v in (1.0, 0.95)]
    assert np.array_equal(*same)


def test_hosts_and_parasites_do_what_the_predictions_say() -> None:
    """Also in the short races of a quick run."""
    greedy, restrained = (
        np.array(
            [toys.hosts_and_parasites(v, s, generations=150).final_objective for s in range(3)]
        )
        for v in (1.0, 0.75)
    )
    assert (abs(greedy[:, 0] - 50) < 10).all()
    assert (restrained[:, 0] > 85).all()
    assert (restrained[:, 1] > greedy[:, 1]).all()


def test_a_rare_winner_is_rarely_a_parent() -> None:
    wins = np.zeros((20, 10))
    wins[:19, :9], wins[19, 9] = 1.0, 1.0
    for fitness, chance in ((wins.sum(axis=1), 0.11), (competitive_sharing(wins), 0.88)):
        assert 1 - (1 - fitness[19] / fitness.sum()) ** 20 == pytest.approx(chance, abs=0.005)


def test_the_races_to_judge_are_of_both_sorts_and_need_many_episodes() -> None:
    truths = [is_disengaged(*each) for each in UNKNOWN]
    assert sum(truths) == 4
    few, many = ([verdict_of(race) for race in unknown_races(episodes)] for episodes in (10, 50))
    assert "present" not in few
    assert [verdict == "present" for verdict in many] == truths


def test_the_truth_is_shown_beside_the_verdicts() -> None:
    races = unknown_races(episodes=4)
    right = ["yes" if is_disengaged(*each) else "no" for each in UNKNOWN]
    assert "0 false alarms" in reveal(right, races)
    assert "and 0 of 4 disengaged ones missed" in reveal(right, races)
    swapped = ["no" if each == "yes" else "yes" for each in right]
    assert "4 false alarms" in reveal(swapped, races)
    assert "and 4 of 4" in reveal(swapped, races)
    for wrong in (..., "yes", ["yes"], ["maybe"] * 8):
        assert "truth" not in reveal(wrong, races)


def test_the_kept_races_show_what_the_notebook_says() -> None:
    stored = kept("chapter_7")
    shape = (10, 15, 15, 30)
    kinds = ("even", "few evader epochs", "no overlap penalty", "restrained pursuers")
    assert all(stored[f"captured: {kind}"].shape == shape for kind in kinds)
    present = {}
    for kind in kinds:
        found = analysis.judge(stored[f"captured: {kind}"] / stored["evaders"], per_episode=True)
        verdicts = found.windows["last half"]["disengagement"].by_run
        present[kind] = verdicts.count("present")
    assert present["few evader epochs"] >= 7
    assert 5 <= present["restrained pursuers"] <= 8
    assert max(present["even"], present["no overlap penalty"]) <= 2
    assert stored["has not: disengagement"][0] == 0
