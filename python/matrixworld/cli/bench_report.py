"""Output of ``matrixworld bench``: the figures as plain values, and in words."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from dataclasses import asdict
from typing import Any

import click

from matrixworld.bench import MATCHES, VECTOR_ENV, Machine, Measurement
from matrixworld.cli.console import print_table, print_wrapped
from matrixworld.coevolution import TEAMS, RaceSettings
from matrixworld.world.config import WorldConfig

HEADS = (
    "",
    "at once",
    "threads",
    "million agent-steps/s",
    "world steps/s",
    "matches/s",
    "speedup",
)
LEGEND = (
    "An agent-step is one step of a living agent, in matches one decision of a network. At once: "
    "worlds in a step, or matches in a call. Speedup: over one thread."
)
LEARNING = 100_000_000
"""Agent-steps that a reinforcement learner may need."""
LEAST_SPEEDUP, LEAST_SHARE = 1.5, 0.25
"""Least speedup of several threads on an idle machine, in all and per thread."""
WIDEST_SPREAD = 0.3
"""Largest spread of repeats on an idle machine, as a share of the median."""

Figures = dict[str, Any]


def print_machine(machine: Machine, variant: str, world: WorldConfig) -> None:
    """Print the machine and the world."""
    # A forced instruction set explains figures that are lower than on other machines.
    chosen = ", as MATRIXWORLD_KERNELS says" if "MATRIXWORLD_KERNELS" in os.environ else ""
    cores = "1 core" if machine.cores == 1 else f"{machine.cores} cores"
    click.echo(
        f"matrixworld {machine.matrixworld}, NumPy {machine.numpy}, Python {machine.python}\n"
        f"{machine.processor}, {cores} to use; kernels for {machine.kernels}{chosen}\n"
        f"{variant}: {world.rows} x {world.cols} cells, {world.n_pursuers} pursuers against "
        f"{world.n_evaders} evaders, views of {world.fov} x {world.fov}\n"
    )


def figures_of(
    measured: Sequence[Measurement],
    machine: Machine,
    world: WorldConfig,
    races: Sequence[RaceSettings],
) -> Figures:
    """Return everything that was measured as values that JSON can hold.

    Parameters
    ----------
    measured : sequence of Measurement
        Measurements with at least one repeat each.
    machine : Machine
        The machine.
    world : WorldConfig
        The world that was played.
    races : sequence of RaceSettings
        The races of ``matrixworld evolve`` in this world.

    Returns
    -------
    dict
        ``machine``, ``world``, ``lines`` (one for each measurement), and ``evolve`` (estimated
        duration of the races, None if no measured network is theirs).
    """
    lines = [_line(each) for each in measured]
    _compare(lines)
    return {
        "machine": asdict(machine),
        "world": world.to_json(),
        "lines": lines,
        "evolve": _evolve(lines, races),
    }


def _line(each: Measurement) -> Figures:
    return {
        "what": each.what,
        "hidden": None if each.hidden is None else list(each.hidden),
        "at_once": each.size,
        "threads": each.threads,
        "agent_steps_per_second": each.rate * each.agent_steps,
        "world_steps_per_second": each.rate * each.world_steps,
        "matches_per_second": each.rate * each.size if each.what == MATCHES else None,
        "over_one_thread": None,
        "repeats": len(each.rates),
        "spread": each.spread,
    }


def _compare(lines: Sequence[Figures]) -> None:
    """Add to each line of several threads the speedup over one thread, if that was measured."""
    # A line is compared with the line that differs from it in the threads only.
    keys = ("what", "hidden", "at_once")
    ones = [line for line in lines if line["threads"] == 1]
    for line in lines:
        same = [one for one in ones if all(one[key] == line[key] for key in keys)]
        if line["threads"] > 1 and same:
            ratio = line["agent_steps_per_second"] / same[0]["agent_steps_per_second"]
            line["over_one_thread"] = ratio


def _evolve(lines: Sequence[Figures], races: Sequence[RaceSettings]) -> Figures | None:
    """Estimate how long the matches of races take, from the rate of training matches."""
    # All races have the same network and world; they differ in the schedule.
    hidden = list(races[0].hidden)
    rates = [line for line in lines if line["what"] == MATCHES and line["hidden"] == hidden]
    if not rates:
        return None
    # The matches measured have the length of training; those of the evaluation are longer.
    trained, evaluated = (sum(counts) for counts in zip(*map(matches_of, races), strict=True))
    longer = races[0].eval_steps / races[0].train_steps
    # The last line is that of the most threads.
    rate = rates[-1]["matches_per_second"]
    return {
        "hidden": hidden,
        "threads": rates[-1]["threads"],
        "matches": trained + evaluated,
        "seconds": (trained + longer * evaluated) / rate,
    }


def matches_of(race: RaceSettings) -> tuple[int, int]:
    """Return the numbers of matches of a race's training and of its payoff matrix."""
    epochs = sum(race.total_epochs(team) for team in TEAMS)
    # Generation 0 is evaluated, too.
    cells = (race.generations + 1) ** 2
    return epochs * race.population * race.worlds, cells * race.eval_episodes


