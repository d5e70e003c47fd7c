"""The glossary: one entry for each term, an anchor for each entry, and links that find them."""

from __future__ import annotations

import re
from collections import Counter
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
GLOSSARY = (ROOT / "docs" / "glossary.md").read_text(encoding="utf-8")
ANCHOR = re.compile(r'<a id="([^"]+)"></a>')
TABLES = re.findall(r"(?:^\|.*\|\n)+", GLOSSARY, re.MULTILINE)
ENTRIES = [line for table in TABLES for line in table.splitlines()[2:]]
ANCHORS = ANCHOR.findall(GLOSSARY)
PAGES = [*(ROOT / "docs").rglob("*.md"), *ROOT.glob("*.md"), *ROOT.glob("*/README.md")]

SURVEY = """
    co-evolution cooperative-co-evolution competitive-co-evolution intra-population
    inter-population symmetric asymmetric intraspecific interspecific individual population
    fitness self-play adaptation counter-adaptation arms-race endings-of-an-arms-race extinction
    equilibrium cycling curriculum-learning automatic-curriculum-learning autocurriculum
    carrying-capacity policy-cycle adversarial-learning alternating-learning minimax
    adversarial-policy zero-sum-game specialist generalist generalisation baseline
    stochastic-game turn-taking-game vertex-conflict edge-conflict capture-rate
"""
"""Terms of the paper's survey and experiments."""


def term(entry: str) -> str:
    """Return the first cell without its anchors."""
    return ANCHOR.sub("", entry).split("|")[1].strip()


def test_anchors_are_unique() -> None:
    assert [anchor for anchor, count in Counter(ANCHORS).items() if count > 1] == []


def test_terms_are_unique() -> None:
    terms = Counter(map(term, ENTRIES))
    assert [name for name, count in terms.items() if count > 1] == []


def test_every_entry_has_an_anchor_and_all_cells() -> None:
    for table in TABLES:
        heading, _, *entries = table.splitlines()
        for entry in entries:
            assert ANCHOR.match(entry, pos=2), entry
            cells = entry.strip("|").split("|")
            assert len(cells) == heading.count("|") - 1, entry
            assert all(cell.strip() for cell in cells), entry


def test_the_terms_of_the_survey_are_there() -> None:
    assert set(SURVEY.split()) <= set(ANCHORS)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_links_to_the_glossary_find_their_entry(page: Path) -> None:
    links = re.findall(r"glossary\.md#([\w-]+)\)", page.read_text(encoding="utf-8"))
    assert [link for link in links if link not in ANCHORS] == []
