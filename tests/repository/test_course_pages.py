"""The pages about the course: what they name exists."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from matrixworld.tutorial import Exercise, exercises

ROOT = Path(__file__).parents[2]
TEACHERS = ROOT / "docs" / "teachers.md"
COURSE = ROOT / "tutorials" / "README.md"
NAMED = re.findall(r"\b[1-9]\.[a-z1-9]\b", TEACHERS.read_text("utf-8"))


@pytest.mark.parametrize("page", [TEACHERS, COURSE], ids=["teachers", "course"])
def test_links_lead_to_files(page: Path) -> None:
    links = re.findall(r"\]\(([^)#\s]+)", page.read_text("utf-8"))
    missing = [link for link in links if "://" not in link and not (page.parent / link).exists()]
    assert missing == []


@pytest.mark.parametrize("name", sorted(set(NAMED)))
def test_the_exercises_that_the_teacher_s_page_names_exist(name: str) -> None:
    chapter, _, item = name.partition(".")
    found = exercises(int(chapter))[name]
    assert isinstance(found, Exercise) is item.isdigit()


def test_the_path_has_a_row_for_each_notebook() -> None:
    text = COURSE.read_text("utf-8")
    for path in sorted((ROOT / "tutorials").glob("[0-9]*.ipynb")):
        assert text.count(f"({path.name})") == 1, path.name
