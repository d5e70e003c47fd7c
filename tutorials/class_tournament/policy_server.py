"""The processes of submitted programs: a server that forks them, and what each of them does.

The server has imported NumPy, so a fork of it is ready in milliseconds. Beside it, it has this file
and `sandbox`; worlds, engine and scripts are not in its memory. It never sees a
program nor its seed: these travel from the parent to the fork, after the fork has given up all
rights. Commands come over a connection, which is the server's standard input. If it ends, because
the parent has ended in whatever way, the forks are killed and the server ends.

A fork plays one match of one program. It knows what the program's agents see, and nothing else of
the world: no positions, no opponents, no seeds but its own, from which no other follows.
"""

from __future__ import annotations

import builtins
import gc
import inspect
import json
import os
import random
import signal
import socket
import struct
import sys
from collections.abc import Callable, Mapping
from contextlib import suppress
from traceback import walk_tb
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from class_tournament.sandbox import end_with_parent, filter_system_calls, set_limits

# ---- Messages ------------------------------------------------------------------------------------
#
# A message is its kind (one byte), its length (four bytes, little-endian) and its content. A reader
# knows which kinds may come and how long they may be; anything else ends the connection. Nothing is
# unpickled or evaluated.

SETTINGS, CODE, VIEWS = b"S", b"C", b"V"  # to the program's process
READY, ACTIONS, ERROR = b"R", b"A", b"E"  # from it

HEAD = struct.Struct("<cI")
LONGEST_ERROR = 2000
"""Most bytes of a text that a program's process may send."""
LONGEST_COMMAND = 4096
NUMBER = "<u4"
"""Dtype of the numbers of agents in a message of views."""


class MessageError(Exception):
    """The other side sent something that is no message, or not the expected one."""


def message(kind: bytes, content: bytes) -> bytes:
    """Return a message as bytes."""
    return HEAD.pack(kind, len(content)) + content


def receive(read: Callable[[int], bytes], longest: Mapping[bytes, int]) -> tuple[bytes, bytes]:
    """Return kind and content of the next message.

    `read` returns at most so many bytes, and none at the end of the connection: EOFError. A kind
    that is not in `longest`, or a longer content, is a MessageError; the content is not read.
    """
    kind, size = HEAD.unpack(_exactly(read, HEAD.size))
    if size > longest.get(kind, -1):
        raise MessageError(f"expected {sorted(longest)}, got {kind!r} with {size} bytes")
    return kind, _exactly(read, size)


def _exactly(read: Callable[[int], bytes], size: int) -> bytes:
    parts, left = [], size
    while left:
        part = read(min(left, 1 << 20))
        if not part:
            raise EOFError
        parts.append(part)
        left -= len(part)
    return b"".join(parts)


# ---- The server ----------------------------------------------------------------------------------

MODULES = (
    "abc", "array", "bisect", "cmath", "collections.abc", "contextlib", "copy", "dataclasses",
    "decimal", "enum", "fractions", "functools", "graphlib", "heapq", "itertools", "json", "math",
    "numbers", "operator", "random", "re", "statistics", "string", "struct", "textwrap", "time",
    "types", "typing", "__future__", "numpy.char", "numpy.fft", "numpy.lib.stride_tricks",
    "numpy.linalg", "numpy.ma", "numpy.polynomial", "numpy.random", "numpy.rec", "numpy.strings",
    "numpy.typing",
)  # fmt: skip
"""Modules that are loaded before a program runs. It can import these, and no others."""
UNNAMED = (
    "encodings.utf_8_sig", "encodings.latin_1", "encodings.cp1252", "numpy._core._exceptions",
    "numpy._core._dtype", "numpy._core._internal", "numpy._core._methods",
)  # fmt: skip
"""Modules that Python and NumPy import later, when no file can be opened any more."""
ROOTS = frozenset(name.partition(".")[0] for name in MODULES)
CONNECTION = 3
"""The only open file of a program's process beside /dev/null, which is 0, 1 and 2."""
NOT_CONFINED = "files can still be opened in spite of the filter"


