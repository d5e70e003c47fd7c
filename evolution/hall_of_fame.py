"""Do halls of fame do what their literature says? Races with and without them, at equal matches.

    python evolution/hall_of_fame.py             ten seeds of each kind, half an hour on two cores
    python evolution/hall_of_fame.py --quick     a small world and two seeds, some seconds

Two populations evolve simultaneously. Without halls of fame, individuals meet living opponents
only. With halls of fame they also meet earlier champions. Both kinds of race play the same number
of matches. Runs are kept in ``--runs``; an interrupted script continues where it stopped.

Method: Rosin and Belew (1997), "New methods for competitive coevolution". They expect of a hall of
fame that less is forgotten, and that progress does not go in cycles.

Look at the last three columns: the difference that halls of fame make, with its interval over
seeds; its p-value; and whether it is the expected one. P-values are adjusted for the number of rows
(Holm), so that by chance any verdict of the table is wrong in 5 % of such tables; an interval
speaks of its own row alone. ``--results`` receives the table and the numbers of each race.
"""

from __future__ import annotations

import csv
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from tqdm import tqdm

from common import (
    SIGNIFICANCE,
    finish_all,
    holm,
    long_race,
    p_value,
    script_parser,
    shown_p,
    written,
)
from matrixworld import analysis, plots
from matrixworld.coevolution import TEAMS, RaceSettings, SavedRun, open_run, score

FULL = RaceSettings.of(long_race("hall-of-fame"))
QUICK = FULL.changed(
    {
        "world.rows": 10,
        "world.cols": 10,
        "world.n_pursuers": 3,
        "world.n_evaders": 4,
        "schedule.generations": 8,
        "schedule.joint_epochs": 3,
        "learner.population": 8,
        "train_steps": 40,
        "world.max_steps": 60,
    }
)
LIVING, HALL = "living opponents only", "halls of fame"

Row = dict[str, float]
"""Numbers of one race: its seed, and the keys of `MEASURES`."""


@dataclass(frozen=True)
class Measure:
    """A number of a race that halls of fame are expected to change.

    Parameters
    ----------
    label : str
        Name in words.
    expected : {1, -1}
        Whether halls of fame should raise it or lower it.
    """

    label: str
    expected: int


MEASURES = {
    "pursuer_forgetting": Measure("forgetting of the pursuers", -1),
    "evader_forgetting": Measure("forgetting of the evaders", -1),
    "checkerboards": Measure("checkerboard share, last half", -1),
    "transitive_share": Measure("transitive share, last half", 1),
    "lag_rise": Measure("gain of later over earlier pursuers", 1),
    "pursuer_score": Measure("held-out score of the pursuers", 1),
    "evader_score": Measure("held-out score of the evaders", 1),
}


WHOLE = dict.fromkeys(("pursuer_forgetting", "evader_forgetting"), "whole")
"""Windows of the measures that are not about that of tables."""


def kinds(base: RaceSettings) -> dict[str, RaceSettings]:
    """Return the settings of both kinds of race, with the same number of matches."""
    # A match between living opponents counts for both teams, a match against the hall for one.
    living = base.schedule.contemporaries + 2 * base.schedule.hall_sample
    return {
        LIVING: base.changed({"schedule.contemporaries": living, "schedule.hall_sample": 0}),
        HALL: base,
    }


def numbers_of(run: SavedRun, threads: int | None) -> Row:
    """Return the numbers of one finished race."""
    matrix, scores = run.payoff().capture_rate, score(run, threads=threads)
    of_matrix = {
        name: analysis.MEASURES[name].of(matrix, WHOLE.get(name)).value
        for name in MEASURES
        if name in analysis.MEASURES
    }
    return {
        **of_matrix,
        **{f"{team}_score": float(scores[team].rates[-1].mean()) for team in TEAMS},
    }


