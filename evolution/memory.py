"""What does it bring to remember? A corridor that only memory solves, evaders that flee, races.

    python evolution/memory.py                    hours on two cores; can be interrupted
    python evolution/memory.py --parts corridor   a quarter of an hour
    python evolution/memory.py --quick            some seconds

**Corridor.** One pursuer sees one cell around it, and a still evader is somewhere in a corridor of
13 cells. A pursuer that remembers an end where nobody was goes to the other one, and captures
always. Without memory it decides in the middle of the corridor without knowing where it comes from:
cells there look alike. The best such policy goes east with some probability. Its capture rate is
computed exactly, as the largest over that probability and those of turning at the ends. (Nobody can
hide behind obstacles here, because agents see over them; so the evader is hidden by distance.)

**Fleers.** Pursuers train against evaders that flee, with and without memory and with equal numbers
of matches; all else is as in `catching_fleers.py`. Scripts stand beside them.

**Board.** The same on 6 x 6 cells, all of which agents see. This world is solved: what the best
pursuers capture tells "cannot be caught" from "was not learned".

**Races.** The three default races, with and without memory and with equal numbers of matches, by
the scores of both last generations against held-out opponents. Differences are those of the same
seeds.

``evolution/results/memory`` keeps what was found.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy import optimize

import catching_fleers
from catching_fleers import EVADERS, SCRIPTED
from common import finish_all, script_parser, written
from course import chapter_10
from course.chapter_10 import CELLS, STEPS
from matrixworld.analysis import interval_over_runs
from matrixworld.coevolution import TEAMS, RaceSettings, SavedRun, score
from matrixworld.solve import States, best_response, expected_payoff
from matrixworld.world.policy import GATES
from race_budgets import SCHEDULES

SEEDS, RACE_SEEDS = 5, 3
CORRIDOR = chapter_10.CORRIDOR.changed({"evaluation_episodes": 10_000})
QUICK = {
    "schedule.epochs": 2, "schedule.archive_every": 2, "learner.population": 4,
    "evaluation_episodes": 50,
}  # fmt: skip
BOARD = RaceSettings.of({
    "world.rows": 6, "world.cols": 6, "world.n_pursuers": 2, "world.n_evaders": 1,
    "world.max_steps": 20, "train_steps": 20, "match_episodes": 16,
    "schedule": "against", "schedule.epochs": 300, "schedule.archive_every": 300,
    "learner.population": 48, "learner.sigma": 0.2, "learner.learning_rate": 0.1,
    "evaluation_episodes": 10_000,
})  # fmt: skip
QUICK_RACES = {
    "world.rows": 10, "world.cols": 10, "world.n_pursuers": 3, "world.n_evaders": 4,
    "world.max_steps": 30, "train_steps": 20, "learner.population": 4, "schedule.generations": 2,
    "evaluation_episodes": 2,
}  # fmt: skip
FLEERS = catching_fleers.Plan(
    catching_fleers.FULL.base,
    {"no memory": {}, **{each: {"policy.memory": each} for each in ("elman", "gru")}},
    teams=(8, 16, 32),
    seeds=SEEDS,
    episodes=100,
)
QUICK_FLEERS = catching_fleers.Plan(
    catching_fleers.QUICK.base, FLEERS.changes, teams=(3, 6), seeds=1, episodes=2
)


# ---- The corridor, exactly -----------------------------------------------------------------------


def capture_rate(policy: NDArray[np.float64], cells: int = CELLS, steps: int = STEPS) -> float:
    """Return the capture rate of a pursuer that remembers nothing.

    `policy` has the probabilities of going east in the middle of the corridor, and of turning at
    its west and its east end. To stay would only lose time; an evader in view is captured at once.
    """
    east, turn_west, turn_east = policy
    moves = np.zeros((cells, cells))  # from a cell to a cell
    for cell in range(cells):
        chance = {0: turn_west, cells - 1: 1 - turn_east}.get(cell, east)
        moves[cell, min(cell + 1, cells - 1)] += chance
        moves[cell, max(cell - 1, 0)] += 1 - chance
    each = np.arange(cells)
    by_evader = np.repeat(moves[None], cells, axis=0)
    near = np.abs(each[:, None] - each) <= 1
    by_evader[near] = np.eye(cells)[np.nonzero(near)[0]]
    start = (1 - np.eye(cells)) / (cells - 1)
    found = start[:, None]
    for _ in range(steps):
        found = found @ by_evader
    return float(found[each, 0, each].mean())


def without_memory(cells: int = CELLS, steps: int = STEPS) -> float:
    """Return the largest capture rate without memory; of several local searches the best."""
    starts = np.stack(np.meshgrid(*3 * [[0.25, 0.5, 0.75]]), axis=-1).reshape(-1, 3)
    return max(
        -optimize.minimize(
            lambda policy: -capture_rate(policy, cells, steps), start, bounds=3 * [(0, 1)]
        ).fun
        for start in starts
    )


# ---- Runs ----------------------------------------------------------------------------------------


def trained(
    bases: Mapping[str, RaceSettings], root: Path, seeds: int
) -> dict[str, dict[str, list[SavedRun]]]:
    """Train what is missing, with each memory and seed; return the runs by base and memory."""
    settings = {
        f"{name}-{memory}/{seed}": base.changed({"policy.memory": memory, "seed": seed})
        for seed in range(seeds)
        for name, base in bases.items()
        for memory in GATES
    }
    runs = finish_all(settings, root)

    def of(start: str) -> list[SavedRun]:
        return [run for name, run in runs.items() if name.startswith(start)]

    return {name: {each: of(f"{name}-{each}/") for each in GATES} for name in bases}


def captured(run: SavedRun) -> float:
    """Return the capture rate of the last pursuers, in episodes that no training has played."""
    return float(run.summary()["capture_rate"])


def corridor(root: Path, *, quick: bool) -> list[str]:
    """Train what is missing in the corridor; return a table of capture rates."""
    base, seeds = (CORRIDOR.changed(QUICK), 1) if quick else (CORRIDOR, SEEDS)
    lines = ["| corridor | capture rate | of each seed |", "|---|---|---|"]
    for memory, runs in trained({"corridor": base}, root, seeds)["corridor"].items():
        rates = [captured(run) for run in runs]
        each = ", ".join(f"{rate:.3f}" for rate in rates)
        lines.append(f"| memory: {memory} | {catching_fleers.shown(rates)} | {each} |")
    return [*lines, f"| the best without memory, exactly | {without_memory():.3f} | |"]


def board(root: Path, *, quick: bool) -> list[str]:
    """Train what is missing on the board; return a table of capture rates by evader."""
    base = BOARD.changed(QUICK) if quick else BOARD
    bases = {each: base.changed({"schedule.opponent": each}) for each in EVADERS}
    states = States(base.world)
    table = {
        each: [f"{expected_payoff(states, each, evaders):.3f}" for evaders in EVADERS]
        for each in SCRIPTED
    }
    runs = trained(bases, root, 1 if quick else SEEDS)
    for memory in GATES:
        rates = ([captured(run) for run in runs[evaders][memory]] for evaders in EVADERS)
        table[f"trained, memory: {memory}"] = [catching_fleers.shown(each) for each in rates]
    table["the best, exactly"] = [
        f"{best_response(states, evaders, 'evader').value:.3f}" for evaders in EVADERS
    ]
    rows = (f"| {name} | {' | '.join(cells)} |" for name, cells in table.items())
    return [f"| pursuers | {' | '.join(EVADERS)} |", "|---" * (len(EVADERS) + 1) + "|", *rows]


def fleers(root: Path, *, quick: bool) -> list[str]:
    """Train what is missing against fleers; return a table of capture rates by team size."""
    plan = QUICK_FLEERS if quick else FLEERS
    fov = plan.base.world.fov
    heads = [f"{each}, {size} pursuers" for each in catching_fleers.EVADERS for size in plan.teams]
    lines = [f"| pursuers | {' | '.join(heads)} |", "|---" * (len(heads) + 1) + "|"]
    teams = {each: [each] for each in catching_fleers.SCRIPTED}
    for name, trained in catching_fleers.trained(plan, root, None).items():
        teams[f"trained, {name}"] = list(trained)
    return [*lines, *(catching_fleers.row(plan, name, each, fov) for name, each in teams.items())]


def races(root: Path, *, quick: bool) -> list[str]:
    """Play the missing races; return a table of held-out scores by schedule and memory."""
    changes = QUICK_RACES if quick else {}
    bases = {each: RaceSettings.of({"schedule": each, **changes}) for each in SCHEDULES}
    heads = ["memory", *(f"{team}s" for team in TEAMS), *(f"difference, {team}s" for team in TEAMS)]
    lines = [f"| schedule | {' | '.join(heads)} |", "|---" * (len(heads) + 1) + "|"]
    for schedule, by_memory in trained(bases, root, 1 if quick else RACE_SEEDS).items():
        scores = {
            memory: np.array([[score(run)[team].means[-1] for run in runs] for team in TEAMS])
            for memory, runs in by_memory.items()
        }
        for memory, each in scores.items():
            cells = [written(interval_over_runs(team, bounds=(0.0, 1.0)), 2) for team in each]
            for change in each - scores["none"]:
                differs = memory != "none"
                cells.append(written(interval_over_runs(change), 2, "+") if differs else "")
            lines.append(f"| {schedule} | {memory} | {' | '.join(cells)} |")
    return lines


PARTS = {"corridor": corridor, "fleers": fleers, "board": board, "races": races}


def main() -> None:
    """Train what is missing; print the tables."""
    parser = script_parser(__doc__, quick="few epochs and one seed")
    parser.add_argument("--runs", type=Path, default=Path("runs/memory"))
    parser.add_argument("--parts", nargs="+", choices=PARTS, default=list(PARTS))
    args = parser.parse_args()
    for part in args.parts:
        root = args.runs / ("quick" if args.quick else "full") / part
        print(*PARTS[part](root, quick=args.quick), "", sep="\n")


if __name__ == "__main__":
    main()
