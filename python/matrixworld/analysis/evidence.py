"""The numbers that a diagnosis rests on, freed from the noise of the episodes as far as known."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from matrixworld.analysis.bootstrap import Estimate
from matrixworld.analysis.cycles import transitive_share
from matrixworld.analysis.dominance import dominance_tournament
from matrixworld.analysis.engagement import disengagements
from matrixworld.analysis.lags import half_steps
from matrixworld.analysis.measures import MEASURES
from matrixworld.analysis.payoff import Rates, check_rates, last_half, require
from matrixworld.analysis.progress import Forgetting, forgetting

FEWEST_EPISODES = 4
"""Of each cell: with fewer, halves of them have one, and nothing is known of its noise."""

BOUNDS = {
    "least_rise": (-1.0, 1.0),
    "greatest_rise": (-1.0, 1.0),
    "pursuer_rise": (-1.0, 1.0),
    "evader_rise": (-1.0, 1.0),
    "checkerboards": (0.0, 1.0),
    "transitive_share": (0.0, 1.0),
    "one_sided": (0.0, 1.0),
    "most_forgetting": (0.0, 1.0),
    "pursuer_forgetting": (0.0, 1.0),
    "evader_forgetting": (0.0, 1.0),
}
"""The numbers by name, and the range of each; `numbers_of` defines them."""

SUPPORT: Mapping[str, tuple[str, ...]] = {
    "arms race": (
        "least_rise", "pursuer_rise", "evader_rise", "transitive_share",
        "pursuer_rungs", "evader_rungs",
    ),
    "cycling": ("checkerboards", "transitive_share", "pursuer_stripes", "evader_stripes"),
    "disengagement": ("one_sided", "capture_rate", "swing"),
    "forgetting": (
        "most_forgetting", "pursuer_forgetting", "evader_forgetting",
        "pursuer_fading", "evader_fading",
    ),
    "stagnation": ("greatest_rise", "checkerboards", "transitive_share"),
}  # fmt: skip
"""The numbers that are told of each condition; the first one decides."""
_PLAIN = (
    "capture_rate", "swing", "pursuer_fading", "evader_fading", "pursuer_stripes", "evader_stripes",
)  # fmt: skip


class Rises(NamedTuple):
    """What each team scores more against opponents of the past than it did then, in [-1, 1]."""

    pursuers: float
    evaders: float


def rises(payoff: ArrayLike) -> Rises:
    """How much either team gains on opponents that stand still.

    The mean, over pairs of generations k < g from 1 on, of what the team scores in generation g
    against the opponents of generation k, less what it scored in generation k in both team phases.
    In an arms race both teams have it, while the current matches may stay as even as ever; in a
    cycle the gains of one stretch are the losses of the next. A team that stands still has none,
    give or take half of what the others gain in a generation.

    At least 3 x 3 generations; those past the shorter side have no current opponent and are left
    out. Raises ValueError for fewer.
    """
    matrix = check_rates(payoff, ndim=2, what="a payoff matrix")
    size = min(matrix.shape)
    require(size >= 3, "at least 3 x 3 generations", matrix.shape)
    current = half_steps(matrix).mean(axis=1)
    k, later = np.triu_indices(size - 1, k=1)
    pursuers = matrix[later + 1, k + 1] - current[k]
    evaders = current[k] - matrix[k + 1, later + 1]
    return Rises(float(pursuers.mean()), float(evaders.mean()))


def held_out_forgetting(one: ArrayLike, other: ArrayLike) -> Forgetting:
    """Forgetting without the luck of the best: chosen in some episodes, measured in others.

    ``one`` and ``other``, shape ``(n, m)`` each: capture rates of the same pairs in two separate
    sets of episodes. For each opponent the best ancestor is chosen by one set, and how far a
    generation falls below it is read from the other; then the sets change places, and the mean is
    taken. Pure noise gives 0 on average, where :func:`forgetting` gives what the best of many cells
    owes to chance. The same matrix twice gives :func:`forgetting`.
    """
    first, second = (check_rates(part, ndim=2, what="a payoff matrix") for part in (one, other))
    require(first.shape == second.shape, f"two matrices of shape {first.shape}", second.shape)
    pursuers = (_drops(first, second) + _drops(second, first)) / 2.0
    evaders = (_drops(1.0 - first.T, 1.0 - second.T) + _drops(1.0 - second.T, 1.0 - first.T)) / 2.0
    return Forgetting(pursuers, evaders)


def _drops(chooses: Rates, measures: Rates) -> Rates:
    """Of each row: mean over columns of the best row so far less itself; ``(n,)``."""
    best, height = chooses[0], measures[0]
    heights = []
    for chosen, measured in zip(chooses, measures, strict=True):
        best, height = np.maximum(best, chosen), np.where(chosen > best, measured, height)
        heights.append(height)
    drops: Rates = (np.array(heights) - measures).mean(axis=1)
    return drops


def one_sided_share(rates: ArrayLike) -> float:
    """Share of the last half of the generations in which one team wins both team phases.

    ``rates``, shape ``(K, 2)``, as for :func:`disengagements`, whose stretches are counted: at
    least three generations in a row that the same team wins.
    """
    generations = range(1, len(np.asarray(rates)) + 1)
    late = generations[len(generations) // 2 :]
    stretches = disengagements(rates)
    return sum(any(s.first <= k <= s.last for s in stretches) for k in late) / max(1, len(late))


def numbers_of(matrix: Rates, forgotten: Forgetting, one_sided: float | None) -> dict[str, float]:
    """The numbers of :data:`BOUNDS`, of a matrix of at least 6 x 6 generations.

    pursuer_rise, evader_rise : :func:`rises` in the last half, up to the end of the shorter side;
        least_rise is the smaller of them, greatest_rise the one farther from 0.
    checkerboards, transitive_share : as in `MEASURES`.
    one_sided : :func:`one_sided_share`, of the matrix unless given.
    forgetting : mean over the last half of the generations; most_forgetting is the larger one.
    """
    late, size = last_half(matrix), min(matrix.shape)
    rise = rises(last_half(matrix[:size, :size]))
    forgets = [float(drops[len(drops) // 2 :].mean()) for drops in forgotten]
    share = one_sided_share(half_steps(matrix)) if one_sided is None else one_sided
    values = (
        min(rise), max(rise, key=abs), *rise, MEASURES["checkerboards"].of(matrix),
        transitive_share(late), share, max(forgets), *forgets,
    )  # fmt: skip
    return dict(zip(BOUNDS, values, strict=True))


def supporting(matrix: Rates, scores: Rates | None) -> dict[str, Estimate]:
    """Numbers of one run that decide nothing, without intervals: `MEASURES`, dominance ladders."""
    values = {name: MEASURES[name].of(matrix) for name in _PLAIN}
    if scores is not None and scores.shape[2] >= FEWEST_EPISODES:
        ladders = dominance_tournament(scores)
        values["pursuer_rungs"] = float(len(ladders.pursuers))
        values["evader_rungs"] = float(len(ladders.evaders))
    return {
        name: Estimate(value, None, None, "nothing", 1, "told without an interval")
        for name, value in values.items()
    }


def numbers_of_run(
    matrix: Rates,
    scores: Rates | None,
    one_sided: float | None,
    *,
    level: float,
    resamples: int,
    rng: np.random.Generator,
) -> dict[str, Estimate]:
    """The numbers of one run, with intervals over its episodes if there are enough of them.

    Basic bootstrap intervals, as :func:`bootstrap_episodes` takes them. The value is freed from the
    noise, too: what resampling adds to it on average is taken off. Forgetting is held out, and its
    halves are resampled apart, so that no episode is in both.
    """
    if scores is None or scores.shape[2] < FEWEST_EPISODES:
        plain = numbers_of(matrix, forgetting(matrix), one_sided)
        return {
            name: Estimate(value, None, None, "nothing", 1, "noise of the episodes unknown")
            for name, value in plain.items()
        }
    halves = scores[..., ::2], scores[..., 1::2]
    held_out = held_out_forgetting(*(half.mean(axis=2) for half in halves))
    values = numbers_of(matrix, held_out, one_sided)
    drawn = list(_resampled(scores, halves, one_sided, resamples, rng))
    return {
        name: _basic(value, [one[name] for one in drawn], BOUNDS[name], level, scores.shape[2])
        for name, value in values.items()
    }


def _resampled(
    scores: Rates,
    halves: tuple[Rates, Rates],
    one_sided: float | None,
    resamples: int,
    rng: np.random.Generator,
) -> Iterator[dict[str, float]]:
    for _ in range(resamples):
        forgotten = held_out_forgetting(*(_drawn(half, rng) for half in halves))
        yield numbers_of(_drawn(scores, rng), forgotten, one_sided)


def _drawn(scores: Rates, rng: np.random.Generator) -> Rates:
    """Mean of each cell over as many of its episodes, drawn with replacement."""
    chosen = rng.integers(scores.shape[2], size=scores.shape)
    mean: Rates = np.take_along_axis(scores, chosen, axis=2).mean(axis=2)
    return mean


def _basic(
    value: float, drawn: list[float], bounds: tuple[float, float], level: float, episodes: int
) -> Estimate:
    known = [one for one in drawn if math.isfinite(one)]
    if not known or math.isnan(value):
        return Estimate(value, None, None, "nothing", episodes, "not defined for this matrix")
    tails = np.quantile(known, [(1.0 + level) / 2.0, (1.0 - level) / 2.0])
    middle, low, high = np.clip(2.0 * value - np.array([np.mean(known), *tails]), *bounds)
    return Estimate(float(middle), float(low), float(high), "episodes", episodes)
