"""The tournament: every pursuer of a class against every evader.

Every submission is read, loaded and tried first. What breaks a rule is left out, and its matches
count for no one.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager, closing, nullcontext
from dataclasses import dataclass, field
from itertools import product
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from matrixworld._util.checks import check_integer, check_threads
from matrixworld._util.files import DamagedFileError
from matrixworld.classroom.match import MatchPool, Played
from matrixworld.classroom.policy_process import RefusedError
from matrixworld.classroom.policy_server import FUNCTIONS
from matrixworld.classroom.sandbox import Limits
from matrixworld.classroom.submissions import (
    Entry,
    Refusal,
    Submission,
    genome_of,
    read_submissions,
    without_path,
    without_rivals,
)
from matrixworld.coevolution.progress import Report, silent
from matrixworld.coevolution.types import TEAMS, Team, other
from matrixworld.play.network_policy import check_fits
from matrixworld.play.rollout import match_seed
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import Script

SCRIPTS: dict[Team, tuple[Script, ...]] = {
    "pursuer": ("random", "chaser", "hunter"),
    "evader": ("random", "fleer", "dodger"),
}
"""The package's scripts that take part, for comparison."""
TRIAL_OPPONENT: Script = "random"
"""The script against which every program plays an episode first."""


@dataclass(frozen=True, eq=False)
class ClassResult:
    """A tournament of P pursuers and E evaders; what broke a rule while it played is refused."""

    config: WorldConfig
    seed: int  # `match_seed` of it is that of every match
    entries: dict[Team, tuple[Entry, ...]]  # scripts come last
    refusals: tuple[Refusal, ...]
    capture_rates: NDArray[np.float64]  # (P, E, episodes)
    lengths: NDArray[np.int64]  # (P, E, episodes), in steps
    recordings: dict[tuple[int, int], NDArray[np.uint8]] = field(repr=False)
    """All actions of the first episode of each pair, (steps, A)."""


