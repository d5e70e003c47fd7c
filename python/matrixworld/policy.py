"""Policies: multilayer perceptrons as flat genomes, and the scripted opponents."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Any, Literal, TypeAlias, get_args

import numpy as np
from numpy.typing import NDArray

from matrixworld import _core
from matrixworld.checks import check_bool, check_integer
from matrixworld.config import WorldConfig

Script: TypeAlias = Literal[
    "random",
    "still",
    "chaser",
    "fleer",
    "clumsy-chaser",
    "hunter",
    "surrounder",
    "clumsy-fleer",
    "dodger",
]

SCRIPTS: tuple[Script, ...] = get_args(Script)
"""Scripted opponents.

random: any action, all equally likely
still: stays
chaser: the move after which the nearest adversary in view is nearest
fleer: the move after which the nearest adversary in view is farthest
clumsy-chaser, clumsy-fleer: the same, but in half of the steps any action
hunter: a chaser of the nearest adversary in view to which no teammate in view is nearer
surrounder: a chaser of the nearest free cell beside an adversary in view that no teammate is on
dodger: the move after which all adversaries in view together are farthest; each cell that holds
    some weighs ``2**14 // (1 + moves)**2``

All but random do not step into obstacles and break ties at random. While they see nobody (the
hunter: no adversary, the surrounder: no such cell) hunter and surrounder walk on in one direction
for 12 steps, the others but still walk at random. Near is counted in moves.
"""

CHANNELS = 3

_MAX_FOV = 255  # as in a world
_MAX_LAYER = 2**20


@dataclass(frozen=True)
class Network:
    """A multilayer perceptron from one agent's view to its action.

    hidden: sizes of the hidden layers; may be empty
    activation: of the hidden layers, "relu" or "tanh"
    fov: side of the view; the input is the view flattened, 3 * fov * fov numbers
    n_actions: outputs, 5 or 9
    sampled: draw the action from the softmax of the outputs, or take the (first) largest

    A genome is flat float32: layer by layer the weights, ``(inputs, outputs)`` row by row, and
    then the biases.

    Raises ValueError for sizes below 1 or above 2**20, an even fov, or another activation;
    TypeError for values of a wrong type.
    """

    hidden: tuple[int, ...] = (32,)
    activation: Literal["relu", "tanh"] = "relu"
    fov: int = 11
    n_actions: int = 5
    sampled: bool = True

    def __post_init__(self) -> None:
        if not isinstance(self.hidden, Iterable):
            raise TypeError(f"hidden: expected a sequence of ints, got {self.hidden!r}")
        sizes = tuple(check_integer("hidden", size, 1, _MAX_LAYER) for size in self.hidden)
        object.__setattr__(self, "hidden", sizes)
        object.__setattr__(self, "fov", check_integer("fov", self.fov, 1, _MAX_FOV))
        object.__setattr__(self, "n_actions", check_integer("n_actions", self.n_actions))
        if self.fov % 2 == 0:
            raise ValueError(f"fov: expected an odd number, got {self.fov}")
        if self.n_actions not in (5, 9):
            raise ValueError(f"n_actions: expected 5 or 9, got {self.n_actions}")
        check_bool("sampled", self.sampled)
        if self.activation not in ("relu", "tanh"):
            raise ValueError(f"activation: expected 'relu' or 'tanh', got {self.activation!r}")

    @classmethod
    def for_config(
        cls, config: WorldConfig, hidden: tuple[int, ...] = (32,), **more: Any
    ) -> Network:
        """The network that fits a world's views and actions."""
        return cls(hidden, fov=config.fov, n_actions=config.n_actions, **more)

    @property
    def sizes(self) -> tuple[int, ...]:
        """Inputs, hidden layers, actions."""
        return (CHANNELS * self.fov**2, *self.hidden, self.n_actions)

    @property
    def genome_size(self) -> int:
        """Numbers in a genome."""
        return sum((n_in + 1) * n_out for n_in, n_out in pairwise(self.sizes))

    def layers(
        self, genome: NDArray[np.float32]
    ) -> list[tuple[NDArray[np.float32], NDArray[np.float32]]]:
        """Weights ``(inputs, outputs)`` and biases ``(outputs,)`` of each layer, as views.

        Raises ValueError for a genome of another length.
        """
        if genome.shape != (self.genome_size,):
            raise ValueError(f"genome: expected shape {(self.genome_size,)}, got {genome.shape}")
        layers, start = [], 0
        for n_in, n_out in pairwise(self.sizes):
            middle, end = start + n_in * n_out, start + (n_in + 1) * n_out
            layers.append((genome[start:middle].reshape(n_in, n_out), genome[middle:end]))
            start = end
        return layers

    def logits(self, genome: NDArray[np.float32], views: NDArray[np.uint8]) -> NDArray[np.float32]:
        """Outputs ``(n, n_actions)`` float32 for views ``(n, 3, fov, fov)``, in NumPy.

        Raises ValueError for views or a genome of another shape.
        """
        expected = (CHANNELS, self.fov, self.fov)
        if views.shape[1:] != expected:
            raise ValueError(f"views: expected shape (n, {str(expected)[1:]}, got {views.shape}")
        x = views.reshape(len(views), -1).astype(np.float32)
        *hidden, last = self.layers(genome)
        for weights, bias in hidden:
            x = x @ weights + bias
            x = np.maximum(x, 0) if self.activation == "relu" else np.tanh(x)
        return x @ last[0] + last[1]

    def initial(
        self, rng: np.random.Generator, weight: float = 0.05, head: float = 0.1
    ) -> NDArray[np.float32]:
        """A random genome: hidden weights N(0, weight), last layer N(0, head), biases 0."""
        genome = np.zeros(self.genome_size, np.float32)
        layers = self.layers(genome)
        for number, (weights, _) in enumerate(layers):
            scale = head if number == len(layers) - 1 else weight
            weights[:] = scale * rng.standard_normal(weights.shape, dtype=np.float32)
        return genome

    @cached_property
    def core(self) -> _core.Network:
        """The engine's form of this network."""
        return _core.Network(
            fov=self.fov,
            hidden=list(self.hidden),
            n_actions=self.n_actions,
            activation=self.activation,
            sampled=self.sampled,
        )


