"""Policies of a team: multilayer perceptrons as flat genomes, and scripts."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable
from dataclasses import dataclass, fields
from functools import cached_property
from itertools import pairwise
from math import prod
from pathlib import Path
from typing import Any, ClassVar, Literal, TypeAlias

import numpy as np
from numpy.typing import NDArray
from typing_extensions import Self

from matrixworld import _core
from matrixworld._util import checks
from matrixworld._util.files import load_toml
from matrixworld._util.readable import Readable, plain_values
from matrixworld._util.teams import TEAMS as TEAMS
from matrixworld._util.teams import Team as Team
from matrixworld.world.config import WorldConfig

Script: TypeAlias = str
"""One of `SCRIPTS`."""

CAREFUL = "careful-"
"""Before the name of a script that takes only moves that right of way allows."""

_PLAIN_TEXTS: dict[Script, str] = load_toml(Path(__file__).with_name("scripts.toml"))

SCRIPT_TEXTS: dict[Script, str] = _PLAIN_TEXTS | {
    f"{CAREFUL}{name}": f"as {name}, but takes only moves that right of way allows"
    for name in _PLAIN_TEXTS
    if name != "still"
}
"""What scripts do.

Distances are counted in moves; for the dodger each cell that holds some adversaries weighs
``2**14 // (1 + moves)**2``. All scripts but random avoid obstacles and break ties at random. A
careful script needs a fov of at least 5.
Without an adversary in view (for the surrounder: without such a cell; for the hunter: without an
adversary of its own) hunter and surrounder keep one direction for 12 steps, and the others, except
still, walk at random.

The team-surrounder stays beside an adversary. Otherwise the nearest teammates in view that are not
beside one share the free cells beside adversaries in view, so that the ways are short and
adversaries can flee towards a border only; each goes to its own. Without one it searches: in few,
teams of as many as surround an adversary cross the grid in a line; in many, each agent crosses it
in swaths of its own. Views wider than 11 are cut to 11. It counts steps, and knows the sizes of the
grid and of its team, and whether there are obstacles.
"""

SCRIPTS: tuple[Script, ...] = tuple(SCRIPT_TEXTS)
"""Names of the scripted policies."""

Memory: TypeAlias = Literal["none", "gru"]

GATES: dict[Memory, int] = {"none": 0, "gru": 3}
"""Outputs of a recurrent layer for each of its units."""

CHANNELS = 3
"""Channels of a view: evaders, pursuers, obstacles."""

FORBIDDEN = -(2.0**100)
"""What a mask adds to the output of a forbidden move. Its probability is 0: e^x is 0 in float32
below -104, and other outputs are smaller by far, as `Network.check_genomes` sees to."""

_MAX_FOV = 255  # as in a world
_MAX_LAYER = 2**20


Layers: TypeAlias = list[tuple[NDArray[np.float32], NDArray[np.float32]]]
"""Weights (inputs, outputs) and biases (outputs,) of each layer."""


def layers_of(genome: NDArray[np.float32], shapes: Iterable[tuple[int, int]]) -> Layers:
    """Return the layers of a genome by their inputs and outputs; the last may lack biases."""
    layers, start = [], 0
    for n_in, n_out in shapes:
        middle, end = start + n_in * n_out, start + (n_in + 1) * n_out
        layers.append((genome[start:middle].reshape(n_in, n_out), genome[middle:end]))
        start = end
    return layers


class Policy(ABC):
    """The shape of a policy: what its genomes mean, in worlds with certain views and moves.

    `Network`, `Rating` and `Program` are policies. Each is compared and hashed by its fields.
    """

    kind: ClassVar[str]
    """Name of the kind of policy in settings and files."""
    fov: int
    n_actions: int
    memory: Memory = "none"
    state_size: int = 0
    """Length of what an agent remembers from one step to the next."""

    @classmethod
    def for_config(cls, config: WorldConfig, *first: Any, **more: Any) -> Self:
        """Return one for the views and actions of a world; the others are its other fields."""
        checks.check_instance("config", config, WorldConfig)
        shape: dict[str, Any] = {"fov": config.fov, "n_actions": config.n_actions}
        return cls(*first, **shape, **more)

    def fits(self, config: WorldConfig) -> bool:
        """Return whether it has the views and actions of a world."""
        return (self.fov, self.n_actions) == (config.fov, config.n_actions)

    def check_fits(self, name: str, config: WorldConfig) -> None:
        """Raise ValueError, naming the argument, unless it has the views and actions of a world."""
        if not self.fits(config):
            raise ValueError(
                f"{name}: expected a policy for fov {config.fov} and {config.n_actions} actions, "
                f"got fov {self.fov} and {self.n_actions} actions"
            )

    @property
    @abstractmethod
    def genome_size(self) -> int:
        """Numbers in a genome."""

    @property
    @abstractmethod
    def core(self) -> Any:
        """The engine's form of this policy."""

    @abstractmethod
    def initial(self, rng: np.random.Generator) -> NDArray[np.float32]:
        """Return a random genome, float32 (genome_size,)."""

    def check_genomes(self, genomes: NDArray[np.float32]) -> None:  # noqa: B027
        """Raise ValueError for genomes (n, genome_size) that mean nothing. By default, none do."""

    def _check_world(self) -> None:
        # A frozen dataclass lets its fields be set in this way only.
        object.__setattr__(self, "fov", checks.check_integer("fov", self.fov, 1, _MAX_FOV))
        object.__setattr__(self, "n_actions", checks.check_integer("n_actions", self.n_actions))
        if self.fov % 2 == 0:
            raise ValueError(f"fov: expected an odd number, got {self.fov}")
        if self.n_actions not in (5, 9):
            raise ValueError(f"n_actions: expected 5 or 9, got {self.n_actions}")

    def to_json(self) -> dict[str, Any]:
        """Return kind and fields as values that JSON can hold."""
        return {"kind": self.kind, **plain_values(self)}

    def __getstate__(self) -> dict[str, Any]:
        """Return the fields; the engine's form of them is built again on demand."""
        return {item.name: getattr(self, item.name) for item in fields(self)}  # type: ignore[arg-type]


