"""A submitted program during one match, on the side that plays: what it is told and answers."""

from __future__ import annotations

import json
import math
import os
import signal
import socket
import subprocess
import sys
import sysconfig
import time
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import matrixworld
from matrixworld._util.files import one_line
from matrixworld.classroom.policy_server import (
    ACTIONS,
    CODE,
    ERROR,
    LONGEST_COMMAND,
    LONGEST_ERROR,
    NUMBER,
    READY,
    SETTINGS,
    VIEWS,
    MessageError,
    message,
    receive,
)
from matrixworld.classroom.sandbox import Limits, Used, rest
from matrixworld.coevolution.types import Team

CAN_FORK = hasattr(os, "fork") and hasattr(socket, "send_fds")
NO_FORK = "they need Linux or macOS"
PLACE = os.path.join(Path(matrixworld.__path__[0]).parent, "")
# Empty packages with the paths of ours: the server gets the files that it names, and no engine.
START = """
import sys, types
for name in sys.argv[1].split():
    sys.modules[name] = types.ModuleType(name)
    sys.modules[name].__path__ = [sys.argv[2] + name.replace(".", "/")]
from matrixworld.classroom.policy_server import main
for name in sys.argv[1].split():
    del sys.modules[name]
main()
"""
EMPTY = "matrixworld matrixworld._util matrixworld.classroom"
LONGEST_REASON = 300
"""Most characters of what a program says about its own end."""


class RefusedError(Exception):
    """A submission broke a rule or a limit; the text says which.

    `team` is the team for which it played; None where it did not play.
    """

    def __init__(self, reason: str, team: Team | None = None) -> None:
        super().__init__(reason)
        self.team = team


class KilledError(RefusedError):
    """A program's process was killed, perhaps from outside: the match is worth another try."""


class PolicyServer:
    """A process that makes the processes of the two programs of a match.

    Several may start at the same time: `ready` waits until this one is there. A server that was
    killed is started anew for the next program.
    """

    def __init__(self, limits: Limits, trust: bool = False) -> None:
        self.limits, self._trust = limits, trust
        self._is_lost = self._is_closed = False
        self._start()

    def _start(self) -> None:
        self._commands, theirs = socket.socketpair()
        with theirs:
            self._process = subprocess.Popen(
                [sys.executable, "-c", START, EMPTY, PLACE, *["--trust"] * self._trust],
                stdin=theirs.fileno(),
                stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL,
                cwd=os.path.abspath(os.sep),
                env=_environment(),
                start_new_session=True,  # Ctrl-C is for the parent, which then ends the servers
            )

    def ready(self) -> str:
        """Wait for the server; return why programs cannot be confined here, empty if they can."""
        for _ in range(2):
            with suppress(KilledError, OSError):
                return str(self._reply()["problem"])
            self._stop()
            self._start()
        return "the process that starts them has ended"

    def _reply(self) -> dict[str, Any]:
        reply = self._commands.recv(LONGEST_COMMAND)
        if not reply:
            raise KilledError("the process that held the program was killed")
        values: dict[str, Any] = json.loads(reply)
        return values

    def _asked(self, command: Mapping[str, Any], *handles: int) -> dict[str, Any]:
        """Return the reply to a command; KilledError if the server has ended."""
        try:
            socket.send_fds(self._commands, [json.dumps(command).encode()], handles)
            return self._reply()
        except (OSError, KilledError) as error:
            self._is_lost = True
            raise KilledError("the process that held the program was killed") from error

    def connect(self, name: str, seconds: float) -> socket.socket:
        """Return the connection to a new process, which has so many seconds of processor time."""
        if self._is_lost and not self._is_closed:
            self._stop()
            self._start()
            self.ready()
            self._is_lost = False
        ours, theirs = socket.socketpair()
        limits = {"seconds": max(1, math.ceil(seconds)), "memory": self.limits.memory}
        with theirs:
            try:
                self._asked({"name": name, "limits": limits}, theirs.fileno())
            except KilledError:  # or the tournament was interrupted
                ours.close()
                raise
        return ours

    def end(self, name: str) -> tuple[int, float]:
        """End a process; return its exit code (-n: by signal n), and its processor time."""
        end = self._asked({"name": name})
        return end["code"], end["seconds"]

    def close(self) -> None:
        """End the server for good, and with it what it has made."""
        self._is_closed = True
        self._stop()

    def _stop(self) -> None:
        # A thread may wait for a reply: it gets the end of the connection.
        with suppress(OSError):
            self._commands.shutdown(socket.SHUT_RDWR)
        self._commands.close()
        self._process.wait()


