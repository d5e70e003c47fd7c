"""Which pursuers capture without collisions? Prices, limits and masks, by gradients and evolution.

    python evolution/safe_learning.py             two variants, ten seeds: an hour of one core
    python evolution/safe_learning.py --quick     a small world, two seeds: some seconds

Pursuers learn to surround an evader that moves at random, in S (teammates may share a cell) and in
SB (they bounce). Each method changes one thing of the same training: the penalty of a collision, a
limit of collisions, a mask of moves. Afterwards all archived generations play new episodes.

Methods: policy gradients with the clipped objective of PPO; a Lagrangian multiplier on costs (Ray,
Achiam and Amodei, 2019); evolution strategies (Salimans et al., 2017) on captures, and with
candidates within a limit first (Deb, 2000); masks of actions (Huang and Ontañón, 2022).

Look at the first figures of a row: a method is safe if it captures and does not collide. All
methods are compared at the same number of agent-steps. The last table compares pairs of methods,
with p-values that are adjusted for the number of its differences (Holm). ``--results`` receives the
numbers, the tables and two figures. Needs PyTorch.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from common import (
    SIGNIFICANCE,
    Numbers,
    Runs,
    adjusted,
    by_seed,
    experiment,
    kinds_in,
    markdown,
    mean,
    shown_p,
)
from matrixworld._util import colors
from matrixworld.analysis import Estimate, interval_over_runs
from matrixworld.world.rules import COLLISION_KINDS
from safe_runs import FEW_SEEDS, LIMIT, budget, kinds, long_test, of_run, seeds

EVOLVED = " evolution: "
LONG_TEST = 1e7
"""Steps of pursuers with right of way in the test of all their last generations."""
HEADS = (
    "capture rate", "steps", "collisions", *COLLISION_KINDS, "while training", "million steps",
)  # fmt: skip
NOTHING, TWELVE, ONE, LIMITED, WALLS, WAYS = (
    colors.INK, colors.VERMILLION, colors.PURPLE, colors.BLUE, colors.SKY_BLUE, colors.GREEN,
)  # fmt: skip
FREELY, LIMIT_ALONE = "gradients: no penalty", "gradients: limit, by a multiplier"
WALLED, MASKED = "gradients: mask of obstacles", "gradients: right of way"
DRAWN = {
    FREELY: NOTHING,
    "gradients: penalty 12, as in the paper": TWELVE,
    LIMIT_ALONE: LIMITED,
    MASKED: WAYS,
}
"""Methods whose training is drawn, and their colours."""
COMPARED = (
    ("capture rate", LIMIT_ALONE, FREELY),
    ("capture rate", MASKED, FREELY),
    ("capture rate", MASKED, LIMIT_ALONE),
    ("length", MASKED, FREELY),
    ("length", MASKED, WALLED),
    ("training", WALLED, FREELY),
)
"""A number of `judged` and two methods: the first one minus the second one is tested."""
NUMBERS = {
    "capture rate": "capture rate",
    "length": "steps",
    "all": "collisions",
    "training": "collisions while training",
}
STYLES = [
    *({"color": color, "marker": "o"} for color in (NOTHING, TWELVE, LIMITED, WALLS, WAYS)),
    *(
        {"color": color, "marker": "s", "fillstyle": "none"}
        for color in (NOTHING, ONE, LIMITED, WAYS)
    ),
]
"""Marks of the methods: filled for gradients, hollow for evolution."""


def variants_of(numbers: Numbers) -> list[str]:
    """Return the variants of the numbers."""
    return list(dict.fromkeys(name.split()[0] for name in kinds_in(numbers)))


def methods_of(numbers: Numbers, variant: str) -> list[str]:
    """Return the names of a variant and each of its methods."""
    return [name for name in kinds_in(numbers) if name.startswith(f"{variant} ")]


def within(numbers: Numbers, variant: str) -> list[str]:
    """Return the methods of a variant that archive a trained generation within the budget."""
    budget = float(numbers["budget"])
    names = methods_of(numbers, variant)
    return [name for name in names if numbers[f"{name} / agent-steps"][:, 1].max() <= budget]


def judged(numbers: Numbers, name: str, *, budget: float) -> dict[str, NDArray[Any]]:
    """Return the numbers of a method at its last generation within a budget, (seeds,) each."""
    steps = numbers[f"{name} / agent-steps"]
    last = np.arange(len(steps)), (steps <= budget).sum(axis=1) - 1
    faults = numbers[f"{name} / fault"][last]
    return {
        "capture rate": numbers[f"{name} / capture rate"][last],
        "length": numbers[f"{name} / length"][last],
        "all": faults.sum(axis=1),
        **dict(zip(COLLISION_KINDS, faults.T, strict=True)),
        "training": 1000 * numbers[f"{name} / collisions"][last] / steps[last],
        "agent-steps": steps[last] / 1e6,
    }


def table(numbers: Numbers) -> str:
    """Return the comparison of the methods as a table in Markdown for each variant."""
    budget = float(numbers["budget"])
    count = len(numbers[f"{kinds_in(numbers)[0]} / capture rate"])
    parts = [
        f"Collisions at fault per 1000 agent-steps of the pursuers: in the test, by kind, and in "
        f"training so far.\nAll methods after at most {budget / 1e6:.4g} million agent-steps of "
        f"training; evolution at its end as well.\nMean over {count} seeds, at most {FEW_SEEDS} "
        "with a penalty, a limit or 16 times the matches [95% interval]."
    ]
    for variant in variants_of(numbers):
        names = methods_of(numbers, variant)
        rows = [
            *(row(numbers, name, name.removeprefix(f"{variant} "), budget)
              for name in within(numbers, variant)),
            *(row(numbers, name, f"{name.removeprefix(f'{variant} ')}, at the end", np.inf)
              for name in names if EVOLVED in name),
        ]  # fmt: skip
        parts.append(markdown([f"{variant}", *HEADS], rows))
    steps, faults = numbers["long test"]
    tested = (
        f"With right of way, pursuers were at fault {faults:,} times in {steps:,} agent-steps of "
        "the last generations of all seeds."
    )
    return "\n\n".join([*parts, comparisons(numbers), tested])


def comparisons(numbers: Numbers) -> str:
    """Return the differences of `COMPARED` in each variant as a table in Markdown."""
    budget, variants = float(numbers["budget"]), variants_of(numbers)
    found = {}
    for row in COMPARED:
        number, *methods = row
        for variant in variants:
            names = (f"{variant} {method}" for method in methods)
            # Pairs of the same seed: both teams start with the same genome.
            one, other = (judged(numbers, name, budget=budget)[number] for name in names)
            both = min(len(one), len(other))
            found[row, variant] = one[:both] - other[:both]
    p_values = adjusted(found)

    def cell(row: tuple[str, str, str], variant: str) -> str:
        p, digits = p_values[row, variant], 2 if row[0] == "capture rate" else 1
        unknown = "; **cannot tell**" if p > SIGNIFICANCE else ""
        return f"{mean(found[row, variant], digits, '+')}; {shown_p(p)}{unknown}"

    return markdown(
        ["difference of", "between", *(f"{variant}" for variant in variants)],
        [
            [NUMBERS[row[0]], f"{row[1]}, minus {row[2]}", *(cell(row, v) for v in variants)]
            for row in COMPARED
        ],
    )


def row(numbers: Numbers, name: str, label: str, budget: float) -> list[str]:
    """Return a line of the table."""
    found, positive = judged(numbers, name, budget=budget), (0.0, np.inf)
    return [
        label,
        mean(found["capture rate"], bounds=(0.0, 1.0)),
        *(mean(found[number], 1, bounds=positive) for number in ("length", "all")),
        *(f"{found[kind].mean():.1f}" for kind in COLLISION_KINDS),
        mean(found["training"], 1, bounds=positive),
        f"{found['agent-steps'].mean():.2f}",
    ]


def training_figure(numbers: Numbers) -> Figure:
    """Draw capture rate and collisions by kind while training, for some methods."""
    variants = variants_of(numbers)
    drawn = Figure(figsize=(16.0, 3.5 * len(variants)), dpi=120, layout="constrained")
    panels = drawn.subplots(len(variants), 1 + len(DRAWN), squeeze=False, sharex=True)
    for variant, (captures, *faults) in zip(variants, panels, strict=True):
        captures.set(title=f"{variant}", ylabel="capture rate", ylim=(-0.02, 1.02))
        for (method, color), axes in zip(DRAWN.items(), faults, strict=True):
            name, label = f"{variant} {method}", method.partition(": ")[2]
            curve(captures, numbers, name, "capture rate", color=color, label=label)
            axes.set_title(f"{variant}: {label}", color=color, fontsize="medium")
            for k, (kind, of_kind) in enumerate(
                zip(COLLISION_KINDS, colors.CONFLICTS, strict=True)
            ):
                curve(axes, numbers, name, "fault", k, color=of_kind, label=kind)
            axes.set_yscale("symlog", linthresh=10.0)
            axes.set_ylim(0.0, 1000.0)
        faults[0].set_ylabel("collisions at fault per 1000 agent-steps")
        for axes in faults[1:]:
            axes.tick_params(labelleft=False)
    for axes in panels.flat:
        axes.grid(color=colors.GRID)
    for axes in panels[-1]:
        axes.set_xlabel("million agent-steps of training")
    panels[0, 1].legend(loc="lower right")
    return drawn


def methods_figure(numbers: Numbers) -> Figure:
    """Draw captures over collisions of all methods within the budget, with intervals."""
    variants = variants_of(numbers)
    drawn = Figure(figsize=(6.0 * len(variants) + 3.0, 5.0), dpi=120, layout="constrained")
    panels = drawn.subplots(1, len(variants), squeeze=False, sharey=True)[0]
    for variant, axes in zip(variants, panels, strict=True):
        axes.axvline(LIMIT, color=colors.MUTED, linestyle=":", label=f"limit of {LIMIT:g}")
        for name, style in zip(within(numbers, variant), STYLES, strict=False):
            found = judged(numbers, name, budget=float(numbers["budget"]))
            x = interval_over_runs(found["all"], bounds=(0.0, np.inf))
            y = interval_over_runs(found["capture rate"], bounds=(0.0, 1.0))
            axes.errorbar(
                x.value, y.value, xerr=reach(x), yerr=reach(y), capsize=2, markersize=8,
                label=name.removeprefix(f"{variant} "), **style,
            )  # fmt: skip
        axes.set_xscale("symlog", linthresh=1.0)
        axes.set(title=f"{variant}", xlabel="collisions at fault per 1000 agent-steps")
        axes.set(ylim=(-0.02, 1.02), xlim=(-0.2, 3000.0))
        axes.grid(color=colors.GRID)
    panels[0].set_ylabel("capture rate")
    drawn.legend(*panels[0].get_legend_handles_labels(), loc="outside right center")
    return drawn


def reach(found: Estimate) -> list[list[float]] | None:
    """Return how far an interval reaches from its mean, as Matplotlib takes it."""
    if found.low is None or found.high is None:
        return None
    return [[found.value - found.low], [found.high - found.value]]


def curve(
    axes: Axes, numbers: Numbers, name: str, number: str, kind: int | None = None, **style: Any
) -> None:
    """Draw the mean of a number over seeds, and its range, over agent-steps of training."""
    steps, values = numbers[f"{name} / agent-steps"] / 1e6, numbers[f"{name} / {number}"]
    values = values if kind is None else values[..., kind]
    # Seeds have played different numbers of steps: the mean is over equal ones.
    grid = np.linspace(0.0, steps[:, -1].min(), 60)
    seeds = [np.interp(grid, x, y) for x, y in zip(steps, values, strict=True)]
    axes.plot(grid, np.mean(seeds, axis=0), **style)
    low, high = np.min(seeds, axis=0), np.max(seeds, axis=0)
    axes.fill_between(grid, low, high, color=style["color"], alpha=0.12, linewidth=0)


def measured(runs: Runs, quick: bool) -> dict[str, Any]:
    """Return numbers of all runs, the budget, and the ``long test``.

    It has the steps of masked pursuers, and how many of them were at fault.
    """
    masked = [run for name, each in runs.items() if name.endswith("right of way") for run in each]
    share = (1e4 if quick else LONG_TEST) / max(1, len(masked))
    tests = [long_test(run, share) for run in masked]
    return {
        **by_seed(runs, lambda run: of_run(run, quick)),
        "budget": budget(quick),
        "long test": np.sum(tests or [(0, 0)], axis=0),
    }


if __name__ == "__main__":
    figures = {"training.png": training_figure, "methods.png": methods_figure}
    experiment(__doc__, kinds=kinds, measure=measured, table=table, seeds=seeds(), figures=figures)
