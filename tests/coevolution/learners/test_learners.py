"""Learners and their parts, on functions of known optimum; champions of a genetic algorithm."""

import math

import numpy as np
import pytest
from deap import cma
from threadpoolctl import threadpool_limits

from matrixworld.coevolution import (
    CmaEs,
    EvolutionStrategy,
    GeneticAlgorithm,
    NoiseTable,
)
from matrixworld.coevolution.learners.evolution_strategy import centred_ranks
from matrixworld.coevolution.learners.genetic_algorithm import (
    mate_uniform,
    mutate_from_table,
    select_tournament,
    select_truncation,
)
from matrixworld.coevolution.learners.learner import Adam, DivergedError, Momentum

SIZE = 20
TARGET = np.linspace(-1.0, 1.0, SIZE)


def closeness(genomes):
    """Minus the squared distance from the target: a sphere, best at zero."""
    return -((np.asarray(genomes, dtype=np.float64) - TARGET) ** 2).sum(axis=-1)


def generator(epoch=0):
    return np.random.Generator(np.random.SFC64([7, epoch]))


def noise_table(size=SIZE, sigma=0.05):
    return NoiseTable(size, generator(99), sigma=sigma)


def strategy(**changes):
    options = {"samples": 16, "learning_rate": 0.05, **changes}
    return EvolutionStrategy(np.zeros(SIZE), noise_table(), **options)


def momentum(**changes):
    return strategy(**{"momentum": 0.9, "learning_rate": 0.01, **changes})


def covariance(**changes):
    return CmaEs(np.zeros(SIZE), **{"sigma": 0.3, "samples": 16, **changes})


def algorithm(sigma=0.05, **changes):
    population = generator(98).standard_normal((40, SIZE), dtype=np.float32)
    return GeneticAlgorithm(population, noise_table(sigma=sigma), **changes)


LEARNERS = [strategy, momentum, algorithm, covariance]


def teach(learner, epochs, first=0):
    for epoch in range(first, first + epochs):
        learner.tell(closeness(learner.ask(generator(epoch))))
    return learner


@pytest.mark.parametrize(
    ("fitness", "ranks"),
    [
        ([10.0, 30.0, 20.0], [-0.5, 0.5, 0.0]),
        ([5.0, 5.0, 5.0, 5.0], [0.0, 0.0, 0.0, 0.0]),
        ([1.0, 2.0, 2.0, 3.0, 3.0], [-0.5, -0.125, -0.125, 0.375, 0.375]),
    ],
)
def test_centred_ranks(fitness, ranks):
    assert centred_ranks(np.array(fitness)).tolist() == ranks


GRADIENTS = np.array([[0.3, -2.0], [0.1, 1.0], [-0.5, 0.0], [0.2, 4.0]], dtype=np.float32)
RATES = [0.02, 0.02, 0.01, 0.005]


def test_optimizers_are_the_textbook_algorithms():
    """Kingma & Ba 2015 and Sutskever et al. 2013, written out as sums over all gradients so far."""
    adam, heavy = Adam(2), Momentum(2, momentum=0.8)
    for t, (gradient, rate) in enumerate(zip(GRADIENTS, RATES, strict=True), start=1):
        past = GRADIENTS[:t][::-1].T.astype(np.float64)
        m, v = past @ (0.1 * 0.9 ** np.arange(t)), past**2 @ (0.001 * 0.999 ** np.arange(t))
        expected = rate * (m / (1 - 0.9**t)) / (np.sqrt(v / (1 - 0.999**t)) + 1e-8)
        assert adam.step(gradient, rate) == pytest.approx(expected, rel=1e-4)
        expected = past @ (RATES[:t][::-1] * 0.8 ** np.arange(t))
        assert heavy.step(gradient, rate) == pytest.approx(expected, rel=1e-5)


def test_evolution_strategy_samples_mirrored_pairs_on_shared_matches():
    learner = teach(strategy(), 3)
    candidates = learner.ask(generator(3))
    assert candidates.shape == (16, SIZE)
    assert candidates.dtype == np.float32
    assert np.allclose((candidates[:8] + candidates[8:]) / 2, learner.genome, atol=1e-6)  # mirrored
    assert np.std(candidates - learner.genome) == pytest.approx(0.05, rel=0.2)
    assert learner.seed_groups.tolist() == [*range(8), *range(8)]


def gradient_of(learner, epoch):
    """Teach an epoch, and return the gradient that Salimans et al. 2017 define for it."""
    candidates = learner.ask(generator(epoch))
    fitness, noise = closeness(candidates), (candidates - learner.genome) / 0.05
    ranks = np.argsort(np.argsort(fitness)) / 15 - 0.5
    learner.tell(fitness)
    return (ranks[:, None] * noise).sum(axis=0) / (16 * 0.05)


