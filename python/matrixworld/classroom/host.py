"""A process that makes the processes of submitted programs, one at a time, each limited and fresh.

It has imported NumPy and the package, and a fork of it is ready in milliseconds. It never sees a
program: that travels from the parent to the fork, after the fork has given up all rights. Commands
come over a connection; if that ends, because the parent has ended in whatever way, the fork is
killed and the host ends.

Run as ``python -m matrixworld.classroom.host``, with the connection as standard input.
"""

from __future__ import annotations

import gc
import json
import os
import signal
import socket
import sys
from contextlib import suppress
from typing import Any

from matrixworld.classroom import limits, policy_process, system_calls
from matrixworld.classroom.limits import Limits

CONNECTION = 3
"""The only open file of a program's process beside /dev/null, which is 0, 1 and 2."""
LONGEST_COMMAND = 4096
NOT_CONFINED = "files can still be opened in spite of the filter"


def main() -> None:
    """Make processes until the parent ends the connection."""
    trust = "--trust" in sys.argv
    policy_process.load_modules()
    commands = socket.socket(fileno=os.dup(0))
    commands.send(json.dumps({"problem": "" if trust else _problem()}).encode())
    gc.freeze()  # pages that no collection writes to are shared by all forks
    while True:
        command, handles, _, _ = socket.recv_fds(commands, LONGEST_COMMAND, 1)
        if not command:
            return
        with socket.socket(fileno=handles[0]) as connection:
            child = os.fork()
            if not child:
                _be_program(connection.fileno(), Limits(**json.loads(command)), trust)
        # The next word comes when the match is over; none comes if the parent has ended.
        commands.recv(LONGEST_COMMAND)
        commands.send(json.dumps(_ended(child)).encode())


def _ended(child: int) -> dict[str, Any]:
    """End a process with all that it may have started, and return how it ended and its time."""
    for end in (os.killpg, os.kill):
        # It may have no group yet, or have ended.
        with suppress(PermissionError, ProcessLookupError):
            end(child, signal.SIGKILL)
    _, status, used = os.wait4(child, 0)
    code = os.waitstatus_to_exitcode(status)
    return {"code": code, "seconds": used.ru_utime + used.ru_stime}


def _be_program(connection: int, allowed: Limits, trust: bool) -> None:
    """Give up all rights and play; this process does not return."""
    try:
        os.environ.clear()
        os.setsid()
        system_calls.end_with_parent(signal.SIGKILL)
        nothing = os.open(os.devnull, os.O_RDWR)
        for handle in (0, 1, 2):
            os.dup2(nothing, handle)
        os.dup2(connection, CONNECTION)
        os.closerange(CONNECTION + 1, os.sysconf("SC_OPEN_MAX"))
        sys.stdin = None
        sys.stdout = sys.stderr = open(1, "w", encoding="utf-8", errors="replace", closefd=False)  # noqa: SIM115
        limits.apply(allowed, None if trust else CONNECTION + 1)
        if not trust:
            system_calls.restrict()
        policy_process.serve(CONNECTION)
    finally:
        # Not sys.exit: nothing of the host may be done twice.
        os._exit(0)


def _problem() -> str:
    """Return why programs cannot be confined here; empty if they can."""
    readable, writable = os.pipe()
    if not os.fork():
        try:
            system_calls.restrict()
            os.open(os.devnull, os.O_RDONLY)
            os.write(writable, NOT_CONFINED.encode())
        except PermissionError:
            pass  # as it has to be; installing the filter raises other errors
        except OSError as error:
            os.write(writable, (error.strerror or str(error)).encode())
        finally:
            os._exit(0)
    os.close(writable)
    with open(readable, encoding="utf-8") as text:
        return text.read()


if __name__ == "__main__":
    main()
