"""Advice: what to try, from a judgement and the settings of the race."""

import shlex

import numpy as np
import pytest

from matrices import circular, logistic
from matrixworld.analysis import CONDITIONS, Judgement, judge
from matrixworld.cli.evolve import evolve_command
from matrixworld.cli.judge import ADVICE, advice
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


@pytest.mark.parametrize("settings", SETTINGS, ids=lambda settings: settings.schedule.name)
def test_advice_changes_settings_to_others_that_a_race_can_have(settings):
    rows = [row for row in ADVICE if row.helps(settings, CONDITIONS)]
    assert rows
    for row in rows:
        changes = row.options(settings)
        assert changes
        assert settings.changed(changes) != settings, row


def test_advice_names_options_of_evolve_and_known_conditions():
    for row in ADVICE:
        for settings in (each for each in SETTINGS[:3] if row.helps(each, CONDITIONS)):
            words = shlex.split(row.line(settings).partition(": ")[0])
            with evolve_command.make_context("evolve", words) as context:
                settings_of(given_options(context.params))
        assert set(row.conditions) <= set(CONDITIONS)


@pytest.mark.parametrize("settings", SETTINGS, ids=lambda settings: settings.schedule.name)
@pytest.mark.parametrize("condition", CONDITIONS)
def test_every_condition_has_advice_for_every_schedule(settings, condition):
    rows = [row for row in ADVICE if row.helps(settings, [condition])]
    # Where virulence is reduced and both teams learn at once nothing else is known to help.
    assert rows or (condition, settings.schedule.name) == ("disengagement", "hall-of-fame")


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
    cma = RaceSettings.of({"learner": "cma", "world.fov": 5, "policy.hidden": ()})
    [larger] = [row for row in ADVICE if "policy.hidden" in row.changes]
    assert larger.helps(RaceSettings(), ["stagnation"])
    assert not larger.helps(cma, ["stagnation"])
    assert larger.line(RaceSettings()) == "--set policy.hidden=64: a larger network"


def test_only_what_is_present_leads_to_advice():
    found = judged(logistic(31, 0.3))
    assert found.present() == ("arms race", "rise")
    [line] = advice(found, RaceSettings.of({"schedule.generations": 30}))
    assert line.startswith("--generations 60: ")
    assert advice(found, None) == ["more generations show how long it goes on"]
    assert advice(judge(circular(31)), RaceSettings()) == []
