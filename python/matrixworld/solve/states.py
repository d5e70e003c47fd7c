"""All states of a small world, and how much memory they take."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import cached_property
from math import comb, log10, prod

import numpy as np
from numpy.typing import NDArray

from matrixworld import _core
from matrixworld._core import Capture, Interaction, Outcome
from matrixworld._util.checks import (
    OutOfMemoryError,
    available_memory,
    check_instance,
    check_threads,
)
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import Team, TeamPolicy, check_team

_MOST_BYTES = 2**34
"""What is refused where nobody knows how much memory there is."""
_INDEX = 4
"""Bytes of a state's number."""


class States:
    """All states of a small world that its episodes reach, and what joint actions lead to.

    A state is a moment before a turn. It says where the agents are, who is gone, and which evaders
    count as captured. Members of a team that act at once are sorted by their cells, because their
    numbers cannot matter; agents that act one at a time keep their numbers. The engine's own worlds
    play every joint action in every state.

    Each turn of a round has its own states, numbered from 0: there is one turn where all agents
    move at once. States 0 to E are ends: k stands for all ends of an episode with k captured
    evaders. The others can be reached from starts on distinct free cells.

    A joint action of n members that act is one number, whose digits to the base `n_actions` are
    their actions, the first member's the highest. A team that does not act in a turn has one, 0.

    Parameters
    ----------
    config : WorldConfig
        The world. Its `max_steps`, views and rewards do not matter here.
    threads : int, optional
        Threads, by default all cores. The result does not depend on it.

    Attributes
    ----------
    config : WorldConfig
        The world.
    n_turns : int
        Turns of a round.
    starts : ndarray of int32, shape (n,)
        States of the first turn in which an episode can start, all equally likely.

    Raises
    ------
    ValueError
        If obstacles are drawn at each reset; OutOfMemoryError, a ValueError, if the states do not
        fit into memory.

    Examples
    --------
    >>> from matrixworld import WorldConfig
    >>> from matrixworld.solve import States
    >>> states = States(WorldConfig("O", rows=3, cols=3, n_pursuers=1, n_evaders=1))
    >>> states.count(), states.starts.size, states.successors().shape
    (74, 72, (74, 5, 5))
    """

    def __init__(self, config: WorldConfig, *, threads: int | None = None) -> None:
        check_instance("config", config, WorldConfig)
        self.config, self.threads = config, check_threads(threads)
        if config.density:
            raise ValueError(
                "obstacles: expected none or a map, got obstacles that each episode draws anew"
            )
        _check_size(config)
        self.core = _core.States(config.setup, self.threads)
        self.n_turns = self.core.n_turns()
        self.starts = self.core.starts()

    @classmethod
    def of(cls, world: WorldConfig | States) -> States:
        """Return the states of a world, or what already are states."""
        return world if isinstance(world, States) else cls(world)

    def __repr__(self) -> str:
        """Return the size."""
        return f"States({self.count():,} states)"

    @property
    def n_ends(self) -> int:
        """How many of the states of each turn are ends: E + 1."""
        return self.config.n_evaders + 1

    @property
    def total(self) -> int:
        """The number of states of all turns together."""
        return sum(map(self.count, range(self.n_turns)))

    def count(self, turn: int = 0) -> int:
        """Return the number S of the states of a turn."""
        return len(self.successors(turn))

    def successors(self, turn: int = 0) -> NDArray[np.int32]:
        """Return states of the next turn, int32 (S, P, Q), for P and Q joint actions of the teams.

        After the last turn of a round they are states of the first. An end leads to itself. The
        array is read-only: it is the engine's own.
        """
        return self.core.successors(turn)

    def cells(self, turn: int = 0) -> NDArray[np.int32]:
        """Return the cells of the agents, int32 (S, A), as row * cols + col; -1 for gone ones."""
        return self.core.describe(turn)[0]

    def captured(self, turn: int = 0) -> NDArray[np.bool_]:
        """Return which evaders count as captured, bool (S, E), sorted as the cells are."""
        return self.core.describe(turn)[1]

    @cached_property
    def payoffs(self) -> NDArray[np.float64]:
        """Capture rate (S,) of an episode that is over in a state of the first turn."""
        return np.asarray(self.captured().mean(axis=1), np.float64)

    def decisions(self, policy: TeamPolicy, team: Team) -> tuple[NDArray[np.float64], ...]:
        """Return the probabilities with which a policy plays, for each turn (S, its joint actions).

        Members decide independently of each other. The softmax of a network's outputs is computed
        in float64; the engine draws with 24 bits. ValueError if a script sees nothing that it looks
        for in some state, and so walks on as before.
        """
        plain, evaders = check_team("champion", policy), team == "evader"
        return tuple(
            self.core.weigh(turn, evaders, plain, self.threads) for turn in range(self.n_turns)
        )


def size_of(config: WorldConfig) -> tuple[int, int]:
    """Return at most how many states of all turns there are, and the bytes of their successors."""
    sizes = list(_turns(config))
    places = (1 + config.rows * config.cols, 2 + 2 * config.rows * config.cols)
    codes = prod(n**k for n, k in zip(places, (config.n_pursuers, config.n_evaders), strict=True))
    joint = sum(count * actions for count, actions in sizes)
    return sum(count for count, _ in sizes), _INDEX * (joint + codes * len(sizes))


def _turns(config: WorldConfig) -> Iterator[tuple[int, int]]:
    """Yield the number of states and of joint actions of each turn."""
    rules = config.rules
    free = config.rows * config.cols
    if config.map is not None and rules.obstacle is not Outcome.REACH:
        free -= int(config.map.sum())
    dies = Outcome.DISAPPEAR in (rules.obstacle, rules.teammate, rules.pursuer)
    lives_on = rules.capture is Capture.SURROUND or rules.evader is Outcome.REACH
    one_by_one = rules.interaction is Interaction.AGENT_TURNS
    teams = ((free + dies, config.n_pursuers), (free * (1 + lives_on) + 2, config.n_evaders))
    count = prod(n**k if one_by_one else comb(n + k - 1, k) for n, k in teams)
    together = rules.interaction is Interaction.SIMULTANEOUS
    acting = [config.n_agents] if together else [config.n_pursuers, config.n_evaders]
    for n in [1] * config.n_agents if one_by_one else acting:
        yield count, config.n_actions**n


def _check_size(config: WorldConfig) -> None:
    """Raise OutOfMemoryError unless the states fit into memory, and say which board would."""
    available = available_memory() or _MOST_BYTES
    count, needed = size_of(config)
    if needed <= available:
        return
    sides = range(min(config.rows, config.cols) - 1, 1, -1)
    boards = (
        side
        for side in sides
        if side**2 >= config.n_agents
        and size_of(replace(config, rows=side, cols=side, obstacles=0.0))[1] <= available
    )
    side = next(boards, None)
    would = "no smaller board would" if side is None else f"{side} x {side} cells would fit"
    raise OutOfMemoryError(
        f"states: expected at most {available / 10**9:,.1f} GB, got about {_rounded(count)} states "
        f"and {_rounded(needed // 10**9)} GB for {config.n_pursuers} against {config.n_evaders} "
        f"agents on {config.rows} x {config.cols} cells; {would}"
    )


def _rounded(number: int) -> str:
    """Return a number, or which power of ten it is, if nobody would read its digits."""
    return f"{number:,}" if number < 10**12 else f"10^{int(log10(number))}"
