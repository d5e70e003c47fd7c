"""Results have a text of one line, and tables where they are printed and in notebooks."""

import numpy as np
import pytest

import matrixworld as mw
from matrixworld import analysis
from matrixworld.coevolution.evaluation.scores import HeldOutScores

PAYOFF = np.random.default_rng(0).random((12, 11))
NETWORK = mw.Network.for_config(mw.WorldConfig("O"))
RESULTS = {
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


def test_text_of_others_is_escaped():
    scores = HeldOutScores("evader", (1,), ("<b>", "fleer"), np.ones((1, 2, 9)))
    assert "<b>" in str(scores)
    assert "<b>" not in scores._repr_html_()
    assert "&lt;b&gt;" in scores._repr_html_()
