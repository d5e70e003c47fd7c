"""Tables over groups of runs: verdicts, measures side by side, and what the paper reports."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from matrixworld.analysis import (
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
from matrixworld.cli.console import WIDEST, print_table, print_wrapped, say
from matrixworld.cli.groups import SCORED_EPISODES, Group, Result
from matrixworld.coevolution import Against
from matrixworld.coevolution.types import TEAMS, Team

BESIDE = 3
"""Groups side by side in one table, so that lines fit into a terminal."""
RATE = (0.0, 1.0)
INTERVALS = "In brackets: 95% interval over the seeds; of a single run, over its episodes."


def print_head(text: str) -> None:
    """Print what a table is about, in bold, below an empty line."""
    say(f"\n{text}", bold=True)


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


def _limits(judgement: Judgement) -> Iterator[str]:
    """Yield what limits a judgement."""
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
    rows = []
    first: dict[tuple[str, str], str] = {}
    for condition, verdict, numbers, window in judgement_table(judgement):
        # Numbers of an earlier row are named by its condition.
        owner = first.setdefault((numbers, window), condition)
        cell = f"as for {owner}" if numbers and owner != condition else numbers
        rows.append((condition, verdict, cell.replace("), ", ")\n"), window))
    print_table(rows, "<<<<")
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
    print_head(f"{group.name}: {counts(group.judgement)}")
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


# Measures side by side:


ROWS: Mapping[str, tuple[str, str]] = {
    "pursuer_gain": ("gain of the pursuers", "+.2f"),
    "evader_gain": ("gain of the evaders", "+.2f"),
    "transitive_share": ("transitive share", ".2f"),
    "checkerboards": ("checkerboards", ".1%"),
    "pursuer_held_out": ("held-out, pursuers", ".2f"),
    "pursuer_held_out_iqm": ("  interquartile mean", ".2f"),
    "evader_held_out": ("held-out, evaders", ".2f"),
    "evader_held_out_iqm": ("  interquartile mean", ".2f"),
    "training_matches": ("training matches", ",.0f"),
    "training_agent_steps": ("training agent-steps", ",.0f"),
    "evaluation_matches": ("evaluation matches", ",.0f"),
}
"""Rows of the table of groups by their names in summary.json: label and form of the numbers."""
PLAYED = list(ROWS)[-3:]
OF_SEEDS = ("pursuer_held_out_iqm", "evader_held_out_iqm")
"""Rows that are shown only where several seeds were asked for."""
NOISY = ("transitive_share", "checkerboards")
"""Rows in which the entry of `NoiseReference` stands beside the number of a single run."""


def measured(group: Group) -> dict[str, Estimate | None]:
    """Return the numbers of a group of races by their names in `ROWS`."""
    gains = group.judgement.headline["arms race"].estimates
    # A window that is too short has no gains.
    found = {f"{team}_gain": gains.get(f"{team}_gain") for team in TEAMS}
    for name in NOISY:
        estimate = MEASURES[name].of(group.payoffs)
        found[name] = None if math.isnan(estimate.value) else estimate
    for team in TEAMS:
        scores = held_out(group, team)
        found[f"{team}_held_out"] = over_seeds(scores.mean(axis=1))
        if len(group.runs) == 1:
            [mean] = group.runs[0].held_out[f"{team}s"]["mean"]
            found[f"{team}_held_out"] = Estimate(**mean, across="episodes", samples=SCORED_EPISODES)
        found[f"{team}_held_out_iqm"] = interquartile_mean(scores)
    for name in PLAYED:
        found[name] = over_seeds([run.numbers[name] for run in group.runs], (0.0, math.inf))
    return found


def held_out(group: Group, team: Team) -> NDArray[np.float64]:
    """Return the scores (seeds, opponents) of the last generation of a team."""
    of_runs = [run.held_out[f"{team}s"]["against"].values() for run in group.runs]
    return np.array([[last["value"] for [last] in against] for against in of_runs])


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


def print_comparison(
    groups: Sequence[Group], estimates: Mapping[str, Mapping[str, Estimate | None]]
) -> None:
    """Print the table of measures: a column for each group of races."""
    several = any(group.several for group in groups)
    names = [name for name in ROWS if several or name not in OF_SEEDS]
    labels = ["", *(["seeds finished"] if several else []), "present"]
    labels += [ROWS[name][0] for name in names]
    for first in range(0, len(groups), BESIDE):
        part = groups[first : first + BESIDE]
        columns = [
            [
                group.name,
                *([group.finished_of_asked()] if several else []),
                headline(group.judgement).replace(", ", ",\n"),
                *(_cell(group, name, estimates[group.name][name]) for name in names),
            ]
            for group in part
        ]
        say()
        print_table([*zip(labels, *columns, strict=True)], "<" * (1 + len(part)))
    print_wrapped(LEGEND + (SEEDS_LEGEND if several else NOISE_LEGEND))


def _cell(group: Group, name: str, estimate: Estimate | None) -> str:
    form = ROWS[name][1]
    noise = getattr(group.noise, name) if name in NOISY and group.noise else None
    return shown(estimate, form) + (f" (noise: {noise:{form}})" if noise else "")


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
        say()
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
    say(
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
