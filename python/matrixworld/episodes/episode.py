"""Recorded episodes: arrays in memory, files, scenes to be drawn, and animations of them."""

from __future__ import annotations

import io
import json
import os
from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from matrixworld._util.checks import check_instance, check_integer, check_number, check_shape
from matrixworld._util.files import DamagedFileError, load_arrays, read_json, replacing
from matrixworld.episodes.frames import FASTEST, HOLD, SLOWEST, Animation, Draw, write_gif
from matrixworld.world.canvas import SMALLEST_NUMBERED, fitting_cell
from matrixworld.world.conflicts import Conflict, conflict_of
from matrixworld.world.render import MARK_STEPS, Scene, rgb

FORMAT = "matrixworld episode 3"  # marks a saved file; a new layout, a new number

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
    "conflict_table": ("N 11", "int32"),
}
OPTIONAL = {"conflict_table", "seat"}  # entries that a file may lack
# World arrays that a recording keeps, one of each moment or of each step. Actions are not among
# them: they are the input of a step.
MOMENT_ARRAYS = tuple(name for name, (shape, _) in _ARRAYS.items() if shape.startswith("S"))
STEP_ARRAYS = ("rewards", "involved", "fault")
FRAMES = 120  # the most frames of an animation in a notebook
PIXELS = 480  # wanted length of the longer side of its field


