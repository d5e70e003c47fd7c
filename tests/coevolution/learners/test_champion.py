"""The genetic algorithm's champion under noise: the winner's curse, and the elite scored again."""

from __future__ import annotations

import numpy as np
import pytest

from matrixworld.coevolution import GeneticAlgorithm, NoiseTable

SIZE, ELITES, TRIALS = 40, 10, 400
SPREAD, NOISE = 0.1, 0.3  # standard deviations of the true fitness and of one epoch's noise
AGAIN = 30  # new matches of each elite


def scored(rng):
    """Return a learner after an epoch of noisy fitness, and that fitness; genes are the truth."""
    genomes = rng.normal(0.0, SPREAD, (SIZE, 1))
    table = NoiseTable(1, np.random.default_rng(0), sigma=0.05)
    learner = GeneticAlgorithm(genomes, table, elites=ELITES)
    truth = learner.ask(rng)[:, 0]
    noisy = truth + rng.normal(0.0, NOISE, SIZE)
    learner.tell(noisy)
    return learner, noisy


@pytest.fixture(scope="module")
def trials():
    """Return (trials, 4): estimate and truth of the champion of one epoch, and of the crowned."""
    rng, rows = np.random.default_rng(1), []
    for _ in range(TRIALS):
        learner, noisy = scored(rng)
        row = [noisy.max(), learner.genome[0]]
        means = rng.normal(0.0, NOISE / np.sqrt(AGAIN), ELITES)
        again = learner.elite_genomes()[:, 0] + means
        learner.choose_champion(again)
        rows.append([*row, again.max(), learner.genome[0]])
    return np.array(rows)


def test_the_fitness_of_one_epoch_overestimates_its_champion(trials):
    # The expected maximum of 40 normal numbers is 2.161 standard deviations; the share of noise in
    # the variance is 9/10.
    expected = 2.161 * np.hypot(SPREAD, NOISE) * 0.9
    curse = (trials[:, 0] - trials[:, 1]).mean()
    assert curse == pytest.approx(expected, abs=0.05)
    assert curse > 0.5


def test_new_matches_of_the_elite_reduce_the_overestimate_and_find_a_better_champion(trials):
    before, after = (trials[:, i] - trials[:, i + 1] for i in (0, 2))
    assert 0 < after.mean() < 0.1 * before.mean()
    gain = trials[:, 3] - trials[:, 1]
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
    learner = GeneticAlgorithm(np.zeros((4, 1)), NoiseTable(1, np.random.default_rng(0), sigma=0.1))
    with pytest.raises(RuntimeError, match="elite: expected a call of tell before it, got none"):
        learner.choose_champion([1.0, 2.0])
    learner.ask(np.random.default_rng(0))
    learner.tell([0.0, 3.0, 1.0, 2.0])
    for bad in ([1.0], [1.0, np.nan]):
        with pytest.raises(ValueError, match="fitness: expected"):
            learner.choose_champion(bad)
