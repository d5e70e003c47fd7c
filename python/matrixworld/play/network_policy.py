"""A genome as a policy: it acts on observations, and other libraries can run it."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld._util.checks import check_bool
from matrixworld.version import __version__, imported
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
    run. It keeps no state of agents: a policy with memory takes their states and returns the next.

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

    With memory, each agent has a state:

    >>> network = Network(hidden=(16,), fov=5, memory="gru")
    >>> policy = NetworkPolicy(network, network.initial(np.random.default_rng(0)), seed=1)
    >>> states = dict.fromkeys(observations)
    >>> for agent, seen in observations.items():
    ...     actions[agent], states[agent] = policy(seen, states[agent])
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

    def __call__(self, observations: ArrayLike, states: ArrayLike | None = None) -> Any:
        """Return actions for observations: an int for one, int64 of the leading axes for several.

        An observation is (3, fov, fov) or flattened; further axes may stand in front of it. With
        memory it is a pair, actions and next states: `states`, float32 (..., state_size), are those
        of the agents before, by default zeros, as at the start of an episode.
        """
        logits, following, leading = self._advance(observations, states)
        if self.network.sampled:
            # The action is the number of cumulated weights that do not exceed unit * total.
            cumulated = np.exp(logits - logits.max(axis=1, keepdims=True)).cumsum(axis=1)
            threshold = self._rng.random(len(logits), np.float32) * cumulated[:, -1]
            actions = (cumulated[:, :-1] <= threshold[:, None]).sum(axis=1)
        else:
            actions = logits.argmax(axis=1)
        chosen = actions.reshape(leading) if leading else int(actions[0])
        return (chosen, following) if self.network.state_size else chosen

    def logits(
        self, observations: ArrayLike, states: ArrayLike | None = None
    ) -> NDArray[np.float32]:
        """Return the outputs of the network, (..., n_actions), for arguments as in a call."""
        logits, _, leading = self._advance(observations, states)
        return logits.reshape(*leading, -1)

    def probabilities(
        self, observations: ArrayLike, states: ArrayLike | None = None
    ) -> NDArray[np.float32]:
        """Return the probability of each action, (..., n_actions): the softmax of the outputs.

        A policy that does not sample takes the largest.
        """
        logits = self.logits(observations, states)
        weights = np.exp(logits - logits.max(axis=-1, keepdims=True))
        return np.asarray(weights / weights.sum(axis=-1, keepdims=True))

    def _advance(
        self, observations: ArrayLike, states: ArrayLike | None
    ) -> tuple[NDArray[np.float32], NDArray[np.float32], tuple[int, ...]]:
        """Return outputs (n, n_actions), next states (..., state_size) and the leading axes."""
        views, leading = self._views(observations)
        shape = *leading, self.network.state_size
        if states is not None:
            if np.shape(states) != shape or not self.network.state_size:
                expected = f"shape {shape}" if self.network.state_size else "none without memory"
                raise ValueError(f"states: expected {expected}, got shape {np.shape(states)}")
            states = np.asarray(states, np.float32).reshape(len(views), -1)
        logits, following = self.network.advance(self.genome, views, states)
        return logits, following.reshape(shape), leading

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
        every layer but the last, whose outputs are the logits, and a recurrent one (see `Network`).
        """
        return [(w.copy(), b.copy()) for w, b in self.network.layers(self.genome)]

    def population(self) -> Population:
        """Return the genome as a population of one, which rollouts and environments take."""
        return Population(self.genome, self.network)

    def to_torch(self) -> torch.nn.Module:
        """Return the network as a PyTorch module: observations (n, ...) to logits (n, n_actions).

        It is Flatten, then Linear and activation in turn. Inputs are float32; the softmax of the
        outputs are the probabilities. It can be trained. With memory it maps observations and
        states (n, state_size) to logits and next states, by an RNNCell or GRUCell. Raises
        ImportError without PyTorch.
        """
        torch = imported("torch", "torch")
        activation = torch.nn.ReLU if self.network.activation == "relu" else torch.nn.Tanh
        size, modules = self.network.state_size, [torch.nn.Flatten()]
        for number, (weights, bias) in enumerate(self.layers()):
            # PyTorch keeps weights as (outputs, inputs).
            rows, numbers = torch.from_numpy(weights.T.copy()), torch.from_numpy(bias)
            if number == 1 and size:
                make = torch.nn.RNNCell if self.network.memory == "elman" else torch.nn.GRUCell
                parts = rows[:, :size], rows[:, size:], numbers, torch.zeros_like(numbers)
                names = "weight_ih", "weight_hh", "bias_ih", "bias_hh"
                modules.append(make(size, size))
                modules[-1].load_state_dict(dict(zip(names, parts, strict=True)))
                continue
            modules += [torch.nn.Linear(*weights.shape), activation()]
            modules[-2].load_state_dict({"weight": rows, "bias": numbers})
        modules.pop()
        return _with_states(modules) if size else torch.nn.Sequential(*modules)

    def to_onnx(self, path: str | Path | None = None) -> onnx.ModelProto:
        """Return the network as an ONNX model, and write it to a file if there is a path.

        Its input is ``observations``, float32 (n, 3, fov, fov); outputs are ``logits`` and
        ``probabilities``, float32 (n, n_actions). With memory a second input is ``states`` and the
        third output ``next_states``, float32 (n, state_size). Raises ImportError without the
        package onnx.
        """
        onnx = imported("onnx", "onnx")
        model = onnx.helper.make_model(
            _onnx_graph(self.network, self.layers()),
            opset_imports=[onnx.helper.make_opsetid("", _OPSET)],
            ir_version=_IR_VERSION,
            producer_name="matrixworld",
            producer_version=__version__,
        )
        onnx.checker.check_model(model, full_check=True)
        if path is not None:
            onnx.save(model, path)
        return model


