"""Speed of worlds and matches on this machine, as ``matrixworld bench`` measures it.

An agent-step is one step of an agent that is alive when the step begins, as in
`EpisodeStatistics`. Worlds are played with random actions that are drawn before the clock starts;
an episode that ends is followed by a new one. Matches are played between untrained networks; one
call plays the matches of an epoch of ``matrixworld evolve``.
"""

from __future__ import annotations

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

from matrixworld import _core
from matrixworld._core import Autoreset
from matrixworld._util.checks import usable_cores
from matrixworld.envs.vector import VectorEnv
from matrixworld.play.rollout import EpisodeStatistics, Matches, rollout
from matrixworld.version import __version__
from matrixworld.world.arrays import array_specs, episode_specs
from matrixworld.world.batch import Batch
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import Network, Population
from matrixworld.world.world import World

STEP, VIEWS, VECTOR_ENV = "step only", "step and views", "VectorEnv"
IN_PLACE = "VectorEnv, copy=False"
MATCHES = "matches"

MANY = 1024
MOST_VIEWS = 2**28
"""Most bytes of views; where `MANY` worlds need more, fewer worlds are played."""

COUNTED = 2**20
"""Agent-steps, of living and dead agents, from which the share of the living is estimated."""
CHECKED_WORLDS, CHECKED_STEPS = 5, 16
CHECKED_MATCHES = 4


class WrongAnswerError(RuntimeError):
    """Two ways to play the same episodes have given different results."""


@dataclass(frozen=True)
class Machine:
    """The machine and the versions with which figures were measured.

    Parameters
    ----------
    processor : str
        Name of the processor.
    cores : int
        Cores that this process may use.
    kernels : str
        Instruction set of the networks' code, a value of ``MATRIXWORLD_KERNELS``.
    matrixworld, numpy, python : str
        Versions.
    """

    processor: str
    cores: int
    kernels: str
    matrixworld: str
    numpy: str
    python: str

    @classmethod
    def this(cls) -> Machine:
        """Describe this machine.

        Raises
        ------
        ValueError
            If this processor does not have the kernels that ``MATRIXWORLD_KERNELS`` names.
        """
        level = _core.kernel_level().removeprefix("kernels_")
        return cls(
            processor=processor_name(),
            cores=usable_cores(),
            kernels=level if level == "base" else f"x86-64-{level}",
            matrixworld=__version__,
            numpy=np.__version__,
            python=platform.python_version(),
        )


def processor_name(cpuinfo: Path = Path("/proc/cpuinfo")) -> str:
    """Return the processor's name, or "unknown"."""
    lines = cpuinfo.read_text(encoding="utf-8").splitlines() if cpuinfo.is_file() else []
    names = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    # Linux only has cpuinfo, and on some machines it names no model.
    known = (*names, platform.processor(), platform.machine())
    return next((name for name in known if name), "unknown")


def check_worlds(config: WorldConfig, threads: int) -> None:
    """Compare a `VectorEnv` with single worlds; raise WrongAnswerError if they differ."""
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
                f"VectorEnv and a single world differ in {name} after step {step + 1} of seed "
                f"{number}"
            )


def check_matches(config: WorldConfig, network: Network, threads: int) -> None:
    """Compare several threads with one; raise WrongAnswerError if the statistics differ."""
    teams = _team(network, CHECKED_MATCHES, 0), _team(network, 1, 1)
    matches = Matches.of(np.arange(CHECKED_MATCHES), 0, np.arange(CHECKED_MATCHES))
    # Also where only one thread is measured, there must be something to compare with.
    several = max(2, threads)
    one, more = (
        rollout(config, *teams, matches, episodes=2, threads=number) for number in (1, several)
    )
    for name in (item.name for item in fields(EpisodeStatistics)):
        if not np.array_equal(getattr(one, name), getattr(more, name)):
            raise WrongAnswerError(f"rollout: {name} with {several} threads differs from 1 thread")


class RandomActions:
    """Random actions of all agents, ``actions[step]`` of shape (worlds, A) and dtype uint8.

    Drawing them takes no time during a measurement: each step's actions are a window, at a random
    place, of numbers drawn beforehand.

    Parameters
    ----------
    config : WorldConfig
        The world, of A agents.
    worlds : int
        Number of worlds.
    """

    # A few rows of actions in turn would drive all agents to the borders, where they collide more.

    SPARE, PLACES = 2**20, 4093

    def __init__(self, config: WorldConfig, worlds: int) -> None:
        rng = np.random.default_rng(0)
        self._shape = (worlds, config.n_agents)
        self._size = worlds * config.n_agents
        self._drawn = rng.integers(config.n_actions, size=self._size + self.SPARE, dtype=np.uint8)
        self._places = rng.integers(self.SPARE, size=self.PLACES).tolist()

    def __getitem__(self, step: int) -> NDArray[np.uint8]:
        # PLACES is prime, so that its period hardly ever coincides with that of the episodes.
        place = self._places[step % self.PLACES]
        return self._drawn[place : place + self._size].reshape(self._shape)


