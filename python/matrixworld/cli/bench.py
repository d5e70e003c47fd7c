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
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any

import click
import numpy as np
from numpy.typing import NDArray

from matrixworld import _core
from matrixworld._util.checks import check_threads, processor_name, usable_cores
from matrixworld.cli.console import in_words, print_table, print_wrapped, progress, say
from matrixworld.cli.options import (
    VARIANT,
    FiniteRange,
    force_option,
    json_option,
    refuse_existing,
    threads_option,
    write_json,
)
from matrixworld.cli.setting_options import parsed, set_option, settings_of
from matrixworld.coevolution import TEAMS, HallOfFame, Progress, RaceSettings
from matrixworld.envs.vector import VectorEnv
from matrixworld.play.rollout import Matches, rollout
from matrixworld.version import __version__
from matrixworld.world.arrays import array_specs, episode_specs
from matrixworld.world.batch import Batch
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import Population

# The default of `evolve`, a common size, and the network of the published runs.
HIDDEN = ("32", "64,64", "400,300")
REPEATS, SECONDS, LONGEST = 5, 4.0, 3600.0
SAMPLED, LEARNED = 0.2, 1.25
"""Seconds of matches from which the time of a race is estimated, and how much longer its matches
take, on average, because teams learn to move."""

MANY = 1024
MOST_VIEWS = 2**28
"""Most bytes of views; where `MANY` worlds need more, fewer worlds are played."""
SAMPLE, EPISODES = 16, 4
"""Worlds that are played to estimate the share of the living, and for how many episodes."""
SPARE, PLACES = 2**20, 4093
"""Random actions beside those of one step, and windows of them that are played in turn."""

COLUMNS = {
    "agent_steps_per_second": ("million agent-steps/s", 1e-6, ".2f"),
    "world_steps_per_second": ("world steps/s", 1, ",.0f"),
    "matches_per_second": ("matches/s", 1, ",.1f"),
    "over_one_thread": ("speedup", 1, ",.2f"),
    "spread": ("spread", 1, ".0%"),
}
"""Numbers of a line, by their names in the file: column, unit and format in the table."""
LEGEND = (
    "An agent-step is one step of a living agent, in matches one decision of a network. At once: "
    "worlds in a step, or matches in a call. Speedup: over one thread. Spread: between the fastest "
    "and the slowest repeat, as a share of the median; above 30% another process may be busy, or "
    "--seconds too short."
)


# What is measured:


@dataclass
class Timing:
    """A call that plays `at_once` worlds or matches, and the rates (calls a second) so far."""

    what: str
    at_once: int
    threads: int
    play: Callable[[int], object]
    agent_steps: float
    world_steps: float
    of_matches: bool = False
    rates: list[float] = field(default_factory=list)

    def repeat(self, seconds: float) -> None:
        """Call for so many seconds, at least once, and append the rate to `rates`."""
        # An untimed call fills the caches, which the timing before has used. A call of matches is
        # so long that this does not matter.
        if not self.of_matches:
            self.play(0)
        calls, passed, start = 0, 0.0, time.perf_counter()
        while calls == 0 or passed < seconds:
            self.play(calls)
            calls += 1
            passed = time.perf_counter() - start
        self.rates.append(calls / passed)

    @property
    def rate(self) -> float:
        """Calls a second: the median of the repeats."""
        return statistics.median(self.rates)

    def line(self, one: Timing) -> dict[str, Any]:
        """Return the figures; `one` is the same call with one thread."""
        return {
            "what": self.what,
            "at_once": self.at_once,
            "threads": self.threads,
            "agent_steps_per_second": self.rate * self.agent_steps,
            "world_steps_per_second": self.rate * self.world_steps,
            "matches_per_second": self.rate * self.at_once if self.of_matches else None,
            "over_one_thread": self.rate / one.rate if self.threads > 1 else None,
            "spread": (max(self.rates) - min(self.rates)) / self.rate,
        }


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
    many, alive = many_worlds(config), alive_share(config)
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
        agent_steps = worlds * config.n_agents * alive
        return Timing(what, worlds, n, lambda call: game.step(actions(call)), agent_steps, worlds)

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


def alive_share(config: WorldConfig) -> float:
    """Return the share of the agents that are alive when a step begins."""
    # Whole episodes are played, because agents disappear in the course of them.
    batch, actions = _batch(config, SAMPLE, 1, "acted"), random_actions(config, SAMPLE)
    steps = range(EPISODES * config.max_steps)
    return float(np.mean([batch.step(actions(step))["acted"].mean() for step in steps]))


def _batch(config: WorldConfig, worlds: int, threads: int, *names: str) -> Batch:
    specs = array_specs(config) | episode_specs(config)
    buffers = {name: np.zeros((worlds, *specs[name][0]), specs[name][1]) for name in names}
    # Every step of every world is then a step of an episode.
    mode = _core.Autoreset.SAME_STEP
    return Batch(worlds, config, threads=threads, autoreset=mode, buffers=buffers)


