"""Exercises of notebook 9, "Fast and safe?"."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from numbers import Real
from typing import Any

import numpy as np
from numpy.typing import NDArray

from matrixworld.play.rollout import Matches, rollout
from matrixworld.tutorial.exercises import NO_FUNCTION, Exercise, Prediction
from matrixworld.tutorial.packs import WEIGHTS, WORLD, MaskedEpisodes, pack, play_masked
from matrixworld.world.rules import Rewards

MOST_FAULTS, MOST_STEPS = 10.0, 15.0
BRISK, IDLE = (4, 10, -10, -8, -2, 0), (0, 0, 0, 0, 0, 20)
GREEDY = (6, 20, 0, 0, 0, 0)
FEWEST_EPISODES = 299  # 0.99^299 = 0.0495, and 0.99^298 = 0.05004
FEWEST_CAPTURES = 0.5


def _weights(answer: Any) -> str | None:
    try:
        weights = np.asarray(answer, np.float64)
    except (TypeError, ValueError):
        return "The answer is a list of six numbers."
    if weights.shape != (len(WEIGHTS),) or not np.isfinite(weights).all():
        return f"The answer is six numbers, one for each of {', '.join(WEIGHTS)}."
    played = rollout(WORLD, pack(weights), "random", Matches.of(0, 0, 91), episodes=1000)
    faults = 1000 * played.faults[:, :, 0].sum() / played.agent_steps[:, :, 0].sum()
    steps = played.length.mean()
    if faults < MOST_FAULTS and steps <= MOST_STEPS:
        return None
    found = f"In 1000 new episodes it is at fault in {faults:.1f} of 1000 agent-steps and needs "
    found += f"{steps:.1f} steps. "
    if faults >= MOST_FAULTS and steps > MOST_STEPS:
        return found + "Both numbers are too large: it gets in its own way."
    if faults >= MOST_FAULTS:
        return found + "It is fast enough. Now make it more careful."
    return found + "It is careful enough. Now make it more determined."


@cache
def _break_even() -> float:
    free = replace(WORLD, rewards=Rewards(pursuer_collide=0))
    played = rollout(free, pack([BRISK, IDLE]), "random", Matches.of([0, 1], 0, 2), episodes=400)
    gain = played.pursuer_return.mean(axis=1)
    collisions = played.faults[:, :, 0].sum(axis=2).mean(axis=1)
    return float((gain[0] - gain[1]) / (collisions[0] - collisions[1]))


def _penalty(answer: Any) -> str | None:
    if not isinstance(answer, Real) and np.ndim(answer) == 0:
        answer = getattr(answer, "item", lambda: answer)()
    if isinstance(answer, bool) or not isinstance(answer, Real):
        return "The answer is one number: the penalty at which both returns are equal."
    value = abs(float(answer))
    true = _break_even()
    if abs(value - true) <= 0.02 * true:
        return None
    played = "At this penalty the return of the {} pack is larger. "
    return played.format("brisk" if value < true else "idle") + (
        "Look for the penalty at which both are equal."
    )


def _episodes(answer: Any) -> str | None:
    if isinstance(answer, bool) or not isinstance(answer, int | np.integer):
        return "The answer is a whole number of episodes."
    if answer in (FEWEST_EPISODES, 300):
        return None
    if answer <= 0:
        return "At least one episode has to be played."
    chance = 0.99 ** int(answer)
    if answer < FEWEST_EPISODES:
        return (
            f"A pack with p = 0.01 would pass {answer} episodes with a probability of "
            f"{chance:.1%}. That is more than 5%."
        )
    return f"That is enough, but not the smallest number: {chance:.2%} is well below 5%."


def _mask(answer: Any) -> str | None:
    if not callable(answer):
        return NO_FUNCTION
    views = np.zeros((2, 3, WORLD.fov, WORLD.fov), np.uint8)
    allowed = answer(views)
    if np.shape(allowed) != (2, 5):
        return f"For n views it returns (n, 5) values; for 2 views it gave {np.shape(allowed)}."
    if not np.asarray(allowed, bool).all():
        return "On an empty grid, with nothing in view, it forbids an action. Nothing can happen."
    for weights in (GREEDY, BRISK):
        played = play_masked(weights, answer, episodes=200, seed=92)
        mistake = _collided(played)
        if mistake is not None:
            return mistake
    return None


def _collided(played: MaskedEpisodes) -> str | None:
    """Return what is wrong with a mask, from episodes under it."""
    rates: NDArray[np.float64] = played.safety.summary().fault_rate[0]
    if rates[0]:
        return (
            f"Pursuers still run into walls ({rates[0]:.1f} of 1000 agent-steps). Views show the "
            "cells outside the grid as obstacles."
        )
    if rates[1]:
        return (
            f"Pursuers still collide with teammates ({rates[1]:.1f} of 1000 agent-steps). Is there "
            "a cell to which two of them may go at once, or one with a teammate on it?"
        )
    if played.captured.mean() < FEWEST_CAPTURES:
        return (
            f"No collision, but the evader is captured in {played.captured.mean():.0%} of the "
            "episodes only. The mask forbids too much: of several pursuers around a cell, one may "
            "go."
        )
    return None


EXERCISES: dict[str, Exercise | Prediction] = {
    "9.a": Prediction(
        ("a", "b", "c"),
        "c",
        "Pursuers in one cell cannot surround anything. Those that avoid each other come from "
        "different sides, so they are safer and faster.",
    ),
    "9.1": Exercise(
        _weights,
        "Being careful (`crowd`) and determined (`approach`) have to grow together: what counts is "
        "how they compare, since the softmax looks at differences of wishes.",
        (
            "Begin with [4, 10, -10, -8, -4, 0], and look at both numbers.",
            "A more negative `crowd` makes it safer. A larger `approach` makes it faster. Change "
            "both.",
            "`approach` from 5 to 6, and `crowd` from -5 to -6, are close.",
        ),
    ),
    "9.b": Prediction(
        ("a", "b", "c"),
        "b",
        "Runs that found a way to capture before they stopped moving became careful, but not safe. "
        "The others learned that who does not move does not collide.",
    ),
    "9.2": Exercise(
        _penalty,
        "It is below the paper's 12. At that penalty a learner should prefer to stand still over a "
        "pack that captures nearly always: the reward says so.",
        (
            "Write down both returns, and set them equal.",
            "gain[0] - penalty * collisions[0] = gain[1] - penalty * collisions[1]. Solve it for "
            "the penalty.",
        ),
    ),
    "9.3": Exercise(
        _episodes,
        "0.99^299 is just below 0.05. The rule of thumb 3/n gives 300. To show a rate that is ten "
        "times smaller takes ten times as many episodes.",
        (
            "You look for the smallest n with 0.99^n <= 0.05.",
            "Take logarithms, or let a loop count: n = 1, 2, 3, ...",
        ),
    ),
    "9.c": Prediction(
        ("a", "b", "c"),
        "b",
        "No pursuer enters an occupied cell any more. But two pursuers can still enter the same "
        "free cell at the same moment, and then stay together in it.",
    ),
    "9.4": Exercise(
        _mask,
        "No pursuer enters an occupied cell, and no two may enter the same free one. So no two can "
        "meet, whatever they wish.",
        (
            "Begin with free_cells. For each move, look at the four cells around its target.",
            "One of these four is your own cell. The cells with a higher priority are those that "
            "come before it in the order north, east, south, west of the target.",
            "For a move (r, c) and a side (a, b), the cell is MIDDLE + r + a, MIDDLE + c + b, and "
            "teammates are in layer 1. Loop over the sides; stop at (a, b) = (-r, -c), which is "
            "you; forbid the move where a teammate stands.",
        ),
    ),
    "9.d": Prediction(
        ("a", "b", "c"),
        "b",
        "These packs had learned to capture with several pursuers in one cell. The mask takes that "
        "away, and nothing has taught them what to do instead.",
    ),
}
