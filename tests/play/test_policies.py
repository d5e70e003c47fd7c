"""Genomes as policies: actions, probabilities, states."""

import numpy as np
import pytest

import matrixworld as mw

# About as many cells are taken as in play.
VIEWS = (np.random.default_rng(5).random((200, 3, 5, 5)) < 0.3).astype(np.uint8)


def policy_of(**fields):
    network = mw.Network(**({"hidden": (16, 8), "fov": 5} | fields))
    genome = network.initial(np.random.default_rng(1), 0.5, 2.0)
    # A new genome has none, and would hide them.
    biases = np.random.default_rng(2).normal(0, 0.5, genome.shape).astype(np.float32)
    return mw.NetworkPolicy(network, genome + 0.1 * biases, seed=3)


def test_probabilities_are_those_of_the_engine():
    policy = policy_of(activation="tanh")
    world = mw.World("O", rows=9, cols=9, n_pursuers=6, n_evaders=6, fov=5)
    engine = world._core.logits(policy.policy.core, policy.genome)
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


def test_observations_come_single_or_in_batches_flat_or_not_in_any_dtype():
    policy = policy_of(sampled=False)
    actions = policy(VIEWS)
    assert np.array_equal(actions, policy.probabilities(VIEWS).argmax(axis=1))
    one = policy(VIEWS[0])
    assert type(one) is int
    assert one == actions[0]
    assert policy.probabilities(VIEWS[0]).shape == (5,)
    for same in (VIEWS.astype("f4"), VIEWS.astype(bool), VIEWS.reshape(200, 75).astype(float)):
        assert np.array_equal(policy(same), actions)
    assert np.array_equal(policy(VIEWS.reshape(10, 20, 3, 5, 5)), actions.reshape(10, 20))
    assert policy.logits(VIEWS.reshape(10, 20, 75)).shape == (10, 20, 5)
    assert policy(VIEWS[:0]).shape == (0,)


# What agents remember when they see these.
STATES = np.random.default_rng(6).uniform(-1, 1, (200, 16)).astype(np.float32)


def test_a_policy_with_memory_takes_states_and_returns_the_next():
    policy, same = (policy_of(memory="gru", sampled=False) for _ in range(2))
    actions, following = policy(VIEWS, STATES)
    logits, expected = policy.policy.advance(policy.genome, VIEWS, STATES)
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


# Ratings:


def rating_of(**fields):
    rating = mw.Rating(**({"fov": 7} | fields))
    return mw.RatingPolicy(rating, rating.initial(np.random.default_rng(1)), seed=3)


@pytest.mark.parametrize("mask", ["none", "obstacles", "right-of-way"])
def test_a_rating_policy_chooses_as_the_engine(mask):
    """In each moment of an episode; where moves are equally good, any of them."""
    size = {"rows": 9, "cols": 9, "n_pursuers": 6, "n_evaders": 6, "fov": 7}
    config = mw.WorldConfig("SB", **size, obstacles=0.2, diagonal=True)
    policy = rating_of(mask=mask, n_actions=9, hidden=(3,))
    world, team, single = mw.World(config), range(6), 0
    actions = np.zeros(12, np.int64)
    for _ in range(30):
        inputs = world.inputs()[team]
        world.decide(policy, team, actions)
        world.decide("random", range(6, 12), actions)
        ratings = np.where(policy.allowed(inputs), policy.rate(inputs), -np.inf)
        best = ratings == ratings.max(axis=1, keepdims=True)
        assert best[team, actions[team]].all()
        assert best[team, policy(inputs)].all()
        single += int((best.sum(axis=1) == 1).sum())
        world.step(actions)
    assert single > 100


def test_equal_moves_are_taken_equally_often():
    policy = mw.RatingPolicy(mw.Rating(("ahead",)), np.float32([0]), seed=0)
    world = mw.World("O", rows=9, cols=9, n_pursuers=1, n_evaders=1)
    world.reset(0, pursuers=[(4, 4)])
    inputs = world.inputs()[0]
    inputs[1, list(mw.INPUTS).index("room")] = 0  # as if there were an obstacle
    assert type(policy(inputs)) is int
    shares = np.bincount(policy(np.stack([inputs] * 9000))) / 9000
    np.testing.assert_allclose(shares, [0.25, 0, 0.25, 0.25, 0.25], atol=0.02)


def test_a_rating_policy_plays_as_its_population():
    config = mw.WorldConfig("O", rows=9, cols=9, n_pursuers=3, n_evaders=3, max_steps=15, fov=7)
    policy = rating_of()
    team = policy.population()
    matches = mw.Matches.of(0, 0, range(4))
    rates = mw.rollout(config, policy, "fleer", matches).capture_rate
    assert np.array_equal(rates, mw.rollout(config, team, "fleer", matches).capture_rate)
    played = mw.score_policy(policy, "pursuer", config, episodes=4).rates
    assert np.array_equal(played, mw.score_policy(team, "pursuer", config, episodes=4).rates)
    one, same = (mw.record(config, "chaser", each, seed=3).actions for each in (policy, team))
    assert np.array_equal(one, same)
