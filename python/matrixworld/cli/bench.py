"""``matrixworld bench``: how fast this machine plays worlds and matches.

An agent-step is one step of an agent that is alive when the step begins, as in
`EpisodeStatistics`. Worlds are played with random actions that are drawn before the clock starts;
an episode that ends is followed by a new one. Matches are played between untrained networks; one
call plays the matches of an epoch of ``matrixworld evolve``.
"""

from __future__ import annotations

import os
import platform
import re
import statistics
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, fields
from functools import partial
from pathlib import Path
from typing import Any

import click
import numpy as np
from numpy.typing import NDArray

from matrixworld import _core
from matrixworld._util.checks import check_threads, processor_name, usable_cores
from matrixworld.cli.arguments import failures
from matrixworld.cli.console import INTERRUPTED, note, print_table, print_wrapped, progress
from matrixworld.cli.options import (
    cols_option,
    diagonal_option,
    force_option,
    fov_option,
    given_options,
    json_option,
    n_evaders_option,
    n_pursuers_option,
    obstacles_option,
    refuse_existing,
    rows_option,
    threads_option,
    write_json,
)
from matrixworld.cli.setting_options import Asked
from matrixworld.coevolution import TEAMS, RaceSettings
from matrixworld.envs.vector import VectorEnv
from matrixworld.play.rollout import EpisodeStatistics, Matches, rollout
from matrixworld.version import __version__
from matrixworld.world.arrays import array_specs, episode_specs
from matrixworld.world.batch import Batch
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import Network, Population
from matrixworld.world.rules import VARIANTS
from matrixworld.world.world import World

Figures = dict[str, Any]

# The default of `evolve`, a common size, and the network of the published runs.
HIDDEN = ("32", "64,64", "400,300")
REPEATS, SECONDS, LONGEST = 5, 4.0, 3600.0

MANY = 1024
MOST_VIEWS = 2**28
"""Most bytes of views; where `MANY` worlds need more, fewer worlds are played."""
COUNTED = 2**20
"""Agent-steps, of living and dead agents, from which the share of the living is estimated."""
SPARE, PLACES = 2**20, 4093
"""Random actions beside those of one step, and windows of them that are played in turn."""
CHECKED_WORLDS, CHECKED_STEPS, CHECKED_MATCHES = 5, 16, 4

LEARNING = 100_000_000
"""Agent-steps that a reinforcement learner may need."""
LEAST_SPEEDUP, LEAST_SHARE = 1.5, 0.25
"""Least speedup of several threads on an idle machine, in all and per thread."""
WIDEST_SPREAD = 0.3
"""Largest spread of repeats on an idle machine, as a share of the median."""


COLUMNS = {
    "at once": ("at_once", 1, "d"),
    "threads": ("threads", 1, "d"),
    "million agent-steps/s": ("agent_steps_per_second", 1e-6, ".2f"),
    "world steps/s": ("world_steps_per_second", 1, ",.0f"),
    "matches/s": ("matches_per_second", 1, ",.1f"),
    "speedup": ("over_one_thread", 1, ",.2f"),
}
"""Columns of the table: key of the figures, unit and format."""
LEGEND = (
    "An agent-step is one step of a living agent, in matches one decision of a network. At once: "
    "worlds in a step, or matches in a call. Speedup: over one thread."
)


# ---- What is measured ----------------------------------------------------------------------------


