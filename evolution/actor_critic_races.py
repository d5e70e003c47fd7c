"""Do races of policy gradients cycle or progress? The paper's three schedules, judged over seeds.

    python evolution/actor_critic_races.py             five seeds, some minutes on two cores
    python evolution/actor_critic_races.py --quick     a small world, some seconds
    python evolution/actor_critic_races.py --project   hours of the paper's own size, not played

Both teams learn by policy gradients (actor-critic with GAE and PPO's clip) on a board of 20 x 20
cells. The schedules differ in the opponents that a team meets: the last generation of the other
team (specialist), or all of its generations in turn (generalist).

Each schedule is judged by `analysis.judge`, as races of neuroevolution are, over all seeds
together: the whole race, its first half and its last half. Gains are changes of mean capture or
escape over that part, against all opponents of the race. ``--runs`` keeps the races; an interrupted
script continues where it stopped.
"""

from __future__ import annotations

import tempfile
from collections.abc import Mapping
from pathlib import Path
from time import process_time

import numpy as np

from common import finish_all, script_parser, written
from matrixworld import analysis
from matrixworld.coevolution import RaceSettings, SavedRun, finish
from matrixworld.coevolution.schedules import SCHEDULES

FULL = RaceSettings.of(
    {
        "learner": "actor-critic",
        "world.rows": 20,
        "world.cols": 20,
        "world.n_pursuers": 3,
        "world.n_evaders": 8,
        "policy.hidden": (32,),
        "learner.population": 4,
        "learner.actor_rate": 0.003,
        "learner.clip": 0.2,
        "learner.actor_updates": 5,
        "world.rewards": "published",
        "schedule.generations": 20,
        "schedule.pursuer_epochs": 10,
        "schedule.evader_epochs": 20,
        "train_steps": 100,
        "world.max_steps": 100,
    }
)
QUICK = FULL.changed(
    {
        "world.rows": 8,
        "world.cols": 8,
        "world.n_pursuers": 3,
        "world.n_evaders": 3,
        "world.fov": 5,
        "policy.hidden": (4,),
        "learner.population": 2,
        "schedule.generations": 8,
        "schedule.pursuer_epochs": 2,
        "schedule.evader_epochs": 2,
        "train_steps": 15,
        "world.max_steps": 20,
        "evaluation_episodes": 4,
    }
)
PUBLISHED = RaceSettings(learner="actor-critic")
"""All defaults are the paper's: networks, rates, updates, 400 epochs of each team a generation."""
SEEDS, QUICK_SEEDS = 5, 2


def play(
    base: RaceSettings, seeds: range, root: Path, threads: int | None
) -> dict[str, list[SavedRun]]:
    """Return the races of each schedule; play the missing ones."""
    planned = {
        f"{schedule}/{seed}": base.changed({"schedule": schedule, "seed": seed})
        for seed in seeds
        for schedule in SCHEDULES
    }
    runs = finish_all(planned, root, threads=threads)
    return {schedule: [runs[f"{schedule}/{seed}"] for seed in seeds] for schedule in SCHEDULES}


def measured(races: Mapping[str, list[SavedRun]]) -> dict[str, np.ndarray]:
    """Return the capture rates (seeds, n, n, episodes) of each schedule."""
    return {
        schedule: np.stack([run.payoff().capture_rates for run in runs]).astype(np.float32)
        for schedule, runs in races.items()
    }


def table(payoffs: Mapping[str, np.ndarray]) -> str:
    """Return gains and verdicts of each schedule in each window as a table in Markdown."""
    heads = ("schedule", "part", "gain of pursuers", "gain of evaders", *analysis.CONDITIONS)
    lines = [f"| {' | '.join(heads)} |", "|---" * len(heads) + "|"]
    for schedule, of_schedule in payoffs.items():
        windows = analysis.judge(of_schedule, per_episode=True).windows
        for window, judged in windows.items():
            gains = (written(each, 2, "+") for each in judged["arms race"].estimates.values())
            verdicts = (judged[condition].verdict for condition in analysis.CONDITIONS)
            lines.append(f"| {' | '.join([schedule, window, *gains, *verdicts])} |")
    return "\n".join(lines)


def seconds_of(settings: RaceSettings) -> float:
    """Return the computing time of a race on one core."""
    with tempfile.TemporaryDirectory() as place:
        before = process_time()
        finish(settings, Path(place) / "race", threads=1)
        return process_time() - before


def projected(settings: RaceSettings) -> str:
    """Return how long a race would take on one core, from few epochs of it."""
    epochs = {"schedule.pursuer_epochs": 1, "schedule.evader_epochs": 1}
    short = settings.changed({"schedule.generations": 1, **epochs})
    seconds_of(short)  # the first one imports PyTorch
    start = seconds_of(short)
    epoch = (
        seconds_of(short.changed({"schedule.pursuer_epochs": 4, "schedule.evader_epochs": 4}))
        - start
    ) / 3
    pairs = settings.schedule.entries**2 / short.schedule.entries**2
    training = settings.schedule.generations * settings.schedule.pursuer_epochs * epoch / 3600
    evaluation = pairs * max(start - epoch, 0.0) / 3600
    return (
        f"{epoch:.2f} seconds for an epoch of each team: {training:.1f} hours of training, and "
        f"{evaluation:.1f} hours of evaluation on one core"
    )


def main() -> None:
    """Play missing races; print and write the table."""
    parser = script_parser(__doc__, quick="a small world and two seeds")
    parser.add_argument("--project", action="store_true", help="hours of the paper's own size")
    parser.add_argument("--runs", type=Path, default=Path("runs/actor_critic_races"))
    parser.add_argument("--results", type=Path, default=Path("actor_critic"))
    parser.add_argument("--threads", type=int, help="default: one for each core")
    args = parser.parse_args()
    if args.project:
        print(projected(QUICK if args.quick else PUBLISHED))
        return
    base, seeds, name = (QUICK, QUICK_SEEDS, "quick") if args.quick else (FULL, SEEDS, "full")
    payoffs = measured(play(base, range(seeds), args.runs / name, args.threads))
    text = table(payoffs)
    print(text)
    args.results.mkdir(parents=True, exist_ok=True)
    (args.results / "races.md").write_text(text + "\n", encoding="utf-8")
    np.savez_compressed(args.results / "races.npz", **payoffs)
    print(f"Written: {args.results}/races.md, {args.results}/races.npz")


if __name__ == "__main__":
    main()
