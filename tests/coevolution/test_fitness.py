"""Fitness from statistics, competitive sharing, limits; seeds of matches."""

import itertools
from dataclasses import replace

import numpy as np
import pytest

import matrixworld as mw
from matrixworld.coevolution.games.game import Scores
from matrixworld.coevolution.games.pursuit import Pursuit
from matrixworld.coevolution.learners.fitness import (
    feasible_first,
    mean_over_opponents,
    shared_fitness,
)
from matrixworld.coevolution.seeding import Phase, evaluation_seed, explanation_seed, training_seeds
from matrixworld.coevolution.types import TEAMS
from tiny_race import begun, tiny_single

STATISTICS = {
    "captured_fraction": np.array([[0.2, 0.4], [1.0, 0.0]], dtype=np.float32),
    "capture_rate": np.array([[0.5, 0.5], [1.0, 0.0]], dtype=np.float32),
    "evader_overlap": np.array([[0.1, 0.3], [0.0, 0.0]], dtype=np.float32),
    "pursuer_return": np.array([[10.0, 20.0], [0.0, 0.0]]),
    "evader_return": np.array([[-10.0, -30.0], [0.0, 2.0]]),
}
"""Two matches of two worlds each."""


@pytest.mark.parametrize(
    ("measure", "team", "expected"),
    [
        ("captured-fraction", "pursuer", [0.3, 0.5]),
        ("captured-fraction", "evader", [0.7 - 0.5 * 0.2, 0.5]),
        ("capture-rate", "pursuer", [0.5, 0.5]),
        ("capture-rate", "evader", [0.5 - 0.5 * 0.2, 0.5]),
        ("rewards", "pursuer", [15.0, 0.0]),
        ("rewards", "evader", [-20.0, 1.0]),  # they have penalties of their own
    ],
)
def test_fitness(measure, team, expected):
    scores = Scores(STATISTICS["capture_rate"], STATISTICS)
    values = Pursuit(penalty=0.5).values(scores, team, measure)
    assert values.mean(axis=1) == pytest.approx(expected)


def test_sharing_by_hand():
    # Opponent 0 is beaten by 0 and 1, opponent 1 by 1 alone, opponent 2 by no individual.
    wins = np.array([[1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 0.0, 0.0]])
    assert shared_fitness(wins).tolist() == [0.5, 1.5, 0.0]
    # Half a win beside a whole one gets a third of the opponent; n / m is 2.
    assert shared_fitness(np.array([[0.5], [1.0]])) == pytest.approx([2 / 3, 4 / 3])
    assert shared_fitness(np.zeros((2, 3))).tolist() == [0.0, 0.0]


def test_opponents_that_were_not_met_do_not_count():
    nan = np.nan
    payoff = np.array([[1.0, 0.0, nan], [1.0, nan, 0.5], [0.0, 0.0, nan]])
    # Opponent 0 is shared by two, opponent 2 belongs to individual 1; n / m = 3 / 3.
    assert shared_fitness(payoff) == pytest.approx([0.5, 1.5, 0.0])
    assert mean_over_opponents(payoff).tolist() == [0.5, 0.75, 0.0]
    assert mean_over_opponents(np.array([[1.0, 3.0]])).tolist() == [2.0]


def test_candidates_within_the_limit_come_first():
    found = feasible_first(np.array([0.2, 0.9, 0.5, 0.7]), np.array([-1.0, 3.0, 0.0, 0.5]))
    np.testing.assert_allclose(found, [0.2, 0.2 - 3.0, 0.5, 0.2 - 0.5])
    # Beyond the limit only the violation counts.
    np.testing.assert_allclose(
        feasible_first(np.array([0.9, 0.1]), np.array([3.0, 2.0])), [-3.0, -2.0]
    )


def test_collisions_are_counted_as_by_the_safety_monitor():
    config = mw.WorldConfig("S", rows=6, cols=6, n_pursuers=4, n_evaders=3, max_steps=20)
    scores = mw.rollout(config, "random", "random", mw.Matches.of(0, 0, [1, 2]), episodes=3)
    for t, team in enumerate(TEAMS):
        costs = Pursuit(world=config).costs(Scores(scores.capture_rate, vars(scores)), team)
        for match, found in enumerate(costs):
            monitor = mw.SafetyMonitor()
            fields = (scores.collisions, scores.faults, scores.agent_steps, scores.capture_rate)
            monitor.add(*(each[match] for each in fields))
            assert found == pytest.approx(monitor.summary().fault_rate[t].sum())


def test_a_limit_decides_the_fitness_of_a_run(tmp_path):
    settings = tiny_single(rules="S", rows=4, cols=4, n_pursuers=3, train_steps=12, population=8)
    initial = settings.evaluation_game.policies["pursuer"].initial
    genomes = np.stack([initial(np.random.default_rng(k), head=2.0) for k in range(8)])
    run = begun(settings, tmp_path / "run", threads=1).training
    seeds = np.zeros((8, 1), np.uint64)
    scores = run.play_candidates("pursuer", genomes, "random", np.zeros(1, int), seeds)
    rates = run.game.costs(scores, "pursuer")
    limit = float(np.sort(rates)[3:5].mean())  # between the fourth and the fifth of eight
    plain, limited = (
        each.fitness(run.game, scores, "pursuer", lambda values: values[:, None])
        for each in (settings.learner, replace(settings.learner, cost_limit=limit))
    )
    assert (rates <= limit).sum() == 4
    np.testing.assert_allclose(limited, feasible_first(plain, rates - limit))


LARGEST = 2**64 - 1


@pytest.mark.parametrize("key", [(5, 3, 2, Phase.EVADERS_LEARN, 17), (LARGEST, 0, 0, 1, 0)])
def test_training_seeds_are_the_words_of_a_seed_sequence(key):
    words = np.random.SeedSequence([int(number) for number in key]).generate_state(9, np.uint64)
    assert training_seeds(*key, 9).tolist() == words.tolist()


def test_seeds_of_all_matches_differ():
    keys = itertools.product(range(3), range(3), range(3), Phase, range(3))
    seeds = [seed for key in keys for seed in training_seeds(*key, 5).tolist()]
    seeds += [evaluation_seed(*key) for key in itertools.product(range(3), range(9), range(9))]
    seeds += [explanation_seed(*key) for key in itertools.product(range(3), range(9))]
    assert len(set(seeds)) == len(seeds) == 3**4 * len(Phase) * 5 + 3**5 + 3**3
