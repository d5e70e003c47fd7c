"""Twenty-four small worlds, and what all players of two teams get in one of them, exactly.

The worlds are drawn by a rule with a seed; no result of any player decides which. ``league.py``
compares leagues in them.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy import sparse
from tqdm import tqdm

import league_players
import matrixworld as mw
import tabular
from matrixworld.coevolution import TEAMS, Team
from matrixworld.coevolution.types import other
from matrixworld.solver import States, best_response, solve, table
from matrixworld.world.rules import VARIANTS

N_WORLDS = 24
"""Half of them in turns and half at once, in alternation."""
WORLD_SEED = 2411
TEAM_SIZES = ((1, 1), (2, 1), (1, 2), (2, 2))
"""Pursuers and evaders, in rotation."""
SIDES, WALLS, STEPS = (3, 6), (1, 4), (3, 9)
VALUES, MOST = (0.1, 0.9), 3000
"""Values of worlds, and how many states and different views of a team they have at most."""
MOST_PLACES = 15_000
"""Joint places of agents that are numbered; worlds with more are not even listed."""

Floats: TypeAlias = NDArray[np.float64]
Tables: TypeAlias = list[Floats]
"""By turn: probabilities (S, joint actions)."""


# Worlds


def drawn(rng: np.random.Generator, in_turns: bool, sizes: tuple[int, int]) -> str:
    """Return the name of a world that is drawn by chance."""
    n, m = sizes
    if in_turns:
        turns, capture = rng.choice([*tabular.TURNS]), rng.choice([*tabular.CAPTURES])
        rules = f"{turns}, {capture}"
    else:
        rules = rng.choice([name for name in VARIANTS if name != "TO"])
    rows, cols = sorted(rng.integers(SIDES[0], SIDES[1] + 1, 2))
    board = np.full(rows * cols, ".")
    walls = rng.integers(WALLS[0], WALLS[1] + 1)
    board[rng.choice(rows * cols, walls, replace=False)] = "#"
    text = "/".join(map("".join, board.reshape(rows, cols)))
    steps = rng.integers(STEPS[0], STEPS[1] + 1)
    return f"{rules}; {n} v {m}; {rows} x {cols} with walls {text}; {steps} steps"


def config_of(name: str) -> mw.WorldConfig:
    """Return the world of a name, in which the players see all."""
    return replace(tabular.config_of(name), fov=league_players.FOV)


def fits(name: str) -> bool:
    """Return whether a world is small, and neither team surely wins."""
    config = config_of(name)
    free = config.rows * config.cols - name.count("#")
    if free**config.n_agents > MOST_PLACES:
        return False
    states = States(config, threads=1)
    if states.total > MOST or not VALUES[0] <= solve(states).value <= VALUES[1]:
        return False
    return all(len(states.views(team)[0]) <= MOST for team in TEAMS)


def draw_worlds() -> list[str]:
    """Return the names of the worlds."""
    rng = np.random.default_rng(WORLD_SEED)
    known = {name.rpartition("; ")[0] for name in tabular.WORLDS}
    found: list[str] = []
    while len(found) < N_WORLDS:
        place = len(found)
        sizes = TEAM_SIZES[place // 2 % len(TEAM_SIZES)]
        name = drawn(rng, place % 2 == 0, sizes)
        if (but_steps := name.rpartition("; ")[0]) not in known and fits(name):
            known.add(but_steps)
            found.append(name)
    return found


# Exact results


def operators(tables: Tables, successors: list[NDArray[np.intp]], next_counts: list[int]) -> Any:
    """Return for each turn what a fixed player makes of values: a matrix (S * Q, next states).

    `successors` are (S, its joint actions, Q) by turn.
    """
    found = []
    for play, succ, count in zip(tables, successors, next_counts, strict=True):
        states, actions = np.nonzero(play)
        n, _, others = succ.shape
        rows = (states[:, None] * others + np.arange(others)).ravel()
        weights = np.repeat(play[states, actions], others)
        columns = succ[states, actions].ravel()
        found.append(sparse.csr_array((weights, (rows, columns)), (n * others, count)))
    return found


def met(
    states: States, team: Team, rounds: Iterable[Tables], opponents: Tables, ends: Floats
) -> Floats:
    """Return the mean value, (payoffs, n), of one player that meets n opponents.

    Parameters
    ----------
    states : States
        The world.
    team : {"pursuer", "evader"}
        The player's team.
    rounds : iterable of list of ndarray, by turn (S, P)
        How it plays with 1, 2, ... rounds left.
    opponents : list of ndarray, by turn (S, Q, n)
        How the opponents play.
    ends : ndarray, shape (payoffs, S)
        What the states of the first turn are worth when no round is left.
    """
    successors = [states.successors(turn) for turn in range(states.n_turns)]
    if team == "evader":
        successors = [succ.transpose(0, 2, 1) for succ in successors]
    counts = [len(succ) for succ in successors]
    payoffs, n = len(ends), opponents[0].shape[2]
    values = np.repeat(ends.T[:, :, None], n, axis=2).reshape(-1, payoffs * n)
    known: tuple[Tables | None, Any] = (None, None)
    for tables in rounds:
        if tables is not known[0]:
            known = tables, operators(tables, successors, [*counts[1:], counts[0]])
        for turn in reversed(range(states.n_turns)):
            after = (known[1][turn] @ values).reshape(counts[turn], -1, payoffs, n)
            if after.shape[1] == 1:
                values = after.reshape(counts[turn], -1)
            else:
                values = np.einsum("sqkn,sqn->skn", after, opponents[turn]).reshape(len(after), -1)
    return np.asarray(values.reshape(-1, payoffs, n)[states.starts].mean(axis=0))


def different(tables: list[Tables]) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Return the first player of each table, and the number of each player's table."""
    keys = [b"".join(np.round(each, 12).tobytes() for each in one) for one in tables]
    numbers: dict[bytes, int] = {}
    number = np.array([numbers.setdefault(key, len(numbers)) for key in keys])
    return np.unique(number, return_index=True)[1], number


