"""Pages of the repository, for the tests that read them."""

from pathlib import Path

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"


def read(name):
    return (ROOT / name).read_text(encoding="utf-8")


def page_id(page):
    return page.relative_to(ROOT).as_posix()
