"""Collisions over many episodes, compared with counts by hand and by plain loops."""

from typing import Any

import numpy as np
import pytest

import matrixworld as mw
from rows import config_of, random_actions

NAMES = ["D", "SB", "SDB", "TO", "swarm-S"]


def rows_of(config: mw.WorldConfig, number: int) -> np.ndarray:
    return random_actions(number, config.n_actions, config.max_steps, config.n_agents)


def counted(config: mw.WorldConfig, seeds: range) -> dict[str, Any]:
    """Count with plain loops over worlds and agents."""
    steps, faults, capture = np.zeros((2, len(seeds))), np.zeros((len(seeds), 2, 3)), []
    involved = np.zeros((2, 3))
    for n, seed in enumerate(seeds):
        world = mw.World(config)
        world.reset(seed)
        for row in rows_of(config, seed):
            if world.terminated or world.truncated:
                break
            alive = world.alive
            world.step(row)
            for agent in range(config.n_agents):
                team = int(agent >= config.n_pursuers)
                steps[team, n] += alive[agent]
                for kind in range(3):
                    involved[team, kind] += world.involved[agent, kind]
                    faults[n, team, kind] += world.fault[agent, kind]
        capture.append(world.capture_rate)
    total = steps.sum(axis=1)
    return {
        "episodes": len(seeds),
        "agent_steps": total,
        "capture_rate": np.mean(capture),
        "involved_rate": 1000 * involved / total[:, None],
        "fault_rate": 1000 * faults.sum(axis=0) / total[:, None],
        "safe_share": [[np.mean(faults[:, t, k] == 0) for k in range(3)] for t in range(2)],
        "safe_episodes": np.mean([not each.any() for each in faults]),
        "fault_mean": faults.mean(axis=0),
        "fault_median": np.median(faults, axis=0),
        "fault_max": faults.max(axis=0),
    }


def assert_summary(summary: mw.SafetySummary, expected: dict[str, Any]) -> None:
    for name, value in expected.items():
        np.testing.assert_allclose(getattr(summary, name), value, rtol=1e-6, err_msg=name)


def assert_same(one: mw.SafetyMonitor, other: mw.SafetyMonitor) -> None:
    assert_summary(one.summary(), vars(other.summary()))


@pytest.mark.parametrize("max_steps", [1, 20])
@pytest.mark.parametrize("name", NAMES)
def test_recordings_agree_with_plain_counts(name: str, max_steps: int) -> None:
    config, seeds = config_of(name, obstacles=0.1, max_steps=max_steps), range(5)
    monitor = mw.SafetyMonitor()
    for seed in seeds:
        monitor.add_episode(mw.record_actions(config, rows_of(config, seed), seed=seed))
    assert_summary(monitor.summary(), counted(config, seeds))


@pytest.mark.parametrize("name", NAMES)
def test_rollouts_agree_with_recordings(name: str) -> None:
    config, matches = config_of(name), mw.Matches.of(0, 0, range(4))
    rolled, recorded = mw.SafetyMonitor(), mw.SafetyMonitor()
    rolled.add_statistics(mw.rollout(config, "random", "fleer", matches, episodes=2))
    for seed in range(4):
        for episode in range(2):
            recorded.add_episode(mw.record(config, "random", "fleer", seed=seed, episode=episode))
    assert_same(rolled, recorded)


@pytest.mark.parametrize("mode", ["NextStep", "SameStep", "Disabled"])
def test_vector_environments_agree_with_recordings(mode: str) -> None:
    config = config_of("SDB", max_steps=6)
    vector, recorded = mw.SafetyMonitor(), mw.SafetyMonitor()
    env = mw.VectorEnv(config, 3, autoreset_mode=mode)
    env.reset(seed=4)
    rows = random_actions(1, 5, 6, 3, config.n_agents)
    for row in rows:
        *_, infos = env.step(row)
        vector.add_infos(infos)
    for w in range(3):
        recorded.add_episode(mw.record_actions(config, rows[:, w], seed=4 + w))
    assert vector.episodes == 3
    assert_same(vector, recorded)


def two_episodes() -> mw.SafetyMonitor:
    monitor = mw.SafetyMonitor()
    one = [[[1, 2, 0], [0, 0, 4]], [[3, 0, 0], [0, 0, 0]]]
    monitor.add(one, np.array(one) // 2, [[100, 50], [100, 150]], [1.0, 0.5])
    return monitor


def test_numbers_by_hand() -> None:
    summary = two_episodes().summary()
    assert summary.episodes == 2
    assert summary.agent_steps.tolist() == [200, 200]
    assert summary.capture_rate == 0.75
    assert summary.involved_rate.tolist() == [[20, 10, 0], [0, 0, 20]]
    assert summary.fault_rate.tolist() == [[5, 5, 0], [0, 0, 10]]
    assert summary.safe_share.tolist() == [[0.5, 0.5, 1], [1, 1, 0.5]]
    assert summary.safe_episodes == 0
    assert summary.fault_max.tolist() == [[1, 1, 0], [0, 0, 2]]
    assert summary.fault_mean.tolist() == [[0.5, 0.5, 0], [0, 0, 1]]
