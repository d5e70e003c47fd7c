"""All states of a small world."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from itertools import count
from math import comb, inf, isqrt
from typing import Any

import numpy as np
from numpy.typing import NDArray

from matrixworld import _core
from matrixworld._core import Capture, Interaction, Outcome
from matrixworld._util import checks
from matrixworld.world.arrays import CHANNEL
from matrixworld.world.config import WorldConfig
from matrixworld.world.masks import check_team
from matrixworld.world.policy import CHANNELS, TEAMS, Team

_MOST_BYTES = 2**31
"""More states would take hours to solve, wherever they fit."""
_MOST_AGENTS = 31
"""More have no 2**31 joint places, which the engine numbers."""
STRIDE = 12
"""Steps for which an agent keeps the direction that the input ``ahead`` names."""
_NO_MATTER = ("max_steps", "fov", "rewards")
"""Settings of a world that do not change its states."""
_INDEX = 4
"""Bytes of a state's number."""


class States:
    """All states of a small world that its episodes reach, and what joint actions lead to.

    A state is a moment before a turn. It says where the agents are, who is gone, and which evaders
    count as captured. Members of a team that act at once are sorted by their cells, because their
    numbers cannot matter; agents that act one at a time keep their numbers, and so do all agents of
    `numbered` states. The engine's own worlds play every joint action in every state.

    Each turn of a round has its own states, numbered from 0: there is one turn where all agents
    move at once. States 0 to E are ends: k stands for all ends of an episode with k captured
    evaders. The others can be reached from starts on distinct free cells.

    A joint action of n members that act is one number, whose digits to the base `n_actions` are
    their actions, the first member's the highest. A team that does not act in a turn has one, 0.

    Parameters
    ----------
    config : WorldConfig
        The world. Its `max_steps`, `fov` and `rewards` do not matter here.
    numbered : bool, optional
        Whether members of a team that act at once keep their numbers, too, which those need who
        remember something. There are more states then.
    threads : int, optional
        Threads, by default all cores. The result does not depend on it.
    report : callable, optional
        Called several times a second with what is being computed, of these states or from them, and
        the share of it that is done.

    Attributes
    ----------
    n_turns : int
        Turns of a round.
    starts : ndarray of int32, shape (n,)
        States of the first turn in which an episode can start, all equally likely.

    Raises
    ------
    ValueError
        If obstacles are drawn at each reset, and if the states would take more than 2 GB.
    """

    def __init__(
        self,
        config: WorldConfig,
        *,
        numbered: bool = False,
        threads: int | None = None,
        report: Callable[[str, float], None] | None = None,
    ) -> None:
        checks.check_instance("config", config, WorldConfig)
        self.config = config
        self.numbered = checks.check_bool("numbered", numbered)
        self.threads = checks.check_threads(threads)
        self.report = report
        if got := why_not_solved(config, numbered=numbered):
            most = f"states: expected at most {_MOST_BYTES / 10**9:,.1f} GB"
            expected = "obstacles: expected none or a map" if config.density else most
            raise ValueError(f"{expected}, got {got}")
        report_states = self.reporter("states")
        self.core = _core.States(
            config.setup, self.threads, _count(config, numbered), report_states, numbered
        )
        self.n_turns = self.core.n_turns()
        self.starts = self.core.starts()

    @classmethod
    def of(cls, world: WorldConfig | States) -> States:
        """Return the states of a world, or what already are states."""
        return world if isinstance(world, States) else cls(config_of(world))

    def has_states_of(self, config: WorldConfig) -> bool:
        """Return whether a world has these states, with the same numbers."""
        if config is self.config:
            return True
        own, others = self.config.to_json(), config.to_json()
        for name in _NO_MATTER:
            del own[name], others[name]
        return own == others

    def __repr__(self) -> str:
        return f"States({self.count():,} states)"

    @property
    def total(self) -> int:
        """The number of states of all turns together."""
        return sum(map(self.count, range(self.n_turns)))

    def reporter(self, what: str, part: int = 0, parts: int = 1) -> Callable[[float], None] | None:
        """Return a function that tells `report` the share of a part of some work; None without."""
        report = self.report
        if report is None:
            return None
        return lambda share: report(what, (part + share) / parts)

    def count(self, turn: int = 0) -> int:
        """Return the number S of the states of a turn."""
        return len(self.successors(turn))

    def successors(self, turn: int = 0) -> NDArray[np.int32]:
        """Return states of the next turn, int32 (S, P, Q), for P and Q joint actions of the teams.

        After the last turn of a round they are states of the first. An end leads to itself. The
        array is read-only: it is the engine's own.
        """
        return self.core.successors(checks.check_integer("turn", turn, 0, self.n_turns - 1))

    def cells(self, turn: int = 0) -> NDArray[np.int32]:
        """Return the cells of the agents, int32 (S, A), as row * cols + col; -1 for gone ones."""
        return self.core.describe(checks.check_integer("turn", turn, 0, self.n_turns - 1))[0]

    def captured(self, turn: int = 0) -> NDArray[np.bool_]:
        """Return which evaders count as captured, bool (S, E), sorted as the cells are."""
        return self.core.describe(checks.check_integer("turn", turn, 0, self.n_turns - 1))[1]

    def members(self, turn: int, team: Team) -> list[int]:
        """Return the agents of a team that act in a turn, in the order of the states."""
        checks.check_choice("team", team, TEAMS)
        acting = _actors(self.config)[checks.check_integer("turn", turn, 0, self.n_turns - 1)]
        pursuers = range(self.config.n_pursuers)
        return [agent for agent in acting if (agent in pursuers) == (team == "pursuer")]

    def views(self, team: Team) -> tuple[NDArray[np.uint8], list[NDArray[np.intp]]]:
        """Return all that members of a team see when they act.

        Parameters
        ----------
        team : {"pursuer", "evader"}
            The team.

        Returns
        -------
        views : ndarray of uint8, shape (n, 3, fov, fov)
            The different views, as `World.views` returns them.
        places : list of ndarray of int, shape (S, members that act)
            By turn, the place in `views` of what each member sees; -1 for gone ones.
        """
        checks.check_choice("team", team, TEAMS)
        packed: list[NDArray[np.uint8]] = []
        places: list[NDArray[np.intp]] = []
        for turn in range(self.n_turns):
            cells = self.cells(turn)
            members = self.members(turn, team)
            places.append(np.full((len(cells), len(members)), -1, np.intp))
            for agent in members:
                seen = self._seen(cells[cells[:, agent] >= 0], agent)
                packed.append(np.packbits(seen.reshape(len(seen), -1), axis=1))
        different, inverse = np.unique(np.concatenate(packed), axis=0, return_inverse=True)
        numbers = iter(np.split(inverse.ravel(), np.cumsum([len(each) for each in packed])[:-1]))
        for turn, of_turn in enumerate(places):
            cells = self.cells(turn)
            for column, agent in enumerate(self.members(turn, team)):
                of_turn[cells[:, agent] >= 0, column] = next(numbers)
        side = self.config.fov
        flat = np.unpackbits(different, axis=1, count=CHANNELS * side * side)
        return flat.reshape(-1, CHANNELS, side, side), places

    def inputs(
        self, team: Team, places: list[NDArray[np.intp]], step: int = 0
    ) -> NDArray[np.float32]:
        """Return the named inputs of moves for each different view of a team.

        Parameters
        ----------
        team : {"pursuer", "evader"}
            The team.
        places : list of ndarray of int, shape (S, members that act)
            Those of `views`.
        step : int, optional
            How many steps have been played. Only ``must_yield`` depends on it.

        Returns
        -------
        ndarray of float32, shape (n, n_actions, inputs)
            As `World.inputs` returns them; ``ahead`` and ``search``, which each episode draws, are
            those of some episode.
        """
        n = 1 + max(int(of_turn.max(initial=-1)) for of_turn in places)
        found = np.empty((n, self.config.n_actions, len(_core.inputs())), np.float32)
        for turn, of_turn in enumerate(places):
            for column, agent in enumerate(self.members(turn, team)):
                numbers, at = np.unique(of_turn[:, column], return_index=True)
                states = at[numbers >= 0].astype(np.int32)
                found[numbers[numbers >= 0]] = self.core.look(turn, agent, step, 0, states)
        return found

    def _seen(self, cells: NDArray[np.int32], observer: int) -> NDArray[np.uint8]:
        """Return the views, (n, 3, fov, fov), of a living agent in states with these cells."""
        config = self.config
        middle = config.fov // 2
        walls = np.zeros((config.rows, config.cols), np.uint8)
        if config.map is not None:
            walls[:] = config.map
        padded = np.pad(walls, middle, constant_values=1)
        windows = np.lib.stride_tricks.sliding_window_view(padded, (config.fov, config.fov))
        rows, cols = np.divmod(cells, config.cols)
        views = np.zeros((len(cells), CHANNELS, config.fov, config.fov), np.uint8)
        views[:, CHANNEL["obstacle"]] = windows[rows[:, observer], cols[:, observer]]
        for other in range(config.n_agents):
            if other == observer:
                continue
            row = rows[:, other] - rows[:, observer] + middle
            col = cols[:, other] - cols[:, observer] + middle
            inside = (row >= 0) & (row < config.fov) & (col >= 0) & (col < config.fov)
            [at] = np.nonzero(inside & (cells[:, other] >= 0))
            channel = CHANNEL["pursuer" if other < config.n_pursuers else "evader"]
            views[at, channel, row[at], col[at]] = 1
        return views

    def decisions(
        self, policy: Any, team: Team, step: int = 0, episode: int | None = None
    ) -> tuple[NDArray[np.float64], ...]:
        """Return the probabilities with which a policy plays, for each turn (S, its joint actions).

        `policy` is what the engine plays without memory: a script's name, a population of one or
        its genome. Members decide independently of each other, by the softmax of a network in
        float64. `step` steps have been played; see `counts_steps`. ValueError if a script sees
        nothing that it looks for in some state, and so walks on, or if each episode draws something
        that the policy reads, and no number of an `episode` is given; see `strides`.
        """
        checks.check_choice("team", team, TEAMS)
        player = check_team("champion", policy, self.config, team)
        if episode is None and self.core.draws_strides(player):
            raise ValueError(
                "champion: expected one that decides by what it sees and by the step, got one that "
                "reads ahead, a direction that each agent draws in an episode"
            )
        decisions = []
        for turn in range(self.n_turns):
            report = self.reporter("play", turn, self.n_turns)
            decisions.append(
                self.core.weigh(
                    turn, team == "evader", player, step, episode or 0, self.threads, report
                )
            )
        return tuple(decisions)

    def counts_steps(self, policy: Any, team: Team) -> bool:
        """Return whether `decisions` of a policy differ from step to step, as by right of way."""
        return self.core.counts_steps(check_team("champion", policy, self.config, team))

    def draws_strides(self, policy: Any, team: Team) -> bool:
        """Return whether a policy reads ``ahead``, the direction that each agent draws."""
        return self.core.draws_strides(check_team("champion", policy, self.config, team))

    def strides(self, team: Team) -> list[int]:
        """Return numbers of episodes in which a team's agents draw each of their directions once.

        All ways in which they can draw them in the first `STRIDE` steps are equally likely. The
        agents need their numbers: see `numbered`.
        """
        pursuers = range(self.config.n_pursuers)
        agents = pursuers if team == "pursuer" else range(len(pursuers), self.config.n_agents)
        ahead = [name for name, *_ in _core.inputs()].index("ahead")
        start = self.starts[:1]
        episodes: dict[tuple[int, ...], int] = {}
        for episode in count(0):
            looks = (self.core.look(0, agent, 0, episode, start) for agent in agents)
            drawn = tuple(int(look[0, :, ahead].argmax()) for look in looks)
            episodes.setdefault(drawn, episode)
            if len(episodes) == (self.config.n_actions - 1) ** len(agents):
                return sorted(episodes.values())
        raise AssertionError("episodes end")  # they do not


