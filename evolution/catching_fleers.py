"""What does it take to catch evaders that flee? Longer training, more pursuers, wider views.

    python evolution/catching_fleers.py             half an hour on two cores; can be interrupted
    python evolution/catching_fleers.py --quick     a small world, some seconds

The scripts ``fleer`` and ``dodger`` run from the pursuers that they see. The pursuers of a default
race capture few of them. Here pursuers train against fleers alone, with one change at a time, and
then hunt fleers and dodgers in teams of 8 to 64. Scripted pursuers stand beside the trained ones.

Look at a row from left to right for the effect of team size, and at a column from top to bottom for
the effect of training. The interval is Student's t over training seeds. Scripts do not learn, and
have none.

``evolution/results/catching_fleers`` keeps the table. These networks decide by what an agent sees
in this step; `memory.py` trains others.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import matrixworld as mw
from common import SMALL_STEPS, finish_all, script_parser
from matrixworld.analysis import interval_over_runs
from matrixworld.coevolution import RaceSettings

SCRIPTED = ("chaser", "hunter")
EVADERS = ("fleer", "dodger")


@dataclass(frozen=True)
class Plan:
    """Training, tests and their sizes.

    Parameters
    ----------
    base : RaceSettings
        Training that the others change.
    changes : mapping of str to mapping
        Changed settings by the name of the training.
    teams : tuple of int
        Team sizes of the test.
    seeds : int
        Number of training seeds, from 0.
    episodes : int
        Episodes of each test.
    """

    base: RaceSettings
    changes: dict[str, dict[str, object]]
    teams: tuple[int, ...]
    seeds: int
    episodes: int


def plan(base: RaceSettings, *, large: int, fov: int, **sizes: object) -> Plan:
    """Return a plan: the base, and it with one change each."""
    changes: dict[str, dict[str, object]] = {
        "fleers": {},
        "fleers, four times as long": {"schedule.epochs": 4 * base.schedule.epochs},
        "random evaders": {"schedule.opponent": "random"},
        "clumsy fleers": {"schedule.opponent": "clumsy-fleer"},
        f"fleers, {large} pursuers": {"world.n_pursuers": large},
        f"fleers, a view of {fov} x {fov} cells": {"world.fov": fov},
    }
    return Plan(base, changes, **sizes)  # type: ignore[arg-type]


FULL = plan(
    RaceSettings.of(
        {
            "schedule": "against",
            "schedule.opponent": "fleer",
            "learner.population": 48,
            "schedule.epochs": 300,
            **SMALL_STEPS["pursuer"],
            "schedule.archive_every": 300,
            "evaluation_episodes": 50,
        }
    ),
    large=32,
    fov=21,
    teams=(8, 16, 32, 64),
    seeds=3,
    episodes=100,
)
QUICK = plan(
    RaceSettings.of(
        {
            "schedule": "against",
            "schedule.opponent": "fleer",
            "world.rows": 10,
            "world.cols": 10,
            "world.n_pursuers": 3,
            "world.n_evaders": 4,
            "learner.population": 4,
            "schedule.epochs": 3,
            "schedule.archive_every": 3,
            "train_steps": 20,
            "world.max_steps": 30,
            "evaluation_episodes": 3,
        }
    ),
    large=6,
    fov=15,
    teams=(3, 6),
    seeds=2,
    episodes=3,
)


def trained(plan: Plan, root: Path, where: str | None) -> dict[str, list[mw.Population]]:
    """Return the last pursuers of each training and seed; play the runs that are missing."""
    settings = {
        f"{name.replace(',', '').replace(' ', '-')}/{seed}": plan.base.changed(
            {"seed": seed, **change}
        )
        for seed in range(plan.seeds)
        for name, change in plan.changes.items()
    }
    runs = finish_all(settings, root, where=where)
    found: dict[str, list[mw.Population]] = {name: [] for name in plan.changes}
    # In the order of the settings: seed by seed, each training in turn.
    for run, name in zip(runs.values(), plan.seeds * list(plan.changes), strict=True):
        team = run.teams["pursuer"]
        found[name].append(mw.Population(team.genomes[-1:], team.network))
    return found


def captured(plan: Plan, pursuers: mw.Population | str, evaders: str, size: int, fov: int) -> float:
    """Return the mean capture rate of a team of this size, in episodes of the base's world."""
    world = plan.base.world
    return float(
        mw.rollout(
            mw.WorldConfig.of(world, n_pursuers=size, fov=fov),
            pursuers,
            evaders,
            mw.Matches.of(0, 0, plan.base.seed),
            episodes=plan.episodes,
        ).capture_rate.mean()
    )


def row(plan: Plan, name: str, teams: list[mw.Population | str], fov: int) -> str:
    """Return a line of the table: capture rates by evader and team size."""
    cells = []
    for evaders in EVADERS:
        for size in plan.teams:
            rates = [captured(plan, team, evaders, size, fov) for team in teams]
            cells.append(shown(rates))
    return f"| {name} | {' | '.join(cells)} |"


def shown(rates: list[float]) -> str:
    """Return a mean, with its interval over seeds if there are several."""
    found = interval_over_runs(rates, bounds=(0.0, 1.0))
    if found.low is None:
        return f"{found.value:.2f}"
    return f"{found.value:.2f} [{found.low:.2f}, {found.high:.2f}]"


def main() -> None:
    """Train what is missing; print the table."""
    parser = script_parser(__doc__, quick="a small world and few epochs", cluster=True)
    parser.add_argument("--runs", type=Path, default=Path("runs/catching_fleers"))
    args = parser.parse_args()
    chosen = QUICK if args.quick else FULL
    root = args.runs / ("quick" if args.quick else "full")
    heads = [f"{evaders}, {size} pursuers" for evaders in EVADERS for size in chosen.teams]
    lines = [f"| pursuers | {' | '.join(heads)} |", "|---" * (len(heads) + 1) + "|"]
    lines += [row(chosen, script, [script], chosen.base.world.fov) for script in SCRIPTED]
    for name, teams in trained(chosen, root, args.cluster).items():
        fov = chosen.base.changed(chosen.changes[name]).world.fov
        lines.append(row(chosen, f"trained against {name}", list(teams), fov))
    print(*lines, sep="\n")


if __name__ == "__main__":
    main()
