"""Small worlds: a step as a picture, and pursuers alone on a square."""

from __future__ import annotations

import io
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray
from PIL import Image, ImageDraw

from matrixworld import Action, Recorder, Rules, World, colors, render
from matrixworld.world.arrays import MOVES
from matrixworld.world.canvas import Layout

Cell = tuple[int, int]
Situation = tuple[list[Cell], list[Cell]]
"""Cells of pursuers on a square, all different, and those they mean to enter."""
CELL = 40
"""Pixels of a cell in pictures."""


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
    for agent, action in enumerate(chosen):
        if world.alive[agent] and action:
            centre = layout.centre(*world.positions[agent].tolist())
            _draw_arrow(ImageDraw.Draw(canvas), centre, MOVES[action].tolist())
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


def after(world: World, actions: ArrayLike) -> Picture:
    """Play a step of a world, and draw what came of it."""
    recorder = Recorder(world)
    world.step(actions, explain=True)
    recorder.note(actions)
    scene = replace(recorder.scene(trail=0), title="what happened")
    return Picture(render.rgb(scene, cell=CELL, numbers=True))


def before_and_after(world: World, actions: ArrayLike) -> Picture:
    """Play a step of a world, and draw the planned moves and what came of them."""
    pictures = plan(world, actions), after(world, actions)
    return Picture(np.concatenate([each.pixels for each in pictures], axis=1))


# ---- Pursuers alone ------------------------------------------------------------------------------


def pack(cells: Sequence[Cell], side: int, rules: Rules | str = "SB") -> World:
    """Return a world of pursuers on a square of cells, at the begin of an episode.

    A world has agents of both teams, so one evader waits behind a wall on the right of the square.
    """
    walls = np.zeros((side, side + 2), np.bool_)
    walls[:, side] = True
    world = World(rules, n_pursuers=len(cells), n_evaders=1, obstacles=walls)
    world.reset(0, pursuers=cells, evaders=[(0, side + 1)])
    return world


def after_step(situation: Situation, side: int, rules: Rules | str = "SB") -> World:
    """Return a world after the step of a pack on a square; no target is outside."""
    cells, targets = situation
    world = pack(cells, side, rules)
    moves = np.subtract(targets, cells).tolist()
    world.step([*map(MOVES.tolist().index, moves), Action.STAY], explain=True)
    return world


def random_pack(rng: np.random.Generator, side: int, count: int) -> Situation:
    """Return a situation of pursuers that stay or enter a cell beside them.

    A pursuer that would leave the square stays.
    """
    cells = np.stack(np.divmod(rng.permutation(side * side)[:count], side), axis=1)
    wanted = cells + MOVES[rng.integers(5, size=count)]
    inside = ((wanted >= 0) & (wanted < side)).all(axis=1, keepdims=True)
    there = np.where(inside, wanted, cells)
    return [*map(tuple, cells.tolist())], [*map(tuple, there.tolist())]


_row, _rng = [(0, 0), (0, 1), (0, 2)], np.random.default_rng(2)
SITUATIONS: list[Situation] = [
    ([(0, 0), (0, 2)], [(0, 1), (0, 1)]),
    ([(0, 0), (0, 1)], [(0, 1), (0, 1)]),
    ([(0, 0), (0, 1)], [(0, 1), (0, 0)]),
    ([(0, 0), (0, 1)], [(0, 1), (0, 2)]),
    (_row, [(0, 1), (0, 2), (0, 3)]),
    (_row, [(0, 1), (0, 2), (0, 2)]),
    ([*_row, (1, 3)], [(0, 1), (0, 2), (0, 3), (0, 3)]),
    *(random_pack(_rng, 4, count) for count in range(2, 15) for _ in range(8)),
]
"""Of 2 to 14 pursuers on 4 x 4 cells: those at first that are easy to tell, then random ones."""