@dataclass
class Measurement:
    """A call whose speed is measured, and the rates measured so far.

    Parameters
    ----------
    what : str
        `STEP`, `VIEWS`, `VECTOR_ENV`, `IN_PLACE` or `MATCHES`.
    size : int
        Worlds, or matches, in a call.
    threads : int
        Threads that play.
    play : callable
        Called with the number of the call.
    agent_steps : float
        Mean number of agent-steps in a call.
    world_steps : float
        Steps of worlds in a call.
    hidden : tuple of int, optional
        Hidden layers of the networks of matches. None for worlds.
    rates : list of float, optional
        Calls a second, one number for each repeat.
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
        """Call for so many seconds, at least once, and append the rate to `rates`."""
        # An untimed call fills the caches, which the measurement before has used. A call of matches
        # is so long that this does not matter.
        if self.what != MATCHES:
            self.play(0)
        calls, passed, start = 0, 0.0, time.perf_counter()
        while calls == 0 or passed < seconds:
            self.play(calls)
            calls += 1
            passed = time.perf_counter() - start
        self.rates.append(calls / passed)

    @property
    def rate(self) -> float:
        """Median of the repeats, in calls a second."""
        return statistics.median(self.rates)

    @property
    def spread(self) -> float:
        """Difference of the fastest and the slowest repeat, as a share of the median."""
        return (max(self.rates) - min(self.rates)) / self.rate


def measurements(
    config: WorldConfig,
    match_config: WorldConfig,
    networks: Sequence[Network],
    *,
    population: int,
    threads: int,
) -> list[Measurement]:
    """Prepare all measurements, with one thread and with `threads`; nothing is timed yet.

    Parameters
    ----------
    config : WorldConfig
        World of the steps.
    match_config : WorldConfig
        World of the matches.
    networks : sequence of Network
        Networks of matches; each is measured, as the network of both teams.
    population : int
        Pursuers that meet one evader in a call.
    threads : int
        Number of threads beside one.

    Returns
    -------
    list of Measurement
        First those of worlds, then those of matches.
    """
    many = many_worlds(config)
    alive = {size: alive_share(config, size) for size in (many, 1)}
    # Threads divide the worlds, so one world is played by one thread. Steps without views are, too:
    # they are the cost of the rules alone.
    cases = [(many, 1), (1, 1), (many, threads)]
    steps = [
        _steps(config, what, size, number, alive[size])
        for what in (STEP, VIEWS, VECTOR_ENV, IN_PLACE)
        for size, number in dict.fromkeys(cases)
        if number == 1 or what != STEP
    ]
    return steps + [
        each
        for network in networks
        for each in _matches(match_config, network, population, [*dict.fromkeys((1, threads))])
    ]


def many_worlds(config: WorldConfig) -> int:
    """Return `MANY`, or the number of worlds whose views fit into `MOST_VIEWS`."""
    # A view has three channels of one byte a cell.
    views = config.n_agents * 3 * config.fov**2
    return max(1, min(MANY, MOST_VIEWS // views))


def alive_share(config: WorldConfig, worlds: int) -> float:
    """Return the share of the agents that are alive when a step begins."""
    an_episode = config.n_agents * config.max_steps
    # At least one whole episode is played, because agents disappear in the course of it.
    some = max(1, min(worlds, COUNTED // an_episode))
    steps = max(config.max_steps, COUNTED // (config.n_agents * some))
    batch, actions = _batch(config, some, 1, "acted"), RandomActions(config, some)
    counts = [np.count_nonzero(batch.step(actions[step])["acted"]) for step in range(steps)]
    return sum(counts) / (steps * some * config.n_agents)


def _batch(config: WorldConfig, worlds: int, threads: int, *names: str) -> Batch:
    specs = array_specs(config) | episode_specs(config)
    buffers = {name: np.zeros((worlds, *specs[name][0]), specs[name][1]) for name in names}
    # Every step of every world is then a step of an episode.
    mode = Autoreset.SAME_STEP
    return Batch(worlds, config, threads=threads, autoreset=mode, buffers=buffers)


def _vector_env(config: WorldConfig, worlds: int, threads: int, copy: bool) -> VectorEnv:
    env = VectorEnv(config, worlds, threads=threads, copy=copy, autoreset_mode="SameStep")
    env.reset(seed=0)
    return env


def _steps(config: WorldConfig, what: str, worlds: int, threads: int, alive: float) -> Measurement:
    actions = RandomActions(config, worlds)
    played: Any
    if what in (VECTOR_ENV, IN_PLACE):
        played = _vector_env(config, worlds, threads, copy=what == VECTOR_ENV)
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

    # Every call plays the same matches, so their steps are counted once.
    scores = play(max(threads))
    counts = int(scores.agent_steps.sum()), int(scores.length.sum())
    return [
        Measurement(MATCHES, population, n, partial(play, n), *counts, hidden=network.hidden)
        for n in threads
    ]
