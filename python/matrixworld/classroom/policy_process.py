"""The process of one submitted program during one match: it gets views and returns actions.

The process is limited before the program's first line is compiled. It knows what its agents see,
and nothing else of the world: no positions, no opponents, no seeds of the world.
"""

from __future__ import annotations

import inspect
import json
import os
import random
from collections.abc import Callable, Mapping
from types import FrameType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from matrixworld.classroom.wire import (
    ACTIONS,
    CODE,
    ERROR,
    LONGEST_ERROR,
    NUMBER,
    READY,
    SETTINGS,
    VIEWS,
    message,
    receive,
)

FUNCTIONS = {"pursuer": "pursue", "evader": "evade"}
"""The function of a program that plays for a team."""
FILE = "<submission>"
"""Name of the program in the frames of its functions."""

MODULES = (
    "abc", "array", "bisect", "cmath", "collections.abc", "contextlib", "copy", "dataclasses",
    "decimal", "enum", "fractions", "functools", "graphlib", "heapq", "itertools", "json", "math",
    "numbers", "operator", "random", "re", "statistics", "string", "struct", "textwrap", "time",
    "types", "typing", "__future__", "numpy.fft", "numpy.lib.stride_tricks", "numpy.linalg",
    "numpy.polynomial", "numpy.random", "matrixworld",
    # Not to be named by programs, but by Python while it loads one.
    "encodings.utf_8_sig", "encodings.latin_1", "encodings.cp1252",
)  # fmt: skip
"""Modules that are loaded before a program runs. It can import these, and no others."""


class PolicyError(Exception):
    """A program did not give what it had to give; the text is for its author."""


class Connection:
    """Messages of the parent, and answers to it.

    Parameters
    ----------
    handle : int
        The open connection.
    """

    def __init__(self, handle: int) -> None:
        self._handle = handle

    def receive(self, kind: bytes) -> bytes:
        """Return the content of the next message, which is of one kind."""
        return receive(self._read, {kind: 1 << 30})[1]

    def _read(self, size: int) -> bytes:
        return os.read(self._handle, size)

    def send(self, kind: bytes, content: bytes) -> None:
        """Send a message."""
        rest = message(kind, content)
        while rest:
            rest = rest[os.write(self._handle, rest) :]


def serve(handle: int) -> None:
    """Load a program and let it play until the parent ends the connection."""
    connection = Connection(handle)
    try:
        settings = json.loads(connection.receive(SETTINGS))
        functions = _load(connection.receive(CODE), settings["seed"])
        present = [name in functions for name in FUNCTIONS.values()]
        connection.send(READY, bytes(present))
        _play(connection, settings, functions)
    except EOFError:
        return
    # Whatever a program raises, also SystemExit, is the answer to the question why it failed.
    except BaseException as error:  # noqa: BLE001
        connection.send(ERROR, _explained(error))


def _load(code: bytes, seed: list[int]) -> dict[str, Any]:
    """Run a program and return its names."""
    # Programs that use the global generators are reproducible, too.
    random.seed(seed[0])
    np.random.seed(seed[0])  # noqa: NPY002
    names: dict[str, Any] = {"__name__": "submission", "__file__": FILE}
    exec(compile(code, FILE, "exec", dont_inherit=True), names)
    return names


def _play(connection: Connection, settings: Mapping[str, Any], names: Mapping[str, Any]) -> None:
    """Answer every message of views with actions."""
    function = FUNCTIONS[settings["team"]]
    view = (3, settings["fov"], settings["fov"])
    act = None
    while True:
        content = connection.receive(VIEWS)
        if act is None:  # asked for the first time: a program need not play for both teams
            act = _callable(function, names, np.random.default_rng(settings["seed"]))
        agents, views = _views(content, view)
        chosen = [
            _action(function, act(number, each), settings["n_actions"])
            for number, each in zip(agents.tolist(), views, strict=True)
        ]
        connection.send(ACTIONS, bytes(chosen))


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
    required = _required(function)
    if len(required) == 2:
        return lambda number, view: function(view, rng)
    if len(required) == 3:
        memories: dict[int, dict[Any, Any]] = {}
        return lambda number, view: function(view, rng, memories.setdefault(number, {}))
    expected = f"{name}(view, rng) or {name}(view, rng, memory)"
    raise PolicyError(f"expected {expected}, got {name}({', '.join(required)})")


def _required(function: Callable[..., Any]) -> list[str]:
    """Return the parameters of a function that have no default."""
    try:
        parameters = inspect.signature(function).parameters.values()
    except (TypeError, ValueError):  # functions of libraries may tell none
        return ["view", "rng"]
    return [each.name for each in parameters if each.default is each.empty]


def _action(name: str, value: Any, n_actions: int) -> int:
    """Return an action as an int; PolicyError if it is none."""
    if isinstance(value, np.ndarray) and value.shape == ():
        value = value.item()
    if isinstance(value, bool | np.bool_ | np.ndarray) or not hasattr(value, "__index__"):
        raise PolicyError(
            f"{name} returned {_kind(value)}, expected an action 0 to {n_actions - 1}"
        )
    action = value.__index__()
    if not 0 <= action < n_actions:
        raise PolicyError(f"{name} returned {action}, expected an action 0 to {n_actions - 1}")
    return int(action)


def _kind(value: Any) -> str:
    """Return what a program returned instead of an action, in few words."""
    if value is None:
        return "None (a return is missing)"
    if isinstance(value, np.ndarray):
        return f"an array of shape {value.shape} and dtype {value.dtype}"
    if isinstance(value, float | np.floating):
        return f"the float {float(value)!r}"
    return f"a {type(value).__name__}"


# What the author of the program reads:


def _explained(error: BaseException) -> bytes:
    """Return an error with the line of the program that caused it, as a short text."""
    try:
        return _text(error).encode(errors="replace")[:LONGEST_ERROR]
    except BaseException:  # noqa: BLE001, its message may be the program's own code, or too large
        return type(error).__name__.encode()[:LONGEST_ERROR]


def _text(error: BaseException) -> str:
    if isinstance(error, PolicyError):
        return str(error)
    if isinstance(error, SyntaxError):
        place = f"line {error.lineno}: " if error.lineno else ""
        return f"{place}SyntaxError: {error.msg}"
    line = _line(error)
    place = f"line {line}: " if line else ""
    if isinstance(error, SystemExit):
        return f"{place}the program ends itself (SystemExit)"
    if isinstance(error, MemoryError):
        return f"{place}MemoryError: more memory than the limit"
    text = str(error)[:LONGEST_ERROR]
    if isinstance(error, OSError) and error.strerror:
        text = error.strerror + (f": {error.filename!r}" if error.filename else "")
    more = next((hint for kind, hint in HINTS.items() if isinstance(error, kind)), "")
    return f"{place}{type(error).__name__}: {text}{more}"


HINTS = {
    ImportError: " (docs/class.md lists what can be imported)",
    PermissionError: " (files, network, processes and signals are not allowed)",
}
"""What is added to some errors."""


def _line(error: BaseException) -> int:
    """Return the last line of the program in an error's traceback; 0 if there is none."""
    found, trace = 0, error.__traceback__
    while trace is not None:
        frame: FrameType = trace.tb_frame
        if frame.f_code.co_filename == FILE:
            found = trace.tb_lineno
        trace = trace.tb_next
    return found


def load_modules() -> None:
    """Import what programs may import, before files cannot be read any more."""
    for name in MODULES:
        __import__(name)
