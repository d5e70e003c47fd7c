"""Diagnosis: its numbers, its calibration, and verdicts on races whose truth is known."""

from __future__ import annotations

import json
import re

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays
from matrixworld.analysis.calibration import (
    ABSENT,
    CANNOT_TELL,
    PRESENT,
    STRENGTHS,
    Bins,
    calibration,
    strength,
    tally,
)
from matrixworld.analysis.diagnosis import _unless_cycling
from matrixworld.analysis.findings import ADVICE, LABELS
from scipy.stats import fisher_exact

from matrices import circular, logistic, staircase
from matrixworld import analysis, toys
from matrixworld.analysis import CONDITIONS, diagnose
from matrixworld.analysis.evidence import BOUNDS, SUPPORT, numbers_of_run, one_sided_share
from matrixworld.coevolution.opponents import Uniform
from matrixworld.coevolution.types import TEAMS
from matrixworld.toys.labelled_races import truth_of_hands, truth_of_history

rates = arrays.arrays(
    np.float64,
    arrays.array_shapes(min_dims=2, max_dims=2, min_side=3, max_side=9),
    elements=st.integers(0, 8).map(lambda n: n / 8),
)


def played(chance: np.ndarray, episodes: int = 20, seed: int = 0) -> np.ndarray:
    """Draw episodes that are won with these probabilities."""
    rng = np.random.default_rng(seed)
    return (rng.random((*chance.shape, episodes)) < chance[..., None]).astype(float)


# ---- The numbers ---------------------------------------------------------------------------------


@given(rates)
def test_rises_are_means_over_pairs(matrix: np.ndarray) -> None:
    size = min(matrix.shape)
    pursuers, evaders = [], []
    for k in range(1, size):
        current = (matrix[k, k - 1] + matrix[k, k]) / 2
        for later in range(k + 1, size):
            pursuers.append(matrix[later, k] - current)
            evaders.append(current - matrix[k, later])
    found = analysis.rises(matrix)
    assert found == pytest.approx((np.mean(pursuers), np.mean(evaders)))


def test_rises_by_hand() -> None:
    # The later generation wins; pursuers are later in half of the team phases.
    later_wins = np.tri(9, k=-1)
    assert analysis.rises(later_wins) == pytest.approx((0.5, 0.5))
    # Constant rates: neither team rises.
    assert analysis.rises(np.full((5, 5), 0.3)) == pytest.approx((0.0, 0.0))
    # Pursuers improve, evaders do not change.
    alone = np.linspace(0.2, 0.8, 7)[:, None] * np.ones(7)
    found = analysis.rises(alone)
    assert found == pytest.approx((0.1 * 7 / 3, 0.0))  # the mean lag of pairs of 6 is 7 / 3
    with pytest.raises(ValueError, match=r"at least 3 x 3 generations, got \(2, 5\)"):
        analysis.rises(np.zeros((2, 5)))


@given(rates)
def test_the_same_episodes_twice_give_forgetting(matrix: np.ndarray) -> None:
    plain, held_out = analysis.forgetting(matrix), analysis.held_out_forgetting(matrix, matrix)
    np.testing.assert_allclose(held_out.pursuers, plain.pursuers, atol=1e-12)
    np.testing.assert_allclose(held_out.evaders, plain.evaders, atol=1e-12)


def test_held_out_forgetting_by_hand() -> None:
    one = np.array([[0.9], [0.2], [0.5]])
    other = np.array([[0.6], [0.7], [0.1]])
    # `one` chooses row 0 always; measured 0, .6 - .7, .6 - .1. `other` chooses rows 0, 1, 1;
    # measured 0, 0, .2 - .5.
    found = analysis.held_out_forgetting(one, other).pursuers
    np.testing.assert_allclose(found, [0.0, (-0.1 + 0.0) / 2, (0.5 - 0.3) / 2])
    with pytest.raises(ValueError, match=r"two matrices of shape \(3, 1\), got \(1, 3\)"):
        analysis.held_out_forgetting(one, other.T)


