"""Do races need twice the matches of the default ones? Longer ones, with other steps.

    python evolution/race_budgets.py           ten seeds of three schedules, 20 minutes on two cores
    python evolution/race_budgets.py --quick   a small world and two seeds, some seconds

The samples of default races spread with the genome (`relative_sigma`). The *long* races play twice
as many matches with the same standard deviation throughout (`common.long_race`). Races of the same
schedule and seed are compared by the scores of both last generations against held-out opponents,
and all seeds together by what the judgement finds in the last half of the race.

The long races have been played for other tables, and are read from results/; of the hall of fame
their scores are kept, not their payoffs. Only ``--quick`` plays them.

Look at the differences, default minus long. An interval that lies below 0 says that half of the
matches cost something; one around 0 says how much they may cost.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

import hall_of_fame
from common import (
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

SPECIALISTS, GENERALISTS = "specialist-specialist", "generalist-generalist"
HALL = "hall-of-fame"
SCHEDULES = (SPECIALISTS, GENERALISTS, HALL)
KEPT = Path(__file__).parent / "results"
LONG, DEFAULT = "long", "default"
SEEDS, LONG_MATCHES = 10, 268_810
QUICK_EPOCHS = {
    LONG: {"pursuer_epochs": 4, "evader_epochs": 8, "joint_epochs": 6},
    DEFAULT: {"pursuer_epochs": 2, "evader_epochs": 4, "joint_epochs": 3},
}
"""Epochs in a generation of the races of ``--quick``."""


def kinds(quick: bool) -> dict[str, RaceSettings]:
    """Return the settings of default races, and of long ones with ``--quick``."""
    found = {}
    for kind in (LONG, DEFAULT) if quick else (DEFAULT,):
        for schedule in SCHEDULES:
            chosen = long_race(schedule) if kind == LONG else {"schedule": schedule}
            settings = RaceSettings.of(chosen)
            if quick:
                known = vars(settings.schedule)
                few = {f"schedule.{n}": k for n, k in QUICK_EPOCHS[kind].items() if n in known}
                settings = settings.changed({**SMALL_RACE, "schedule.generations": 8, **few})
            found[f"{kind}; {schedule}"] = settings
    return found


def scores_of(run: SavedRun) -> dict[str, float]:
    """Return the scores of both last generations against held-out opponents."""
    scores = score(run)
    return {team: float(scores[team].means[-1]) for team in TEAMS}


def found_in(payoffs: Any) -> list[str]:
    """Return what the judgement finds in races together: payoffs (seeds, G, H, episodes)."""
    return [*analysis.judge(payoffs, per_episode=True).present()]


def measured(runs: Runs, quick: bool) -> dict[str, Any]:
    """Return scores, matches and what is found of each kind, and the numbers of long races."""
    numbers = by_seed(runs, scores_of) | ({} if quick else kept())
    for kind, each in runs.items():
        every = np.stack([run.payoff().capture_rates for run in each])
        numbers[f"matches of {kind}"] = each[0].log()["matches"][-1] + every[0].size
        numbers[f"found in {kind}"] = np.array(found_in(every), str)
    return numbers


def kept() -> dict[str, Any]:
    """Return the numbers of the long races, which other tables have."""
    hall = dict(np.load(KEPT / "hall_of_fame" / "numbers.npz"))
    claims = dict(np.load(KEPT / "paper_claims" / "numbers.npz"))
    numbers: dict[str, Any] = {f"matches of {LONG}; {each}": LONG_MATCHES for each in SCHEDULES}
    for team in TEAMS:
        scores = hall[f"{hall_of_fame.HALL} / {team}_score"]
        numbers[f"{LONG}; {HALL} / {team}"] = scores[:SEEDS]
    for row, schedule in ((0, SPECIALISTS), (2, GENERALISTS)):
        rates = claims[f"captured {schedule}"][:SEEDS] / float(claims["evaders"])
        numbers[f"found in {LONG}; {schedule}"] = np.array(found_in(rates), str)
        for team in TEAMS:
            numbers[f"{LONG}; {schedule} / {team}"] = claims[f"held-out of {team}s"][row, :SEEDS]
    return numbers


def table(numbers: Numbers) -> str:
    """Return the comparison of both kinds of races as a table in Markdown."""
    rows = []
    # Long races first.
    for kind in sorted(kinds_in(numbers), key=lambda kind: not kind.startswith(LONG)):
        long = f"{LONG}; {kind.split('; ')[1]}"
        scores = [numbers[f"{kind} / {team}"] for team in TEAMS]
        differences = ["", ""]
        if kind != long:
            before = [numbers[f"{long} / {team}"] for team in TEAMS]
            # Of the same seeds.
            differences = [
                mean(each - other[: len(each)], 2, "+")
                for each, other in zip(scores, before, strict=True)
            ]
        found = numbers.get(f"found in {kind}")
        told = "not kept" if found is None else ", ".join(found) or "cannot tell"
        counts = [str(len(scores[0])), f"{numbers[f'matches of {kind}']:,}"]
        rows.append([kind, *counts, *(mean(each, 2) for each in scores), *differences, told])
    heads = ["races", "seeds", "matches", *(f"{team}s" for team in TEAMS)]
    heads += [f"difference, {team}s" for team in TEAMS]
    return markdown([*heads, "found in the last half"], rows)


if __name__ == "__main__":
    experiment(__doc__, kinds=kinds, measure=measured, table=table, seeds=SEEDS)
