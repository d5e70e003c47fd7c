# The engine. Sizes: W worlds, A agents (pursuers first), E evaders, M matches, T steps.
# Wrong values raise ValueError, wrong types TypeError.

from collections.abc import Callable, Sequence
from enum import Enum
from typing import Any, TypeAlias, type_check_only

import numpy as np
from numpy.typing import NDArray

_Integers: TypeAlias = NDArray[np.uint8 | np.int8 | np.int32 | np.int64]
_Map: TypeAlias = NDArray[np.uint8] | None  # (rows, cols), 1 for an obstacle
_Positions: TypeAlias = NDArray[np.int32] | None  # (n, 2) rows and columns
_ByTeam: TypeAlias = tuple[float, float]  # the pursuers' and the evaders'
_ByKind: TypeAlias = tuple[float, float, float]  # with an obstacle, a teammate, an adversary
_Genomes: TypeAlias = tuple[Network | Rating, NDArray[np.float32]]
_Candidates: TypeAlias = _Genomes | Tables | str  # a script's name
_Report: TypeAlias = Callable[[float], None] | None
# turn, kind, form, first agent, second agent or -1, cell; at fault, held and doomed as bits, of
# which bit 0 is the first agent's and bit 1 the second's
_Conflict: TypeAlias = tuple[int, int, int, int, int, tuple[int, int], int, int, int]

# Name, dtype, names of axes, and "moment", "step", "step start" or "episode end".
_OutputField: TypeAlias = tuple[str, np.dtype[Any], tuple[str, ...], str]

@type_check_only
class _Pybind11Type(type): ...  # pybind11's metaclass, which cannot be imported

class Outcome(Enum):
    """What a collision does to an agent."""

    __pybind11_native_enum__: object
    DISAPPEAR = 0
    REACH = 1
    BOUNCE = 2

class Interaction(Enum):
    """Which agents move at the same time."""

    __pybind11_native_enum__: object
    SIMULTANEOUS = 0
    SWARM_TURNS = 1
    AGENT_TURNS = 2

class Capture(Enum):
    """How an evader is captured."""

    __pybind11_native_enum__: object
    OCCUPATION = 0
    SURROUND = 1

class Blame(Enum):
    """Which agents pay for a collision."""

    __pybind11_native_enum__: object
    FAULT = 0
    INVOLVED = 1

class Autoreset(Enum):
    """What becomes of an ended world."""

    __pybind11_native_enum__: object
    DISABLED = 0
    NEXT_STEP = 1
    SAME_STEP = 2

class Rules(metaclass=_Pybind11Type):
    """The rules of a game."""

    def __init__(
        self,
        *,
        interaction: Interaction,
        obstacle: Outcome,
        teammate: Outcome,
        evader: Outcome,
        pursuer: Outcome,
        capture: Capture,
        captured_disappear: bool,
    ) -> None: ...

class Rewards(metaclass=_Pybind11Type):
    """The rewards."""

    def __init__(
        self,
        *,
        capture: _ByTeam,
        neighbor: _ByTeam,
        collide: tuple[_ByKind, _ByKind],
        step: _ByTeam,
        blame: Blame,
        capture_repeats: bool,
    ) -> None: ...

class Setup(metaclass=_Pybind11Type):
    """What all worlds of a configuration share."""

    def __init__(
        self,
        *,
        rules: Rules,
        rewards: Rewards,
        rows: int,
        cols: int,
        n_pursuers: int,
        n_evaders: int,
        fov: int,
        diagonal: bool,
        max_steps: int,
        density: float,
        map: _Map,
    ) -> None: ...
    def axis_sizes(self) -> dict[str, int]:
        """Sizes of the axes of output fields, by the names of axes."""

class Network(metaclass=_Pybind11Type):
    """The shape of a policy network; `hidden` are the sizes of its hidden layers."""

    def __init__(
        self,
        *,
        fov: int,
        hidden: Sequence[int],
        n_actions: int,
        activation: str,
        sampled: bool,
        memory: str,
    ) -> None: ...

