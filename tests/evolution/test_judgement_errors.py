"""The benchmark of the judgement: its races, counts, tables and files."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable
from operator import itemgetter
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from scipy.stats import binom

import judgement_cases as cases
import judgement_errors
import judgement_tables as tables
from evolution_scripts import RESULTS, read
from judgement_truths import WINDOWS
from matrixworld import analysis
from matrixworld.analysis import CONDITIONS

COMMITTED = RESULTS / "judgement"


def opinion(source: np.ndarray, *, per_episode: bool = False, episodes: int | None = None) -> Any:
    """Call all but a cycle present, whatever the matches, and leave out first halves."""
    assert source.ndim in ((3, 4) if per_episode else (2, 3))
    assert not (per_episode and episodes)
    windows = {}
    for window in ("whole", "last half"):
        ends = SimpleNamespace(value=0.0, low=-0.001, high=0.001)
        windows[window] = {
            name: SimpleNamespace(
                verdict="absent" if name == "cycling" else "present",
                estimates={"pursuer_change": ends, "evader_change": ends},
            )
            for name in CONDITIONS
        }
    return SimpleNamespace(windows=windows, window="last half")


@pytest.fixture(autouse=True)
def no_judgement(monkeypatch: pytest.MonkeyPatch) -> None:
    """Put the opinion in place of the judgement, which takes long."""
    monkeypatch.setattr(analysis, "judge", opinion)


@pytest.fixture
def run(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Callable[..., str]:
    """Return a function that runs the script with options and returns what it prints."""

    def run_script(*options: object) -> str:
        monkeypatch.setattr(sys, "argv", ["judgement_errors.py", *map(str, options)])
        judgement_errors.main()
        return capsys.readouterr().out

    return run_script


def follows(results: Path) -> bool:
    """Whether the tables of a directory follow from its counts."""
    return bool(tables.report_of(results) == read(results / "errors.md"))


@pytest.mark.slow
def test_quick_benchmark_writes_tables_that_follow_from_counts(
    run: Callable[..., str], tmp_path: Path
) -> None:
    told = run("--quick", "--results", tmp_path)
    assert told.startswith(read(tmp_path / "errors.md"))
    assert follows(tmp_path)
    counts = tables.read_counts(tmp_path / "counts.csv")
    samples = {row["sample"] for row in counts}
    assert samples == {"development", "held back", "toy game", "real race"}
    # The opinion is always the same, and has none of the first half.
    for window in WINDOWS:
        for condition in CONDITIONS:
            found = tables.totals(counts, window=window, condition=condition)
            given = "absent" if condition == "cycling" else "present"
            given = "cannot tell" if window == "first half" else given
            assert found[given] == sum(found.values()) > 0
    by_size = tables.read_counts(tmp_path / "power.csv")
    assert sum(tables.totals(by_size, condition="disengagement").values()) > 0
    # Races for power curves are in no other table.
    races = tables.totals(tables.read_counts(tmp_path / "settings.csv"), setting="runs")
    assert sum(races.values()) <= 37 * 2 * len(CONDITIONS)


@pytest.mark.slow
def test_an_interrupted_benchmark_continues(
    run: Callable[..., str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    options = ("--seeds", 2, "--development", "--results", tmp_path)
    whole = run(*options)
    file = tmp_path / "judgements.jsonl"
    lines = file.read_text(encoding="utf-8").splitlines(keepends=True)
    file.write_text("".join(lines[:9]) + lines[9][:20], encoding="utf-8")
    seen = []
    monkeypatch.setattr(
        analysis, "judge", lambda source, **known: seen.append(1) or opinion(source, **known)
    )
    assert run(*options) == whole
    assert len(seen) == len(lines) - 9
    assert sorted(file.read_text(encoding="utf-8").splitlines()) == sorted(map(str.strip, lines))


def test_judgements_of_other_code_are_refused(run: Callable[..., str], tmp_path: Path) -> None:
    (tmp_path / "judgements.jsonl").write_text('{"version": "older"}\n', encoding="utf-8")
    with pytest.raises(ValueError, match="expected judgements of this version of the code"):
        run("--quick", "--results", tmp_path)


def test_races_are_those_that_the_setting_says() -> None:
    seen = set()
    for seed in range(40):
        case = cases.synthetic_case("cycle", seed)
        runs, n = int(case.setting["runs"]), int(case.setting["generations"])
        shape = (n, n) if runs == 1 else (runs, n, n)
        episodes = int(case.setting["noise"].split(", ")[1])
        known = case.setting["episodes known"]
        seen.add(known)
        assert case.scores.shape == (*shape, episodes)[: len(shape) + case.per_episode]
        assert case.per_episode == (known == "each episode")
        assert case.episodes == (episodes if known == "number of episodes" else None)
        again = cases.synthetic_case("cycle", seed)
        assert np.array_equal(case.scores, again.scores)
    assert seen == {"each episode", "number of episodes", "unknown"}


def test_races_for_power_curves_are_single_and_show_all_episodes() -> None:
    for kind in cases.POWER:
        sizes = []
        for seed in range(6):
            case = cases.power_case(kind, seed)
            assert case.setting["noise"] == cases.POWER_NOISES[seed]
            assert case.scores.shape[:2] == (31, 31)
            assert case.per_episode
            sizes.append({name: one.size for name, one in case.truths["last half"].items()})
        assert len({tuple(each.values()) for each in sizes}) == 6
    assert case.truths["last half"]["disengagement"].holds
    assert 0.97 <= case.truths["last half"]["disengagement"].size <= 1.0


def test_sizes_by_hand() -> None:
    place = itemgetter("condition", "from", "to")
    found = [
        ["last half", "intransitivity", True, 0.09, "present"],
        ["last half", "disengagement", False, 0.5, "absent"],
        ["last half", "stagnation", False, 0.9, "absent"],
        ["whole", "arms race", True, 0.9, "present"],
    ]
    rows = tables.count_by_size([judgement("cycle", found)])
    assert [*map(place, rows)] == [("intransitivity", "0.08", "0.14")]
    found[0][2] = False
    rows = tables.count_by_size([judgement("cycle", found)])
    assert [*map(place, rows)] == [("stagnation", "0.2", "0.4")]


def test_learners_that_cannot_learn_and_opponents_in_random_order() -> None:
    frozen = cases.real_case(cases.FROZEN, 3)
    assert frozen.scores.shape == (15, 15, 10)
    held = {condition: truth.holds for condition, truth in frozen.truths["whole"].items()}
    assert held["arms race"] is held["intransitivity"] is held["forgetting"] is False
    # No generation differs from another by more than chance.
    each = frozen.scores.mean(axis=(1, 2))
    luck = frozen.scores.mean(axis=1).std(axis=1).mean() / np.sqrt(10)
    assert each.std() < 2.5 * luck
    shuffled = cases.real_case(cases.SHUFFLED, 3)
    assert shuffled.truths["whole"]["arms race"].holds is False
    assert shuffled.truths["whole"]["one-sided progress"].holds is None


def judgement(kind: str, found: list[list[Any]], **setting: str) -> dict[str, Any]:
    return {
        "source": "synthetic", "kind": kind, "seed": 0, "headline": "last half", "changes": [],
        "setting": {"noise": "win or loss, 10", "runs": "1", "episodes known": "unknown"} | setting,
        "found": found,
    }  # fmt: skip


def test_counts_by_hand() -> None:
    both = [
        judgement("cycle", [["last half", "cycling", True, 0.1, "present"]]),
        judgement("cycle", [["last half", "cycling", True, 0.1, "absent"]]),
        judgement("decline", [["whole", "cycling", False, 0.0, "present"]]),
        judgement("decline", [["last half", "cycling", None, 0.0, "present"]]),
    ]
    counts = tables.count_verdicts(both)
    assert tables.totals(counts, truth="True") == {"present": 1, "absent": 1, "cannot tell": 0}
    assert [row["sample"] for row in counts] == ["development", "held back"]
    # Only the headline window.
    by_setting = tables.count_by_setting(both)
    assert tables.totals(by_setting, truth="False")["present"] == 0
    assert tables.totals(by_setting, setting="runs", value="1")["present"] == 1
    text = tables.report(counts, by_setting, [])
    assert "| cycling | development | 2 | 50.0% | 50.0% | 0.0% | 0 | - | - | - | - |" in text
    assert "| cycling | held back | decline | whole | 1 of 1 | 100.0% | yes |" in text


def test_coverage_by_hand() -> None:
    changes = [["whole", "pursuer", 0.1, 0.0, 0.2], ["whole", "evader", 0.3, 0.0, 0.2]]
    rows = tables.count_changes([judgement("cycle", []) | {"changes": changes}])
    assert {(row["covered"], row["missed"]) for row in rows} == {("1", "1")}


@pytest.mark.parametrize(("count", "of"), [(0, 100), (3, 20), (19, 20)])
def test_upper_bounds_of_rates(count: int, of: int) -> None:
    # By definition: at the bound, so few happen with a probability of 5 %.
    assert binom.cdf(count, of, tables.upper_bound(count, of)) == pytest.approx(0.05)
    assert tables.upper_bound(of, of) == 1.0


def test_the_published_counts_are_of_all_conditions_and_small() -> None:
    counts = tables.read_counts(COMMITTED / "counts.csv")
    assert {row["condition"] for row in counts} == set(CONDITIONS)
    assert not list(COMMITTED.glob("*.jsonl"))
    assert sum(file.stat().st_size for file in COMMITTED.iterdir()) < 400_000


def test_verdicts_are_plain_values() -> None:
    found = judgement_errors.judged(judgement_errors.Task("synthetic", "noise only, .5", 4))
    assert json.loads(json.dumps(found, allow_nan=False))["kind"] == "noise only, .5"
