"""Notebook 4: what its text says of kept results."""

from __future__ import annotations

import numpy as np

from matrixworld import analysis
from matrixworld.tutorial import kept


def test_the_red_queen_in_the_kept_races() -> None:
    saved = kept("chapter_4")
    races = saved["captured"] / saved["evaders_met"]
    when = saved["generations"].tolist()
    assert races.shape == (10, 25, 25)
    assert (races.min(), races.max()) >= (0, 0)
    assert races.max() <= 1
    diagonal = np.array([np.diag(race) for race in races])[:, when]

    def change(scores: np.ndarray, begin: int, end: int) -> analysis.Estimate:
        found = scores[:, when.index(end)] - scores[:, when.index(begin)]
        return analysis.interval_over_runs(found.astype(float))

    whole = change(diagonal, 0, 24)
    assert whole.low < 0 < whole.high
    assert change(diagonal, 0, 6).high < 0 < change(diagonal, 6, 24).low
    assert change(saved["pursuer"], 0, 24).low > 0
    assert change(saved["evader"], 0, 24).low > 0
    assert change(saved["evader"], 0, 6).low > 0
    later = change(saved["evader"], 6, 24)
    assert later.low < 0 < later.high
    assert change(saved["pursuer"], 6, 24).low > 0
    assert (saved["evader"][:, -1] > saved["evader"][:, 0]).all()
