"""Processes that play the matches of slow games. They import the game by its name."""

from __future__ import annotations

import sys
from concurrent.futures import BrokenExecutor, Executor, Future
from contextlib import ExitStack
from functools import cache
from multiprocessing import current_process, parent_process, util
from threading import RLock
from typing import TYPE_CHECKING, Any, NamedTuple
from weakref import WeakKeyDictionary

import numpy as np

from matrixworld._util import checks
from matrixworld._util.callers import warn_caller
from matrixworld._util.processes import processes, without_interrupts
from matrixworld.coevolution.games.names import code_of, in_notebook, object_of
from matrixworld.coevolution.types import Genomes, Seeds

if TYPE_CHECKING:
    from matrixworld.coevolution.games.game import Game

PARTS = 4  # parts of the matches for each process: some take longer than others
DEATHS = 3  # processes that die in succession, without a part that ends, before it is an error


class Part(NamedTuple):
    """Matches that one process plays at a time: genomes (M, genes), seeds (M,) and episodes."""

    ones: Genomes
    others: Genomes
    seeds: Seeds
    episodes: range


def parts_of(matches: Part, count: int) -> list[Part]:
    """Return the parts of matches, about `count` of them; those of a match are adjacent."""
    parts = []
    for m in np.array_split(np.arange(len(matches.seeds)), min(count, len(matches.seeds))):
        pieces = min(-(-count // len(matches.seeds)), len(matches.episodes))
        for some in np.array_split(np.array(matches.episodes), pieces):
            episodes = range(int(some[0]), int(some[-1]) + 1)
            parts.append(Part(matches.ones[m], matches.others[m], matches.seeds[m], episodes))
    return parts


class Workers:
    """Processes for the matches of a game, started when they are first needed."""

    def __init__(self, game: Game) -> None:
        self.code = game.found_as or code_of(game)
        self.digest = game.digest
        self._lock = RLock()  # threads of this process take turns
        self._open = ExitStack()
        self._pools: dict[int, Executor] = {}
        # A process that multiprocessing has started waits at its end for those that it has started,
        # before anybody else ends them.
        util.Finalize(self, _end, (self._open, self._pools), exitpriority=1)

    def play(self, parts: list[Part], count: int) -> list[Any]:
        """Return what `Game.played` returns of each part.

        A process that dies is told by a warning, and its matches are played again; BrokenExecutor
        if that goes on. Errors of the game are raised as they are.
        """
        with self._lock:
            return self._play(parts, count)

    def _play(self, parts: list[Part], count: int) -> list[Any]:
        played: dict[int, Any] = {}
        deaths = 0
        while len(played) < len(parts):
            before = len(played)
            futures: dict[int, Future[Any]] = {}
            try:
                for number in [n for n in range(len(parts)) if n not in played]:
                    pool = self._pool(count)
                    futures[number] = pool.submit(_play, self.code, self.digest, parts[number])
                for number, future in futures.items():
                    played[number] = future.result()
            except BrokenExecutor as error:
                played |= {n: each.result() for n, each in futures.items() if _ended_well(each)}
                deaths = deaths + 1 if len(played) == before else 1
                self.close()
                if deaths == DEATHS:
                    raise BrokenExecutor(
                        f"{self.code}: expected processes that play its matches, got {deaths} that "
                        f"died in succession: {error!r}; perhaps memory has too low a limit, or a "
                        'script has no `if __name__ == "__main__":`'
                    ) from error
                warn_caller(f"{self.code}: a process has died; its matches are played again")
            except BaseException:
                for future in futures.values():
                    future.cancel()
                if not isinstance(sys.exc_info()[1], Exception):  # Ctrl-C: nobody waits for more
                    self.close(at_once=True)
                raise
        return [played[number] for number in range(len(parts))]

    def _pool(self, count: int) -> Executor:
        if count not in self._pools:
            self.close()
            with without_interrupts():
                self._pools[count] = self._open.enter_context(processes(count))
        return self._pools[count]

    def close(self, *, at_once: bool = False) -> None:
        """End the processes, `at_once` in the middle of a match."""
        with self._lock:
            _end(self._open, self._pools, sys.exc_info() if at_once else (None, None, None))


def _end(opened: ExitStack, pools: dict[int, Executor], error: Any = (None, None, None)) -> None:
    """End processes; in the middle of a match if there is an error."""
    pools.clear()
    opened.__exit__(*error)


def _ended_well(future: Future[Any]) -> bool:
    return future.done() and not future.cancelled() and future.exception() is None


_WORKERS: WeakKeyDictionary[Game, Workers | None] = WeakKeyDictionary()
"""The processes of each game that has some; None if none can import it."""


def workers_of(game: Game) -> Workers | None:
    """Return the processes of a game; None, with a warning, of one in a notebook."""
    if game not in _WORKERS:
        workers = Workers(game)
        if in_notebook(workers.code):
            warn_caller(
                f"game: expected a slow game in a module, which other processes can import, got "
                f"{workers.code}; put it into a module, or its matches are played one by one"
            )
            _WORKERS[game] = None
        else:
            _WORKERS[game] = workers
    return _WORKERS[game]


def end_workers(game: Game) -> None:
    """End the processes of a game, if it has any; the next matches start new ones."""
    if workers := _WORKERS.get(game):
        workers.close()


def play_in_processes(game: Game, matches: Part, threads: int | None) -> Any:
    """Return what `Game.played` returns of matches, which so many processes play.

    One is enough to play here, but not in a process of a job, whose run would die with a match.
    """
    count = checks.check_threads(threads)
    total = len(matches.seeds) * len(matches.episodes)
    of_job = parent_process() is not None and not current_process().daemon
    workers = workers_of(game) if min(count, total) > 1 or of_job else None
    if workers is None:
        return game.played(*matches)
    parts = parts_of(matches, PARTS * count)
    played = workers.play(parts, count)
    return _joined(parts, played)


def _joined(parts: list[Part], played: list[Any]) -> Any:
    """Return the results of all parts, by name: episodes of a match are side by side."""
    joined = {}
    for name in played[0]:
        rows: list[Any] = []
        for part, results in zip(parts, played, strict=True):
            if part.episodes.start:
                rows[-1] = np.concatenate([rows[-1], results[name]], axis=1)
            else:
                rows.append(results[name])
        joined[name] = np.concatenate(rows)
    return joined


def _play(code: str, digest: str, part: Part) -> Any:
    """Play a part in a process of `Workers`."""
    return _game(code, digest).played(*part)


@cache
def _game(code: str, digest: str) -> Game:
    """Return the game of a name; ValueError if it is another one than in the main process."""
    game: Game = object_of(code)
    if game.digest != digest:
        raise ValueError(
            f"{code}: expected the game of the process that plays, got one of another source"
        )
    return game
