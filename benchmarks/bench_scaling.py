"""Cost of a step and of a rollout against the number of agents, worlds and genomes.

    python benchmarks/bench_scaling.py [--seconds 0.3] [--repeats 5]

Agents: one world of SB, where no agent disappears, on grids of constant density and on grids of
two constant sizes, which show what the caches cost. Worlds: batches of SB with views.
Genomes: rollouts of O over 20 rounds, each genome in one world. Each number is the median of some
repeats on one core, to which the process is bound if the system supports it. A fitted exponent is
the slope of log seconds over log size in the upper half of the sizes. Before the measurement,
batches and rollouts are compared with single worlds and matches.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import click
import numpy as np

import matrixworld as mw
from timing import Clock, bind, print_table, random_actions

LARGEST = {"agents": 100_000, "worlds": 100_000, "genomes": 10_000}
SIDES = (2048, 1024)
PURSUERS = 8 / 38  # share of the agents, as in the default world
NEVER = 10**9  # rounds: no episode ends during the measurement
ROUNDS = 20  # rounds of an episode in rollouts
SMALL: dict[str, Any] = {"rows": 10, "cols": 10, "n_pursuers": 2, "n_evaders": 6, "fov": 5}
WORLDS: dict[str, dict[str, Any]] = {
    "40 x 40, 8 v 30": {"n_pursuers": 8, "n_evaders": 30},
    "10 x 10, 2 v 6": SMALL,
}
HIDDEN = ((32,), (64, 64))


def sizes(first: int, largest: int) -> list[int]:
    """Return sizes from `first` to `largest`, two in each power of ten."""
    steps = round(2 * math.log10(largest / first))
    return [round(first * 10 ** (step / 2)) for step in range(steps + 1)]


# ---- Worlds and populations ------------------------------------------------------------------


def crowd(n_agents: int, side: int | None) -> mw.WorldConfig:
    """Return a world with many agents on a square; `side` None: constant density."""
    if side is None:
        side = math.ceil(SIDES[-1] * math.sqrt(n_agents / LARGEST["agents"]))
    n_pursuers = max(1, round(PURSUERS * n_agents))
    return mw.WorldConfig(
        "SB",
        rows=side,
        cols=side,
        n_pursuers=n_pursuers,
        n_evaders=n_agents - n_pursuers,
        max_steps=NEVER,
    )


def batch(config: mw.WorldConfig, n_worlds: int, *names: str) -> mw.Batch:
    specs = mw.array_specs(config)
    buffers = {name: np.zeros((n_worlds, *specs[name][0]), specs[name][1]) for name in names}
    return mw.Batch(n_worlds, config, threads=1, buffers=buffers)


def population(hidden: tuple[int, ...], n: int) -> mw.Population:
    network = mw.Network(hidden)
    rng = np.random.default_rng(0)
    genomes = rng.standard_normal((n, network.genome_size), dtype=np.float32)
    genomes *= np.float32(0.1)
    return mw.Population(genomes, network)


# ---- Checks before the measurement -------------------------------------------------------------


def check_batch(config: mw.WorldConfig) -> None:
    """Check that the worlds of a batch agree with single worlds."""
    worlds = [mw.World(config) for _ in range(3)]
    together = batch(config, len(worlds), "positions", "rewards", "views")
    rng = np.random.default_rng(0)
    for seed, world in enumerate(worlds):
        world.reset(seed)
    for _ in range(10):
        actions = rng.integers(config.n_actions, size=(len(worlds), config.n_agents))
        arrays = together.step(actions)
        for number, world in enumerate(worlds):
            world.step(actions[number])
            assert (arrays["positions"][number] == world.positions).all()
            assert (arrays["rewards"][number] == world.rewards).all()
            assert (arrays["views"][number] == world.views()).all()


def check_rollout(team: mw.Population) -> None:
    """Check that the matches of a rollout agree with single matches."""
    config, n = mw.WorldConfig("O", max_steps=ROUNDS), len(team.genomes)
    fractions = rollout(config, team, n).captured_fraction[:, 0]
    for genome in range(n):
        episode = mw.record(config, team, team, seed=genome, pursuer=genome, evader=0)
        share = [moment.mean() for moment in episode.ever_captured[1:]]
        share += [share[-1]] * (ROUNDS - episode.length)  # an ended episode keeps its share
        assert math.isclose(fractions[genome], np.mean(share), abs_tol=1e-6)


# ---- Measurements ----------------------------------------------------------------------------


@dataclass(frozen=True)
class Curve:
    """Seconds by size."""

    label: str
    sizes: Sequence[int]
    seconds: Sequence[float]

    @property
    def upper(self) -> slice:
        """Upper half of the sizes, including the middle one."""
        return slice((len(self.sizes) - 1) // 2, None)

    @property
    def exponent(self) -> float:
        """Slope of log seconds over log size in the upper half, by least squares."""
        # Small sizes are dominated by constant cost.
        sizes, seconds = self.sizes[self.upper], self.seconds[self.upper]
        if len(sizes) < 2:
            return float("nan")
        return float(np.polyfit(np.log(sizes), np.log(seconds), 1)[0])


def rollout(config: mw.WorldConfig, team: mw.Population, n: int) -> mw.EpisodeStatistics:
    """Play the first n genomes as pursuers, each against genome 0 in one world."""
    each = np.arange(n)
    return mw.rollout(config, team, team, mw.Matches.of(each, 0, each), threads=1)


def step_seconds(
    config: mw.WorldConfig, names: Sequence[str], clock: Clock, n_worlds: int
) -> float:
    """Return the seconds of a step of all worlds, including the output arrays of these names."""
    timed = batch(config, n_worlds, *names)
    actions = random_actions(config.n_actions, (n_worlds, config.n_agents))

    def play(i: int) -> int:
        timed.step(actions(i))
        return 1

    return 1 / clock.rate(play)


def crowd_seconds(side: int | None, names: Sequence[str], clock: Clock, n_agents: int) -> float:
    """Return the seconds of a step of one world."""
    return step_seconds(crowd(n_agents, side), names, clock, 1)


def rollout_seconds(team: mw.Population, clock: Clock, n: int) -> float:
    """Return the seconds of a rollout of n genomes."""
    config = mw.WorldConfig("O", max_steps=ROUNDS)

    def play(_: int) -> int:
        rollout(config, team, n)
        return 1

    return 1 / clock.rate(play)


def curve(
    label: str, numbers: Sequence[int], clock: Clock, seconds: Callable[[Clock, int], float]
) -> Curve:
    """Return the medians over repeats of all sizes."""
    # All sizes are measured in turn: a disturbance of the machine then hits one repeat of several
    # sizes instead of all repeats of one size.
    once = replace(clock, repeats=1)
    rounds = [[seconds(once, number) for number in numbers] for _ in range(clock.repeats)]
    return Curve(label, numbers, np.median(rounds, axis=0).tolist())


def agent_curves(largest: int, clock: Clock) -> list[Curve]:
    numbers = sizes(10, largest)
    return [
        curve(label, numbers, clock, partial(crowd_seconds, side, names))
        for label, side, names in (
            ("constant density, with views", None, ["views"]),
            *((f"{side} x {side} cells", side, []) for side in SIDES),
            ("constant density", None, []),
        )
    ]


def world_curves(largest: int, clock: Clock) -> list[Curve]:
    curves = []
    for label, changes in WORLDS.items():
        config = mw.WorldConfig("SB", max_steps=NEVER, **changes)
        seconds = partial(step_seconds, config, ["views"])
        curves.append(curve(f"{label}, with views", sizes(1, largest), clock, seconds))
    return curves


def genome_curves(largest: int, clock: Clock) -> list[Curve]:
    curves = []
    for hidden in reversed(HIDDEN):
        seconds = partial(rollout_seconds, population(hidden, largest))
        curves.append(curve(f"hidden {list(hidden)}", sizes(1, largest), clock, seconds))
    return curves


# ---- Tables ----------------------------------------------------------------------------------


def print_curves(what: str, curves: Sequence[Curve]) -> None:
    rows = [
        (
            c.label,
            f"{c.sizes[0]:,} to {c.sizes[-1]:,}",
            f"{c.seconds[0] * 1e6:.2f}",
            f"{c.seconds[-1] * 1e6:,.0f}",
            f"{c.seconds[-1] / c.sizes[-1] * 1e6:.3g}",
            f"{c.exponent:.2f}",
            f"{c.sizes[c.upper][0]:,} to {c.sizes[-1]:,}",
        )
        for c in curves
    ]
    header = (what, "range", "μs, smallest", "μs, largest", "μs each", "exponent", "fitted over")
    print_table(header, rows)


@click.command()
@click.option("--seconds", default=0.3, show_default=True, help="time of one repeat")
@click.option("--repeats", default=5, show_default=True, help="repeats of which the median counts")
@click.option("--largest", type=int, help="largest number of agents, worlds and genomes")
def main(seconds: float, repeats: int, largest: int | None) -> None:
    """Print tables in Markdown."""
    most = {what: min(n, largest or n) for what, n in LARGEST.items()}
    clock = Clock(seconds, repeats)
    check_batch(crowd(1000, None))
    check_batch(mw.WorldConfig("SB", **SMALL))
    check_rollout(population((32,), 8))
    bind(1)
    # Single-threaded throughout: scaling with threads is measured by bench_rollouts.py.
    print_curves("agents", agent_curves(most["agents"], clock))
    print_curves("worlds", world_curves(most["worlds"], clock))
    print_curves("genomes", genome_curves(most["genomes"], clock))


if __name__ == "__main__":
    main()