def main() -> None:
    """Start and end processes, each under the name of a team, until the parent has ended."""
    trust = "--trust" in sys.argv
    for name in (*MODULES, *UNNAMED):
        __import__(name)
    # For `from numpy import *`: the names that are missing here would be imported from files.
    np.__all__ = [name for name in np.__all__ if name in vars(np)]
    commands = socket.socket(fileno=os.dup(0))
    commands.send(json.dumps({"problem": "" if trust else _problem()}).encode())
    gc.freeze()  # pages that no collection writes to are shared by all forks
    children: dict[str, int] = {}
    while True:
        command, handles, _, _ = socket.recv_fds(commands, LONGEST_COMMAND, 1)
        if not command:
            break
        given, reply = json.loads(command), {}
        if handles:
            with socket.socket(fileno=handles[0]) as connection:
                children[given["name"]] = child = os.fork()
                if not child:
                    _be_program(connection.fileno(), trust, given["limits"])
        else:
            reply = _ended(children.pop(given["name"]))
        commands.send(json.dumps(reply).encode())
    for child in children.values():
        _ended(child)


def _ended(child: int) -> dict[str, Any]:
    """End a process with all that it may have started, and return how it ended and its time."""
    for end in (os.killpg, os.kill):
        # It may have no group yet, or have ended.
        with suppress(PermissionError, ProcessLookupError):
            end(child, signal.SIGKILL)
    _, status, used = os.wait4(child, 0)
    return {"code": os.waitstatus_to_exitcode(status), "seconds": used.ru_utime + used.ru_stime}


def _be_program(connection: int, trust: bool, limits: Mapping[str, int]) -> None:
    """Give up all rights and play; this process does not return."""
    try:
        os.environ.clear()
        os.setsid()
        end_with_parent(signal.SIGKILL)
        nothing = os.open(os.devnull, os.O_RDWR)
        for handle in (0, 1, 2):
            os.dup2(nothing, handle)
        os.dup2(connection, CONNECTION)
        os.closerange(CONNECTION + 1, os.sysconf("SC_OPEN_MAX"))
        sys.stdin = None
        sys.stdout = sys.stderr = open(1, "w", encoding="utf-8", errors="replace", closefd=False)  # noqa: SIM115
        set_limits(**limits, files=None if trust else CONNECTION + 1)
        if not trust:
            filter_system_calls()
        _play(trust)
    finally:
        # Not sys.exit: nothing of the server may be done twice.
        os._exit(0)


def _problem() -> str:
    """Return why programs cannot be confined here; empty if they can."""
    readable, writable = os.pipe()
    if not os.fork():
        try:
            filter_system_calls()
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


# ---- A program -----------------------------------------------------------------------------------

FUNCTIONS = {"pursuer": "pursue", "evader": "evade"}
"""The function of a program that plays for a team."""
FILE = "<submission>"
"""Name of the program in the frames of its functions."""


class PolicyError(Exception):
    """A program did not give what it had to give; the text is for its author."""


def _play(trust: bool) -> None:
    """Load a program and let it play until the parent ends the connection."""
    try:
        settings = json.loads(_receive(SETTINGS))
        names = _names(_receive(CODE), settings["seed"], __import__ if trust else _import)
        _send(READY, bytes(name in names for name in FUNCTIONS.values()))
        _answer_views(settings, names)
    except EOFError:
        return
    # Whatever a program raises, also SystemExit, is the answer to the question why it failed.
    except BaseException as error:  # noqa: BLE001
        _send(ERROR, _explained(error))


def _receive(kind: bytes) -> bytes:
    return receive(lambda size: os.read(CONNECTION, size), {kind: 1 << 30})[1]


def _send(kind: bytes, content: bytes) -> None:
    rest = message(kind, content)
    while rest:
        rest = rest[os.write(CONNECTION, rest) :]


def _import(name: str, *others: Any, **named: Any) -> ModuleType:
    """Import a module on the list; NumPy, too, imports its late parts as the program that calls.

    The list helps honest programs. What holds the others is the filter, and that nothing in this
    process is worth finding.
    """
    if name.partition(".")[0] not in ROOTS:
        raise ModuleNotFoundError(f"{name} cannot be imported")
    return __import__(name, *others, **named)


def _names(code: bytes, seed: int, importing: Callable[..., ModuleType]) -> dict[str, Any]:
    # Programs that use the global generators are reproducible, too.
    random.seed(seed)
    np.random.seed(seed % 2**32)  # noqa: NPY002
    # As a module that is imported, which a dataclass looks for.
    sys.modules["submission"] = module = ModuleType("submission")
    names = vars(module)
    names["__file__"] = FILE
    names["__builtins__"] = {**vars(builtins), "__import__": importing}
    exec(compile(code, FILE, "exec", dont_inherit=True), names)
    return names


