"""The results of a class tournament: standings, values for a JSON file, and the page."""

from __future__ import annotations

import zlib
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import combinations, product
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from class_tournament.submissions import Entry, Refusal
from matrixworld._util.readable import Parts, Readable, Table, plain_values
from matrixworld.analysis import Estimate
from matrixworld.analysis.intervals import UNIT, difference_over_episodes, linear_over_episodes
from matrixworld.coevolution.evaluation.scores import SCORE
from matrixworld.coevolution.types import TEAMS, Team, other
from matrixworld.explorer.page import render_page
from matrixworld.version import __version__
from matrixworld.world.config import WorldConfig

BUILT = Path(__file__).parent / "built"
"""Script and style sheet of the page, which ``npm run build`` in ``web/`` makes of ``page/``."""
ERROR = 0.05
"""Chance that the range of an entry's rank misses its true rank."""
MOST_BYTES = 8 * 2**20
"""Recordings of a page in bytes; compression leaves a third of them, or less."""

Pair = tuple[int, int]


@dataclass(frozen=True)
class Standing:
    """The place of one entry among those of its team.

    The score is the mean payoff against all opponents, with a 95 % interval over episodes: the
    capture rate of pursuers, one minus it of evaders.
    """

    entry: Entry
    number: int  # its row of the matrix, or its column
    score: Estimate
    ranks: tuple[int, int] | None  # the best and the worst that it may have; None for a script
    best: int  # the opponent against which its payoff is highest
    worst: int

    @property
    def rank(self) -> str:
        """The rank as text, such as "3" or "2 to 5"; empty for a script."""
        if self.ranks is None:
            return ""
        first, last = self.ranks
        return str(first) if first == last else f"{first} to {last}"


@dataclass(frozen=True, eq=False, repr=False)
class ClassResult(Readable):
    """A tournament of P pursuers and E evaders; what broke a rule while it played is refused."""

    config: WorldConfig
    seed: int  # the secret from which all random numbers of the tournament come
    match_seed: int  # of all worlds
    entries: dict[Team, tuple[Entry, ...]]  # scripts come last
    refusals: tuple[Refusal, ...]
    capture_rates: NDArray[np.float64]  # (P, E, episodes)
    lengths: NDArray[np.int64]  # (P, E, episodes), in steps
    recordings: dict[Pair, NDArray[np.uint8]]  # all actions of each first episode, (steps, A)
    votes: dict[str, dict[str, int]] = field(default_factory=dict)  # by prediction and choice

    @cached_property
    def standings(self) -> dict[Team, list[Standing]]:
        """The students and scripts of each team, the highest score first.

        Entries with equal scores are in the order of the submissions.
        """
        return {team: _standings(self.entries[team], self.payoffs(team)) for team in TEAMS}

    def payoffs(self, team: Team) -> NDArray[np.float64]:
        """Return the payoffs of a team, (entries, opponents, episodes)."""
        rates = self.capture_rates
        return rates if team == "pursuer" else 1.0 - rates.transpose(1, 0, 2)

    def _parts(self) -> Parts:
        parts: list[str | Table] = []
        for team, rows in self.standings.items():
            opponents = len(self.entries[other(team)])
            parts += [
                f"\nThe {team}s: mean {SCORE[team]} against all {opponents} opponents",
                [
                    ("rank", "name", "", "mean and 95 % interval"),
                    *((r.rank or "-", r.entry.name, r.entry.kind, str(r.score)) for r in rows),
                ],
            ]
        if self.refusals:
            parts.append(f"\nRefused ({len(self.refusals)})")
            parts += [f"  {each.file}: {each.reason}" for each in self.refusals]
        return parts


# ---- Standings -----------------------------------------------------------------------------------


def _standings(entries: Sequence[Entry], payoffs: NDArray[np.float64]) -> list[Standing]:
    means = payoffs.mean(axis=2)
    students = [number for number, entry in enumerate(entries) if entry.kind != "script"]
    ranks = dict(zip(students, rank_ranges(payoffs[students]), strict=True))
    standings = [
        Standing(
            entry,
            number,
            score=linear_over_episodes(
                payoffs[number : number + 1], lambda means: float(means.mean()), bounds=UNIT
            ),
            ranks=ranks.get(number),
            best=int(means[number].argmax()),
            worst=int(means[number].argmin()),
        )
        for number, entry in enumerate(entries)
    ]
    return sorted(standings, key=lambda standing: -standing.score.value)


