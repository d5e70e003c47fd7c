"""Collisions over many episodes, from wherever these come, and compared with counts by hand."""

import numpy as np
import pytest

import matrixworld as mw
from rows import config_of, random_actions


def assert_same(one, other):
    found = one.summary()
    for name, value in vars(other.summary()).items():
        np.testing.assert_allclose(getattr(found, name), value, rtol=1e-6, err_msg=name)


@pytest.mark.parametrize("name", ["D", "SB", "SDB", "TO", "swarm-S"])
def test_recordings_agree_with_rollouts(name):
    """The statistics of rollouts are counted in cpp/tests/random_rollouts.cpp."""
    for max_steps in (1, 20):
        config, matches = config_of(name, max_steps=max_steps), mw.Matches.of(0, 0, range(2))
        rolled, recorded = mw.SafetyMonitor(), mw.SafetyMonitor()
        rolled.add_statistics(mw.rollout(config, "random", "fleer", matches, episodes=2))
        for seed in range(2):
            for episode in range(2):
                played = mw.record(config, "random", "fleer", seed=seed, episode=episode)
                recorded.add_episode(played)
        assert_same(rolled, recorded)


@pytest.mark.parametrize("mode", ["NextStep", "SameStep", "Disabled"])
def test_vector_environments_agree_with_recordings(mode):
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


def test_numbers_by_hand():
    monitor = mw.SafetyMonitor()
    involved = np.array([[[1, 2, 0], [0, 0, 4]], [[3, 0, 0], [0, 0, 0]], [[3, 0, 0], [0, 0, 0]]])
    monitor.add(involved, involved // 2, [[100, 50], [50, 100], [50, 50]], [1.0, 0.5, 0.0])
    summary = monitor.summary()
    assert summary.episodes == 3
    assert summary.agent_steps.tolist() == [200, 200]
    assert summary.capture_rate == 0.5
    assert summary.involved_rate.tolist() == [[35, 10, 0], [0, 0, 20]]
    assert summary.fault_rate.tolist() == [[10, 5, 0], [0, 0, 10]]
    assert summary.safe_share.tolist() == [[1 / 3, 2 / 3, 1], [1, 1, 2 / 3]]
    assert summary.safe_episodes == 0
    assert summary.fault_max.tolist() == [[1, 1, 0], [0, 0, 2]]
    assert summary.fault_median.tolist() == [[1, 0, 0], [0, 0, 0]]
    assert summary.fault_mean.tolist() == [[2 / 3, 1 / 3, 0], [0, 0, 2 / 3]]
