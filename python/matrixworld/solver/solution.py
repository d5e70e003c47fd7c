"""Backward induction: values and perfect play of both teams, or of one against a champion."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal, TypeAlias

import numpy as np
from numpy.typing import NDArray

from matrixworld import _core
from matrixworld._util import checks
from matrixworld._util.readable import Parts, Readable
from matrixworld.play.player import Player, player
from matrixworld.play.tables import Table, table
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import TEAMS, TablePolicy, Team
from matrixworld.world.states import States, config_of

PayoffName: TypeAlias = Literal["capture-rate", "capture-time"]
PAYOFFS: tuple[PayoffName, PayoffName] = ("capture-rate", "capture-time")

Fixed: TypeAlias = "Table | Solution"
"""The play of a champion: its table or, which takes less memory, its solution."""


@dataclass(frozen=True, eq=False, repr=False)
class Solution(Readable):
    """Values of all states of a world for every number of rounds left, and who plays how.

    `solve` returns one in which both teams play perfectly, `best_response` one in which a team
    replies to a champion. It is of some `states` and of episodes of `steps` rounds, T. The `payoff`
    is what the pursuers maximize: the "capture-rate" after the last round; or, "capture-time",
    minus the rounds until all evaders are captured, where T counts if they are not.

    `values`, (R + 1, S) of each turn, are what the pursuers get from each state when r rounds are
    left, this one included (for later turns of a round, row 0 has no meaning and is 0). R is at
    most T: more rounds have the values of the last row. The `gap` is the largest difference, over
    all states and rounds, between what the strategies of the two teams guarantee in the game of one
    turn: rounding. Over an episode it is T times as much. `fixed` is the champion of the team that
    has one.
    """

    states: States
    steps: int
    payoff: PayoffName
    values: tuple[NDArray[np.float64], ...]
    gap: float
    fixed: dict[Team, Fixed]

    def _parts(self) -> Parts:
        rows = {
            "value": f"{self.value:.4f}, the mean {self.payoff.replace('-', ' ')} over all starts",
            "steps of an episode": str(self.steps),
            "states": f"{self.states.total:,}",
            "largest gap between the guarantees of a step": f"{self.gap:.1g}",
        }
        plays = (
            f"{next(iter(self.fixed))}s are fixed" if self.fixed else "both teams play perfectly"
        )
        return [[("Solution", plays), *rows.items()]]

    @property
    def value(self) -> float:
        """Mean over the starts: the capture rate, or the rounds until all evaders are captured."""
        return float(self.means[-1])

    @cached_property
    def means(self) -> NDArray[np.float64]:
        """The value of episodes of 0, 1, ... R rounds, (R + 1,)."""
        means = self.values[0][:, self.states.starts].mean(axis=1)
        return np.asarray(means if self.payoff == "capture-rate" else -means)

    def before(self, rounds: int, turn: int = 0) -> NDArray[np.float64]:
        """Return the values (S,) of a turn's states with so many rounds left, this one included."""
        values = self.values[turn]
        return np.asarray(values[min(rounds, len(values) - 1)])

    def after(self, rounds: int, turn: int = 0) -> NDArray[np.float64]:
        """Return the values (S,) of the next turn's states, after a turn of such a round."""
        last = turn + 1 == self.states.n_turns  # the next turn is the first of a round
        return self.before(rounds - 1) if last else self.before(rounds, turn + 1)

    def probabilities(
        self, team: Team, rounds: int | None = None, turn: int = 0
    ) -> NDArray[np.float64]:
        """Return with which probabilities a team plays, float64 (S, its joint actions).

        `rounds` are left, this one included, by default all. In an end the joint action is 0.
        """
        checks.check_choice("team", team, TEAMS)
        left = checks.check_integer(
            "rounds", self.steps if rounds is None else rounds, 1, self.steps
        )
        turn = checks.check_integer("turn", turn, 0, self.states.n_turns - 1)
        if team in self.fixed:
            return _play_of(self.fixed[team], team, turn, left)
        after = self.after(left, turn)
        _, _, *chosen = _backup(self.states, after, turn, left, self.fixed, None, chosen=True)
        played = chosen[TEAMS.index(team)]
        assert played is not None  # it was asked for
        return played

    def policy(self, team: Team) -> TablePolicy:
        """Return a team's play as a policy, whose members act on one draw of a joint action."""
        checks.check_choice("team", team, TEAMS)
        rounds = len(self.values[0]) - 1
        axis = 1 + TEAMS.index(team)
        successors = [self.states.successors(turn) for turn in range(self.states.n_turns)]
        shapes = [(rounds, array.shape[0], array.shape[axis]) for array in successors]
        tables = [np.empty(shape, np.float32) for shape in shapes]
        for turn, rows in enumerate(tables):
            for left in range(1, rounds + 1):
                done = turn * rounds + left
                report = self.states.reporter("tables", done, len(tables) * rounds)
                if report is not None:
                    report(0.0)
                rows[left - 1] = self.probabilities(team, left, turn)
        core = _core.Tables(self.states.core, team == "evader", self.steps, tables)
        return TablePolicy(core, team, self)


