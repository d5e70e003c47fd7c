"""Exercises of notebook 3: neuroevolution."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from matrixworld._util.checks import shown
from matrixworld.tutorial.checks import NUMBER, Check, function
from matrixworld.world.policy import Network

genome_size = function(
    NUMBER,
    lambda side, hidden, moves: Network((hidden,), fov=side, n_actions=moves).genome_size,
    lambda: ((5, 8, 5), (11, 32, 5), (3, 4, 9)),
    case="For a view of {side} x {side}, {hidden} hidden units and {moves} moves",
    clues={
        "It counts the weights. What else does each unit have?": (
            lambda side, hidden, moves: 3 * side * side * hidden + hidden * moves
        ),
        "How many layers does a view have?": (
            lambda side, hidden, moves: (side * side + 1) * hidden + (hidden + 1) * moves
        ),
    },
    otherwise="Expected another number.",
)


def _why_matches(found: float, right: int, spread: float, error: float) -> str:
    if math.isclose(found, spread / error) or found == math.ceil(spread / error):
        return "It is too few. Half the error takes more than twice the matches."
    if right - 1 < found < right:
        return f"Exactly it is {found}, and a number of matches is whole: round up."
    if found in (right - 1, right + 1):
        return "One match more is needed." if found < right else "One match less is enough."
    error_then = f"{spread / math.sqrt(found):.3g}" if found > 0 else "not defined"
    return f"With so many matches the standard error is {error_then}, and {error:g} is asked for."


matches_needed = function(
    NUMBER,
    lambda spread, error: math.ceil(round((spread / error) ** 2, 6)),
    lambda: ((0.2, 0.1), (0.17, 0.01), (0.3, 0.05), (0.2, 0.03)),
    case="For a spread of {spread} and an error of {error}",
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
    clues={
        "It counts all agents on shared cells; the first on each is not counted.": (
            lambda cells, team: sum(cells.count(cell) > 1 for cell in cells) / team
        ),
        "It is a share of the living; expected a share of the whole team.": (
            lambda cells, team: (len(cells) - len(set(cells))) / (len(cells) or team)
        ),
    },
    otherwise=lambda found, right, cells, team: (
        f"Expected {right:g}. How many different cells are there?"
    ),
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


CHECKS: dict[str, Check] = {
    "3.1": genome_size,
    "3.2": matches_needed,
    "3.3": overlap,
    "3.4": _learner,
}
