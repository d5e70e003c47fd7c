"""Scenes as text, and texts shown one after the other in a terminal."""

from __future__ import annotations

import os
import shutil
import time
from collections.abc import Iterable, Mapping
from functools import lru_cache
from itertools import groupby
from typing import Any, NamedTuple, TextIO

import numpy as np
from numpy.typing import NDArray

from matrixworld._util import colors
from matrixworld.episodes.render.scene import Cell, CellContents, Scene

MODES = ("true", "256", "none")

# Control sequences of ECMA-48 that practically all terminals know.
HOME = "\x1b[H"
CLEAR = "\x1b[2J"
CLEAR_LINE = "\x1b[K"
CLEAR_BELOW = "\x1b[J"
HIDE_CURSOR = "\x1b[?25l"
SHOW_CURSOR = "\x1b[?25h"
WRAP_OFF = "\x1b[?7l"  # a drawing wider than the terminal is cut instead of broken into pieces
WRAP_ON = "\x1b[?7h"
RESET = "\x1b[0m"


class Ink(NamedTuple):
    """Colours of a piece of text, ``#rrggbb``; empty means the terminal's own."""

    text: str = ""
    ground: str = ""


class Glyphs(NamedTuple):
    """The characters that a drawing is made of."""

    pursuer: str
    evader: str
    captured: str
    obstacle: str
    free: str
    crash: str


UNICODE = Glyphs("▲", "●", "○", "██", "· ", "× ")
ASCII = Glyphs("P", "E", "e", "##", ". ", "x ")
Run = tuple[str, Ink]  # a piece of text of one colour


def ansi(scene: Scene, *, color: str = "true", compact: bool = False) -> str:
    """Draw a scene as lines of text, without a newline at the end.

    A cell is two characters wide. The second one is the number of agents if there are several. If
    both teams share a cell, colored text shows the sign or the number of each team in its color;
    plain text shows X, and the number of agents if it is 3 or more.

    Parameters
    ----------
    scene : Scene
        What to draw.
    color : {"true", "256", "none"}, optional
        24-bit escape codes, the 256-color palette, or plain ASCII: P pursuer, E evader,
        e captured evader, X both teams, x a death, # obstacle.
    compact : bool, optional
        Whether to draw half blocks: two rows of cells per line and one character per column. Only
        colors tell the teams apart then, so it needs colors.

    Raises
    ------
    ValueError
        If `color` is unknown, or `compact` is combined with "none".
    """
    if color not in MODES:
        raise ValueError(f"color: expected one of {MODES}, got {color!r}")
    if compact and color == "none":
        raise ValueError("compact: expected color 'true' or '256', got 'none'")
    glyphs = ASCII if color == "none" else UNICODE
    field = _half_blocks(scene) if compact else _cells(scene, glyphs)
    return "\n".join(_painted(line, color) for line in (_legend(scene, glyphs), *field))


def _legend(scene: Scene, glyphs: Glyphs) -> list[Run]:
    pursuers, evaders = scene.team_sizes()
    title = [(scene.title + "   ", Ink())] if scene.title else []
    return [
        *title,
        (glyphs.pursuer, Ink(colors.PURSUER)),
        (f" {pursuers}  ", Ink()),
        (glyphs.evader, Ink(colors.EVADER)),
        (f" {evaders}", Ink()),
    ]


def _cells(scene: Scene, glyphs: Glyphs) -> list[list[Run]]:
    occupied, grounds = scene.occupied_cells(), _grounds(scene)
    crashes = _last_step(scene.deaths)
    lines: list[list[Run]] = []
    for row, obstacles in enumerate(scene.map.tolist()):
        line: list[Run] = []
        for col, obstacle in enumerate(obstacles):
            cell = (row, col)
            ground = grounds.get(cell, colors.PAPER)
            if cell in occupied:
                line += _agents(occupied[cell], glyphs, ground)
            elif cell in crashes:
                line.append((glyphs.crash, Ink(colors.INK, ground)))
            else:
                text = glyphs.obstacle if obstacle else glyphs.free
                ink = colors.OBSTACLE if obstacle else colors.FREE
                line.append((text, Ink(ink, ground)))
        lines.append(line)
    return lines


def _agents(contents: CellContents, glyphs: Glyphs, ground: str) -> list[Run]:
    pursuer, evader = Ink(colors.PURSUER, ground), Ink(colors.EVADER, ground)
    pursuers, evaders = len(contents.pursuers), len(contents.evaders)
    sign = glyphs.captured if contents.all_captured else glyphs.evader
    if pursuers and evaders:
        if glyphs is ASCII:
            return [("X" + _number(pursuers + evaders, least=3), pursuer)]
        return [
            (_number(pursuers, alone=glyphs.pursuer), pursuer),
            (_number(evaders, alone=sign), evader),
        ]
    if pursuers:
        return [(glyphs.pursuer + _number(pursuers), pursuer)]
    return [(sign + _number(evaders), evader)]


def _number(count: int, alone: str = " ", least: int = 2) -> str:
    """Return one character: a digit, + for 10 or more, and `alone` below `least`."""
    return alone if count < least else str(count) if count < 10 else "+"


def _grounds(scene: Scene) -> dict[Cell, str]:
    """Return the cells whose background shows an event of the last step."""
    collided = scene.collided()[0] | _last_step(scene.deaths)
    return {
        **dict.fromkeys(collided, colors.COLLISION_GROUND),
        **dict.fromkeys(_last_step(scene.captures), colors.CAPTURE_GROUND),
    }


