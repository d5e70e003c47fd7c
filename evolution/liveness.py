"""Who waits for whom? Teams with right of way that rest or go in circles, and groups at one cell.

    python evolution/liveness.py                      a few minutes of one core
    python evolution/liveness.py --learned DIRECTORY  with the pursuers of all runs in each
    python evolution/liveness.py --quick              two episodes of each

Careful scripts pursue on 24 x 24 cells that are open, random obstacles, rooms with doors two cells
wide, or corridors one cell wide (SB, 12 against 3, views of 11 x 11 cells, 300 steps). An episode
*freezes* if no pursuer moves for 20 steps, and is in a *livelock* if pursuers move and all agents
repeat their positions with a period of 2 to 20 steps for 20 steps, in each case while an evader
has a free cell beside it. It *waits* in a step in which a pursuer that is beside no evader stays.

Around a free cell: of all groups of two and more teammates beside it, the share of which right of
way admits nobody or more than one, in the order of networks and in the orders by step that scripts
and ratings have. All groups are looked at, in all orders.
"""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

import matrixworld as mw
from common import learned_in, markdown, script_parser, write_json
from matrixworld.world.arrays import CHANNEL, MOVES
from matrixworld.world.masks import right_of_way_cells
from matrixworld.world.policy import TeamPolicy

SIDE, WINDOW, EPISODES = 24, 20, 20
FIRST_SEED = 2 * 10**6
SCRIPTS = "careful-team-surrounder", "careful-surrounder", "careful-chaser"
EVADERS: tuple[TeamPolicy, ...] = "still", "random", "fleer"
MEASURES = "captured", "steps", "waits", "freezes", "livelocks", "faults"


def grounds() -> dict[str, float | NDArray[np.bool_]]:
    """Return obstacles by name."""
    rows, cols = np.indices((SIDE, SIDE))
    walls = (rows % 8 == 7) | (cols % 8 == 7)
    doors = (rows % 8 == 3) | (rows % 8 == 4) | (cols % 8 == 3) | (cols % 8 == 4)
    return {
        "open": 0.0,
        "10 % obstacles": 0.1,
        "rooms": walls & ~doors,
        "corridors": (rows % 4 > 0) & (cols % 4 > 0),
    }


class Looked(NamedTuple):
    """What an episode looks like step by step: T moments, A agents, of them n pursuers."""

    positions: NDArray[np.int64]
    """Cells (T, A, 2) of all agents."""
    open_sides: NDArray[np.bool_]
    """Which sides (T, evaders, 4) of evaders are free: no obstacle and no agent."""
    rests: NDArray[np.bool_]
    """Which pursuers (T - 1, n) stay in a step."""

    @classmethod
    def of(cls, positions: NDArray[Any], obstacles: NDArray[Any], n_pursuers: int) -> Looked:
        """Look at the positions (T, A, 2) of living agents among obstacles (rows, cols)."""
        at = positions.astype(int)
        rows, cols = obstacles.shape
        taken = np.ones((len(at), rows + 2, cols + 2), bool)
        taken[:, 1:-1, 1:-1] = obstacles != 0
        each = np.arange(len(at))[:, None]
        taken[each, at[..., 0] + 1, at[..., 1] + 1] = True
        beside = at[:, n_pursuers:, None] + MOVES[1:5]
        free = ~taken[each[..., None], beside[..., 0] + 1, beside[..., 1] + 1]
        return cls(at, free, (at[1:, :n_pursuers] == at[:-1, :n_pursuers]).all(-1))

    @property
    def freezes(self) -> bool:
        """Whether no pursuer moves for a window of steps while an evader has an open side."""
        return self._repeats(np.concatenate([[False], self.rests.all(1)]))

    @property
    def livelocks(self) -> bool:
        """Whether pursuers move and all agents repeat their positions throughout a window."""
        at = self.positions
        moves = np.concatenate([[False], ~self.rests.all(1)])
        return any(
            self._repeats(np.concatenate([np.zeros(p, bool), same]))
            for p in range(2, min(WINDOW + 1, len(at)))
            if (same := (at[p:] == at[:-p]).all((1, 2)) & moves[p:]).any()
        )

    def _repeats(self, repeats: NDArray[np.bool_]) -> bool:
        """Return whether steps repeat earlier ones throughout a window that ends uncaptured."""
        runs = np.convolve(repeats, np.ones(WINDOW, int))[: len(repeats)]
        return bool(((runs == WINDOW) & self.open_sides.any((1, 2))).any())


