"""Tables over groups of runs: verdicts, measures side by side, and what the paper reports."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import click
import numpy as np
from numpy.typing import NDArray

from matrixworld.analysis import (
    CONDITIONS,
    MEASURES,
    Estimate,
    Judgement,
    fewest_runs,
    headline,
    interquartile_mean,
    interval_over_runs,
    judgement_table,
)
from matrixworld.analysis.judge import ABSENT, CANNOT_TELL, PRESENT
from matrixworld.analysis.payoffs import EPISODES_TO_JUDGE, GENERATIONS_TO_JUDGE
from matrixworld.cli.console import WIDEST, print_table, print_wrapped
from matrixworld.cli.groups import SCORED_EPISODES, Group, Result
from matrixworld.coevolution import Against
from matrixworld.coevolution.types import TEAMS, Team

BESIDE = 3
"""Groups side by side in one table, so that lines fit into a terminal."""
RATE = (0.0, 1.0)
INTERVALS = "In brackets: 95% interval over the seeds; of a single run, over its episodes."


def print_head(text: str) -> None:
    """Print what a table is about, in bold, below an empty line."""
    click.secho(f"\n{text}", bold=True)


def shown(estimate: Estimate | None, form: str) -> str:
    """Return an estimate with its interval, if there is one."""
    if estimate is None:
        return "-"
    if estimate.low is None or estimate.high is None:
        return format(estimate.value, form)
    return f"{estimate.value:{form}} ({estimate.low:{form}} to {estimate.high:{form}})"


def over_seeds(values: Any, bounds: tuple[float, float] = RATE) -> Estimate | None:
    """Return the mean over the seeds for which a number is defined; None if there is none."""
    known = [float(value) for value in values if math.isfinite(value)]
    return interval_over_runs(known, bounds=bounds) if known else None


# Verdicts:


LIMITS: tuple[tuple[Callable[[Judgement], bool], str], ...] = (
    (
        lambda judgement: judgement.episodes is None,
        "The payoffs do not say how many episodes are behind each cell, and without their noise "
        'some conditions have the verdict "cannot tell". Give the number with --episodes.',
    ),
    (
        lambda judgement: judgement.episodes is not None and judgement.episodes < EPISODES_TO_JUDGE,
        f"It takes at least {EPISODES_TO_JUDGE} episodes of each cell to tell all conditions from "
        "noise; matrixworld tournament RUN --episodes NUMBER plays more.",
    ),
    (
        lambda judgement: judgement.window == "whole",
        f"It takes at least {GENERATIONS_TO_JUDGE} generations of each team to judge a race, and "
        f"{2 * GENERATIONS_TO_JUDGE} to judge its halves.",
    ),
)
"""What limits a judgement: how to see it, and what to say of it."""


def print_judgement(judgement: Judgement) -> None:
    """Print the table of a judgement, and what limits it."""
    rows = []
    first: dict[tuple[str, str], str] = {}
    for condition, verdict, numbers, window in judgement_table(judgement):
        # Numbers of an earlier row are named by its condition.
        owner = first.setdefault((numbers, window), condition)
        cell = f"as for {owner}" if numbers and owner != condition else numbers
        rows.append((condition, verdict, cell.replace("), ", ")\n"), window))
    print_table(rows, "<<<<")
    for applies, text in LIMITS:
        if applies(judgement):
            print_wrapped(text)


def counts(judgement: Judgement) -> str:
    """Return the numbers of runs, generations and episodes that were judged."""
    runs = "1 run" if judgement.runs == 1 else f"{judgement.runs} runs"
    pursuers, evaders = judgement.shape
    episodes = (
        "" if judgement.episodes is None else f", {judgement.episodes:,} episodes of each pair"
    )
    return f"{runs}, {pursuers} pursuer and {evaders} evader generations{episodes}"


SIGNS = {PRESENT: "+", ABSENT: "-", CANNOT_TELL: "?"}
NOT_FINISHED = "."
TOGETHER = f"together (seeds: {', '.join(SIGNS.values())})"
STRIP_LEGEND = (
    f"{SIGNS[PRESENT]} present, {SIGNS[ABSENT]} absent, {SIGNS[CANNOT_TELL]} cannot tell, "
    f"{NOT_FINISHED} not finished. In brackets: number of seeds with each verdict."
)


def print_judged(group: Group) -> None:
    """Print the judgement of a group, and of several seeds the verdict on each."""
    print_head(f"{group.name}: {counts(group.judgement)}")
    print_judgement(group.judgement)
    if group.several:
        click.echo()
        print_strip(group)
        print_missing(group)
        print_wrapped(STRIP_LEGEND)


def print_missing(group: Group) -> None:
    """Name the seeds of a group that are not finished, if there are any."""
    if group.missing:
        print_wrapped(f"Not finished: seeds {', '.join(map(str, group.missing))}.")


def print_strip(group: Group) -> None:
    """Print the verdict on each seed in columns, and how many seeds have which verdict."""
    seeds = sorted([*group.seeds, *group.missing])
    width = max(len(str(seed)) for seed in seeds)
    beside = max(1, (WIDEST - 50) // (width + 1))
    for first in range(0, len(seeds), beside):
        part, last = seeds[first : first + beside], first + beside >= len(seeds)
        rows = [("seed", *map(str, part), TOGETHER if last else "")]
        rows += [_strip_row(group, name, part, last) for name in CONDITIONS]
        _print_columns(rows, width)


def _strip_row(group: Group, name: str, seeds: Sequence[int], last: bool) -> tuple[str, ...]:
    finding = group.judgement.headline[name]
    found = dict(zip(group.seeds, finding.by_run, strict=True))
    signs = [SIGNS[found[seed]] if seed in found else NOT_FINISHED for seed in seeds]
    numbers = ", ".join(str(finding.by_run.count(verdict)) for verdict in SIGNS)
    return name, *signs, f"{finding.verdict} ({numbers})" if last else ""


def _print_columns(rows: Sequence[tuple[str, ...]], width: int) -> None:
    """Print rows with narrow columns between the first and the last cell."""
    first = max(len(name) for name in CONDITIONS)
    for number, (name, *cells, together) in enumerate(rows):
        line = " ".join([f"{name:{first}}", *(f"{cell:>{width}}" for cell in cells)])
        click.secho(f"{line}  {together}".rstrip(), bold=number == 0)


def verdict_counts(group: Group) -> dict[str, dict[str, Any]]:
    """Return the verdicts as plain values: together, on each seed, and how many there are."""
    return {
        name: {
            "together": finding.verdict,
            "by_seed": {str(s): v for s, v in zip(group.seeds, finding.by_run, strict=True)},
            **{verdict: finding.by_run.count(verdict) for verdict in SIGNS},
        }
        for name, finding in group.judgement.headline.items()
    }


# Measures side by side:


@dataclass(frozen=True)
class Row:
    """A row of the table of groups: its name, how numbers are printed, and the number of a group.

    `noise` is the entry of `NoiseReference` that stands beside the number of a single run. Rows
    `of_seeds` are shown only where several seeds were asked for.
    """

    label: str
    form: str
    of: Callable[[Group], Estimate | None]
    noise: str = ""
    of_seeds: bool = False

    def cell(self, group: Group, estimate: Estimate | None) -> str:
        """Return what the table shows of a group."""
        noise = getattr(group.noise, self.noise) if self.noise and group.noise else None
        return shown(estimate, self.form) + (f" (noise: {noise:{self.form}})" if noise else "")


def _gain(team: Team) -> Row:
    # A window that is too short has no gains.
    return Row(
        f"gain of the {team}s", "+.2f",
        lambda group: group.judgement.headline["arms race"].estimates.get(f"{team}_gain"),
    )  # fmt: skip


def _measure(label: str, name: str, form: str) -> Row:
    def of(group: Group) -> Estimate | None:
        found = MEASURES[name].of(group.payoffs)
        return None if math.isnan(found.value) else found

    return Row(label, form, of, noise=name)


def _held_out(team: Team) -> tuple[Row, Row]:
    return (
        Row(f"held-out, {team}s", ".2f", lambda group: _held_out_mean(group, team)),
        Row(
            "  interquartile mean", ".2f", of_seeds=True,
            of=lambda group: interquartile_mean(held_out(group, team)),
        ),
    )  # fmt: skip


def _held_out_mean(group: Group, team: Team) -> Estimate | None:
    if len(group.runs) > 1:
        return over_seeds(held_out(group, team).mean(axis=1))
    [mean] = group.runs[0].held_out[f"{team}s"]["mean"]
    return Estimate(**mean, across="episodes", samples=SCORED_EPISODES)


def held_out(group: Group, team: Team) -> NDArray[np.float64]:
    """Return the scores (seeds, opponents) of the last generation of a team."""
    of_runs = [run.held_out[f"{team}s"]["against"].values() for run in group.runs]
    return np.array([[last["value"] for [last] in against] for against in of_runs])


def _played(label: str, entry: str) -> Row:
    return Row(
        label, ",.0f",
        lambda group: over_seeds([run.numbers[entry] for run in group.runs], (0.0, math.inf)),
    )  # fmt: skip


ROWS: Mapping[str, Row] = {
    "pursuer_gain": _gain("pursuer"),
    "evader_gain": _gain("evader"),
    "transitive_share": _measure("transitive share", "transitive_share", ".2f"),
    "checkerboards": _measure("checkerboards", "checkerboards", ".1%"),
    **{
        f"{team}_{name}": row
        for team in TEAMS
        for name, row in zip(("held_out", "held_out_iqm"), _held_out(team), strict=True)
    },
    "training_matches": _played("training matches", "training_matches"),
    "training_agent_steps": _played("training agent-steps", "training_agent_steps"),
    "evaluation_matches": _played("evaluation matches", "evaluation_matches"),
}
"""Rows of the table by their names in summary.json."""

LEGEND = (
    f"{INTERVALS} Gain: change of a team's mean payoff against all opponents of its race. "
    "Held-out: capture rate of the last pursuers and escape rate of the last evaders, mean over "
    "opponents that no run has met. "
)
NOISE_LEGEND = (
    "Noise: what an order of strength with the same episode noise rarely exceeds (checkerboards) "
    "or falls below (transitive share)."
)
SEEDS_LEGEND = (
    "Interquartile mean: the middle half of the held-out scores; its interval takes "
    f"{fewest_runs()} seeds."
)


def measured(group: Group) -> dict[str, Estimate | None]:
    """Return the numbers of a group of races by their names in `ROWS`."""
    return {name: row.of(group) for name, row in ROWS.items()}


def print_comparison(
    groups: Sequence[Group], estimates: Mapping[str, Mapping[str, Estimate | None]]
) -> None:
    """Print the table of measures: a column for each group of races."""
    several = any(group.several for group in groups)
    rows = {name: row for name, row in ROWS.items() if several or not row.of_seeds}
    labels = ["", *(["seeds finished"] if several else []), "present"]
    labels += [row.label for row in rows.values()]
    for first in range(0, len(groups), BESIDE):
        part = groups[first : first + BESIDE]
        columns = [
            [
                group.name,
                *([group.finished_of_asked()] if several else []),
                headline(group.judgement).replace(", ", ",\n"),
                *(row.cell(group, estimates[group.name][name]) for name, row in rows.items()),
            ]
            for group in part
        ]
        click.echo()
        print_table([*zip(labels, *columns, strict=True)], "<" * (1 + len(part)))
    print_wrapped(LEGEND + (SEEDS_LEGEND if several else NOISE_LEGEND))


# What the paper reports:

CONDITION = "cycling"
CLAIMS = {"specialist-specialist": "present", "generalist-generalist": "absent"}
"""Whether the paper reports cycling of its schedules (Sun et al. 2023)."""


def print_claims(groups: Sequence[Group]) -> None:
    """Print what the paper reports of the schedules, beside what these races show."""
    rows = [
        (group.name, f"{CONDITION} {CLAIMS[schedule]}", f"{CONDITION} {_found(group.judgement)}")
        for group in groups
        if group.settings and (schedule := group.settings.schedule.name) in CLAIMS
    ]
    if rows:
        click.echo()
        print_table([("race", "the paper reports", "this job shows"), *rows], "<<<")


def _found(judgement: Judgement) -> str:
    """Return the verdict in the headline window, and other windows in which it is present."""
    verdict = f"{judgement.headline[CONDITION].verdict} ({judgement.window})"
    others = [
        name
        for name in judgement.windows
        if name != judgement.window and CONDITION in judgement.present(name)
    ]
    return "; ".join([verdict, *(f"present ({name})" for name in others)])


# Runs in which one team evolved:

OF_ONE_TEAM = {"capture_rate": ("capture rate", ".4f"), "length": ("length in steps", ".1f")}
"""Numbers of a run in which one team evolved: label and form."""
ONE_TEAM_LEGEND = (
    "In brackets: 95% interval of the mean over the episodes; in the last line, over the seeds."
)


def measured_of_one_team(group: Group) -> dict[str, Estimate]:
    """Return the means over the seeds of a group."""
    return {
        name: interval_over_runs([run.numbers[name] for run in group.runs], bounds=(0.0, math.inf))
        for name in OF_ONE_TEAM
    }


def print_one_team(group: Group) -> None:
    """Print the results of one team against fixed opponents: a line for each seed, and the mean."""
    settings = group.settings
    assert settings is not None  # its runs are finished
    schedule = settings.schedule
    assert isinstance(schedule, Against)
    seeds = f", {group.finished_of_asked()} seeds finished" if group.several else ""
    print_head(f"{group.name}{seeds}")
    click.echo(
        f"  {schedule.team}s after {schedule.epochs} epochs against {schedule.opponent}, in "
        f"{group.runs[0].numbers['evaluation_matches']} fresh episodes of at most "
        f"{settings.world.max_steps} steps"
    )
    heads = [head for label, _ in OF_ONE_TEAM.values() for head in (label, "of an episode")]
    rows = [("seed", *heads), *map(_one_team_row, group.runs)]
    if len(group.runs) > 1:
        means = measured_of_one_team(group)
        cells = [(shown(means[name], form), "") for name, (_, form) in OF_ONE_TEAM.items()]
        rows.append(("mean", *(cell for pair in cells for cell in pair)))
    print_table(rows, "<" * len(rows[0]))
    print_wrapped(ONE_TEAM_LEGEND)
    print_missing(group)


def _one_team_row(run: Result) -> tuple[str, ...]:
    cells = []
    for name, (_, form) in OF_ONE_TEAM.items():
        mean, low, high, std = (run.numbers[name + end] for end in ("", "_low", "_high", "_std"))
        estimate = Estimate(mean, low, high, "episodes", run.numbers["evaluation_matches"])
        alike = "in every episode" if low is None else f"standard deviation {std:{form}}"
        cells += [shown(estimate, form), alike]
    return str(run.settings.seed), *cells