def _answer_views(settings: Mapping[str, Any], names: Mapping[str, Any]) -> None:
    function = FUNCTIONS[settings["team"]]
    act = None
    while True:
        content = _receive(VIEWS)
        if act is None:  # asked for the first time: a program need not play for both teams
            act = _callable(function, names, np.random.default_rng(settings["seed"]))
        agents, views = _views(content, (3, settings["fov"], settings["fov"]))
        chosen = [
            _action(function, act(number, each), settings["n_actions"])
            for number, each in zip(agents.tolist(), views, strict=True)
        ]
        _send(ACTIONS, bytes(chosen))


def _views(
    content: bytes, view: tuple[int, int, int]
) -> tuple[NDArray[np.uint32], NDArray[np.uint8]]:
    """Return the numbers of n agents, and what they see, (n, 3, fov, fov)."""
    size = np.dtype(NUMBER).itemsize
    n = len(content) // (size + int(np.prod(view)))
    numbers = np.frombuffer(content, NUMBER, n)
    # A copy: the function may write into what it gets.
    return numbers, np.frombuffer(content, np.uint8, offset=n * size).reshape(n, *view).copy()


Act = Callable[[int, NDArray[np.uint8]], Any]


def _callable(name: str, names: Mapping[str, Any], rng: np.random.Generator) -> Act:
    """Return the program's function as one of the number of an agent and of its view."""
    function = names.get(name)
    if not callable(function):
        raise PolicyError(f"expected a function {name}(view, rng), got none")
    signature = inspect.signature(function)
    memories: dict[int, dict[Any, Any]] = {}
    plays_with_two = _takes(signature, 2)
    if _takes(signature, 3) and ("memory" in signature.parameters or not plays_with_two):
        return lambda number, view: function(view, rng, memories.setdefault(number, {}))
    if plays_with_two:
        return lambda number, view: function(view, rng)
    expected = f"{name}(view, rng) or {name}(view, rng, memory)"
    raise PolicyError(f"expected {expected}, got {name}{signature}")


def _takes(signature: inspect.Signature, count: int) -> bool:
    """Return whether a function can be called with so many arguments."""
    try:
        signature.bind(*range(count))
    except TypeError:
        return False
    return True


def _action(name: str, value: Any, n_actions: int) -> int:
    expected = f"expected an action 0 to {n_actions - 1}"
    if isinstance(value, np.ndarray) and value.shape == ():
        value = value.item()
    if isinstance(value, bool | np.bool_ | np.ndarray) or not hasattr(value, "__index__"):
        raise PolicyError(f"{name} returned {_described(value)}, {expected}")
    action = value.__index__()
    if not 0 <= action < n_actions:
        raise PolicyError(f"{name} returned {action}, {expected}")
    return int(action)


def _described(value: Any) -> str:
    """Return what a program returned instead of an action, in few words."""
    if value is None:
        return "None (a return is missing)"
    if isinstance(value, np.ndarray):
        return f"an array of shape {value.shape} and dtype {value.dtype}"
    if isinstance(value, float | np.floating):
        return f"the float {float(value)!r}"
    return f"a {type(value).__name__}"


HINTS = {
    ImportError: " (class_tournament/README.md lists what can be imported)",
    PermissionError: " (files, network, processes and signals are not allowed)",
}
"""What is added to some errors."""


def _explained(error: BaseException) -> bytes:
    """Return an error with the line of the program that caused it, as a short text."""
    try:
        return _text(error).encode(errors="replace")[:LONGEST_ERROR]
    except BaseException:  # noqa: BLE001, its message may be the program's own code, or too large
        return type(error).__name__.encode()[:LONGEST_ERROR]


def _text(error: BaseException) -> str:
    if isinstance(error, PolicyError):
        return str(error)
    line = error.lineno if isinstance(error, SyntaxError) else _line(error)
    place = f"line {line}: " if line else ""
    if isinstance(error, SyntaxError):
        return f"{place}SyntaxError: {error.msg}"
    if isinstance(error, SystemExit):
        return f"{place}the program ends itself (SystemExit)"
    if isinstance(error, MemoryError):
        return f"{place}MemoryError: more memory than the limit"
    text = str(error)[:LONGEST_ERROR]
    if isinstance(error, OSError) and error.strerror:
        text = error.strerror + (f": {error.filename!r}" if error.filename else "")
    more = next((hint for kind, hint in HINTS.items() if isinstance(error, kind)), "")
    return f"{place}{type(error).__name__}{': ' * bool(text)}{text}{more}"


def _line(error: BaseException) -> int:
    """Return the last line of the program in an error's traceback; 0 if there is none."""
    frames = walk_tb(error.__traceback__)
    lines = [line for frame, line in frames if frame.f_code.co_filename == FILE]
    return lines[-1] if lines else 0
