"""What do shorter races lose? Half of the matches, and steps that spread, each by itself.

    python evolution/race_budgets.py           ten seeds of each race, an hour on two cores
    python evolution/race_budgets.py --quick   a small world and two seeds, some seconds

Races of `evolve --paper` differ in two things from the *long* ones (`common.long_race`). They play
half of the matches, and their samples spread with the genome (`relative_sigma`), where those of the
long ones have the same standard deviation throughout. So there are four kinds of race. Those of the
same schedule and seed are compared by the scores of both last generations against held-out
opponents, and by the share of checkerboards in the last half.

Long races with the same steps have been played for other tables, and are read from results/; of the
hall of fame their scores are kept, not their payoffs. Only ``--quick`` plays them.

Look at the differences, each kind minus long: an interval that lies on one side of 0 says what the
change costs or brings.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

import hall_of_fame
from common import (
    SAME_STEPS,
    SMALL_RACE,
    Numbers,
    Runs,
    by_seed,
    experiment,
    kinds_in,
    long_race,
    markdown,
    mean,
)
from matrixworld import analysis
from matrixworld.coevolution import TEAMS, RaceSettings, SavedRun, score
from matrixworld.coevolution.types import FloatArray

SPECIALISTS, GENERALISTS = "specialist-specialist", "generalist-generalist"
HALL = "hall-of-fame"
SCHEDULES = (SPECIALISTS, GENERALISTS, HALL)
KEPT = Path(__file__).parent / "results"
LONG, DEFAULT = "long", "default"
LONG_SPREADING, DEFAULT_SAME = "long, spreading steps", "default, same steps"
SEEDS, LONG_MATCHES = 10, 268_810
QUICK_EPOCHS = {
    LONG: {"pursuer_epochs": 4, "evader_epochs": 8, "joint_epochs": 6},
    DEFAULT: {"pursuer_epochs": 2, "evader_epochs": 4, "joint_epochs": 3},
}
"""Epochs in a generation of the races of ``--quick``."""


def kinds(quick: bool) -> dict[str, RaceSettings]:
    """Return the settings of all kinds of races; of long ones with the same steps if `quick`."""
    found = {}
    for schedule in SCHEDULES:
        default = RaceSettings.of({"schedule": schedule})
        of_schedule = {DEFAULT: default}
        if quick:
            of_schedule[LONG] = RaceSettings.of(long_race(schedule))
        if schedule != HALL:
            of_schedule[DEFAULT_SAME] = default.changed(SAME_STEPS)
            long = {n: v for n, v in long_race(schedule).items() if n not in SAME_STEPS}
            of_schedule[LONG_SPREADING] = RaceSettings.of(long)
        for kind, settings in of_schedule.items():
            if quick:
                known, epochs = vars(settings.schedule), QUICK_EPOCHS[kind.split(",")[0]]
                few = {f"schedule.{n}": k for n, k in epochs.items() if n in known}
                settings = settings.changed({**SMALL_RACE, "schedule.generations": 8, **few})
            found[f"{kind}; {schedule}"] = settings
    return found


def scores_of(run: SavedRun) -> dict[str, float]:
    """Return the scores of both last generations against held-out opponents."""
    scores = score(run)
    return {team: float(scores[team].means[-1]) for team in TEAMS}


def checkerboards(payoffs: FloatArray) -> FloatArray:
    """Return the share of checkerboards in the last half of races (seeds, G, H, episodes)."""
    measure = analysis.MEASURES["checkerboards"]
    return np.array([measure.of(each.mean(axis=-1), "last half").value for each in payoffs])


def measured(runs: Runs, quick: bool) -> dict[str, Any]:
    """Return scores, matches and checkerboards of each kind, and the numbers of long races."""
    numbers = by_seed(runs, scores_of) | ({} if quick else kept())
    for kind, each in runs.items():
        every = np.stack([run.payoff().scores for run in each])
        numbers[f"matches of {kind}"] = each[0].log()["matches"][-1] + every[0].size
        numbers[f"checkerboards in {kind}"] = checkerboards(every)
    return numbers


def kept() -> dict[str, Any]:
    """Return the numbers of the long races, which other tables have."""
    hall = dict(np.load(KEPT / "hall_of_fame" / "numbers.npz"))
    claims = dict(np.load(KEPT / "paper" / "paper_claims" / "numbers.npz"))
    numbers: dict[str, Any] = {f"matches of {LONG}; {each}": LONG_MATCHES for each in SCHEDULES}
    for team in TEAMS:
        scores = hall[f"{hall_of_fame.HALL} / {team}_score"]
        numbers[f"{LONG}; {HALL} / {team}"] = scores[:SEEDS]
    for row, schedule in ((0, SPECIALISTS), (2, GENERALISTS)):
        rates = claims[f"captured {schedule}"][:SEEDS] / float(claims["evaders"])
        kind = f"{LONG}; {schedule}"
        numbers[f"checkerboards in {kind}"] = checkerboards(rates)
        for team in TEAMS:
            numbers[f"{kind} / {team}"] = claims[f"held-out of {team}s"][row, :SEEDS]
    return numbers


def order_of(kind: str) -> tuple[int, int]:
    """Return the place of a kind: schedule by schedule, long races first."""
    budget, schedule = kind.split("; ")
    return SCHEDULES.index(schedule), (LONG, LONG_SPREADING, DEFAULT_SAME, DEFAULT).index(budget)


def table(numbers: Numbers) -> str:
    """Return the comparison of both kinds of races as a table in Markdown."""
    rows = []
    for kind in sorted(kinds_in(numbers), key=order_of):
        long = f"{LONG}; {kind.split('; ')[1]}"
        compared = [f"{{}} / {team}" for team in TEAMS]
        if f"checkerboards in {long}" in numbers:
            compared.append("checkerboards in {}")
        cells = []
        for name in compared:
            each, other = numbers[name.format(kind)], numbers[name.format(long)]
            # Of the same seeds.
            cells.append(mean(each, 3) if kind == long else mean(each - other[: len(each)], 3, "+"))
        cells += ["not kept"] * (3 - len(cells))
        seeds = len(numbers[f"{kind} / pursuer"])
        rows.append([kind, str(seeds), f"{numbers[f'matches of {kind}']:,}", *cells])
    heads = ["races", "seeds", "matches", *(f"{team}s" for team in TEAMS), "checkerboards"]
    told = "Scores and checkerboards: of long races the mean, of others the difference from them."
    return f"{told}\n\n{markdown(heads, rows)}"


if __name__ == "__main__":
    experiment(__doc__, kinds=kinds, measure=measured, table=table, seeds=SEEDS)
