"""The recipes of docs/how_to_add.md work: each is followed in a copy of the project.

A fenced block with a title is an edit of the file that the title names::

    ```python title="path" after="text"     insert below the first line that contains the text
    ```python title="path" before="text"    insert above it
    ```python title="path" replace="text"   put in place of that line
    ```python title="path"                  a new file

A block ``sh`` holds commands that must succeed afterwards.
"""

import os
import re
import shutil
import subprocess
import sys
import sysconfig
from pathlib import Path
from typing import NamedTuple

import pytest

from matrixworld import _core
from node import NODE
from slow import quickly

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs" / "how_to_add.md"
COPIED = (
    *("CMakeLists.txt", "pyproject.toml", "README.md", "LICENSE"),
    *("cpp", "python", "tests", "docs", "tutorials", "web"),
)
NOT_COPIED = shutil.ignore_patterns("__pycache__", ".hypothesis", "node_modules")
MODULES = ROOT / "web" / "node_modules"
"""What builds pages; ``npm ci`` in web/ installs it, as .ci/run does."""

FENCE = re.compile(r"^```(?P<kind>\w+)(?P<rest>[^\n]*)\n(?P<text>.*?)^```$", re.M | re.S)
ATTRIBUTE = re.compile(r'(\w+)="((?:[^"\\]|\\.)*)"')
PLACES = ("after", "before", "replace")


class Edit(NamedTuple):
    path: str
    text: str
    where: str | None
    line: str

    def apply(self, root):
        file = root / self.path
        if self.where is None:
            assert not file.exists(), f"{self.path}: the recipe makes a new file, but it exists"
            file.parent.mkdir(exist_ok=True)
            file.write_text(self.text, encoding="utf-8")
            return
        lines = file.read_text(encoding="utf-8").splitlines(keepends=True)
        found = [number for number, line in enumerate(lines) if self.line in line]
        assert found, f"{self.path}: no line contains {self.line!r}"
        start = found[0] + (self.where == "after")
        lines[start : start + (self.where == "replace")] = [self.text]
        file.write_text("".join(lines), encoding="utf-8")


class Recipe(NamedTuple):
    """A section of the page: its edits, and the commands that must succeed afterwards."""

    title: str
    edits: list[Edit]
    commands: list[str]

    def edits_in(self, folder):
        return any(edit.path.startswith(folder) for edit in self.edits)


def read_recipes():
    found = []
    for section in re.split(r"^## ", PAGE.read_text(encoding="utf-8"), flags=re.M)[1:]:
        recipe = Recipe(section.split("\n", 1)[0], [], [])
        for block in FENCE.finditer(section):
            attributes = dict(ATTRIBUTE.findall(block["rest"]))
            if "title" in attributes:
                where = next((place for place in PLACES if place in attributes), None)
                line = attributes[where].replace('\\"', '"') if where else ""
                recipe.edits.append(Edit(attributes["title"], block["text"], where, line))
            elif block["kind"] == "sh":
                recipe.commands.extend(block["text"].strip().splitlines())
        found += [recipe] if recipe.edits else []
    return found


def run(command, root):
    """Run a command of a recipe in the copy, with its package before the installed one."""
    environment = {**os.environ, "PYTHONPATH": str(root / "python")}
    folders = [Path(sys.executable).parent, NODE.parent, environment["PATH"]]
    environment["PATH"] = os.pathsep.join(map(str, folders))
    done = subprocess.run(
        command, shell=True, cwd=root, env=environment, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, f"{command}\n{done.stdout}\n{done.stderr}"


RECIPES = read_recipes()
QUICK = ("A game of your own", "A measure", "A condition of the judgement")


def test_every_kind_of_extension_has_a_recipe():
    assert len({recipe.title for recipe in RECIPES}) == 9


def follow(recipes, root):
    for recipe in recipes:
        for edit in recipe.edits:
            edit.apply(root)
    if any(recipe.edits_in("cpp/") for recipe in recipes):
        build(root)
    for recipe in recipes:
        for command in recipe.commands:
            run(command, root)


def build(root):
    """Compile the copy's engine into the copy's package; fast code would take longer."""
    packages = sysconfig.get_path("purelib")
    jobs = os.cpu_count() or 1
    for extension in (root / "python" / "matrixworld").glob("_core.*.so"):
        extension.unlink()
    run(
        f'cmake -S . -B build -G Ninja -DCMAKE_CXX_FLAGS_RELEASE="-O1 -DNDEBUG" '
        f'-DCMAKE_PREFIX_PATH="{packages};{packages}/pybind11" '
        f'-DPython_EXECUTABLE="$(command -v python)"',
        root,
    )
    run(f"cmake --build build --target _core --parallel {jobs}", root)
    run("cp build/_core.* python/matrixworld/", root)


@pytest.fixture
def project(tmp_path):
    """A copy of the project with the compiled extension."""
    for name in COPIED:
        if (ROOT / name).is_dir():
            shutil.copytree(ROOT / name, tmp_path / name, ignore=NOT_COPIED)
        else:
            shutil.copy(ROOT / name, tmp_path / name)
    shutil.copy(_core.__file__, tmp_path / "python" / "matrixworld")
    return tmp_path


PLAIN = [recipe for recipe in RECIPES if not recipe.edits_in("cpp/")]
TOGETHER = [recipe for recipe in PLAIN if recipe.title in QUICK]
ALONE = [[recipe] for recipe in PLAIN if recipe not in TOGETHER]


@quickly("recipes", [TOGETHER, *ALONE], TOGETHER.__eq__, lambda recipes: recipes[0].title)
def test_recipes_without_a_compiler(recipes, project):
    if recipes[0].edits_in("web/"):
        if not MODULES.exists():
            pytest.skip("expected web/node_modules (npm ci in web/), found none")
        (project / "web" / "node_modules").symlink_to(MODULES)
    follow(recipes, project)


@pytest.mark.nightly
def test_the_recipes_with_a_compiler(project):
    """All of them in one copy, so that the engine is compiled once."""
    follow([recipe for recipe in RECIPES if recipe.edits_in("cpp/")], project)
