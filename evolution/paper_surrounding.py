"""Do pursuers learn to capture, and safely, at the paper's size? S as published, and masked.

    python evolution/paper_surrounding.py                        ten runs: four hours of one core
    python evolution/paper_surrounding.py --kinds right-of-way   five runs: 40 minutes of one core
    python evolution/paper_surrounding.py --quick                a small world: some seconds

Twenty pursuers learn by actor-critic to surround five evaders that move at random, on 40 x 40
cells, in episodes of 500 steps (S). Three kinds of training:

published     settings and rewards of the code that the paper's authors published, 5,000 epochs
no mask       other settings; rewards of the paper without penalties for collisions, 2,500 epochs
right of way  the same, with the mask `policy.mask=right-of-way`

Look at the captures in an episode's last step, and at the collisions: the log of the authors'
training (every tenth epoch) stands beside the first kind. With the mask no pursuer is at fault in
any step of training. Runs resume where they were interrupted. ``--results`` receives the numbers,
and the tables; numbers of other kinds that are there already are kept.

Method: Sun et al. (2023), section on Pursuit-Evasion-S; policy gradients with the clipped objective
of PPO (Schulman et al., 2017). Needs PyTorch.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import matrixworld as mw
from common import FIRST_TEST_SEED, Numbers, experiment, kinds_in, markdown, mean, of_each
from matrixworld.coevolution import RaceSettings, SavedRun
from matrixworld.world.rules import COLLISION_KINDS

LOG = Path(__file__).parent / "results" / "paper" / "paper_surrounding" / "published_log.csv"
"""Every tenth epoch of the authors' log (github.com/LijunSun90/MatrixWorld, directory
data/s_train_pursuit_vs_random_evasion): reward of a pursuer, evaders captured in the last step, and
collisions of the pursuers by kind, in one episode each."""
WINDOW = 100
"""Epochs of a mean, and between two archived generations."""
CURVE_EPISODES, LAST_EPISODES = 20, 400
"""Test episodes of each archived generation, and of the last one."""

BASE = RaceSettings.of({
    "schedule": "against", "schedule.team": "pursuer", "schedule.archive_every": WINDOW,
    "learner": "actor-critic",
    "world.rules": "S", "world.n_pursuers": 20, "world.n_evaders": 5,
})  # fmt: skip
SMALL = {
    "world.rows": 6, "world.cols": 6, "world.n_pursuers": 4, "world.n_evaders": 1, "world.fov": 5,
    "world.max_steps": 10, "train_steps": 10, "policy.hidden": (8,), "schedule.epochs": 4,
    "schedule.archive_every": 2,
}  # fmt: skip
PUBLISHED = {"world.rewards": "published", "schedule.epochs": 5000, "policy.initial_head": 2**0.5}
FREE = {
    "world.rewards": mw.Rewards(pursuer_collide=0.0),
    "schedule.epochs": 2500, "policy.hidden": (64,), "learner.population": 2, "learner.clip": 0.2,
    "learner.actor_updates": 12, "learner.critic_updates": 12, "learner.minibatches": 4,
    "learner.actor_rate": 1e-3, "learner.critic_rate": 2e-3, "learner.anneal": True,
    "learner.discount": 0.97, "learner.entropy": 0.01,
}  # fmt: skip
KINDS: Mapping[str, Mapping[str, Any]] = {
    "published": PUBLISHED,
    "no mask": FREE,
    "right of way": {**FREE, "policy.mask": "right-of-way"},
}
"""Settings of each kind."""
SEEDS = {"published": 2, "no mask": 3, "right of way": 5}


def kinds(quick: bool) -> dict[str, RaceSettings]:
    """Return the settings of each kind."""
    small = SMALL if quick else {}
    return {kind: BASE.changed({**changes, **small}) for kind, changes in KINDS.items()}


def of_run(run: SavedRun) -> Numbers:
    """Return the numbers of a run.

    Over epochs of training ``captured`` (in the last step) and ``fault`` (agent-steps of the
    pursuers at fault in an episode); over archived generations ``reward`` (of a pursuer in an
    episode) and ``test captured``, and ``test fault`` (generations, kinds of collision); of the
    last generation in new episodes ``last captured``, ``last length`` and, in all of them, ``last
    fault`` (kinds) and ``last agent-steps``.
    """
    log, own, world = run.log(), run.teams["pursuer"], run.settings.game.world

    def play(generations: Any, episodes: int, seed: int) -> mw.EpisodeStatistics:
        matches = mw.Matches.of(generations, 0, seed)
        return mw.rollout(world, own, run.settings.schedule.opponent, matches, episodes=episodes)

    last = len(own.genomes) - 1
    curve = play(np.arange(last + 1), CURVE_EPISODES, FIRST_TEST_SEED)
    final = play(last, LAST_EPISODES, FIRST_TEST_SEED + 1)
    return {
        "captured": log["capture_rate"],
        "fault": log["pursuer_faults"],
        "reward": curve.pursuer_return.mean(axis=1) / world.n_pursuers,
        "test captured": curve.capture_rate.mean(axis=1),
        "test fault": curve.faults[:, :, 0].mean(axis=1),
        "last captured": final.capture_rate.mean(),
        "last length": final.length.mean(),
        "last fault": final.faults[:, :, 0].sum(axis=(0, 1)),
        "last agent-steps": final.agent_steps[:, :, 0].sum(),
    }


def published_log() -> dict[str, NDArray[np.float64]]:
    """Return `epoch`, `captured`, `collisions` and `reward` of the authors' log, by windows."""
    log = np.genfromtxt(LOG, delimiter=",", names=True)
    collisions = sum(log[kind] for kind in COLLISION_KINDS)
    columns = {name: log[name] for name in ("epoch", "captured", "reward")}
    # The log has every tenth epoch.
    every = {**columns, "collisions": collisions}
    return {name: windows(each, WINDOW // 10) for name, each in every.items()}


def windows(values: NDArray[Any], length: int = WINDOW) -> NDArray[np.float64]:
    """Return the means of windows of so many numbers along the last axis, without a rest."""
    whole = values.shape[-1] // length * length
    parts = values[..., :whole].reshape(*values.shape[:-1], -1, length)
    return np.asarray(parts.mean(axis=-1, dtype=np.float64))


def tables(numbers: Numbers) -> str:
    """Return the ends of all runs, and the course of the published training, in Markdown."""
    return f"{ends(numbers)}\n\n{course(numbers)}"


def in_order(numbers: Numbers) -> list[str]:
    """Return the kinds that have been measured, in the order of `KINDS`."""
    return [kind for kind in KINDS if kind in kinds_in(numbers)]


def ends(numbers: Numbers) -> str:
    """Return how the runs ended, in Markdown."""
    told = (
        f"Ends of the runs, {LAST_EPISODES} new episodes each: evaders captured in the last step, "
        "steps, and collisions\nof the pursuers (agent-steps at fault in an episode); in training, "
        "all of them. Mean over seeds [95% interval].\n\n"
    )
    heads = ["training", "seeds", "captured", "steps", *COLLISION_KINDS]
    rows = []
    for kind in in_order(numbers):
        captured, length, faults, steps = (
            numbers[f"{kind} / last {key}"]
            for key in ("captured", "length", "fault", "agent-steps")
        )
        matches = KINDS[kind].get("learner.population", 1)
        rows.append([
            kind,
            f"{len(captured)}",
            mean(captured, bounds=(0.0, 1.0)),
            mean(length, 0, bounds=(0.0, np.inf)),
            *(f"{each:.1f}" for each in faults.mean(axis=0) / LAST_EPISODES),
            f"{steps.sum() / 1e6:.1f} million",
            f"{matches * numbers[f'{kind} / fault'].sum(axis=1).mean():,.0f}",
        ])  # fmt: skip
    return told + markdown([*heads, "agent-steps", "collisions in training"], rows)


def course(numbers: Numbers) -> str:
    """Return the published training beside its log, by windows of epochs, in Markdown."""
    log = published_log()
    columns = [log[name] for name in ("captured", "collisions", "reward")]
    if "published" in in_order(numbers):
        captured, faults = (windows(numbers[f"published / {key}"]) for key in ("captured", "fault"))
        rewards = numbers["published / reward"][:, 1:]  # the first generation is untrained
        for of_seed in zip(captured, faults, rewards, strict=True):
            columns += of_seed
    heads = ["epochs", "log: captured", "collisions", "reward"]
    for seed in range(len(columns) // 3 - 1):
        heads += [f"seed {seed}: captured", "collisions", "reward"]
    told = (
        f"The published training by windows of {WINDOW} epochs: means of an episode (the log: "
        f"every tenth epoch); rewards of a pursuer,\nours in {CURVE_EPISODES} test episodes at the "
        "end of the window.\n\n"
    )
    rows = []
    for w in range(len(log["epoch"])):
        if w >= 10 and w % 5 != 4:  # later windows change slowly
            continue
        cells = [
            f"{column[w]:.{0 if k % 3 else 2}f}" if w < len(column) else ""
            for k, column in enumerate(columns)
        ]
        rows.append([f"{w * WINDOW} to {(w + 1) * WINDOW - 1}", *cells])
    return told + markdown(heads, rows)


if __name__ == "__main__":
    experiment(__doc__, kinds=kinds, measure=of_each(of_run), table=tables, seeds=SEEDS)
