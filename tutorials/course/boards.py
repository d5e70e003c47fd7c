"""Small worlds of the first notebooks: a step as a picture, and pursuers alone on a square."""

from __future__ import annotations

import io
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray
from PIL import Image, ImageDraw

from matrixworld import Action, Recorder, Rules, World, colors, render
from matrixworld.episodes.canvas import Layout
from matrixworld.world.arrays import MOVES

Cell = tuple[int, int]
Situation = tuple[list[Cell], list[Cell]]
"""Cells of pursuers on a square, all different, and those they mean to enter."""
CELL = 40
"""Pixels of a cell in pictures."""


def pack(cells: Sequence[Cell], side: int, rules: Rules | str = "SB") -> World:
    """Return a world of pursuers on a square of cells, at the begin of an episode.

    A world has agents of both teams, so one evader waits behind a wall on the right of the square.
    """
    walls = np.zeros((side, side + 2), np.bool_)
    walls[:, side] = True
    world = World(rules, n_pursuers=len(cells), n_evaders=1, obstacles=walls)
    world.reset(0, pursuers=cells, evaders=[(0, side + 1)])
    return world


def target(cell: Cell, action: Action | int) -> Cell:
    """Return the cell that an agent means to enter."""
    (row, col), (down, right) = cell, MOVES[Action(action)].tolist()
    return row + down, col + right


@dataclass(frozen=True, repr=False)
class Picture:
    """A picture that a notebook shows."""

    pixels: NDArray[np.uint8]  # (height, width, 3)

    def __repr__(self) -> str:
        height, width, _ = self.pixels.shape
        return f"<Picture: {width} x {height} pixels>"

    def _repr_png_(self) -> bytes:
        file = io.BytesIO()
        Image.fromarray(self.pixels).save(file, "PNG", optimize=True)
        return file.getvalue()


def plan(world: World, actions: ArrayLike, title: str = "planned moves") -> Picture:
    """Draw a world, which stays as it is, and where its agents are going to move.

    Agents carry their numbers, and arrows show their moves.
    """
    chosen, count = np.asarray(actions), world.config.n_agents
    if chosen.shape != (count,) or not np.isin(chosen, range(Action.WEST + 1)).all():
        raise ValueError(f"actions: expected {count} from 0 to 4, got {chosen.tolist()}")
    canvas = Image.fromarray(render.rgb(world.scene(title), cell=CELL, numbers=True))
    layout = Layout.of(world.map.shape, CELL, least=CELL)
    moves = zip(world.positions.tolist(), chosen.tolist(), strict=True)
    for agent, ((row, col), action) in enumerate(moves):
        if world.alive[agent] and action:
            _draw_arrow(ImageDraw.Draw(canvas), layout.centre(row, col), MOVES[action].tolist())
    return Picture(np.asarray(canvas))


def _draw_arrow(draw: ImageDraw.ImageDraw, centre: tuple[float, float], move: Cell) -> None:
    """Draw a move over the edge of a cell, on the left of its way: those of a swap are apart."""
    down, right = move
    ahead, left = np.array([right, down]), np.array([down, -right])
    tail = np.array(centre) + CELL * (0.34 * left + 0.2 * ahead)
    neck, tip = tail + CELL * 0.3 * ahead, tail + CELL * 0.6 * ahead
    head = [tuple(tip), tuple(neck + CELL * 0.13 * left), tuple(neck - CELL * 0.13 * left)]
    draw.line([*tail, *neck], fill=colors.INK, width=4)
    draw.polygon(head, fill=colors.INK, outline=colors.PAPER)


def before_and_after(world: World, actions: ArrayLike) -> Picture:
    """Play a step of a world, and draw the planned moves and what came of them."""
    before = plan(world, actions)
    recorder = Recorder(world)
    world.step(actions)
    recorder.note(actions)
    after = replace(recorder.scene(trail=0), title="what happened")
    pixels = [before.pixels, render.rgb(after, cell=CELL, numbers=True)]
    return Picture(np.concatenate(pixels, axis=1))


def random_pack(rng: np.random.Generator, side: int, count: int) -> Situation:
    """Return a situation of pursuers that stay or enter a cell beside them.

    A pursuer that would leave the square stays.
    """
    places = rng.permutation(side * side)[:count]
    cells = [divmod(int(place), side) for place in places]
    wanted = [
        target(cell, action)
        for cell, action in zip(cells, rng.integers(5, size=count), strict=True)
    ]
    targets = [
        there if all(0 <= part < side for part in there) else here
        for here, there in zip(cells, wanted, strict=True)
    ]
    return cells, targets


def situations(drawn: Iterable[Situation], *, seed: int, most: int) -> list[Situation]:
    """Return drawn situations, and random ones of 2 to `most` pursuers on 4 x 4 cells."""
    rng = np.random.default_rng(seed)
    counts = [count for count in range(2, most + 1) for _ in range(8)]
    return [*drawn, *(random_pack(rng, 4, count) for count in counts)]


def after_step(situation: Situation, side: int, rules: Rules | str = "SB") -> World:
    """Return a world after the step of a pack on a square; no target is outside."""
    world = pack(situation[0], side, rules)
    world.step([*actions_to(*situation), Action.STAY], explain=True)
    return world


def actions_to(cells: Iterable[Cell], targets: Iterable[Cell]) -> list[Action]:
    """Return the actions that lead from cells to targets on them or beside them."""
    moves = np.subtract([*targets], [*cells]).tolist()
    return [Action(MOVES.tolist().index(move)) for move in moves]
