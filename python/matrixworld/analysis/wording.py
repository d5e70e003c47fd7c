"""Judgements and summaries in words."""

from __future__ import annotations

from matrixworld.analysis.evidence import CHECKERBOARDS, CYCLIC, EVADER_CHANGE, PURSUER_CHANGE
from matrixworld.analysis.intervals import Estimate
from matrixworld.analysis.judgement import Judgement, WindowJudgement
from matrixworld.analysis.summary import MARGIN, PartSummary, Summary, TeamSummary
from matrixworld.analysis.verdicts import ABSENT, CANNOT_TELL, PRESENT

SHORT = {
    "squared cyclic amplitude": "cyclic amplitude",
    "gain of the pursuers": "pursuers",
    "gain of the evaders": "evaders",
    "change of the pursuers": "change of the pursuers",
    "change of the evaders": "of the evaders",
    "forgetting of the pursuers": "pursuers",
    "forgetting of the evaders": "evaders",
}
"""Short names of the numbers in the table."""


SHOWN = {"one-sided progress": (PURSUER_CHANGE, EVADER_CHANGE)}
"""Numbers in the rows of some conditions; the others stand in another row already."""


def headline(judgement: Judgement) -> str:
    """Return what is present in the window that headlines speak of, in a few words.

    Parameters
    ----------
    judgement : Judgement
        Result of `judge`.

    Returns
    -------
    str
        Such as ``"cycling, forgetting (last half)"``; "cannot tell" if no condition is present and
        not all are absent.
    """
    part = judgement.headline
    present = ", ".join(part.present)
    if not present:
        open_ = any(each.verdict == CANNOT_TELL for each in part.findings.values())
        present = CANNOT_TELL if open_ else "no condition is present"
    return f"{present} ({judgement.window})"


def judgement_table(judgement: Judgement) -> list[tuple[str, str, str, str]]:
    """Return the rows of a table: condition, verdict, numbers with intervals, window.

    Parameters
    ----------
    judgement : Judgement
        Result of `judge`.

    Returns
    -------
    list of tuple of str
        The heads; all findings of the headline window; and those of other windows that are present
        there and not in the headline window.
    """
    main = judgement.headline
    rows = [("condition", "verdict", f"{judgement.level:.0%} interval", "window")]
    rows += [_row(main, name) for name in main.findings]
    # A wave that is over belongs into the table, too.
    for part in judgement.windows.values():
        rows += [_row(part, name) for name in part.present if name not in main.present]
    return rows


def _row(part: WindowJudgement, name: str) -> tuple[str, str, str, str]:
    finding = part[name]
    numbers = ", ".join(
        f"{SHORT.get(key, key)} {_number(key, estimate)}"
        for key, estimate in finding.estimates.items()
        if key in SHOWN.get(name, finding.estimates)
    )
    return name, finding.verdict, numbers, part.window.name


def _number(key: str, estimate: Estimate) -> str:
    if estimate.low is None or estimate.high is None:
        return f"{estimate.value:.3f}"
    value, low, high = estimate.value, estimate.low, estimate.high
    if key == CHECKERBOARDS:
        return f"{value:.1%}" if low == high else f"{value:.1%} ({low:.1%} to {high:.1%})"
    if key == CYCLIC:
        # In units of the capture rate, which readers know; below 0 there is nothing but noise.
        value, low, high = (max(0.0, end) ** 0.5 for end in (value, low, high))
    sign = "+" if key.startswith(("gain", "change")) else ""
    return f"{value:{sign}.3f} ({low:{sign}.3f} to {high:{sign}.3f})"


def explain(judgement: Judgement) -> str:
    """Return the findings of the headline window as sentences, one for each condition.

    Parameters
    ----------
    judgement : Judgement
        Result of `judge`.

    Returns
    -------
    str
        One line for each condition: verdict and reason; for several runs how many of them have
        which verdict on their own.
    """
    return "\n".join(
        f"{name.capitalize()}: {finding.verdict}, because {finding.reason}."
        f"{_counts(finding.by_run)}"
        for name, finding in judgement.headline.findings.items()
    )


def _counts(by_run: tuple[str, ...]) -> str:
    if len(by_run) == 1:
        return ""
    counts = ", ".join(
        f"{by_run.count(verdict)} {verdict}" for verdict in (PRESENT, ABSENT, CANNOT_TELL)
    )
    return f" Of the single runs: {counts}."


def describe(summary: Summary) -> str:
    """Describe a summary in plain English.

    Parameters
    ----------
    summary : Summary
        Result of `summarize`.

    Returns
    -------
    str
        One statement on each line. It gives numbers; `judge` tells which of them exceed noise.
    """
    lines = [
        _transitivity(summary.last_half),
        _checkerboards(summary.last_half),
        _swing(summary),
        _lags(summary),
        _team("Pursuers", "capture", summary.pursuers),
        _team("Evaders", "escape", summary.evaders),
        *(f"Warning: disengagement in {stretch}." for stretch in summary.disengagements),
    ]
    return "\n".join(lines)


def _transitivity(part: PartSummary) -> str:
    if part.transitive_share is None or part.transitive_share_logits is None:
        return f"{_when(part)}, all capture rates are equal, so there is no variance to explain."
    return (
        f"{_when(part)}, the strength of each generation explains "
        f"{part.transitive_share:.0%} of the variance of the capture rate (transitive share "
        f"{part.transitive_share:.2f}; {part.transitive_share_logits:.2f} on logits); "
        "the rest depends on the pairing or is noise."
    )


def _checkerboards(part: PartSummary) -> str:
    if part.checkerboard_share is None:
        return f"{_when(part)}, there are too few generations for a checkerboard."
    return (
        f"{_when(part)}, {part.checkerboards:,} of {part.quadruples:,} possible checkerboards "
        f"({part.checkerboard_share:.1%}): two pursuer generations and two evader generations, "
        f"each better against one opponent and worse against the other, by more than {MARGIN}."
    )


def _when(part: PartSummary) -> str:
    # The last half of a matrix that is not square starts at two different generations.
    first, second = part.first_pursuers, part.first_evaders
    return f"From generation {first if first == second else f'{first} / {second}'} on"


def _swing(summary: Summary) -> str:
    return (
        f"From generation {summary.swing_start} on, the capture rate of the same pursuers against "
        f"the evaders of one generation and of the previous one differs by {summary.swing:.2f} on "
        "average."
    )


def _lags(summary: Summary) -> str:
    means = ", ".join(
        f"{lag:+d}: {mean:.2f}" if lag else f"0: {mean:.2f}"
        for lag, mean in zip(summary.lags, summary.lag_means, strict=True)
    )
    # The lag is a third of the run, so it is 1 in short runs.
    plural = "" if summary.rise_lag == 1 else "s"
    return (
        f"Capture rate by lag (pursuer minus evader generation): {means}. At a lag of "
        f"+{summary.rise_lag} generation{plural} it differs from a lag of -{summary.rise_lag} by "
        f"{summary.lag_rise:+.2f}."
    )


def _team(name: str, score: str, team: TeamSummary) -> str:
    return (
        f"{name}' mean {score} rate against all opponents: {team.generalization_first:.2f} at "
        f"generation 0, {team.generalization_last:.2f} at generation {team.generations - 1}, best "
        f"{team.generalization_best:.2f} at generation {team.best_generation}; forgetting in the "
        f"last half {team.forgetting:.2f}."
    )
