"""Disengagement: one team wins everything, so neither gets a signal to learn from."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import groupby

import numpy as np
from numpy.typing import ArrayLike

from matrixworld.analysis.payoff import Rates, check_rates

PURSUERS_WIN = 0.97
"""Capture rate above which the pursuers have won; seen in runs with too few evader epochs."""
EVADERS_WIN = 0.05
"""Capture rate below which the evaders have won."""
PATIENCE = 3
"""Generations in a row before it counts: a single one-sided generation is part of many races."""


@dataclass(frozen=True)
class Disengagement:
    """Generations ``first`` to ``last``, both included, that ``winner`` won on both half-steps."""

    winner: str
    first: int
    last: int

    @property
    def loser(self) -> str:
        """The other team: the one to give more epochs."""
        return "evaders" if self.winner == "pursuers" else "pursuers"

    def __len__(self) -> int:
        return self.last - self.first + 1

    def __str__(self) -> str:
        return (
            f"generations {self.first} to {self.last}: the {self.winner} win nearly everything, "
            f"so neither team has much to learn from; give the {self.loser} more epochs"
        )


def disengagements(
    rates: ArrayLike,
    *,
    first: int = 1,
    high: float = PURSUERS_WIN,
    low: float = EVADERS_WIN,
    patience: int = PATIENCE,
) -> tuple[Disengagement, ...]:
    """The longest stretches of generations in which one team wins both half-steps, in order.

    ``rates``, shape ``(K, 2)``: capture rate after the pursuers' and after the evaders' half-step
    of generations ``first``, ``first + 1``, ... (:func:`half_steps` takes them from a matrix; a
    training log has them as the race goes). A stretch has all rates above ``high`` (pursuers win)
    or all below ``low`` (evaders win) for at least ``patience`` generations. It is still going on
    if its ``last`` is the newest generation. ``K = 0``, before the first generation, has none.

    Raises ValueError for another shape, rates outside [0, 1], ``low >= high`` or ``patience < 1``.
    """
    if not low < high:
        raise ValueError(f"expected low < high, got low {low} and high {high}")
    if patience < 1:
        raise ValueError(f"expected a patience of at least 1 generation, got {patience}")
    winners = _winners(_check_half_steps(rates), high, low)
    return tuple(s for s in _stretches(winners, first) if len(s) >= patience)


def _check_half_steps(rates: ArrayLike) -> Rates:
    if np.shape(rates) == (0, 2):
        return np.empty((0, 2))
    array = check_rates(rates, ndim=2, what="half-step capture rates")
    if array.shape[1] != 2:
        raise ValueError(f"expected half-step capture rates of shape (K, 2), got {array.shape}")
    return array


def _winners(rates: Rates, high: float, low: float) -> list[str | None]:
    return [
        "pursuers" if min(pair) > high else "evaders" if max(pair) < low else None
        for pair in rates.tolist()
    ]


def _stretches(winners: list[str | None], first: int) -> Iterator[Disengagement]:
    generation = first
    for winner, group in groupby(winners):
        length = len(list(group))
        if winner is not None:
            yield Disengagement(winner, generation, generation + length - 1)
        generation += length
