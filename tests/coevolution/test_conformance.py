"""Checks of learners and samplers of one's own: what passes, and what is found."""

from __future__ import annotations

import numpy as np
import pytest

from matrixworld.coevolution import (
    CmaEs,
    EvolutionStrategy,
    GeneticAlgorithm,
    NoiseTable,
    PluginError,
    check_learner,
    check_sampler,
    opponents,
)
from own_code import Crash, Fails, Fixed, Hardest, HillClimber, ReturnsViews


def strategy(genome, samples, rng, epochs, *, momentum=None):
    noise = NoiseTable(genome.size, rng, sigma=0.1)
    return EvolutionStrategy(genome, noise, samples=samples, anneal_over=epochs, momentum=momentum)


def algorithm(genomes, rng, *, elites=2, mutation=0.05):
    noise = NoiseTable(genomes.shape[1], rng, sigma=mutation)
    return GeneticAlgorithm(genomes, noise, elites=elites)


def climber(base=HillClimber, **methods):
    return type("Changed", (base,), methods)


def tell_in_place(self, fitness):
    self.genome[:] = self.candidates[int(np.argmax(fitness))]


@pytest.mark.parametrize(
    ("learner", "settings"),
    [
        (HillClimber, {}),
        ("own_code:HillClimber", {"sigma": 0.3, "shrink": 0.5}),
        (climber(tell=tell_in_place), {}),
        (ReturnsViews, {}),
        (CmaEs, {"sigma": 0.1}),
        (strategy, {}),
        (strategy, {"momentum": 0.9}),
        (lambda genome, samples, **own: HillClimber(genome, samples, **own), {"sigma": 1}),
        (algorithm, {"elites": 1}),
    ],
)
def test_a_learner_that_keeps_all_promises(learner, settings):
    check_learner(learner, settings)


@pytest.mark.parametrize(
    ("sampler", "settings"),
    [
        (Hardest, {"forget": 0.2}),
        ("own_code:Fixed", {}),
        (opponents.Latest, {}),
        (opponents.Uniform, {}),
        (opponents.RoundRobin, {}),
        (opponents.SharedSampling, {}),
        (opponents.Prioritized, {"decay": 0.9}),
        (lambda count: opponents.ArchiveSampler(opponents.IPCA(), count), {}),
    ],
)
@pytest.mark.parametrize("count", [1, 3])
def test_a_sampler_that_keeps_all_promises(sampler, settings, count):
    check_sampler(sampler, settings, count=count)


def asks(change):
    return climber(ask=lambda self, rng: change(HillClimber.ask(self, rng)))


def states(change):
    return climber(state=lambda self: HillClimber.state(self) | change(self))


def tell_and_regroup(self, fitness):
    HillClimber.tell(self, fitness)
    self.seed_groups = np.arange(len(fitness))


def begin_unevenly(self, genome, samples):
    HillClimber.__init__(self, genome, samples)
    self.seed_groups[0] = 1


class NoTell:
    genome, seed_groups = np.zeros(20, np.float32), np.zeros(8, np.intp)
    ask = HillClimber.ask


OTHER_NOISE = climber(ask=lambda self, rng: HillClimber.ask(self, np.random.default_rng()))
FORGETS_SIGMA = climber(
    state=lambda self: {"genome": self.genome},
    restore=lambda self, state: setattr(self, "genome", state["genome"]),
)
# It continues equally, but its state is that of before.
RESTORES_HALF = climber(ReturnsViews, restore=HillClimber.restore)


@pytest.mark.parametrize(
    ("learner", "message"),
    [
        (OTHER_NOISE, "expected equal results from equal generators and results"),
        (FORGETS_SIGMA, "expected equal results after restore in a (new|used) one"),
        (RESTORES_HALF, "state: expected an equal one after restore in a used one"),
        (asks(lambda asked: asked.astype(float)), r"ask: .*, got float64 \(8, 20\)"),
        (asks(lambda asked: asked.repeat(2, axis=0)), r"ask: .*, got float32 \(16, 20\)"),
        (asks(lambda asked: asked + np.float32(np.inf)), "ask: expected finite numbers"),
        (states(lambda self: {"self": np.array([self])}), "state: expected an array of numbers"),
        (states(lambda self: {"a.mean": np.zeros(1)}), "state: expected names such as sigma"),
        (climber(tell=tell_and_regroup), "seed_groups: expected equal groups in all epochs"),
        (climber(__init__=begin_unevenly), "seed_groups: expected 8 numbers of groups from 0"),
        (NoTell, "expected genome, seed_groups, ask, .*, got no tell"),
        (Fails, "tell: ZeroDivisionError: no luck"),
    ],
)
def test_a_broken_promise_of_a_learner_is_named(learner, message):
    with pytest.raises(PluginError, match=rf"^learner [\w.]+:{learner.__name__}: {message}"):
        check_learner(learner)


def samples(*chosen):
    return type("Chosen", (Fixed,), {"sample": lambda *_: np.array(chosen, np.intp)})


UNSAVED = type("Unsaved", (Hardest,), {"state": lambda _: {}, "restore": lambda *_: None})


@pytest.mark.parametrize(
    ("sampler", "message"),
    [
        (samples(1), r"sample: expected 1 to 1 different opponents from 0 to 0, got \[1\]"),
        (samples(0, 0), r"sample: expected 1 to 1 different opponents from 0 to 0, got \[0, 0\]"),
        (samples(), r"sample: expected .* got \[\]"),
        (UNSAVED, "expected equal results after restore in a (new|used) one"),
        (Crash, "sample: KeyError: 'generation'"),
    ],
)
def test_a_broken_promise_of_a_sampler_is_named(sampler, message):
    with pytest.raises(PluginError, match=f":{sampler.__name__}: {message}"):
        check_sampler(sampler)


@pytest.mark.parametrize(
    ("learner", "settings", "message"),
    [
        (
            HillClimber,
            {"sgima": 0.1},
            r"expected its settings \(sigma, shrink\), got {'sgima': 0.1}",
        ),
        (HillClimber, {"samples": 9}, "expected its settings .* 'samples'"),
        (HillClimber, {"sigma": -1}, "expected settings that it accepts, got"),
        (CmaEs, {}, r"expected its settings \(sigma\), got {} \(missing .* 'sigma'\)"),
    ],
)
def test_settings_are_those_of_the_signature(learner, settings, message):
    with pytest.raises(ValueError, match=f":{learner.__name__}: {message}"):
        check_learner(learner, settings)


def test_nothing_is_drawn_from_the_global_generator():
    before = np.random.get_state()[1].copy()  # noqa: NPY002
    check_learner(HillClimber)
    check_sampler(Hardest)
    assert np.array_equal(np.random.get_state()[1], before)  # noqa: NPY002
