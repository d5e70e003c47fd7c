"""Evolve the packs of notebook 9: penalties, and a mask; twenty seeds each.

    python tutorials/make/chapter_9.py      eight minutes on one core; goes on after an interruption

Writes `safe_packs.npz` to the folder of kept results. Every pack has six weights and evolves for
the same number of matches in the same world (`course.chapter_9`):

- penalties: a fixed penalty for each collision at fault, with the paper's other rewards;
- mask: no penalty at all, but the mask right-of-way.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from races import DATA
from tqdm import tqdm

import matrixworld as mw
from matrixworld._util.files import load_arrays, save_arrays
from matrixworld.coevolution import EvolutionStrategy, Results
from matrixworld.world.masks import action_masks, forbidding_cells

sys.path.append(str(Path(__file__).parents[1]))  # where the folder `course` lies

from course.chapter_9 import WORLD, idle_pack, pack, play_masked

PENALTIES = (0.0, 0.1, 0.3, 1.0, 3.0, 12.0, 40.0)
SEEDS = 20
EPOCHS, SAMPLES, WORLDS = 60, 32, 8
EPISODES = 400  # of each final test

Row = dict[str, NDArray[np.float64]]

LEARNER = EvolutionStrategy(SAMPLES, sigma=0.5, learning_rate=0.3, relative_sigma=0.0)


def matches(rng: np.random.Generator) -> mw.Matches:
    """Return a match of each sample; both samples of a pair meet the same seed."""
    return mw.Matches.of(range(SAMPLES), 0, np.tile(rng.integers(2**62, size=SAMPLES // 2), 2))


def with_penalty(penalty: float) -> mw.WorldConfig:
    """Return the world with this penalty for each kind of collision."""
    return replace(WORLD, rewards=mw.Rewards(pursuer_collide=-penalty))


def evolve(seed: int, penalty: float) -> Row:
    """Evolve a pack on rewards."""
    rng = np.random.default_rng(seed)
    state, world = idle_pack(LEARNER, seed), with_penalty(penalty)
    for _ in range(EPOCHS):
        candidates, state = LEARNER.ask(state, rng)
        played = mw.rollout(world, pack(candidates), "random", matches(rng), episodes=WORLDS)
        state = LEARNER.tell(state, Results(played.pursuer_return.mean(axis=1)))
    return tested(LEARNER.genome(state), seed)


def tested(weights: NDArray[np.float32], seed: int) -> Row:
    """Play a pack in new episodes."""
    played = mw.rollout(
        WORLD, pack(weights), "random", mw.Matches.of(0, 0, 10**6 + seed), episodes=EPISODES
    )
    return {
        "weights": weights,
        "captured": played.capture_rate.sum(),
        "steps": played.length.sum(),
        "safe": (played.faults[:, :, 0].sum(axis=2) == 0).sum(),
    }


def right_of_way(views: NDArray[np.uint8]) -> NDArray[np.bool_]:
    """Allow the moves that the mask right-of-way of the package allows."""
    return action_masks(views, forbidding_cells(WORLD, "right-of-way", "pursuer")).astype(bool)


def evolve_masked(seed: int) -> Row:
    """Evolve a pack without a penalty, under the mask in training and test."""
    rng = np.random.default_rng(seed)
    state = idle_pack(LEARNER, seed)
    world = with_penalty(0.0)
    envs = mw.VectorEnv(
        world, n_worlds=SAMPLES * WORLDS, copy=False, autoreset_mode="Disabled", threads=1
    )
    for _ in range(EPOCHS):
        candidates, state = LEARNER.ask(state, rng)
        played = masked_epoch(envs, pack(candidates), rng)
        earned = played["return"][:, 0].reshape(SAMPLES, WORLDS).mean(axis=1)
        state = LEARNER.tell(state, Results(earned))
    return tested_masked(LEARNER.genome(state), seed)


def masked_epoch(
    envs: mw.VectorEnv, population: mw.Population, rng: np.random.Generator
) -> dict[str, NDArray[Any]]:
    """Play each sample in its worlds and return the statistics of these episodes."""
    network, pursuers = population.policy, WORLD.n_pursuers
    weights, biases = zip(*(network.layers(g)[0] for g in population.genomes), strict=True)
    pairs = rng.integers(2**62, size=(SAMPLES // 2, 1)) + np.arange(WORLDS)
    _, infos = envs.reset(seed=np.tile(pairs, (2, 1)).ravel())
    while not (infos["terminated"] | infos["truncated"]).all():
        views = envs.observations[:, :pursuers].reshape(-1, 3, network.fov, network.fov)
        inputs = views.reshape(SAMPLES, -1, network.sizes[0]).astype(np.float32)
        wishes = (inputs @ np.stack(weights) + np.stack(biases)[:, None]).reshape(-1, 5)
        wishes[~right_of_way(views)] = -np.inf
        # The evader moves at random.
        actions = rng.integers(5, size=(len(infos["alive"]), envs.config.n_agents))
        # The largest of wishes with Gumbel noise is a draw with their softmax.
        chosen = (wishes + rng.gumbel(size=wishes.shape)).argmax(axis=1)
        actions[:, :pursuers] = chosen.reshape(-1, pursuers)
        *_, infos = envs.step(actions)
    statistics: dict[str, NDArray[Any]] = infos["episode"]
    return statistics


def tested_masked(weights: NDArray[np.float32], seed: int) -> Row:
    """Play a pack under the mask in new episodes."""
    safety, steps = play_masked(weights, right_of_way, episodes=EPISODES, seed=10**6 + seed)
    summary = safety.summary()
    return {
        "weights": weights,
        "captured": round(EPISODES * summary.capture_rate),  # there is one evader
        "steps": steps.sum(),
        "safe": np.rint(EPISODES * summary.safe_share[0].min()),
    }


def over_seeds(name: str, one: Callable[[int], Row]) -> dict[str, NDArray[np.float32]]:
    """Return the rows of all seeds, stacked, under names that begin with `name`."""
    rows = [one(seed) for seed in tqdm(range(SEEDS), desc=name)]
    return {
        f"{name}_{key}": np.stack([row[key] for row in rows]).astype(np.float32) for key in rows[0]
    }


def main(path: Path) -> None:
    """Evolve all packs and keep the results after each group; groups that are kept are skipped."""
    path.parent.mkdir(exist_ok=True)
    arrays: dict[str, NDArray[Any]] = dict(load_arrays(path)) if path.exists() else {}
    arrays |= {"penalties": np.array(PENALTIES, np.float32), "episodes": np.array(EPISODES)}
    groups: dict[str, Callable[[int], Row]] = {
        f"penalty{number}": partial(evolve, penalty=penalty)
        for number, penalty in enumerate(PENALTIES)
    }
    groups["mask"] = evolve_masked
    # The packs that evolved without a penalty, tested under the mask.
    groups["late_mask"] = lambda seed: tested_masked(arrays["penalty0_weights"][seed], seed)
    for name, one in groups.items():
        if f"{name}_weights" not in arrays:
            arrays |= over_seeds(name, one)
            save_arrays(path, arrays)
    print(f"{path.name}: {path.stat().st_size / 1e3:.0f} kB")


if __name__ == "__main__":
    main(DATA / "safe_packs.npz")
