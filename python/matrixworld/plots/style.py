"""What all figures share: size, title, legend, axes, and files: pixels or vector graphics."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from pathlib import Path
from typing import Any, NamedTuple, TypeVar

import matplotlib as mpl
import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine
from matplotlib.ticker import MaxNLocator
from numpy.typing import ArrayLike

from matrixworld._util import colors
from matrixworld._util.checks import check_instance, check_sequence
from matrixworld._util.files import replacing
from matrixworld._util.teams import BOTH
from matrixworld.analysis.intervals import Band
from matrixworld.analysis.payoffs import require

OfName = TypeVar("OfName")

DPI = 150  # resolution of saved figures

CHARACTERS = 106.0  # characters of one point that an inch holds, about
LARGE = 1.2  # size of titles, as a multiple of the type
HANDLE = 7  # characters that a line of a legend takes beside its name

COLUMN, PAGE = 3.4, 7.0
"""Widths in inches of one column of a paper and of both, for figures that are printed so."""
_IN_COLUMN: ContextVar[bool] = ContextVar("in_column", default=False)
_TYPE: dict[Any, Any] = {"font.size": 8.0, "axes.titlesize": "medium", "figure.titlesize": "medium"}

DASHES = ("--", ":", "-.")  # line styles beside the solid one
EVADERS = "--"
"""Line style of evaders: in grey both teams have the same tone. Pursuers have solid lines."""
_COLORS = (colors.BLUE, colors.VERMILLION, colors.GREEN, colors.PURPLE, colors.ORANGE)
LINES: tuple[tuple[str, Any], ...] = tuple(
    (_COLORS[group % 5], ("-", *DASHES)[group % 4]) for group in range(20)
)
"""Colour and dashes of each group of runs, in their order; neighbours differ in grey, too."""
MOST_LINES = 10  # with more runs the single ones are not drawn: their lines would hide the band


class Words(NamedTuple):
    """What the axes and legends of a game say; of pursuit by default."""

    teams: tuple[str, str] = BOTH
    score: str = "capture rate"
    generations: tuple[str, str] = ("pursuer generation", "evader generation")
    lag: str = "lag: pursuer minus\nevader generation"
    scale: str = "capture rate\n(0 all escape, 1 all caught)"
    scores: tuple[str, str] = (
        "pursuers (score: capture rate)",
        "evaders (score: 1 - capture rate)",
    )

    def begin(self, rest: str) -> str:
        """Return a title that begins with what the score is."""
        return f"{self.score[0].upper()}{self.score[1:]}{rest}"


def words_of(teams: Sequence[str], *, general: bool = False) -> Words:
    """Return the words of a game with these names of its teams.

    In a `general` one both teams have scores of their own.
    """
    words = _words_of_constant_sum(teams)
    if not general:
        return words
    first, second = (f"{name} (own score)" for name in words.teams)
    return words._replace(scale=f"{words.score}\n(0 worst, 1 best)", scores=(first, second))


def _words_of_constant_sum(teams: Sequence[str]) -> Words:
    names = check_sequence("teams", teams, "two texts")
    require(len(names) == 2, "names of two teams", names)
    first, second = names
    if (first, second) == BOTH:
        return Words()
    if first == second:  # one population
        return Words(
            (first, second),
            f"score of {first}",
            (f"generation of {first}", "generation of the opponent"),
            "lag: generation minus\nthat of the opponent",
            f"score of {first}\n(0 loses, 1 wins)",
            (f"{first} (score)", f"{first} (score)"),
        )
    return Words(
        (first, second),
        f"score of {first}",
        (f"generation of {first}", f"generation of {second}"),
        f"lag: generation of {first} minus\nthat of {second}",
        f"score of {first}\n(0 {second} win, 1 {first} win)",
        (f"{first} (score)", f"{second} (1 - score)"),
    )


@contextmanager
def column() -> Iterator[None]:
    """Let figures be as wide as a column of a paper, with type that is read at this width."""
    token = _IN_COLUMN.set(True)
    try:
        with mpl.rc_context(_TYPE):
            yield
    finally:
        _IN_COLUMN.reset(token)


def beside(panels: int) -> int:
    """Return how many of so many panels stand beside each other: in a column one."""
    return 1 if _IN_COLUMN.get() else panels


def new_figure(width: float, height: float, *, panels: int = 1) -> Figure:
    """Return an empty figure; sizes are in inches.

    In a `column` it is no wider than that; with several `panels` beside each other it takes a page.
    """
    if _IN_COLUMN.get():
        width = min(width, COLUMN if panels == 1 else PAGE)
    layout = ConstrainedLayoutEngine(w_pad=0.04, h_pad=0.04)
    return Figure(figsize=(width, height), dpi=DPI, layout=layout)


def room(figure: Figure, columns: float = 1, size: float = 1.0) -> int:
    """Return about how many characters fit beside each other into a column of a figure."""
    return int(CHARACTERS * figure.get_figwidth() / columns / (size * mpl.rcParams["font.size"]))


def wrapped(text: str, width: int) -> str:
    """Return text in lines of at most `width` characters; paths may break after a slash."""
    check_instance("title or name", text, str)
    lines = [textwrap.wrap(line.replace("/", "/ "), width) for line in text.splitlines()]
    return "\n".join(part.replace("/ ", "/") for line in lines for part in line)


def fitting(figure: Figure, title: str) -> str:
    """Return a title in as many lines as it needs in a figure."""
    return wrapped(title, room(figure, size=LARGE))


def single(width: float, height: float, title: str | None = None) -> tuple[Figure, Axes]:
    """Return a figure of one panel, perhaps with a title above it."""
    figure = new_figure(width, height)
    axes = figure.add_subplot()
    if title is not None:
        axes.set_title(fitting(figure, title))
    return figure, axes


def check_some(groups: Mapping[str, object], what: str = "group of runs") -> None:
    """Raise TypeError unless groups are named, and ValueError if there is nothing to draw."""
    check_instance(f"{what}s by name", groups, Mapping)
    require(len(groups) > 0, f"at least one {what} to draw", "none")


def by_name(name: str, values: Mapping[str, OfName] | None) -> Mapping[str, OfName]:
    """Return an optional argument with a value for each name; TypeError if it has no names."""
    if values is None:
        return {}
    check_instance(name, values, Mapping)
    return values


def labelled(*panels: Axes) -> dict[str, Artist]:
    """Return what is labelled in some panels, each label once, for a legend."""
    found = (axes.get_legend_handles_labels() for axes in panels)
    return {label: handle for each in found for handle, label in zip(*each, strict=True)}


def legend_below(figure: Figure, entries: Mapping[str, Artist], *, columns: int = 2) -> None:
    """Add a legend below all axes of a figure, in at most so many columns, as many as fit."""
    most = room(figure)
    longest = min(max(map(len, entries), default=0), most - HANDLE)
    names = [wrapped(name, longest) for name in entries]
    fit = max(1, most // (longest + HANDLE))
    if sum(len(name) + HANDLE for name in entries) <= most:
        fit = len(entries)
    figure.legend(
        [*entries.values()], names, loc="outside lower center", ncols=min(columns, fit),
        frameon=False,
    )  # fmt: skip


def finished(
    figure: Figure, entries: Mapping[str, Artist], title: str | None, *, columns: int = 2
) -> Figure:
    """Return a figure with its legend below all axes, and its title above them."""
    legend_below(figure, entries, columns=columns)
    if title:
        figure.suptitle(fitting(figure, title))
    return figure


def unit_axis(axes: Axes) -> None:
    """Let the vertical axis show rates from 0 to 1, with room for lines at both ends."""
    axes.set_ylim(-0.02, 1.02)
    axes.set_yticks(np.linspace(0.0, 1.0, 6))
    plain_axis(axes)


def plain_axis(axes: Axes) -> None:
    """Draw a light grid below the curves, and no frame above and on the right."""
    axes.grid(color=colors.GRID, linewidth=0.8)
    axes.set_axisbelow(True)
    axes.spines[["top", "right"]].set_visible(False)


def whole_numbers() -> MaxNLocator:
    """Return a locator of as many ticks as fit, at round whole numbers: generations, epochs."""
    return MaxNLocator(nbins="auto", steps=[1, 2, 5, 10], integer=True)


def generation_axis(axes: Axes) -> None:
    """Let the horizontal axis show round generations, with some room at both ends."""
    axes.xaxis.set_major_locator(whole_numbers())
    axes.margins(x=0.02)


def draw_runs(axes: Axes, band: Band, curves: ArrayLike, color: str) -> None:
    """Draw the band around a mean curve if there is one, and some runs (runs, k) as thin lines."""
    if band.low is not None and band.high is not None:
        axes.fill_between(band.places, band.low, band.high, color=color, alpha=0.22, linewidth=0)
    if 1 < len(np.asarray(curves)) <= MOST_LINES:
        # Smooth edges of many thin lines would make the picture several times as large.
        look: dict[str, Any] = {"alpha": 0.35, "linewidth": 0.6, "antialiased": False}
        axes.plot(band.places, np.asarray(curves).T, color=color, **look)


def label_runs(axes: Axes, counts: Iterable[int]) -> None:
    """Label the thin lines of single runs, if a group of so many runs has some."""
    if any(1 < runs <= MOST_LINES for runs in counts):
        axes.plot([], [], color=colors.MUTED, alpha=0.6, linewidth=0.6, label="one run")


FORMATS = ("png", "pdf", "svg")
"""Formats of figures, which are the suffixes of their files; pdf and svg are vector graphics."""

# TrueType fonts: journals refuse the other kind that Matplotlib writes. No date and no random names
# of parts, so that files under version control change with the figure only.
_LOOK: dict[Any, Any] = {"pdf.fonttype": 42, "svg.hashsalt": "matrixworld"}
_METADATA: dict[str, dict[str, Any]] = {
    "png": {"Software": "matrixworld"},
    "pdf": {"Creator": "matrixworld", "CreationDate": None},
    "svg": {"Creator": "matrixworld", "Date": None},
}


def save_figure(figure: Figure, path: str | Path) -> Path:
    """Write a figure, complete or not at all, in the format of the suffix.

    Parameters
    ----------
    figure : Figure
        A figure of Matplotlib.
    path : str or path
        A name that ends in ``.png``, ``.pdf`` or ``.svg``. An older file is replaced.

    Returns
    -------
    Path
        The file.
    """
    check_instance("figure", figure, Figure)
    file = Path(path)
    kind = file.suffix.lower().removeprefix(".")
    if kind not in FORMATS:
        expected = ", ".join(f".{each}" for each in FORMATS)
        raise ValueError(f"{file}: expected a name that ends in {expected}, got {file.name!r}")
    with mpl.rc_context(_LOOK), replacing(file) as content:
        figure.savefig(content, format=kind, metadata=_METADATA[kind])
    return file
