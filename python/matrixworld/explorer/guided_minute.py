"""A guided minute: captions of a race, each with what the page shows to it.

A caption states what cells measured, or a verdict as the judgement gives it. Cells that were chosen
because they stand out illustrate a verdict; they are never the reason for it.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal, NamedTuple

from matrixworld import analysis
from matrixworld.analysis.cycles import MARGIN, Checkerboard
from matrixworld.analysis.payoffs import Rates


class Stop(NamedTuple):
    """A caption, the match that it speaks of, and the part of the page to look at."""

    text: str
    pursuer: int
    evader: int
    shows: Literal["match", "checkerboard", "judgement"] = "match"


def guided_minute(
    matrix: Rates,
    judgement: analysis.Judgement,
    boards: Sequence[Checkerboard],
    kept: tuple[Sequence[int], Sequence[int]],
) -> list[Stop]:
    """Return the captions of a race.

    `boards` are its checkerboards, the strongest first; `kept` are the pursuer and evader
    generations that the page can play.
    """
    g, h = (size - 1 for size in matrix.shape)
    return [
        Stop(
            f"Before learning: pursuers 0 capture {matrix[0, 0]:.0%} of evaders 0, on average. "
            "Triangles pursue, discs evade.",
            *(0, 0),
        ),
        Stop(
            f"At the end: pursuers {g} capture {matrix[g, h]:.0%} of evaders {h}. Both teams have "
            "trained, so it takes other opponents to tell which one became better.",
            *(g, h),
        ),
        _early_opponent(matrix, judgement, kept),
        _checkerboard(matrix, judgement, boards),
        Stop(
            f"The judgement: {analysis.headline(judgement)}. It weighs all cells and episodes of "
            "this race; another seed may give another one.",
            *(g, h, "judgement"),
        ),
    ]


def _verdict(judgement: analysis.Judgement, condition: str) -> str:
    """Return the verdicts on a condition, with the windows where they are not the same."""
    by_verdict: dict[str, list[str]] = {}
    for window, findings in judgement.windows.items():
        name = "whole race" if window == "whole" else window
        by_verdict.setdefault(findings[condition].verdict, []).append(name)
    told = [f"{each} in the {' and the '.join(by_verdict[each])}" for each in by_verdict]
    return f"The judgement on {condition}: {'; '.join(told if len(told) > 1 else by_verdict)}."


def _early_opponent(
    matrix: Rates, judgement: analysis.Judgement, kept: tuple[Sequence[int], Sequence[int]]
) -> Stop:
    """Return the opponent of the first half against which a newest generation lost most."""
    g, h = (size - 1 for size in matrix.shape)
    early = [[each for each in kept[axis] if 2 * each <= last] for axis, last in enumerate((g, h))]
    losses = [(matrix[:, each].max() - matrix[g, each], "pursuers", each) for each in early[1]]
    losses += [(matrix[each, h] - matrix[each].min(), "evaders", each) for each in early[0]]
    loss, team, other = max(losses)
    verdict = _verdict(judgement, "forgetting")
    if loss <= 0:
        none = "Against early opponents, no earlier generation did better than the newest ones."
        return Stop(f"{none} {verdict}", g, 0)
    if team == "pursuers":
        best = matrix[:, other].argmax()
        text = (
            f"The newest pursuers lost most against evaders {other}: pursuers {g} capture "
            f"{matrix[g, other]:.0%} of them, pursuers {best} {matrix[best, other]:.0%}. {verdict}"
        )
        return Stop(text, g, other)
    best = matrix[other].argmin()
    text = (
        f"The newest evaders lost most against pursuers {other}: these capture "
        f"{matrix[other, h]:.0%} of evaders {h}, and {matrix[other, best]:.0%} of evaders {best}. "
        f"{verdict}"
    )
    return Stop(text, other, h)


def _checkerboard(
    matrix: Rates, judgement: analysis.Judgement, boards: Sequence[Checkerboard]
) -> Stop:
    verdict = _verdict(judgement, "intransitivity")
    if not boards:
        g, h = (size - 1 for size in matrix.shape)
        none = f"No four cells differ crosswise by more than {MARGIN}, as in a checkerboard."
        return Stop(f"{none} {verdict}", g, h)
    (p, q), (a, b) = boards[0].pursuers, boards[0].evaders
    text = (
        f"A checkerboard: pursuers {p} capture {matrix[p, a]:.0%} of evaders {a} and "
        f"{matrix[p, b]:.0%} of evaders {b}; pursuers {q} capture {matrix[q, a]:.0%} and "
        f"{matrix[q, b]:.0%}. The strongest of many, some of which noise makes. {verdict}"
    )
    return Stop(text, p, a, "checkerboard")
