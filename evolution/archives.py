"""Which opponent sampler gives the best champions? All samplers at the same number of matches.

    python evolution/archives.py             five seeds of each sampler, about six minutes
    python evolution/archives.py --quick     a small world and two seeds, some seconds

Both teams learn in turns. Their opponents are sampled from all earlier generations or from an
archive. Matches that an archive plays to compare candidates count towards the budget, so at the
same budget races have reached different generations. The budget is the smallest number of matches
that a race played. The champions of each sampler then play the champions of all other samplers.

Method: the samplers of ``matrixworld.coevolution.opponents``, with their sources; comparison at an
equal budget after de Jong (2007), "A monotonic archive for Pareto-coevolution".

Look at the capture and escape rates with their intervals over seeds, and at the generations that
each sampler reached with the budget.
"""

from __future__ import annotations

from typing import Any

import numpy as np

import matrixworld as mw
from common import SAME_STEPS, SMALL_RACE, Numbers, Runs, experiment, kinds_in, markdown
from matrixworld import analysis, coevolution
from matrixworld.coevolution import RaceSettings
from matrixworld.coevolution.schedules import SAMPLERS

FULL = RaceSettings.of({
    "schedule": "alternating", "schedule.generations": 15, "schedule.opponents": 2,
    "schedule.pursuer_epochs": 20, "schedule.evader_epochs": 30,
    "world.rows": 24, "world.cols": 24, "world.n_pursuers": 6, "world.n_evaders": 12,
    **SAME_STEPS, "learner.population": 24, "evaluation_episodes": 5,
})  # fmt: skip
QUICK = {
    **SMALL_RACE, "schedule.generations": 4, "schedule.pursuer_epochs": 3,
    "schedule.evader_epochs": 4, "evaluation_episodes": 2,
}  # fmt: skip


def kinds(quick: bool) -> dict[str, RaceSettings]:
    """Return the settings of races whose teams meet what each sampler chooses."""
    base = FULL.changed(QUICK if quick else {})
    return {
        name: base.changed({"schedule.pursuers_meet": name, "schedule.evaders_meet": name})
        for name in SAMPLERS
    }


def champions(runs: Runs, team: coevolution.Team, budget: int) -> mw.Population:
    """Return the newest genome of each run within the budget, sampler by sampler."""
    every = [run for of_name in runs.values() for run in of_name]
    # Not the last genome: races whose archives play matches end above the budget.
    genomes = [run.teams[team].genomes[run.generation_at(team, budget)] for run in every]
    return mw.Population(np.stack(genomes), every[0].teams[team].network)


def cross_play(runs: Runs, budget: int, episodes: int) -> np.ndarray:
    """Return capture rates (samplers, seeds, samplers, seeds): pursuers first, then evaders."""
    pursuers, evaders = (champions(runs, team, budget) for team in coevolution.TEAMS)
    first = next(iter(runs.values()))
    # Longer episodes than in training, as in payoff matrices.
    world = first[0].settings.world
    played = coevolution.tournament(world, pursuers, evaders, seed=0, episodes=episodes)
    return played.capture_rate.reshape(len(runs), len(first), len(runs), len(first))


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


def measured(runs: Runs, quick: bool) -> dict[str, Any]:
    """Return the budget; for each sampler the generations within it, captures and escapes."""
    # The smallest total is a number of matches that every race has played.
    totals = (run.log()["matches"][-1] for of_name in runs.values() for run in of_name)
    budget = int(min(totals))
    capture, escape = scores(cross_play(runs, budget, episodes=2 if quick else 20))
    numbers: dict[str, Any] = {"budget": budget}
    for name, captured, escaped in zip(runs, capture, escape, strict=True):
        reached = [run.generation_at("evader", budget) for run in runs[name]]
        for key, each in (("generation", reached), ("capture", captured), ("escape", escaped)):
            numbers[f"{name} / {key}"] = each
    return numbers


def table(numbers: Numbers) -> str:
    """Return the rates of each sampler's champions in Markdown."""
    rows = []
    for name in kinds_in(numbers):
        rates = (numbers[f"{name} / {key}"] for key in ("capture", "escape"))
        means = (str(analysis.interval_over_runs(each, bounds=(0.0, 1.0))) for each in rates)
        rows.append([name, f"{numbers[f'{name} / generation'].mean():.1f}", *means])
    heads = ["sampler", "generations", "capture rate of pursuers", "escape rate of evaders"]
    told = f"Champions after {numbers['budget']:,} matches, against those of the other samplers:"
    return f"{told}\n\n{markdown(heads, rows)}"


if __name__ == "__main__":
    experiment(__doc__, kinds=kinds, measure=measured, table=table, seeds=5)
