"""The operators of the genetic algorithm: selection, mating and mutation."""

from __future__ import annotations

from functools import partial

import numpy as np
import pytest

from matrixworld.coevolution import GeneticAlgorithm, NoiseTable
from matrixworld.coevolution.learners.genetic_algorithm import (
    mate_uniform,
    mutate_from_table,
    mutate_gaussian,
    select_tournament,
    select_truncation,
)


def generator(number=0):
    return np.random.Generator(np.random.SFC64([7, number]))


def test_tournament_prefers_the_fitter():
    fitness = np.arange(10.0)
    chosen = select_tournament(fitness, 20_000, generator(), size=3)
    share_of_best = np.mean(chosen == 9)
    assert share_of_best == pytest.approx(1 - 0.9**3, abs=0.02)
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
    mated = mate_uniform(children, population, mates, generator(), probability=0.25)
    assert mated is children
    assert (population == before).all()
    mixed = children.any(axis=1)
    assert mixed.mean() == pytest.approx(0.25, abs=0.04)
    assert (children[mixed] != 0).mean() == pytest.approx(0.5, abs=0.03)
    assert ((children == 0) | (children == population[mates])).all()


@pytest.mark.parametrize(
    "mutate",
    [
        partial(mutate_gaussian, sigma=0.5),
        partial(mutate_from_table, noise=NoiseTable(100, generator(2), sigma=0.5)),
    ],
)
def test_mutation_has_the_given_standard_deviation(mutate):
    genomes = np.full((500, 100), 3.0, dtype=np.float32)
    assert mutate(genomes, generator()) is genomes
    assert genomes.mean() == pytest.approx(3.0, abs=0.02)
    assert genomes.std() == pytest.approx(0.5, abs=0.02)


def test_another_operator_may_return_a_new_array():
    noise = NoiseTable(5, generator(2), sigma=1.0)
    learner = GeneticAlgorithm(np.zeros((8, 5), np.float32), noise, elites=2)
    learner.toolbox.register("mutate", lambda genomes, rng: genomes + np.float32(1))
    learner.tell(learner.ask(generator()).sum(axis=1))
    assert (learner.ask(generator(1)) == [[0.0]] * 2 + [[1.0]] * 6).all()
