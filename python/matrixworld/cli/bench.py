"""``matrixworld bench``: how fast this machine plays worlds and matches.

An agent-step is one step of an agent that is alive when the step begins, as in
`EpisodeStatistics`. Worlds are played with random actions that are drawn before the clock starts;
an episode that ends is followed by a new one. Matches are played between untrained networks; one
call plays the matches of an epoch of ``matrixworld evolve``.
"""

from __future__ import annotations

import os
import platform
import statistics
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
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
from matrixworld.cli.console import (
    INTERRUPTED,
    in_words,
    note,
    print_table,
    print_wrapped,
    progress,
    say,
)
from matrixworld.cli.options import (
    FiniteRange,
    force_option,
    json_option,
    refuse_existing,
    threads_option,
    write_json,
)
from matrixworld.cli.setting_options import parsed, set_option, settings_of
from matrixworld.coevolution import TEAMS, Progress, RaceSettings
from matrixworld.envs.vector import VectorEnv
from matrixworld.play.rollout import EpisodeStatistics, Matches, rollout
from matrixworld.version import __version__
from matrixworld.world.arrays import array_specs, episode_specs
from matrixworld.world.batch import Batch
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import Population
from matrixworld.world.world import World

Line = dict[str, Any]
"""Figures by name, as the file has them."""

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

AMOUNTS = {
    "agent_steps": ("million agent-steps/s", 1e-6, ".2f"),
    "world_steps": ("world steps/s", 1, ",.0f"),
    "matches": ("matches/s", 1, ",.1f"),
}
"""What a call plays: its column in the table, with unit and format."""
LEGEND = (
    "An agent-step is one step of a living agent, in matches one decision of a network. At once: "
    "worlds in a step, or matches in a call. Speedup: over one thread."
)


# What is measured:


@dataclass
class Timing:
    """A call that plays `at_once` worlds or matches, and the rates (calls a second) so far.

    `amounts` has what one call plays, by the names in `AMOUNTS`.
    """

    what: str
    at_once: int
    threads: int
    play: Callable[[int], object]
    amounts: Mapping[str, float]
    rates: list[float] = field(default_factory=list)

    def repeat(self, seconds: float) -> None:
        """Call for so many seconds, at least once, and append the rate to `rates`."""
        # An untimed call fills the caches, which the timing before has used. A call of matches is
        # so long that this does not matter.
        if "matches" not in self.amounts:
            self.play(0)
        calls, passed, start = 0, 0.0, time.perf_counter()
        while calls == 0 or passed < seconds:
            self.play(calls)
            calls += 1
            passed = time.perf_counter() - start
        self.rates.append(calls / passed)

    @property
    def per_second(self) -> dict[str, float]:
        """What is played in a second, by the median of the repeats."""
        rate = statistics.median(self.rates)
        return {name: rate * amount for name, amount in self.amounts.items()}


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
    env = partial(VectorEnv, config, autoreset_mode="SameStep")
    played: dict[str, Callable[[int, int], Any]] = {
        "step only": lambda worlds, n: _batch(config, worlds, n),
        "step and views": lambda worlds, n: _batch(config, worlds, n, "views"),
        "VectorEnv": lambda worlds, n: env(worlds, threads=n),
        "VectorEnv, copy=False": lambda worlds, n: env(worlds, threads=n, copy=False),
    }

    def timing(what: str, worlds: int, n: int) -> Timing:
        game, actions = played[what](worlds, n), random_actions(config, worlds)
        if isinstance(game, VectorEnv):
            game.reset(seed=0)
        amounts = {"agent_steps": worlds * config.n_agents * alive[worlds], "world_steps": worlds}
        return Timing(what, worlds, n, lambda call: game.step(actions(call)), amounts)

    # Threads divide the worlds, so one world is played by one thread. Steps without views are, too:
    # they are the cost of the rules alone.
    cases = dict.fromkeys([(many, 1), (1, 1), (many, threads)])
    return [
        timing(what, worlds, n)
        for what in played
        for worlds, n in cases
        if n == 1 or what != "step only"
    ]


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