@dataclass
class Timing:
    """A call that plays `size` worlds or matches, and the rates (calls a second) so far.

    `agent_steps` and `world_steps` are those of one call.
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
        # An untimed call fills the caches, which the timing before has used. A call of matches is
        # so long that this does not matter.
        if self.hidden is None:
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


def random_actions(config: WorldConfig, worlds: int) -> Callable[[int], NDArray[np.uint8]]:
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


def timings_of_worlds(config: WorldConfig, threads: int) -> list[Timing]:
    """Prepare the timings of steps, of many worlds and of one, with one thread and several."""
    many = many_worlds(config)
    alive = {worlds: alive_share(config, worlds) for worlds in (many, 1)}
    played: dict[str, Callable[[int, int], Any]] = {
        "step only": lambda worlds, n: _batch(config, worlds, n),
        "step and views": lambda worlds, n: _batch(config, worlds, n, "views"),
        "VectorEnv": lambda worlds, n: _vector_env(config, worlds, n, copy=True),
        "VectorEnv, copy=False": lambda worlds, n: _vector_env(config, worlds, n, copy=False),
    }

    def timing(what: str, worlds: int, n: int) -> Timing:
        env, actions = played[what](worlds, n), random_actions(config, worlds)
        agent_steps = worlds * config.n_agents * alive[worlds]
        return Timing(what, worlds, n, lambda k: env.step(actions(k)), agent_steps, worlds)

    # Threads divide the worlds, so one world is played by one thread. Steps without views are, too:
    # they are the cost of the rules alone.
    cases = dict.fromkeys([(many, 1), (1, 1), (many, threads)])
    return [
        timing(what, worlds, n)
        for what in played
        for worlds, n in cases
        if n == 1 or what != "step only"
    ]


def timings_of_matches(
    config: WorldConfig, network: Network, population: int, threads: int
) -> list[Timing]:
    """Prepare the timings of matches of a population of pursuers against one evader."""
    match = _match(config, network, population)
    # Every call plays the same matches, so their steps are counted once.
    scores = match(threads=threads)
    counts = int(scores.agent_steps.sum()), int(scores.length.sum())
    return [
        Timing("matches", population, n, partial(_played, match, n), *counts, network.hidden)
        for n in dict.fromkeys((1, threads))
    ]


def _played(match: Callable[..., EpisodeStatistics], threads: int, call: int) -> None:
    match(threads=threads)


def _match(config: WorldConfig, network: Network, size: int) -> Callable[..., EpisodeStatistics]:
    pursuers, evaders = (
        Population(np.stack([network.initial(rng) for _ in range(count)]), network)
        for rng, count in zip(map(np.random.default_rng, (0, 1)), (size, 1), strict=True)
    )
    matches = Matches.of(np.arange(size), 0, np.arange(size))
    return partial(rollout, config, pursuers, evaders, matches)


def many_worlds(config: WorldConfig) -> int:
    """Return `MANY`, or the number of worlds whose views fit into `MOST_VIEWS`."""
    # A view has three channels of one byte a cell.
    return max(1, min(MANY, MOST_VIEWS // (config.n_agents * 3 * config.fov**2)))


def alive_share(config: WorldConfig, worlds: int) -> float:
    """Return the share of the agents that are alive when a step begins."""
    # At least one whole episode is played, because agents disappear in the course of it.
    some = max(1, min(worlds, COUNTED // (config.n_agents * config.max_steps)))
    steps = max(config.max_steps, COUNTED // (config.n_agents * some))
    batch, actions = _batch(config, some, 1, "acted"), random_actions(config, some)
    counts = [np.count_nonzero(batch.step(actions(step))["acted"]) for step in range(steps)]
    return sum(counts) / (steps * some * config.n_agents)


def _batch(config: WorldConfig, worlds: int, threads: int, *names: str) -> Batch:
    specs = array_specs(config) | episode_specs(config)
    buffers = {name: np.zeros((worlds, *specs[name][0]), specs[name][1]) for name in names}
    # Every step of every world is then a step of an episode.
    mode = _core.Autoreset.SAME_STEP
    return Batch(worlds, config, threads=threads, autoreset=mode, buffers=buffers)


def _vector_env(config: WorldConfig, worlds: int, threads: int, *, copy: bool) -> VectorEnv:
    env = VectorEnv(config, worlds, threads=threads, copy=copy, autoreset_mode="SameStep")
    env.reset(seed=0)
    return env


# ---- Checks --------------------------------------------------------------------------------------


def check_worlds(config: WorldConfig, threads: int) -> None:
    """Compare a `VectorEnv` with single worlds; raise click.ClickException if they differ."""
    worlds = [World(config) for _ in range(CHECKED_WORLDS)]
    env = VectorEnv(config, CHECKED_WORLDS, autoreset_mode="Disabled", threads=threads)
    env.reset(seed=0)
    for seed, world in enumerate(worlds):
        world.reset(seed)
    actions = random_actions(config, CHECKED_WORLDS)
    for step in range(CHECKED_STEPS):
        env.step(actions(step))
        for seed, world in enumerate(worlds):
            if world.terminated or world.truncated:
                continue
            world.step(actions(step)[seed])
            pairs: dict[str, tuple[NDArray[Any], NDArray[Any]]] = {
                "observations": (env.observations[seed], world.views()),
                "rewards": (env.rewards[seed], world.rewards),
                "positions": (env.infos["positions"][seed], world.positions),
            }
            for name, (ours, theirs) in pairs.items():
                where = f"in {name} after step {step + 1} of seed {seed}"
                _check_equal(ours, theirs, f"VectorEnv and a single world differ {where}")


def check_matches(config: WorldConfig, network: Network, threads: int) -> None:
    """Compare several threads with one; raise click.ClickException if the results differ."""
    match = _match(config, network, CHECKED_MATCHES)
    # Also where only one thread is measured, there must be something to compare with.
    several = max(2, threads)
    one, more = (match(episodes=2, threads=n) for n in (1, several))
    for name in (item.name for item in fields(EpisodeStatistics)):
        wrong = f"rollout: {name} with {several} threads differs from 1 thread"
        _check_equal(getattr(one, name), getattr(more, name), wrong)


def _check_equal(ours: NDArray[Any], theirs: NDArray[Any], wrong: str) -> None:
    if not np.array_equal(ours, theirs):
        raise click.ClickException(f"{wrong}. Nothing was measured, because the results are wrong.")


# ---- The command ---------------------------------------------------------------------------------


def _variant(ctx: click.Context, param: click.Parameter, value: str) -> str:
    if value.upper() not in VARIANTS:
        raise click.BadParameter(f"expected one of {', '.join(VARIANTS)}, got {value!r}")
    return value.upper()


def _sizes_of(value: str) -> tuple[int, ...]:
    """Return layer sizes such as 32 or 64,64; none: no layer."""
    if not re.fullmatch(r"none|\d{1,9}(,\d{1,9})*", value):
        raise click.BadParameter(f"expected sizes such as 32 or 64,64, or none, got {value!r}")
    return () if value == "none" else tuple(map(int, value.split(",")))


def _seconds(ctx: click.Context, param: click.Parameter, value: float) -> float:
    # Not click.FloatRange, which lets nan pass.
    if not 0 < value <= LONGEST:
        raise click.BadParameter(f"expected a number above 0, at most {LONGEST:g}, got {value:g}")
    return value


@click.command("bench", short_help="Measure how fast this machine plays.")
@click.argument("variant", default="O", callback=_variant)
@click.option(
    "--hidden",
    type=_sizes_of,
    multiple=True,
    default=HIDDEN,
    metavar="SIZES",
    help="hidden layers of the networks in matches, such as 32 or 64,64; none: no hidden layer; "
    f"may be given several times  [default: {' and '.join(HIDDEN)}]",
)
@click.option(
    "--seconds",
    type=float,
    default=SECONDS,
    show_default=True,
    callback=_seconds,
    metavar="NUMBER",
    help=f"time of each measurement, in {REPEATS} repeats; there are about 14",
)
@threads_option
@json_option
@force_option
@rows_option
@cols_option
@n_pursuers_option
@n_evaders_option
@obstacles_option
@fov_option
@diagonal_option
def bench_command(
    variant: str,
    hidden: tuple[tuple[int, ...], ...],
    seconds: float,
    threads: int | None,
    json_file: Path | None,
    force: bool,
    **options: Any,
) -> None:
    """Measure how fast worlds and matches are played on this machine.

    Takes about a minute; other programs should not be busy meanwhile. VARIANT is a game (O, SB,
    ...), by default O. Everything is measured with one thread and with --threads. First the
    results are checked: those of many worlds against single worlds, and those of several threads
    against one.

    Ctrl-C stops, and prints what has been measured so far.
    """
    refuse_existing(json_file, force=force)
    given = given_options(options)
    # One row of races for each network; the first network is that of the world's own lines.
    asked = {**given, "variant": variant}
    races = [Asked(asked, [("policy.hidden", h)]).settings() for h in dict.fromkeys(hidden)]
    settings = [race for race, *_ in races]
    world, threads = settings[0].world, check_threads(threads)
    machine = machine_figures()
    print_head(machine, variant, world)
    with failures():
        measured, stopped = _measure(settings, world, threads, seconds / REPEATS)
    if measured:
        lines = lines_of(measured)
        evolve = evolve_figures(lines, races[0])
        print_lines(lines)
        where = "" if variant == "O" and not given else " in this world"
        for sentence in (*durations(lines, evolve, where), *hints(lines)):
            print_wrapped(sentence)
        figures = {"machine": machine, "world": world.to_json(), "lines": lines, "evolve": evolve}
        with failures():
            write_json(json_file, figures)
    if stopped:
        what = "The figures are from the time before" if measured else "Nothing was measured yet"
        note(f"\nStopped. {what}.")
        raise click.exceptions.Exit(INTERRUPTED)


def _measure(
    settings: Sequence[RaceSettings], world: WorldConfig, threads: int, seconds: float
) -> tuple[list[Timing], bool]:
    """Return what was measured, and whether Ctrl-C stopped it."""
    planned: list[Timing] = []
    stopped = False
    # Ctrl-C may come in the checks, too: then nothing is planned yet.
    try:
        short = settings[0].training_world
        check_worlds(world, threads)
        for each in settings:
            check_matches(short, each.network, threads)
        planned += timings_of_worlds(world, threads)
        for each in settings:
            planned += timings_of_matches(short, each.network, each.learner.population, threads)
        total = REPEATS * len(planned)
        with progress(unit="timings") as report:
            # In turns, so that a disturbance of some seconds does not spoil all repeats of a line.
            for number, one in enumerate(planned * REPEATS):
                report(one.what, number, total)
                one.repeat(seconds)
            report("done", total, total)
    except KeyboardInterrupt:
        stopped = True
    # After Ctrl-C some have not been measured at all.
    return [each for each in planned if each.rates], stopped


# ---- What is printed and written -----------------------------------------------------------------


def machine_figures() -> Figures:
    """Describe this machine."""
    try:
        level = _core.kernel_level().removeprefix("kernels_")
    except ValueError as error:  # the processor lacks what MATRIXWORLD_KERNELS names
        raise click.ClickException(str(error)) from error
    return {
        "processor": processor_name(),
        "cores": usable_cores(),
        "kernels": level if level == "base" else f"x86-64-{level}",
        "matrixworld": __version__,
        "numpy": np.__version__,
        "python": platform.python_version(),
    }


def print_head(machine: Figures, variant: str, world: WorldConfig) -> None:
    """Print the machine and the world."""
    # A forced instruction set explains figures that are lower than on other machines.
    chosen = ", as MATRIXWORLD_KERNELS says" if "MATRIXWORLD_KERNELS" in os.environ else ""
    versions = "matrixworld {matrixworld}, NumPy {numpy}, Python {python}"
    click.echo(
        f"{versions.format(**machine)}\n{machine['processor']}, "
        f"{_count(machine['cores'], 'core')} to use; kernels for {machine['kernels']}{chosen}\n"
        f"{variant}: {world.rows} x {world.cols} cells, {world.n_pursuers} pursuers against "
        f"{world.n_evaders} evaders, views of {world.fov} x {world.fov}\n"
    )


def lines_of(measured: Sequence[Timing]) -> list[Figures]:
    """Return the figures of each timing; those of several threads are compared with one."""
    # A line is compared with the line that differs from it in the threads only.
    ones = {(each.what, each.hidden, each.size): each for each in measured if each.threads == 1}
    lines = []
    for each in measured:
        one = ones.get((each.what, each.hidden, each.size), each)
        lines.append(
            {
                "what": each.what,
                "hidden": None if each.hidden is None else list(each.hidden),
                "at_once": each.size,
                "threads": each.threads,
                "agent_steps_per_second": each.rate * each.agent_steps,
                "world_steps_per_second": each.rate * each.world_steps,
                "matches_per_second": None if each.hidden is None else each.rate * each.size,
                "over_one_thread": None if one is each else each.rate / one.rate,
                "repeats": len(each.rates),
                "spread": (max(each.rates) - min(each.rates)) / each.rate,
            }
        )
    return lines


def evolve_figures(lines: Sequence[Figures], races: Sequence[RaceSettings]) -> Figures | None:
    """Estimate how long the matches of races take; None if no measured network is theirs."""
    # All races have the same network and world; they differ in the schedule.
    hidden = list(races[0].policy.hidden)
    rates = [line for line in lines if line["hidden"] == hidden]
    if not rates:
        return None
    trained, evaluated = (sum(counts) for counts in zip(*map(matches_of, races), strict=True))
    # The matches measured have the length of training; those of the evaluation are longer.
    longer = races[0].world.max_steps / races[0].train_steps
    # The last line is that of the most threads.
    return {
        "hidden": hidden,
        "threads": rates[-1]["threads"],
        "matches": trained + evaluated,
        "seconds": (trained + longer * evaluated) / rates[-1]["matches_per_second"],
    }


def matches_of(race: RaceSettings) -> tuple[int, int]:
    """Return the numbers of matches of a race's training and of its payoff matrix."""
    epochs = sum(race.schedule.total_epochs(team) for team in TEAMS)
    # Generation 0 is evaluated, too.
    cells = race.schedule.entries**2
    return epochs * race.learner.population * race.match_episodes, cells * race.evaluation_episodes


