"""Notebook 5: its four races, and the numbers of its text."""

from __future__ import annotations

import numpy as np
import pytest

from matrixworld import analysis, coevolution
from matrixworld.tutorial import check, kept
from matrixworld.tutorial.chapter_5 import four_races, noisy_race
from student_functions import gains, last_beats_first

SCHEDULES = ("specialist_specialist", "generalist_specialist", "generalist_generalist")


@pytest.fixture(scope="module")
def scores() -> dict[str, np.ndarray]:
    races = kept("paper_races")
    return {name: races[name] / int(races["evaders"]) for name in SCHEDULES}


def test_the_four_races_are_what_the_solution_says() -> None:
    rises = {
        letter: [curve[-6:].mean() - curve[-15:-9].mean() > 0.05 for curve in curves]
        for letter, race in four_races().items()
        if (curves := analysis.generalization(race.mean(axis=2)))
    }
    assert rises == {
        "A": [False, True], "B": [False, False], "C": [True, True], "D": [False, False]
    }  # fmt: skip


def test_generalists_of_the_package_meet_these_opponents() -> None:
    sampler = coevolution.SCHEDULES["generalist-generalist"].new_sampler("evader")
    rng = np.random.default_rng(0)

    def met(k: int, i: int) -> int:
        return int(sampler.sample(coevolution.available("evader", k), i, rng)[0])

    assert check("5.2", met).right


def verdict(scores: np.ndarray, condition: str) -> str:
    return analysis.judge(scores, per_episode=True).headline[condition].verdict


def test_specialists_beat_the_newest_evaders_and_forget() -> None:
    lost = gains("specialist_specialist")
    assert np.count_nonzero(lost < -0.04) == 8
    assert np.count_nonzero(np.abs(lost) < 0.01) == 2
    assert (gains("generalist_generalist") > 0.0).all()


@pytest.mark.parametrize(
    ("schedule", "race", "cycling"),
    [
        ("specialist_specialist", "cannot tell", "present"),
        ("generalist_specialist", "present", "cannot tell"),
        ("generalist_generalist", "present", "absent"),
    ],
)
def test_verdicts_on_ten_seeds(
    scores: dict[str, np.ndarray], schedule: str, race: str, cycling: str
) -> None:
    found = analysis.judge(scores[schedule], per_episode=True).headline
    assert (found["arms race"].verdict, found["cycling"].verdict) == (race, cycling)
    if schedule == "generalist_specialist":
        assert found["arms race"].by_run.count("present") == 1
        assert found["arms race"].by_run.count("cannot tell") == 9
    if schedule == "specialist_specialist":
        assert found["cycling"].by_run.count("present") == 9
        assert found["forgetting"].by_run.count("present") == 10


def test_three_seeds_could_not_tell(scores: dict[str, np.ndarray]) -> None:
    assert verdict(scores["generalist_generalist"][:3], "arms race") == "cannot tell"
    assert verdict(scores["generalist_generalist"][:5], "arms race") == "present"
    assert verdict(scores["generalist_generalist"][:5], "cycling") == "cannot tell"


@pytest.mark.parametrize("count", [40, 200])
def test_the_simple_rule_is_fooled_by_one_race_of_four(count: int) -> None:
    alarms = [last_beats_first(noisy_race("noise only, .5", seed)) for seed in range(count)]
    assert 0.15 < np.mean(alarms) < 0.35


def test_specialists_have_more_checkerboards(scores: dict[str, np.ndarray]) -> None:
    measure = analysis.MEASURES["checkerboards"].of
    specialists, mixed = (
        [measure(matrix).value for matrix in scores[name].mean(axis=3)] for name in SCHEDULES[:2]
    )
    difference = analysis.difference_of_runs(mixed, specialists)
    assert difference.high < 0.0
