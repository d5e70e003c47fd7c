"""A class tournament as plain values: for the JSON file, and for the page."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from matrixworld.analysis.plain_values import plain_values
from matrixworld.classroom.round_robin import ClassResult
from matrixworld.classroom.standings import Standing
from matrixworld.coevolution.types import TEAMS, Team
from matrixworld.play.seeds import match_seed
from matrixworld.version import __version__

Tables = Mapping[Team, Sequence[Standing]]


def class_json(result: ClassResult, tables: Tables) -> dict[str, Any]:
    """Return a tournament as values that JSON can hold.

    Parameters
    ----------
    result : ClassResult
        The tournament.
    tables : mapping of str to sequence of Standing
        The `standings` of each team.

    Returns
    -------
    dict
        Settings, standings, refusals, and for every pair the capture rate of each episode.
    """
    return {
        **summary(result, tables),
        "capture_rates": plain_values(result.capture_rates),
        "lengths": plain_values(result.lengths),
    }


def summary(result: ClassResult, tables: Tables) -> dict[str, Any]:
    """Return settings, standings and refusals as plain values."""
    return {
        "matrixworld": __version__,
        "world": result.config.to_json(),
        "seed": str(result.seed),
        # As text: a number of JavaScript holds 53 of the 64 bits.
        "match_seed": str(match_seed(result.seed)),
        "episodes": result.capture_rates.shape[2],
        "names": {team: [entry.name for entry in result.entries[team]] for team in TEAMS},
        "standings": {team: [_row(each) for each in tables[team]] for team in TEAMS},
        "refusals": plain_values(result.refusals),
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
