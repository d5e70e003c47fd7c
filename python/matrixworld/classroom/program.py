"""A submitted program during one match, on the side that plays: what it is told and answers."""

from __future__ import annotations

import json
import signal
import time
from collections.abc import Mapping
from types import TracebackType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from matrixworld._util.reading import one_line
from matrixworld.classroom.limits import Limits
from matrixworld.classroom.seat import End, RefusedError, Seat
from matrixworld.classroom.wire import (
    ACTIONS,
    CODE,
    ERROR,
    LONGEST_ERROR,
    NUMBER,
    READY,
    SETTINGS,
    VIEWS,
    WireError,
    message,
    receive,
)

LONGEST_REASON = 300
"""Most characters of what a program says about its own end."""


class Program:
    """A submitted program during one match.

    Parameters
    ----------
    seat : Seat
        Where it runs.
    limits : Limits
        How long it may take to answer.
    code : bytes
        The program.
    settings : mapping
        ``team``, ``fov``, ``n_actions``, and ``seed``, a list of integers.

    Attributes
    ----------
    functions : tuple of bool
        Whether the program has a function for pursuers, and one for evaders.
    seconds : float
        Processor time that it took; known when the match is over.

    Raises
    ------
    RefusedError
        If the program fails, or breaks a limit.
    """

    def __init__(
        self, seat: Seat, limits: Limits, code: bytes, settings: Mapping[str, Any]
    ) -> None:
        self._seat, self._limits = seat, limits
        self._n_actions: int = settings["n_actions"]
        self.seconds = 0.0
        self._connection = seat.connect()
        self._open = True
        with self._ending_on_failure():
            self._send(SETTINGS, json.dumps(dict(settings)).encode())
            self._send(CODE, code)
            flags = self._answer(READY, 2)
        self.functions = flags[0] == 1, flags[1] == 1

    def actions(self, numbers: NDArray[Any], views: NDArray[np.uint8]) -> NDArray[np.uint8]:
        """Return what the program chooses.

        Parameters
        ----------
        numbers : ndarray of int, shape (n,)
            A number of each agent, the same in all steps of an episode.
        views : ndarray of uint8, shape (n, 3, fov, fov)
            What they see.

        Returns
        -------
        ndarray of uint8, shape (n,)
            Legal actions.

        Raises
        ------
        RefusedError
            If the program fails, or breaks a limit.
        """
        with self._ending_on_failure():
            self._send(VIEWS, numbers.astype(NUMBER).tobytes() + views.tobytes())
            chosen = np.frombuffer(self._answer(ACTIONS, len(numbers)), np.uint8)
            # The program's process checks this, too; but that process is the program's.
            if (chosen >= self._n_actions).any():
                raise WireError(f"expected actions below {self._n_actions}")
        return chosen

    def _ending_on_failure(self) -> _Failures:
        return _Failures(self)

    def _send(self, kind: bytes, content: bytes) -> None:
        self._connection.settimeout(self._limits.wait)
        self._connection.sendall(message(kind, content))

    def _answer(self, kind: bytes, size: int) -> bytes:
        """Return an answer of an exact size; RefusedError with the program's own error."""
        last = time.monotonic() + self._limits.wait

        def read(most: int) -> bytes:
            # The time is that of the whole answer, which may come byte by byte.
            self._connection.settimeout(max(1e-3, last - time.monotonic()))
            return self._connection.recv(most)

        found, content = receive(read, {kind: size, ERROR: LONGEST_ERROR})
        if found == ERROR:
            raise RefusedError(_shortened(content.decode(errors="replace")))
        if len(content) != size:
            raise WireError(f"expected {size} bytes, got {len(content)}")
        return content

    def end(self) -> End:
        """End the process of the program, and note its time."""
        self._open = False
        self._connection.close()
        end = self._seat.end()
        self.seconds = end.seconds
        return end

    def close(self) -> None:
        """End the process of the program, if it has not ended."""
        if self._open:
            self.end()


class _Failures:
    """Ends a program's process when it fails, and raises RefusedError with the reason."""

    def __init__(self, program: Program) -> None:
        self._program = program

    def __enter__(self) -> None:
        pass

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        if error is None:
            return
        end = self._program.end()
        limits = self._program._limits
        if isinstance(error, TimeoutError):
            raise RefusedError(f"no answer within {limits.wait:g} seconds") from error
        if isinstance(error, WireError):
            raise RefusedError("wrote into the connection of its process") from error
        if isinstance(error, EOFError | ConnectionError):
            raise RefusedError(_how(end, limits)) from error


def _how(end: End, limits: Limits) -> str:
    """Return in words how a process ended that had not finished."""
    if end.code == -signal.SIGXCPU or end.seconds >= limits.seconds:
        return f"more than {limits.seconds} seconds of processor time in a match"
    if end.code < 0:
        return f"its process crashed ({signal.Signals(-end.code).name})"
    return f"ended its own process (exit code {end.code})"


def _shortened(text: str) -> str:
    line = one_line(text)
    return line if len(line) <= LONGEST_REASON else f"{line[:LONGEST_REASON]} ..."
