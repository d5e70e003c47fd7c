"""A summary in sentences, with every number that the verdict rests on."""

from __future__ import annotations

from matrixworld.analysis.summary import MARGIN, PartSummary, Summary, TeamSummary


def describe(summary: Summary) -> str:
    """Plain English, one statement a line: the verdict first, then the evidence.

    The wording stays that of a single run: it "looks like" cycling or progress.
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
    looks = {
        "cycling": "This run looks like cycling",
        "progress": "This run looks like progress",
        "undecided": "This run is undecided between cycling and progress",
    }[summary.verdict]
    return (
        f"{looks}, because {summary.reason}. It is a single run: "
        "only several seeds can tell what the method does."
    )


def _transitivity(part: PartSummary) -> str:
    if part.transitive_share is None or part.transitive_share_logits is None:
        return f"{_when(part)}, all capture rates are the same, so there is nothing to explain."
    return (
        f"{_when(part)}, the strength of each generation by itself explains "
        f"{part.transitive_share:.0%} of the variance of the capture rate (transitive share "
        f"{part.transitive_share:.2f}; {part.transitive_share_logits:.2f} on logits); "
        "the rest is who meets whom, and noise."
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
    first, second = part.first_pursuers, part.first_evaders
    return f"From generation {first if first == second else f'{first} / {second}'} on"


def _swing(summary: Summary) -> str:
    return (
        f"From generation {summary.swing_start} on, the evaders of one generation and of the one "
        f"before differ by {summary.swing:.2f} on average in what the same pursuers capture."
    )


def _lags(summary: Summary) -> str:
    means = ", ".join(
        f"{lag:+d}: {mean:.2f}" if lag else f"0: {mean:.2f}"
        for lag, mean in zip(summary.lags, summary.lag_means, strict=True)
    )
    plural = "" if summary.rise_lag == 1 else "s"
    return (
        f"Capture rate by lag (pursuer minus evader generation): {means}. Pursuers "
        f"{summary.rise_lag} generation{plural} after their opponents rather than as many before "
        f"them change it by {summary.lag_rise:+.2f}."
    )


def _team(name: str, score: str, team: TeamSummary) -> str:
    return (
        f"{name}' mean {score} rate against all opponents: {team.generalization_first:.2f} at "
        f"generation 0, {team.generalization_last:.2f} at generation {team.generations - 1}, best "
        f"{team.generalization_best:.2f} at generation {team.best_generation}; forgetting in the "
        f"last half {team.forgetting:.2f}."
    )
