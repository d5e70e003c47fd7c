"""Colonel Blotto in plain Python: what every library plays in `bench_libraries.py`.

Two commanders divide their soldiers among fields. Whoever has more soldiers on a field wins it, and
equal numbers share it. In the lottery, the game with chance, soldiers only make it more probable to
win a field.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

FIELDS, SOLDIERS = 10, 100

Plan = list[int]
"""Soldiers on each field, SOLDIERS in total."""
Rng = np.random.Generator


# ---- The game ----------------------------------------------------------------------------------


def play(one: Plan, other: Plan) -> float:
    """Return the share of fields that the first plan wins; an equal field is half a field."""
    points = 0
    for mine, theirs in zip(one, other, strict=True):
        if mine > theirs:
            points += 2
        elif mine == theirs:
            points += 1
    return points / (2 * FIELDS)


def lottery(one: Plan, other: Plan, draws: list[float]) -> float:
    """Return the share of fields that the first plan wins by chance, by a draw for each field."""
    points = 0
    for mine, theirs, draw in zip(one, other, draws, strict=True):
        if draw * (mine + theirs + 2) < mine + 1:  # one ticket more for each side: never 0 of 0
            points += 1
    return points / FIELDS


def play_all(ones: ArrayLike, others: ArrayLike) -> NDArray[np.float64]:
    """Return the results (M,) of `play` for plans (M, FIELDS)."""
    mine, theirs = np.asarray(ones), np.asarray(others)
    points = 2 * (mine > theirs).sum(axis=1) + (mine == theirs).sum(axis=1)
    return np.asarray(points / (2 * FIELDS))


def lottery_all(ones: ArrayLike, others: ArrayLike, draws: ArrayLike) -> NDArray[np.float64]:
    """Return the results (M,) of `lottery` for plans and draws (M, FIELDS)."""
    mine, theirs = np.asarray(ones, np.float64), np.asarray(others, np.float64)
    points = (np.asarray(draws) * (mine + theirs + 2) < mine + 1).sum(axis=1)
    return np.asarray(points / FIELDS)


# ---- Operators ---------------------------------------------------------------------------------


def initial(rng: Rng) -> Plan:
    """Return a new plan: the row of soldiers is cut at random places."""
    cuts = np.sort(rng.integers(SOLDIERS + 1, size=FIELDS - 1))
    plan: Plan = np.diff(cuts, prepend=0, append=SOLDIERS).tolist()
    return plan


def mutate(plan: Plan, rng: Rng) -> Plan:
    """Move some soldiers from one field to another, in place."""
    source, target = int(rng.integers(FIELDS)), int(rng.integers(FIELDS))
    moved = int(rng.integers(plan[source] + 1))
    plan[source] -= moved
    plan[target] += moved
    return plan


def mate(one: Plan, other: Plan, rng: Rng) -> Plan:
    """Return a child with the mean of both plans; the soldiers that are left go anywhere."""
    child = [(mine + theirs) // 2 for mine, theirs in zip(one, other, strict=True)]
    for _ in range(SOLDIERS - sum(child)):
        child[int(rng.integers(FIELDS))] += 1
    return child


def decoded(vectors: ArrayLike) -> list[Plan]:
    """Return vectors (n, FIELDS) of numbers as plans: shares by softmax, rounded to soldiers."""
    values = np.asarray(vectors, np.float64)
    shares = np.exp(values - values.max(axis=1, keepdims=True))
    shares *= SOLDIERS / shares.sum(axis=1, keepdims=True)
    soldiers = np.floor(shares).astype(np.int64)
    # Those that rounding has left go where it has taken most.
    order = np.argsort(soldiers - shares, axis=1)
    left = SOLDIERS - soldiers.sum(axis=1, keepdims=True)
    ranks = np.argsort(order, axis=1)
    plans: list[Plan] = (soldiers + (ranks < left)).tolist()
    return plans