def config_of(world: WorldConfig | States) -> WorldConfig:
    """Return the settings of a world or of states; TypeError for anything else."""
    config = world.config if isinstance(world, States) else world
    checks.check_instance("world", config, WorldConfig)
    return config


def _actors(config: WorldConfig) -> list[range]:
    """Return the agents that act in each turn of a round."""
    every = range(config.n_agents)
    return {
        Interaction.SIMULTANEOUS: [every],
        Interaction.SWARM_TURNS: [every[: config.n_pursuers], every[config.n_pursuers :]],
        Interaction.AGENT_TURNS: [every[agent : agent + 1] for agent in every],
    }[config.rules.interaction]


def _count(config: WorldConfig, numbered: bool = False) -> int:
    """Return about how many states a turn has, a few more than there are.

    An agent is on a cell or gone, an evader captured or not. All ends are one state, so that in the
    others an evader is alive and not captured.
    """
    rules, cells = config.rules, config.rows * config.cols
    if config.map is not None and rules.obstacle is not Outcome.REACH:
        cells -= int(config.map.sum())
    surround = rules.capture is Capture.SURROUND
    meet = rules.evader is rules.pursuer is Outcome.REACH
    die = Outcome.DISAPPEAR in (rules.obstacle, rules.teammate)
    lost = die or (rules.evader is Outcome.DISAPPEAR and (surround or not rules.captures))
    caught = rules.removes_captured or (meet and die) or (surround and lost)
    # Where contact captures and all live on, who was captured is remembered; else places tell.
    memories = 2**config.n_evaders - 1 if meet and not surround else 1
    pursuer = cells + (die or rules.pursuer is Outcome.DISAPPEAR)
    evader = cells + lost + caught

    def ways(places: int, agents: int) -> int:
        in_order = numbered or rules.interaction is Interaction.AGENT_TURNS
        return places**agents if in_order else comb(places + agents - 1, agents)

    placed = ways(pursuer, config.n_pursuers) * ways(evader, config.n_evaders)
    return config.n_evaders + 1 + placed * memories


