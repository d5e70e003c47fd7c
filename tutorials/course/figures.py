"""Figures of the game: conflicts and their outcomes, right of way, rules, models, concepts.

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

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import (
    Circle,
    FancyArrowPatch,
    FancyBboxPatch,
    Patch,
    Rectangle,
    RegularPolygon,
)
from matplotlib.patheffects import withStroke
from matplotlib.transforms import Bbox

from matrixworld._util import colors
from matrixworld.plots.style import legend_below, new_figure
from matrixworld.world.arrays import MOVES
from matrixworld.world.masks import ActionMasks
from matrixworld.world.rules import (
    INTERACTION_TEXTS,
    OUTCOME_TEXTS,
    RULES_HEAD,
    VARIANTS,
    Action,
    Capture,
    Interaction,
    Outcome,
    Rules,
    rules_row,
)
from matrixworld.world.world import World

Cell = tuple[int, int]
Place = tuple[float, float]

CELL, BELOW = 0.5, 0.42
"""Height of a cell and of the text below a world, in inches."""


@dataclass(frozen=True)
class Situation:
    """Agents of a small world, each with its action, and cells with obstacles."""

    name: str
    text: str
    rows: int
    cols: int
    pursuers: tuple[tuple[Cell, Action], ...]
    evaders: tuple[tuple[Cell, Action], ...] = ()
    obstacles: tuple[Cell, ...] = ()

    @property
    def agents(self) -> dict[str, tuple[Cell, Action]]:
        """All agents by their names, pursuers first."""
        pursuers = {f"P{number}": agent for number, agent in enumerate(self.pursuers)}
        return pursuers | {f"E{number}": agent for number, agent in enumerate(self.evaders)}


N, E, S, W = Action.NORTH, Action.EAST, Action.SOUTH, Action.WEST
SITUATIONS = (
    Situation("vertex", "two enter one cell", 1, 3, (((0, 0), E), ((0, 2), W))),
    Situation("edge", "two swap their cells", 1, 2, (((0, 0), E), ((0, 1), W))),
    Situation(
        "following", "one enters the cell\nthat another leaves", 1, 3, (((0, 0), E), ((0, 1), E)),
    ),
    Situation(
        "cycle", "each enters the cell\nof the next", 2, 2,
        (((0, 0), E), ((0, 1), S), ((1, 1), W), ((1, 0), N)),
    ),
    Situation(
        "blocked", "one follows another\nthat is stopped", 1, 3,
        (((0, 0), E), ((0, 1), E)), obstacles=((0, 2),),
    ),
    Situation("obstacle", "one runs into an\nobstacle", 1, 2, (((0, 0), E),), obstacles=((0, 1),)),
    Situation(
        "adversary", "a pursuer and an evader\nenter one cell", 1, 3,
        (((0, 0), E),), (((0, 2), W),),
    ),
)  # fmt: skip
"""The rows of the figure: the forms of a conflict between teammates, then the other kinds."""


def world_of(situation: Situation, outcome: Outcome) -> World:
    """Return a world in a situation; every kind of collision has one outcome.

    The agents of the situation come first. A world has agents of both teams: if no evader is in
    the situation, one waits behind a wall on the right, outside of the drawing.
    """
    walled = situation.cols + 2
    obstacles = np.zeros((situation.rows, walled), bool)
    obstacles[:, situation.cols] = True
    for cell in situation.obstacles:
        obstacles[cell] = True
    pursuers = [cell for cell, _ in situation.pursuers]
    evaders = [cell for cell, _ in situation.evaders] or [(0, walled - 1)]
    # Evaders that are surrounded: a meeting is a collision, and no capture.
    rules = Rules(
        obstacle=outcome, teammate=outcome, evader=outcome, pursuer=outcome,
        capture=Capture.SURROUND,
    )  # fmt: skip
    world = World(
        rules, rows=situation.rows, cols=walled, n_pursuers=len(pursuers), n_evaders=len(evaders),
        obstacles=obstacles,
    )  # fmt: skip
    world.reset(0, pursuers=pursuers, evaders=evaders)
    return world


def resolve(situation: Situation, outcome: Outcome) -> World:
    """Return the world after one step from a situation."""
    world = world_of(situation, outcome)
    actions = [action for _, action in situation.agents.values()]
    waiting = [Action.STAY] * (world.config.n_agents - len(actions))
    world.step(actions + waiting, explain=True)
    return world


_MARK: dict[str, Any] = {"linestyle": "", "color": colors.COLLISION, "markersize": 9}


def conflict_outcomes() -> Figure:
    """Draw what happens in each situation under each outcome, as the engine resolves it.

    A row for each of `SITUATIONS`: the planned moves, then the result of the outcomes disappear,
    reach and bounce.
    """
    heights = [CELL * situation.rows + BELOW for situation in SITUATIONS]
    figure = new_figure(8.0, 1.1 + sum(heights))
    grid = figure.subplots(len(SITUATIONS), 4, height_ratios=heights)
    for situation, panels in zip(SITUATIONS, grid, strict=True):
        _draw_plan(panels[0], situation)
        for axes, outcome in zip(panels[1:], OUTCOME_TEXTS, strict=True):
            _draw_result(axes, situation, resolve(situation, outcome))
    for axes, head in zip(grid[0], ("planned moves", *OUTCOME_TEXTS.values()), strict=True):
        axes.set_title(head, fontweight="bold", pad=10)
    marks = {
        "removed": Line2D([], [], marker="x", markeredgewidth=2, **_MARK),
        "had to stay": Line2D([], [], marker="o", markerfacecolor="none", **_MARK),
    }
    legend_below(figure, marks)
    figure.suptitle("Conflicts and their outcomes")
    return figure


def _draw_plan(axes: Axes, situation: Situation) -> None:
    _draw_cells(axes, situation)
    for name, (cell, action) in situation.agents.items():
        _draw_agent(axes, cell, name)
        _draw_move(axes, cell, action)
    label = f"$\\bf{{{situation.name}}}$\n{situation.text}"
    axes.annotate(
        label, (0, 0.5), xytext=(-10, 0), xycoords="axes fraction", textcoords="offset points",
        ha="right", va="center", size="small",
    )  # fmt: skip


def _draw_result(axes: Axes, situation: Situation, world: World) -> None:
    """Draw the living and, where they disappeared, the others; below, the engine's words."""
    _draw_cells(axes, situation)
    cells = [(row, col) for row, col in world.last_positions.tolist()]
    agents = list(zip(situation.agents, cells, world.alive, strict=False))
    taken = [cell for _, cell, alive in agents if alive]
    for row, col in {cell for _, cell, alive in agents if not alive}:
        # In a corner if another agent is there.
        aside, size = (0.33, 6) if (row, col) in taken else (0, 13)
        axes.plot(
            [col - aside], [row - aside], marker="x", markersize=size, markeredgewidth=size / 5,
            color=colors.COLLISION, zorder=2,
        )  # fmt: skip
    held = {agent for conflict in world.conflicts for agent in conflict.held}
    drawn: list[Cell] = []
    for agent, (name, cell, alive) in enumerate(agents):
        if alive:
            _draw_agent(axes, cell, name, place=drawn.count(cell), among=taken.count(cell))
            drawn.append(cell)
            if agent in held:
                look: dict[str, Any] = {"edgecolor": colors.COLLISION, "linewidth": 1.8}
                axes.add_patch(Circle(cell[::-1], 0.46, fill=False, zorder=2, **look))
    texts = [conflict.text.split(": ", 1)[1] for conflict in world.conflicts]
    text = "\n".join(texts) or "no conflict: all move"
    axes.set_xlabel(text, size="small", color=colors.MUTED, labelpad=3)


