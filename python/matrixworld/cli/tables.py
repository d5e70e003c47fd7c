"""Tables and numbers of groups of runs: verdicts, held-out scores, one team alone."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from matrixworld.analysis import Estimate, Judgement, interval_over_runs
from matrixworld.analysis.judge import ABSENT, CANNOT_TELL, PRESENT
from matrixworld.analysis.payoffs import EPISODES_TO_JUDGE, GENERATIONS_TO_JUDGE
from matrixworld.analysis.words import headline, judgement_cells
from matrixworld.cli.console import WIDEST, print_table, print_wrapped, say
from matrixworld.cli.groups import Group
from matrixworld.coevolution.types import Team


def print_head(text: str) -> None:
    """Print what a table is about, in bold, below an empty line."""
    say(f"\n{text}", bold=True)


def over_seeds(values: Any) -> Estimate | None:
    """Return the mean over the seeds for which a number is defined; None if there is none."""
    known = [float(value) for value in values if math.isfinite(value)]
    return interval_over_runs(known, bounds=(0.0, 1.0)) if known else None


# Verdicts:


def _limits(judgement: Judgement) -> Iterator[str]:
    if judgement.episodes is None:
        yield (
            "The payoffs do not say how many episodes are behind each cell, and without their "
            'noise some conditions have the verdict "cannot tell". Give the number with --episodes.'
        )
    elif judgement.episodes < EPISODES_TO_JUDGE:
        yield (
            f"It takes at least {EPISODES_TO_JUDGE} episodes of each cell to tell all conditions "
            "from noise; matrixworld tournament RUN --episodes NUMBER plays more."
        )
    if judgement.window == "whole":
        yield (
            f"It takes at least {GENERATIONS_TO_JUDGE} generations of each team to judge a race, "
            f"and {2 * GENERATIONS_TO_JUDGE} to judge its halves."
        )


def print_judgement(judgement: Judgement) -> None:
    """Print the table of a judgement, and what limits it."""
    print_table(judgement_cells(judgement), "<<<<")
    for text in _limits(judgement):
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
    print_head(group.name)
    say(f"{headline(group.judgement)}\n{counts(group.judgement)}")
    print_judgement(group.judgement)
    if group.several:
        say()
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
    beside = max(1, (WIDEST - 50) // (2 + max(len(str(seed)) for seed in seeds)))
    for first in range(0, len(seeds), beside):
        part, is_last = seeds[first : first + beside], first + beside >= len(seeds)
        rows = [("seed", *map(str, part), TOGETHER if is_last else "")]
        for name, finding in group.judgement.headline.items():
            found = dict(zip(group.seeds, finding.by_run, strict=True))
            signs = [SIGNS[found[seed]] if seed in found else NOT_FINISHED for seed in part]
            numbers = ", ".join(str(finding.by_run.count(verdict)) for verdict in SIGNS)
            rows.append((name, *signs, f"{finding.verdict} ({numbers})" if is_last else ""))
        print_table(rows, "<" + ">" * len(part) + "<")


# Held-out scores:


def held_out(group: Group, team: Team) -> NDArray[np.float64]:
    """Return the scores (seeds, opponents) of the last generation of a team."""
    of_runs = [run.held_out[f"{team}s"]["against"].values() for run in group.runs]
    return np.array([[last["value"] for [last] in against] for against in of_runs])


# Runs in which one team evolved:


def of_one_team(group: Group) -> dict[str, Estimate]:
    """Return capture rate and length of episodes of one team: means over the seeds of a group.

    Those of a single run have their intervals over its episodes.
    """
    if len(group.runs) > 1:
        rows = [run.numbers for run in group.runs]
        return {
            name: interval_over_runs([row[name] for row in rows], bounds=(0.0, math.inf))
            for name in OF_ONE_TEAM
        }
    [run] = group.runs
    found = {}
    for name in OF_ONE_TEAM:
        mean, low, high = (run.numbers[name + end] for end in ("", "_low", "_high"))
        found[name] = Estimate(mean, low, high, "episodes", run.numbers["evaluation_matches"])
    return found


OF_ONE_TEAM = ("capture_rate", "length")
