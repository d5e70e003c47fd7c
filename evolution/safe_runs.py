"""Runs behind `safe_learning`: methods, settings, and the numbers of each run."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

import matrixworld as mw
from common import SMALL_STEPS
from matrixworld.coevolution import RaceSettings, SavedRun

LIMIT = 20.0
"""Collisions at fault per 1000 agent-steps that the limited methods may have."""
FIRST_TEST_SEED = 10**6
"""Test episodes have seeds of their own; those of training are hashes."""

SEEDS, FEW_SEEDS = 10, 5
"""Seeds of a method, and of those whose runs take longest."""

Changes = dict[str, Any]


class Method(NamedTuple):
    """What a method changes in the settings, and its seeds."""

    changes: Changes
    seeds: int = SEEDS


LEARNER_LIMIT, FITNESS_LIMIT, MASK = "learner.cost_limit", "fitness.cost_limit", "policy.mask"


def _penalty(size: float) -> Changes:
    """Return the change of the penalty for a collision at fault."""
    return {"world.rewards": mw.Rewards(pursuer_collide=-size, evader_collide=-size)}


FREE: Changes = _penalty(0.0)
# With a penalty or a limit most runs stand still, which takes long.
GRADIENTS: dict[str, Method] = {
    "no penalty": Method(FREE),
    "penalty 12, as in the paper": Method({}, FEW_SEEDS),
    "limit, by a multiplier": Method({**FREE, LEARNER_LIMIT: LIMIT}, FEW_SEEDS),
    "mask of obstacles": Method({**FREE, MASK: "obstacles"}),
    "right of way": Method({**FREE, MASK: "right-of-way"}),
}
EVOLUTION: dict[str, Method] = {
    "captures": Method({}),
    "rewards with penalty 1": Method({"fitness.measure": "rewards", **_penalty(1.0)}, FEW_SEEDS),
    "captures within a limit": Method({FITNESS_LIMIT: LIMIT}, FEW_SEEDS),
    "captures, right of way": Method({MASK: "right-of-way"}),
    "rewards, right of way, 16 times the matches": Method({
        MASK: "right-of-way", "fitness.measure": "rewards", "learner.population": 128,
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
    return epochs * one.learner.population * one.train_steps * one.world.n_pursuers


def of_run(run: SavedRun, quick: bool) -> dict[str, NDArray[Any]]:
    """Return the numbers of a run over archived generations, untrained pursuers first.

    ``agent-steps`` and ``collisions`` of the pursuers in training until then; in the test the
    ``capture rate``, the mean ``length``, and agent-steps at ``fault`` per 1000 (generations,
    kinds).
    """
    settings, log = run.settings, run.log()
    schedule: Any = settings.schedule
    # Here no agent disappears: each world step is one step of all pursuers.
    steps = settings.world.n_pursuers * np.concatenate([[0], log["steps"]])
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
    played = mw.rollout(settings.world, own, settings.schedule.opponent, matches, episodes=episodes)
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
        played = mw.rollout(settings.world, own, settings.schedule.opponent, match, episodes=1000)
        steps += int(played.agent_steps[..., 0].sum())
        faults += int(played.faults[:, :, 0].sum())
    return steps, faults
