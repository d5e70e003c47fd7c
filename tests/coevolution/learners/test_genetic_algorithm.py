"""The genetic algorithm: its operators, its elite, and its champion under noise."""

from __future__ import annotations

import numpy as np
import pytest

from matrixworld.coevolution import GeneticAlgorithm, NoiseTable
from matrixworld.coevolution.learners.genetic_algorithm import (
    mate_uniform,
    mutate_from_table,
    select_tournament,
    select_truncation,
)


def generator(number=0):
    return np.random.Generator(np.random.SFC64([7, number]))


def test_tournament_prefers_the_fitter():
    fitness = np.arange(10.0)
    chosen = select_tournament(fitness, 20_000, generator(), size=3)
    assert np.mean(chosen == 9) == pytest.approx(1 - 0.9**3, abs=0.02)
    at_random = select_tournament(fitness, 20_000, generator(), size=1)
    assert np.bincount(at_random).min() > 1700


def test_truncation_takes_from_the_best_only():
    chosen = select_truncation(np.array([3.0, 9.0, 1.0, 8.0]), 500, generator(), fraction=0.5)
    assert set(chosen) == {1, 3}


def test_mating_mixes_the_given_share():
    # All genes of a first parent are 0, and those of a second one its number from 1.
    children = np.zeros((2000, 10), np.float32)
    population = np.repeat(np.arange(1.0, 6.0, dtype=np.float32)[:, None], 10, axis=1)
    before, mates = population.copy(), generator(1).integers(0, 5, size=2000)
    assert mate_uniform(children, population, mates, generator(), probability=0.25) is children
    assert (population == before).all()
    mixed = children.any(axis=1)
    assert mixed.mean() == pytest.approx(0.25, abs=0.04)
    assert (children[mixed] != 0).mean() == pytest.approx(0.5, abs=0.03)
    assert ((children == 0) | (children == population[mates])).all()


def test_mutation_has_the_given_standard_deviation():
    genomes, noise = np.full((500, 100), 3.0, np.float32), NoiseTable(100, generator(2), sigma=0.5)
    assert mutate_from_table(genomes, generator(), noise=noise) is genomes
    assert genomes.mean() == pytest.approx(3.0, abs=0.02)
    assert genomes.std() == pytest.approx(0.5, abs=0.02)


def learner_of(population, elites=2):
    noise = NoiseTable(np.shape(population)[1], generator(2), sigma=0.05)
    return GeneticAlgorithm(population, noise, elites=elites)


def test_elites_are_kept_and_an_operator_may_return_a_new_array():
    learner = learner_of(generator(5).normal(size=(8, 5)), elites=3)
    learner.toolbox.register("mutate", lambda genomes, rng: genomes * np.float32(0))
    first = learner.ask(generator())
    fitness = first.sum(axis=1)
    learner.tell(fitness)
    elite = first[np.argsort(-fitness)[:3]]
    assert np.array_equal(learner.genome, elite[0])
    assert np.array_equal(learner.ask(generator(1)), [*elite, *np.zeros((5, 5))])


# The winner's curse:

SIZE, ELITES, TRIALS = 40, 10, 400
SPREAD, NOISE = 0.1, 0.3  # standard deviations of the true fitness and of one epoch's noise
AGAIN = 30  # new matches of each elite


def scored(rng):
    """Return a learner after an epoch of noisy fitness, and that fitness; genes are the truth."""
    learner = learner_of(rng.normal(0.0, SPREAD, (SIZE, 1)), ELITES)
    noisy = learner.ask(rng)[:, 0] + rng.normal(0.0, NOISE, SIZE)
    learner.tell(noisy)
    return learner, noisy


def test_new_matches_of_the_elite_reduce_the_overestimate_and_find_a_better_champion():
    rng, rows = np.random.default_rng(1), []
    for _ in range(TRIALS):
        learner, noisy = scored(rng)
        champion = learner.genome[0]
        again = learner.elite_genomes()[:, 0] + rng.normal(0.0, NOISE / np.sqrt(AGAIN), ELITES)
        learner.choose_champion(again)
        rows.append([noisy.max(), champion, again.max(), learner.genome[0]])
    estimate, champion, new_estimate, new_champion = np.transpose(rows)
    # The expected maximum of 40 normal numbers is 2.161 standard deviations; the share of noise in
    # the variance is 9/10.
    curse = (estimate - champion).mean()
    assert curse == pytest.approx(2.161 * np.hypot(SPREAD, NOISE) * 0.9, abs=0.05)
    assert 0 < (new_estimate - new_champion).mean() < 0.1 * curse
    gain = new_champion - champion
    assert gain.mean() > 5 * gain.std() / np.sqrt(TRIALS)


def test_crowning_changes_the_champion_and_no_offspring():
    children = []
    for crowned in (False, True):
        learner, noisy = scored(np.random.default_rng(2))
        fittest = learner.genome
        assert learner.elite.tolist() == np.argsort(-noisy)[:ELITES].tolist()
        if crowned:
            learner.choose_champion(np.arange(ELITES))
            assert learner.genome == learner.elite_genomes()[-1] != fittest
            restored, _ = scored(np.random.default_rng(3))
            restored.restore(learner.state())
            assert restored.genome == learner.genome
        children.append(learner.ask(np.random.default_rng(4)))
        learner.tell(np.arange(SIZE))
        # The next epoch has its own champion.
        assert learner.genome == children[-1][-1]
    assert np.array_equal(*children)


def test_there_is_no_elite_before_the_first_fitness():
    learner = learner_of(np.zeros((4, 1)))
    with pytest.raises(RuntimeError, match="elite: expected a call of tell before it, got none"):
        learner.choose_champion([1.0, 2.0])
    learner.ask(generator())
    learner.tell([0.0, 3.0, 1.0, 2.0])
    for bad in ([1.0], [1.0, np.nan]):
        with pytest.raises(ValueError, match="fitness: expected"):
            learner.choose_champion(bad)