class Rating(metaclass=_Pybind11Type):
    """The shape of policies that rate moves by a network, or by a program of a `length`."""

    def __init__(
        self,
        *,
        fov: int,
        n_actions: int,
        inputs: Sequence[int],
        hidden: Sequence[int],
        length: int,
        mask: str,
    ) -> None: ...
    def genome_size(self) -> int:
        """Numbers in a genome."""

    def check(self, genomes: NDArray[np.float32]) -> None:
        """Raise ValueError if one of the genomes (n, genome_size) is no program."""

class World(metaclass=_Pybind11Type):
    """One world."""

    def __init__(self, setup: Setup) -> None: ...
    def reset(
        self, seed: int, episode: int, pursuers: _Positions, evaders: _Positions, map: _Map
    ) -> None: ...
    def step(self, actions: _Integers, explain: bool) -> None:
        """Play one round with actions (A,)."""

    def play_turn(self, actions: _Integers, explain: bool) -> None:
        """Play the next turn with actions (A,); only those of the actors are read."""

    def decide(
        self, policy: _Candidates, first: int, last: int, actions: NDArray[np.int64]
    ) -> None:
        """Write what a genome or a script chooses for agents [first, last) into actions (A,)."""

    def turn(self) -> int:
        """The number of the next turn of the round."""

    def n_turns(self) -> int:
        """The number of turns in a round."""

    def actors(self) -> tuple[int, int]:
        """The agents of the next turn, as first and one past the last."""

    def write(self, arrays: dict[str, NDArray[Any]]) -> None:
        """Fill the given arrays, named and shaped as `matrixworld.array_specs` says."""

    def conflicts(self) -> list[_Conflict]:
        """The conflicts of the last step, if it was played with `explain`."""

    def snapshot(self) -> dict[str, Any]:
        """The state of the world as plain values and arrays."""

    def restore(self, snapshot: dict[str, Any]) -> None:
        """Restore a state that `snapshot` of a world of the same setup returned."""

    def logits(self, network: Network, genome: NDArray[np.float32]) -> NDArray[np.float32]:
        """The network's outputs for the living agents, (n, n_actions)."""

class Batch(metaclass=_Pybind11Type):
    """W worlds that write into the caller's arrays."""

    def __init__(
        self,
        setup: Setup,
        n_worlds: int,
        n_threads: int,
        autoreset: Autoreset,
        buffers: dict[str, NDArray[Any]],
    ) -> None: ...
    def reset(
        self,
        seeds: NDArray[np.uint64] | None,
        episode: int,
        mask: NDArray[np.bool_] | None,
        pursuers: _Positions,
        evaders: _Positions,
        map: _Map,
    ) -> None:
        """Start an episode of seeds (W,), or the next episodes, in the worlds of mask (W,).

        Positions are (W, n, 2)."""

    def step(self, actions: _Integers) -> None:
        """Play one round with actions (W, A)."""

    def play_turn(self, actions: _Integers) -> None:
        """Play the next turn of a round with actions (W, A); those of its actors are read."""

    def turn(self) -> int: ...
    def n_turns(self) -> int: ...
    def actors(self) -> tuple[int, int]: ...
    def decide(
        self,
        policies: list[_Candidates | None],
        chosen: NDArray[np.int32],
        first: int,
        last: int,
        actions: NDArray[np.int64],
    ) -> None:
        """Write what policies[chosen[w]] chooses for agents [first, last) into actions (W, A)."""

    def snapshot(self, world: int) -> dict[str, Any]:
        """The state of one of the worlds, for `World.restore`."""

