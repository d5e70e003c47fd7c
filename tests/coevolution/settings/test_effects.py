"""Each setting has an effect, or is refused where it has none."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import fields, replace
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from matrixworld import coevolution
from matrixworld.coevolution import NoEffectError, RaceSettings, SingleSettings
from matrixworld.coevolution.learners import LEARNERS
from matrixworld.coevolution.settings.effects import CONDITIONS, conditions_of
from tiny_race import TINY, directory_in_memory, tiny_race, tiny_single

ALTERNATING = {"schedule": "alternating", "opponents": 2}
ARCHIVES = {**ALTERNATING, "pursuers_meet": "generalist", "evaders_meet": "lapca"}
HALL = {"schedule": "hall-of-fame", "contemporaries": 2, "hall_sample": 1}
LONG = {"generations": 4, "train_steps": 20}

RUNS: dict[str, Any] = {
    "specialists with es": tiny_race(
        schedule="specialist-specialist", generations=1, variant="D", train_steps=20
    ),
    "alternating with momentum": tiny_race(**ALTERNATING, **LONG, optimizer="momentum"),
    "alternating with ga": tiny_race(**ALTERNATING, **LONG, learner="ga", population=8),
    "archives with cma": tiny_race(
        **ARCHIVES, **LONG, learner="cma", hidden=(), archive_size=1, seed=1
    ),
    "hall of fame": tiny_race(**HALL, population=8),
    "hall of fame without hall": tiny_race(**{**HALL, "hall_sample": 0}, population=8),
    "evaders alone for rewards": tiny_single(team="evader", fitness="rewards"),
    "actor-critic": tiny_race(**ALTERNATING, learner="actor-critic", actor_updates=2),
    "evaders alone with actor-critic and costs": tiny_single(
        team="evader",
        learner="actor-critic",
        clip=0.2,
        actor_updates=2,
        cost_limit=1.0,
        actor_rate=0.05,
    ),
    "pursuers alone": tiny_single(hidden=()),
    "own learner and samplers": tiny_race(
        **ALTERNATING,
        **LONG,
        learner="own_code:HillClimber",
        pursuers_meet="own_code:Hardest",
        evaders_meet="own_code:Hardest",
    ),
    "own learner alone": tiny_single(learner="own_code:HillClimber"),
    "evaders alone with ga": tiny_single(
        team="evader", learner="ga", selection="truncation", train_steps=20
    ),
}
"""Kinds of runs, in which each setting is changed."""

OTHER_VALUES: dict[str, Any] = {
    "variant": "S", "rows": 7, "cols": 7, "pursuers": 3, "evaders": 2, "obstacles": 0.1, "fov": 5,
    "diagonal": True, "hidden": (3,), "activation": "tanh", "initial_weight": 0.7,
    "initial_head": 0.7, "learner": "ga", "population": 6, "sigma": 0.3, "optimizer": "momentum",
    "learning_rate": 0.3, "momentum": 0.2, "anneal": True, "mutation": 0.4, "crossover": 0.9,
    "selection": "truncation", "tournament": 2, "truncation": 0.9, "elites": 3,
    "elite_episodes": 2, "fitness": "capture-rate", "overlap_penalty": 0.9, "train_steps": 9,
    "worlds": 2, "eval_steps": 60, "eval_episodes": 4, "seed": 6,
    "schedule": "generalist-generalist", "generations": 3, "pursuer_epochs": 4,
    "evader_epochs": 4, "joint_epochs": 4, "contemporaries": 3, "hall_sample": 2,
    "pursuers_meet": "latest", "evaders_meet": "latest", "opponents": 1, "archive_size": 7,
    "archive_episodes": 7, "retention_episodes": 2, "sharing": "competitive",
    "pursuer_virulence": 0.6, "evader_virulence": 0.6, "team": "evader", "against": "fleer",
    "learner_settings": {"sigma": 0.3}, "pursuers_meet_settings": {"forget": 0.9},
    "evaders_meet_settings": {"forget": 0.9},
    "actor_rate": 0.02, "critic_rate": 0.02, "discount": 0.5, "trace": 0.5, "actor_updates": 3,
    "critic_updates": 9, "clip": 0.01, "entropy": 0.5, "central_critic": True, "cost_limit": 0.0,
    "cost_rate": 5.0, "device": "cpu:0", "rewards": "published",
    "mask": "obstacles", "collision_penalty": 3.0,
    "start": "RUN", "epochs": 6, "archive_every": 3,
}  # fmt: skip
"""Another valid value of each setting."""

SECOND_VALUES = {"anneal": False, "selection": "tournament", "optimizer": "adam", "opponents": 3}
"""Values for runs that have the other value already."""

DETERMINE_OTHERS = {
    "schedule", "learner", "team", "hidden", "variant", "optimizer", "selection", "hall_sample",
    "start", "cost_limit", "fitness",
}  # fmt: skip
"""Settings on which the effect of other ones depends."""


def changed(run: Any, name: str, start: str) -> Any:
    """Return the settings with another value of one of them."""
    value = start if name == "start" else OTHER_VALUES[name]
    if getattr(run, name) == value:
        value = SECOND_VALUES[name]
    return replace(run, **{name: value})


def played(settings: Any, place: Path) -> tuple[Any, ...]:
    """Return the archive, the log and the payoff of a run: all that does not name the settings."""
    if settings.learner == "actor-critic":
        pytest.importorskip("torch")
    run = coevolution.start(settings, place, threads=1)
    payoff = run.run()
    archive = {team: genomes.tobytes() for team, genomes in run.files.archive().items()}
    outcomes = payoff.capture_rates.tobytes(), payoff.lengths.tobytes()
    return archive, (place / "log.csv").read_bytes(), outcomes


@pytest.fixture(scope="module")
def known(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], tuple[str, Any]]:
    """Return a function that plays a kind of run once: its place and its results."""
    with directory_in_memory() as root:
        yield cache(lambda kind: (str(root / kind), played(RUNS[kind], root / kind)))


CASES = [
    (kind, item.name)
    for kind, run in RUNS.items()
    for item in fields(run)
    # Settings that always have an effect are changed in one race and in one single run.
    if conditions_of(item.name) or kind in {"specialists with es", "pursuers alone"}
    # A device changes no results.
    if item.name != "device"
    # The value is that of the run: all values but one are refused.
    if not (item.name == "learner" and run.learner_name == "ga")
]


@pytest.mark.filterwarnings("ignore::matrixworld.coevolution.DisengagementWarning")
@pytest.mark.parametrize(("kind", "name"), CASES)
def test_each_setting_changes_the_results_or_is_refused(tmp_path, kind, name, known):
    place, expected = known(kind)
    try:
        other = changed(RUNS[kind], name, place)
    except NoEffectError as error:
        refused = error.name
    else:
        assert played(other, tmp_path / "run") != expected
        return
    # It is refused itself, or another one has no effect beside it.
    assert refused == name or name in DETERMINE_OTHERS


def test_another_value_is_known_of_each_setting():
    names = {item.name for kind in (RaceSettings, SingleSettings) for item in fields(kind)}
    assert set(OTHER_VALUES) == names


def test_conditions_are_those_of_fields():
    names = {item.name for kind in (RaceSettings, SingleSettings) for item in fields(kind)}
    assert set(CONDITIONS) <= names


EVERY = {*CONDITIONS} | {setting for entry in LEARNERS.values() for setting in entry.settings}


@pytest.mark.parametrize("name", sorted(EVERY))
def test_each_condition_is_met_by_some_run_and_not_by_another(name):
    runs = [*RUNS.values(), tiny_single(start="RUN")]
    runs = [run for run in runs if name in {item.name for item in fields(run)}]
    assert {all(each.holds(run) for each in conditions_of(name)) for run in runs} == {True, False}


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"mutation": 0.1}, r"mutation: expected 0.05 \(the default\), got 0.1; .* learner ga$"),
        ({"learner": "ga", "sigma": 0.3}, "sigma: .* an effect only with the learner es or cma$"),
        ({"learner": "ga", "optimizer": "momentum"}, "optimizer: .* with the learner es$"),
        ({"learner": "ga", "anneal": True}, "anneal: .* with the learner es$"),
        ({"momentum": 0.5}, "momentum: .* with the optimizer momentum$"),
        ({"selection": "truncation"}, "selection: .* with the learner ga$"),
        ({"learner": "ga", "truncation": 0.5}, "truncation: .* with the selection truncation$"),
        ({"learner": "ga", "selection": "truncation", "tournament": 3}, "tournament: .* tournamen"),
        ({"learner": "ga", "elites": 1, "elite_episodes": 3}, "elite_episodes: .* at least 2 elit"),
        ({"joint_epochs": 3}, "joint_epochs: expected 90 .*, got 3; .* the schedule hall-of-fame$"),
        ({"schedule": "hall-of-fame", "evader_epochs": 3}, "evader_epochs: .* other than hall-of"),
        ({"opponents": 3}, "opponents: expected 1 .*, got 3; .* with the schedule alternating$"),
        ({"archive_size": 3}, "archive_size: .* with the samplers maxsolve, lapca, generalist$"),
        ({"schedule": "alternating", "sharing": "competitive"}, "sharing: .* several opponents"),
        ({"variant": "B", "overlap_penalty": 0.1}, "overlap_penalty: .* may share a cell$"),
        ({"hidden": (), "activation": "tanh"}, "activation: .* with hidden layers$"),
        ({"pursuers_meet": "uniform"}, "pursuers_meet: expected no value"),
    ],
)
def test_a_setting_without_effect_is_refused_with_the_reason(changes, message):
    with pytest.raises(NoEffectError, match=message):
        RaceSettings(**changes)


def test_explicit_defaults_are_accepted():
    assert tiny_race(mutation=0.05, joint_epochs=90, opponents=1).generations == 2
    assert tiny_race(schedule="hall-of-fame", learner="ga", sigma=0.1, pursuer_epochs=60)
    # The default of either team: `replace` keeps values that were filled in for the first one.
    pursuers = tiny_single(learner="ga")
    assert replace(pursuers, team="evader").sigma == pursuers.sigma != 0.1


def test_one_team_alone():
    for changes in ({"initial_head": 0.3}, {"initial_weight": 0.3}):
        with pytest.raises(NoEffectError, match=rf"{next(iter(changes))}: .* only without start$"):
            tiny_single(start="RUN", **changes)
    with pytest.raises(NoEffectError, match="overlap_penalty: .* only where evaders learn$"):
        SingleSettings(team="pursuer", overlap_penalty=0.1, **TINY)