def _draw_cells(axes: Axes, situation: Situation) -> None:
    for row, col in np.ndindex(situation.rows, situation.cols):
        filled = colors.OBSTACLE if (row, col) in situation.obstacles else colors.PAPER
        look: dict[str, Any] = {"facecolor": filled, "edgecolor": colors.MUTED, "linewidth": 0.8}
        axes.add_patch(Rectangle((col - 0.5, row - 0.5), 1, 1, **look))
    # The same scale in all panels of the figure; row 0 is on top.
    middle = situation.cols / 2 - 0.5
    axes.set(xlim=(middle - 1.6, middle + 1.6), ylim=(situation.rows - 0.45, -0.55))
    axes.set(xticks=[], yticks=[], aspect="equal")
    axes.spines[:].set_visible(False)


# ---- Parts of a board, which look like the pictures of `matrixworld.episodes` --------------------


def _draw_agent(axes: Axes, cell: Cell, name: str, *, place: int = 0, among: int = 1) -> None:
    """Draw an agent: an orange triangle for a pursuer "P0", a blue disc for an evader "E0".

    The cell is row and column; several agents on it have a place `among` so many.
    """
    row, col = cell
    radius = 0.33 if among == 1 else 0.24  # in cells
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
    size = "small" if among == 1 else "x-small"
    _write(axes, x, y + 0.02, name, color=colors.PAPER, size=size, fontweight="bold", zorder=4)