def played(name: str, players: Mapping[Team, list[Any]]) -> dict[str, ArrayLike]:
    """Return the exact results of all players in a world.

    By team: the number of the table of each player, and of each table the grade and the result
    against perfect play; of all pairs of tables the mean captures and their mean squares. All are
    captures.
    """
    states = States(config_of(name), threads=1)
    solution = solve(states)
    steps = states.config.max_steps
    shares = states.captured().mean(axis=1)
    found: dict[str, ArrayLike] = {"value": solution.value}
    all_tables, stacked = {}, {}
    for team in TEAMS:
        # No player counts steps: each has one table for all of them.
        tables = [list(table(states, each, team).steps[0]) for each in players[team]]
        first, found[f"{team} table"] = different(tables)
        found[f"{team} grade"] = np.array(
            [best_response(states, players[team][k], team).value for k in first]
        )
        all_tables[team] = [tables[k] for k in first]
        stacked[team] = [np.stack(turn, axis=2) for turn in zip(*all_tables[team], strict=True)]
    for team in TEAMS:
        perfect = (
            [solution.probabilities(other(team), left, turn) for turn in range(states.n_turns)]
            for left in range(1, steps + 1)
        )
        [found[f"{team} against perfect play"]] = met(
            states, other(team), perfect, stacked[team], shares[None]
        )
    ends = np.stack([shares, shares**2][: states.config.n_evaders])  # one evader: equal
    # The team with more joint actions is played one by one: its zeros are skipped.
    joint = {team: max(each.shape[1] for each in stacked[team]) for team in TEAMS}
    one = max(TEAMS, key=joint.__getitem__)
    each = tqdm(all_tables[one], desc=name, unit=" players", disable=None, leave=False)
    results = np.stack(
        [met(states, one, [tables] * steps, stacked[other(one)], ends) for tables in each], axis=1
    )
    means, *squares = results if one == "pursuer" else results.transpose(0, 2, 1)
    return {**found, "means": means, "squares": squares[0] if squares else means}
