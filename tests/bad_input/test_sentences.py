"""Mistakes that users make first: the exception, what was expected; and nothing has changed."""

import numpy as np
import pytest

import matrixworld as mw
from matrixworld.play.functions import PlayerError
from rows import random_genome

SMALL = {"rows": 3, "cols": 4, "n_pursuers": 2, "n_evaders": 1}
CONFIG = mw.WorldConfig(**SMALL, fov=5)
NETWORK = mw.Network.for_config(CONFIG, (4,))
GENOME = random_genome(NETWORK, 0)
TEAM = mw.Population(np.stack([GENOME, GENOME]), NETWORK)
MATCH = mw.Matches.of(0, 0, 0)
SPOILT = TEAM.genomes.copy()
SPOILT[1, 17] = np.nan
DIAGONAL = mw.WorldConfig(**SMALL, fov=5, diagonal=True)


def value(call, says):
    """Return a case of a wrong value; `says` is ``"expected part | got part"`` of the message."""
    return pytest.param(call, ValueError, says, id=says)


def kind(call, says):
    return pytest.param(call, TypeError, says, id=says)


def table(cases):
    return pytest.mark.parametrize(("call", "error", "says"), cases)


def assert_refuses(call, error, says):
    """Check the type of the exception, and both parts of its message."""
    expected, received = says.split(" | ")
    with pytest.raises(error) as caught:
        call()
    message = str(caught.value)
    # A subclass could be an accident, such as UnicodeDecodeError.
    assert type(caught.value) in (error, PlayerError)
    assert f"expected {expected}" in message, message
    assert received in message, message


def config(**field):
    return lambda: mw.WorldConfig(**SMALL | field)


def with_buffer(name, array):
    return lambda: mw.Batch(2, CONFIG, buffers={name: array})


def score(**arguments):
    usual = {"policy": lambda seen: [0] * len(seen), "team": "pursuer", "episodes": 2}
    return lambda: mw.score_policy(config=CONFIG, **{**usual, **arguments})


