"""One moment of a world as plain arrays, and its drawings.

`Scene` holds the arrays. `rgb` and `png` draw it as a picture with Pillow, `ansi` as text for a
terminal.
"""

from __future__ import annotations

import io
from dataclasses import dataclass, field
from functools import lru_cache
from itertools import groupby, pairwise, product
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageColor, ImageDraw

from matrixworld._util import checks, colors
from matrixworld.world.canvas import SMALLEST_NUMBERED, Layout, Point, font, stamp

__all__ = ["Scene", "ansi", "png", "rgb"]

Cell = tuple[int, int]

MARK_STEPS = 4  # steps until the mark of a capture or a death has faded
SMALLEST_BADGE = 14  # cell size in pixels below which a number on an agent is unreadable
SMALLEST_GRID = 6  # cell size in pixels below which lines between cells would fill the picture
AGENT_SCALE = 0.86  # in cells, but never too small to see
TRIANGLE_SCALE = 1.16  # a triangle as wide as a disc looks smaller
SHARED_SCALE, SHARED_SHIFT = 0.74, 0.19  # both teams on one cell, in diameters of an agent
BURST_SCALE, CROSS_SCALE, RING_SCALE = 1.7, 0.9, 1.14  # marks, in cells
INVOLVED_OPACITY = 0.4  # of the ring of an agent that is not at fault
NUMBERS_IN_BADGE = 3  # more numbers of agents would cover the next cell
TRAIL_LEVEL = 220  # of 255: how strong the newest piece of a trail is
OLDEST_LEVEL = 0.25  # of the newest piece: a trail that faded to nothing would end nowhere
TRAIL_WIDTH, TRAIL_SHIFT = 0.2, 0.1  # in cells; trails of the teams are beside each other


@dataclass
class CellContents:
    """The living agents on one cell, by their numbers in their teams; how many are captured."""

    pursuers: list[int] = field(default_factory=list)
    evaders: list[int] = field(default_factory=list)
    captured: int = 0

    @property
    def all_captured(self) -> bool:
        """Whether no evader on the cell is free."""
        return self.captured == len(self.evaders)


