"""Bad settings and maps: the exceptions and their messages."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import matrixworld as mw
from refusals import CONFIG, SMALL, assert_refuses, kind, table, value


def value_of(field: str, given: Any, says: str) -> Any:
    """A wrong value of a field of a configuration."""
    changes = SMALL | {field: given}
    return value(f"{field}={given!r}"[:40], lambda: mw.WorldConfig(**changes), says)


def kind_of(field: str, given: Any, says: str) -> Any:
    """A value of a wrong type."""
    changes = SMALL | {field: given}
    return kind(f"{field}={given!r}"[:40], lambda: mw.WorldConfig(**changes), says)


SETTINGS = [
    value_of("rules", "Q", "one of D, R, B, O, S | got 'Q'"),
    kind_of("rules", 7, "Rules or the name of a variant | got 7"),
    kind_of("rules", None, "Rules or the name of a variant | got None"),
    value_of("rows", 0, "1 to 4096 | got 0"),
    value_of("rows", -3, "1 to 4096 | got -3"),
    value_of("rows", 4097, "1 to 4096 | got 4097"),
    value_of("rows", 10**12, "-2147483647 to 2147483647 | got 1000000000000"),
    kind_of("rows", 3.0, "an integer | got 3.0"),
    value_of("cols", 0, "1 to 4096 | got 0"),
    kind_of("cols", True, "an integer | got True"),
    kind_of("cols", "4", "an integer | got '4'"),
    value_of("n_pursuers", 0, "1 to 12 | got 0"),
    value_of("n_pursuers", 13, "1 to 12 | got 13"),
    value_of("n_pursuers", 12, "at most 12 agents | got 13"),
    value_of("n_evaders", 0, "1 to 12 | got 0"),
    kind_of("n_evaders", 1.5, "an integer | got 1.5"),
    value_of("fov", 4, "an odd number | got 4"),
    value_of("fov", 0, "1 to 255 | got 0"),
    value_of("fov", 257, "1 to 255 | got 257"),
    kind_of("diagonal", 1, "True or False | got 1"),
    value_of("max_steps", 0, "1 to | got 0"),
    value_of("max_steps", 2**31, "-2147483647 to 2147483647 | got 2147483648"),
    kind_of("rewards", {"step": 1}, "Rewards | got {'step': 1}"),
    value_of("obstacles", 1.0, "a number in [0, 1) | got 1.0"),
    value_of("obstacles", -0.1, "a number in [0, 1) | got -0.1"),
    value_of("obstacles", float("nan"), "a number in [0, 1) | got nan"),
    value_of("obstacles", 0.9, "at most 1 agents | got 3"),
    kind_of("obstacles", True, "a number in [0, 1) or a map | got True"),
    value_of("obstacles", np.ones((3, 4), bool), "at most 0 agents | got 3"),
    value_of("obstacles", np.zeros((4, 3), bool), "shape (3, 4) | got (4, 3)"),
    kind_of("obstacles", np.zeros((3, 4)), "dtype bool | got float64"),
    kind_of("obstacles", 5j, "a bool array, rows of text or a path | got 5j"),
    value(
        "a world larger than the limits",
        lambda: mw.World(obstacles=np.zeros((2, 5000), bool)),
        "1 to 4096 | got 5000",
    ),
    kind("Rules(obstacle)", lambda: mw.Rules(obstacle="B"), "a matrixworld.Outcome | 'B'"),
    kind("Rules(capture)", lambda: mw.Rules(capture=0), "a matrixworld.Capture | got 0"),
    kind(
        "Rules(interaction)",
        lambda: mw.Rules(interaction=mw.Outcome.REACH),
        "a matrixworld.Interaction | got <Outcome.REACH",
    ),
    kind(
        "Rules(captured_disappear)", lambda: mw.Rules(captured_disappear=1), "True or False | got 1"
    ),
    value(
        "Rewards(nan)", lambda: mw.Rewards(evader_step=float("nan")), "a finite number | got nan"
    ),
    value("Rewards(1e39)", lambda: mw.Rewards(evader_step=1e39), "a finite | got 1e+39"),
    kind("Rewards(None)", lambda: mw.Rewards(evader_step=None), "a number | got None"),
    kind("Rewards('1')", lambda: mw.Rewards(pursuer_step="1"), "a number | got '1'"),
    kind(
        "Rewards(capture_repeats)", lambda: mw.Rewards(capture_repeats=1), "True or False | got 1"
    ),
]


@table(SETTINGS)
def test_settings(call: Any, error: type[Exception], says: str) -> None:
    assert_refuses(call, error, says)


def test_unknown_fields_are_named() -> None:
    for call in (mw.WorldConfig, mw.World, lambda **more: mw.Batch(1, CONFIG, **more)):
        with pytest.raises(TypeError, match="n_predators"):
            call(n_predators=3)


# ---- Maps ------------------------------------------------------------------------------------

HEADER = "type octile\nheight 2\nwidth 3\nmap\n"
TEXTS = [
    value("no rows", [], "at least one row | got []"),
    value("empty rows", ["", ""], "at least one row | got ['', '']"),
    value(
        "ragged",
        ["...", "..", "..."],
        "3 cells as in row 0 | row 1: expected 3 cells as in row 0, got 2",
    ),
    value(
        "unknown",
        ["..?", "..x"],
        "'.GS' (free) or '#@OTW' (obstacle) | row 0",
    ),
    value("a flat array", np.zeros(3, bool), "shape (rows, cols) | got (3,)"),
    value("an empty array", np.zeros((0, 3), bool), "shape (rows, cols) | got (0, 3)"),
    kind("an array of bytes", np.zeros((2, 3), np.uint8), "dtype bool | got uint8"),
    kind("a number", 3, "a bool array, rows of text or a path | got 3"),
    kind(
        "lists of bools",
        [[True, False]],
        "a bool array, rows of text or a path | got [[True, False]]",
    ),
]
FILES = [
    value("an empty file", "", "a MovingAI map | got []"),
    value("no header", "...\n.#.\n", "a MovingAI map | got ['...', '.#.']"),
    value(
        "no word map",
        HEADER.replace("map", ""),
        "a MovingAI map | got ['type octile', 'height 2', 'width 3']",
    ),
    value(
        "no height", HEADER.replace("height", "depth") + "...\n...\n", "a MovingAI map | 'depth 2'"
    ),
    value("no cells", HEADER, "at least one row | got []"),
    value("too few rows", HEADER + "...\n", "(2, 3) cells as in its header | got (1, 3)"),
    value("too wide", HEADER + "....\n....\n", "(2, 3) cells as in its header | got (2, 4)"),
    value(
        "a word as height", HEADER.replace("2", "two") + "...\n...\n", "(two, 3) cells | got (2, 3)"
    ),
    value("ragged", HEADER + "...\n..\n", "3 cells as in row 0 | row 1: expected 3 cells"),
    value("unknown", HEADER + "..!\n...\n", "'.GS' (free) | got ['!']"),
    value("not text", HEADER + "..é\n...\n", "'.GS' (free) | row 0"),
]


@table(TEXTS)
def test_maps(call: Any, error: type[Exception], says: str) -> None:
    assert_refuses(lambda: mw.read_map(call), error, says)


@table(FILES)
def test_map_files(tmp_path: Path, call: str, error: type[Exception], says: str) -> None:
    path = tmp_path / "broken.map"
    path.write_text(call, encoding="utf-8")
    assert_refuses(lambda: mw.read_map(path), error, says)
    with pytest.raises(error, match="broken"):
        mw.WorldConfig(obstacles=str(path))


def test_a_map_file_that_is_not_there(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match=r"nowhere\.map"):
        mw.WorldConfig(obstacles=tmp_path / "nowhere.map")
