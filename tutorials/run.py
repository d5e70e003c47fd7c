"""Run notebooks from top to bottom and keep them with what they showed.

    python tutorials/run.py                 all notebooks
    python tutorials/run.py 03 05           those whose names begin so

Needs the extra "test". A notebook is replaced only after it ran without an error. Pages that it
embeds (the playground, an explorer) are shown where it runs; the file keeps the picture that stands
in for them. Figures are kept with 256 colours, which makes the file less than half as large.
"""

from __future__ import annotations

import base64
import io
import os
import sys
import time
from pathlib import Path

import nbformat
from nbclient import NotebookClient
from PIL import Image

HERE = Path(__file__).parent
SECONDS_A_CELL = 600
COLORS = 256


def run(path: Path) -> None:
    """Execute a notebook in place."""
    notebook = nbformat.read(path, as_version=4)
    resources = {"metadata": {"path": str(HERE)}}
    NotebookClient(
        notebook,
        timeout=SECONDS_A_CELL,
        kernel_name="python3",
        resources=resources,
        coalesce_streams=True,  # the prints of a cell in one piece
    ).execute()
    for cell in notebook.cells:
        cell.metadata.pop("execution", None)  # times of day: they change without a reason
        for output in cell.get("outputs", []):
            drop_frame(output)
            reduce_colors(output)
    temporary = path.with_suffix(".tmp")
    nbformat.write(notebook, temporary)
    os.replace(temporary, path)


def drop_frame(output: nbformat.NotebookNode) -> None:
    """Remove an embedded page from an output that has a picture of it, too."""
    data = output.get("data", {})
    if "image/png" in data and "<iframe" in "".join(data.get("text/html", "")):
        del data["text/html"]


def reduce_colors(output: nbformat.NotebookNode) -> None:
    """Keep the picture of an output with a palette, if it is smaller so."""
    data = output.get("data", {})
    if "image/png" not in data:
        return
    before = base64.b64decode(data["image/png"])
    picture = Image.open(io.BytesIO(before)).convert("RGB").quantize(COLORS)
    after = io.BytesIO()
    picture.save(after, "PNG", optimize=True)
    if len(after.getvalue()) < len(before):
        data["image/png"] = base64.b64encode(after.getvalue()).decode("ascii")


def main(beginnings: list[str]) -> None:
    paths = [
        path
        for path in sorted(HERE.glob("[0-9]*.ipynb"))
        if not beginnings or path.name.startswith(tuple(beginnings))
    ]
    if not paths:
        sys.exit(f"expected the beginning of a notebook's name, got {' '.join(beginnings)}")
    for path in paths:
        began = time.monotonic()
        run(path)
        print(f"{path.name}: {time.monotonic() - began:.0f} s, {path.stat().st_size / 1e3:.0f} kB")


if __name__ == "__main__":
    main(sys.argv[1:])