def _backup(
    states: States,
    after: NDArray[np.float64],
    turn: int,
    rounds: int,
    fixed: dict[Team, Fixed],
    report: Callable[[float], None] | None,
    chosen: bool = False,
) -> tuple[NDArray[np.float64], float, NDArray[np.float64] | None, NDArray[np.float64] | None]:
    """Return values, gap, and if wanted the play of both teams in one turn."""
    pursuers, evaders = (
        _play_of(fixed[team], team, turn, rounds) if team in fixed else None for team in TEAMS
    )
    if report is not None:
        report(0.0)
    return states.core.backup(turn, after, pursuers, evaders, chosen, states.threads, report)


def _play_of(fixed: Fixed, team: Team, turn: int, rounds: int) -> NDArray[np.float64]:
    """Return the probabilities of a champion's team with so many rounds left, this one included."""
    if isinstance(fixed, Solution):
        return fixed.probabilities(team, rounds, turn)
    return fixed.probabilities(rounds, turn)


def induct(
    world: WorldConfig | States,
    steps: int | None,
    payoff: PayoffName,
    champions: Mapping[Team, Any],
) -> Solution:
    """Check all arguments, list the states, and go back through the rounds."""
    config = config_of(world)
    checks.check_choice("payoff", payoff, PAYOFFS)
    plays = {team: _champion(champion, team, config) for team, champion in champions.items()}
    solutions = [play for play in plays.values() if isinstance(play, Solution)]
    # A solution plays no more rounds than its own.
    most = min([checks.INT_MAX, *(solution.steps for solution in solutions)])
    rounds = checks.check_integer("steps", config.max_steps if steps is None else steps, 1, most)
    states = next((each.states for each in solutions), None) or States.of(world)
    fixed: dict[Team, Fixed] = {
        team: play if isinstance(play, Solution) else table(states, play, team, steps=rounds)
        for team, play in plays.items()
    }
    return _go_back(states, rounds, payoff, fixed)


def _champion(champion: Any, team: Team, config: WorldConfig) -> Solution | Table | Player:
    """Return the solution or table that a champion plays by, or the champion as a player."""
    given = champion.play if isinstance(champion, TablePolicy) else champion
    if isinstance(given, Table):
        return given
    if not isinstance(given, Solution):
        return player(champion, team)
    if isinstance(champion, TablePolicy) and champion.team != team:
        raise ValueError(f"champion: expected a policy of the {team}s, got one of {champion.team}s")
    if not given.states.has_states_of(config):
        raise ValueError("champion: expected a solution of the same States, got one of others")
    return given


