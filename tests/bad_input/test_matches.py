"""Bad networks, populations and matches: the exceptions and their messages."""

from __future__ import annotations

from typing import Any

import numpy as np

import matrixworld as mw
from refusals import CONFIG, GENOME, NETWORK, SMALL, assert_refuses, kind, table, value

TEAM = mw.Population(np.stack([GENOME, GENOME]), NETWORK)
MATCH = mw.Matches.of(0, 0, 0)
EMPTY = np.zeros((0, 329), np.float32)
LONG = np.zeros((2, 330), np.float32)
SPOILT = TEAM.genomes.copy()
SPOILT[1, 17] = np.nan
INFINITE = np.full(329, np.inf, np.float32)

NETWORKS = [
    value("an empty layer", lambda: mw.Network((0,)), "1 to 1048576 | got 0"),
    value("a negative layer", lambda: mw.Network((8, -1)), "1 to 1048576 | got -1"),
    value("a huge layer", lambda: mw.Network((2**40,)), "1 to 1048576 | got 1099511627776"),
    kind("a float layer", lambda: mw.Network((3.7,)), "an integer | got 3.7"),
    kind("hidden=32", lambda: mw.Network(32), "a sequence of ints | got 32"),
    value("even fov", lambda: mw.Network(fov=4), "an odd number | got 4"),
    value("no fov", lambda: mw.Network(fov=0), "1 to 255 | got 0"),
    value("huge fov", lambda: mw.Network(fov=10**6 + 1), "1 to 255 | got 1000001"),
    kind("float fov", lambda: mw.Network(fov=11.0), "an integer | got 11.0"),
    value("four actions", lambda: mw.Network(n_actions=4), "5 or 9 | got 4"),
    value("activation", lambda: mw.Network(activation="gelu"), "'relu' or 'tanh' | got 'gelu'"),
    kind("sampled", lambda: mw.Network(sampled=1), "True or False | got 1"),
    value("a short genome", lambda: NETWORK.layers(GENOME[:-1]), "shape (329,) | got (328,)"),
    value("two genomes", lambda: NETWORK.layers(TEAM.genomes), "shape (329,) | got (2, 329)"),
    value(
        "views of another size",
        lambda: NETWORK.logits(GENOME, np.zeros((6, 3, 7, 7), np.uint8)),
        "shape (n, 3, 5, 5) | got (6, 3, 7, 7)",
    ),
    kind(
        "double genomes",
        lambda: mw.Population(GENOME.astype(float), NETWORK),
        "dtype float32 | got float64",
    ),
    kind("a list of genes", lambda: mw.Population([0.5], NETWORK), "dtype float32 | float64"),
    value(
        "too long genomes",
        lambda: mw.Population(LONG, NETWORK),
        "shape (n >= 1, 329) | got (2, 330)",
    ),
    value(
        "no genomes", lambda: mw.Population(EMPTY, NETWORK), "shape (n >= 1, 329) | got (0, 329)"
    ),
    value(
        "a cube of genomes",
        lambda: mw.Population(TEAM.genomes[None], NETWORK),
        "shape (n >= 1, 329) | got (1, 2, 329)",
    ),
    value(
        "nan",
        lambda: mw.Population(SPOILT, NETWORK),
        "finite numbers | got nan (genome 1, number 17)",
    ),
    value(
        "infinity",
        lambda: mw.Population(INFINITE, NETWORK),
        "finite numbers | inf (genome 0, number 0)",
    ),
    kind("no network", lambda: mw.Population(GENOME, None), "a Network | got None"),
]


@table(NETWORKS)
def test_networks(call: Any, error: type[Exception], says: str) -> None:
    assert_refuses(call, error, says)


# ---- Matches ---------------------------------------------------------------------------------

DIAGONAL = mw.WorldConfig(**SMALL, fov=5, diagonal=True)
WIDE = mw.WorldConfig(**SMALL, fov=7)


def rollout(pursuers: Any, evaders: Any, config: Any = CONFIG, **more: Any) -> mw.EpisodeStatistics:
    return mw.rollout(config, pursuers, evaders, MATCH, **more)


def play(pursuers: Any, evaders: Any, pursuer: Any, evader: Any) -> mw.EpisodeStatistics:
    return mw.rollout(CONFIG, pursuers, evaders, mw.Matches.of(pursuer, evader, 0))


