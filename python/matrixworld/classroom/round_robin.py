"""The tournament: every pursuer of a class against every evader."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass, field
from itertools import product
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from matrixworld._util.checks import check_integer, check_threads
from matrixworld.classroom.admission import admit, reason_of
from matrixworld.classroom.limits import Limits
from matrixworld.classroom.match import FailedError, Played
from matrixworld.classroom.referee import Referee
from matrixworld.classroom.submissions import Entry, Refusal, read_submissions
from matrixworld.coevolution.progress import Report
from matrixworld.coevolution.types import TEAMS, Team, other
from matrixworld.play.seeds import match_seed
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import Script

SCRIPTS: dict[Team, tuple[Script, ...]] = {
    "pursuer": ("random", "chaser", "hunter"),
    "evader": ("random", "fleer", "dodger"),
}
"""The package's scripts that take part, for comparison."""


@dataclass(frozen=True, eq=False)
class ClassResult:
    """A class tournament.

    Parameters
    ----------
    config : WorldConfig
        The settings of the world.
    seed : int
        The seed of the tournament; ``match_seed(seed)`` is that of every match.
    entries : dict of str to tuple of Entry
        What played for the ``"pursuer"`` and for the ``"evader"`` team: P and E of them. Scripts
        come last.
    refusals : tuple of Refusal
        What did not play, or broke a rule while it played, and why.
    capture_rates : ndarray of float64, shape (P, E, episodes)
        Capture rate of each episode.
    lengths : ndarray of int64, shape (P, E, episodes)
        Steps of each episode.
    recordings : dict of (int, int) to ndarray
        All actions of the first episode of each pair, uint8 (steps, A).
    """

    config: WorldConfig
    seed: int
    entries: dict[Team, tuple[Entry, ...]]
    refusals: tuple[Refusal, ...]
    capture_rates: NDArray[np.float64]
    lengths: NDArray[np.int64]
    recordings: dict[tuple[int, int], NDArray[np.uint8]] = field(repr=False)


def play_class(
    directory: Path,
    config: WorldConfig,
    *,
    seed: int = 0,
    episodes: int = 10,
    limits: Limits | None = None,
    trust: bool = False,
    threads: int | None = None,
    progress: Callable[[str], AbstractContextManager[Report]] = lambda unit: nullcontext(_silent),
) -> ClassResult:
    """Play the tournament of a directory of submissions.

    Parameters
    ----------
    directory : Path
        Holds ``NAME.py`` and ``NAME.npz``, or directories ``NAME`` with such files.
    config : WorldConfig
        The settings of the world.
    seed : int, optional
        The seed of the tournament. The default is 0.
    episodes : int, optional
        Episodes of each pair, at least 2. The default is 10.
    limits : Limits, optional
        Limits of programs. The default is ``Limits()``.
    trust : bool, optional
        Whether programs run without a filter of system calls: only for programs that you have read.
        The default is False.
    threads : int, optional
        Matches that are played side by side. The default is one for each core. The result does not
        depend on it.
    progress : callable, optional
        Takes the unit of a part of the work and returns a context, which gives a function
        ``report(what, done, total)``. By default nothing is reported.

    Returns
    -------
    ClassResult
        Results of all pairs of entries that broke no rule.

    Raises
    ------
    OSError
        If the directory cannot be read.
    ValueError
        If it holds nothing that can play, or an argument is out of range.
    """
    check_integer("episodes", episodes, 2)
    check_integer("seed", seed, 0)
    submissions, unreadable = read_submissions(directory)
    with Referee(
        config,
        seed=match_seed(seed),
        limits=limits or Limits(),
        trust=trust,
        threads=check_threads(threads),
        programs=any(each.kind == "program" for each in submissions),
    ) as referee:
        with progress("submissions") as report:
            students, refused = admit(submissions, referee, report)
        refusals = [*unreadable, *refused]
        _require(students, refusals, directory)
        with progress("episodes") as report:
            results = _Results(students, limits or Limits())
            results.play(referee, episodes, report)
    refusals += results.refusals
    _require([each for each in students if each not in results.failed], refusals, directory)
    return results.all(config, seed, refusals)


