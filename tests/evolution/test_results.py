"""Scripts in evolution/ that measure over many runs: their counts, comparisons and files."""

from __future__ import annotations

import re
from functools import partial
from pathlib import Path

import numpy as np
import pytest

import hall_of_fame
import paper_claims
from evolution_scripts import RESULTS, read, run_quickly
from matrixworld.coevolution import open_run


@pytest.mark.slow
def test_hall_of_fame_compares_two_kinds_of_race(tmp_path: Path) -> None:
    printed = run_quickly("hall_of_fame", tmp_path)
    assert "| living opponents only | halls of fame | difference | |" in printed
    assert {path.name for path in tmp_path.iterdir()} == {"runs", "hall_of_fame"}
    results = tmp_path / "hall_of_fame"
    assert {path.name for path in results.iterdir()} == {"races.csv", "comparison.md", "seed_0.png"}
    assert printed.startswith(read(results / "comparison.md"))
    matches = [
        open_run(tmp_path / "runs/hall_of_fame" / kind / "0").files.log()["matches"][-1]
        for kind in ("living-opponents-only", "halls-of-fame")
    ]
    assert matches[0] == matches[1] == 8 * 3 * 8 * 4
    assert run_quickly("hall_of_fame", tmp_path) == printed


def test_committed_comparison_follows_from_committed_races() -> None:
    results = RESULTS / "hall_of_fame"
    found = hall_of_fame.read_races(results / "races.csv")
    seeds = [[row["seed"] for row in rows] for rows in found.values()]
    assert seeds[0] == seeds[1] == list(range(len(seeds[0])))
    assert hall_of_fame.table(found) + "\n" == (results / "comparison.md").read_text(
        encoding="utf-8"
    )


@pytest.mark.parametrize(
    ("low", "high", "expected", "verdict"),
    [
        (-0.2, -0.1, -1, "as expected"),
        (-0.2, -0.1, 1, "the opposite"),
        (0.1, 0.2, 1, "as expected"),
        (-0.1, 0.1, 1, "undecided"),
        (0.0, 0.0, -1, "undecided"),
    ],
)
def test_verdict_on_halls_of_fame(low: float, high: float, expected: int, verdict: str) -> None:
    assert hall_of_fame.verdict(low, high, expected) == verdict


def test_archives_are_compared_at_one_budget(tmp_path: Path) -> None:
    printed = run_quickly("archives", tmp_path, "--samplers", "latest", "maxsolve")
    budget = int(printed.split(" matches")[0].rsplit(" ", 1)[-1].replace(",", ""))
    ends = [
        open_run(tmp_path / "runs/archives" / name / "0").files.log()["matches"][-1]
        for name in ("latest", "maxsolve")
    ]
    assert budget == min(ends) < max(ends)
    assert printed.count("\n| latest |") == printed.count("\n| maxsolve |") == 1


@pytest.mark.slow
def test_paper_claims_prints_intervals_and_writes_numbers(tmp_path: Path) -> None:
    printed = run_quickly("paper_claims", tmp_path)
    table = read(tmp_path / "paper_claims/claims.md")
    assert table in printed
    claims, scores = table.strip().split("\n\n")
    assert len(claims.splitlines()) == 2 + 32
    assert len(scores.splitlines()) == 2 + 9
    verdicts = [line.rsplit("**", 2)[1] for line in claims.splitlines()[2:]]
    assert set(verdicts) <= {"reproduced", "not reproduced", "undecided"}
    with np.load(tmp_path / "paper_claims/numbers.npz") as numbers:
        assert numbers["captured generalist-generalist"].shape == (2, 7, 7, 10)
        assert numbers["phases specialist-specialist"].shape == (2, 9, 2)
        assert numbers["cross-play of evaders"].shape == (5, 2, 3, 2, 7)
        assert numbers["held-out of pursuers"].shape == (4, 2)


NUMBER = r"-?\d+\.\d+"


@pytest.mark.slow
def test_committed_claims_follow_from_committed_numbers() -> None:
    results = RESULTS / "paper_claims"
    with np.load(results / "numbers.npz") as numbers:
        told = paper_claims.tables(numbers)
    committed = read(results / "claims.md").strip()
    # Another SciPy may resample differently: text and verdicts stay, numbers change a little.
    assert re.sub(NUMBER, "#", told) == re.sub(NUMBER, "#", committed)
    values, expected = ([*map(float, re.findall(NUMBER, text))] for text in (told, committed))
    assert values == pytest.approx(expected, rel=0.05, abs=0.01)


@pytest.mark.parametrize(
    ("values", "side", "verdict"),
    [
        ([0.2, 0.3, 0.4], "above", "reproduced"),
        ([0.2, 0.3, 0.4], "below", "not reproduced"),
        ([-0.2, 0.3, 0.1], "above", "undecided"),
        ([-0.2, 0.3, 0.1], "below", "undecided"),
        ([-0.2, -0.3, -0.4], "above", "not reproduced"),
        ([-0.2, -0.3, -0.4], "below", "reproduced"),
        ([0.0, 0.0, 0.0], "above", "undecided"),
        ([0.0] * 10, "above", "not reproduced"),
        ([0.1] * 10, "above", "reproduced"),
        ([0.1] * 10, "below", "not reproduced"),
    ],
)
def test_verdict_on_a_claim(values: list[float], side: str, verdict: str) -> None:
    estimate = paper_claims.over_seeds(np.array(values))
    assert paper_claims.Claim("it is so", "a number", estimate, side).verdict == verdict


@pytest.mark.slow
def test_held_out_opponents_are_the_same_for_any_number_of_processes(tmp_path: Path) -> None:
    evolve = partial(run_quickly, "evolve_held_out", tmp_path)
    assert "O done\nSB done\nWritten: held_out.npz" in evolve()
    evolve("--processes", "2", "--output", "again.npz")
    assert (tmp_path / "held_out.npz").read_bytes() == (tmp_path / "again.npz").read_bytes()
    lines = evolve("--table", "held_out.npz").splitlines()
    assert "| pursuers | O | SB |" in lines
    rows = [line.split(" | ") for line in lines if line.startswith("| evolved-")]
    assert len(rows) == 4
    assert all(len(row) == 3 for row in rows)