def test_noise_alone_is_not_forgetting() -> None:
    found = []
    for seed in range(20):
        scores = played(np.full((31, 31), 0.5), 10, seed)
        halves = scores[..., ::2].mean(axis=2), scores[..., 1::2].mean(axis=2)
        found.append(analysis.held_out_forgetting(*halves).pursuers[-1])
        assert analysis.forgetting(scores.mean(axis=2)).pursuers[-1] > 0.25
    assert np.mean(found) == pytest.approx(0.0, abs=0.03)


def test_one_sided_share_is_of_the_last_half() -> None:
    won, open_ = (0.99, 0.98), (0.7, 0.3)
    assert one_sided_share([won] * 5 + [open_] * 5) == 0.0
    assert one_sided_share([open_] * 5 + [won] * 5) == 1.0
    assert one_sided_share([open_] * 7 + [won] * 3) == pytest.approx(3 / 5)
    assert one_sided_share([open_] * 8 + [won] * 2) == 0.0  # not three in a row


def test_values_and_intervals_are_corrected_for_episode_noise() -> None:
    chance = 0.5 + 0.4 * (logistic(31, 0.4) - 0.5)  # no checkerboards without noise
    scores = played(chance, 16)
    found = numbers_of_run(
        scores.mean(axis=2), scores, None, level=0.95, resamples=40, rng=np.random.default_rng(0)
    )
    plain = numbers_of_run(
        scores.mean(axis=2), None, None, level=0.95, resamples=1, rng=np.random.default_rng(0)
    )
    assert found.keys() == plain.keys() == BOUNDS.keys()
    assert plain["checkerboards"].value > 0.004
    assert found["checkerboards"].value < plain["checkerboards"].value / 2
    assert found["most_forgetting"].value < plain["most_forgetting"].value / 2
    exact = analysis.rises(analysis.last_half(chance)).pursuers
    rise = found["pursuer_rise"]
    assert rise.low is not None
    assert rise.high is not None
    assert rise.low < exact < rise.high
    assert plain["pursuer_rise"].low is None


# ---- Calibration ---------------------------------------------------------------------------------


def test_bins_by_hand() -> None:
    bins = tally(
        (0.1, 0.2), [(0.05, False)] * 8 + [(0.1, True), (0.15, False)] + [(0.9, True)] * 18
    )
    assert bins == Bins((0.1, 0.2), (0, 1, 18), (8, 1, 0))
    assert bins.shares((0.0, 0.0)) == (0.1, 0.1)
    assert bins.shares((0.05, 0.3)) == (0.1, 0.95)
    assert bins.judge((0.0, 0.09)) == (ABSENT, 0.9)
    assert bins.judge((0.2, 5.0)) == (PRESENT, 0.95)
    assert bins.judge((0.15, 0.15)) == (CANNOT_TELL, 0.0)
    assert bins.judge((0.19, 0.21)) == (CANNOT_TELL, 0.0)
    assert Bins((0.5,), (3, 0), (0, 0)).judge((0.0, 0.0)) == (PRESENT, 0.8)
    assert Bins((0.5,), (0, 0), (0, 0)).judge((0.0, 1.0)) == (CANNOT_TELL, 0.0)


def test_the_calibration_is_of_every_condition() -> None:
    found = calibration()
    assert found.episodes.keys() == found.means.keys() == found.slack.keys() == set(CONDITIONS)
    for bins in (*found.episodes.values(), *found.means.values()):
        assert len(bins.present) == len(bins.absent) == len(bins.edges) + 1
        assert list(bins.edges) == sorted(bins.edges)
        assert sum(bins.present) >= 30
        assert sum(bins.absent) >= 30
    assert "seeds 0 to 39" in found.source


@pytest.fixture(scope="module")
def rerun() -> list[tuple[toys.LabelledRace, dict[str, analysis.Estimate]]]:
    """Measure two calibration seeds of each toy again, with other resamples."""
    races = [toys.labelled_race(name, seed) for name in toys.RACES for seed in (0, 12)]
    rng = np.random.default_rng(9)
    return [
        (
            race,
            numbers_of_run(
                race.scores.mean(axis=2), race.scores, None, level=0.95, resamples=6, rng=rng
            ),
        )
        for race in races
    ]


