"""Scripted pursuers that surround without collisions, beside published ones.

    python evolution/scripted_pursuit.py           half an hour of one core
    python evolution/scripted_pursuit.py --quick   the smallest levels, some seconds

The levels are those of FSC2 (Sun et al., 2022, "Toward multi-target self-organizing pursuit in a
partially observable Markov game", arXiv:2206.12330): pursuers with a view of 11 x 11 cells and
without communication surround evaders on 40 x 40 or 80 x 80 cells within 500 steps. The numbers
published for them are in ``results/scripted_pursuit/published.csv``, with the file of the authors'
repository (LijunSun90/pursuitFSC2 at 604cab1e) that each is from. Here all act at the same time
(SB), and evaders play a script. The *authors' setting* is theirs but for one thing: their
evaders act before the pursuers of a step, here they act after them. Evaders move one by one to a
free cell beside them, drawn at random; all four neighbours of a captured evader are taken, by
whatever it is; and an episode ends when all evaders are captured at one moment. `one_team` plays
the same levels with pursuers that have learned.

Look at the captures in the last step and at the steps, and at the collisions: agent-steps of
pursuers at fault. ``--results`` receives the numbers and the table.
"""

from __future__ import annotations

import csv
import json
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from time import process_time
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray
from tqdm import tqdm

import matrixworld as mw
from common import markdown, mean, script_parser, write_json
from matrixworld.world.arrays import MOVES
from matrixworld.world.policy import TeamPolicy

RESULTS = Path(__file__).parent / "results" / "scripted_pursuit"
FILE = "published.csv"
STEPS = 500


class Level(NamedTuple):
    """Side of the grid, and numbers of pursuers and of evaders."""

    side: int
    pursuers: int
    evaders: int

    def __str__(self) -> str:
        return f"{self.side} x {self.side}, {self.pursuers} v {self.evaders}"


SOME = tuple(Level(40, 4 * n, n) for n in (1, 4, 16, 64, 256))
"""Levels that all kinds play."""
BEST, BEFORE = "careful-team-surrounder", "surrounder"
EPISODES, FEW_EPISODES, MANY = 100, 20, 1024
"""Episodes of a level; fewer where there are as many pursuers as `MANY`."""
MORE_EPISODES = {Level(40, 16, 4): 900}
"""More where few could not tell the script from FSC2."""
FIRST_SEED = 10**6


class Kind(NamedTuple):
    """What plays, in which world."""

    name: str
    pursuers: TeamPolicy
    evaders: str = "random"
    obstacles: float = 0.0
    variant: str = "SB"
    authors: bool = False
    every: bool = False
    """Whether it plays every published level."""


KINDS = (
    Kind("SB, evaders at random", BEST, every=True),
    Kind("the authors' setting", BEST, authors=True, every=True),
    Kind("SDB, evaders at random", BEST, variant="SDB"),
    Kind("SB, evaders that stand still", BEST, "still"),
    Kind("SB, fleers", BEST, "fleer"),
    Kind("SB, dodgers", BEST, "dodger"),
    Kind("SB, 5 % obstacles", BEST, obstacles=0.05),
    Kind("SB, 10 % obstacles", BEST, obstacles=0.1),
    Kind("SB, careful-surrounder", "careful-surrounder"),
    Kind("SB, surrounder", BEFORE),
)


class Row(NamedTuple):
    """Episodes of a kind at a level."""

    captured: list[float]
    """Share of the evaders that is captured in the last step, of each episode."""
    steps: list[int]
    faults: int
    """Agent-steps of pursuers at fault, in all episodes."""
    seconds: float
    """Of an episode, on one core."""


Rows: TypeAlias = dict[str, dict[Level, Row]]


def play(kind: Kind, level: Level, episodes: int) -> Row:
    """Play the episodes of a row."""
    begun, numbers = process_time(), np.arange(episodes)
    if kind.authors:
        played = [authors_episode(level, kind.pursuers, FIRST_SEED + k) for k in numbers]
        faults = sum(each.faults for each in played)
        captured, steps = [each.captured for each in played], [each.steps for each in played]
    else:
        config = world_of(level, kind.variant, kind.obstacles)
        matches = mw.Matches.of(0, 0, FIRST_SEED + numbers)
        told = mw.rollout(config, kind.pursuers, kind.evaders, matches, threads=1)
        captured = np.round(told.capture_rate[:, 0].astype(float), 6).tolist()
        steps, faults = told.length[:, 0].tolist(), int(told.faults[:, :, 0].sum())
    return Row(captured, steps, faults, round((process_time() - begun) / episodes, 4))