def measures(
    config: mw.WorldConfig, pursuers: TeamPolicy, evaders: TeamPolicy, seed: int
) -> tuple[float, ...]:
    """Return the measures of an episode."""
    played = mw.record(config, pursuers, evaders, seed=seed)
    n = config.n_pursuers
    looked = Looked.of(played.positions, played.map, n)
    at = looked.positions
    near = (abs(at[:, :n, None] - at[:, None, n:]).sum(-1) == 1).any(-1)
    waits = float((looked.rests & ~near[:-1]).sum() / max(1, (~near[:-1]).sum()))
    captured = 1.0 - looked.open_sides.any(2)[-1].mean()
    faults = int(played.fault[:, :n].any(-1).sum())
    return captured, len(at) - 1, waits, looked.freezes, looked.livelocks, faults


def admitted(diagonal: bool, step: int | None) -> dict[int, list[int]]:
    """Return how many may enter a free cell, for every group of teammates beside it, by size."""
    config = mw.WorldConfig("S", rows=9, cols=9, fov=5, diagonal=diagonal)
    forbids = right_of_way_cells(config, "pursuer", step)
    team = CHANNEL["pursuer"]
    found: dict[int, list[int]] = {}
    for size in range(1, config.n_actions):
        for group in itertools.combinations(range(1, config.n_actions), size):
            may = 0
            for move in group:
                others = {(team, *(MOVES[move] - MOVES[other]).tolist()) for other in group}
                may += not (others - {(team, 0, 0)}) & set(map(tuple, forbids[move - 1]))
            found.setdefault(size, []).append(may)
    return found


def orders_table() -> str:
    """Return the table of groups around a free cell."""
    lines = []
    for diagonal, name in ((False, "four directions"), (True, "eight directions")):
        turns = [admitted(diagonal, step) for step in range(49)]  # all orders, seven times
        for size, road in admitted(diagonal, None).items():
            numbers = {may for turn in turns for may in turn[size]}
            shares = [f"{sum(may == k for may in road)} of {len(road)}" for k in (0, 1)]
            more = str(sum(may > 1 for may in road))
            told = ", ".join(map(str, sorted(numbers)))
            lines.append([name, str(size), *shares, more, told])
    heads = ["", "teammates", "nobody", "one", "more", "admitted in orders by step"]
    return markdown(heads, lines)


def table(rows: Sequence[Mapping[str, Any]]) -> str:
    """Return the tables of all episodes and of all groups."""
    lines = []
    for row in rows:
        captured, steps, waits = (f"{np.mean(row[name]):.3g}" for name in MEASURES[:3])
        totals = [str(int(sum(row[name]))) for name in MEASURES[3:]]
        lines.append(
            [row["ground"], row["script"], row["evaders"], captured, steps, waits, *totals]
        )
    return "\n\n".join([
        f"Of {len(rows[0]['steps'])} episodes each: evaders captured in the last step, steps, "
        "share of steps in which a pursuer beside no evader stays, and numbers of episodes that "
        "freeze or are in a livelock, and of agent-steps of pursuers at fault.",
        markdown(["ground", "pursuers", "evaders", *MEASURES], lines),
        "Groups of teammates around a free cell, of which right of way admits nobody, one or more "
        "in the order of networks, and the numbers admitted in all orders by step:",
        orders_table(),
    ])  # fmt: skip


def total(
    rows: Sequence[Mapping[str, Any]], measure: str, script: str, *, still: bool
) -> tuple[int, int]:
    """Return in how many episodes pursuers freeze, or are in a livelock, and of how many.

    On all grounds, against evaders that stand still or against the others.
    """
    found = [
        episode
        for row in rows
        if row["script"] == script and (row["evaders"] == "still") == still
        for episode in row[measure]
    ]
    return int(sum(found)), len(found)


def main() -> None:
    """Play all; print and write the tables."""
    parser = script_parser(__doc__, quick="two episodes of each")
    told = "directories of runs: their last pursuers, called as the directory"
    parser.add_argument("--learned", type=Path, nargs="+", default=[], help=told)
    args = parser.parse_args()
    pursuers: dict[str, Sequence[TeamPolicy]] = {name: [name] for name in SCRIPTS}
    pursuers |= {directory.name: learned_in(directory) for directory in args.learned}
    rows = []
    for (ground, obstacles), (name, teams), evaders in itertools.product(
        grounds().items(), pursuers.items(), EVADERS
    ):
        config = mw.WorldConfig(
            "SB", size=SIDE, n_pursuers=12, n_evaders=3, max_steps=300, obstacles=obstacles
        )
        seeds = range(FIRST_SEED, FIRST_SEED + (2 if args.quick else EPISODES))
        played = (measures(config, teams[s % len(teams)], evaders, s) for s in seeds)
        rows.append({"ground": ground, "script": name, "evaders": evaders} | {
            measure: [round(float(value), 4) for value in values]
            for measure, values in zip(MEASURES, zip(*played, strict=True), strict=True)
        })  # fmt: skip
    write_json(args.results, rows, table(rows))


if __name__ == "__main__":
    main()
