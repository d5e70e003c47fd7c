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

from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import ArrayLike, NDArray

import matrixworld as mw
from common import (
    SAME_STEPS,
    SIGNIFICANCE,
    Numbers,
    Runs,
    adjusted,
    by_seed,
    experiment,
    kept,
    kinds_in,
    markdown,
    mean,
    shown_p,
)
from matrixworld import analysis
from matrixworld._util import colors
from matrixworld._util.files import load_toml
from matrixworld.coevolution import TEAMS, RaceSettings, SavedRun
from matrixworld.solve import States, guarantees, mixture_bounds, solve

FULL = RaceSettings.of(load_toml(Path(__file__).with_name("small_world.toml"))).changed({
    **SAME_STEPS, "policy.hidden": [32], "learner.population": 24, "evaluation_episodes": 64,
    "schedule.generations": 12, "schedule.pursuer_epochs": 20, "schedule.evader_epochs": 20,
})  # fmt: skip
QUICK = {
    "world.rows": 4, "world.cols": 4, "learner.population": 8, "evaluation_episodes": 8,
    "schedule.generations": 3, "schedule.pursuer_epochs": 3, "schedule.evader_epochs": 3,
}  # fmt: skip
# A match is 16 episodes here, so that 2 matches of each pair are 32.
META = {f"schedule.{team}s_meet.episodes": 2 for team in TEAMS}


def meeting(sampler: str) -> dict[str, Any]:
    """Return changes by which both teams, in turns, meet opponents of a sampler."""
    return {"schedule": "alternating", **{f"schedule.{team}s_meet": sampler for team in TEAMS}}


GENERALISTS, HALLS = "generalists", "halls of fame"
KINDS = {
    GENERALISTS: {"schedule": "generalist-generalist"},
    "random past opponents": meeting("uniform"),
    HALLS: {"schedule": "hall-of-fame"},
    "MaxSolve": meeting("maxsolve"),
    "LAPCA": meeting("lapca"),
    "PSRO, Nash": {**meeting("nash"), **META},
    "PSRO, replicators": {**meeting("prd"), **META},
    "PSRO, rectified": {**meeting("rectified"), **META},
}

CURVES = {
    "newest": "NashConv of the newest generations",
    "mixture": "NashConv of the mixtures, at most",
    "population": "population exploitability",
}
TABLED = ("newest", "mixture")
"""Curves that are compared. The equilibrium of all generations of a race has a population
exploitability of 0, whatever the race: it tells in the course of a race only."""


def kinds(quick: bool) -> dict[str, RaceSettings]:
    """Return the settings of each kind of race."""
    return races(FULL.changed(QUICK if quick else {}), KINDS)


