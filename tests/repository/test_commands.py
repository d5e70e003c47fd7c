"""Commands that pages and scripts show have only options that the command line has."""

from __future__ import annotations

import re
from pathlib import Path

import click
import pytest

from matrixworld.cli import main

ROOT = Path(__file__).parents[2]
PAGES = [
    *(ROOT / name for name in ("README.md", "CONTRIBUTING.md")),
    # The recipes of how_to_add.md add names of their own, and another test follows them.
    *sorted({*(ROOT / "docs").glob("*.md")} - {ROOT / "docs" / "how_to_add.md"}),
    *sorted((ROOT / "evolution").glob("*.md")),
    *sorted((ROOT / "tutorials").glob("*.ipynb")),
]
COMMAND = re.compile(r"matrixworld (?P<name>[a-z]+)(?P<rest>(?: [^\s`|\"\\]+)*)")


def shown_commands(page: Path) -> list[tuple[str, list[str]]]:
    """Return the commands of a page: their name and their options."""
    found = COMMAND.finditer(page.read_text(encoding="utf-8"))
    return [
        (match["name"], re.findall(r"(?<!\S)--[a-z-]+", match["rest"]))
        for match in found
        if match["name"] in main.commands
    ]


def visible_options(command: click.Command) -> set[str]:
    options = (param for param in command.params if isinstance(param, click.Option))
    shown = (option for option in options if not option.hidden)
    return {"--help", *(name for each in shown for name in (*each.opts, *each.secondary_opts))}


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_options_that_a_page_shows_exist(page: Path) -> None:
    for name, options in shown_commands(page):
        assert set(options) <= visible_options(main.commands[name]), name


def test_options_are_found() -> None:
    shown = [option for page in PAGES for _, options in shown_commands(page) for option in options]
    assert {"--champion", "--against", "--pursuer"} <= set(shown)
