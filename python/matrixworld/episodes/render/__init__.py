"""Drawings of one moment of a world, made from plain arrays only.

`Scene` holds the arrays. `rgb` and `png` draw it as a picture, `ansi` as text for a terminal.
"""

from __future__ import annotations

from matrixworld.episodes.render.raster import MARK_STEPS, png, rgb
from matrixworld.episodes.render.scene import Cell, Scene
from matrixworld.episodes.render.terminal import ansi

__all__ = ["MARK_STEPS", "Cell", "Scene", "ansi", "png", "rgb"]
