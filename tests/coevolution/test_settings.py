"""Settings: defaults, what is refused, what has no effect, and settings as JSON."""

import json
import pickle
from dataclasses import replace

import numpy as np
import pytest

import matrixworld as mw
from matrixworld import coevolution as co
from matrixworld.coevolution import sections
from matrixworld.coevolution.race import ALL_SCHEDULES
from tiny_race import settings_of, tiny_race, tiny_single

LEARNERS = ("es", "ga", "cma", "actor-critic")
SMALL = {"world.fov": 5, "policy.hidden": ()}
GA, GRADIENTS = {"learner": "ga"}, {"learner": "actor-critic"}
HALL = {"schedule": "hall-of-fame", "schedule.hall_sample": 0}
MEET = "schedule.pursuers_meet"
SHARED = {"fitness.sharing": "competitive"}
STARTED = {"schedule": "against", "schedule.start": "run"}


ALONE = {"schedule": "against", "learner.population": 128, "learner.relative_sigma": 0.0,
         "learner.anneal": True, "evaluation_episodes": 200}  # fmt: skip


@pytest.mark.parametrize(("kinds", "expected"), [
    ({}, {"schedule": "alternating", "schedule.generations": 30, "schedule.pursuer_epochs": 28,
          "schedule.evader_epochs": 58, "learner": "es", "learner.population": 48,
          "learner.sigma": 0.1, "learner.relative_sigma": 0.4, "learner.learning_rate": 0.03,
          "world.max_steps": 500, "train_steps": 200, "policy.hidden": [32]}),
    ({"schedule": "hall-of-fame"}, {"learner.population": 24, "schedule.joint_epochs": 43}),
    ({"schedule": co.Against(team="pursuer")},
     {**ALONE, "schedule.epochs": 6000, "train_steps": 500,
      "policy.initial_weight": 0.2, "policy.initial_head": 0.09}),
    ({"schedule": co.Against(team="evader")},
     {**ALONE, "schedule.epochs": 4000, "train_steps": 300,
      "policy.initial_weight": 0.05, "policy.initial_head": 0.1}),
    ({"learner": "cma", "world": mw.WorldConfig(fov=5), "policy": {"hidden": []}},
     {"learner.population": 48, "learner.sigma": 0.8}),
    # Those of the published code:
    (GRADIENTS, {"learner.population": 1, "train_steps": 500, "policy.hidden": [400, 300],
                 "schedule.pursuer_epochs": 400, "schedule.evader_epochs": 400}),
    ({**GRADIENTS, "schedule": "hall-of-fame"}, {"schedule.joint_epochs": 400}),
    ({**GRADIENTS, "schedule": co.Against(team="evader")},
     {"schedule.epochs": 1200, "train_steps": 500}),
])  # fmt: skip
def test_defaults_are_those_that_were_seen_to_work(kinds, expected):
    found = sections.values_of(co.RaceSettings(**kinds))
    assert {path: found[path] for path in expected} == expected


@pytest.mark.parametrize(("epochs", "rate", "sigma"), [(6000, 0.0161, 0.0898), (1, 1.25, 0.791)])
def test_steps_of_a_team_alone_follow_from_its_epochs(epochs, rate, sigma):
    learner = co.RaceSettings.of({"schedule": "against", "schedule.epochs": epochs}).learner
    assert (learner.learning_rate, learner.sigma) == pytest.approx((rate, sigma), rel=0.003)
    chosen = settings_of(schedule="against", epochs=epochs, sigma=0.3).learner
    assert (chosen.learning_rate, chosen.sigma) == (learner.learning_rate, 0.3)


def test_overlap_is_penalised_where_teammates_may_share_a_cell():
    assert co.RaceSettings().training_game.penalty == 0.2
    assert co.RaceSettings(schedule=co.Against(team="evader")).training_game.penalty == 0.5
    assert settings_of(rules="SB").training_game.penalty == 0.0  # two cannot share a cell there
    # The rewards have penalties of their own.
    assert settings_of(measure="rewards").training_game.penalty == 0.0
    started = co.RaceSettings(schedule=co.Against(team="evader", start="a-run"))
    assert started.training_game.penalty == 0.2


def test_a_text_stands_for_a_section():
    assert co.RaceSettings(schedule="hall-of-fame") == co.RaceSettings(schedule=co.AtOnce())
    alternating = co.InTurns(pursuers_meet="latest", evaders_meet="prioritized-even")
    assert alternating.pursuers_meet == co.opponents.Latest()
    assert alternating.evaders_meet == co.opponents.Prioritized(weighting="even")
    assert co.RaceSettings(schedule="alternating").schedule.evaders_meet == co.opponents.Uniform()
    generalists = co.RaceSettings(schedule="generalist-specialist").schedule
    assert (generalists.pursuers_meet, generalists.evaders_meet) == (
        co.opponents.RoundRobin(),
        co.opponents.Latest(),
    )


