"""What a player does in every state of a small world."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from math import inf
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from matrixworld import _core
from matrixworld._util import checks
from matrixworld._util.callers import warn_caller
from matrixworld._util.teams import PLURALS
from matrixworld.play.draws import NotExactError
from matrixworld.play.functions import Function
from matrixworld.play.player import Plays, placed, player
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import SCRIPTS, TEAMS, Population, TablePolicy, Team
from matrixworld.world.states import States, states_size

MOST_STATES = 50_000
"""The most states of a world in which a function becomes a table by itself."""

MOST_BYTES = 2**28
"""The most bytes of its states."""
KEPT = 8
"""The most worlds of which a function keeps a table."""

Turns: TypeAlias = tuple[NDArray[np.float64], ...]
"""Probabilities of a step, for each turn (S, the team's joint actions)."""


@dataclass(frozen=True, eq=False)
class Table:
    """The probabilities with which a team plays in every state of a small world.

    Parameters
    ----------
    states : States
        The states.
    team : {"pursuer", "evader"}
        The team.
    steps : tuple of tuple of ndarray
        For each step and turn float64 (S, joint actions); a single step stands for all of them.
    """

    states: States
    team: Team
    steps: tuple[Turns, ...]

    @property
    def by_step(self) -> bool:
        """Whether each step has its own probabilities."""
        return len(self.steps) > 1

    def probabilities(self, rounds: int, turn: int = 0) -> NDArray[np.float64]:
        """Return the probabilities, float64 (S, joint actions), with so many rounds left.

        The present round is one of them. An episode has as many rounds as there are steps.
        """
        return self.steps[len(self.steps) - rounds if self.by_step else 0][turn]

    def policy(self, team: Team | None = None) -> TablePolicy:
        """Return the table as a policy; ValueError if it is of another team than `team`."""
        if team not in (None, self.team):
            expected, got = PLURALS[team], PLURALS[self.team]
            raise ValueError(f"table: expected one of {expected}, got one of {got}")
        turns = range(self.states.n_turns)
        rounds = range(1, len(self.steps) + 1)
        rows = [
            np.stack([self.probabilities(left, turn) for left in rounds]).astype(np.float32)
            for turn in turns
        ]
        steps = len(self.steps) if self.by_step else checks.INT_MAX
        core = _core.Tables(self.states.core, self.team == "evader", steps, rows)
        return TablePolicy(core, self.team, self, steps if self.by_step else None)


def table(states: States, given: Any, team: Team, *, steps: int | None = None) -> Table:
    """Return the probabilities with which a player plays in every state.

    Parameters
    ----------
    states : States
        All states of a world.
    given : player
        What `matrixworld.player` takes. Members of its team decide independently of each other. A
        function is asked once for each different view, so it has to choose by its arguments alone;
        the results of its draws are all followed.
    team : {"pursuer", "evader"}
        The team that it plays for.
    steps : int, optional
        Steps of an episode, which matter to players that count them. The default is the world's
        `max_steps`.

    Raises
    ------
    NotExactError
        A ValueError: if a player remembers something, or draws what cannot be followed.
    TypeError, ValueError
        If the player fits no world like this, has several genomes, or fails.
    """
    checks.check_choice("team", team, TEAMS)
    n_steps = checks.check_integer("steps", states.config.max_steps if steps is None else steps, 1)
    if isinstance(given, Table):
        return _checked(states, given, team, n_steps)
    plays = player(given, team).at(states.config)
    if isinstance(plays, TablePolicy):
        return _of_policy(states, plays, team, n_steps)
    if isinstance(plays, Function):
        return _of_function(states, plays, team, n_steps)
    if isinstance(plays, Population) and plays.policy.memory != "none":
        raise NotExactError(
            "champion: expected a network without memory, whose choices depend on the present "
            f"state alone, got memory {plays.policy.memory!r}"
        )
    counted = range(n_steps if states.counts_steps(plays, team) else 1)
    return Table(states, team, tuple(states.decisions(plays, team, step) for step in counted))


def _checked(states: States, given: Table, team: Team, steps: int) -> Table:
    """Return a table; ValueError unless it is of the team, the states and so many steps."""
    if given.team != team:
        expected, got = PLURALS[team], PLURALS[given.team]
        raise ValueError(f"table: expected one of {expected}, got one of {got}")
    own = given.states
    if not own.has_states_of(states.config) or own.numbered != states.numbered:
        raise ValueError("table: expected one of the same States, got one of others")
    if given.by_step and len(given.steps) != steps:
        raise ValueError(f"steps: expected {len(given.steps)}, those of the table, got {steps}")
    return given


def _of_policy(states: States, policy: TablePolicy, team: Team, steps: int) -> Table:
    """Return the table that a policy is, or that of the play of its solution."""
    play = policy.play
    if not isinstance(play, Table):
        turns = range(play.states.n_turns)
        rounds = range(steps, 0, -1)
        by_step = (
            tuple(play.probabilities(policy.team, left, turn) for turn in turns) for left in rounds
        )
        play = Table(play.states, policy.team, tuple(by_step))
    return _checked(states, play, team, steps)


def _of_function(states: States, function: Function, team: Team, steps: int) -> Table:
    n_actions = states.config.n_actions
    views, places = states.views(team)
    if function.reads == "views":
        return Table(states, team, (joint(function.probabilities(views, n_actions), places),))
    first = function.probabilities(states.inputs(team, places), n_actions)
    found = [joint(first, places)]
    for step in range(1, steps if function.has_read_step else 1):
        inputs = states.inputs(team, places, step)
        found.append(joint(function.probabilities(inputs, n_actions), places))
    return Table(states, team, tuple(found))


def in_engine(given: Any, team: Team, config: WorldConfig) -> Plays:
    """Return what plays for a team in a world: as the engine takes it where that is possible.

    A function becomes a table in a world of few states, once for a `Player` or `Function`. A
    warning says why it does not.
    """
    if isinstance(given, Population) or (isinstance(given, str) and given in SCRIPTS):
        return given
    plays = placed(PLURALS[team], given, team, config)
    if not isinstance(plays, Function):
        return plays
    key = team, config
    if key not in plays.tables:
        plays.tables[key] = _as_table(plays, team, config)
        while len(plays.tables) > KEPT:  # the oldest one
            plays.tables.pop(next(iter(plays.tables)))
    kept: TablePolicy | None = plays.tables[key]
    return plays if kept is None else kept


def _as_table(function: Function, team: Team, config: WorldConfig) -> TablePolicy | None:
    """Return a function as a table, or None and a warning."""
    try:
        if config.density:
            raise NotExactError("each episode draws obstacles")
        count, size = states_size(config)
        if count > MOST_STATES or size > MOST_BYTES:
            got = f"about {count:,} states" if count < inf else "more than 2^31 states"
            got += f" of {size / 10**6:,.0f} MB" if count <= MOST_STATES else ""
            raise NotExactError(f"the world has {got}, tables are made up to {MOST_STATES:,}")
        return table(States(config), function, team).policy()
    except NotExactError as error:
        if str(error) not in function.told:
            warn_caller(f"{function.name} is asked in every step, which is slow: {error}")
            function.told.add(str(error))
        return None


def joint(by_view: NDArray[np.float64], places: Iterable[NDArray[np.intp]]) -> Turns:
    """Return the probabilities of joint actions from those (n, n_actions) for each view."""
    gone = np.eye(1, by_view.shape[1])  # in the row that -1 finds: they act 0
    rows = np.concatenate([by_view, gone])
    turns = []
    for of_turn in places:
        play = np.ones((len(of_turn), 1))
        # Members decide independently of each other; the first one is the highest digit.
        for numbers in of_turn.T:
            play = (play[:, :, np.newaxis] * rows[numbers][:, np.newaxis]).reshape(len(play), -1)
        turns.append(play)
    return tuple(turns)
