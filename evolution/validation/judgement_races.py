"""Races for measuring the judgement: capture rates without noise, by formula, of 57 kinds.

A kind of race is a function of the number of generations n, an effect size (1 is plain to see) and
nuisance parameters (levels, slopes, phases, differences between the teams), which are drawn from a
seed. Throughout, t in [0, 1] is the time of a generation, p_g and e_h are strengths in logits, and
sigma(x) = 1 / (1 + exp(-x)). `judgement_truths` says what is true of a race.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import NamedTuple

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


# ---- Races ---------------------------------------------------------------------------------------


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
    return of_one_team(rising, np.zeros(n), middle, pursuers=pursuers)


def moment(draws: Draws, low: float, high: float) -> float:
    """Return a time: uniform in the group + N(0, .01) of the run."""
    return float(draws.shared.uniform(low, high) + draws.own.normal(0.0, 0.01))


def coin(draws: Draws) -> bool:
    """Return True or False, the same for the group."""
    return bool(draws.shared.random() < 0.5)


def by_chance(walks: FloatArray, level: float) -> SyntheticRace:
    """Return ``M = sigma(level + p_g - e_h)``, where p and e (2, n) come from chance."""
    flat = np.zeros(walks.shape[1])
    return SyntheticRace(additive(walks[0], walks[1], level).rates, flat, flat)


def of_one_team(
    course: FloatArray, other: FloatArray, level: float, *, pursuers: bool
) -> SyntheticRace:
    """Return a race in which the named team has the strength `course`, the other one `other`."""
    return additive(course, other, level) if pursuers else additive(other, course, level)


def uneven_pace(n: int, effect: float, draws: Draws) -> SyntheticRace:
    """Both teams gain exponential amounts in 40 % of the steps; one gains 2 to 3 times as much."""
    steps = draws.own.exponential(size=(2, n)) * (draws.own.random((2, n)) < 0.4)
    fast, slow = 5.0 * effect * np.cumsum(steps, axis=1) / (0.4 * n)
    slow = slow / draws.size(2.0, 3.0)
    return of_one_team(fast, slow, draws.level(), pursuers=coin(draws))


def saturating(n: int, effect: float, draws: Draws) -> SyntheticRace:
    """``M = clip(.5 + a g - b h, floor, ceiling)``: differences beyond the limits do not count."""
    a, b = (size * time(n) for size in draws.sizes(1.2 * effect))
    floor, ceiling = draws.shared.uniform(0.05, 0.25), draws.shared.uniform(0.7, 0.92)
    return SyntheticRace(np.clip(0.5 + a[:, None] - b, floor, ceiling), a, b)


def two_skills(n: int, effect: float, draws: Draws) -> SyntheticRace:
    """``M = sigma(1 + a_g - b_h) sigma(1 + c_g - d_h)``: to win needs both of two skills.

    Each skill rises at its own time, so no strength ``f(p_g - e_h)`` explains the rates; but a
    later generation is never worse against any opponent.
    """
    t = time(n)
    a, d = (size * t**2 for size in draws.sizes(4.0 * effect))
    b, c = (size * np.sqrt(t) for size in draws.sizes(4.0 * effect))
    rates = expit(1.0 + a[:, None] - b) * expit(1.0 + c[:, None] - d)
    return SyntheticRace(rates, a + c, b + d)


def sigmoid(n: int, effect: float, draws: Draws) -> SyntheticRace:
    """Both teams rise by about 2 logits, most of it between t = .35 and .65."""
    course = expit((time(n) - moment(draws, 0.4, 0.6)) / 0.08)
    a, b = draws.sizes(2.0 * effect)
    return additive(a * course, b * course, draws.level())


def early_dip(n: int, effect: float, draws: Draws) -> SyntheticRace:
    """Both teams rise evenly by 2 logits; at t = .1 they are .75 logits lower for a while."""
    t = time(n)
    course = t - 0.375 * np.exp(-(((t - 0.1) / 0.07) ** 2))
    a, b = draws.sizes(2.0 * effect)
    return additive(a * course, b * course, draws.level())


def late_onset(n: int, effect: float, draws: Draws) -> SyntheticRace:
    """Nobody gains up to t = .6; then both teams rise by 2 logits."""
    course = np.clip((time(n) - 0.6) / 0.4, 0.0, 1.0)
    a, b = draws.sizes(2.0 * effect)
    return additive(a * course, b * course, draws.level())


def heavy_tails(
    n: int, effect: float, draws: Draws, *, trend: float, free: float = 1.5
) -> SyntheticRace:
    """Both teams rise evenly by `trend` logits, and each generation has luck with heavy tails.

    The luck is .25 times Student's t with so many degrees of freedom: 1.5 has no variance.
    """
    rises = np.array(draws.sizes(trend * effect))[:, None] * time(n)
    luck = 0.25 * draws.own.standard_t(free, (2, n))
    return SyntheticRace(additive(*(rises + luck), draws.level()).rates, *rises)


def failed_generations(
    n: int, effect: float, draws: Draws, *, trend: float, length: int = 1, sign: float = -1.0
) -> SyntheticRace:
    """Both teams rise evenly by `trend` logits, but 5 to 20 % of the generations fail.

    A failure costs 2 to 4 logits for `length` generations; with a sign of 1 it is luck instead.
    """
    rises = np.array(draws.sizes(trend * effect))[:, None] * time(n)
    begins = draws.own.random((2, n)) < draws.shared.uniform(0.05, 0.2) / length
    failed = begins.copy()
    for later in range(1, length):
        failed[:, later:] |= begins[:, :-later]
    size = sign * draws.shared.uniform(2.0, 4.0)
    strengths = rises + np.where(failed, size, 0.0)
    return SyntheticRace(additive(*strengths, draws.level()).rates, *rises)


def heavy_steps(n: int, effect: float, draws: Draws) -> SyntheticRace:
    """Strengths are walks whose steps have heavy tails: Student's t with 1.5 degrees of freedom."""
    walks = 0.6 * effect * np.cumsum(draws.own.standard_t(1.5, (2, n)), axis=1) / np.sqrt(n)
    return by_chance(np.clip(walks, -8.0, 8.0), draws.level())


