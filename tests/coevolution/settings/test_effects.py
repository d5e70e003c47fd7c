"""Each setting has an effect, or is refused where it has none."""

from __future__ import annotations

from dataclasses import fields, replace
from pathlib import Path
from typing import Any

import pytest

from matrixworld import coevolution
from matrixworld.coevolution import NoEffectError, RaceSettings, SingleSettings
from matrixworld.coevolution.learners import LEARNERS
from matrixworld.coevolution.settings.effects import CONDITIONS, conditions_of
from tiny_race import TINY, directory_in_memory, results, tiny_race, tiny_single

ALTERNATING = {"schedule": "alternating", "opponents": 2}
ARCHIVES = {**ALTERNATING, "pursuers_meet": "lapca", "evaders_meet": "maxsolve"}
HALL = {"schedule": "hall-of-fame", "contemporaries": 2, "hall_sample": 2}
LONG = {"generations": 5, "train_steps": 20}

RUNS: dict[str, Any] = {
    "specialists with es": tiny_race(schedule="specialist-specialist", generations=1),
    "alternating with momentum": tiny_race(**ALTERNATING, optimizer="momentum"),
    "alternating with ga": tiny_race(**ALTERNATING, learner="ga", population=8),
    "archives with cma": tiny_race(
        **ARCHIVES, **LONG, learner="cma", hidden=(), variant="SB", archive_size=1, seed=1
    ),
    "hall of fame": tiny_race(**HALL, population=8),
    "hall of fame without hall": tiny_race(**{**HALL, "hall_sample": 0}, population=8),
    "pursuers alone": tiny_single(hidden=()),
    "evaders alone with ga": tiny_single(team="evader", learner="ga", selection="truncation"),
}
"""Kinds of runs, in which each setting is changed."""

OTHER_VALUES: dict[str, Any] = {
    "variant": "R", "rows": 7, "cols": 7, "pursuers": 3, "evaders": 2, "obstacles": 0.1, "fov": 5,
    "diagonal": True, "hidden": (3,), "activation": "tanh", "initial_weight": 0.7,
    "initial_head": 0.7, "learner": "ga", "population": 6, "sigma": 0.3, "optimizer": "momentum",
    "learning_rate": 0.3, "momentum": 0.2, "anneal": True, "mutation": 0.4, "crossover": 0.9,
    "selection": "truncation", "tournament": 2, "truncation": 0.9, "elites": 3,
    "elite_episodes": 2, "fitness": "capture-rate", "overlap_penalty": 0.9, "train_steps": 9,
    "worlds": 2, "eval_steps": 13, "eval_episodes": 4, "seed": 6,
    "schedule": "generalist-generalist", "generations": 3, "pursuer_epochs": 4,
    "evader_epochs": 4, "joint_epochs": 4, "contemporaries": 3, "hall_sample": 1,
    "pursuers_meet": "latest", "evaders_meet": "latest", "opponents": 3, "archive_size": 7,
    "archive_episodes": 7, "retention_episodes": 2, "sharing": "competitive",
    "pursuer_virulence": 0.6, "evader_virulence": 0.6, "team": "evader", "against": "fleer",
    "start": "RUN", "epochs": 6, "archive_every": 3,
}  # fmt: skip
"""Another valid value of each setting."""

MORE: dict[str, Any] = {"anneal": False, "selection": "tournament"}
"""Another value where a run has the first one already."""


def changed(run: Any, name: str) -> Any:
    """Return the settings with another value of one of them."""
    value = OTHER_VALUES[name]
    return replace(run, **{name: MORE.get(name) if getattr(run, name) == value else value})


@pytest.fixture(scope="module")
def played() -> Any:
    """Return a function that plays a run once, and returns its files."""
    known: dict[Any, dict[str, bytes]] = {}
    with directory_in_memory() as root:

        def play(settings: Any) -> dict[str, bytes]:
            if settings not in known:
                place = root / str(len(known))
                coevolution.start(settings, place, threads=1).run()
                known[settings] = results(place)
            return known[settings]

        yield play


@pytest.fixture(scope="module")
def start_run(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """Return runs to start from, by the layers and the team."""
    root = tmp_path_factory.mktemp("starts")
    places = {}
    for kind in ("pursuers alone", "evaders alone with ga"):
        coevolution.start(replace(RUNS[kind], seed=9), root / kind, threads=1).run()
        places[kind] = str(root / kind)
    return places


CASES = [(kind, item.name) for kind, run in RUNS.items() for item in fields(run)]


def without(files: dict[str, bytes]) -> dict[str, bytes]:
    """Return the files but config.json, which holds the settings themselves."""
    return {name: content for name, content in files.items() if name != "config.json"}


@pytest.mark.parametrize(("kind", "name"), CASES)
def test_each_setting_changes_the_results_or_is_refused(kind, name, played, start_run):
    run = RUNS[kind]
    if name == "start":
        other = replace(run, start=start_run[kind])
    else:
        try:
            other = changed(run, name)
        except NoEffectError as error:
            assert error.name in str(error)
            # Refused itself, or since it takes the effect from another setting that was given.
            assert error.name == name or name in {"schedule", "learner", "team", "hidden"} | {
                "variant", "optimizer", "selection", "hall_sample"
            }  # fmt: skip
            return
    assert without(played(other)) != without(played(run))


def test_another_value_is_known_of_each_setting():
    names = {item.name for kind in (RaceSettings, SingleSettings) for item in fields(kind)}
    assert set(OTHER_VALUES) == names


def test_conditions_are_those_of_fields():
    names = {item.name for kind in (RaceSettings, SingleSettings) for item in fields(kind)}
    assert set(CONDITIONS) <= names


@pytest.mark.parametrize("name", {*CONDITIONS} | {s for e in LEARNERS.values() for s in e.settings})
def test_each_condition_is_met_by_some_run_and_not_by_another(name):
    runs = [*RUNS.values(), tiny_race(**ARCHIVES, learner="cma", hidden=())]
    runs = [run for run in runs if hasattr(run, name)]
    held = [all(each.holds(run) for each in conditions_of(name)) for run in runs]
    if name in {"initial_head"}:
        # Fails in runs that start from another one only.
        runs.append(replace(RUNS["pursuers alone"], start="RUN"))
        held.append(all(each.holds(runs[-1]) for each in conditions_of(name)))
    assert True in held
    assert False in held


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
        ({"joint_epochs": 3}, "joint_epochs: expected 15 .*, got 3; .* the schedule hall-of-fame$"),
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
    assert tiny_race(mutation=0.05, joint_epochs=15, opponents=1).generations == 2
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
