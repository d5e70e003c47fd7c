"""Learners and their parts, on functions of known optimum."""

from dataclasses import replace

import numpy as np
import pytest
from deap import cma
from threadpoolctl import threadpool_limits

from matrixworld.coevolution import CmaEs, EvolutionStrategy, GeneticAlgorithm, Results, Task
from matrixworld.coevolution.games.game import Game
from matrixworld.coevolution.learners.evolution_strategy import centred_ranks
from matrixworld.coevolution.learners.genetic_algorithm import mate_uniform, select_truncation
from matrixworld.coevolution.learners.optimizers import Adam, Momentum
from matrixworld.coevolution.learners.selection import select_tournament
from matrixworld.coevolution.states import flat

SIZE = 20
TARGET = np.linspace(-1.0, 1.0, SIZE)


def closeness(genomes):
    return sphere(np.asarray(genomes, dtype=np.float64) - TARGET)


def sphere(genomes):
    return -(genomes**2).sum(axis=-1)


def generator(epoch=0):
    return np.random.Generator(np.random.SFC64([7, epoch]))


def task(genes=SIZE, epochs=100, begin=None):
    """A task whose genomes are zeros, or normal numbers."""
    begin = np.zeros(genes, np.float32) if begin is None else begin

    def untrained(rng):
        return begin if begin.ndim == 1 else rng.standard_normal(genes, np.float32)

    return Task(
        99, 0, epochs, untrained, None, Game(lambda a, b, rng: a[:, 0], genes, ("ones", "others"))
    )


RANDOM = np.zeros((1, 1))
"""As `begin`: a population of normal numbers."""
ES = EvolutionStrategy(
    population=16, sigma=0.05, learning_rate=0.05, relative_sigma=0.0, anneal=False
)
MOMENTUM = replace(ES, momentum=0.9, learning_rate=0.01)
GA = GeneticAlgorithm(population=40, mutation=0.05)
CMA = CmaEs(population=16, sigma=0.3)
LEARNERS = [ES, MOMENTUM, GA, CMA]


def begun(learner, **options):
    """Return the state of a learner before its first epoch."""
    if isinstance(learner, GeneticAlgorithm):
        options.setdefault("begin", RANDOM)
    return learner.start(task(**options))


def teach(learner, state, epochs, score=closeness):
    for epoch in range(epochs):
        candidates, asked = learner.ask(state, generator(epoch))
        state = learner.tell(asked, Results(score(candidates)))
    return state


def gradient_of(learner, state, epoch):
    """Teach an epoch; return the gradient that Salimans et al. 2017 define, and the state."""
    candidates, asked = learner.ask(state, generator(epoch))
    fitness, noise = closeness(candidates), (candidates - learner.genome(state)) / 0.05
    gradient = centred_ranks(fitness) @ noise / (16 * 0.05)
    return gradient, learner.tell(asked, Results(fitness))


def test_evolution_strategies_follow_the_published_update():
    first, state = gradient_of(ES, begun(ES), 0)
    assert np.allclose(ES.genome(state), 0.05 * np.sign(first), atol=1e-4)  # Adam's first step
    learner = replace(MOMENTUM, momentum=0.5)  # not the usual one, so that it is seen to count
    first, state = gradient_of(learner, begun(learner), 0)
    second, state = gradient_of(learner, state, 1)
    expected = 0.01 * first + (0.01 * second + 0.5 * 0.01 * first)
    assert np.allclose(learner.genome(state), expected, atol=1e-5)


@pytest.mark.parametrize("learner", [ES, MOMENTUM])
def test_annealed_strategies_find_the_target_and_steps_fall_to_a_tenth(learner):
    annealing = replace(learner, anneal=True)
    state = teach(annealing, begun(annealing, epochs=400), 400)
    assert closeness(annealing.genome(state)) > -0.01 > closeness(np.zeros(SIZE))
    optimizer = (Adam if learner.momentum is None else Momentum).start(SIZE)
    for updates, share in ((0, 1.0), (200, 0.55), (400, 0.1), (900, 0.1)):
        begin = state._replace(optimizer=optimizer._replace(updates=np.array(updates)))
        steps = [
            np.abs(each.genome(teach(each, at, 1)) - each.genome(at)).mean()
            for each, at in ((annealing, begin), (learner, begin._replace(epochs=None)))
        ]
        assert steps[0] == pytest.approx(share * steps[1], rel=1e-2)


