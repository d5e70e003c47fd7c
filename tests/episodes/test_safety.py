"""Collisions over many episodes, compared with counts by hand and by plain loops."""

from typing import Any

import numpy as np
import pytest

import matrixworld as mw
from rows import by_name, config_of, random_actions

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


# ---- Where episodes come from --------------------------------------------------------------------


@pytest.mark.parametrize("max_steps", [1, 20])
@pytest.mark.parametrize("name", NAMES)
def test_all_sources_agree_with_plain_counts(name: str, max_steps: int) -> None:
    config, seeds = config_of(name, obstacles=0.1, max_steps=max_steps), range(5)
    by_status, by_record, by_turn = (mw.SafetyMonitor() for _ in range(3))
    for seed in seeds:
        rows = rows_of(config, seed)
        by_record.add_episode(mw.record_actions(config, rows, seed=seed))
        env = mw.parallel_env(config)
        env.reset(seed=seed)
        for row in rows:
            if env.agents:
                env.step(by_name(env, row))
                by_status.observe(env.status)
        turns = mw.aec_env(config)
        turns.reset(seed=seed)
        for agent in turns.agent_iter():
            _, _, terminated, truncated, info = turns.last()
            row = rows[min(info["step"], len(rows) - 1)]
            action = int(row[turns.possible_agents.index(agent)])
            turns.step(None if terminated or truncated else action)
            by_turn.observe(turns.status)
    expected = counted(config, seeds)
    for monitor in (by_status, by_record, by_turn):
        assert_summary(monitor.summary(), expected)


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


# ---- Numbers -----------------------------------------------------------------------------------


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


def test_an_unfinished_episode_is_forgotten_and_a_missing_step_refused() -> None:
    env = mw.parallel_env(config_of("R", max_steps=3))
    monitor, whole = mw.SafetyMonitor(), mw.SafetyMonitor()
    for steps, seed in ((2, 1), (3, 0)):
        env.reset(seed=seed)
        for _ in range(steps):
            env.step(dict.fromkeys(env.agents, 2))
            monitor.observe(env.status)
    whole.add_episode(mw.record_actions(env.config, np.full((3, env.config.n_agents), 2)))
    assert_same(monitor, whole)
    env.reset()
    env.step(dict.fromkeys(env.agents, 0))
    env.step(dict.fromkeys(env.agents, 0))
    with pytest.raises(ValueError, match="expected step 1, got step 2"):
        monitor.observe(env.status)
