"""Arguments that are wrong are refused in one sentence: what was expected and what came."""

from functools import partial

import numpy as np
import pytest

from matrices import ROCK_PAPER_SCISSORS, logistic
from matrixworld import analysis
from matrixworld.analysis.payoffs import check_payoff

PENNIES = np.eye(2)
HIDDEN = np.ma.array([[0.9, 0.5], [0.2, 0.3]], mask=[[0, 1], [0, 0]])


def test_rounding_is_clipped_and_more_is_refused():
    found = check_payoff([[1 + 1e-12, -1e-12, 0.5]])
    assert found.tolist() == [[1.0, 0.0, 0.5]]
    for rate in (1.01, 1 + 1e-6, -0.01):
        with pytest.raises(ValueError, match=r"in \[0, 1\], got"):
            check_payoff([[rate]])


HIDDEN_VALUES = np.ma.array([0.5, 0.6, 0.7], mask=[0, 1, 0])
HIDDEN_CURVES = np.ma.array(np.full((3, 4), 0.5), mask=np.eye(3, 4))
HIDDEN_SCORES = np.ma.array(np.full((7, 7, 4), 0.5), mask=np.eye(7)[..., None] * np.ones(4))


@pytest.mark.parametrize(
    ("function", "hidden"),
    [
        *((getattr(analysis, name), HIDDEN) for name in (
            "checkerboards", "ciao", "elo", "forgetting", "generalization", "judge", "lag_profile",
            "last_half", "measure_all", "measure_table", "nash_averaging", "read_payoffs",
            "team_phase_rates", "transitive_share",
        )),
        (analysis.disengagements, HIDDEN_CURVES[:, :2]),
        (analysis.elo_over_episodes, HIDDEN_SCORES),
        (partial(analysis.judge, per_episode=True), HIDDEN_SCORES),
        (analysis.interval_over_runs, HIDDEN_VALUES),
        (partial(analysis.difference_of_runs, [0.1, 0.2]), HIDDEN_VALUES),
        (analysis.band_over_runs, HIDDEN_CURVES),
        (analysis.interquartile_mean, HIDDEN_CURVES),
    ],
)  # fmt: skip
def test_what_a_mask_hides_is_never_used(function, hidden):
    with pytest.raises(ValueError, match="masked cell at"):
        function(hidden)


judge, over_runs = analysis.judge, analysis.interval_over_runs
exploit = partial(analysis.exploitability, ROCK_PAPER_SCISSORS, evaders=[1 / 3] * 3)
judged = judge(logistic(8))
NUMBERS = "an array of numbers, got"


@pytest.mark.parametrize(
    ("function", "arguments", "error", "message"),
    [
        (check_payoff, [np.zeros((2, 2, 2))], ValueError, r"2 dimension.*got shape \(2, 2, 2\)"),
        (check_payoff, [[[0.1, 0.2], [0.3]]], ValueError, r"got \[\[0.1, 0.2\], \[0.3\]\]"),
        (check_payoff, [[[0.0, np.nan]]], ValueError, r"got nan at index \(0, 1\)"),
        (check_payoff, [[["0.5", "0.6"]]], TypeError, NUMBERS),
        (partial(analysis.checkerboards, margin=-0.1), [PENNIES], ValueError, r"in \[0, 1\)"),
        (exploit, [[0.5, 0.5]], ValueError, "3 weights of the pursuers, got 2"),
        (exploit, [[0.5] * 3], ValueError, "weights of the pursuers with sum 1, got 1.5"),
        (analysis.elo_over_episodes, [np.zeros((2, 2, 1))], ValueError, "at least 2 episodes"),
        (analysis.disengagements, [[[0.5] * 3]], ValueError, r"shape \(K, 2\), got \(1, 3\)"),
        (over_runs, [[]], ValueError, r"values of runs with 1 dimension.* got shape \(0,\)"),
        (partial(over_runs, bounds=(1, 0)), [[0.1, 0.2]], ValueError, r"bounds .*, got \(1, 0\)"),
        (partial(analysis.difference_of_runs, [1], paired=True), [[0, 1]], ValueError, "1 paired"),
        (analysis.interquartile_mean, [[0.1]], ValueError, r"scores .* with 2 dim"),
        (analysis.measure_table, [np.zeros((1, 5))], ValueError, r"2 x 2 generations, got"),
        (analysis.MEASURES["lag_rise"].of, [PENNIES, "x"], ValueError, "^window: expected one of"),
        (judged.present, ["early"], ValueError, "^window: expected one of whole, first half"),
        (partial(judge, level=1.5), [logistic(8)], ValueError, r"level in \(0, 1\), got 1.5"),
        (partial(judge, episodes=0), [logistic(8)], ValueError, "episodes: expected"),
        (
            partial(judge, per_episode=True, episodes=5),
            [np.zeros((8, 8, 3))], ValueError, "3 episodes",
        ),
    ],
)  # fmt: skip
def test_a_wrong_argument_is_refused(function, arguments, error, message):
    with pytest.raises(error, match=message):
        function(*arguments)
