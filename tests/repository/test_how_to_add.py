"""The recipes of docs/how_to_add.md work: each is followed in a copy of the project."""

from __future__ import annotations

import os
import shutil
import sysconfig
from pathlib import Path

import pytest

from matrixworld import _core
from recipes import Recipe, copy_project, read_recipes, run

RECIPES = read_recipes()
MOST_FILES_OF_AN_OUTPUT = 3
QUICK = ("An opponent sampler", "A measure")


def test_every_kind_of_extension_has_a_recipe() -> None:
    assert [recipe.title for recipe in RECIPES] == [
        *("A variant", "An outcome", "A learner", "An opponent sampler"),
        *("A script", "A measure", "An output of a step"),
    ]


def test_an_output_of_a_step_touches_few_files() -> None:
    (recipe,) = (recipe for recipe in RECIPES if recipe.title == "An output of a step")
    assert len(recipe.files) <= MOST_FILES_OF_AN_OUTPUT


def follow(recipes: list[Recipe], root: Path) -> None:
    """Make all edits, then run all commands."""
    for recipe in recipes:
        for edit in recipe.edits:
            edit.apply(root)
    if any(recipe.needs_compiler for recipe in recipes):
        build(root)
    for recipe in recipes:
        for command in recipe.commands:
            run(command, root)


def build(root: Path) -> None:
    """Compile the copy's engine into the copy's package."""
    packages = sysconfig.get_path("purelib")
    jobs = os.cpu_count() or 1
    for extension in (root / "python" / "matrixworld").glob("_core.*.so"):
        extension.unlink()
    run(
        f'cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="{packages};'
        f'{packages}/pybind11" -DPython_EXECUTABLE="$(command -v python)"',
        root,
    )
    run(f"cmake --build build --target _core --parallel {jobs}", root)
    run("cp build/_core.* python/matrixworld/", root)


@pytest.fixture
def project(tmp_path: Path) -> Path:
    """A copy of the project with the compiled extension."""
    copy_project(tmp_path)
    shutil.copy(_core.__file__, tmp_path / "python" / "matrixworld")
    return tmp_path


@pytest.mark.parametrize(
    "recipe",
    [
        pytest.param(each, id=each.title, marks=() if each.title in QUICK else pytest.mark.slow)
        for each in RECIPES
        if not each.needs_compiler
    ],
)
def test_a_recipe_in_python(recipe: Recipe, project: Path) -> None:
    follow([recipe], project)


@pytest.mark.slow
def test_the_recipes_with_a_compiler(project: Path) -> None:
    """All of them in one copy, so that the engine is compiled once."""
    follow([recipe for recipe in RECIPES if recipe.needs_compiler], project)
