"""Parts of a board as vector graphics: cells, agents, planned moves, collisions.

They look like the pictures of `matrixworld.episodes.render`, which are made of pixels.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any

from matplotlib.axes import Axes
from matplotlib.patches import Circle, FancyArrowPatch, Rectangle, RegularPolygon
from matplotlib.patheffects import withStroke

from matrixworld._util import colors
from matrixworld.world.rules import Action

RADIUS = 0.33
"""Of an agent that is alone on its cell, in cells."""
MOVES = {Action.NORTH: (-1, 0), Action.EAST: (0, 1), Action.SOUTH: (1, 0), Action.WEST: (0, -1)}


def draw_board(axes: Axes, rows: int, cols: int, obstacles: Iterable[tuple[int, int]] = ()) -> None:
    """Draw the cells of a world, row 0 on top, and obstacles; no axes."""
    for row in range(rows):
        for col in range(cols):
            filled = colors.OBSTACLE if (row, col) in set(obstacles) else colors.PAPER
            corner = col - 0.5, row - 0.5
            axes.add_patch(
                Rectangle(corner, 1, 1, facecolor=filled, edgecolor=colors.MUTED, linewidth=0.8)
            )
    axes.set(xlim=(-0.55, cols - 0.45), ylim=(rows - 0.45, -0.55), aspect="equal")
    axes.set(xticks=[], yticks=[])
    axes.spines[:].set_visible(False)


def draw_agent(
    axes: Axes, cell: tuple[int, int], name: str, *, place: int = 0, among: int = 1
) -> None:
    """Draw an agent: an orange triangle for a pursuer "P0", a blue disc for an evader "E0".

    Parameters
    ----------
    axes : Axes
        Where to draw.
    cell : tuple of int
        Row and column.
    name : str
        Name inside of the agent; the first letter tells the team.
    place, among : int, optional
        Number of the agent on its cell, and how many share it.
    """
    row, col = cell
    radius = RADIUS if among == 1 else 0.24
    x, y = col + (place - (among - 1) / 2) * 0.46, float(row)
    pursuer = name.startswith("P")
    look: dict[str, Any] = {"facecolor": colors.TEAMS[not pursuer], "zorder": 3}
    if pursuer:
        # Turned, because the axis of rows points down; a little lower, to be in the middle.
        y += 0.2 * radius
        triangle = RegularPolygon((x, y), 3, radius=1.3 * radius, orientation=math.pi, **look)
        axes.add_patch(triangle)
    else:
        axes.add_patch(Circle((x, y), radius, **look))
    size = 8 if among == 1 else 6
    axes.text(
        x, y + 0.02, name, ha="center", va="center", color=colors.PAPER, size=size,
        fontweight="bold", zorder=4,
    )  # fmt: skip


def draw_move(axes: Axes, cell: tuple[int, int], action: Action) -> None:
    """Draw the planned move of an agent: an arrow over the edge of its cell."""
    (row, col), (down, right) = cell, MOVES[action]
    # On the left of the agent's way, so that the arrows of a swap are beside each other.
    aside = 0.34
    x, y = col + down * aside + right * 0.24, row - right * aside + down * 0.24
    axes.add_patch(
        FancyArrowPatch(
            (x, y), (x + 0.52 * right, y + 0.52 * down), arrowstyle="-|>", mutation_scale=9,
            linewidth=1.3, color=colors.INK, shrinkA=0, shrinkB=0, zorder=5,
            path_effects=[withStroke(linewidth=3, foreground=colors.PAPER)],  # on obstacles
        )
    )  # fmt: skip


def draw_removed(axes: Axes, cell: tuple[int, int], *, occupied: bool = False) -> None:
    """Draw a cross where an agent disappeared; in a corner if another agent is there."""
    row, col = cell
    aside, size = (0.33, 6) if occupied else (0, 13)
    axes.plot(
        [col - aside], [row - aside], marker="x", markersize=size, markeredgewidth=size / 5,
        color=colors.COLLISION, zorder=2,
    )  # fmt: skip


def draw_held(axes: Axes, cell: tuple[int, int]) -> None:
    """Draw a ring around an agent that had to stay."""
    row, col = cell
    axes.add_patch(
        Circle((col, row), 0.46, fill=False, edgecolor=colors.COLLISION, linewidth=1.8, zorder=2)
    )
