"""What several notebooks show: films, figures to drag, differences with their intervals."""

from __future__ import annotations

import base64
import hashlib
import io
import tempfile
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
from jinja2 import StrictUndefined, Template
from matplotlib.animation import FuncAnimation, PillowWriter
from matplotlib.figure import Figure
from numpy.typing import ArrayLike
from PIL import Image

from matrixworld import analysis, replay

PAGE = Path(__file__).with_name("slider.html")
DPI = 90
COLORS = 256
"""Of the pictures; with a palette they are less than half as large."""


def film(
    figure: Figure, draw: Callable[[int], object], frames: range, fps: int, alt: str
) -> replay.Animation:
    """Return the pictures of a figure that `draw` changes for each frame."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "film.gif"
        FuncAnimation(figure, draw, frames=frames).save(path, writer=PillowWriter(fps=fps))  # type: ignore[arg-type]
        return replay.Animation(path.read_bytes(), alt=alt)


def differences(pairs: Mapping[str, tuple[ArrayLike, ArrayLike]]) -> str:
    """Return lines with the first minus the second of each pair, over runs of the same seeds."""
    lines = []
    for name, (one, other) in pairs.items():
        found = analysis.difference_of_runs(one, other, paired=True)
        word = ("cannot tell", "higher", "lower")[found.sign]
        lines.append(f"  {name:{max(map(len, pairs))}}  {found:+.3f}  {word}")
    return "\n".join(lines)


class Slider:
    """Figures of which a slider shows one; a notebook shows it as the last expression of a cell.

    It needs neither a kernel nor a network. Where scripts do not run, the middle figure stands.

    `label` says what the slider changes. `figures` has for each value, in their order, a figure and
    what it shows, in words for readers who do not see it. Figures are drawn now and closed.
    """

    def __init__(self, label: str, figures: Mapping[Any, tuple[Figure, str]]) -> None:
        self.label = label
        self.pictures = [
            (_picture(figure), words, str(value)) for value, (figure, words) in figures.items()
        ]

    def __repr__(self) -> str:
        return f"<Slider: {self.label}>"

    def _repr_mimebundle_(
        self, include: object = None, exclude: object = None
    ) -> tuple[dict[str, str], dict[str, Any]]:
        """Return the page's part, and the middle picture with its words for places without HTML."""
        middle = len(self.pictures) // 2
        source, words, _ = self.pictures[middle]
        digest = hashlib.sha256("".join(each[0] for each in self.pictures).encode()).hexdigest()
        page = Template(PAGE.read_text("utf-8"), autoescape=True, undefined=StrictUndefined)
        html = page.render(
            name=f"slider-{digest[:8]}", label=self.label, pictures=self.pictures, middle=middle
        )
        picture = source.partition(",")[2]
        return {"text/html": html, "image/png": picture}, {"image/png": {"alt": words}}


def _picture(figure: Figure) -> str:
    """Return a figure as the address of a picture, and close it: a cell would show it again."""
    drawn, small = io.BytesIO(), io.BytesIO()
    figure.savefig(drawn, format="png", dpi=DPI)
    plt.close(figure)
    Image.open(drawn).convert("RGB").quantize(COLORS).save(small, "PNG", optimize=True)
    return f"data:image/png;base64,{base64.b64encode(small.getvalue()).decode('ascii')}"
