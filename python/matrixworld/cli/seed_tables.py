"""Tables over the seeds of one job: measures with intervals, and verdicts on each seed."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import click
import numpy as np
from numpy.typing import NDArray

from matrixworld.analysis import (
    CONDITIONS,
    MEASURES,
    Estimate,
    fewest_runs,
    headline,
    interquartile_mean,
    interval_over_runs,
)
from matrixworld.analysis.judge import ABSENT, CANNOT_TELL, PRESENT
from matrixworld.cli.console import WIDEST, print_table, print_wrapped
from matrixworld.cli.held_out import Scores
from matrixworld.cli.race_groups import Group
from matrixworld.coevolution.types import TEAMS, Team

BESIDE = 3
"""Groups side by side in one table, so that lines fit into a terminal."""
RATE = (0.0, 1.0)

LEGEND = (
    "In brackets: 95% interval of the mean over seeds; one seed has none. Gain: change of a team's "
    "mean payoff against all opponents of its race. Held-out: capture rate of the last pursuers "
    "and escape rate of the last evaders against opponents that no run has met. Interquartile "
    f"mean: the middle half of these scores; its interval takes {fewest_runs()} seeds."
)
SIGNS = {PRESENT: "+", ABSENT: "-", CANNOT_TELL: "?"}
NOT_FINISHED = "."
TOGETHER = f"together (seeds: {', '.join(SIGNS.values())})"
STRIP_LEGEND = (
    f"{SIGNS[PRESENT]} present, {SIGNS[ABSENT]} absent, {SIGNS[CANNOT_TELL]} cannot tell, "
    f"{NOT_FINISHED} not finished. In brackets: number of seeds with each verdict."
)


@dataclass(frozen=True)
class SeedMeasure:
    """A row of the table: a number of each seed, and how it is printed.

    Parameters
    ----------
    label : str
        Name of the row.
    form : str
        How numbers are printed, as in an f-string.
    of : callable
        Takes a group and its held-out scores by run directory; returns the estimate over seeds.
    """

    label: str
    form: str
    of: Callable[[Group, Mapping[Path, Scores]], Estimate | None]


def _gain(team: Team) -> SeedMeasure:
    # Of `judge`: the interval on which the verdicts rest.
    return SeedMeasure(
        f"gain of the {team}s",
        "+.2f",
        lambda group, _: group.judgement.headline["arms race"].estimates.get(f"{team}_gain"),
    )


def _measure(label: str, name: str, form: str) -> SeedMeasure:
    def of(group: Group, scores: Mapping[Path, Scores]) -> Estimate | None:
        found = MEASURES[name].of(group.payoffs.matrices)
        return None if math.isnan(found.value) else found

    return SeedMeasure(label, form, of)


def _held_out(team: Team) -> tuple[SeedMeasure, SeedMeasure]:
    return (
        SeedMeasure(
            f"held-out, {team}s", ".2f",
            lambda group, scores: _over_seeds(held_out(group, scores, team).mean(axis=1), RATE),
        ),
        SeedMeasure(
            "  interquartile mean", ".2f",
            lambda group, scores: interquartile_mean(held_out(group, scores, team)),
        ),
    )  # fmt: skip


def _played(label: str, entry: str) -> SeedMeasure:
    return SeedMeasure(
        label, ",.0f",
        lambda group, _: _over_seeds([run.numbers[entry] for run in group.runs]),
    )  # fmt: skip


SEED_MEASURES: Mapping[str, SeedMeasure] = {
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


def held_out(group: Group, scores: Mapping[Path, Scores], team: Team) -> NDArray[np.float64]:
    """Return the scores (seeds, opponents) of the last generation of a team."""
    of_runs = [scores[run.path][f"{team}s"]["against"].values() for run in group.runs]
    return np.array([[last["value"] for [last] in against] for against in of_runs])


def _over_seeds(values: Any, bounds: tuple[float, float] | None = None) -> Estimate | None:
    """Return the mean over the seeds for which a number is defined; None if there is none."""
    known = [float(value) for value in values if math.isfinite(value)]
    if not known:
        return None
    return interval_over_runs(known, bounds=bounds or (-math.inf, math.inf))


def measured(group: Group, scores: Mapping[Path, Scores]) -> dict[str, Estimate | None]:
    """Return the estimates over the seeds of a group by their names in `SEED_MEASURES`."""
    return {name: row.of(group, scores) for name, row in SEED_MEASURES.items()}


def print_seed_table(
    groups: Sequence[Group], estimates: Mapping[str, Mapping[str, Estimate | None]]
) -> None:
    """Print the table of measures: a column for each group."""
    labels = ["", "seeds finished", "present"]
    labels += [row.label for row in SEED_MEASURES.values()]
    for first in range(0, len(groups), BESIDE):
        part = groups[first : first + BESIDE]
        columns = [_column(group, estimates[group.name]) for group in part]
        click.echo()
        print_table([*zip(labels, *columns, strict=True)], "<" * (1 + len(part)))
    print_wrapped(LEGEND)


def _column(group: Group, estimates: Mapping[str, Estimate | None]) -> list[str]:
    return [
        group.name,
        finished_of_asked(group),
        headline(group.judgement).replace(", ", ",\n"),
        *(shown(estimates[name], row.form) for name, row in SEED_MEASURES.items()),
    ]


def finished_of_asked(group: Group) -> str:
    """Return how many seeds are finished, such as ``"9 of 10"``."""
    return f"{len(group.runs)} of {len(group.runs) + len(group.missing)}"


def shown(estimate: Estimate | None, form: str) -> str:
    """Return an estimate over seeds; an interval over episodes is not shown beside others."""
    if estimate is None:
        return "-"
    if estimate.across != "runs" or estimate.low is None or estimate.high is None:
        return format(estimate.value, form)
    return f"{estimate.value:{form}} ({estimate.low:{form}} to {estimate.high:{form}})"


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
    return name, *signs, f"{finding.verdict} ({_counts(finding.by_run)})" if last else ""


def _print_columns(rows: Sequence[tuple[str, ...]], width: int) -> None:
    """Print rows with narrow columns between the first and the last cell."""
    first = max(len(name) for name in CONDITIONS)
    for number, (name, *cells, together) in enumerate(rows):
        line = " ".join([f"{name:{first}}", *(f"{cell:>{width}}" for cell in cells)])
        click.secho(f"{line}  {together}".rstrip(), bold=number == 0)


def _counts(by_run: Sequence[str]) -> str:
    return ", ".join(str(by_run.count(verdict)) for verdict in SIGNS)


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
