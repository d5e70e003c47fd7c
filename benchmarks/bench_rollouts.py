"""Decisions per second of networks in whole matches.

    python benchmarks/bench_rollouts.py [--seconds 1] [--repeats 5]

A decision is the step of one living agent: its view, its network and its share of the world's step.
Both teams are networks with genomes drawn from N(0, 0.1), in the last tables policies of each kind.
Each number is the median of some repeats. The process is bound to one core, and for two threads to
two cores, if the system supports it. Before the measurement, a match is replayed in plain NumPy.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from typing import Any

import click
import numpy as np
from numpy.typing import NDArray

import matrixworld as mw
from matrixworld.coevolution import RaceSettings, default_race
from timing import CORES, Clock, Rate, bind, print_table

HIDDEN: tuple[tuple[int, ...], ...] = ((32,), (64, 64), (400, 300))
SHORT = 20  # rounds of a short episode
EPISODES = 16  # of a match with long episodes
NETWORK = "network [32]"
TEAMWORK = ("escapes", "opposite", "parity")  # inputs that one asks for
GENOMES = 64  # population in short episodes; the largest genomes fill 68 MB


def population(config: mw.WorldConfig, hidden: tuple[int, ...], n: int) -> mw.Population:
    network = mw.Network.for_config(config, hidden)
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
    """Return decisions per second of matches of one episode: the same or `fresh` genomes."""
    config = mw.WorldConfig("O", max_steps=SHORT, obstacles=obstacles)
    team, each = population(config, hidden, GENOMES), np.arange(GENOMES)

    def play(number: int) -> int:
        seeds = number * GENOMES + each
        matches = mw.Matches.of(each, each[::-1], seeds) if fresh else mw.Matches.of(0, 1, seeds)
        return decisions(config, team, matches, episodes=1, threads=1)

    return clock.rate(play)


# ---- Tables ----------------------------------------------------------------------------------


def print_long(rounds: int, clock: Clock) -> None:
    bind(1)
    alone = {hidden: long_episodes(hidden, rounds, 1, clock) for hidden in HIDDEN}
    both = {}
    if len(CORES) > 1:
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


def print_policies(clock: Clock) -> None:
    """Print matches of one episode of 200 rounds, with 48 genomes of each kind of policy."""
    config, each = mw.WorldConfig("O", max_steps=200), np.arange(48)
    few = ("adversary", "teammate", "room")
    policies = {
        "network [32]": mw.Network.for_config(config),
        "rating of 3 inputs": mw.Rating.for_config(config, inputs=few),
        "rating of all inputs": mw.Rating.for_config(config),
        "the same, 4 hidden": mw.Rating.for_config(config, hidden=(4,)),
        "the same, right of way": mw.Rating.for_config(config, mask="right-of-way"),
        "program": mw.Program.for_config(config),
    }
    rows = []
    for name, policy in policies.items():
        genomes = np.stack([policy.initial(np.random.default_rng(seed)) for seed in each])
        if name == "program":
            text = "unclaimed + 0.5 * room - min(teammate, open_side) * pressure"
            genomes = np.tile(policy.genome(text), (48, 1))
        team = mw.Population(genomes, policy)

        def play(number: int, team: mw.Population = team) -> int:
            matches = mw.Matches.of(each, each, number * 48 + each)
            return mw.rollout(config, team, team, matches, threads=1).length.size

        rate = clock.measure(play)
        rows.append((name, f"{rate.per_second:.0f}", f"{1 / rate.cpu:.0f}"))
    print_table(("policy", "matches a second", "a CPU second"), rows)


def costs_of_ratings(config: mw.WorldConfig, clock: Clock) -> dict[str, list[float]]:
    """Return CPU seconds a decision of the network [32] and of ratings, a number for each repeat.

    They are measured in turn, so that what else the machine does slows all of them.
    """
    nine = mw.Rating.inputs
    inputs = {"adversary": nine[:1], "nine": nine, "twelve": (*nine, *TEAMWORK)}
    policies: dict[str, Any] = {NETWORK: mw.Network.for_config(config)}
    policies |= {name: mw.Rating.for_config(config, inputs=some) for name, some in inputs.items()}
    rng, each = np.random.default_rng(0), np.arange(32)
    teams = {}
    for name, policy in policies.items():
        genomes = rng.standard_normal((len(each), policy.genome_size), dtype=np.float32)
        teams[name] = mw.Population(np.float32(0.1 if name == NETWORK else 0.5) * genomes, policy)

    def cost(team: mw.Population) -> float:
        def play(number: int) -> int:
            matches = mw.Matches.of(each, each[::-1], 1000 * number + each)
            return decisions(config, team, matches, episodes=4, threads=1)

        return replace(clock, repeats=1).measure(play).cpu

    repeats = [{name: cost(team) for name, team in teams.items()} for _ in range(clock.repeats)]
    return {name: [each[name] for each in repeats] for name in teams}


def print_ratings(clock: Clock) -> None:
    """Print decisions of ratings by the number of their inputs, beside those of a network."""
    courtyard = RaceSettings.of(default_race("hall-of-fame")).game.world
    worlds = {"courtyard": courtyard, "O": mw.WorldConfig("O"), "S": mw.WorldConfig("S")}
    rows = []
    for world, config in worlds.items():
        costs = costs_of_ratings(config, clock)
        for name, cost in costs.items():
            share = np.median(np.divide(costs[NETWORK], cost))
            rows.append((world, name, f"{1e9 * np.median(cost):.1f}", f"{share:.2f}"))
    print_table(("world", "inputs", "CPU, ns a decision", "speed, times the network's"), rows)


def millions(rate: float) -> str:
    return f"{rate / 1e6:.2f}"


@click.command()
@click.option("--seconds", default=1.0, show_default=True, help="time of one repeat")
@click.option("--repeats", default=5, show_default=True, help="repeats of which the median counts")
@click.option("--rounds", default=500, show_default=True, help="rounds of a long episode")
def main(seconds: float, repeats: int, rounds: int) -> None:
    """Print tables in Markdown: long and short episodes, kinds of policies."""
    clock = Clock(seconds, repeats)
    for hidden in HIDDEN:
        check(hidden)
    print_long(rounds, clock)
    print_short(clock)
    print_policies(clock)
    print_ratings(clock)


if __name__ == "__main__":
    main()