def timings_of_matches(race: RaceSettings, threads: int) -> list[Timing]:
    """Prepare the timings of the matches of an epoch: a population against one evader."""
    size = race.learner.population
    match = _match(race, size)
    # Every call plays the same matches, so their steps are counted once.
    scores = match(threads=threads)
    amounts = {
        "agent_steps": int(scores.agent_steps.sum()),
        "world_steps": int(scores.length.sum()),
        "matches": size,
    }

    def timing(n: int) -> Timing:
        return Timing(_matches(race), size, n, lambda call: match(threads=n), amounts)

    return [timing(n) for n in dict.fromkeys((1, threads))]


def _match(race: RaceSettings, size: int) -> Callable[..., EpisodeStatistics]:
    """Return the rollout of so many untrained pursuers against one untrained evader."""
    network = race.network
    pursuers, evaders = (
        Population(np.stack([network.initial(rng) for _ in range(count)]), network)
        for rng, count in zip(map(np.random.default_rng, (0, 1)), (size, 1), strict=True)
    )
    matches = Matches.of(np.arange(size), 0, np.arange(size))
    return partial(rollout, race.training_world, pursuers, evaders, matches)


# Checks:


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
            where = f"after step {step + 1} of seed {seed}"
            for name, ours, theirs in (
                ("observations", env.observations, world.views()),
                ("rewards", env.rewards, world.rewards),
                ("positions", env.infos["positions"], world.positions),
            ):
                wrong = f"VectorEnv and a single world differ in {name} {where}"
                _check_equal(ours[seed], theirs, wrong)


def check_matches(race: RaceSettings, threads: int) -> None:
    """Compare several threads with one; raise click.ClickException if the results differ."""
    match = _match(race, CHECKED_MATCHES)
    # Also where only one thread is measured, there must be something to compare with.
    several = max(2, threads)
    one, more = (match(episodes=2, threads=n) for n in (1, several))
    for name in (item.name for item in fields(EpisodeStatistics)):
        wrong = f"rollout: {name} with {several} threads differs from 1 thread"
        _check_equal(getattr(one, name), getattr(more, name), wrong)


def _check_equal(ours: NDArray[Any], theirs: NDArray[Any], wrong: str) -> None:
    if not np.array_equal(ours, theirs):
        raise click.ClickException(f"{wrong}. Nothing was measured, because the results are wrong.")


# The command:


@click.command("bench", short_help="Measure how fast this machine plays.")
@click.argument("variant", default="O", type=click.types.FuncParamType(str.upper))
@click.option(
    "--hidden",
    type=parsed,
    multiple=True,
    default=HIDDEN,
    metavar="SIZES",
    help="hidden layers of the networks in matches, such as 32 or 64,64; []: no hidden layer; "
    f"may be given several times  [default: {' and '.join(HIDDEN)}]",
)
@click.option(
    "--seconds",
    type=FiniteRange(0, LONGEST, min_open=True),
    default=SECONDS,
    show_default=True,
    metavar="NUMBER",
    help=f"time of each measurement, in {REPEATS} repeats; there are about 14",
)
@threads_option
@set_option
@json_option
@force_option
def bench_command(
    variant: str,
    hidden: tuple[Any, ...],
    seconds: float,
    threads: int | None,
    sets: list[tuple[str, Any]],
    json_file: Path | None,
    force: bool,
) -> None:
    """Measure how fast worlds and matches are played on this machine.

    Takes about a minute; other programs should not be busy meanwhile. VARIANT is a game (O, SB,
    ...), by default O. Everything is measured with one thread and with --threads. First the
    results are checked: those of many worlds against single worlds, and those of several threads
    against one.

    Ctrl-C stops, and prints what has been measured so far.
    """
    refuse_existing(json_file, force=force)
    # The races of `evolve` for each network; the lines without a network have the world of all.
    jobs = [
        settings_of({"variant": variant, "sets": [*sets, ("policy.hidden", sizes)]})
        for sizes in hidden
    ]
    races = list(dict.fromkeys(first for first, *_ in jobs))
    world, threads = races[0].world, check_threads(threads)
    machine = print_head(variant, world)
    timings: list[Timing] = []
    stopped = False
    with failures():
        # Ctrl-C may come in the checks, too: then nothing is planned yet.
        try:
            _measure(races, threads, seconds / REPEATS, timings)
        except KeyboardInterrupt:
            stopped = True
        measured = [each for each in timings if each.rates]
        if measured:
            lines, evolve = lines_of(measured), evolve_figures(measured, jobs[0])
            print_lines(lines)
            for sentence in (*durations(measured, evolve), *hints(lines)):
                print_wrapped(sentence)
            found = {"machine": machine, "world": world.to_json(), "lines": lines, "evolve": evolve}
            write_json(json_file, found)
    if stopped:
        what = "The figures are from the time before" if measured else "Nothing was measured yet"
        note(f"\nStopped. {what}.")
        raise click.exceptions.Exit(INTERRUPTED)


