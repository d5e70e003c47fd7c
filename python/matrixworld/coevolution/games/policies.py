"""What decides for the agents of a team: the settings of policies, one class for each kind."""

from __future__ import annotations

from abc import abstractmethod
from typing import Any, TypeAlias

from matrixworld._util.constraints import Constraint, OneOf, Whole
from matrixworld._util.sections import Section, section, setting
from matrixworld.coevolution.types import TEAMS, Genome, Rng, Team
from matrixworld.world import masks
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import GATES, Network, Policy
from matrixworld.world.program import Program
from matrixworld.world.rating import INPUTS, Rating


def _mask(default: str, more: str = "") -> Any:
    return setting(
        default,
        "moves that a policy never chooses: obstacles (into an obstacle or the border; needs a "
        "world.fov of 3), right-of-way (all that could put it at fault; needs a world.fov of 5 and "
        f"rules under which pursuers that learn can capture so), or none{more}",
        OneOf(masks.MASKS),
    )


Inputs: TypeAlias = tuple[str | tuple[str, ...], ...]
"""Names of both teams' inputs, or two tuples of names, the pursuers' and the evaders'."""


class _InputsOfTeams(Constraint):
    """Names of inputs, of both teams or of each."""

    def expected(self, value: Any) -> str:
        """Return in words what was expected in place of a value; empty if the value fits."""
        if all(map(_are_inputs, value if _is_pair(value) else (value,))):
            return ""
        return (
            f"a sequence of different ones of {', '.join(INPUTS)}; or two, the pursuers' and the "
            "evaders'"
        )


def _is_pair(value: Any) -> bool:
    is_tuple = isinstance(value, tuple)
    return is_tuple and len(value) == 2 and all(isinstance(part, tuple) for part in value)


def _are_inputs(value: Any) -> bool:
    if not isinstance(value, tuple) or not all(isinstance(name, str) for name in value):
        return False
    return 0 < len(value) == len(set(value)) and INPUTS.keys() >= set(value)


def _inputs() -> Any:
    text = f"inputs: some of {', '.join(INPUTS)}; or two sequences, the pursuers' and the evaders'"
    return setting(Rating.inputs, text, _InputsOfTeams())


def inputs_of(team: Team, inputs: Inputs) -> Inputs:
    """Return the names of a team's inputs."""
    return inputs[TEAMS.index(team)] if _is_pair(inputs) else inputs  # type: ignore[return-value]


@section()
class PolicySettings(Section):
    """Base of the settings of policies: both teams have policies of one kind."""

    mask: str = _mask("none")

    @abstractmethod
    def policy(self, world: WorldConfig, team: Team) -> Policy:
        """Return the shape of a team's policies in a world."""

    @abstractmethod
    def initial(self, policy: Any, rng: Rng) -> Genome:
        """Return an untrained genome of a policy of this shape."""

    def fixed(self, world: WorldConfig, team: Team) -> masks.FixedWeights | None:
        """Return genes that do not change, and their values; None without any."""
        return None


@section("cells")
class Cells(PolicySettings):
    """Networks that see the cells of the view."""

    hidden: tuple[int, ...] = setting((32,), "sizes of the hidden layers")
    activation: str = setting(
        "relu", "activation of the hidden layers: relu or tanh", OneOf(("relu", "tanh"))
    )
    memory: str = setting(
        "none",
        "recurrent layer after the first hidden layer: gru (gated recurrent units) or none",
        OneOf(tuple(GATES)),
    )
    initial_weight: float = setting(0.05, "standard deviation of untrained hidden weights")
    initial_head: float = setting(0.1, "standard deviation of untrained output weights")
    mask: str = _mask("none", "; not with every learner")

    def policy(self, world: WorldConfig, team: Team) -> Network:
        """Return the network, with room for its mask."""
        shape: Any = {"activation": self.activation, "memory": self.memory}
        network = Network.for_config(world, self.hidden, **shape)
        return network if self.mask == "none" else masks.masked_network(network)

    def initial(self, policy: Network, rng: Rng) -> Genome:
        """Return untrained weights."""
        return policy.initial(rng, weight=self.initial_weight, head=self.initial_head)

    def fixed(self, world: WorldConfig, team: Team) -> masks.FixedWeights | None:
        """Return the weights of the mask of a team's network, None without a mask."""
        if self.mask == "none":
            return None
        cells = masks.forbidding_cells(world, self.mask, team)
        return masks.mask_weights(self.policy(world, team), cells)


@section("rating")
class Ratings(PolicySettings):
    """Small networks that rate each move by named inputs of the cell that it leads to."""

    inputs: Inputs = _inputs()
    hidden: tuple[int, ...] = setting((), "sizes of the hidden layers; none: a weighted sum")
    initial_weight: float = setting(0.5, "standard deviation of untrained weights")
    mask: str = _mask("obstacles")

    def policy(self, world: WorldConfig, team: Team) -> Rating:
        """Return the shape of a team's ratings."""
        inputs = inputs_of(team, self.inputs)
        shape: Any = {"inputs": inputs, "hidden": self.hidden, "mask": self.mask}
        return Rating(fov=world.fov, n_actions=world.n_actions, **shape)

    def initial(self, policy: Rating, rng: Rng) -> Genome:
        """Return untrained weights."""
        return policy.initial(rng, weight=self.initial_weight)


@section("program")
class Programs(PolicySettings):
    """Programs that rate each move by named inputs of the cell that it leads to."""

    inputs: Inputs = _inputs()
    length: int = setting(40, "most instructions of a program", Whole(1))
    initial_depth: int = setting(3, "most levels of an untrained program")
    mask: str = _mask("obstacles")

    def policy(self, world: WorldConfig, team: Team) -> Program:
        """Return the shape of a team's programs."""
        inputs = inputs_of(team, self.inputs)
        shape: Any = {"inputs": inputs, "length": self.length, "mask": self.mask}
        return Program(fov=world.fov, n_actions=world.n_actions, **shape)

    def initial(self, policy: Program, rng: Rng) -> Genome:
        """Return an untrained program."""
        return policy.initial(rng, depth=self.initial_depth)
