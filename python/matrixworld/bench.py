"""How fast this machine plays: what the command ``matrixworld bench`` measures.

An agent-step is one step of one agent that is alive as it begins, as in
`EpisodeStatistics`. Worlds are played with random actions, drawn before the clock starts, and begin
anew where an episode has ended; matches are between untrained networks,
one call being an epoch of ``matrixworld evolve``.
"""

from __future__ import annotations

import os
import platform
import statistics
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, fields
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import matrixworld
from matrixworld import _core
from matrixworld._core import Autoreset
from matrixworld.arrays import array_specs, episode_specs
from matrixworld.batch import Batch
from matrixworld.config import WorldConfig
from matrixworld.policy import Network, Population
from matrixworld.rollout import EpisodeStatistics, Matches, rollout
from matrixworld.vector import VectorEnv
from matrixworld.world import World

STEP, VIEWS, VECTOR_ENV = "step only", "step and views", "VectorEnv"
MATCHES = "matches"

MANY = 1024
MOST_VIEWS = 2**28
"""Bytes of views from which on fewer worlds than `MANY` are played."""

COUNTED = 2**20
"""Steps of agents in which those alive are counted."""
CHECKED_WORLDS, CHECKED_STEPS = 5, 16
CHECKED_MATCHES = 4


class WrongAnswerError(RuntimeError):
    """Two ways of playing the same thing have come to different ends."""


# ---- The machine -------------------------------------------------------------------------------


@dataclass(frozen=True)
class Machine:
    """What figures were measured on.

    cores: those that this process may use
    kernels: the instruction set of the networks, as ``MATRIXWORLD_KERNELS`` calls it
    matrixworld, numpy, python: versions
    """

    processor: str
    cores: int
    kernels: str
    matrixworld: str
    numpy: str
    python: str

    @classmethod
    def this(cls) -> Machine:
        """The machine at hand. Raises ValueError where ``MATRIXWORLD_KERNELS`` cannot be had."""
        level = _core.kernel_level().removeprefix("kernels_")
        return cls(
            processor=processor_name(),
            cores=usable_cores(),
            kernels=level if level == "base" else f"x86-64-{level}",
            matrixworld=matrixworld.__version__,
            numpy=np.__version__,
            python=platform.python_version(),
        )


def processor_name(cpuinfo: Path = Path("/proc/cpuinfo")) -> str:
    """The processor's name, as far as the system tells."""
    lines = cpuinfo.read_text(encoding="utf-8").splitlines() if cpuinfo.is_file() else []
    names = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    known = (*names, platform.processor(), platform.machine())
    return next((name for name in known if name), "unknown")


