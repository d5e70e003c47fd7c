"""Agent-steps per second of worlds of two games, bound to cores.

    python benchmarks/bench_worlds.py [--seconds 1] [--repeats 5]

An agent-step is one step of an agent that is alive when the step begins. Actions are random and are
drawn before the measurement; an episode that ends is followed by a new one. Each number is the
median of some repeats. The process is bound to one core, and for two threads to two cores, if the
system supports it.
"""

from __future__ import annotations

from collections.abc import Callable

import click
import numpy as np
from numpy.typing import NDArray

import matrixworld as mw
from matrixworld import _core
from matrixworld.world.arrays import array_specs, episode_specs
from matrixworld.world.batch import Batch
from timing import Clock, bind, n_cores, print_table

VARIANTS = ("O", "SDB")
MANY = 1024
"""Worlds of a batch: enough to hide the cost of a call from Python."""
SAMPLE, EPISODES = 16, 4
"""Worlds that are played to estimate the share of the living, and for how many episodes."""
SPARE, PLACES = 2**20, 4093
"""Random actions beside those of one step, and windows of them that are played in turn."""


def random_actions(config: mw.WorldConfig, worlds: int) -> Callable[[int], NDArray[np.uint8]]:
    """Return a function of the step: actions of all agents, uint8, of shape (worlds, A).

    Each step's actions are a window, at a random place, of numbers drawn beforehand: a few rows of
    actions in turn would drive all agents to the borders, where they collide more.
    """
    rng = np.random.default_rng(0)
    shape, size = (worlds, config.n_agents), worlds * config.n_agents
    drawn = rng.integers(config.n_actions, size=size + SPARE, dtype=np.uint8)
    # PLACES is prime, so that its period hardly ever coincides with that of the episodes.
    windows = [drawn[place : place + size] for place in rng.integers(SPARE, size=PLACES)]
    return lambda step: windows[step % PLACES].reshape(shape)


def batch(config: mw.WorldConfig, worlds: int, threads: int, *names: str) -> Batch:
    """Return worlds whose steps are all steps of episodes, with buffers of these arrays."""
    specs = array_specs(config) | episode_specs(config)
    buffers = {name: np.zeros((worlds, *specs[name][0]), specs[name][1]) for name in names}
    mode = _core.Autoreset.SAME_STEP
    return Batch(worlds, config, threads=threads, autoreset=mode, buffers=buffers)


def alive_share(config: mw.WorldConfig) -> float:
    """Return the share of the agents that are alive when a step begins."""
    # Whole episodes are played, because agents disappear in the course of them.
    worlds, actions = batch(config, SAMPLE, 1, "acted"), random_actions(config, SAMPLE)
    steps = range(EPISODES * config.max_steps)
    return float(np.mean([worlds.step(actions(step))["acted"].mean() for step in steps]))


def world_steps(
    what: str, config: mw.WorldConfig, worlds: int, threads: int, clock: Clock
) -> float:
    """Return the world-steps a second of a line of the table."""
    game: Batch | mw.VectorEnv
    if what.startswith("step"):
        game = batch(config, worlds, threads, *(["views"] if what == "step and views" else []))
    else:
        copy = what == "VectorEnv"
        game = mw.VectorEnv(config, worlds, threads=threads, copy=copy, autoreset_mode="SameStep")
        game.reset(seed=0)
    actions = random_actions(config, worlds)

    def play(call: int) -> int:
        game.step(actions(call))
        return worlds

    bind(threads)
    return clock.rate(play)


def measured(variant: str, threads: int, clock: Clock) -> dict[tuple[str, int, int], float]:
    """Return world-steps a second by what is played, number of worlds and number of threads."""
    config = mw.WorldConfig(variant)
    # Threads divide the worlds. Steps without views are the cost of the rules alone.
    lines = [
        (what, worlds, n)
        for what in ("step only", "step and views", "VectorEnv", "VectorEnv, copy=False")
        for worlds, n in dict.fromkeys([(MANY, 1), (1, 1), (MANY, threads)])
        if n == 1 or what != "step only"
    ]
    return {line: world_steps(line[0], config, *line[1:], clock) for line in lines}


@click.command()
@click.option("--seconds", default=1.0, show_default=True, help="time of one repeat")
@click.option("--repeats", default=5, show_default=True, help="repeats of which the median counts")
def main(seconds: float, repeats: int) -> None:
    """Print a table in Markdown."""
    threads, clock = min(2, n_cores()), Clock(seconds, repeats)
    rates = {variant: measured(variant, threads, clock) for variant in VARIANTS}
    agents = {variant: mw.WorldConfig(variant).n_agents for variant in VARIANTS}
    living = {v: n * alive_share(mw.WorldConfig(v)) for v, n in agents.items()}
    rows = [
        (
            *line,
            *(f"{rates[v][line] * living[v] / 1e6:.1f}" for v in VARIANTS),
            *(f"{rates[v][line] / 1e6:.3f}" for v in VARIANTS),
        )
        for line in rates[VARIANTS[0]]
    ]
    heads = [f"-{v}, {of}" for of in ("agent-steps", "steps") for v in VARIANTS]
    print_table(("million per second", "worlds", "threads", *heads), rows)


if __name__ == "__main__":
    main()
