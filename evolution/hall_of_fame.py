"""Does a hall of fame prevent forgetting? Races with and without one, at equal matches.

    python evolution/hall_of_fame.py             five seeds of each kind, about two minutes
    python evolution/hall_of_fame.py --quick     a small world and two seeds, some seconds

Two populations evolve simultaneously. Without a hall of fame, individuals meet current opponents
only. With a hall of fame they also meet earlier champions. Both kinds of race play the same number
of matches. Runs are kept in ``--runs``; an interrupted script continues where it stopped.

Method: Rosin and Belew (1997), "New methods for competitive coevolution".

Look at forgetting and at historical progress: a hall of fame helps if their intervals over seeds
do not overlap.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
from tqdm import tqdm

from common import script_parser
from matrixworld import analysis, plots
from matrixworld.coevolution import RaceSettings, finish

HALL, CURRENT = 2, 2  # opponents of each individual in an epoch: earlier champions, current ones
FULL = RaceSettings(
    schedule="hall-of-fame", rows=24, cols=24, pursuers=6, evaders=10, generations=30,
    joint_epochs=8, population=32,
)  # fmt: skip
QUICK = replace(
    FULL, rows=10, cols=10, pursuers=3, evaders=4, generations=8, joint_epochs=3, population=8,
    train_steps=40, eval_steps=60,
)  # fmt: skip
MEASURES = (
    "pursuer_forgetting",
    "evader_forgetting",
    "pursuer_historical_gain",
    "evader_historical_gain",
    "checkerboards",
    "transitive_share",
)


def kinds(base: RaceSettings) -> dict[str, RaceSettings]:
    """Return the settings of both kinds of race, with the same number of matches."""
    # A match between current opponents counts for both teams, a match against the hall for one.
    return {
        "latest only": replace(base, contemporaries=CURRENT + 2 * HALL, hall_sample=0),
        "hall of fame": replace(base, contemporaries=CURRENT, hall_sample=HALL),
    }


def payoffs(base: RaceSettings, seeds: range, root: Path) -> dict[str, np.ndarray]:
    """Return payoff matrices (seeds, generations, generations) of each kind, playing new runs."""
    found: dict[str, list[np.ndarray]] = {name: [] for name in kinds(base)}
    jobs = [(name, each, seed) for name, each in kinds(base).items() for seed in seeds]
    # Each race has its own directory, where an interrupted script finds it again.
    for name, settings, seed in tqdm(jobs, unit=" races", disable=None):
        place = root / name.replace(" ", "-") / str(seed)
        run = finish(replace(settings, seed=seed), place)
        found[name].append(run.payoff().capture_rate)
    return {name: np.stack(matrices) for name, matrices in found.items()}


def main() -> None:
    """Play missing runs, print the measures of both kinds, and draw one race of each."""
    parser = script_parser(__doc__, quick="a small world and two seeds")
    parser.add_argument("--seeds", type=int, help="races of each kind")
    parser.add_argument("--runs", type=Path, default=Path("runs/hall_of_fame"))
    parser.add_argument("--figure", default="hall_of_fame.png", help="file to draw to")
    args = parser.parse_args()
    base, few = (QUICK, 2) if args.quick else (FULL, 5)
    found = payoffs(base, range(args.seeds or few), args.runs)
    estimates = {name: analysis.analyze(matrices).estimates for name, matrices in found.items()}
    print(f"| mean over seeds | {' | '.join(found)} |\n|---|{'---|' * len(found)}")
    for measure in MEASURES:
        cells = " | ".join(str(each[measure]) for each in estimates.values())
        print(f"| {analysis.MEASURES[measure].label} | {cells} |")
    # One race of each kind: a mean over seeds would hide cycles of different phase.
    plots.comparison({name: matrices[0] for name, matrices in found.items()}).savefig(args.figure)
    print(f"Drawn: {args.figure}, the first seed of each")


if __name__ == "__main__":
    main()