class States(metaclass=_Pybind11Type):
    """The states of a small world: S in a turn, with P and Q joint actions of the teams."""

    def __init__(
        self, setup: Setup, n_threads: int, expected: int, report: _Report, numbered: bool
    ) -> None: ...
    def n_turns(self) -> int:
        """The number of turns in a round."""

    def starts(self) -> NDArray[np.int32]:
        """The states of the first turn in which an episode starts."""

    def describe(self, turn: int) -> tuple[NDArray[np.int32], NDArray[np.bool_]]:
        """Cells (S, A), -1 for gone agents, and captured (S, E)."""

    def successors(self, turn: int) -> NDArray[np.int32]:
        """States of the next turn, (S, P, Q), read-only."""

    def weigh(
        self,
        turn: int,
        evaders: bool,
        policy: _Candidates,
        step: int,
        episode: int,
        n_threads: int,
        report: _Report,
    ) -> NDArray[np.float64]:
        """Probabilities of a team's joint actions in a step of an episode, (S, P) or (S, Q)."""

    def counts_steps(self, policy: _Candidates) -> bool:
        """Whether these probabilities differ from step to step."""

    def draws_strides(self, policy: _Candidates) -> bool:
        """Whether these probabilities differ by the directions that each episode draws."""

    def look(
        self, turn: int, agent: int, step: int, episode: int, states: NDArray[np.int32]
    ) -> NDArray[np.float32]:
        """The named inputs of an agent, (n, moves, inputs), in states in which it is alive."""

    def backup(
        self,
        turn: int,
        next: NDArray[np.float64],
        pursuers: NDArray[np.float64] | None,
        evaders: NDArray[np.float64] | None,
        chosen: bool,
        n_threads: int,
        report: _Report,
    ) -> tuple[NDArray[np.float64], float, NDArray[np.float64] | None, NDArray[np.float64] | None]:
        """Values (S,) from those of the next turn, the largest gap, and how the teams play.

        A team whose probabilities are given plays by them, another one its best."""

class Tables(metaclass=_Pybind11Type):
    """Probabilities of a team's joint actions by turn: (rounds, S, P or Q) each."""

    def __init__(
        self, states: States, evaders: bool, steps: int, by_turn: Sequence[NDArray[np.float32]]
    ) -> None: ...

def rollout(
    setup: Setup,
    pursuers: _Candidates,
    evaders: _Candidates,
    pursuer: NDArray[np.int32],
    evader: NDArray[np.int32],
    seed: NDArray[np.uint64],
    n_worlds: int,
    n_threads: int,
    one_by_one: bool = False,
) -> dict[str, NDArray[Any]]:
    """Episode statistics of M matches: arrays (M, n_worlds, ...) by name.

    With `one_by_one` worlds play one after the other also where they could play in lockstep. The
    statistics are the same: tests compare the two.
    """

def record(
    setup: Setup,
    pursuers: _Candidates,
    evaders: _Candidates,
    pursuer: int,
    evader: int,
    seed: int,
    episode: int,
    of_moments: Sequence[str],
    of_steps: Sequence[str],
) -> dict[str, NDArray[Any]]:
    """The arrays of one episode of T steps: `actions` (T, A), and world arrays by name.

    Those named in `of_moments` are (T + 1, ...), those named in `of_steps` (T, ...)."""

def world_fields() -> list[_OutputField]:
    """The arrays that worlds write, alone or in a batch."""

def batch_fields() -> list[_OutputField]:
    """The arrays that only batches write."""

def inputs() -> list[tuple[str, str, str, float]]:
    """Name, definition, unit and largest value, or 0, of each named input of a move."""

def operations() -> list[tuple[str, int]]:
    """Name and number of arguments of each operation of programs."""

def right_of_way(
    setup: Setup, evaders: bool, step: int | None = None
) -> list[list[tuple[int, int, int]]]:
    """What forbids each move by the right of way: (channel, row, column) from the agent."""

def philox(counter: Sequence[int], key: Sequence[int]) -> list[int]:
    """Four random 64-bit numbers of Philox4x64-10, from a counter (4,) and a key (2,)."""

def kernel_level() -> str:
    """The instruction set of the networks' kernels in use."""
