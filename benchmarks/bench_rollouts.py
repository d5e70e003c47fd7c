"""Decisions per second of networks in whole matches, compared with a matrix product (GEMM).

    python benchmarks/bench_rollouts.py [--seconds 1] [--repeats 5]

A decision is the step of one living agent: its view, its network and its share of the world's step.
Both teams are networks with genomes drawn from N(0, 0.1). Each number is the median of some
repeats. The process is bound to one core, and for two threads to two cores, if the system supports
it. Before the measurement, a match is replayed in plain NumPy. Networks with memory are measured in
turns with the plain network, so that other programs disturb them alike.
"""

from __future__ import annotations

import math
import os
import subprocess
import sys
import time
from itertools import pairwise
from pathlib import Path

import click
import numpy as np
from numpy.typing import NDArray

import matrixworld as mw
from matrixworld.world.policy import GATES, Memory
from timing import Clock, Rate, bind, n_cores, print_table

HIDDEN: tuple[tuple[int, ...], ...] = ((32,), (64, 64), (400, 300))
REMEMBERING = (32,)  # hidden layer of the networks with memory
SHORT = 20  # rounds of a short episode
EPISODES = 16  # of a match with long episodes
GENOMES = 64  # population in short episodes; the largest genomes fill 68 MB
GEMM_SIDE = 2048
CORE_TYPES = (None, "SkylakeX")  # core types of OpenBLAS; None: its own choice


def population(
    config: mw.WorldConfig, hidden: tuple[int, ...], n: int, memory: Memory = "none"
) -> mw.Population:
    network = mw.Network.for_config(config, hidden, memory=memory)
    genomes = np.random.default_rng(0).standard_normal((n, network.genome_size), dtype=np.float32)
    return mw.Population(np.float32(0.1) * genomes, network)


# ---- Checks before the measurement -------------------------------------------------------------


def forward(
    hidden: tuple[int, ...], genome: NDArray[np.float32], views: NDArray[np.uint8]
) -> NDArray[np.float32]:
    """Return logits (n, 5) for views (n, 3, 11, 11), from the layout of a genome."""
    x, start = views.reshape(len(views), -1).astype(np.float32), 0
    sizes = (x.shape[1], *hidden, 5)
    for layer, (n_in, n_out) in enumerate(pairwise(sizes)):
        middle, end = start + n_in * n_out, start + (n_in + 1) * n_out
        x = x @ genome[start:middle].reshape(n_in, n_out) + genome[middle:end]
        x, start = np.maximum(x, 0) if layer < len(hidden) else x, end
    return x


def check(hidden: tuple[int, ...]) -> None:
    """Check that agents take the action of the largest logit, and that a rollout agrees."""
    config = mw.WorldConfig(rows=12, cols=12, n_pursuers=3, n_evaders=6, obstacles=0.1, max_steps=9)
    network = mw.Network.for_config(config, hidden, sampled=False)
    team = mw.Population(population(config, hidden, 2).genomes, network)
    episode = mw.record(config, team, team, seed=1, pursuer=0, evader=1)
    world, of_evader = mw.World(config), np.arange(config.n_agents) >= config.n_pursuers
    world.reset(1)
    n_clear = 0
    for actions in episode.actions:
        each = [forward(hidden, genome, world.views()) for genome in team.genomes]
        logits = np.where(of_evader[:, None], each[1], each[0])
        second, largest = np.sort(logits, axis=1)[:, -2:].T
        # Sums in another order may round differently and change a close decision.
        clear = world.alive & (largest - second > 1e-4)
        assert (actions == logits.argmax(axis=1))[clear].all()
        n_clear += clear.sum()
        world.step(actions)
    agent_steps = mw.rollout(config, team, team, mw.Matches.of(0, 1, 1)).agent_steps.sum()
    assert agent_steps == episode.alive[:-1].sum()
    assert n_clear > 0.9 * agent_steps


# ---- Measurements ----------------------------------------------------------------------------


def decisions(
    config: mw.WorldConfig, team: mw.Population, matches: mw.Matches, episodes: int, threads: int
) -> int:
    """Play all matches, and return the number of decisions."""
    scores = mw.rollout(config, team, team, matches, episodes=episodes, threads=threads)
    return int(scores.agent_steps.sum())


def long_episodes(hidden: tuple[int, ...], rounds: int, threads: int, clock: Clock) -> Rate:
    """Measure decisions with one match of 16 episodes on each thread."""
    config = mw.WorldConfig("O", max_steps=rounds)
    team = population(config, hidden, 2)

    def play(number: int) -> int:
        matches = mw.Matches.of(0, 1, number * threads + np.arange(threads))
        return decisions(config, team, matches, EPISODES, threads)

    return clock.measure(play)


def short_episodes(hidden: tuple[int, ...], obstacles: float, fresh: bool, clock: Clock) -> float:
    """Return decisions per second of matches of one episode.

    Parameters
    ----------
    hidden : tuple of int
        Hidden layers.
    obstacles : float
        Share of cells with obstacles.
    fresh : bool
        Whether each match has new genomes, whose preparation is then part of the time.
    clock : Clock
        The measurement.
    """
    config = mw.WorldConfig("O", max_steps=SHORT, obstacles=obstacles)
    team, each = population(config, hidden, GENOMES), np.arange(GENOMES)

    def play(number: int) -> int:
        seeds = number * GENOMES + each
        matches = mw.Matches.of(each, each[::-1], seeds) if fresh else mw.Matches.of(0, 1, seeds)
        return decisions(config, team, matches, episodes=1, threads=1)

    return clock.rate(play)


