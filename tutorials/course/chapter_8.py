"""Exercises of notebook 8, "Who learns more from the race?"."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np

from course.checks import Mistake, array, choices, compare, numbers, one_of
from matrixworld import analysis
from matrixworld.coevolution.types import FloatArray

# ---- Scores of the schools -----------------------------------------------------------------------

Scores = dict[str, dict[str, FloatArray]]
"""Of each seed (seeds,), by examiner and school."""


def table_of(stored: Mapping[str, Any], team: str) -> Scores:
    """Return the scores of a team's schools with each single examiner."""
    schools, scores = stored[f"{team}: kinds"].tolist(), stored[f"{team}: scores"] / 1000
    return {
        examiner: dict(zip(schools, scores[..., place], strict=True))
        for place, examiner in enumerate(stored[f"{team}: opponents"].tolist())
    }


def examined(stored: Mapping[str, Any], team: str, scripts: Sequence[str]) -> Scores:
    """Return the scores of a team's schools with three sorts of examiners."""
    single = table_of(stored, team)
    sorts = {"scripts": scripts, "evolved strangers": ("evolved-1", "evolved-2")}
    found = {
        sort: {name: np.mean([single[one][name] for one in of], axis=0) for name in single[of[0]]}
        for sort, of in sorts.items()
    }
    races = zip(stored[f"{team}: kinds"].tolist(), stored[f"{team}: against races"], strict=True)
    # Own races are left out: who has met these rivals remembers them.
    return found | {
        "co-evolved rivals": {
            name: _without_own(each / 1000).sum(axis=1) / 9 for name, each in races
        }
    }


def _without_own(rates: FloatArray) -> FloatArray:
    return rates * ~np.eye(len(rates), dtype=bool)


# ---- Exercises -----------------------------------------------------------------------------------

POPULATION, GENERATIONS, EPOCHS, STAGES = 32, 20, 50, 4
"""Of the races and curricula that the notebook keeps."""


def exercise_1(answer: Any) -> None:
    """Compute the budgets of a race and of a curriculum."""
    kind = "a pair of numbers: (matches of the evaders, epochs of a stage)"
    matches, epochs = numbers(answer, kind, 2)
    right = GENERATIONS * EPOCHS * POPULATION
    if matches == 2 * right:
        raise Mistake(
            "These are the matches of both teams. In half of them the evaders do not learn."
        )
    if matches == right // POPULATION:
        raise Mistake("These are epochs. In each epoch every candidate plays one match.")
    if matches != right:
        raise Mistake(
            f"The evaders learn in {GENERATIONS} generations. How many epochs, how many matches?"
        )
    if epochs == GENERATIONS * EPOCHS:
        raise Mistake(f"So many epochs are the whole curriculum; it has {STAGES} stages.")
    if epochs != GENERATIONS * EPOCHS / STAGES:
        raise Mistake("The stages are equally long.")


def exercise_2(answer: Any) -> None:
    """Score teams against strangers."""
    compare(
        answer,
        lambda rates: _without_own(rates).sum(axis=1) / 5.0,
        [(np.random.default_rng(83).random((6, 6)),)],
        _six,
        clues={
            "That is the mean over all races, the own one included.": (
                lambda rates: rates.mean(axis=1)
            ),
            "These are the scores in the own race: those to leave out.": np.diag,
            "You divide by 6, but only 5 numbers are left in each row.": (
                lambda rates: _without_own(rates).mean(axis=1)
            ),
            "These are the means of the columns. Rows are the seeds of your team.": (
                lambda rates: _without_own(rates).sum(axis=0) / 5.0
            ),
        },
        otherwise="Row i without its i-th number; then the mean.",
    )


def _six(value: Any) -> FloatArray:
    return array(value, "one number for each of 6 seeds", 6)


BETTER, WORSE, OPEN = "better", "worse", "cannot tell"


def verdict_on(one: Any, other: Any) -> str:
    """Return whether the first kind of training is better, by the paired interval over seeds.

    Entry i of both lists of scores has the same seed.
    """
    return (OPEN, BETTER, WORSE)[analysis.difference_of_runs(one, other, paired=True).sign]


def exercise_3(answer: Any) -> None:
    """Write a rule that says which of two kinds of training is better."""
    compare(
        answer,
        verdict_on,
        _scores(),
        partial(one_of, words=(BETTER, WORSE, OPEN)),
        otherwise=_why_verdict,
    )


def _scores() -> list[tuple[FloatArray, FloatArray]]:
    """Return scores of two kinds of training that share the luck of each seed."""
    seeds, cases = 10, []
    for shift in (0.3, -0.3, 0.07, -0.07, 0.005):
        rng = np.random.default_rng([85, seeds, int(100 * shift) + 100])
        luck = rng.normal(0.5, 0.15, seeds)
        one = luck + rng.normal(shift, 0.03, seeds)
        cases.append((one, luck + rng.normal(0.0, 0.03, seeds)))
    return cases


def _why_verdict(found: str, right: str, one: FloatArray, other: FloatArray) -> str:
    if {found, right} == {BETTER, WORSE}:
        return "Better and worse are swapped."
    if right == OPEN:
        return f"The interval contains 0 there, and your function says '{found}'."
    return (
        f"The difference is the same in nearly all seeds there, and your function says '{found}'. "
        "Entries with the same seed belong together."
    )


WORDS = ("co-evolution", "autocurriculum", "curriculum by hand", "none of these")
CASES = {
    "A": "none of these",
    "B": "curriculum by hand",
    "C": "autocurriculum",
    "D": "co-evolution",
    "E": "autocurriculum",
}
"""Which word fits best, by case."""
WHY_NOT = {
    "A": "A: does the classifier learn while the pictures are searched?",
    "B": "B: who decides which pursuers come next, and do these pursuers learn?",
    "C": "C: who sets the tasks of each copy?",
    "D": "D: both learn, so the fitness of one depends on the other. Are they rivals?",
    "E": "E: both teams learn. Who sets the tasks of the evaders?",
}


def exercise_4(answer: Any) -> None:
    """Say which word fits which case."""
    wrong = choices(answer, CASES, WORDS)
    if wrong:
        raise Mistake(
            f"{len(wrong)} of {len(CASES)} do not fit. Think again about {WHY_NOT[wrong[0]]}"
        )
