"""Advice: what to try, from a judgement and the settings of the race."""

import shlex

import numpy as np
import pytest

from matrices import circular, logistic
from matrixworld.analysis import CONDITIONS, Judgement, judge
from matrixworld.analysis.judge import PRESENT, RULES, Finding
from matrixworld.cli.evolve import evolve_command
from matrixworld.cli.judge import advice, helpful
from matrixworld.cli.options import given_options
from matrixworld.cli.setting_options import settings_of
from matrixworld.coevolution import RaceSettings
from matrixworld.coevolution.schedules import ALL_SCHEDULES

SETTINGS = [
    *map(RaceSettings.of, [{"schedule": name} for name in ALL_SCHEDULES]),
    *map(
        RaceSettings.of,
        [
            {"schedule": "alternating", "schedule.pursuers_meet": "latest"},
            {"schedule.opponents": 4, "fitness.sharing": "competitive"},
            {
                "fitness.evader_virulence": 0.6,
                "learner": "cma",
                "world.fov": 5,
                "policy.hidden": (),
            },
        ],
    ),
]


def judged(chance: np.ndarray) -> Judgement:
    played = np.random.default_rng(0).binomial(30, chance[..., None] * np.ones(10)) / 30
    return judge(played, per_episode=True)


def present(condition: str) -> Judgement:
    return Judgement(1, (9, 9), 9, 0.95, "whole", {"whole": {condition: Finding(PRESENT, "")}})


@pytest.mark.parametrize("settings", SETTINGS, ids=lambda settings: settings.schedule.name)
@pytest.mark.parametrize("condition", CONDITIONS)
def test_advice_is_typed_for_every_condition_and_schedule(settings, condition):
    """The options of each line are those of `evolve`, and change a race to another one."""
    lines = advice(present(condition), settings)
    # Where virulence is reduced and both teams learn at once nothing else is known to help.
    assert lines or (condition, settings.schedule.name) == ("disengagement", "hall-of-fame")
    for line in lines:
        with evolve_command.make_context("evolve", shlex.split(line.partition(": ")[0])) as context:
            settings_of(given_options(context.params))
    for change in RULES[condition].changes:
        options = helpful(change, settings)
        assert not options or settings.changed(options) != settings


def test_every_change_helps_some_race():
    """A path or a situation that does not exist would never be told."""
    changes = {change for each in RULES.values() for change in each.changes}
    assert [each for each in changes if not any(helpful(each, one) for one in SETTINGS)] == []


@pytest.mark.parametrize(
    ("given", "first"),
    [
        ({"schedule": "specialist-specialist"}, "--schedule generalist-generalist: "),
        ({"schedule": "generalist-generalist"}, "--set schedule.opponents=4: "),
        ({"schedule": "alternating", "schedule.opponents": 3}, "--set schedule.opponents=6: "),
    ],
)
def test_what_comes_first_against_cycles_depends_on_the_settings(given, first):
    found = judged(circular(31))
    assert "cycling" in found.present()
    assert advice(found, RaceSettings.of(given))[0].startswith(first)


def test_what_the_learner_cannot_have_is_not_advised():
    larger = "--set policy.hidden=64: a larger network"
    cma = RaceSettings.of({"learner": "cma", "world.fov": 5, "policy.hidden": ()})
    assert larger in advice(present("stagnation"), RaceSettings())
    assert not any("hidden" in line for line in advice(present("stagnation"), cma))


def test_only_what_is_present_leads_to_advice():
    found = judged(logistic(31, 0.3))
    assert found.present() == ("arms race", "rise")
    [line] = advice(found, RaceSettings.of({"schedule.generations": 30}))
    assert line.startswith("--generations 60: ")
    assert advice(found, None) == ["more generations show how long it goes on"]
    assert advice(judge(circular(31)), RaceSettings()) == []