def world_of(level: Level, variant: str = "SB", obstacles: float = 0.0) -> mw.WorldConfig:
    """Return the world of a level."""
    side, n, m = level
    return mw.WorldConfig(
        variant, size=side, n_pursuers=n, n_evaders=m, max_steps=STEPS, obstacles=obstacles
    )


class Played(NamedTuple):
    """An episode of T steps."""

    captured: float
    """Share of the evaders that is captured in the last step."""
    steps: int
    faults: int
    """Agent-steps of pursuers at fault."""
    positions: NDArray[Any]
    """Cells (T + 1, agents, 2)."""


def authors_episode(level: Level, pursuers: TeamPolicy, seed: int) -> Played:
    """Play an episode in the authors' setting."""
    bounce, reach = mw.Outcome.BOUNCE, mw.Outcome.REACH
    rules = mw.Rules(mw.Interaction.SWARM_TURNS, bounce, bounce, bounce, reach, mw.Capture.SURROUND)
    side, n, m = level
    world = mw.World(rules, size=side, n_pursuers=n, n_evaders=m, max_steps=STEPS)
    world.reset(seed=int(seed))
    rng = np.random.default_rng(int(seed))
    share, faults, positions = 0.0, 0, [world.positions.copy()]
    while share < 1.0 and not (world.terminated or world.truncated):
        actions = np.zeros(n + m, np.int64)
        world.decide(pursuers, range(n), actions)
        world.play_turn(actions)
        actions[n:] = open_moves(world.positions, n, side, rng)
        world.play_turn(actions)
        faults += int(world.fault[:n].any(axis=1).sum())
        share = float(np.mean([not free for free in sides(world.positions, n, side)]))
        positions.append(world.positions.copy())
    return Played(share, int(world.steps), faults, np.stack(positions))


def sides(positions: np.ndarray, n_pursuers: int, side: int) -> list[list[int]]:
    """Return the moves of each evader that lead to a free cell."""
    taken = set(map(tuple, positions.tolist()))
    return [free_moves(taken, cell, side) for cell in positions[n_pursuers:].tolist()]


def free_moves(taken: set[tuple[int, ...]], cell: Sequence[int], side: int) -> list[int]:
    """Return the moves from a cell to free cells of the grid."""
    row, col = cell
    cells = ((move, row + r, col + c) for move, (r, c) in enumerate(MOVES[:5].tolist()) if move)
    return [m for m, r, c in cells if 0 <= r < side and 0 <= c < side and (r, c) not in taken]


def open_moves(
    positions: np.ndarray, n_pursuers: int, side: int, rng: np.random.Generator
) -> list[int]:
    """Return moves of the evaders to free cells, one evader after the other; 0 without one."""
    taken, chosen = set(map(tuple, positions.tolist())), []
    for row, col in positions[n_pursuers:].tolist():
        free = free_moves(taken, (row, col), side)
        move = free[rng.integers(len(free))] if free else 0
        taken.remove((row, col))
        taken.add((row + int(MOVES[move][0]), col + int(MOVES[move][1])))
        chosen.append(move)
    return chosen


def published() -> dict[Level, dict[str, list[float]]]:
    """Return what is published of each level, by method: captures, steps, collisions, seconds."""
    found: dict[Level, dict[str, list[float]]] = {}
    names = "captured", "steps", "collisions", "seconds"
    with (RESULTS / FILE).open(encoding="utf-8") as file:
        for row in csv.DictReader(file):
            level = Level(*(int(row[name]) for name in ("side", "pursuers", "evaders")))
            found.setdefault(level, {})[row["method"]] = [float(row[name]) for name in names]
    return {level: methods for level, methods in found.items() if "FSC2" in methods}


