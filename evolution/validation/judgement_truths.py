"""What is true of a race whose capture rates are known, window by window.

The truth comes from the rates without noise and from the strength that the teams have by design. It
never uses matches, and no part of a judgement.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from judgement_races import SyntheticRace
from matrixworld.analysis import checkerboards
from matrixworld.coevolution.types import BoolArray, FloatArray

WINDOWS: Mapping[str, tuple[float, float]] = {
    "whole": (0.0, 1.0),
    "first half": (0.0, 0.5),
    "last half": (0.5, 1.0),
}
"""Windows by name: first generation and the one after the last, as shares of n (rounded down)."""


class Truth(NamedTuple):
    """Whether a race has a condition, and how large the effect is, in the unit of its definition.

    `holds` is None where the definition, see `truths`, leaves it open.
    """

    holds: bool | None
    size: float


Truths = dict[str, Truth]


def truths(race: SyntheticRace, window: str) -> Truths:
    """Return what is true of a window of a race: condition -> truth.

    The *strength* of a generation is its mean score against all opponents of the matrix. A team
    *rises* in a window if its strength by design does so in at least three of four equal parts, no
    single step makes up half of the rise, and its gain (the slope of the strength times the
    length) is at least .02. It does not rise if its strength by design ends no higher, or if a
    single step makes up 95 % of the rise. Otherwise it is open.

    ==================  ============================================================================
    arms race           both teams rise; size: the smaller gain
    one-sided progress  one team rises; the other does not, and gains .01 at most; False: both or
                        none of them rise; size: the larger gain
    stagnation          engaged, without a cycle, and the strength of both teams stays within .01;
                        False: a team changes by more than .05; size: the larger change
    rise                a team's strength changes by more than .07 (both usual readings), no step
                        makes more than .4 of it, and from fifth to fifth of the window it loses .15
                        of it at most; False: neither changes by more than .03; size: the change
    intransitivity      at least 2 % of the quadruples (two generations of each team) are
                        checkerboards at a margin of .1; False: there is none at .02; size: share
    cycling             intransitivity, and a team becomes similar to its past again by .3 (product
                        of what no sum of strengths explains, divided by that of a generation with
                        itself, at the best lag after the first negative one, up to half of the
                        window); False: no intransitivity, or both at most .08; size: the similarity
    forgetting          later half of the window: mean drop below the best ancestor, over all
                        opponents, of the team that drops more: at least .10; False: at most .02;
                        size: the drop
    disengagement       current matches (against the latest and the previous opponent) are won by
                        more than .97 by the same team in a row of at least half of the generations;
                        False: within [.04, .96] in three of four; size: mean payoff of the team
                        that wins more of these matches
    ==================  ============================================================================

    In a disengaged window every other condition is open.
    """
    span = span_of(race.rates, window)
    arms, one_sided = _progress(race, span)
    inner = race.rates[span, span]
    circles, disengaged = _intransitivity(inner), _disengagement(race.rates, span)
    found = {
        "disengagement": disengaged,
        "arms race": arms,
        "one-sided progress": one_sided,
        "rise": _rise(race.rates, span),
        "intransitivity": circles,
        "cycling": _cycling(inner, circles.holds),
        "forgetting": _forgetting(race.rates, span),
        "stagnation": _stagnation(race.rates, span, circles.holds, disengaged.holds),
    }
    if not disengaged.holds:
        return found
    return {
        name: one if one is disengaged else Truth(None, one.size) for name, one in found.items()
    }


def change_of_strength(rates: FloatArray, window: str) -> list[float | None]:
    """Return the change of the pursuers' and of the evaders' strength over a window.

    None where the two usual readings differ by more than .005: the slope times the length, and the
    difference between the last and the first generation.
    """
    strengths = _strengths(rates, span_of(rates, window))
    readings = [(_gain(strength), float(strength[-1] - strength[0])) for strength in strengths]
    return [slope if abs(slope - ends) <= 0.005 else None for slope, ends in readings]


def truths_of_group(races: Sequence[SyntheticRace], window: str) -> Truths:
    """Return what is true of all runs of a group: open where they differ; sizes are means."""
    each = [truths(race, window) for race in races]
    return {name: _common([one[name] for one in each]) for name in each[0]}


def _common(several: Sequence[Truth]) -> Truth:
    kinds = {one.holds for one in several}
    holds = kinds.pop() if len(kinds) == 1 else None
    return Truth(holds, float(np.mean([one.size for one in several])))


def span_of(rates: FloatArray, window: str) -> slice:
    """Return the generations of a window of a race with these rates."""
    return slice(*(int(share * len(rates)) for share in WINDOWS[window]))


def _strengths(rates: FloatArray, span: slice) -> tuple[FloatArray, FloatArray]:
    return rates.mean(axis=1)[span], 1.0 - rates.mean(axis=0)[span]


def _gain(strength: FloatArray) -> float:
    """Return the least-squares slope of a strength, times the length of the window."""
    return float(np.polyfit(np.arange(len(strength)), strength, 1)[0] * (len(strength) - 1))


def _progress(race: SyntheticRace, span: slice) -> tuple[Truth, Truth]:
    """Return the truth of "arms race" and of "one-sided progress"."""
    gains = [_gain(strength) for strength in _strengths(race.rates, span)]
    courses = (race.pursuers[span], race.evaders[span])
    rises = [_rises(course, gain) for course, gain in zip(courses, gains, strict=True)]
    arms = False if False in rises else None if None in rises else True
    one_sided = None if None in rises else rises[0] is not rises[1]
    if one_sided and gains[rises.index(False)] > 0.01:
        one_sided = None  # the other team gains all the same, by a jump or by chance
    return Truth(arms, min(gains)), Truth(one_sided, max(gains))


def _rises(course: FloatArray, gain: float) -> bool | None:
    steps = np.diff(course)
    total = steps.sum()
    if total <= 1e-9 or steps.max() >= 0.95 * total:
        return False
    last = len(course) - 1
    parts = np.diff(np.interp(np.linspace(0, last, 5), np.arange(last + 1), course))
    sustained = np.count_nonzero(parts > 1e-9) >= 3 and steps.max() < total / 2.0
    return True if sustained and gain >= 0.02 else None


def _stagnation(
    rates: FloatArray, span: slice, circles: bool | None, disengaged: bool | None
) -> Truth:
    strengths = _strengths(rates, span)
    # A team has changed if both readings of "change" say so; within the range both are small.
    changes = [min(abs(_gain(one)), abs(one[-1] - one[0])) for one in strengths]
    ranges = [np.ptp(one) for one in strengths]
    if circles or max(changes) > 0.05:
        return Truth(False, max(changes))
    still = max(ranges) <= 0.01 and circles is False and disengaged is False
    return Truth(True if still else None, max(changes))


def _rise(rates: FloatArray, span: slice) -> Truth:
    found = []
    for strength in _strengths(rates, span):
        change = min(_gain(strength), float(strength[-1] - strength[0]))
        fifths = np.array([part.mean() for part in np.array_split(strength, min(5, len(strength)))])
        steady = np.diff(strength).max() <= 0.4 * change and np.diff(fifths).min() >= -0.15 * change
        most = max(_gain(strength), float(strength[-1] - strength[0]))
        found.append((True if steady and change > 0.07 else None if most > 0.03 else False, change))
    holds = [each for each, _ in found]
    size = max(change for _, change in found)
    return Truth(True if True in holds else None if None in holds else False, size)


def _cycling(rates: FloatArray, circles: bool | None) -> Truth:
    cyclic = rates - rates.mean(axis=0) - rates.mean(axis=1)[:, None] + rates.mean()
    similar = max(_recurrence(cyclic), _recurrence(cyclic.T))
    if circles is False or similar <= 0.08:
        return Truth(False, similar)
    return Truth(True if circles and similar >= 0.3 else None, similar)


def _recurrence(cyclic: FloatArray) -> float:
    """Return the largest similarity to the own past after the first negative one; else 0."""
    n, itself = len(cyclic), (cyclic**2).sum(axis=1).mean()
    left, best = False, 0.0
    for lag in range(1, n // 2 + 1):
        pairs = [float(cyclic[g] @ cyclic[g + lag]) for g in range(n - lag)]
        similar = float(np.mean(pairs) / max(itself, 1e-12))
        best = max(best, similar) if left else best
        left = left or similar < 0.0
    return best


def _intransitivity(rates: FloatArray) -> Truth:
    plain = checkerboards(rates, margin=0.1, level=None)
    share = plain.count / plain.possible
    if share >= 0.02:
        return Truth(True, share)
    return Truth(None if checkerboards(rates, margin=0.02, level=None).count else False, share)


def _forgetting(rates: FloatArray, span: slice) -> Truth:
    later = slice((span.start + span.stop) // 2, span.stop)
    within = slice(later.start - span.start, None)
    # Ancestors and opponents of the window, or of the whole race: both readings must agree.
    drops = [_drop(rates[span, span], within), _drop(rates, later)]
    if min(drops) >= 0.10:
        return Truth(True, min(drops))
    return Truth(False if max(drops) <= 0.02 else None, max(drops))


def _drop(rates: FloatArray, later: slice) -> float:
    """Return the mean drop below the best ancestor of the team that drops more."""
    pursuers = np.maximum.accumulate(rates, axis=0) - rates
    evaders = rates - np.minimum.accumulate(rates, axis=1)
    return float(max(pursuers[later].mean(), evaders[:, later].mean()))


def _disengagement(rates: FloatArray, span: slice) -> Truth:
    current = np.diag(rates)
    previous = np.concatenate([current[:1], np.diag(rates, -1)])
    both = np.array([current, previous])[:, span]
    payoff = float(max(both.mean(), 1.0 - both.mean()))
    one_sided = ((both > 0.97).all(axis=0), (both < 0.03).all(axis=0))
    if max(_longest_row(np.asarray(mask)) for mask in one_sided) >= both.shape[1] / 2.0:
        return Truth(True, payoff)
    engaged = np.mean(((both >= 0.04) & (both <= 0.96)).all(axis=0))
    return Truth(False if engaged >= 0.75 else None, payoff)


def _longest_row(mask: BoolArray) -> int:
    """Return the length of the longest row of True."""
    ends = np.flatnonzero(np.concatenate([[True], ~mask, [True]]))
    return int(np.diff(ends).max() - 1)