def rank_ranges(payoffs: NDArray[np.float64]) -> list[tuple[int, int]]:
    """Return the best and the worst rank that each of n entries may have.

    Payoffs are (n, opponents, episodes) in [0, 1]; episode e of all cells has the same start. The
    best rank is 1 + the number of entries that are surely better, the worst one n minus the number
    of those that are surely worse: the interval of the difference does not include 0.

    Mogstad, Romano, Shaikh and Wilhelm (2024), "Inference for ranks with applications to mobility
    across neighbourhoods and academic achievement across countries": each of the n - 1 differences
    of an entry has an interval of level ``1 - ERROR / (n - 1)``, so that all of them hold at once
    with a probability of at least 0.95; then so does the range.
    """
    n = len(payoffs)
    signs = np.zeros((n, n), int)
    for one, two in combinations(range(n), 2):
        signs[one, two] = _surely(payoffs[one], payoffs[two], 1.0 - ERROR / (n - 1))
    signs -= signs.T
    return [(1 + int((row < 0).sum()), n - int((row > 0).sum())) for row in signs]


def _surely(one: NDArray[np.float64], two: NDArray[np.float64], level: float) -> int:
    """Return 1 if one entry is surely better than another, -1 if worse, 0 if nobody can tell."""
    difference = linear_over_episodes(
        np.stack([one, two]), lambda means: float(means[0].mean() - means[1].mean()), level=level
    )
    if difference.low is None:
        # Equal differences in all episodes have no t interval; this one needs no variation.
        difference = difference_over_episodes(one.mean(axis=0), two.mean(axis=0), level=level)
    return difference.sign


# ---- The file and the page -----------------------------------------------------------------------


def class_json(result: ClassResult) -> dict[str, Any]:
    """Return a tournament as values that JSON can hold, with the results of all episodes."""
    return {
        **_summary(result),
        "capture_rates": result.capture_rates.tolist(),
        "lengths": result.lengths.tolist(),
    }


def _summary(result: ClassResult) -> dict[str, Any]:
    return {
        "matrixworld": __version__,
        "world": result.config.to_json(),
        # As text: a number of JavaScript holds 53 of the 64 bits.
        "seed": str(result.seed),
        "match_seed": str(result.match_seed),
        "episodes": result.capture_rates.shape[2],
        "names": {team: [entry.name for entry in result.entries[team]] for team in TEAMS},
        "standings": {team: list(map(_row, rows)) for team, rows in result.standings.items()},
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


def class_page(result: ClassResult, *, title: str, most: int = MOST_BYTES) -> str:
    """Return the page of a class tournament as HTML.

    It holds `most` bytes of recordings: the best and the worst match of each entry come first.
    """
    kept = _chosen(result, most)
    rows, columns, _ = result.capture_rates.shape
    data = {
        **_summary(result),
        "title": title,
        "capture_rate": _rounded(result.capture_rates.mean(axis=2)),
        "lowest": _rounded(result.capture_rates.min(axis=2)),
        "highest": _rounded(result.capture_rates.max(axis=2)),
        "length": _rounded(result.lengths.mean(axis=2)),
        "first": _rounded(result.capture_rates[:, :, 0]),
        "steps": [
            [len(result.recordings[g, h]) if (g, h) in kept else -1 for h in range(columns)]
            for g in range(rows)
        ],
    }
    # An action a byte, row by row of the matrix.
    actions = b"".join(result.recordings[pair].tobytes() for pair in sorted(kept))
    blobs = {"recordings": zlib.compress(actions, 9)}
    return render_page("class", f"{title} - matrixworld", data, blobs, folder=BUILT)


def _rounded(values: NDArray[np.floating[Any]]) -> Any:
    return plain_values(np.round(values, 4))


def _chosen(result: ClassResult, most: int) -> set[Pair]:
    """Return the pairs whose recordings are on the page, as many as fit."""
    wanted: list[Pair] = []
    for standing in result.standings["pursuer"]:
        wanted += [(standing.number, standing.best), (standing.number, standing.worst)]
    for standing in result.standings["evader"]:
        wanted += [(standing.best, standing.number), (standing.worst, standing.number)]
    rows, columns, _ = result.capture_rates.shape
    wanted += product(range(rows), range(columns))
    kept: set[Pair] = set()
    for pair in dict.fromkeys(wanted):
        if result.recordings[pair].nbytes <= most:
            kept.add(pair)
            most -= result.recordings[pair].nbytes
    return kept
