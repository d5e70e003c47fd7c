"""Functions that students of the course write, right ones and with their mistakes."""

from functools import partial
from itertools import combinations, product
from typing import Any

import numpy as np

import matrixworld as mw
from course import chapter_3, kept
from matrixworld import analysis


def conflicts(cells: list, targets: list, *, vertex: bool = True, edge: bool = True) -> set[int]:
    moves = list(zip(cells, targets, strict=True))
    return {
        a
        for a, (here, there) in enumerate(moves)
        if (vertex and targets.count(there) > 1)
        or (edge and here != there and (there, here) in moves)
    }


def careless(cells: list, targets: list) -> list[int]:
    """Change the arguments."""
    found = sorted(conflicts(cells, targets))
    cells.clear()  # the caller still needs them
    return found


def by_index(cells: list, targets: list) -> list:
    cells = list(cells)
    for agent, target in enumerate(targets):
        if target not in cells:
            cells[agent] = target
    return cells


def without_chains(cells: list, targets: list) -> list:
    held = conflicts(cells, targets)
    return [cells[a] if a in held else there for a, there in enumerate(targets)]


def at_once(cells: list, targets: list) -> np.ndarray:
    for _ in cells:
        targets = without_chains(cells, targets)
    return np.array(targets)


def the_lowest(candidates, scores):
    return candidates[np.argsort(1 - scores)[-8:]].mean(axis=0)


def hand_race(seed, *, payoff=np.asarray, select=chapter_3.mean_of_best):
    """Return the answer of exercise 3.3; the evaders select in a way that may be wrong."""
    archives = [chapter_3.first_genome(seed, 0)], [chapter_3.first_genome(seed, 1)]
    for k, (team, chosen) in product((1, 2, 3), enumerate((chapter_3.mean_of_best, select))):
        newest, rng = archives[1 - team][-1], np.random.default_rng([seed, k, team])
        learned = chapter_3.learn(team, archives[team][-1], newest, rng, select=chosen)
        archives[team].append(learned)
    return seed, *archives, payoff(chapter_3.all_against_all(archives))


class Later(partial):
    """An answer that takes long, and is made when it is given."""


def sums(a, b, rng):
    return (1 + np.sign(a.sum(axis=1) - b.sum(axis=1))) / 2


def coin_of_sums(a, b, rng):
    return rng.random(len(a)) < 0.25 + sums(a, b, rng) / 2


def game(play: Any, *, deterministic: bool = True) -> Any:
    """Return the game of a student's function."""
    return mw.Game(play, genes=2, teams=("ones", "others"), deterministic=deterministic)


def rate_turned(tokens: list, inputs: dict) -> float:
    """Run a program, but subtract the other way round."""
    stack = []
    for token in tokens:
        if token in ("add", "subtract", "multiply", "min", "max"):
            a, b = stack.pop(), stack.pop()
            results = {"add": a + b, "subtract": a - b, "multiply": a * b}
            stack.append((results | {"min": min(a, b), "max": max(a, b)})[token])
        else:
            stack.append(inputs.get(token, token))
    return stack[0]


def pairs(individuals, opponents):
    n, m = len(individuals), len(opponents)
    return np.repeat(individuals, m, axis=0), np.tile(opponents, (n, 1))


def gains(schedule: str) -> np.ndarray:
    """Return the capture rate at lag 5 minus that at lag 1 in each race of a schedule."""
    races = kept("paper_races")
    matrices = (races[schedule] / int(races["evaders"])).mean(axis=3)
    return np.array([np.diag(m, -5).mean() - np.diag(m, -1).mean() for m in matrices])


def interval_of_gains(schedule: str) -> analysis.Estimate:
    """Return the interval that exercise 5.3 asks for."""
    return analysis.interval_over_runs(gains(schedule))


def both_rise(scores: np.ndarray) -> np.bool_:
    curves = analysis.generalization(scores.mean(axis=2))
    return np.all([curve[-6:].mean() - curve[:6].mean() > 0.05 for curve in curves])


def strict_losses(matrix: np.ndarray) -> int:
    return sum(
        np.array_equal(
            np.sign(matrix[np.ix_(rows, columns)] - 0.5), sign * np.array([[1, -1], [-1, 1]])
        )
        for rows in combinations(range(len(matrix)), 2)
        for columns in combinations(range(matrix.shape[1]), 2)
        for sign in (1, -1)
    )


def of_other_shapes(beats, individuals, opponents):
    return (individuals > opponents).mean()


def hall(count: int, *, repeat: bool = False) -> Any:
    return lambda available, rng: [
        available - 1,
        *rng.choice(max(1, available - 1), size=min(count, available - 1), replace=repeat),
    ]


def right_before_left(own: int, other: int) -> bool:
    """Go first if the other one has this move on its right, and say nothing of two face to face."""
    return (other - own) % 4 == 1
