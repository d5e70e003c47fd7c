"""Result of a diagnosis: a finding for each condition, its wording, and advice."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from matrixworld.analysis.calibration import ABSENT, CANNOT_TELL, PRESENT
from matrixworld.analysis.intervals import Estimate
from matrixworld.analysis.plain_values import plain_values

REASONS = {
    PRESENT: "the condition was present in nearly all calibration races with comparable evidence",
    ABSENT: "the condition was rarely present in calibration races with comparable evidence",
    CANNOT_TELL: (
        "calibration races with evidence in this interval do not agree on whether it is present"
    ),
}
"""Reason of each verdict, as a clause after "because"."""
HIDDEN = "one team wins nearly all matches, which hides the other conditions"

LONGER = "Train for more generations."
NO_ACTION = "No action needed."

_MORE = "play more episodes of each pair, and compare several runs with different seeds"

ADVICE: Mapping[str, Mapping[str, str]] = {
    "arms race": {
        PRESENT: "Continue training: both teams still improve. Test the last generations against "
        "opponents of other runs to check whether the improvement is general.",
        ABSENT: "Train against past opponents (a generalist schedule or a hall of fame), or give "
        "more epochs to the team that does not improve.",
        CANNOT_TELL: f"Train for more generations, {_MORE}.",
    },
    "cycling": {
        PRESENT: "Train against past opponents, not only the newest ones: use a generalist "
        "schedule, a hall of fame, or an archive such as MaxSolve or IPCA.",
        ABSENT: NO_ACTION,
        CANNOT_TELL: f"To separate a cycle from noise, {_MORE}.",
    },
    "disengagement": {
        PRESENT: "Give the losing team more epochs, reduce the virulence of the winning team, or "
        "sample opponents that are sometimes beaten (prioritized by win rate).",
        ABSENT: NO_ACTION,
        CANNOT_TELL: "Look at the capture rates after each team phase in log.csv, and compare "
        "several runs with different seeds.",
    },
    "forgetting": {
        PRESENT: "Keep old opponents in training: sample more opponents, and older ones, from a "
        "hall of fame or an archive.",
        ABSENT: f"{NO_ACTION} Matches do not show the loss of skills that no opponent tests.",
        CANNOT_TELL: f"To separate forgetting from noise, {_MORE}.",
    },
    "stagnation": {
        PRESENT: "Change what limits learning: use a larger mutation or step size, more samples or "
        "episodes in each epoch, or a larger network. Stop if there is nothing left to gain.",
        ABSENT: NO_ACTION,
        CANNOT_TELL: f"Train for more generations, {_MORE}.",
    },
}
"""Advice by condition and verdict."""

LABELS = {
    "least_rise": "rise of the team that rises less",
    "greatest_rise": "rise of the team that changes more (negative: a fall)",
    "pursuer_rise": "rise of the pursuers",
    "evader_rise": "rise of the evaders",
    "checkerboards": "checkerboard share",
    "transitive_share": "transitive share",
    "one_sided": "share of one-sided generations",
    "most_forgetting": "forgetting of the team that forgets more",
    "pursuer_forgetting": "forgetting of the pursuers",
    "evader_forgetting": "forgetting of the evaders",
    "capture_rate": "mean capture rate",
    "swing": "swing between team phases",
    "pursuer_fading": "fading of the pursuers",
    "evader_fading": "fading of the evaders",
    "pursuer_stripes": "stripes of the pursuers",
    "evader_stripes": "stripes of the evaders",
    "pursuer_rungs": "dominant pursuer generations",
    "evader_rungs": "dominant evader generations",
}
"""Labels of the numbers of the evidence."""


@dataclass(frozen=True)
class Finding:
    """Verdict on one condition; ``str`` gives verdict, reason, evidence and advice in one line.

    Parameters
    ----------
    name : str
        One of `CONDITIONS`.
    verdict : str
        ``"present"``, ``"absent"`` or ``"cannot tell"``.
    confidence : float
        Share, in [0, 1], of the calibration races with the same strength of evidence for which the
        verdict is true; the least one over the interval. 0 for ``"cannot tell"``.
    reason : str
        Reason of the verdict, as a clause after "because".
    evidence : mapping of str to Estimate
        Numbers behind the verdict by name; the first one decides.
    by_run : tuple of str
        Verdict on each single run.
    advice : str
        What to try.
    """

    name: str
    verdict: str
    confidence: float
    reason: str
    evidence: Mapping[str, Estimate]
    by_run: tuple[str, ...]
    advice: str

    def __str__(self) -> str:
        # Without a verdict the confidence is 0 by definition and would mislead.
        sure = "" if self.verdict == CANNOT_TELL else f" (confidence {self.confidence:.2f})"
        numbers = "; ".join(f"{LABELS[name]} {one}" for name, one in self.evidence.items())
        return (
            f"{self.name.capitalize()}: {self.verdict}{sure}, because {self.reason}."
            f"{f' Evidence: {numbers}.' if numbers else ''}{self._single_runs()} {self.advice}"
        )

    # Shows whether runs agree, which the verdict on their mean does not.
    def _single_runs(self) -> str:
        runs = len(self.by_run)
        if runs == 1:
            return ""
        return (
            f" Verdicts on single runs: present in {self.by_run.count(PRESENT)}, absent in "
            f"{self.by_run.count(ABSENT)} of {runs}."
        )


@dataclass(frozen=True)
class Diagnosis:
    """All findings on a race; ``str`` describes them in words.

    Parameters
    ----------
    runs : int
        Number of runs.
    generations : tuple of int
        Generations of the pursuers and of the evaders.
    findings : tuple of Finding
        One for each condition, in the order of `CONDITIONS`.
    source : str
        The calibration races.
    """

    runs: int
    generations: tuple[int, int]
    findings: tuple[Finding, ...]
    source: str

    # Findings stay a tuple in a fixed order, which the printed text and JSON keep.
    def __getitem__(self, name: str) -> Finding:
        """Return the finding on a condition, or raise KeyError for another name."""
        return {finding.name: finding for finding in self.findings}[name]

    @property
    def present(self) -> tuple[str, ...]:
        """Names of the conditions that are present."""
        return tuple(finding.name for finding in self.findings if finding.verdict == PRESENT)

    def to_json(self) -> dict[str, Any]:
        """Return plain values that JSON can represent; NaN as None."""
        plain: dict[str, Any] = plain_values(self)
        return plain

    def __str__(self) -> str:
        n, m = self.generations
        runs = "A single run" if self.runs == 1 else f"{self.runs} runs"
        return "\n".join(
            [
                f"{runs}, {n} pursuer and {m} evader generations: "
                f"{', '.join(self.present) or 'no condition found'}.",
                *map(str, self.findings),
                "Confidence is the share of correct verdicts in calibration races whose truth is "
                f"known ({self.source}).",
            ]
        )
