"""Watching a recorded episode: in a terminal, as an animation, as a sheet of pictures."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from typing import TextIO

import numpy as np
from numpy.typing import NDArray

from matrixworld.episode import Episode, replacing
from matrixworld.render import MARK_STEPS, Cell, Scene, ansi, rgb
from matrixworld.render.gif import write_gif
from matrixworld.render.screen import color_mode, fits, play

__all__ = ["Episode", "animate_terminal", "contact_sheet", "save_gif", "scene"]

# Row and column by action: stay, north, east, south, west, north-east and on clockwise.
MOVES = ((0, 0), (-1, 0), (0, 1), (1, 0), (0, -1), (-1, 1), (1, 1), (1, -1), (-1, -1))
AXIAL = MOVES[1:5]


def scene(episode: Episode, step: int = -1, *, trail: int = 6, title: str | None = None) -> Scene:
    """What there is to draw after so many steps, from 0; negative numbers count from the end.

    trail: how many steps back the trails of the agents go
    title: by default the step and the share of the evaders that are captured

    Raises IndexError for a step outside the episode.
    """
    now = range(episode.length + 1)[step]
    captures, deaths = _marks(episode, now)
    return Scene(
        positions=episode.positions[now],
        alive=episode.alive[now],
        captured=episode.captured[now],
        map=episode.map,
        n_pursuers=episode.n_pursuers,
        involved=episode.involved[now - 1] if now else None,
        fault=episode.fault[now - 1] if now else None,
        trail=episode.positions[max(0, now - trail) : now],
        captures=captures,
        deaths=deaths,
        title=capture_title(episode, now, f"step {now} of {episode.length}")
        if title is None
        else title,
    )


def animate_terminal(
    episode: Episode,
    stream: TextIO | None = None,
    *,
    fps: float = 10.0,
    every: int = 1,
    color: str | None = None,
) -> None:
    """Show an episode in a terminal, in place, until its end or Ctrl-C.

    stream: None for standard output; when it is no terminal, the last moment is printed as
        plain text instead
    fps: drawings a second; every: steps from one to the next
    color: as `render.ansi` takes it; None finds out

    A grid too large for the terminal is drawn in half blocks. Raises ValueError for an fps that
    is not positive and for every below 1.
    """
    if not fps > 0:
        raise ValueError(f"fps: expected more than 0 drawings a second, got {fps}")
    times = _times(episode, every)
    out = sys.stdout if stream is None else stream
    if not out.isatty():
        out.write(ansi(scene(episode), color="none") + "\n")
        return
    mode = color_mode(out) if color is None else color
    compact = mode != "none" and not fits(episode.map.shape, out)
    play((ansi(scene(episode, t), color=mode, compact=compact) for t in times), out, fps=fps)


def save_gif(
    episode: Episode,
    path: str | os.PathLike[str],
    *,
    fps: float = 10.0,
    every: int = 1,
    cell: int | None = None,
    trail: int = 6,
    hold: float = 2.0,
    fov: int = 11,
    viewers: Sequence[int] = (),
) -> None:
    """Write an episode as an endlessly repeated animation.

    fps: frames a second, at most 50; every: steps from one frame to the next, the last step
        always being shown, and held for `hold` seconds more
    cell: pixels per cell; None chooses by the size of the grid
    trail: how many steps back the trails go
    fov, viewers: as for `render.rgb`

    Raises ValueError for a value out of range.
    """
    times = _times(episode, every)

    def draw(time: int) -> NDArray[np.uint8]:
        return rgb(scene(episode, time, trail=trail), cell=cell, fov=fov, viewers=viewers)

    with replacing(path) as file:
        write_gif(file, draw, times, fps=fps, hold=hold)


def contact_sheet(
    episode: Episode, *, rows: int = 2, cols: int = 3, cell: int | None = None
) -> NDArray[np.uint8]:
    """Moments of an episode from first to last, evenly spread, side by side: one RGB picture."""
    if rows < 1 or cols < 1:
        raise ValueError(f"rows, cols: expected at least 1, got {rows}, {cols}")
    times = np.linspace(0, episode.length, rows * cols).round().astype(int)
    pictures = [rgb(scene(episode, t), cell=cell) for t in times.tolist()]
    lines = [np.concatenate(pictures[i : i + cols], axis=1) for i in range(0, len(times), cols)]
    return np.concatenate(lines)


def _times(episode: Episode, every: int) -> list[int]:
    if every < 1:
        raise ValueError(f"every: expected 1 step or more, got {every}")
    times = list(range(0, episode.length + 1, every))
    return times if times[-1] == episode.length else [*times, episode.length]


def capture_title(episode: Episode, now: int, start: str) -> str:
    """A line of text: ``start``, and how many of the evaders are captured."""
    caught, of = int(episode.counted[now].sum()), episode.n_evaders
    share = f" ({caught / of:.0%})" if of else ""
    return f"{start}    captured {caught} of {of}{share}"


def _marks(episode: Episode, now: int) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Row, column and age of the captures and of the other deaths of the last steps."""
    captures: list[tuple[int, int, int]] = []
    deaths: list[tuple[int, int, int]] = []
    for step in range(max(1, now - MARK_STEPS + 1), now + 1):
        caught = _newly_captured(episode, step)
        gone = episode.alive[step - 1] & ~episode.alive[step]
        for marks, agents in ((captures, caught), (deaths, gone & ~caught)):
            for agent in np.flatnonzero(agents).tolist():
                marks.append((*_place(episode, step, agent), now - step))
    return np.array(captures, int).reshape(-1, 3), np.array(deaths, int).reshape(-1, 3)


def _newly_captured(episode: Episode, step: int) -> NDArray[np.bool_]:
    """``(A,)``: whose first capture was in the step that led to this moment."""
    evaders = episode.ever_captured[step] & ~episode.ever_captured[step - 1]
    return np.concatenate([np.zeros(episode.n_pursuers, bool), evaders])


def _place(episode: Episode, step: int, agent: int) -> Cell:
    """Where an agent is after a step, or where it vanished in it.

    The latter is not recorded. It is taken for the cell that the agent meant to enter, unless
    that is a wall, or pursuers now stand all around the cell that it came from (it was
    surrounded) or on that cell and not on the other (they swapped, or it stayed).
    """
    if episode.alive[step, agent]:
        row, col = episode.positions[step, agent].tolist()
        return row, col
    row, col = episode.positions[step - 1, agent].tolist()
    down, right = MOVES[episode.actions[step - 1, agent]]
    ahead = (row + down, col + right)
    around = [(row + dr, col + dc) for dr, dc in AXIAL]
    surrounded = all(_wall(episode, each) or _pursued(episode, step, each) for each in around)
    stayed = _pursued(episode, step, (row, col)) and not _pursued(episode, step, ahead)
    return (row, col) if _wall(episode, ahead) or surrounded or stayed else ahead


def _wall(episode: Episode, cell: Cell) -> bool:
    rows, cols = episode.map.shape
    return not (0 <= cell[0] < rows and 0 <= cell[1] < cols) or bool(episode.map[cell])


def _pursued(episode: Episode, step: int, cell: Cell) -> bool:
    pursuers = episode.positions[step, : episode.n_pursuers]
    return bool((pursuers == cell).all(axis=1).any())
