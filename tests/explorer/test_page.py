"""A page is one file that allows nothing from elsewhere, whatever text it holds."""

from __future__ import annotations

import json
import re
from html.parser import HTMLParser
from pathlib import Path

import pytest

from matrixworld.explorer.built import KINDS, PAGES, recorded_digest, source_digest
from matrixworld.explorer.page import render_page

WEB = Path(__file__).parents[2] / "web"
HOSTILE = "</script><script>document.title='owned'</script><img src=x onerror=alert(1)> & \u2028"


@pytest.mark.parametrize("page", PAGES)
@pytest.mark.parametrize("kind", KINDS)
def test_built_files_are_of_the_present_sources(page: str, kind: str) -> None:
    message = "run npm ci && npm run build in web/"
    assert recorded_digest(page, kind) == source_digest(WEB), message


@pytest.mark.parametrize("page", PAGES)
def test_data_are_read_as_they_were(page: str) -> None:
    html = render_page(page, HOSTILE, {"name": HOSTILE})
    found = re.search(r'<script type="application/json" id="data">(.*)</script>', html)
    assert found
    assert json.loads(found[1].partition("</script>")[0]) == {"name": HOSTILE}


@pytest.mark.parametrize("page", PAGES)
def test_no_text_of_the_data_becomes_markup(page: str) -> None:
    plain, hostile = (
        elements(render_page(page, "title", {"name": ""})),
        elements(render_page(page, HOSTILE, {"name": HOSTILE})),
    )
    assert plain == hostile


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