def print_lines(lines: Sequence[Figures]) -> None:
    """Print the table of all lines and what its columns mean."""

    def cell(value: float | None, unit: float, form: str) -> str:
        return "" if value is None else format(value * unit, form)

    rows = [
        (_name(line), *(cell(line[key], unit, form) for key, unit, form in COLUMNS.values()))
        for line in lines
    ]
    print_table([("", *COLUMNS), *rows], "<" + ">" * len(COLUMNS))
    click.echo()
    print_wrapped(LEGEND)
    click.echo()


def durations(lines: Sequence[Figures], evolve: Figures | None, where: str) -> Iterator[str]:
    """Yield what the figures mean for a user."""
    if evolve is not None:
        yield (
            f"The {evolve['matches']:,} matches of matrixworld evolve{where} with hidden layers "
            f"{_sizes(evolve['hidden'])} take about {_duration(evolve['seconds'])}, with "
            f"{_count(evolve['threads'], 'thread')}. The time of the learners is not included."
        )
    envs = [line for line in lines if line["what"] == "VectorEnv" and line["at_once"] > 1]
    if envs:
        seconds = LEARNING / envs[-1]["agent_steps_per_second"]
        yield (
            f"VectorEnv, with {envs[-1]['at_once']} worlds and "
            f"{_count(envs[-1]['threads'], 'thread')}, plays {LEARNING // 1_000_000} million "
            f"agent-steps in {_duration(seconds)}."
        )


