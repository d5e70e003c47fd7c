"""A number to drag in a notebook: a picture for each of its values, all made by the cell."""

from __future__ import annotations

import base64
import hashlib
import io
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
from jinja2 import StrictUndefined, Template
from matplotlib.figure import Figure
from PIL import Image

PAGE = Path(__file__).with_name("slider.html")
DPI = 90
COLORS = 256
"""Of the pictures; with a palette they are less than half as large."""


class Slider:
    """Figures of which a slider shows one; a notebook shows it as the last expression of a cell.

    It needs neither a kernel nor a network. Where scripts do not run, the middle figure stands.

    Parameters
    ----------
    label : str
        What the slider changes, for example ``"opponents in a hall of fame"``.
    figures : mapping from a value to (matplotlib.figure.Figure, str)
        For each value in their order a figure, and what it shows, in words for readers who do not
        see it. Figures are drawn now and closed.

    Raises
    ------
    ValueError
        If there are fewer than two figures.
    """

    def __init__(self, label: str, figures: Mapping[Any, tuple[Figure, str]]) -> None:
        if len(figures) < 2:
            raise ValueError(f"figures: expected two or more, got {len(figures)}")
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