def table(rows: Rows) -> str:
    """Return what was played of every level beside what is published, and of all kinds at some."""
    theirs = published()
    methods = list(dict.fromkeys(name for each in theirs.values() for name in each))
    whole = [kind for kind, levels in rows.items() if any(each not in SOME for each in levels)]
    heads = [f"{name}, published" for name in methods] + whole
    levels = []
    for level, values in theirs.items():
        ours = [rows[kind].get(level) for kind in whole]
        cells = [published_cell(values[name]) if name in values else "" for name in methods]
        seconds = [short(values["FSC2"][3]), *(short(row.seconds) for row in ours[:1] if row)]
        levels.append([str(level), *cells, *map(cell, ours), " / ".join(seconds)])
    kinds = [
        [kind, *(cell(each.get(level)) for level in SOME), f"{faults_of(each):,}"]
        for kind, each in rows.items()
    ]
    sizes = [f"{level.pursuers} v {level.evaders}" for level in SOME]
    parts = [
        "Evaders captured in the last step / steps [95% over episodes] (of the published ones also "
        "the collisions of an episode). At the end seconds an episode: of FSC2, of the script.",
        markdown(["", *heads, "seconds"], levels).replace("|  |", "| |", 1),
        "On 40 x 40 cells, other evaders, walls and pursuers:",
        markdown(["", *sizes, "pursuers at fault"], kinds).replace("|  |", "| |", 1),
    ]
    return "\n\n".join(parts)


def published_cell(values: Sequence[float]) -> str:
    """Return captures, steps and collisions of a published method as text."""
    captured, steps, collisions, _ = values
    return f"{captured:.4g} / {steps:.0f} ({short(collisions)})"


def short(number: float) -> str:
    """Return a number with three digits, or without fractions."""
    return f"{number:.3g}" if number < 100 else f"{number:,.0f}"


def cell(row: Row | None) -> str:
    """Return captures and steps of a row as text."""
    if row is None:
        return ""
    return f"{np.mean(row.captured):.4g} / {mean(row.steps, 0, bounds=(0.0, float(STEPS)))}"


def gaps(kept: Mapping[str, Any], kind: str) -> list[float]:
    """Return by how much more of the evaders a kind captures than FSC2, at each level.

    `kept` is what `plain_rows` returns. Four digits, as published.
    """
    captured = {Level(*row["level"]): float(np.mean(row["captured"])) for row in kept[kind]}
    return [
        round(captured[level], 4) - round(methods["FSC2"][0], 4)
        for level, methods in published().items()
    ]


def faults_of(rows: Mapping[Level, Row]) -> int:
    """Return the agent-steps of pursuers at fault in all rows."""
    return sum(row.faults for row in rows.values())


def rows_of(kinds: Iterable[Kind], levels: Iterable[Level], quick: bool) -> Rows:
    """Return the rows of kinds by name and level."""
    found: Rows = {}
    for kind in kinds:
        found[kind.name] = {}
        chosen = [level for level in levels if kind.every or level in SOME]
        for level in tqdm(chosen, desc=kind.name, disable=None):
            # The scripts that it replaces take minutes for an episode's crowd, and say no more.
            if level.pursuers < MANY or kind.pursuers == BEST or kind.every:
                few = FEW_EPISODES if level.pursuers >= MANY else EPISODES
                episodes = 2 if quick else MORE_EPISODES.get(level, few)
                found[kind.name][level] = play(kind, level, episodes)
    return found


def plain_rows(rows: Rows) -> dict[str, Any]:
    """Return rows as JSON has them."""
    return {
        kind: [{"level": at, **row._asdict()} for at, row in of_kind.items()]
        for kind, of_kind in rows.items()
    }


def read_rows(text: str) -> Rows:
    """Return the rows of `plain_rows`."""
    return {
        kind: {Level(*each.pop("level")): Row(**each) for each in rows}
        for kind, rows in json.loads(text).items()
    }


def main() -> None:
    """Play all rows; print and write them."""
    parser = script_parser(__doc__, quick="the smallest levels, two episodes each")
    args = parser.parse_args()
    rows = rows_of(KINDS, SOME[:2] if args.quick else published(), args.quick)
    write_json(args.results, plain_rows(rows), table(rows))


if __name__ == "__main__":
    main()
