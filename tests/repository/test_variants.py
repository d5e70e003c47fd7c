"""The pages of the variants: their tables are true, and the files on disk are up to date."""

import importlib
from pathlib import Path

import pytest
from PIL import Image

import matrixworld as mw

DOCS = Path(__file__).parents[2] / "docs"
TURNS = ("all at once", "team by team", "one at a time")
MOVES = dict(zip(mw.Interaction, TURNS, strict=True))


@pytest.fixture(scope="module")
def make_pages():
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(DOCS)
        yield importlib.import_module("make_pages")


def test_the_readme_has_the_rules_of_each_variant():
    readme = (DOCS.parent / "README.md").read_text(encoding="utf-8")
    for name, rules in mw.VARIANTS.items():
        outcomes = (rules.obstacle, rules.teammate, rules.evader, rules.pursuer)
        obstacle, teammate, evader, pursuer = (outcome.name[0] for outcome in outcomes)
        capture = "occupation" if rules.capture is mw.Capture.OCCUPATION else "surrounding"
        captured = "disappear" if rules.removes_captured else "stay"
        cells = (name, MOVES[rules.interaction], obstacle, teammate, f"{evader}, {pursuer}")
        row = f"| {' | '.join((*cells, capture, captured))} |\n"
        assert row in readme, f"README.md, The games: add the row {row}"


@pytest.mark.parametrize("variant", mw.VARIANTS)
def test_pages_are_up_to_date(make_pages, variant):
    file = DOCS / "variants" / f"{variant.lower()}.md"
    assert file.exists(), f"{file.name} is missing: run python docs/make_pages.py"
    assert file.read_text(encoding="utf-8") == make_pages.page(variant), (
        f"{file.name} is out of date: run python docs/make_pages.py"
    )
    with Image.open(file.with_suffix(".png")) as picture:
        assert picture.size == (504, 410)  # of one size, so that the pages look alike
    games = (DOCS / "README.md").read_text(encoding="utf-8")
    assert f"](variants/{file.name})" in games, "docs/README.md, The nine games: add a row"
