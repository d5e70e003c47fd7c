"""The scripted policies, for many agents at once (``cpp/play/script.cpp``).

Each script is a row of data: its goals (cells in view), what a move is worth with regard to the
goals, how often the script errs, and how it searches when it sees no goal. A script considers the
moves that do not lead into an obstacle, and takes one of those with the highest worth, all equally
likely.

Arrays over n agents; an agent has up to K goals, as rows and columns relative to its own cell.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from matrixworld.play.draws import Moments, below, decision_draws, stride_draws
from matrixworld.policy import Script

Ints = NDArray[np.int64]
Bools = NDArray[np.bool_]

# Rows and columns of the actions: stay, north, east, south, west, and the diagonals.
STEPS = np.array([[0, 0], [-1, 0], [0, 1], [1, 0], [0, -1], [-1, 1], [1, 1], [1, -1], [-1, -1]])

SLIP_STEPS = 256
_FAR = 2**31 - 1  # the worth of a move without goals, as in the engine
_CHARGE = 2**14
_STRIDE = 12  # steps; crosses a usual field of view


@dataclass(frozen=True)
class Offsets:
    """Cells relative to each agent: rows and columns (n, K, 2), and which of them exist (n, K)."""

    cells: Ints
    exist: Bools

    @classmethod
    def of_channel(cls, channel: NDArray[np.uint8]) -> Offsets:
        """Return the cells that are set in a channel of the agents' views, (n, fov, fov)."""
        n, fov, _ = channel.shape
        owner, cell = np.nonzero(channel.reshape(n, -1))
        counts = np.bincount(owner, minlength=n)
        place = np.arange(len(owner)) - (np.cumsum(counts) - counts)[owner]
        cells = np.zeros((n, int(counts.max(initial=0)), 2), np.int64)
        cells[owner, place] = np.stack([cell // fov, cell % fov], axis=1) - fov // 2
        return cls(cells, np.arange(cells.shape[1]) < counts[:, None])

    def only(self, kept: Bools) -> Offsets:
        """Return the same cells, of which some do not exist any longer."""
        return Offsets(self.cells, self.exist & kept)


@dataclass(frozen=True)
class Sight:
    """What n agents see, and where they are.

    Parameters
    ----------
    views : ndarray of uint8, shape (n, 3, fov, fov)
        Their views.
    positions : ndarray of int, shape (n, 2)
        Rows and columns.
    maps : ndarray of bool, shape (n, rows, cols)
        Obstacles of their worlds.
    is_pursuer : bool
        Whether they are pursuers; all are of one team.
    n_actions : int
        5, or 9 with diagonal moves.
    """

    views: NDArray[np.uint8]
    positions: Ints
    maps: Bools
    is_pursuer: bool
    n_actions: int

    @cached_property
    def adversaries(self) -> Offsets:
        """Cells that hold adversaries, each once."""
        return Offsets.of_channel(self.views[:, 0 if self.is_pursuer else 1])

    @cached_property
    def teammates(self) -> Offsets:
        """Cells that hold teammates, each once."""
        return Offsets.of_channel(self.views[:, 1 if self.is_pursuer else 0])

    def moves(self, there: Ints, cells: Ints) -> Ints:
        """Return the least number of moves between cells, over the last axis."""
        apart = np.abs(there - cells)
        return np.asarray(apart.max(-1) if self.n_actions == len(STEPS) else apart.sum(-1))

    def is_free(self, cells: Ints) -> Bools:
        """Whether cells (n, K, 2) are inside the grid and hold no obstacle."""
        n, rows, cols = self.maps.shape
        at = self.positions[:, None] + cells
        inside = ((at >= 0) & (at < (rows, cols))).all(axis=-1)
        row, col = at[..., 0].clip(0, rows - 1), at[..., 1].clip(0, cols - 1)
        return np.asarray(inside & ~self.maps[np.arange(n)[:, None], row, col])


# ---- Goals -------------------------------------------------------------------------------------


def adversaries(sight: Sight) -> Offsets:
    """Return all adversaries in view."""
    return sight.adversaries


def unclaimed_adversaries(sight: Sight) -> Offsets:
    """Return adversaries to which no teammate in view is nearer; if there are none, all."""
    every, mates = sight.adversaries, sight.teammates
    own = sight.moves(np.zeros(2, np.int64), every.cells)
    theirs = sight.moves(mates.cells[:, None], every.cells[:, :, None])
    nearer = np.asarray(((theirs < own[..., None]) & mates.exist[:, None]).any(axis=-1))
    unclaimed = every.only(~nearer)
    return every.only(~(nearer & unclaimed.exist.any(axis=1, keepdims=True)))


def open_sides(sight: Sight) -> Offsets:
    """Return free cells beside adversaries without those on which a teammate stands."""
    every, mates = sight.adversaries, sight.teammates
    sides = STEPS[1 : sight.n_actions]
    n = len(every.cells)
    beside = (every.cells[:, :, None] + sides).reshape(n, -1, 2)
    exist = np.repeat(every.exist, len(sides), axis=1)
    taken = (beside[:, :, None] == mates.cells[:, None]).all(axis=-1) & mates.exist[:, None]
    return Offsets(beside, exist & ~taken.any(axis=-1) & sight.is_free(beside))


# ---- Worth -------------------------------------------------------------------------------------


def far(sight: Sight, goals: Offsets, there: Ints) -> Ints:
    """Return the moves from a cell to each agent's nearest goal, (n,)."""
    moves = np.where(goals.exist, sight.moves(there, goals.cells), _FAR)
    return np.asarray(moves.min(axis=1, initial=_FAR))


def near(sight: Sight, goals: Offsets, there: Ints) -> Ints:
    """Return minus the moves to the nearest goal, (n,)."""
    return -far(sight, goals, there)


def far_from_all(sight: Sight, goals: Offsets, there: Ints) -> Ints:
    """Return minus a push that falls with the square of the distance to each goal, (n,)."""
    push = _CHARGE // (1 + sight.moves(there, goals.cells)) ** 2
    return np.asarray(-np.where(goals.exist, push, 0).sum(axis=1))


@dataclass(frozen=True)
class Row:
    """A script: its goals, the worth of a cell, slips of `SLIP_STEPS`, steps in one direction."""

    goals: Callable[[Sight], Offsets] | None
    worth: Callable[[Sight, Offsets, Ints], Ints] = near
    slips: int = 0
    stride: int = 0


ROWS: dict[Script, Row] = {
    "random": Row(None, slips=SLIP_STEPS),
    "still": Row(None),
    "chaser": Row(adversaries, near),
    "fleer": Row(adversaries, far),
    "clumsy-chaser": Row(adversaries, near, slips=SLIP_STEPS // 2),
    "hunter": Row(unclaimed_adversaries, near, stride=_STRIDE),
    "surrounder": Row(open_sides, near, stride=_STRIDE),
    "clumsy-fleer": Row(adversaries, far, slips=SLIP_STEPS // 2),
    "dodger": Row(adversaries, far_from_all),
}


def script_actions(script: Script, sight: Sight, at: Moments, agents: Ints) -> Ints:
    """Return the actions of n agents that play a script.

    Parameters
    ----------
    script : str
        The name of the script.
    sight : Sight
        What the agents see.
    at : Moments
        Seed, episode and step of each.
    agents : ndarray of int, shape (n,)
        Their numbers in their worlds.

    Returns
    -------
    ndarray of int64, shape (n,)
        The actions.
    """
    row = ROWS[script]
    draws = decision_draws(at, agents)
    slips = draws % SLIP_STEPS < row.slips
    slip = below(draws, sight.n_actions)
    if row.goals is None:
        return np.where(slips, slip, 0)
    goals = row.goals(sight)
    chosen = _best_moves(row, sight, goals, draws)
    if row.stride:
        chosen = np.where(goals.exist.any(axis=1), chosen, _walk_on(row, sight, at, agents, chosen))
    return np.where(slips, slip, chosen)


def _best_moves(row: Row, sight: Sight, goals: Offsets, draws: NDArray[np.uint32]) -> Ints:
    steps = STEPS[: sight.n_actions]
    worth = np.stack([row.worth(sight, goals, step) for step in steps], axis=1)
    free = sight.is_free(np.broadcast_to(steps, (len(draws), *steps.shape)))
    free[:, 0] = True  # an agent can always stay
    best = worth == np.where(free, worth, np.iinfo(np.int64).min).max(axis=1, keepdims=True)
    best &= free
    rank = below(draws, best.sum(axis=1))
    return np.asarray(np.argmax(best.cumsum(axis=1) == rank[:, None] + 1, axis=1))


def _walk_on(row: Row, sight: Sight, at: Moments, agents: Ints, otherwise: Ints) -> Ints:
    """Return the direction of the present stride, or another action where it is not free."""
    moves = 1 + below(stride_draws(at, agents, row.stride), sight.n_actions - 1)
    return np.where(sight.is_free(STEPS[moves][:, None])[:, 0], moves, otherwise)
