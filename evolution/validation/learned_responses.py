"""How much of a best response do learned ones find? Champions whose best response is known.

    python evolution/validation/learned_responses.py           ten seeds, half an hour
    python evolution/validation/learned_responses.py --quick   two seeds of tiny races, some seconds

Champions are the last generations of races of generalists in the world of ``small_world.toml``,
which is solved exactly. `best_responses` learns a response to each, in several numbers of matches.
Gains are exact: the score of a response minus that of the champion's last opponent in its race.
Look at the share of the true gain, that of a best response, with its interval over seeds.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

import _paths  # noqa: F401
import matrixworld as mw
from common import SMALL_STEPS, Numbers, Runs, by_seed, experiment, long_race, markdown, mean
from matrixworld._util.files import load_toml
from matrixworld.coevolution import (
    TEAMS,
    RaceSettings,
    SavedRun,
    Team,
    best_responses,
    open_run,
)
from matrixworld.coevolution.types import FloatArray, other
from matrixworld.solve import States, expected_payoff, guarantees

SMALL = load_toml(Path(__file__).parents[1] / "small_world.toml")
SHORT = {"match_episodes": 4, "schedule.generations": 20}
"""Races shorter than those of the file."""
QUICK = {
    "world.rows": 3, "world.cols": 3, "world.max_steps": 2, "learner.population": 4,
    "schedule.generations": 8, "schedule.pursuer_epochs": 2, "schedule.evader_epochs": 2,
}  # fmt: skip
CHAMPIONS = "generalist-generalist"
BUDGETS = (2_000, 5_000, 20_000, 200_000)
"""Matches of learned responses."""


def kinds(quick: bool) -> dict[str, RaceSettings]:
    """Return the settings of the races."""
    settings = RaceSettings.of(SMALL | long_race(CHAMPIONS)).changed(SHORT)
    return {CHAMPIONS: settings.changed(QUICK) if quick else settings}


@cache
def states_of(world: mw.WorldConfig) -> States:
    """Return the states of a world, which all races share."""
    return States(world)


def responses(runs: Sequence[SavedRun], budgets: Sequence[int]) -> FloatArray:
    """Return exact scores of responses to the champions of races (seeds, teams, 1 + budgets).

    First that of the champion's last opponent; then those of learned responses, by matches.
    """
    found = np.zeros((len(runs), len(TEAMS), 1 + len(budgets)))
    champions = {f"seed-{run.settings.seed}": run for run in runs}
    states, root = states_of(runs[0].settings.world), runs[0].path.parents[1] / "responses"
    for t, team in enumerate(TEAMS):
        met = [{each: run.last(each) for each in TEAMS} for run in runs]
        found[:, t, 0] = [exact(states, teams, team) for teams in met]
        steps = SMALL_STEPS[other(team)]
        learner = RaceSettings.of({"learner.population": 48, **steps}).learner
        for b, budget in enumerate(budgets, 1):
            where = root / f"responses-to-{team}s-{budget}"
            learned = best_responses(champions, team, budget, where, learner=learner, threads=1)
            for seed, each in enumerate(learned.values()):
                last = open_run(each.directory).last(other(team))
                found[seed, t, b] = exact(states, met[seed] | {other(team): last}, team)
    return found


def exact(states: States, teams: dict[Team, mw.Population], champion: Team) -> float:
    """Return the exact score of a champion's opponent."""
    captured = expected_payoff(states, teams["pursuer"], teams["evader"])
    return captured if champion == "evader" else 1 - captured


def guaranteed(run: SavedRun) -> dict[str, Any]:
    """Return what the last generations of a race guarantee (teams,)."""
    last = {team: run.last(team) for team in TEAMS}
    truth = guarantees(states_of(run.settings.world), last)
    return {"truth": np.round([truth.pursuers[0], 1 - truth.evaders[0]], 4)}


def measured(runs: Runs, quick: bool) -> dict[str, Any]:
    """Return what the champions guarantee, and exact scores of the responses to them."""
    budgets = BUDGETS[: 1 if quick else None]
    found = np.round(responses(runs[CHAMPIONS], budgets), 4)
    return by_seed(runs, guaranteed) | {"budgets": budgets, "responses": found}


def table(numbers: Numbers) -> str:
    """Return how much of the gain of a best response the learned ones find, by matches."""
    met, *learned = np.moveaxis(numbers["responses"], 2, 0)  # (seeds, teams) each
    best = 1 - numbers[f"{CHAMPIONS} / truth"] - met
    rows = []
    for budget, each in zip(numbers["budgets"], learned, strict=True):
        gains = each - met
        columns = [
            column for t in range(len(TEAMS)) for column in (gains[:, t], (gains / best)[:, t])
        ]
        rows.append([f"{budget:,}", *(mean(column, 2) for column in columns)])
    heads = [f"{team}s: {what}" for team in TEAMS for what in ("gain", "share of the true gain")]
    return markdown(["matches", *heads], rows)


if __name__ == "__main__":
    experiment(__doc__, kinds=kinds, measure=measured, table=table, seeds=10)