def _last_step(marks: NDArray[np.integer] | None) -> set[Cell]:
    if marks is None:
        return set()
    return {(row, col) for row, col, age in marks.tolist() if age == 0}


def _half_blocks(scene: Scene) -> list[list[Run]]:
    rows, cols = scene.shape
    fill: dict[Cell, str] = dict.fromkeys(zip(*scene.map.nonzero(), strict=True), colors.OBSTACLE)
    fill |= _grounds(scene)
    for cell, contents in scene.occupied_cells().items():
        fill[cell] = colors.PURSUER if contents.pursuers else colors.EVADER
    return [
        [
            (
                "▀",
                Ink(
                    fill.get((row, col), colors.PAPER),
                    fill.get((row + 1, col), colors.PAPER) if row + 1 < rows else "",
                ),
            )
            for col in range(cols)
        ]
        for row in range(0, rows, 2)
    ]


def _painted(line: list[Run], color: str) -> str:
    """Return the line with an escape code at each change of colour, reset at its end."""
    parts = []
    for ink, runs in groupby(line, key=lambda run: run[1]):
        text = "".join(run[0] for run in runs)
        start = _code(ink, color)
        parts.append(f"{start}{text}{RESET}" if start else text)
    return "".join(parts)


def _code(ink: Ink, color: str) -> str:
    """Return the escape code of a text's colours; none for the terminal's own."""
    given = [(place, colour) for place, colour in (("38", ink.text), ("48", ink.ground)) if colour]
    if color == "none" or not given:
        return ""
    number = _palette_number if color == "256" else _true_number
    return f"\x1b[{';'.join(f'{place};{number(colour)}' for place, colour in given)}m"


def _true_number(colour: str) -> str:
    return "2;" + ";".join(map(str, _channels(colour)))


def _channels(colour: str) -> tuple[int, int, int]:
    return int(colour[1:3], 16), int(colour[3:5], 16), int(colour[5:7], 16)


@lru_cache(maxsize=64)
def _palette_number(colour: str) -> str:
    """Return the nearest colour of the 6 x 6 x 6 and 24 greys that xterm numbers 16 to 255."""
    # The first 16 colours are left out, because users choose them.
    levels = (0, 95, 135, 175, 215, 255)
    palette = {
        16 + 36 * r + 6 * g + b: (levels[r], levels[g], levels[b])
        for r in range(6)
        for g in range(6)
        for b in range(6)
    }
    palette |= {232 + i: (8 + 10 * i,) * 3 for i in range(24)}
    wanted = _channels(colour)

    def distance(number: int) -> int:
        return sum((a - b) ** 2 for a, b in zip(palette[number], wanted, strict=True))

    return f"5;{min(palette, key=distance)}"


def play(frames: Iterable[str], stream: TextIO, *, fps: float) -> None:
    """Show drawings of `ansi` in place, one after the other, until the last one or Ctrl-C.

    A drawing higher than the terminal is cut. In any case the cursor is visible again afterwards,
    on the line below the drawing.
    """
    due = time.monotonic()
    try:
        stream.write(HIDE_CURSOR + WRAP_OFF + CLEAR)
        for frame in frames:
            draw(frame, stream)
            # Waiting for a point in time, not for a period, makes up for the time to draw.
            due += 1 / fps
            time.sleep(max(0.0, due - time.monotonic()))
    except KeyboardInterrupt:
        return  # the viewer has seen enough
    finally:
        stream.write(WRAP_ON + SHOW_CURSOR + "\n")
        stream.flush()


def draw(frame: str, stream: TextIO) -> None:
    """Replace the drawing in a terminal by another one, cut to the height of the terminal."""
    height = terminal_size(stream).lines - 1
    # Each line is cleared behind its text: clearing the whole screen first would flicker.
    lines = (line + CLEAR_LINE for line in frame.split("\n")[:height])
    stream.write(HOME + "\n".join(lines) + CLEAR_BELOW)
    stream.flush()


def color_mode(stream: TextIO, environ: Mapping[str, str] = os.environ) -> str:
    """Return the colors that `ansi` may use on a stream: "true", "256" or "none".

    It reads NO_COLOR (https://no-color.org), TERM and COLORTERM.
    """
    encoding = (getattr(stream, "encoding", None) or "utf-8").lower()
    plain = not stream.isatty() or environ.get("NO_COLOR") or environ.get("TERM") == "dumb"
    if plain or not encoding.startswith("utf"):
        return "none"
    return "true" if environ.get("COLORTERM") in ("truecolor", "24bit") else "256"


def terminal_size(stream: TextIO) -> os.terminal_size:
    """Return columns and lines of a terminal; without one, of the variables COLUMNS and LINES."""
    try:
        return os.get_terminal_size(stream.fileno())
    except OSError:
        return shutil.get_terminal_size()


def text_look(shape: tuple[int, ...], stream: TextIO) -> dict[str, Any]:
    """Return the keyword arguments of `ansi` for a grid, in half blocks where it would not fit."""
    mode, (columns, lines), (rows, cols) = color_mode(stream), terminal_size(stream), shape
    fits = 2 * cols <= columns and rows + 2 <= lines  # cells of two characters, below a title
    return {"color": mode, "compact": mode != "none" and not fits}
