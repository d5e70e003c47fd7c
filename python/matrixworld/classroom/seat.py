"""The place of a program in a match: a host that makes its process, and what that answers."""

from __future__ import annotations

import json
import os
import signal
import socket
import subprocess
import sys
import sysconfig
import time
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import asdict, dataclass
from pathlib import Path
from types import TracebackType
from typing import Any

import numpy as np
from numpy.typing import NDArray

import matrixworld
from matrixworld.classroom.limits import Limits
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
from matrixworld.reading import one_line

CAN_FORK = hasattr(os, "fork") and hasattr(socket, "send_fds")
NO_FORK = "they need Linux or macOS"
LONGEST_REPLY = 4096
LONGEST_REASON = 300
"""Most characters of what a program says about its own end."""


class RefusedError(Exception):
    """A submission broke a rule or a limit; the text says which."""


@dataclass(frozen=True)
class End:
    """How a program's process ended.

    Parameters
    ----------
    code : int
        Exit code; a signal's number with a minus sign.
    seconds : float
        Processor time.
    """

    code: int
    seconds: float


class Seat:
    """A host, which makes the processes of programs one after the other.

    Parameters
    ----------
    limits : Limits
        Limits of each of them.
    trust : bool, optional
        Whether programs run without a filter of system calls. The default is False.

    Notes
    -----
    Several seats may be made at the same time: `ready` waits until one is there.
    """

    def __init__(self, limits: Limits, trust: bool = False) -> None:
        self._limits, self._trust = limits, trust
        self._closed = False
        self._start()

    def _start(self) -> None:
        self._commands, theirs = socket.socketpair()
        with theirs:
            self._host = subprocess.Popen(
                [sys.executable, "-m", "matrixworld.classroom.host", *["--trust"] * self._trust],
                stdin=theirs.fileno(),
                stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL,
                cwd=os.path.abspath(os.sep),
                env=_environment(),
                start_new_session=True,  # Ctrl-C is for the parent, which then ends the hosts
            )

    def ready(self) -> str:
        """Wait for the host; return why programs cannot be confined here, empty if they can."""
        try:
            problem: str = self._reply()["problem"]
        except RefusedError:
            return "the process that starts them has ended"
        return problem

    def _reply(self) -> dict[str, Any]:
        reply = self._commands.recv(LONGEST_REPLY)
        if not reply:
            raise RefusedError("the process that held the program was ended from outside")
        values: dict[str, Any] = json.loads(reply)
        return values

    def connect(self) -> socket.socket:
        """Return the connection to a new process."""
        ours, theirs = socket.socketpair()
        with theirs:
            socket.send_fds(
                self._commands, [json.dumps(asdict(self._limits)).encode()], [theirs.fileno()]
            )
        return ours

    def end(self) -> End:
        """End the process and return how it ended."""
        try:
            self._commands.send(b"end")
            return End(**self._reply())
        except (OSError, RefusedError):
            # The tournament was interrupted, or a trusted program has ended the host.
            if not self._closed:
                self._stop()
                self._start()
                self.ready()
            return End(-signal.SIGKILL, 0.0)

    def close(self) -> None:
        """End the host for good, and with it what it has made."""
        self._closed = True
        self._stop()

    def _stop(self) -> None:
        # A thread may wait for a reply: it gets the end of the connection.
        with suppress(OSError):
            self._commands.shutdown(socket.SHUT_RDWR)
        self._commands.close()
        self._host.wait()

    def __enter__(self) -> Seat:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()


def _environment() -> dict[str, str]:
    """Return the environment of a host: nothing of the user's."""
    kept = {name: os.environ[name] for name in ("LD_LIBRARY_PATH",) if name in os.environ}
    # Not sys.path, which may begin with the directory of the submissions: a file random.py of a
    # student would be imported by the host.
    packages = {str(Path(file).parents[1]) for file in (matrixworld.__file__, np.__file__) if file}
    own = packages - {sysconfig.get_path("purelib"), sysconfig.get_path("platlib")}
    return {
        **kept,
        "PYTHONPATH": os.pathsep.join(sorted(own)),
        "PYTHONSAFEPATH": "1",  # nor the directory where it starts; from Python 3.11 on
        "PYTHONHASHSEED": "0",  # sets of text have the same order in every match
        "OPENBLAS_NUM_THREADS": "1",
        "OMP_NUM_THREADS": "1",
        "MKL_NUM_THREADS": "1",
    }


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
