"""A class tournament as plain values for a JSON file, and as a page with the recorded matches."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from matrixworld.analysis.plain_values import plain_values
from matrixworld.classroom.standings import Standing
from matrixworld.classroom.tournament import ClassResult
from matrixworld.coevolution.types import TEAMS, Team
from matrixworld.explorer.page import render_page
from matrixworld.version import __version__

MOST_BYTES = 3 * 2**20
"""Recordings of a page, in bytes; base64 adds a third. 56 x 56 default matches take 0.8 MB."""

Pair = tuple[int, int]
Tables = Mapping[Team, Sequence[Standing]]


def class_json(result: ClassResult, tables: Tables) -> dict[str, Any]:
    """Return a tournament as values that JSON can hold, with the results of all episodes."""
    return {
        **_summary(result, tables),
        "capture_rates": plain_values(result.capture_rates),
        "lengths": plain_values(result.lengths),
    }


def _summary(result: ClassResult, tables: Tables) -> dict[str, Any]:
    return {
        "matrixworld": __version__,
        "world": result.config.to_json(),
        "seed": str(result.seed),
        # As text: a number of JavaScript holds 53 of the 64 bits.
        "match_seed": str(result.match_seed),
        "episodes": result.capture_rates.shape[2],
        "names": {team: [entry.name for entry in result.entries[team]] for team in TEAMS},
        "standings": {team: [_row(each) for each in tables[team]] for team in TEAMS},
        "refusals": plain_values(result.refusals),
        "votes": result.votes,
    }


def _row(standing: Standing) -> dict[str, Any]:
    return {
        "name": standing.entry.name,
        "kind": standing.entry.kind,
        "file": standing.entry.file,
        "number": standing.number,
        "rank": standing.rank,
        "ranks": plain_values(standing.ranks),
        "score": standing.score.value,
        "low": standing.score.low,
        "high": standing.score.high,
        "best": standing.best,
        "worst": standing.worst,
    }


def class_page(result: ClassResult, tables: Tables, *, title: str, most: int = MOST_BYTES) -> str:
    """Return the page of a class tournament as HTML.

    It holds `most` bytes of recordings: the best and the worst match of each entry come first.
    """
    packed = _chosen(result, tables, most)
    rows, columns, _ = result.capture_rates.shape
    steps = [
        [len(result.recordings[g, h]) if (g, h) in packed else -1 for h in range(columns)]
        for g in range(rows)
    ]
    data: dict[str, Any] = {
        **_summary(result, tables),
        "title": title,
        "n_actions": result.config.n_actions,
        "capture_rate": _rounded(result.capture_rates.mean(axis=2)),
        "lowest": _rounded(result.capture_rates.min(axis=2)),
        "highest": _rounded(result.capture_rates.max(axis=2)),
        "length": _rounded(result.lengths.mean(axis=2)),
        "first": _rounded(result.capture_rates[:, :, 0]),
        "steps": steps,
    }
    blob = b"".join(packed[pair] for pair in sorted(packed))
    return render_page("class", f"{title} - matrixworld", data, {"recordings": blob})


def _chosen(result: ClassResult, tables: Tables, most: int) -> dict[Pair, bytes]:
    """Return the recordings of the page by pair, as many as fit."""
    extremes: list[Pair] = []
    for standing in tables["pursuer"]:
        extremes += [(standing.number, standing.best), (standing.number, standing.worst)]
    for standing in tables["evader"]:
        extremes += [(standing.best, standing.number), (standing.worst, standing.number)]
    rows, columns, _ = result.capture_rates.shape
    every = product(range(rows), range(columns))
    kept: dict[Pair, bytes] = {}
    left = most
    for pair in dict.fromkeys([*extremes, *every]):
        packed = pack_actions(result.recordings[pair], result.config.n_actions)
        if len(packed) <= left:
            kept[pair] = packed
            left -= len(packed)
    return kept


def pack_actions(actions: NDArray[np.uint8], n_actions: int) -> bytes:
    """Return actions with several to a byte: digits of a number with base `n_actions`.

    Three of 5 actions, or two of 9, fit into a byte; the first is the lowest digit. The page's
    script reads them (``web/src/class/recordings.ts``).
    """
    count = digits(n_actions)
    flat = actions.ravel()
    padded = np.zeros(-(-len(flat) // count) * count, np.uint8)
    padded[: len(flat)] = flat
    weights = n_actions ** np.arange(count)
    return (padded.reshape(-1, count) @ weights).astype(np.uint8).tobytes()


def digits(n_actions: int) -> int:
    """Return how many actions a byte holds."""
    count = 1
    while n_actions ** (count + 1) <= 256:
        count += 1
    return count


def _rounded(values: NDArray[np.floating[Any]]) -> list[list[float]]:
    rows: list[list[float]] = plain_values(np.round(values, 4))
    return rows
