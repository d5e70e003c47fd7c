"""Exercises of notebook 5, "Is this an arms race?"."""

from __future__ import annotations

from typing import Any

import numpy as np

from matrixworld import analysis
from matrixworld.coevolution.types import FloatArray
from matrixworld.toys import play_episodes, synthetic_race
from matrixworld.tutorial.checks import WHOLE, choices, function, numbers, tried, value
from matrixworld.tutorial.course import Exercise, Prediction, kept

ENDINGS = {"A": "one side only", "B": "cycle", "C": "arms race", "D": "equilibrium"}
"""What happens in the four races of the first exercise."""
SHOWN = {
    "A": "only evaders rise",
    "B": "cycle",
    "C": "pure race",
    "D": "early stagnation",
}
"""Kinds of these races."""


def noisy_race(kind: str, seed: int, *, generations: int = 20) -> FloatArray:
    """Return the episodes of a race whose truth is known, (generations, generations, 10).

    Each is the captured fraction of 30 evaders.
    """
    rates = synthetic_race(kind, generations, seed).rates
    return play_episodes(rates, 10, np.random.default_rng([5, seed]), evaders=30)


def four_races() -> dict[str, FloatArray]:
    """Return the episodes of the four races of the first exercise by letter."""
    return {letter: noisy_race(kind, 1, generations=30) for letter, kind in SHOWN.items()}


endings = choices(
    ENDINGS,
    sorted(ENDINGS.values()),
    lambda wrong: (
        f"{len(ENDINGS) - len(wrong)} of 4 are right. Ask of each race: which of the two curves "
        "of generalization rises, and until when?"
    ),
)

opponent = function(
    WHOLE,
    lambda k, i: i % (k + 1),
    lambda: ((k, i) for k in (3, 1, 2, 7, 30) for i in range(2 * k + 3)),
    case="For k = {k} and i = {i}",
    clues=(
        (
            lambda k, i: i % k,
            "This is the rule of the pursuers. When the evaders of generation k begin to learn, "
            "the pursuers of generation k are ready. How many generations of pursuers are there?",
        ),
        (
            lambda k, i: k,
            "These evaders meet the newest pursuers only: they are specialists.",
        ),
    ),
    otherwise="This is not the opponent.",
)

CLOSE = 2e-3


def _ends(schedule: str) -> FloatArray:
    """Return the interval of the capture rate at lag 5 minus that at lag 1 over ten seeds."""
    arrays = kept("paper_races")
    matrices = (arrays[schedule] / float(arrays["evaders"])).mean(axis=3)
    gains = [np.diag(m, -5).mean() - np.diag(m, -1).mean() for m in matrices]
    estimate = analysis.interval_over_runs(np.array(gains))
    return np.array([estimate.low, estimate.high], dtype=np.float64)


def _interval(answer: Any) -> str | None:
    if isinstance(answer, analysis.Estimate):
        answer = (answer.low, answer.high)
    return value(numbers("the two ends of the interval, (low, high)", 2), _wrong_ends)(answer)


def _wrong_ends(ends: list[float]) -> str | None:
    right = _ends("generalist_generalist")
    if np.allclose(ends, right, atol=CLOSE):
        return None
    if np.allclose(ends, -right[::-1], atol=CLOSE):
        return "The sign is turned round: take lag +5 minus lag +1."
    if np.allclose(ends, _ends("specialist_specialist"), atol=CLOSE):
        return "This is the interval of the specialists."
    if abs(np.mean(ends) - right.mean()) < CLOSE:
        return (
            "The middle is right, the width is not. The ten seeds are the sample: one number each."
        )
    return (
        "Take one number for each seed: the mean capture rate at lag +5 minus that at lag +1. Then "
        "ask for the interval over the ten numbers."
    )