@dataclass(frozen=True, eq=False)
class Population:
    """One team's candidates: genomes ``(n, genome_size)`` float32 of one network.

    A single genome ``(genome_size,)`` is taken as a population of one. Raises TypeError for
    another dtype, ValueError for another shape and for numbers that are not finite.
    """

    genomes: NDArray[np.float32]
    network: Network

    def __post_init__(self) -> None:
        if not isinstance(self.network, Network):
            raise TypeError(f"network: expected a Network, got {self.network!r}")
        genomes = np.atleast_2d(self.genomes)
        if genomes.dtype != np.float32:
            raise TypeError(f"genomes: expected dtype float32, got {genomes.dtype}")
        expected = (len(genomes), self.network.genome_size)
        if genomes.shape != expected or len(genomes) == 0:
            raise ValueError(
                f"genomes: expected shape (n >= 1, {expected[1]}), got {np.shape(self.genomes)}"
            )
        if not np.isfinite(genomes).all():
            genome, gene = np.argwhere(~np.isfinite(genomes))[0]
            raise ValueError(
                f"genomes: expected finite numbers, got {genomes[genome, gene]} "
                f"(genome {genome}, number {gene})"
            )
        object.__setattr__(self, "genomes", np.ascontiguousarray(genomes))


TeamPolicy: TypeAlias = Population | Script
"""Who plays for a team."""


def check_team(name: str, team: TeamPolicy) -> Any:
    """The engine's form of a team.

    Raises TypeError for another type, ValueError for an unknown script.
    """
    if isinstance(team, Population):
        return team.network.core, team.genomes
    if not isinstance(team, str):
        raise TypeError(f"{name}: expected a Population or the name of a script, got {team!r}")
    if team not in SCRIPTS:
        raise ValueError(f"{name}: expected one of {', '.join(SCRIPTS)}, got {team!r}")
    return team
