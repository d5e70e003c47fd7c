"""A slow and obvious solution of a small world: recursion over the slow reading of the rules.

Agents keep their numbers, states are dictionaries, and every game is a linear programme of SciPy.
"""

from collections.abc import Iterator
from copy import copy
from functools import cache
from itertools import permutations, product

import numpy as np
from scipy.optimize import linprog

import matrixworld as mw
from reference import ReferenceWorld


class SlowSolver:
    def __init__(self, config: mw.WorldConfig) -> None:
        self.config = config
        self.value = cache(self.value)
        self.after: dict[tuple, list[list[tuple]]] = {}

    def mean(self, steps: int) -> float:
        return float(np.mean([self.value(start, 0, steps) for start in self.starts()]))

    def starts(self) -> Iterator[tuple]:
        ground = np.zeros((self.config.rows, self.config.cols), bool)
        ground = ground if self.config.map is None else self.config.map
        free = [tuple(map(int, cell)) for cell in np.argwhere(~ground)]
        for cells in permutations(free, self.config.n_agents):
            yield tuple(enumerate(cells)), frozenset(), frozenset(), frozenset()

    def world(self, state: tuple) -> ReferenceWorld:
        where, ever, taken, now = state
        world = ReferenceWorld(self.config)
        cells = [(0, 0)] * self.config.n_agents
        n = self.config.n_pursuers
        world.place(cells[:n], cells[n:], self.config.map)
        world.where, world.been = dict(where), dict(where)
        world.ever, world.taken, world.now = set(ever), set(taken), {e: {0} for e in now}
        return world

    def moment(self, world: ReferenceWorld) -> tuple:
        sets = (frozenset(each) for each in (world.ever, world.taken, world.now))
        return (tuple(sorted(world.where.items())), *sets)

    def value(self, state: tuple, turn: int, steps: int) -> float:
        """What the pursuers get from a moment before a turn, with so many rounds left."""
        world = self.world(state)
        if world.has_ended() or steps == 0:
            surround = self.config.rules.capture is mw.Capture.SURROUND
            captured = set(world.now) | world.taken if surround else world.ever
            return len(captured) / self.config.n_evaders
        turns = list(world.turns())
        last = turn + 1 == len(turns)
        following = (turn + 1) % len(turns), steps - last
        table = self.successors(state, turn)
        return game_value(np.array([[self.value(s, *following) for s in row] for row in table]))

    def successors(self, state: tuple, turn: int) -> list[list[tuple]]:
        """What follows each joint action of pursuers (rows) and evaders (columns)."""
        if (state, turn) not in self.after:
            world = self.world(state)
            number, agents = list(world.turns())[turn]
            teams = [[a for a in agents if (a in world.evaders) == evaders] for evaders in (0, 1)]
            moves = [list(product(range(self.config.n_actions), repeat=len(t))) for t in teams]
            actors = teams[0] + teams[1]
            self.after[state, turn] = [
                [
                    self.play(world, number, dict(zip(actors, mine + theirs, strict=True)))
                    for theirs in moves[1]
                ]
                for mine in moves[0]
            ]
        return self.after[state, turn]

    def play(self, world: ReferenceWorld, number: int, actions: dict[int, int]) -> tuple:
        world = copy(world)
        world.where, world.ever, world.taken = dict(world.where), set(world.ever), set(world.taken)
        acting = {a for a in actions if a in world.where}
        if acting:
            world.begin_round()
            world.play(number, acting, actions)
        return self.moment(world)


def game_value(matrix: np.ndarray) -> float:
    """The value of a matrix game for the player of the rows."""
    n_rows, n_cols = matrix.shape
    low, high = matrix.min(axis=1).max(), matrix.max(axis=0).min()
    if low == high:  # most games; the rest takes long
        return float(low)
    solved = linprog(
        [*np.zeros(n_rows), -1.0],
        A_ub=np.hstack([-matrix.T, np.ones((n_cols, 1))]),
        b_ub=np.zeros(n_cols),
        A_eq=[[*np.ones(n_rows), 0.0]],
        b_eq=[1.0],
        bounds=[(0, None)] * n_rows + [(None, None)],
    )
    return -solved.fun