VALUES = [
    value(config(rules="Q"), "one of D, R, B, O, S | got 'Q'"),
    value(config(n_pursuers=12), "at least 13 cells (rows x cols) for 12 | got 3 x 4"),
    value(config(obstacles=1.0), "a number in [0, 1) | got 1.0"),
    value(config(obstacles=0.9), "at most 1 agents | got 3"),
    value(config(obstacles=np.zeros((4, 3), bool)), "shape (3, 4) | got (4, 3)"),
    value(config(obstacles=[[0, 2, 0, 0]] * 3), "0 (free) or 1 (obstacle) | got 2"),
    value(lambda: mw.Rewards(pursuer_collide=(1, 2)), "1 or 3 numbers | got (1, 2)"),
    value(lambda: NETWORK.layers(GENOME[:-1]), "shape (329,) | got (328,)"),
    value(lambda: mw.Population(TEAM.genomes[:, :9], NETWORK), "shape (n >= 1, 329) | got (2, 9)"),
    value(lambda: mw.Population(SPOILT, NETWORK), "finite numbers | got nan"),
    value(lambda: mw.Matches.of(0, [2, -1], 0), "at least 0 | got -1"),
    value(lambda: mw.Matches.of([[0]], 0, 0), "one axis | got shape (1, 1)"),
    value(lambda: mw.rollout(CONFIG, "stalker", TEAM, MATCH), "one of random | got 'stalker'"),
    kind(lambda: mw.rollout(CONFIG, TEAM, GENOME, MATCH), "the name of a script | evaders"),
    value(lambda: mw.rollout(DIAGONAL, "still", TEAM, MATCH), "a network for fov 5 | 5 actions"),
    value(lambda: mw.rollout(CONFIG, TEAM, TEAM, MATCH, episodes=0), "at least 1 | got 0"),
    value(lambda: mw.record(CONFIG, TEAM, TEAM, seed=0, evader=2), "0 to 1 | evader: expected"),
    value(lambda: mw.Batch(2, CONFIG, threads=0), "1 to 1024 | got 0"),
    value(with_buffer("reward", np.zeros((2, 3), np.float32)), "some of positions | ['reward']"),
    kind(with_buffer("rewards", np.zeros((2, 3), ">f4")), "dtype float32 | got >f4"),
    value(with_buffer("positions", np.zeros((2, 4, 2), np.int32)), "shape (2, 3, 2) | (2, 4, 2)"),
    value(with_buffer("positions", np.zeros((2, 3, 4), "i4")[:, :, ::2]), "a writeable C | pos"),
    value(score(episodes=1), "at least 2 | got 1"),
    value(score(policy=lambda seen: [1]), "an action, an integer from 0 | probabilities"),
    value(score(opponents={"mad": "mad"}), "one of random | opponents"),
    value(score(opponents={}), "at least one | got none"),
    # Environments
    value(lambda: mw.VectorEnv("O", 0), "at least 1 | got 0"),
    value(lambda: mw.VectorEnv(dtype=np.float64), "one of uint8, float32 | float64"),
    value(lambda: mw.parallel_env(dtype="u1", observation="named"), "one of float32 | uint8"),
    value(lambda: mw.VectorEnv("O", fov=1, action_mask=True), "a fov | 1"),
    value(lambda: mw.VectorEnv("O", 4).world(4), "0 to 3 | got 4"),
    value(lambda: mw.VectorEnv().reset(options={"map": 1}), "some of | map"),
    value(lambda: mw.AgentVectorEnv(mw.VectorEnv(), "both"), "one of | both"),
    value(lambda: mw.AgentVectorEnv(mw.VectorEnv(evaders="fleer"), "evader"), "the | evader"),
    value(lambda: mw.AgentEnv("O", agent="prey"), "one of pursuer_0 | got 'prey'"),
    value(lambda: mw.parallel_env(evaders="flier"), "one of | evaders"),
    kind(lambda: mw.parallel_env(pursuers=3), "the name | pursuers"),
    value(lambda: mw.parallel_env(evaders=[]), "at least one | evaders"),
    value(lambda: mw.parallel_env(evaders="fleer", pursuers="chaser"), "one | pursuers, evaders"),
    value(lambda: mw.parallel_env(evaders="evolved-1", fov=5), "a policy for fov 5 | evaders"),
    # Their order is not the same in every process.
    kind(lambda: mw.parallel_env(evaders={"still", "random"}), "a sequence | evaders"),
    value(lambda: mw.parallel_env(evaders=""), "one of | evaders"),  # no current directory
    # Maps
    value(lambda: mw.read_map([]), "at least one row | got []"),
    value(lambda: mw.read_map(["...", ".."]), "3 cells as in row 0 | row 1"),
    value(lambda: mw.read_map(["..?", "..x"]), "'.GS' (free) or '#@OTW' (obstacle) | row 0"),
    kind(lambda: mw.read_map([[True], ["."]]), "a path, rows of text or an array | True"),
]


@table(VALUES)
def test_values_are_refused(call, error, says):
    assert_refuses(call, error, says)


HEADER = "type octile\nheight 2\nwidth 3\nmap\n"
FILES = [
    value("...\n.#.\n", "a MovingAI map | got ['...', '.#.']"),
    value(HEADER, "at least one row | got []"),
    value(HEADER.replace("3", "-3") + "...\n...\n", "(2, -3) cells | got (2, 3)"),
    value(HEADER + "....\n....\n", "(2, 3) cells as in its header | got (2, 4)"),
    value(HEADER.replace("2", "two") + "...\n...\n", "(two, 3) cells | got (2, 3)"),
    value(HEADER + "..é\n...\n", "'.GS' (free) | row 0"),
]


@table(FILES)
def test_map_files(tmp_path, call, error, says):
    path = tmp_path / "broken.map"
    path.write_text(call, encoding="utf-8")
    assert_refuses(lambda: mw.read_map(path), error, says)
    with pytest.raises(error, match="broken"):
        mw.WorldConfig(obstacles=str(path))


