"""All measures of one run or several."""

import numpy as np
import pytest
from hypothesis import given, settings
from scipy import stats

from matrices import circular, logistic, payoffs
from matrixworld import analysis
from matrixworld.analysis.cycles import MARGIN
from matrixworld.analysis.games import game_value

small_payoffs = payoffs(least=2, most=5)
noisy = np.random.default_rng(0)
RUNS = np.stack([noisy.binomial(40, logistic(13)) / 40 for _ in range(6)])
SCORES = (noisy.random((13, 13, 20)) < logistic(13)[:, :, None]).astype(np.float32)


def test_measures_are_those_of_the_single_functions() -> None:
    matrix = circular(13)
    found = {name: one.value for name, one in analysis.measure_all(matrix).items()}
    late = analysis.last_half(matrix)
    assert found["game_value"] == game_value(matrix)
    assert found["transitive_share"] == analysis.transitive_share(late)
    assert found["checkerboards"] == analysis.checkerboards(late, margin=MARGIN, level=None).share
    assert found["pursuer_stripes"] == analysis.ciao(matrix).pursuers.stripes
    forgetting = analysis.MEASURES["evader_forgetting"]
    drops = analysis.forgetting(matrix).evaders
    assert forgetting.of(matrix, "whole").value == drops[6:].mean()
    assert forgetting.of(matrix).value == found["evader_forgetting"] == drops[9:].mean()


def test_the_judgement_and_the_tables_have_the_same_numbers() -> None:
    for scores in (SCORES, np.stack([SCORES, SCORES[::-1]]), SCORES[:8, :8]):
        payoffs = analysis.read_payoffs(scores, per_episode=True)
        found, judgement = analysis.measure_all(payoffs), analysis.judge(payoffs)
        for finding in judgement.findings.values():
            assert all(found[name] == one for name, one in finding.estimates.items())


def test_a_single_run_has_no_intervals_and_says_so() -> None:
    found = analysis.measure_all(circular(13))
    scatter = {"pursuer_gain", "evader_gain", "pursuer_change", "evader_change"}
    assert all(one.low is None and one.note for name, one in found.items() if name not in scatter)
    assert analysis.measure_table(circular(13)).startswith("A single run (95% interval over its")


def test_several_runs_have_intervals_over_runs() -> None:
    share = analysis.measure_all(RUNS)["transitive_share"]
    each = [analysis.transitive_share(analysis.last_half(run)) for run in RUNS]
    assert share.value == pytest.approx(np.mean(each))
    half = stats.t.ppf(0.975, 5) * np.std(each, ddof=1) / np.sqrt(6)
    assert share.ends == pytest.approx((share.value - half, share.value + half))
    assert (share.across, share.samples) == ("runs", 6)
    assert f"{share}" in analysis.measure_table(RUNS)


@settings(max_examples=8)
@given(small_payoffs)
def test_any_matrix_is_analysed_and_swapping_teams_swaps_the_numbers(matrix: np.ndarray) -> None:
    numbers, swapped = analysis.measure_all(matrix), analysis.measure_all(1 - matrix.T)
    for name, one in numbers.items():
        value = one.value
        team, _, measure = name.partition("_")
        other = {"pursuer": f"evader_{measure}", "evader": f"pursuer_{measure}"}.get(team, name)
        expected = 1 - value if name in ("capture_rate", "game_value") else value
        np.testing.assert_allclose(swapped[other].value, expected, atol=1e-6, err_msg=name)