def _with_states(modules: list[torch.nn.Module]) -> torch.nn.Module:
    """Return a module of (observations, states) from its parts, of which the fourth is a cell."""
    import torch

    class WithStates(torch.nn.Module):  # type: ignore[misc]  # of an untyped package
        def __init__(self) -> None:
            super().__init__()
            self.first = torch.nn.Sequential(*modules[:3])
            self.cell = modules[3]
            self.rest = torch.nn.Sequential(*modules[4:])

        def forward(self, observations: Any, states: Any) -> Any:
            following = self.cell(self.first(observations), states)
            return self.rest(following), following

    return WithStates()


def _onnx_graph(network: Network, layers: Layers) -> onnx.GraphProto:
    """Return the network's nodes, and the softmax of its logits, with these weights."""
    import onnx

    helper, to_tensor = onnx.helper, onnx.numpy_helper.from_array
    activation = "Relu" if network.activation == "relu" else "Tanh"
    nodes: list[Any] = [helper.make_node("Flatten", ["observations"], ["hidden_0"], axis=1)]
    weights: list[Any] = []
    for number, (matrix, bias) in enumerate(layers):
        names = [f"weights_{number}", f"bias_{number}"]
        inputs = [f"hidden_{number}", *names]
        if number == 1 and network.state_size:
            cell_nodes, cell_weights = _onnx_cell(network, matrix, bias)
            nodes, weights = nodes + cell_nodes, weights + cell_weights
            continue
        weights += map(to_tensor, (matrix, bias), names)
        if number == len(layers) - 1:
            nodes.append(helper.make_node("Gemm", inputs, ["logits"]))
            break
        nodes.append(helper.make_node("Gemm", inputs, [f"sum_{number}"]))
        nodes.append(helper.make_node(activation, [f"sum_{number}"], [f"hidden_{number + 1}"]))
    nodes.append(helper.make_node("Softmax", ["logits"], ["probabilities"], axis=1))

    def values(**shapes: list[str | int]) -> list[Any]:
        floats = onnx.TensorProto.FLOAT
        return [helper.make_tensor_value_info(name, floats, each) for name, each in shapes.items()]

    state: list[str | int] = ["n", network.state_size]
    answer: list[str | int] = ["n", network.n_actions]
    given = values(observations=["n", CHANNELS, network.fov, network.fov])
    returned = values(logits=answer, probabilities=answer)
    if network.state_size:
        given += values(states=state)
        returned += values(next_states=state)
    return helper.make_graph(nodes, "policy", given, returned, weights)


def _onnx_cell(
    network: Network, matrix: NDArray[np.float32], bias: NDArray[np.float32]
) -> tuple[list[Any], list[Any]]:
    """Return nodes from hidden_1 and states to next_states, also named hidden_2, with weights."""
    import onnx

    node, to_tensor, size = onnx.helper.make_node, onnx.numpy_helper.from_array, network.state_size
    options = {"hidden_size": size}
    if network.memory == "gru":
        options["linear_before_reset"] = 1
        # ONNX has the gates in the order z, r, c.
        order = np.r_[size : 2 * size, :size, 2 * size : 3 * size]
        matrix, bias = matrix[:, order], bias[order]
    rows = matrix.T.copy()
    weights = {
        "steps": np.array([0], np.int64),  # the axis of time, of one step
        "weights_1": rows[None, :, :size],
        "states_1": rows[None, :, size:],
        "bias_1": np.concatenate([bias, np.zeros_like(bias)])[None],
    }
    nodes = [
        node("Unsqueeze", ["hidden_1", "steps"], ["input_1"]),
        node("Unsqueeze", ["states", "steps"], ["before_1"]),
        node(
            "RNN" if network.memory == "elman" else "GRU",
            ["input_1", "weights_1", "states_1", "bias_1", "", "before_1"],
            ["", "after_1"],
            **options,
        ),
        node("Squeeze", ["after_1", "steps"], ["next_states"]),
        node("Identity", ["next_states"], ["hidden_2"]),
    ]
    return nodes, [to_tensor(np.ascontiguousarray(each), name) for name, each in weights.items()]
