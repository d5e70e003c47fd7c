"""Worlds and batches: starts, seeds, settings, maps, text, penalties, turn by turn, and copies.

That a batch plays as single worlds do, by any number of threads, is shown in ``cpp/tests``.
"""

import copy
import dataclasses
import json
import pickle

import numpy as np
import pytest
from scipy import stats

import matrixworld as mw
from matrixworld import _core
from matrixworld.world.arrays import array_specs, new_arrays
from rows import NAMES, assert_same_worlds, config_of, random_actions


def small(**changes):
    return mw.World(**({"rows": 3, "cols": 4, "n_pursuers": 2, "n_evaders": 1} | changes))


def test_the_same_seed_gives_the_same_episode_whatever_was_played_before():
    config = config_of("SDB", obstacles=0.1, max_steps=3)
    new, played = mw.World(config), mw.World(config)
    first = played.positions
    for actions in random_actions(2, 5, 3, config.n_agents):
        played.step(actions)
    assert played.truncated
    for world in (new, played):
        world.reset(77)
    assert not np.array_equal(new.positions, first)
    for actions in random_actions(1, 5, 3, config.n_agents):
        assert_same_worlds(new, played)
        new.step(actions)
        played.step(actions, explain=True)  # which changes nothing else
    assert_same_worlds(new, played)


@pytest.mark.parametrize(("always", "count"), [(["....", ".##.", "...."], 2), (0.5, 6)])
def test_obstacles_for_one_episode(always, count):
    world = small(obstacles=always)
    for once in (["#...", "....", "...."], np.zeros((3, 4), bool)):
        assert world.map.sum() == count
        world.reset(obstacles=once)
        np.testing.assert_array_equal(world.map, mw.read_map(once))
        world.reset()
    assert world.map.sum() == count


def test_conflicts_are_kept_only_with_explain():
    world = small()
    world.step([0, 0, 0], explain=True)
    assert world.conflicts == []
    for call in (lambda: world.step([0, 0, 0]), world.reset):
        call()
        with pytest.raises(RuntimeError, match="explain=True"):
            _ = world.conflicts


@pytest.mark.parametrize("of", [list, tuple, mw.read_map])
def test_a_map_gives_the_size_and_is_the_config_s_own(of):
    ground = of(["..#..", "....."])
    config = mw.WorldConfig("SB", obstacles=ground, n_pursuers=2, n_evaders=2)
    assert (config.rows, config.cols, config.density) == (2, 5, 0)
    if isinstance(ground, np.ndarray):
        ground[:] = True
    assert config.map is not None
    assert config.map.dtype == bool
    assert config.map.tolist() == [[False, False, True, False, False], [False] * 5]


@pytest.mark.parametrize(
    "config",
    [
        mw.WorldConfig("SDB", rows=np.int64(9), obstacles=np.float32(0.25)),
        mw.WorldConfig("O", obstacles=["..#", "...", "#.."], n_pursuers=2, n_evaders=2),
        mw.WorldConfig("TO", rewards=mw.Rewards(evader_step=np.float32(0.5), capture_repeats=True)),
    ],
)
def test_json(config):
    plain = json.loads(json.dumps(config.to_json()))
    assert set(plain) == {item.name for item in dataclasses.fields(config)}
    assert plain["rules"]["capture"] == config.rules.capture.name
    again = mw.WorldConfig.from_json(plain)
    assert again.rules == config.rules
    assert again.rewards == config.rewards
    assert again.to_json() == config.to_json()


def penalties_only(**changes):
    names = ("capture", "neighbor", "step")
    zero = {f"{team}_{name}": 0.0 for team in ("pursuer", "evader") for name in names}
    return mw.Rewards(**(zero | changes))


@pytest.mark.parametrize("name", ["D", "S", "SDB", "swarm-S", "agents-R"])
@pytest.mark.parametrize("blame", list(mw.Blame))
def test_penalties_agree_with_reported_fault_and_involvement(name, blame):
    by_kind = {"pursuer_collide": (-1, -20, -300), "evader_collide": [-2, -40, -600]}
    config = config_of(name, obstacles=0.1, rewards=penalties_only(**by_kind, blame=blame))
    world = mw.World(config)
    pursuers = np.arange(config.n_agents)[:, None] < config.n_pursuers
    tariff = np.where(pursuers, *by_kind.values())  # no two sums of these amounts are equal
    for actions in random_actions(9, config.n_actions, 30, config.n_agents):
        if world.terminated or world.truncated:
            world.reset()
        rewards = world.step(actions)
        to_blame = world.fault if blame is mw.Blame.FAULT else world.involved
        np.testing.assert_array_equal(rewards, (tariff * to_blame).sum(axis=1))


def test_equal_dtypes_are_one():
    """As those of arrays from a pickle, or of another integer of C of the same size."""
    world, batch = small(), mw.Batch(1, small().config)
    stay = np.zeros(3, np.int64)
    for row in (pickle.loads(pickle.dumps(stay)), stay.astype(np.longlong)):  # noqa: S301
        world.step(row)
        batch.step(row[None])
        batch.reset(mask=pickle.loads(pickle.dumps(np.array([True]))))  # noqa: S301


WORD = 2**64
KEYS = [(0, 0), (1, 0), (0, 1), (2**64 - 1, 2**63), (0x123456789ABCDEF, 0xFEDCBA987654321)]
COUNTERS = [(1, 0, 0, 0), (0, 1, 0, 0), (7, 500, 2, 0), (3, 2, 1, 2**64 - 1), (0, 0, 0, 0)]