# ---- Cycles --------------------------------------------------------------------------------------


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


def hands(n: int, effect: float, draws: Draws) -> SyntheticRace:
    """Rock-paper-scissors: ``M = sigma(+c, 0, -c)``, hands change one after the other."""
    turns = 3.0 * min(float(draws.shared.choice((2.0, 3.0, 4.5))), n / 4.0)
    start, lag = draws.own.integers(3, size=2)
    hands = (start + np.floor(turns * time(n))).astype(int)
    difference = (hands[:, None] - hands + lag) % 3
    amplitude = effect * draws.size(2.5, 4.0)
    flat = np.zeros(n)
    return additive(flat, flat, 0.0, amplitude * np.array([0.0, 1.0, -1.0])[difference])


def wave_then(n: int, effect: float, draws: Draws, *, late: bool) -> SyntheticRace:
    """Return a cycle in one half of the time, a race (3 logits) in the other; `late`: cycle last.

    ``M = sigma(a x(t_g) - b x(t_h) + c r_g r_h cos(...))`` with x rising in the race's half, and r
    falling from 1 to 0 between the halves (.4 to .5 early, .5 to .6 late).
    """
    t = time(n)
    radius = np.clip((t - 0.5) / 0.1 if late else (0.5 - t) / 0.1, 0.0, 1.0)
    rise = np.clip(2.0 * t if late else 2.0 * t - 1.0, 0.0, 1.0)
    a, b = draws.sizes(3.0)
    circle = rotation(n, draws.shared.uniform(3.0, 6.0), draws, radius)
    amplitude = effect * draws.size(1.5, 3.0)
    return additive(a * rise, b * rise, draws.level(), amplitude * circle)


def styles(n: int, effect: float, draws: Draws, *, kinds: int) -> SyntheticRace:
    """Teams have one style after the other, and none returns: who wins depends on both styles."""
    ends = [(np.arange(1, kinds) + draws.own.uniform(-0.25, 0.25, kinds - 1)) / kinds for _ in "pe"]
    style = [np.searchsorted(each, time(n), "right") for each in ends]
    # Each style of the pursuers has one style of the evaders that it beats.
    wins = kinds * np.eye(kinds)[draws.shared.permutation(kinds)] - 1.0
    flat = np.zeros(n)
    amplitude = effect * draws.size(1.5, 3.0)
    return additive(flat, flat, draws.level(), amplitude * wins[np.ix_(*style)])


def slow_turn(n: int, effect: float, draws: Draws) -> SyntheticRace:
    """Skill turns by less than half a circle, so that none returns; strength is the mean score."""
    angle = np.pi * draws.shared.uniform(0.3, 0.9) * time(n)
    turn = np.cos(angle[:, None] - angle + draws.lag())
    flat, amplitude = np.zeros(n), effect * draws.size(1.5, 3.0)
    rates = additive(flat, flat, draws.level(), amplitude * turn).rates
    return SyntheticRace(rates, rates.mean(axis=1), 1.0 - rates.mean(axis=0))