@dataclass(frozen=True, eq=False, repr=False)
class Episode:
    """Recorded episode of T steps with P pursuers and E evaders, A = P + E agents, pursuers first.

    Step t (an entry of actions, rewards, involved, fault) leads from moment t to moment t + 1 (of
    positions, last_positions, alive, captured, ever_captured).

    Parameters
    ----------
    positions : ndarray of int32, shape (T + 1, A, 2)
        Row and column of each agent; (-1, -1) when gone.
    last_positions : ndarray of int32, shape (T + 1, A, 2)
        The same, but for a gone agent the cell where it disappeared.
    alive : ndarray of bool, shape (T + 1, A)
        Whether the agent is in the world.
    captured, ever_captured : ndarray of bool, shape (T + 1, E)
        Whether the evader is captured at this moment; whether it was at some time until then.
    actions : ndarray of int8, shape (T, A)
        Actions, 0 to 8. Those of gone agents have no meaning.
    rewards : ndarray of float32, shape (T, A)
        Rewards of the step.
    involved, fault : ndarray of bool, shape (T, A, 3)
        Whether the agent was in a collision, and at fault in one, with an obstacle, a teammate, an
        adversary.
    map : ndarray of bool, shape (rows, cols)
        True for an obstacle.
    n_pursuers : int
        P.
    config : mapping, optional
        The settings of the world, as `WorldConfig.to_json` returns them. The default is none.
    conflict_table : ndarray of int32, shape (n, 11), optional
        All conflicts: the step, from 1, and the numbers that
        `matrixworld.world.conflicts.CONFLICT_COLUMNS` names. The default is None: not recorded.
    seat : int, optional
        The agent that a person has played, as on the page of ``matrixworld playground``. The
        default is None: nobody has.
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
    conflict_table: NDArray[np.int32] | None = None
    seat: int | None = None

    def __post_init__(self) -> None:
        # A frozen dataclass lets its fields be set in this way only.
        object.__setattr__(self, "n_pursuers", check_integer("n_pursuers", self.n_pursuers))
        check_instance("config", self.config, Mapping)
        arrays = self._arrays()
        for name, array in arrays.items():
            dtype = _ARRAYS[name][1]
            if not isinstance(array, np.ndarray) or array.dtype != dtype:
                got = getattr(array, "dtype", type(array).__name__)
                raise TypeError(f"{name}: expected an array of {dtype}, got {got}")
        steps, agents = (*self.actions.shape, 0, 0)[:2]
        if not 0 <= self.n_pursuers <= agents:
            raise ValueError(f"n_pursuers: expected 0 to {agents} (agents), got {self.n_pursuers}")
        rows, cols = (*self.map.shape, 0, 0)[:2]
        sizes = {"S": steps + 1, "T": steps, "A": agents, "E": agents - self.n_pursuers}
        sizes |= {"rows": rows, "cols": cols, "N": len(arrays.get("conflict_table", ()))}
        sizes |= {"2": 2, "3": 3, "11": 11}
        for name, array in arrays.items():
            check_shape(name, array, *(sizes[letter] for letter in _ARRAYS[name][0].split()))
        if self.seat is not None:
            object.__setattr__(self, "seat", check_integer("seat", self.seat, 0, agents - 1))
        # Gone agents keep whatever action was passed for them.
        played = self.actions[self.alive[:-1]]
        if ((played < 0) | (played > 8)).any():
            raise ValueError(f"actions: expected 0 to 8, got {np.unique(played)}")

    def _arrays(self) -> dict[str, Any]:
        """Return the arrays that this recording has."""
        arrays = {name: getattr(self, name) for name in _ARRAYS}
        if self.conflict_table is None:
            del arrays["conflict_table"]
        return arrays

    def __repr__(self) -> str:
        rows, cols = self.map.shape
        return (
            f"<Episode: {self.length} steps, {self.n_pursuers} pursuers, {self.n_evaders} evaders, "
            f"{rows} x {cols} cells, capture rate {self.capture_rate:.2f}>"
        )

    def _repr_html_(self) -> str:
        return animation(self)._repr_html_()

    @property
    def length(self) -> int:
        """The number of steps, T."""
        return len(self.actions)

    @property
    def n_evaders(self) -> int:
        """The number of evaders, E."""
        return int(self.captured.shape[1])

    @property
    def counted(self) -> NDArray[np.bool_]:
        """Evaders that count as captured, (T + 1, E): now under surround, else ever."""
        rules = self.config.get("rules")
        surround = isinstance(rules, Mapping) and rules.get("capture") == "SURROUND"
        return self.captured if surround else self.ever_captured

    @property
    def capture_rate(self) -> float:
        """Share of the evaders that count as captured at the end; 0 without evaders."""
        return float(self.counted[-1].mean()) if self.n_evaders else 0.0

    def explain(self, step: int = -1) -> list[Conflict]:
        """Return the conflicts of one step: why agents bounced or disappeared in it.

        Parameters
        ----------
        step : int, optional
            Step 1 to T led to the moment that `replay.scene` draws for the same number; moment 0
            has no conflicts. Negative numbers count from the end; the default is the last step.

        Returns
        -------
        list of Conflict
            Those of `World.conflicts`; ``str`` of each is a sentence.

        Raises
        ------
        IndexError, ValueError
            Outside the episode; if the recording has no conflicts.
        """
        if self.conflict_table is None:
            raise ValueError("conflict_table: expected a recording with conflicts, got none")
        now = step_number(step, self.length)
        rows = self.conflict_table[self.conflict_table[:, 0] == now, 1:].tolist()
        return [conflict_of(numbers, self.n_pursuers) for numbers in rows]

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the episode to a file, which appears complete or not at all.

        Parameters
        ----------
        path : str or path
            A name that ends in ``.npz`` or has no suffix; `replay.save` writes pictures.
        """
        if Path(path).suffix not in ("", ".npz"):
            hint = "mw.replay.save(episode, path) writes pictures"
            raise ValueError(f"path: expected a name that ends in .npz, got {path}; {hint}")
        arrays = self._arrays()
        if self.seat is not None:
            arrays["seat"] = np.array(self.seat)
        with replacing(path) as file:
            np.savez_compressed(
                file,
                format=np.array(FORMAT),
                n_pursuers=np.array(self.n_pursuers),
                config=np.array(json.dumps(self.config)),
                **arrays,
            )

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Episode:
        """Read an episode that `save` wrote; DamagedFileError, a ValueError, for another file."""
        path = Path(path)
        entries = load_arrays(path)
        if str(entries.pop("format", "")) != FORMAT:
            raise DamagedFileError(path, f"expected a file marked '{FORMAT}'")
        names = {item.name for item in fields(cls)}
        if entries.keys() | OPTIONAL != names:
            problem = f"expected entries {sorted(names)}, got {sorted(entries)}"
            raise DamagedFileError(path, problem)
        arrays = {name: entries[name] for name in _ARRAYS if name in entries}
        try:
            return cls(
                n_pursuers=int(entries["n_pursuers"]),
                config=read_json(path, str(entries["config"])),
                seat=int(entries["seat"]) if "seat" in entries else None,
                **arrays,
            )
        except DamagedFileError:
            raise
        except (OverflowError, TypeError, ValueError) as error:
            raise DamagedFileError(path, f"not an episode ({error})") from error


