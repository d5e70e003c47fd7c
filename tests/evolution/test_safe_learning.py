"""The comparison of methods to capture without collisions: its runs, numbers and tables."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import matrixworld as mw
import safe_learning
from evolution_scripts import DOCS, RESULTS, read, run_quickly
from matrixworld.coevolution import open_run

PUBLISHED = RESULTS / "safe_learning"


def test_safe_learning_compares_methods_at_equal_agent_steps(tmp_path: Path) -> None:
    pytest.importorskip("torch")
    printed = run_quickly("safe_learning", tmp_path)
    results = tmp_path / "safe_learning"
    assert {path.name for path in results.iterdir()} == {
        "table.md", "numbers.npz", "training.png", "methods.png",
    }  # fmt: skip
    table = read(results / "table.md")
    assert printed.startswith(table)
    rows = [line for line in table.splitlines() if line.startswith(("| gradients", "| evolution"))]
    assert len(rows) == 8 + 5 + 5
    for row in rows:
        cells = [cell.strip() for cell in row.strip("|").split("|")]
        if "mask" in cells[0]:
            assert cells[3] == "0.0"  # no collision with an obstacle
        if "occupied" in cells[0]:
            assert cells[5] == "0.0"  # nor with an evader that moves in other cells
    with np.load(results / "numbers.npz") as numbers:
        name = "SB gradients: mask of occupied cells"
        assert numbers[f"{name} / fault"].shape == (2, 3, 3)
        assert not numbers[f"{name} / fault"][..., 0].any()
        steps = numbers[f"{name} / agent-steps"]
        captures = numbers[f"{name} / capture rate"]
    # The numbers are those of the runs.
    run = open_run(tmp_path / "runs/safe_learning/SB-gradients-mask-of-occupied-cells/1")
    assert steps[1, -1] == 3 * run.files.log()["steps"][-1]
    settings, own = run.settings, run.teams["pursuer"]
    last = mw.Population(own.genomes[-1:], own.network)
    world = settings.world(settings.eval_steps)
    matches = mw.Matches.of(0, 0, 10**6)
    played = mw.rollout(world, last, "random", matches, episodes=5)
    assert captures[1, -1] == pytest.approx(played.capture_rate.mean())
    assert run_quickly("safe_learning", tmp_path) == printed


def test_methods_are_compared_at_the_last_generation_within_the_budget() -> None:
    steps = {"S a": [[0, 50, 100], [0, 40, 90]], "S b": [[0, 70, 95], [0, 60, 120]]}
    numbers = {}
    for name, of_seeds in steps.items():
        numbers[f"{name} / agent-steps"] = np.array(of_seeds)
        numbers[f"{name} / collisions"] = np.array(of_seeds) / 10
        numbers[f"{name} / capture rate"] = np.arange(6).reshape(2, 3) / 10
        numbers[f"{name} / fault"] = np.arange(18.0).reshape(2, 3, 3)
    found = safe_learning.judged(numbers, "S a", budget=90)
    np.testing.assert_allclose(found["capture rate"], [0.1, 0.5])
    np.testing.assert_allclose(found["all"], [3 + 4 + 5, 15 + 16 + 17])
    np.testing.assert_allclose(found["teammate"], [4, 16])
    np.testing.assert_allclose(found["training"], [100, 100])
    np.testing.assert_allclose(found["agent-steps"], [50e-6, 90e-6])
    np.testing.assert_allclose(
        safe_learning.judged(numbers, "S b", budget=95)["capture rate"], [0.2, 0.4]
    )


def test_the_committed_table_follows_from_the_committed_numbers() -> None:
    with np.load(PUBLISHED / "numbers.npz") as numbers:
        told = safe_learning.table(dict(numbers))
    assert told + "\n" == read(PUBLISHED / "table.md")


def test_the_page_shows_the_numbers_of_the_committed_table() -> None:
    page = read(DOCS / "safe_learning.md")
    table = read(PUBLISHED / "table.md")

    def rows(text: str) -> list[list[str]]:
        lines = [line for line in text.splitlines() if line.startswith(("| grad", "| evol"))]
        return [[cell.strip() for cell in line.strip("|").split("|")] for line in lines]

    in_s, in_sb = (rows(part) for part in table.split("| -SB |"))
    expected = [[*one[:3], *other[1:3]] for one, other in zip(in_s, in_sb, strict=True)]
    assert [row[0] for row in in_s] == [row[0] for row in in_sb]
    assert rows(page) == expected