@pytest.mark.parametrize("condition", CONDITIONS)
def test_the_calibration_agrees_with_a_re_run(condition: str, rerun) -> None:
    told = [
        (strength(condition, numbers), race.truth[condition])
        for race, numbers in rerun
        if race.truth[condition] is not None
        and not (race.truth["disengagement"] and condition != "disengagement")
        and not (race.truth["cycling"] and condition == "stagnation")
    ]
    committed = calibration().episodes[condition]
    again = tally(committed.edges, told)
    # Few races must be distributed over the bins as the committed ones are.
    for one, other in ((committed.present, again.present), (committed.absent, again.absent)):
        assert sum(other) >= 2
        for k in range(1, len(one)):
            halves = [[sum(one[:k]), sum(one[k:])], [sum(other[:k]), sum(other[k:])]]
            assert fisher_exact(halves).pvalue > 1e-4, (k, one, other)


# ---- Diagnosis -----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("toy", "present", "absent"),
    [
        ("rock-paper-scissors, specialists", {"cycling", "forgetting"}, {"arms race"}),
        ("virulence .75, climbing", {"arms race"}, {"cycling", "stagnation", "disengagement"}),
        ("virulence 1", {"disengagement"}, set()),
        ("scalar, at the top", {"stagnation"}, {"arms race", "cycling", "disengagement"}),
        ("scalar, without mutation", {"stagnation"}, {"cycling", "forgetting"}),
    ],
)
def test_toys(toy: str, present: set[str], absent: set[str]) -> None:
    found = diagnose(toys.labelled_race(toy, 2005).scores, episodes=True)
    assert set(found.present) == present
    assert absent <= {one.name for one in found.findings if one.verdict == ABSENT}
    for one in found.findings:
        assert (one.confidence >= 0.8) == (one.verdict != CANNOT_TELL)
        assert one.advice == ADVICE[one.name][one.verdict]
        assert next(iter(one.evidence)) == STRENGTHS[one.name]
        assert one.by_run == (one.verdict,) or one.name == "stagnation"


def test_matrices_whose_diagnosis_is_known() -> None:
    assert set(diagnose(circular(31)).present) == {"cycling", "forgetting"}
    race = diagnose(logistic(31, 0.3))
    assert race.present == ("arms race",)
    assert race["stagnation"].verdict == ABSENT
    assert race["cycling"].verdict == ABSENT
    assert diagnose(np.full((31, 31), 0.4)).present == ("stagnation",)


@pytest.mark.parametrize("rate", [0.0, 1.0])
def test_disengagement_hides_other_conditions(rate: float) -> None:
    found = diagnose(np.full((20, 20), rate))
    assert found.present == ("disengagement",)
    for name in set(CONDITIONS) - {"disengagement"}:
        assert found[name].verdict == CANNOT_TELL
        assert "hides" in found[name].reason


def test_team_phase_rates_of_a_log_decide_about_disengagement() -> None:
    matrix = np.full((20, 20), 0.5)
    assert diagnose(matrix)["disengagement"].verdict == ABSENT
    found = diagnose(matrix, team_phase_rates=[(0.99, 0.98)] * 100)
    assert found["disengagement"].verdict == PRESENT
    assert found["disengagement"].evidence["one_sided"].value == 1.0
    with pytest.raises(ValueError, match="team phases of a single run, got 2 runs"):
        diagnose([matrix, matrix], team_phase_rates=[(0.5, 0.5)])


def test_too_few_generations_give_no_verdict() -> None:
    found = diagnose(circular(11))
    assert found.present == ()
    assert {one.verdict for one in found.findings} == {CANNOT_TELL}
    assert all("at least 12 generations and there are 11" in one.reason for one in found.findings)
    assert diagnose(circular(12))["cycling"].verdict == PRESENT


