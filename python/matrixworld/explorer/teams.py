"""Teams as plain values: what a page reads of their policies, and their genomes as bytes."""

from __future__ import annotations

import zlib
from collections.abc import Sequence
from typing import Any

import numpy as np

from matrixworld.coevolution.storage import SavedRun
from matrixworld.coevolution.types import Genomes
from matrixworld.world.policy import Population, TeamPolicy
from matrixworld.world.rating import Program

MOST_BYTES = 48 * 2**20
"""Genomes of a page, in bytes; base64 adds a third. A default race has 2.9 MB."""


def step_of(runs: Sequence[SavedRun], most: int = MOST_BYTES) -> int:
    """Return the step between generations, one for all runs, whose genomes fit in `most` bytes."""
    learned = [team for run in runs for team in run.teams.values() if isinstance(team, Population)]
    longest = max((len(team.genomes) for team in learned), default=1)

    def size(step: int) -> int:
        kept = (len(kept_generations(len(team.genomes), step)) for team in learned)
        return sum(n * team.genomes[0].nbytes for n, team in zip(kept, learned, strict=True))

    return next((step for step in range(1, longest) if size(step) <= most), longest)


def kept_generations(count: int, step: int) -> list[int]:
    """Return every generation by a step, and the last one."""
    return sorted({*range(0, count, step), count - 1})


def plain_team(
    team: TeamPolicy, identifier: str, step: int, genomes: dict[str, bytes]
) -> dict[str, Any]:
    """Return a team as plain values, and add its genomes to the others."""
    if not isinstance(team, Population):
        script = team if isinstance(team, str) else None
        return {"script": script, "policy": None, "kept": [0], "genomes": ""}
    kept = kept_generations(len(team.genomes), step)
    policy, shown = team.policy, team.genomes[kept]
    genomes[identifier] = packed(shown)
    return {
        "script": None,
        "policy": plain_policy(team),
        "kept": kept,
        "genomes": identifier,
        "expressions": [policy.expression(g) for g in shown] if isinstance(policy, Program) else [],
        "words": "",
    }


def plain_policy(team: Population) -> dict[str, Any]:
    """Return the policy of a population as a page reads it, without genomes."""
    return {**team.policy.to_json(), "genome_size": team.policy.genome_size}


def packed(genomes: Genomes) -> bytes:
    """Return genomes (generations, genes) as bytes, of which a page makes the same numbers."""
    # A generation differs from the one before in the low bits of its numbers: each is joined by
    # exclusive or with that one, equal places of the float32 come together, and are compressed.
    bits = np.ascontiguousarray(genomes, dtype="<f4").view("<u4")
    bits = np.concatenate([bits[:1], bits[1:] ^ bits[:-1]])
    planes = bits.view(np.uint8).reshape(-1, bits.itemsize).T
    return zlib.compress(planes.tobytes(), 9)
