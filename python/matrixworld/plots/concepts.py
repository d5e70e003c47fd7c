"""Figure of concepts: how co-evolution, self-play, autocurricula and arms races are related."""

from __future__ import annotations

from typing import Any, NamedTuple

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import FancyArrowPatch, FancyBboxPatch

from matrixworld._util import colors
from matrixworld.plots.style import new_figure


class Area(NamedTuple):
    """A box that stands for a concept: left, bottom, width, height, name, colour."""

    x: float
    y: float
    width: float
    height: float
    name: str
    color: str


class Note(NamedTuple):
    """A text in an area: its place, words in bold, and what they mean."""

    x: float
    y: float
    name: str
    text: str


AREAS = (
    Area(0.1, 1.0, 6.6, 4.9, "co-evolution", colors.SKY_BLUE),
    Area(3.3, 0.4, 6.6, 4.9, "curriculum learning", colors.ORANGE),
)
SHARED = Area(3.5, 1.2, 3.0, 3.9, "", colors.PAPER)
"""What is both: the tasks are opponents that learn."""
NOTES = (
    Note(1.7, 5.2, "", "the fitness of one learner\ndepends on other learners"),
    Note(1.7, 3.8, "cooperative\nco-evolution", "partners that learn\nfor a common aim"),
    Note(1.7, 2.0, "", "one population or several,\nequal roles or different ones"),
    Note(8.3, 4.55, "", "tasks in a sequence,\nfor example easy to hard"),
    Note(8.3, 3.25, "by hand", "a teacher chooses\nthe tasks"),
    Note(8.3, 1.6, "automatic", "a rule chooses\nthe tasks"),
    Note(5.0, 4.5, "self-play,\nautocurriculum", "rivals set each\nother's tasks"),
    Note(5.0, 2.0, "adversarial learning", "one way to do it: rivals\nlearn in turns"),
    Note(1.7, 0.42, "", "not co-evolution: only one side\nlearns against a fixed rival"),
)


def learning_concepts() -> Figure:
    """Draw how co-evolution, self-play, autocurricula, arms races and curricula are related.

    References
    ----------
    Sun et al. (2023), "MatrixWorld", section 2; Leibo et al. (2019), "Autocurricula and the
    emergence of innovation from social interaction".
    """
    figure = new_figure(8.0, 5.0, shrinks=False)
    axes = figure.subplots()
    axes.set(xlim=(0.0, 10.0), ylim=(0.0, 6.0))
    axes.axis("off")
    for area in AREAS:
        _draw_area(axes, area, alpha=0.25)
        # The names of both are where the other one is not.
        x = area.x + 0.25 if area is AREAS[0] else area.x + area.width - 0.25
        side = "left" if area is AREAS[0] else "right"
        top = area.y + area.height - 0.28
        axes.text(x, top, area.name, ha=side, va="center", weight="bold", size="large")
    _draw_area(axes, SHARED, alpha=1.0)
    for note in NOTES:
        _draw_note(axes, note)
    _draw_arms_race(axes)
    return figure


def _draw_area(axes: Axes, area: Area, *, alpha: float) -> None:
    style = "round,pad=0,rounding_size=0.18"
    place = (area.x, area.y)
    ground: dict[str, Any] = {"facecolor": area.color, "alpha": alpha, "edgecolor": "none"}
    outline: dict[str, Any] = {"facecolor": "none", "linewidth": 1.2, "edgecolor": colors.INK}
    for look in (ground, outline):
        axes.add_patch(FancyBboxPatch(place, area.width, area.height, boxstyle=style, **look))


def _draw_note(axes: Axes, note: Note) -> None:
    lines = note.name.count("\n") + 1 if note.name else 0
    if note.name:
        axes.text(
            note.x, note.y, note.name, ha="center", va="center", weight="bold", linespacing=1.1
        )
    below = note.y - 0.13 * lines - 0.08 if lines else note.y + 0.2
    axes.text(note.x, below, note.text, ha="center", va="top", size="small", linespacing=1.15)


def _draw_arms_race(axes: Axes) -> None:
    # Each side adapts to the other.
    for begin, end, y in ((4.25, 5.75, 3.03), (5.75, 4.25, 2.87)):
        axes.add_patch(
            FancyArrowPatch(
                (begin, y), (end, y), arrowstyle="-|>", mutation_scale=12, color=colors.INK
            )
        )
    axes.text(5.0, 3.28, "arms race", ha="center", va="center", weight="bold")
    axes.text(5.0, 2.6, "each adapts to the other", ha="center", va="center", size="small")
    axes.plot(4.0, 2.95, "^", color=colors.PURSUER, markersize=9)
    axes.plot(6.0, 2.95, "o", color=colors.EVADER, markersize=8)