def test_noise_as_large_as_the_effect_gives_no_verdict() -> None:
    # A clear arms race in many episodes, and a weak one in few.
    chance = 0.5 + 0.45 * (logistic(31, 0.3) - 0.5) / 0.5
    assert diagnose(played(chance, 100), episodes=True)["arms race"].verdict == PRESENT
    weak = 0.5 + 0.1 * (logistic(31, 0.3) - 0.5) / 0.5
    assert diagnose(played(weak, 4), episodes=True)["arms race"].verdict != PRESENT


def test_without_episodes_the_interval_comes_from_the_calibration() -> None:
    edge = calibration().episodes["cycling"].edges[-1]
    slack = calibration().slack["cycling"]
    numbers = {"checkerboards": analysis.Estimate(edge + slack / 2, None, None, "nothing", 1)}
    low, high = analysis.calibration.strength_interval("cycling", numbers, slack)
    assert (low, high) == pytest.approx((edge - slack / 2, edge + 1.5 * slack))
    size = {"greatest_rise": analysis.Estimate(-0.1, -0.3, 0.05, "episodes", 10)}
    assert analysis.calibration.strength_interval("stagnation", size, 0.0) == (0.0, 0.3)
    falls = {"greatest_rise": analysis.Estimate(-0.2, -0.3, -0.1, "episodes", 10)}
    assert analysis.calibration.strength_interval("stagnation", falls, 0.0) == (0.1, 0.3)


def test_runs_with_opposite_verdicts_give_no_verdict() -> None:
    cycles, races = circular(31), logistic(31, 0.3)
    found = diagnose(np.array([cycles] * 4 + [races] * 2))
    assert found["cycling"].verdict == CANNOT_TELL
    assert found["cycling"].by_run == (PRESENT,) * 4 + (ABSENT,) * 2
    assert "present in 4, absent in 2 of 6" in found["cycling"].reason
    assert found["stagnation"].verdict == ABSENT
    together = diagnose(np.array([cycles] * 6))
    assert together["cycling"].verdict == PRESENT
    assert together["cycling"].evidence["checkerboards"].over == "runs"


def test_a_race_that_may_cycle_is_not_called_stagnant() -> None:
    assert _unless_cycling((PRESENT, 0.9, "no trend"), CANNOT_TELL, 0.0)[:2] == (CANNOT_TELL, 0.0)
    assert _unless_cycling((PRESENT, 0.9, "no trend"), PRESENT, 0.8)[:2] == (ABSENT, 0.8)
    assert _unless_cycling((PRESENT, 0.9, "no trend"), ABSENT, 0.8) == (PRESENT, 0.9, "no trend")
    assert _unless_cycling((ABSENT, 0.9, "a trend"), CANNOT_TELL, 0.0) == (ABSENT, 0.9, "a trend")


def test_stagnation_of_each_run_depends_on_the_cycling_of_that_run() -> None:
    still, cycles = np.full((31, 31), 0.5), circular(31)
    found = diagnose(np.array([still, cycles]))
    assert found["cycling"].by_run == (ABSENT, PRESENT)
    assert found["stagnation"].by_run == (PRESENT, ABSENT)


def test_the_interval_of_few_runs_is_their_range() -> None:
    waves = [0.5 + factor * (circular(31) - 0.5) for factor in (0.3, 1.0, 1.0)]
    alone = [diagnose(wave)["cycling"].evidence["checkerboards"].value for wave in waves]
    together = diagnose(np.array(waves))["cycling"].evidence["checkerboards"]
    assert (together.low, together.high) == (min(alone), max(alone))
    assert together.value == pytest.approx(np.mean(alone))
    many = diagnose(np.array(waves * 3))["cycling"].evidence["checkerboards"]
    assert many.low is not None
    assert min(alone) < many.low < many.value


def test_a_disengaged_run_is_left_out_of_other_conditions() -> None:
    found = diagnose(np.array([logistic(31, 0.3)] * 5 + [np.zeros((31, 31))]))
    assert found["disengagement"].by_run == (ABSENT,) * 5 + (PRESENT,)
    assert found["arms race"].verdict == PRESENT
    assert found["arms race"].evidence["least_rise"].samples == 5
    assert found["arms race"].by_run[-1] == CANNOT_TELL


