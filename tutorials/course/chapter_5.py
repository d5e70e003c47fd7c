"""Exercises of notebook 5, "Is this an arms race?"."""

from __future__ import annotations

from typing import Any

import numpy as np

from course.checks import Mistake, array, choices, comparison, function, whole
from course.questions import kept
from course.synthetic_races import play_episodes, synthetic_race
from matrixworld import analysis
from matrixworld.coevolution.types import FloatArray

ENDINGS = {"A": "one side only", "B": "cycle", "C": "arms race", "D": "equilibrium"}
"""What happens in the four races of the first exercise."""
SHOWN = {"A": "only evaders rise", "B": "cycle", "C": "pure race", "D": "early stagnation"}
"""Kinds of these races."""


def noisy_race(kind: str, seed: int, *, generations: int = 20) -> FloatArray:
    """Return the captured shares of 30 evaders in a race whose truth is known, (n, n, 10)."""
    rates = synthetic_race(kind, generations, seed).rates
    return play_episodes(rates, 10, np.random.default_rng([5, seed]), evaders=30)


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