def _draw_move(axes: Axes, cell: Cell, action: Action) -> None:
    """Draw the planned move of an agent: an arrow over the edge of its cell."""
    (row, col), (down, right) = cell, MOVES[action].tolist()
    # On the left of the agent's way, so that the arrows of a swap are beside each other.
    aside = 0.34
    x, y = col + down * aside + right * 0.24, row - right * aside + down * 0.24
    look: dict[str, Any] = {"linewidth": 1.3, "color": colors.INK, "shrinkA": 0, "shrinkB": 0}
    on_obstacles = [withStroke(linewidth=3, foreground=colors.PAPER)]
    _draw_arrow(
        axes, (x, y), (x + 0.52 * right, y + 0.52 * down), mutation_scale=9, zorder=5,
        path_effects=on_obstacles, **look,
    )  # fmt: skip


def _draw_arrow(axes: Axes, begin: Place, end: Place, **look: Any) -> None:
    axes.add_patch(FancyArrowPatch(begin, end, arrowstyle="-|>", **look))


def _draw_box(axes: Axes, corner: Place, size: Place, rounding: float, **look: Any) -> None:
    box = f"round,pad=0,rounding_size={rounding}"
    axes.add_patch(FancyBboxPatch(corner, *size, boxstyle=box, **look))


def _write(axes: Axes, x: float, y: float, text: str, **look: Any) -> None:
    axes.text(x, y, text, **{"ha": "center", "va": "center", "size": "small", **look})


# ---- Right of way --------------------------------------------------------------------------------

CROSSINGS = (
    ("right before left", "P1 has P0 on its right", (N, E)),
    ("face to face", "east before west", (E, W)),
    ("three", "P0 goes before both", (N, E, S)),
    ("four", "each waits for another", (N, E, S, W)),
)
"""Panels: title, text, and the moves by which pursuers mean to enter the free cell."""


def may_go(moves: Sequence[Action]) -> list[bool]:
    """Return which of several pursuers around a free cell the mask right-of-way lets enter it."""
    around = tuple(((1 - row, 1 - col), move) for move in moves for row, col in [MOVES[move]])
    world = world_of(Situation("", "", 3, 3, around), Outcome.BOUNCE)
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
        _draw_cells(axes, Situation(title, text, 3, 3, ()))
        for agent, (move, goes) in enumerate(zip(moves, may_go(moves), strict=True)):
            down, right = MOVES[move]
            _draw_agent(axes, (1 - down, 1 - right), f"P{agent}")
            x, y = 1 - right / 2, 1 - down / 2  # on the border of the free cell
            # An arrow into the cell, or a bar on its border.
            style, begin, dx, dy = ("-|>", -0.1, right, down) if goes else ("-", -0.4, down, right)
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


# ---- Interaction models --------------------------------------------------------------------------

GAMES = {
    Interaction.SIMULTANEOUS: "stochastic (Markov)\ngame",
    Interaction.SWARM_TURNS: "two-swarm\nturn-taking game",
    Interaction.AGENT_TURNS: "agent environment\ncycle game",
}
"""What the theory of games calls each model."""

