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

from typing import Any, NamedTuple

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

import matrixworld as mw
from common import (
    FIRST_TEST_SEED,
    SIGNIFICANCE,
    SMALL_STEPS,
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
from matrixworld.coevolution import RaceSettings, SavedRun
from matrixworld.world.rules import COLLISION_KINDS

LIMIT = 20.0
"""Collisions at fault per 1000 agent-steps that the limited methods may have."""

SEEDS, FEW_SEEDS = 10, 5
"""Seeds of a method, and of those whose runs take longest."""

Changes = dict[str, Any]


class Method(NamedTuple):
    """What a method changes in the settings, and its seeds."""

    changes: Changes
    seeds: int = SEEDS


COST_LIMIT, MASK = "learner.cost_limit", "policy.mask"


def _penalty(size: float) -> Changes:
    """Return the change of the penalty for a collision at fault."""
    return {"world.rewards": mw.Rewards(pursuer_collide=-size, evader_collide=-size)}


FREE: Changes = _penalty(0.0)
# With a penalty or a limit most runs stand still, which takes long.
GRADIENTS: dict[str, Method] = {
    "no penalty": Method(FREE),
    "penalty 12, as in the paper": Method({}, FEW_SEEDS),
    "limit, by a multiplier": Method({**FREE, COST_LIMIT: LIMIT}, FEW_SEEDS),
    "mask of obstacles": Method({**FREE, MASK: "obstacles"}),
    "right of way": Method({**FREE, MASK: "right-of-way"}),
}
EVOLUTION: dict[str, Method] = {
    "captures": Method({}),
    "rewards with penalty 1": Method({"learner.measure": "rewards", **_penalty(1.0)}, FEW_SEEDS),
    "captures within a limit": Method({COST_LIMIT: LIMIT}, FEW_SEEDS),
    "captures, right of way": Method({MASK: "right-of-way"}),
    "rewards, right of way, 16 times the matches": Method({
        MASK: "right-of-way", "learner.measure": "rewards", "learner.population": 128,
        "match_episodes": 4, "learner.sigma": 0.3, "learner.learning_rate": 0.1,
    }, FEW_SEEDS),
}  # fmt: skip
METHODS = {
    f"{kind}: {name}": method
    for kind, methods in (("gradients", GRADIENTS), ("evolution", EVOLUTION))
    for name, method in methods.items()
}


WORLD: Changes = {
    "world.rules": "SB", "world.rows": 8, "world.cols": 8, "world.n_pursuers": 6,
    "world.n_evaders": 1, "world.fov": 7, "world.max_steps": 60, "train_steps": 60,
    "schedule.team": "pursuer", "policy.hidden": (32,),
}  # fmt: skip
BASES = {
    "gradients": RaceSettings.of({
        "schedule": "against", **WORLD, "schedule.epochs": 1200, "schedule.archive_every": 60,
        "learner": "actor-critic", "learner.population": 16, "learner.clip": 0.2,
        "learner.actor_updates": 4, "learner.critic_updates": 4, "learner.actor_rate": 1e-3,
        "learner.critic_rate": 2e-3, "learner.discount": 0.95,
    }),
    "evolution": RaceSettings.of({
        "schedule": "against", **WORLD, "schedule.epochs": 1500, "schedule.archive_every": 50,
        "learner.population": 32, **SMALL_STEPS["pursuer"],
    }),
}  # fmt: skip
"""Training by gradients and by evolution, which the methods change."""
TINY: Changes = {
    "world.rows": 5, "world.cols": 5, "world.n_pursuers": 3, "world.fov": 5, "world.max_steps": 12,
    "policy.hidden": (8,), "train_steps": 10, "learner.population": 4, "schedule.epochs": 4,
    "schedule.archive_every": 2,
}  # fmt: skip
VARIANTS = {False: ("S", "SB"), True: ("SB",)}
EPISODES = {False: 200, True: 5}
"""Variants of the game, and test episodes of each archived generation; with ``--quick`` or not."""

EVOLVED = " evolution: "
LONG_TEST = 1e7
"""Steps of pursuers with right of way in the test of all their last generations."""
HEADS = ("capture rate", "steps", "collisions", *COLLISION_KINDS, "while training", "million steps")
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


def kinds(quick: bool) -> dict[str, RaceSettings]:
    """Return the settings of each variant and method."""
    return {
        f"{variant} {name}": base_of(name, quick).changed(
            {**method.changes, "world.rules": variant}
        )
        for variant in VARIANTS[quick]
        for name, method in METHODS.items()
    }


def seeds() -> dict[str, int]:
    """Return the seeds of each variant and method."""
    return {
        f"{v} {name}": method.seeds for v in VARIANTS[False] for name, method in METHODS.items()
    }


def base_of(method: str, quick: bool) -> RaceSettings:
    """Return the training that a method changes."""
    base = BASES[method.partition(":")[0]]
    return base.changed(TINY) if quick else base


def budget(quick: bool) -> int:
    """Return the steps of all pursuers in a training by gradients, if no episode ends early."""
    one = base_of("gradients", quick)
    epochs = one.schedule.total_epochs("pursuer")
    return epochs * one.learner.population * one.game.train_steps * one.game.world.n_pursuers


def of_run(run: SavedRun, quick: bool) -> dict[str, NDArray[Any]]:
    """Return the numbers of a run over archived generations, untrained pursuers first.

    ``agent-steps`` and ``collisions`` of the pursuers in training until then; in the test the
    ``capture rate``, the mean ``length``, and agent-steps at ``fault`` per 1000 (generations,
    kinds).
    """
    settings, log = run.settings, run.log()
    schedule: Any = settings.schedule
    # Here no agent disappears: each world step is one step of all pursuers.
    steps = settings.game.world.n_pursuers * np.concatenate([[0], log["steps"]])
    episodes_played = settings.learner.population * settings.match_episodes
    collisions = np.concatenate([[0.0], np.cumsum(log["pursuer_faults"]) * episodes_played])
    ends = np.minimum(
        np.arange(len(run.teams["pursuer"].genomes)) * schedule.archive_every, schedule.epochs
    )
    captures, lengths, faults = tested(run, EPISODES[quick])
    return {
        "agent-steps": steps[ends],
        "collisions": collisions[ends],
        "capture rate": captures,
        "length": lengths,
        "fault": faults,
    }


def tested(run: SavedRun, episodes: int) -> tuple[NDArray[Any], NDArray[Any], NDArray[Any]]:
    """Return capture rates, lengths and faults by kind of all generations, in the same episodes."""
    settings, own = run.settings, run.teams["pursuer"]
    generations = np.arange(len(own.genomes))
    matches = mw.Matches.of(generations, 0, FIRST_TEST_SEED)
    played = mw.rollout(
        settings.game.world, own, settings.schedule.opponent, matches, episodes=episodes
    )
    steps = played.agent_steps[:, :, 0].sum(axis=1, keepdims=True)
    faults = 1000 * played.faults[:, :, 0].sum(axis=1) / steps
    return played.capture_rate.mean(axis=1), played.length.mean(axis=1), faults


def long_test(run: SavedRun, agent_steps: float) -> tuple[int, int]:
    """Return steps of pursuers, and how many of them were at fault, of the last generation.

    At least so many steps are played, in new episodes.
    """
    own, steps, faults, seed = run.teams["pursuer"], 0, 0, FIRST_TEST_SEED
    while steps < agent_steps:
        seed += 1
        match = mw.Matches.of(len(own.genomes) - 1, 0, seed)
        settings = run.settings
        played = mw.rollout(
            settings.game.world, own, settings.schedule.opponent, match, episodes=1000
        )
        steps += int(played.agent_steps[..., 0].sum())
        faults += int(played.faults[:, :, 0].sum())
    return steps, faults


# ---- Tables


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
        parts += [f"## `{variant}`", markdown(["method", *HEADS], rows)]
    steps, faults = numbers["long test"]
    tested = (
        f"With right of way, pursuers were at fault {faults:,} times in {steps:,} agent-steps of "
        "the last generations of all seeds."
    )
    return "\n\n".join([*parts, "## Differences", comparisons(numbers), tested])


def figure(numbers: Numbers) -> Figure:
    """Draw captures and collisions of the methods by policy gradients in S, a dot for each seed."""
    names = [name for name in within(numbers, "S") if name.startswith("S gradients: ")]
    found = Figure(figsize=(8, 2.4), layout="constrained")
    heads = {"capture rate": "share of captured evaders", "all": "collisions per 1000 agent-steps"}
    for axis, (number, head) in zip(found.subplots(1, 2, sharey=True), heads.items(), strict=True):
        for name in reversed(names):
            values = judged(numbers, name, budget=float(numbers["budget"]))[number]
            label = name.removeprefix("S gradients: ")
            color = "tab:blue" if label == "right of way" else "tab:gray"
            axis.plot(values, [label] * len(values), "o", color=color, alpha=0.5, clip_on=False)
        axis.set_title(head, fontsize=10)
        axis.spines[["top", "right"]].set_visible(False)
        axis.set_xlim(left=0.0)
        axis.grid(axis="y", alpha=0.3)
    return found


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
    experiment(__doc__, kinds=kinds, measure=measured, table=table, seeds=seeds(), draw=figure)
