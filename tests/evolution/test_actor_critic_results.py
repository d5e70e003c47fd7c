"""The scripts that compare policy gradients with neuroevolution: their runs, verdicts and files."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import actor_critic_baselines as baselines
import actor_critic_races as races
from evolution_scripts import DOCS, RESULTS, read, run_quickly, run_script
from matrixworld.analysis import interval_over_runs
from matrixworld.coevolution import open_run

PUBLISHED = RESULTS / "actor_critic"


def test_baselines_play_each_game_with_each_learner_and_continue(tmp_path: Path) -> None:
    pytest.importorskip("torch")
    told = run_quickly("actor_critic_baselines", tmp_path, "--processes", "1")
    results = tmp_path / "actor_critic"
    assert told.startswith(read(results / "baselines.md"))
    numbers = np.load(results / "baselines.npz")
    assert numbers["captures"].shape == (4, 3, 2, 4)
    root = tmp_path / "runs" / "actor_critic" / "quick"
    for game, seed in (
        ("pursuers-against-random-evaders", 0),
        ("evaders-against-random-pursuers", 1),
    ):
        run = open_run(root / game / "actor-critic" / str(seed))
        at = 0 if seed == 0 else 2, 0, seed
        np.testing.assert_array_equal(numbers["captures"][at], run.payoff().capture_rates[-1, -1])
    # Taught evaders start from those of their own learner, and all meet the same pursuers.
    for learner in ("actor-critic", "evolution-equal-time"):
        taught = open_run(root / "evaders-against-those-pursuers" / learner / "1")
        begun = open_run(root / "evaders-against-random-pursuers" / learner / "1")
        rivals = open_run(root / "pursuers-against-random-evaders" / "actor-critic" / "1")
        genomes, pursuers = taught.teams["evader"].genomes, rivals.teams["pursuer"].genomes
        np.testing.assert_array_equal(genomes[0], begun.teams["evader"].genomes[-1])
        np.testing.assert_array_equal(taught.teams["pursuer"].genomes, pursuers[-1:])

    # A run without its time is played anew; the others are only read.
    lost = root / "pursuers-against-static-evaders" / "actor-critic" / "0"
    lost.with_suffix(".seconds").unlink()
    kept = {path: path.stat().st_mtime_ns for path in root.rglob("summary.json")}
    again = run_quickly("actor_critic_baselines", tmp_path, "--processes", "1")
    changed = [path for path, time in kept.items() if path.stat().st_mtime_ns != time]
    assert changed == [lost / "summary.json"]
    assert again.count("\n") == told.count("\n")


@pytest.mark.parametrize(
    ("team", "values", "verdict"),
    [
        ("pursuer", [0.9, 0.91, 0.92], "reached"),
        ("pursuer", [0.5, 0.51, 0.52], "not reached"),
        ("pursuer", [0.5, 0.95, 0.99], "undecided"),
        ("pursuer", [0.9, 0.9, 0.9], "reached"),
        ("evader", [0.1, 0.11, 0.12], "reached"),
        ("evader", [0.97, 0.98, 0.99], "not reached"),
    ],
)
def test_verdicts(team: str, values: list[float], verdict: str) -> None:
    # The published interval is 0.8 +- 2.262 * 0.1 / sqrt(10) = 0.8 +- 0.072.
    game = baselines.Game("a game", team, "random", 0.8, 0.1)
    assert game.verdict(interval_over_runs(values, bounds=(0.0, 1.0))) == verdict


def test_the_committed_baselines_follow_from_the_committed_numbers() -> None:
    numbers = dict(np.load(PUBLISHED / "baselines.npz"))
    table = read(PUBLISHED / "baselines.md")
    assert baselines.table(baselines.FULL, numbers) + "\n" == table
    assert table in read(DOCS / "actor_critic.md")


def test_the_committed_verdicts_follow_from_the_committed_races() -> None:
    table = read(PUBLISHED / "races.md")
    assert races.table(dict(np.load(PUBLISHED / "races.npz"))) + "\n" == table
    assert table in read(DOCS / "actor_critic.md")


def test_races_are_judged_by_schedule(tmp_path: Path) -> None:
    pytest.importorskip("torch")
    told = run_quickly("actor_critic_races", tmp_path, "--threads", "1")
    assert told.startswith(read(tmp_path / "actor_critic" / "races.md"))
    for schedule in ("specialist-specialist", "generalist-specialist", "generalist-generalist"):
        assert f"| {schedule} | " in told
    assert len(list((tmp_path / "runs").rglob("summary.json"))) == 3 * 2
    assert run_quickly("actor_critic_races", tmp_path, "--threads", "1") == told


def test_the_hours_of_the_published_size_are_projected(tmp_path: Path) -> None:
    pytest.importorskip("torch")
    done = run_script("actor_critic_races", tmp_path, "--quick", "--project")
    assert "hours of training" in done.stdout, done.stderr
    assert list(tmp_path.iterdir()) == []
