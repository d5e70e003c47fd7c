"""Numbers behind a diagnosis, corrected for episode noise where the episodes are known."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from matrixworld.analysis.calibration import Numbers
from matrixworld.analysis.cycles import transitive_share
from matrixworld.analysis.dominance import dominance_tournament
from matrixworld.analysis.engagement import disengagements
from matrixworld.analysis.episode_intervals import resampled_means
from matrixworld.analysis.generalization import Forgetting, forgetting
from matrixworld.analysis.intervals import Estimate
from matrixworld.analysis.lags import team_phase_rates
from matrixworld.analysis.measures import MEASURES
from matrixworld.analysis.payoff import Rates, check_rates, last_half, require

FEWEST_EPISODES = 4
"""Fewest episodes of each cell for an interval: each half then has two, which show their noise."""

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
"""Range of each number by name; `numbers_of` defines the numbers."""

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
"""Numbers that are reported for each condition; the first one decides."""
_REPORTED = (
    "capture_rate", "swing", "pursuer_fading", "evader_fading", "pursuer_stripes", "evader_stripes",
)  # fmt: skip


class Rises(NamedTuple):
    """Gain of each team on past opponents, in [-1, 1].

    Parameters
    ----------
    pursuers : float
        Gain of the pursuers.
    evaders : float
        Gain of the evaders.
    """

    pursuers: float
    evaders: float


def rises(payoff: ArrayLike) -> Rises:
    """Return how much each team gains on opponents of the past.

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
        Payoff matrix of at least 3 x 3 generations. Generations beyond the end of the shorter side
        have no current opponent and are left out.

    Returns
    -------
    Rises
        Mean over pairs of generations ``1 <= k < g`` of the team's score in generation g against
        the opponents of generation k, minus its mean score in both team phases of generation k.

    Raises
    ------
    ValueError
        If there are fewer generations.

    Notes
    -----
    In an arms race both teams rise, while current matches may stay even. In a cycle later losses
    cancel earlier gains. A team that does not change has a rise of 0, except for half of what its
    opponents gain in one generation.
    """
    matrix = check_rates(payoff, ndim=2, what="a payoff matrix")
    size = min(matrix.shape)
    require(size >= 3, "at least 3 x 3 generations", matrix.shape)
    current = team_phase_rates(matrix).mean(axis=1)
    # All pairs k < g; index i stands for generation i + 1, since generation 0 has no team phases.
    k, later = np.triu_indices(size - 1, k=1)
    pursuers = matrix[later + 1, k + 1] - current[k]
    evaders = current[k] - matrix[k + 1, later + 1]
    return Rises(float(pursuers.mean()), float(evaders.mean()))


def held_out_forgetting(one: ArrayLike, other: ArrayLike) -> Forgetting:
    """Return forgetting without selection bias: best ancestors are chosen in other episodes.

    Parameters
    ----------
    one : array_like of float, shape (n, m)
        Capture rates of all pairs in one set of episodes.
    other : array_like of float, shape (n, m)
        Capture rates of the same pairs in other episodes.

    Returns
    -------
    Forgetting
        Drop of each generation below the best ancestor, mean over opponents.

    Raises
    ------
    ValueError
        If the shapes differ, or these are not payoff matrices.

    Notes
    -----
    For each opponent one set of episodes chooses the best ancestor, and the other set measures how
    far a generation falls below it; then the sets change roles, and the mean is taken. Pure noise
    gives 0 on average. `forgetting` chooses and measures in the same episodes, so the best of many
    noisy cells is too high. The same matrix twice gives `forgetting`.
    """
    first, second = (check_rates(part, ndim=2, what="a payoff matrix") for part in (one, other))
    require(first.shape == second.shape, f"two matrices of shape {first.shape}", second.shape)
    # Each set of episodes chooses once and measures once, so that no episode is wasted.
    pursuers = (_drops(first, second) + _drops(second, first)) / 2.0
    evaders = (_drops(1.0 - first.T, 1.0 - second.T) + _drops(1.0 - second.T, 1.0 - first.T)) / 2.0
    return Forgetting(pursuers, evaders)


def _drops(chooses: Rates, measures: Rates) -> Rates:
    """Return the drop of each row below the best row so far, mean over columns; shape (n,)."""
    # `best` decides which row is the best so far, `height` is its value in the other episodes.
    best, height = chooses[0], measures[0]
    heights = []
    for chosen, measured in zip(chooses, measures, strict=True):
        # A strict comparison: of equal ancestors the first one stays the best.
        best, height = np.maximum(best, chosen), np.where(chosen > best, measured, height)
        heights.append(height)
    drops: Rates = (np.array(heights) - measures).mean(axis=1)
    return drops


def one_sided_share(rates: ArrayLike) -> float:
    """Return the share of the last half of the generations that lies within `disengagements`.

    Parameters
    ----------
    rates : array_like of float, shape (K, 2)
        Capture rates after both team phases of each generation, as for `disengagements`.

    Returns
    -------
    float
        In [0, 1]; 0 without generations.
    """
    generations = range(1, len(np.asarray(rates)) + 1)
    late = generations[len(generations) // 2 :]
    stretches = disengagements(rates)
    return sum(any(s.first <= k <= s.last for s in stretches) for k in late) / max(1, len(late))


def numbers_of(matrix: Rates, forgotten: Forgetting, one_sided: float | None) -> dict[str, float]:
    """Compute the numbers of `BOUNDS` for one matrix.

    Parameters
    ----------
    matrix : ndarray of float64, shape (n, m)
        Payoff matrix of at least 6 x 6 generations.
    forgotten : Forgetting
        Forgetting of both teams in this matrix.
    one_sided : float or None
        Share of one-sided generations; None: from the matrix.

    Returns
    -------
    dict of str to float
        ``pursuer_rise`` and ``evader_rise``: `rises` in the last half, up to the end of the shorter
        side. ``least_rise`` is the smaller of them, ``greatest_rise`` the one farther from 0.
        ``checkerboards`` and ``transitive_share``: as in `MEASURES`. ``one_sided``: as
        `one_sided_share`. ``pursuer_forgetting`` and ``evader_forgetting``: means over the last
        half of the generations; ``most_forgetting`` is the larger one.
    """
    # Rises need current opponents, so they use the square part of the matrix.
    late, size = last_half(matrix), min(matrix.shape)
    rise = rises(last_half(matrix[:size, :size]))
    forgets = [float(drops[len(drops) // 2 :].mean()) for drops in forgotten]
    share = one_sided_share(team_phase_rates(matrix)) if one_sided is None else one_sided
    # In the order of BOUNDS.
    values = (
        min(rise), max(rise, key=abs), *rise, MEASURES["checkerboards"].of(matrix),
        transitive_share(late), share, max(forgets), *forgets,
    )  # fmt: skip
    return dict(zip(BOUNDS, values, strict=True))


def supporting(matrix: Rates, scores: Rates | None) -> Numbers:
    """Return numbers of one run that are reported beside the deciding ones, without intervals."""
    values = {name: MEASURES[name].of(matrix) for name in _REPORTED}
    if scores is not None and scores.shape[2] >= FEWEST_EPISODES:
        ladders = dominance_tournament(scores)
        values["pursuer_rungs"] = float(len(ladders.pursuers))
        values["evader_rungs"] = float(len(ladders.evaders))
    return {
        name: Estimate(value, None, None, "nothing", 1, "reported without an interval")
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
) -> Numbers:
    """Compute the numbers of one run, with intervals over its episodes if there are enough.

    Parameters
    ----------
    matrix : ndarray of float64, shape (n, m)
        Payoff matrix.
    scores : ndarray of float64, shape (n, m, episodes), or None
        Capture rates of the episodes, if they are known.
    one_sided : float or None
        Share of one-sided generations; None: from the matrix.
    level : float
        Confidence level.
    resamples : int
        Number of resamples.
    rng : numpy.random.Generator
        Generator of the resamples.

    Returns
    -------
    dict of str to Estimate
        The numbers of `numbers_of`. With at least `FEWEST_EPISODES` episodes of each cell they have
        basic bootstrap intervals, as in `bootstrap_episodes`, and the mean change by resampling is
        subtracted from the value, too.
    """
    if scores is None or scores.shape[2] < FEWEST_EPISODES:
        plain = numbers_of(matrix, forgetting(matrix), one_sided)
        return {
            name: Estimate(value, None, None, "nothing", 1, "episode noise unknown")
            for name, value in plain.items()
        }
    # Even and odd episodes; forgetting chooses in one half and measures in the other.
    halves = scores[..., ::2], scores[..., 1::2]
    held_out = held_out_forgetting(*(half.mean(axis=2) for half in halves))
    values = numbers_of(matrix, held_out, one_sided)
    resampled = list(_resampled(scores, halves, one_sided, resamples, rng))
    return {
        name: _corrected(
            value, [one[name] for one in resampled], BOUNDS[name], level, scores.shape[2]
        )
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
        # The halves are resampled separately, so that no episode is in both.
        forgotten = held_out_forgetting(*(resampled_means(half, rng) for half in halves))
        yield numbers_of(resampled_means(scores, rng), forgotten, one_sided)


def _corrected(
    value: float,
    resampled: Sequence[float],
    bounds: tuple[float, float],
    level: float,
    episodes: int,
) -> Estimate:
    """Return the value minus the bias of resampling, with a basic interval."""
    known = [one for one in resampled if math.isfinite(one)]
    if not known or math.isnan(value):
        return Estimate(value, None, None, "nothing", episodes, "not defined for this matrix")
    tails = np.quantile(known, [(1.0 + level) / 2.0, (1.0 - level) / 2.0])
    # Resampling moves a number about as far from the value as noise moved the value from the
    # truth: the bias is subtracted once, the quantiles are reflected.
    middle, low, high = np.clip(2.0 * value - np.array([np.mean(known), *tails]), *bounds)
    return Estimate(float(middle), float(low), float(high), "episodes", episodes)