def states_size(config: WorldConfig) -> tuple[float, float]:
    """Return about how many states of all turns a world has, and their bytes.

    Both are infinity if nobody can number the states.
    """
    return _size(config)


def _size(config: WorldConfig, numbered: bool = False) -> tuple[float, float]:
    """Return about how many states of all turns there are, and how many bytes they take."""
    cells, n, m = config.rows * config.cols, config.n_pursuers, config.n_evaders
    codes = (1 + cells) ** n * (2 + 2 * cells) ** m if n + m <= _MOST_AGENTS else inf
    if codes > checks.INT_MAX:  # the engine numbers them
        return inf, inf
    count = _count(config, numbered)
    joint_actions = [config.n_actions ** len(actors) for actors in _actors(config)]
    numbers = sum(count * (joint + 1) + codes for joint in joint_actions) + count  # and the starts
    return count * len(joint_actions), _INDEX * numbers


def why_not_solved(config: WorldConfig, *, numbered: bool = False) -> str:
    """Return why the states of a world cannot be listed, with their size; empty if they can."""
    agents = f"{config.n_pursuers} against {config.n_evaders} agents"
    board = f"{agents} on {config.rows} x {config.cols} cells"
    if config.density:
        return f"obstacles that each episode draws anew, for {board}"
    count, needed = _size(config, numbered)
    if needed <= _MOST_BYTES:
        return ""
    most = isqrt(config.rows * config.cols) if config.n_agents <= _MOST_AGENTS else 0
    sides = range(most, isqrt(config.n_agents), -1)
    boards = (replace(config, rows=side, cols=side, obstacles=0.0) for side in sides)
    fitting = (board.rows for board in boards if _size(board, numbered)[1] <= _MOST_BYTES)
    largest = next(fitting, None)
    would = f"{largest} x {largest} cells would fit" if largest else "no smaller board would fit"
    size = f"about {count:,} states and {needed / 10**9:,.1f} GB"
    return f"{size if count < inf else 'more than 2^31 joint places'} for {board}; {would}"
