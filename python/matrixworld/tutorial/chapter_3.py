"""Exercises of notebook 3: neuroevolution."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from matrixworld._util.checks import shown
from matrixworld.tutorial.checks import NUMBER, function
from matrixworld.tutorial.course import Exercise, Prediction
from matrixworld.world.policy import Network

genome_size = function(
    NUMBER,
    lambda side, hidden, moves: Network((hidden,), fov=side, n_actions=moves).genome_size,
    lambda: ((5, 8, 5), (11, 32, 5), (3, 4, 9)),
    case="For a view of {side} x {side}, {hidden} hidden units and {moves} moves",
    clues=(
        (
            lambda side, hidden, moves: 3 * side * side * hidden + hidden * moves,
            "It counts the weights. What else does each unit have?",
        ),
        (
            lambda side, hidden, moves: (side * side + 1) * hidden + (hidden + 1) * moves,
            "How many layers does a view have?",
        ),
    ),
    otherwise="Expected another number.",
)


def _why_matches(found: float, right: int, spread: float, error: float) -> str:
    if abs(found - right) <= 1:
        return "It must be a whole number, and the smallest one that is enough."
    return "Expected another number."


TOO_FEW = "It is too few. Half the error takes more than twice the matches."
matches_needed = function(
    NUMBER,
    lambda spread, error: math.ceil(round((spread / error) ** 2, 6)),
    lambda: ((0.2, 0.1), (0.17, 0.01), (0.3, 0.05), (0.2, 0.03)),
    case="For a spread of {spread} and an error of {error}",
    clues=(
        (lambda spread, error: spread / error, TOO_FEW),
        (lambda spread, error: math.ceil(spread / error), TOO_FEW),
    ),
    otherwise=_why_matches,
)

TEAM = 10
CROWDS: tuple[list[tuple[int, int]], ...] = (
    [(0, 0), (0, 0), (0, 0), (4, 7), (4, 7)],
    [(1, 1), (2, 2), (3, 3)],
    [(5, 5)] * TEAM,
    [],
)
"""Cells of living agents."""

overlap = function(
    NUMBER,
    lambda cells, team: (len(cells) - len(set(cells))) / team,
    lambda: ((cells, TEAM) for cells in CROWDS),
    case="For the cells {cells} and a team of {team}",
    clues=(
        (
            lambda cells, team: sum(cells.count(cell) > 1 for cell in cells) / team,
            "It counts all agents on shared cells; the first on each is not counted.",
        ),
        (
            lambda cells, team: (len(cells) - len(set(cells))) / (len(cells) or team),
            "It is a share of the living; expected a share of the whole team.",
        ),
    ),
    otherwise="Expected another number. How many different cells are there?",
)

GENES, EPOCHS, NOISE = 60, 200, 0.01
ENOUGH = 1 / 3
"""Share of the distance to the optimum that a learner has to cover."""
MOST_CANDIDATES = 200


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


def _gain(make: Any, seed: int) -> float | str:
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
    if len(candidates) > MOST_CANDIDATES:
        return f"ask: expected at most {MOST_CANDIDATES} candidates here, got {len(candidates)}."
    return None


EXERCISES: dict[str, Exercise | Prediction] = {
    "3.1": Exercise(
        genome_size,
        "Each layer has inputs times outputs weights, and one bias for each output. Most genes are "
        "in the first layer, because a view has many cells.",
        (
            "Look at the shapes that the cell above prints.",
            "A view has three layers, so the first layer has 3 * side * side inputs.",
            "Add (inputs + 1) * outputs of both layers; the 1 is the bias.",
        ),
    ),
    "3.a": Prediction(
        "c",
        "Python looks up what each small step means whenever it is done; the compiler did "
        "it once. Evolution plays tens of thousands of matches, so the ratio decides what can be "
        "tried.",
    ),
    "3.2": Exercise(
        matches_needed,
        "The standard error is spread / sqrt(n), so n = (spread / error)**2, rounded up. Ten times "
        "less error costs a hundred times as many matches.",
        (
            "The standard error of a mean of n matches is spread / sqrt(n).",
            "Solve spread / sqrt(n) = error for n.",
            "Round up with math.ceil: the number of matches is whole.",
        ),
    ),
    "3.b": Prediction(
        "c",
        "The logbook shows the luckiest of thousands of scores. In new matches the luck is gone.",
    ),
    "3.c": Prediction(
        "b",
        "Nothing in their fitness speaks against it: a genome whose ten evaders hide together in "
        "four lucky matches scores more than one whose evaders are found one by one.",
    ),
    "3.3": Exercise(
        overlap,
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
