"""Tables over the races of one job: side by side, and beside what the paper reports."""

from __future__ import annotations

import math
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from matrixworld.analysis import MEASURES, Estimate, headline, noise_reference, read_payoffs
from matrixworld.analysis.cycles import MARGIN
from matrixworld.cli.console import print_table, print_wrapped
from matrixworld.coevolution.types import TEAMS, Team

if TYPE_CHECKING:
    from matrixworld.analysis import Judgement
    from matrixworld.cli.held_out import Scores
    from matrixworld.cli.jobs import Result

CONDITION = "cycling"
CLAIMS = {"specialist-specialist": "present", "generalist-generalist": "absent"}
"""Whether the paper reports cycling of its schedules (Sun et al. 2023)."""

BESIDE = 3
"""Races side by side in one table, so that lines fit into a terminal."""
LEGEND = (
    "In brackets: 95% intervals. Gain: change of a team's mean payoff against all opponents of its "
    "race. Held-out: capture rate of the last pursuers and escape rate of the last evaders, mean "
    "over opponents that no run has met. Noise: what an order of strength with the same episode "
    "noise rarely exceeds (checkerboards) or falls below (transitive share)."
)


def print_comparison(races: Mapping[str, Result], scores: Mapping[Path, Scores]) -> None:
    """Print a table of races, each a column: what is present, gains, cycles, held-out scores."""
    columns = [_column(name, race, scores[race.path]) for name, race in races.items()]
    for first in range(0, len(columns), BESIDE):
        rows = list(zip(ROWS, *columns[first : first + BESIDE], strict=True))
        click.echo()
        print_table(rows, "<" * len(rows[0]))
    print_wrapped(LEGEND)


ROWS = (
    "", "present", "gain of the pursuers", "gain of the evaders", "transitive share",
    "checkerboards", "held-out, pursuers", "held-out, evaders",
)  # fmt: skip


def _column(name: str, race: Result, scores: Scores) -> tuple[str, ...]:
    payoffs = read_payoffs(race.payoff.capture_rate)
    share, boards = (
        _number(MEASURES[name].of(payoffs).value, form)
        for name, form in (("transitive_share", ".2f"), ("checkerboards", ".1%"))
    )
    rates = race.payoff.capture_rates[payoffs.late.cells]
    # A single episode of each cell does not show its noise.
    if rates.shape[2] >= 2:
        noise = noise_reference(rates, margin=MARGIN)
        share += f" (noise: {noise.transitive_share:.2f})"
        boards += f" (noise: {noise.checkerboards:.1%})"
    return (
        name,
        headline(race.judgement).replace(", ", ",\n"),
        *(_gain(race.judgement, team) for team in TEAMS),
        share,
        boards,
        *(_score(scores[f"{team}s"]) for team in TEAMS),
    )


def _gain(judgement: Judgement, team: Team) -> str:
    # A window that is too short has no gains.
    gain: Estimate | None = judgement.headline["arms race"].estimates.get(f"{team}_gain")
    return "-" if gain is None else _interval(gain.value, gain.low, gain.high, "+.2f")


def _score(scores: Mapping[str, Any]) -> str:
    [mean] = scores["mean"]
    return _interval(mean["value"], mean["low"], mean["high"], ".2f")


def _interval(value: float, low: float | None, high: float | None, form: str) -> str:
    if low is None or high is None:
        return format(value, form)
    return f"{value:{form}} ({low:{form}} to {high:{form}})"


def _number(value: float, form: str) -> str:
    return "-" if math.isnan(value) else format(value, form)


def print_claims(races: Mapping[str, Result]) -> None:
    """Print what the paper reports of the schedules, beside what these races show."""
    rows = [
        (name, f"{CONDITION} {CLAIMS[schedule]}", f"{CONDITION} {_found(race.judgement)}")
        for name, race in races.items()
        if (schedule := getattr(race.settings, "schedule", "")) in CLAIMS
    ]
    if rows:
        click.echo()
        print_table([("race", "the paper reports", "this run shows"), *rows], "<<<")


def _found(judgement: Judgement) -> str:
    """Return the verdict in the headline window, and other windows in which it is present."""
    verdict = f"{judgement.headline[CONDITION].verdict} ({judgement.window})"
    others = [
        name
        for name in judgement.windows
        if name != judgement.window and CONDITION in judgement.present(name)
    ]
    return "; ".join([verdict, *(f"present ({name})" for name in others)])
