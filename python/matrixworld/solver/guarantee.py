"""What a player guarantees: its result against the best response, exactly or within a bracket."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from matrixworld._util import checks
from matrixworld.play.draws import NotExactError
from matrixworld.play.functions import Function
from matrixworld.play.player import player
from matrixworld.play.tables import Table, Turns, joint, table
from matrixworld.solver.memory import mind_of, needs_numbers, remembered
from matrixworld.solver.solution import Solution, best_response, expected_payoff, solve
from matrixworld.solver.visits import Visit, visits
from matrixworld.world.policy import Population, Team
from matrixworld.world.rating import INPUTS
from matrixworld.world.states import STRIDE, States

DRAWS = 10
"""Answers for each view and step by which a function is estimated."""


@dataclass(frozen=True, eq=False)
class Guarantee:
    """The capture rate of a player against the best response, which knows it and sees the world.

    Parameters
    ----------
    low, high : float
        Equal if it is exact. Of an estimate one is too low and one too high on average, if the
        function's draws are independent; they are no bounds.
    unread : float
        The capture rate against perfect play that does not know the player: the other team's part
        of the solution.
    reason : str
        Why it is an estimate; empty if it is exact.
    perfect : Solution
        Perfect play in the states of `visits`.
    visits : tuple of Visit
        Where the player gets in episodes against the best response.
    """

    low: float
    high: float
    unread: float
    reason: str
    perfect: Solution
    visits: tuple[Visit, ...]

    @property
    def value(self) -> float:
        """The capture rate; of an estimate the middle of its bounds."""
        return (self.low + self.high) / 2


def guarantee(
    perfect: Solution, given: Any, team: Team, *, draws: int = DRAWS, seed: int = 0
) -> Guarantee:
    """Return what a player guarantees in a solved world.

    Parameters
    ----------
    perfect : Solution
        The solution of the world, of the capture rate.
    given : player
        What `matrixworld.player` takes.
    team : {"pursuer", "evader"}
        The team that it plays for.
    draws : int, optional
        Answers for each view and step, where a function cannot be followed exactly.
    seed : int, optional
        Seed of these draws.

    Returns
    -------
    Guarantee
        Exact for players that choose by what they see, by the step, by draws that can be followed
        (see `Function`) and by a memory without too many values.

    Raises
    ------
    NotExactError
        A ValueError: if a player with a memory reaches too many moments, or draws what cannot be
        followed; or if one that reads ``ahead`` plays more than `STRIDE` steps.
    TypeError, ValueError
        If it is no player of this world, has several genomes, or fails.
    """
    checks.check_integer("draws", draws, 1)
    if perfect.fixed or perfect.payoff != "capture-rate":
        raise ValueError(
            f"perfect: expected a solution by solve, of the capture rate, got {perfect!r}"
        )
    states, steps = perfect.states, perfect.steps
    plays = player(given, team).at(states.config)
    mind = mind_of(plays)
    if mind is not None:
        if needs_numbers(states, team):
            perfect = _numbered(perfect)
        value, unread, met = remembered(perfect, mind, team)
        return Guarantee(value, value, unread, "", perfect, met)
    if isinstance(plays, Population) and states.draws_strides(plays, team):
        if needs_numbers(states, team):
            perfect = _numbered(perfect)
        return _with_strides(perfect, plays, team)
    try:
        some = others = table(states, plays, team, steps=steps)
        reason = ""
    except NotExactError as error:
        if not isinstance(plays, Function):
            raise
        rng = np.random.default_rng(seed)
        some, others = (_sampled(perfect, plays, team, draws, rng) for _ in range(2))
        reason = str(error)
    response = best_response(states, some, team, steps=steps)
    # A response to answers that were drawn exploits their chance: against them it gets too much, on
    # average; against others it gets at most what a best response gets.
    low, high = sorted(
        [response.value, _result(others, response, team) if reason else response.value]
    )
    met = tuple(visits(perfect, some, response, team))
    return Guarantee(low, high, _result(others, perfect, team), reason, perfect, met)


def _numbered(perfect: Solution) -> Solution:
    """Return the same solution of states in which members of a team are told apart."""
    states = perfect.states
    if states.numbered:
        return perfect
    numbered = States(states.config, numbered=True, threads=states.threads, report=states.report)
    return solve(numbered, steps=perfect.steps)


def _with_strides(perfect: Solution, genome: Population, team: Team) -> Guarantee:
    """Return what a genome guarantees whose agents keep directions that they draw.

    The best response knows these directions from the start. So it is the mean over all of them.
    """
    states, steps = perfect.states, perfect.steps
    if steps > STRIDE:
        raise NotExactError(
            f"champion: expected at most {STRIDE} steps, in which an agent keeps its direction "
            f"(it reads ahead), got {steps}"
        )
    episodes = states.strides(team)
    counted = range(steps if states.counts_steps(genome, team) else 1)
    values, unread, met = [], [], list[Visit]()
    for episode in episodes:
        by_step = (states.decisions(genome, team, step, episode) for step in counted)
        play = Table(states, team, tuple(by_step))
        response = best_response(states, play, team, steps=steps)
        values.append(response.value)
        unread.append(_result(play, perfect, team))
        met += (visit.times(1 / len(episodes)) for visit in visits(perfect, play, response, team))
    value = float(np.mean(values))
    return Guarantee(value, value, float(np.mean(unread)), "", perfect, tuple(met))


def _result(play: Table, rival: Solution, team: Team) -> float:
    """Return the capture rate of a team's table against the other team of a solution."""
    pair = (play, rival) if team == "pursuer" else (rival, play)
    return expected_payoff(play.states, *pair, steps=rival.steps)


def _sampled(
    perfect: Solution, function: Function, team: Team, draws: int, rng: np.random.Generator
) -> Table:
    """Return a table of answers that are drawn, others in each step."""
    states, n_actions = perfect.states, perfect.states.config.n_actions
    views, places = states.views(team)

    def drawn(step: int) -> Turns:
        answers = []
        for _ in range(draws):
            seen: Any = views
            if function.reads == "inputs":
                seen = states.inputs(team, places, step)
                ahead = rng.integers(1, n_actions, len(seen))[:, np.newaxis] == np.arange(n_actions)
                seen[..., [*INPUTS].index("ahead")] = ahead
            answers.append(function.sampled(seen, n_actions, rng))
        return joint(np.mean(answers, axis=0), places)

    return Table(states, team, tuple(map(drawn, range(perfect.steps))))