@dataclass(frozen=True, eq=False, repr=False)
class Scene:
    """One moment of a world of P pursuers and E evaders, to be drawn; A = P + E, pursuers first."""

    positions: NDArray[np.integer]
    """Row and column of each agent (A, 2); of one that is gone where it disappeared, or -1."""
    alive: NDArray[np.bool_]
    """Whether each agent is alive (A,)."""
    captured: NDArray[np.bool_]
    """Whether each evader is captured at this moment (E,)."""
    map: NDArray[np.bool_]
    """Obstacles (rows, cols)."""
    n_pursuers: int
    involved: NDArray[np.bool_] | None = None
    fault: NDArray[np.bool_] | None = None
    """Collisions of the last step (A, 3) by kind: obstacle, teammate, adversary."""
    trail: NDArray[np.integer] | None = None
    """Earlier positions (K, A, 2), oldest first; -1 for an agent that is gone."""
    captures: NDArray[np.integer] | None = None
    deaths: NDArray[np.integer] | None = None
    """Recent captures, and deaths by collision (n, 3): row, column, age; 0 is the last step."""
    title: str = ""

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns."""
        rows, cols = self.map.shape
        return rows, cols

    def __repr__(self) -> str:
        rows, cols = self.shape
        pursuers, evaders = self.team_sizes()
        return f"<Scene: {rows} x {cols} cells, {pursuers} pursuers, {evaders} evaders>"

    def _repr_png_(self) -> bytes:
        return png(self)

    def occupied_cells(self) -> dict[Cell, CellContents]:
        """Return what is on each cell that has living agents."""
        cells: dict[Cell, CellContents] = {}
        for agent in np.flatnonzero(self.alive).tolist():
            row, col = self.positions[agent].tolist()
            contents = cells.setdefault((row, col), CellContents())
            if agent < self.n_pursuers:
                contents.pursuers.append(agent)
            else:
                contents.evaders.append(agent - self.n_pursuers)
                contents.captured += bool(self.captured[agent - self.n_pursuers])
        return cells

    def team_sizes(self) -> tuple[int, int]:
        """Return how many pursuers and how many evaders are alive."""
        return int(self.alive[: self.n_pursuers].sum()), int(self.alive[self.n_pursuers :].sum())

    def collided(self) -> tuple[set[Cell], set[Cell]]:
        """Return the cells of agents at fault in a collision, and of other agents involved.

        Agents that disappeared in a collision are included. A contact of adversaries without fault
        is not: it is the aim of the game.
        """
        if self.fault is None or self.involved is None:
            return set(), set()
        at_fault, involved = (
            {(row, col) for row, col in self.positions[marked.any(axis=1)].tolist() if row >= 0}
            for marked in (self.fault, self.involved[:, :2])  # no adversaries
        )
        return at_fault, involved - at_fault


def rgb(scene: Scene, *, cell: int | None = None, numbers: bool = False) -> NDArray[np.uint8]:
    """Draw a `scene` as an array of pixels, uint8 (height, width, 3).

    Scenes of the same grid and `cell` size give pictures of the same size, as animations need; by
    default the size of the grid decides on the pixels per cell. With `numbers` agents carry theirs
    in their teams, 3 for ``pursuer_3`` and ``evader_3``, and cells have at least 20 pixels.
    """
    checks.check_instance("scene", scene, Scene)
    least = SMALLEST_NUMBERED if checks.check_bool("numbers", numbers) else 1
    picture = _Picture(scene, Layout.of(scene.shape, cell, least=least), numbers)
    # Each layer is drawn over the ones before it: agents must not be hidden.
    picture.draw_trails()
    picture.draw_marks()
    picture.draw_collisions()
    picture.draw_agents()
    picture.draw_header()
    return np.array(picture.canvas)


def png(scene: Scene, **look: Any) -> bytes:
    """Draw a scene as the bytes of a PNG file; `look` holds keyword arguments of `rgb`."""
    buffer = io.BytesIO()
    Image.fromarray(rgb(scene, **look)).save(buffer, "PNG")
    return buffer.getvalue()


# The ground is the slowest part to draw and the same in all frames of an episode.
@lru_cache(maxsize=8)
def _ground(obstacles: bytes, layout: Layout) -> Image.Image:
    """Return the picture of an empty world: obstacles, and lines between free cells."""
    canvas = Image.new("RGB", (layout.width, layout.height), colors.PAPER)
    draw = ImageDraw.Draw(canvas)
    left, top, right, bottom = layout.field
    draw.rectangle((left - 2, top - 2, right + 1, bottom + 1), outline=colors.OBSTACLE, width=2)
    if layout.cell >= SMALLEST_GRID:
        for x in range(left + layout.cell, right, layout.cell):
            draw.line((x, top, x, bottom - 1), fill=colors.GRID)
        for y in range(top + layout.cell, bottom, layout.cell):
            draw.line((left, y, right - 1, y), fill=colors.GRID)
    cells = np.frombuffer(obstacles, np.uint8).reshape(layout.rows, layout.cols) * np.uint8(255)
    size = (right - left, bottom - top)
    mask = Image.fromarray(cells).resize(size, Image.Resampling.NEAREST)
    canvas.paste(colors.OBSTACLE, (left, top), mask)
    return canvas


class _Picture:
    """A scene while it is being drawn."""

    def __init__(self, scene: Scene, layout: Layout, numbers: bool) -> None:
        self.scene = scene
        self.layout = layout
        self.numbers = numbers
        self.halo = 1 if layout.cell >= 8 else 0  # width of the light border around an agent
        self.badges: list[tuple[list[int], Point]] = []  # agents on one cell, and where to say so
        self.canvas = _ground(scene.map.astype(bool).tobytes(), layout).copy()

    def draw_trails(self) -> None:
        """Draw where each living agent came from: a line for each step, fainter with age."""
        trail, layout = self.scene.trail, self.layout
        if trail is None or len(trail) == 0:
            return
        cells = np.concatenate([trail, self.scene.positions[None]])
        teams = slice(0, self.scene.n_pursuers), slice(self.scene.n_pursuers, None)
        width = max(1, round(layout.cell * TRAIL_WIDTH))
        for team, colour, side in zip(teams, colors.TEAMS, (-1, 1), strict=True):
            mask = Image.new("L", self.canvas.size, 0)
            draw, shift = ImageDraw.Draw(mask), side * TRAIL_SHIFT * layout.cell
            for step, (start, end) in enumerate(pairwise(cells[:, team]), 1):
                # An agent that is gone has negative coordinates: no line leads from there.
                moved = (start != end).any(axis=1) & (start >= 0).all(axis=1)
                strength = OLDEST_LEVEL + (1 - OLDEST_LEVEL) * step / len(trail)
                for agent in np.flatnonzero(moved & self.scene.alive[team]):
                    ends = layout.centre(*start[agent]), layout.centre(*end[agent])
                    line = [(float(x) + shift, float(y) + shift) for x, y in ends]
                    draw.line(line, fill=round(TRAIL_LEVEL * strength), width=width)
            self.canvas.paste(colour, (0, 0), mask)

    def draw_marks(self) -> None:
        """Draw captures as stars under the agents, and deaths by collision as crosses."""
        for marks, name, colour, scale in (
            (self.scene.captures, "burst", colors.CAPTURE, BURST_SCALE),
            (self.scene.deaths, "cross", colors.COLLISION, CROSS_SCALE),
        ):
            size = max(7, round(self.layout.cell * scale))
            for row, col, age in [] if marks is None else marks.tolist():
                at, opacity = self.layout.centre(row, col), max(0, 1 - age / MARK_STEPS)
                stamp(self.canvas, name, colour, at, size, opacity)
                if colour == colors.CAPTURE:  # too light for white paper without an outline
                    stamp(self.canvas, "burst outline", colors.INK, at, size, opacity)

    def draw_agents(self) -> None:
        """Draw the living agents; two teams on one cell are smaller and side by side."""
        size = max(4, round(self.layout.cell * AGENT_SCALE))
        for (row, col), contents in self.scene.occupied_cells().items():
            x, y = self.layout.centre(row, col)
            if contents.pursuers and contents.evaders:
                shift, small = size * SHARED_SHIFT, max(3, round(size * SHARED_SCALE))
                self._draw_evaders(contents, (x + shift, y - shift), small)
                self._draw_pursuers(contents, (x - shift, y + shift), small)
            elif contents.pursuers:
                self._draw_pursuers(contents, (x, y), size)
            else:
                self._draw_evaders(contents, (x, y), size)
        for agents, centre in self.badges:  # over the agents of all cells, which may be near
            self._draw_badge(agents, centre)

    def _draw_pursuers(self, contents: CellContents, centre: Point, size: int) -> None:
        wide = round(size * TRIANGLE_SCALE)
        stamp(self.canvas, "triangle", colors.PAPER, centre, wide + 4 * self.halo)
        stamp(self.canvas, "triangle", colors.PURSUER, centre, wide)
        side = -1 if contents.evaders else 1  # evaders on the cell have their badge on the right
        badge = (centre[0] + side * size * 0.5, centre[1] - side * size * 0.4)
        inside = (centre[0], centre[1] + size * 0.16)  # where a triangle is wide
        self._draw_label(contents.pursuers, inside, badge, round(size * 0.55), colors.PAPER)

    def _draw_evaders(self, contents: CellContents, centre: Point, size: int) -> None:
        # A disc, which is hollow if all evaders on the cell are captured.
        shape = "thick ring" if contents.all_captured else "disc"
        stamp(self.canvas, "disc", colors.PAPER, centre, size + 2 * self.halo)
        stamp(self.canvas, shape, colors.EVADER, centre, size)
        badge = (centre[0] + size * 0.45, centre[1] - size * 0.4)
        ink, scale = (colors.EVADER, 0.55) if contents.all_captured else (colors.PAPER, 0.65)
        self._draw_label(contents.evaders, centre, badge, round(size * scale), ink)

    def _draw_label(
        self, agents: list[int], inside: Point, badge: Point, size: int, ink: str
    ) -> None:
        """Draw which agents, or how many of them, are on a cell."""
        if len(agents) > 1:
            self.badges.append((agents, badge))
        elif self.numbers:
            draw = ImageDraw.Draw(self.canvas)
            text = str(agents[0])
            draw.text(inside, text, fill=ink, font=font(size - 2 * (len(text) - 1)), anchor="mm")

    def _draw_badge(self, agents: list[int], centre: Point) -> None:
        """Draw the number of agents of one team on a cell, or the numbers that they carry."""
        if self.layout.cell < SMALLEST_BADGE:
            return
        size = max(11, round(self.layout.cell * 0.42))
        text = _badge_text(agents, self.numbers)
        draw, letters = ImageDraw.Draw(self.canvas), font(size - 1)
        width = max(size, draw.textlength(text, font=letters) + size * 0.4)
        x = min(max(centre[0], width / 2 + 1), self.layout.width - width / 2 - 2)
        for colour, border in ((colors.PAPER, 1), (colors.INK, 0)):
            right, down = width / 2 + border, size / 2 + border
            box = (x - right, centre[1] - down, x + right, centre[1] + down)
            draw.rounded_rectangle(box, radius=down, fill=colour)
        draw.text((x, centre[1]), text, fill=colors.PAPER, font=letters, anchor="mm")

    def draw_collisions(self) -> None:
        """Draw rings around agents: strong for agents at fault, faint for others involved."""
        size = max(9, round(self.layout.cell * RING_SCALE))
        for cells, opacity in zip(self.scene.collided(), (1.0, INVOLVED_OPACITY), strict=True):
            for row, col in sorted(cells):
                at = self.layout.centre(row, col)
                stamp(self.canvas, "ring", colors.COLLISION, at, size, opacity)

    def draw_header(self) -> None:
        """Draw the title on the left, and the sizes of both teams on the right."""
        layout = self.layout
        draw, text = ImageDraw.Draw(self.canvas), font(layout.text)
        middle, right = layout.header / 2 + 1, layout.width - layout.margin
        pursuers, evaders = map(str, self.scene.team_sizes())
        for shape, colour, count in (
            ("disc", colors.EVADER, evaders),
            ("triangle", colors.PURSUER, pursuers),
        ):
            draw.text((right, middle), count, fill=colors.INK, font=text, anchor="rm")
            right -= round(draw.textlength(count, font=text)) + layout.text
            stamp(self.canvas, shape, colour, (right + 1, middle), layout.text)
            right -= round(layout.text * 1.1)
        title = _shortened(self.scene.title, right - layout.margin, layout.text)
        draw.text((layout.margin, middle), title, fill=colors.INK, font=text, anchor="lm")


def _badge_text(agents: list[int], numbers: bool) -> str:
    if not numbers:
        return str(len(agents)) if len(agents) < 10 else "+"
    shown = [str(agent) for agent in agents[:NUMBERS_IN_BADGE]]
    if len(agents) > NUMBERS_IN_BADGE:
        shown.append("+")
    return " ".join(shown)


def _shortened(title: str, room: int, size: int) -> str:
    text = font(size)
    if text.getlength(title) <= room:
        return title
    while title and text.getlength(title + "...") > room:
        title = title[:-1]
    return title.rstrip() + "..."


# Text:

RESET = "\x1b[0m"


Run = tuple[str, str, str]
"""A piece of text, its colour and that of its ground, ``#rrggbb``; empty: the terminal's own."""

