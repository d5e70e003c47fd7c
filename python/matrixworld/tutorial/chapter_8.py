"""Exercises of notebook 8, "Who learns more from the race?"."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from numbers import Integral
from typing import Any

import numpy as np

from matrixworld import analysis
from matrixworld.coevolution.types import FloatArray
from matrixworld.tutorial.exercises import NO_FUNCTION, Exercise, Prediction

# ---- A curriculum that chooses itself ------------------------------------------------------------

LAST_STAGE, UP, DOWN = 3, 0.6, 0.2


def _next_stage(stage: int, escaped: float) -> int:
    """Return the stage that exercise 8.1 asks for."""
    step = 1 if escaped > UP else -1 if escaped < DOWN else 0
    return min(max(stage + step, 0), LAST_STAGE)


def _stage_mistake(answer: object) -> str | None:
    if not callable(answer):
        return NO_FUNCTION
    for stage in range(LAST_STAGE + 1):
        for escaped in (0.0, 0.1, 0.2, 0.4, 0.6, 0.75, 1.0):
            found, expected = answer(stage, escaped), _next_stage(stage, escaped)
            if isinstance(found, bool) or not isinstance(found, Integral):
                return f"Return the number of a stage, 0 to {LAST_STAGE}; got {found!r}."
            if found != expected:
                return _stage_clue(stage, escaped, int(found))
    return None


def _stage_clue(stage: int, escaped: float, found: int) -> str:
    where = f"In stage {stage} with {escaped:.0%} escaped, your function returns {found}."
    if not 0 <= found <= LAST_STAGE:
        return f"{where} There are the stages 0 to {LAST_STAGE} only."
    if escaped in (UP, DOWN):
        return f"{where} Exactly {escaped:.0%} is neither more nor less than the limit."
    return f"{where} Up if more than {UP:.0%} escape, down if less than {DOWN:.0%}, else stay."


# ---- Budgets -------------------------------------------------------------------------------------

POPULATION, GENERATIONS, EPOCHS, STAGES = 32, 20, 50, 4
"""Of the races and curricula that the notebook keeps."""


def _budget_mistake(answer: object) -> str | None:
    pair = isinstance(answer, Sequence | np.ndarray) and not isinstance(answer, str)
    if not pair or len(answer) != 2:  # type: ignore[arg-type]
        return "The answer is a pair of numbers: (matches of the evaders, epochs of a stage)."
    try:
        matches, epochs = (float(value) for value in answer)  # type: ignore[attr-defined]
    except (TypeError, ValueError):
        return "The answer is a pair of numbers: (matches of the evaders, epochs of a stage)."
    right = GENERATIONS * EPOCHS * POPULATION
    if matches == 2 * right:
        return "These are the matches of both teams. In half of them the evaders do not learn."
    if matches == right // POPULATION:
        return "These are epochs. In each epoch every candidate plays one match."
    if matches != right:
        return f"The evaders learn in {GENERATIONS} generations. How many epochs, how many matches?"
    if epochs == GENERATIONS * EPOCHS:
        return f"So many epochs are the whole curriculum; it has {STAGES} stages."
    return None if epochs == GENERATIONS * EPOCHS / STAGES else "The stages are equally long."


# ---- Strangers -----------------------------------------------------------------------------------


def _strangers_mistake(answer: object) -> str | None:
    if not callable(answer):
        return NO_FUNCTION
    rates = np.random.default_rng(83).random((6, 6))
    found = np.asarray(answer(rates.copy()), dtype=np.float64)
    if found.shape != (6,):
        return f"Expected one number for each of 6 seeds, got the shape {found.shape}."
    if np.allclose(found, rates.mean(axis=1)):
        return "That is the mean over all races, the own one included."
    if np.allclose(found, np.diag(rates)):
        return "These are the scores in the own race: those to leave out."
    others = ~np.eye(6, dtype=bool)
    if np.allclose(found, (rates * others).mean(axis=1)):
        return "You divide by 6, but only 5 numbers are left in each row."
    if np.allclose(found, (rates * others).sum(axis=0) / 5.0):
        return "These are the means of the columns. Rows are the seeds of your team."
    expected = (rates * others).sum(axis=1) / 5.0
    return None if np.allclose(found, expected) else "Row i without its i-th number; then the mean."


# ---- Words ---------------------------------------------------------------------------------------

WORDS = ("co-evolution", "autocurriculum", "curriculum by hand", "none of these")
CASES: Mapping[str, str] = {
    "A": "none of these",
    "B": "curriculum by hand",
    "C": "autocurriculum",
    "D": "co-evolution",
    "E": "autocurriculum",
}
"""Which word fits best, by case."""
WHY_NOT: Mapping[str, str] = {
    "A": "A: does the classifier learn while the pictures are searched?",
    "B": "B: who decides which pursuers come next, and do these pursuers learn?",
    "C": "C: who sets the tasks of each copy?",
    "D": "D: both learn, so the fitness of one depends on the other. Are they rivals?",
    "E": "E: both teams learn. Who sets the tasks of the evaders?",
}


def _words_mistake(answer: object) -> str | None:
    if not isinstance(answer, Mapping) or set(answer) != set(CASES):
        return f"The answer is a dict with the keys {', '.join(CASES)}."
    unknown = [word for word in answer.values() if word not in WORDS]
    if unknown:
        return f"Expected one of {', '.join(map(repr, WORDS))}, got {unknown[0]!r}."
    wrong = [WHY_NOT[case] for case, word in CASES.items() if answer[case] != word]
    return (
        f"{len(wrong)} of {len(CASES)} do not fit. Think again about {wrong[0]}" if wrong else None
    )


# ---- Verdicts ------------------------------------------------------------------------------------

BETTER, WORSE, OPEN = "better", "worse", "cannot tell"


def verdict_on(one: Any, other: Any) -> str:
    """Return whether the first team is better, by the paired interval over seeds.

    Parameters
    ----------
    one, other : array_like of float, shape (seeds,)
        Scores of two kinds of training; entry i of both has the same seed.

    Returns
    -------
    str
        ``"better"``, ``"worse"`` or ``"cannot tell"``.
    """
    found = analysis.difference_of_runs(one, other, paired=True)
    if found.low is None or found.high is None:
        return OPEN
    return BETTER if found.low > 0.0 else WORSE if found.high < 0.0 else OPEN


def _seeds(shift: float, seeds: int = 10) -> tuple[FloatArray, FloatArray]:
    """Return scores of two kinds of training that share the luck of each seed."""
    rng = np.random.default_rng([85, seeds, int(100 * shift) + 100])
    luck = rng.normal(0.5, 0.15, seeds)
    return luck + rng.normal(shift, 0.03, seeds), luck + rng.normal(0.0, 0.03, seeds)


def _verdict_mistake(answer: object) -> str | None:
    if not callable(answer):
        return NO_FUNCTION
    for shift in (0.3, -0.3, 0.07, -0.07, 0.005):
        one, other = _seeds(shift)
        found, expected = answer(one.copy(), other.copy()), verdict_on(one, other)
        if found not in (BETTER, WORSE, OPEN):
            return f"Expected '{BETTER}', '{WORSE}' or '{OPEN}', got {found!r}."
        if found == expected:
            continue
        if {found, expected} == {BETTER, WORSE}:
            return "Better and worse are swapped."
        if expected == OPEN:
            return f"The interval contains 0 there, and your function says '{found}'."
        return (
            "The difference is the same in nearly all seeds there, and your function says "
            f"'{found}'. Entries with the same seed belong together."
        )
    return None


EXERCISES: dict[str, Exercise | Prediction] = {
    "8.1": Exercise(
        _stage_mistake,
        "The pupils decide when they go on, and they get an easier task when they fail.",
        (
            "Two conditions change the stage by one.",
            "min(max(stage, 0), 3) keeps a number between 0 and 3.",
        ),
    ),
    "8.a": Prediction(
        ("easy to hard", "hard to easy", "hardest only", "random only"),
        "hardest only",
        "They practised it all the time. The evaders that came to hunters last had a quarter of "
        "the epochs for them, and what they had learned from walkers and chasers helped little.",
    ),
    "8.b": Prediction(
        ("more often", "as often", "less often"),
        "less often",
        "Fleers are hardly ever caught, so chasing them teaches something else than chasing "
        "walkers, and the old skill is not rewarded any more.",
    ),
    "8.2": Exercise(
        _budget_mistake,
        "The evaders learn in 1000 epochs of 32 matches; four stages have 250 epochs each.",
        (
            "In each generation the evaders learn for 50 epochs.",
            "In each epoch each of 32 candidates plays one match.",
        ),
    ),
    "8.3": Exercise(
        _strangers_mistake,
        "What is left are opponents that no team of the row has met.",
        (
            "np.diag(rates) are the numbers to leave out.",
            "Subtract them from the sums of the rows. How many numbers are left in each row?",
        ),
    ),
    "8.c": Prediction(
        (
            "easy to hard, with every examiner",
            "co-evolution, with every examiner",
            "it depends on the examiner",
        ),
        "it depends on the examiner",
        "Each school prepares for opponents that resemble its teachers.",
    ),
    "8.4": Exercise(
        _words_mistake,
        "The questions are always the same: who learns, who sets the tasks, and do they compete?",
        (
            "First ask who learns. If only one side does, it is no co-evolution.",
            "If all learn, ask whether they are rivals. If only one does, ask who made the plan.",
        ),
    ),
    "8.5": Exercise(
        _verdict_mistake,
        "If the whole interval is on one side of 0, the sign is known. Pairs take out the luck "
        "that both have in common.",
        (
            "analysis.difference_of_runs(one, other, paired=True) has the ends low and high.",
            "Better if low is above 0, worse if high is below 0.",
        ),
    ),
}
"""Exercises and predictions by name, in the order of the notebook."""