def _measure(
    races: Sequence[RaceSettings], threads: int, seconds: float, timings: list[Timing]
) -> None:
    """Check the results, and append to `timings` what is then measured."""
    check_worlds(races[0].world, threads)
    for race in races:
        check_matches(race, threads)
    timings += timings_of_worlds(races[0].world, threads)
    for race in races:
        timings += timings_of_matches(race, threads)
    total = REPEATS * len(timings)
    with progress(unit="timings") as report:
        # In turns, so that a disturbance of some seconds does not spoil all repeats of a line.
        for number, one in enumerate(timings * REPEATS):
            report(Progress(one.what, number, total))
            one.repeat(seconds)
        report(Progress("done", total, total))


# What is printed and written:


def print_head(variant: str, world: WorldConfig) -> dict[str, Any]:
    """Print the machine and the world; return what describes the machine."""
    level = _core.kernel_level().removeprefix("kernels_")
    machine = {
        "processor": processor_name(),
        "cores": usable_cores(),
        "kernels": level if level == "base" else f"x86-64-{level}",
        "matrixworld": __version__,
        "numpy": np.__version__,
        "python": platform.python_version(),
    }
    # A forced instruction set explains figures that are lower than on other machines.
    chosen = ", as MATRIXWORLD_KERNELS says" if "MATRIXWORLD_KERNELS" in os.environ else ""
    say(
        f"matrixworld {__version__}, NumPy {np.__version__}, Python {machine['python']}\n"
        f"{machine['processor']}, cores to use: {machine['cores']}; kernels for "
        f"{machine['kernels']}{chosen}\n"
        f"{variant}: {world.rows} x {world.cols} cells, {world.n_pursuers} pursuers against "
        f"{world.n_evaders} evaders, views of {world.fov} x {world.fov}\n"
    )
    return machine


def lines_of(measured: Sequence[Timing]) -> list[Line]:
    """Return the figures of each timing; those of several threads are compared with one."""
    speeds = {(each.what, each.at_once, each.threads): each.per_second for each in measured}
    lines = []
    for each in measured:
        one = speeds.get((each.what, each.at_once, 1)) if each.threads > 1 else None
        steps, median = each.per_second["world_steps"], statistics.median(each.rates)
        lines.append(
            {
                "what": each.what,
                "at_once": each.at_once,
                "threads": each.threads,
                **{f"{name}_per_second": each.per_second.get(name) for name in AMOUNTS},
                "over_one_thread": None if one is None else steps / one["world_steps"],
                "repeats": len(each.rates),
                "spread": (max(each.rates) - min(each.rates)) / median,
            }
        )
    return lines