def print_figures(figures: Figures, *, default: bool) -> None:
    """Print the table, what the figures mean for a user, and what looks wrong.

    Parameters
    ----------
    figures : dict
        From `figures_of`.
    default : bool
        Whether the world is that of ``matrixworld evolve`` without options.
    """
    print_table([HEADS, *map(_cells, figures["lines"])], "<" + ">" * (len(HEADS) - 1))
    click.echo()
    print_wrapped(LEGEND)
    click.echo()
    for sentence in (*_durations(figures, default), *_hints(figures)):
        print_wrapped(sentence)


def _cells(line: Figures) -> tuple[str, ...]:
    matches, gain = line["matches_per_second"], line["over_one_thread"]
    return (
        _name(line),
        str(line["at_once"]),
        str(line["threads"]),
        f"{line['agent_steps_per_second'] / 1e6:.2f}",
        _number(line["world_steps_per_second"]),
        "" if matches is None else _number(matches),
        "" if gain is None else f"{gain:.2f}",
    )


def _name(line: Figures) -> str:
    return line["what"] if line["hidden"] is None else f"matches, hidden {_sizes(line['hidden'])}"


def _sizes(hidden: Sequence[int]) -> str:
    return ",".join(map(str, hidden)) or "none"


def _number(value: float) -> str:
    return f"{value:,.0f}" if value >= 100 else f"{value:.1f}"


def _durations(figures: Figures, default: bool) -> Iterator[str]:
    evolve = figures["evolve"]
    if evolve is not None:
        where = "" if default else " in this world"
        yield (
            f"The {evolve['matches']:,} matches of matrixworld evolve{where} with --hidden "
            f"{_sizes(evolve['hidden'])} take about {_duration(evolve['seconds'])}, with "
            f"{_threads(evolve['threads'])}. The time of the learners is not included."
        )
    envs = [line for line in figures["lines"] if line["what"] == VECTOR_ENV and line["at_once"] > 1]
    if envs:
        seconds = LEARNING / envs[-1]["agent_steps_per_second"]
        yield (
            f"VectorEnv, with {envs[-1]['at_once']} worlds and {_threads(envs[-1]['threads'])}, "
            f"plays {LEARNING // 1_000_000} million agent-steps in {_duration(seconds)}."
        )


def _threads(count: int) -> str:
    return "1 thread" if count == 1 else f"{count} threads"


def _duration(seconds: float) -> str:
    # From one and a half units on: "80 seconds" reads better than "1.3 minutes".
    for unit, length in (("hours", 3600.0), ("minutes", 60.0)):
        if seconds >= 1.5 * length:
            return f"{seconds / length:.{0 if seconds >= 10 * length else 1}f} {unit}"
    return f"{seconds:.{0 if seconds >= 10 else 1}f} seconds"


def _hints(figures: Figures) -> Iterator[str]:
    """Yield what looks wrong, with possible causes."""
    compared = [line for line in figures["lines"] if line["over_one_thread"] is not None]
    worst = min(compared, key=lambda line: line["over_one_thread"], default=None)
    if worst and worst["over_one_thread"] < max(LEAST_SPEEDUP, LEAST_SHARE * worst["threads"]):
        yield (
            f"Hint: {worst['threads']} threads are only {worst['over_one_thread']:.2f} times as "
            f"fast as one ({_name(worst)}). Another process may be busy, or fewer cores may be "
            f"free than there are threads."
        )
    uneven = max(figures["lines"], key=lambda line: line["spread"])
    if uneven["spread"] > WIDEST_SPREAD:
        yield (
            f"Hint: the repeats of {_name(uneven)}, {uneven['at_once']} at once with "
            f"{_threads(uneven['threads'])}, differ by {uneven['spread']:.0%}. Another process may "
            f"be busy, the processor may change its clock, or --seconds may be too short."
        )
