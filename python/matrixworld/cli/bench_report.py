"""What ``matrixworld bench`` prints and writes."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from dataclasses import asdict
from typing import Any

import click

from matrixworld.bench import MATCHES, VECTOR_ENV, Machine, Measurement
from matrixworld.cli.report import print_wrapped
from matrixworld.coevolution import TEAMS, RaceSettings
from matrixworld.config import WorldConfig

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
LEARNING = 100_000_000  # agent-steps
LEAST_GAIN, LEAST_SHARE = 1.5, 0.25
"""What several threads play at least, on an idle machine: times as much as one, and by thread."""
WIDEST_SPREAD = 0.3

Figures = dict[str, Any]


def print_machine(machine: Machine, variant: str, world: WorldConfig) -> None:
    """Print what it runs on and what is played."""
    chosen = ", as MATRIXWORLD_KERNELS says" if "MATRIXWORLD_KERNELS" in os.environ else ""
    cores = "1 core" if machine.cores == 1 else f"{machine.cores} cores"
    click.echo(
        f"matrixworld {machine.matrixworld}, NumPy {machine.numpy}, Python {machine.python}\n"
        f"{machine.processor}, {cores} to use; kernels for {machine.kernels}{chosen}\n"
        f"{variant}: {world.rows} x {world.cols} cells, {world.n_pursuers} pursuers against "
        f"{world.n_evaders} evaders, views of {world.fov} x {world.fov}\n"
    )


# ---- The figures as plain values ---------------------------------------------------------------


def figures_of(
    measured: Sequence[Measurement],
    machine: Machine,
    world: WorldConfig,
    races: Sequence[RaceSettings],
) -> Figures:
    """Everything that was measured, as it is written to a file.

    races: those of ``matrixworld evolve`` in this world
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
    """Say of each line how many times as much it plays as one thread, where that was measured."""
    keys = ("what", "hidden", "at_once")
    ones = [line for line in lines if line["threads"] == 1]
    for line in lines:
        same = [one for one in ones if all(one[key] == line[key] for key in keys)]
        if line["threads"] > 1 and same:
            ratio = line["agent_steps_per_second"] / same[0]["agent_steps_per_second"]
            line["over_one_thread"] = ratio


def _evolve(lines: Sequence[Figures], races: Sequence[RaceSettings]) -> Figures | None:
    """How long the matches of races take, if those measured are as long as in training."""
    hidden = list(races[0].hidden)
    rates = [line for line in lines if line["what"] == MATCHES and line["hidden"] == hidden]
    if not rates:
        return None
    trained, evaluated = (sum(counts) for counts in zip(*map(matches_of, races), strict=True))
    longer = races[0].eval_steps / races[0].train_steps
    rate = rates[-1]["matches_per_second"]
    return {
        "hidden": hidden,
        "threads": rates[-1]["threads"],
        "matches": trained + evaluated,
        "seconds": (trained + longer * evaluated) / rate,
    }


def matches_of(race: RaceSettings) -> tuple[int, int]:
    """The matches of a race's training and of its payoff matrix."""
    epochs = sum(race.total_epochs(team) for team in TEAMS)
    cells = (race.generations + 1) ** 2
    return epochs * race.population * race.worlds, cells * race.eval_episodes


# ---- The figures in words ----------------------------------------------------------------------


def print_figures(figures: Figures, *, default: bool) -> None:
    """Print the table, what it means, and what looks wrong.

    default: whether the world is that of ``matrixworld evolve`` without options
    """
    _print_table(figures["lines"])
    click.echo()
    print_wrapped(LEGEND)
    click.echo()
    for sentence in (*_work(figures, default), *_hints(figures)):
        print_wrapped(sentence)


def _print_table(lines: Sequence[Figures]) -> None:
    rows = [HEADS, *(_cells(line) for line in lines)]
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    for number, (name, *cells) in enumerate(rows):
        aligned = (f"{cell:>{width}}" for cell, width in zip(cells, widths[1:], strict=True))
        click.secho(f"{name:{widths[0]}}  {'  '.join(aligned)}".rstrip(), bold=number == 0)


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


def _work(figures: Figures, default: bool) -> Iterator[str]:
    evolve = figures["evolve"]
    if evolve is not None:
        where = "" if default else " in this world"
        yield (
            f"The {evolve['matches']:,} matches of matrixworld evolve{where} with --hidden "
            f"{_sizes(evolve['hidden'])} take about {_duration(evolve['seconds'])}, with "
            f"{_threads(evolve['threads'])}; what the learners take comes on top."
        )
    envs = [line for line in figures["lines"] if line["what"] == VECTOR_ENV and line["at_once"] > 1]
    if envs:
        seconds = LEARNING / envs[-1]["agent_steps_per_second"]
        yield (
            f"A learner on VectorEnv, with {envs[-1]['at_once']} worlds and "
            f"{_threads(envs[-1]['threads'])}, waits {_duration(seconds)} for "
            f"{LEARNING // 1_000_000} million agent-steps."
        )


def _threads(count: int) -> str:
    return "1 thread" if count == 1 else f"{count} threads"


def _duration(seconds: float) -> str:
    for unit, length in (("hours", 3600.0), ("minutes", 60.0)):
        if seconds >= 1.5 * length:
            return f"{seconds / length:.{0 if seconds >= 10 * length else 1}f} {unit}"
    return f"{seconds:.{0 if seconds >= 10 else 1}f} seconds"


def _hints(figures: Figures) -> Iterator[str]:
    """What looks wrong, and what it may be."""
    compared = [line for line in figures["lines"] if line["over_one_thread"] is not None]
    worst = min(compared, key=lambda line: line["over_one_thread"], default=None)
    if worst and worst["over_one_thread"] < max(LEAST_GAIN, LEAST_SHARE * worst["threads"]):
        yield (
            f"Hint: {worst['threads']} threads play only {worst['over_one_thread']:.2f} times as "
            f"much as one ({_name(worst)}): another process is busy, or fewer cores are free than "
            f"there are threads."
        )
    uneven = max(figures["lines"], key=lambda line: line["spread"])
    if uneven["spread"] > WIDEST_SPREAD:
        yield (
            f"Hint: from repeat to repeat {_name(uneven)}, {uneven['at_once']} at once with "
            f"{_threads(uneven['threads'])}, differs by {uneven['spread']:.0%}: another process is "
            f"busy, the processor changes its clock, or --seconds is too short."
        )
