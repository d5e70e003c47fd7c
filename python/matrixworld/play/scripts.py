"""The scripted policies, for many agents at once (``cpp/play/script.cpp``).

Each script is a row of data: its goals (cells in view), what a move is worth with regard to the
goals, how often the script errs, and how it searches when it sees no goal. A script considers the
moves that do not lead into an obstacle, and takes one of those with the highest worth, all equally
likely.

Arrays over n agents; an agent has up to K goals, as rows and columns relative to its own cell.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from matrixworld.play.draws import Moments, below, decision_draws, stride_draws
from matrixworld.policy import Script

Ints = NDArray[np.int64]
Bools = NDArray[np.bool_]

# Rows and columns of the actions: stay, north, east, south, west, and the diagonals.
ROW_STEP = np.array([0, -1, 0, 1, 0, -1, 1, 1, -1])
COL_STEP = np.array([0, 0, 1, 0, -1, 1, 1, -1, -1])

SLIP_STEPS = 256
_FAR = 2**31 - 1  # the worth of a move without goals, as in the engine
_CHARGE = 2**14
_OBSTACLES = 2  # the channel of a world's state
_STRIDE = 12  # steps; crosses a usual field of view


@dataclass(frozen=True)
class Offsets:
    """Cells relative to each agent: rows and columns (n, K), and which of them exist (n, K)."""

    rows: Ints
    cols: Ints
    exist: Bools

    @classmethod
    def of_channel(cls, channel: NDArray[Any]) -> Offsets:
        """Return the cells that are set in a channel of the agents' views, (n, fov, fov)."""
        n, fov, _ = channel.shape
        owner, cell = np.nonzero(channel.reshape(n, -1))
        counts = np.bincount(owner, minlength=n)
        place = np.arange(len(owner)) - (np.cumsum(counts) - counts)[owner]
        cells = np.zeros((n, int(counts.max(initial=0))), np.int64)
        cells[owner, place] = cell
        exist = np.arange(cells.shape[1]) < counts[:, None]
        return cls(cells // fov - fov // 2, cells % fov - fov // 2, exist)

    def only(self, kept: Bools) -> Offsets:
        """Return the same cells, of which some do not exist any longer."""
        return Offsets(self.rows, self.cols, self.exist & kept)


@dataclass(frozen=True)
class Sight:
    """What n agents of a team see, and where they are.

    Parameters
    ----------
    moment : mapping of str to ndarray
        The worlds' present moment, with a leading axis of W worlds.
    world, agent : ndarray of int, shape (n,)
        The worlds of the agents, and their numbers in them.
    is_pursuer : bool
        Whether they are pursuers.
    n_actions : int
        5, or 9 with diagonal moves.
    """

    moment: Mapping[str, NDArray[Any]]
    world: NDArray[np.intp]
    agent: NDArray[np.intp]
    is_pursuer: bool
    n_actions: int

    @cached_property
    def adversaries(self) -> Offsets:
        """Cells that hold adversaries, each once."""
        return Offsets.of_channel(self._channel(0 if self.is_pursuer else 1))

    @cached_property
    def teammates(self) -> Offsets:
        """Cells that hold teammates, each once."""
        return Offsets.of_channel(self._channel(1 if self.is_pursuer else 0))

    def _channel(self, number: int) -> NDArray[Any]:
        return np.asarray(self.moment["views"][self.world, self.agent, number])

    def moves(self, rows: Ints, cols: Ints) -> Ints:
        """Return the least number of moves over distances in rows and in columns."""
        diagonal = self.n_actions == len(ROW_STEP)
        join: Callable[..., Ints] = np.maximum if diagonal else np.add
        return join(np.abs(rows), np.abs(cols))

    def is_free(self, rows: Ints, cols: Ints) -> Bools:
        """Whether cells (n, K), relative to the agents, are in the grid and hold no obstacle."""
        obstacles = self.moment["state"][:, _OBSTACLES]
        n_rows, n_cols = obstacles.shape[1:]
        own = self.moment["positions"][self.world, self.agent]
        row, col = own[:, :1] + rows, own[:, 1:] + cols
        inside = (row >= 0) & (row < n_rows) & (col >= 0) & (col < n_cols)
        at = self.world[:, None], row.clip(0, n_rows - 1), col.clip(0, n_cols - 1)
        return np.asarray(inside & (obstacles[at] == 0))


# ---- Goals -------------------------------------------------------------------------------------


def adversaries(sight: Sight) -> Offsets:
    """Return all adversaries in view."""
    return sight.adversaries


def unclaimed_adversaries(sight: Sight) -> Offsets:
    """Return adversaries to which no teammate in view is nearer; if there are none, all."""
    every, mates = sight.adversaries, sight.teammates
    own = sight.moves(every.rows, every.cols)
    theirs = sight.moves(
        mates.rows[:, None] - every.rows[..., None], mates.cols[:, None] - every.cols[..., None]
    )
    nearer = np.asarray(((theirs < own[..., None]) & mates.exist[:, None]).any(axis=-1))
    unclaimed = every.only(~nearer)
    return every.only(~(nearer & unclaimed.exist.any(axis=1, keepdims=True)))


def open_sides(sight: Sight) -> Offsets:
    """Return free cells beside adversaries without those on which a teammate stands."""
    every, mates = sight.adversaries, sight.teammates
    n = len(sight.world)
    sides = slice(1, sight.n_actions)
    rows = (every.rows[..., None] + ROW_STEP[sides]).reshape(n, -1)
    cols = (every.cols[..., None] + COL_STEP[sides]).reshape(n, -1)
    exist = np.repeat(every.exist, sight.n_actions - 1, axis=1) & sight.is_free(rows, cols)
    taken = (rows[..., None] == mates.rows[:, None]) & (cols[..., None] == mates.cols[:, None])
    return Offsets(rows, cols, exist & ~(taken & mates.exist[:, None]).any(axis=-1))


# ---- Worth -------------------------------------------------------------------------------------


def far(sight: Sight, goals: Offsets, action: int) -> Ints:
    """Return the moves to each agent's nearest goal after an action, (n,)."""
    moves = sight.moves(goals.rows - ROW_STEP[action], goals.cols - COL_STEP[action])
    return np.asarray(np.where(goals.exist, moves, _FAR).min(axis=1, initial=_FAR))


def near(sight: Sight, goals: Offsets, action: int) -> Ints:
    """Return minus the moves to the nearest goal, (n,)."""
    return -far(sight, goals, action)


def far_from_all(sight: Sight, goals: Offsets, action: int) -> Ints:
    """Return minus a push that falls with the square of the distance to each goal, (n,)."""
    moves = sight.moves(goals.rows - ROW_STEP[action], goals.cols - COL_STEP[action])
    return np.asarray(-np.where(goals.exist, _CHARGE // (1 + moves) ** 2, 0).sum(axis=1))


@dataclass(frozen=True)
class Row:
    """A script: its goals, the worth of a cell, slips of `SLIP_STEPS`, steps in one direction."""

    goals: Callable[[Sight], Offsets] | None
    worth: Callable[[Sight, Offsets, int], Ints] = near
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


def script_actions(script: Script, sight: Sight, at: Moments) -> Ints:
    """Return the actions of n agents that play a script.

    Parameters
    ----------
    script : str
        The name of the script.
    sight : Sight
        What the agents see.
    at : Moments
        Seed, episode and step of each.

    Returns
    -------
    ndarray of int64, shape (n,)
        The actions.
    """
    row = ROWS[script]
    draws = decision_draws(at, sight.agent)
    slips = draws % SLIP_STEPS < row.slips
    slip = below(draws, sight.n_actions)
    if row.goals is None:
        return np.where(slips, slip, 0)
    goals = row.goals(sight)
    chosen = _best_moves(row, sight, goals, draws)
    if row.stride:
        chosen = np.where(goals.exist.any(axis=1), chosen, _walk_on(row, sight, at, chosen))
    return np.where(slips, slip, chosen)


def _best_moves(row: Row, sight: Sight, goals: Offsets, draws: NDArray[np.uint32]) -> Ints:
    actions = range(sight.n_actions)
    worth = np.stack([row.worth(sight, goals, action) for action in actions], axis=1)
    free = sight.is_free(ROW_STEP[None, : len(actions)], COL_STEP[None, : len(actions)])
    free[:, 0] = True  # an agent can always stay
    best = worth == np.where(free, worth, np.iinfo(np.int64).min).max(axis=1, keepdims=True)
    best &= free
    rank = below(draws, best.sum(axis=1))
    return np.asarray(np.argmax(best.cumsum(axis=1) == rank[:, None] + 1, axis=1))


def _walk_on(row: Row, sight: Sight, at: Moments, otherwise: Ints) -> Ints:
    """Return the direction of the present stride, or another action where it is not free."""
    moves = 1 + below(stride_draws(at, sight.agent, row.stride), sight.n_actions - 1)
    free = sight.is_free(ROW_STEP[moves][:, None], COL_STEP[moves][:, None])
    return np.where(free[:, 0], moves, otherwise)
