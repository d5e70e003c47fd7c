"""Genomes as policies: actions, probabilities, states."""

from typing import Any

import numpy as np
import pytest

import matrixworld as mw

# About as many cells are taken as in play.
VIEWS = (np.random.default_rng(5).random((200, 3, 5, 5)) < 0.3).astype(np.uint8)


def policy_of(**fields: Any) -> mw.NetworkPolicy:
    network = mw.Network(**({"hidden": (16, 8), "fov": 5} | fields))
    genome = network.initial(np.random.default_rng(1), 0.5, 2.0)
    # A new genome has none, and would hide them.
    biases = np.random.default_rng(2).normal(0, 0.5, genome.shape).astype(np.float32)
    return mw.NetworkPolicy(network, genome + 0.1 * biases, seed=3)


def test_probabilities_are_those_of_the_engine() -> None:
    policy = policy_of(activation="tanh")
    world = mw.World("O", rows=9, cols=9, n_pursuers=6, n_evaders=6, fov=5)
    engine = world._core.logits(policy.network.core, policy.genome)
    expected = np.exp(engine) / np.exp(engine).sum(axis=1, keepdims=True)
    assert np.allclose(policy.probabilities(world.views()), expected, atol=1e-6)
    assert np.allclose(policy.logits(world.views()), engine, atol=1e-5)
    # Actions are drawn from them, with a seed.
    seen = np.repeat(VIEWS[:1], 20_000, axis=0)
    actions = policy(seen)
    assert np.array_equal(actions, policy_of(activation="tanh")(seen))
    shares = np.bincount(actions, minlength=5) / len(actions)
    # 4 deviations of 20,000 draws.
    assert np.allclose(shares, policy.probabilities(VIEWS[0]), atol=0.015)


def test_observations_come_single_or_in_batches_flat_or_not_in_any_dtype() -> None:
    policy = policy_of(sampled=False)
    actions = policy(VIEWS)
    assert np.array_equal(actions, policy.probabilities(VIEWS).argmax(axis=1))
    one = policy(VIEWS[0])
    assert type(one) is int
    assert one == actions[0]
    assert policy.probabilities(VIEWS[0]).shape == (5,)
    for same in (
        VIEWS.astype(np.float32),
        VIEWS.astype(bool),
        VIEWS.reshape(200, 75).astype(float),
    ):
        assert np.array_equal(policy(same), actions)
    assert np.array_equal(policy(VIEWS.reshape(10, 20, 3, 5, 5)), actions.reshape(10, 20))
    assert policy.logits(VIEWS.reshape(10, 20, 75)).shape == (10, 20, 5)
    assert policy(VIEWS[:0]).shape == (0,)


# What agents remember when they see these.
STATES = np.random.default_rng(6).uniform(-1, 1, (200, 16)).astype(np.float32)


def test_a_policy_with_memory_takes_states_and_returns_the_next() -> None:
    policy, same = (policy_of(memory="gru", sampled=False) for _ in range(2))
    actions, following = policy(VIEWS, STATES)
    logits, expected = policy.network.advance(policy.genome, VIEWS, STATES)
    assert np.array_equal(actions, logits.argmax(axis=1))
    assert np.array_equal(following, expected)
    assert following.shape == STATES.shape
    assert np.array_equal(policy.logits(VIEWS, STATES), logits)
    # It keeps nothing, and agents begin with zeros; one by one as all together.
    zeros = np.zeros_like(STATES)
    assert np.array_equal(policy(VIEWS)[1], same(VIEWS, zeros)[1])
    action, state = policy(VIEWS[7], STATES[7])
    assert action == actions[7]
    assert np.allclose(state, following[7], atol=1e-6)
    for states in (STATES[:1], STATES[:, :4], 0.5):
        with pytest.raises(ValueError, match=r"states: expected shape \(200, 16\), got shape"):
            policy(VIEWS, states)
    with pytest.raises(ValueError, match="states: expected none without memory"):
        policy_of()(VIEWS, STATES)