def _silent(what: str, done: int, total: int) -> None:
    """Report nothing."""


def _require(students: Sequence[Entry], refusals: Sequence[Refusal], directory: Path) -> None:
    """Raise ValueError with all reasons if there is no entry of a student."""
    if not students:
        reasons = "".join(f"\n  {each.file}: {each.reason}" for each in refusals)
        raise ValueError(f"{directory}: expected a submission that can play, got none{reasons}")


class _Results:
    """The results of all pairs, and the entries that broke a rule while they played."""

    def __init__(self, students: Sequence[Entry], limits: Limits) -> None:
        self._entries: dict[Team, list[Entry]] = {
            team: [
                *(entry for entry in students if entry.team == team),
                *(Entry(name, team, "script", "", name) for name in SCRIPTS[team]),
            ]
            for team in TEAMS
        }
        self._limits = limits
        self._played: dict[tuple[int, int], Played] = {}
        self._seconds: dict[Entry, float] = {}
        self.failed: dict[Entry, str] = {}

    def play(self, referee: Referee, episodes: int, report: Report) -> None:
        """Play all pairs; those of an entry that broke a rule are left out from then on."""
        counts = len(self._entries["pursuer"]), len(self._entries["evader"])
        pairs = list(product(range(counts[0]), range(counts[1])))

        def play(pair: tuple[int, int]) -> Played | FailedError | None:
            pursuers, evaders = self._of(pair)
            if pursuers in self.failed or evaders in self.failed:
                return None
            try:
                return referee.match(pursuers, evaders, episodes)
            except FailedError as error:
                return error

        # In the order of the pairs: the first failure of an entry is the same with any threads.
        for number, found in enumerate(referee.executor.map(play, pairs)):
            self._note(pairs[number], found)
            report("round robin", (number + 1) * episodes, len(pairs) * episodes)

    def _of(self, pair: tuple[int, int]) -> tuple[Entry, Entry]:
        return self._entries["pursuer"][pair[0]], self._entries["evader"][pair[1]]

    def _note(self, pair: tuple[int, int], found: Played | FailedError | None) -> None:
        entries = dict(zip(TEAMS, self._of(pair), strict=True))
        if isinstance(found, FailedError):
            entry, rival = (entries[team] for team in (found.team, other(found.team)))
            reason = f"{reason_of(entry, found)} (in the match against {rival.name})"
            self.failed.setdefault(entry, reason)
        elif found is not None:
            self._played[pair] = found
            for team, seconds in found.seconds.items():
                self._count(entries[team], seconds)

    def _count(self, entry: Entry, seconds: float) -> None:
        """Add up the processor time of an entry."""
        self._seconds[entry] = self._seconds.get(entry, 0.0) + seconds
        if self._seconds[entry] > self._limits.in_all:
            limit = f"more than {self._limits.in_all:g} seconds of processor time in all matches"
            self.failed.setdefault(entry, limit)

    @property
    def refusals(self) -> list[Refusal]:
        """Why entries that had been admitted were refused later."""
        return [Refusal(each.name, each.file, reason) for each, reason in self.failed.items()]

    def all(self, config: WorldConfig, seed: int, refusals: Sequence[Refusal]) -> ClassResult:
        """Return the results of the entries that broke no rule."""
        kept = {
            team: [n for n, entry in enumerate(entries) if entry not in self.failed]
            for team, entries in self._entries.items()
        }
        played = {
            (row, column): self._played[g, h]
            for row, g in enumerate(kept["pursuer"])
            for column, h in enumerate(kept["evader"])
        }
        shape = len(kept["pursuer"]), len(kept["evader"]), -1
        return ClassResult(
            config,
            seed,
            {team: tuple(self._entries[team][n] for n in kept[team]) for team in TEAMS},
            tuple(sorted(refusals, key=lambda each: (each.file, each.reason))),
            np.stack([each.capture_rates for each in played.values()]).reshape(shape),
            np.stack([each.lengths for each in played.values()]).reshape(shape),
            {pair: each.actions for pair, each in played.items()},
        )
