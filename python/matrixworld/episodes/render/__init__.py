"""Drawings of one moment of a world, made from plain arrays only.

`Scene` holds the arrays. `rgb` and `png` draw it as a picture, `ansi` as text for a terminal.
"""

from __future__ import annotations

from matrixworld.episodes.render.scene import MARK_STEPS, Cell, Scene, png, rgb
from matrixworld.episodes.render.terminal import ansi

__all__ = ["MARK_STEPS", "Cell", "Scene", "ansi", "png", "rgb"]