def test_cma_goes_where_deap_s_own_strategy_goes(monkeypatch):
    """DEAP's strategy, driven as its documentation does, on the same normal numbers."""

    class Individual(list):
        fitness = None

    # An ellipsoid: on a sphere the covariance would stay what it is.
    axes, _ = np.linalg.qr(generator(97).standard_normal((SIZE, SIZE)))
    scales = np.logspace(0, 2, SIZE)

    def score(genomes):
        return -(((np.asarray(genomes, dtype=np.float64) - TARGET) @ axes) ** 2 @ scales)

    state, theirs = begun(CMA), cma.Strategy([0.0] * SIZE, 0.3, lambda_=16)
    for epoch in range(30):
        candidates, asked = CMA.ask(state, generator(epoch))
        # The fitness of both is that of the float32 genomes, which are what is played.
        state = CMA.tell(asked, Results(score(candidates)))
        monkeypatch.setattr(np.random, "standard_normal", generator(epoch).standard_normal)
        population = theirs.generate(Individual)
        for individual in population:
            individual.fitness = score(np.array(individual, dtype=np.float32))
        with threadpool_limits(limits=1, user_api="blas"):  # as ours: threads change the last bits
            theirs.update(population)
    for name in ("centroid", "sigma", "C", "pc", "ps"):
        assert np.array_equal(getattr(state, name), getattr(theirs, name)), name
    assert np.array_equal(CMA.genome(state), theirs.centroid.astype(np.float32))
    assert state.update_count == 30
    assert theirs.sigma != pytest.approx(0.3, rel=0.1)  # it went somewhere at all


def test_cma_does_not_depend_on_the_threads_of_the_linear_algebra():
    """With 330 genes, OpenBLAS with two threads rounds otherwise than with one."""
    ended, learner = [], replace(CMA, population=24)
    for threads in (1, 2):
        with threadpool_limits(threads, "blas"):
            ended.append(teach(learner, begun(learner, genes=330), 3, score=sphere))
    one, two = map(flat, ended)
    assert all(np.array_equal(one[name], two[name]) for name in one)


@pytest.mark.parametrize("learner", LEARNERS)
@pytest.mark.parametrize("fitness", [np.zeros(3), np.full(16, np.nan), np.full(40, np.nan)])
def test_bad_fitness_is_refused(learner, fitness):
    _, asked = learner.ask(begun(learner), generator())
    with pytest.raises(ValueError, match="^fitness: "):
        learner.tell(asked, Results(fitness))


@pytest.mark.parametrize("learner", LEARNERS)
def test_fitness_without_candidates_is_refused(learner):
    with pytest.raises(RuntimeError, match="^tell: expected a state of `ask`"):
        learner.tell(begun(learner), Results(np.zeros(learner.population)))


def test_cma_that_cannot_go_on_has_a_genome_of_nan_which_a_run_reports():
    state = begun(CMA)._replace(C=np.full((SIZE, SIZE), np.inf))
    _, asked = CMA.ask(state, generator())
    assert np.isnan(CMA.genome(CMA.tell(asked, Results(np.arange(16.0))))).all()


@pytest.mark.parametrize("options", [{}, {"crossover": 0.7}, {"truncation": 0.25, "elites": 0}])
def test_genetic_algorithm_improves(options):
    learner = replace(GA, mutation=0.1, **options)
    state = begun(learner)
    best_at_first = closeness(learner.ask(state, generator())[0]).max()
    assert closeness(learner.genome(teach(learner, state, 150))) > best_at_first / 10


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


class Zeros(GeneticAlgorithm):
    """All offspring become 0, so that what is left is elite."""

    @property
    def toolbox(self):
        toolbox = super().toolbox
        toolbox.register("mutate", lambda genomes, rng, noise: genomes * np.float32(0))
        return toolbox


def test_elites_are_kept_and_an_operator_may_return_a_new_array():
    learner = Zeros(population=8, elites=3, mutation=0.05)
    first, asked = learner.ask(begun(learner), generator())
    fitness = first.sum(axis=1)
    state = learner.tell(asked, Results(fitness))
    elite = first[np.argsort(-fitness)[:3]]
    assert np.array_equal(learner.genome(state), elite[0])
    assert np.array_equal(learner.ask(state, generator(1))[0], [*elite, *np.zeros((5, SIZE))])
