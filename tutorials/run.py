"""Run notebooks from top to bottom, and keep what they show.

    python tutorials/run.py                    the students' notebooks, all of them
    python tutorials/run.py 03 05              those whose names begin so
    python tutorials/run.py --teacher [03]     the teacher's copies, in teacher/

Needs the extra "test". The student's notebook is kept without the outputs from its first prediction
on, and with a still picture in place of its animations: what it shows gives nothing away. The
teacher's copy holds all predictions with their outcomes, all outputs, and the solutions; it is made
of the student's notebook and of solutions/, and is not kept in the repository. A file is replaced
only after its notebook ran without an error. Pages that a notebook embeds (the playground, an
explorer) are shown where it runs; the file keeps the picture that stands in for them. Figures are
kept with 256 colours, which makes the file less than half as large. A picture gets the words of
`alt` in the metadata of its cell, for readers who do not see it.
"""

from __future__ import annotations

import argparse
import base64
import html
import io
import os
import re
import shutil
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


def run(path: Path, for_teacher: bool) -> Path:
    """Execute a notebook, and replace the student's or the teacher's; return the file."""
    notebook = nbformat.read(path, as_version=4)
    executed = execute(notebook, timeout=SECONDS_A_CELL)
    if for_teacher:
        TEACHER.mkdir(exist_ok=True)
        written = TEACHER / path.name
        write(for_teachers(executed, path.stem), written)
    else:
        written = path
        write(for_students(notebook, executed), written)
    return written


def execute(notebook: nbformat.NotebookNode, **options: object) -> nbformat.NotebookNode:
    """Return a copy of a notebook with its outcomes as predictions, and with its outputs."""
    copy = deepcopy(notebook)
    for cell in copy.cells:
        if cell.cell_type == "code":
            cell.source = PREDICTION.sub(_with_outcome, cell.source)
    folders = [str(HERE), *filter(None, [os.environ.get("PYTHONPATH")])]
    with tempfile.TemporaryDirectory() as folder:  # predictions are written there
        start = Path(folder, "course", "start.py")
        start.parent.mkdir()
        shutil.copy(HERE / "course" / "start.py", start)
        NotebookClient(
            copy,
            kernel_name="python3",
            resources={"metadata": {"path": folder}},
            startup_timeout=300,  # of a busy machine
            coalesce_streams=True,  # the prints of a cell in one piece
            **options,
        ).execute(env=os.environ | {"PYTHONPATH": os.pathsep.join(folders)})
    for cell in copy.cells:
        cell.metadata.pop("execution", None)  # times of day: they change without a reason
        for output in cell.get("outputs", []):
            drop_frame(output)
            reduce_colors(output)
            describe(output, cell.metadata.get("alt", ""))
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
    "%run course/": "%run ../course/",
    "<details><summary>After": "<details open><summary>After",
}
"""What differs in the copy for teachers: it lies in a folder of its own, and hides no outcome."""
CHECK = re.compile(r'^check\("([\d.]+)"', re.M)
SOLUTION = re.compile(r"^# (\d+\.\d)  ")


def for_teachers(executed: nbformat.NotebookNode, name: str) -> nbformat.NotebookNode:
    """Return the copy of a notebook for teachers: with a solution below each exercise."""
    copy, solved = deepcopy(executed), solutions(name)
    copy.cells = []
    for cell in deepcopy(executed.cells):
        for old, new in MOVED.items():
            cell.source = cell.source.replace(old, new)
        copy.cells.append(cell)
        if cell.cell_type == "code" and (asked := CHECK.search(cell.source)):
            copy.cells.append(nbformat.v4.new_markdown_cell(solved[asked[1]]))
    copy.cells[0].source += (
        "\n\n*The teacher's copy, with all outcomes and solutions. "
        f"Students get [theirs](../{name}.ipynb).*"
    )
    return copy


def solutions(name: str) -> dict[str, str]:
    """Return the solutions of a notebook by exercise, as Markdown."""
    found: dict[str, list[str]] = {}
    lines: list[str] = []
    for line in (HERE / "solutions" / f"{name}.py").read_text("utf-8").splitlines():
        if head := SOLUTION.match(line):
            lines = found[head[1]] = []
        lines.append(line)
    return {
        exercise: "\n".join(["**Solution**\n\n```python", *text]).rstrip() + "\n```"
        for exercise, text in found.items()
    }


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


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("begins", nargs="*", help="notebooks whose names begin so; default: all")
    parser.add_argument("--teacher", action="store_true", help="make the teacher's copies")
    options = parser.parse_args()
    begins = tuple(options.begins) or ("",)
    paths = [path for path in sorted(HERE.glob("[0-9]*.ipynb")) if path.name.startswith(begins)]
    if not paths:
        parser.error(f"expected the beginning of a notebook's name, got {' '.join(begins)}")
    for path in paths:
        began = time.monotonic()
        written = run(path, options.teacher)
        seconds, size = time.monotonic() - began, written.stat().st_size / 1e3
        print(f"{written.relative_to(HERE)}: {seconds:.0f} s, {size:.0f} kB")


if __name__ == "__main__":
    main()
