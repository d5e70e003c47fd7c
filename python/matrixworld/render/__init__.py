"""Drawing one moment of a world, from plain arrays and nothing else.

`Scene` holds the arrays, `ansi` draws it as text for a terminal, `rgb` as a picture.
"""

from __future__ import annotations

from matrixworld.render.raster import MARK_STEPS, png, rgb
from matrixworld.render.scene import Cell, Scene
from matrixworld.render.terminal import ansi

__all__ = ["MARK_STEPS", "Cell", "Scene", "ansi", "png", "rgb"]
