"""Do races need all their matches? Half of them, with other standard deviations of the samples.

    python evolution/race_budgets.py           all kinds and seeds, some hours on two cores
    python evolution/race_budgets.py --quick   a small world and two seeds, some seconds

Each kind of race of `KINDS` changes the default settings, and plays half of their matches. Races of
the same schedule and seed are compared by the scores of both last generations against held-out
opponents, and all seeds together by what the judgement finds in the last half of the race.
``--kinds``, ``--schedules`` and ``--seeds`` choose which races are played. ``--results`` receives
the numbers of all races in ``--runs`` that have ended; an interrupted script continues where it
stopped.

Races with the default settings have been played for other tables, and are read from results/; of
the hall of fame their scores are kept, not their payoffs. Only ``--quick`` plays them.

Look at the differences. An interval that lies below 0 says that half of the matches cost something;
one around 0 says how much they may cost.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

import hall_of_fame
from common import finish_all, script_parser, written
from matrixworld import analysis
from matrixworld.coevolution import TEAMS, RaceSettings, SavedRun, open_run, score

SPECIALISTS, GENERALISTS, HALL = (
    "specialist-specialist",
    "generalist-generalist",
    "hall-of-fame",
)
SCHEDULES = (SPECIALISTS, GENERALISTS, HALL)
KEPT = Path(__file__).parent / "results"
LONG = "default: sigma 0.1, rate 0.02"
SEEDS, LONG_MATCHES = 10, 268_810
DONE = "summary.json"
"""The last file of a run."""


def kind(pursuers: int, evaders: int, joint: int, **learner: float) -> dict[str, Any]:
    """Return changes of settings: the epochs of a generation, and those of the learner."""
    return {
        "schedule.pursuer_epochs": pursuers,
        "schedule.evader_epochs": evaders,
        "schedule.joint_epochs": joint,
        **{f"learner.{name}": value for name, value in learner.items()},
    }


KINDS = {
    LONG: kind(60, 120, 90, sigma=0.1, learning_rate=0.02),
    "half: sigma 0.1, rate 0.02": kind(28, 58, 43, sigma=0.1, learning_rate=0.02),
    "half: relative sigma 0.4, rate 0.03": kind(
        28, 58, 43, sigma=0.1, relative_sigma=0.4, learning_rate=0.03
    ),
}
"""Settings by name; the first ones are the default."""
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
QUICK = {
    name: {**SMALL, **changes}
    for name, changes in {
        LONG: kind(4, 8, 6, sigma=0.1, learning_rate=0.02),
        "half: relative sigma 0.4, rate 0.03": kind(
            2, 4, 3, sigma=0.1, relative_sigma=0.4, learning_rate=0.03
        ),
    }.items()
}

Numbers = dict[str, dict[str, Any]]
"""Kind and schedule -> "seeds", "matches", the scores of each team (seeds,), and "found"."""


def settings_of(changes: Mapping[str, Any], schedule: str, seed: int) -> RaceSettings:
    """Return the settings of a race, by the changes that its schedule has."""
    idle = "r_epochs" if schedule == HALL else "joint_epochs"
    fitting = {path: value for path, value in changes.items() if not path.endswith(idle)}
    return RaceSettings.of({"schedule": schedule, "seed": seed, **fitting})


def place(name: str, schedule: str, seed: int) -> str:
    """Return the path of a race in the directory of all runs."""
    kept_in = re.sub("[ ,:]+", "-", f"{name}-{schedule}")
    return f"{kept_in}/{seed}"


def key(name: str, schedule: str) -> str:
    """Return the name of the races of a kind and a schedule."""
    return f"{name}; {schedule}"


def found_in(payoffs: ArrayLike) -> list[str]:
    """Return what the judgement finds in races together: payoffs (seeds, G, H, episodes)."""
    return [*analysis.judge(payoffs, per_episode=True).present()]


def play(
    kinds: Mapping[str, Mapping[str, Any]],
    chosen: Iterable[str],
    schedules: Iterable[str],
    seeds: Iterable[int],
    root: Path,
    threads: int | None,
) -> None:
    """Play the missing races; all kinds of a seed, then the next seed."""
    races = {
        place(name, schedule, seed): settings_of(kinds[name], schedule, seed)
        for seed in seeds
        for schedule in schedules
        for name in chosen
    }
    finish_all(races, root, threads=threads)


def measured(runs: Mapping[int, SavedRun], threads: int | None) -> dict[str, Any]:
    """Return the numbers of races of a kind and a schedule, by seed."""
    scores = [score(run, threads=threads) for run in runs.values()]
    every = [run.payoff().capture_rates for run in runs.values()]
    return {
        "seeds": [*runs],
        "matches": next(iter(runs.values())).files.log()["matches"][-1].item() + every[0].size,
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
    """Return the comparison of all kinds of races with the first one as a table in Markdown."""
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
    parser.add_argument("--kinds", nargs="+", metavar="NAME", help="default: all")
    parser.add_argument("--schedules", nargs="+", choices=SCHEDULES, default=SCHEDULES)
    parser.add_argument("--seeds", nargs="+", type=int, help=f"default: 0 to {SEEDS - 1}, or 0 1")
    parser.add_argument("--runs", type=Path, default=Path("runs/race_budgets"))
    parser.add_argument("--results", type=Path, default=Path("race_budgets"))
    parser.add_argument("--threads", type=int, help="default: one for each core")
    args = parser.parse_args()
    kinds = QUICK if args.quick else {name: KINDS[name] for name in KINDS if name != LONG}
    seeds = args.seeds or range(2 if args.quick else SEEDS)
    play(kinds, args.kinds or kinds, args.schedules, seeds, args.runs, args.threads)
    numbers = {} if args.quick else kept()
    for name in kinds:
        for schedule in SCHEDULES:
            places = {seed: args.runs / place(name, schedule, seed) for seed in range(SEEDS)}
            runs = {seed: open_run(at) for seed, at in places.items() if (at / DONE).exists()}
            if runs:
                numbers[key(name, schedule)] = measured(runs, args.threads)
    args.results.mkdir(parents=True, exist_ok=True)
    (args.results / "numbers.json").write_text(json.dumps(numbers, indent=1) + "\n", "utf-8")
    text = table(numbers)
    (args.results / "table.md").write_text(text + "\n", encoding="utf-8")
    print(text)
    print(f"Written: numbers.json and table.md in {args.results}")


if __name__ == "__main__":
    main()
