"""Settings: what was chosen, what follows from it, what has no effect, and settings as JSON."""

import itertools
import json
import pickle
from dataclasses import replace

import numpy as np
import pytest

import matrixworld as mw
from matrixworld import coevolution as co
from matrixworld._util import sections
from matrixworld.coevolution.games.policies import PolicySettings
from matrixworld.coevolution.learners import OwnLearner
from matrixworld.coevolution.learners.learner import Learner
from matrixworld.coevolution.settings.schedules import ALL_SCHEDULES
from matrixworld.coevolution.settings.usual import COURTYARD
from tiny_race import settings_of, tiny_race, tiny_single

LEARNERS = ("es", "ga", "cma", "actor-critic")
SMALL = {"world.fov": 5, "policy.hidden": ()}
GA, GRADIENTS = {"learner": "ga"}, {"learner": "actor-critic"}
HALL = {"schedule": "hall-of-fame", "schedule.hall_sample": 0}
MEET = "schedule.pursuers_meet"
SHARED = {"learner.sharing": "competitive"}
STARTED = {"schedule": "against", "schedule.start": "run"}
TURNS = "schedule.evader_learner"


ALONE = {"schedule": "against", "learner.population": 128, "learner.relative_sigma": 0.0,
         "learner.anneal": True, "evaluation_episodes": 200}  # fmt: skip


@pytest.mark.parametrize(("kinds", "expected"), [
    ({}, {"schedule": "alternating", "schedule.generations": 30, "schedule.pursuer_epochs": 28,
          "schedule.evader_epochs": 58, "learner": "es", "learner.population": 48,
          "learner.sigma": 0.1, "learner.relative_sigma": 0.4, "learner.learning_rate": 0.03,
          "world.max_steps": 500, "train_steps": 200, "policy.hidden": [32]}),
    ({"schedule": "hall-of-fame"}, {"learner.population": 24, "schedule.joint_epochs": 43}),
    ({"schedule": "against"},
     {**ALONE, "schedule.epochs": 6000, "train_steps": 500,
      "policy.initial_weight": 0.2, "policy.initial_head": 0.09}),
    ({"schedule": "against", "schedule.team": "evader"},
     {**ALONE, "schedule.epochs": 4000, "train_steps": 300,
      "policy.initial_weight": 0.05, "policy.initial_head": 0.1}),
    ({"learner": "cma", "world": mw.WorldConfig(fov=5), "policy": {"hidden": []}},
     {"learner.population": 48, "learner.sigma": 0.8}),
    # Those of the published code:
    (GRADIENTS, {"learner.population": 1, "train_steps": 500, "policy.hidden": [400, 300],
                 "schedule.pursuer_epochs": 400, "schedule.evader_epochs": 400}),
    ({**GRADIENTS, "schedule": "hall-of-fame"}, {"schedule.joint_epochs": 400}),
    ({**GRADIENTS, "schedule": "against", "schedule.team": "evader"},
     {"schedule.epochs": 1200, "train_steps": 500}),
    # Those of the command:
    ({"defaults": COURTYARD},
     {"world.rows": 20, "policy": "rating", "policy.initial_weight": 0.2, "learner": "cma",
      "learner.population": 24, "match_episodes": 4, "schedule.pursuer_epochs": 5,
      "train_steps": 200}),
    ({"defaults": COURTYARD, "schedule": "against"},
     {"learner": "cma", "learner.population": 24, "schedule.epochs": 150}),
    ({"defaults": COURTYARD, "learner": "es"},
     {"learner.population": 12, "learner.sigma": 0.3, "schedule.pursuer_epochs": 20,
      "match_episodes": 1}),
    ({"defaults": COURTYARD, "policy": "cells"}, {"learner": "es", "learner.population": 12}),
    ({"defaults": COURTYARD, "learner": "ga", "policy": "cells"},
     {"learner.population": 48, "learner.mutation": 0.05, "policy.initial_weight": 0.05}),
    ({"defaults": COURTYARD, "world.obstacles": ["..#..", ".....", "....."]},
     {"world.rows": 3, "world.cols": 5, "world.n_pursuers": 4}),
])  # fmt: skip
def test_defaults_are_those_that_were_seen_to_work(kinds, expected):
    values = co.RaceSettings.of(kinds).values()
    assert {path: values[path] for path in expected} == expected


