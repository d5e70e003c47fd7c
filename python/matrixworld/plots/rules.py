"""Figures of rules: the variants as a table, and the turns of the interaction models.

References
----------
S. J. Russell and P. Norvig (2021). Artificial intelligence: a modern approach.
J. K. Terry et al. (2021). PettingZoo: Gym for multi-agent reinforcement learning.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import FancyArrowPatch, FancyBboxPatch, Patch

from matrixworld._util import colors
from matrixworld.plots.style import fitting, legend_below, new_figure
from matrixworld.world.rules import (
    CAPTURE_TEXTS,
    INTERACTION_TEXTS,
    OUTCOME_TEXTS,
    VARIANTS,
    Action,
    Interaction,
    Outcome,
    Rules,
)
from matrixworld.world.world import World

COLUMNS = {
    "variant": 0.5,
    "agents move": 1.7,
    "obstacle": 3.25,
    "teammate": 4.55,
    "evader": 5.85,
    "pursuer": 7.15,
    "capture by": 8.5,
    "the captured": 9.85,
}
"""Heads of the columns, and the middle of each in tenths of the width."""
GROUPS = {
    "collision with": ("obstacle", "teammate"),
    "collision of adversaries": ("evader", "pursuer"),
}
"""Heads above several columns: the first and the last of them."""
WIDTH = 10.5
ROW = 0.34
"""Height of a row, in inches."""

FILLS = {
    Outcome.DISAPPEAR: (colors.VERMILLION, colors.PAPER),
    Outcome.REACH: (colors.SKY_BLUE, colors.INK),
    Outcome.BOUNCE: (colors.GRID, colors.INK),
}
"""Colours of the outcomes: the ground and the text on it."""


def rules_table(
    rules: Mapping[str, Rules] = VARIANTS, *, title: str = "The rules of the variants"
) -> Figure:
    """Draw rules as a table: which agents move together, what a collision does, what a capture is.

    Parameters
    ----------
    rules : mapping of str to Rules, optional
        The rows, by name. The default is the nine variants.
    title : str, optional
        Title of the figure.
    """
    if not rules:
        raise ValueError("rules: expected at least one row, got none")
    figure = new_figure(9.2, 1.15 + ROW * len(rules))
    axes = figure.add_subplot()
    axes.set(xlim=(0, WIDTH), ylim=(len(rules) - 0.5, -2.1))
    axes.set_axis_off()
    _write_heads(axes)
    for row, (name, each) in enumerate(rules.items()):
        _write_row(axes, row, name, each)
    axes.set_title(fitting(figure, title))
    return figure


def _write_heads(axes: Axes) -> None:
    for head, place in COLUMNS.items():
        _write(axes, place, -1.0, head, fontweight="bold")
    for head, (first, last) in GROUPS.items():
        left, right = COLUMNS[first], COLUMNS[last]
        _write(axes, (left + right) / 2, -1.85, head, color=colors.MUTED)
        axes.plot([left - 0.55, right + 0.55], [-1.45] * 2, color=colors.MUTED, linewidth=0.8)
    axes.plot([0, WIDTH], [-0.55] * 2, color=colors.INK, linewidth=1.0)


def _write_row(axes: Axes, row: int, name: str, rules: Rules) -> None:
    if row:
        axes.plot([0, WIDTH], [row - 0.5] * 2, color=colors.GRID, linewidth=0.8)
    _write(axes, COLUMNS["variant"], row, f"-{name}" if name in VARIANTS else name, weight="bold")
    _write(axes, COLUMNS["agents move"], row, INTERACTION_TEXTS[rules.interaction])
    for field in ("obstacle", "teammate", "evader", "pursuer"):
        _write_outcome(axes, COLUMNS[field], row, getattr(rules, field))
    _write(axes, COLUMNS["capture by"], row, CAPTURE_TEXTS[rules.capture])
    fate = ("disappear" if rules.removes_captured else "stay") if rules.captures else "none"
    _write(axes, COLUMNS["the captured"], row, fate)


def _write_outcome(axes: Axes, place: float, row: int, outcome: Outcome) -> None:
    ground, ink = FILLS[outcome]
    axes.add_patch(
        FancyBboxPatch(
            (place - 0.5, row - 0.3), 1.0, 0.6, facecolor=ground, linewidth=0,
            boxstyle="round,pad=0,rounding_size=0.12",
        )
    )  # fmt: skip
    # The first word: reaches, bounces, disappears.
    _write(axes, place, row, OUTCOME_TEXTS[outcome].split()[0], color=ink)


def _write(axes: Axes, x: float, y: float, text: str, **look: Any) -> None:
    axes.text(x, y, text, **{"ha": "center", "va": "center", "size": "small", **look})


# ---- Interaction models --------------------------------------------------------------------------


GAMES = {
    Interaction.SIMULTANEOUS: "stochastic (Markov) game",
    Interaction.SWARM_TURNS: "two-swarm turn-taking game",
    Interaction.AGENT_TURNS: "agent environment cycle game",
}
"""What the theory of games calls each model."""

PER_TEAM = 2
"""Pursuers, and evaders, in the drawing."""
NAMES = [*(f"P{i}" for i in range(PER_TEAM)), *(f"E{i}" for i in range(PER_TEAM))]
STATE = len(NAMES) + 0.35
"""Height of the row of states, below the agents."""


def turns_of(interaction: Interaction) -> list[range]:
    """Return the agents that act in each turn of a round, as a `World` plays it.

    Parameters
    ----------
    interaction : Interaction
        The model.

    Returns
    -------
    list of range
        The agents of each turn; pursuers first. The world has `PER_TEAM` agents of each team.
    """
    world = World(Rules(interaction), rows=4, cols=4, n_pursuers=PER_TEAM, n_evaders=PER_TEAM)
    world.reset(0, pursuers=[[0, 0], [0, 1]], evaders=[[3, 2], [3, 3]])
    turns = []
    for _ in range(world.n_turns):
        turns.append(world.actors)
        world.play_turn([Action.STAY] * len(NAMES))
    return turns


def interaction_models(*, title: str = "One round of the three interaction models") -> Figure:
    """Draw which agents observe and act together: all at once, team by team, one at a time.

    Parameters
    ----------
    title : str, optional
        Title of the figure.

    Returns
    -------
    matplotlib.figure.Figure
        One panel for each `Interaction`. Time runs to the right, in turns.
    """
    models = list(Interaction)
    rounds = [turns_of(each) for each in models]
    figure = new_figure(10.0, 3.9)
    panels = figure.subplots(1, len(models), width_ratios=[len(turns) + 0.9 for turns in rounds])
    for axes, interaction, turns in zip(panels, models, rounds, strict=True):
        _draw_round(axes, turns)
        axes.set_title(f"{INTERACTION_TEXTS[interaction]}\n", fontweight="bold")
        name = GAMES[interaction].replace(" turn", "\nturn").replace(" cycle", "\ncycle")
        axes.set_xlabel(name.replace(") game", ")\ngame"))
    _name_rows(panels[0])
    entries = {
        "observes the state": Line2D([], [], color=colors.MUTED, linewidth=0.9),
        "acts on it (colour of the team)": Line2D([], [], color=colors.INK, linewidth=1.3),
        "state before and after the round": Patch(facecolor=colors.INK),
        "state between two turns": Patch(facecolor=colors.PAPER, edgecolor=colors.INK),
    }
    legend_below(figure, [*entries.values()], [*entries])
    figure.suptitle(fitting(figure, title))
    return figure


def _draw_round(axes: Axes, turns: list[range]) -> None:
    length = len(turns)
    for agent in range(len(NAMES)):
        axes.plot([-0.3, length + 0.3], [agent] * 2, color=colors.GRID, linewidth=1, zorder=0)
    axes.plot([0, length], [STATE] * 2, color=colors.MUTED, linewidth=1, zorder=0)
    for place in range(length + 1):
        _draw_state(axes, place, place in (0, length))
    for turn, agents in enumerate(turns):
        for agent in agents:
            _draw_action(axes, turn, agent)
        axes.text(turn + 0.5, -0.75, f"turn {turn}", ha="center", size="small", color=colors.MUTED)
    axes.set(xlim=(-0.45, length + 0.45), ylim=(STATE + 0.45, -1.0), xticks=[], yticks=[])
    axes.spines[:].set_visible(False)


def _draw_state(axes: Axes, place: int, begins: bool) -> None:
    """Draw a state of the world: strong at the begin and the end of the round."""
    axes.add_patch(
        FancyBboxPatch(
            (place - 0.13, STATE - 0.2), 0.26, 0.4, boxstyle="round,pad=0,rounding_size=0.08",
            facecolor=colors.INK if begins else colors.PAPER, edgecolor=colors.INK, zorder=3,
        )
    )  # fmt: skip


def _draw_action(axes: Axes, turn: int, agent: int) -> None:
    """Draw how an agent observes the state before a turn, and changes that after it."""
    middle = turn + 0.5
    color = colors.TEAMS[agent >= PER_TEAM]
    arrows = (
        ((turn + 0.1, STATE - 0.22), (middle - 0.08, agent + 0.17), colors.MUTED, 0.9),
        ((middle + 0.08, agent + 0.17), (turn + 0.9, STATE - 0.22), color, 1.3),
    )
    for begin, end, ink, width in arrows:
        axes.add_patch(
            FancyArrowPatch(
                begin, end, arrowstyle="-|>", mutation_scale=8, color=ink, linewidth=width,
                shrinkA=0, shrinkB=0, zorder=2,
            )
        )  # fmt: skip
    axes.plot([middle], [agent], marker="o" if agent >= PER_TEAM else "^", markersize=10,
              color=color, zorder=4)  # fmt: skip


def _name_rows(axes: Axes) -> None:
    axes.set_yticks([*range(len(NAMES)), STATE], [*NAMES, "world"])
    axes.tick_params(axis="y", length=0)
    inks = [*np.repeat(colors.TEAMS, PER_TEAM), colors.INK]
    for label, ink in zip(axes.get_yticklabels(), inks, strict=True):
        label.set_color(ink)
