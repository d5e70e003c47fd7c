"""Pages: their links lead somewhere, and names in their tables exist."""

import json
import re
import runpy
from pathlib import Path

import numpy as np
import pytest

from course.questions import Exercise, exercises
from matrixworld.coevolution import Game, Pursuit, evolve
from matrixworld.coevolution.storage import COLUMNS
from notebooks import NOTEBOOKS
from pages import DOCS, ROOT, page_id, read
from tiny_race import tiny_race

ANCHOR = re.compile(r'<a id="([^"]+)"></a>')
READMES = [*ROOT.glob("*/README.md"), *ROOT.glob("evolution/*/README.md")]
READMES += ROOT.glob("tutorials/*/README.md")
ALL_PAGES = sorted({*DOCS.rglob("*.md"), *ROOT.glob("*.md"), *READMES, *NOTEBOOKS})


def prose(page: Path) -> str:
    text = page.read_text(encoding="utf-8")
    if page.suffix == ".ipynb":
        cells = [cell for cell in json.loads(text)["cells"] if cell["cell_type"] == "markdown"]
        text = "\n".join("".join(cell["source"]) for cell in cells)
    return re.sub(r"^```.*?^```$", "", text, flags=re.M | re.S)


def anchors(page: Path) -> set[str]:
    """Return the anchors of a page: headings as GitHub names them, and explicit ones."""
    headings = re.findall(r"^#+ (.+)$", prose(page), re.M)
    texts = (re.sub(r"\[([^]]+)\]\([^)]+\)", r"\1", heading).lower() for heading in headings)
    names = (re.sub(r"[^\w\- ]", "", text).replace(" ", "-") for text in texts)
    return {*names, *ANCHOR.findall(prose(page))}


@pytest.mark.parametrize("page", ALL_PAGES, ids=page_id)
def test_links_lead_somewhere(page: Path) -> None:
    links = re.findall(r"\]\(([^)\s]+)\)", prose(page))
    if page in NOTEBOOKS:
        assert "../docs/glossary.md" in {link.partition("#")[0] for link in links}
    for link in links:
        file, _, anchor = link.partition("#")
        target = (page.parent / file).resolve() if file else page
        if "://" not in link:
            assert target.exists(), link
            assert not anchor or target.suffix != ".md" or anchor in anchors(target), link


def test_each_picture_of_the_pages_is_shown() -> None:
    shown = {
        (page.parent / link).resolve()
        for page in ALL_PAGES
        for link in re.findall(r"!\[[^]]*\]\(([^)\s]+)\)", prose(page))
    }
    pictures = {path for kind in ("png", "gif") for path in DOCS.rglob(f"*.{kind}")}
    assert pictures - shown == set()


def test_the_exercises_that_the_teachers_page_names_exist() -> None:
    named = re.findall(r"\b[1-9]\.[a-z1-9]\b", read("docs/teachers.md"))
    assert named
    for name in named:
        chapter, _, item = name.partition(".")
        assert isinstance(exercises(int(chapter))[name], Exercise) is item.isdigit(), name


def test_answers_for_a_class_are_what_dice_and_hands_do(capsys: pytest.CaptureFixture[str]) -> None:
    runpy.run_path(str(DOCS / "class_material" / "simulate.py"), run_name="__main__")
    told = re.findall(r"\d+\.\d|\d+ %", capsys.readouterr().out)
    assert len(told) == 9
    answers = read("docs/class_material/answers.md")
    assert [number for number in told if number not in answers] == []


# The page on files

FILES = read("docs/files.md")


def named(heading: str) -> dict[str, str]:
    """Names in the first column of a section's table, and what stands in the second column."""
    section = FILES.split(f"{heading}\n")[1].split("\n#")[0]
    found = {}
    for line in re.findall(r"^\| (`.+)$", section, re.M):
        names, second = line.split(" | ")[:2]
        found |= dict.fromkeys(re.findall(r"`([^`]+)`", names), second)
    return found


def check_arrays(
    file: Path, heading: str, *, parts: bool = False, optional: frozenset[str] = frozenset()
) -> None:
    stated = named(heading)
    with np.load(file) as arrays:
        names = {name for name in arrays.files if not (parts and "." in name)}
        assert names | optional == {name for name in stated if "." not in name}
        for name in names:
            shape, dtype = stated[name].rsplit(" ", 1)
            axes = [axis for axis in shape.strip("()").split(",") if axis]
            assert arrays[name].ndim == len(axes), name
            found = arrays[name].dtype
            assert dtype == {"U": "str", "S": "bytes"}.get(found.kind, found.name), name
        if parts:
            teams = {name.split(".")[0] for name in arrays.files if "." in name}
            assert {f"{team}.*" for team in teams} <= set(stated)


def test_the_files_of_a_run(tmp_path: Path) -> None:
    columns = {**COLUMNS, **Pursuit.columns, **Game.columns}
    assert named("### `log.csv`") == {name: kind.__name__ for name, kind in columns.items()}
    run = tmp_path / "run"
    evolve(tiny_race(), run, threads=1)
    genomes = np.load(run / "pursuers.npy")
    assert genomes.ndim == 2
    assert f"(G, genes) and (H, genes) {genomes.dtype}" in FILES
    other_team = frozenset({"evaders"})  # one team learns in a stage of this race
    check_arrays(run / "stage-0003.npz", "### `stage-0007.npz`", optional=other_team)
    check_arrays(run / "checkpoint-0004.npz", "### `checkpoint-0007.npz`", parts=True)
    check_arrays(run / "payoff.npz", "### `payoff.npz`")
    summary = json.loads((run / "summary.json").read_bytes())
    assert set(summary) == set(named("### `summary.json` of a race"))
    stated = named("## A run directory")
    made = {path.name for path in run.iterdir() if not path.name.startswith(".")}
    by_command = {"scores.json", "*.png"}
    assert {re.sub(r"\d{4}", "0007", name) for name in made} == set(stated) - by_command


def test_each_promise_of_the_security_page_has_a_test() -> None:
    rows = re.findall(r"^\| .+$", read("SECURITY.md"), re.M)
    promises = [row for row in rows if not row.startswith(("| Promise", "| ---"))]
    assert promises
    for promise in promises:
        named = re.findall(r"`((?:[\w/]+/)?tests/[\w/]+\.py)(?:::(\w+))?`", promise)
        assert named, promise
        for file, test in named:
            assert f"def {test or 'test_'}" in read(file), (file, test)
