"""The tournament of a class: every pursuer that was handed in against every evader.

Every submission is read, loaded and tried first. What breaks a rule is left out, and its matches
count for no one. The world is played here: a program gets the views of its agents and returns
actions, whatever it does in its own process.
"""

from __future__ import annotations

import hashlib
import json
import queue
import secrets
import signal
import threading
from collections import defaultdict
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack, closing, contextmanager
from functools import wraps
from itertools import compress, product
from pathlib import Path
from typing import Any, NamedTuple, ParamSpec, TypeVar

import numpy as np
from numpy.typing import NDArray

from class_tournament import submissions
from class_tournament.policy_process import (
    CAN_FORK,
    NO_FORK,
    KilledError,
    Limits,
    PolicyProcess,
    PolicyServer,
    RefusedError,
    Used,
    rest,
)
from class_tournament.policy_server import FUNCTIONS
from class_tournament.results import ClassResult
from class_tournament.submissions import Entry, Refusal, Submission
from class_tournament.votes import count_votes
from matrixworld._util.checks import SEED_MAX, check_integer, check_threads
from matrixworld.coevolution.progress import Progress, Report, silent
from matrixworld.coevolution.types import TEAMS, Team, other
from matrixworld.play.matches import Chooser, play_episodes
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import Script, TeamPolicy

SCRIPTS: dict[Team, tuple[Script, ...]] = {
    "pursuer": ("random", "chaser", "hunter"),
    "evader": ("random", "fleer", "dodger"),
}
"""The package's scripts that take part, for comparison."""
TRIAL_OPPONENT: Script = "random"
"""The script against which every program plays an episode first."""


def play_class(
    directory: Path,
    config: WorldConfig,
    *,
    seed: int | None = None,
    episodes: int = 10,
    limits: Limits | None = None,
    trust: bool = False,
    threads: int | None = None,
    report: Report = silent,
) -> ClassResult:
    """Play all pairs of a directory of submissions, at least 2 `episodes` each.

    `seed` is the secret of a tournament, which repeats it; by default one is drawn, so that no
    program can know the starts before. With `trust` programs run without a filter of system calls.
    `threads` matches are played side by side, by default one for each core; the result does not
    depend on it. ValueError if nothing can play and there are no predictions.
    """
    check_integer("episodes", episodes, 2)
    threads = check_threads(threads)
    seed = secrets.randbits(63) if seed is None else check_integer("seed", seed, 0, SEED_MAX)
    files, refusals = submissions.read_submissions(directory)
    policies = [file for file in files if file.kind != "predictions"]
    votes, spoilt = _votes([file for file in files if file.kind == "predictions"])
    programs = any(file.kind == "program" for file in policies)
    pool = MatchPool(
        config, seed, limits or Limits(), trust=trust, threads=threads, programs=programs
    )
    with _one_interruption(), closing(pool):
        students, refused = admit(policies, pool, report)
        teams = {team: _with_scripts(students, team) for team in TEAMS}
        played, failed = _round_robin(teams, pool, episodes, report)
    refusals += [*spoilt, *refused]
    refusals += [Refusal(entry.name, entry.file, reason) for entry, reason in failed.items()]
    if not (votes or any(entry not in failed for entry in students)):
        reasons = "".join(f"\n  {refusal.file}: {refusal.reason}" for refusal in refusals)
        raise ValueError(f"{directory}: expected a submission that can play, got none{reasons}")
    kept = {team: tuple(e for e in teams[team] if e not in failed) for team in TEAMS}
    shape = len(kept["pursuer"]), len(kept["evader"])
    matches = [played[pair] for pair in product(kept["pursuer"], kept["evader"])]
    return ClassResult(
        config,
        seed,
        pool.match_seed,
        kept,
        tuple(sorted(refusals, key=lambda refusal: (refusal.file, refusal.reason))),
        np.reshape([match.capture_rates for match in matches], (*shape, episodes)),
        np.reshape([match.lengths for match in matches], (*shape, episodes)),
        dict(zip(np.ndindex(shape), (match.actions for match in matches), strict=True)),
        votes,
    )


def _votes(files: Sequence[Submission]) -> tuple[dict[str, dict[str, int]], list[Refusal]]:
    """Return the votes on predictions of the course, and the files that do not count."""
    if not files:
        return {}, []
    known = [(submissions.folded(file.name), file.file, file.content) for file in files]
    votes, reasons = count_votes(known)
    return votes, [Refusal(f.name, f.file, reasons[f.file]) for f in files if f.file in reasons]


def derived(seed: int, *parts: object) -> int:
    """Return a seed of 64 bits from the secret of a tournament and what the seed is for.

    SHA-256: who has one of them, as a program has that of its `rng`, cannot tell the secret.
    """
    digest = hashlib.sha256(json.dumps([seed, *parts]).encode()).digest()
    return int.from_bytes(digest[:8], "little")


