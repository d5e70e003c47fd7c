"""Synthetic races: capture rates without noise, by formula, so that the truth about them is known.

A kind of race is a function of the number of generations n, an effect size (1 is plain to see) and
nuisance parameters (levels, slopes, phases, differences between the teams), which are drawn from a
seed. Throughout, t in [0, 1] is the time of a generation, p_g and e_h are strengths in logits, and
sigma(x) = 1 / (1 + exp(-x)).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial

import numpy as np
from scipy.special import expit, logit

from matrixworld.coevolution.types import FloatArray


@dataclass(frozen=True)
class SyntheticRace:
    """A race of known capture rates, and the strength *by design* of each generation, in any unit.

    Chance is left out: the strength is constant where it drifts.
    """

    rates: FloatArray  # that pursuers of generation g capture an evader of generation h, (n, n)
    pursuers: FloatArray  # (n,)
    evaders: FloatArray  # (n,)


class Draws:
    """Nuisance parameters of a run: a part that all runs of a group share, and a part of its own.

    `seed` is that of the group, `run` the index of the run in it.
    """

    def __init__(self, seed: int, run: int = 0) -> None:
        self.run = run
        self.shared: np.random.Generator = np.random.default_rng([seed, 0])
        self.own: np.random.Generator = np.random.default_rng([seed, 1, run])

    def level(self) -> float:
        """Return a level in logits: N(0, .4) of the group + N(0, .15) of the run."""
        return float(self.shared.normal(0.0, 0.4) + self.own.normal(0.0, 0.15))

    def size(self, low: float, high: float) -> float:
        """Return a size: uniform in the group, times exp(N(0, .15)) of the run."""
        return float(self.shared.uniform(low, high) * np.exp(self.own.normal(0.0, 0.15)))

    def lag(self) -> float:
        """Return the angle between the teams in a cycle: 45 to 135 degrees either way."""
        return float(self.own.choice((-1.0, 1.0)) * np.pi * self.own.uniform(0.25, 0.75))

    def sizes(self, size: float) -> tuple[float, float]:
        """Return the sizes of pursuers and evaders: one up to 1.3 times the size, one down."""
        ratio = np.exp(self.shared.uniform(-1.0, 1.0) * np.log(1.3))
        return size * ratio * self.size(1.0, 1.0), size / ratio * self.size(1.0, 1.0)


def time(n: int) -> FloatArray:
    """Return the time (n,) of each generation."""
    return np.linspace(0.0, 1.0, n)


def additive(
    p: FloatArray, e: FloatArray, level: float, cycle: FloatArray | float = 0.0
) -> SyntheticRace:
    """Return ``M = sigma(level + p_g - e_h + cycle_gh)``; p and e are by design."""
    return SyntheticRace(expit(level + p[:, None] - e + cycle), p, e)


def race(n: int, effect: float, draws: Draws, *, total: float) -> SyntheticRace:
    """``p = a t``, ``e = b t``: both teams rise evenly, by about `total` logits."""
    a, b = draws.sizes(effect * total)
    return additive(a * time(n), b * time(n), draws.level())


def slow_race(n: int, effect: float, draws: Draws) -> SyntheticRace:
    """``M = sigma(s (g - h))`` with s at most .1 a generation, whatever n."""
    return race(n, effect, draws, total=(n - 1) * draws.shared.uniform(0.03, 0.1))


def one_sided(n: int, effect: float, draws: Draws, *, pursuers: bool) -> SyntheticRace:
    """One team rises by ``c t``, c = 2 to 4 logits; the other stands still."""
    rising = effect * draws.size(2.0, 4.0) * time(n)
    # The level moves to the middle, so that captures are neither rare nor certain.
    middle = draws.level() - (1 if pursuers else -1) * rising[-1] / 2.0
    still = np.zeros(n)
    return additive(rising, still, middle) if pursuers else additive(still, rising, middle)


def rotation(n: int, periods: float, draws: Draws, radius: FloatArray | float = 1.0) -> FloatArray:
    """Return ``r_g r_h cos(angle_g - angle_h + lag)``: skill on a circle, `periods` times round."""
    # At least five generations in a period; a faster circle could not be seen.
    angle = 2.0 * np.pi * min(periods, n / 5.0) * time(n)
    reach = np.broadcast_to(radius, n)
    return np.asarray(reach[:, None] * reach * np.cos(angle[:, None] - angle + draws.lag()))


def cycle(
    n: int, effect: float, draws: Draws, *, periods: tuple[float, ...], climb: float = 0.0
) -> SyntheticRace:
    """Rotate the skill, amplitude 1.5 to 3 logits, while both teams climb by `climb` logits."""
    a, b = draws.sizes(climb)
    circle = rotation(n, float(draws.shared.choice(periods)), draws)
    level, amplitude = draws.level(), effect * draws.size(1.5, 3.0)
    return additive(a * time(n), b * time(n), level, amplitude * circle)


def constant(n: int, effect: float, draws: Draws, *, rate: float) -> SyntheticRace:
    """``M = rate`` for all pairs: whatever is seen is noise. The effect size has no effect."""
    del effect
    level = logit(rate) + draws.own.normal(0.0, 0.15)
    return additive(np.zeros(n), np.zeros(n), level)


def drift(n: int, effect: float, draws: Draws) -> SyntheticRace:
    """``p`` and ``e`` are independent random walks that end at N(0, 1) logits, without a trend."""
    walks = effect * np.cumsum(draws.own.normal(size=(2, n)), axis=1) / np.sqrt(n)
    flat = np.zeros(n)
    return SyntheticRace(additive(*walks, draws.level()).rates, flat, flat)


def stagnation(n: int, effect: float, draws: Draws, *, until: float) -> SyntheticRace:
    """``p = a min(t / until, 1)``: both rise by about 4 logits, and stand still from `until` on."""
    rise = np.minimum(time(n) / until, 1.0)
    a, b = draws.sizes(4.0 * effect)
    return additive(a * rise, b * rise, draws.level())


SYNTHETIC: Mapping[str, Callable[[int, float, Draws], SyntheticRace]] = {
    "pure race": partial(race, total=4.0),
    "slow race": slow_race,
    "only pursuers rise": partial(one_sided, pursuers=True),
    "only evaders rise": partial(one_sided, pursuers=False),
    "cycle": partial(cycle, periods=(2.0, 4.0)),
    "noise only, .5": partial(constant, rate=0.5),
    "drift": drift,
    "early stagnation": partial(stagnation, until=1 / 3),
}
"""Kinds of races by name; `judgement_races` has more of them."""


TOGETHER = 4.0
"""Fates of an episode's evaders: Beta(4 M, 4 (1 - M)), so that their correlation is 1 / 5."""


def play_episodes(
    rates: FloatArray,
    episodes: int,
    rng: np.random.Generator,
    *,
    evaders: int = 1,
    matchups: float = 0.0,
) -> FloatArray:
    """Play matches of known capture rates (...), and return the captured fractions (..., episodes).

    With one evader they are Bernoulli(M); with k: Binomial(k, q) / k with q from
    Beta(4 M, 4 (1 - M)) once an episode. M is the rate plus N(0, `matchups`) of the pair, which is
    the same in all of its episodes.
    """
    true = np.clip(rates + matchups * rng.standard_normal(rates.shape), 0.0, 1.0)
    chances = np.repeat(true[..., None], episodes, axis=-1)
    if evaders > 1:
        # Beta distributions have no parameter 0.
        inside = TOGETHER * np.clip(chances, 1e-9, 1.0 - 1e-9)
        chances = rng.beta(inside, TOGETHER - inside)
    return np.asarray(rng.binomial(evaders, chances) / evaders)
