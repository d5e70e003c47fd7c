"""Reads the recipes of docs/how_to_add.md and follows them in a copy of the project.

A fenced block with a title is an edit of the file that the title names::

    ```python title="path" after="text"     insert below the first line that contains the text
    ```python title="path" before="text"    insert above it
    ```python title="path" replace="text"   put in place of that line
    ```python title="path"                  a new file

A block ``sh`` holds commands that must succeed afterwards.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs" / "how_to_add.md"
COPIED = (
    *("CMakeLists.txt", "pyproject.toml", "README.md", "LICENSE"),
    *("cpp", "python", "tests", "docs", "tutorials"),
)
NOT_COPIED = shutil.ignore_patterns("__pycache__", ".hypothesis")

FENCE = re.compile(r"^```(?P<kind>\w+)(?P<rest>[^\n]*)\n(?P<text>.*?)^```$", re.M | re.S)
ATTRIBUTE = re.compile(r'(\w+)="((?:[^"\\]|\\.)*)"')
PLACES = ("after", "before", "replace")


@dataclass(frozen=True)
class Edit:
    """One change of one file."""

    path: str
    text: str
    where: str | None
    line: str

    def apply(self, root: Path) -> None:
        file = root / self.path
        if self.where is None:
            assert not file.exists(), f"{self.path}: the recipe makes a new file, but it exists"
            file.write_text(self.text, encoding="utf-8")
            return
        lines = file.read_text(encoding="utf-8").splitlines(keepends=True)
        found = [number for number, line in enumerate(lines) if self.line in line]
        assert found, f"{self.path}: no line contains {self.line!r}"
        start = found[0] + (self.where == "after")
        lines[start : start + (self.where == "replace")] = [self.text]
        file.write_text("".join(lines), encoding="utf-8")


@dataclass(frozen=True)
class Recipe:
    """A section of the page: its edits, and the commands that must succeed afterwards."""

    title: str
    edits: tuple[Edit, ...]
    commands: tuple[str, ...]

    @property
    def files(self) -> set[str]:
        return {edit.path for edit in self.edits}

    @property
    def needs_compiler(self) -> bool:
        return any(path.startswith("cpp/") for path in self.files)


def read_recipes() -> list[Recipe]:
    """Return the recipes of the page, one for each section that has edits."""
    sections = re.split(r"^## ", PAGE.read_text(encoding="utf-8"), flags=re.M)[1:]
    recipes = [_recipe(section) for section in sections]
    return [recipe for recipe in recipes if recipe.edits]


def _recipe(section: str) -> Recipe:
    title = section.split("\n", 1)[0]
    edits, commands = [], []
    for block in FENCE.finditer(section):
        attributes = dict(ATTRIBUTE.findall(block["rest"]))
        if "title" in attributes:
            where = next((place for place in PLACES if place in attributes), None)
            line = attributes[where].replace('\\"', '"') if where else ""
            edits.append(Edit(attributes["title"], block["text"], where, line))
        elif block["kind"] == "sh":
            commands += block["text"].strip().splitlines()
    return Recipe(title, tuple(edits), tuple(commands))


def copy_project(root: Path) -> None:
    """Copy what a build and the tests need."""
    for name in COPIED:
        source = ROOT / name
        if source.is_dir():
            shutil.copytree(source, root / name, ignore=NOT_COPIED)
        else:
            shutil.copy(source, root / name)


def run(command: str, root: Path) -> None:
    """Run a command of a recipe in the copy, with its package before the installed one."""
    environment = {**os.environ, "PYTHONPATH": str(root / "python")}
    bin_folder = str(Path(sys.executable).parent)
    environment["PATH"] = os.pathsep.join([bin_folder, environment["PATH"]])
    done = subprocess.run(
        command, shell=True, cwd=root, env=environment, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, f"{command}\n{done.stdout}\n{done.stderr}"
