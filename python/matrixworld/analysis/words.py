"""Judgements and measures in words and tables."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

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
WHEN = {
    "first half": {ABSENT: "until {}", CANNOT_TELL: "at least until {}"},
    "last half": {ABSENT: "from {} on", CANNOT_TELL: "at least from {} on"},
}
"""When something happened in one half only, by the verdict on the other half."""
IMPROVEMENTS = ("arms race", "one-sided progress", "rise")
BETTER_OR_NOT = {"disengagement", "stagnation", *IMPROVEMENTS}
"""Conditions that say whether a team improved, or why that is not known."""
RANKED_PAIRS = 1024
"""Most pairs for alpha-Rank here, which keeps it under a second; longer runs are thinned out."""


# ---- A judgement ---------------------------------------------------------------------------------


def summary(judgement: Judgement) -> list[str]:
    """Return what happened, in lines: `sentence`, `headline` and `headline_numbers`.

    Parameters
    ----------
    judgement : Judgement
    """
    return [sentence(judgement), headline(judgement), *headline_numbers(judgement)]


def sentence(judgement: Judgement) -> str:
    """Return in one plain sentence who improved, until when, and what was lost.

    Such as ``"Both teams improved until generation 14; the pursuers lost old skills from
    generation 15 on."``. It says what the verdicts say, and no more: "until" if a condition is
    absent in the other half, "at least until" if this cannot be told.

    Parameters
    ----------
    judgement : Judgement
    """
    parts: dict[str, list[_Claim]] = {}
    for claim in _claims(judgement):
        parts.setdefault(claim.window, []).append(claim)
    # Whether a team improved comes first, then what holds for the whole race, then the halves.
    order = ["", "whole", "both", *TIMES]
    told = "; ".join(
        _part(parts[window])
        for window in sorted(
            parts, key=lambda each: (not any(c.better for c in parts[each]), order.index(each))
        )
    )
    if judgement.runs > 1:
        told = f"in the mean of {judgement.runs} runs, {told}"
    return f"{told[0].upper()}{told[1:]}."


class _Claim(NamedTuple):
    """What happened, in which window, and in words when; and whether it is about improvement."""

    what: str
    window: str
    when: str
    better: bool


def _part(claims: list[_Claim]) -> str:
    """Return what happened in a window as a part of a sentence."""
    (first, *others), [when, *different] = claims, dict.fromkeys(each.when for each in claims)
    if not others:
        return f"{first.what} {when}".rstrip()
    when = f"in the {first.window}" if different else when
    *listed, last = (each.what for each in claims)
    return f"{when}, {', '.join(listed)} and {last}".removeprefix(", ")


def _claims(judgement: Judgement) -> list[_Claim]:
    """Return what is present, and whether a team improved if nothing present says it."""
    claims, present = [], _present(judgement)
    for name in sorted(present, key=lambda each: (each not in BETTER_OR_NOT, each)):
        by_teams: dict[tuple[str, ...], list[str]] = {}
        for window in _halves(present[name]):
            by_teams.setdefault(judgement.windows[window][name].teams, []).append(window)
        verdicts = {at: found[name].verdict for at, found in judgement.windows.items()}
        for teams, windows in by_teams.items():
            who = "both teams" if len(teams) == 2 else "".join(f"the {team}" for team in teams)
            time = _time(judgement, windows, verdicts)
            what = RULES[name].happened.format(teams=who)
            claims.append(_Claim(what, *time, name in BETTER_OR_NOT))
    if not BETTER_OR_NOT & present.keys():
        claims.insert(0, _no_improvement(judgement))
    return claims


def _no_improvement(judgement: Judgement) -> _Claim:
    """Return where no team improved; if that is not known anywhere, so much."""
    verdicts = {
        at: PRESENT if {found[name].verdict for name in IMPROVEMENTS} == {ABSENT} else CANNOT_TELL
        for at, found in judgement.windows.items()
    }
    windows = _halves([at for at, verdict in verdicts.items() if verdict == PRESENT])
    if not windows:
        return _Claim("it cannot be told whether a team improved", "", "", True)
    return _Claim("neither team improved", *_time(judgement, windows, verdicts), True)


def _halves(windows: list[str]) -> list[str]:
    """Return the halves among windows, or else the whole race."""
    return [window for window in windows if window in TIMES] or windows


def _time(judgement: Judgement, windows: list[str], verdicts: Mapping[str, str]) -> tuple[str, str]:
    """Return the window in which something holds, and when it did in words."""
    if judgement.window not in TIMES:
        return "whole", ""  # too short to have halves
    if len(windows) == 2:
        return "both", "throughout the race"
    [window] = windows
    if window == "whole":
        return window, "over the whole race"
    [other] = TIMES.keys() - windows
    words = WHEN[window].get(verdicts[other], f"in the {window}")
    pursuers, evaders = judgement.shape
    # The last half begins with the middle generation; teams of different length share no number.
    middle = f"generation {pursuers // 2 - (window == 'first half')}"
    return window, words.format(middle if pursuers == evaders else "the middle of the race")


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

    Such as ``"gains: pursuers +0.42, evaders +0.70 (whole race)"``; about the window that the
    headline names, or about the whole race. No line stands for numbers that are not known.
    """
    lines = []
    for name, window in _numbered(judgement):
        found, kind = judgement.windows[window][name], RULES[name].numbers
        known = {MEASURES[key].short: each for key, each in found.estimates.items()}
        if kind == "drops":  # only of teams that are known to forget
            drops = [f"{team} {known[team].value:.2f}" for team in found.teams]
            lines.append(f"{', '.join(drops)} below their best ({_named(window)})")
        elif known:
            gains = [f"{team} {each.value:+.2f}" for team, each in known.items()]
            lines.append(f"{kind}: {', '.join(gains)} ({_named(window)})")
    return lines


def _numbered(judgement: Judgement) -> list[tuple[str, str]]:
    """Return the conditions whose numbers stand under a headline, each with a window."""
    present = _present(judgement)
    told = [name for name in CONDITIONS if name in present and RULES[name].numbers]
    # A rise is a change in what was played; a gain would come again. One of them is enough.
    falling = [name for name in told if RULES[name].numbers == "drops"]
    rising = [name for name in told if name not in falling][:1]
    numbered = []
    for name in rising + falling or ["arms race"]:
        halves = _halves(present.get(name, []))
        numbered.append((name, halves[0] if len(halves) == 1 else "whole"))
    return numbered


def _named(window: str) -> str:
    return "whole race" if window == "whole" else window


def judgement_table(judgement: Judgement) -> list[tuple[str, str, str, str]]:
    """Return the rows of a table: condition, verdict, numbers with intervals, window.

    After the heads all findings of the headline window; then those that are present in another
    window only, and those whose numbers stand under the headline.

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
    numbered = _numbered(judgement)
    for window, findings in judgement.windows.items():
        others = [each for each in judgement.present(window) if each not in judgement.present()]
        others += [name for name, at in numbered if at == window and name not in others]
        told += [(name, findings[name], window) for name in others if window != judgement.window]
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
    return condition, finding.verdict, numbers, _named(window)


def explain(judgement: Judgement) -> str:
    """Return the findings of `judgement_table` as sentences with reasons, a line for each.

    Parameters
    ----------
    judgement : Judgement
    """
    return "\n".join(
        f"{name.capitalize()}{'' if window == judgement.window else f' ({_named(window)})'}: "
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
            lines.append(f"  {_named(window)}")
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