PER_TEAM = 2
"""Pursuers, and evaders, in the drawing."""
NAMES = [*(f"P{i}" for i in range(PER_TEAM)), *(f"E{i}" for i in range(PER_TEAM))]
STATE = len(NAMES) + 0.35
"""Height of the row of states, below the agents."""


def turns_of(interaction: Interaction) -> list[range]:
    """Return the agents that act in each turn of a round, as a `World` plays it; pursuers first."""
    world = World(Rules(interaction), rows=4, cols=4, n_pursuers=PER_TEAM, n_evaders=PER_TEAM)
    world.reset(0, pursuers=[[0, 0], [0, 1]], evaders=[[3, 2], [3, 3]])
    turns = []
    for _ in range(world.n_turns):
        turns.append(world.actors)
        world.play_turn([Action.STAY] * len(NAMES))
    return turns


def interaction_models() -> Figure:
    """Draw which agents observe and act together: all at once, team by team, one at a time.

    One panel for each `Interaction`. Time runs to the right, in turns.
    """
    models = list(Interaction)
    rounds = [turns_of(each) for each in models]
    figure = new_figure(10.0, 3.9)
    panels = figure.subplots(1, len(models), width_ratios=[len(turns) + 0.9 for turns in rounds])
    for axes, interaction, turns in zip(panels, models, rounds, strict=True):
        _draw_round(axes, turns)
        axes.set_title(f"{INTERACTION_TEXTS[interaction]}\n", fontweight="bold")
        axes.set_xlabel(GAMES[interaction])
    _name_rows(panels[0])
    entries = {
        "observes the state": Line2D([], [], color=colors.MUTED, linewidth=0.9),
        "acts on it (colour of the team)": Line2D([], [], color=colors.INK, linewidth=1.3),
        "state before and after the round": Patch(facecolor=colors.INK),
        "state between two turns": Patch(facecolor=colors.PAPER, edgecolor=colors.INK),
    }
    legend_below(figure, entries)
    figure.suptitle("One round of the three interaction models")
    return figure


def _draw_round(axes: Axes, turns: list[range]) -> None:
    length = len(turns)
    for agent in range(len(NAMES)):
        axes.plot([-0.3, length + 0.3], [agent] * 2, color=colors.GRID, linewidth=1, zorder=0)
    axes.plot([0, length], [STATE] * 2, color=colors.MUTED, linewidth=1, zorder=0)
    for place in range(length + 1):  # the world at the begin and the end of the round, and between
        filled = colors.INK if place in (0, length) else colors.PAPER
        look: dict[str, Any] = {"facecolor": filled, "edgecolor": colors.INK, "zorder": 3}
        _draw_box(axes, (place - 0.13, STATE - 0.2), (0.26, 0.4), 0.08, **look)
    for turn, agents in enumerate(turns):
        for agent in agents:
            _draw_action(axes, turn, agent)
        axes.text(turn + 0.5, -0.75, f"turn {turn}", ha="center", size="small", color=colors.MUTED)
    axes.set(xlim=(-0.45, length + 0.45), ylim=(STATE + 0.45, -1.0), xticks=[], yticks=[])
    axes.spines[:].set_visible(False)


def _draw_action(axes: Axes, turn: int, agent: int) -> None:
    """Draw how an agent observes the state before a turn, and changes that after it."""
    middle, team = turn + 0.5, int(agent >= PER_TEAM)
    color = colors.TEAMS[team]
    arrows = (
        ((turn + 0.1, STATE - 0.22), (middle - 0.08, agent + 0.17), colors.MUTED, 0.9),
        ((middle + 0.08, agent + 0.17), (turn + 0.9, STATE - 0.22), color, 1.3),
    )
    for begin, end, ink, width in arrows:
        look: dict[str, Any] = {"color": ink, "linewidth": width, "shrinkA": 0, "shrinkB": 0}
        _draw_arrow(axes, begin, end, mutation_scale=8, zorder=2, **look)
    axes.plot([middle], [agent], marker="^o"[team], markersize=10, color=color, zorder=4)


