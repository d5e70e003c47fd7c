"""Judgements and measures in words and tables."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from matrixworld._util.checks import check_instance
from matrixworld._util.readable import plain_values
from matrixworld.analysis import progress
from matrixworld.analysis.cycles import spinning_top
from matrixworld.analysis.dynamics import alpha_rank, replicator_dynamics
from matrixworld.analysis.games import nash_averaging
from matrixworld.analysis.intervals import FEW_RUNS, LEVEL, SINGLE_RUN, Estimate, few_runs
from matrixworld.analysis.judge import (
    ABSENT,
    CANNOT_TELL,
    CONDITIONS,
    LEAST_FORGETTING,
    PRESENT,
    RULES,
    Finding,
    Judgement,
)
from matrixworld.analysis.measures import MEASURES, measure_all
from matrixworld.analysis.payoffs import Payoffs, Rates, Source, read_payoffs
from matrixworld.analysis.ratings import elo, elo_over_episodes
from matrixworld.analysis.runs import race_bands
from matrixworld.analysis.strength import forgetting

TIMES = {"first half": "early", "last half": "late"}
"""Windows in a headline."""
OVERALL = "overall"
RANKED_PAIRS = 1024
"""Most pairs for alpha-Rank here, which keeps it under a second; longer runs are thinned out."""


# ---- A judgement ---------------------------------------------------------------------------------


def headline(judgement: Judgement) -> str:
    """Return what is present, and when, in one sentence; commands, figures and pages share it.

    Such as ``"CYCLING early, FORGETTING late"``. "early" and "late" are the halves of a race. What
    is present in both halves, or only in the whole race, is so "overall", or has no time. "cannot
    tell" if nothing is present in any window and not everything is absent.

    Parameters
    ----------
    judgement : Judgement
    """
    at: dict[str, list[str]] = {time: [] for time in (OVERALL, *TIMES.values())}
    for name, windows in _present(judgement).items():
        halves = [TIMES[window] for window in windows if window in TIMES]
        at[halves[0] if len(halves) == 1 else OVERALL].append(name.upper())
    if not any(at.values()):
        verdicts = {each.verdict for found in judgement.windows.values() for each in found.values()}
        return CANNOT_TELL if CANNOT_TELL in verdicts else "no condition is present"
    if not (at["early"] or at["late"]):
        return ", ".join(at[OVERALL])
    parts = [f"{' and '.join(names)} {time}" for time, names in at.items() if names]
    if not (at["late"] or at[OVERALL]):
        early = (judgement.findings[name.lower()].verdict for name in at["early"])
        parts.append("later undecided" if CANNOT_TELL in early else "not later")
    return ", ".join(parts)


def _present(judgement: Judgement) -> dict[str, list[str]]:
    """Return the windows in which each condition is present and no other one implies it."""
    check_instance("judgement", judgement, Judgement)
    found: dict[str, list[str]] = {}
    for window in judgement.windows:
        present = judgement.present(window)
        implied = {RULES[name].implies for name in present}
        for name in present:
            if name not in implied:
                found.setdefault(name, []).append(window)
    return found


def headline_numbers(judgement: Judgement) -> list[str]:
    """Return the numbers under a headline: gains, and how far teams fall below their best.

    Such as ``"gains: pursuers +0.42, evaders +0.70"``; about the window that the
    headline names, or about the whole race. No line stands for numbers that are not known.
    """
    lines, present = [], _present(judgement)
    told = {name: RULES[name].numbers for name in CONDITIONS if name in present}
    # A rise is a change in what was played; a gain would come again. One of them is enough.
    rising = [name for name, numbers in told.items() if numbers in ("gains", "changes")]
    falling = [name for name, numbers in told.items() if numbers == "drops"]
    if rising or not falling:
        name = rising[0] if rising else "arms race"
        window, about = _where(present.get(name, []))
        known = judgement.windows[window][name].estimates
        numbers = [f"{MEASURES[key].short} {each.value:+.2f}" for key, each in known.items()]
        lines += [f"{RULES[name].numbers}: {', '.join(numbers)}{about}"] if numbers else []
    for name in falling:
        window, about = _where(present[name])
        # Only of teams that are known to forget.
        numbers = [
            f"{MEASURES[key].short} {each.value:.2f}"
            for key, each in judgement.windows[window][name].estimates.items()
            if each.ends[0] > LEAST_FORGETTING
        ]
        lines.append(f"{', '.join(numbers)} below their best{about}")
    return lines


def _where(windows: list[str]) -> tuple[str, str]:
    halves = [window for window in windows if window in TIMES]
    window = halves[0] if len(halves) == 1 else "whole"
    return window, "" if window == "whole" else f" ({window})"


def judgement_table(judgement: Judgement) -> list[tuple[str, str, str, str]]:
    """Return the rows of a table: condition, verdict, numbers with intervals, window.

    After the heads all findings of the headline window; then those that are present in another
    window only.

    Parameters
    ----------
    judgement : Judgement
    """
    rows = [_row(*told) for told in _told(judgement)]
    return [("condition", "verdict", f"{judgement.level:.0%} interval", "window"), *rows]


def _told(judgement: Judgement) -> list[tuple[str, Finding, str]]:
    """Return condition, finding and window of what `judgement_table` lists."""
    check_instance("judgement", judgement, Judgement)
    told = [(name, found, judgement.window) for name, found in judgement.findings.items()]
    # A wave that is over belongs into the table, too.
    for window, findings in judgement.windows.items():
        others = [each for each in judgement.present(window) if each not in judgement.present()]
        told += [(name, findings[name], window) for name in others]
    return told


def judgement_cells(judgement: Judgement) -> list[tuple[str, ...]]:
    """Return the rows of `judgement_table` for a terminal: numbers below each other, and once."""
    rows: list[tuple[str, ...]] = []
    first: dict[tuple[str, str], str] = {}
    for condition, verdict, numbers, window in judgement_table(judgement):
        # Numbers of an earlier row are named by its condition.
        owner = first.setdefault((numbers, window), condition)
        cell = f"as for {owner}" if numbers and owner != condition else numbers
        rows.append((condition, verdict, cell.replace(", ", "\n"), window))
    return rows


def _row(condition: str, finding: Finding, window: str) -> tuple[str, str, str, str]:
    numbers = ", ".join(
        f"{MEASURES[key].short or MEASURES[key].label} {MEASURES[key].shown(estimate)}"
        for key, estimate in finding.estimates.items()
    )
    return condition, finding.verdict, numbers, window


def explain(judgement: Judgement) -> str:
    """Return the findings of `judgement_table` as sentences with reasons, a line for each.

    Parameters
    ----------
    judgement : Judgement
    """
    return "\n".join(
        f"{name.capitalize()}{'' if window == judgement.window else f' ({window})'}: "
        f"{finding.verdict}, because {finding.reason}.{_counts(finding.by_run)}"
        for name, finding, window in _told(judgement)
    )


def _counts(by_run: tuple[str, ...]) -> str:
    if len(by_run) == 1:
        return ""
    counts = ", ".join(f"{by_run.count(each)} {each}" for each in (PRESENT, ABSENT, CANNOT_TELL))
    return f" Of the single runs: {counts}."


# ---- All measures --------------------------------------------------------------------------------


def measure_table(source: Source, *, level: float = LEVEL, **known: Any) -> str:
    """Return all measures of one run or several as text, by window.

    Notes say why a measure has no interval.

    Parameters
    ----------
    source, level, **known
        As for `measure_all`.
    """
    payoffs = read_payoffs(source, **known)
    estimates = measure_all(payoffs, level=level)
    notes = _footnotes(payoffs, estimates)
    lines, last = [_heading(payoffs, estimates, level)], ""
    for name, estimate in estimates.items():
        window = MEASURES[name].window_in(payoffs).name
        if window != last:
            lines.append("  whole race" if window == "whole" else f"  {window}")
            last = window
        text = f"{MEASURES[name].label:53}{MEASURES[name].shown(estimate)}"
        lines.append(f"    {text} {notes.get(estimate.note, '')}".rstrip())
    lines += [f"  {mark} {note}" for note, mark in notes.items()]
    return "\n".join([*lines, *_dominant(payoffs)])


def _heading(payoffs: Payoffs, estimates: Mapping[str, Estimate], level: float) -> str:
    if len(payoffs) > 1:
        few = "; few runs make it wide" if len(payoffs) < FEW_RUNS else ""
        return f"Mean ({level:.0%} interval over runs{few}):"
    if any(one.across == "episodes" for one in estimates.values()):
        return (
            f"A single run ({level:.0%} interval over its episodes, which says nothing about other "
            "runs):"
        )
    return "A single run: no intervals."


def _footnotes(payoffs: Payoffs, estimates: Mapping[str, Estimate]) -> dict[str, str]:
    """Return the notes that the heading does not say, with a mark for each."""
    said = (SINGLE_RUN, few_runs(len(payoffs)), "")
    notes = dict.fromkeys(one.note for one in estimates.values() if one.note not in said)
    return {note: f"[{number}]" for number, note in enumerate(notes, 1)}


def _dominant(payoffs: Payoffs) -> list[str]:
    # Several runs have the mean number of dominant generations among the measures.
    if len(payoffs) > 1 or payoffs.scores is None or payoffs.scores.shape[3] < 2:
        return []
    ladders = progress.dominance_tournament(payoffs.scores[0])
    return [
        f"Dominant {team}: generations {', '.join(map(str, ladder.generations))}."
        for team, ladder in zip(("pursuers", "evaders"), ladders, strict=True)
    ]


def all_results(source: Source, *, level: float = LEVEL) -> dict[str, Any]:
    """Return measures and curves as plain values that JSON can represent: lists, and None for NaN.

    ``measures``: those of `measure_all`. ``bands``: the mean curves of `race_bands`. ``runs``: for
    each run its payoff matrix and the results of `CURVES`, of episodes also those of
    `dominance_tournament` and `spinning_top`. ``ratings``: of episodes, `elo_over_episodes`. With
    cross tests ``global_progress``.
    """
    payoffs = read_payoffs(source)
    found: dict[str, Any] = {
        "level": level,
        "measures": measure_all(payoffs, level=level),
        "bands": race_bands(payoffs.matrices, level=level),
        "runs": [_curves(run, level) for run in payoffs.runs],
    }
    if payoffs.scores is not None and payoffs.scores.shape[3] >= 2:
        found["ratings"] = elo_over_episodes(payoffs.scores, level=level)
    if payoffs.cross is not None:
        found["global_progress"] = progress.global_progress(payoffs.cross)
    plain: dict[str, Any] = plain_values(found)
    return plain


def _curves(run: Payoffs, level: float) -> dict[str, Any]:
    curves = {name: of(run.matrices[0]) for name, of in CURVES.items()}
    if run.scores is not None and run.scores.shape[3] >= 2:
        curves["dominance"] = progress.dominance_tournament(run.scores[0])
        curves["spinning_top"] = spinning_top(run.scores[0], level=level)
    return {"payoff": run.matrices[0], **curves}


def _ranked(matrix: Rates) -> dict[str, Any]:
    """Return alpha-Rank of all generations, or of every k-th one counted back from the last."""
    rows, columns = matrix.shape
    step = 1
    # The smallest k for which every k-th generation of both teams is few enough pairs.
    while -(-rows // step) * -(-columns // step) > RANKED_PAIRS:
        step += 1
    g, h = (np.arange((size - 1) % step, size, step) for size in matrix.shape)
    return {"pursuers": g, "evaders": h, "ranks": alpha_rank(matrix[np.ix_(g, h)])}


CURVES: Mapping[str, Callable[[Rates], Any]] = {
    "generalization": progress.generalization,
    "forgetting": forgetting,
    "local_progress": progress.local_progress,
    "historical_progress": progress.historical_progress,
    "lag_profile": progress.lag_profile,
    "ciao": progress.ciao,
    "ratings": lambda matrix: elo(matrix, cycles=1),
    "nash": nash_averaging,
    "alpha_rank": _ranked,
    "replicator_dynamics": lambda matrix: replicator_dynamics(matrix, points=51),
}
