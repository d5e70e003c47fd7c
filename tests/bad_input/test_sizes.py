"""Sizes that cannot be are refused, with an estimate, before anything is allocated or written."""

import multiprocessing
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import matrixworld as mw
from matrixworld._util import checks
from matrixworld.coevolution import score_policy, start
from matrixworld.coevolution import tournament as play_tournament
from matrixworld.envs import vector
from matrixworld.episodes import replay
from matrixworld.world.arrays import state_bytes, workspace_bytes
from refusals import CONFIG, GENOME, NETWORK
from rows import random_walks
from slow import quickly
from tiny_race import tiny_race

TEAM = mw.Population(GENOME, NETWORK)
MATCH = mw.Matches.of(0, 0, 0)
MANY = 2**31 - 1  # the largest number that is accepted where sizes are ints
WIDE = mw.WorldConfig(rows=4096, cols=4096, n_pursuers=4_000_000, n_evaders=4_000_000)
GIANT = mw.Network((2**20, 2**20))
GB = 10**9

TOO_LARGE = {
    "world": lambda path: mw.World(WIDE),
    "batch": lambda path: mw.Batch(MANY, CONFIG),
    "copies": lambda path: mw.VectorEnv(CONFIG, 230_000),  # would fit once
    "threads": lambda path: mw.Batch(1024, WIDE, threads=1024, buffers={}),
    "genome": lambda path: GIANT.initial(np.random.default_rng(0)),
    "episodes": lambda path: mw.rollout(CONFIG, TEAM, "still", MATCH, episodes=MANY),
    "tournament": lambda path: play_tournament(CONFIG, TEAM, TEAM, seed=0, episodes=MANY),
    "scores": lambda path: score_policy(TEAM, "pursuer", CONFIG, episodes=MANY),
    "candidates": lambda path: start(tiny_race(hidden=(2**20, 2**20)), path / "run"),
    "payoff": lambda path: start(tiny_race(generations=MANY), path / "run"),
}


@pytest.mark.parametrize("call", TOO_LARGE.values(), ids=TOO_LARGE)
def test_what_is_too_large_is_refused_with_an_estimate(
    call: Callable[[Path], object], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(checks, "available_memory", lambda: GB // 2)
    with pytest.raises(checks.OutOfMemoryError, match="at most 0.5 GB of memory.*an estimate of"):
        call(tmp_path)
    assert list(tmp_path.iterdir()) == []
    monkeypatch.setattr(checks, "available_memory", lambda: None)
    checks.check_memory("all", bytes=10**30)  # where memory is unknown nothing is refused


# Estimates


def measured_peak(play: Callable[[], object]) -> int:
    """In a fresh process: memory that was freed before would be used again and not be seen."""
    here, there = multiprocessing.Pipe()
    process = multiprocessing.get_context("spawn").Process(target=peak_of, args=(play, there))
    process.start()
    there.close()
    measured: int = here.recv()
    process.join()
    return measured


def peak_of(play: Callable[[], object], connection: Any) -> None:
    """Send by how many bytes a call raises the memory of this process."""
    before = status("VmRSS")
    Path("/proc/self/clear_refs").write_text("5", encoding="ascii")  # the peak begins anew
    result = play()
    connection.send(status("VmHWM") - before)
    del result


def status(name: str) -> int:
    lines = Path("/proc/self/status").read_text(encoding="ascii").splitlines()
    return next(1024 * int(line.split()[1]) for line in lines if line.startswith(name))


CROWD = mw.WorldConfig(rows=60, cols=60, n_pursuers=800, n_evaders=800, max_steps=1)
FIELD = mw.WorldConfig(rows=1500, cols=1500, max_steps=1)
SMALL = mw.WorldConfig(rows=6, cols=6, n_pursuers=2, n_evaders=2, max_steps=1)
ESTIMATES: dict[str, tuple[Callable[[], object], int]] = {
    "cells": (partial(mw.World, FIELD), workspace_bytes(FIELD)),
    "agents": (partial(mw.Batch, 1000, CROWD, threads=1, buffers={}), 1000 * state_bytes(CROWD)),
    "episodes": (
        partial(mw.rollout, SMALL, "still", "still", MATCH, episodes=200_000, threads=1),
        200_000 * checks.EPISODE_BYTES,
    ),
}


@pytest.mark.skipif(not Path("/proc/self/clear_refs").exists(), reason="needs Linux")
@quickly("name", ESTIMATES, lambda name: name == "agents", others=pytest.mark.slow)
def test_estimates_are_near_what_is_measured(name: str) -> None:
    play, estimate = ESTIMATES[name]
    measured = measured_peak(play)
    assert 0.5 * measured < estimate < 2 * measured, (measured, estimate)


def stepped(n_worlds: int, team: str | None = None, **settings: Any) -> object:
    """Step as a loop does: the results of a step are held while those of the next are made."""
    env: Any = mw.VectorEnv("O", n_worlds, threads=1, **settings)
    env = env if team is None else mw.AgentVectorEnv(env, team=team)
    kept = env.reset(seed=0)
    for _ in range(3):
        kept = env.step(np.zeros(env.action_space.shape, np.int64))
    return env, kept


ENVIRONMENTS: dict[str, dict[str, Any]] = {
    "copies": {"n_worlds": 3000},
    "masks and state": {"n_worlds": 3000, "action_mask": True, "state": True},
    "final views": {"n_worlds": 1500, "autoreset_mode": "SameStep"},
    "the only team": {"n_worlds": 4000, "team": "pursuer", "evaders": "random", "copy": False},
}


@pytest.mark.skipif(not Path("/proc/self/clear_refs").exists(), reason="needs Linux")
@pytest.mark.slow
@quickly("name", ENVIRONMENTS, lambda name: name == "copies")
def test_estimates_of_environments_are_within_a_half(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    told: dict[str, int] = {}
    monkeypatch.setattr(vector, "check_memory", lambda what, **parts: told.update(parts))
    stepped(**ENVIRONMENTS[name])
    measured = measured_peak(partial(stepped, **ENVIRONMENTS[name]))
    assert 0.95 * measured < sum(told.values()) < 1.5 * measured, (measured, told)


@pytest.mark.parametrize("suffix", [".gif", ".mp4"])
def test_pictures_and_animations_have_a_largest_size(
    tmp_path: Path, suffix: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    with pytest.raises(ValueError, match="contact sheet: expected at most 67,108,864 pixels"):
        replay.contact_sheet(random_walks(), rows=10**6, cols=10**6)
    monkeypatch.setattr(replay, "MOST_ANIMATED", 10**6)
    with pytest.raises(ValueError, match="animation: expected at most 1,000,000 pixels in all"):
        replay.save(random_walks(), tmp_path / f"x{suffix}")
    assert list(tmp_path.iterdir()) == []
