"""The actor-critic learner: advantages, gradients, state, what it learns, and its runs."""

from dataclasses import replace
from functools import partial

import numpy as np
import pytest

from matrixworld.coevolution import Cells, Pursuit, Results, create, open_run
from matrixworld.coevolution.learners import actor_critic
from matrixworld.coevolution.learners.actor_critic import ActorCritic, Update, advantages
from matrixworld.coevolution.learners.learner import Task
from matrixworld.coevolution.states import flat
from matrixworld.play.experience import experience
from matrixworld.play.rollout import Matches, rollout
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import Network, Population
from tiny_race import check_resumes, tiny_race, tiny_single

NETWORK = Network((6,), fov=5)
CONFIG = WorldConfig("D", rows=7, cols=7, n_pursuers=3, n_evaders=4, fov=5, max_steps=12)


def rng():
    return np.random.default_rng(0)


def new(network=NETWORK, epochs=1, **changes):
    pytest.importorskip("torch")
    one = ActorCritic(population=4, **changes)
    shape = {"hidden": network.hidden, "activation": network.activation, "initial_head": 1.0}
    game = Pursuit(world=CONFIG, settings=Cells(**shape))
    untrained = partial(one.untrained, game, "pursuer")
    return Update(one, one.start(Task(0, 0, epochs, untrained, None, game)))


def genome(update):
    return update.state().actor.weights


def seen_by(update, *, seed=0, matches=4, config=CONFIG):
    seeds = np.arange(seed, seed + matches, dtype=np.uint64)
    own, chosen = Population(genome(update)[None], NETWORK), np.zeros(matches, int)
    return experience(config, "pursuer", own, "random", chosen, seeds, threads=1)


def slow_advantages(acted, rewards, values, discount, trace):
    """Sum the series of Schulman et al. 2016, equation 16, for each agent and step."""
    found = np.zeros(acted.shape)
    for w, a in np.ndindex(acted.shape[1:]):
        n = int(acted[:, w, a].sum())
        for t in range(n):
            for k in range(t, n):
                delta = rewards[k, w, a] + discount * values[k + 1, w, a] - values[k, w, a]
                found[t, w, a] += (discount * trace) ** (k - t) * delta
    return found


def test_advantages_are_the_sums_of_their_definition():
    trace = 0.97
    draw = rng()
    steps, worlds, agents = 9, 3, 4
    lengths = draw.integers(0, steps + 1, (worlds, agents))
    # Agents that leave before the end, as after captures.
    acted = np.arange(steps)[:, None, None] < lengths
    rewards = np.where(acted, draw.normal(size=acted.shape), 0).astype(np.float32)
    values = np.zeros((steps + 1, worlds, agents), np.float32)
    values[:-1][acted] = draw.normal(size=acted.sum())
    values[steps][lengths == steps] = 0.7  # their time was over
    found = advantages(acted, rewards, values, 0.9, trace)
    expected = slow_advantages(acted, rewards, values, 0.9, trace)
    np.testing.assert_allclose(found, expected, rtol=1e-5, atol=1e-6)
    assert not found[~acted].any()


SMOOTH = replace(NETWORK, activation="tanh")  # the corners of ReLU have no derivative


def slow_outputs(weights, n_out, views):
    """Return the outputs of a network with six hidden units of tanh, in float64."""
    hidden, head = np.split(weights.astype(np.float64), [-7 * n_out])
    first, last = hidden.reshape(-1, 6), head.reshape(7, n_out)
    return np.tanh(views @ first[:-1] + first[-1]) @ last[:-1] + last[-1]


def check_gradient(gradient, value, weights):
    """Compare the gradient of a value with finite differences, at some weights and at the last."""
    # Each needs two passes, so not all; the last is a bias.
    places = np.append(rng().choice(len(weights), 20, replace=False), len(weights) - 1)
    expected = []
    for place in places:
        step = np.where(np.arange(len(weights)) == place, 1e-3, 0.0)
        expected.append((value(weights + step) - value(weights - step)) / 2e-3)
    np.testing.assert_allclose(gradient[places], expected, rtol=2e-3, atol=2e-6)


@pytest.mark.parametrize(("clip", "entropy"), [(0.0, 0.1), (0.2, 0.05)])
def test_the_actor_s_gradient_is_that_of_finite_differences(clip, entropy):
    one = new(SMOOTH, clip=clip, entropy=entropy)
    weights_before, draw, seen = genome(one), rng(), seen_by(one)
    weight = draw.normal(size=len(seen)).astype(np.float32)
    given = []  # instead of a step of Adam, which would hide the gradient
    one._actor.ascend = lambda gradient, share: given.append(gradient)
    one._improve(one._parts(seen.views), seen.actions, weight)
    taken = np.arange(len(seen)), seen.actions

    def logs(weights):
        outputs = slow_outputs(weights, 5, seen.views)
        return outputs - np.log(np.exp(outputs).sum(axis=1, keepdims=True))

    old = logs(weights_before)[taken]

    def value(weights):
        log = logs(weights)
        # At the old weights the clipped ratio of PPO is 1, and its slope that of the ratio.
        gain = (np.exp(log[taken] - old) if clip else log[taken]) * weight
        return float((gain - entropy * (np.exp(log) * log).sum(axis=1)).mean())

    check_gradient(given[0], value, weights_before)


