"""The figure of the documentation that shows which agents observe and act together."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import FancyArrowPatch, FancyBboxPatch, Patch

from matrixworld._util import colors
from matrixworld.plots.style import legend_below, new_figure
from matrixworld.world.rules import INTERACTION_TEXTS, Action, Interaction, Rules
from matrixworld.world.world import World

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
        box = FancyBboxPatch(
            (place - 0.13, STATE - 0.2),
            0.26,
            0.4,
            boxstyle="round,pad=0,rounding_size=0.08",
            **look,
        )
        axes.add_patch(box)
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
        arrow = FancyArrowPatch(begin, end, arrowstyle="-|>", mutation_scale=8, zorder=2, **look)
        axes.add_patch(arrow)
    axes.plot([middle], [agent], marker="^o"[team], markersize=10, color=color, zorder=4)


def _name_rows(axes: Axes) -> None:
    axes.set_yticks([*range(len(NAMES)), STATE], [*NAMES, "world"])
    axes.tick_params(axis="y", length=0)
    inks = [*np.repeat(colors.TEAMS, PER_TEAM), colors.INK]
    for label, ink in zip(axes.get_yticklabels(), inks, strict=True):
        label.set_color(ink)
