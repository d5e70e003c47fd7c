"""Sizes that cannot be are refused before anything is written: a job's memory, pictures."""

import numpy as np
import pytest

import matrixworld as mw
from matrixworld._util import checks
from matrixworld.coevolution import evolve
from tiny_race import tiny_race

MANY = 2**31 - 1  # the largest number that is accepted where sizes are ints
GB = 10**9
TOO_LARGE = {
    "networks": tiny_race(hidden=(2**20, 2**20)),
    "population": tiny_race(population=2**31 - 2),
    "generations": tiny_race(generations=MANY),
    "episodes": tiny_race(evaluation_episodes=MANY),
}
"""Jobs by the setting to make smaller."""


@pytest.mark.parametrize("settings", TOO_LARGE.values(), ids=TOO_LARGE)
def test_a_job_that_is_too_large_is_refused_with_an_estimate(settings, tmp_path, monkeypatch):
    monkeypatch.setattr(checks, "available_memory", lambda: GB // 2)
    with pytest.raises(checks.OutOfMemoryError, match="expected .*at most 0.5 GB.* got .* GB"):
        evolve(settings, tmp_path / "job")
    assert list(tmp_path.iterdir()) == []
    monkeypatch.setattr(checks, "available_memory", lambda: None)
    checks.check_memory("all", bytes=10**30)  # where memory is unknown nothing is refused


def test_what_else_is_too_large_fails_as_in_numpy():
    giant = mw.Network((2**20, 2**20))
    with pytest.raises(MemoryError, match="Unable to allocate"):
        giant.initial(np.random.default_rng(0))
    with pytest.raises(MemoryError):
        mw.Batch(MANY, mw.WorldConfig(rows=60, cols=60))