def _name_rows(axes: Axes) -> None:
    axes.set_yticks([*range(len(NAMES)), STATE], [*NAMES, "world"])
    axes.tick_params(axis="y", length=0)
    inks = [*np.repeat(colors.TEAMS, PER_TEAM), colors.INK]
    for label, ink in zip(axes.get_yticklabels(), inks, strict=True):
        label.set_color(ink)


# ---- Concepts ------------------------------------------------------------------------------------

AREAS = (
    (0.1, 1.0, 6.6, 4.9, colors.SKY_BLUE, 0.25),
    (3.3, 0.4, 6.6, 4.9, colors.ORANGE, 0.25),
    (3.5, 1.2, 3.0, 3.9, colors.PAPER, 1.0),
)
"""Co-evolution, curriculum learning, and what is both, where the tasks are opponents that learn:
left, bottom, width, height, colour and opacity of a box."""
NOTES = (
    (1.7, 5.2, "", "the fitness of one learner\ndepends on other learners"),
    (1.7, 3.8, "cooperative\nco-evolution", "partners that learn\nfor a common aim"),
    (1.7, 2.0, "", "one population or several,\nequal roles or different ones"),
    (8.3, 4.55, "", "tasks in a sequence,\nfor example easy to hard"),
    (8.3, 3.25, "by hand", "a teacher chooses\nthe tasks"),
    (8.3, 1.6, "automatic", "a rule chooses\nthe tasks"),
    (5.0, 4.5, "self-play,\nautocurriculum", "rivals set each\nother's tasks"),
    (5.0, 2.0, "adversarial learning", "one way to do it: rivals\nlearn in turns"),
    (1.7, 0.42, "", "not co-evolution: only one side\nlearns against a fixed rival"),
)
"""Texts in the areas: their places, words in bold, and what they mean."""


def learning_concepts() -> Figure:
    """Draw how co-evolution, self-play, autocurricula, arms races and curricula are related.

    References
    ----------
    Sun et al. (2023), "MatrixWorld", section 2; Leibo et al. (2019), "Autocurricula and the
    emergence of innovation from social interaction".
    """
    figure = new_figure(8.0, 5.0)
    axes = figure.subplots()
    axes.set(xlim=(0.0, 10.0), ylim=(0.0, 6.0))
    axes.axis("off")
    for x, y, width, height, color, alpha in AREAS:
        ground: dict[str, Any] = {"facecolor": color, "alpha": alpha, "edgecolor": "none"}
        outline: dict[str, Any] = {"facecolor": "none", "linewidth": 1.2, "edgecolor": colors.INK}
        for look in (ground, outline):
            _draw_box(axes, (x, y), (width, height), 0.18, **look)
    name: dict[str, Any] = {"va": "center", "weight": "bold", "size": "large"}
    # The names of both are where the other one is not.
    axes.text(0.35, 5.62, "co-evolution", ha="left", **name)
    axes.text(9.65, 5.02, "curriculum learning", ha="right", **name)
    for x, y, head, text in NOTES:
        lines = head.count("\n") + 1 if head else 0
        if head:
            axes.text(x, y, head, ha="center", va="center", weight="bold", linespacing=1.1)
        below = y - 0.13 * lines - 0.08 if lines else y + 0.2
        axes.text(x, below, text, ha="center", va="top", size="small", linespacing=1.15)
    # Each side adapts to the other.
    for begin, end, y in ((4.25, 5.75, 3.03), (5.75, 4.25, 2.87)):
        _draw_arrow(axes, (begin, y), (end, y), mutation_scale=12, color=colors.INK)
    axes.text(5.0, 3.28, "arms race", ha="center", va="center", weight="bold")
    axes.text(5.0, 2.6, "each adapts to the other", ha="center", va="center", size="small")
    axes.plot(4.0, 2.95, "^", color=colors.PURSUER, markersize=9)
    axes.plot(6.0, 2.95, "o", color=colors.EVADER, markersize=8)
    return figure


PICTURES = {
    "conflicts": conflict_outcomes,
    "interaction": interaction_models,
    "right_of_way": right_of_way,
}
"""Figures that the documentation shows, by the names of their files."""