def test_swapping_the_teams_hardly_changes_the_numbers() -> None:
    for matrix in (circular(31), logistic(31, 0.3), staircase(31)):
        one, other = diagnose(matrix), diagnose(analysis.swap_teams(matrix))
        for name in ("cycling", "forgetting"):
            key = STRENGTHS[name]
            assert one[name].evidence[key].value == pytest.approx(other[name].evidence[key].value)


def test_text_and_json() -> None:
    found = diagnose(
        toys.labelled_race("rock-paper-scissors, specialists", 2000).scores, episodes=True
    )
    text = str(found)
    assert text.startswith(
        "A single run, 31 pursuer and 31 evader generations: cycling, forgetting."
    )
    assert len(text.splitlines()) == 2 + len(CONDITIONS)
    assert "Cycling: present (confidence 0." in text
    assert "dominant pursuer generations" in text
    assert not re.search(r"\bnan\b", text)
    plain = found.to_json()
    assert json.loads(json.dumps(plain, allow_nan=False)) == plain
    assert [one["name"] for one in plain["findings"]] == list(CONDITIONS)
    constant = diagnose(np.full((12, 12), 0.5)).to_json()
    assert constant["findings"][4]["evidence"]["transitive_share"]["value"] is None
    assert "6 runs" in str(diagnose(np.array([circular(31)] * 6)))
    assert {key for keys in SUPPORT.values() for key in keys} <= LABELS.keys()
    assert ADVICE.keys() == set(CONDITIONS)


def test_the_same_seed_gives_the_same_diagnosis() -> None:
    scores = toys.labelled_race("intransitive", 0).scores
    assert diagnose(scores, episodes=True).to_json() == diagnose(scores, episodes=True).to_json()


@settings(max_examples=30)
@given(rates)
def test_every_matrix_has_a_diagnosis(matrix: np.ndarray) -> None:
    large = np.tile(matrix, (4, 4))
    found = diagnose(large)
    for one in found.findings:
        assert 0.0 <= one.confidence <= 1.0
    json.dumps(found.to_json(), allow_nan=False)
    assert not {"cycling", "stagnation"} <= set(found.present)


def test_bad_input_is_refused() -> None:
    with pytest.raises(ValueError, match=r"level in \(0, 1\), got 1"):
        diagnose(circular(12), level=1)
    with pytest.raises(ValueError, match="got 1.5"):
        diagnose(np.full((12, 12), 1.5))
    with pytest.raises(KeyError):
        diagnose(circular(12))["boredom"]


# ---- The toys ------------------------------------------------------------------------------------


def test_chances_of_hands_and_of_averages() -> None:
    pure = np.eye(3)
    np.testing.assert_allclose(
        toys.capture_probabilities(pure, pure), [[0.5, 0.0, 1.0], [1.0, 0.5, 0.0], [0.0, 1.0, 0.5]]
    )
    lucky = toys.capture_probabilities(pure, pure, luck=0.1)
    np.testing.assert_allclose(lucky[0], [0.5, 0.1, 0.9])
    np.testing.assert_allclose(toys.average_strategies([0, 1, 1, 2])[-1], [0.25, 0.5, 0.25])
    np.testing.assert_allclose(
        toys.capture_probabilities(np.full((1, 3), 1 / 3), pure), [[0.5] * 3]
    )
    with pytest.raises(ValueError, match=r"luck: expected a number in \[0, 0.5\], got 0.6"):
        toys.capture_probabilities(pure, pure, luck=0.6)


def test_averages_are_near_the_equilibrium_from_the_start() -> None:
    # The truth of "rock-paper-scissors, its averages" relies on it.
    for seed in range(3):
        hands = toys.play_together({team: Uniform(None) for team in TEAMS}, 400, seed)
        for rounds in (100, 250, 400):
            so_far = {team: hands[team][: rounds + 1] for team in TEAMS}
            assert toys.exploitability(so_far) < 0.15


