"""``matrixworld playground``."""

from __future__ import annotations

from pathlib import Path

import pytest

from command_line import matrixworld_command
from matrixworld.cli import explore
from matrixworld.explorer import Playground


@pytest.fixture(autouse=True)
def opened(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Open no browser; return what would have been opened."""
    addresses: list[str] = []
    monkeypatch.setattr(explore.webbrowser, "open", lambda url: addresses.append(url) or True)
    return addresses


def test_the_page_is_written_and_opened(
    tmp_path: Path, opened: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    result = matrixworld_command("playground")
    page = tmp_path / "playground.html"
    assert page.read_text(encoding="utf-8") == Playground().html()
    assert result.output == "playground.html\n"
    assert opened == [page.as_uri()]


def test_the_same_page_is_opened_again(tmp_path: Path, opened: list[str]) -> None:
    page = tmp_path / "page.html"
    for _ in range(2):
        matrixworld_command("playground", "-o", page, "--no-open")
    assert opened == []


def test_another_file_is_kept(tmp_path: Path, opened: list[str]) -> None:
    page = tmp_path / "page.html"
    page.write_text("mine")
    result = matrixworld_command("playground", "-o", page, code=2)
    assert "exists; give --force to replace it" in result.output
    assert (page.read_text(), opened) == ("mine", [])
    matrixworld_command("playground", "-o", page, "--force")
    assert page.read_text(encoding="utf-8") == Playground().html()


def test_a_directory_that_is_missing_is_named(tmp_path: Path) -> None:
    result = matrixworld_command("playground", "-o", tmp_path / "no" / "page.html", code=2)
    assert "expected a directory that exists" in result.output
