"""What does PSRO bring? Exact exploitability of its races and of others, at equal matches.

    python evolution/psro.py             ten seeds of each race, some minutes on two cores
    python evolution/psro.py --quick     short races of two seeds, some seconds

Races on the small world (`small_world.toml`), which is solved exactly. In races of PSRO each
generation responds to a meta-strategy of the other team: the Nash equilibrium of the matches so
far, the mean mixture of projected replicator dynamics, or the rectified Nash equilibrium. They are
compared with generalists, halls of fame and Pareto archives. Matches that fill payoff
matrices and archives count: all races are read when the shortest one has ended.

For each race the exploitability, exactly: how far what a team guarantees falls short of the value,
both teams together (NashConv). Of the newest generations; and of the *mixtures*, the equilibrium of
the payoff matrix of all generations so far, from which each team draws one an episode. Mixtures can
be made of the generations of any race. Theirs is a bound: an opponent that is told whom it meets
gains as much, and the best one at most. What `matrixworld.solve.mixture_bounds` says of the races
of the first seed shows how close the bound is. *Population exploitability* is what the best
generation of the same race gains against the mixtures, by its payoff matrix.

Method: Lanctot et al. (2017), "A unified game-theoretic approach to multiagent reinforcement
learning"; Balduzzi et al. (2019), "Open-ended learning in symmetric zero-sum games".

Look at the differences from generalists, with intervals over seeds and p-values that are adjusted
for the number of rows (Holm).
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from numpy.typing import ArrayLike, NDArray
from tqdm import tqdm

import matrixworld as mw
from common import (
    SAME_STEPS,
    SIGNIFICANCE,
    finish_all,
    holm,
    kept,
    p_value,
    script_parser,
    shown_p,
    written,
)
from matrixworld import analysis
from matrixworld._util import colors
from matrixworld._util.files import load_toml
from matrixworld.coevolution import TEAMS, RaceSettings, SavedRun
from matrixworld.solve import States, guarantees, mixture_bounds, solve

FULL = RaceSettings.of(load_toml(Path(__file__).with_name("small_world.toml"))).changed(
    {
        **SAME_STEPS,
        "policy.hidden": [32],
        "learner.population": 24,
        "schedule.generations": 12,
        "schedule.pursuer_epochs": 20,
        "schedule.evader_epochs": 20,
        "evaluation_episodes": 64,
    }
)
QUICK = {
    "world.rows": 4,
    "world.cols": 4,
    "schedule.generations": 3,
    "schedule.pursuer_epochs": 3,
    "schedule.evader_epochs": 3,
    "learner.population": 8,
    "evaluation_episodes": 8,
}
# A match is 16 episodes here, so that 2 matches of each pair are 32.
META = {f"schedule.{team}s_meet.episodes": 2 for team in TEAMS}


def meeting(sampler: str, **others: Any) -> dict[str, Any]:
    """Return changes by which both teams meet opponents of a sampler."""
    return {**{f"schedule.{team}s_meet": sampler for team in TEAMS}, **others}


PSRO = {
    "PSRO, Nash": {"schedule": "alternating", **meeting("nash"), **META},
    "PSRO, replicators": {"schedule": "alternating", **meeting("prd"), **META},
    "PSRO, rectified": {"schedule": "alternating", **meeting("rectified"), **META},
}
GENERALISTS = "generalists"
OTHERS = {
    GENERALISTS: {"schedule": "generalist-generalist"},
    "random past opponents": {"schedule": "alternating", **meeting("uniform")},
    "halls of fame": {"schedule": "hall-of-fame"},
    "MaxSolve": {"schedule": "alternating", **meeting("maxsolve")},
    "LAPCA": {"schedule": "alternating", **meeting("lapca")},
}
KINDS = {**OTHERS, **PSRO}

Row = dict[str, Any]
"""Numbers of one race: its seed, and one number of each generation from 1 (see `numbers_of`)."""
CURVES = {
    "newest": "NashConv of the newest generations",
    "mixture": "NashConv of the mixtures, at most",
    "population": "population exploitability",
}
TABLED = ("newest", "mixture")
"""Curves that are compared. The equilibrium of all generations of a race has a population
exploitability of 0, whatever the race: it tells in the course of a race only."""


def races(
    base: RaceSettings, seeds: range, kinds: Mapping[str, Mapping[str, Any]] = KINDS
) -> dict[str, RaceSettings]:
    """Return the settings of all races, all kinds of a seed after each other."""
    schedule = base.schedule
    # With two contemporaries and one of the hall, an epoch of both teams is two of each.
    joint = (schedule.pursuer_epochs + schedule.evader_epochs) // 4
    found = {}
    for seed in seeds:
        for kind, changes in kinds.items():
            given = {"seed": seed, **changes}
            if kind == "halls of fame":
                given |= {
                    "schedule.generations": schedule.generations,
                    "schedule.joint_epochs": max(1, joint),
                }
            found[f"{place(kind)}/{seed}"] = base.changed(given)
    return found


def place(kind: str) -> str:
    """Return the name of the directory of all races of a kind."""
    return kind.lower().replace(",", "").replace(" ", "-")


# Numbers of a race


def mixtures(matrix: NDArray[np.float64], k: int) -> list[NDArray[np.float64]]:
    """Return the equilibrium of the generations up to k, as weights of all generations."""
    nash = analysis.nash_averaging(matrix[: k + 1, : k + 1])
    rest = np.zeros(len(matrix) - k - 1)
    return [np.append(weights, rest) for weights in (nash.pursuers, nash.evaders)]


def numbers_of(run: SavedRun, states: States) -> Row:
    """Return the numbers of one finished race."""
    matrix, log = run.payoff().capture_rate, run.log()
    short = guarantees(states, run.teams).exploitability
    generations = range(1, len(matrix))
    weights = [mixtures(matrix, k) for k in generations]
    curves = {
        "matches": [log["matches"][log["generation"] == k].max() for k in generations],
        "newest": [sum(short[team][k] for team in TEAMS) for k in generations],
        "mixture": [
            sum(w @ short[team] for w, team in zip(of_k, TEAMS, strict=True)) for of_k in weights
        ],
        "population": [analysis.exploitability(matrix, *of_k).total for of_k in weights],
    }
    steps = run.summary()["training_agent_steps"] / int(curves["matches"][-1])
    rounded = {name: np.round(values, 6).tolist() for name, values in curves.items()}
    return {"seed": run.settings.seed, "agent_steps": round(steps, 3), **rounded}


def kept_numbers(run: SavedRun, states: States) -> Row:
    """Return the numbers of a race, which a file beside it keeps for the next call."""
    return kept(run.path.with_suffix(".json"), lambda: numbers_of(run, states))


def enclosure(run: SavedRun, states: States, k: int) -> float:
    """Return the least that the NashConv of the mixtures of generation k can be."""
    ends = []
    for team, weights, best in zip(
        TEAMS, mixtures(run.payoff().capture_rate, k), (1, 0), strict=True
    ):
        genomes, network = run.teams[team].genomes, run.teams[team].network
        members = [mw.Population(genome[None], network) for genome in genomes]
        chosen = [(float(w), m) for w, m in zip(weights, members, strict=True) if w > 0.0]
        ends.append(mixture_bounds(states, chosen, team)[best])
    return round(ends[1] - ends[0], 6)


# Tables and figures


def at_budget(found: Mapping[str, Sequence[Row]]) -> tuple[int, dict[str, dict[str, NDArray[Any]]]]:
    """Return the budget, and the numbers of all seeds of each kind within it."""
    budget = min(row["matches"][-1] for rows in found.values() for row in rows)
    numbers = {}
    for kind, rows in found.items():
        ends = [int(np.searchsorted(row["matches"], budget, side="right")) - 1 for row in rows]
        numbers[kind] = {
            name: np.array([row[name][end] for row, end in zip(rows, ends, strict=True)])
            for name in CURVES
        }
        numbers[kind]["generation"] = 1 + np.array(ends)
        numbers[kind]["agent_steps"] = np.array([row["agent_steps"] for row in rows])
    return budget, numbers


def verdict(p: float, difference: float) -> str:
    """Return whether a difference from generalists is told, by its adjusted p-value."""
    return "cannot tell" if p > SIGNIFICANCE else "lower" if difference < 0.0 else "higher"


def differences(
    reached: Mapping[str, Mapping[str, NDArray[Any]]], labels: Mapping[str, str]
) -> list[str]:
    """Return the differences of all kinds from generalists as a table in Markdown."""
    others = [kind for kind in reached if kind != GENERALISTS]
    lines = ["", "Differences from generalists of the same seed:", ""]
    lines += [f"| race | {' | '.join(f'{label} | Holm' for label in labels.values())} |"]
    lines += ["|---" * (1 + 2 * len(labels)) + "|"]
    # Pairs of the same seed: both races start with the same genomes.
    found = {
        (kind, name): reached[kind][name] - reached[GENERALISTS][name]
        for kind in others
        for name in labels
    }
    adjusted = holm([p_value(each) for each in found.values()])
    told = dict(zip(found, adjusted, strict=True))
    for kind in others:
        cells = [kind]
        for name in labels:
            difference, p = found[kind, name], told[kind, name]
            cells += [
                written(analysis.interval_over_runs(difference), sign="+"),
                f"{shown_p(p)}, {verdict(p, difference.mean())}",
            ]
        lines.append(f"| {' | '.join(cells)} |")
    return lines


def table(numbers: Mapping[str, Any]) -> str:
    """Return the comparison of all kinds of race as tables in Markdown."""
    found: dict[str, list[Row]] = numbers["races"]
    budget, reached = at_budget(found)
    lines = [
        f"After {budget:,} matches; means over {len(found[GENERALISTS])} seeds [95 %]. "
        f"The value is {numbers['value']:.3f}.",
        "",
        f"| race | generations | agent-steps a match | {' | '.join(CURVES[n] for n in TABLED)} |",
        "|---" * (3 + len(TABLED)) + "|",
    ]
    for kind, each in reached.items():
        means = [written(analysis.interval_over_runs(each[name])) for name in TABLED]
        counts = [f"{each['generation'].mean():.1f}", f"{each['agent_steps'].mean():.1f}"]
        lines.append(f"| {' | '.join([kind, *counts, *means])} |")
    lines += differences(reached, {name: CURVES[name] for name in TABLED})
    widths = [
        float(reached[kind]["mixture"][0]) - least for kind, least in numbers["least"].items()
    ]
    lines += [
        "",
        f"In the races of the first seed the bound of the mixtures is at most {max(widths):.4f} "
        "above what an opponent gains that is told nothing.",
    ]
    return "\n".join(lines)


DASHES = {
    "random past opponents": "--",
    "halls of fame": ":",
    "MaxSolve": "-.",
    "LAPCA": (0, (6, 1, 1, 1, 1, 1)),
}
COLORS = {
    GENERALISTS: colors.INK,
    "PSRO, Nash": colors.BLUE,
    "PSRO, replicators": colors.GREEN,
    "PSRO, rectified": colors.VERMILLION,
}


def draw_curve(
    axes: Axes, kind: str, matches: ArrayLike, values: NDArray[np.float64], marker: str = ""
) -> None:
    """Draw the mean of values (seeds, points) over the matches; of some kinds the interval, too."""
    color, style = COLORS.get(kind, colors.MUTED), DASHES.get(kind, "-")
    mean = values.mean(axis=0)
    axes.plot(matches, mean, ls=style, marker=marker, ms=4, color=color, label=kind, lw=1.5)
    if kind in COLORS and len(values) > 1:
        band = analysis.band_over_runs(values)
        axes.fill_between(matches, band.low, band.high, color=color, alpha=0.12, lw=0)


def draw(found: Mapping[str, Sequence[Row]], path: Path) -> None:
    """Draw the mean curves of all kinds over the matches; of some the interval over seeds."""
    figure, panels = plt.subplots(1, 3, figsize=(11.0, 3.6), layout="constrained", sharex=True)
    for (name, label), axes in zip(CURVES.items(), panels, strict=True):
        for kind, rows in found.items():
            matches = np.mean([row["matches"] for row in rows], axis=0)
            draw_curve(axes, kind, matches, np.array([row[name] for row in rows]))
        axes.set(title=label, xlabel="training matches")
    panels[0].set_ylabel("capture rate")
    handles, labels = panels[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside lower center", ncols=4, frameon=False)
    figure.savefig(path, dpi=150)


def main() -> None:
    """Play missing races; write their numbers, the tables and the figure."""
    parser = script_parser(__doc__, quick="a small world and two seeds", cluster=True)
    parser.add_argument("--seeds", type=int, help="races of each kind; default 10, or 2")
    parser.add_argument("--runs", type=Path, default=Path("runs/psro"))
    parser.add_argument("--results", type=Path, default=Path("psro"))
    parser.add_argument("--threads", type=int, help="default: one for each core")
    args = parser.parse_args()
    base, few = (FULL.changed(QUICK), 2) if args.quick else (FULL, 10)
    seeds = range(args.seeds or few)
    runs = finish_all(races(base, seeds), args.runs, threads=args.threads, where=args.cluster)
    states = States(base.world, threads=args.threads)
    found = {
        kind: [kept_numbers(runs[f"{place(kind)}/{seed}"], states) for seed in seeds]
        for kind in tqdm(KINDS, unit=" kinds", disable=None)
    }
    value = solve(states).value
    _, reached = at_budget(found)
    least = {
        kind: enclosure(runs[f"{place(kind)}/0"], states, int(reached[kind]["generation"][0]))
        for kind in KINDS
    }
    numbers = {"value": round(value, 6), "least": least, "races": found}
    args.results.mkdir(parents=True, exist_ok=True)
    path = args.results / "numbers.json"
    path.write_text(json.dumps(numbers, indent=1) + "\n", encoding="utf-8")
    # From the file, so that the table follows from the rounded numbers that are kept.
    text = table(json.loads(path.read_text(encoding="utf-8")))
    (args.results / "table.md").write_text(text + "\n", encoding="utf-8")
    print(text)
    draw(found, args.results / "curves.png")
    print(f"Written: numbers.json, table.md and curves.png in {args.results}")


if __name__ == "__main__":
    main()