def test_evolution_strategies_follow_the_published_update():
    learner = strategy()
    first = gradient_of(learner, 0)
    assert np.allclose(learner.genome, 0.05 * np.sign(first), atol=1e-4)  # Adam's first step
    learner = momentum(momentum=0.5)  # not the default, so that it is seen to count
    first, second = gradient_of(learner, 0), gradient_of(learner, 1)
    expected = 0.01 * first + (0.01 * second + 0.5 * 0.01 * first)
    assert np.allclose(learner.genome, expected, atol=1e-5)


def test_samples_spread_with_the_genome_and_the_update_stays_that_of_the_ranks():
    learner = strategy(relative_sigma=0.5)
    assert (learner.ask(generator()) == strategy().ask(generator())).all()  # the genome is zero
    learner.genome = np.linspace(1, 2, SIZE, dtype=np.float32)
    sigma = 0.5 * math.sqrt((np.linspace(1, 2, SIZE) ** 2).mean())
    before, candidates = learner.genome, learner.ask(generator(1))
    noise = np.stack(noise_table().draw(8, generator(1))) / 0.05
    assert np.allclose(candidates - before, sigma * np.concatenate([noise, -noise]), atol=1e-5)
    fitness = closeness(candidates)
    learner.tell(fitness)
    ranks = np.argsort(np.argsort(fitness)) / 15 - 0.5
    step = 0.05 * np.sign((ranks[:, None] * np.concatenate([noise, -noise])).sum(axis=0))
    assert np.allclose(learner.genome - before, step, atol=1e-3)


@pytest.mark.parametrize("make", [strategy, momentum])
def test_annealed_strategies_find_the_target_and_their_rate_falls_to_a_tenth(make):
    learner = make(anneal_over=400)
    first = learner.rate
    assert teach(learner, 200).rate == pytest.approx(0.55 * first)
    assert teach(learner, 200, first=200).rate == pytest.approx(0.1 * first)
    assert closeness(learner.genome) > -0.01 > closeness(np.zeros(SIZE))
    assert teach(learner, 1).rate == pytest.approx(0.1 * first)
    assert teach(make(), 3).rate == first


def ellipsoid(size, condition):
    """Minus a rotated ellipsoid around `TARGET`, best at zero."""
    axes, _ = np.linalg.qr(generator(97).standard_normal((size, size)))
    scales = np.logspace(0, math.log10(condition), size)
    return lambda genomes: (
        -(((np.asarray(genomes, dtype=np.float64) - TARGET[:size]) @ axes) ** 2 @ scales)
    )


def test_cma_goes_where_deap_s_own_strategy_goes(monkeypatch):
    """DEAP's strategy, driven as its documentation does, on the same normal numbers."""

    class Individual(list):
        fitness = None

    score = ellipsoid(SIZE, 100.0)  # on a sphere the covariance would stay what it is
    learner, theirs = covariance(), cma.Strategy([0.0] * SIZE, 0.3, lambda_=16)
    for epoch in range(30):
        candidates = learner.ask(generator(epoch))
        # The fitness of both is that of the float32 genomes, which are what is played.
        learner.tell(score(candidates))
        monkeypatch.setattr(np.random, "standard_normal", generator(epoch).standard_normal)
        population = theirs.generate(Individual)
        for individual in population:
            individual.fitness = score(np.array(individual, dtype=np.float32))
        with threadpool_limits(limits=1, user_api="blas"):  # as ours: threads change the last bits
            theirs.update(population)
    state = learner.state()
    for name in ("centroid", "sigma", "C", "pc", "ps"):
        assert np.array_equal(state[name], getattr(theirs, name)), name
    assert np.array_equal(learner.genome, theirs.centroid.astype(np.float32))
    assert state["update_count"] == 30
    assert theirs.sigma != pytest.approx(0.3, rel=0.1)  # it went somewhere at all


def test_cma_does_not_depend_on_the_threads_of_the_linear_algebra():
    """With 330 genes, OpenBLAS with two threads rounds otherwise than with one."""
    ended = []
    for threads in (1, 2):
        with threadpool_limits(threads, "blas"):
            learner = CmaEs(np.zeros(330), sigma=0.3, samples=24)
            for epoch in range(3):
                candidates = learner.ask(generator(epoch))
                learner.tell(-(candidates**2).sum(axis=1))
            ended.append(learner.state())
    assert all(np.array_equal(ended[0][name], ended[1][name]) for name in ended[0])


