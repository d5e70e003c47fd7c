"""Which inputs do ratings need? Each one left out in turn, and everything learned anew.

    python evolution/rating_inputs.py             ten seeds of each, half an hour of one core
    python evolution/rating_inputs.py --quick     small worlds and two seeds, some seconds

Short hall-of-fame races of ratings without hidden layers, in three small worlds and in three of
40 x 40: with all inputs, and without one of them, in both teams. The *loss* of an input is the
held-out score of the last generation with all inputs minus that without it, in races of the same
seed. The episodes are the same for all. Inputs stand in for each other, and that each of two costs
nothing does not mean that both do; so in one kind only three inputs are left, and in some several
are left out together.

The kept results have two inputs more: `crowd`, the sum over teammates of 1 / (1 + moves)^2, and
`stay`, 1 if it is no move. They cost nothing in the small worlds, so they are gone.

Stated before the runs, of the mean loss over worlds and teams, one number of each seed, with its
95 % interval over the seeds:

- an input *counts* if the interval lies above 0;
- it *costs nothing* if the interval ends below 0.02;
- otherwise one *cannot tell*.

Intervals are not adjusted for their number.
"""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np

import matrixworld as mw
from common import Numbers, Runs, by_seed, experiment, kept, kinds_in, markdown, mean, play
from matrixworld.analysis import interval_over_runs
from matrixworld.coevolution import TEAMS, RaceSettings, SavedRun, score
from matrixworld.coevolution.types import FloatArray

Worlds = dict[str, dict[str, Any]]
SMALL: Worlds = {
    "SB 8 x 8": {"rules": "SB", "rows": 8, "cols": 8, "n_pursuers": 6, "n_evaders": 1},
    "O 20 x 20": {
        "rules": "O", "rows": 20, "cols": 20, "n_pursuers": 4, "n_evaders": 4, "obstacles": 0.1,
    },
    "D 16 x 16": {"rules": "D", "rows": 16, "cols": 16, "n_pursuers": 6, "n_evaders": 6},
}  # fmt: skip
LARGE: Worlds = {
    f"{rules} 40 x 40": {"rules": rules, "max_steps": 200} for rules in ("O", "S", "SB")
}
RACE: dict[str, Any] = {
    "schedule": "hall-of-fame", "schedule.generations": 6, "schedule.joint_epochs": 12,
    "policy": "rating", "learner": "cma", "learner.population": 12, "world.max_steps": 100,
    "train_steps": 100, "evaluation_episodes": 2,
}  # fmt: skip
QUICK = {"schedule.generations": 2, "schedule.joint_epochs": 2}
ALL, FEW = "all inputs", ("adversary", "teammate", "room")
LEFT_OUT = {f"without {name}": name for name in mw.Rating.inputs}
ONLY = f"only {' '.join(FEW)}"
EPISODES, NOTHING = 50, 0.02
"""Episodes against each held-out opponent; the loss below which an input costs nothing."""


def kinds(quick: bool) -> dict[str, RaceSettings]:
    """Return the settings of races with all inputs, and without some, in each world."""
    chosen = {ALL: mw.Rating.inputs, ONLY: FEW}
    for kind, left_out in LEFT_OUT.items():
        chosen[kind] = tuple(name for name in mw.Rating.inputs if name != left_out)
    found = {}
    for place, world in (SMALL | LARGE).items():
        settings = {f"world.{name}": value for name, value in world.items()}
        if place in LARGE:
            settings["train_steps"] = world["max_steps"]
        for kind, inputs in chosen.items():
            changes = RACE | settings | {"policy.inputs": inputs} | (QUICK if quick else {})
            found[f"{place}: {kind}"] = RaceSettings.of(changes)
    return found


def scores_of(run: SavedRun, episodes: int) -> dict[str, float]:
    """Return the held-out scores of both last generations."""
    scores = score(run, episodes=episodes, threads=1)
    return {team: float(scores[team].means[-1]) for team in TEAMS}


def measured(runs: Runs, quick: bool) -> dict[str, Any]:
    """Return the scores of all runs; files beside them keep the numbers."""
    scores = partial(scores_of, episodes=2 if quick else EPISODES)
    return by_seed(
        runs, lambda run: kept(run.path.with_suffix(".scores.json"), partial(scores, run))
    )


def losses(numbers: Numbers, worlds: Worlds, kind: str) -> FloatArray:
    """Return what a kind loses against all inputs in some worlds: (worlds, teams, seeds)."""
    return np.array(
        [
            [numbers[f"{p}: {ALL} / {t}"] - numbers[f"{p}: {kind} / {t}"] for t in TEAMS]
            for p in worlds
        ]
    )


def verdict(values: FloatArray) -> str:
    """Return what the mean losses (seeds,) say of an input."""
    found = interval_over_runs(values)
    if found.low is None or found.high is None:
        return "cannot tell"
    if found.low > 0:
        return "counts"
    return "costs nothing" if found.high < NOTHING else "cannot tell"


def table(numbers: Numbers) -> str:
    """Return the losses of all inputs in Markdown."""
    return "\n\n".join(table_of(numbers, worlds) for worlds in (SMALL, LARGE))


def table_of(numbers: Numbers, worlds: Worlds) -> str:
    """Return the losses of the inputs that have been left out in all of these worlds."""
    scores = {f"{p}, {t}s": numbers[f"{p}: {ALL} / {t}"] for p in worlds for t in TEAMS}
    heads = ["", "mean loss", "", *scores]
    rows = [[ALL, "", "", *(mean(each, bounds=(0.0, 1.0)) for each in scores.values())]]
    first, *_ = worlds
    for name in kinds_in(numbers):
        place, kind = name.split(": ")
        if place != first or kind == ALL:
            continue
        loss = losses(numbers, worlds, kind)
        together = loss.mean(axis=(0, 1))
        each = [f"{value:+.3f}" for value in loss.mean(axis=2).ravel()]
        rows.append([kind, mean(together, sign="+"), verdict(together), *each])
    seeds = len(next(iter(scores.values())))
    told = (
        f"Held-out scores with all inputs, and losses without some: means of {seeds} seeds [95 %]."
    )
    return f"{told}\n\n{markdown(heads, rows)}".replace("|  |", "| |")


if __name__ == "__main__":
    experiment(__doc__, kinds=kinds, measure=measured, table=table, seeds=10, play=play)