AGAINST = {"schedule": "against"}
REFUSED = {
    "schedule: contemporaries and hall_sample": [{**HALL, "schedule.contemporaries": 0}],
    "schedule.evaders_meet": [{**HALL, "schedule.evaders_meet": "nash"}],
    "schedule.opponent": [{**AGAINST, "schedule.opponent": "careful-chaser", "world.fov": 3}],
    f"{MEET}.episodes": [{MEET: "uniform", f"{MEET}.episodes": 3}],
    "evader_learner": [{"evader_learner.sigma": 0.1}, {"evader_learner": "cma"},
                       {**AGAINST, "evader_learner": "ga"}, {**HALL, "evader_learner": "ga"}],
    "learner": [{"learner": "cma"}],
    "learner.population": [{"learner.population": 7}],
    "learner.momentum": [{"learner.momentum": 1.0}],
    "learner.elites": [{**GA, "learner.elites": 48}],
    "learner.tournament": [{**GA, "learner.truncation": 0.5, "learner.tournament": 3}],
    "learner.minibatches": [{**GRADIENTS, "learner.minibatches": 2}],
    "learner.cost_rate": [{**GRADIENTS, "learner.cost_rate": 0.1}],
    "fitness.sharing": [{**SHARED, "fitness.measure": "rewards"}, SHARED],
    "fitness.measure": [{**GRADIENTS, "fitness.measure": "rewards"}],
    "world.fov": [{"world.fov": 4}],
    "world.rows": [{"world.rows": 2, "world.cols": 2}],
    "world.rules.evader": [{"world.rules.evader": "JUMP"}],
    "world.rewards": [{"world.rewards": "mine"}, {"world.rewards": "published"}],
    "world.rewards.evader_step": [{"world.rewards.evader_step": "x"}],
    "policy.activation": [{"policy.hidden": (), "policy.activation": "tanh"}],
    "policy.memory": [{"policy.memory": "gru", "policy.hidden": ()},
                      {**GRADIENTS, "policy.memory": "gru"}],
    "policy.initial_weight": [{"policy.hidden": (), "policy.initial_weight": 0.3},
                              {**GRADIENTS, "policy.initial_weight": 0.3},
                              {**STARTED, "policy.initial_weight": 0.3}],
    "policy.initial_head": [{**STARTED, "policy.initial_head": 0.3}],
    "policy.mask": [{"world.fov": 3, "policy.mask": "right-of-way"},
                    {"world.rules": mw.Rules(pursuer=mw.Outcome.BOUNCE),
                     "policy.mask": "right-of-way"},
                    {**SMALL, "learner": "cma", "policy.mask": "obstacles"},
                    {**SMALL, "evader_learner": "cma", "policy.mask": "obstacles"}],
    "training_worlds.fov": [{"training_worlds": [{"fov": 5}]}],
    "training_worlds.n_cats": [{"training_worlds": [{"n_cats": 5}]}],
    "training_worlds": [{"training_worlds": [7]}],
    "training_shares": [{"training_worlds": [{}] * 3, "training_shares": (1,)},
                        {"training_shares": (1,)}],
    "sigma": [{"sigma": 0.1}],
}  # fmt: skip
"""Settings that do not fit together, by the path with which the message begins.

What a single setting may not be is tried in ``bad_input/test_declared.py``.
"""


@pytest.mark.parametrize("path", REFUSED)
def test_bad_settings_and_those_without_effect_are_refused(path):
    for changes in REFUSED[path]:
        with pytest.raises((TypeError, ValueError), match=f"^{path}: expected "):
            co.RaceSettings.of(changes)


EVERY = [
    *(tiny_race(schedule=name) for name in ALL_SCHEDULES),
    *(tiny_race(learner=name, hidden=()) for name in LEARNERS),
    tiny_single(team="evader", opponent="chaser"),
    tiny_race(schedule="alternating", pursuers_meet="nash", evaders_meet="own_code:Hardest"),
    tiny_race(learner="own_code:HillClimber"),
    tiny_race(rules=mw.Rules(evader=mw.Outcome.REACH), obstacles=0.1, diagonal=True),
    tiny_race(rows=6, cols=6, obstacles=np.eye(6, dtype=bool)),
    co.RaceSettings(learner=co.EvolutionStrategy(sigma=1 / 3, momentum=0.9)),
    tiny_race(measure="rewards", rewards="published"),
]


@pytest.mark.parametrize("settings", EVERY, ids=range(len(EVERY)))
def test_settings_are_compared_hashed_pickled_and_saved(settings):
    plain = json.loads(json.dumps(settings.to_json()))
    copied = pickle.loads(pickle.dumps(settings))  # noqa: S301
    for same in (co.RaceSettings.of(plain), settings.changed({}), copied, replace(settings)):
        assert same == settings
        assert hash(same) == hash(settings)
        assert same.to_json() == plain
    assert replace(settings, seed=6) != settings
    assert sections.different_settings(settings, replace(settings, seed=6)) == ["seed"]


