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
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

import matrixworld
from class_tournament import policy_server as messages
from class_tournament.policy_server import MessageError, message, receive
from matrixworld._util.checks import check_integer, check_number
from matrixworld._util.files import one_line
from matrixworld.world.policy import Team

# ---- Limits --------------------------------------------------------------------------------------

MOST_SECONDS = 3600


def _limit(default: float, text: str) -> Any:
    return field(default=default, metadata={"help": text})


@dataclass(frozen=True)
class Limits:
    """Limits of a submitted policy; ValueError or TypeError if one is out of range."""

    seconds: int = _limit(10, "processor time of a policy in a match, in seconds")
    in_all: float = _limit(200.0, "processor time of a policy in all its matches, in seconds")
    wait: float = _limit(30.0, "time by the clock of one answer of a program, in seconds")
    clock: float = _limit(60.0, "time by the clock of all answers in a match, in seconds")
    clock_in_all: float = _limit(600.0, "the same in all matches of a program, in seconds")
    memory: int = _limit(512, "memory of a program beyond that of Python and NumPy, in MiB")

    def __post_init__(self) -> None:
        check_integer("seconds", self.seconds, 1, MOST_SECONDS)
        check_integer("memory", self.memory, 16, 1 << 20)
        for name in ("in_all", "wait", "clock", "clock_in_all"):
            check_number(name, getattr(self, name), least=0.0, positive=True)


class Used(NamedTuple):
    """Time that a policy has used, in seconds."""

    processor: float = 0.0
    clock: float = 0.0


class Rest(NamedTuple):
    """What is left of a limit, in seconds, and what is said of a policy that takes more."""

    seconds: float
    reason: str


def rest(limits: Limits, used: Sequence[Used] = ()) -> tuple[Rest, Rest]:
    """Return what a match may take of processor time, and by the clock, after those before it."""
    before = Used(*(sum(times) for times in zip(Used(), *used, strict=True)))
    return (
        _rest("of processor time", limits.seconds, limits.in_all, before.processor),
        _rest("by the clock", limits.clock, limits.clock_in_all, before.clock),
    )


def _rest(kind: str, once: float, in_all: float, before: float) -> Rest:
    if once <= in_all - before:
        return Rest(once, f"more than {once:g} seconds {kind} in a match")
    return Rest(in_all - before, f"more than {in_all:g} seconds {kind} in all matches")


# ---- The server ----------------------------------------------------------------------------------

CAN_FORK = hasattr(os, "fork") and hasattr(socket, "send_fds")
NO_FORK = "they need Linux or macOS"
HERE = Path(__file__).absolute().parent
# Nothing of matrixworld: it imports the engine.
START = """
import sys
sys.path.append(sys.argv[1])
from class_tournament.policy_server import main
main()
"""
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
                [sys.executable, "-c", START, str(HERE.parent), *["--trust"] * self._trust],
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
            with suppress(EOFError, OSError):
                return str(self._reply()["problem"])
            self._stop()
            self._start()
        return "the process that starts them has ended"

    def _reply(self) -> dict[str, Any]:
        reply = self._commands.recv(messages.LONGEST_COMMAND)
        if not reply:
            raise EOFError
        values: dict[str, Any] = json.loads(reply)
        return values

    def _asked(self, command: Mapping[str, Any], *handles: int) -> dict[str, Any]:
        """Return the reply to a command; KilledError if the server has ended."""
        try:
            socket.send_fds(self._commands, [json.dumps(command).encode()], handles)
            return self._reply()
        except (OSError, EOFError) as error:
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
        asked = message(messages.SETTINGS, json.dumps(settings).encode())
        with self._ending_on_failure():
            flags = self._answer(asked + message(messages.CODE, code), messages.READY, 2)
        self.functions = flags[0] == 1, flags[1] == 1

    def actions(self, numbers: NDArray[Any], views: NDArray[np.uint8]) -> NDArray[np.uint8]:
        """Return what the program chooses for n agents with views (n, 3, fov, fov).

        The number of an agent is the same in all steps of an episode. All actions are legal.
        """
        with self._ending_on_failure():
            content = numbers.astype(messages.NUMBER).tobytes() + views.tobytes()
            asked = message(messages.VIEWS, content)
            chosen = np.frombuffer(self._answer(asked, messages.ACTIONS, len(numbers)), np.uint8)
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
            longest = {kind: size, messages.ERROR: messages.LONGEST_ERROR}
            found, content = receive(read, longest)
        finally:
            self.used = Used(0.0, self.used.clock + time.monotonic() - began)
        if found == messages.ERROR:
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
