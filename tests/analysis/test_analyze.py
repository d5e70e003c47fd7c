"""All measures of one run or several, with episodes, as JSON and as text."""

from __future__ import annotations

import json

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays
from scipy import stats

from matrices import additive, circular, logistic, staircase
from matrixworld import analysis

small_payoffs = arrays.arrays(
    np.float64,
    arrays.array_shapes(min_dims=2, max_dims=2, min_side=2, max_side=5),
    elements=st.integers(0, 16).map(lambda n: n / 16),
)
noisy = np.random.default_rng(0)
RUNS = np.stack([noisy.binomial(40, logistic(13)) / 40 for _ in range(6)])
SCORES = (noisy.random((13, 13, 20)) < logistic(13)[:, :, None]).astype(np.float32)


def test_analyze_returns_the_values_of_the_single_functions() -> None:
    matrix = circular(13)
    (run,) = analysis.analyze(matrix).runs
    np.testing.assert_array_equal(run.payoff, matrix)
    assert run.summary == analysis.summarize(matrix)
    assert run.nash.value == analysis.nash_averaging(matrix).value
    np.testing.assert_array_equal(run.ciao.pursuers.payoff, analysis.ciao(matrix).pursuers.payoff)
    np.testing.assert_array_equal(run.alpha_rank.ranks.pairs, analysis.alpha_rank(matrix).pairs)
    np.testing.assert_array_equal(run.ratings.u, analysis.multi_elo(matrix).u)
    assert run.alpha_rank.pursuers == tuple(range(13))
    assert run.dominance is None
    assert run.numbers["swing"] == analysis.swing(matrix)
    assert run.numbers["game_value"] == analysis.game_value(matrix)
    assert run.numbers["transitive_share"] == run.summary.last_half.transitive_share
    assert run.numbers["checkerboards"] == run.summary.last_half.checkerboard_share
    assert run.numbers["pursuer_stripes"] == run.ciao.pursuers.stripes
    assert run.numbers["evader_forgetting"] == run.summary.evaders.forgetting


def test_a_single_run_has_no_intervals_and_says_so() -> None:
    found = analysis.analyze(circular(13))
    assert all(one.low is None and "single run" in one.note for one in found.estimates.values())
    assert found.bands["lag_profile"].low is None
    text = str(found)
    assert "1 run, 13 pursuer and 13 evader generations\nA single run: no intervals.\n" in text
    assert "Judgement: cannot tell (last half)" in text


def test_several_runs_have_intervals_over_runs() -> None:
    found = analysis.analyze(RUNS)
    assert len(found.runs) == 6
    share = found.estimates["transitive_share"]
    each = [analysis.transitive_share(analysis.last_half(run)) for run in RUNS]
    assert share.value == pytest.approx(np.mean(each))
    assert share.low is not None
    assert share.high is not None
    half = stats.t.ppf(0.975, 5) * np.std(each, ddof=1) / np.sqrt(6)
    assert (share.low, share.high) == pytest.approx((share.value - half, share.value + half))
    assert (share.over, share.samples) == ("runs", 6)
    band = found.bands["pursuer_generalization"]
    assert band.low is not None
    assert band.high is not None
    assert (band.low <= band.mean).all()
    assert (band.mean <= band.high).all()
    text = str(found)
    assert "6 runs, 13 pursuer and 13 evader generations" in text
    assert "Mean (95% interval over runs):" in text
    assert f"{share}" in text
    assert "Of the single runs: " in text


def test_episodes_give_intervals_to_a_single_run_and_dominant_generations() -> None:
    found = analysis.analyze(SCORES, per_episode=True)
    assert found.estimates["capture_rate"].over == "episodes"
    assert found.runs[0].dominance is not None
    rungs = found.runs[0].dominance.pursuers.generations
    assert found.estimates["pursuer_rungs"].value == len(rungs) > 3
    text = str(found)
    assert "interval over its episodes, which says nothing about other runs" in text
    assert f"Dominant pursuers: generations {', '.join(map(str, rungs))}." in text
    assert found.estimates["checkerboards"].low is None
    assert " *\n" in text
    assert " **\n" in text
    remark = "biased by episode noise: no interval"
    assert f"  * {remark}, no variation beyond it\n  ** {remark}\n" in text


def test_one_run_with_episodes_may_be_a_stack_of_one() -> None:
    part = SCORES[:4, :4, :5]
    single, stacked = (analysis.analyze(each, per_episode=True) for each in (part, part[None]))
    assert single.to_json() == stacked.to_json()


