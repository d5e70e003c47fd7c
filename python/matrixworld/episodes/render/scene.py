"""One moment of a world as plain arrays, and its picture, drawn with Pillow."""

from __future__ import annotations

import io
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw

from matrixworld._util import colors
from matrixworld._util.checks import check_integer
from matrixworld.episodes.render.canvas import SMALLEST_NUMBERED, Layout, Point, font, stamp
from matrixworld.world.conflicts import agent_name

Cell = tuple[int, int]

MARK_STEPS = 4  # steps until the mark of a capture or a death has faded
SMALLEST_BADGE = 14  # cell size in pixels below which a number on an agent is unreadable
SMALLEST_GRID = 6  # cell size in pixels below which lines between cells would fill the picture
TRIANGLE_SCALE = 1.16  # a triangle as wide as a disc looks smaller
SHARED_SCALE, SHARED_SHIFT = 0.74, 0.19  # both teams on one cell, in diameters of an agent
BURST_SCALE, CROSS_SCALE, RING_SCALE = 1.7, 0.9, 1.14  # marks, in cells
INVOLVED_OPACITY = 0.4  # of the ring of an agent that is not at fault
NUMBERS_IN_BADGE = 3  # more numbers of agents would cover the next cell
TRAIL_LEVEL = 220  # of 255: how strong the newest piece of a trail is
OLDEST_LEVEL = 0.25  # of the newest piece: a trail that faded to nothing would end nowhere
TRAIL_WIDTH, TRAIL_SHIFT = 0.2, 0.1  # in cells; trails of the teams are beside each other
VIEW_LEVEL = 28  # of 255: tint of a field of view


@dataclass
class CellContents:
    """The living agents on one cell, by their numbers in their teams.

    `captured` is how many of the evaders are captured at this moment.
    """

    pursuers: list[int] = field(default_factory=list)
    evaders: list[int] = field(default_factory=list)
    captured: int = 0

    @property
    def all_captured(self) -> bool:
        """Whether no evader on the cell is free."""
        return self.captured == len(self.evaders)


@dataclass(frozen=True, eq=False, repr=False)
class Scene:
    """One moment of a world, to be drawn.

    The world has P pursuers and E evaders, A = P + E agents, pursuers first.

    Parameters
    ----------
    positions : ndarray of int, shape (A, 2)
        Row and column of each agent. For an agent that is gone, the cell where it disappeared or
        (-1, -1).
    alive : ndarray of bool, shape (A,)
        Whether each agent is alive.
    captured : ndarray of bool, shape (E,)
        Whether each evader is captured at this moment.
    map : ndarray of bool, shape (rows, cols)
        True for an obstacle.
    n_pursuers : int
        P.
    involved, fault : ndarray of bool, shape (A, 3), optional
        Collisions of the last step by kind: obstacle, teammate, adversary.
    trail : ndarray of int, shape (K, A, 2), optional
        Earlier positions, oldest first; (-1, -1) for an agent that is gone.
    captures, deaths : ndarray of int, shape (n, 3), optional
        Recent captures, and recent deaths by collision: row, column, and age in steps. Age 0 is the
        last step.
    title : str, optional
        One line of text.

    Raises
    ------
    ValueError
        If an array has another shape or a living agent is outside the map.
    TypeError
        If an array is not a NumPy array.
    """

    positions: NDArray[np.integer]
    alive: NDArray[np.bool_]
    captured: NDArray[np.bool_]
    map: NDArray[np.bool_]
    n_pursuers: int
    involved: NDArray[np.bool_] | None = None
    fault: NDArray[np.bool_] | None = None
    trail: NDArray[np.integer] | None = None
    captures: NDArray[np.integer] | None = None
    deaths: NDArray[np.integer] | None = None
    title: str = ""

    def __post_init__(self) -> None:
        _check_shape("map", self.map, (None, None))
        _check_shape("alive", self.alive, (None,))
        agents = len(self.alive)
        if not 0 <= self.n_pursuers <= agents:
            raise ValueError(f"n_pursuers: expected 0 to {agents} (agents), got {self.n_pursuers}")
        _check_shape("positions", self.positions, (agents, 2))
        _check_shape("captured", self.captured, (agents - self.n_pursuers,))
        _check_shape("involved", self.involved, (agents, 3))
        _check_shape("fault", self.fault, (agents, 3))
        _check_shape("trail", self.trail, (None, agents, 2))
        _check_shape("captures", self.captures, (None, 3))
        _check_shape("deaths", self.deaths, (None, 3))
        self._check_inside()

    def _check_inside(self) -> None:
        beyond = (self.positions < 0) | (self.positions >= self.map.shape)
        outside = self.alive & beyond.any(axis=1)
        if outside.any():
            agent = int(outside.argmax())
            cell = tuple(self.positions[agent].tolist())
            raise ValueError(
                f"positions: expected cells of a {self.map.shape[0]} x {self.map.shape[1]} map, "
                f"got {cell} for agent {agent}"
            )

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

    def agent(self, who: int | str) -> int:
        """Return the number of an agent given by number or name; ValueError if there is none."""
        agents = range(len(self.alive))
        names = [agent_name(agent, self.n_pursuers) for agent in agents]
        if isinstance(who, str) and who in names:
            return names.index(who)
        if isinstance(who, str) or who not in agents:
            expected = f"0 to {agents[-1]} or a name such as {names[0]}" if names else "no viewers"
            raise ValueError(f"viewers: expected {expected}, got {who!r}")
        return who

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
        at_fault: set[Cell] = set()
        involved: set[Cell] = set()
        if self.fault is None:
            return at_fault, involved
        for agent, (row, col) in enumerate(self.positions.tolist()):
            if row < 0:
                continue
            if self.fault[agent].any():
                at_fault.add((row, col))
            elif self.involved is not None and self.involved[agent, :2].any():  # no adversaries
                involved.add((row, col))
        return at_fault, involved - at_fault