def step_number(step: int, length: int) -> int:
    """Return a number of steps from one that may count from the end."""
    number = check_integer("step", step)
    if not -length - 1 <= number <= length:
        raise IndexError(f"step: expected {-length - 1} to {length}, got {number}")
    return number % (length + 1)


def scene(episode: Episode, step: int = -1, *, trail: int = 6, title: str | None = None) -> Scene:
    """Return one moment of an `episode`, to be drawn; IndexError outside the episode.

    `step` is the number of steps played before it; negative numbers count from the end, the
    default. Trails of the agents go `trail` steps back. `title` is a line of text, by default the
    step and the share of the evaders that are captured.
    """
    check_instance("episode", episode, Episode)
    now = step_number(step, episode.length)
    trail = check_integer("trail", trail, 0)
    if title is None:
        title = capture_title(episode, now, f"step {now} of {episode.length}")
    captures, deaths = _marks(episode, now)
    return Scene(
        positions=episode.last_positions[now],
        alive=episode.alive[now],
        captured=episode.captured[now],
        map=episode.map,
        n_pursuers=episode.n_pursuers,
        involved=episode.involved[now - 1] if now else None,
        fault=episode.fault[now - 1] if now else None,
        trail=episode.positions[max(0, now - trail) : now],
        captures=captures,
        deaths=deaths,
        title=title,
    )


def capture_title(episode: Episode, now: int, start: str) -> str:
    """Return a line of text: `start`, and how many of the evaders are captured."""
    captured = int(episode.counted[now].sum())
    evaders = episode.n_evaders
    share = f" ({captured / evaders:.0%})" if evaders else ""
    return f"{start}    captured {captured} of {evaders}{share}"


def _marks(episode: Episode, now: int) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Return row, column and age of the captures and of the other deaths of the last steps."""
    captures: list[tuple[int, int, int]] = []
    deaths: list[tuple[int, int, int]] = []
    for step in range(max(1, now - MARK_STEPS + 1), now + 1):
        evaders = episode.ever_captured[step] & ~episode.ever_captured[step - 1]
        caught = np.concatenate([np.zeros(episode.n_pursuers, bool), evaders])
        # An evader that disappears in its capture is marked as captured, not as dead.
        gone = episode.alive[step - 1] & ~episode.alive[step]
        for marks, agents in ((captures, caught), (deaths, gone & ~caught)):
            last_positions = episode.last_positions[step, agents].tolist()
            marks.extend((row, col, now - step) for row, col in last_positions)
    return np.array(captures, int).reshape(-1, 3), np.array(deaths, int).reshape(-1, 3)


def animation(
    episode: Episode, *, fps: float = 10.0, every: int | None = None, **look: Any
) -> Animation:
    """Return an animation that a notebook shows, and stores in itself.

    A long episode on 40 x 40 cells takes about 1 MB.

    Takes `episode`, `fps`, `every` and `look` as `replay.save` does. By default it has at most
    about 120 frames, and about 480 pixels a side.
    """
    fps = check_number("fps", fps, least=SLOWEST, most=FASTEST)
    # A notebook keeps the animation in its file, so both frames and pixels are limited.
    times = times_of(episode, every)
    if look.get("cell") is None:
        least = SMALLEST_NUMBERED if look.get("numbers") else 1
        look["cell"] = fitting_cell(episode.map.shape, PIXELS, least)
    buffer = io.BytesIO()
    write_gif(buffer, pictures(episode, look), times, fps=fps, hold=HOLD)
    return Animation(buffer.getvalue())


def pictures(episode: Episode, look: dict[str, Any]) -> Draw:
    """Return what draws moments of an episode."""
    trail = look.pop("trail", 6)
    return lambda step: rgb(scene(episode, step, trail=trail), **look)


def times_of(episode: Episode, every: int | None) -> list[int]:
    """Return the times of frames; the end, the most interesting one, whatever the stride."""
    check_instance("episode", episode, Episode)
    length = episode.length
    default = -(-length // FRAMES) or 1
    stride = default if every is None else check_integer("every", every, 1)
    times = list(range(0, length + 1, stride))
    return times if times[-1] == length else [*times, length]
