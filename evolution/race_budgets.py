"""Do races need twice the matches of the default ones? Longer ones, with other steps.

    python evolution/race_budgets.py           ten seeds of three schedules, 20 minutes on two cores
    python evolution/race_budgets.py --quick   a small world and two seeds, some seconds

The samples of default races spread with the genome (`relative_sigma`). The *long* races play twice
as many matches with the same standard deviation throughout (`common.long_race`). Races of the same
schedule and seed are compared by the scores of both last generations against held-out opponents,
and all seeds together by what the judgement finds in the last half of the race. ``--schedules`` and
``--seeds`` choose which races are played. ``--results`` receives the numbers of all races in
``--runs`` that have ended; an interrupted script continues where it stopped.

The long races have been played for other tables, and are read from results/; of the hall of fame
their scores are kept, not their payoffs. Only ``--quick`` plays them.

Look at the differences, default minus long. An interval that lies below 0 says that half of the
matches cost something; one around 0 says how much they may cost.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

import hall_of_fame
from common import finish_all, long_race, script_parser, written
from matrixworld import analysis
from matrixworld.coevolution import TEAMS, RaceSettings, SavedRun, open_run, score

SPECIALISTS, GENERALISTS, HALL = (
    "specialist-specialist",
    "generalist-generalist",
    "hall-of-fame",
)
SCHEDULES = (SPECIALISTS, GENERALISTS, HALL)
KEPT = Path(__file__).parent / "results"
LONG, DEFAULT = "long", "default"
SEEDS, LONG_MATCHES = 10, 268_810
DONE = "summary.json"
"""The last file of a run."""
SMALL = {
    "world.rows": 10,
    "world.cols": 10,
    "world.n_pursuers": 3,
    "world.n_evaders": 4,
    "world.max_steps": 60,
    "schedule.generations": 8,
    "learner.population": 8,
    "train_steps": 40,
}
QUICK_EPOCHS = {
    LONG: {"pursuer_epochs": 4, "evader_epochs": 8, "joint_epochs": 6},
    DEFAULT: {"pursuer_epochs": 2, "evader_epochs": 4, "joint_epochs": 3},
}
"""The world and the length of the races of ``--quick``, and their epochs in a generation."""

Numbers = dict[str, dict[str, Any]]
"""Kind and schedule -> "seeds", "matches", the scores of each team (seeds,), and "found"."""


def settings_of(kind: str, schedule: str, seed: int, quick: bool) -> RaceSettings:
    """Return the settings of a race."""
    settings = RaceSettings.of(long_race(schedule) if kind == LONG else {"schedule": schedule})
    if quick:
        known = vars(settings.schedule)
        few = {f"schedule.{n}": each for n, each in QUICK_EPOCHS[kind].items() if n in known}
        settings = settings.changed({**SMALL, **few})
    return replace(settings, seed=seed)


def place(kind: str, schedule: str, seed: int) -> str:
    """Return the path of a race in the directory of all runs."""
    return f"{kind}-{schedule}/{seed}"


def key(kind: str, schedule: str) -> str:
    """Return the name of the races of a kind and a schedule."""
    return f"{kind}; {schedule}"


def found_in(payoffs: ArrayLike) -> list[str]:
    """Return what the judgement finds in races together: payoffs (seeds, G, H, episodes)."""
    return [*analysis.judge(payoffs, per_episode=True).present()]


def measured(runs: Mapping[int, SavedRun], threads: int | None) -> dict[str, Any]:
    """Return the numbers of races of a kind and a schedule, by seed."""
    scores = [score(run, threads=threads) for run in runs.values()]
    every = [run.payoff().capture_rates for run in runs.values()]
    return {
        "seeds": [*runs],
        "matches": next(iter(runs.values())).log()["matches"][-1].item() + every[0].size,
        **{team: [round(float(each[team].means[-1]), 4) for each in scores] for team in TEAMS},
        "found": found_in(np.stack(every)),
    }


def kept() -> Numbers:
    """Return the numbers of the long races, which other tables have."""
    hall = hall_of_fame.read_races(KEPT / "hall_of_fame" / "races.csv")[hall_of_fame.HALL]
    numbers: Numbers = {
        key(LONG, HALL): {
            **{team: [row[f"{team}_score"] for row in hall[:SEEDS]] for team in TEAMS},
            "found": None,
        }
    }
    with np.load(KEPT / "paper_claims" / "numbers.npz") as claims:
        for row, schedule in ((0, SPECIALISTS), (2, GENERALISTS)):
            rates = claims[f"captured {schedule}"][:SEEDS] / float(claims["evaders"])
            scores = {team: claims[f"held-out of {team}s"][row, :SEEDS] for team in TEAMS}
            numbers[key(LONG, schedule)] = {
                **{team: np.round(each, 4).tolist() for team, each in scores.items()},
                "found": found_in(rates),
            }
    same = {"seeds": [*range(SEEDS)], "matches": LONG_MATCHES}
    return {name: {**same, **each} for name, each in numbers.items()}


def table(numbers: Numbers) -> str:
    """Return the comparison of both kinds of races as a table in Markdown."""
    heads = ["races", "seeds", "matches", *(f"{team}s" for team in TEAMS)]
    heads += [f"difference, {team}s" for team in TEAMS]
    lines = [f"| {' | '.join([*heads, 'found in the last half'])} |", "|---" * 8 + "|"]
    for name, each in numbers.items():
        long = numbers[key(LONG, name.split("; ")[1])]
        cells = [name, str(len(each["seeds"])), f"{each['matches']:,}"]
        cells += [written(analysis.interval_over_runs(each[team]), 2) for team in TEAMS]
        cells += [difference(each, long, team) for team in TEAMS]
        found = each["found"]
        cells.append("not kept" if found is None else ", ".join(found) or "cannot tell")
        lines.append(f"| {' | '.join(cells)} |")
    return "\n".join(lines)


def difference(one: Mapping[str, Any], long: Mapping[str, Any], team: str) -> str:
    """Return the difference of the scores of the same seeds, with its interval over seeds."""
    if one is long:
        return ""
    of_long = dict(zip(long["seeds"], long[team], strict=True))
    changes = [each - of_long[seed] for seed, each in zip(one["seeds"], one[team], strict=True)]
    return written(analysis.interval_over_runs(changes), 2, "+")


def main() -> None:
    """Play missing races, and write the numbers of all."""
    parser = script_parser(__doc__, quick="a small world and two seeds")
    parser.add_argument("--schedules", nargs="+", choices=SCHEDULES, default=SCHEDULES)
    parser.add_argument("--seeds", nargs="+", type=int, help=f"default: 0 to {SEEDS - 1}, or 0 1")
    parser.add_argument("--runs", type=Path, default=Path("runs/race_budgets"))
    parser.add_argument("--results", type=Path, default=Path("race_budgets"))
    parser.add_argument("--threads", type=int, help="default: one for each core")
    args = parser.parse_args()
    kinds = (LONG, DEFAULT) if args.quick else (DEFAULT,)
    races = {
        place(kind, schedule, seed): settings_of(kind, schedule, seed, args.quick)
        for seed in args.seeds or range(2 if args.quick else SEEDS)
        for schedule in args.schedules
        for kind in kinds
    }
    finish_all(races, args.runs, threads=args.threads)
    numbers = {} if args.quick else kept()
    for kind in kinds:
        for schedule in SCHEDULES:
            places = {seed: args.runs / place(kind, schedule, seed) for seed in range(SEEDS)}
            runs = {seed: open_run(at) for seed, at in places.items() if (at / DONE).exists()}
            if runs:
                numbers[key(kind, schedule)] = measured(runs, args.threads)
    args.results.mkdir(parents=True, exist_ok=True)
    (args.results / "numbers.json").write_text(json.dumps(numbers, indent=1) + "\n", "utf-8")
    text = table(numbers)
    (args.results / "table.md").write_text(text + "\n", encoding="utf-8")
    print(text)
    print(f"Written: numbers.json and table.md in {args.results}")


if __name__ == "__main__":
    main()
