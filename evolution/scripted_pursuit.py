"""Scripted pursuers that surround without collisions, beside published ones.

    python evolution/scripted_pursuit.py                       ten minutes of one core
    python evolution/scripted_pursuit.py --networks DIRECTORY   networks of all runs in it, too
    python evolution/scripted_pursuit.py --quick               the smallest rows, some seconds

The rows are those of FSC2 (Sun et al., 2022, "Toward multi-target self-organizing pursuit in a
partially observable Markov game", arXiv:2206.12330): pursuers with a view of 11 x 11 cells and
without communication surround evaders on 40 x 40 cells within 500 steps. Here all act at the same
time (SB), and evaders play a script. The *authors' setting* is theirs but for one thing: their
evaders act before the pursuers of a step, here they act after them. Evaders move one by one to a
free cell beside them, drawn at random; all four neighbours of a captured evader are taken, by
whatever it is; and an episode ends when all evaders are captured at one moment.

Look at the captures in the last step and at the steps, and at the collisions: agent-steps of
pursuers at fault. ``--results`` receives the numbers and the table.
"""

from __future__ import annotations

import json
from collections.abc import Iterable
from pathlib import Path
from time import process_time
from typing import NamedTuple

import numpy as np
from tqdm import tqdm

import matrixworld as mw
from common import markdown, mean, script_parser
from matrixworld.coevolution import open_run
from matrixworld.world.arrays import MOVES
from matrixworld.world.policy import TeamPolicy

SIDE, STEPS = 40, 500
SIZES = ((4, 1), (16, 4), (64, 16), (256, 64), (1024, 256))
"""Pursuers and evaders of each row."""
PUBLISHED = {
    "FSC2": ((1.0, 112), (1.0, 108), (0.9975, 134), (0.9988, 113), (0.9939, 338)),
    "FSC2, seconds": (0.7, 2.6, 13, 70, 2487),
}
"""Captures and steps of the published pursuers, without a collision, and seconds an episode (their
files ``sop_40_40_*_statistical_result.txt``)."""
BEST, BEFORE = "careful-team-surrounder", "surrounder"
EPISODES, FEW_EPISODES, MANY = 100, 20, 1024
"""Episodes of a row; fewer where there are as many pursuers as `MANY`."""
FIRST_SEED = 10**6


class Kind(NamedTuple):
    """Rows of one kind: what plays, in which world."""

    name: str
    pursuers: TeamPolicy
    evaders: str = "random"
    obstacles: float = 0.0
    variant: str = "SB"
    authors: bool = False


KINDS = (
    Kind("SB, evaders at random", BEST),
    Kind("the authors' setting", BEST, authors=True),
    Kind("SDB, evaders at random", BEST, variant="SDB"),
    Kind("SB, fleers", BEST, "fleer"),
    Kind("SB, dodgers", BEST, "dodger"),
    Kind("SB, 5 % obstacles", BEST, obstacles=0.05),
    Kind("SB, 10 % obstacles", BEST, obstacles=0.1),
    Kind("SB, careful-surrounder", "careful-surrounder"),
    Kind("SB, surrounder", BEFORE),
)


class Row(NamedTuple):
    """Episodes of a kind and a size."""

    captured: list[float]
    """Share of the evaders that is captured in the last step, of each episode."""
    steps: list[int]
    faults: int
    """Agent-steps of pursuers at fault, in all episodes."""
    seconds: float
    """Of an episode, on one core."""


def play(kind: Kind, size: tuple[int, int], episodes: int) -> Row:
    """Play the episodes of a row."""
    if kind.authors:
        return authors_row(kind, size, episodes)
    config = mw.WorldConfig(
        kind.variant, rows=SIDE, cols=SIDE, n_pursuers=size[0], n_evaders=size[1],
        max_steps=STEPS, obstacles=kind.obstacles,
    )  # fmt: skip
    begun = process_time()
    teams = len(kind.pursuers.genomes) if isinstance(kind.pursuers, mw.Population) else 1
    numbers = np.arange(episodes)
    matches = mw.Matches.of(numbers % teams, 0, FIRST_SEED + numbers)
    played = mw.rollout(config, kind.pursuers, kind.evaders, matches, threads=1)
    return Row(
        np.round(played.capture_rate[:, 0].astype(float), 6).tolist(),
        played.length[:, 0].tolist(),
        int(played.faults[:, :, 0].sum()),
        round((process_time() - begun) / episodes, 4),
    )


def authors_row(kind: Kind, size: tuple[int, int], episodes: int) -> Row:
    """Play the episodes of a row in the authors' setting."""
    bounce, reach = mw.Outcome.BOUNCE, mw.Outcome.REACH
    rules = mw.Rules(mw.Interaction.SWARM_TURNS, bounce, bounce, bounce, reach, mw.Capture.SURROUND)
    world = mw.World(
        rules, rows=SIDE, cols=SIDE, n_pursuers=size[0], n_evaders=size[1], max_steps=STEPS
    )
    captured, steps, faults, begun = [], [], 0, process_time()
    for episode in range(episodes):
        world.reset(seed=FIRST_SEED + episode)
        rng = np.random.default_rng(FIRST_SEED + episode)
        share = 0.0
        while share < 1.0 and not (world.terminated or world.truncated):
            actions = np.zeros(sum(size), np.int64)
            world.decide(kind.pursuers, range(size[0]), actions)
            world.play_turn(actions)
            actions[size[0] :] = open_moves(world.positions, size[0], rng)
            world.play_turn(actions)
            faults += int(world.fault[: size[0]].any(axis=1).sum())
            share = float(np.mean([not free for free in sides(world.positions, size[0])]))
        captured.append(share)
        steps.append(int(world.steps))
    return Row(captured, steps, faults, round((process_time() - begun) / episodes, 4))