def timings_of_matches(race: RaceSettings, threads: int) -> list[Timing]:
    """Prepare the timings of the matches of an epoch: a population against one evader."""
    size, network = race.learner.population, race.network
    pursuers, evaders = (
        Population(np.stack([network.initial(rng) for _ in range(count)]), network)
        for rng, count in zip(map(np.random.default_rng, (0, 1)), (size, 1), strict=True)
    )
    drawn = Matches.of(np.arange(size), 0, np.arange(size))
    match = partial(rollout, race.training_world, pursuers, evaders, drawn)
    # Every call plays the same matches, so their steps are counted once.
    scores = match(threads=threads)
    steps = int(scores.agent_steps.sum()), int(scores.length.sum())
    what = f"matches, hidden {','.join(map(str, race.policy.hidden)) or 'none'}"

    def timing(n: int) -> Timing:
        return Timing(what, size, n, lambda call: match(threads=n), *steps, of_matches=True)

    return [timing(n) for n in dict.fromkeys((1, threads))]


def seconds_of(races: Sequence[RaceSettings], threads: int | None) -> float | None:
    """Estimate how long the matches of races take, from those of one epoch.

    All races have the same network and world; they differ in the schedule. None if the time of the
    learner, which is not measured, is the larger part.
    """
    if races[0].learner.rounds_by_processor:
        return None
    timing = timings_of_matches(races[0], check_threads(threads))[-1]
    timing.repeat(SAMPLED)
    return _seconds(races, timing)


def _seconds(races: Sequence[RaceSettings], timing: Timing) -> float:
    """Estimate the time of the matches of races; `timing` is of matches without learning."""
    return LEARNED * matches_of(races) / (timing.rate * timing.at_once)


def matches_of(races: Sequence[RaceSettings]) -> float:
    """Return how many matches races play, those of the evaluation in units of training matches."""
    trained = 0
    for race in races:
        schedule = race.schedule
        # A match of two living individuals is one match, here of the pursuers.
        living = schedule.contemporaries if isinstance(schedule, HallOfFame) else 0
        met = {"pursuer": schedule.opponents_met, "evader": schedule.opponents_met - living}
        epochs = sum(schedule.total_epochs(team) * met[team] for team in TEAMS)
        trained += epochs * race.learner.population * race.match_episodes
    # Generation 0 is evaluated, too; the matches of the evaluation are longer.
    evaluated = sum(race.schedule.entries**2 * race.evaluation_episodes for race in races)
    return trained + evaluated * races[0].world.max_steps / races[0].train_steps


# The command:


@click.command("bench", short_help="Measure how fast this machine plays.")
@click.argument("variant", default="O", **VARIANT)
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
    ...), by default O. Everything is measured with one thread and with --threads.
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
    timings = timings_of_worlds(world, threads)
    of_matches = [each for race in races for each in timings_of_matches(race, threads)]
    timings += of_matches
    _measure(timings, seconds / REPEATS)
    lines = lines_of(timings)
    print_lines(lines)
    # Of the first network, with the most threads.
    one = [each for each in of_matches if each.what == of_matches[0].what][-1]
    took = _seconds(jobs[0], one)
    print_wrapped(
        f"The matches of matrixworld evolve in this world ({one.what}) take about "
        f"{in_words(took)} with --threads {threads}. The time of the learners is not included."
    )
    found = {"machine": machine, "world": world.to_json(), "lines": lines}
    write_json(json_file, {**found, "evolve_seconds": took})


def _measure(timings: Sequence[Timing], seconds: float) -> None:
    total = REPEATS * len(timings)
    with progress(unit="timings") as report:
        # In turns, so that a disturbance of some seconds does not spoil all repeats of a line.
        for number, one in enumerate([*timings] * REPEATS):
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


def lines_of(timings: Sequence[Timing]) -> list[dict[str, Any]]:
    """Return the figures of each timing; those of several threads are compared with one."""
    alone = {(each.what, each.at_once): each for each in timings if each.threads == 1}
    return [each.line(alone[each.what, each.at_once]) for each in timings]


def print_lines(lines: Sequence[Mapping[str, Any]]) -> None:
    """Print the table of all lines and what its columns mean."""
    rows: list[tuple[str, ...]] = [
        ("", "at once", "threads", *(head for head, *_ in COLUMNS.values()))
    ]
    for line in lines:
        cells = (
            "" if line[name] is None else format(line[name] * unit, form)
            for name, (_, unit, form) in COLUMNS.items()
        )
        rows.append((line["what"], str(line["at_once"]), str(line["threads"]), *cells))
    print_table(rows, "<" + ">" * (len(rows[0]) - 1))
    say()
    print_wrapped(LEGEND)
    say()
