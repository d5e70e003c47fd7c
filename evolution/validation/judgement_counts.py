"""Counts of judgements whose truth is known: how many races of each kind got which verdict."""

from __future__ import annotations

import csv
from collections import Counter
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from judgement_races import KINDS

Row = dict[str, str]
VERDICTS = PRESENT, ABSENT, CANNOT_TELL = "present", "absent", "cannot tell"
DEVELOPMENT, HELD_BACK = "development", "held back"

SIZE_EDGES = {
    "arms race": (0.02, 0.05, 0.1, 0.2, 0.3, 0.5),
    "one-sided progress": (0.02, 0.05, 0.1, 0.2, 0.4, 0.6),
    "stagnation": (0.0, 0.005, 0.02, 0.05, 0.1, 0.2, 0.4),
    "rise": (0.07, 0.1, 0.15, 0.2, 0.3, 0.5),
    "intransitivity": (0.02, 0.04, 0.08, 0.14, 0.2, 0.3),
    "cycling": (0.3, 0.4, 0.5, 0.6, 0.8, 1.0),
    "forgetting": (0.1, 0.15, 0.2, 0.3, 0.4, 0.6),
    "disengagement": (0.97, 0.98, 0.985, 0.99, 0.995, 1.0),
}
"""Edges of the bins of the figure, in the units of `judgement_truths.truths`.

The last bin has no upper end.
"""


# ---- Counts --------------------------------------------------------------------------------------


def sample(judgement: dict[str, Any]) -> str:
    """Return the part of the benchmark that a race belongs to."""
    if judgement["source"] != "synthetic":
        return str(judgement["source"])
    return DEVELOPMENT if KINDS[judgement["kind"]].development else HELD_BACK


def count_verdicts(judgements: Iterable[dict[str, Any]]) -> list[Row]:
    """Return verdicts by sample, kind, condition, window and truth, where it is known."""
    return _wide(
        ("sample", "kind", "condition", "window", "truth"),
        (
            ((sample(one), one["kind"], condition, window, str(holds)), verdict)
            for one in judgements
            for window, condition, holds, _, verdict in one["found"]
            if holds is not None
        ),
    )


def count_by_setting(judgements: Iterable[dict[str, Any]]) -> list[Row]:
    """Return verdicts on synthetic races, headline window, by each setting alone."""
    return _wide(
        ("setting", "value", "condition", "truth"),
        (
            ((setting, value, condition, str(holds)), verdict)
            for one in judgements
            for setting, value in one["setting"].items()
            for window, condition, holds, _, verdict in one["found"]
            if holds is not None and window == one["headline"]
        ),
    )


def count_by_size(judgements: Iterable[dict[str, Any]]) -> list[Row]:
    """Return verdicts on the races for power curves, last half, by noise and size of effect.

    Races that have the condition; for stagnation, all that are engaged and have no cycle.
    """
    counted = []
    for one in judgements:
        found = {c: (t, size, v) for w, c, t, size, v in one["found"] if w == "last half"}
        still_possible = found["intransitivity"][0] is found["disengagement"][0] is False
        for condition, (holds, size, verdict) in found.items():
            if holds or (condition == "stagnation" and still_possible):
                edges = SIZE_EDGES[condition]
                # Effects beyond the last edge belong to the last bin.
                place = min(int(np.searchsorted(edges, size, "right")), len(edges) - 1)
                ends = (f"{edges[place - 1]:g}", f"{edges[place]:g}")
                counted.append(((condition, one["setting"]["noise"], *ends), verdict))
    return _wide(("condition", "noise", "from", "to"), counted)


def count_changes(judgements: Iterable[dict[str, Any]]) -> list[Row]:
    """Return how many intervals of single races contain the true change of strength."""
    counts = Counter(
        (setting, value, window, "covered" if low <= true <= high else "missed")
        for one in judgements
        for window, _, true, low, high in one["changes"]
        for setting, value in one["setting"].items()
        if setting in ("noise", "episodes known", "generations")
    )
    keys = dict.fromkeys(key[:3] for key in counts)
    heads = ("setting", "value", "window")
    return [
        dict(zip(heads, key, strict=True))
        | {name: str(counts[(*key, name)]) for name in ("covered", "missed")}
        for key in sorted(keys)
    ]


def _wide(heads: Sequence[str], counted: Iterable[tuple[tuple[str, ...], str]]) -> list[Row]:
    """Return a row for each key, with the number of each verdict."""
    counts = Counter(counted)
    return [
        dict(zip(heads, key, strict=True)) | {name: str(counts[key, name]) for name in VERDICTS}
        for key in sorted({key for key, _ in counts})
    ]


def totals(rows: Iterable[Row], **wanted: str) -> dict[str, int]:
    """Return the number of each verdict, over the rows that have the wanted values."""
    of = [row for row in rows if wanted.items() <= row.items()]
    return {verdict: sum(int(row[verdict]) for row in of) for verdict in VERDICTS}


# ---- Files ----


def write_counts(rows: Sequence[Row], file: Path) -> None:
    """Write rows to a CSV file."""
    with file.open("w", newline="", encoding="utf-8") as out:
        writer = csv.DictWriter(out, list(rows[0]) if rows else [], lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def read_counts(file: Path) -> list[Row]:
    """Return the rows of one of the files of counts."""
    with file.open(newline="", encoding="utf-8") as rows:
        return list(csv.DictReader(rows))