@contextmanager
def _one_interruption() -> Iterator[None]:
    """Let the first Ctrl-C interrupt, and no second one the end of all that was started."""
    before = signal.getsignal(signal.SIGINT)

    def interrupt(*given: Any) -> None:
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        before(*given)  # type: ignore[misc, operator]

    with ExitStack() as stack:
        if callable(before) and threading.current_thread() is threading.main_thread():
            stack.callback(signal.signal, signal.SIGINT, before)
            signal.signal(signal.SIGINT, interrupt)
        yield


# ---- Matches -------------------------------------------------------------------------------------

Pair = tuple[Entry, Entry]
P = ParamSpec("P")
Result = TypeVar("Result")


def tried_twice(work: Callable[P, Result]) -> Callable[P, Result]:
    """Do work again if a process was killed: a program that did so itself does it again."""

    @wraps(work)
    def work_or_again(*args: P.args, **options: P.kwargs) -> Result:
        try:
            return work(*args, **options)
        except KilledError:
            return work(*args, **options)

    return work_or_again


class Played(NamedTuple):
    """The result of a match."""

    capture_rates: NDArray[np.float64]  # (episodes,)
    lengths: NDArray[np.int64]  # (episodes,), in steps
    actions: NDArray[np.uint8]  # (steps, A), of the first episode


class MatchPool:
    """Plays matches, several side by side.

    All pairs play the same starts, those of the seed, so that differences between entries are
    differences in play. The threads of `executor` wait for programs and for the engine, which both
    work outside of Python's lock. `problem` says why programs cannot play here; `used` tells what
    each entry has used of its limits, match by match.
    """

    def __init__(
        self,
        config: WorldConfig,
        seed: int,
        limits: Limits,
        *,
        trust: bool,
        threads: int,
        programs: bool,
    ) -> None:
        self.config, self.limits, self._seed = config, limits, seed
        self.match_seed = derived(seed, "worlds")
        self.executor = ThreadPoolExecutor(threads)
        self.used: defaultdict[Entry, list[Used]] = defaultdict(list)
        # As many as threads, so that no thread waits.
        count = threads if programs and CAN_FORK else 0
        self._servers = [PolicyServer(limits, trust) for _ in range(count)]
        self._free: queue.SimpleQueue[PolicyServer] = queue.SimpleQueue()
        for server in self._servers:
            self._free.put(server)
        # All of them start at the same time, and find the same.
        problem = "".join({server.ready() for server in self._servers})
        self.problem = problem if CAN_FORK else NO_FORK

    def close(self) -> None:
        """End all that was started, also where a match is played."""
        # The servers first: a thread that waits for a program gets the end of the connection.
        for server in self._servers:
            server.close()
        self.executor.shutdown(cancel_futures=True)

    @contextmanager
    def _server(self) -> Iterator[PolicyServer]:
        server = self._free.get()
        try:
            yield server
        finally:
            self._free.put(server)

    @tried_twice
    def functions(self, code: bytes) -> tuple[bool, bool]:
        """Return whether a program has a function for pursuers, and one for evaders.

        RefusedError if it fails while it is loaded.
        """
        with self._server() as server:
            program = PolicyProcess(server, code, self._settings("pursuer"))
            program.close()
            return program.functions

    @tried_twice
    def play(self, pursuers: Entry, evaders: Entry, episodes: int) -> Played:
        """Play a match; RefusedError if a program fails or an entry breaks a limit.

        The result depends on entries, seed and world only, as long as programs do so, too.
        """
        entries = pursuers, evaders
        lengths, steps = np.zeros(episodes, np.int64), []
        rests = [rest(self.limits, self.used[entry]) for entry in entries]
        taken = [0.0, 0.0]  # by what decides in the engine

        def record_round(actions: NDArray[np.int64], running: NDArray[np.bool_]) -> None:
            lengths[running] += 1
            if running[0]:
                steps.append(actions[0].astype(np.uint8))

        def count(number: int, seconds: float) -> None:
            taken[number] += seconds
            processor, _ = rests[number]
            if entries[number].kind == "genome" and taken[number] > processor.seconds:
                raise RefusedError(processor.reason, TEAMS[number])

        programs: dict[Entry, PolicyProcess] = {}
        choosers: list[TeamPolicy | Chooser] = []
        with ExitStack() as stack:
            if any(entry.kind == "program" for entry in entries):
                server = stack.enter_context(self._server())
            for team, entry in zip(TEAMS, entries, strict=True):
                if not isinstance(entry.policy, bytes):
                    choosers.append(entry.policy)
                    continue
                settings = self._settings(team, pursuers.key, evaders.key)
                program = PolicyProcess(server, entry.policy, settings, *self.used[entry])
                stack.callback(program.close)
                programs[entry] = program
                choosers.append(_asking(program))
            rates = play_episodes(
                self.config, *choosers, seed=self.match_seed, episodes=episodes,
                on_round=record_round, on_decision=count, threads=1,
            )  # fmt: skip
        for entry, seconds in zip(entries, taken, strict=True):
            self.used[entry].append(programs[entry].used if entry in programs else Used(seconds))
        return Played(rates, lengths, np.stack(steps))

    def order(self, pair: Pair) -> int:
        """Return the place of a pair in an order that only the secret tells.

        Otherwise a program could tell its opponent from how much was played before.
        """
        return derived(self._seed, "order", *(entry.key for entry in pair))

    def _settings(self, team: Team, *keys: str) -> dict[str, object]:
        """Return what a program's process is told: its team, the form of views, its own seed."""
        return {
            "team": team,
            "fov": self.config.fov,
            "n_actions": self.config.n_actions,
            # Of what plays, not of its place in the class: it stays the same if others join.
            "seed": derived(self._seed, "program", team, *keys),
        }


