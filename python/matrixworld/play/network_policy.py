"""A genome as a policy: it acts on observations, and other libraries can run it."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld._util.checks import check_bool
from matrixworld.version import __version__
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import CHANNELS, Network, Population

if TYPE_CHECKING:
    import onnx
    import torch


Layers: TypeAlias = list[tuple[NDArray[np.float32], NDArray[np.float32]]]
"""Weights (inputs, outputs) and biases (outputs,) of each layer."""

# Versions of ONNX, of 2020: enough for a perceptron, and read by old runtimes.
_OPSET, _IR_VERSION = 13, 8


def fits(network: Network, config: WorldConfig) -> bool:
    """Return whether a network has the views and actions of a world."""
    return (network.fov, network.n_actions) == (config.fov, config.n_actions)


def check_fits(name: str, network: Network, config: WorldConfig) -> None:
    """Raise ValueError unless a network has the views and actions of a world."""
    if not fits(network, config):
        raise ValueError(
            f"{name}: expected a network for fov {config.fov} and {config.n_actions} actions, "
            f"got fov {network.fov} and {network.n_actions} actions"
        )


class NetworkPolicy:
    """A policy network with its weights, to act on observations outside of the engine.

    Call it with observations to get actions. `SavedRun.policy` returns one for a generation of a
    run.

    Parameters
    ----------
    network : Network
        The network.
    genome : ndarray of float32, shape (genome_size,)
        Its weights and biases.
    sampled : bool, optional
        Whether actions are drawn from the probabilities, or are those with the largest one. The
        default is what the network says.
    seed : int, optional
        Seed of the draws. The default is one from the operating system.

    Attributes
    ----------
    network : Network
        The network, with `sampled` as given.
    genome : ndarray of float32, shape (genome_size,)
        A copy.

    Raises
    ------
    ValueError, TypeError
        As `Population` does.

    Examples
    --------
    >>> import numpy as np
    >>> from matrixworld import Network, NetworkPolicy, parallel_env
    >>> network = Network(hidden=(16,), fov=5)
    >>> policy = NetworkPolicy(network, network.initial(np.random.default_rng(0)), seed=1)
    >>> env = parallel_env("O", rows=8, cols=8, n_pursuers=2, n_evaders=2, fov=5)
    >>> observations, infos = env.reset(seed=0)
    >>> actions = {agent: policy(seen) for agent, seen in observations.items()}
    >>> policy.probabilities(np.stack(list(observations.values()))).shape
    (4, 5)
    """

    def __init__(
        self,
        network: Network,
        genome: NDArray[np.float32],
        *,
        sampled: bool | None = None,
        seed: int | None = None,
    ) -> None:
        genomes = Population(genome, network).genomes
        if len(genomes) != 1:
            raise ValueError(f"genome: expected a single one, got {len(genomes)}")
        self.genome = genomes[0].copy()
        self.network = network
        if sampled is not None:
            self.network = replace(network, sampled=check_bool("sampled", sampled))
        self._rng = np.random.default_rng(seed)

    def __repr__(self) -> str:
        """Return the network without its weights."""
        return f"NetworkPolicy({self.network!r})"

    def __call__(self, observations: ArrayLike) -> Any:
        """Return actions for observations: an int for one, int64 of the leading axes for several.

        An observation is (3, fov, fov) or flattened; further axes may stand in front of it.
        """
        views, leading = self._views(observations)
        logits = self.network.logits(self.genome, views)
        if self.network.sampled:
            # The action is the number of cumulated weights that do not exceed unit * total.
            cumulated = np.exp(logits - logits.max(axis=1, keepdims=True)).cumsum(axis=1)
            threshold = self._rng.random(len(views), np.float32) * cumulated[:, -1]
            actions = (cumulated[:, :-1] <= threshold[:, None]).sum(axis=1)
        else:
            actions = logits.argmax(axis=1)
        return actions.reshape(leading) if leading else int(actions[0])

    def logits(self, observations: ArrayLike) -> NDArray[np.float32]:
        """Return the outputs of the network, (..., n_actions), for observations as in a call."""
        views, leading = self._views(observations)
        return self.network.logits(self.genome, views).reshape(*leading, -1)

    def probabilities(self, observations: ArrayLike) -> NDArray[np.float32]:
        """Return the probability of each action, (..., n_actions): the softmax of the outputs.

        A policy that does not sample takes the largest.
        """
        logits = self.logits(observations)
        weights = np.exp(logits - logits.max(axis=-1, keepdims=True))
        return np.asarray(weights / weights.sum(axis=-1, keepdims=True))

    def _views(self, observations: ArrayLike) -> tuple[NDArray[Any], tuple[int, ...]]:
        """Return observations as (n, 3, fov, fov), and the axes in front of an observation."""
        array = np.asarray(observations)
        if array.dtype.kind not in "buif":
            raise TypeError(f"observations: expected numbers, got dtype {array.dtype}")
        view = (CHANNELS, self.network.fov, self.network.fov)
        size = self.network.sizes[0]
        for tail in (view, (size,)):
            if array.shape[-len(tail) :] == tail:
                return array.reshape(-1, *view), array.shape[: -len(tail)]
        raise ValueError(
            f"observations: expected shape (..., {str(view)[1:]} or (..., {size}), "
            f"got {array.shape}"
        )

    def layers(self) -> Layers:
        """Return a copy of the weights (inputs, outputs) and biases (outputs,) of each layer.

        An observation is flattened in its own order: channel, row, column. The activation follows
        every layer but the last, whose outputs are the logits.
        """
        return [(w.copy(), b.copy()) for w, b in self.network.layers(self.genome)]

    def population(self) -> Population:
        """Return the genome as a population of one, which rollouts and environments take."""
        return Population(self.genome, self.network)

    def to_torch(self) -> torch.nn.Sequential:
        """Return the network as a PyTorch module: observations (n, ...) to logits (n, n_actions).

        It is Flatten, then Linear and activation in turn. Inputs are float32; the softmax of the
        outputs are the probabilities. It can be trained. Raises ImportError without PyTorch.
        """
        try:
            import torch
        except ImportError as error:
            raise ImportError(
                "to_torch: expected PyTorch, install it: pip install torch"
            ) from error
        activation = torch.nn.ReLU if self.network.activation == "relu" else torch.nn.Tanh
        modules: list[torch.nn.Module] = [torch.nn.Flatten()]
        for weights, bias in self.layers():
            linear = torch.nn.Linear(*weights.shape)
            # PyTorch keeps weights as (outputs, inputs).
            linear.load_state_dict(
                {"weight": torch.from_numpy(weights.T.copy()), "bias": torch.from_numpy(bias)}
            )
            modules += [linear, activation()]
        return torch.nn.Sequential(*modules[:-1])

    def to_onnx(self) -> onnx.ModelProto:
        """Return the network as an ONNX model, for example to save with ``onnx.save``.

        Its input is ``observations``, float32 (n, 3, fov, fov); outputs are ``logits`` and
        ``probabilities``, float32 (n, n_actions). Raises ImportError without the package onnx.
        """
        try:
            import onnx
        except ImportError as error:
            raise ImportError(
                "to_onnx: expected the package onnx, install it: pip install onnx"
            ) from error
        model = onnx.helper.make_model(
            _onnx_graph(self.network, self.layers()),
            opset_imports=[onnx.helper.make_opsetid("", _OPSET)],
            ir_version=_IR_VERSION,
            producer_name="matrixworld",
            producer_version=__version__,
        )
        onnx.checker.check_model(model, full_check=True)
        return model


def _onnx_graph(network: Network, layers: Layers) -> onnx.GraphProto:
    """Return the network's nodes, and the softmax of its logits, with these weights."""
    import onnx

    helper = onnx.helper
    activation = "Relu" if network.activation == "relu" else "Tanh"
    nodes: list[Any] = [helper.make_node("Flatten", ["observations"], ["hidden_0"], axis=1)]
    weights: list[Any] = []
    for number, (matrix, bias) in enumerate(layers):
        names = [f"weights_{number}", f"bias_{number}"]
        weights += map(onnx.numpy_helper.from_array, (matrix, bias), names)
        inputs = [f"hidden_{number}", *names]
        if number == len(layers) - 1:
            nodes.append(helper.make_node("Gemm", inputs, ["logits"]))
            break
        nodes.append(helper.make_node("Gemm", inputs, [f"sum_{number}"]))
        nodes.append(helper.make_node(activation, [f"sum_{number}"], [f"hidden_{number + 1}"]))
    nodes.append(helper.make_node("Softmax", ["logits"], ["probabilities"], axis=1))
    shapes: dict[str, list[str | int]] = {
        "observations": ["n", CHANNELS, network.fov, network.fov],
        "logits": ["n", network.n_actions],
        "probabilities": ["n", network.n_actions],
    }
    first, *outputs = (
        helper.make_tensor_value_info(name, onnx.TensorProto.FLOAT, shape)
        for name, shape in shapes.items()
    )
    return helper.make_graph(nodes, "policy", [first], outputs, weights)
