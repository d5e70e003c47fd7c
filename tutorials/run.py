"""Run notebooks from top to bottom, and keep them for students and for teachers.

    python tutorials/run.py                 all notebooks
    python tutorials/run.py 03 05           those whose names begin so

Needs the extra "test". The teacher's copy, in teacher/, holds all predictions with their outcomes
and all outputs. The student's notebook is kept without the outputs from its first prediction on,
and with a still picture in place of its animations: what it shows gives nothing away. Both are
replaced only after the notebook ran without an error. Pages that it embeds (the playground, an
explorer) are shown where it runs; the file keeps the picture that stands in for them. Figures are
kept with 256 colours, which makes the file less than half as large. A picture gets the words of
`alt` in the metadata of its cell, for readers who do not see it.
"""

from __future__ import annotations

import base64
import html
import io
import os
import re
import sys
import tempfile
import time
from copy import deepcopy
from pathlib import Path

import nbformat
from nbclient import NotebookClient
from PIL import Image, ImageSequence

from course.questions import Prediction, exercises

HERE = Path(__file__).parent
TEACHER = HERE / "teacher"
SECONDS_A_CELL = 600
COLORS = 256
PREDICTION = re.compile(r'predict\("([\d.a-z]+)", \.\.\.\)')
GIF = re.compile(r'<img src="data:image/gif;base64,([^"]+)" alt="([^"]*)">')


def run(path: Path) -> None:
    """Execute a notebook, and replace it and its copy for teachers."""
    notebook = nbformat.read(path, as_version=4)
    executed = execute(notebook, timeout=SECONDS_A_CELL)
    for cell in executed.cells:
        cell.metadata.pop("execution", None)  # times of day: they change without a reason
        for output in cell.get("outputs", []):
            drop_frame(output)
            reduce_colors(output)
            describe(output, cell.metadata.get("alt", ""))
    TEACHER.mkdir(exist_ok=True)
    write(for_students(notebook, executed), path)
    write(for_teachers(executed, path.name), TEACHER / path.name)


def execute(notebook: nbformat.NotebookNode, **options: object) -> nbformat.NotebookNode:
    """Return a copy of a notebook with its outcomes as predictions, and with its outputs."""
    copy = deepcopy(notebook)
    for cell in copy.cells:
        if cell.cell_type == "code":
            cell.source = PREDICTION.sub(_with_outcome, cell.source)
    folders = [str(HERE), *filter(None, [os.environ.get("PYTHONPATH")])]
    with tempfile.TemporaryDirectory() as folder:  # predictions are written there
        NotebookClient(
            copy,
            kernel_name="python3",
            resources={"metadata": {"path": folder}},
            startup_timeout=300,  # of a busy machine
            coalesce_streams=True,  # the prints of a cell in one piece
            **options,
        ).execute(env=os.environ | {"PYTHONPATH": os.pathsep.join(folders)})
    return copy


def _with_outcome(match: re.Match[str]) -> str:
    name = match[1]
    prediction = exercises(int(name.partition(".")[0]))[name]
    assert isinstance(prediction, Prediction), name
    return f'predict("{name}", "{prediction.outcome}")'


def for_students(
    notebook: nbformat.NotebookNode, executed: nbformat.NotebookNode
) -> nbformat.NotebookNode:
    """Return a notebook with the outputs of what stands above its first prediction."""
    copy = deepcopy(notebook)
    shown = True
    for cell, ran in zip(copy.cells, executed.cells, strict=True):
        if cell.cell_type != "code":
            continue
        shown = shown and not PREDICTION.search(cell.source)
        cell.outputs = deepcopy(ran.outputs) if shown else []
        cell.execution_count = ran.execution_count if shown else None
        for output in cell.outputs:
            still(output)
    return copy


def still(output: nbformat.NotebookNode) -> None:
    """Put a picture from the middle of an animation in its place."""
    found = GIF.search("".join(output.get("data", {}).get("text/html", "")))
    if not found:
        return
    with Image.open(io.BytesIO(base64.b64decode(found[1]))) as film:
        frames = [frame.convert("RGB") for frame in ImageSequence.Iterator(film)]
    file = io.BytesIO()
    frames[len(frames) // 2].quantize(COLORS).save(file, "PNG", optimize=True)
    output["data"] = {
        "image/png": base64.b64encode(file.getvalue()).decode("ascii"),
        "text/plain": output["data"]["text/plain"],
    }
    describe(output, f"a moment of {html.unescape(found[2])}")


MOVED = {
    "](../": "](../../",
    'Path("..")': 'Path("../..")',
    'sys.path.append(".")': 'sys.path.append("..")',
    "<details><summary>After": "<details open><summary>After",
}
"""What differs in the copy for teachers: it lies in a folder of its own, and hides no outcome."""


def for_teachers(executed: nbformat.NotebookNode, name: str) -> nbformat.NotebookNode:
    """Return an executed notebook as the copy for teachers, which says so."""
    for cell in executed.cells:
        for old, new in MOVED.items():
            cell.source = cell.source.replace(old, new)
    executed.cells[
        0
    ].source += f"\n\n*The teacher's copy, with all outcomes. Students get [theirs](../{name}).*"
    return executed


def write(notebook: nbformat.NotebookNode, path: Path) -> None:
    temporary = path.with_suffix(".tmp")
    nbformat.write(notebook, temporary)
    os.replace(temporary, path)


def drop_frame(output: nbformat.NotebookNode) -> None:
    """Remove an embedded page from an output that has a picture of it, too."""
    data = output.get("data", {})
    if "image/png" in data and "<iframe" in "".join(data.get("text/html", "")):
        del data["text/html"]


def describe(output: nbformat.NotebookNode, words: str) -> None:
    """Give a picture its words; pages that are made of a notebook show them as `alt`."""
    if words and "image/png" in output.get("data", {}):
        output.setdefault("metadata", {})["image/png"] = {"alt": words}


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
        sizes = [each.stat().st_size / 1e3 for each in (path, TEACHER / path.name)]
        seconds = time.monotonic() - began
        print(f"{path.name}: {seconds:.0f} s, {sizes[0]:.0f} kB, for teachers {sizes[1]:.0f} kB")


if __name__ == "__main__":
    main(sys.argv[1:])