@dataclass(frozen=True)
class Network(Policy):
    """A multilayer perceptron that maps an agent's view to an action, with or without memory.

    It describes the shape of the network only; a genome holds the weights.

    Parameters
    ----------
    hidden : sequence of int, optional
        Sizes of the hidden layers; may be empty. The default is one layer of 32.
    activation : {"relu", "tanh"}, optional
        Activation of the hidden layers.
    fov : int, optional
        Side of the view, odd. The input is the flattened view, 3 * fov * fov numbers.
    n_actions : int, optional
        Outputs: 5, or 9 with diagonal moves.
    sampled : bool, optional
        Whether the action is drawn from the softmax of the outputs, or is the first largest one.
    memory : {"none", "gru"}, optional
        The recurrent layer after the first hidden layer, of as many units: none, or gated recurrent
        units (Cho et al. 2014, "Learning phrase representations using RNN encoder-decoder").

    Notes
    -----
    A genome is a flat array of float32. It holds, layer by layer, the weights as an (inputs,
    outputs) matrix in row-major order and then the biases.

    A recurrent layer replaces the outputs x of the first hidden layer (n,) by the state h of the
    agent (n,). Each agent has its own, zeros at the start of an episode. At each step::

        r, z = logistic(x W_r + h U_r + b_r), logistic(x W_z + h U_z + b_z)
        c = tanh(x W_c + r * (h U_c) + b_c)
        h' = z * h + (1 - z) * c

    In the genome it is one layer of 2 n inputs, (x, h), and of 3 n outputs: r, z, c.
    The activation is not applied to it.

    Examples
    --------
    >>> from matrixworld import Network
    >>> network = Network(hidden=(16, 8), fov=5)
    >>> network.sizes, network.genome_size
    ((75, 16, 8, 5), 1397)
    """

    kind: ClassVar[str] = "cells"

    hidden: tuple[int, ...] = (32,)
    activation: Literal["relu", "tanh"] = "relu"
    fov: int = 11
    n_actions: int = 5
    sampled: bool = True
    memory: Memory = "none"

    def __post_init__(self) -> None:
        object.__setattr__(self, "hidden", checks.check_sizes("hidden", self.hidden, _MAX_LAYER))
        self._check_world()
        checks.check_bool("sampled", self.sampled)
        checks.check_choice("activation", self.activation, ("relu", "tanh"))
        checks.check_choice("memory", self.memory, GATES)
        if self.memory != "none" and not self.hidden:
            raise ValueError(f"memory: expected none without hidden layers, got {self.memory!r}")

    @property
    def sizes(self) -> tuple[int, ...]:
        """Sizes of all layers but a recurrent one: inputs, hidden layers, actions."""
        return (CHANNELS * self.fov**2, *self.hidden, self.n_actions)

    @property
    def state_size(self) -> int:  # type: ignore[override]
        """Length of an agent's state; 0 without memory."""
        return 0 if self.memory == "none" else self.hidden[0]

    @property
    def shapes(self) -> list[tuple[int, int]]:
        """Inputs and outputs of each layer; the recurrent layer is the second."""
        shapes = list(pairwise(self.sizes))
        if self.memory != "none":
            shapes.insert(1, (2 * self.state_size, GATES[self.memory] * self.state_size))
        return shapes

    @property
    def genome_size(self) -> int:
        """Number of weights and biases in a genome."""
        return sum((n_in + 1) * n_out for n_in, n_out in self.shapes)

    def layers(self, genome: NDArray[np.float32]) -> Layers:
        """Return weights (inputs, outputs) and biases (outputs,) of each layer, views of a genome.

        Changing a returned array changes the genome.
        """
        checks.check_shape("genome", genome, self.genome_size)
        return layers_of(genome, self.shapes)

    def logits(self, genome: NDArray[np.float32], views: NDArray[np.uint8]) -> NDArray[np.float32]:
        """Return the outputs before any softmax, float32 (n, n_actions), computed in NumPy.

        Of views, uint8 (n, 3, fov, fov); with memory, of agents in the first step of an episode.
        """
        return self.advance(genome, views)[0]

    def advance(
        self,
        genome: NDArray[np.float32],
        views: NDArray[np.uint8],
        states: NDArray[np.float32] | None = None,
    ) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
        """Return the outputs of agents, as `logits` does, and their next states (n, state_size).

        `states`, float32 (n, state_size), are what the agents remember; the default is zeros.
        """
        expected = (CHANNELS, self.fov, self.fov)
        checks.check_instance("views", views, np.ndarray)
        if views.shape[1:] != expected:
            raise ValueError(f"views: expected shape (n, {str(expected)[1:]}, got {views.shape}")
        room = len(views), self.state_size
        states = np.zeros(room, np.float32) if states is None else states
        checks.check_shape("states", states, *room)
        x = views.reshape(len(views), self.sizes[0]).astype(np.float32)
        *hidden, last = self.layers(genome)
        for number, (weights, bias) in enumerate(hidden):
            if number == 1 and self.state_size:
                x = states = self._remember(weights, bias, x, states)
                continue
            x = x @ weights + bias
            x = np.maximum(x, 0) if self.activation == "relu" else np.tanh(x)
        return x @ last[0] + last[1], states

    def _remember(
        self, weights: NDArray[Any], bias: NDArray[Any], x: NDArray[Any], states: NDArray[Any]
    ) -> NDArray[Any]:
        """Return the next states (n, state_size); the notes of the class have the formulas."""
        sums = x @ weights[: self.state_size] + bias
        from_states = states @ weights[self.state_size :]
        r, z, c = np.split(sums, 3, axis=1)
        from_r, from_z, from_c = np.split(from_states, 3, axis=1)
        z = _logistic(z + from_z)
        c = np.tanh(c + _logistic(r + from_r) * from_c)
        return np.asarray(z * states + (1 - z) * c)

    def initial(
        self, rng: np.random.Generator, weight: float = 0.05, head: float = 0.1
    ) -> NDArray[np.float32]:
        """Return a random genome, float32 (genome_size,), with all biases 0.

        `weight` and `head` are the standard deviations of the weights in the hidden layers and in
        the last layer. That of a recurrent layer of n units is 1 / sqrt(2 n): states of all sizes
        then last about as long.
        """
        checks.check_instance("rng", rng, np.random.Generator)
        weight = checks.check_number("weight", weight, least=0.0)
        head = checks.check_number("head", head, least=0.0)
        genome = np.zeros(self.genome_size, np.float32)
        layers = self.layers(genome)
        for number, (weights, _) in enumerate(layers):
            scale = head if number == len(layers) - 1 else weight
            if number == 1 and self.state_size:
                scale = len(weights) ** -0.5
            weights[:] = scale * rng.standard_normal(weights.shape, dtype=np.float32)
        return genome

    def forbids(self, genomes: NDArray[np.float32]) -> NDArray[np.bool_]:
        """Return which inputs forbid each move but staying by masks, bool (n, inputs, moves)."""
        moves, (n_in, n_out), (last, _) = self.n_actions - 1, self.shapes[0], self.shapes[-1]
        first = genomes[:, : n_in * n_out].reshape(-1, n_in, n_out)
        if not self.hidden:
            return np.asarray(first[..., 1:] == FORBIDDEN)
        if min(self.hidden) < moves:  # no unit for each move
            return np.zeros((len(genomes), n_in, moves), np.bool_)
        outputs = genomes[:, -(last + 1) * self.n_actions : -self.n_actions]
        units = outputs.reshape(-1, last, self.n_actions)[:, -moves:, 1:]
        masked = (np.diagonal(units, axis1=1, axis2=2) == FORBIDDEN).all(axis=1)
        return np.asarray((first[..., -moves:] == 1.0) & masked[:, np.newaxis, np.newaxis])

    def check_genomes(self, genomes: NDArray[np.float32]) -> None:
        """Raise ValueError for weights that may outweigh those of a mask in the same genome."""
        masked = genomes[self.forbids(genomes).any(axis=(1, 2))]
        # Each layer multiplies numbers by at most so much: a quarter is left for rounding and tanh.
        terms = prod(n_in + 1 for n_in, _ in self.shapes)
        most = (-FORBIDDEN / 8 / terms) ** (1 / len(self.shapes))
        largest = np.abs(masked[masked != FORBIDDEN]).max(initial=0.0)
        if not largest <= most:
            raise ValueError(
                f"genomes: expected weights of at most {most:.1e} beside a mask, got {largest:.1e}"
            )

    # Networks are compared and hashed by their fields, so the engine's form is not one of them.
    @cached_property
    def core(self) -> _core.Network:
        """The engine's form of this network."""
        return _core.Network(**self.__getstate__() | {"hidden": list(self.hidden)})


