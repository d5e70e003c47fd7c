"""Episodes recorded while they are played, and replayed from their actions."""

import numpy as np
import pytest

import matrixworld as mw
from matrixworld.episodes.episode import MOMENT_ARRAYS, STEP_ARRAYS
from rows import NAMES, by_name, config_of, play_turns, random_actions


def assert_same(one: mw.Episode, other: mw.Episode) -> None:
    for name in (*MOMENT_ARRAYS, *STEP_ARRAYS, "map"):
        np.testing.assert_array_equal(getattr(one, name), getattr(other, name), name)
    acted = one.alive[:-1]  # actions of gone agents have no meaning
    np.testing.assert_array_equal(one.actions[acted], other.actions[acted])
    assert one.config == other.config


@pytest.mark.parametrize("name", NAMES)
def test_an_episode_is_what_a_world_does_with_its_actions(name: str) -> None:
    config = config_of(name, obstacles=0.1, diagonal=True)
    episode = mw.record(config, "random", "fleer", seed=12, episode=3)
    world = mw.World(config)
    world.reset(12, episode=3)
    np.testing.assert_array_equal(episode.map, world.map)
    told = [[]]
    for step in range(episode.length + 1):
        for what in MOMENT_ARRAYS:
            np.testing.assert_array_equal(getattr(episode, what)[step], getattr(world, what))
        assert episode.explain(step) == told[-1]
        if step < episode.length:
            world.step(episode.actions[step], explain=True)
            told.append(world.conflicts)
            for what in STEP_ARRAYS:
                np.testing.assert_array_equal(getattr(episode, what)[step], getattr(world, what))
    assert world.terminated or world.truncated
    assert episode.explain() == told[-1]
    assert any(told)
    for step in (episode.length + 1, -episode.length - 2):
        with pytest.raises(IndexError, match="^step:"):
            episode.explain(step)


@pytest.mark.parametrize("name", ["D", "SD", "TO"])
def test_an_environment_records_its_episode(name: str) -> None:
    config = config_of(name, obstacles=0.1)
    env = mw.parallel_env(config, record=True)
    env.reset(seed=12)
    rows = random_actions(1, config.n_actions, config.max_steps, config.n_agents)
    for row in rows:
        if env.agents:
            env.step(by_name(env, row))
    assert_same(env.recorded, mw.record_actions(config, rows, seed=12))
    env.reset()
    assert env.recorded.length == 0


def test_the_aec_environment_records_whole_rounds_and_conflicts() -> None:
    config = config_of("TO", obstacles=0.1)
    env = mw.aec_env(config, record=True)
    env.reset(seed=4)
    rng = np.random.default_rng(0)
    play_turns(env, lambda agent, _: int(rng.integers(5)))
    kept = env.unwrapped.recorded
    again = mw.record_actions(config, kept.actions, seed=4)
    assert_same(kept, again)
    np.testing.assert_array_equal(kept.conflict_table, again.conflict_table)
    assert kept.conflict_table[:, 1].max() > 0  # later turns of a round are there


def test_a_recorder_refuses_missing_rounds() -> None:
    world = mw.World("TO", rows=6, cols=6, n_pursuers=2, n_evaders=2)
    recorder = mw.Recorder(world)
    with pytest.raises(RuntimeError, match="this is note 1, and the world has played 0"):
        recorder.note([0] * 4)
    world.step([0] * 4)
    for actions, error in (([0] * 3, ValueError), ([0.5] * 4, TypeError)):
        with pytest.raises(error, match="^actions:"):
            recorder.note(actions)
    recorder.note([0] * 4)
    with pytest.raises(RuntimeError, match="this is note 2, and the world has played 1"):
        recorder.note([0] * 4)
    world.reset(3)
    world.step([0] * 4)
    with pytest.raises(RuntimeError, match=r"expected begin\(\) after a reset"):
        recorder.note([0] * 4)
    assert recorder.episode().length == 1
    world.play_turn([0] * 4)
    with pytest.raises(RuntimeError, match=r"expected begin\(\) between two rounds, got turn 1"):
        recorder.begin()