def _environment() -> dict[str, str]:
    """Return the environment of a server: nothing of the user's."""
    kept = {name: os.environ[name] for name in ("LD_LIBRARY_PATH",) if name in os.environ}
    # Not sys.path, which may begin with the directory of the submissions: a file random.py of a
    # student would be imported by the server.
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


class PolicyProcess:
    """A submitted program during one match; RefusedError if it fails or breaks a limit.

    Settings are ``team``, ``fov``, ``n_actions``, and ``seed``. `functions` says whether it has one
    for pursuers, and one for evaders; `used` is known when the match is over.
    """

    def __init__(
        self, server: PolicyServer, code: bytes, settings: Mapping[str, Any], *before: Used
    ) -> None:
        self._server = server
        self._team: Team = settings["team"]
        self._n_actions: int = settings["n_actions"]
        self.used = Used()
        self._processor, self._clock = rest(server.limits, before)
        self._connection = server.connect(self._team, self._processor.seconds)
        self._is_open = True
        told = message(SETTINGS, json.dumps(settings).encode()) + message(CODE, code)
        with self._ending_on_failure():
            flags = self._answer(told, READY, 2)
        self.functions = flags[0] == 1, flags[1] == 1

    def actions(self, numbers: NDArray[Any], views: NDArray[np.uint8]) -> NDArray[np.uint8]:
        """Return what the program chooses for n agents with views (n, 3, fov, fov).

        The number of an agent is the same in all steps of an episode. All actions are legal.
        """
        with self._ending_on_failure():
            asked = message(VIEWS, numbers.astype(NUMBER).tobytes() + views.tobytes())
            chosen = np.frombuffer(self._answer(asked, ACTIONS, len(numbers)), np.uint8)
            # The program's process checks this, too; but that process is the program's.
            if (chosen >= self._n_actions).any():
                raise MessageError(f"expected actions below {self._n_actions}")
        return chosen

    @contextmanager
    def _ending_on_failure(self) -> Iterator[None]:
        """End the process if it fails, and raise RefusedError with the reason."""
        try:
            yield
        except (TimeoutError, MessageError, EOFError, ConnectionError) as error:
            raise self._refused(error) from error
        except BaseException:
            self.close()
            raise

    def _refused(self, error: Exception) -> RefusedError:
        """End a process that had not finished, and return in words why it failed."""
        try:
            code = self._end()
        except KilledError as killed:
            return KilledError(str(killed), self._team)
        if isinstance(error, TimeoutError):
            wait = f"no answer within {self._server.limits.wait:g} seconds"
            is_over = self.used.clock >= self._clock.seconds
            return RefusedError(self._clock.reason if is_over else wait, self._team)
        if isinstance(error, MessageError):
            return RefusedError("wrote into the connection of its process", self._team)
        if code == -signal.SIGXCPU or self.used.processor >= self._processor.seconds:
            return RefusedError(self._processor.reason, self._team)
        if code == -signal.SIGKILL:
            return KilledError("its process was killed", self._team)
        if code < 0:
            return RefusedError(f"its process crashed ({signal.Signals(-code).name})", self._team)
        return RefusedError(f"ended its own process (exit code {code})", self._team)

    def _answer(self, asked: bytes, kind: bytes, size: int) -> bytes:
        """Send a message and return its answer of an exact size; RefusedError with its error."""
        began = time.monotonic()
        wait = min(self._server.limits.wait, self._clock.seconds - self.used.clock)

        def read(most: int) -> bytes:
            # The time is that of the whole answer, which may come byte by byte.
            self._connection.settimeout(max(1e-3, began + wait - time.monotonic()))
            return self._connection.recv(most)

        try:
            self._connection.settimeout(max(1e-3, wait))
            self._connection.sendall(asked)
            found, content = receive(read, {kind: size, ERROR: LONGEST_ERROR})
        finally:
            self.used = Used(0.0, self.used.clock + time.monotonic() - began)
        if found == ERROR:
            line = one_line(content.decode(errors="replace")) or "failed without a message"
            short = line if len(line) <= LONGEST_REASON else f"{line[:LONGEST_REASON]} ..."
            raise RefusedError(short, self._team)
        if len(content) != size:
            raise MessageError(f"expected {size} bytes, got {len(content)}")
        return content

    def _end(self) -> int:
        """End the process of the program, and note its processor time; return its exit code."""
        self._is_open = False
        self._connection.close()
        code, seconds = self._server.end(self._team)
        self.used = self.used._replace(processor=seconds)
        return code

    def close(self) -> None:
        """End the process of the program, if it has not ended."""
        if self._is_open:
            with suppress(KilledError):  # the answers of the match are there
                self._end()
