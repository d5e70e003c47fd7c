"""In which races does a good learner still have something to show? Larger tasks for CMA-ES.

    python evolution/longer_races.py --threads 1   half an hour of one core
    python evolution/longer_races.py --quick       two seeds of short races, some seconds

The races of `matrixworld evolve` are flat after few generations: the learner has found nearly the
best that nine weights can do in the courtyard. Here generalists race by the same learner where
there is more to learn: with hidden layers, a larger view, more agents on a larger grid, all
thirteen inputs, and in worlds that change from epoch to epoch. Each by itself and three together.

Measured are the judgement of the whole race, and whether a team learned early and stood still
afterwards (`Judgement.leads`). Expected before the races were played: in none of the kinds do both
teams improve in more than one race of four.
"""

from __future__ import annotations

from typing import Any

import numpy as np

import matrixworld as mw
from common import Numbers, Runs, experiment, kinds_in, markdown
from matrixworld import analysis
from matrixworld.coevolution import TEAMS, RaceSettings, default_race

MORE = {"world.rows": 28, "world.cols": 28, "world.n_pursuers": 8, "world.n_evaders": 8}
CHANGING = {
    "training_worlds": ({}, {"rows": 14, "cols": 14}, {"rows": 28, "cols": 28, "n_pursuers": 6})
}
HIDDEN = {"policy.hidden": (8,)}
INPUTS = {"policy.inputs": tuple(mw.INPUTS)}
CHANGES: dict[str, dict[str, Any]] = {
    "as evolve": {},
    "8 hidden units": HIDDEN,
    "view of 21 x 21": {"world.fov": 21},
    "8 v 8 on 28 x 28": MORE,
    "thirteen inputs": INPUTS,
    "three training worlds": CHANGING,
    "8 hidden units, thirteen inputs, 8 v 8": {**HIDDEN, **INPUTS, **MORE},
}
QUICK = {"schedule.generations": 8, "learner.population": 4, "evaluation_episodes": 4}
SHOWN = ("arms race", "one-sided progress", "rise", "stagnation")


def kinds(quick: bool) -> dict[str, RaceSettings]:
    """Return the settings of the races of each kind."""
    short = {**QUICK, **{f"schedule.{team}_epochs": 1 for team in TEAMS}} if quick else {}
    chosen = list(CHANGES)[:2] if quick else CHANGES
    usual = default_race("generalist-generalist")
    return {name: RaceSettings.of(usual, CHANGES[name], short) for name in chosen}


def measured(runs: Runs, quick: bool) -> dict[str, Any]:
    """Return what is found in the races of each kind, and who learned early."""
    numbers: dict[str, Any] = {}
    for kind, each in runs.items():
        judged = [analysis.judge(run.payoff().scores, per_episode=True) for run in each]
        found = [one.present("whole") for one in judged]
        numbers[f"{kind} / found"] = np.array([[name in one for name in SHOWN] for one in found])
        early = [[lead.reached is not None for lead in one.leads.values()] for one in judged]
        leads = [[lead.size.value for lead in one.leads.values()] for one in judged]
        numbers[f"{kind} / early"] = np.array(early)
        numbers[f"{kind} / leads"] = np.array(leads)
    return numbers


def table(numbers: Numbers) -> str:
    """Return what is found in the races of each kind, in Markdown."""
    rows = []
    for kind in kinds_in(numbers):
        found = numbers[f"{kind} / found"]
        cells = [str(len(found)), *map(str, found.sum(axis=0))]
        cells += [str(early.sum()) for early in numbers[f"{kind} / early"].T]
        cells += [f"{lead.mean():.2f}" for lead in numbers[f"{kind} / leads"].T]
        rows.append([kind, *cells])
    heads = ["", "seeds", *SHOWN, *(f"{team}s learned early" for team in TEAMS)]
    return markdown([*heads, *(f"lead of {team}s" for team in TEAMS)], rows).replace("|  |", "| |")


if __name__ == "__main__":
    experiment(__doc__, kinds=kinds, measure=measured, table=table, seeds=4, first_seed=40)
