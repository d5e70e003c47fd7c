"""Comparison with other systems: environments with random actions, and co-evolution.

    python benchmarks/bench_peers.py [--seconds 1] [--repeats 5] [--pogema PYTHON]

Environments: 40 x 40 cells, 38 agents, views of 11 x 11, random actions that are drawn before the
measurement; resets of ended episodes are part of it. Co-evolution: one DEAP loop whose matches are
played by plain NumPy or by `matrixworld.rollout`. The process is bound to one core if the system
supports it. Before the measurement, the plain world is compared with the engine.
"""

from __future__ import annotations

import subprocess
import sys
from contextlib import AbstractContextManager, nullcontext
from pathlib import Path
from typing import Any

import click
import numpy as np
import pettingzoo
from pettingzoo.env_registry.exceptions import FailedToImport

import matrixworld as mw
from plain_coevolution import (
    EVADER,
    PURSUER,
    MakeScore,
    PlainWorld,
    act,
    coevolution,
    plain_score,
    rollout_score,
)
from timing import Clock, bind, print_table, random_actions

# Worlds of a batch: enough to hide the cost of a call from Python.
MANY = 1024
HIDDEN = (32,)
INSTALL = {
    "PettingZoo pursuit": "pip install 'pettingzoo[sisl]'",
    "POGEMA": "pip install pogema into a separate environment, and give its Python as --pogema",
}

try:
    from threadpoolctl import threadpool_limits
except ImportError:
    threadpool_limits = None


# ---- Checks before the measurement -------------------------------------------------------------


def assert_same(plain: PlainWorld, world: mw.World) -> None:
    p, alive = world.config.n_pursuers, world.alive
    assert (plain.alive == alive).all()
    assert (plain.positions == world.positions)[alive].all()
    assert (~plain.alive[p:] == world.captured).all()
    views = world.views()
    pursuers, evaders = np.arange(p), p + np.flatnonzero(alive[p:])
    assert (plain.views(pursuers, PURSUER) == views[pursuers]).all()
    assert (plain.views(evaders, EVADER) == views[evaders]).all()


def check_world(config: mw.WorldConfig) -> int:
    """Play random episodes in both worlds, and return the number of captured evaders."""
    world, plain, rng = mw.World(config), PlainWorld(config), np.random.default_rng(0)
    n_captured = 0
    for seed in range(3):
        world.reset(seed)
        plain.place(world.positions, world.map)
        while not (world.terminated or world.truncated):
            assert_same(plain, world)
            actions = rng.integers(5, size=config.n_agents)
            world.step(actions)
            plain.step(actions)
        assert_same(plain, world)
        # Captures are counted so that the check fails if the worlds agree without any.
        n_captured += world.captured.sum()
    return int(n_captured)


def check_network() -> None:
    """Check that actions of the plain network follow the softmax of `Network.logits`."""
    world, rng = mw.World(), np.random.default_rng(0)
    network = mw.Network.for_config(world.config, HIDDEN)
    genome = network.initial(rng, weight=0.5, head=0.5)
    views = world.views()[:1]
    powers = np.exp(network.logits(genome, views)[0].astype(float))
    actions = act(network, genome, np.repeat(views, 20_000, axis=0).astype(np.bool_), rng)
    shares = np.bincount(actions, minlength=5) / len(actions)
    assert np.abs(shares - powers / powers.sum()).max() < 0.02  # five standard deviations


def check() -> None:
    crowded: dict[str, Any] = {"rows": 9, "cols": 7, "n_pursuers": 4, "n_evaders": 9, "fov": 5}
    assert check_world(mw.WorldConfig("O", max_steps=100)) > 0
    assert check_world(mw.WorldConfig("O", obstacles=0.15, max_steps=200, **crowded)) > 0
    check_network()


# ---- Environments ----------------------------------------------------------------------------


def parallel_env(env: Any, clock: Clock) -> float:
    """Return world-steps per second of a PettingZoo environment."""
    drawn = random_actions(5, (len(env.possible_agents),))
    env.reset(seed=0)

    def play(i: int) -> int:
        row = dict(zip(env.possible_agents, drawn(i).tolist(), strict=True))
        env.step({agent: row[agent] for agent in env.agents})
        if not env.agents:
            env.reset()
        return 1

    return clock.rate(play)


