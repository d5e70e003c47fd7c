"""What commands print of a judgement."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import click

from matrixworld.analysis import Judgement, judgement_table
from matrixworld.analysis.payoffs import EPISODES_TO_JUDGE, GENERATIONS_TO_JUDGE
from matrixworld.cli.console import print_table, print_wrapped

Row = tuple[str, str, str, str]
"""Condition, verdict, numbers with intervals, window."""

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
    rows = _short(judgement_table(judgement))
    print_table(rows, "<" * len(rows[0]))
    for applies, text in LIMITS:
        if applies(judgement):
            print_wrapped(text)


def _short(rows: Sequence[Row]) -> list[Row]:
    """Return the rows with one number a line, and numbers of an earlier row by its condition."""
    short: list[Row] = []
    first: dict[tuple[str, str], str] = {}
    for condition, verdict, numbers, window in rows:
        owner = first.setdefault((numbers, window), condition)
        shown = numbers.replace("), ", ")\n")
        if numbers and owner != condition:
            shown = f"as for {owner}"
        short.append((condition, verdict, shown, window))
    return short


def print_head(text: str) -> None:
    """Print what a table is about, in bold, below an empty line."""
    click.secho(f"\n{text}", bold=True)


def counts(judgement: Judgement) -> str:
    """Return the numbers of runs, generations and episodes that were judged."""
    runs = "1 run" if judgement.runs == 1 else f"{judgement.runs} runs"
    pursuers, evaders = judgement.shape
    episodes = (
        "" if judgement.episodes is None else f", {judgement.episodes:,} episodes of each pair"
    )
    return f"{runs}, {pursuers} pursuer and {evaders} evader generations{episodes}"
