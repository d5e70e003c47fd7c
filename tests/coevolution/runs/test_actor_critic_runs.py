"""Runs of the actor-critic learner: all schedules, exact resume, what it needs and refuses."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from matrixworld.coevolution import RaceSettings, best_response, finish, open_run, start
from matrixworld.coevolution.schedules import SCHEDULES
from tiny_race import check_resumes, results, tiny_race, tiny_single

LEARNER: dict[str, Any] = {"learner": "actor-critic", "population": 3, "actor_rate": 0.01}


@pytest.fixture
def torch() -> Any:
    return pytest.importorskip("torch")


@pytest.mark.parametrize("schedule", [*SCHEDULES, "alternating", "hall-of-fame"])
def test_every_schedule_learns_and_resumes_bit_for_bit(
    torch, schedule: str, tmp_path: Path
) -> None:
    settings = tiny_race(**LEARNER, schedule=schedule)
    check_resumes(settings, 5, tmp_path / "run")
    run = open_run(tmp_path / "run")
    for team in ("pursuer", "evader"):
        genomes = run.teams[team].genomes
        assert len(np.unique(genomes, axis=0)) == len(genomes) == 3
    run.record(pursuer=-1, evader=-1)


@pytest.mark.parametrize(
    "changes",
    [
        {"central_critic": True},
        {"cost_limit": 2.0, "clip": 0.2},
        {"match_episodes": 2},
        {"hidden": ()},
    ],
    ids=["central", "costs", "worlds", "linear"],
)
def test_options_of_the_learner(torch, changes: dict[str, Any], tmp_path: Path) -> None:
    settings = tiny_single(**{**LEARNER, **changes})
    finish(settings, tmp_path / "one", threads=1)
    finish(settings, tmp_path / "two", threads=2)
    assert results(tmp_path / "one") == results(tmp_path / "two")
    plain = finish(tiny_single(**LEARNER), tmp_path / "plain", threads=1)
    assert not np.array_equal(
        open_run(tmp_path / "one").teams["pursuer"].genomes[-1],
        plain.teams["pursuer"].genomes[-1],
    )


def test_a_team_learns_from_a_run_s_genome_and_is_exploited(torch, tmp_path: Path) -> None:
    finish(tiny_single(**LEARNER), tmp_path / "first", threads=1)
    more = tiny_single(**LEARNER, start=str(tmp_path / "first"), team="pursuer")
    run = finish(more, tmp_path / "second", threads=1)
    first = open_run(tmp_path / "first").teams["pursuer"].genomes[-1]
    np.testing.assert_array_equal(run.teams["pursuer"].genomes[0], first)
    best_response(run, "pursuer", 48, tmp_path / "response", evaluation_episodes=2)


def test_without_torch_the_extra_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "torch", None)
    with pytest.raises(ImportError, match=r"pip install 'matrixworld-pursuit\[torch\]'"):
        start(tiny_race(**LEARNER), tmp_path / "run")
    assert not (tmp_path / "run").exists()


@pytest.mark.parametrize("device", ["tpu9", "meta", "cuda:99"])
def test_a_device_that_is_missing_is_refused_before_anything_is_written(
    torch, device: str, tmp_path: Path
) -> None:
    with pytest.raises(ValueError, match="device: expected a device that PyTorch has on this mach"):
        start(tiny_race(**LEARNER, device=device), tmp_path / "run")
    assert not (tmp_path / "run").exists()


def test_settings_can_be_read_without_torch(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "torch", None)
    assert isinstance(tiny_race(**LEARNER), RaceSettings)
