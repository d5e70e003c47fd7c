"""What a team guarantees that draws one of several champions at the start of each episode."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from matrixworld.solve.solution import (
    Champion,
    Fixed,
    fixed_play,
    go_back,
    parts_of,
    rounds_of,
    values_after,
)
from matrixworld.solve.states import States, config_of
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import Team

Array = NDArray[np.float64]

_MOST_PASSES = 10
_ENOUGH = 1e-6  # a pass that gains less is the last
_CHOICE = np.dtype(np.int32)  # of joint actions
_PIECE = 2**12  # states


def mixture_bounds(
    world: WorldConfig | States,
    mixture: Sequence[tuple[float, Champion]],
    team: Team,
    *,
    steps: int | None = None,
) -> tuple[float, float]:
    """Return bounds of the capture rate against the best opponent of a mixture of champions.

    The team draws one of the champions at the start of each episode, for all its members, and not
    in every turn anew. Its opponent knows the mixture, but finds out in the course of the episode
    only whom it has met. Both bounds are exact, without sampling: one opponent is told after its
    first action whom it has met, and gets at least as much as the best one. The other one cannot be
    better: it believes what the state alone says about whom it has met, and is improved until a
    pass gains less than 1e-6, in at most ten passes.

    Parameters
    ----------
    world : WorldConfig or States
        The world, or its states.
    mixture : sequence of (float, Champion)
        Weights, whose sum is 1, and champions.
    team : {"pursuer", "evader"}
        Their team.
    steps : int, optional
        Rounds of an episode. The default is the world's `max_steps`.

    Returns
    -------
    low, high : float
        Of pursuers the opponents minimize the capture rate, and the first one gets `low`; of
        evaders they maximize it, and the first one gets `high`. Both are equal for one champion.
    """
    config = config_of(world)
    parts = [part for part in parts_of(config, mixture, team) if part[0] > 0.0]
    rounds = rounds_of(config, steps, parts)
    states = States.of(world)
    shares = np.array([share for share, _ in parts])
    members = [fixed_play(states, [(1.0, part)], team) for _, part in parts]
    first: Any = 0.0
    for share, member in zip(shares, members, strict=True):
        after = values_after(go_back(states, rounds, "capture-rate", {team: member}), 0, rounds)
        first = first + share * _responses(states, member, 0, rounds, after)
    better = np.min if team == "pursuer" else np.max
    informed = float(better(first, axis=1)[states.starts].mean())
    forgetful = _forgetful(states, shares, members, rounds)
    return (informed, forgetful) if team == "pursuer" else (forgetful, informed)


def _responses(states: States, member: Fixed, turn: int, left: int, after: Array) -> Array:
    """Return the values (S, its joint actions) of the responder's actions against a member."""
    successors, probabilities = states.successors(turn), member.at(turn, left)
    played = "spq,sp->sq" if member.team == "pursuer" else "spq,sq->sp"
    n, pursuers, evaders = successors.shape
    values = np.empty((n, evaders if member.team == "pursuer" else pursuers))
    for start in range(0, len(values), _PIECE):  # all values at once would be twice the states
        part = slice(start, start + _PIECE)
        values[part] = np.einsum(played, after[successors[part]], probabilities[part])
    return values


def _forgetful(states: States, shares: Array, members: list[Fixed], rounds: int) -> float:
    """Return what a responder gets that knows the state, but not how it came about."""
    turns = range(states.n_turns)
    moments = [(left, turn) for left in range(rounds, 0, -1) for turn in turns]
    # At first every state says as much as the start.
    reached = {
        each: [np.broadcast_to(share, states.count(each[1])) for share in shares]
        for each in moments
    }
    best = np.argmin if members[0].team == "pursuer" else np.argmax
    found, chosen = np.nan, {}
    for _ in range(_MOST_PASSES):
        values = [states.payoffs for _ in members]
        for left, turn in reversed(moments):
            of_actions = [
                _responses(states, member, turn, left, after)
                for member, after in zip(members, values, strict=True)
            ]
            weighted = zip(reached[left, turn], of_actions, strict=True)
            action = best(sum(each[:, None] * q for each, q in weighted), axis=1)[:, None]
            chosen[left, turn] = action.astype(_CHOICE)
            values = [np.take_along_axis(q, action, axis=1)[:, 0] for q in of_actions]
        before, found = found, float(shares @ [v[states.starts].mean() for v in values])
        if abs(found - before) < _ENOUGH:
            break
        for number, (share, member) in enumerate(zip(shares, members, strict=True)):
            weights = np.bincount(states.starts, minlength=states.count()) * share
            for left, turn in moments:
                # A little of the prior, for states that are not reached as yet.
                reached[left, turn][number] = weights + 1e-12 * share
                weights = _moved(states, member, turn, left, chosen[left, turn], weights)
    return found


def _moved(
    states: States, member: Fixed, turn: int, left: int, action: NDArray[np.intp], weights: Array
) -> Array:
    """Return the weights of the next turn's states against a member and the chosen actions."""
    successors, played = states.successors(turn), member.at(turn, left)
    axis = 2 if member.team == "pursuer" else 1
    following = np.take_along_axis(successors, np.expand_dims(action, 3 - axis), axis=axis)
    size = states.count((turn + 1) % states.n_turns)
    flow = (weights[:, None] * played).ravel()
    moved = np.bincount(following.reshape(played.shape).ravel(), flow, minlength=size)
    return moved.astype(np.float64, copy=False)
