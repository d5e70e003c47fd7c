"""What does right of way cost a team? Values of small worlds, exactly, with the mask and without.

    python evolution/mask_price.py           all variants, twenty minutes of one core
    python evolution/mask_price.py --quick   two of them, some seconds

A mask takes moves away, so a team that keeps it can guarantee at most as much. Here both teams play
perfectly and see the whole world (docs/ground_truth.md), and a masked team never plays a joint
action in which one of its members makes a move that right of way forbids (docs/safety.md). Backward
induction is done here once more, by linear programmes: without masks it gives the value of
`matrixworld.solver.solve`, which is checked. The mask looks at cells at most two moves away.

The *price* of the mask is how much less a team guarantees: of pursuers the value without masks
minus the value in which they keep it, of evaders the other way round. *Both* is what the value
becomes if both teams keep it. Where agents take turns they keep right of way, too, as a run with
``policy.mask=right-of-way`` does. All numbers are exact but for rounding.
"""

from __future__ import annotations

from collections.abc import Collection
from functools import cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from tqdm import tqdm

import matrixworld as mw
from common import markdown, script_parser, write_json
from matrixworld.analysis.games import game_value
from matrixworld.coevolution import TEAMS, Team
from matrixworld.solver import States, solve
from matrixworld.world.arrays import CHANNEL
from matrixworld.world.masks import right_of_way_cells
from matrixworld.world.rules import VARIANTS

SIDE = 4
SIZES = {
    mw.Capture.OCCUPATION: ((2, 1, 4), (1, 2, 4)),
    mw.Capture.SURROUND: ((2, 1, 10), (3, 1, 6)),
}
"""Pursuers, evaders and steps of a variant, by what captures."""
MASKED: dict[str, tuple[Team, ...]] = {
    "none": (), "pursuers masked": ("pursuer",), "evaders masked": ("evader",), "both": TEAMS,
}  # fmt: skip
ROUNDING = 1e-6
Joint = NDArray[np.intp]


class World(NamedTuple):
    """A variant, the numbers of its agents, and the steps of an episode."""

    variant: str
    pursuers: int
    evaders: int
    steps: int

    @property
    def config(self) -> mw.WorldConfig:
        """The world; agents see the whole grid."""
        return mw.WorldConfig(
            self.variant, size=SIDE, n_pursuers=self.pursuers, n_evaders=self.evaders,
            fov=2 * SIDE - 1, max_steps=self.steps,
        )  # fmt: skip


def forbidden(config: mw.WorldConfig, cells: NDArray[np.int32]) -> NDArray[np.bool_]:
    """Return which moves right of way forbids, (S, A, actions), to agents in cells (S, A)."""
    n_states, n_agents = cells.shape
    found = np.zeros((n_states, n_agents, config.n_actions), bool)
    n = config.n_pursuers
    for agent in range(n_agents):
        rows, cols = np.divmod(cells[:, agent], config.cols)
        rules = right_of_way_cells(config, "pursuer" if agent < n else "evader")
        for move, forbidding in enumerate(rules, start=1):
            for channel, down, right in forbidding:
                row, col = rows + down, cols + right
                inside = (row >= 0) & (row < config.rows) & (col >= 0) & (col < config.cols)
                there = row * config.cols + col
                if channel == CHANNEL["obstacle"]:
                    found[:, agent, move] |= ~inside
                    continue
                others = range(n) if channel == CHANNEL["pursuer"] else range(n, n_agents)
                for other in others:
                    if other != agent:
                        found[:, agent, move] |= inside & (cells[:, other] == there)
        found[cells[:, agent] < 0, agent] = False  # gone
    return found


def instead(
    forbids: NDArray[np.bool_], members: Collection[int], n_joint: int, n_actions: int
) -> Joint:
    """Return the joint action (S, P) that stands for each one: whoever may not move stays.

    Joint actions are numbers whose digits are the actions of `members`, the first one's the
    highest.
    """
    joint = np.zeros((len(forbids), n_joint), np.intp)
    for place, member in enumerate(reversed([*members])):
        digit = np.arange(n_joint) // n_actions**place % n_actions
        stays = forbids[:, member][:, digit]
        joint += np.where(stays, 0, digit) * n_actions**place
    return joint


