"""The rooms of the C++ tree include each other in one direction only."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2] / "cpp"

# Which rooms the files of a room may include, besides their own.
ALLOWED = {
    "grid": set(),
    "kernels": {"grid"},
    "game": {"grid"},
    "observe": {"grid", "kernels", "game"},
    "play": {"grid", "kernels", "game", "observe"},
    "bindings": {"grid", "kernels", "game", "observe", "play"},
    "tests": {"grid", "kernels", "game", "observe", "play"},
}
INCLUDE = re.compile(r'^#include "(?:(\w+)/)?([\w.]+)"', re.MULTILINE)


def includes(file: Path) -> list[tuple[str, str]]:
    """Return (room, header) of every quoted include; without a room it is the file's own."""
    own = file.relative_to(ROOT).parts[0]
    return [(room or own, header) for room, header in INCLUDE.findall(file.read_text())]


def test_every_folder_is_a_room_of_the_table() -> None:
    """A new folder below cpp/ needs a row that says what it may include."""
    assert {path.name for path in ROOT.iterdir() if path.is_dir()} == set(ALLOWED)


@pytest.mark.parametrize("room", ALLOWED)
def test_includes_run_one_way(room: str) -> None:
    """grid <- game <- observe <- play <- bindings, with kernels beside game."""
    wrong = [
        f"cpp/{file.relative_to(ROOT)} includes {other}/{header}: "
        f"expected {room} to include {sorted(ALLOWED[room]) or 'no other room'}"
        for file in sorted((ROOT / room).glob("*.[ch]pp"))
        for other, header in includes(file)
        if other != room and other not in ALLOWED[room]
    ]
    assert not wrong, "\n".join(wrong)


def test_included_files_exist() -> None:
    """The pattern reads the includes, and each names a file of the tree."""
    named = {
        ROOT / room / header for file in ROOT.rglob("*.[ch]pp") for room, header in includes(file)
    }
    assert len(named) > 20
    assert {str(path) for path in named if not path.exists()} == set()


def test_kernels_include_plain_data_only() -> None:
    """Inline functions in kernels.cpp could replace those of the base instruction set."""
    headers = {
        f"{room}/{header}"
        for file in (ROOT / "kernels").iterdir()
        for room, header in includes(file)
        if room != "kernels"
    }
    assert headers == {"grid/positions.hpp"}
    assert includes(ROOT / "grid" / "positions.hpp") == []
    assert "inline" not in re.sub(r"//.*", "", (ROOT / "grid" / "positions.hpp").read_text())