@pytest.mark.parametrize(("epochs", "rate", "sigma"), [(6000, 0.0161, 0.0898), (1, 1.25, 0.791)])
def test_steps_of_a_team_alone_follow_from_its_epochs(epochs, rate, sigma):
    learner = co.RaceSettings.of({"schedule": "against", "schedule.epochs": epochs}).learner
    assert (learner.learning_rate, learner.sigma) == pytest.approx((rate, sigma), rel=0.003)
    chosen = settings_of(schedule="against", epochs=epochs, sigma=0.3).learner
    assert (chosen.learning_rate, chosen.sigma) == (learner.learning_rate, 0.3)


# What was chosen, and what follows from it:


def kinds_of_settings():
    """Yield choices of schedule, learner, policy, and team of one that learns alone."""
    schedules = [{"schedule": name} for name in ALL_SCHEDULES]
    schedules += [{"schedule": "against", "schedule.team": team} for team in co.TEAMS]
    learners = [name for name in sections.names_in(Learner) if name != sections.OWN]
    policies = sections.names_in(PolicySettings)
    yield {}
    for schedule in schedules:
        yield schedule
    for kind in (*learners, "own_code:HillClimber"):
        yield {"learner": kind}
    for kind in policies:
        yield {"policy": kind}
    for schedule, learner, policy in itertools.product(schedules, learners, policies):
        yield {**schedule, "learner": learner, "policy": policy, "world.fov": 5}
    yield {"defaults": COURTYARD}
    yield {"defaults": COURTYARD, "schedule": "against", "schedule.epochs": 10}
    yield {"schedule.generations": 7, "world.rules": "SB"}
    yield {"world": "park", "world.n_pursuers": 6}


EVERY_KIND = [*kinds_of_settings()]


def made(make):
    """Return what a function makes, or the error that it raises."""
    try:
        return make()
    except co.SettingError as error:
        return f"{error.path}: expected {error.expected}"


@pytest.mark.parametrize("every", [11, pytest.param(1, marks=pytest.mark.slow)])
def test_a_change_is_the_same_as_a_choice_from_the_beginning(every):
    made_of = [(choices, made(lambda c=choices: co.RaceSettings.of(c))) for choices in EVERY_KIND]
    valid = [(choices, settings) for choices, settings in made_of if not isinstance(settings, str)]
    assert len(valid) > 70
    compared = 0
    pairs = itertools.product(valid, made_of)
    for (first, settings), (second, _) in itertools.islice(pairs, 0, None, every):
        expected = made(lambda a=first, b=second: co.RaceSettings.of({**a, **b}))
        found = made(lambda s=settings, b=second: s.changed(b))
        assert found == expected, (first, second)
        if isinstance(found, str):
            continue
        compared += 1
        assert found.chosen == {**settings.chosen, **sections.flat(second)}
    assert compared > 3000 / every


def test_the_files_of_a_run_remember_what_was_chosen():
    for choices in EVERY_KIND[:40]:
        settings = made(lambda c=choices: co.RaceSettings.of(c))
        if isinstance(settings, str):
            continue
        file = json.loads(json.dumps(settings.to_json()))
        read = co.RaceSettings.from_json(file)
        assert (read, read.chosen) == (settings, settings.chosen)
        for change in ({"schedule": "against", "schedule.team": "evader"}, {"seed": 3}):
            expected = made(lambda c=choices, d=change: co.RaceSettings.of({**c, **d}))
            assert made(lambda f=file, d=change: co.RaceSettings.of(f["chosen"], d)) == expected
            assert made(lambda r=read, d=change: r.changed(d)) == expected


def test_what_a_constructor_or_replace_was_given_counts_as_chosen():
    whole = co.RaceSettings(schedule=co.Against())
    assert whole.learner == co.EvolutionStrategy()  # the docstring says so
    assert whole.changed({}) == whole
    assert whole.changed({"seed": 1}) == replace(whole, seed=1)
    settings = co.RaceSettings.of({"schedule": "hall-of-fame"})
    seeded = replace(settings, seed=6)
    assert seeded.changed({"schedule": "psro"}) == co.RaceSettings.of(schedule="psro", seed=6)
    alone = replace(co.RaceSettings.of(schedule="psro", generations=3), schedule=co.Against())
    assert alone.changed({}) == alone
    assert alone.changed({"seed": 1}).schedule == co.Against()
    learner = co.GeneticAlgorithm(population=48, elites=3)
    chosen = co.RaceSettings.of({"learner": learner, "schedule": "hall-of-fame"})
    assert chosen.learner == learner  # as a whole: not with the population of this schedule
    message = "^learner: expected a section derived from Learner, got 'ga'; only `of` takes names$"
    with pytest.raises(co.SettingError, match=message):
        co.RaceSettings(learner="ga")