def _logistic(x: NDArray[Any]) -> NDArray[Any]:
    """Return 1 / (1 + e^-x), by a form that cannot overflow."""
    return np.asarray(0.5 + 0.5 * np.tanh(0.5 * x))


@dataclass(frozen=True, eq=False, repr=False)
class Population(Readable):
    """Genomes of one policy, which can play for a team.

    `genomes` (n, genome_size) are of a `policy`: a `Network`, `Rating` or `Program`. A single one
    (genome_size,) becomes a population of one; other floats are copied to float32.
    """

    genomes: NDArray[np.float32]
    policy: Any

    def __post_init__(self) -> None:
        checks.check_instance("policy", self.policy, Policy)
        genomes = np.atleast_2d(checks.unmasked("genomes", self.genomes))
        if not np.issubdtype(genomes.dtype, np.floating):
            raise TypeError(f"genomes: expected dtype float32, got {genomes.dtype}")
        with np.errstate(over="ignore"):  # what is too large becomes infinite, and is refused
            genomes = genomes.astype(np.float32, copy=False)
        size = self.policy.genome_size
        if len(genomes) == 0 or genomes.shape != (len(genomes), size):
            shape = np.shape(self.genomes)
            raise ValueError(f"genomes: expected shape (n >= 1, {size}), got {shape}")
        checks.check_finite("genomes", genomes)
        # The engine reads the genomes from one block of memory, without copying them.
        object.__setattr__(self, "genomes", np.ascontiguousarray(genomes))
        self.policy.check_genomes(self.genomes)

    @cached_property
    def forbids(self) -> NDArray[np.bool_]:
        """Which inputs of networks forbid each move by masks in the genomes, (n, inputs, moves)."""
        return np.asarray(self.policy.forbids(self.genomes))


TeamPolicy: TypeAlias = Population | Script
"""What plays for a team: genomes of a policy, or the name of a script."""


@dataclass(frozen=True, eq=False)
class TablePolicy:
    """Joint actions of a `team` by state, of a solution or table: that is its `play`.

    Where it counts steps, episodes have `steps` of them.
    """

    core: _core.Tables
    team: Team
    play: Any
    steps: int | None = None


EnginePolicy: TypeAlias = TeamPolicy | TablePolicy
"""All that the engine can play for a team."""


def check_agents(agents: range) -> tuple[int, int]:
    """Return the first agent of a range and one past the last; its step must be 1."""
    if not isinstance(agents, range) or agents.step != 1:
        raise TypeError(f"agents: expected a range with step 1, got {agents!r}")
    return agents.start, agents.stop