def record(pursuers: Any, evaders: Any, config: Any = CONFIG, **more: Any) -> mw.Episode:
    return mw.record(config, pursuers, evaders, **more)


MATCHES = [
    kind("float indices", lambda: mw.Matches.of([0.0], 0, 0), "an integer | got 0.0"),
    value("negative indices", lambda: mw.Matches.of(0, [2, -1], 0), "0 to 2147483647 | got -1"),
    value("huge indices", lambda: mw.Matches.of(2**32, 0, 0), "0 to 2147483647 | got 4294967296"),
    value("negative seeds", lambda: mw.Matches.of(0, 0, -1), "0 to 1844 | got -1"),
    value("huge seeds", lambda: mw.Matches.of(0, 0, 2**64), "0 to 1844 | got 18446744073709551616"),
    kind("text as a seed", lambda: mw.Matches.of(0, 0, "7"), "an integer | got '7'"),
    value("a table of matches", lambda: mw.Matches.of([[0]], 0, 0), "one axis | got shape (1, 1)"),
    value("no episodes", lambda: rollout(TEAM, TEAM, episodes=0), "at least 1 | got 0"),
    kind("float episodes", lambda: rollout(TEAM, TEAM, episodes=1.5), "an integer | got 1.5"),
    value("no threads", lambda: rollout(TEAM, TEAM, threads=0), "1 to 1024 | got 0"),
    kind("no config", lambda: rollout(TEAM, TEAM, None), "Rules or the name | got None"),
    value(
        "another script",
        lambda: mw.rollout(CONFIG, "stalker", TEAM, MATCH),
        f"one of {', '.join(mw.SCRIPTS)} | got 'stalker'",
    ),
    kind(
        "a genome as a team", lambda: rollout(TEAM, GENOME), "a Population or the name | evaders: "
    ),
    value(
        "beyond the pursuers",
        lambda: play(TEAM, TEAM, [1, 2], 0),
        "0 to 1 | pursuer: expected 0 to 1, got 2",
    ),
    value(
        "beyond the evaders",
        lambda: play(TEAM, TEAM, 0, 5),
        "0 to 1 | evader: expected 0 to 1, got 5",
    ),
    value("beyond a script", lambda: play("still", TEAM, 1, 0), "0 to 0 | got 1"),
    value(
        "too wide a world",
        lambda: rollout(TEAM, "still", WIDE),
        "a network for fov 7 and 5 actions | got fov 5 and 5 actions",
    ),
    value(
        "too many directions",
        lambda: rollout("still", TEAM, DIAGONAL),
        "a network for fov 5 and 9 actions | evaders: ",
    ),
    value("record: another script", lambda: record("still", "", seed=0), "one of random | got ''"),
    value(
        "record: beyond",
        lambda: record(TEAM, TEAM, seed=0, evader=2),
        "0 to 1 | evader: expected 0 to 1, got 2",
    ),
    value(
        "record: negative",
        lambda: record(TEAM, TEAM, seed=0, pursuer=-1),
        "at least 0 | got -1",
    ),
    kind("record: seeds", lambda: record(TEAM, TEAM, seed=[1, 2]), "an integer | got [1, 2]"),
    value("record: negative seed", lambda: record(TEAM, TEAM, seed=-1), "0 to 1844 | got -1"),
    value(
        "record: negative episode",
        lambda: record(TEAM, TEAM, seed=1, episode=-1),
        "0 to 1844 | got -1",
    ),
    value(
        "record: too wide a world",
        lambda: record(TEAM, "still", WIDE, seed=1),
        "a network for fov 7 | got fov 5",
    ),
    value("match_seed: negative", lambda: mw.match_seed(1, -2), "0 to 1844 | got -2"),
    kind("match_seed: float", lambda: mw.match_seed(1, 2.0), "an integer | got 2.0"),
]


@table(MATCHES)
def test_matches(call: Any, error: type[Exception], says: str) -> None:
    assert_refuses(call, error, says)


def test_these_teams_can_play() -> None:
    assert play(TEAM, TEAM, 1, [0, 1]).length.shape == (2, 1)
    assert record(TEAM, "still", seed=0, pursuer=1).n_pursuers == 2
