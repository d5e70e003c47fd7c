"""Exercises of notebook 7, "When one side gives up", and the races that it lets you judge."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import Any

import numpy as np

from course.checks import Mistake, array, compare, function, near, number
from course.questions import UnansweredError
from course.synthetic_races import play_episodes, synthetic_race
from course.toys import hosts_and_parasites
from matrixworld import analysis
from matrixworld.coevolution import competitive_sharing, reduced_virulence
from matrixworld.coevolution.types import FloatArray

# ---- Races to judge ------------------------------------------------------------------------------

UNKNOWN = (
    ("disengagement, .95", 3), ("disengagement, .985", 1), ("disengagement, .95", 5),
    ("disengagement, .995", 2), ("disengagement, .95", 12), ("disengagement, .985", 8),
    ("disengagement, .95", 9), ("disengagement, .995", 6),
)  # fmt: skip
"""Kinds and seeds of the races that the notebook shows without their names."""
GENERATIONS = 31
ANSWERS = {"yes": "present", "no": "absent", "?": "cannot tell"}
"""What a student writes, and the verdict that it stands for."""


def unknown_races(episodes: int) -> list[FloatArray]:
    """Return the races to judge, (31, 31, episodes): 1 where the evader was captured, else 0."""
    return [
        play_episodes(_rates(*each), episodes, np.random.default_rng([7, place]))
        for place, each in enumerate(UNKNOWN)
    ]


def reveal(answers: Any, races: Sequence[FloatArray]) -> str:
    """Return the truth about `unknown_races`, beside a student's verdicts and those of `judge`.

    An answer is "yes", "no" or "?": whether a race is disengaged in its last half. UnansweredError
    if there is not one for each race.
    """
    if answers is ...:
        text = "No verdicts yet. Replace the dots with a list, and run both cells again."
        raise UnansweredError(text)
    if isinstance(answers, str) or len(answers) != len(races) or set(answers) - set(ANSWERS):
        text = f"Expected a list of {len(races)} answers, each 'yes', 'no' or '?'."
        raise UnansweredError(text)
    truths = [is_disengaged(*each) for each in UNKNOWN]
    lines = [f"race  {'truth':13}{'you':13}judge"]
    for place, (truth, answer) in enumerate(zip(truths, answers, strict=True)):
        word = "disengaged" if truth else "not"
        lines.append(f"{place:<6}{word:13}{ANSWERS[answer]:13}{verdict_of(races[place])}")
    pairs = list(zip(answers, truths, strict=True))
    alarms, missed = pairs.count(("yes", False)), pairs.count(("no", True))
    return "\n".join(lines) + (
        f"\n\nYou: {alarms} false alarms in {truths.count(False)} races that are not disengaged, "
        f"and {missed} of {truths.count(True)} disengaged ones missed."
    )


def verdict_of(race: FloatArray) -> str:
    """Return the verdict of `judge` on disengagement in the last half of a race."""
    found = analysis.judge(race, per_episode=True)
    return found.windows["last half"]["disengagement"].verdict


def is_disengaged(kind: str, seed: int) -> bool:
    """Return whether one team wins more than 97 % of the current matches in the last half."""
    current = np.diag(_rates(kind, seed))[GENERATIONS // 2 :]
    return bool((current > 0.97).all() or (current < 0.03).all())


def _rates(kind: str, seed: int) -> FloatArray:
    return synthetic_race(kind, GENERATIONS, seed).rates


# ---- Exercises -----------------------------------------------------------------------------------


def exercise_1(answer: Any) -> None:
    """Write the fitness of parasites of reduced virulence."""
    compare(
        answer,
        reduced_virulence,
        _wins_of_parasites(),
        partial(_row, name="a fitness for each of 25 parasites", count=25),
        clues={
            "x is not the number of wins: it is the wins divided by the largest number of wins in "
            "the population.": _virulence_of,
            "x is relative to the best parasite of the population, which need not win all five.": (
                lambda wins, virulence: _virulence_of(wins / 5.0, virulence)
            ),
        },
        otherwise=_why_not_restrained,
    )


def _row(value: Any, name: str, count: int) -> FloatArray:
    return array(value, name, count)


def _wins_of_parasites() -> list[tuple[FloatArray, float]]:
    rng = np.random.default_rng(71)
    cases = []
    for virulence in (1.0, 0.75, 0.6):
        wins = np.minimum(rng.integers(0, 6, 25), 4).astype(float)
        wins[0] = 4.0
        cases.append((wins, virulence))
    return [*cases, (np.zeros(25), 0.75)]


def _virulence_of(share: FloatArray, virulence: float) -> FloatArray:
    return 2.0 * share / virulence - (share / virulence) ** 2


def _why_not_restrained(
    found: FloatArray, right: FloatArray, wins: FloatArray, virulence: float
) -> str:
    if not wins.any():
        return "If no parasite wins, the largest number of wins is 0. Then all fitness is 0."
    each = int(np.abs(np.nan_to_num(found, nan=np.inf) - right).argmax())
    return (
        f"With v = {virulence}, {wins[each]:.0f} wins and at most {wins.max():.0f} wins of any "
        f"parasite, your fitness is {found[each]:.3g}; expected {right[each]:.3g}."
    )


def exercise_2(answer: Any) -> None:
    """Find the largest virulence at which 4 wins of 5 are as good as 5."""
    virulence = number(answer, "a number between 0.5 and 1")
    inside = 0.5 <= virulence <= 1.0
    near(
        virulence,
        0.9,
        0.002,
        clues={
            0.8: "At v = 0.8 the fitness is largest for 4 of 5 wins. But 4 wins may be as good as "
            "5 at a larger v."
        },
        low="There, 4 wins are at least as good as 5. There is a larger v with this property."
        if inside
        else "Virulence lies between 0.5 and 1.",
        high="There, 5 wins are still better than 4."
        if inside
        else "Virulence lies between 0.5 and 1.",
    )


def exercise_3(answer: Any) -> None:
    """Share fitness among those that beat the same opponent."""
    wins = (np.random.default_rng(73).random((6, 4)) < 0.5).astype(float)
    wins[0], wins[1:, 3] = 1.0, 0.0
    without = wins.copy()
    without[:, 3] = 0.0
    compare(
        answer,
        competitive_sharing,
        [(wins,), (without,)],
        partial(
            _row, name="6 numbers, one for each individual (row) of a table of 6 x 4 wins", count=6
        ),
        clues={
            "That is the number of wins. Each opponent is worth 1 in total, however many beat "
            "it.": lambda wins: wins.sum(axis=1),
            "You divide by the wins of the individual. Divide by the number of individuals that "
            "beat the opponent.": lambda wins: (wins > 0).any(axis=1).astype(float),
        },
        otherwise=_why_not_shared,
    )


def _why_not_shared(found: FloatArray, right: FloatArray, wins: FloatArray) -> str:
    if not np.isfinite(found).all():
        return "An opponent that no individual beats is worth nothing. You divide by zero there."
    return "Each column shares one point among those that beat this opponent; then sum each row."


HITS, ALARMS, RARITY = 0.9, 0.25, 0.05
"""Shares of disengaged races that the rule finds, of others that it takes for such; of both."""
FALSE, TRUE = ALARMS * (1.0 - RARITY), HITS * RARITY
IMAGINE = "Imagine 1000 races, and count the alarms of both kinds."


def exercise_4(answer: Any) -> None:
    """Compute how many alarms of a rule are false."""
    share = number(answer, "a number: a share between 0 and 1")
    near(
        share,
        FALSE / (FALSE + TRUE),
        0.006,
        clues={
            ALARMS: "That is the share of alarms among the races that are not disengaged. "
            "You look for the share of these races among the alarms.",
            TRUE / (FALSE + TRUE): "That is the share of alarms that are right.",
            FALSE: "That is the share of false alarms among all races. Divide by all alarms.",
            1.0 - HITS: "That is the share of the disengaged races that the rule misses.",
            ALARMS / (ALARMS + HITS): "This would hold if half of all races were disengaged.",
        },
        low=IMAGINE,
        high="The answer is a share between 0 and 1, not a percentage." if share > 1.0 else IMAGINE,
    )


FEWEST_ONES = 85.0
TRIALS, TRIAL_GENERATIONS = range(700, 703), 200


def exercise_5(answer: Any) -> None:
    """Write a fitness of parasites with which the hosts climb."""
    array(
        function(answer)(np.array([0.0, 1.0, 2.0, 5.0])),
        "4 fitness values for 4 numbers of wins",
        4,
    )

    def fitness(wins: FloatArray) -> FloatArray:
        return np.asarray(answer(wins.copy()), dtype=np.float64)

    races = [hosts_and_parasites(fitness, s, generations=TRIAL_GENERATIONS) for s in TRIALS]
    ones = [float(race.final_objective[0]) for race in races]
    if min(ones) < FEWEST_ONES:
        raise Mistake(
            f"With your parasites the hosts end with {', '.join(f'{one:.0f}' for one in ones)} "
            f"ones in three races of {TRIAL_GENERATIONS} generations; expected at least "
            f"{FEWEST_ONES:.0f} in each."
        )
