"""The place of a program in a match: a host, which makes a process for each program."""

from __future__ import annotations

import json
import os
import signal
import socket
import subprocess
import sys
import sysconfig
from contextlib import suppress
from dataclasses import asdict, dataclass
from pathlib import Path
from types import TracebackType
from typing import Any

import numpy as np

import matrixworld
from matrixworld.classroom.limits import Limits

CAN_FORK = hasattr(os, "fork") and hasattr(socket, "send_fds")
NO_FORK = "they need Linux or macOS"
LONGEST_REPLY = 4096


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
        command = json.dumps(asdict(self._limits)).encode()
        try:
            with theirs:
                socket.send_fds(self._commands, [command], [theirs.fileno()])
        except OSError:  # the tournament was interrupted
            ours.close()
            raise
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