def test_a_change_keeps_what_the_kind_of_section_still_has():
    settings = co.RaceSettings.of({"schedule.generations": 7, "learner.sigma": 0.3})
    mixed = settings.changed({"schedule": "generalist-specialist", "schedule.evader_epochs": 3})
    assert mixed.schedule.name == "generalist-specialist"
    assert (mixed.schedule.generations, mixed.schedule.evader_epochs) == (7, 3)
    assert mixed.learner == settings.learner
    other = settings.changed({"schedule": "hall-of-fame", "learner": "ga"})
    assert (other.schedule.generations, other.learner.kind) == (30, "ga")
    rewards = mw.Rewards(evader_step=0.5)
    for change in (
        {"world.rules": "SB", "world.rewards.evader_step": 0.5},
        {"world.rules": mw.VARIANTS["SB"], "world.rewards": rewards},
    ):
        worlds = settings.changed({**change, "fitness.measure": "rewards"})
        assert (worlds.world.rules, worlds.world.rewards) == (mw.VARIANTS["SB"], rewards)
    # A name stands for all rewards, of which one is changed.
    named = {"world.rewards": "published", "world.rewards.evader_step": 0.5}
    expected = replace(mw.Rewards.published(), evader_step=0.5)
    assert worlds.changed(named).world.rewards == expected


def test_a_name_stands_for_a_world_whose_other_fields_can_be_changed():
    park = mw.WorldConfig("TO", size=28, n_pursuers=4, n_evaders=4, max_steps=200, obstacles=0.1)
    larger = replace(park, n_pursuers=6)
    for given, expected in (
        ([{"world": "park"}], park),
        ([{"world": {"kind": "park", "n_pursuers": 6}}], larger),
        ([{"world.n_pursuers": 6, "world": "park"}], larger),
        ([{"world": "park"}, {"world.n_pursuers": 6}], larger),
        ([{"world": "park"}, {"world.obstacles": None}], replace(park, obstacles=0.0)),
        ([{"world.n_pursuers": 6}, {"world": "park"}], park),
    ):
        assert co.RaceSettings.of(*given).world == expected
    assert co.RaceSettings.of(world="park", n_pursuers=6).world == larger
    assert co.RaceSettings().changed({"world": "park"}).world == mw.WorldConfig.of("park") == park
    with pytest.raises(ValueError, match=r"world\.kind: expected one of .*park, got 'lake'"):
        co.RaceSettings.of(world="lake")


def test_later_values_change_earlier_ones_before_defaults_are_filled_in():
    file = {"learner": {"kind": "ga", "mutation": 0.3}, "world": {"rules": {"kind": "S"}}}
    settings = co.RaceSettings.of(file, {"schedule": "hall-of-fame", "world.rules.evader": "REACH"})
    assert (settings.learner.population, settings.learner.mutation) == (24, 0.3)
    assert settings.world.rules == replace(mw.VARIANTS["S"], evader=mw.Outcome.REACH)
    assert settings.world.n_pursuers == 20
    # A learner of the evaders has defaults of its own, and can be taken back.
    mixed = co.RaceSettings.of(file, {"evader_learner": "ga", "evader_learner.elites": 2})
    assert (mixed.evader_learner.population, mixed.evader_learner.mutation) == (48, 0.05)
    assert mixed.learner_of("evader").elites == 2
    assert mixed.learner_of("pursuer") == mixed.learner
    assert co.RaceSettings.of(mixed.to_json()) == mixed
    assert mixed.changed({"evader_learner": None}) == co.RaceSettings.of(file)
    # Mappings and texts stand for sections in constructors, too.
    assert co.RaceSettings(schedule="hall-of-fame", **file).learner == settings.learner


def test_every_setting_has_a_help_text():
    for settings in EVERY:
        assert all(text for _, _, text in sections.leaves(settings))


def test_a_part_of_an_opponent_sampler_that_a_schedule_names():
    given = {"schedule": "psro", f"{MEET}.episodes": 3}
    for settings in (
        co.RaceSettings.of(given),
        co.RaceSettings().changed(given),
        co.RaceSettings(schedule="hall-of-fame").changed(given),
    ):
        schedule = settings.schedule
        assert (schedule.name, schedule.evaders_meet) == ("psro", co.opponents.NashOpponents())
        assert schedule.pursuers_meet == co.opponents.NashOpponents(episodes=3)
    # A mixture of one team only has no name.
    assert (
        co.RaceSettings.of({**given, "schedule.evaders_meet": "latest"}).schedule.name
        == "alternating"
    )