def _go_back(states: States, rounds: int, payoff: PayoffName, fixed: dict[Team, Fixed]) -> Solution:
    """Go back from the last round to the first."""
    captures = payoff == "capture-rate"
    counts = [states.count(turn) for turn in range(states.n_turns)]
    values = [np.zeros((1, count)) for count in counts]
    if captures:
        values[0][0] = states.captured().mean(axis=1)
    first = values[0][0].copy()  # the row of the first turn
    changes = any(isinstance(play, Solution) for play in fixed.values())
    what = "best responses" if fixed else "perfect play"
    n_turns = states.n_turns
    gap = 0.0
    left = 0
    while left < rounds:
        left += 1
        if left == len(values[0]):
            # In place where the system can: joined at the end, they would take twice as much.
            room = min(left + left // 4 + 1, rounds + 1)
            for turn, count in enumerate(counts):
                values[turn].resize((room, count), refcheck=False)
        before = after = first
        for turn in reversed(range(states.n_turns)):
            report = states.reporter(what, left * n_turns - turn - 1, rounds * n_turns)
            after, wrong, _, _ = _backup(states, after, turn, left, fixed, report)
            gap = max(gap, wrong)
            if turn == 0 and not captures:
                after -= 1.0
                after[states.config.n_evaders] = 0.0  # the end with all captured
            values[turn][left] = after
        first = after
        # Rounds of which no more change the values add no rows.
        if not changes and (first == before).all():
            break
    for turn, count in enumerate(counts):
        values[turn].resize((left + 1, count), refcheck=False)
    return Solution(states, rounds, payoff, tuple(values), gap, fixed)


def solve(
    world: WorldConfig | States, *, steps: int | None = None, payoff: PayoffName = "capture-rate"
) -> Solution:
    """Return values and perfect play of both teams in a small world.

    Parameters
    ----------
    world : WorldConfig or States
        The world, or its states, which several calls can share.
    steps : int, optional
        Rounds of an episode. The default is the world's `max_steps`.
    payoff : {"capture-rate", "capture-time"}, optional
        What the teams play for, see `Solution`.

    Returns
    -------
    Solution
        Values, and play by its `policy`.

    Notes
    -----
    Backward induction over the rounds. Where both teams move at once, each state and round is a
    matrix game, in which it can be best to mix (Shapley 1953, "Stochastic games", PNAS 39); in
    turns, a maximum or a minimum.
    """
    return induct(world, steps, payoff, {})


def best_response(
    world: WorldConfig | States,
    champion: Any,
    team: Team,
    *,
    steps: int | None = None,
    payoff: PayoffName = "capture-rate",
) -> Solution:
    """Return the best that the other team can do against a champion, and how.

    The responder knows the champion's play, sees the whole world and is one player. So no opponent
    gets more, whatever it is trained with.

    Parameters
    ----------
    world, steps, payoff
        As for `solve`.
    champion : player
        What `matrixworld.player` takes: a script, genomes, a program, a function, a solution of the
        same States. It is of a single genome, sees what it looks for, and remembers nothing; of
        others see `guarantee`.
    team : {"pursuer", "evader"}
        The champion's team.

    Returns
    -------
    Solution
        Its `value` is what the pair comes to.

    Raises
    ------
    NotExactError
        A ValueError: if the champion remembers something, or draws what cannot be followed.
    TypeError, ValueError
        If it is no player, or not of this world.
    """
    checks.check_choice("team", team, TEAMS)
    return induct(world, steps, payoff, {team: champion})


def expected_payoff(
    world: WorldConfig | States,
    pursuers: Any,
    evaders: Any,
    *,
    steps: int | None = None,
    payoff: PayoffName = "capture-rate",
) -> float:
    """Return what a pair comes to on average, exactly: a cell of the payoff matrix without noise.

    `pursuers` and `evaders` are champions as `best_response` takes them; `world`, `steps` and
    `payoff` are as in `solve`.
    """
    return induct(world, steps, payoff, {"pursuer": pursuers, "evader": evaders}).value
