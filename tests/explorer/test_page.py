"""A page is one file that allows nothing from elsewhere, whatever text it holds."""

from __future__ import annotations

import hashlib
import json
import re
from html.parser import HTMLParser
from pathlib import Path

import pytest

from matrixworld.explorer.page import BUILT, SUFFIXES, render_page

PAGES = ("explorer", "playground", "class")
WEB = Path(__file__).parents[2] / "web"
SOURCES = ("src", "build.mjs", "package.json", "package-lock.json", "tsconfig.json")
HOSTILE = "</script><script>document.title='owned'</script><img src=x onerror=alert(1)> & \u2028"


def source_digest() -> str:
    """Return the digest of the sources, as ``web/build.mjs`` computes it."""
    paths = [file for source in SOURCES for file in [WEB / source, *(WEB / source).rglob("*")]]
    names = {path.relative_to(WEB).as_posix(): path for path in paths if path.is_file()}
    digest = hashlib.sha256()
    for name in sorted(names):
        content = hashlib.sha256(names[name].read_bytes()).hexdigest()
        digest.update(f"{name} {content}\n".encode())
    return digest.hexdigest()


@pytest.mark.parametrize("page", PAGES)
@pytest.mark.parametrize("suffix", SUFFIXES)
def test_built_files_are_of_the_present_sources(page: str, suffix: str) -> None:
    first_line = (BUILT / f"{page}.{suffix}").read_text(encoding="utf-8").partition("\n")[0]
    assert f"sources {source_digest()} */" in first_line, "run npm ci && npm run build in web/"


@pytest.mark.parametrize("page", PAGES)
def test_data_are_read_as_they_were_and_become_no_markup(page: str) -> None:
    hostile = render_page(page, HOSTILE, {"name": HOSTILE})
    found = re.search(r'<script type="application/json" id="data">(.*)</script>', hostile)
    assert json.loads(found[1].partition("</script>")[0]) == {"name": HOSTILE}
    assert elements(hostile) == elements(render_page(page, "title", {"name": ""}))


class Elements(HTMLParser):
    """List the elements of a page with their attributes, as a browser would find them."""

    def __init__(self) -> None:
        super().__init__()
        self.found: list[tuple[str, tuple[tuple[str, str | None], ...]]] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.found.append((tag, tuple(attrs)))


def elements(html: str) -> list[tuple[str, tuple[tuple[str, str | None], ...]]]:
    parser = Elements()
    parser.feed(html)
    return parser.found


def test_numbers_that_are_not_json_are_refused() -> None:
    with pytest.raises(ValueError, match="JSON"):
        render_page("explorer", "title", {"rate": float("nan")})
