"""Exported networks: in PyTorch and in ONNX, with their own layers, recurrent ones among them."""

import importlib

import numpy as np
import pytest

import matrixworld as mw

SHAPES = [
    {"hidden": ()},
    {"hidden": (16, 8), "activation": "tanh"},
    {"hidden": (16,), "memory": "gru"},
    {"hidden": (16, 8), "activation": "tanh", "memory": "gru"},
]
RNG = np.random.default_rng(6)
VIEWS = RNG.integers(0, 2, (200, 3, 5, 5)).astype(np.uint8)
STATES = RNG.uniform(-1, 1, (200, 16)).astype(np.float32)


@pytest.mark.parametrize("shape", SHAPES, ids=str)
@pytest.mark.parametrize("library", ["torch", "onnx"])
def test_an_exported_network_computes_the_same(shape, library):
    package = pytest.importorskip(library, exc_type=ImportError)
    network = mw.Network(fov=5, **shape)
    genome = network.initial(np.random.default_rng(1), 0.5, 2.0)
    # A new genome has no biases.
    biases = np.random.default_rng(2).normal(0, 0.05, genome.shape).astype(np.float32)
    policy = mw.NetworkPolicy(network, genome + biases)
    given = {"observations": VIEWS.astype(np.float32)}
    if network.memory == "none":
        expected = [policy.logits(VIEWS), policy.probabilities(VIEWS)]
    else:
        given["states"] = STATES
        expected = list(network.advance(policy.genome, VIEWS, STATES))
    if library == "torch":
        module = importlib.import_module("torch_export").to_torch(policy)
        with package.no_grad():
            found = module(*map(package.from_numpy, given.values()))
        found = [each.numpy() for each in found] if "states" in given else [found.numpy()]
        assert all(parameter.requires_grad for parameter in module.parameters())
    else:
        reference = importlib.import_module("onnx.reference")
        model = importlib.import_module("onnx_export").to_onnx(policy)
        names = ["logits", "next_states" if "states" in given else "probabilities"]
        found = reference.ReferenceEvaluator(model).run(names, given)
    for one, other in zip(found, expected, strict=False):
        assert np.abs(one - other).max() < 1e-5


@pytest.mark.parametrize("hidden", [(), (6, 4)], ids=str)
def test_a_module_of_pytorch_rates_the_same(hidden):
    torch = pytest.importorskip("torch", exc_type=ImportError)
    rating = mw.Rating(inputs=("room", "adversary", "pressure"), hidden=hidden)
    genome = np.random.default_rng(4).normal(size=rating.genome_size)  # biases, too
    policy = mw.RatingPolicy(rating, genome.astype(np.float32))
    inputs = np.random.default_rng(2).uniform(0, 2, (50, 5, len(mw.INPUTS))).astype(np.float32)
    module = importlib.import_module("torch_export").rating_to_torch(policy)
    with torch.no_grad():
        rated = module(torch.from_numpy(inputs)).numpy()
    np.testing.assert_allclose(rated, policy.rate(inputs), rtol=1e-4, atol=1e-5)
