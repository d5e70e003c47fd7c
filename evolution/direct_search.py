"""Direct search: pursuers of a solved world that learn on what they guarantee, by any inputs.

A `Place` holds a solved world of `mw.SUITE` as arrays: what each move of a pursuer leads to, for
each different view, as numbers of any definition. So inputs that the engine does not have can be
tried: `Place.guarantee` says what ratings of the moves guarantee, exactly.
``look_for_inputs.py`` and ``readable_price.py`` share it.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from matrixworld.coevolution.settings.usual import STEPLESS
from matrixworld.play.tables import Table, joint
from matrixworld.solver import States, best_response, solve
from matrixworld.solver.suite import SuiteWorld
from matrixworld.world.arrays import MOVES
from matrixworld.world.rating import INPUTS, allowed_moves

Floats: TypeAlias = NDArray[np.float64]
Bools: TypeAlias = NDArray[np.bool_]
Ints: TypeAlias = NDArray[np.intp]

TODAY = STEPLESS
"""Seven of the nine inputs that are the default: ``must_yield`` has another table in each step, and
``ahead`` is drawn in each episode."""
FAR = 99
"""The distance of what cannot be reached."""
TIE = 1e-9
"""Ratings that differ by less are equal."""


class Place:
    """A solved world as its pursuers see it.

    Parameters
    ----------
    world : SuiteWorld
        The world; its pursuers see all of it.

    Attributes
    ----------
    cells : ndarray of int, shape (n, agents)
        Of each view, the cells of the agents; that of the pursuer that acts is in `own`, -1 is
        gone.
    own : ndarray of int, shape (n,)
        The number of the pursuer that acts.
    after : ndarray of int, shape (n, moves)
        The cell after each of its moves.
    allowed : ndarray of bool, shape (n, moves)
        Moves that lead into no obstacle.
    today : dict of str to ndarray, shape (n, moves)
        The inputs of the engine, by name.
    """

    def __init__(self, world: SuiteWorld) -> None:
        self.world = world
        # Threads would wait for each other longer than these small worlds take.
        self.states = States(world.config, threads=1)
        self.perfect = solve(self.states)
        config = self.states.config
        self.n_pursuers = config.n_pursuers
        _, self.places = self.states.views("pursuer")
        inputs = self.states.inputs("pursuer", self.places)
        self.allowed: Bools = allowed_moves(inputs, "obstacles")
        self.today: dict[str, Floats] = {
            name: inputs[:, :, number].astype(float) for number, name in enumerate(INPUTS)
        }
        n = len(inputs)
        self.cells: Ints = np.full((n, config.n_agents), -1)
        self.own: Ints = np.zeros(n, np.intp)
        for turn, of_turn in enumerate(self.places):
            cells = self.states.cells(turn)
            for column, agent in enumerate(self.states.members(turn, "pursuer")):
                views, at = np.unique(of_turn[:, column], return_index=True)
                self.cells[views[views >= 0]] = cells[at[views >= 0]]
                self.own[views[views >= 0]] = agent
        self.board = np.zeros((config.rows, config.cols), bool)
        if config.map is not None:
            self.board[:] = config.map
        self.moves = MOVES[: config.n_actions]
        here = self.cells[np.arange(n), self.own]
        self.after: Ints = np.where(
            self.allowed, self.neighbours[np.maximum(here, 0)], here[:, None]
        )

    @cached_property
    def neighbours(self) -> Ints:
        """The cell after each move from each cell, (cells, moves): the same where it is blocked."""
        rows, cols = self.board.shape
        cells = np.arange(rows * cols)
        to = np.array(divmod(cells, cols)).T[:, None] + self.moves
        inside = ((to >= 0) & (to < (rows, cols))).all(axis=2)
        clipped = np.clip(to, 0, (rows - 1, cols - 1))
        free = inside & ~self.board[clipped[..., 0], clipped[..., 1]]
        return np.where(free, clipped @ (cols, 1), cells[:, None])

    @cached_property
    def distances(self) -> dict[str, Ints]:
        """Least moves from cell to cell, (cells, cells): ``free`` of obstacles or by a ``path``."""
        rows, cols = self.board.shape
        places = np.array(divmod(np.arange(rows * cols), cols)).T
        apart = np.abs(places[:, None] - places)
        free = apart.max(axis=2) if len(self.moves) > 5 else apart.sum(axis=2)
        path = np.where(np.eye(len(places), dtype=bool), 0, FAR)
        for _ in range(len(places)):
            path = np.minimum(path, 1 + path[self.neighbours].min(axis=1))
        return {"free": free, "path": path}

    def play(self, ratings: Floats) -> Floats:
        """Return with which probabilities the best moves of ratings (n, moves) are taken."""
        rated = np.where(self.allowed, ratings, -np.inf)
        best = rated >= rated.max(axis=1, keepdims=True) - TIE
        return np.asarray(best / best.sum(axis=1, keepdims=True))

    def table(self, play: Floats) -> Table:
        """Return what the team does, of the probabilities (n, moves) of its members."""
        return Table(self.states, "pursuer", (joint(play, self.places),))

    def guarantee(self, ratings: Floats) -> float:
        """Return the share of perfect play that ratings (n, moves) guarantee."""
        response = best_response(self.states, self.table(self.play(ratings)), "pursuer")
        return response.value / self.world.value


def scaled(columns: list[Floats]) -> Floats:
    """Return inputs (n, moves) as one array (n, moves, inputs), each with a spread of about 1."""
    stacked = np.stack(columns, axis=2)
    spread = stacked.std(axis=(0, 1))
    return np.asarray(stacked / np.where(spread > 0, spread, 1.0))


def search(
    value: Callable[[Floats], float],
    genes: int,
    evaluations: int,
    rng: np.random.Generator,
    start: Floats | None = None,
    sigma: float = 1.0,
    most: float = 1.0,
) -> tuple[float, Floats]:
    """Return the best value that an evolution strategy with restarts finds, and its genes.

    It ends before where it reaches `most`: no share is higher.

    Twelve candidates, the mean of the best four, and a step that grows while the mean moves farther
    than chance would (Ostermeier, Gawelczyk and Hansen 1994, "Step-size adaptation based on
    non-local use of selection information"). It begins again where 15 generations found nothing
    better; the first time from `start`.
    """
    best, found = -np.inf, np.zeros(genes)
    left = evaluations
    while left > 0 and best < most - TIE:
        mean = rng.standard_normal(genes) if start is None else start
        step, start, top, stalled = sigma, None, -np.inf, 0
        while stalled < 15 and left > 0 and best < most - TIE:
            noise = rng.standard_normal((min(12, left), genes))
            candidates = mean + step * noise
            values = np.array([value(each) for each in candidates])
            left -= len(values)
            chosen = np.argsort(-values, kind="stable")[:4]
            mean = candidates[chosen].mean(axis=0)
            moved = np.linalg.norm(noise[chosen].mean(axis=0)) * 2 / np.sqrt(genes)
            step = float(np.clip(step * np.exp(0.3 * (moved - 1)), 0.02, 5))
            stalled = 0 if values.max() > top + 1e-9 else stalled + 1
            top = max(top, values.max())
            if values.max() > best:
                best, found = float(values.max()), candidates[values.argmax()]
    return best, found


def by_weights(
    place: Place, columns: list[Floats], evaluations: int, seed: int, **options: Any
) -> tuple[float, Floats]:
    """Return the best share that weights of inputs (n, moves) guarantee, and the weights."""
    inputs = scaled(columns)
    rng = np.random.default_rng(seed)
    return search(lambda w: place.guarantee(inputs @ w), len(columns), evaluations, rng, **options)
