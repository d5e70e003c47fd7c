"""Exercises of notebook 8, "Who learns more from the race?"."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from course.checks import Mistake, array, choices, comparison, near, one_of
from matrixworld import analysis
from matrixworld.coevolution.types import FloatArray

EXAMINERS = ("scripts", "evolved strangers", "co-evolved rivals")


def examined(stored: Mapping[str, Any], team: str) -> dict[str, dict[str, FloatArray]]:
    """Return the scores (seeds,) of a team's schools, by examiner and school."""
    schools = stored[f"{team}: kinds"].tolist()
    return {
        examiner: dict(zip(schools, stored[f"{team}: {examiner}"], strict=True))
        for examiner in EXAMINERS
    }


# ---- Exercises -----------------------------------------------------------------------------------

POPULATION, GENERATIONS, EPOCHS, STAGES = 32, 20, 50, 4
"""Of the races and curricula that the notebook keeps."""


def exercise_1(answer: Any) -> None:
    """Compute the budgets of a race and of a curriculum."""
    kind = "a pair of numbers: (matches of the evaders, epochs of a stage)"
    matches, epochs = array(answer, kind, 2)
    budget = GENERATIONS * EPOCHS
    near(
        matches,
        budget * POPULATION,
        0,
        clues={
            2 * budget * POPULATION: "These are the matches of both teams. In half of them the "
            "evaders do not learn.",
            budget: "These are epochs. In each epoch every candidate plays one match.",
        },
        low=f"The evaders learn in {GENERATIONS} generations. How many epochs, how many matches?",
    )
    whole = f"So many epochs are the whole curriculum; it has {STAGES} stages."
    near(epochs, budget / STAGES, 0, clues={budget: whole}, low="The stages are equally long.")


def _without_own(rates: FloatArray) -> FloatArray:
    return rates * ~np.eye(len(rates), dtype=bool)


exercise_2 = comparison(
    lambda rates: _without_own(rates).sum(axis=1) / 5.0,
    [(np.random.default_rng(83).random((6, 6)),)],
    lambda value: array(value, "one number for each of 6 seeds", 6),
    clues={
        "That is the mean over all races, the own one included.": lambda rates: rates.mean(axis=1),
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
"""Score teams against strangers."""


BETTER, WORSE, OPEN = "better", "worse", "cannot tell"


def verdict_on(one: Any, other: Any) -> str:
    """Return whether the first kind of training is better; entry i of both has the same seed."""
    return (OPEN, BETTER, WORSE)[analysis.difference_of_runs(one, other, paired=True).sign]


def _scores() -> list[tuple[FloatArray, FloatArray]]:
    """Return scores of two kinds of training that share the luck of each seed."""
    cases = []
    for shift in (0.3, -0.3, 0.07, -0.07, 0.005):
        rng = np.random.default_rng([85, 10, int(100 * shift) + 100])
        luck = rng.normal(0.5, 0.15, 10)
        one = luck + rng.normal(shift, 0.03, 10)
        cases.append((one, luck + rng.normal(0.0, 0.03, 10)))
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


exercise_3 = comparison(
    verdict_on,
    _scores(),
    lambda value: one_of(value, (BETTER, WORSE, OPEN)),
    otherwise=_why_verdict,
)
"""Write a rule that says which of two kinds of training is better."""


WORDS = ("co-evolution", "autocurriculum", "curriculum by hand", "none of these")
CASES = {
    "A": ("none of these", "does the classifier learn while the pictures are searched?"),
    "B": ("curriculum by hand", "who decides which pursuers come next, and do they learn?"),
    "C": ("autocurriculum", "who sets the tasks of each copy?"),
    "D": ("co-evolution", "both learn, and depend on each other. Are they rivals?"),
    "E": ("autocurriculum", "both teams learn. Who sets the tasks of the evaders?"),
}
"""Which word fits best, by case, and what to ask where another one is given."""


def exercise_4(answer: Any) -> None:
    """Say which word fits which case."""
    if wrong := choices(answer, {case: word for case, (word, _) in CASES.items()}, WORDS):
        raise Mistake(
            f"{len(wrong)} of {len(CASES)} do not fit. Think again about {wrong[0]}: "
            f"{CASES[wrong[0]][1]}"
        )