@pytest.mark.parametrize("make", LEARNERS)
@pytest.mark.parametrize("fitness", [np.zeros(3), np.full(16, np.nan)])
def test_bad_fitness_is_refused(make, fitness):
    learner = make()
    with pytest.raises(RuntimeError, match="ask"):
        learner.tell(fitness)
    learner.ask(generator())
    with pytest.raises(ValueError, match="^fitness: "):
        learner.tell(fitness)


@pytest.mark.parametrize(
    ("call", "field"),
    [
        (lambda: strategy(samples=5), "samples"),
        (lambda: algorithm(elites=40), "population"),
        (lambda: momentum(momentum=1.0), "momentum"),
        (lambda: CmaEs(np.zeros(1001), sigma=0.1), "genome"),
    ],
)
def test_parts_that_do_not_fit_are_refused(call, field):
    with pytest.raises(ValueError, match=f"^{field}: expected"):
        call()


@pytest.mark.parametrize("options", [{}, {"crossover": 0.7}, {"truncation": 0.25, "elites": 0}])
def test_genetic_algorithm_improves(options):
    learner = algorithm(sigma=0.1, **options)
    best_at_first = closeness(learner.ask(generator())).max()
    assert closeness(teach(learner, 150).genome) > best_at_first / 10


def test_selection_prefers_the_fitter():
    fitness = np.arange(10.0)
    chosen = select_tournament(fitness, 20_000, generator(), size=3)
    # Absent from three draws otherwise.
    assert np.mean(chosen == 9) == pytest.approx(1 - 0.9**3, abs=0.02)
    at_random = select_tournament(fitness, 20_000, generator(), size=1)
    assert np.bincount(at_random).min() > 1700  # of 2000 expected, with a deviation of 42
    survivors = select_truncation(np.array([3.0, 9.0, 1.0, 8.0]), 500, generator(), fraction=0.5)
    assert set(survivors) == {1, 3}


def test_mating_mixes_the_given_share():
    # All genes of a first parent are 0, and those of a second one its number from 1.
    children = np.zeros((2000, 10), np.float32)
    population = np.repeat(np.arange(1.0, 6.0, dtype=np.float32)[:, None], 10, axis=1)
    before, mates = population.copy(), generator(1).integers(0, 5, size=2000)
    assert mate_uniform(children, population, mates, generator(), probability=0.25) is children
    assert (population == before).all()
    mixed = children.any(axis=1)
    assert mixed.mean() == pytest.approx(0.25, abs=0.04)  # 4 standard deviations of 2000 children
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
    # All offspring become 0, so what is left is elite.
    learner.toolbox.register("mutate", lambda genomes, rng: genomes * np.float32(0))
    first = learner.ask(generator())
    fitness = first.sum(axis=1)
    learner.tell(fitness)
    elite = first[np.argsort(-fitness)[:3]]
    assert np.array_equal(learner.genome, elite[0])
    assert np.array_equal(learner.ask(generator(1)), [*elite, *np.zeros((5, 5))])


INDIVIDUALS, ELITES = 40, 10


def scored(rng):
    """Return a learner after an epoch of random fitness, and that fitness."""
    learner = learner_of(rng.normal(size=(INDIVIDUALS, 1)), ELITES)
    learner.ask(rng)
    fitness = rng.normal(size=INDIVIDUALS)
    learner.tell(fitness)
    return learner, fitness


def test_crowning_changes_the_champion_and_no_offspring():
    children = []
    for crowned in (False, True):
        learner, fitness = scored(np.random.default_rng(2))
        fittest = learner.genome
        assert learner.elite.tolist() == np.argsort(-fitness)[:ELITES].tolist()
        if crowned:
            learner.choose_champion(np.arange(ELITES))
            assert learner.genome == learner.elite_genomes()[-1] != fittest
            restored, _ = scored(np.random.default_rng(3))
            restored.restore(learner.state())
            assert restored.genome == learner.genome
        children.append(learner.ask(np.random.default_rng(4)))
        learner.tell(np.arange(INDIVIDUALS))
        # The next epoch has its own champion.
        assert learner.genome == children[-1][-1]
    assert np.array_equal(*children)


@pytest.mark.parametrize(("sigma", "advice"), [(1e-160, "larger"), (1e300, "smaller")])
def test_cma_names_the_direction_of_a_better_sigma(sigma: float, advice: str) -> None:
    learner = CmaEs(np.zeros(5), sigma=sigma, samples=8)

    def learn() -> None:
        for epoch in range(300):
            learner.ask(np.random.default_rng(epoch))
            learner.tell(np.arange(8.0))

    with pytest.raises(DivergedError, match=f"{advice} sigma"):
        learn()
