"""Limits and penalties of collisions: candidates within the limit first, rewards, multiplier."""

from __future__ import annotations

import numpy as np
import pytest

import matrixworld as mw
from matrixworld.coevolution.fitness import collisions, feasible_first
from matrixworld.coevolution.runs.training_matches import TrainingMatches
from matrixworld.coevolution.types import TEAMS
from tiny_race import tiny_single


def test_candidates_within_the_limit_come_first() -> None:
    found = feasible_first([0.2, 0.9, 0.5, 0.7], [-1.0, 3.0, 0.0, 0.5])
    np.testing.assert_allclose(found, [0.2, 0.2 - 3.0, 0.5, 0.2 - 0.5])
    # Beyond the limit only the violation counts.
    np.testing.assert_allclose(feasible_first([0.9, 0.1], [3.0, 2.0]), [-3.0, -2.0])


def test_collisions_are_counted_as_by_the_safety_monitor() -> None:
    config = mw.WorldConfig("S", rows=6, cols=6, n_pursuers=4, n_evaders=3, max_steps=20)
    scores = mw.rollout(config, "random", "random", mw.Matches.of(0, 0, [1, 2]), episodes=3)
    for t, team in enumerate(TEAMS):
        for match, found in enumerate(collisions(scores, team)):
            monitor = mw.SafetyMonitor()
            fields = (scores.collisions, scores.faults, scores.agent_steps, scores.capture_rate)
            monitor.add(*(each[match] for each in fields))
            assert found == pytest.approx(monitor.summary().fault_rate[t].sum())


def test_a_limit_decides_the_fitness_of_a_run() -> None:
    settings = tiny_single(rules="S", rows=4, cols=4, n_pursuers=3, train_steps=12, population=8)
    genomes = np.stack(
        [settings.network.initial(np.random.default_rng(k), head=2.0) for k in range(8)]
    )
    seeds = np.zeros((8, 1), np.uint64)
    plain = TrainingMatches(settings, mw.rollout, 1)
    scores = plain.play_candidates("pursuer", genomes, "random", np.zeros(1, int), seeds)
    rates = collisions(scores, "pursuer")
    limit = float(np.sort(rates)[3:5].mean())
    limited = TrainingMatches(settings.changed({"fitness.cost_limit": limit}), mw.rollout, 1)
    found = limited.fitness(scores, "pursuer", lambda values: values[:, None])
    expected = plain.fitness(scores, "pursuer", lambda values: values[:, None])
    within = rates <= limit
    assert within.sum() == 4
    np.testing.assert_array_equal(found[within], expected[within])
    assert found[within].min() > found[~within].max()
    assert list(np.argsort(-found[~within])) == list(np.argsort(rates[~within]))