def with_memory(rounds: int, clock: Clock) -> dict[Memory, float]:
    """Return the CPU seconds of a decision by memory: the least of many short repeats in turns."""
    # Short repeats, so that other programs interrupt few of them.
    config = mw.WorldConfig("O", max_steps=max(rounds // 10, 1))
    teams = {memory: population(config, REMEMBERING, 2, memory) for memory in GATES}
    for team in teams.values():
        team.network.layers(team.genomes[0])[-1][0][:] = 0  # all play the same matches, at random
    least = dict.fromkeys(teams, math.inf)
    for _ in range(max(1, round(40 * clock.seconds * clock.repeats))):
        for memory, team in teams.items():
            start = time.process_time()
            played = decisions(config, team, mw.Matches.of(0, 0, 1), EPISODES, 1)
            least[memory] = min(least[memory], (time.process_time() - start) / played)
    return least


def gemm(core_type: str | None, clock: Clock) -> tuple[float, str]:
    """Return flop/s of NumPy's float32 matrix product on one thread, and the instruction set."""
    # OpenBLAS reads its settings when it is loaded, hence the environment of a new process.
    environment = os.environ | {"OPENBLAS_NUM_THREADS": "1"}
    if core_type is not None:
        environment["OPENBLAS_CORETYPE"] = core_type
    script = str(Path(__file__).with_name("gemm.py"))
    command = [sys.executable, script, *map(str, (GEMM_SIDE, clock.seconds, clock.repeats))]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    flops, architecture = done.stdout.split(maxsplit=1)
    return float(flops), architecture.strip()


# ---- Tables ----------------------------------------------------------------------------------


def dense_flop(hidden: tuple[int, ...]) -> int:
    """Return the flop of a decision without the first layer.

    The first layer adds the weights of the cells that are set, and does not multiply.
    """
    return sum(2 * n_in * n_out for n_in, n_out in pairwise((*hidden, 5)))


def print_long(rounds: int, clock: Clock) -> dict[tuple[int, ...], float]:
    """Print the table of long episodes, and return decisions per second on one thread."""
    bind(1)
    alone = {hidden: long_episodes(hidden, rounds, 1, clock) for hidden in HIDDEN}
    both = {}
    if n_cores() > 1:
        bind(2)
        # Twice the matches on twice the threads: the work of each thread stays the same.
        both = {hidden: long_episodes(hidden, rounds, 2, clock) for hidden in HIDDEN}
        bind(1)
    rows = [
        (
            list(hidden),
            millions(alone[hidden].per_second),
            f"{1e9 * alone[hidden].cpu:.1f}",
            millions(both[hidden].per_second) if both else "",
        )
        for hidden in HIDDEN
    ]
    header = ("million decisions/s", "1 thread", "CPU, ns a decision", "2 threads")
    print_table(header, rows)
    return {hidden: measured.per_second for hidden, measured in alone.items()}


def print_short(clock: Clock) -> None:
    rows = [
        (
            list(hidden),
            obstacles,
            *(millions(short_episodes(hidden, obstacles, fresh, clock)) for fresh in (True, False)),
        )
        for hidden in HIDDEN
        for obstacles in (0.0, 0.1)
    ]
    header = ("million decisions/s", "obstacles", "new genomes each match", "the same genomes")
    print_table(header, rows)


def print_memory(rounds: int, clock: Clock) -> None:
    """Print rates beside the plain network, and the products that each decision has to add."""
    bind(1)
    cost = with_memory(rounds, clock)
    n = REMEMBERING[0]
    rows = [
        (
            f"{list(REMEMBERING)}, {memory}",
            dense_flop(REMEMBERING) // 2 + 2 * n * GATES[memory] * n,
            f"{1e9 * seconds:.1f}",
            f"{cost['none'] / seconds:.2f}",
        )
        for memory, seconds in cost.items()
    ]
    header = ("memory", "multiply-adds a decision", "CPU, ns a decision", "rate, plain = 1")
    print_table(header, rows)


def print_gemm(alone: dict[tuple[int, ...], float], clock: Clock) -> None:
    measured = [gemm(core_type, clock) for core_type in CORE_TYPES]
    best = max(flops for flops, _ in measured)
    rows = [
        (f"GEMM, OpenBLAS {how} ({architecture})", f"{flops / 1e9:.1f}", f"{flops / best:.2f}")
        for (flops, architecture), how in zip(measured, ("default", "forced"), strict=True)
    ]
    for hidden, rate in alone.items():
        flops = rate * dense_flop(hidden)
        rows.append(
            (f"dense layers of {list(hidden)}", f"{flops / 1e9:.1f}", f"{flops / best:.2f}")
        )
    print_table(("float32, 1 thread", "Gflop/s", "share of the faster GEMM"), rows)


def millions(rate: float) -> str:
    return f"{rate / 1e6:.2f}"


@click.command()
@click.option("--seconds", default=1.0, show_default=True, help="time of one repeat")
@click.option("--repeats", default=5, show_default=True, help="repeats of which the median counts")
@click.option("--rounds", default=500, show_default=True, help="rounds of a long episode")
def main(seconds: float, repeats: int, rounds: int) -> None:
    """Print tables in Markdown: long and short episodes, memory, and a comparison with GEMM."""
    clock = Clock(seconds, repeats)
    for hidden in HIDDEN:
        check(hidden)
    # The rates on one thread serve the comparison with GEMM below.
    alone = print_long(rounds, clock)
    print_short(clock)
    print_memory(rounds, clock)
    print_gemm(alone, clock)


if __name__ == "__main__":
    main()
