"""Which opponent sampler gives the best champions? All samplers at the same number of matches.

    python evolution/archives.py             five seeds of each sampler, about six minutes
    python evolution/archives.py --quick     a small world and one seed, some seconds

Both teams learn in turns. Their opponents are sampled from all earlier generations or from an
archive. Matches that an archive plays to compare candidates count towards the budget, so at the
same budget races have reached different generations. The budget is the smallest number of matches
that a race played. The champions of each sampler then play the champions of all other samplers.
Runs are kept in ``--runs``; an interrupted script continues where it stopped.

Method: the samplers of ``matrixworld.coevolution.opponents``, with their sources; comparison at an
equal budget after de Jong (2007), "A monotonic archive for Pareto-coevolution".

Look at the capture and escape rates with their intervals over seeds, and at the generations that
each sampler reached with the budget.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np

import matrixworld as mw
from common import SAME_STEPS, finish_all, script_parser
from matrixworld import analysis, coevolution
from matrixworld.coevolution import RaceSettings, SavedRun
from matrixworld.coevolution.schedules import SAMPLERS

FULL = RaceSettings.of(
    {
        "schedule": "alternating",
        "world.rows": 24,
        "world.cols": 24,
        "world.n_pursuers": 6,
        "world.n_evaders": 12,
        "schedule.generations": 15,
        "schedule.opponents": 2,
        "schedule.pursuer_epochs": 20,
        "schedule.evader_epochs": 30,
        **SAME_STEPS,
        "learner.population": 24,
        "evaluation_episodes": 5,
    }
)
QUICK = FULL.changed(
    {
        "world.rows": 10,
        "world.cols": 10,
        "world.n_pursuers": 3,
        "world.n_evaders": 4,
        "schedule.generations": 4,
        "schedule.pursuer_epochs": 3,
        "schedule.evader_epochs": 4,
        "learner.population": 8,
        "train_steps": 40,
        "world.max_steps": 60,
        "evaluation_episodes": 2,
    }
)

Runs = Mapping[str, list[SavedRun]]


def play(
    base: RaceSettings, names: list[str], seeds: range, root: Path, where: str | None = None
) -> Runs:
    """Return a finished race of each sampler and seed."""
    settings = {
        f"{name}/{seed}": base.changed(
            {"schedule.pursuers_meet": name, "schedule.evaders_meet": name, "seed": seed}
        )
        for name in names
        for seed in seeds
    }
    runs = finish_all(settings, root, where=where)
    return {name: [runs[f"{name}/{seed}"] for seed in seeds] for name in names}


def champions(runs: Runs, team: coevolution.Team, budget: int) -> mw.Population:
    """Return the newest genome of each run within the budget, sampler by sampler."""
    every = [run for of_name in runs.values() for run in of_name]
    # Not the last genome: races whose archives play matches end above the budget.
    genomes = [run.teams[team].genomes[run.generation_at(team, budget)] for run in every]
    return mw.Population(np.stack(genomes), every[0].teams[team].network)


def cross_play(base: RaceSettings, runs: Runs, budget: int, episodes: int) -> np.ndarray:
    """Return capture rates (samplers, seeds, samplers, seeds): pursuers first, then evaders."""
    pursuers, evaders = (champions(runs, team, budget) for team in coevolution.TEAMS)
    # Longer episodes than in training, as in payoff matrices.
    world = base.world
    played = coevolution.tournament(world, pursuers, evaders, seed=0, episodes=episodes)
    seeds = len(next(iter(runs.values())))
    return played.capture_rate.reshape(len(runs), seeds, len(runs), seeds)


def scores(captured: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return capture and escape rates (samplers, seeds) against all other samplers."""
    # Opponents of the same sampler are left out: a sampler could make both of its teams weak.
    others = ~np.eye(len(captured), dtype=bool)
    # Seeds of the opponents are averaged; seeds of the own sampler give the intervals.
    of_pairs = captured.mean(axis=3)  # (samplers, seeds, samplers)
    capture = np.stack([row[:, others[i]].mean(axis=1) for i, row in enumerate(of_pairs)])
    escapes = 1.0 - captured.mean(axis=1).transpose(1, 2, 0)
    escape = np.stack([row[:, others[i]].mean(axis=1) for i, row in enumerate(escapes)])
    return capture, escape


def main() -> None:
    """Play missing runs, and print the rates of each sampler's champions."""
    parser = script_parser(__doc__, quick="a small world and one seed", cluster=True)
    parser.add_argument("--seeds", type=int, help="races of each sampler")
    parser.add_argument("--samplers", nargs="+", choices=SAMPLERS, default=list(SAMPLERS))
    parser.add_argument("--runs", type=Path, default=Path("runs/archives"))
    args = parser.parse_args()
    base, few, episodes = (QUICK, 1, 2) if args.quick else (FULL, 5, 20)
    runs = play(base, args.samplers, range(args.seeds or few), args.runs, args.cluster)
    every = [run for of_name in runs.values() for run in of_name]
    # The smallest total is a number of matches that every race has played.
    budget = min(int(run.log()["matches"][-1]) for run in every)
    capture, escape = scores(cross_play(base, runs, budget, episodes))
    print(f"Champions after {budget:,} matches, against those of the other samplers:\n")
    print("| sampler | generations | capture rate of pursuers | escape rate of evaders |")
    print("|---|---|---|---|")
    for name, captured, escaped in zip(runs, capture, escape, strict=True):
        reached = np.mean([run.generation_at("evader", budget) for run in runs[name]])
        means = [
            analysis.interval_over_runs(values, bounds=(0.0, 1.0)) for values in (captured, escaped)
        ]
        print(f"| {name} | {reached:.1f} | {means[0]} | {means[1]} |")


if __name__ == "__main__":
    main()
