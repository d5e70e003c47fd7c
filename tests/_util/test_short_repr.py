"""Results with arrays have a text of one line."""

import numpy as np
import pytest

import matrixworld as mw
from matrixworld import analysis
from matrixworld.coevolution import finish, open_run
from tiny_race import tiny_race, tiny_single

PAYOFF = np.random.default_rng(0).random((12, 11))
NETWORK = mw.Network.for_config(mw.WorldConfig("O"))
RESULTS = {
    "AlphaRank": lambda: analysis.alpha_rank(PAYOFF),
    "Judgement": lambda: analysis.judge(PAYOFF),
    "LagProfile": lambda: analysis.lag_profile(PAYOFF),
    "Nash": lambda: analysis.nash_averaging(PAYOFF),
    "Population": lambda: mw.Population(np.zeros((3, NETWORK.genome_size), np.float32), NETWORK),
    "EpisodeStatistics": lambda: mw.rollout("O", "still", "still", mw.Matches.of([0, 0], 0, 1)),
}


@pytest.mark.parametrize("name", RESULTS)
def test_a_result_has_a_text_of_one_line(name):
    text = repr(RESULTS[name]())
    assert text.startswith(f"{name}(")
    assert "\n" not in text
    assert len(text) <= 600  # a few lines of a notebook; arrays would have thousands


def test_a_run_says_what_it_is(tmp_path):
    finish(tiny_race(), tmp_path / "race")
    assert repr(open_run(tmp_path / "race")) == (
        f"SavedRun('{tmp_path / 'race'}', generalist-generalist, seed 5, pursuers: 3, evaders: 3)"
    )
    finish(tiny_single(), tmp_path / "one")
    assert "pursuer-against-random, seed" in repr(open_run(tmp_path / "one"))


def test_arrays_appear_as_dtype_and_shape():
    assert repr(analysis.lag_profile(PAYOFF)) == (
        "LagProfile(lags=<int64 (22,)>, means=<float64 (22,)>, cells=<int64 (22,)>)"
    )