def test_settings_of_a_version_with_other_defaults_stay_as_they_were():
    settings = co.RaceSettings.of({"schedule": "hall-of-fame"})
    file = settings.to_json()
    file["learner"]["population"] = 30  # what followed from it then
    read = co.RaceSettings.from_json(file)
    assert read.learner.population == 30
    assert read.changed({"seed": 2}).learner.population == 30
    del file["chosen"]  # of a race that a page has saved
    assert co.RaceSettings.from_json(file) == read


def test_none_takes_a_choice_back():
    chosen = {"learner": "ga", "learner.mutation": 0.2, "schedule": "hall-of-fame"}
    settings = co.RaceSettings.of(chosen)
    assert settings.changed({"learner.mutation": None}).learner == co.GeneticAlgorithm(
        population=24
    )
    message = r"^learner\.mutation: expected one of the settings .*, got 0\.2, .*None takes it back"
    with pytest.raises(co.SettingError, match=message):
        settings.changed({"learner": "es"})
    changed = settings.changed({"learner": "es", "learner.mutation": None})
    assert changed == co.RaceSettings.of({"schedule": "hall-of-fame"})
    courtyard = co.RaceSettings.of({"defaults": "courtyard"})
    assert courtyard.changed({"defaults": None}) == co.RaceSettings()
    park = co.RaceSettings.of(world="park", rows=12, n_pursuers=3, rules="S", max_steps=9)
    for name in ("rows", "n_pursuers", "rules", "max_steps"):
        park = park.changed({f"world.{name}": None})
    assert park == co.RaceSettings.of(world="park")


def test_a_learner_of_your_own_has_the_defaults_of_what_it_inherits():
    class_of = {"learner": "own_code:Bred"}
    for schedule, population, mutation in (
        ("psro", 48, 0.05), ("hall-of-fame", 24, 0.05), ("against", 128, 0.2),
    ):  # fmt: skip
        settings = co.RaceSettings.of({**class_of, "schedule": schedule})
        assert settings.learner == OwnLearner(code="own_code:Bred")
        learner = settings.learner_of("pursuer")
        assert (learner.population, learner.mutation, learner.bits) == (population, mutation, 1)
    given = settings.changed({"learner.settings.mutation": 0.3}).learner_of("pursuer")
    assert (given.population, given.mutation) == (128, 0.3)


@pytest.mark.parametrize(("code", "inherits"), [("own_code:Steps", "es"), ("own_code:Bred", "ga")])
@pytest.mark.parametrize("schedule", ["psro", "hall-of-fame", "against"])
def test_a_class_of_your_own_has_all_defaults_of_what_it_inherits(code, inherits, schedule):
    own = co.RaceSettings.of(schedule=schedule, learner=code).learner_of("pursuer")
    usual = co.RaceSettings.of(schedule=schedule, learner=inherits).learner
    assert {name: getattr(own, name) for name in usual.values()} == usual.values()


def test_equal_settings_have_equal_learners_of_your_own():
    """Whether they were made of choices, by `replace`, or are read from a file."""
    settings = co.RaceSettings.of(learner="own_code:Bred", defaults="courtyard")
    alone = replace(settings, schedule=co.Against())
    same = [alone, co.RaceSettings.from_json(alone.to_json()), replace(alone, chosen=None)]
    assert all(other == alone for other in same)
    assert [other.learner_of("pursuer").population for other in same] == [128, 128, 128]


def test_what_nobody_chose_is_not_refused_when_something_else_changes():
    chosen = {"schedule": "against", "schedule.start": "a-run", "learner.population": 8}
    settings = co.RaceSettings.of(chosen)
    evaders = replace(settings, schedule=replace(settings.schedule, team="evader"))
    assert co.RaceSettings.from_json(evaders.to_json()) == evaders
    changed = evaders.changed({"seed": 1})
    assert (changed.schedule, changed.learner) == (evaders.schedule, evaders.learner)


@pytest.mark.parametrize("path", ["", ".", ".x", "learner..x", "learner.sigma.", "schedule.x.y"])
def test_paths_that_are_none_are_refused(path):
    for value in (1, None, {}):
        with pytest.raises(co.SettingError):
            co.RaceSettings.of({path: value})


def test_overlap_is_penalised_where_teammates_may_share_a_cell():
    evaders = {"schedule": "against", "schedule.team": "evader"}
    assert co.RaceSettings().training_game.penalty == 0.2
    assert co.RaceSettings.of(evaders).training_game.penalty == 0.5
    assert settings_of(rules="SB").training_game.penalty == 0.0  # two cannot share a cell there
    started = co.RaceSettings.of(evaders, {"schedule.start": "a-run"})
    assert started.training_game.penalty == 0.2


