"""Exercises of notebook 10, "How far from perfect?"."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from itertools import permutations
from typing import Any

import numpy as np
from scipy.stats import spearmanr

from course.boards import playable
from course.checks import Mistake, array, comparison, described, function, near, number
from matrixworld.coevolution import RaceSettings
from matrixworld.coevolution.types import BoolArray, FloatArray
from matrixworld.solver import States, best_response, solve
from matrixworld.world.config import WorldConfig, read_map

STAKES = np.array([[0.5, 0.25, 1.0], [0.75, 0.5, 0.25], [0.0, 0.75, 0.5]])
"""Rock, paper, scissors: rock always beats scissors, and the other winners win 3 of 4 matches."""
SAFE = 0.495
"""What a mixture has to score against each hand."""
HALLS, GENERALISTS = 0.8305, 0.8431
"""NashConv of the last generations of the kept races, means over seeds; a test computes them."""


def agreement(stored: Mapping[str, FloatArray], team: str, measure: str) -> list[float]:
    """Return the rank correlation with the truth for each seed, a mean over its five races."""
    said, truth = stored[f"{team}: {measure}"], stored[f"{team}: truth"]
    races = (zip(said[:, seed], truth[:, seed], strict=True) for seed in range(said.shape[1]))
    return [
        float(np.mean([spearmanr(*pair).statistic for pair in each if min(map(np.ptp, pair)) > 0]))
        for each in races
    ]


_rng = np.random.default_rng(101)
SHAPES = ((3, 3), (2, 5), (6, 4))
DRAWN = [(_rng.random(shape), _rng.dirichlet(np.ones(shape[0]))) for shape in SHAPES]

exercise_1 = comparison(
    lambda payoff, mixture: float((mixture @ payoff).min()),
    [(STAKES, np.full(3, 1 / 3)), *DRAWN],
    clues={
        "That is the score against the opponent that the mixture likes best.": (
            lambda payoff, mixture: float((mixture @ payoff).max())
        ),
        "That is the mean over all opponents. Who knows your mixture does not draw by lot.": (
            lambda payoff, mixture: float((mixture @ payoff).mean())
        ),
        "That is the worst single entry: you looked at one row at a time, not at the "
        "mixture.": lambda payoff, mixture: float(payoff.min()),
    },
    otherwise="Weight the rows by the mixture: that gives one score against each opponent.",
)
"""Compute what a mixture guarantees."""


def exercise_2(answer: Any) -> None:
    """Find a safe mixture of rock, paper and scissors with stakes."""
    shares = array(answer, "the shares of rock, paper and scissors", 3)
    if min(shares) < 0.0 or abs(sum(shares) - 1.0) > 1e-6:
        raise Mistake("Three shares are not negative, and their sum is 1.")
    scores = shares @ STAKES
    if scores.min() < SAFE:
        worst = ("rock", "paper", "scissors")[int(scores.argmin())]
        raise Mistake(
            f"Against {worst} this mixture scores {scores.min():.3f}; it has to reach {SAFE}."
        )


def exercise_3(answer: Any) -> None:
    """Compute the NashConv of races with halls of fame."""
    near(
        number(answer),
        HALLS,
        0.001,
        clues={
            GENERALISTS: "That is the NashConv of generalists.",
            1.0 - HALLS: "That is what both teams guarantee together. How much is missing?",
        },
        low="Best responses gain more. The exploitabilities of both teams are added.",
        high="A team falls short of what perfect play guarantees: of the value or of 1 - value.",
    )


CELLS, STEPS = 13, 23
"""Of the corridor; the slowest search that goes to one end and then to the other takes 22 steps."""
CORRIDOR = RaceSettings.of(
    {
        "world": {"rules": "R", "rows": 1, "cols": CELLS, "fov": 3, "max_steps": STEPS},
        "world.n_pursuers": 1,
        "world.n_evaders": 1,
        "schedule": {"kind": "against", "opponent": "still", "epochs": 300, "archive_every": 300},
        "fitness.measure": "capture-rate",
        # Larger steps than the defaults, with which memory does not always learn the search.
        "learner": {"population": 64, "sigma": 0.2, "learning_rate": 0.1},
        "policy.hidden": (16,),
        "train_steps": STEPS,
        "match_episodes": 16,
        "evaluation_episodes": 2000,
    }
)
"""A pursuer that sees one cell to each side evolves there, and an evader stands still."""
WAYS = {"west": -1, "east": 1}


def exercise_4(answer: Any) -> None:
    """Write a search of the corridor that remembers."""
    search = function(answer)
    for start, evader in permutations(range(CELLS), 2):
        cell, memory = start, None
        path: list[int] = []
        while abs(cell - evader) > 1 and len(path) < STEPS - 1:  # the last step captures
            found = search(cell == 0, cell == CELLS - 1, memory)
            if not isinstance(found, tuple) or len(found) != 2 or found[0] not in WAYS:
                raise Mistake(
                    f'Expected a pair of "west" or "east" and a memory, got {described(found)}.'
                )
            cell = min(max(cell + WAYS[found[0]], 0), CELLS - 1)
            memory = found[1]
            path.append(cell)
        if abs(cell - evader) > 1:
            raise Mistake(
                f"From cell {start} it does not find the evader in cell {evader} (the westernmost "
                f"cell is 0). These are the cells that it visits: {', '.join(map(str, path))}."
            )


BOARD = WorldConfig("TO", rows=6, cols=6, n_pursuers=2, n_evaders=1, max_steps=5)
"""The world of the notebook, on any map."""
HIGH = 0.3
"""Regret that a drawn map has to have."""


def regret(walls: BoolArray) -> float:
    """Return by how much chasers fall short of perfect play on a map, True where a wall is."""
    there = States(replace(BOARD, obstacles=walls))
    return solve(there).value - best_response(there, "chaser", "pursuer").value


def exercise_5(answer: Any) -> None:
    """Draw a map on which chasers are far from perfect."""
    try:
        walls = read_map(answer)
        if walls.shape != (BOARD.rows, BOARD.cols):
            raise ValueError
    except (OSError, TypeError, ValueError):
        raise Mistake(
            f"Expected six texts of six characters, . or #, got {described(answer)}."
        ) from None
    if not playable(walls, BOARD.n_agents):
        raise Mistake(
            "All free cells have to be connected by steps to the four sides, and three agents "
            "need room."
        )
    found = regret(walls)
    if found < HIGH:
        raise Mistake(f"On this map the regret of chasers is {found:.3f}, less than {HIGH}.")
