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
with p-values that are adjusted for the number of its differences (Holm). Needs PyTorch.
"""

from __future__ import annotations

from typing import Any

import numpy as np
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
from matrixworld.world.rules import COLLISION_KINDS
from safe_runs import FEW_SEEDS, budget, kinds, long_test, of_run, seeds

EVOLVED = " evolution: "
LONG_TEST = 1e7
"""Steps of pursuers with right of way in the test of all their last generations."""
HEADS = (
    "capture rate", "steps", "collisions", *COLLISION_KINDS, "while training", "million steps",
)  # fmt: skip
FREELY, LIMIT_ALONE = "gradients: no penalty", "gradients: limit, by a multiplier"
WALLED, MASKED = "gradients: mask of obstacles", "gradients: right of way"
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
        parts.append(markdown([variant, *HEADS], rows))
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
        ["difference of", "between", *variants],
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
    experiment(__doc__, kinds=kinds, measure=measured, table=table, seeds=seeds())