def sides(positions: np.ndarray, n_pursuers: int) -> list[list[int]]:
    """Return the moves of each evader that lead to a free cell."""
    taken = set(map(tuple, positions.tolist()))
    return [free_moves(taken, row, col) for row, col in positions[n_pursuers:].tolist()]


def free_moves(taken: set[tuple[int, ...]], row: int, col: int) -> list[int]:
    """Return the moves from a cell to free cells of the grid."""
    cells = ((move, row + r, col + c) for move, (r, c) in enumerate(MOVES[:5].tolist()) if move)
    return [m for m, r, c in cells if 0 <= r < SIDE and 0 <= c < SIDE and (r, c) not in taken]


def open_moves(positions: np.ndarray, n_pursuers: int, rng: np.random.Generator) -> list[int]:
    """Return moves of the evaders to free cells, one evader after the other; 0 without one."""
    taken, chosen = set(map(tuple, positions.tolist())), []
    for row, col in positions[n_pursuers:].tolist():
        free = free_moves(taken, row, col)
        move = free[rng.integers(len(free))] if free else 0
        taken.remove((row, col))
        taken.add((row + int(MOVES[move][0]), col + int(MOVES[move][1])))
        chosen.append(move)
    return chosen


def table(rows: dict[str, list[Row | None]]) -> str:
    """Return captures and steps of all kinds, faults and seconds, in Markdown."""
    sizes = [f"{n} v {m}" for n, m in SIZES]
    published = [f"{captured:g} / {steps}" for captured, steps in PUBLISHED["FSC2"]]
    lines = [["FSC2, published", *published, "0"]]
    for name, each in rows.items():
        faults = sum(row.faults for row in each if row)
        lines.append([name, *map(cell, each), f"{faults:,}"])
    seconds = [row.seconds if row else None for row in next(iter(rows.values()))]
    parts = [
        "Evaders captured in the last step / steps [95% over episodes].",
        markdown(["", *sizes, "pursuers at fault"], lines).replace("|  |", "| |", 1),
        "Seconds an episode:",
        markdown(
            ["", *sizes],
            [
                ["FSC2, published", *(f"{s:g}" for s in PUBLISHED["FSC2, seconds"])],
                [f"{BEST}, one core", *("" if s is None else f"{s:.2g}" for s in seconds)],
            ],
        ).replace("|  |", "| |", 1),
    ]
    return "\n\n".join(parts)


def cell(row: Row | None) -> str:
    """Return captures and steps of a row as text."""
    if row is None:
        return ""
    return f"{np.mean(row.captured):.4g} / {mean(row.steps, 0, bounds=(0.0, float(STEPS)))}"


def networks_in(directory: Path) -> mw.Population:
    """Return the last pursuers of all runs in a directory."""
    last = [open_run(path.parent).last("pursuer") for path in directory.glob("*/summary.json")]
    if not last:
        raise FileNotFoundError(f"{directory}: expected directories of finished runs, got none")
    return mw.Population(np.concatenate([team.genomes for team in last]), last[0].policy)


def rows_of(kinds: Iterable[Kind], quick: bool) -> dict[str, list[Row | None]]:
    """Return the rows of kinds by name; None for a size that is not played."""
    found: dict[str, list[Row | None]] = {}
    for kind in tqdm(kinds, desc="kinds", disable=None):
        rows: list[Row | None] = []
        for size in SIZES:
            # The scripts that it replaces take minutes for an episode's crowd, and say no more.
            left_out = size[0] >= MANY and kind.pursuers != BEST
            episodes = FEW_EPISODES if size[0] >= MANY else EPISODES
            left_out |= quick and size not in SIZES[:2]
            rows.append(None if left_out else play(kind, size, 2 if quick else episodes))
        found[kind.name] = rows
    return found


def main() -> None:
    """Play all rows; print and write them."""
    parser = script_parser(__doc__, quick="the smallest rows, two episodes each")
    parser.add_argument("--networks", type=Path, help="a directory of runs: their last pursuers")
    parser.add_argument("--results", type=Path, default=Path("scripted_pursuit"))
    args = parser.parse_args()
    kinds = list(KINDS)
    if args.networks is not None:
        kinds.append(Kind("SB, networks with right of way", networks_in(args.networks)))
    rows = rows_of(kinds, args.quick)
    text = table(rows)
    print(text)
    args.results.mkdir(parents=True, exist_ok=True)
    (args.results / "table.md").write_text(text + "\n", encoding="utf-8")
    (args.results / "numbers.json").write_text(json.dumps(rows) + "\n", encoding="utf-8")
    print(f"\nWritten: table.md and numbers.json in {args.results}")


if __name__ == "__main__":
    main()