def play_class(
    directory: Path,
    config: WorldConfig,
    *,
    seed: int = 0,
    episodes: int = 10,
    limits: Limits | None = None,
    trust: bool = False,
    threads: int | None = None,
    progress: Callable[[str], AbstractContextManager[Report]] = lambda unit: nullcontext(silent),
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
    limits = limits or Limits()
    submissions, unreadable = read_submissions(directory)
    pool = MatchPool(
        config,
        seed=match_seed(seed),
        limits=limits,
        trust=trust,
        threads=check_threads(threads),
        programs=any(each.kind == "program" for each in submissions),
    )
    with closing(pool):
        with progress("submissions") as report:
            students, refused = admit(submissions, pool, report)
        refusals = [*unreadable, *refused]
        _require(students, refusals, directory)
        with progress("episodes") as report:
            played = _RoundRobin(students, limits)
            played.play(pool, episodes, report)
    refusals += [Refusal(each.name, each.file, reason) for each, reason in played.failed.items()]
    _require([each for each in students if each not in played.failed], refusals, directory)
    return played.result(config, seed, refusals)


def _require(students: Sequence[Entry], refusals: Sequence[Refusal], directory: Path) -> None:
    """Raise ValueError with all reasons if there is no entry of a student."""
    if not students:
        reasons = "".join(f"\n  {each.file}: {each.reason}" for each in refusals)
        raise ValueError(f"{directory}: expected a submission that can play, got none{reasons}")


# ---- Who may play --------------------------------------------------------------------------------

Admitted = tuple[list[Entry], list[Refusal]]


def admit(submissions: Sequence[Submission], pool: MatchPool, report: Report) -> Admitted:
    """Return the entries of submissions, at most one for each student and team, and refusals."""
    entries: list[Entry] = []
    refusals: list[Refusal] = []
    tried = pool.executor.map(lambda each: _entries_of(each, pool), submissions)
    for number, (found, refused) in enumerate(tried, 1):
        entries += found
        refusals += refused
        report("trials", number, len(submissions))
    kept, rivals = without_rivals(entries)
    return kept, refusals + rivals


def _entries_of(submission: Submission, pool: MatchPool) -> Admitted:
    """Return the entries of one submission, or why it is refused."""
    try:
        if submission.kind == "genome":
            return [_genome(submission, pool.config)], []
        return _program(submission, pool)
    except RefusedError as error:
        return [], [Refusal(submission.name, submission.file, str(error))]


def _genome(submission: Submission, config: WorldConfig) -> Entry:
    """Read a genome; RefusedError if it is damaged or does not fit the world."""
    try:
        team, population = genome_of(submission.path, submission.content)
        check_fits("genome", population.network, config)
    except DamagedFileError as error:
        raise RefusedError(without_path(error)) from error
    except ValueError as error:
        raise RefusedError(str(error)) from error
    return Entry(submission.name, team, "genome", submission.file, population)


def _program(submission: Submission, pool: MatchPool) -> Admitted:
    """Load a program, and let it play an episode for each team for which it has a function."""
    if pool.problem:
        raise RefusedError(f"programs are not played here: {pool.problem}")
    present = pool.functions(submission.content)
    if not any(present):
        raise RefusedError("expected a function pursue(view, rng) or evade(view, rng), got none")
    entries: list[Entry] = []
    refusals: list[Refusal] = []
    for team, is_present in zip(TEAMS, present, strict=True):
        if not is_present:
            continue
        entry = Entry(submission.name, team, "program", submission.file, submission.content)
        opponent = Entry(TRIAL_OPPONENT, other(team), "script", "", TRIAL_OPPONENT)
        try:
            pool.play(*((entry, opponent) if team == "pursuer" else (opponent, entry)), 1)
            entries.append(entry)
        except RefusedError as error:
            refusals.append(Refusal(entry.name, entry.file, _reason(entry, error)))
    return entries, refusals


def _reason(entry: Entry, error: RefusedError) -> str:
    """Return why an entry is refused, beginning with its function."""
    text, function = str(error), FUNCTIONS[entry.team]
    return text if text.startswith(f"{function} ") else f"{function}: {text}"


# ---- All pairs -----------------------------------------------------------------------------------


class _RoundRobin:
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
        self._seconds: defaultdict[Entry, float] = defaultdict(float)  # of processor time
        self.failed: dict[Entry, str] = {}

    def play(self, pool: MatchPool, episodes: int, report: Report) -> None:
        """Play all pairs; those of an entry that broke a rule are left out from then on."""

        def play(entries: tuple[Entry, ...]) -> Played | RefusedError | None:
            if any(entry in self.failed for entry in entries):
                return None
            try:
                return pool.play(entries[0], entries[1], episodes)
            except RefusedError as error:
                return error

        teams = [self._entries[team] for team in TEAMS]
        pairs = list(product(*(range(len(entries)) for entries in teams)))
        # In the order of the pairs: the first failure of an entry is the same with any threads.
        for number, found in enumerate(pool.executor.map(play, product(*teams))):
            self._add(pairs[number], found)
            report("round robin", (number + 1) * episodes, len(pairs) * episodes)

    def _add(self, pair: tuple[int, ...], found: Played | RefusedError | None) -> None:
        entries = {team: self._entries[team][n] for team, n in zip(TEAMS, pair, strict=True)}
        if isinstance(found, RefusedError):
            assert found.team is not None
            entry, rival = entries[found.team], entries[other(found.team)]
            reason = f"{_reason(entry, found)} (in the match against {rival.name})"
            self.failed.setdefault(entry, reason)
        elif found is not None:
            self._played[pair[0], pair[1]] = found
            most = self._limits.in_all
            for team, seconds in found.seconds.items():
                self._seconds[entries[team]] += seconds
                if self._seconds[entries[team]] > most:
                    limit = f"more than {most:g} seconds of processor time in all matches"
                    self.failed.setdefault(entries[team], limit)

    def result(self, config: WorldConfig, seed: int, refusals: Sequence[Refusal]) -> ClassResult:
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
