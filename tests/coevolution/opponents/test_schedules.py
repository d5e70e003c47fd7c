"""The paper's three schedules, against its algorithms by hand; and the settings of a race."""

from __future__ import annotations

import numpy as np
import pytest

from matrixworld.coevolution import SCHEDULES, RaceSettings, available
from matrixworld.coevolution.settings import ALL_SCHEDULES

# The paper's pseudo-code, generations 1 to 3 with four epochs each, by hand:
# schedule: {k: (opponents of the pursuers, generations of e; of the evaders, generations of p)}
BY_HAND = {
    "specialist-specialist": {
        1: ([0, 0, 0, 0], [1, 1, 1, 1]),
        2: ([1, 1, 1, 1], [2, 2, 2, 2]),
        3: ([2, 2, 2, 2], [3, 3, 3, 3]),
    },
    "generalist-specialist": {
        1: ([0, 0, 0, 0], [1, 1, 1, 1]),
        2: ([0, 1, 0, 1], [2, 2, 2, 2]),
        3: ([0, 1, 2, 0], [3, 3, 3, 3]),
    },
    "generalist-generalist": {
        1: ([0, 0, 0, 0], [0, 1, 0, 1]),
        2: ([0, 1, 0, 1], [0, 1, 2, 0]),
        3: ([0, 1, 2, 0], [0, 1, 2, 3]),
    },
}


def opponents(name, team, k, epochs):
    """Return the opponents of a team in the first epochs of its generation k."""
    sampler, rng = SCHEDULES[name].sampler(team), np.random.default_rng(0)
    sampled = [sampler.sample(available(team, k), i, rng).tolist() for i in range(epochs)]
    assert all(len(each) == 1 for each in sampled)
    return [each[0] for each in sampled]


def test_all_schedules_are_written_out():
    assert SCHEDULES.keys() == BY_HAND.keys()


@pytest.mark.parametrize("name", BY_HAND)
@pytest.mark.parametrize("k", [1, 2, 3])
def test_schedule(name, k):
    pursuers_meet, evaders_meet = BY_HAND[name][k]
    assert opponents(name, "pursuer", k, 4) == pursuers_meet
    assert opponents(name, "evader", k, 4) == evaders_meet


def test_generation_zero_learns_nothing():
    with pytest.raises(ValueError, match="generation: expected at least 1, got 0"):
        available("pursuer", 0)


def test_defaults_are_those_that_were_seen_to_work():
    settings = RaceSettings()
    assert (settings.generations, settings.pursuer_epochs, settings.evader_epochs) == (30, 60, 120)
    assert settings.total_epochs("evader") == 3600
    assert settings.learner_name == "es"
    assert settings.resolved_overlap_penalty == 0.2
    assert settings.network.genome_size == 363 * 32 + 32 + 32 * 5 + 5


@pytest.mark.parametrize("schedule", ALL_SCHEDULES)
def test_population_depends_on_the_schedule(schedule):
    assert RaceSettings(schedule=schedule).population == (24 if schedule == "hall-of-fame" else 48)
    assert RaceSettings(schedule=schedule, population=6).population == 6


def test_overlap_is_penalised_where_teammates_may_share_a_cell():
    assert RaceSettings(variant="SB").resolved_overlap_penalty == 0.0
    assert RaceSettings(fitness="rewards").resolved_overlap_penalty == 0.0
    assert RaceSettings(variant="S", overlap_penalty=0.5).resolved_overlap_penalty == 0.5


@pytest.mark.parametrize(
    ("changes", "error", "message"),
    [
        ({"schedule": "generalist"}, ValueError, "schedule: expected one of specialist-specialist"),
        ({"generations": 0}, ValueError, "generations: expected at least 1, got 0"),
        ({"generations": 2.5}, TypeError, "generations: expected an integer, got 2.5"),
        ({"pursuer_epochs": 0}, ValueError, "pursuer_epochs"),
        ({"population": 7}, ValueError, "population: expected an even number for es, got 7"),
        ({"sigma": 0.0}, ValueError, "sigma: expected a number above 0"),
        ({"learning_rate": float("nan")}, ValueError, "learning_rate"),
        ({"learning_rate": "fast"}, TypeError, "learning_rate: expected a number, got 'fast'"),
        (
            {"learner": "sgd"},
            ValueError,
            "learner: expected one of es, ga, cma, actor-critic, or module:object, got 'sgd'",
        ),
        ({"learner": "cma"}, ValueError, "learner: expected at most 1000 genes .* got 11813"),
        ({"optimizer": "sgd"}, ValueError, "optimizer: expected one of adam, momentum"),
        ({"momentum": 1.0}, ValueError, "momentum: expected"),
        ({"learner": "ga", "elites": 48}, ValueError, "elites: expected fewer than 48"),
        ({"contemporaries": 0, "hall_sample": 0}, ValueError, "contemporaries and hall_sample"),
        (
            {"pursuers_meet": "latest"},
            ValueError,
            "pursuers_meet: expected no value [(]the default",
        ),
        ({"schedule": "alternating", "evaders_meet": "all"}, ValueError, "evaders_meet: expected"),
        ({"opponents": 2}, ValueError, "opponents: expected 1 .*with the schedule alter"),
        ({"opponents": 0}, ValueError, "opponents: expected at least 1, got 0"),
        ({"archive_size": 0}, ValueError, "archive_size: expected at least 1, got 0"),
        ({"archive_episodes": 1.5}, TypeError, "archive_episodes: expected an integer"),
        ({"sharing": "fair"}, ValueError, "sharing: expected one of none, competitive"),
        ({"evader_virulence": 0.4}, ValueError, "evader_virulence: expected a number at least 0.5"),
        ({"sharing": "competitive", "fitness": "rewards"}, ValueError, "sharing: expected a fit"),
        (
            {"sharing": "competitive", "pursuer_virulence": 0.9},
            ValueError,
            "pursuer_virulence: expected it with sharing .none. only",
        ),
        ({"fitness": "style"}, ValueError, "fitness: expected one of captured-fraction"),
        ({"overlap_penalty": -1.0}, ValueError, "overlap_penalty"),
        ({"variant": "X"}, ValueError, "variant: expected one of"),
        ({"fov": 4}, ValueError, "fov"),
        ({"rows": 2, "cols": 2}, ValueError, "."),
        ({"hidden": (0,)}, ValueError, "."),
        ({"activation": "sine"}, ValueError, "."),
        ({"seed": -1}, ValueError, "seed: expected 0 to 9223372036854775807, got -1"),
        ({"seed": 2**63}, ValueError, "seed: expected 0 to"),
        ({"anneal": 1}, TypeError, "anneal: expected True or False, got 1"),
        ({"train_steps": 0}, ValueError, "train_steps"),
        ({"initial_head": -0.1}, ValueError, "initial_head"),
    ],
)
def test_bad_settings_are_refused(changes, error, message):
    with pytest.raises(error, match=message):
        RaceSettings(**changes)
