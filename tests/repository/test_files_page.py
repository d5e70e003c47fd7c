"""The page on files names every column and key of real files, and nothing else."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np

import matrixworld as mw
from matrixworld._util.reading import DEPTH, LIMITS, UNPACKED
from matrixworld.coevolution import start
from matrixworld.coevolution.storage.run_log import COLUMNS
from tiny_race import tiny_race

PAGE = (Path(__file__).parents[2] / "docs" / "files.md").read_text(encoding="utf-8")


def named(heading: str) -> dict[str, str]:
    """Names in the first column of a section's table, and what stands in the second column."""
    section = PAGE.split(f"{heading}\n")[1].split("\n#")[0]
    found = {}
    for line in re.findall(r"^\| (`.+)$", section, re.M):
        names, second = line.split(" | ")[:2]
        found |= dict.fromkeys(re.findall(r"`([^`]+)`", names), second)
    return found


def test_the_columns_of_the_log() -> None:
    types = {name: kind.__name__ for name, kind in COLUMNS.items()}
    assert named("### `log.csv`") == types


def check_arrays(file: Path, heading: str, *, parts: bool = False) -> None:
    """Compare names, numbers of axes and dtypes with the table of a section."""
    stated = named(heading)
    with np.load(file) as arrays:
        names = {name for name in arrays.files if not (parts and "." in name)}
        assert names == {name for name in stated if "." not in name}
        for name in names:
            shape, dtype = stated[name].rsplit(" ", 1)
            axes = [axis for axis in shape.strip("()").split(",") if axis]
            assert arrays[name].ndim == len(axes), name
            found = arrays[name].dtype
            assert dtype == ("str" if found.kind == "U" else found.name), name
        if parts:
            teams = {name.split(".")[0] for name in arrays.files if "." in name}
            assert {f"{team}.*" for team in teams} <= set(stated)


def test_the_files_of_a_run(tmp_path: Path) -> None:
    run = tmp_path / "run"
    start(tiny_race(), run, threads=1).run()
    genomes = np.load(run / "pursuers.npy")
    assert genomes.ndim == 2
    assert f"(G, genes) and (H, genes) {genomes.dtype}" in PAGE
    check_arrays(run / "checkpoint.npz", "### `checkpoint.npz`", parts=True)
    check_arrays(run / "payoff.npz", "### `payoff.npz`")
    summary = json.loads((run / "summary.json").read_bytes())
    assert set(summary) == set(named("### `summary.json` of a race"))
    stated = named("## A run directory")
    made = {path.name for path in run.iterdir() if not path.name.startswith(".")}
    assert {name for name in made if ".previous" not in name} <= set(stated)


def test_the_limits() -> None:
    rows = re.findall(r"^\| (\w+) \| ([\d,]+) \|", PAGE.split("## Files by others\n")[1], re.M)
    assert {kind: int(most.replace(",", "")) for kind, most in rows} == LIMITS
    assert f"at most {UNPACKED:,} bytes" in PAGE
    assert f"nested {DEPTH} levels deep" in PAGE


def test_a_recorded_episode(tmp_path: Path) -> None:
    mw.record("O", "chaser", "fleer", seed=0).save(tmp_path / "episode.npz")
    check_arrays(tmp_path / "episode.npz", "## A recorded episode")