def usable_cores() -> int:
    """Cores that this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


# ---- The answer, first -------------------------------------------------------------------------


def check_worlds(config: WorldConfig, threads: int) -> None:
    """Raise WrongAnswerError unless a `VectorEnv` shows what single worlds show."""
    worlds = [World(config) for _ in range(CHECKED_WORLDS)]
    env = VectorEnv(config, CHECKED_WORLDS, autoreset_mode="Disabled", threads=threads)
    env.reset(seed=0)
    for seed, world in enumerate(worlds):
        world.reset(seed)
    drawn = RandomActions(config, CHECKED_WORLDS)
    for step in range(CHECKED_STEPS):
        actions = drawn[step]
        env.step(actions)
        for number, world in enumerate(worlds):
            if not (world.terminated or world.truncated):
                world.step(actions[number])
                _check_world(env, number, world, step)


def _check_world(env: VectorEnv, number: int, world: World, step: int) -> None:
    shown: dict[str, tuple[NDArray[Any], NDArray[Any]]] = {
        "observations": (env.observations[number], world.views()),
        "rewards": (env.rewards[number], world.rewards),
        "positions": (env.infos["positions"][number], world.positions),
    }
    for name, (ours, theirs) in shown.items():
        if not np.array_equal(ours, theirs):
            raise WrongAnswerError(
                f"VectorEnv shows other {name} than a single world after step {step + 1} of seed "
                f"{number}"
            )


def check_matches(config: WorldConfig, network: Network, threads: int) -> None:
    """Raise WrongAnswerError unless several threads score matches as one does."""
    teams = _team(network, CHECKED_MATCHES, 0), _team(network, 1, 1)
    matches = Matches.of(np.arange(CHECKED_MATCHES), 0, np.arange(CHECKED_MATCHES))
    several = max(2, threads)
    one, more = (
        rollout(config, *teams, matches, worlds=2, threads=number) for number in (1, several)
    )
    for name in (item.name for item in fields(EpisodeStatistics)):
        if not np.array_equal(getattr(one, name), getattr(more, name)):
            raise WrongAnswerError(f"rollout scores another {name} with {several} threads than 1")


# ---- What is measured --------------------------------------------------------------------------


class RandomActions:
    """Actions of all agents of some worlds, ``(worlds, A)`` uint8, by the number of the step.

    They are windows of numbers that were drawn before, at places drawn before. (A few rows that
    come again and again would drive all agents to the borders, where they collide more.)
    """

    SPARE, PLACES = 2**20, 4093

    def __init__(self, config: WorldConfig, worlds: int) -> None:
        rng = np.random.default_rng(0)
        self._shape = (worlds, config.n_agents)
        self._size = worlds * config.n_agents
        self._drawn = rng.integers(config.n_actions, size=self._size + self.SPARE, dtype=np.uint8)
        self._places = rng.integers(self.SPARE, size=self.PLACES).tolist()

    def __getitem__(self, step: int) -> NDArray[np.uint8]:
        place = self._places[step % self.PLACES]
        return self._drawn[place : place + self._size].reshape(self._shape)


@dataclass
class Measurement:
    """Something that is played again and again, always as much in a call.

    what: `STEP`, `VIEWS`, `VECTOR_ENV` or `MATCHES`
    size: worlds, or matches, in a call
    hidden: layers of the networks of matches
    play: called with the number of the call
    agent_steps, world_steps: in a call, the first a mean
    rates: calls a second, one number for each repeat
    """

    what: str
    size: int
    threads: int
    play: Callable[[int], object]
    agent_steps: float
    world_steps: float
    hidden: tuple[int, ...] | None = None
    rates: list[float] = field(default_factory=list)

    def repeat(self, seconds: float) -> None:
        """Play for so long, at least one call, and keep the rate."""
        if self.what != MATCHES:  # which are long beside the time to fill the caches again
            self.play(0)
        calls, passed, start = 0, 0.0, time.perf_counter()
        while calls == 0 or passed < seconds:
            self.play(calls)
            calls += 1
            passed = time.perf_counter() - start
        self.rates.append(calls / passed)

    @property
    def rate(self) -> float:
        """Calls a second, the median of the repeats."""
        return statistics.median(self.rates)

    @property
    def spread(self) -> float:
        """From the slowest repeat to the fastest, as a share of the median."""
        return (max(self.rates) - min(self.rates)) / self.rate


def measurements(
    config: WorldConfig,
    match_config: WorldConfig,
    networks: Sequence[Network],
    *,
    population: int,
    threads: int,
) -> list[Measurement]:
    """What there is to measure, with one thread and with all; nothing is timed yet.

    config, match_config: of the worlds and of the matches
    networks: of both teams, one after the other
    population: pursuers that meet one evader in a call
    """
    many = many_worlds(config)
    alive = {size: alive_share(config, size) for size in (many, 1)}
    cases = [(many, 1), (1, 1), (many, threads)]
    steps = [
        _steps(config, what, size, number, alive[size])
        for what in (STEP, VIEWS, VECTOR_ENV)
        for size, number in dict.fromkeys(cases)
        if number == 1 or what != STEP
    ]
    return steps + [
        each
        for network in networks
        for each in _matches(match_config, network, population, [*dict.fromkeys((1, threads))])
    ]


def many_worlds(config: WorldConfig) -> int:
    """`MANY`, or as many as `MOST_VIEWS` holds."""
    views = config.n_agents * 3 * config.fov**2
    return max(1, min(MANY, MOST_VIEWS // views))


def alive_share(config: WorldConfig, worlds: int) -> float:
    """The share of the agents that are alive as a step begins, counted in whole episodes."""
    an_episode = config.n_agents * config.max_steps
    some = max(1, min(worlds, COUNTED // an_episode))
    steps = max(config.max_steps, COUNTED // (config.n_agents * some))
    batch, actions = _batch(config, some, 1, "acted"), RandomActions(config, some)
    counts = [np.count_nonzero(batch.step(actions[step])["acted"]) for step in range(steps)]
    return sum(counts) / (steps * some * config.n_agents)


def _batch(config: WorldConfig, worlds: int, threads: int, *names: str) -> Batch:
    specs = array_specs(config) | episode_specs(config)
    buffers = {name: np.zeros((worlds, *specs[name][0]), specs[name][1]) for name in names}
    mode = Autoreset.SAME_STEP
    return Batch(worlds, config, threads=threads, autoreset=mode, buffers=buffers)


def _vector_env(config: WorldConfig, worlds: int, threads: int) -> VectorEnv:
    env = VectorEnv(config, worlds, threads=threads, autoreset_mode="SameStep")
    env.reset(seed=0)
    return env


def _steps(config: WorldConfig, what: str, worlds: int, threads: int, alive: float) -> Measurement:
    actions = RandomActions(config, worlds)
    played: Any
    if what == VECTOR_ENV:
        played = _vector_env(config, worlds, threads)
    else:
        played = _batch(config, worlds, threads, *(["views"] if what == VIEWS else []))
    return Measurement(
        what,
        worlds,
        threads,
        lambda call: played.step(actions[call]),
        agent_steps=worlds * config.n_agents * alive,
        world_steps=worlds,
    )


def _team(network: Network, size: int, seed: int) -> Population:
    rng = np.random.default_rng(seed)
    return Population(np.stack([network.initial(rng) for _ in range(size)]), network)


def _matches(
    config: WorldConfig, network: Network, population: int, threads: Sequence[int]
) -> list[Measurement]:
    teams = _team(network, population, 0), _team(network, 1, 1)
    matches = Matches.of(np.arange(population), 0, np.arange(population))

    def play(number: int, call: int = 0) -> EpisodeStatistics:
        return rollout(config, *teams, matches, threads=number)

    scores = play(max(threads))  # the same in every call
    counts = int(scores.agent_steps.sum()), int(scores.length.sum())
    return [
        Measurement(MATCHES, population, n, partial(play, n), *counts, hidden=network.hidden)
        for n in threads
    ]