def test_a_name_stands_for_a_section():
    of = co.RaceSettings.of
    assert of(schedule="hall-of-fame").schedule == co.AtOnce()
    meeting = {"pursuers_meet": "latest", "evaders_meet": "prioritized-even"}
    alternating = of(schedule={"kind": "alternating", **meeting}).schedule
    assert alternating.pursuers_meet == co.opponents.Latest()
    assert alternating.evaders_meet == co.opponents.Prioritized(weighting="even")
    assert of(schedule="alternating").schedule.evaders_meet == co.opponents.Uniform()
    generalists = of(schedule="generalist-specialist").schedule
    assert (generalists.pursuers_meet, generalists.evaders_meet) == (
        co.opponents.RoundRobin(),
        co.opponents.Latest(),
    )


def test_learners_and_samplers_are_complete_when_they_are_made():
    class Half(Learner):
        def start(self, task):
            return {}

    class Nobody(co.opponents.Opponents):
        pass

    for incomplete in (Half, Nobody):
        with pytest.raises(TypeError, match="abstract"):
            incomplete()


AGAINST = {"schedule": "against"}
REFUSED = {
    "schedule.hall_sample": [{**HALL, "schedule.contemporaries": 0}],
    "schedule.evaders_meet": [{**HALL, "schedule.evaders_meet": "nash"}],
    "schedule.opponent": [{**AGAINST, "schedule.opponent": "careful-chaser", "world.fov": 3}],
    f"{MEET}.episodes": [{MEET: "uniform", f"{MEET}.episodes": 3}],
    TURNS: [{f"{TURNS}.sigma": 0.1}, {TURNS: "cma"}, {**AGAINST, TURNS: "ga"},
            {**HALL, TURNS: "ga"}],
    "learner": [{"learner": "cma"}],
    "learner.population": [{"learner.population": 7}],
    "learner.momentum": [{"learner.momentum": 1.0}],
    "learner.elites": [{**GA, "learner.elites": 48}],
    "learner.tournament": [{**GA, "learner.truncation": 0.5, "learner.tournament": 3}],
    "learner.minibatches": [{**GRADIENTS, "learner.minibatches": 2}],
    "learner.cost_rate": [{**GRADIENTS, "learner.cost_rate": 0.1}],
    "learner.sharing": [{**SHARED, "learner.measure": "rewards"}, SHARED],
    "learner.measure": [{**GRADIENTS, "learner.measure": "rewards"}],
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
                    {**SMALL, TURNS: "cma", "policy.mask": "obstacles"}],
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
        with pytest.raises(co.SettingError, match=f"^{path}: expected ") as caught:
            co.RaceSettings.of(changes)
        assert caught.value.path == path


EVERY = [
    *(tiny_race(schedule=name) for name in ALL_SCHEDULES),
    *(tiny_race(learner=name, hidden=()) for name in LEARNERS),
    tiny_single(team="evader", opponent="chaser"),
    tiny_race(schedule="alternating", pursuers_meet="nash", evaders_meet="own_code:Hardest"),
    tiny_race(learner="own_code:HillClimber"),
    tiny_race(rules=mw.Rules(evader=mw.Outcome.REACH), obstacles=0.1, diagonal=True),
    tiny_race(rows=6, cols=6, obstacles=np.eye(6, dtype=bool)),
    co.RaceSettings(learner=co.EvolutionStrategy(sigma=1 / 3, momentum=0.9)),
    co.RaceSettings(schedule=co.Against(team="evader")),
    tiny_race(evader_learner="ga", training_worlds=[{"n_pursuers": 1}, {"rows": 5}]),
    tiny_race(measure="rewards", rewards="published"),
]


@pytest.mark.parametrize("settings", EVERY, ids=range(len(EVERY)))
def test_settings_are_compared_hashed_pickled_and_saved(settings):
    plain = json.loads(json.dumps(settings.to_json()))
    copied = pickle.loads(pickle.dumps(settings))  # noqa: S301
    read = co.RaceSettings.from_json(plain)
    of_choices = co.RaceSettings.of(plain["chosen"])
    for same in (read, of_choices, settings.changed({}), copied, replace(settings)):
        assert same == settings
        assert hash(same) == hash(settings)
        assert json.loads(json.dumps(same.to_json())) == plain
    other = replace(settings, seed=6)
    assert other != settings
    assert {**other.values(), "seed": settings.seed} == settings.values()


