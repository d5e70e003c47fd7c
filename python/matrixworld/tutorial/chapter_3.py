"""Exercises of notebook 3: neuroevolution."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from matrixworld._util.checks import shown
from matrixworld.tutorial.exercises import NO_DEFINITION, Exercise, Prediction
from matrixworld.world.policy import Network


def _genome_size(answer: Any) -> str | None:
    if not callable(answer):
        return NO_DEFINITION
    for side, hidden, moves in ((5, 8, 5), (11, 32, 5), (3, 4, 9)):
        right = Network((hidden,), fov=side, n_actions=moves).genome_size
        found = answer(side, hidden, moves)
        if found == right:
            continue
        case = f"For a view of {side} x {side}, {hidden} hidden units and {moves} moves"
        if found == right - hidden - moves:
            return f"{case}, {found} counts the weights. What else does each unit have?"
        if found == right - 2 * side * side * hidden:
            return f"{case}, the result is {found}. How many layers does a view have?"
        return f"{case}, expected another number than {shown(found)}."
    return None


def _matches_needed(answer: Any) -> str | None:
    if not callable(answer):
        return NO_DEFINITION
    for spread, error in ((0.2, 0.1), (0.17, 0.01), (0.3, 0.05), (0.2, 0.03)):
        right = math.ceil(round((spread / error) ** 2, 6))
        found = answer(spread, error)
        case = f"For a spread of {spread} and an error of {error}"
        if not isinstance(found, int | float | np.integer | np.floating):
            return f"{case}, expected a number, got {shown(found)}."
        if found == right:
            continue
        if math.isclose(found, spread / error) or found == math.ceil(spread / error):
            return (
                f"{case}, {found:.6g} is too few. Half the error takes more than twice the matches."
            )
        if abs(found - right) <= 1:
            return (
                f"{case}, the result is {found:.6g}. It must be a whole number, and the smallest "
                "one that is enough."
            )
        return f"{case}, expected another number than {found:.6g}."
    return None


TEAM = 10
CROWDS: tuple[list[tuple[int, int]], ...] = (
    [(0, 0), (0, 0), (0, 0), (4, 7), (4, 7)],
    [(1, 1), (2, 2), (3, 3)],
    [(5, 5)] * TEAM,
    [],
)
"""Cells of living agents."""


def _overlap(answer: Any) -> str | None:
    if not callable(answer):
        return NO_DEFINITION
    for cells in CROWDS:
        # Copies: a function that empties its argument must not spoil the next check.
        found = answer(list(cells), TEAM)
        right = (len(cells) - len(set(cells))) / TEAM
        if not isinstance(found, int | float | np.integer | np.floating):
            return f"For the cells {cells} expected a number, got {shown(found)}."
        if not math.isclose(found, right, abs_tol=1e-9):
            return _why_overlap(cells, found)
    return None


def _why_overlap(cells: list[tuple[int, int]], found: Any) -> str:
    case = f"For the cells {cells} and a team of {TEAM} the result is {found:.6g}."
    shared = sum(cells.count(cell) > 1 for cell in cells)
    extra = len(cells) - len(set(cells))
    if math.isclose(found, shared / TEAM):
        return f"{case} It counts all agents on shared cells; the first on each is not counted."
    if cells and math.isclose(found, extra / len(cells)):
        return f"{case} It is a share of the living; expected a share of the whole team."
    return f"{case} Expected another number. How many different cells are there?"


GENES, EPOCHS, NOISE = 60, 200, 0.01
ENOUGH = 1 / 3
"""Share of the distance to the optimum that a learner has to cover."""


def _learner(answer: Any) -> str | None:
    if not isinstance(answer, type):
        return "Expected a class: write `class Climber:` and then `answer = Climber`."
    missing = [name for name in ("ask", "tell") if not callable(getattr(answer, name, None))]
    if missing:
        return f"The class has no method {missing[0]!r}."
    gains = []
    for seed in range(3):
        gain = _gain(answer, seed)
        if isinstance(gain, str):
            return gain
        gains.append(gain)
    if min(gains) < ENOUGH:
        return (
            f"It ran without an error. After {EPOCHS} epochs it had covered {min(gains):.0%} of "
            "the distance to the optimum; expected at least a third. Does `genome` move to the "
            "best candidate? Are the steps neither tiny nor huge?"
        )
    return None


def _gain(make: Callable[..., Any], seed: int) -> float | str:
    """Return the share of the distance to an optimum that a learner covers, or what is wrong."""
    rng = np.random.default_rng(seed)
    start = rng.standard_normal(GENES).astype(np.float32) * np.float32(0.1)
    target = start + rng.standard_normal(GENES).astype(np.float32) * np.float32(0.5)
    # A copy: the start must stay what it is, even if a learner changes its genome in place.
    learner = make(start.copy(), np.random.default_rng(seed))
    if not hasattr(learner, "genome"):
        return "The learner has no attribute `genome`; set it in `__init__`."
    begin = float(np.linalg.norm(start - target))
    for _ in range(EPOCHS):
        candidates = learner.ask(rng)
        problem = _wrong_candidates(candidates)
        if problem:
            return problem
        distances = np.linalg.norm(candidates - target, axis=1) / begin
        learner.tell(-distances + NOISE * rng.standard_normal(len(candidates)))
    if np.shape(learner.genome) != (GENES,):
        return f"genome: expected the shape ({GENES},), got {np.shape(learner.genome)}."
    return 1.0 - float(np.linalg.norm(learner.genome - target)) / begin


def _wrong_candidates(candidates: Any) -> str | None:
    if not isinstance(candidates, np.ndarray):
        return f"ask: expected an array, got {shown(candidates)}."
    if candidates.ndim != 2 or candidates.shape[1] != GENES or not len(candidates):
        return f"ask: expected the shape (n, {GENES}), got {candidates.shape}."
    if candidates.dtype != np.float32:
        return f"ask: expected the dtype float32, got {candidates.dtype}."
    if len(candidates) > 200:
        return f"ask: expected at most 200 candidates here, got {len(candidates)}."
    return None


EXERCISES: dict[str, Exercise | Prediction] = {
    "3.1": Exercise(
        _genome_size,
        "Each layer has inputs times outputs weights, and one bias for each output. Most genes are "
        "in the first layer, because a view has many cells.",
        (
            "Look at the shapes that the cell above prints.",
            "A view has three layers, so the first layer has 3 * side * side inputs.",
            "Add (inputs + 1) * outputs of both layers; the 1 is the bias.",
        ),
    ),
    "3.a": Prediction(
        ("a", "b", "c"),
        "c",
        "Python looks up what each small step means whenever it is done; the compiler did "
        "it once. Evolution plays tens of thousands of matches, so the ratio decides what can be "
        "tried.",
    ),
    "3.2": Exercise(
        _matches_needed,
        "The standard error is spread / sqrt(n), so n = (spread / error)**2, rounded up. Ten times "
        "less error costs a hundred times as many matches.",
        (
            "The standard error of a mean of n matches is spread / sqrt(n).",
            "Solve spread / sqrt(n) = error for n.",
            "Round up with math.ceil: the number of matches is whole.",
        ),
    ),
    "3.b": Prediction(
        ("a", "b", "c"),
        "c",
        "The logbook shows the luckiest of thousands of scores. In new matches the luck is gone.",
    ),
    "3.c": Prediction(
        ("a", "b", "c"),
        "b",
        "Nothing in their fitness speaks against it: a genome whose ten evaders hide together in "
        "four lucky matches scores more than one whose evaders are found one by one.",
    ),
    "3.3": Exercise(
        _overlap,
        "Agents minus different cells: on each cell all but the first are counted.",
        (
            "On a cell with n agents, n - 1 are counted.",
            "A set holds each cell once: len(set(cells)).",
        ),
    ),
    "3.4": Exercise(
        _learner,
        "It improves a genome from scores alone, without knowing what they measure.",
        (
            "ask: the genome plus sigma times normal numbers, as float32; keep these candidates.",
            "tell: np.argmax(fitness) says which candidate becomes the genome.",
            "Let the mean of the best few candidates become the genome: it suffers less from luck.",
        ),
    ),
}
"""Exercises and predictions in the order of the notebook."""