UNICODE = {"pursuer": "▲", "evader": "●", "captured": "○", "obstacle": "██", "free": "· "}
ASCII = {"pursuer": "P", "evader": "E", "captured": "e", "obstacle": "##", "free": ". "}


def ansi(scene: Scene, *, color: bool = True, compact: bool = False) -> str:
    """Draw a `scene` as lines of text, without a newline at the end.

    A cell is two characters wide. The second one is the number of agents if there are several. If
    both teams share a cell, colored text shows the sign or the number of each team in its color;
    plain text shows X, and the number of agents if it is 3 or more.

    With `color` there are escape codes of the palette of 256 colors, else plain ASCII: P pursuer, E
    evader, e captured evader, X both teams, x a death, # obstacle. `compact` draws half blocks: two
    rows of cells per line and one character per column. Only colors tell the teams apart then.
    """
    checks.check_instance("scene", scene, Scene)
    colored = checks.check_bool("color", color)
    if checks.check_bool("compact", compact) and not colored:
        raise ValueError("compact: expected color with it, got color=False")
    glyphs = UNICODE if color else ASCII
    pursuers, evaders = scene.team_sizes()
    legend = [
        (scene.title + "   " if scene.title else "", "", ""),
        (glyphs["pursuer"], colors.PURSUER, ""),
        (f" {pursuers}  ", "", ""),
        (glyphs["evader"], colors.EVADER, ""),
        (f" {evaders}", "", ""),
    ]
    field = _half_blocks(scene) if compact else _cells(scene, glyphs)
    return "\n".join(_painted(line, color) for line in (legend, *field))