def _asking(program: PolicyProcess) -> Chooser:
    return lambda asked, views: program.actions(np.flatnonzero(asked), views)


# ---- Who may play --------------------------------------------------------------------------------


def admit(
    files: Sequence[Submission], pool: MatchPool, report: Report
) -> tuple[list[Entry], list[Refusal]]:
    """Return the entries of submissions, at most one for each student and team, and refusals."""
    entries: list[Entry] = []
    refusals: list[Refusal] = []
    trials = pool.executor.map(lambda file: _trial(file, pool), files)
    for number, outcomes in enumerate(trials, 1):
        entries += [outcome for outcome in outcomes if isinstance(outcome, Entry)]
        refusals += [outcome for outcome in outcomes if isinstance(outcome, Refusal)]
        report(Progress("trials", number, len(files)))
    kept, rivals = submissions.without_rivals(entries)
    return kept, refusals + rivals


def _trial(submission: Submission, pool: MatchPool) -> list[Entry | Refusal]:
    """Return an entry for each team for which a submission can play, or why it cannot."""
    name, file, kind, content, path = submission
    try:
        if kind == "genome":
            team, population = submissions.read_genome(path, content)
            population.policy.check_fits("genome", pool.config)
            return [Entry(name, team, "genome", file, population)]
        if pool.problem:
            raise RefusedError(f"programs are not played here: {pool.problem}")
        functions = pool.functions(content)
        if not any(functions):
            expected = "expected a function pursue(view, rng) or evade(view, rng)"
            raise RefusedError(f"{expected}, got none")
    except (RefusedError, ValueError) as error:
        return [Refusal(name, file, submissions.reason_of(error))]
    entries = [Entry(name, team, "program", file, content) for team in compress(TEAMS, functions)]
    return [_after_trial(entry, pool) for entry in entries]


def _after_trial(entry: Entry, pool: MatchPool) -> Entry | Refusal:
    """Let a program play an episode."""
    opponent = Entry(TRIAL_OPPONENT, other(entry.team), "script", "", TRIAL_OPPONENT)
    try:
        pool.play(*((entry, opponent) if entry.team == "pursuer" else (opponent, entry)), 1)
    except RefusedError as error:
        return Refusal(entry.name, entry.file, _reason(entry, error))
    return entry


def _reason(entry: Entry, error: RefusedError) -> str:
    """Return why an entry is refused, for a program beginning with its function."""
    text, function = str(error), FUNCTIONS[entry.team]
    named = entry.kind == "genome" or text.startswith(f"{function} ")
    return text if named else f"{function}: {text}"


# ---- All pairs -----------------------------------------------------------------------------------


def _with_scripts(students: Sequence[Entry], team: Team) -> tuple[Entry, ...]:
    scripts = (Entry(name, team, "script", "", name) for name in SCRIPTS[team])
    return (*(entry for entry in students if entry.team == team), *scripts)


def _round_robin(
    teams: dict[Team, tuple[Entry, ...]], pool: MatchPool, episodes: int, report: Report
) -> tuple[dict[Pair, Played], dict[Entry, str]]:
    """Play all pairs; return the results, and by entry why it broke a rule while it played.

    Pairs of an entry that broke a rule are left out from then on.
    """
    played: dict[Pair, Played] = {}
    failed: dict[Entry, str] = {}
    pool.used.clear()  # without the trials

    def play(pair: Pair) -> Played | RefusedError | None:
        if any(entry in failed for entry in pair):
            return None
        try:
            return pool.play(*pair, episodes)
        except RefusedError as error:
            return error

    pairs = sorted(product(teams["pursuer"], teams["evader"]), key=pool.order)
    # In the order of the pairs: the first failure of an entry is the same with any threads.
    results = zip(pairs, pool.executor.map(play, pairs), strict=True)
    for number, (pair, result) in enumerate(results, 1):
        if isinstance(result, RefusedError):
            entry, rival = pair if result.team == "pursuer" else reversed(pair)
            reason = f"{_reason(entry, result)} (while it played against {rival.name})"
            failed.setdefault(entry, reason)
        elif result is not None:
            played[pair] = result
            for entry in pair:
                for seconds, reason in rest(pool.limits, pool.used[entry]):
                    if seconds < 0.0 and entry.kind != "script":
                        failed.setdefault(entry, reason)
        report(Progress("round robin", number * episodes, len(pairs) * episodes))
    return played, failed