def test_the_critic_s_gradient_is_that_of_finite_differences():
    one = new(SMOOTH)
    seen = seen_by(one)
    target = rng().normal(size=len(seen)).astype(np.float32)
    critic = one._critic
    given = []
    critic.ascend = lambda gradient, share: given.append(gradient)
    one._fit(critic, one._parts(seen.views), target)
    assert len(given) == 5

    def value(weights):
        return float(-((slow_outputs(weights, 1, seen.views)[:, 0] - target) ** 2).mean())

    check_gradient(given[0], value, critic.weights)


def test_the_multiplier_rises_above_the_limit_and_falls_below_it():
    one = new(cost_limit=10.0, cost_rate=0.5)
    seen = seen_by(one)

    def after(collisions_per_1000):
        costs = np.full(len(seen), collisions_per_1000 / 1000, np.float32)
        one.learn(replace(seen, costs=costs))
        return one.multiplier

    # By the rate at most; and never below 0.
    rates = (0.0, 18.0, 300.0, 5.0, 0.0, 0.0)
    expected = [0.0, 0.4, 0.9, 0.65, 0.15, 0.0]
    assert [after(rate) for rate in rates] == pytest.approx(expected, abs=1e-5)


def test_it_learns_to_catch_in_a_small_world():
    """Pursuers learn to reach evaders that stand still, to a level that chance does not reach."""
    config = WorldConfig("O", rows=6, cols=6, n_pursuers=2, n_evaders=3, fov=5, max_steps=30)
    update = new(actor_rate=0.01, critic_rate=0.01, actor_updates=4, clip=0.2)
    one, state = update.settings, update.state()
    # Seeds that training does not reach.
    test = Matches.of(0, 0, np.arange(10_000, 10_100, dtype=np.uint64))

    def captures():
        policy = Population(one.genome(state)[None], NETWORK)
        return float(rollout(config, policy, "still", test).captured_fraction.mean())

    first = captures()
    for epoch in range(40):
        seeds = np.arange(16 * epoch, 16 * (epoch + 1), dtype=np.uint64)
        candidates, asked = one.ask(state, rng())
        own = Population(candidates[:1], NETWORK)
        matches = own, "still", np.zeros(16, int), seeds
        again = partial(experience, config, "pursuer", *matches, threads=1)
        state = one.tell(asked, Results(np.zeros(4), again))
    assert first < 0.5
    assert captures() > 0.65


LEARNER = {"learner": "actor-critic", "population": 3, "actor_rate": 0.01}


@pytest.fixture
def torch():
    return pytest.importorskip("torch")


HALL = tiny_race(**LEARNER, schedule="hall-of-fame")
COSTS = {"learner.cost_limit": 2.0, "clip": 0.2, "actor_updates": 2, "minibatches": 2, "hidden": ()}
RUNS = {
    "O": (HALL, 5),
    "TO": (HALL.changed({"world.rules": "TO"}), 5),
    "pursuers": (
        tiny_race().changed({"learner": "actor-critic", "schedule.evader_learner": "es"}),
        5,
    ),
    "evaders": (tiny_race().changed({"schedule.evader_learner": "actor-critic"}), 5),
    "central": (tiny_single(**LEARNER, central_critic=True, match_episodes=2), 2),
    "costs": (tiny_single(**{**LEARNER, **COSTS}), 2),
}
"""Runs, and the call of `rollout` at which they are stopped."""


@pytest.mark.parametrize("name", RUNS)
def test_runs_learn_and_resume_bit_for_bit(torch, name, tmp_path):
    check_resumes(*RUNS[name], tmp_path / "run")
    for genomes in open_run(tmp_path / "run").archive().values():
        assert len(np.unique(genomes, axis=0)) == len(genomes) in (0, 3, 4)


def test_a_central_critic_sees_no_turns():
    with pytest.raises(ValueError, match="central_critic: expected false where agents take turns"):
        HALL.changed({"world.rules": "TO", "learner.central_critic": True})


def test_a_device_that_is_missing_is_refused_before_anything_is_written(torch, tmp_path):
    with pytest.raises(ValueError, match="^device: expected"):
        create(tiny_race(**LEARNER, device="tpu9"), tmp_path / "run")
    assert not (tmp_path / "run").exists()


def test_rates_fall_to_a_tenth():
    first = new(epochs=4, actor_updates=2, anneal=True)
    shares = []
    for updates in (0, 2, 4, 8, 20):
        state = first.state()
        adam = state.actor.adam._replace(updates=np.array(updates))
        state = state._replace(actor=state.actor._replace(adam=adam))
        one = Update(first.settings, state)
        one._actor.ascend = lambda _, share: shares.append(share)
        one.learn(seen_by(first))
    np.testing.assert_allclose(shares[::2], [1.0, 0.775, 0.55, 0.1, 0.1])


def test_an_update_changes_no_array_of_the_state_before():
    one = new(cost_limit=3.0)
    state, seen = one.state(), seen_by(one)
    before = {name: value.copy() for name, value in flat(state).items()}
    one.learn(seen)
    after = flat(state)
    assert all(np.array_equal(after[name], before[name]) for name in before)
    assert not np.array_equal(genome(one), before["actor.weights"])


def test_minibatches_and_chunks_divide_the_transitions(monkeypatch):
    monkeypatch.setattr(actor_critic, "CHUNK", 50)
    one = new(minibatches=3, actor_updates=3)
    seen = seen_by(one)
    numbers = np.arange(len(seen))
    places = [numbers[place] for part in one._parts(seen.views) for _, place in part]
    assert len(places) > 3
    np.testing.assert_array_equal(np.sort(np.concatenate(places)), numbers)