def _check_shape(
    name: str, array: NDArray[np.generic] | None, expected: tuple[int | None, ...]
) -> None:
    if array is None:
        return
    if not isinstance(array, np.ndarray):
        raise TypeError(f"{name}: expected a NumPy array, got {type(array).__name__}")
    # None in an expected shape stands for any length.
    fits = array.ndim == len(expected) and all(
        want in (None, have) for want, have in zip(expected, array.shape, strict=True)
    )
    if not fits:
        wanted = tuple("any" if want is None else want for want in expected)
        shown = "(" + ", ".join(map(str, wanted)) + ("," if len(wanted) == 1 else "") + ")"
        raise ValueError(f"{name}: expected shape {shown}, got {array.shape}")


def rgb(
    scene: Scene,
    *,
    cell: int | None = None,
    fov: int = 11,
    viewers: Sequence[int | str] = (),
    numbers: bool = False,
) -> NDArray[np.uint8]:
    """Draw a scene as an array of pixels, uint8 (height, width, 3).

    Scenes of the same grid and cell size give pictures of the same size, as animations need.

    Parameters
    ----------
    scene : Scene
        What to draw.
    cell : int, optional
        Pixels per cell. By default the size of the grid decides.
    fov : int, optional
        Side of the fields of view, odd. The default is 11.
    viewers : sequence of int or str, optional
        The agents whose fields of view are outlined while they are alive, by number or by name
        (``pursuer_0`` and so on, ``evader_0`` and so on).
    numbers : bool, optional
        Whether agents carry their numbers in their teams: 3 for ``pursuer_3`` and ``evader_3``.
        Cells then have at least 20 pixels. The default is False.

    Raises
    ------
    ValueError
        If `cell` is below 1 (20 with numbers) or gives too large a picture, `fov` is even, or a
        viewer is unknown.
    """
    if check_integer("fov", fov, 1) % 2 == 0:
        raise ValueError(f"fov: expected an odd number from 1 up, got {fov}")
    agents = [scene.agent(viewer) for viewer in viewers]
    least = SMALLEST_NUMBERED if numbers else 1
    picture = _Picture(scene, Layout.of(scene.shape, cell, least=least), numbers)
    for agent in agents:
        picture.draw_view(agent, fov // 2)
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
        self.badges: list[tuple[list[int], Point]] = []  # agents on one cell, and where to say so
        self.canvas = _ground(scene.map.astype(bool).tobytes(), layout).copy()

    def draw_view(self, viewer: int, reach: int) -> None:
        """Draw the square that an agent sees."""
        if not self.scene.alive[viewer]:
            return
        row, col = self.scene.positions[viewer].tolist()
        colour = colors.TEAMS[viewer >= self.scene.n_pursuers]
        left, top, right, bottom = self.layout.box(
            row - reach, col - reach, row + reach, col + reach
        )
        tint = Image.new("L", (right - left, bottom - top), VIEW_LEVEL)
        self.canvas.paste(colour, (left, top), tint)
        ImageDraw.Draw(self.canvas).rectangle(
            (left, top, right - 1, bottom - 1), outline=colour, width=self.layout.stroke
        )

    def draw_trails(self) -> None:
        """Draw where each living agent came from: a line that fades with age."""
        if self.scene.trail is None or len(self.scene.trail) == 0:
            return
        cells = np.concatenate([self.scene.trail, self.scene.positions[None]])
        teams = slice(0, self.scene.n_pursuers), slice(self.scene.n_pursuers, None)
        for team, colour, side in zip(teams, colors.TEAMS, (-1, 1), strict=True):
            mask = Image.new("L", self.canvas.size, 0)
            shift = side * TRAIL_SHIFT * self.layout.cell
            alive = self.scene.alive[team]
            _draw_lines(ImageDraw.Draw(mask), self.layout, cells[:, team], alive, shift)
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
        size = self.layout.agent
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
        stamp(self.canvas, "triangle", colors.PAPER, centre, wide + 4 * self.layout.halo)
        stamp(self.canvas, "triangle", colors.PURSUER, centre, wide)
        side = -1 if contents.evaders else 1  # evaders on the cell have their badge on the right
        badge = (centre[0] + side * size * 0.5, centre[1] - side * size * 0.4)
        inside = (centre[0], centre[1] + size * 0.16)  # where a triangle is wide
        self._draw_label(contents.pursuers, inside, badge, round(size * 0.55), colors.PAPER)

    def _draw_evaders(self, contents: CellContents, centre: Point, size: int) -> None:
        """Draw a disc, which is hollow if all evaders on the cell are captured."""
        shape = "thick ring" if contents.all_captured else "disc"
        stamp(self.canvas, "disc", colors.PAPER, centre, size + 2 * self.layout.halo)
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


def _draw_lines(
    draw: ImageDraw.ImageDraw,
    layout: Layout,
    cells: NDArray[np.integer],
    alive: NDArray[np.bool_],
    shift: float,
) -> None:
    """Draw one line per step, in pieces so that it fades evenly, newer lines over older ones."""
    width = max(1, round(layout.cell * TRAIL_WIDTH))
    pieces = max(2, layout.cell // 6)
    steps = len(cells) - 1
    for step, (start, end) in enumerate(pairwise(cells)):
        # An agent that is gone has negative coordinates: no line leads from there.
        moved = alive & (start != end).any(axis=1) & (start >= 0).all(axis=1)
        freshness = (step + (np.arange(pieces) + 1) / pieces) / steps
        strength = OLDEST_LEVEL + (1 - OLDEST_LEVEL) * freshness
        levels = (TRAIL_LEVEL * strength).round().astype(int).tolist()
        for a, b in zip(start[moved].tolist(), end[moved].tolist(), strict=True):
            (x0, y0), (x1, y1) = layout.centre(*a), layout.centre(*b)
            dx, dy = (x1 - x0) / pieces, (y1 - y0) / pieces
            for piece, level in enumerate(levels):
                x, y = x0 + piece * dx + shift, y0 + piece * dy + shift
                draw.line((x, y, x + dx, y + dy), fill=level, width=width)


def _badge_text(agents: list[int], numbers: bool) -> str:
    if not numbers:
        return str(len(agents)) if len(agents) < 10 else "+"
    shown = [str(agent) for agent in agents[:NUMBERS_IN_BADGE]]
    return " ".join(shown + ["+"] * (len(agents) > NUMBERS_IN_BADGE))


def _shortened(title: str, room: int, size: int) -> str:
    text = font(size)
    if text.getlength(title) <= room:
        return title
    while title and text.getlength(title + "...") > room:
        title = title[:-1]
    return title.rstrip() + "..."
