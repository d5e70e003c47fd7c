"""Exercises of notebook 5, "Is this an arms race?"."""

from __future__ import annotations

from collections.abc import Callable
from numbers import Integral, Real
from typing import Any

import numpy as np

from matrixworld import analysis
from matrixworld.coevolution import SCHEDULES, available
from matrixworld.coevolution.types import FloatArray
from matrixworld.toys import play_episodes, synthetic_race
from matrixworld.tutorial.exercises import Exercise, Prediction
from matrixworld.tutorial.kept import kept

ENDINGS = {"A": "one side only", "B": "cycle", "C": "arms race", "D": "equilibrium"}
"""What happens in the four races of the first exercise."""
SHOWN = {
    "A": "only evaders rise",
    "B": "cycle",
    "C": "pure race",
    "D": "early stagnation",
}
"""Kinds of these races."""
WITHOUT = ("noise only, .5", "only pursuers rise", "only evaders rise", "cycle", "drift")
"""Kinds of races on which a rule must not raise an alarm."""
WITH = ("pure race", "slow race")
"""Kinds of races that it must find."""
OF_EACH_WITHOUT, OF_EACH_WITH = 12, 15
MOST_FALSE_ALARMS, FEWEST_HITS = 3, 24
UNSEEN = 1000
"""First seed of the races that the notebook does not show."""
CLOSE = 2e-3


def noisy_race(kind: str, seed: int, *, generations: int = 20) -> FloatArray:
    """Return the episodes of a race whose truth is known.

    Parameters
    ----------
    kind : str
        Name in `matrixworld.toys.SYNTHETIC`.
    seed : int
        Seed of the race and of its episodes.
    generations : int, optional
        Generations of each team.

    Returns
    -------
    ndarray of float64, shape (generations, generations, 10)
        Captured fraction of 30 evaders in each episode.
    """
    rates = synthetic_race(kind, generations, seed).rates
    return play_episodes(rates, 10, np.random.default_rng([5, seed]), evaders=30)


def four_races() -> dict[str, FloatArray]:
    """Return the episodes of the four races of the first exercise by letter."""
    return {letter: noisy_race(kind, 1, generations=30) for letter, kind in SHOWN.items()}


def _endings(answer: Any) -> str | None:
    if not isinstance(answer, dict) or set(answer) != set(ENDINGS):
        return "Expected a dict with the keys 'A', 'B', 'C' and 'D'."
    unknown = [value for value in answer.values() if value not in ENDINGS.values()]
    if unknown:
        names = ", ".join(repr(name) for name in sorted(ENDINGS.values()))
        return f"Each value is one of {names}; you wrote {unknown[0]!r}."
    right = sum(answer[letter] == name for letter, name in ENDINGS.items())
    if right == len(ENDINGS):
        return None
    return (
        f"{right} of 4 are right. Ask of each race: which of the two curves of generalisation "
        "rises, and until when?"
    )


def _opponent(answer: Any) -> str | None:
    if not callable(answer):
        return "Expected a function of k and i."
    sampler = SCHEDULES["generalist-generalist"].sampler("evader")
    rng = np.random.default_rng(0)
    for k in (1, 2, 3, 7, 30):
        for i in range(2 * k + 3):
            found = answer(k, i)
            if isinstance(found, bool) or not isinstance(found, Integral):
                return f"For k = {k}, i = {i} it returned {found!r}; expected a whole number."
            if found != sampler.sample(available("evader", k), i, rng)[0]:
                return _wrong_opponent(answer, k, i, int(found))
    return None


def _wrong_opponent(answer: Callable[[int, int], Any], k: int, i: int, found: int) -> str:
    if all(answer(n, e) == e % n for n in (1, 2, 7) for e in range(9)):
        return (
            "This is the rule of the pursuers. When the evaders of generation k begin to learn, "
            "the pursuers of generation k are ready. How many generations of pursuers are there?"
        )
    if all(answer(n, e) == n for n in (1, 2, 7) for e in range(9)):
        return "These evaders meet the newest pursuers only: they are specialists."
    return f"For k = {k} and i = {i} it returned {found}, which is not the opponent."


def _gain_by_lag(name: str) -> FloatArray:
    """Return the capture rate at lag 5 minus that at lag 1 of each seed, shape (10,)."""
    arrays = kept("paper_races")
    matrices = (arrays[name] / float(arrays["evaders"])).mean(axis=3)
    return np.array([np.diag(m, -5).mean() - np.diag(m, -1).mean() for m in matrices])


