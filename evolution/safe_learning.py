"""Which pursuers capture without collisions? Prices, limits and masks, by gradients and evolution.

    python evolution/safe_learning.py             two variants, five seeds: an hour of one core
    python evolution/safe_learning.py --quick     a small world, two seeds: some seconds

Pursuers learn to surround an evader that moves at random, in -S (teammates may share a cell) and in
-SB (they bounce). Each method changes one thing of the same training: the penalty of a collision, a
limit of collisions, a mask of moves. Afterwards all archived generations play new episodes.

Methods: policy gradients with the clipped objective of PPO; a Lagrangian multiplier on costs (Ray,
Achiam and Amodei, 2019); evolution strategies (Salimans et al., 2017) on captures, and with
candidates within a limit first (Deb, 2000); masks of actions (Huang and Ontañón, 2022).

Look at the first figures of a row: a method is safe if it captures and does not collide. All
methods are compared at the same number of agent-steps. ``--results`` receives the numbers, the
table and a figure. Needs PyTorch.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import ArrayLike, NDArray

import matrixworld as mw
from common import finish_all, script_parser
from matrixworld import colors
from matrixworld.analysis import Estimate, interval_over_runs
from matrixworld.coevolution import SavedRun, SingleSettings
from matrixworld.rules import KINDS

LIMIT = 20.0
"""Collisions at fault per 1000 agent-steps that the limited methods may have."""
FIRST_TEST_SEED = 10**6
"""Test episodes have seeds of their own; those of training are hashes."""

Changes = dict[str, Any]
Numbers = Mapping[str, NDArray[Any]]

FREE: Changes = {"collision_penalty": 0.0}
GRADIENTS: dict[str, Changes] = {
    "no penalty": FREE,
    "penalty 12, as in the paper": {},
    "penalty 1": {"collision_penalty": 1.0},
    "limit, by a multiplier": {**FREE, "cost_limit": LIMIT},
    "mask of obstacles": {**FREE, "mask": "obstacles"},
    "mask of occupied cells": {**FREE, "mask": "occupied"},
    "mask of occupied cells, and limit": {**FREE, "mask": "occupied", "cost_limit": LIMIT},
}
EVOLUTION: dict[str, Changes] = {
    "captures": {},
    "rewards with penalty 1": {"fitness": "rewards", "collision_penalty": 1.0},
    "captures within a limit": {"cost_limit": LIMIT},
    "captures, mask of occupied cells": {"mask": "occupied"},
    "captures within a limit, mask of occupied cells": {"mask": "occupied", "cost_limit": LIMIT},
}
PENALTIES = {
    "gradients: no penalty": colors.INK,
    "gradients: penalty 1": colors.ORANGE,
    "gradients: penalty 12, as in the paper": colors.VERMILLION,
}
"""Methods whose training is drawn, and their colours."""
NOTHING, TWELVE, ONE, WALLS, OCCUPIED, LIMITED, BOTH = (
    colors.INK, colors.VERMILLION, colors.ORANGE, colors.SKY_BLUE, colors.GREEN, colors.BLUE,
    colors.PURPLE,
)  # fmt: skip
STYLES = [
    *(
        {"color": color, "marker": "o"}
        for color in (NOTHING, TWELVE, ONE, LIMITED, WALLS, OCCUPIED, BOTH)
    ),
    *(
        {"color": color, "marker": "s", "fillstyle": "none"}
        for color in (NOTHING, ONE, LIMITED, OCCUPIED, BOTH)
    ),
]
"""Marks of the methods: filled for gradients, hollow for evolution."""


@dataclass(frozen=True)
class Plan:
    """Trainings and tests, and their sizes.

    Parameters
    ----------
    gradients, evolution : SingleSettings
        Training by gradients and by evolution, which the methods change.
    variants : tuple of str
        Variants of the game.
    seeds : int
        Number of training seeds, from 0.
    episodes : int
        Test episodes of each archived generation.
    """

    gradients: SingleSettings
    evolution: SingleSettings
    variants: tuple[str, ...]
    seeds: int
    episodes: int

    def trainings(self) -> dict[str, SingleSettings]:
        """Return the settings of each method by its name, in the first variant and seed."""
        bases = {
            "gradients": (self.gradients, GRADIENTS),
            "evolution": (self.evolution, EVOLUTION),
        }
        return {
            f"{kind}: {name}": replace(base, **changes)
            for kind, (base, methods) in bases.items()
            for name, changes in methods.items()
        }


WORLD: Changes = {
    "variant": "SB", "rows": 8, "cols": 8, "pursuers": 6, "evaders": 1, "fov": 7,
    "train_steps": 60, "eval_steps": 60, "team": "pursuer", "hidden": (64,),
}  # fmt: skip
FULL = Plan(
    SingleSettings(
        **WORLD, learner="actor-critic", population=16, epochs=400, archive_every=20, clip=0.2,
        actor_updates=4, actor_rate=1e-3, critic_rate=2e-3, discount=0.95,
    ),
    SingleSettings(**WORLD, population=32, epochs=200, archive_every=10),
    variants=("S", "SB"),
    seeds=5,
    episodes=200,
)  # fmt: skip
QUICK = Plan(
    replace(
        FULL.gradients, rows=5, cols=5, pursuers=3, fov=5, hidden=(8,), train_steps=10,
        eval_steps=12, population=4, epochs=4, archive_every=2,
    ),
    replace(
        FULL.evolution, rows=5, cols=5, pursuers=3, fov=5, hidden=(8,), train_steps=10,
        eval_steps=12, population=4, epochs=4, archive_every=2,
    ),
    variants=("S", "SB"),
    seeds=2,
    episodes=5,
)  # fmt: skip


def play(plan: Plan, seeds: range, root: Path, where: str | None) -> dict[str, list[SavedRun]]:
    """Return the runs of each variant and method, one for each seed; play the missing ones."""
    settings = {
        f"{variant}-{slug(name)}/{seed}": replace(base, variant=variant, seed=seed)
        # All methods of a seed, then the next seed: what is interrupted compares equals.
        for seed in seeds
        for variant in plan.variants
        for name, base in plan.trainings().items()
    }
    runs = finish_all(settings, root, where=where)
    return {
        f"{variant} {name}": [runs[f"{variant}-{slug(name)}/{seed}"] for seed in seeds]
        for variant in plan.variants
        for name in plan.trainings()
    }


def slug(name: str) -> str:
    """Return a name as the name of a directory."""
    return "-".join(word.strip(":,") for word in name.split())


def measured(runs: Mapping[str, list[SavedRun]], episodes: int) -> dict[str, NDArray[Any]]:
    """Return the numbers of all runs.

    Parameters
    ----------
    runs : mapping of str to list of SavedRun
        Runs of each variant and method, one for each seed.
    episodes : int
        Test episodes of each archived generation.

    Returns
    -------
    dict of str to ndarray
        By ``"<variant> <method> / <number>"``, arrays over seeds and archived generations:
        ``agent-steps`` and ``collisions`` of the pursuers in training until then, (seeds,
        generations), the ``capture rate`` in the test, (seeds, generations), and agent-steps at
        ``fault`` per 1000 in the test, (seeds, generations, kinds).
    """
    return {
        f"{name} / {key}": np.stack([each[key] for each in of_seeds])
        for name, of_seeds in (
            (name, [of_run(run, episodes) for run in each]) for name, each in runs.items()
        )
        for key in of_seeds[0]
    }


def of_run(run: SavedRun, episodes: int) -> dict[str, NDArray[Any]]:
    """Return the numbers of one run; see `measured`."""
    settings, log = run.settings, run.files.log()
    assert isinstance(settings, SingleSettings)
    # Here no agent disappears: each world step is one step of all pursuers.
    steps = settings.pursuers * np.concatenate([[0], log["steps"]])
    collisions = np.concatenate([[0.0], np.cumsum(log["pursuer_faults"]) * settings.population])
    ends = np.minimum(
        np.arange(len(run.teams["pursuer"].genomes)) * settings.archive_every, settings.epochs
    )
    captures, faults = tested(run, episodes)
    return {
        "agent-steps": steps[ends],
        "collisions": collisions[ends],
        "capture rate": captures,
        "fault": faults,
    }


def tested(run: SavedRun, episodes: int) -> tuple[NDArray[Any], NDArray[Any]]:
    """Return capture rates and faults by kind of all generations, in the same new episodes."""
    settings, own = run.settings, run.teams["pursuer"]
    generations = np.arange(len(own.genomes))
    played = mw.rollout(
        settings.world(settings.eval_steps),
        own,
        settings.against,
        mw.Matches.of(generations, 0, FIRST_TEST_SEED),
        worlds=episodes,
    )
    monitors = [mw.SafetyMonitor() for _ in generations]
    fields = (played.collisions, played.faults, played.agent_steps, played.capture_rate)
    for generation, monitor in enumerate(monitors):
        monitor.add(*(each[generation] for each in fields))
    summaries = [monitor.summary() for monitor in monitors]
    captures = np.array([summary.capture_rate for summary in summaries])
    return captures, np.array([summary.fault_rate[0] for summary in summaries])


def names_of(numbers: Numbers) -> list[str]:
    """Return the variants and methods of the numbers, in their order."""
    return list(dict.fromkeys(key.split(" / ")[0] for key in numbers))


def variants_of(numbers: Numbers) -> list[str]:
    """Return the variants of the numbers."""
    return list(dict.fromkeys(name.split()[0] for name in names_of(numbers)))


def methods_of(numbers: Numbers, variant: str) -> list[str]:
    """Return those of `names_of` that belong to a variant."""
    return [name for name in names_of(numbers) if name.startswith(f"{variant} ")]


def budget_of(numbers: Numbers) -> int:
    """Return the largest number of agent-steps that all runs have played."""
    return int(min(numbers[f"{name} / agent-steps"][:, -1].min() for name in names_of(numbers)))


def at_budget(numbers: Numbers, name: str) -> dict[str, NDArray[Any]]:
    """Return the numbers of a method at the last generation within the budget, (seeds, ...)."""
    steps = numbers[f"{name} / agent-steps"]
    last = (steps <= budget_of(numbers)).sum(axis=1) - 1
    seeds = np.arange(len(steps))
    faults = numbers[f"{name} / fault"][seeds, last]
    return {
        "capture rate": numbers[f"{name} / capture rate"][seeds, last],
        "all": faults.sum(axis=1),
        **{kind: faults[:, k] for k, kind in enumerate(KINDS)},
        "training": 1000 * numbers[f"{name} / collisions"][seeds, last] / steps[seeds, last],
    }


def table(numbers: Numbers) -> str:
    """Return the comparison of the methods at equal agent-steps as tables in Markdown."""
    parts = [
        f"After at most {budget_of(numbers):,} agent-steps of the pursuers in training. Collisions "
        "at fault per 1000 agent-steps.\nMean over "
        f"{len(next(iter(numbers.values())))} seeds [95% interval]."
    ]
    for variant in variants_of(numbers):
        lines = [
            f"| -{variant} | capture rate | collisions | obstacle | teammate | adversary "
            "| collisions in training |",
            "|---" * 7 + "|",
        ]
        for name in methods_of(numbers, variant):
            cells = [
                shown(values, 2 if key == "capture rate" else 1)
                for key, values in at_budget(numbers, name).items()
            ]
            lines.append(f"| {' | '.join([name.removeprefix(f'{variant} '), *cells])} |")
        parts.append("\n".join(lines))
    return "\n\n".join(parts)


def shown(values: ArrayLike, digits: int) -> str:
    """Return a mean over seeds, with its interval if the seeds differ."""
    most = 1.0 if digits == 2 else 1000.0 * len(KINDS)
    found = interval_over_runs(values, bounds=(0.0, most))
    if found.low is None:
        return f"{found.value:.{digits}f}"
    return f"{found.value:.{digits}f} [{found.low:.{digits}f}, {found.high:.{digits}f}]"


def training_figure(numbers: Numbers) -> Figure:
    """Draw capture rate and collisions by kind while training, for each penalty."""
    variants = variants_of(numbers)
    drawn = Figure(figsize=(14.0, 3.4 * len(variants)), dpi=120, layout="constrained")
    panels = drawn.subplots(len(variants), 1 + len(PENALTIES), squeeze=False)
    for variant, (captures, *faults) in zip(variants, panels, strict=True):
        captures.set(title=f"-{variant}: capture rate", ylim=(-0.02, 1.02))
        for (method, color), axes in zip(PENALTIES.items(), faults, strict=True):
            name, label = f"{variant} {method}", method.partition(": ")[2]
            curve(captures, numbers, name, "capture rate", color=color, label=label)
            axes.set_title(f"-{variant}, {label}: collisions")
            for k, (kind, of_kind) in enumerate(zip(KINDS, colors.CONFLICTS, strict=True)):
                curve(axes, numbers, name, "fault", k, color=of_kind, label=kind)
            axes.sharey(faults[0])
    for axes in panels.flat:
        axes.set_xlabel("thousand agent-steps")
        axes.grid(color=colors.GRID)
        axes.legend()
    return drawn


def methods_figure(numbers: Numbers) -> Figure:
    """Draw captures over collisions of all methods at equal agent-steps, with intervals."""
    variants = variants_of(numbers)
    drawn = Figure(figsize=(6.0 * len(variants) + 3.0, 5.0), dpi=120, layout="constrained")
    panels = drawn.subplots(1, len(variants), squeeze=False, sharey=True)[0]
    for variant, axes in zip(variants, panels, strict=True):
        axes.axvline(LIMIT, color=colors.MUTED, linestyle=":", label=f"limit of {LIMIT:g}")
        for name, style in zip(methods_of(numbers, variant), STYLES, strict=False):
            found = at_budget(numbers, name)
            x, y = (interval_over_runs(found[key]) for key in ("all", "capture rate"))
            axes.errorbar(
                x.value, y.value, xerr=reach(x), yerr=reach(y), capsize=2, markersize=8,
                label=name.removeprefix(f"{variant} "), **style,
            )  # fmt: skip
        axes.set_xscale("symlog", linthresh=1.0)
        axes.set(title=f"-{variant}", xlabel="collisions at fault per 1000 agent-steps")
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
    steps, values = numbers[f"{name} / agent-steps"] / 1000.0, numbers[f"{name} / {number}"]
    values = values if kind is None else values[..., kind]
    # Seeds have played different numbers of steps: the mean is over equal ones.
    grid = np.linspace(0.0, steps[:, -1].min(), 60)
    seeds = [np.interp(grid, x, y) for x, y in zip(steps, values, strict=True)]
    axes.plot(grid, np.mean(seeds, axis=0), **style)
    low, high = np.min(seeds, axis=0), np.max(seeds, axis=0)
    axes.fill_between(grid, low, high, color=style["color"], alpha=0.12, linewidth=0)


def main() -> None:
    """Play missing runs; print and write the comparison, and draw it."""
    parser = script_parser(__doc__, quick="a small world and two seeds", cluster=True)
    parser.add_argument("--seeds", type=int, help="runs of each method; default 5, or 2")
    parser.add_argument("--runs", type=Path, default=Path("runs/safe_learning"))
    parser.add_argument("--results", type=Path, default=Path("safe_learning"))
    args = parser.parse_args()
    plan, few = (QUICK, 2) if args.quick else (FULL, 5)
    runs = play(plan, range(args.seeds or few), args.runs, args.cluster)
    numbers = measured(runs, plan.episodes)
    text = table(numbers)
    print(text)
    args.results.mkdir(parents=True, exist_ok=True)
    (args.results / "table.md").write_text(text + "\n", encoding="utf-8")
    np.savez_compressed(args.results / "numbers.npz", **numbers)
    training_figure(numbers).savefig(args.results / "training.png")
    methods_figure(numbers).savefig(args.results / "methods.png")
    print(f"\nWritten: table.md, numbers.npz, training.png and methods.png in {args.results}")


if __name__ == "__main__":
    main()
