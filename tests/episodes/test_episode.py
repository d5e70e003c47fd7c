"""Recorded episodes: arrays, files, refused input, and what is recorded while it is played."""

import dataclasses
import os

import numpy as np
import pytest

import matrixworld as mw
from matrixworld._util.files import DamagedFileError
from matrixworld.episodes.episode import MOMENT_ARRAYS, STEP_ARRAYS, Episode
from rows import NAMES, config_of, play_turns, random_walks

EPISODE = random_walks()
ARRAYS = [name for name, value in vars(EPISODE).items() if isinstance(value, np.ndarray)]


def test_round_trip(tmp_path):
    episode, path = EPISODE, tmp_path / "an episode"
    episode.save(path)
    loaded, written = Episode.load(path), path.read_bytes()
    assert (loaded.n_pursuers, loaded.config) == (episode.n_pursuers, episode.config)
    for name in ARRAYS:
        np.testing.assert_array_equal(getattr(loaded, name), getattr(episode, name))
        assert getattr(loaded, name).dtype == getattr(episode, name).dtype
    episode.save(path)
    assert path.read_bytes() == written
    assert os.listdir(tmp_path) == [path.name]
    with pytest.raises(ValueError, match=r"^path: expected a name that ends in \.npz, got .*gif"):
        episode.save(tmp_path / "x.gif")


@pytest.mark.parametrize(
    "changes",
    [
        {"format": np.array("payoffs 1")},
        {"payoff": np.zeros(3)},
        {"seat": np.array(99)},
        {"map": np.array([{}], object)},
        {"alive": np.zeros((30, 12), bool)},
        {"positions": None},
        {"config": np.array("[]")},
        {"n_pursuers": np.array([1, 2])},
    ],
)
def test_foreign_archives_are_refused(changes, tmp_path):
    EPISODE.save(tmp_path / "foreign.npz")
    with np.load(tmp_path / "foreign.npz") as stored:
        changed = {**stored, **changes}
    entries = {name: each for name, each in changed.items() if each is not None}
    np.savez(tmp_path / "foreign.npz", **entries)
    with pytest.raises(DamagedFileError, match=r"foreign\.npz: "):
        Episode.load(tmp_path / "foreign.npz")


@pytest.mark.parametrize("name", ARRAYS)
def test_wrong_dtypes_and_shapes_are_refused(name):
    array = getattr(EPISODE, name)
    for wrong in (array.astype(complex), array.tolist()):
        with pytest.raises(TypeError, match=f"^{name}: expected an array of"):
            dataclasses.replace(EPISODE, **{name: wrong})
    with pytest.raises(ValueError, match="expected shape"):
        dataclasses.replace(EPISODE, **{name: array[None]})


def explained(*rows):
    return dataclasses.replace(EPISODE, conflict_table=np.array(rows, np.int32).reshape(-1, 11))


def test_conflicts_are_kept_in_files_and_told_by_step(tmp_path):
    episode = explained(
        (4, 0, 1, 0, 0, 3, 2, 5, 3, 3, 0), (4, 0, 0, 0, 7, -1, -1, 3, 1, 0, 1), (9,) + (0,) * 10
    )
    episode.save(tmp_path / "kept.npz")
    for each in (episode, Episode.load(tmp_path / "kept.npz")):
        assert list(map(str, each.explain(4))) == [
            "pursuer_0 and pursuer_3 both headed for (2, 5): both bounce",
            "evader_2 ran into the obstacle or border at (-1, 3): evader_2 disappears",
        ]
        assert each.explain(4) == each.explain(-27)
        assert each.explain(5) == []
    assert explained().explain() == []
    with pytest.raises(ValueError, match="^conflict_table: expected a recording with conflicts"):
        EPISODE.explain(3)


def assert_same(one, other):
    for name in (*MOMENT_ARRAYS, *STEP_ARRAYS, "map"):
        np.testing.assert_array_equal(getattr(one, name), getattr(other, name), name)
    acted = one.alive[:-1]  # actions of gone agents have no meaning
    np.testing.assert_array_equal(one.actions[acted], other.actions[acted])
    assert one.config == other.config


@pytest.mark.parametrize("name", NAMES)
def test_an_episode_is_what_a_world_does_with_its_actions(name):
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


def test_the_aec_environment_records_whole_rounds_and_conflicts():
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
    env.reset()
    assert env.unwrapped.recorded.length == 0


def test_a_recorder_refuses_missing_rounds():
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
