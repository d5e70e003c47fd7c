"""Formulas of synthetic races: true capture rates, and the strength that each team has by design.

Each function takes the number of generations n, an effect size (1 is plain to see) and the nuisance
parameters' `Draws`. Throughout, t in [0, 1] is the time of a generation, p_g and e_h are strengths
in logits, and sigma(x) = 1 / (1 + exp(-x)).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from matrixworld.coevolution.types import FloatArray


@dataclass(frozen=True)
class SyntheticRace:
    """A race of known capture rates.

    Parameters
    ----------
    rates : ndarray of float64, shape (n, n)
        Probability that pursuers of generation g capture an evader of generation h.
    pursuers : ndarray of float64, shape (n,)
        Strength by design of each generation of pursuers, in any unit. Chance is left out: it is
        constant where strength drifts.
    evaders : ndarray of float64, shape (n,)
        The same of the evaders.
    """

    rates: FloatArray
    pursuers: FloatArray
    evaders: FloatArray


class Draws:
    """Nuisance parameters of a run: a part that all runs of a group share, and a part of its own.

    Parameters
    ----------
    seed : int
        Seed of the group.
    run : int
        Index of the run in its group.
    """

    def __init__(self, seed: int, run: int = 0) -> None:
        self.shared: np.random.Generator = np.random.default_rng([seed, 0])
        self.own: np.random.Generator = np.random.default_rng([seed, 1, run])

    def level(self) -> float:
        """Return a level in logits: N(0, .4) of the group + N(0, .15) of the run."""
        return float(self.shared.normal(0.0, 0.4) + self.own.normal(0.0, 0.15))

    def size(self, low: float, high: float) -> float:
        """Return a size: uniform in the group, times exp(N(0, .15)) of the run."""
        return float(self.shared.uniform(low, high) * np.exp(self.own.normal(0.0, 0.15)))

    def moment(self, low: float, high: float) -> float:
        """Return a time: uniform in the group + N(0, .01) of the run."""
        return float(self.shared.uniform(low, high) + self.own.normal(0.0, 0.01))

    def lag(self) -> float:
        """Return the angle between the teams in a cycle: 45 to 135 degrees either way."""
        return float(self.own.choice((-1.0, 1.0)) * np.pi * self.own.uniform(0.25, 0.75))

    def sizes(self, size: float) -> tuple[float, float]:
        """Return the sizes of pursuers and evaders: one up to 1.3 times the size, one down."""
        ratio = np.exp(self.shared.uniform(-1.0, 1.0) * np.log(1.3))
        return size * ratio * self.size(1.0, 1.0), size / ratio * self.size(1.0, 1.0)

    def coin(self) -> bool:
        """Return True or False, the same for the group."""
        return bool(self.shared.random() < 0.5)


def sigma(x: FloatArray) -> FloatArray:
    """Return ``1 / (1 + exp(-x))``."""
    return np.asarray(1.0 / (1.0 + np.exp(-x)))


def _logit(rate: float) -> float:
    return float(np.log(rate / (1.0 - rate)))


def _time(n: int) -> FloatArray:
    return np.linspace(0.0, 1.0, n)


def _additive(
    p: FloatArray, e: FloatArray, level: float, cycle: FloatArray | float = 0.0
) -> SyntheticRace:
    """Return ``M = sigma(level + p_g - e_h + cycle_gh)``; p and e are by design."""
    return SyntheticRace(sigma(level + p[:, None] - e + cycle), p, e)


def _by_chance(walks: FloatArray, level: float) -> SyntheticRace:
    """Return ``M = sigma(level + p_g - e_h)``, where p and e (2, n) come from chance."""
    flat = np.zeros(walks.shape[1])
    return SyntheticRace(_additive(walks[0], walks[1], level).rates, flat, flat)


def _of_one_team(
    course: FloatArray, other: FloatArray, level: float, *, pursuers: bool
) -> SyntheticRace:
    """Return a race in which the named team has the strength `course`, the other one `other`."""
    return _additive(course, other, level) if pursuers else _additive(other, course, level)


# ---- Races ---------------------------------------------------------------------------------------


def race(n: int, effect: float, draws: Draws, *, total: float) -> SyntheticRace:
    """``p = a t``, ``e = b t``: both teams rise evenly, by about `total` logits."""
    a, b = draws.sizes(effect * total)
    return _additive(a * _time(n), b * _time(n), draws.level())


def slow_race(n: int, effect: float, draws: Draws) -> SyntheticRace:
    """``M = sigma(s (g - h))`` with s at most .1 a generation, whatever n."""
    return race(n, effect, draws, total=(n - 1) * draws.shared.uniform(0.03, 0.1))


def one_sided(n: int, effect: float, draws: Draws, *, pursuers: bool) -> SyntheticRace:
    """One team rises by ``c t``, c = 2 to 4 logits; the other stands still."""
    rising = effect * draws.size(2.0, 4.0) * _time(n)
    # The level moves to the middle, so that captures are neither rare nor certain.
    middle = draws.level() - (1 if pursuers else -1) * rising[-1] / 2.0
    return _of_one_team(rising, np.zeros(n), middle, pursuers=pursuers)


def uneven_pace(n: int, effect: float, draws: Draws) -> SyntheticRace:
    """Both teams gain exponential amounts in 40 % of the steps; one gains 2 to 3 times as much."""
    steps = draws.own.exponential(size=(2, n)) * (draws.own.random((2, n)) < 0.4)
    fast, slow = 5.0 * effect * np.cumsum(steps, axis=1) / (0.4 * n)
    slow = slow / draws.size(2.0, 3.0)
    return _of_one_team(fast, slow, draws.level(), pursuers=draws.coin())


def saturating(n: int, effect: float, draws: Draws) -> SyntheticRace:
    """``M = clip(.5 + a g - b h, floor, ceiling)``: differences beyond the limits do not count."""
    a, b = (size * _time(n) for size in draws.sizes(1.2 * effect))
    floor, ceiling = draws.shared.uniform(0.05, 0.25), draws.shared.uniform(0.7, 0.92)
    return SyntheticRace(np.clip(0.5 + a[:, None] - b, floor, ceiling), a, b)


def two_skills(n: int, effect: float, draws: Draws) -> SyntheticRace:
    """``M = sigma(1 + a_g - b_h) sigma(1 + c_g - d_h)``: to win needs both of two skills.

    Each skill rises at its own time, so no strength ``f(p_g - e_h)`` explains the rates; but a
    later generation is never worse against any opponent.
    """
    t = _time(n)
    a, d = (size * t**2 for size in draws.sizes(4.0 * effect))
    b, c = (size * np.sqrt(t) for size in draws.sizes(4.0 * effect))
    rates = sigma(1.0 + a[:, None] - b) * sigma(1.0 + c[:, None] - d)
    return SyntheticRace(rates, a + c, b + d)


# ---- Cycles --------------------------------------------------------------------------------------


def _rotation(n: int, periods: float, draws: Draws, radius: FloatArray | float = 1.0) -> FloatArray:
    """Return ``r_g r_h cos(angle_g - angle_h + lag)``: skill on a circle, `periods` times round."""
    # At least five generations in a period; a faster circle could not be seen.
    angle = 2.0 * np.pi * min(periods, n / 5.0) * _time(n)
    reach = np.broadcast_to(radius, n)
    return np.asarray(reach[:, None] * reach * np.cos(angle[:, None] - angle + draws.lag()))


def cycle(
    n: int, effect: float, draws: Draws, *, periods: tuple[float, ...], climb: float = 0.0
) -> SyntheticRace:
    """Rotate the skill, amplitude 1.5 to 3 logits, while both teams climb by `climb` logits."""
    a, b = draws.sizes(climb)
    rotation = _rotation(n, float(draws.shared.choice(periods)), draws)
    level, amplitude = draws.level(), effect * draws.size(1.5, 3.0)
    return _additive(a * _time(n), b * _time(n), level, amplitude * rotation)


def hands(n: int, effect: float, draws: Draws) -> SyntheticRace:
    """Rock-paper-scissors: ``M = sigma(+c, 0, -c)``, hands change one after the other."""
    turns = 3.0 * min(float(draws.shared.choice((2.0, 3.0, 4.5))), n / 4.0)
    start, lag = draws.own.integers(3, size=2)
    hands = (start + np.floor(turns * _time(n))).astype(int)
    difference = (hands[:, None] - hands + lag) % 3
    amplitude = effect * draws.size(2.5, 4.0)
    flat = np.zeros(n)
    return _additive(flat, flat, 0.0, amplitude * np.array([0.0, 1.0, -1.0])[difference])


def wave_then(n: int, effect: float, draws: Draws, *, late: bool) -> SyntheticRace:
    """Return a cycle in one half of the time, a race (3 logits) in the other; `late`: cycle last.

    ``M = sigma(a x(t_g) - b x(t_h) + c r_g r_h cos(...))`` with x rising in the race's half, and r
    falling from 1 to 0 between the halves (.4 to .5 early, .5 to .6 late).
    """
    t = _time(n)
    radius = np.clip((t - 0.5) / 0.1 if late else (0.5 - t) / 0.1, 0.0, 1.0)
    rise = np.clip(2.0 * t if late else 2.0 * t - 1.0, 0.0, 1.0)
    a, b = draws.sizes(3.0)
    rotation = _rotation(n, draws.shared.uniform(3.0, 6.0), draws, radius)
    amplitude = effect * draws.size(1.5, 3.0)
    return _additive(a * rise, b * rise, draws.level(), amplitude * rotation)


# ---- Nobody gains, or not for long ---------------------------------------------------------------


def constant(n: int, effect: float, draws: Draws, *, rate: float) -> SyntheticRace:
    """``M = rate`` for all pairs: whatever is seen is noise. The effect size has no effect."""
    del effect
    level = _logit(rate) + draws.own.normal(0.0, 0.15)
    return _additive(np.zeros(n), np.zeros(n), level)


def drift(n: int, effect: float, draws: Draws) -> SyntheticRace:
    """``p`` and ``e`` are independent random walks that end at N(0, 1) logits, without a trend."""
    walks = effect * np.cumsum(draws.own.normal(size=(2, n)), axis=1) / np.sqrt(n)
    return _by_chance(walks, draws.level())


def fluctuation(n: int, effect: float, draws: Draws) -> SyntheticRace:
    """``x_t = .6 x_{t-1} + noise``, standard deviation .5 logits: strength returns to its mean."""
    kept, noise = 0.6, draws.own.normal(size=(n, 2))
    x = [noise[0]]
    for step in noise[1:]:
        x.append(kept * x[-1] + np.sqrt(1.0 - kept**2) * step)
    return _by_chance(0.5 * effect * np.array(x).T, draws.level())


def stagnation(n: int, effect: float, draws: Draws, *, until: float) -> SyntheticRace:
    """``p = a min(t / until, 1)``: both rise by about 4 logits, and stand still from `until` on."""
    rise = np.minimum(_time(n) / until, 1.0)
    a, b = draws.sizes(4.0 * effect)
    return _additive(a * rise, b * rise, draws.level())


def jump(n: int, effect: float, draws: Draws) -> SyntheticRace:
    """Each team jumps by about 2 logits, once, at its own moment between t = .2 and .8."""
    a, b = draws.sizes(2.0 * effect)
    p, e = (np.where(_time(n) > draws.moment(0.2, 0.8), size, 0.0) for size in (a, b))
    return _additive(p, e, draws.level())


# ---- Losses --------------------------------------------------------------------------------------


def forgetting(n: int, effect: float, draws: Draws) -> SyntheticRace:
    """Both teams rise by 3 logits; one loses 2 to 4 logits against opponents older than a lag.

    ``M = sigma(a t_g - b t_h - c [t_g - t_h > lag])`` if the pursuers forget, lag .12 to .3.
    """
    t, lag = _time(n), draws.moment(0.12, 0.3)
    a, b = draws.sizes(3.0)
    lost = np.where(t[:, None] - t > lag, effect * draws.size(2.0, 4.0), 0.0)
    return _additive(a * t, b * t, draws.level(), -lost if draws.coin() else lost.T)


def decline(n: int, effect: float, draws: Draws) -> SyntheticRace:
    """One team rises by 2 logits up to t = .5, then falls by 3; the other rises by 1."""
    t = _time(n)
    course = 4.0 * np.minimum(t, 0.5) - 6.0 * effect * np.maximum(t - 0.5, 0.0)
    return _of_one_team(draws.size(0.8, 1.2) * course, t, draws.level(), pursuers=draws.coin())


def collapse(n: int, effect: float, draws: Draws) -> SyntheticRace:
    """Both teams rise by 3 logits; from t = .7 to .85 one loses 3 to 5."""
    t, start = _time(n), draws.moment(0.68, 0.75)
    a, b = draws.sizes(3.0)
    lost = effect * draws.size(3.0, 5.0) * np.clip((t - start) / 0.12, 0.0, 1.0)
    pursuers = draws.coin()
    return _additive(
        a * t - lost * pursuers, b * t - lost * (not pursuers), draws.level() * (1 - effect / 4)
    )


def disengagement(n: int, effect: float, draws: Draws, *, rate: float) -> SyntheticRace:
    """Return a race (2 logits), until one team wins `rate` of the current matches from an onset on.

    The onset lies between t = 0 and .4, and takes .05. From then on both stand still. The effect
    size has no effect.
    """
    del effect
    t, onset = _time(n), draws.moment(0.0, 0.4)
    race = draws.size(1.5, 2.5) * np.minimum(t, onset)
    ahead = _logit(rate) * np.clip((t - onset) / 0.05, 0.0, 1.0)
    return _of_one_team(race + ahead, race, 0.0, pursuers=draws.coin())