def test_maps_are_read_in_all_forms(tmp_path):
    expected = np.array([[False, False, True], [True, False, False]])
    for same in (
        "..#\n#..",
        "\n..# \r\n#..\n",
        ["..#", "#.. "],
        [[0, 0, 1], [1, 0, 0]],
        expected.astype(np.uint8),
        expected.tolist(),
    ):
        np.testing.assert_array_equal(mw.read_map(same), expected)
    path = tmp_path / "x.map"
    for encoding in ("utf-8", "utf-8-sig"):
        for header in (HEADER, HEADER.replace(" ", "\t  ") + "\n", HEADER.replace("2", "02 ")):
            path.write_text(header + "..@ \r\nT..\n\n \n", encoding=encoding)
            np.testing.assert_array_equal(mw.read_map(path), expected)
    world = mw.World(obstacles=path, n_pursuers=1, n_evaders=1)
    world.reset(obstacles=str(path))
    np.testing.assert_array_equal(world.map, expected)
    path.write_text(HEADER + ".GS\nOTW\n")
    assert mw.read_map(path).tolist() == [[False] * 3, [True] * 3]


HOLE = ["....", ".#..", "...."]
WORLD_CALLS = [
    value(lambda w: w.step([0, 0]), "shape (3,) | got (2,)"),
    kind(lambda w: w.step([0.0, 1, 2]), "an integer | got 0.0"),
    value(lambda w: w.step([0, 2**63, np.uint64(1)]), "-9223372036854775808 to | 92233720368547"),
    value(lambda w: w.step([mw.Action.NORTHEAST, 0, 0]), "0 to 4 | got 5 (world 0, agent 0)"),
    value(lambda w: w.reset(-1), "at least 0 | got -1"),
    value(lambda w: w.reset(episode=3), "a seed with it | got episode 3"),
    value(lambda w: w.reset(evaders=[[0, 1, 2]]), "shape (1, 2) | (1, 3)"),
    value(lambda w: w.reset(pursuers=[[1, 2], [1, 2]]), "distinct cells | two agents on (1, 2)"),
    value(lambda w: w.reset(evaders=[[2**40, 0]]), "-2147483648 to 2147483647 | got 1099511627776"),
    value(lambda w: w.reset(evaders=[[1, 1]], obstacles=HOLE), "a free cell | position (1, 1)"),
    value(lambda w: w.reset(obstacles=["...", "..."]), "shape (3, 4) | got (2, 3)"),
    value(lambda w: w.reset(obstacles=["####", "####", "##.."]), "at least 3 free cells | got 2"),
]


@table(WORLD_CALLS)
def test_a_world_refuses_and_stays_as_it_was(call, error, says):
    world, twin = mw.World(CONFIG), mw.World(CONFIG)
    for each in (world, twin):
        each.reset(pursuers=[[0, 0], [0, 1]], evaders=[[2, 3]])
        each.step([mw.Action.EAST, mw.Action.WEST, mw.Action.EAST], explain=True)
    assert_refuses(lambda: call(world), error, says)
    assert world.conflicts == twin.conflicts
    for _ in range(2):
        for name, expected in twin.read(*mw.array_specs(CONFIG)).items():
            np.testing.assert_array_equal(world.read(name)[name], expected)
        world.reset()
        twin.reset()


ZEROS = np.zeros((2, 3), int)
BATCH_CALLS = [
    value(lambda b: b.step(ZEROS[0]), "shape (2, 3) | got (3,)"),
    value(lambda b: b.step([[0, 0, 0], [4, 5, 4]]), "0 to 4 | got 5 (world 1, agent 1)"),
    value(lambda b: b.reset([1]), "shape (2,) | got (1,)"),
    value(lambda b: b.reset([5, -3]), "at least 0 | got -3"),
    kind(lambda b: b.reset(mask=[1, 0]), "dtype bool | got int64"),
    value(lambda b: b.reset(mask=[True] * 3), "shape (2,) | got (3,)"),
    value(lambda b: b.reset(pursuers=np.zeros((2, 0, 2), int)), "shape | got (2, 0, 2)"),
]


@table(BATCH_CALLS)
def test_a_batch_refuses_and_stays_as_it_was(call, error, says):
    batch, twin = mw.Batch(2, CONFIG), mw.Batch(2, CONFIG)
    assert_refuses(lambda: call(batch), error, says)
    for action in (mw.Action.WEST, mw.Action.NORTH):
        for name, array in twin.buffers.items():
            np.testing.assert_array_equal(batch.buffers[name], array)
        for each in (batch, twin):
            each.step(ZEROS + action)