def _cells(scene: Scene, glyphs: dict[str, str]) -> list[list[Run]]:
    occupied, grounds, deaths = scene.occupied_cells(), _grounds(scene), _last_step(scene.deaths)
    lines: list[list[Run]] = []
    for row, obstacles in enumerate(scene.map.tolist()):
        line: list[Run] = []
        for col, obstacle in enumerate(obstacles):
            cell = (row, col)
            ground = grounds.get(cell, colors.PAPER)
            if cell in occupied:
                line += _agents(occupied[cell], glyphs, ground)
            elif cell in deaths:
                line.append(("x " if glyphs is ASCII else "× ", colors.INK, ground))
            elif obstacle:
                line.append((glyphs["obstacle"], colors.OBSTACLE, ground))
            else:
                line.append((glyphs["free"], colors.FREE, ground))
        lines.append(line)
    return lines


def _agents(contents: CellContents, glyphs: dict[str, str], ground: str) -> list[Run]:
    """Return two characters: the signs or the numbers of the teams on a cell."""
    pursuer, evader = (colors.PURSUER, ground), (colors.EVADER, ground)
    pursuers, evaders = len(contents.pursuers), len(contents.evaders)
    sign = glyphs["captured" if contents.all_captured else "evader"]
    if pursuers and evaders and glyphs is ASCII:
        return [("X" + _number(pursuers + evaders, least=3), *pursuer)]
    if pursuers and evaders:
        first = (_number(pursuers, alone=glyphs["pursuer"]), *pursuer)
        return [first, (_number(evaders, alone=sign), *evader)]
    if pursuers:
        return [(glyphs["pursuer"] + _number(pursuers), *pursuer)]
    return [(sign + _number(evaders), *evader)]


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

    def color(row: int, col: int) -> str:
        return fill.get((row, col), colors.PAPER) if row < rows else ""

    return [
        [("▀", color(row, col), color(row + 1, col)) for col in range(cols)]
        for row in range(0, rows, 2)
    ]


def _painted(line: list[Run], color: bool) -> str:
    """Return the line with an escape code at each change of colour, reset at its end."""
    parts = []
    for colours, runs in groupby(line, key=lambda run: run[1:]):
        text = "".join(run[0] for run in runs)
        codes = [
            f"{place};5;{_palette_number(colour)}"
            for place, colour in zip(("38", "48"), colours, strict=True)
            if colour and color
        ]
        parts.append(f"\x1b[{';'.join(codes)}m{text}{RESET}" if codes and text else text)
    return "".join(parts)


@lru_cache(maxsize=64)
def _palette_number(colour: str) -> int:
    """Return the nearest colour of the 6 x 6 x 6 and 24 greys that xterm numbers 16 to 255."""
    # The first 16 colours are left out, because users choose them.
    greys = [(8 + 10 * grey,) * 3 for grey in range(24)]
    palette = np.array([*product((0, 95, 135, 175, 215, 255), repeat=3), *greys])
    distances = ((palette - ImageColor.getrgb(colour)) ** 2).sum(axis=1)
    return 16 + int(distances.argmin())