def new_styles(n: int, effect: float, draws: Draws) -> SyntheticRace:
    """Each generation has a style of its own, drawn at random in 30 dimensions."""
    p, e = draws.own.normal(size=(2, n, 30)) / np.sqrt(30.0)
    amplitude = effect * draws.size(4.0, 8.0)
    return additive(np.zeros(n), np.zeros(n), draws.level(), amplitude * p @ e.T)


def period_two(n: int, effect: float, draws: Draws) -> SyntheticRace:
    """Both teams change between two styles in every generation."""
    sign = np.where(np.arange(n) % 2, 1.0, -1.0)
    turn = effect * draws.size(0.8, 1.6) * np.outer(sign, sign)
    return additive(np.zeros(n), np.zeros(n), draws.level(), turn)


# ---- Nobody gains, or not for long ---------------------------------------------------------------


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


def fluctuation(n: int, effect: float, draws: Draws) -> SyntheticRace:
    """``x_t = .6 x_{t-1} + noise``, standard deviation .5 logits: strength returns to its mean."""
    kept, noise = 0.6, draws.own.normal(size=(n, 2))
    x = [noise[0]]
    for step in noise[1:]:
        x.append(kept * x[-1] + np.sqrt(1.0 - kept**2) * step)
    return by_chance(0.5 * effect * np.array(x).T, draws.level())


def jump(n: int, effect: float, draws: Draws) -> SyntheticRace:
    """Each team jumps by about 2 logits, once, at its own moment between t = .2 and .8."""
    a, b = draws.sizes(2.0 * effect)
    p, e = (np.where(time(n) > moment(draws, 0.2, 0.8), size, 0.0) for size in (a, b))
    return additive(p, e, draws.level())


def common_jump(n: int, effect: float, draws: Draws) -> SyntheticRace:
    """Each team jumps by about 2 logits in the same generation of all runs, and drifts a little."""
    at = draws.shared.uniform(0.2, 0.8, (2, 1))
    a, b = draws.sizes(2.0 * effect)
    jumps = np.where(time(n) > at, [[a], [b]], 0.0)
    walks = 0.3 * np.cumsum(draws.own.normal(size=(2, n)), axis=1) / np.sqrt(n)
    chance = by_chance(jumps + walks, draws.level())
    return SyntheticRace(chance.rates, *jumps)


def own_jumps(n: int, effect: float, draws: Draws) -> SyntheticRace:
    """Each team jumps by about 2 logits, once, at a moment of each run's own, t = .1 to .9."""
    a, b = draws.sizes(2.0 * effect)
    p, e = (np.where(time(n) > draws.own.uniform(0.1, 0.9), size, 0.0) for size in (a, b))
    return additive(p, e, draws.level())


def smooth_wander(n: int, effect: float, draws: Draws) -> SyntheticRace:
    """Strengths are smooth random curves: normal, with a deviation of 1 logit.

    Their correlation over a time d is ``exp(-d^2 / 2 l^2)``, with l from .15 to .7 of the race.
    """
    t, length = time(n), draws.shared.uniform(0.15, 0.7)
    correlation = np.exp(-0.5 * ((t[:, None] - t) / length) ** 2) + 1e-9 * np.eye(n)
    walks = np.linalg.cholesky(correlation) @ draws.own.normal(size=(n, 2))
    return by_chance(effect * walks.T, draws.level())


def momentum(n: int, effect: float, draws: Draws) -> SyntheticRace:
    """Strengths are random walks whose steps are alike: N(0, 1.5) logits at the end.

    A step keeps a share of the one before, .7 to .95 of the group, and has chance for the rest.
    """
    kept, chance = draws.shared.uniform(0.7, 0.95), draws.own.normal(size=(n + 50, 2))
    steps = [chance[0]]
    for each in chance[1:]:
        steps.append(kept * steps[-1] + np.sqrt(1.0 - kept**2) * each)
    walks = np.cumsum(steps[50:], axis=0) / np.sqrt(n * (1.0 + kept) / (1.0 - kept))
    return by_chance(1.5 * effect * walks.T, draws.level())


def sines(n: int, effect: float, draws: Draws) -> SyntheticRace:
    """Strengths are sums of five sines, of half a period to two and a half, with random phases."""
    k = np.arange(1, 6)[:, None]
    phases, heights = (
        draws.own.uniform(0.0, 2.0 * np.pi, (2, 5, 1)),
        draws.own.normal(size=(2, 5, 1)),
    )
    walks = (heights / k * np.sin(np.pi * k * time(n) + phases)).sum(axis=1)
    return by_chance(effect * walks, draws.level())


