"""Pages: their links lead somewhere, and names in their tables exist."""

import json
import re

import numpy as np
import pytest

from course.questions import Exercise, exercises
from matrixworld.coevolution import Game, Pursuit, evolve
from matrixworld.coevolution.types import LOGGED
from notebooks import NOTEBOOKS
from pages import DOCS, ROOT, page_id, read
from tiny_race import tiny_race

ANCHOR = re.compile(r'<a id="([^"]+)"></a>')
READMES = [*ROOT.glob("*/README.md"), *ROOT.glob("evolution/**/README.md")]
READMES += ROOT.glob("tutorials/*/README.md")
ALL_PAGES = sorted({*DOCS.rglob("*.md"), *ROOT.glob("*.md"), *READMES, *NOTEBOOKS})


def prose(page):
    text = page.read_text(encoding="utf-8")
    if page.suffix == ".ipynb":
        cells = [cell for cell in json.loads(text)["cells"] if cell["cell_type"] == "markdown"]
        text = "\n".join("".join(cell["source"]) for cell in cells)
    return re.sub(r"^```.*?^```$", "", text, flags=re.M | re.S)


def anchors(page):
    """Return the anchors of a page: headings as GitHub names them, and explicit ones."""
    headings = re.findall(r"^#+ (.+)$", prose(page), re.M)
    texts = (re.sub(r"\[([^]]+)\]\([^)]+\)", r"\1", heading).lower() for heading in headings)
    names = (re.sub(r"[^\w\- ]", "", text).replace(" ", "-") for text in texts)
    return {*names, *ANCHOR.findall(prose(page))}


@pytest.mark.parametrize("page", ALL_PAGES, ids=page_id)
def test_links_lead_somewhere(page):
    links = re.findall(r"\]\(([^)\s]+)\)", prose(page))
    if page in NOTEBOOKS:
        assert "../docs/glossary.md" in {link.partition("#")[0] for link in links}
    for link in links:
        file, _, anchor = link.partition("#")
        target = (page.parent / file).resolve() if file else page
        if "://" not in link:
            assert target.exists(), link
            assert not anchor or target.suffix != ".md" or anchor in anchors(target), link


def test_the_exercises_that_the_teachers_page_names_exist():
    named = re.findall(r"\b[1-9]\.[a-z1-9]\b", read("docs/teachers.md"))
    assert named
    for name in named:
        chapter, _, item = name.partition(".")
        assert isinstance(exercises(int(chapter))[name], Exercise) is item.isdigit(), name


# The page on files

FILES = read("docs/files.md")


def named(heading):
    """Names in the first column of a section's table, and what stands in the second column."""
    section = FILES.split(f"{heading}\n")[1].split("\n#")[0]
    found = {}
    for line in re.findall(r"^\| (`.+)$", section, re.M):
        names, second = line.split(" | ")[:2]
        found |= dict.fromkeys(re.findall(r"`([^`]+)`", names), second)
    return found


def arrays_in(heading):
    return {name for name in named(heading) if "." not in name}


def test_the_files_of_a_run(tmp_path):
    own = Game(len, 1, ("ones", "others"), scores="both")
    columns = {**LOGGED, **Pursuit().columns, **own.columns}
    assert named("### `log.csv`") == {name: kind.__name__ for name, kind in columns.items()}
    run = tmp_path / "run"
    evolve(tiny_race(), run, threads=1)
    for file, heading, left_out in (
        ("stage-0003.npz", "### `stage-0007.npz`", {"evaders"}),  # one team learns there
        ("checkpoint-0004.npz", "### `checkpoint-0007.npz`", set()),
        ("payoff.npz", "### `payoff.npz`", set()),
    ):
        with np.load(run / file) as arrays:
            names = {name for name in arrays.files if "." not in name}
        assert names | left_out == arrays_in(heading)
    summary = json.loads((run / "summary.json").read_bytes())
    assert set(summary) == set(named("### `summary.json` of a race"))
    stated = named("## A run directory")
    made = {path.name for path in run.iterdir() if not path.name.startswith(".")}
    by_command = {"scores.json", "*.png"}
    assert {re.sub(r"\d{4}", "0007", name) for name in made} == set(stated) - by_command


def test_each_promise_of_the_security_page_has_a_test():
    rows = re.findall(r"^\| .+$", read("SECURITY.md"), re.M)
    promises = [row for row in rows if not row.startswith(("| Promise", "| ---"))]
    assert promises
    for promise in promises:
        named = re.findall(r"`((?:[\w/]+/)?tests/[\w/]+\.py)(?:::(\w+))?`", promise)
        assert named, promise
        for file, test in named:
            assert f"def {test or 'test_'}" in read(file), (file, test)