def test_cross_tests_give_global_progress() -> None:
    cross = np.broadcast_to(RUNS[:2, None], (2, 2, 13, 13))
    found = analysis.analyze(RUNS[:2], cross=cross)
    assert found.global_progress is not None
    assert found.estimates["pursuer_global_gain"].value == pytest.approx(
        found.global_progress.pursuers.mean_gain
    )
    assert "global progress of the evaders" in str(found)
    with pytest.raises(ValueError, match=r"shape \(2, 2, 13, 13\), got \(2, 13, 13\)"):
        analysis.analyze(RUNS[:2], cross=RUNS[:2])


@pytest.mark.parametrize("matrix", [circular(12), staircase(9), additive(7, 12), np.zeros((2, 3))])
def test_json_contains_all_fields(matrix: np.ndarray) -> None:
    found = analysis.analyze(matrix)
    plain = found.to_json()
    assert json.loads(json.dumps(plain, allow_nan=False)) == plain
    assert plain["runs"][0]["payoff"] == matrix.tolist()
    assert plain["runs"][0]["summary"] == found.runs[0].summary.to_dict()
    assert len(plain["runs"][0]["alpha_rank"]["ranks"]["pursuers"]) == len(matrix)
    assert plain["estimates"]["capture_rate"]["low"] is None
    assert "nan" not in str(found)


def test_longer_runs_are_ranked_by_every_kth_generation() -> None:
    found = analysis.analyze_run(logistic(61)).alpha_rank
    assert found.pursuers == found.evaders == tuple(range(0, 61, 2))
    assert found.ranks.pairs.shape == (31, 31)
    uneven = analysis.analyze_run(logistic(66)[:, :33]).alpha_rank
    assert (uneven.pursuers[-1], uneven.evaders[-1]) == (65, 32)


def test_equal_runs_have_no_interval() -> None:
    found = analysis.analyze(np.stack([RUNS[0]] * 3))
    assert all(one.low is None for one in found.estimates.values())
    text = str(found)
    assert "Mean (95% interval over runs; few runs make it wide):" in text
    assert "  * no interval: all 3 runs are equal\n" in text


@settings(max_examples=25)
@given(small_payoffs)
def test_any_matrix_is_analysed_and_swapping_the_teams_swaps_the_numbers(
    matrix: np.ndarray,
) -> None:
    numbers = analysis.analyze(matrix).runs[0].numbers
    swapped = analysis.analyze(1 - matrix.T).runs[0].numbers
    for name, value in numbers.items():
        # Pursuers learn first in a generation; equally strong cycles may come in any order.
        if name in ("swing", "multi_elo_log_loss"):
            continue
        team, _, measure = name.partition("_")
        other = {"pursuer": f"evader_{measure}", "evader": f"pursuer_{measure}"}.get(team, name)
        expected = 1 - value if name in ("capture_rate", "game_value") else value
        np.testing.assert_allclose(swapped[other], expected, atol=1e-6, err_msg=name)


@pytest.mark.parametrize(
    ("source", "settings", "error", "message"),
    [
        (np.zeros((1, 5)), {}, ValueError, r"at least 2 x 2 generations, got \(1, 5\)"),
        (np.zeros(4), {}, ValueError, r"got shape \(4,\)"),
        ([], {}, ValueError, r"got shape \(0,\)"),
        (np.full((3, 3), np.nan), {}, ValueError, "got nan at index"),
        (np.full((2, 3, 3), 1.25), {}, ValueError, r"got 1.25 at index \(0, 0, 0\)"),
        ([["a", "b"], ["c", "d"]], {}, TypeError, "real numbers, got dtype <U1"),
        (np.zeros((3, 3)), {"level": 0.0}, ValueError, r"level in \(0, 1\), got 0.0"),
        (np.full((3, 3), None), {}, TypeError, "real numbers, got dtype object"),
    ],
)
def test_bad_input_is_refused(
    source: object, settings: dict[str, float], error: type[Exception], message: str
) -> None:
    with pytest.raises(error, match=message):
        analysis.analyze(source, **settings)  # type: ignore[arg-type]


def test_scores_have_to_fit_the_matrix() -> None:
    with pytest.raises(ValueError, match=r"scores of \(13, 13\) cells, got \(12, 13, 20\)"):
        analysis.analyze_run(RUNS[0], SCORES[1:])
