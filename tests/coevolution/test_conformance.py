"""Checks of learners and samplers of one's own: what passes, and what is found."""

from __future__ import annotations

import numpy as np
import pytest

import own_code
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


def strategy(genome, samples, rng, epochs):
    noise = NoiseTable(genome.size, rng, sigma=0.1)
    return EvolutionStrategy(genome, noise, samples=samples, anneal_over=epochs)


def algorithm(genomes, rng, *, elites=2, mutation=0.05):
    noise = NoiseTable(genomes.shape[1], rng, sigma=mutation)
    return GeneticAlgorithm(genomes, noise, elites=elites)


@pytest.mark.parametrize(
    ("learner", "settings"),
    [
        (own_code.HillClimber, {}),
        ("own_code:HillClimber", {"sigma": 0.3, "shrink": 0.5}),
        (own_code.InPlace, {}),
        (own_code.ReturnsViews, {}),
        (CmaEs, {"sigma": 0.1}),
        (strategy, {}),
        (algorithm, {"elites": 1}),
    ],
)
def test_a_learner_that_keeps_all_promises(learner, settings):
    check_learner(learner, settings)


@pytest.mark.parametrize(
    ("sampler", "settings"),
    [
        (own_code.Hardest, {"forget": 0.2}),
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


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("GlobalNoise", "expected equal results from equal generators and results, got others i"),
        ("ForgetsSigma", "expected equal results after restore in a (new|used) one, got others i"),
        ("Float64", r"ask: expected an array of float32 \(8, 20\), got float64 \(8, 20\)"),
        ("TooMany", r"ask: expected an array of float32 \(8, 20\), got float32 \(16, 20\)"),
        ("Infinite", "ask: expected finite numbers, got NaN or infinity"),
        ("Pickles", "state: expected an array of numbers or text as self, got array"),
        ("Dotted", "state: expected names such as sigma, got 'adam.mean'"),
        ("RestoresHalf", "state: expected an equal one after restore in a used one, got another"),
        ("Regroups", "seed_groups: expected equal groups in all epochs, got others after"),
        ("Uneven", r"seed_groups: expected 8 numbers of groups from 0, all of one size, go"),
        ("NoTell", "expected genome, seed_groups, ask, tell, state, restore, got no tell"),
        ("Fails", "tell: ZeroDivisionError: no luck"),
    ],
)
def test_a_broken_promise_of_a_learner_is_named(name, message):
    with pytest.raises(PluginError, match=f"^learner own_code:{name}: ({message})"):
        check_learner(getattr(own_code, name))


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("Beyond", r"sample: expected 1 to 1 different opponents from 0 to 0, got \[1\]"),
        ("Twice", r"sample: expected 1 to 1 different opponents from 0 to 0, got \[0, 0\]"),
        ("Nothing", r"sample: expected .* got \[\]"),
        ("Unsaved", "expected equal results after restore in a (new|used) one"),
        ("Crash", "sample: KeyError: 'generation'"),
    ],
)
def test_a_broken_promise_of_a_sampler_is_named(name, message):
    with pytest.raises(PluginError, match=f"own_code:{name}: {message}"):
        check_sampler(getattr(own_code, name))


def test_settings_are_those_of_the_signature():
    with pytest.raises(ValueError, match=r"HillClimber: expected its settings \(sigma, shrink\)"):
        check_learner(own_code.HillClimber, {"sgima": 0.1})
    with pytest.raises(ValueError, match="got 'samples'"):
        check_learner(own_code.HillClimber, {"samples": 9})
    with pytest.raises(
        ValueError, match="expected a value of the setting sigma, which has no default"
    ):
        check_learner(CmaEs)
    with pytest.raises(ValueError, match=r"HillClimber: expected settings that it accepts, got"):
        check_learner(own_code.HillClimber, {"sigma": -1})
    check_learner(lambda genome, samples, **more: own_code.HillClimber(genome, samples, **more),
                  {"sigma": 0.2})  # fmt: skip


def test_the_cause_is_kept():
    with pytest.raises(PluginError) as caught:
        check_learner(own_code.Fails)
    cause = caught.value.__cause__
    assert isinstance(cause, ZeroDivisionError)
    assert cause.__traceback__ is not None


def test_nothing_is_drawn_from_the_global_generator():
    before = np.random.get_state()[1].copy()  # noqa: NPY002
    check_learner(own_code.HillClimber)
    check_sampler(own_code.Hardest)
    assert np.array_equal(np.random.get_state()[1], before)  # noqa: NPY002
