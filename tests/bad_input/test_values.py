"""Values that are no settings, networks, matches or batches: the exceptions and their messages."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import matrixworld as mw
from matrixworld.play.rollout import match_seed
from refusals import CONFIG, GENOME, NETWORK, SMALL, assert_refuses, kind, table, value

TEAM = mw.Population(np.stack([GENOME, GENOME]), NETWORK)
MATCH = mw.Matches.of(0, 0, 0)
EMPTY = np.zeros((0, 329), np.float32)
LONG = np.zeros((2, 330), np.float32)
SPOILT = TEAM.genomes.copy()
SPOILT[1, 17] = np.nan
INFINITE = np.full(329, np.inf, np.float32)


def value_of(field: str, given: Any, says: str) -> Any:
    """A wrong value of a field of a configuration."""
    return value(lambda: mw.WorldConfig(**SMALL | {field: given}), says)


def kind_of(field: str, given: Any, says: str) -> Any:
    """A value of a wrong type."""
    return kind(lambda: mw.WorldConfig(**SMALL | {field: given}), says)


SETTINGS = [
    value_of("rules", "Q", "one of D, R, B, O, S | got 'Q'"),
    value_of("rows", 0, "1 to 4096 | got 0"),
    value_of("rows", 4097, "1 to 4096 | got 4097"),
    kind_of("rows", 3.0, "an integer | got 3.0"),
    value_of("cols", 0, "1 to 4096 | got 0"),
    kind_of("cols", True, "an integer | got True"),  # a bool is an int in Python
    value_of("n_pursuers", 0, "1 to 12 | got 0"),
    value_of("n_pursuers", 13, "1 to 12 | got 13"),
    value_of("n_pursuers", 12, "at most 12 agents | got 13"),
    value_of("n_evaders", 0, "1 to 12 | got 0"),
    value_of("fov", 4, "an odd number | got 4"),
    value_of("fov", 257, "1 to 255 | got 257"),  # odd, so that only its size is wrong
    value_of("max_steps", 0, "1 to | got 0"),
    value_of("max_steps", 2**31, "-2147483647 to 2147483647 | got 2147483648"),
    value_of("obstacles", 1.0, "a number in [0, 1) | got 1.0"),
    value_of("obstacles", float("nan"), "a number in [0, 1) | got nan"),
    value_of("obstacles", 0.9, "at most 1 agents | got 3"),
    kind_of("obstacles", True, "a number in [0, 1) or a map | got True"),
    value_of("obstacles", np.ones((3, 4), bool), "at most 0 agents | got 3"),
    value_of("obstacles", np.zeros((4, 3), bool), "shape (3, 4) | got (4, 3)"),
    kind_of("obstacles", np.zeros((3, 4)), "dtype bool | got float64"),
    value(lambda: mw.World(obstacles=np.zeros((2, 5000), bool)), "1 to 4096 | got 5000"),
    kind(lambda: mw.Rules(obstacle="B"), "a matrixworld.Outcome | 'B'"),
    kind(lambda: mw.Rules(interaction=mw.Outcome.REACH), "a matrixworld.Interaction | got <Outc"),
    value(lambda: mw.Rewards(evader_step=float("nan")), "a finite number | got nan"),
    value(lambda: mw.Rewards(evader_step=1e39), "a finite | got 1e+39"),  # infinite as float32
    kind(lambda: mw.Rewards(pursuer_step=(1, 2, 3)), "a number | got (1, 2, 3)"),
    value(lambda: mw.Rewards(pursuer_collide=(1, 2)), "1 or 3 numbers | got (1, 2)"),
    kind(lambda: mw.Rewards(evader_collide=(1, 2, "x")), "a number | got 'x'"),
    value(lambda: mw.Rewards(evader_collide=(1, 2, np.inf)), "a finite number | got inf"),
]

NETWORKS = [
    value(lambda: mw.Network((0,)), "1 to 1048576 | got 0"),
    value(lambda: mw.Network((8, -1)), "1 to 1048576 | got -1"),
    value(lambda: mw.Network(fov=4), "an odd number | got 4"),
    value(lambda: mw.Network(fov=10**6 + 1), "1 to 255 | got 1000001"),
    value(lambda: mw.Network(n_actions=4), "5 or 9 | got 4"),
    value(lambda: mw.Network(activation="gelu"), "'relu' or 'tanh' | got 'gelu'"),
    value(lambda: mw.Network(memory="lstm"), "one of none, elman, gru | got 'lstm'"),
    value(lambda: mw.Network((), memory="gru"), "none without hidden layers | got 'gru'"),
    value(lambda: NETWORK.layers(GENOME[:-1]), "shape (329,) | got (328,)"),
    value(lambda: NETWORK.layers(TEAM.genomes), "shape (329,) | got (2, 329)"),
    value(
        lambda: NETWORK.logits(GENOME, np.zeros((6, 3, 7, 7), np.uint8)),
        "shape (n, 3, 5, 5) | got (6, 3, 7, 7)",
    ),
    kind(lambda: mw.Population(GENOME.astype(float), NETWORK), "dtype float32 | got float64"),
    value(lambda: mw.Population(LONG, NETWORK), "shape (n >= 1, 329) | got (2, 330)"),
    value(lambda: mw.Population(EMPTY, NETWORK), "shape (n >= 1, 329) | got (0, 329)"),
    value(
        lambda: mw.Population(TEAM.genomes[None], NETWORK), "shape (n >= 1, 329) | got (1, 2, 329)"
    ),
    value(lambda: mw.Population(SPOILT, NETWORK), "finite numbers | got nan (genome 1, number 17)"),
    value(lambda: mw.Population(INFINITE, NETWORK), "finite numbers | inf (genome 0, number 0)"),
]

DIAGONAL = mw.WorldConfig(**SMALL, fov=5, diagonal=True)
WIDE = mw.WorldConfig(**SMALL, fov=7)


def rollout(pursuers: Any, evaders: Any, config: Any = CONFIG, **more: Any) -> mw.EpisodeStatistics:
    return mw.rollout(config, pursuers, evaders, MATCH, **more)


def play(pursuers: Any, evaders: Any, pursuer: Any, evader: Any) -> mw.EpisodeStatistics:
    return mw.rollout(CONFIG, pursuers, evaders, mw.Matches.of(pursuer, evader, 0))


def record(pursuers: Any, evaders: Any, config: Any = CONFIG, **more: Any) -> mw.Episode:
    return mw.record(config, pursuers, evaders, **more)


MATCHES = [
    kind(lambda: mw.Matches.of([0.0], 0, 0), "an integer | got 0.0"),
    value(lambda: mw.Matches.of(0, [2, -1], 0), "0 to 2147483647 | got -1"),
    value(lambda: mw.Matches.of(0, 0, -1), "0 to 1844 | got -1"),
    value(lambda: mw.Matches.of(0, 0, 2**64), "0 to 1844 | got 18446744073709551616"),
    value(lambda: mw.Matches.of([[0]], 0, 0), "one axis | got shape (1, 1)"),
    value(lambda: rollout(TEAM, TEAM, episodes=0), "at least 1 | got 0"),
    value(lambda: rollout(TEAM, TEAM, threads=0), "1 to 1024 | got 0"),
    value(
        lambda: mw.rollout(CONFIG, "stalker", TEAM, MATCH),
        f"one of {', '.join(mw.SCRIPTS)} | got 'stalker'",
    ),
    kind(lambda: rollout(TEAM, GENOME), "a Population, a TablePolicy or the name | evaders: "),
    value(lambda: play(TEAM, TEAM, [1, 2], 0), "0 to 1 | pursuer: expected 0 to 1, got 2"),
    value(lambda: play(TEAM, TEAM, 0, 5), "0 to 1 | evader: expected 0 to 1, got 5"),
    value(lambda: play("still", TEAM, 1, 0), "0 to 0 | got 1"),
    value(
        lambda: rollout(TEAM, "still", WIDE),
        "a network for fov 7 and 5 actions | got fov 5 and 5 actions",
    ),
    value(
        lambda: rollout("still", TEAM, DIAGONAL), "a network for fov 5 and 9 actions | evaders: "
    ),
    value(lambda: record("still", "", seed=0), "one of random | got ''"),
    value(lambda: record(TEAM, TEAM, seed=0, evader=2), "0 to 1 | evader: expected 0 to 1, got 2"),
    value(lambda: record(TEAM, TEAM, seed=0, pursuer=-1), "at least 0 | got -1"),
    value(lambda: record(TEAM, TEAM, seed=1, episode=-1), "0 to 1844 | got -1"),
    value(lambda: match_seed(1, -2), "0 to 1844 | got -2"),
]


def with_buffer(name: str, array: Any) -> mw.Batch:
    return mw.Batch(2, CONFIG, buffers={name: array})


def read_only() -> np.ndarray:
    array = np.zeros((2, 3), np.float32)
    array.flags.writeable = False
    return array


BATCHES = [
    value(lambda: mw.Batch(0, CONFIG), "at least 1 | got 0"),
    value(lambda: mw.Batch(2, CONFIG, threads=0), "1 to 1024 | got 0"),
    value(lambda: mw.Batch(2, threads=10**6), "1 to 1024 | got 1000000"),
    value(
        lambda: with_buffer("reward", np.zeros((2, 3), np.float32)),
        "some of positions, last_positions, alive | got ['reward']",
    ),
    kind(lambda: with_buffer("rewards", np.zeros((2, 3))), "dtype float32 | rewards: expected"),
    # The other order of bytes.
    kind(lambda: with_buffer("rewards", np.zeros((2, 3), ">f4")), "dtype float32 | got >f4"),
    value(
        lambda: with_buffer("positions", np.zeros((2, 4, 2), np.int32)),
        "shape (2, 3, 2) | positions: expected shape (2, 3, 2), got (2, 4, 2)",
    ),
    value(
        lambda: with_buffer("positions", np.zeros((2, 3, 4), np.int32)[:, :, ::2]),
        "a writeable C-contiguous array | positions",
    ),
    value(lambda: with_buffer("rewards", read_only()), "a writeable C-contiguous array | rewards"),
    kind(lambda: with_buffer("steps", [0, 0]), "a NumPy array | got list"),
]


@table([*SETTINGS, *NETWORKS, *MATCHES, *BATCHES])
def test_values_are_refused(call: Any, error: type[Exception], says: str) -> None:
    assert_refuses(call, error, says)


def test_these_teams_can_play() -> None:
    assert play(TEAM, TEAM, 1, [0, 1]).length.shape == (2, 1)
    assert record(TEAM, "still", seed=0, pursuer=1).n_pursuers == 2


def test_unknown_fields_are_named() -> None:
    for call in (mw.WorldConfig, mw.World, lambda **more: mw.Batch(1, CONFIG, **more)):
        with pytest.raises(TypeError, match="n_predators"):
            call(n_predators=3)


# Maps

HEADER = "type octile\nheight 2\nwidth 3\nmap\n"
TEXTS = [
    value([], "at least one row | got []"),
    value(["", ""], "at least one row | got ['', '']"),
    value(["...", "..", "..."], "3 cells as in row 0 | row 1: expected 3 cells as in row 0, got 2"),
    value(["..?", "..x"], "'.GS' (free) or '#@OTW' (obstacle) | row 0"),
    value(np.zeros(3, bool), "shape (rows, cols) | got (3,)"),
    value(np.zeros((0, 3), bool), "shape (rows, cols) | got (0, 3)"),
    kind(np.zeros((2, 3), np.uint8), "dtype bool | got uint8"),
    kind(3, "a bool array, rows of text or a path | got 3"),
    kind([[True, False]], "a bool array, rows of text or a path | got [[True, False]]"),
]
FILES = [
    value("", "a MovingAI map | got []"),
    value("...\n.#.\n", "a MovingAI map | got ['...', '.#.']"),
    value(HEADER.replace("map", ""), "a MovingAI map | got ['type octile', 'height 2', 'width 3']"),
    value(HEADER.replace("height", "depth") + "...\n...\n", "a MovingAI map | 'depth 2'"),
    value(HEADER, "at least one row | got []"),
    value(HEADER + "...\n", "(2, 3) cells as in its header | got (1, 3)"),
    value(HEADER + "....\n....\n", "(2, 3) cells as in its header | got (2, 4)"),
    value(HEADER.replace("2", "two") + "...\n...\n", "(two, 3) cells | got (2, 3)"),
    value(HEADER + "...\n..\n", "3 cells as in row 0 | row 1: expected 3 cells"),
    value(HEADER + "..!\n...\n", "'.GS' (free) | got ['!']"),
    value(HEADER + "..é\n...\n", "'.GS' (free) | row 0"),
]


@table(TEXTS)
def test_maps(call: Any, error: type[Exception], says: str) -> None:
    assert_refuses(lambda: mw.read_map(call), error, says)


@table(FILES)
def test_map_files(tmp_path: Path, call: str, error: type[Exception], says: str) -> None:
    path = tmp_path / "broken.map"
    path.write_text(call, encoding="utf-8")
    assert_refuses(lambda: mw.read_map(path), error, says)
    with pytest.raises(error, match="broken"):
        mw.WorldConfig(obstacles=str(path))


def test_a_map_file_that_is_not_there(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match=r"nowhere\.map"):
        mw.WorldConfig(obstacles=tmp_path / "nowhere.map")
