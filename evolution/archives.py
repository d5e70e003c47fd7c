"""Which opponents make the best champions? Every opponent selection at one budget of matches.

    python evolution/archives.py             five seeds of each, about six minutes
    python evolution/archives.py --quick     a small world and one seed, some seconds

Both teams learn in turns, against opponents that the selection draws from all earlier generations
or from its archive. What an archive compares counts as matches, too, so that races end with
different numbers of generations at the same budget: the smallest that any of them played. Then the
champions of all samplers meet those of all others. Runs lie in ``--runs`` and are taken up where
they were interrupted.
"""

from __future__ import annotations

import argparse
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np
from tqdm import tqdm

import matrixworld as mw
from matrixworld import analysis, coevolution
from matrixworld.coevolution import RaceSettings, SavedRun, finish
from matrixworld.coevolution.opponents import SAMPLERS

FULL = RaceSettings(
    schedule="alternating", rows=24, cols=24, pursuers=6, evaders=12, generations=15,
    opponents=2, pursuer_epochs=20, evader_epochs=30, population=24, eval_episodes=5,
)  # fmt: skip
QUICK = replace(
    FULL, rows=10, cols=10, pursuers=3, evaders=4, generations=4, pursuer_epochs=3,
    evader_epochs=4, population=8, train_steps=40, eval_steps=60, eval_episodes=2,
)  # fmt: skip

Runs = Mapping[str, list[SavedRun]]


def play(base: RaceSettings, names: list[str], seeds: range, root: Path) -> Runs:
    """A finished race of each selection and seed."""
    runs: dict[str, list[SavedRun]] = {name: [] for name in names}
    for name, seed in tqdm([(n, s) for n in names for s in seeds], unit=" races", disable=None):
        settings = replace(base, pursuers_meet=name, evaders_meet=name, seed=seed)
        runs[name].append(finish(settings, root / name / str(seed)))
    return runs


def champions(runs: Runs, team: coevolution.Team, budget: int) -> mw.Population:
    """The newest genome of each run that the budget paid for, selection by selection."""
    every = [run for of_name in runs.values() for run in of_name]
    genomes = [run.teams[team].genomes[run.generation_at(team, budget)] for run in every]
    return mw.Population(np.stack(genomes), every[0].teams[team].network)


def cross_play(base: RaceSettings, runs: Runs, budget: int, episodes: int) -> np.ndarray:
    """Capture rates (samplers, seeds, samplers, seeds): pursuers of one, evaders of other."""
    pursuers, evaders = (champions(runs, team, budget) for team in coevolution.TEAMS)
    world = base.world(base.eval_steps)
    played = coevolution.tournament(world, pursuers, evaders, seed=0, episodes=episodes)
    seeds = len(next(iter(runs.values())))
    return played.capture_rate.reshape(len(runs), seeds, len(runs), seeds)


def scores(captured: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Capture of pursuers, escape of evaders (samplers, seeds) against all other samplers."""
    others = ~np.eye(len(captured), dtype=bool)
    of_pairs = captured.mean(axis=3)  # (samplers, seeds, samplers)
    capture = np.stack([row[:, others[i]].mean(axis=1) for i, row in enumerate(of_pairs)])
    escapes = 1.0 - captured.mean(axis=1).transpose(1, 2, 0)
    escape = np.stack([row[:, others[i]].mean(axis=1) for i, row in enumerate(escapes)])
    return capture, escape


def main() -> None:
    """Play what is missing; print what each selection's champions are worth."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="a small world and one seed")
    parser.add_argument("--seeds", type=int, help="races of each selection")
    parser.add_argument("--samplers", nargs="+", choices=SAMPLERS, default=list(SAMPLERS))
    parser.add_argument("--runs", type=Path, default=Path("runs/archives"))
    args = parser.parse_args()
    base, few, episodes = (QUICK, 1, 2) if args.quick else (FULL, 5, 20)
    runs = play(base, args.samplers, range(args.seeds or few), args.runs)
    every = [run for of_name in runs.values() for run in of_name]
    budget = min(int(run.files.log()["matches"][-1]) for run in every)
    capture, escape = scores(cross_play(base, runs, budget, episodes))
    print(f"Champions after {budget:,} matches, against those of the other samplers:\n")
    print("| opponents met | generations | capture of pursuers | escape of evaders |")
    print("|---|---|---|---|")
    for name, caught, fled in zip(runs, capture, escape, strict=True):
        reached = np.mean([run.generation_at("evader", budget) for run in runs[name]])
        told = [analysis.bootstrap_runs(values) for values in (caught, fled)]
        print(f"| {name} | {reached:.1f} | {told[0]} | {told[1]} |")


if __name__ == "__main__":
    main()