def hints(lines: Sequence[Figures]) -> Iterator[str]:
    """Yield what looks wrong, with possible causes."""
    compared = [line for line in lines if line["over_one_thread"] is not None]
    worst = min(compared, key=lambda line: line["over_one_thread"], default=None)
    if worst and worst["over_one_thread"] < max(LEAST_SPEEDUP, LEAST_SHARE * worst["threads"]):
        yield (
            f"Hint: {worst['threads']} threads are only {worst['over_one_thread']:.2f} times as "
            f"fast as one ({_name(worst)}). Another process may be busy, or fewer cores may be "
            f"free than there are threads."
        )
    uneven = max(lines, key=lambda line: line["spread"])
    if uneven["spread"] > WIDEST_SPREAD:
        yield (
            f"Hint: the repeats of {_name(uneven)}, {uneven['at_once']} at once with "
            f"{_count(uneven['threads'], 'thread')}, differ by {uneven['spread']:.0%}. Another "
            f"process may be busy, the processor may change its clock, or --seconds may be too "
            f"short."
        )


def _name(line: Figures) -> str:
    return line["what"] if line["hidden"] is None else f"matches, hidden {_sizes(line['hidden'])}"


def _sizes(hidden: Sequence[int]) -> str:
    return ",".join(map(str, hidden)) or "none"


def _count(number: int, noun: str) -> str:
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"


def _duration(seconds: float) -> str:
    # From one and a half units on: "80 seconds" reads better than "1.3 minutes".
    for unit, length in (("hours", 3600.0), ("minutes", 60.0)):
        if seconds >= 1.5 * length:
            return f"{seconds / length:.{0 if seconds >= 10 * length else 1}f} {unit}"
    return f"{seconds:.{0 if seconds >= 10 else 1}f} seconds"
