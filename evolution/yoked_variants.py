"""Does an arms race of ratings need an answering opponent? Yoked races in the nine variants.

    python evolution/yoked_variants.py --threads 1   ten seeds in all variants, ten minutes
    python evolution/yoked_variants.py --quick       two seeds of short races, some seconds

`yoked_worlds.py` asks this in solved worlds of tables; here it is asked in larger worlds by
matches: two pursuers against four evaders on 12 x 12 cells, or six against one on 8 x 8 cells where
evaders are surrounded, for 60 steps. Settings come from trials of one seed in five variants, in
which both teams had to learn. Ratings of moves evolve by an evolution strategy, generalists in
turns. In the yoked race each team meets the opponents of the race of the next seed
(`yoked_races.py`).

A team's *rise* is how much better its last fifth of generations scores than its first generation,
against every fifth generation of the races of all seeds that neither kind has met. Decided before
the races were played: answers *pay* or *cost* a team in a variant if the difference of rises, race
minus yoked race of the same seed, is told from 0 (Student's t over seeds, Holm over both teams and
all variants); *alike* if its 95 % interval lies within .05; else one cannot tell. The last rows are
means over the variants, each variant one unit, but for SD and SDB: with a single evader it makes no
difference whether captured ones disappear, so these are S and SB with other draws.
"""

from __future__ import annotations

from typing import Any

import numpy as np

import matrixworld as mw
from common import Numbers, Runs, adjusted, experiment, markdown, mean, shown_p
from matrixworld import analysis
from matrixworld.coevolution import TEAMS, RaceSettings
from yoked_races import MEET, RACE, YOKED, against_common, play, verdict, yoked

SIZES = {mw.Capture.OCCUPATION: (12, 2, 4), mw.Capture.SURROUND: (8, 6, 1)}
"""Side of the grid, pursuers and evaders, by what captures."""
SETTINGS: dict[str, Any] = {
    "world.max_steps": 60, "train_steps": 60,
    "match_episodes": 2, "evaluation_episodes": 2, "policy": "rating", "policy.initial_weight": 0.2,
    "learner.population": 12, "learner.sigma": 0.3, "learner.learning_rate": 0.0025,
    "schedule.generations": 20, "schedule.pursuer_epochs": 10, "schedule.evader_epochs": 10, **MEET,
}  # fmt: skip
QUICK = {"schedule.generations": 5, "schedule.pursuer_epochs": 4, "schedule.evader_epochs": 1}
QUICK_VARIANTS = ("O", "R")
TWINS = ("SD", "SDB")
"""Variants that are others where there is a single evader."""


def kinds(quick: bool) -> dict[str, RaceSettings]:
    """Return the settings of the races in each variant."""
    found = {}
    for name in QUICK_VARIANTS if quick else mw.VARIANTS:
        side, pursuers, evaders = SIZES[mw.VARIANTS[name].capture]
        world = {
            "world.rules": name, "world.rows": side, "world.cols": side,
            "world.n_pursuers": pursuers, "world.n_evaders": evaders,
        }  # fmt: skip
        found[f"{name}, generalists, {RACE}"] = RaceSettings.of({
            **SETTINGS, **world, **(QUICK if quick else {}),
        })  # fmt: skip
    return found


def measured(runs: Runs, quick: bool) -> dict[str, Any]:
    """Return the rises of both teams by seed."""
    numbers = {}
    for kind, each in runs.items():
        races = runs[kind.removesuffix(YOKED).removesuffix(RACE) + RACE]
        for team in TEAMS:
            rises = [against_common(team, seed, run, races) for seed, run in enumerate(each)]
            numbers[f"{kind} / {team}"] = np.array(rises)
    return numbers


def table(numbers: Numbers) -> str:
    """Return the rises of both kinds of race in each variant, in Markdown."""
    values = {
        (name, team): [numbers[f"{name}, generalists, {kind} / {team}"] for kind in (RACE, YOKED)]
        for name in mw.VARIANTS
        for team in TEAMS
        if f"{name}, generalists, {RACE} / {team}" in numbers
    }
    differences = {key: race - other for key, (race, other) in values.items()}
    rows = [
        [*row(*key, *values[key]), shown_p(p), f"**{told(differences[key], p)}**"]
        for key, p in adjusted(differences).items()
    ]
    means = {
        team: [np.array([each[k].mean() for (name, of), each in values.items()
                         if of == team and name not in TWINS]) for k in range(2)]
        for team in TEAMS
    }  # fmt: skip
    over = {team: race - other for team, (race, other) in means.items()}
    rows += [
        [*row("seven variants", team, *means[team]), shown_p(p), f"**{told(over[team], p)}**"]
        for team, p in adjusted(over).items()
    ]
    count = len(next(iter(differences.values())))
    heads = ["variant", f"rise, mean over {count} seeds [95 %]", "race", "yoked race"]
    return markdown([*heads, "race minus yoked race", "Holm", "answers"], rows)


def row(name: str, team: str, race: Any, other: Any) -> list[str]:
    """Return the cells of a variant and team."""
    return [name, f"{team}s", mean(race), mean(other), mean(race - other, sign="+")]


def told(difference: Any, p: float) -> str:
    """Return what answers do, by the words of `yoked_races.verdict`."""
    said = verdict(p, analysis.interval_over_runs(difference))
    return {"race higher": "pay", "yoked higher": "cost"}.get(said, said)


if __name__ == "__main__":
    experiment(__doc__, kinds=kinds, then=yoked, play=play, measure=measured, table=table, seeds=10)