def races(base: RaceSettings, kinds: Mapping[str, Mapping[str, Any]]) -> dict[str, RaceSettings]:
    """Return what the kinds change in races of a base."""
    schedule = base.schedule
    # With two contemporaries and one of the hall, an epoch of both teams is two of each.
    joint = max(1, (schedule.pursuer_epochs + schedule.evader_epochs) // 4)
    sizes = {"schedule.generations": schedule.generations, "schedule.joint_epochs": joint}
    return {
        kind: base.changed({**changes, **(sizes if kind == HALLS else {})})
        for kind, changes in kinds.items()
    }


# Numbers of a race


def mixtures(matrix: NDArray[np.float64], k: int) -> list[NDArray[np.float64]]:
    """Return the equilibrium of the generations up to k, as weights of all generations."""
    nash = analysis.nash_averaging(matrix[: k + 1, : k + 1])
    rest = np.zeros(len(matrix) - k - 1)
    return [np.append(weights, rest) for weights in (nash.pursuers, nash.evaders)]


@cache
def states_of(world: mw.WorldConfig) -> States:
    """Return the states of a world, which all races in it share."""
    return States(world)


def measured(runs: Runs, quick: bool) -> dict[str, Any]:
    """Return the numbers of all races, the value, and `enclosure` of those of the first seed.

    A file beside a run keeps its numbers for the next call.
    """
    every = [run for each in runs.values() for run in each]
    states = states_of(every[0].settings.world)
    budget = min(int(run.log()["matches"].max()) for run in every)
    return {
        **by_seed(runs, lambda run: kept(run.path.with_suffix(".json"), lambda: numbers_of(run))),
        "value": solve(states).value,
        **{
            f"least of {kind}": enclosure(each[0], states, each[0].generation_at("evader", budget))
            for kind, each in runs.items()
        },
    }


def numbers_of(run: SavedRun) -> dict[str, Any]:
    """Return numbers of a race for each generation from 1, and agent-steps a match."""
    matrix, log = run.payoff().capture_rate, run.log()
    short = guarantees(states_of(run.settings.world), run.teams).exploitability
    generations = range(1, len(matrix))
    weights = [mixtures(matrix, k) for k in generations]
    matches = [int(log["matches"][log["generation"] == k].max()) for k in generations]
    return {
        "matches": matches,
        "newest": [float(sum(short[team][k] for team in TEAMS)) for k in generations],
        "mixture": [
            float(sum(w @ short[team] for w, team in zip(of_k, TEAMS, strict=True)))
            for of_k in weights
        ],
        "population": [analysis.exploitability(matrix, *of_k).total for of_k in weights],
        "agent_steps": run.summary()["training_agent_steps"] / matches[-1],
    }


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


Reached = Mapping[str, Mapping[str, NDArray[Any]]]
"""Kind -> name -> a number of each seed."""


def at_budget(numbers: Numbers) -> tuple[int, Reached]:
    """Return the budget, and the numbers of all seeds of each kind within it."""
    kinds = kinds_in(numbers)
    budget = min(int(numbers[f"{kind} / matches"][:, -1].min()) for kind in kinds)
    found = {}
    for kind in kinds:
        ends = (numbers[f"{kind} / matches"] <= budget).sum(axis=1) - 1
        seeds = np.arange(len(ends))
        found[kind] = {
            **{name: numbers[f"{kind} / {name}"][seeds, ends] for name in CURVES},
            "generation": 1 + ends,
            "agent_steps": numbers[f"{kind} / agent_steps"],
        }
    return budget, found


def differences(reached: Reached, labels: Mapping[str, str]) -> str:
    """Return the differences of all kinds from generalists as a table in Markdown."""
    # Pairs of the same seed: both races start with the same genomes.
    found = {
        (kind, name): each[name] - reached[GENERALISTS][name]
        for kind, each in reached.items()
        for name in labels
        if kind != GENERALISTS
    }
    rows: dict[str, list[str]] = {}
    for (kind, name), p in adjusted(found).items():
        lower = found[kind, name].mean() < 0.0
        verdict = "cannot tell" if p > SIGNIFICANCE else "lower" if lower else "higher"
        cells = [mean(found[kind, name], sign="+"), f"{shown_p(p)}, {verdict}"]
        rows.setdefault(kind, [kind]).extend(cells)
    heads = ["race", *(head for label in labels.values() for head in (label, "Holm"))]
    return f"Differences from generalists of the same seed:\n\n{markdown(heads, rows.values())}"


def table(numbers: Numbers) -> str:
    """Return the comparison of all kinds of race as tables in Markdown."""
    budget, reached = at_budget(numbers)
    rows = [
        [
            kind,
            f"{each['generation'].mean():.1f}",
            f"{each['agent_steps'].mean():.1f}",
            *(mean(each[name]) for name in TABLED),
        ]
        for kind, each in reached.items()
    ]
    width = max(
        float(each["mixture"][0] - numbers[f"least of {kind}"]) for kind, each in reached.items()
    )
    heads = ["race", "generations", "agent-steps a match", *(CURVES[name] for name in TABLED)]
    parts = [
        f"After {budget:,} matches; means over {len(reached[GENERALISTS]['newest'])} seeds [95 %]. "
        f"The value is {numbers['value']:.3f}.",
        markdown(heads, rows),
        differences(reached, {name: CURVES[name] for name in TABLED}),
        f"In the races of the first seed the bound of the mixtures is at most {width:.4f} "
        "above what an opponent gains that is told nothing.",
    ]
    return "\n\n".join(parts)


DASHES = {
    "random past opponents": "--",
    HALLS: ":",
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


def figure(numbers: Numbers) -> Figure:
    """Draw the mean curves of all kinds over the matches; of some the interval over seeds."""
    drawn, panels = plt.subplots(1, 3, figsize=(11.0, 3.6), layout="constrained", sharex=True)
    for (name, label), axes in zip(CURVES.items(), panels, strict=True):
        for kind in kinds_in(numbers):
            matches = numbers[f"{kind} / matches"].mean(axis=0)
            draw_curve(axes, kind, matches, numbers[f"{kind} / {name}"])
        axes.set(title=label, xlabel="training matches")
    panels[0].set_ylabel("capture rate")
    handles, labels = panels[0].get_legend_handles_labels()
    drawn.legend(handles, labels, loc="outside lower center", ncols=4, frameon=False)
    return drawn


if __name__ == "__main__":
    figures = {"curves.png": figure}
    experiment(__doc__, kinds=kinds, measure=measured, table=table, seeds=10, figures=figures)