def print_lines(lines: Sequence[Line]) -> None:
    """Print the table of all lines and what its columns mean."""

    def cell(value: float | None, unit: float, form: str) -> str:
        return "" if value is None else format(value * unit, form)

    heads = ("", "at once", "threads", *(head for head, *_ in AMOUNTS.values()), "speedup")
    rows = [
        (
            line["what"],
            str(line["at_once"]),
            str(line["threads"]),
            *(
                cell(line[f"{name}_per_second"], unit, form)
                for name, (_, unit, form) in AMOUNTS.items()
            ),
            cell(line["over_one_thread"], 1, ",.2f"),
        )
        for line in lines
    ]
    print_table([heads, *rows], "<" + ">" * (len(heads) - 1))
    say()
    print_wrapped(LEGEND)
    say()


def evolve_figures(measured: Sequence[Timing], races: Sequence[RaceSettings]) -> Line | None:
    """Estimate how long the matches of races take; None if no measured network is theirs.

    All races have the same network and world; they differ in the schedule.
    """
    known = [each for each in measured if each.what == _matches(races[0])]
    if not known:
        return None
    trained = sum(
        race.schedule.total_epochs(team) * race.learner.population * race.match_episodes
        for race in races
        for team in TEAMS
    )
    # Generation 0 is evaluated, too.
    evaluated = sum(race.schedule.entries**2 * race.evaluation_episodes for race in races)
    # The matches measured have the length of training; those of the evaluation are longer.
    longer = races[0].world.max_steps / races[0].train_steps
    most = known[-1]  # of the most threads
    return {
        "hidden": list(races[0].policy.hidden),
        "threads": most.threads,
        "matches": trained + evaluated,
        "seconds": (trained + longer * evaluated) / most.per_second["matches"],
    }


def seconds_of(races: Sequence[RaceSettings], threads: int | None) -> float | None:
    """Estimate how long the matches of races take, from those of one epoch.

    None if the time of the learner, which is not measured, is the larger part.
    """
    if races[0].learner.rounds_by_processor:
        return None
    timing = timings_of_matches(races[0], check_threads(threads))[-1]
    timing.repeat(0)
    found = evolve_figures([timing], races)
    return None if found is None else float(found["seconds"])


def durations(measured: Sequence[Timing], evolve: Line | None) -> Iterator[str]:
    """Yield what the figures mean for a user."""
    if evolve is not None:
        yield (
            f"The {evolve['matches']:,} matches of matrixworld evolve in this world with hidden "
            f"layers {_sizes(evolve['hidden'])} take about {in_words(evolve['seconds'])}, with "
            f"{_threads(evolve['threads'])}. The time of the learners is not included."
        )
    envs = [each for each in measured if each.what == "VectorEnv" and each.at_once > 1]
    for env in envs[-1:]:
        yield (
            f"VectorEnv, with {env.at_once} worlds and {_threads(env.threads)}, plays "
            f"{LEARNING // 1_000_000} million agent-steps in "
            f"{in_words(LEARNING / env.per_second['agent_steps'])}."
        )


def hints(lines: Sequence[Line]) -> Iterator[str]:
    """Yield what looks wrong, with possible causes."""
    compared = [line for line in lines if line["over_one_thread"] is not None]
    worst = min(compared, key=lambda line: line["over_one_thread"], default=None)
    if worst and worst["over_one_thread"] < max(LEAST_SPEEDUP, LEAST_SHARE * worst["threads"]):
        yield (
            f"Hint: {worst['threads']} threads are only {worst['over_one_thread']:.2f} times as "
            f"fast as one ({worst['what']}). Another process may be busy, or fewer cores may be "
            "free than there are threads."
        )
    uneven = max(lines, key=lambda line: line["spread"])
    if uneven["spread"] > WIDEST_SPREAD:
        yield (
            f"Hint: the repeats of {uneven['what']}, {uneven['at_once']} at once with "
            f"{_threads(uneven['threads'])}, differ by {uneven['spread']:.0%}. Another process may "
            "be busy, the processor may change its clock, or --seconds may be too short."
        )


def _matches(race: RaceSettings) -> str:
    return f"matches, hidden {_sizes(race.policy.hidden)}"


def _sizes(hidden: Sequence[int]) -> str:
    return ",".join(map(str, hidden)) or "none"


def _threads(number: int) -> str:
    return f"{number} thread{'' if number == 1 else 's'}"