def vector_env(n_worlds: int, clock: Clock, *, copy: bool = True) -> float:
    """Return world-steps per second of `VectorEnv`."""
    env = mw.VectorEnv("O", n_worlds, copy=copy, threads=1, autoreset_mode="SameStep")
    actions = random_actions(env.config.n_actions, (n_worlds, env.config.n_agents))
    env.reset(seed=0)

    def play(i: int) -> int:
        env.step(actions(i))
        return n_worlds

    return clock.rate(play)


def pursuit(clock: Clock) -> float | None:
    """Return world-steps per second of PettingZoo's pursuit; None if it is not installed."""
    try:
        env = pettingzoo.make("parallel", "sisl/pursuit-v5", x_size=40, y_size=40, obs_range=11)
    except FailedToImport:
        return None
    return parallel_env(env, clock)


def pogema(python: str, clock: Clock) -> float | None:
    """Return world-steps per second of POGEMA; None if that interpreter does not have it."""
    if subprocess.run([python, "-c", "import pogema"], capture_output=True).returncode != 0:
        return None
    # A separate process: its interpreter has other versions of the dependencies.
    script = str(Path(__file__).with_name("pogema_rate.py"))
    command = [python, script, str(clock.seconds), str(clock.repeats)]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    return float(done.stdout.split()[0])


def print_environments(python: str, clock: Clock) -> None:
    rates = {
        "PettingZoo pursuit": pursuit(clock),
        "POGEMA": pogema(python, clock),
        "`parallel_env`": parallel_env(mw.parallel_env("O"), clock),
        "`VectorEnv`, 1 world": vector_env(1, clock),
        f"`VectorEnv`, {MANY} worlds": vector_env(MANY, clock),
        "`VectorEnv(copy=False)`, 1 world": vector_env(1, clock, copy=False),
        f"`VectorEnv(copy=False)`, {MANY} worlds": vector_env(MANY, clock, copy=False),
    }
    n_agents = mw.WorldConfig("O").n_agents
    rows = [
        (what, f"{rate:,.0f}", f"{rate * n_agents / 1e6:.3f}")
        for what, rate in rates.items()
        if rate is not None
    ]
    print_table(("random actions, 38 agents", "world-steps/s", "million agent-steps/s"), rows)
    for what, advice in INSTALL.items():
        if rates[what] is None:
            print(f"{what} is left out: {advice}\n")


# ---- Co-evolution ----------------------------------------------------------------------------


def one_thread() -> AbstractContextManager[object]:
    """Limit NumPy's matrix products to one thread, if threadpoolctl is installed."""
    return nullcontext() if threadpool_limits is None else threadpool_limits(1)


def matches_and_decisions(
    make: MakeScore, config: mw.WorldConfig, size: int, clock: Clock
) -> tuple[float, float]:
    """Return matches and decisions per second, including selection and variation."""
    network = mw.Network.for_config(config, HIDDEN)
    race = coevolution(make(config, network, np.random.default_rng(0)), network, size, seed=0)

    def play(_: int) -> int:
        race.generation()
        return 2 * size

    rate = clock.rate(play)
    return rate, rate * race.decisions / race.matches


def print_coevolution(size: int, rounds: int, clock: Clock) -> None:
    config = mw.WorldConfig("O", max_steps=rounds)
    plain, ours = (
        matches_and_decisions(make, config, size, clock) for make in (plain_score, rollout_score)
    )
    rows = [
        (what, f"{matches:,.1f}", f"{decisions / 1e6:.3f}", f"{matches / plain[0]:.1f}")
        for what, (matches, decisions) in (
            ("DEAP and plain NumPy", plain),
            ("DEAP and `rollout`", ours),
        )
    ]
    print_table(("co-evolution", "matches/s", "million decisions/s", "speedup"), rows)


@click.command()
@click.option("--seconds", default=1.0, show_default=True, help="time of one repeat")
@click.option("--repeats", default=5, show_default=True, help="repeats of which the median counts")
@click.option("--pogema", "python", default=sys.executable, help="Python interpreter with POGEMA")
@click.option("--size", default=8, show_default=True, help="genomes in a population")
@click.option(
    "--rounds", default=500, show_default=True, help="rounds of an episode in co-evolution"
)
def main(seconds: float, repeats: int, python: str, size: int, rounds: int) -> None:
    """Print two tables in Markdown: environments, and co-evolution."""
    clock = Clock(seconds, repeats)
    check()
    bind(1)
    print_environments(python, clock)
    with one_thread():
        print_coevolution(size, rounds, clock)
    if threadpool_limits is None:
        print("NumPy may have used several threads: pip install threadpoolctl")


if __name__ == "__main__":
    main()