def _interval(answer: Any) -> str | None:
    if isinstance(answer, analysis.Estimate):
        answer = (answer.low, answer.high)
    if isinstance(answer, Real):
        return "One number is no interval: give its lower and its upper end, (low, high)."
    if (
        not isinstance(answer, tuple | list | np.ndarray)
        or len(answer) != 2
        or not all(isinstance(end, Real) for end in answer)
    ):
        return "Expected the two ends of the interval, (low, high)."
    ends = np.array([float(end) for end in answer])
    values = _gain_by_lag("generalist_generalist")
    right = _ends(values)
    if np.allclose(ends, right, atol=CLOSE):
        return None
    if np.allclose(ends, -right[::-1], atol=CLOSE):
        return "The sign is turned round: take lag +5 minus lag +1."
    if np.allclose(ends, _ends(_gain_by_lag("specialist_specialist")), atol=CLOSE):
        return "This is the interval of the specialists."
    if abs(ends.mean() - right.mean()) < CLOSE:
        return (
            "The middle is right, the width is not. The ten seeds are the sample: one number each."
        )
    return (
        "Take one number for each seed: the mean capture rate at lag +5 minus that at lag +1. Then "
        "ask for the interval over the ten numbers."
    )


def _ends(values: FloatArray) -> FloatArray:
    estimate = analysis.interval_over_runs(values)
    return np.array([estimate.low, estimate.high], dtype=np.float64)


def _rule(answer: Any) -> str | None:
    if not callable(answer):
        return "Expected a function of the scores, an array (generations, generations, episodes)."
    alarms, hits = 0, 0
    for kind in (*WITHOUT, *WITH):
        count = OF_EACH_WITHOUT if kind in WITHOUT else OF_EACH_WITH
        for seed in range(UNSEEN, UNSEEN + count):
            found = answer(noisy_race(kind, seed))
            if not isinstance(found, bool | np.bool_):
                return f"It returned {found!r}; expected True or False."
            alarms += bool(found) and kind in WITHOUT
            hits += bool(found) and kind in WITH
    return _judged(alarms, hits)


def _judged(alarms: int, hits: int) -> str | None:
    without, with_ = OF_EACH_WITHOUT * len(WITHOUT), OF_EACH_WITH * len(WITH)
    if alarms <= MOST_FALSE_ALARMS and hits >= FEWEST_HITS:
        return None
    counted = (
        f"On races that you have not seen, your rule raised {alarms} false alarms in {without} and "
        f"found {hits} of {with_} arms races."
    )
    if hits < FEWEST_HITS:
        return f"{counted} It misses too many: which real rise is too small for it?"
    return (
        f"{counted} It is fooled too often: in some of these races only one team rises, in others "
        "both go up and down."
    )


EXERCISES: dict[str, Exercise | Prediction] = {
    "5.1": Exercise(
        _endings,
        "A race that goes on has two rising curves; all endings miss at least one of them. Watch "
        "the lag profile, too: only in the cycle it does not rise from left to right.",
        (
            "Begin with the generalisation curves: in which races do both rise until the end?",
            "In one race both curves rise first and are level later. In another one they are level "
            "from the start, and the matrix has stripes.",
            "In the remaining race one curve rises, and the other is level from the start.",
        ),
    ),
    "5.2": Exercise(
        _opponent,
        "The evaders learn after the pursuers, so k + 1 generations of pursuers exist already, the "
        "untrained generation 0 included: i mod (k + 1).",
        (
            "Write down for k = 2 which pursuers are in the archive: 0, 1, ... up to which?",
            "`i % n` goes through 0, 1, ..., n - 1 and begins again. Which n is it here?",
        ),
    ),
    "5.a": Prediction(
        ("a", "b", "c"),
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
        ("a", "b", "c"),
        "a",
        "'Cannot tell' is not 'absent'. Each race alone shows a rise with a wide interval; ten "
        "rises in the same direction have a narrow one.",
    ),
    "5.c": Prediction(
        ("a", "b", "c"),
        "c",
        "Without any change each team's last generation is better than its first one in about half "
        "of the races, by luck. Both are in about a quarter of them.",
    ),
    "5.4": Exercise(
        _rule,
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