def acting(config: mw.WorldConfig, turn: int, team: Team) -> list[int]:
    """Return which agents of a team act in a turn."""
    first = team == "pursuer"
    whole = [*range(config.n_pursuers)] if first else [*range(config.n_pursuers, config.n_agents)]
    interaction = config.rules.interaction
    if interaction is mw.Interaction.SIMULTANEOUS:
        return whole
    if interaction is mw.Interaction.SWARM_TURNS:
        return whole if first == (turn == 0) else []
    return [turn] if turn in whole else []


def value(states: States, masked: Collection[Team]) -> float:
    """Return the value of a world in which some teams keep right of way."""
    config, n_actions = states.config, states.config.n_actions
    games = []
    for turn in range(states.n_turns):
        succ, cells = states.successors(turn), states.cells(turn)
        forbids = forbidden(config, cells)
        for axis, team in enumerate(TEAMS, start=1):
            members = acting(config, turn, team)
            if team in masked and members:
                joint = instead(forbids, members, succ.shape[axis], n_actions)
                shape = (len(joint), -1, 1) if axis == 1 else (len(joint), 1, -1)
                succ = np.take_along_axis(succ, joint.reshape(shape), axis)
        games.append(succ)
    after = states.captured().mean(axis=1)
    for _ in range(config.max_steps):
        for succ in reversed(games):
            after = solved(after[succ])
    return float(after[states.starts].mean())


def solved(games: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the values (S,) of matrix games (S, P, Q), in which pursuers choose the row."""
    low, high = games.min(axis=2).max(axis=1), games.max(axis=1).min(axis=1)
    values = low.copy()
    for place in np.flatnonzero(high - low > ROUNDING):
        # Equal rows and columns, such as those that the mask made equal, change nothing.
        rows = np.unique(np.round(games[place], 9), axis=0)
        values[place] = _value(np.unique(rows, axis=1).tobytes(), len(rows))
    return values


@cache
def _value(matrix: bytes, rows: int) -> float:
    return game_value(np.frombuffer(matrix).reshape(rows, -1))


def measured(world: World) -> dict[str, Any]:
    """Return the values of a world with and without masks."""
    states = States(world.config, threads=1)
    found = {name: value(states, teams) for name, teams in MASKED.items()}
    expected = solve(states).value
    if abs(found["none"] - expected) > ROUNDING:
        raise AssertionError(f"{world}: expected the value {expected}, got {found['none']}")
    return {**world._asdict(), **found}


def table(rows: list[dict[str, Any]]) -> str:
    """Return values and prices in Markdown."""
    heads = ["variant", "", "steps", "value", "pursuers keep it", "evaders keep it", "both keep it"]
    heads += ["price for pursuers", "price for evaders"]
    lines = [
        [
            row["variant"],
            f"{row['pursuers']} v {row['evaders']}",
            str(row["steps"]),
            *(f"{row[name]:.4f}" for name in MASKED),
            f"{row['none'] - row['pursuers masked']:.4f}",
            f"{row['evaders masked'] - row['none']:.4f}",
        ]
        for row in rows
    ]
    told = f"Capture rates of perfect play on {SIDE} x {SIDE} cells: values with masks and without."
    return f"{told}\n\n{markdown(heads, lines)}".replace("|  |", "| |", 1)


def main() -> None:
    """Solve all worlds; print and write them."""
    parser = script_parser(__doc__, quick="two small worlds")
    args = parser.parse_args()
    names = ["O", "SB"] if args.quick else [*VARIANTS]
    worlds = [World(n, *size) for n in names for size in SIZES[VARIANTS[n].capture]]
    rows = [measured(world) for world in tqdm(worlds, disable=None)]
    write_json(args.results, rows, table(rows))


if __name__ == "__main__":
    main()
