"""Figures of the game: conflicts and their outcomes, right of way, rules.

What happens in a conflict is not drawn by hand: a `World` with these rules plays one step. The
paper's figure shows four forms of conflict (vertex, edge, following, cycle), three kinds of
collision (obstacle, teammate, adversary) and three outcomes; here each row is a small world with
planned moves, and each column an outcome.

References
----------
R. Stern et al. (2019). Multi-agent pathfinding: definitions, variants, and benchmarks.
S. J. Russell and P. Norvig (2021). Artificial intelligence: a modern approach.
J. K. Terry et al. (2021). PettingZoo: Gym for multi-agent reinforcement learning.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.transforms import Bbox

from course.boards import CELL, Picture, after, plan
from matrixworld._util import colors
from matrixworld.explorer.playground import drawn_world
from matrixworld.plots.style import legend_below, new_figure
from matrixworld.world.arrays import MOVES
from matrixworld.world.canvas import Layout
from matrixworld.world.masks import ActionMasks
from matrixworld.world.rules import (
    OUTCOME_TEXTS,
    RULES_HEAD,
    VARIANTS,
    Action,
    Capture,
    Outcome,
    Rules,
    rules_row,
)
from matrixworld.world.world import World

HEIGHT, BELOW = 0.5, 0.42
"""Height of a cell and of the text below a world, in inches."""
MARGIN = 7
"""Pixels around the cells, for rings that are larger."""


class Situation(NamedTuple):
    """A drawing of a small world, and the actions of its agents, pursuers first."""

    name: str
    text: str
    drawing: str
    moves: tuple[Action, ...]


N, E, S, W = Action.NORTH, Action.EAST, Action.SOUTH, Action.WEST
SITUATIONS = (
    Situation("vertex", "two enter one cell", "A . B", (E, W)),
    Situation("edge", "two swap their cells", "A B", (E, W)),
    Situation("following", "one enters the cell\nthat another leaves", "A B .", (E, E)),
    Situation("cycle", "each enters the cell\nof the next", "A B / D C", (E, S, W, N)),
    Situation("blocked", "one follows another\nthat is stopped", "A B #", (E, E)),
    Situation("obstacle", "one runs into an\nobstacle", "A #", (E,)),
    Situation("adversary", "a pursuer and an evader\nenter one cell", "A . a", (E, W)),
)
"""The rows of the figure: the forms of a conflict between teammates, then the other kinds."""


def world_of(situation: Situation, outcome: Outcome) -> World:
    """Return a world in a situation; every kind of collision has one outcome.

    A world has agents of both teams: one more evader waits behind a wall on the right, outside of
    the drawing.
    """
    # Evaders that are surrounded: a meeting is a collision, and no capture.
    rules = Rules(
        obstacle=outcome, teammate=outcome, evader=outcome, pursuer=outcome,
        capture=Capture.SURROUND,
    )  # fmt: skip
    first, *others = situation.drawing.split(" / ")
    return drawn_world(rules, "/".join([f"{first} . # z", *(f"{row} . # ." for row in others)]))


def moves_of(situation: Situation) -> list[Action]:
    """Return the actions of all agents of the world in a situation; who is not in it waits."""
    return [*situation.moves, Action.STAY]


def conflict_outcomes() -> Figure:
    """Draw what happens in each situation under each outcome, as the engine resolves it.

    A row for each of `SITUATIONS`: the planned moves, then the result of the outcomes disappear,
    reach and bounce.
    """
    heights = [HEIGHT * (1 + each.drawing.count("/")) + BELOW for each in SITUATIONS]
    figure = new_figure(8.0, 1.1 + sum(heights))
    grid = figure.subplots(len(SITUATIONS), 4, height_ratios=heights)
    for situation, panels in zip(SITUATIONS, grid, strict=True):
        world = world_of(situation, Outcome.BOUNCE)
        _show(panels[0], plan(world, moves_of(situation)), world)
        label = f"$\\bf{{{situation.name}}}$\n{situation.text}"
        panels[0].annotate(
            label, (0, 0.5), xytext=(-10, 0), xycoords="axes fraction", textcoords="offset points",
            ha="right", va="center", size="small",
        )  # fmt: skip
        for axes, outcome in zip(panels[1:], OUTCOME_TEXTS, strict=True):
            world = world_of(situation, outcome)
            _show(axes, after(world, moves_of(situation)), world)
            texts = [conflict.text.split(": ", 1)[1] for conflict in world.conflicts]
            text = "\n".join(texts) or "no conflict: all move"
            axes.set_xlabel(text, size="small", color=colors.MUTED, labelpad=3)
    for axes, head in zip(grid[0], ("planned moves", *OUTCOME_TEXTS.values()), strict=True):
        axes.set_title(head, fontweight="bold", pad=10)
    figure.suptitle("Conflicts and their outcomes")
    return figure


def _show(axes: Axes, picture: Picture, world: World) -> None:
    """Show the cells of a situation, in the same scale in all panels."""
    left, top, *_ = Layout.of(world.map.shape, CELL).field
    (rows, cols), edge = world.map.shape, MARGIN / CELL
    cols -= 3  # the wall on the right is not shown
    down, right = (
        slice(at - MARGIN, at + n * CELL + MARGIN) for at, n in ((top, rows), (left, cols))
    )
    extent = (-cols / 2 - edge, cols / 2 + edge, -edge, rows + edge)
    axes.imshow(picture.pixels[down, right], extent=extent, interpolation="antialiased")
    axes.set(xlim=(-1.7, 1.7), xticks=[], yticks=[])
    axes.spines[:].set_visible(False)


# ---- Right of way --------------------------------------------------------------------------------

CROSSINGS = (
    ("right before left", "P1 has P0 on its right", (N, E)),
    ("face to face", "east before west", (E, W)),
    ("three", "P0 goes before both", (N, E, S)),
    ("four", "each waits for another", (N, E, S, W)),
)
"""Panels: title, text, and the moves by which pursuers mean to enter the free cell."""


def around(moves: Sequence[Action]) -> Situation:
    """Return the situation of pursuers that mean to enter the middle of 3 x 3 cells."""
    cells = np.full((3, 3), ".")
    for letter, move in zip("ABCD", moves, strict=False):
        cells[tuple(1 - MOVES[move])] = letter
    return Situation("", "", " / ".join(map(" ".join, cells)), tuple(moves))


def may_go(moves: Sequence[Action]) -> list[bool]:
    """Return which of several pursuers around a free cell the mask right-of-way lets enter it."""
    world = world_of(around(moves), Outcome.BOUNCE)
    masks = ActionMasks("right-of-way", world.config).of(world.views())
    return [bool(mask[move]) for mask, move in zip(masks, moves, strict=False)]


def right_of_way() -> Figure:
    """Draw which of several pursuers may enter a free cell, as the mask right-of-way says.

    Right before left, as on a road; of two that face each other, the one that moves north or east.
    """
    look = {"color": colors.INK, "linewidth": 2.5, "shrinkA": 0, "shrinkB": 0}
    figure = new_figure(8.0, 2.9)
    panels = figure.subplots(1, len(CROSSINGS))
    for axes, (title, text, moves) in zip(panels, CROSSINGS, strict=True):
        world = world_of(around(moves), Outcome.BOUNCE)
        _show(axes, plan(world, [Action.STAY] * world.config.n_agents), world)
        for move, goes in zip(moves, may_go(moves), strict=True):
            down, right = MOVES[move].tolist()
            x, y = -right / 2, 1.5 + down / 2  # on the border of the free cell
            # An arrow into the cell, or a bar on its border.
            style, begin, dx, dy = ("-|>", -0.1, right, -down) if goes else ("-", -0.4, down, right)
            ends = [(x + far * dx, y + far * dy) for far in (0.4, begin)]
            axes.annotate("", *ends, arrowprops={"arrowstyle": style, **look})
        axes.set_title(title, fontweight="bold")
        axes.set_xlabel(text, size="small", color=colors.MUTED)
    key: dict[str, Any] = {"linestyle": "", "color": colors.INK, "markersize": 9}
    arrow = Line2D([], [], marker=r"$\rightarrow$", **key)
    waits = Line2D([], [], marker="|", markeredgewidth=3, **key)
    legend_below(figure, {"may go": arrow, "waits": waits})
    return figure


# ---- Rules as a table ----------------------------------------------------------------------------

WIDTHS = np.array([0.7, 1.4, 1.0, 1.0, 1.0, 1.0, 1.2, 1.1])
"""Widths of the columns below `RULES_HEAD`."""
ROW = 0.34
"""Height of a row, in inches."""

FILLS = {
    "disappears": (colors.VERMILLION, colors.PAPER),
    "reaches": (colors.SKY_BLUE, colors.INK),
    "bounces": (colors.GRID, colors.INK),
}
"""Colours of the outcomes, by the first words of their texts: the ground and the text on it."""


def rules_table() -> Figure:
    """Draw the variants as a table: who moves together, what collisions and captures do."""
    rows = [rules_row(name, each) for name, each in VARIANTS.items()]
    figure = new_figure(9.2, 1.15 + ROW * len(rows))
    axes = figure.add_subplot()
    axes.set_axis_off()
    table = axes.table(
        rows, colLabels=RULES_HEAD, colWidths=[*WIDTHS / WIDTHS.sum()], cellLoc="center",
        bbox=Bbox.unit(),
    )  # fmt: skip
    table.auto_set_font_size(False)
    for (row, column), cell in table.get_celld().items():
        text = cell.get_text()
        ground, ink = FILLS.get(text.get_text(), (colors.PAPER, colors.INK))
        bold = row == 0 or column == 0
        cell.set(facecolor=ground, edgecolor=colors.PAPER, linewidth=3)
        cell.set_height(2.0 if row == 0 else 1.0)
        text.set(color=ink, size="small", fontweight="bold" if bold else "normal")
    axes.set_title("The rules of the variants")
    return figure