def play(
    base: RaceSettings, seeds: range, root: Path, threads: int | None, where: str | None
) -> dict[str, list[Row]]:
    """Return the numbers of all races by kind, playing the missing ones."""
    # All kinds of a seed, then the next seed: an interrupted comparison is still one of equals.
    runs = finish_all(
        {
            place(name, seed): replace(settings, seed=seed)
            for seed in seeds
            for name, settings in kinds(base).items()
        },
        root,
        threads=threads,
        where=where,
    )
    return {
        name: [
            {"seed": seed, **numbers_of(runs[place(name, seed)], threads)}
            for seed in tqdm(seeds, unit=" scores", disable=None)
        ]
        for name in kinds(base)
    }


def place(name: str, seed: int) -> str:
    """Return the path of a race in the directory of all runs."""
    return f"{name.replace(' ', '-')}/{seed}"


def verdict(p: float, difference: float, expected: int) -> str:
    """Return whether a difference lies on the expected side of 0, by its adjusted p-value."""
    if p > SIGNIFICANCE:
        return "cannot tell"
    return "as expected" if np.sign(difference) == expected else "the opposite"


def table(found: Mapping[str, Sequence[Row]]) -> str:
    """Return the comparison of both kinds of race as a table in Markdown."""
    head = f"| mean over {len(found[HALL])} seeds [95%] | expected | {' | '.join(found)} |"
    lines = [f"{head} difference | Holm | |", "|---" * 7 + "|"]
    numbers = {
        name: {kind: np.array([row[name] for row in rows]) for kind, rows in found.items()}
        for name in MEASURES
    }
    # Pairs of the same seed: both races start with the same genomes.
    differences = {name: each[HALL] - each[LIVING] for name, each in numbers.items()}
    adjusted = holm([p_value(each) for each in differences.values()])
    for (name, measure), p in zip(MEASURES.items(), adjusted, strict=True):
        difference = differences[name]
        cells = [
            measure.label,
            "higher" if measure.expected > 0 else "lower",
            *(
                written(analysis.interval_over_runs(values))
                for values in (*numbers[name].values(), difference)
            ),
            shown_p(p),
            f"**{verdict(p, difference.mean(), measure.expected)}**",
        ]
        lines.append(f"| {' | '.join(cells)} |")
    return "\n".join(lines)


def write_races(path: Path, found: Mapping[str, Sequence[Row]]) -> None:
    """Write one line for each race: its kind, its seed and its numbers."""
    with path.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["kind", "seed", *MEASURES])
        for kind, rows in found.items():
            for row in rows:
                cells = [f"{row[name]:.6f}" for name in MEASURES]
                writer.writerow([kind, row["seed"], *cells])


def read_races(path: Path) -> dict[str, list[Row]]:
    """Return what `write_races` has written."""
    found: dict[str, list[Row]] = {LIVING: [], HALL: []}
    with path.open(encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            kind = row.pop("kind")
            found[kind].append({name: float(value) for name, value in row.items()})
    return found


def main() -> None:
    """Play missing runs, print and write the comparison, and draw one race of each kind."""
    parser = script_parser(__doc__, quick="a small world and two seeds", cluster=True)
    parser.add_argument("--seeds", type=int, help="races of each kind; default 10, or 2")
    parser.add_argument("--runs", type=Path, default=Path("runs/hall_of_fame"))
    parser.add_argument("--results", type=Path, default=Path("hall_of_fame"))
    parser.add_argument("--threads", type=int, help="default: one for each core")
    args = parser.parse_args()
    base, few = (QUICK, 2) if args.quick else (FULL, 10)
    found = play(base, range(args.seeds or few), args.runs, args.threads, args.cluster)
    args.results.mkdir(parents=True, exist_ok=True)
    write_races(args.results / "races.csv", found)
    # From the file, so that the table follows from the rounded numbers that are kept.
    text = table(read_races(args.results / "races.csv"))
    (args.results / "comparison.md").write_text(text + "\n", encoding="utf-8")
    print(text)
    # One race of each kind: a mean over seeds would hide cycles of different phase.
    first = {name: open_run(args.runs / place(name, 0)).payoff().capture_rate for name in found}
    plots.comparison(first).savefig(args.results / "seed_0.png")
    print(f"Written: races.csv, comparison.md and seed_0.png in {args.results}")


if __name__ == "__main__":
    main()