WITHOUT = ("noise only, .5", "only pursuers rise", "only evaders rise", "cycle", "drift")
"""Kinds of races on which a rule must not raise an alarm."""
WITH = ("pure race", "slow race")
"""Kinds of races that it must find."""
OF_EACH_WITHOUT, OF_EACH_WITH = 12, 15
MOST_FALSE_ALARMS, FEWEST_HITS = 3, 24
UNSEEN = 1000
"""First seed of the races that the notebook does not show."""


def _rule(answer: Any) -> str | None:
    alarms, hits = 0, 0
    for kind in (*WITHOUT, *WITH):
        count = OF_EACH_WITHOUT if kind in WITHOUT else OF_EACH_WITH
        for seed in range(UNSEEN, UNSEEN + count):
            found = answer(noisy_race(kind, seed))
            if not isinstance(found, bool | np.bool_):
                return f"Your function returned {found!r}; expected True or False."
            alarms += bool(found) and kind in WITHOUT
            hits += bool(found) and kind in WITH
    if alarms <= MOST_FALSE_ALARMS and hits >= FEWEST_HITS:
        return None
    counted = (
        f"On races that you have not seen, your rule raised {alarms} false alarms in "
        f"{OF_EACH_WITHOUT * len(WITHOUT)} and found {hits} of {OF_EACH_WITH * len(WITH)} arms "
        "races."
    )
    if hits < FEWEST_HITS:
        return f"{counted} It misses too many: which real rise is too small for it?"
    return (
        f"{counted} It is fooled too often: in some of these races only one team rises, in others "
        "both go up and down."
    )


EXERCISES: dict[str, Exercise | Prediction] = {
    "5.1": Exercise(
        endings,
        "A race that goes on has two rising curves; all endings miss at least one of them. Watch "
        "the lag profile, too: only in the cycle it does not rise from left to right.",
        (
            "Begin with the generalization curves: in which races do both rise until the end?",
            "In one race both curves rise first and are level later. In another one they are level "
            "from the start, and the matrix has stripes.",
            "In the remaining race one curve rises, and the other is level from the start.",
        ),
    ),
    "5.2": Exercise(
        opponent,
        "The evaders learn after the pursuers, so k + 1 generations of pursuers exist already, the "
        "untrained generation 0 included: i mod (k + 1).",
        (
            "Write down for k = 2 which pursuers are in the archive: 0, 1, ... up to which?",
            "`i % n` goes through 0, 1, ..., n - 1 and begins again. Which n is it here?",
        ),
    ),
    "5.a": Prediction(
        "c",
        "Specialists learn to beat the evaders in front of them. Five generations later a part of "
        "this skill is lost again, although they have learned for four generations more. In eight "
        "of the ten seeds the difference is plain; in the other two there is none.",
    ),
    "5.3": Exercise(
        _interval,
        "The whole interval is above 0: generalists keep what they have learned and add to it.",
        (
            "`analysis.lag_profile(matrix)` has `lags` and `means`; lag 0 is in the middle.",
            "Make a list of ten differences, one for each matrix in "
            "`payoffs['generalist-generalist']`.",
            "`analysis.interval_over_runs(differences)` has `low` and `high`.",
        ),
    ),
    "5.b": Prediction(
        "a",
        "'Cannot tell' is not 'absent'. Each race alone shows a rise with a wide interval; ten "
        "rises in the same direction have a narrow one.",
    ),
    "5.c": Prediction(
        "c",
        "Without any change each team's last generation is better than its first one in about half "
        "of the races, by luck. Both are in about a quarter of them.",
    ),
    "5.4": Exercise(
        tried(_rule),
        "It is hardly fooled by races without a race in them, and it finds most of the others. "
        "Such rates, counted on races whose truth is known, are what a verdict is worth.",
        (
            "First make two curves: `analysis.generalization(scores.mean(axis=2))` has `pursuers` "
            "and `evaders`.",
            "One generation is a matter of luck. Compare means of several, or use all of them.",
            "How well does a straight line describe each curve? `np.corrcoef(np.arange(len(curve)),"
            " curve)[0, 1]` is near 1 if it rises steadily. Both curves must.",
        ),
    ),
}
