"""A summary in sentences, with all numbers behind its verdict."""

from __future__ import annotations

from matrixworld.analysis.summary import MARGIN, PartSummary, Summary, TeamSummary

_LOOKS = {
    "cycling": "This run looks like cycling",
    "progress": "This run looks like progress",
    "undecided": "This run is undecided between cycling and progress",
}


def describe(summary: Summary) -> str:
    """Describe a summary in plain English.

    Parameters
    ----------
    summary : Summary
        Result of `summarize`.

    Returns
    -------
    str
        One statement on each line: the verdict first, then the evidence. It describes a single run
        ("looks like"), and not the training method.
    """
    lines = [
        _verdict(summary),
        _transitivity(summary.last_half),
        _checkerboards(summary.last_half),
        _swing(summary),
        _lags(summary),
        _team("Pursuers", "capture", summary.pursuers),
        _team("Evaders", "escape", summary.evaders),
        *(f"Warning: disengagement in {stretch}." for stretch in summary.disengagements),
    ]
    return "\n".join(lines)


def _verdict(summary: Summary) -> str:
    return (
        f"{_LOOKS[summary.verdict]}, because {summary.reason}. It is a single run: conclusions "
        "about the training method need several seeds."
    )


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
