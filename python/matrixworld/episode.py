"""One recorded episode, as arrays, in memory and on disk."""

from __future__ import annotations

import io
import json
import os
import zipfile
import zlib
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field, fields
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np
from numpy.typing import NDArray

FORMAT = "matrixworld episode 2"  # marks a saved file; a new layout, a new number

N_ACTIONS = 9  # stay and eight directions

# What reading a damaged npz file raises: AttributeError and TypeError when it is another kind of
# NumPy file, RuntimeError when a flag of the zip archive is altered.
_UNREADABLE = (
    AttributeError,
    EOFError,
    KeyError,
    OSError,
    RuntimeError,
    TypeError,
    ValueError,
    zipfile.BadZipFile,
    zlib.error,
)
# Shape and dtype of each array. T is the number of steps, S = T + 1 that of moments.
_ARRAYS: dict[str, tuple[str, str]] = {
    "positions": ("S A 2", "int32"),
    "last_positions": ("S A 2", "int32"),
    "alive": ("S A", "bool"),
    "captured": ("S E", "bool"),
    "ever_captured": ("S E", "bool"),
    "actions": ("T A", "int8"),
    "rewards": ("T A", "float32"),
    "involved": ("T A 3", "bool"),
    "fault": ("T A 3", "bool"),
    "map": ("rows cols", "bool"),
}
# The world's arrays that a recording keeps, at each moment and of each step. The actions are not
# the world's: whoever plays knows them.
MOMENT_ARRAYS = tuple(name for name, (shape, _) in _ARRAYS.items() if shape.startswith("S"))
STEP_ARRAYS = tuple(
    name for name, (shape, _) in _ARRAYS.items() if shape.startswith("T") and name != "actions"
)


@dataclass(frozen=True, eq=False)
class Episode:
    """An episode of T steps, of P pursuers and E evaders, A = P + E agents, pursuers first.

    positions: ``(T + 1, A, 2)`` int32, row and column, (-1, -1) when gone
    last_positions: the same; of agents that are gone, where they went
    alive: ``(T + 1, A)`` bool
    captured, ever_captured: ``(T + 1, E)`` bool, at the moment and so far
    actions: ``(T, A)`` int8
    rewards: ``(T, A)`` float32
    involved, fault: ``(T, A, 3)`` bool, collisions of a step by kind (obstacle, teammate,
        adversary)
    map: ``(rows, cols)`` bool, True for an obstacle
    n_pursuers: P
    config: the settings of the world, as plain values that JSON can hold

    Step t (an entry of actions, rewards, involved, fault) leads from moment t to moment t + 1 (of
    positions, alive, captured, ever_captured). Raises TypeError for another dtype, ValueError for
    another shape and for an action of a living agent outside 0 to 8.
    """

    positions: NDArray[np.int32]
    last_positions: NDArray[np.int32]
    alive: NDArray[np.bool_]
    captured: NDArray[np.bool_]
    ever_captured: NDArray[np.bool_]
    actions: NDArray[np.int8]
    rewards: NDArray[np.float32]
    involved: NDArray[np.bool_]
    fault: NDArray[np.bool_]
    map: NDArray[np.bool_]
    n_pursuers: int
    config: Mapping[str, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        for name, (_, dtype) in _ARRAYS.items():
            array = getattr(self, name)
            if not isinstance(array, np.ndarray) or array.dtype != dtype:
                got = getattr(array, "dtype", type(array).__name__)
                raise TypeError(f"{name}: expected an array of {dtype}, got {got}")
        self._check_shapes()
        played = self.actions[self.alive[:-1]]
        if ((played < 0) | (played >= N_ACTIONS)).any():
            raise ValueError(f"actions: expected 0 to {N_ACTIONS - 1}, got {np.unique(played)}")

    def _check_shapes(self) -> None:
        steps, agents = (*self.actions.shape, 0, 0)[:2]
        if not 0 <= self.n_pursuers <= agents:
            raise ValueError(f"n_pursuers: expected 0 to {agents} (agents), got {self.n_pursuers}")
        rows, cols = (*self.map.shape, 0, 0)[:2]
        sizes = {"S": steps + 1, "T": steps, "A": agents, "E": agents - self.n_pursuers}
        sizes |= {"2": 2, "3": 3, "rows": rows, "cols": cols}
        for name, (letters, _) in _ARRAYS.items():
            got, expected = getattr(self, name).shape, tuple(sizes[n] for n in letters.split())
            if got != expected:
                raise ValueError(f"{name}: expected shape {expected}, got {got}")

    @property
    def length(self) -> int:
        """T, the number of steps."""
        return len(self.actions)

    @property
    def n_evaders(self) -> int:
        """E."""
        return int(self.captured.shape[1])

    @property
    def counted(self) -> NDArray[np.bool_]:
        """``(T + 1, E)``: who counts as captured: at that moment under surround, else ever."""
        rules = self.config.get("rules")
        surround = isinstance(rules, Mapping) and rules.get("capture") == "SURROUND"
        return self.captured if surround else self.ever_captured

    @property
    def capture_rate(self) -> float:
        """Share of the evaders that count as captured at the end; 0 without evaders."""
        return float(self.counted[-1].mean()) if self.n_evaders else 0.0

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write to a file (npz, no pickle), which appears complete or not at all."""
        arrays = {name: getattr(self, name) for name in _ARRAYS}
        with replacing(path) as file:
            np.savez_compressed(
                file,
                allow_pickle=False,
                format=np.array(FORMAT),
                n_pursuers=np.array(self.n_pursuers),
                config=np.array(json.dumps(self.config)),
                **arrays,
            )

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Episode:
        """Read what `save` wrote. Raises ValueError, naming the file, when it is cut or foreign."""
        content = Path(path).read_bytes()
        try:
            with np.load(io.BytesIO(content), allow_pickle=False) as stored:
                entries = {name: stored[name] for name in stored.files}
        except _UNREADABLE as error:
            raise ValueError(f"{path}: cut, altered or not an npz file ({error})") from error
        if str(entries.pop("format", "")) != FORMAT:
            raise ValueError(f"{path}: expected a file marked '{FORMAT}'")
        names = {each.name for each in fields(cls)}
        if entries.keys() != names:
            raise ValueError(f"{path}: expected entries {sorted(names)}, got {sorted(entries)}")
        arrays = {name: entries[name] for name in _ARRAYS}
        try:
            config = json.loads(str(entries["config"]))
            return cls(n_pursuers=int(entries["n_pursuers"]), config=config, **arrays)
        except (TypeError, ValueError) as error:
            raise ValueError(f"{path}: not an episode ({error})") from error


@contextmanager
def replacing(path: str | os.PathLike[str]) -> Iterator[BinaryIO]:
    """A file to write to that takes its name only when it is complete and on the disk."""
    target = Path(path)
    part = target.with_name(f".{target.name}.{os.getpid()}.part")
    try:
        with part.open("wb") as file:
            yield file
            file.flush()
            os.fsync(file.fileno())
        part.replace(target)
    except BaseException:
        part.unlink(missing_ok=True)
        raise