def shared_trend(n: int, effect: float, draws: Draws) -> SyntheticRace:
    """All runs have the same curve, of `smooth_wander` or `momentum`, and a small walk each."""
    own, draws.own = draws.own, draws.shared
    curve = (momentum if coin(draws) else smooth_wander)(n, effect, draws)
    walks = 0.2 * np.cumsum(own.normal(size=(2, n)), axis=1) / np.sqrt(n)
    logits = logit(np.clip(curve.rates, 1e-9, 1.0 - 1e-9)) + walks[0][:, None] - walks[1]
    return SyntheticRace(expit(logits), curve.pursuers, curve.evaders)


def one_lucky_run(n: int, effect: float, draws: Draws, *, others: str) -> SyntheticRace:
    """In a group the first run races (3 to 8 logits); the others stand still, fall or walk."""
    size = effect * draws.shared.uniform(3.0, 8.0)
    if draws.run == 0:
        walks = size * np.array([time(n), time(n)])
    elif others == "walk":
        walks = 0.25 * np.cumsum(draws.own.normal(size=(2, n)), axis=1)
    else:
        walks = np.tile(time(n) * (-0.5 if others == "fall" else 0.0), (2, 1))
    return by_chance(walks, draws.level())


def slow_disc(
    n: int, effect: float, draws: Draws, *, turns: tuple[float, float] = (0.5, 1.5)
) -> SyntheticRace:
    """Skill turns on a circle: a generation beats those that are up to half a turn behind it.

    In less than half a turn each generation beats all earlier ones, as in a race.
    """
    angle = 2.0 * np.pi * draws.shared.uniform(*turns) * time(n)
    height = 0.45 * min(1.0, effect)
    rates = 0.5 + height * np.sin(angle[:, None] - angle)
    return SyntheticRace(rates, np.zeros(n), np.zeros(n))


# ---- Losses --------------------------------------------------------------------------------------


def forgetting(n: int, effect: float, draws: Draws) -> SyntheticRace:
    """Both teams rise by 3 logits; one loses 2 to 4 logits against opponents older than a lag.

    ``M = sigma(a t_g - b t_h - c [t_g - t_h > lag])`` if the pursuers forget, lag .12 to .3.
    """
    t, lag = time(n), moment(draws, 0.12, 0.3)
    a, b = draws.sizes(3.0)
    lost = np.where(t[:, None] - t > lag, effect * draws.size(2.0, 4.0), 0.0)
    return additive(a * t, b * t, draws.level(), -lost if coin(draws) else lost.T)


def decline(n: int, effect: float, draws: Draws) -> SyntheticRace:
    """One team rises by 2 logits up to t = .5, then falls by 3; the other rises by 1."""
    t = time(n)
    course = 4.0 * np.minimum(t, 0.5) - 6.0 * effect * np.maximum(t - 0.5, 0.0)
    return of_one_team(draws.size(0.8, 1.2) * course, t, draws.level(), pursuers=coin(draws))


def collapse(n: int, effect: float, draws: Draws) -> SyntheticRace:
    """Both teams rise by 3 logits; from t = .7 to .85 one loses 3 to 5."""
    t, start = time(n), moment(draws, 0.68, 0.75)
    a, b = draws.sizes(3.0)
    lost = effect * draws.size(3.0, 5.0) * np.clip((t - start) / 0.12, 0.0, 1.0)
    pursuers = coin(draws)
    return additive(
        a * t - lost * pursuers, b * t - lost * (not pursuers), draws.level() * (1 - effect / 4)
    )


# ---- Kinds ---------------------------------------------------------------------------------------


def disengagement(n: int, effect: float, draws: Draws, *, rate: float) -> SyntheticRace:
    """Return a race (2 logits), until one team wins `rate` of the current matches from an onset on.

    The onset lies between t = 0 and .4, and takes .05. From then on both stand still. The effect
    size has no effect.
    """
    del effect
    t, onset = time(n), moment(draws, 0.0, 0.4)
    engaged = draws.size(1.5, 2.5) * np.minimum(t, onset)
    ahead = logit(rate) * np.clip((t - onset) / 0.05, 0.0, 1.0)
    return of_one_team(engaged + ahead, engaged, 0.0, pursuers=coin(draws))


class Kind(NamedTuple):
    """A kind of race.

    `make` takes (generations, effect size, `Draws`) and returns a `SyntheticRace`. Constants of a
    judgement may be set on kinds for `development`; the others are held back for measuring.
    """

    make: Callable[[int, float, Draws], SyntheticRace]
    development: bool = False