def test_scores_of_a_history_by_hand() -> None:
    ones = np.array([[[[3], [3]], [[1], [1]]], [[[2], [2]], [[2], [2]]]])
    history = toys.History(toys.GAMES["scalar"], ones, np.zeros((1, 2, 2)))
    scores = history.scores([0, 1], 3, np.random.default_rng(0))
    assert scores.shape == (2, 2, 3)
    # 3 against 1 and 2; 2 against 1 and 2.
    assert scores.mean(axis=2).tolist() == [[1.0, 1.0], [1.0, 0.5]]
    assert history.objective.tolist() == [[[3, 3], [1, 1]], [[2, 2], [2, 2]]]


def test_scores_draw_individuals_at_random() -> None:
    ones = np.array([[[[0], [2]], [[1], [1]]]])  # one of two wins
    history = toys.History(toys.GAMES["scalar"], ones, np.zeros((0, 2, 2)))
    assert history.scores([0], 2000, np.random.default_rng(0)).mean() == pytest.approx(
        0.5, abs=0.05
    )


def test_truth_of_hands_by_hand() -> None:
    rounds = {"pursuer": [0, 0, 1, 2, 0], "evader": [0, 0, 1, 2, 0]}
    assert truth_of_hands(rounds, 1)["cycling"] is True
    assert truth_of_hands(rounds, 2)["cycling"] is None
    assert truth_of_hands(rounds, 1)["arms race"] is False


def a_history(game: str, totals: np.ndarray, *, engaged: bool = True) -> toys.History:
    """Return a history of pairs of individuals with `totals` ones, (k, dimensions)."""
    ones = np.repeat(np.repeat(totals[:, None, None, :], 2, axis=1), 2, axis=2)
    wins = np.zeros((len(totals) - 1, 2, 2))
    wins[..., 0] = engaged
    return toys.History(toys.GAMES[game], ones.astype(int), wins)


def test_truth_of_histories_by_hand() -> None:
    every = np.arange(11)
    climbing = truth_of_history(a_history("scalar", 5 * every[:, None]), every)
    assert climbing == {
        "arms race": True,
        "cycling": False,
        "disengagement": False,
        "forgetting": False,
        "stagnation": False,
    }
    still = truth_of_history(a_history("scalar", np.full((11, 1), 50)), every)
    assert still == climbing | {"arms race": False, "stagnation": True}
    lost = truth_of_history(a_history("scalar", 50 - every[:, None]), every)
    assert lost["forgetting"] is True
    assert lost["stagnation"] is None
    idle = truth_of_history(a_history("scalar", 5 * every[:, None], engaged=False), every)
    assert idle["disengagement"] is True
    assert idle["forgetting"] is None
    there_and_back = np.minimum(every, 10 - every)[:, None] * np.array([[5, 5]])
    circle = truth_of_history(a_history("intransitive", there_and_back), every)
    assert circle["cycling"] is True
    assert circle["arms race"] is False
    assert circle["stagnation"] is False
    one_dimension_lost = np.full((11, 10), 5) + 0 * every[:, None]
    one_dimension_lost[5:, 3] = 2
    assert truth_of_history(a_history("focusing", one_dimension_lost), every)["forgetting"] is True
    one_dimension_lost[5:, 3] = 4
    assert truth_of_history(a_history("focusing", one_dimension_lost), every)["forgetting"] is None


def test_an_unlabelled_race_is_refused() -> None:
    with pytest.raises(ValueError, match="race: expected one of rock-paper-scissors, specialists"):
        toys.labelled_race("chess", 0)


def test_labelled_races_are_reproducible_and_name_every_condition(rerun) -> None:
    for race, _ in rerun:
        assert race.truth.keys() == set(CONDITIONS)
        assert race.scores.shape in {(31, 31, 10), (31, 31, 40)}
        assert set(np.unique(race.scores)) <= {0.0, 0.5, 1.0}
    for name in ("rock-paper-scissors, generalists", "virulence .75, climbing"):
        one, again, other = (toys.labelled_race(name, seed).scores for seed in (3, 3, 4))
        assert np.array_equal(one, again)
        assert not np.array_equal(one, other)
