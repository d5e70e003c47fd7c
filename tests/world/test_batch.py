"""Batches against single worlds, and the memory and threads that they use."""

from typing import Any

import numpy as np
import pytest

import matrixworld as mw
from matrixworld.world.arrays import new_arrays
from rows import NAMES, config_of, random_actions, random_team

MOMENT = (
    "positions",
    "last_positions",
    "alive",
    "steps",
    "seed",
    "episode",
    "views",
    "inputs",
    "state",
)


def all_buffers(config: mw.WorldConfig, n_worlds: int) -> dict[str, np.ndarray]:
    return new_arrays(mw.array_specs(config) | mw.episode_specs(config), n_worlds)


class SingleWorld:
    """Reference for one world of a batch, in Python, without the statistics of episodes.

    Those are compared with rollouts in tests/envs/test_vector.py.
    """

    def __init__(self, config: mw.WorldConfig, seed: int, episode: int, mode: mw.Autoreset) -> None:
        self.world = mw.World(config)
        self.world.reset(seed, episode=episode)
        self.autoreset = mode
        self.arrays: dict[str, Any] = {
            name: np.zeros(mw.episode_specs(config)[name][0])
            for name in ("acted", "ended", "final_views", "final_inputs")
        }
        self.read()

    def read(self) -> None:
        self.arrays |= self.world.read(*mw.array_specs(self.world.config))

    @property
    def ended(self) -> bool:
        return self.world.terminated or self.world.truncated

    def step(self, actions: np.ndarray) -> None:
        was_ended = self.ended
        self.arrays["acted"] = self.world.alive & (not was_ended)
        self.arrays["ended"] = False
        if was_ended and self.autoreset is mw.Autoreset.NEXT_STEP:
            self.world.reset()
            self.read()
        elif was_ended:
            for name in ("rewards", "involved", "fault", "captors", "cost"):
                self.arrays[name] = np.zeros_like(self.arrays[name])
        else:
            self.world.step(actions)
            self.read()
            if self.ended:
                seen = {f"final_{name}": self.arrays[name] for name in ("views", "inputs")}
                self.arrays |= {"ended": True, **seen}
        if self.ended and self.autoreset is mw.Autoreset.SAME_STEP:
            self.world.reset()
            self.arrays |= self.world.read(*MOMENT)


@pytest.mark.parametrize("autoreset", mw.Autoreset)
@pytest.mark.parametrize("name", NAMES)
def test_each_world_is_a_single_world(name: str, autoreset: mw.Autoreset) -> None:
    # 24 steps are two episodes and a part.
    config = config_of(name, obstacles=0.15, max_steps=9)
    n = 5
    batch = mw.Batch(n, config, threads=2, autoreset=autoreset, buffers=all_buffers(config, n))
    seeds = [3, 3, 2**63 + 1, 0, 17]  # equal ones, and one beyond signed integers
    batch.reset(seeds, episode=2)
    worlds = [SingleWorld(config, seed, 2, autoreset) for seed in seeds]
    actions = random_actions(1, config.n_actions, 24, n, config.n_agents)
    for row in [*actions, None]:
        for what in worlds[0].arrays:
            expected = np.array([world.arrays[what] for world in worlds])
            np.testing.assert_array_equal(batch.buffers[what], expected, what)
        if row is not None:
            row[[world.ended for world in worlds]] = 99  # ended worlds do not read their actions
            batch.step(row)
            for world, chosen in zip(worlds, row, strict=True):
                world.step(chosen)
    assert batch.buffers["episode_length"].all()


def test_a_mask_selects_the_worlds_to_reset() -> None:
    config = config_of("O")
    batch = mw.Batch(4, config)
    batch.reset(7)
    for actions in random_actions(1, 5, 3, 4, config.n_agents):
        batch.step(actions)
    before = {name: array.copy() for name, array in batch.buffers.items()}
    batch.reset(mask=np.array([False, True, False, True]))
    world = mw.World(config)
    for w in range(4):
        for name, array in batch.buffers.items():
            if w % 2:
                world.reset(7 + w, episode=1)
                np.testing.assert_array_equal(array[w], world.read(name)[name])
            else:
                np.testing.assert_array_equal(array[w], before[name][w])


@pytest.mark.parametrize("name", ["O", "SD", "TO"])
def test_threads_change_nothing(name: str) -> None:
    config = config_of(name, obstacles=0.1, diagonal=True)
    n, mode = 70, mw.Autoreset.SAME_STEP  # no multiple of 3 threads
    actions = random_actions(2, config.n_actions, 25, n, config.n_agents)
    played = []
    for threads in (1, 2, 3, None):
        batch = mw.Batch(n, config, threads=threads, autoreset=mode, buffers=all_buffers(config, n))
        batch.reset(5)
        for row in actions:
            batch.step(row)
        played.append({what: array.copy() for what, array in batch.buffers.items()})
    assert any(played[0]["steps"] < 25)  # some have begun anew
    for other in played[1:]:
        for what, array in played[0].items():
            np.testing.assert_array_equal(array, other[what])


def test_an_int_seeds_consecutive_worlds() -> None:
    config = config_of("O")
    one, other, new = (mw.Batch(4, config) for _ in range(3))
    for seed, seeds in (
        (7, np.array([7, 8, 9, 10], np.int32)),
        (2**64 - 2, [2**64 - 2, 2**64 - 1, 0, 1]),  # wraps
        (0, range(4)),
    ):
        one.reset(seed)
        other.reset(seeds)
        np.testing.assert_array_equal(one.buffers["positions"], other.buffers["positions"])
    np.testing.assert_array_equal(new.buffers["positions"], one.buffers["positions"])


@pytest.mark.parametrize("name", ["D", "SB", "TO", "agents-R"])
def test_worlds_of_a_batch_decide_as_single_worlds(name: str) -> None:
    """Each with the policy that was chosen for it, for any number of threads."""
    config = config_of(name, obstacles=0.1, max_steps=9)
    league = [
        "hunter",
        random_team(config, 1),
        None,
        random_team(config, 2, sampled=False),
        "random",
        random_team(config, 3, memory="gru"),
    ]
    n_worlds = 60  # ten for each of the league
    place = np.random.default_rng(0).integers(len(league), size=n_worlds)
    batches = [mw.Batch(n_worlds, config, threads=threads) for threads in (1, 3)]
    for batch in batches:
        batch.reset(5)
    agents = range(config.n_pursuers, config.n_agents)
    for _ in range(11):  # two steps more than an episode has
        expected = np.full((n_worlds, config.n_agents), 7)
        for world, row in enumerate(expected):
            if league[place[world]] is not None:
                batches[0].world(world).decide(league[place[world]], agents, row)
        for batch in batches:
            # No legal action: what is not written stays visible.
            actions = np.full_like(expected, 7)
            batch.decide(league, place, agents, actions)
            assert np.array_equal(actions, expected)
            assert (actions[:, : config.n_pursuers] == 7).all()
            batch.step(actions % 5)
    assert (expected == 7).all()  # nobody decides in an episode that has ended
