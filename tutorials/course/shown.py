"""What several notebooks show: films, and lists of differences with their intervals."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Mapping
from pathlib import Path

from matplotlib.animation import FuncAnimation, PillowWriter
from matplotlib.figure import Figure
from numpy.typing import ArrayLike

from matrixworld import analysis, replay


def film(
    figure: Figure, draw: Callable[[int], object], frames: range, fps: int, alt: str
) -> replay.Animation:
    """Return the pictures of a figure that `draw` changes for each frame."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "film.gif"
        FuncAnimation(figure, draw, frames=frames).save(path, writer=PillowWriter(fps=fps))  # type: ignore[arg-type]
        return replay.Animation(path.read_bytes(), alt=alt)


def differences(
    pairs: Mapping[str, tuple[ArrayLike, ArrayLike]],
    words: tuple[str, str] = ("higher", "lower"),
    level: float = 0.95,
) -> str:
    """Return lines with the first minus the second of each pair, over runs of the same seeds."""
    lines = []
    for name, (one, other) in pairs.items():
        found = analysis.difference_of_runs(one, other, paired=True, level=level)
        word = ("cannot tell", *words)[found.sign]
        lines.append(f"  {name:{max(map(len, pairs))}}  {found:+.3f}  {word}")
    return "\n".join(lines)
