"""Sizes that cannot be are refused, with an estimate, before anything is allocated or written."""

import multiprocessing
import sys
import tempfile
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import matrixworld as mw
from matrixworld import solve
from matrixworld._util import checks
from matrixworld.coevolution import evolve, score_policy, start
from matrixworld.coevolution import tournament as play_tournament
from matrixworld.episodes import replay
from matrixworld.play import capture_rates
from matrixworld.solve import states
from refusals import CONFIG, GENOME, NETWORK
from rows import random_walks
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
    "agents": lambda path: mw.parallel_env(SEEING, fov=255),
    "views": lambda path: mw.World(SEEING, fov=255).views(),
    "recording": lambda path: mw.record_actions(
        mw.WorldConfig.of(LONG, max_steps=10**4), np.zeros((10**4, 1600), np.int8)
    ),
    "weights": lambda path: solve.mixture_bounds(
        mw.WorldConfig(rows=8, cols=8, n_pursuers=2, n_evaders=1, max_steps=10**4), HALF, "evader"
    ),
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
    for module in (checks, states):
        monkeypatch.setattr(module, "available_memory", lambda: GB // 2)
    with pytest.raises(checks.OutOfMemoryError, match="expected .*at most 0.5 GB.* got .* GB"):
        call(tmp_path)
    assert list(tmp_path.iterdir()) == []
    monkeypatch.setattr(checks, "available_memory", lambda: None)
    checks.check_memory("all", bytes=10**30)  # where memory is unknown nothing is refused


# Every public entry that allocates by its arguments, and what it says before it does so:

CROWD = mw.WorldConfig(rows=60, cols=60, n_pursuers=800, n_evaders=800, max_steps=1)
FIELD = mw.WorldConfig(rows=1500, cols=1500, max_steps=1)
SEEING = mw.WorldConfig(rows=60, cols=60, n_pursuers=1500, n_evaders=1500, fov=101)
LONG = mw.WorldConfig("R", rows=60, cols=60, n_pursuers=800, n_evaders=800, max_steps=400)
SHORT = mw.WorldConfig(max_steps=1)
SMALL = mw.WorldConfig(rows=6, cols=6, n_pursuers=2, n_evaders=2, max_steps=2, fov=3)
TURNS = mw.WorldConfig("TO", rows=100, cols=100, n_pursuers=4, n_evaders=4, max_steps=2)
SOLVED = mw.WorldConfig(rows=8, cols=8, n_pursuers=2, n_evaders=1)
COPS = mw.WorldConfig("TO", rows=11, cols=11, n_pursuers=2, n_evaders=1)
LARGE = mw.Network((200_000,), fov=5)
HALF = [(0.5, "chaser"), (0.5, "random")]


def stand(views: Any) -> Any:
    return np.zeros(len(views), np.int64)


def begun(make: Callable[..., Any]) -> object:
    env = make(CROWD)
    return env, env.reset(seed=0)


def stepped(n_worlds: int, team: str | None = None, **settings: Any) -> object:
    """Step as a loop does: the results of a step are held while those of the next are made."""
    env: Any = mw.VectorEnv("O", n_worlds, threads=1, **settings)
    env = env if team is None else mw.AgentVectorEnv(env, team=team)
    kept = env.reset(seed=0)
    for _ in range(3):
        kept = env.step(np.zeros(env.action_space.shape, np.int64))
    return env, kept


def team_of(number: int) -> mw.Population:
    return mw.Population(np.repeat(GENOME[None], number, axis=0), NETWORK)


def run_large() -> object:
    with tempfile.TemporaryDirectory() as folder:
        return evolve(tiny_race(hidden=(50_000,)), Path(folder) / "run", threads=1)


def solved_policy() -> object:
    return solve.solve(mw.WorldConfig(rows=7, cols=7, n_pursuers=2, n_evaders=1), steps=40).policy(
        "pursuer"
    )


ENTRIES: dict[str, tuple[Callable[[], object], str]] = {
    "World": (partial(mw.World, FIELD), "world"),
    "World.views": (lambda: mw.World(SEEING).views(), "views"),
    "parallel_env": (partial(begun, mw.parallel_env), "environment"),
    "aec_env": (partial(begun, mw.aec_env), "environment"),
    "Batch, agents": (partial(mw.Batch, 1000, CROWD, threads=1, buffers={}), "batch"),
    "Batch": (partial(mw.Batch, 20_000, threads=1), "batch"),
    "VectorEnv": (partial(stepped, 3000), "vector environment"),
    "VectorEnv, all": (partial(stepped, 3000, action_mask=True, state=True), "vector environment"),
    "VectorEnv, ends": (partial(stepped, 1500, autoreset_mode="SameStep"), "vector environment"),
    "AgentVectorEnv": (
        partial(stepped, 4000, "pursuer", evaders="random", copy=False),
        "vector environment, environment of agents",
    ),
    "rollout": (
        partial(mw.rollout, SMALL, "still", "still", MATCH, episodes=200_000, threads=1),
        "rollout",
    ),
    "record": (partial(mw.record, LONG, "still", "still", seed=0), "recording"),
    "record_actions": (
        partial(mw.record_actions, LONG, np.zeros((400, 1600), np.int8)),
        "recording",
    ),
    "capture_rates": (
        partial(capture_rates, SHORT, stand, "still", seed=0, episodes=2000),
        "batch",
    ),
    "capture_rates, turns": (
        partial(capture_rates, TURNS, stand, "still", seed=0, episodes=200),
        "episodes",
    ),
    "tournament": (
        lambda: play_tournament(CONFIG, team_of(30), team_of(30), seed=0, episodes=100, threads=1),
        "tournament",
    ),
    "score_policy": (
        partial(score_policy, "still", "pursuer", SMALL, episodes=50_000, threads=1),
        "scores",
    ),
    "evolve": (run_large, "run"),
    "Network.initial": (partial(LARGE.initial, np.random.default_rng(0)), "genome"),
    "States": (partial(solve.States, SOLVED), "states"),
    "States, turns": (partial(solve.States, COPS), "states"),
    "solve": (partial(solve.solve, SOLVED, steps=40), "states, values"),
    "best_response": (
        partial(solve.best_response, SOLVED, "chaser", "pursuer", steps=20),
        "champions, values",
    ),
    "expected_payoff": (
        partial(solve.expected_payoff, SOLVED, "chaser", "fleer", steps=3),
        "champions, values",
    ),
    "guarantees": (
        partial(solve.guarantees, SOLVED, {"pursuer": "chaser", "evader": "fleer"}, steps=20),
        "states, champions, values",
    ),
    "mixture_bounds": (
        partial(solve.mixture_bounds, SOLVED, HALF, "pursuer", steps=20),
        "mixture, values",
    ),
    "Solution.policy": (solved_policy, "states, values, policy"),
}
"""Calls, and the names of the estimates that say together what a call takes."""


@pytest.mark.skipif(not Path("/proc/self/clear_refs").exists(), reason="needs Linux")
@pytest.mark.slow
@pytest.mark.parametrize("name", ENTRIES)
def test_estimates_are_within_a_half_of_what_is_taken(name: str) -> None:
    """In a fresh process: memory that was freed before would be used again and not be seen."""
    here, there = multiprocessing.Pipe()
    spawn = multiprocessing.get_context("spawn")
    process = spawn.Process(target=told_and_taken, args=(name, there))
    process.start()
    there.close()
    told, taken = here.recv()
    process.join()
    estimate = sum(told[what] for what in ENTRIES[name][1].split(", "))
    assert taken / 1.5 < estimate < 1.5 * taken, (taken, told)


def told_and_taken(name: str, connection: Any) -> None:
    """Send what a call says that it takes, and by how many bytes it raises the memory of this."""
    told: dict[str, int] = {}
    check_memory, check_size = checks.check_memory, states.check_size

    def memory(what: str, **parts: int) -> None:
        told[what] = max(told.get(what, 0), sum(parts.values()))
        check_memory(what, **parts)

    def size(config: mw.WorldConfig) -> None:
        told["states"] = int(states.size_of(config)[1])
        check_size(config)

    for module in list(sys.modules.values()):
        if getattr(module, "check_memory", None) is check_memory:
            module.check_memory = memory  # type: ignore[attr-defined]
    states.check_size = size
    before = status("VmRSS")
    Path("/proc/self/clear_refs").write_text("5", encoding="ascii")  # the peak begins anew
    result = ENTRIES[name][0]()
    connection.send((told, status("VmHWM") - before))
    del result


def status(name: str) -> int:
    lines = Path("/proc/self/status").read_text(encoding="ascii").splitlines()
    return next(1024 * int(line.split()[1]) for line in lines if line.startswith(name))


@pytest.mark.parametrize("suffix", [".gif", ".mp4"])
def test_animations_have_a_largest_size(
    tmp_path: Path, suffix: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(replay, "MOST_ANIMATED", 10**6)
    with pytest.raises(ValueError, match="animation: expected at most 1,000,000 pixels in all"):
        replay.save(random_walks(), tmp_path / f"x{suffix}")
    assert list(tmp_path.iterdir()) == []
