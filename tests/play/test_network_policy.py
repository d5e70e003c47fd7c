"""Genomes as policies: actions, probabilities, and the same function in other libraries."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import matrixworld as mw
from right_of_way import forbidden_in_s, random_teams

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


def test_actions_are_drawn_from_the_probabilities_with_a_seed() -> None:
    policy, again = policy_of(), policy_of()
    seen = np.repeat(VIEWS[:1], 20_000, axis=0)
    actions = policy(seen)
    assert actions.dtype == np.int64
    assert np.array_equal(actions, again(seen))
    assert not np.array_equal(actions, policy(seen))
    shares = np.bincount(actions, minlength=5) / len(actions)
    # 4 deviations of 20,000 draws.
    assert np.allclose(shares, policy.probabilities(VIEWS[0]), atol=0.015)


def test_a_policy_that_does_not_sample_takes_the_most_probable_action() -> None:
    drawn = policy_of()
    policy = mw.NetworkPolicy(drawn.network, drawn.genome, sampled=False)
    assert np.array_equal(policy(VIEWS), policy.probabilities(VIEWS).argmax(axis=1))
    assert not policy.network.sampled
    assert drawn.network.sampled


def test_observations_come_single_or_in_batches_flat_or_not_in_any_dtype() -> None:
    policy = policy_of(sampled=False)
    actions = policy(VIEWS)
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


@pytest.mark.parametrize("hidden", [(), (16,), (16, 8)])
@pytest.mark.parametrize("activation", ["relu", "tanh"])
def test_pytorch_has_the_same_probabilities(hidden: tuple[int, ...], activation: str) -> None:
    torch = pytest.importorskip("torch", reason="PyTorch is not installed")
    policy = policy_of(hidden=hidden, activation=activation)
    module = policy.to_torch()
    assert isinstance(module, torch.nn.Sequential)
    with torch.no_grad():
        logits = module(torch.from_numpy(VIEWS).float())
    probabilities = torch.softmax(logits, dim=1).numpy()
    assert np.abs(probabilities - policy.probabilities(VIEWS)).max() < 1e-6
    assert all(parameter.requires_grad for parameter in module.parameters())


# What agents remember when they see these.
STATES = np.random.default_rng(6).uniform(-1, 1, (200, 16)).astype(np.float32)


@pytest.mark.parametrize("memory", ["elman", "gru"])
def test_a_policy_with_memory_takes_states_and_returns_the_next(memory: str) -> None:
    policy, same = (policy_of(memory=memory, sampled=False) for _ in range(2))
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


@pytest.mark.parametrize("hidden", [(16,), (16, 8)])
@pytest.mark.parametrize("memory", ["elman", "gru"])
def test_libraries_have_the_same_memory(hidden: tuple[int, ...], memory: str) -> None:
    """Their own recurrent layers, step after step."""
    policy = policy_of(hidden=hidden, memory=memory)
    expected = policy.network.advance(policy.genome, VIEWS, STATES)
    views = VIEWS.astype(np.float32)
    answers = []
    try:
        import torch
    except ImportError:
        pass
    else:
        with torch.no_grad():
            given = torch.from_numpy(views), torch.from_numpy(STATES)
            answers.append([each.numpy() for each in policy.to_torch()(*given)])
    try:
        from onnx.reference import ReferenceEvaluator
    except ImportError:
        pass
    else:
        run = ReferenceEvaluator(policy.to_onnx()).run
        given = {"observations": views, "states": STATES}
        answers.append(run(["logits", "next_states"], given))
    if not answers:
        pytest.skip("needs PyTorch or the package onnx")
    for logits, following in answers:
        assert np.abs(logits - expected[0]).max() < 1e-5
        assert np.abs(following - expected[1]).max() < 1e-6


@pytest.mark.parametrize("hidden", [(), (8,), (8, 6)])
def test_an_exported_network_keeps_the_right_of_way(hidden: tuple[int, ...]) -> None:
    torch = pytest.importorskip("torch", reason="PyTorch is not installed")
    config = mw.WorldConfig("S", rows=8, cols=8, n_pursuers=9, n_evaders=9, fov=5)
    pursuers, _ = random_teams(config, np.random.default_rng(0), 1, hidden=hidden)
    world = mw.World(config)
    views = np.concatenate([(world.reset(seed=seed), world.views()[:9])[1] for seed in range(9)])
    module = mw.NetworkPolicy(pursuers.network, pursuers.genomes[0]).to_torch()
    chances = module(torch.from_numpy(views).float()).softmax(dim=1).detach().numpy()
    refused = np.array([forbidden_in_s(view, "pursuer", 5) for view in views])
    assert refused.any(axis=0)[1:].all()
    assert (chances[refused] == 0).all()
    assert (chances[~refused] > 0).all()


@pytest.mark.parametrize("hidden", [(), (16,), (16, 8)])
@pytest.mark.parametrize("activation", ["relu", "tanh"])
def test_onnx_has_the_same_probabilities(
    hidden: tuple[int, ...], activation: str, tmp_path: Path
) -> None:
    onnx = pytest.importorskip("onnx", reason="the package onnx is not installed")
    from onnx.reference import ReferenceEvaluator

    policy = policy_of(hidden=hidden, activation=activation)
    path = tmp_path / "policy.onnx"
    onnx.save(policy.to_onnx(), path)
    inputs = {"observations": VIEWS.astype(np.float32)}
    logits, probabilities = ReferenceEvaluator(str(path)).run(None, inputs)
    assert np.abs(logits - policy.logits(VIEWS)).max() < 1e-5
    assert np.abs(probabilities - policy.probabilities(VIEWS)).max() < 1e-6


# ---- Policies of saved runs --------------------------------------------------------------------
