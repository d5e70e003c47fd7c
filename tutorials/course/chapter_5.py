"""Exercises of notebook 5, "Is this an arms race?"."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from scipy.special import expit

from course.checks import Mistake, array, choices, comparison, function, whole
from course.questions import kept
from matrixworld import analysis
from matrixworld.coevolution.types import FloatArray, Rng

ENDINGS = {"A": "one side only", "B": "cycle", "C": "arms race", "D": "equilibrium"}
"""What happens in the four races of the first exercise."""
SHOWN = {"A": "only evaders rise", "B": "cycle", "C": "pure race", "D": "early stagnation"}
"""Kinds of these races."""


def _times(t: FloatArray, rng: Rng) -> FloatArray:
    """Return a rise of both teams, at a pace of their own."""
    return t * rng.uniform(0.8, 1.2, (2, 1))


KINDS: dict[str, Callable[[FloatArray, Rng], FloatArray]] = {
    "pure race": lambda t, rng: _times(4.0 * t, rng),
    "slow race": lambda t, rng: _times(rng.uniform(0.03, 0.1) * len(t) * t, rng),
    "early stagnation": lambda t, rng: _times(4.0 * np.minimum(3.0 * t, 1.0), rng),
    "only pursuers rise": lambda t, rng: np.outer((rng.uniform(2.0, 4.0), 0.0), t - 0.5),
    "only evaders rise": lambda t, rng: np.outer((0.0, rng.uniform(2.0, 4.0)), t - 0.5),
    "drift": lambda t, rng: rng.normal(size=(2, len(t))).cumsum(axis=1) / np.sqrt(len(t)),
    "cycle": lambda t, rng: np.zeros((2, len(t))),
    "noise only, .5": lambda t, rng: np.zeros((2, len(t))),
}
"""Strengths of both teams (2, n), in logits, at times t (n,) from 0 to 1.

`evolution/validation/judgement_races.py` has more kinds, with which the judgement is measured.
"""


def noisy_race(kind: str, seed: int, *, generations: int = 20) -> FloatArray:
    """Return the captured shares of 30 evaders in a race whose truth is known, (n, n, 10)."""
    rng, t = np.random.default_rng([7, seed]), np.linspace(0.0, 1.0, generations)
    pursuers, evaders = KINDS[kind](t, rng)
    logits = pursuers[:, None] - evaders
    if kind != "noise only, .5":
        logits += rng.normal(0.0, 0.4)
    if kind == "cycle":
        angle, lag = 2.0 * np.pi * rng.integers(2, 5) * t, np.pi * rng.uniform(0.25, 0.75)
        logits += rng.uniform(1.5, 3.0) * np.cos(angle[:, None] - angle + lag)
    # Evaders of an episode share their fate: their correlation is 1 / 5.
    expected = np.repeat(4.0 * expit(logits)[..., None], 10, axis=2)
    return np.asarray(rng.binomial(30, rng.beta(expected, 4.0 - expected)) / 30)


def four_races() -> dict[str, FloatArray]:
    """Return the episodes of the four races of the first exercise by letter."""
    return {letter: noisy_race(kind, 1, generations=30) for letter, kind in SHOWN.items()}


def exercise_1(answer: Any) -> None:
    """Say what happens in four races."""
    if wrong := choices(answer, ENDINGS, sorted(ENDINGS.values())):
        raise Mistake(
            f"{len(ENDINGS) - len(wrong)} of 4 are right. Ask of each race: which of the two "
            "curves of generalization rises, and until when?"
        )


exercise_2 = comparison(
    lambda k, i: i % (k + 1),
    [(k, i) for k in (3, 1, 2, 7, 30) for i in range(2 * k + 3)],
    whole,
    case="For k = {k} and i = {i}",
    clues={
        "This is the rule of the pursuers. When the evaders of generation k begin to learn, "
        "the pursuers of generation k are ready. How many generations of pursuers are there?": (
            lambda k, i: i % k
        ),
        "These evaders meet the newest pursuers only: they are specialists.": lambda k, i: k,
    },
    otherwise="This is not the opponent.",
)
"""Say whom the evaders of generation k meet in epoch i of a race of generalists."""


CLOSE = 2e-3


def exercise_3(answer: Any) -> None:
    """Compute the interval of what generalists gain in four generations."""
    if isinstance(answer, analysis.Estimate):
        answer = answer.low, answer.high
    ends = array(answer, "the two ends of the interval, (low, high)", 2)
    right = _ends("generalist_generalist")
    if np.allclose(ends, right, atol=CLOSE):
        return
    typical = {
        "The sign is turned round: take lag +5 minus lag +1.": -right[::-1],
        "The two ends are exchanged: the lower one comes first.": right[::-1],
        "Right, but rounded too much: give at least three digits after the point.": right.round(2),
        "This is the interval of the specialists.": _ends("specialist_specialist"),
    }
    for told, wrong in typical.items():
        if np.allclose(ends, wrong, atol=CLOSE):
            raise Mistake(told)
    if abs(ends.mean() - right.mean()) < CLOSE:
        raise Mistake(
            "The middle is right, the width is not. The ten seeds are the sample, one number each, "
            "and ten numbers are few: `analysis.interval_over_runs` takes that into account."
        )
    raise Mistake(
        "Take one number for each seed: the mean capture rate at lag +5 minus that at lag +1. Then "
        "ask for the interval over the ten numbers."
    )


def _ends(schedule: str) -> FloatArray:
    """Return the interval of the capture rate at lag 5 minus that at lag 1 over ten seeds."""
    arrays = kept("paper_races")
    matrices = (arrays[schedule] / float(arrays["evaders"])).mean(axis=3)
    gains = [np.diag(m, -5).mean() - np.diag(m, -1).mean() for m in matrices]
    estimate = analysis.interval_over_runs(np.array(gains))
    return np.array([estimate.low, estimate.high], dtype=np.float64)


WITHOUT = ("noise only, .5", "only pursuers rise", "only evaders rise", "cycle", "drift")
"""Kinds of races on which a rule must not raise an alarm."""
WITH = ("pure race", "slow race")
"""Kinds of races that it must find."""
OF_EACH_WITHOUT, OF_EACH_WITH = 12, 15
MOST_FALSE_ALARMS, FEWEST_HITS = 3, 24
UNSEEN = 1000
"""First seed of the races that the notebook does not show."""


def exercise_4(answer: Any) -> None:
    """Write a rule that finds arms races, and few others."""
    alarms = _alarms(answer, WITHOUT, OF_EACH_WITHOUT)
    hits = _alarms(answer, WITH, OF_EACH_WITH)
    if alarms > MOST_FALSE_ALARMS or hits < FEWEST_HITS:
        why = (
            "It misses too many: which real rise is too small for it?"
            if hits < FEWEST_HITS
            else "It is fooled too often: in some of these races only one team rises, in others "
            "both go up and down."
        )
        raise Mistake(
            f"On races that you have not seen, your rule raised {alarms} false alarms in "
            f"{OF_EACH_WITHOUT * len(WITHOUT)} and found {hits} of {OF_EACH_WITH * len(WITH)} arms "
            f"races. {why}"
        )


def _alarms(answer: Any, kinds: tuple[str, ...], count: int) -> int:
    rule, seeds = function(answer), range(UNSEEN, UNSEEN + count)
    found = [rule(noisy_race(kind, seed)) for kind in kinds for seed in seeds]
    for each in found:
        if not isinstance(each, bool | np.bool_):
            raise Mistake(f"Your function returned {each!r}; expected True or False.")
    return int(sum(found))
