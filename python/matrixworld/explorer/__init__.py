"""Pages that show runs and play their matches, with the engine inside."""

from __future__ import annotations

from matrixworld.explorer.playground import Playground
from matrixworld.explorer.runs_page import Explorer, explore

__all__ = ["Explorer", "Playground", "explore"]
