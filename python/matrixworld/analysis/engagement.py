"""Disengagement: one team wins everything, so neither gets a signal to learn from.

Seen over generations (who wins both team phases) and within one (do its individuals differ, do its
opponents tell them apart).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import groupby
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld.analysis.payoff import Rates, check_rates, require

PURSUERS_WIN = 0.97
"""Capture rate above which the pursuers have won; seen in runs with too few evader epochs."""
EVADERS_WIN = 0.05
"""Capture rate below which the evaders have won."""
PATIENCE = 3
"""Generations in a row before it counts: a single one-sided generation is part of many races."""


@dataclass(frozen=True)
class Disengagement:
    """Generations ``first`` to ``last``, both included, that ``winner`` won on both team phases."""

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


class Undecided(NamedTuple):
    """Shares of the opponents that tell no individual of a generation from another, in [0, 1]."""

    beaten_by_all: Rates
    """Shape ``(generations,)``: opponents that every individual beats, too easy."""
    beaten_by_none: Rates
    """Shape ``(generations,)``: opponents that no individual beats, too hard."""

    @property
    def share(self) -> Rates:
        """Shape ``(generations,)``: the sum; 1 is disengagement."""
        return self.beaten_by_all + self.beaten_by_none


def disengagements(
    rates: ArrayLike,
    *,
    first: int = 1,
    high: float = PURSUERS_WIN,
    low: float = EVADERS_WIN,
    patience: int = PATIENCE,
) -> tuple[Disengagement, ...]:
    """The longest stretches of generations in which one team wins both team phases, in order.

    ``rates``, shape ``(K, 2)``: capture rate after the pursuers' and after the evaders' team phase
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


def fitness_variance(fitness: ArrayLike) -> NDArray[np.float64]:
    """Variance of the fitness within each generation, in its unit squared; ``(generations,)``.

    ``fitness``, shape ``(generations, individuals)``: any finite numbers. Where it is 0, selection
    has nothing to choose from; compare with the variance of one individual's fitness over repeated
    episodes, which is noise. A loss of gradient in the sense of Watson and Pollack (2001).

    Raises ValueError for another shape, an empty array, numbers that are not finite.
    """
    array = np.asarray(fitness, dtype=np.float64)
    require(array.ndim == 2 and array.size > 0, "fitness (generations, individuals)", array.shape)
    bad = array[~np.isfinite(array)]
    require(not len(bad), "finite fitness", bad[:1])
    variance: NDArray[np.float64] = array.var(axis=1)
    return variance


def undecided_opponents(outcomes: ArrayLike, *, level: float = 0.5) -> Undecided:
    """Shares of the opponents beaten by all and by none of the individuals of a generation.

    ``outcomes``, shape ``(generations, individuals, opponents)``, or ``(individuals, opponents)``
    for a single generation: payoff to the individual, in [0, 1] (capture rates for pursuers, one
    minus them for evaders). Beaten: above ``level``. Cartlidge and Bullock (2004) look at such
    generations as disengaged.

    Raises ValueError for another shape, payoffs or a level outside [0, 1].
    """
    require(0.0 <= level <= 1.0, "a level in [0, 1]", level)
    single = np.ndim(outcomes) == 2
    what = "outcomes ([generations,] individuals, opponents)"
    array = check_rates(outcomes, ndim=2 if single else 3, what=what)
    wins = (array[None] if single else array) > level
    return Undecided(wins.all(axis=1).mean(axis=-1), (~wins.any(axis=1)).mean(axis=-1))


def _check_half_steps(rates: ArrayLike) -> Rates:
    if np.shape(rates) == (0, 2):
        return np.empty((0, 2))
    array = check_rates(rates, ndim=2, what="team phase capture rates")
    if array.shape[1] != 2:
        raise ValueError(f"expected team phase capture rates of shape (K, 2), got {array.shape}")
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