KINDS: Mapping[str, Kind] = {
    "pure race": Kind(partial(race, total=4.0), development=True),
    "slow race": Kind(slow_race),
    "steep race": Kind(partial(race, total=15.0)),
    "uneven pace": Kind(uneven_pace),
    "saturating race": Kind(saturating),
    "two skills": Kind(two_skills),
    "sigmoid": Kind(sigmoid),
    "early dip": Kind(early_dip),
    "late onset": Kind(late_onset),
    "only pursuers rise": Kind(partial(one_sided, pursuers=True), development=True),
    "only evaders rise": Kind(partial(one_sided, pursuers=False), development=True),
    "cycle": Kind(partial(cycle, periods=(2.0, 4.0)), development=True),
    "cycle, uneven periods": Kind(partial(cycle, periods=(1.3, 2.7, 3.4))),
    "rock-paper-scissors": Kind(hands),
    "cycle on a climb": Kind(partial(cycle, periods=(2.0, 3.0, 4.0), climb=2.0)),
    "wave, then race": Kind(partial(wave_then, late=False)),
    "race, then wave": Kind(partial(wave_then, late=True)),
    "period 2": Kind(period_two),
    "switch of style": Kind(partial(styles, kinds=2)),
    "three styles": Kind(partial(styles, kinds=3)),
    "slow turn": Kind(slow_turn),
    "new styles": Kind(new_styles),
    "noise only, .1": Kind(partial(constant, rate=0.1), development=True),
    "noise only, .5": Kind(partial(constant, rate=0.5), development=True),
    "noise only, .8": Kind(partial(constant, rate=0.8), development=True),
    "drift": Kind(drift, development=True),
    "fluctuation": Kind(fluctuation),
    "early stagnation": Kind(partial(stagnation, until=1 / 3), development=True),
    "late stagnation": Kind(partial(stagnation, until=3 / 4)),
    "single jump": Kind(jump),
    "common jump": Kind(common_jump),
    "own jumps": Kind(own_jumps),
    "forgetting": Kind(forgetting, development=True),
    "decline": Kind(decline),
    "collapse": Kind(collapse),
    "disengagement, .95": Kind(partial(disengagement, rate=0.95)),
    "disengagement, .985": Kind(partial(disengagement, rate=0.985)),
    "disengagement, .995": Kind(partial(disengagement, rate=0.995)),
}
"""Kinds of races by name."""

HARD: Mapping[str, Kind] = {
    "smooth wander": Kind(smooth_wander, development=True),
    "momentum": Kind(momentum, development=True),
    "sines": Kind(sines),
    "shared trend": Kind(shared_trend, development=True),
    "slow disc": Kind(slow_disc, development=True),
    "one lucky run, others still": Kind(partial(one_lucky_run, others="still")),
    "one lucky run, others fall": Kind(partial(one_lucky_run, others="fall")),
    "one lucky run, others walk": Kind(partial(one_lucky_run, others="walk")),
}
"""Kinds without progress that look like it."""


OUTLIERS: Mapping[str, Kind] = {
    "heavy tails": Kind(partial(heavy_tails, trend=4.0), development=True),
    "heavier tails": Kind(partial(heavy_tails, trend=4.0, free=1.0)),
    "failed generations": Kind(partial(failed_generations, trend=4.0), development=True),
    "failures in a row": Kind(partial(failed_generations, trend=4.0, length=2)),
    "heavy tails, no trend": Kind(partial(heavy_tails, trend=0.0), development=True),
    "failed generations, no trend": Kind(partial(failed_generations, trend=0.0), development=True),
    "failures in a row, no trend": Kind(partial(failed_generations, trend=0.0, length=2)),
    "heavy steps": Kind(heavy_steps, development=True),
    "lucky generations": Kind(partial(failed_generations, trend=4.0, sign=1.0)),
    "lucky generations, no trend": Kind(partial(failed_generations, trend=0.0, sign=1.0)),
}
"""Races, and races without a trend, with generations far from the others."""

LIMITS: Mapping[str, Kind] = {
    "a quarter to half a circle": Kind(partial(slow_disc, turns=(0.25, 0.5)))
}
"""Races without progress that no payoff matrix tells from an arms race; they count apart."""

ALL_KINDS: Mapping[str, Kind] = {**KINDS, **HARD, **OUTLIERS, **LIMITS}


def synthetic_races(
    kind: str, n: int, seed: int, *, effect: float = 1.0, runs: int = 1
) -> list[SyntheticRace]:
    """Return the runs of a group: races of one kind, with parameters that vary between runs.

    The effect is the size of what the kind is about (a rise, an amplitude, a loss).
    """
    return [ALL_KINDS[kind].make(n, effect, Draws(seed, run)) for run in range(runs)]


# ---- Matches -------------------------------------------------------------------------------------

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
