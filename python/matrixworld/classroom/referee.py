"""The conditions that are the same for all matches, and the seats in which programs play."""

from __future__ import annotations

import queue
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from types import TracebackType

from matrixworld.classroom.limits import Limits
from matrixworld.classroom.match import Played, Seats, play_match, program_settings
from matrixworld.classroom.program import Program
from matrixworld.classroom.seat import CAN_FORK, NO_FORK, Seat
from matrixworld.classroom.submissions import Entry
from matrixworld.coevolution.types import TEAMS
from matrixworld.world.config import WorldConfig


class Referee:
    """Plays matches, several side by side, each in seats of its own.

    Parameters
    ----------
    config : WorldConfig
        The settings of the world.
    seed : int
        Seed of every match. All pairs play the same starts, so that differences between entries
        are differences in play.
    limits : Limits
        Limits of programs.
    trust : bool
        Whether programs run without a filter of system calls.
    threads : int
        Matches that are played side by side.
    programs : bool
        Whether there are programs: else no seat is made.

    Attributes
    ----------
    executor : ThreadPoolExecutor
        Its threads wait for programs and for the engine, which both work outside of Python's lock.
    problem : str
        Why programs cannot play here; empty if they can.
    """

    def __init__(
        self,
        config: WorldConfig,
        *,
        seed: int,
        limits: Limits,
        trust: bool,
        threads: int,
        programs: bool,
    ) -> None:
        self.config, self.seed, self._limits = config, seed, limits
        self.executor = ThreadPoolExecutor(threads)
        self._all: list[Seat] = []
        self._free: queue.SimpleQueue[Seats] = queue.SimpleQueue()
        self.problem = "" if CAN_FORK else NO_FORK
        if programs and CAN_FORK:
            for _ in range(threads):
                seats = {team: Seat(limits, trust) for team in TEAMS}
                self._all += seats.values()
                self._free.put(seats)
            # All of them start at the same time, and find the same.
            self.problem = "".join({seat.ready() for seat in self._all})

    def functions(self, code: bytes) -> tuple[bool, bool]:
        """Return whether a program has a function for pursuers, and one for evaders.

        Raises
        ------
        RefusedError
            If the program fails while it is loaded.
        """
        settings = program_settings(self.config, "pursuer", (self.seed, (), ()))
        with self._seats() as seats:
            program = Program(seats["pursuer"], self._limits, code, settings)
            program.close()
            return program.functions

    def match(self, pursuers: Entry, evaders: Entry, episodes: int) -> Played:
        """Play a match; FailedError if a program fails or breaks a limit."""
        with self._seats() as seats:
            return play_match(
                self.config,
                pursuers,
                evaders,
                seed=self.seed,
                episodes=episodes,
                limits=self._limits,
                seats=seats,
            )

    @contextmanager
    def _seats(self) -> Iterator[Seats]:
        """Hold a seat of each team; there are as many as threads, so no thread waits."""
        if not self._all:
            yield {}
            return
        seats = self._free.get()
        try:
            yield seats
        finally:
            self._free.put(seats)

    def __enter__(self) -> Referee:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        # The seats first: a thread that waits for a program then gets the end of the connection.
        for seat in self._all:
            seat.close()
        self.executor.shutdown(cancel_futures=True)
