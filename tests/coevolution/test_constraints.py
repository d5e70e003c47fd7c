"""Limits and penalties of collisions: candidates within the limit first, rewards, multiplier."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import matrixworld as mw
from matrixworld import coevolution
from matrixworld.coevolution.fitness import collisions, feasible_first
from matrixworld.coevolution.runs.training_matches import TrainingMatches
from matrixworld.coevolution.types import TEAMS
from matrixworld.world.policy import Population
from tiny_race import tiny_single


def test_candidates_within_the_limit_come_first() -> None:
    fitness, violation = [0.2, 0.9, 0.5, 0.7], [-1.0, 3.0, 0.0, 0.5]
    found = feasible_first(fitness, violation)
    np.testing.assert_allclose(found, [0.2, 0.2 - 3.0, 0.5, 0.2 - 0.5])
    assert list(np.argsort(-found)) == [2, 0, 3, 1]


def test_beyond_the_limit_only_the_violation_counts() -> None:
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


def test_a_limit_makes_evolution_collide_less(tmp_path: Path) -> None:
    base = tiny_single(
        rules="SB", rows=5, cols=5, n_pursuers=4, n_evaders=1, epochs=40, archive_every=40,
        population=24, match_episodes=4, hidden=(), learning_rate=0.1, measure="capture-rate",
        train_steps=20,
    )  # fmt: skip

    def rate(name: str, limit: float | None) -> float:
        run = coevolution.finish(
            base.changed({"fitness.cost_limit": limit}), tmp_path / name, threads=1
        )
        own = Population(run.teams["pursuer"].genomes[-1:], run.teams["pursuer"].network)
        matches = mw.Matches.of(0, 0, 9)
        scores = mw.rollout(replace(base.world, max_steps=30), own, "random", matches, episodes=50)
        return float(collisions(scores, "pursuer")[0])

    assert rate("limited", 20.0) < 0.5 * rate("free", None)
