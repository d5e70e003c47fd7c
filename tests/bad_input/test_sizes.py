"""Jobs and pictures that are too large are refused before anything is written."""

from pathlib import Path

import pytest

from matrixworld.coevolution import RaceSettings, evolve
from matrixworld.episodes import replay
from rows import random_walks
from tiny_race import tiny_race

TOO_LARGE = {
    "policy.hidden": tiny_race(hidden=(2**20, 2**20)),
    "learner.population": tiny_race(population=2**31 - 2),
    "schedule.generations": tiny_race(generations=2**31 - 1),
    "evaluation_episodes": tiny_race(evaluation_episodes=2**31 - 1),
}
"""Jobs by the setting to make smaller."""


@pytest.mark.parametrize("name", TOO_LARGE)
def test_a_job_that_is_too_large_is_refused_with_an_estimate(name: str, tmp_path: Path) -> None:
    settings: RaceSettings = TOO_LARGE[name]
    with pytest.raises(ValueError, match=f"memory.* got an estimate of .* GB.*less .*{name}"):
        evolve(settings, tmp_path / "job")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("suffix", [".gif", ".mp4"])
def test_animations_have_a_largest_size(
    tmp_path: Path, suffix: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(replay, "MOST_ANIMATED", 10**6)
    with pytest.raises(ValueError, match="animation: expected at most 1,000,000 pixels in all"):
        replay.save(random_walks(), tmp_path / f"x{suffix}")
    assert list(tmp_path.iterdir()) == []
