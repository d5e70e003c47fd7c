"""The notebooks of the course, as text."""

import json
from pathlib import Path

TUTORIALS = Path(__file__).parents[2] / "tutorials"
NOTEBOOKS = sorted(TUTORIALS.glob("[0-9]*.ipynb"))


def cells(path, kind=""):
    """Return the cells of a notebook, or those of a kind: "code" or "markdown"."""
    found = json.loads(path.read_text("utf-8"))["cells"]
    return [cell for cell in found if kind in ("", cell["cell_type"])]


def source(cell):
    return "".join(cell["source"])
