"""Does a hall of fame stop forgetting? Two populations evolve at once, with a hall and without.

    python evolution/hall_of_fame.py             five seeds of each, about two minutes
    python evolution/hall_of_fame.py --quick     a small world and two seeds, some seconds

Rosin & Belew 1997, "New methods for competitive coevolution". Without a hall individuals meet the
latest opponents only: those that are alive. With one they meet some of the earlier champions, too.
Both kinds of race play the same number of matches. Runs lie in ``--runs`` and are taken up where
they were interrupted.
"""

from __future__ import annotations

import argparse
from dataclasses import replace
from pathlib import Path

import numpy as np
from tqdm import tqdm

from matrixworld import analysis, plots
from matrixworld.coevolution import RaceSettings, finish

HALL, ALIVE = 2, 2
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
    """The two kinds of race: of an epoch's matches a hall takes its sample twice, once a team."""
    return {
        "latest only": replace(base, contemporaries=ALIVE + 2 * HALL, hall_sample=0),
        "hall of fame": replace(base, contemporaries=ALIVE, hall_sample=HALL),
    }


def payoffs(base: RaceSettings, seeds: range, root: Path) -> dict[str, np.ndarray]:
    """Payoff matrices (seeds, generations, generations) of each kind."""
    found: dict[str, list[np.ndarray]] = {name: [] for name in kinds(base)}
    jobs = [(name, each, seed) for name, each in kinds(base).items() for seed in seeds]
    for name, settings, seed in tqdm(jobs, unit=" races", disable=None):
        place = root / name.replace(" ", "-") / str(seed)
        run = finish(replace(settings, seed=seed), place)
        found[name].append(run.payoff().capture_rate)
    return {name: np.stack(matrices) for name, matrices in found.items()}


def main() -> None:
    """Play what is missing; print what tells the kinds apart, and draw one race of each."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="a small world and two seeds")
    parser.add_argument("--seeds", type=int, help="races of each kind")
    parser.add_argument("--runs", type=Path, default=Path("runs/hall_of_fame"))
    parser.add_argument("--figure", default="hall_of_fame.png", help="file to draw to")
    args = parser.parse_args()
    base, few = (QUICK, 2) if args.quick else (FULL, 5)
    found = payoffs(base, range(args.seeds or few), args.runs)
    estimates = {name: analysis.analyze(matrices).estimates for name, matrices in found.items()}
    print(f"| mean over seeds | {' | '.join(found)} |\n|---|{'---|' * len(found)}")
    for measure in MEASURES:
        told = " | ".join(str(each[measure]) for each in estimates.values())
        print(f"| {analysis.MEASURES[measure].label} | {told} |")
    plots.comparison({name: matrices[0] for name, matrices in found.items()}).savefig(args.figure)
    print(f"Drawn: {args.figure}, the first seed of each")


if __name__ == "__main__":
    main()
