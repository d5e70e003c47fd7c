"""A diagnosis in words: why, what the numbers are, and what to try."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from matrixworld.analysis.calibration import ABSENT, CANNOT_TELL, PRESENT

if TYPE_CHECKING:
    from matrixworld.analysis.diagnosis import Finding

REASONS = {
    PRESENT: "toy races with evidence as strong nearly all had it",
    ABSENT: "toy races with evidence as weak hardly ever had it",
    CANNOT_TELL: "toy races with such evidence, within its interval, both had it and had not",
}
HIDDEN = "one team wins nearly everything, which hides whatever else happens"

LONGER = "Train for more generations."

_MORE = "play more episodes of each pair, and give several runs with different seeds"

ADVICE: Mapping[str, Mapping[str, str]] = {
    "arms race": {
        PRESENT: "Train on: both teams still gain; test the last generations against opponents of "
        "other runs, to see whether they gain on strangers, too.",
        ABSENT: "Let teams meet opponents of the past (a generalist schedule or a hall of fame), "
        "or give the team that does not gain more epochs.",
        CANNOT_TELL: f"Train for more generations, {_MORE}.",
    },
    "cycling": {
        PRESENT: "Train against the past and not the newest opponents only: a generalist schedule, "
        "a hall of fame, or an archive such as MaxSolve or IPCA.",
        ABSENT: "Nothing to do.",
        CANNOT_TELL: f"To tell a cycle from noise, {_MORE}.",
    },
    "disengagement": {
        PRESENT: "Give the losing team more epochs, reduce the virulence of the winner, or choose "
        "opponents that are sometimes beaten (prioritised by win rate).",
        ABSENT: "Nothing to do.",
        CANNOT_TELL: "Look at the capture rates after each team phase in log.csv, and give several "
        "runs with different seeds.",
    },
    "forgetting": {
        PRESENT: "Keep old opponents in training: sample from a hall of fame or an archive, more "
        "of it and further back.",
        ABSENT: "Nothing to do; but what no opponent punishes any more is not seen in matches.",
        CANNOT_TELL: f"To tell forgetting from the luck of the best, {_MORE}.",
    },
    "stagnation": {
        PRESENT: "Change what holds it: a larger mutation or step size, more samples or episodes "
        "an epoch, a larger network; or stop, if nothing is left to gain.",
        ABSENT: "Nothing to do.",
        CANNOT_TELL: f"Train for more generations, {_MORE}.",
    },
}
"""What to try, by condition and verdict."""

LABELS = {
    "least_rise": "rise of the team that gains less",
    "greatest_rise": "rise, or fall, of the team that changes more",
    "pursuer_rise": "rise of the pursuers",
    "evader_rise": "rise of the evaders",
    "checkerboards": "checkerboards",
    "transitive_share": "transitive share",
    "one_sided": "one-sided share of the generations",
    "most_forgetting": "forgetting of the team that forgets more",
    "pursuer_forgetting": "forgetting of the pursuers",
    "evader_forgetting": "forgetting of the evaders",
    "capture_rate": "mean capture rate",
    "swing": "swing between team phases",
    "pursuer_fading": "fading of the pursuers",
    "evader_fading": "fading of the evaders",
    "pursuer_stripes": "stripes of the pursuers",
    "evader_stripes": "stripes of the evaders",
    "pursuer_rungs": "dominant pursuers",
    "evader_rungs": "dominant evaders",
}
"""The numbers of the evidence in words."""


def describe_finding(finding: Finding) -> str:
    """One line: the verdict, why, the evidence, and what to try."""
    sure = "" if finding.verdict == CANNOT_TELL else f" (confidence {finding.confidence:.2f})"
    numbers = "; ".join(f"{LABELS[name]} {one}" for name, one in finding.evidence.items())
    runs = len(finding.by_run)
    alone = (
        f" By itself present in {finding.by_run.count(PRESENT)} and absent in "
        f"{finding.by_run.count(ABSENT)} of {runs} runs."
        if runs > 1
        else ""
    )
    return (
        f"{finding.name.capitalize()}: {finding.verdict}{sure}, because {finding.reason}."
        f"{f' Evidence: {numbers}.' if numbers else ''}{alone} {finding.advice}"
    )