def test_a_change_keeps_what_was_chosen():
    settings = co.RaceSettings.of({"schedule.generations": 7, "learner.population": 20})
    mixed = settings.changed({"schedule": "generalist-specialist", "schedule.evader_epochs": 3})
    assert mixed.schedule.name == "generalist-specialist"
    assert (mixed.schedule.generations, mixed.schedule.evader_epochs) == (7, 3)
    other = settings.changed({"schedule": "hall-of-fame", "learner": "ga"})
    assert (other.schedule.generations, other.learner.population) == (7, 20)
    rewards = mw.Rewards(evader_step=0.5)
    for change in (
        {"world.rules": "SB", "world.rewards.evader_step": 0.5},
        {"world.rules": mw.VARIANTS["SB"], "world.rewards": rewards},
    ):
        worlds = settings.changed({**change, "learner.measure": "rewards"})
        world = worlds.game.world
        assert (world.rules, world.rewards) == (mw.VARIANTS["SB"], rewards)
    # A name stands for all rewards, of which one is changed.
    named = {"world.rewards": "published", "world.rewards.evader_step": 0.5}
    expected = replace(mw.Rewards.published(), evader_step=0.5)
    assert settings.changed({**named, "learner.measure": "rewards"}).game.world.rewards == expected


def test_a_name_stands_for_a_world_whose_other_fields_can_be_changed():
    park = mw.WorldConfig("TO", size=28, n_pursuers=4, n_evaders=4, max_steps=200, obstacles=0.1)
    larger = replace(park, n_pursuers=6)
    for given, expected in (
        ([{"world": "park"}], park),
        ([{"world": {"kind": "park", "n_pursuers": 6}}], larger),
        ([{"world.n_pursuers": 6, "world": "park"}], larger),
        ([{"world": "park"}, {"world.n_pursuers": 6}], larger),
        ([{"world": "park"}, {"world.obstacles": 0.0}], replace(park, obstacles=0.0)),
        ([{"world.n_pursuers": 6}, {"world": "park"}], larger),
        ([{"world": "park", "world.rules.teammate": "REACH"}],
         replace(park, rules=replace(mw.VARIANTS["TO"], teammate=mw.Outcome.REACH))),
    ):  # fmt: skip
        assert co.RaceSettings.of(*given).game.world == expected
    assert co.RaceSettings.of(world="park", n_pursuers=6).game.world == larger
    changed = co.RaceSettings().changed({"world": "park"})
    assert changed.game.world == mw.WorldConfig.of("park") == park
    with pytest.raises(ValueError, match=r"^world: expected one of .*park, got 'lake'"):
        co.RaceSettings.of(world="lake")


def test_later_values_change_earlier_ones_before_defaults_follow():
    file = {"learner": {"kind": "ga", "mutation": 0.3}, "world": {"rules": {"kind": "S"}}}
    settings = co.RaceSettings.of(file, {"schedule": "hall-of-fame", "world.rules.evader": "REACH"})
    assert (settings.learner.population, settings.learner.mutation) == (24, 0.3)
    assert settings.game.world.rules == replace(mw.VARIANTS["S"], evader=mw.Outcome.REACH)
    assert settings.game.world.n_pursuers == 20
    # A learner of the evaders has defaults of its own, and can be taken back.
    mixed = co.RaceSettings.of(file, {TURNS: "ga", f"{TURNS}.elites": 2})
    learner = mixed.schedule.evader_learner
    assert (learner.population, learner.mutation) == (48, 0.05)
    assert mixed.learner_of("evader").elites == 2
    assert mixed.learner_of("pursuer") == mixed.learner
    assert co.RaceSettings.from_json(mixed.to_json()) == mixed
    taken_back = {TURNS: None, f"{TURNS}.elites": None}
    assert mixed.changed(taken_back) == co.RaceSettings.of(file)


def test_every_setting_has_a_help_text():
    for settings in EVERY:
        assert all(settings.help().values())


def test_a_part_of_an_opponent_sampler_that_a_schedule_names():
    given = {"schedule": "psro", f"{MEET}.episodes": 3}
    for settings in (
        co.RaceSettings.of(given),
        co.RaceSettings().changed(given),
        co.RaceSettings.of(schedule="hall-of-fame").changed(given),
    ):
        schedule = settings.schedule
        assert (schedule.name, schedule.evaders_meet) == ("psro", co.opponents.NashOpponents())
        assert schedule.pursuers_meet == co.opponents.NashOpponents(episodes=3)
    # A mixture of one team only has no name.
    assert (
        co.RaceSettings.of({**given, "schedule.evaders_meet": "latest"}).schedule.name
        == "alternating"
    )
