"""A scene as a picture, drawn with Pillow."""

from __future__ import annotations

import io
from collections.abc import Sequence
from functools import lru_cache
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw

from matrixworld import colors
from matrixworld.render.layout import Layout
from matrixworld.render.scene import Crowd, Scene
from matrixworld.render.sprites import Point, font, stamp

MARK_STEPS = 4  # steps until the mark of a capture or a death has faded
SMALLEST_BADGE = 14  # cell size in pixels below which a number on an agent is unreadable
SMALLEST_GRID = 6  # cell size in pixels below which lines between cells would fill the picture
TRIANGLE_SCALE = 1.16  # a triangle as wide as a disc looks smaller
SHARED_SCALE, SHARED_SHIFT = 0.74, 0.19  # both teams on one cell, in diameters of an agent
BURST_SCALE, CROSS_SCALE, RING_SCALE = 1.5, 0.9, 1.14  # marks, in cells
INVOLVED_OPACITY = 0.4  # of the ring of an agent that is not at fault
TRAIL_LEVEL = 165  # of 255: how strong the newest piece of a trail is
VIEW_LEVEL = 28  # of 255: tint of a field of view


def rgb(
    scene: Scene, *, cell: int | None = None, fov: int = 11, viewers: Sequence[int | str] = ()
) -> NDArray[np.uint8]:
    """Draw a scene: an array ``(height, width, 3)`` uint8.

    cell: pixels per cell; None chooses by the size of the grid
    fov, viewers: outline the ``fov x fov`` field of view of each of these agents, when alive; by
        number or by name (``pursuer_0`` ..., ``evader_0`` ...)

    Scenes of one grid and cell size give pictures of one size, so they can follow each other in
    an animation. Raises ValueError for a cell below 1, an even fov, or a viewer that is no agent.
    """
    if fov < 1 or fov % 2 == 0:
        raise ValueError(f"fov: expected an odd number from 1 up, got {fov}")
    agents = [scene.agent(viewer) for viewer in viewers]
    picture = _Picture(scene, Layout.of(scene.shape, cell))
    for agent in agents:
        picture.draw_view(agent, fov // 2)
    picture.draw_trails()
    picture.draw_marks()
    picture.draw_collisions()
    picture.draw_agents()
    picture.draw_header()
    return np.array(picture.canvas)


def png(
    scene: Scene, *, cell: int | None = None, fov: int = 11, viewers: Sequence[int | str] = ()
) -> bytes:
    """The same picture as a PNG file."""
    buffer = io.BytesIO()
    Image.fromarray(rgb(scene, cell=cell, fov=fov, viewers=viewers)).save(buffer, "PNG")
    return buffer.getvalue()


@lru_cache(maxsize=8)
def _ground(obstacles: bytes, layout: Layout) -> Image.Image:
    """The picture of an empty world: free cells with lines between them, and obstacles."""
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
    """A scene on its way to becoming a picture."""

    def __init__(self, scene: Scene, layout: Layout) -> None:
        self.scene = scene
        self.layout = layout
        self.canvas = _ground(scene.map.astype(bool).tobytes(), layout).copy()

    def draw_view(self, viewer: int, reach: int) -> None:
        """The square that an agent sees."""
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
        """Where each living agent came from: a line that fades with age."""
        if self.scene.trail is None or len(self.scene.trail) == 0:
            return
        cells = np.concatenate([self.scene.trail, self.scene.positions[None]])
        teams = slice(0, self.scene.n_pursuers), slice(self.scene.n_pursuers, None)
        for team, colour in zip(teams, colors.TEAMS, strict=True):
            mask = Image.new("L", self.canvas.size, 0)
            _draw_lines(ImageDraw.Draw(mask), self.layout, cells[:, team], self.scene.alive[team])
            self.canvas.paste(colour, (0, 0), mask)

    def draw_marks(self) -> None:
        """Captures as a star under the agents, deaths by collision as a cross."""
        for marks, name, colour, scale in (
            (self.scene.captures, "burst", colors.CAPTURE, BURST_SCALE),
            (self.scene.deaths, "cross", colors.COLLISION, CROSS_SCALE),
        ):
            size = max(7, round(self.layout.cell * scale))
            for row, col, age in [] if marks is None else marks.tolist():
                if age < MARK_STEPS:
                    at = self.layout.centre(row, col)
                    stamp(self.canvas, name, colour, at, size, 1 - age / MARK_STEPS)

    def draw_agents(self) -> None:
        """Everybody alive; where the teams share a cell, smaller and side by side."""
        size = self.layout.agent
        for (row, col), crowd in self.scene.crowds().items():
            x, y = self.layout.centre(row, col)
            if crowd.pursuers and crowd.evaders:
                shift, small = size * SHARED_SHIFT, max(3, round(size * SHARED_SCALE))
                self._draw_evaders(crowd, (x + shift, y - shift), small)
                self._draw_pursuers(crowd, (x - shift, y + shift), small)
            elif crowd.pursuers:
                self._draw_pursuers(crowd, (x, y), size)
            else:
                self._draw_evaders(crowd, (x, y), size)

    def _draw_pursuers(self, crowd: Crowd, centre: Point, size: int) -> None:
        wide = round(size * TRIANGLE_SCALE)
        stamp(self.canvas, "triangle", colors.PAPER, centre, wide + 4 * self.layout.halo)
        stamp(self.canvas, "triangle", colors.PURSUER, centre, wide)
        side = -1 if crowd.evaders else 1  # the badge of evaders there is at the upper right
        badge = (centre[0] + side * size * 0.5, centre[1] - side * size * 0.4)
        self._draw_badge(crowd.pursuers, badge)

    def _draw_evaders(self, crowd: Crowd, centre: Point, size: int) -> None:
        """A disc; hollow when everybody there is captured."""
        shape = "thick ring" if crowd.captured == crowd.evaders else "disc"
        stamp(self.canvas, "disc", colors.PAPER, centre, size + 2 * self.layout.halo)
        stamp(self.canvas, shape, colors.EVADER, centre, size)
        self._draw_badge(crowd.evaders, (centre[0] + size * 0.45, centre[1] - size * 0.4))

    def _draw_badge(self, count: int, centre: Point) -> None:
        """The number of agents of one team on a cell, when there are several."""
        if count < 2 or self.layout.cell < SMALLEST_BADGE:
            return
        size = max(11, round(self.layout.cell * 0.42))
        stamp(self.canvas, "disc", colors.PAPER, centre, size + 2)
        stamp(self.canvas, "disc", colors.INK, centre, size)
        text = str(count) if count < 10 else "+"
        draw = ImageDraw.Draw(self.canvas)
        draw.text(centre, text, fill=colors.PAPER, font=font(size - 1), anchor="mm")

    def draw_collisions(self) -> None:
        """Rings around agents: strong for those at fault, faint for the others involved."""
        size = max(9, round(self.layout.cell * RING_SCALE))
        for cells, opacity in zip(self.scene.collided(), (1.0, INVOLVED_OPACITY), strict=True):
            for row, col in sorted(cells):
                at = self.layout.centre(row, col)
                stamp(self.canvas, "ring", colors.COLLISION, at, size, opacity)

    def draw_header(self) -> None:
        """Title on the left, living members of each team on the right."""
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
) -> None:
    """One line a step, in pieces so that it fades evenly; newer ones over older ones."""
    width = max(1, round(layout.cell * 0.2))
    pieces = max(2, layout.cell // 6)
    steps = len(cells) - 1
    for step, (start, end) in enumerate(pairwise(cells)):
        moved = alive & (start != end).any(axis=1) & (start >= 0).all(axis=1)
        freshness = (step + (np.arange(pieces) + 1) / pieces) / steps
        levels = (TRAIL_LEVEL * freshness**1.5).round().astype(int).tolist()
        for a, b in zip(start[moved].tolist(), end[moved].tolist(), strict=True):
            (x0, y0), (x1, y1) = layout.centre(*a), layout.centre(*b)
            dx, dy = (x1 - x0) / pieces, (y1 - y0) / pieces
            for piece, level in enumerate(levels):
                x, y = x0 + piece * dx, y0 + piece * dy
                draw.line((x, y, x + dx, y + dy), fill=level, width=width)


def _shortened(title: str, room: int, size: int) -> str:
    """The title, cut to a width in pixels."""
    text = font(size)
    if text.getlength(title) <= room:
        return title
    while title and text.getlength(title + "...") > room:
        title = title[:-1]
    return title.rstrip() + "..."