def by_numpy(counter, key):
    """NumPy counts up before its first block."""
    number = sum(word * WORD**i for i, word in enumerate(counter)) - 1
    before = [(number % WORD**4) // WORD**i % WORD for i in range(4)]
    generator = np.random.Philox(counter=np.array(before, np.uint64), key=np.array(key, np.uint64))
    return [int(word) for word in generator.random_raw(4)]


@pytest.mark.parametrize("key", KEYS)
@pytest.mark.parametrize("counter", COUNTERS)
def test_philox_is_that_of_numpy(counter, key):
    assert _core.philox(counter, key) == by_numpy(counter, key)


N_WORLDS = 6000


def starts(config, *buffers):
    """Buffers of many worlds after a reset, of neighbouring seeds."""
    specs = mw.array_specs(config)
    arrays = {name: np.zeros((N_WORLDS, *specs[name][0]), specs[name][1]) for name in buffers}
    return mw.Batch(N_WORLDS, config, buffers=arrays).reset(11)


def is_uniform(numbers, n):
    return bool(stats.chisquare(np.bincount(numbers, minlength=n)).pvalue > 1e-3)


def test_agents_start_apart_and_know_nothing_of_each_other():
    """Ordered pairs of distinct cells are equally likely, so each agent starts anywhere, too."""
    config = mw.WorldConfig(rows=2, cols=4, n_pursuers=2, n_evaders=2)
    places = starts(config, "positions")["positions"] @ [config.cols, 1]
    for one in range(4):
        for other in range(one):
            first, second = places[:, one], places[:, other]
            assert (first != second).all()
            rank = second - (second > first)  # among the seven cells that are left
            assert is_uniform(first * 7 + rank, 56)


def test_obstacles_of_a_density_lie_anywhere():
    config = mw.WorldConfig(rows=4, cols=5, n_pursuers=1, n_evaders=1, obstacles=0.25)
    arrays = starts(config, "positions", "state")
    ground = arrays["state"][:, 2].reshape(N_WORLDS, 20)
    assert (ground.sum(axis=1) == 5).all()
    assert stats.chisquare(ground.sum(axis=0)).pvalue > 1e-3
    places = arrays["positions"] @ [5, 1]
    assert not np.take_along_axis(ground, places, axis=1).any()


OF_TURNS = {"SIMULTANEOUS": 1, "SWARM_TURNS": 2}


@pytest.mark.parametrize("name", NAMES)
def test_a_round_by_turns_is_a_step(name):
    config = config_of(name, obstacles=0.1)
    whole, by_turns = mw.World(config), mw.World(config)
    assert whole.n_turns == OF_TURNS.get(config.rules.interaction.name, config.n_agents)
    for actions in random_actions(3, config.n_actions, 20, config.n_agents):
        if whole.terminated or whole.truncated:
            break
        whole.step(actions, explain=True)
        acted = []
        for turn in range(by_turns.n_turns):
            assert by_turns.turn == turn
            acted += by_turns.actors
            by_turns.play_turn(actions, explain=True)
        assert acted == list(range(config.n_agents))
        assert_same_worlds(whole, by_turns)
        assert whole.conflicts == by_turns.conflicts


@pytest.mark.parametrize("name", NAMES)
def test_a_batch_by_turns_writes_what_its_worlds_would(name):
    """After each turn, also of rounds in whose middle some worlds end, and of none."""
    config, n = config_of(name, obstacles=0.1, max_steps=6), 5
    buffers = new_arrays(array_specs(config), n)
    batch, order = mw.Batch(n, config, threads=2, buffers=buffers), mw.World(config)
    batch.reset(5)
    worlds = [batch.world(w) for w in range(n)]
    for actions in random_actions(3, config.n_actions, 6, n, config.n_agents):
        going = [w for w, world in enumerate(worlds) if not (world.terminated or world.truncated)]
        for turn in range(batch.n_turns):
            assert (batch.turn, batch.actors) == (turn, order.actors)
            unread = np.full_like(actions, 99)
            unread[:, order.actors] = actions[:, order.actors]
            batch.play_turn(unread)
            order.play_turn(actions[0])
            for w in going:
                worlds[w].play_turn(actions[w])
                for each, array in worlds[w].read(*buffers).items():
                    np.testing.assert_array_equal(buffers[each][w], array, err_msg=each)
        order.reset(0)


def test_a_round_is_finished_as_it_was_begun():
    batch, world = mw.Batch(3, config_of("TO")), mw.World(config_of("TO"))
    for each, stay in ((batch, np.zeros((3, 7), int)), (world, np.zeros(7, int))):
        each.play_turn(stay)
        with pytest.raises(RuntimeError, match="turn 1 of 7 is next"):
            each.step(stay)
    with pytest.raises(RuntimeError, match="turn 1 of 7 is next"):
        batch.reset(1, mask=[True, False, False])
    for each in (batch, world):
        each.reset(1)
        assert each.turn == 0
    with pytest.raises(ValueError, match="expected DISABLED"):
        mw.Batch(3, autoreset=mw.Autoreset.SAME_STEP).play_turn(np.zeros((3, 38), int))


def test_a_mask_selects_the_worlds_to_reset():
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


def test_an_int_seeds_consecutive_worlds():
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


@pytest.mark.parametrize("name", ["SDB", "TO", "swarm-SD"])
def test_copies_continue_as_the_world_does(name):
    world = mw.World(config_of(name, obstacles=0.15, max_steps=40))
    world.reset(11, episode=4)
    twins = []
    for number, actions in enumerate(random_actions(6, 5, 60, world.config.n_agents)):
        if number in (1, 5, 17):  # also in the middle of a round
            twins += copy.deepcopy(world), pickle.loads(pickle.dumps(world))  # noqa: S301
        for each in (world, *twins):
            if not each.turn and (each.terminated or each.truncated):
                each.reset()
            each.play_turn(actions)
        for twin in twins:
            assert_same_worlds(world, twin)
