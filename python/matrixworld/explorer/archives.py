"""The teams of a run for a page: their networks, and genomes within a limit of size."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from matrixworld.coevolution.storage.saved_run import SavedRun
from matrixworld.coevolution.types import TEAMS, Team
from matrixworld.world.policy import Network, Population, TeamPolicy

MOST_BYTES = 48 * 2**20
"""Genomes of a page, in bytes; base64 adds a third. A default race has 2.9 MB."""


@dataclass(frozen=True)
class Archives:
    """The teams of the runs of a page.

    Parameters
    ----------
    teams : tuple of dict
        For each run its two teams as plain values, by name.
    blobs : dict of str to bytes
        Genomes, float32 in little-endian order and generation after generation, by the identifier
        that ``teams`` names.
    step : int
        Of the generations, every so many have a genome on the page; 1 if all do.
    """

    teams: tuple[dict[Team, dict[str, Any]], ...]
    blobs: dict[str, bytes]
    step: int


def archives_of(runs: Sequence[SavedRun], most: int = MOST_BYTES) -> Archives:
    """Return the teams of runs, with the genomes of as many generations as fit.

    Parameters
    ----------
    runs : sequence of SavedRun
        The runs.
    most : int, optional
        Bytes of all genomes together.

    Returns
    -------
    Archives
        The first and the last generation of each team are always there.
    """
    step = 1
    # The step is the same for all runs, so that linked generations exist everywhere.
    while _size(runs, step) > most and step < _longest(runs):
        step += 1
    blobs: dict[str, bytes] = {}
    teams = tuple(
        {team: _plain_team(run.teams[team], f"genomes-{n}-{team}", step, blobs) for team in TEAMS}
        for n, run in enumerate(runs)
    )
    return Archives(teams, blobs, step)


def kept_generations(count: int, step: int) -> list[int]:
    """Return every generation by a step, and the last one."""
    return sorted({*range(0, count, step), count - 1})


def _size(runs: Sequence[SavedRun], step: int) -> int:
    return sum(
        len(kept_generations(len(team.genomes), step)) * team.genomes[0].nbytes
        for team in _learned(runs)
    )


def _longest(runs: Sequence[SavedRun]) -> int:
    return max(len(team.genomes) for team in _learned(runs))


def _learned(runs: Sequence[SavedRun]) -> list[Population]:
    """Return the archives of all runs; teams that are scripts have none."""
    return [team for run in runs for team in run.teams.values() if isinstance(team, Population)]


def generations_of(team: TeamPolicy) -> int:
    """Return the number of generations in an archive; 1 for a script."""
    return 1 if isinstance(team, str) else len(team.genomes)


def _plain_team(
    team: TeamPolicy, identifier: str, step: int, blobs: dict[str, bytes]
) -> dict[str, Any]:
    """Return a team as plain values, and add its genomes to the blobs."""
    if isinstance(team, str):
        return {"script": team, "network": None, "generations": 1, "kept": [0], "genomes": ""}
    kept = kept_generations(len(team.genomes), step)
    blobs[identifier] = np.ascontiguousarray(team.genomes[kept], dtype="<f4").tobytes()
    return {
        "script": None,
        "network": plain_network(team.network),
        "generations": len(team.genomes),
        "kept": kept,
        "genomes": identifier,
    }


def plain_network(network: Network) -> dict[str, Any]:
    """Return the shape of a network as plain values."""
    return {
        "hidden": list(network.hidden),
        "activation": network.activation,
        "fov": network.fov,
        "n_actions": network.n_actions,
        "sampled": network.sampled,
        "genome_size": network.genome_size,
    }
