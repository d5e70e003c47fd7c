"""Which schedule comes closest to perfect play? Long races on a small world, solved exactly.

    python evolution/convergence.py             ten seeds of each kind, an hour; needs PyTorch
    python evolution/convergence.py --quick     short races of two seeds, some seconds

Two pursuers take turns with one evader on 4 x 4 cells, for 4 steps; perfect play captures in 0.886
of the episodes. Specialists, generalists, halls of fame and PSRO with the Nash equilibrium learn by
an evolution strategy, each team for 10,000 epochs; after so many Simione and Nolfi (2021,
"Long-term progress and behavior complexification in competitive coevolution") see progress. A
generation is archived every 100. *Self-play* learns by policy gradients with an entropy bonus, both
teams at once, for a quarter of the steps; Rudolph et al. (2025, "Reevaluating policy gradient
methods for imperfect-information games", arXiv:2502.08938) find it not worse than PSRO in five
games. Its rewards are zero-sum: 1 for a capture. All races are compared at equal steps of agents,
when the shortest one has ended. Matches that fill payoff matrices count.

For each race the NashConv, exactly: how far what a team guarantees falls short of the value, both
teams together. Of the newest generations; of the *best* so far, the least exploitable generation of
each team, which only exact play can know; and of the *mixtures*, the equilibrium of the payoff
matrix of the generations so far, from which each team draws one an episode. Theirs is a bound: an
opponent that is told whom it meets gains as much, and the best one at most. A team whose members
decide for themselves may be unable to reach 0 (von Stengel and Koller 1997, "Team-maxmin
equilibria"); here perfect play is deterministic, so it can.

Look at the differences from generalists, with intervals over seeds and p-values that are adjusted
for the number of rows (Holm). The last column says how much the NashConv falls in the last quarter.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

import common
from matrixworld import analysis
from matrixworld.coevolution import TEAMS, RaceSettings, SavedRun, Team

WORLD = {
    "rules": "TO", "rows": 4, "cols": 4, "n_pursuers": 2, "n_evaders": 1, "max_steps": 4, "fov": 7,
}  # fmt: skip
EPOCHS = {f"schedule.{team}_epochs": 100 for team in TEAMS}
RACE: dict[str, Any] = {
    **{f"world.{name}": value for name, value in WORLD.items()}, "train_steps": 4,
    "policy.hidden": [32], "match_episodes": 16, "evaluation_episodes": 32,
    "schedule.generations": 100,
}  # fmt: skip
STRATEGY = {
    "learner.population": 32, "learner.sigma": 0.3, "learner.relative_sigma": 1.0,
    "learner.learning_rate": 0.1,
}  # fmt: skip
REWARDS = {
    f"world.rewards.{team}_{name}": 0.0
    for team in TEAMS
    for name in ("step", "neighbor", "collide")
} | {"world.rewards.pursuer_capture": 1.0, "world.rewards.evader_capture": -1.0}
GRADIENTS = {
    "learner": "actor-critic", "learner.population": 32, "learner.actor_rate": 0.002,
    "learner.critic_rate": 0.002, "learner.actor_updates": 2, "learner.entropy": 0.1,
}  # fmt: skip
QUICK = {
    "schedule.generations": 10, "learner.population": 8, "match_episodes": 4,
    "evaluation_episodes": 8,
}  # fmt: skip
# A match is 16 episodes here, so that 2 matches of each pair are 32.
META = {f"schedule.{team}s_meet.episodes": 2 for team in TEAMS}
GENERALISTS, HALLS = "generalists", "halls of fame"
SELF_PLAY = "self-play by policy gradients"


def meeting(sampler: str) -> dict[str, Any]:
    """Return changes by which both teams, in turns, meet opponents of a sampler."""
    return {"schedule": "alternating", **{f"schedule.{team}s_meet": sampler for team in TEAMS}}


KINDS: dict[str, dict[str, Any]] = {
    "specialists": {"schedule": "specialist-specialist", **EPOCHS, **STRATEGY},
    GENERALISTS: {"schedule": "generalist-generalist", **EPOCHS, **STRATEGY},
    # Three opponents in an epoch of both teams.
    HALLS: {"schedule": "hall-of-fame", "schedule.joint_epochs": 50, **STRATEGY},
    "PSRO, Nash": {**meeting("nash"), **EPOCHS, **META, **STRATEGY},
    SELF_PLAY: {
        "schedule": "hall-of-fame", "schedule.contemporaries": 1, "schedule.hall_sample": 0,
        "schedule.joint_epochs": 50, **GRADIENTS, **REWARDS,
    },
}  # fmt: skip

CURVES = {
    "newest": "NashConv of the newest generations",
    "best": "NashConv of the best generations so far",
    "mixture": "NashConv of the mixtures, at most",
}
EVERY = 5
"""Generations between those whose mixtures are computed."""


def kinds(quick: bool) -> dict[str, RaceSettings]:
    """Return the settings of each kind of race."""
    return {
        kind: RaceSettings.of(RACE | each | (short(each) if quick else {}))
        for kind, each in KINDS.items()
    }


def short(kind: Mapping[str, Any]) -> dict[str, Any]:
    """Return the changes of a quick race."""
    return QUICK | {name: 3 for name in kind if name.endswith("_epochs")}


# Numbers of a race


def mixtures(matrix: NDArray[np.float64], k: int) -> list[NDArray[np.float64]]:
    """Return the equilibrium of the generations up to k, as weights of all generations."""
    nash = analysis.nash_averaging(matrix[: k + 1, : k + 1])
    rest = np.zeros(len(matrix) - k - 1)
    return [np.append(weights, rest) for weights in (nash.pursuers, nash.evaders)]


def shortfalls(run: SavedRun) -> dict[Team, NDArray[np.float64]]:
    """Return by how much what each generation of a team guarantees falls short of the value."""
    value = common.solved(run.settings.game.world).value
    return {
        "pursuer": value - common.guaranteed(run, "pursuer"),
        "evader": common.guaranteed(run, "evader") - value,
    }


def measured(runs: common.Runs, quick: bool) -> dict[str, Any]:
    """Return the numbers of all races, and the value.

    A file beside a run keeps its numbers for the next call.
    """
    world = next(iter(runs.values()))[0].settings.game.world
    return {
        **common.by_seed(
            runs, lambda run: common.kept(run.path.with_suffix(".json"), partial(numbers_of, run))
        ),
        "value": common.solved(world).value,
    }


def numbers_of(run: SavedRun) -> dict[str, Any]:
    """Return numbers of a race for every fifth generation, and the steps of agents so far."""
    matrix, log = run.payoff().matrix, run.log()
    short = shortfalls(run)
    generations = range(EVERY, len(matrix), EVERY)
    matches = [int(log["matches"][log["generation"] == k].max()) for k in generations]
    weights = [mixtures(matrix, k) for k in generations]
    each_match = run.summary()["training_agent_steps"] / int(log["matches"].max())
    return {
        "agent_steps": [each_match * n for n in matches],
        "newest": [float(sum(short[team][k] for team in TEAMS)) for k in generations],
        "best": [float(sum(short[team][: k + 1].min() for team in TEAMS)) for k in generations],
        **{f"{team}s": [float(short[team][: k + 1].min()) for k in generations] for team in TEAMS},
        "mixture": [
            float(sum(w @ short[team] for w, team in zip(of_k, TEAMS, strict=True)))
            for of_k in weights
        ],
    }


# Tables


Reached = Mapping[str, Mapping[str, NDArray[Any]]]
"""Kind -> name -> a number of each seed."""


def within(numbers: common.Numbers, budget: float) -> Reached:
    """Return the numbers of all seeds of each kind within a budget of steps of agents.

    ``flat`` is by how much the NashConv of the newest generations falls in the last quarter.
    """
    found = {}
    for kind in common.kinds_in(numbers):
        steps = numbers[f"{kind} / agent_steps"]
        most = np.minimum(steps[:, -1:], budget)
        ends, early = ((steps <= share * most).sum(axis=1) - 1 for share in (1.0, 0.75))
        seeds = np.arange(len(ends))
        found[kind] = {
            name: numbers[f"{kind} / {name}"][seeds, ends]
            for name in (*CURVES, "pursuers", "evaders")
        }
        newest = numbers[f"{kind} / newest"]
        found[kind]["flat"] = newest[seeds, early] - newest[seeds, ends]
    return found


def differences(reached: Reached, labels: Mapping[str, str]) -> str:
    """Return the differences of all kinds from generalists as a table in Markdown."""
    # Pairs of the same seed: races of one learner start with the same genomes.
    found = {
        (kind, name): each[name] - reached[GENERALISTS][name]
        for kind, each in reached.items()
        for name in labels
        if kind != GENERALISTS
    }
    rows: dict[str, list[str]] = {}
    for (kind, name), p in common.adjusted(found).items():
        lower = found[kind, name].mean() < 0.0
        verdict = "cannot tell" if p > common.SIGNIFICANCE else "lower" if lower else "higher"
        cells = [common.mean(found[kind, name], sign="+"), f"{common.shown_p(p)}, {verdict}"]
        rows.setdefault(kind, [kind]).extend(cells)
    heads = ["race", *(head for label in labels.values() for head in (label, "Holm"))]
    return (
        f"Differences from generalists of the same seed:\n\n{common.markdown(heads, rows.values())}"
    )


def table_of_ends(reached: Reached) -> str:
    """Return where all kinds of race are, as a table in Markdown."""
    shown = {
        **CURVES,
        "pursuers": "of it the best pursuers",
        "evaders": "of it the best evaders",
        "flat": "newest: fall in the last quarter",
    }
    rows = [[kind, *(common.mean(each[name]) for name in shown)] for kind, each in reached.items()]
    return common.markdown(["race", *shown.values()], rows)


def table(numbers: common.Numbers) -> str:
    """Return the comparison of all kinds of race as tables in Markdown."""
    kinds = common.kinds_in(numbers)
    ends = [numbers[f"{kind} / agent_steps"][:, -1] for kind in kinds]
    budget = min(float(each.min()) for each in ends)
    longest = max(float(each.max()) for each in ends)
    parts = [
        f"After {budget / 10**6:.1f} million steps of agents; means over {len(ends[0])} seeds "
        f"[95 %]. The value is {numbers['value']:.3f}; perfect play has a NashConv of 0.",
        table_of_ends(within(numbers, budget)),
        differences(within(numbers, budget), CURVES),
        f"At the ends of the races, after up to {longest / 10**6:.1f} million steps:",
        table_of_ends(within(numbers, np.inf)),
    ]
    return "\n\n".join(parts)


def figure(numbers: common.Numbers) -> Figure:
    """Draw how far the best generations so far are from perfect play, means over seeds."""
    found = Figure(figsize=(7, 3.2), layout="constrained")
    axis = found.subplots()
    for kind in common.kinds_in(numbers):
        steps, best = (numbers[f"{kind} / {name}"].mean(axis=0) for name in ("agent_steps", "best"))
        color = "tab:blue" if kind == SELF_PLAY else "tab:gray"
        axis.plot(steps / 10**6, best, color=color)
        if kind in (SELF_PLAY, GENERALISTS):
            label = SELF_PLAY if kind == SELF_PLAY else "four schedules of evolution"
            place, side = ((0, -18), "left") if kind == SELF_PLAY else ((0, 8), "right")
            at = 1 if kind == SELF_PLAY else -1
            axis.annotate(
                label, (steps[at] / 10**6, best[at]), place, textcoords="offset points",
                color=color, ha=side, weight="bold",
            )  # fmt: skip
    axis.axhline(0.0, color="black")
    axis.annotate("perfect play", (axis.get_xlim()[1], 0.0), (0, 4), textcoords="offset points",
                  ha="right")  # fmt: skip
    axis.set(xlabel="million steps of agents", ylabel=CURVES["best"].split(" of ")[0])
    axis.set(ylim=(0.0, None), xlim=(0.0, None))
    axis.spines[["top", "right"]].set_visible(False)
    return found


if __name__ == "__main__":
    common.experiment(__doc__, kinds=kinds, measure=measured, table=table, seeds=10, draw=figure)
