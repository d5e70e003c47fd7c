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

from collections.abc import Sequence
from typing import Any

import numpy as np

import common
import matrixworld as mw
from matrixworld.coevolution import RaceSettings

SCRIPTED = ("chaser", "hunter")
EVADERS = ("fleer", "dodger")
FULL = RaceSettings.of({
    "schedule": "against", "schedule.opponent": "fleer", "schedule.epochs": 300,
    "schedule.archive_every": 300, "learner.population": 48, **common.SMALL_STEPS["pursuer"],
    "evaluation_episodes": 50,
})  # fmt: skip
QUICK = FULL.changed({
    **common.SMALL_RACE, "schedule.epochs": 3, "schedule.archive_every": 3, "learner.population": 4,
    "train_steps": 20, "world.max_steps": 30, "evaluation_episodes": 3,
})  # fmt: skip
BASES = {False: FULL, True: QUICK}
TEAMS = {False: (8, 16, 32, 64), True: (3, 6)}
EPISODES = {False: 100, True: 3}
"""Training, sizes of the teams that hunt, and episodes of each; with ``--quick`` or not."""


def kinds(quick: bool) -> dict[str, RaceSettings]:
    """Return the base, and it with one change each."""
    base, large, fov = (QUICK, 6, 15) if quick else (FULL, 32, 21)
    changes: dict[str, dict[str, Any]] = {
        "fleers": {},
        "fleers, four times as long": {"schedule.epochs": 4 * base.schedule.epochs},
        "random evaders": {"schedule.opponent": "random"},
        "clumsy fleers": {"schedule.opponent": "clumsy-fleer"},
        f"fleers, {large} pursuers": {"world.n_pursuers": large},
        f"fleers, a view of {fov} x {fov} cells": {"world.fov": fov},
    }
    return {name: base.changed(change) for name, change in changes.items()}


def captures(
    pursuers: Any, quick: bool, fov: int | None = None, *, sizes: Sequence[int] | None = None
) -> np.ndarray:
    """Return the mean capture rates (evaders, sizes) of pursuers in the world of the base."""
    base = BASES[quick]
    world, matches = base.world, mw.Matches.of(0, 0, base.seed)

    def captured(evaders: str, size: int) -> float:
        hunted = mw.WorldConfig.of(world, n_pursuers=size, fov=fov or world.fov)
        played = mw.rollout(hunted, pursuers, evaders, matches, episodes=EPISODES[quick])
        return float(played.capture_rate.mean())

    return np.array([[captured(each, size) for size in sizes or TEAMS[quick]] for each in EVADERS])


def measured(runs: common.Runs, quick: bool) -> dict[str, Any]:
    """Return what the last pursuers of each run and scripts capture, and the sizes of the teams."""
    trained = common.by_seed(
        runs, lambda run: {"captured": captures(run.last("pursuer"), quick, run.settings.world.fov)}
    )
    scripted = {f"captured by {name}": captures(name, quick) for name in SCRIPTED}
    return {**trained, "sizes": TEAMS[quick], **scripted}


def table(numbers: common.Numbers, trained: str = "trained against ") -> str:
    """Return capture rates by pursuers, evaders and team size in Markdown."""
    rows = [
        [name, *(f"{rate:.2f}" for rate in numbers[f"captured by {name}"].ravel())]
        for name in SCRIPTED
    ]
    for kind in common.kinds_in(numbers):
        rates = numbers[f"{kind} / captured"]
        columns = rates.reshape(len(rates), -1).T
        rows.append(
            [f"{trained}{kind}", *(common.mean(each, 2, bounds=(0.0, 1.0)) for each in columns)]
        )
    heads = [f"{each}, {size} pursuers" for each in EVADERS for size in numbers["sizes"]]
    return common.markdown(["pursuers", *heads], rows)


if __name__ == "__main__":
    common.experiment(__doc__, kinds=kinds, measure=measured, table=table, seeds=3)
