"""CIAO triangles and kinds of progress against plain loops; the dominance tournament."""

import numpy as np
import pytest
from hypothesis import given
from scipy import stats

from matrices import circular, payoffs
from matrixworld import analysis

MATRIX = np.array([[0.1, 0.2, 0.3], [0.4, 0.5, 0.6], [0.7, 0.8, 1.0]])
nan = np.nan


# ---- CIAO ---------------------------------------------------------------------------------------


def test_ciao_holds_the_two_triangles_with_the_diagonal() -> None:
    pursuers, evaders = analysis.ciao(MATRIX)
    np.testing.assert_array_equal(
        pursuers.payoff, [[0.1, nan, nan], [0.4, 0.5, nan], [0.7, 0.8, 1.0]]
    )
    np.testing.assert_allclose(
        evaders.payoff, [[0.9, nan, nan], [0.8, 0.5, nan], [0.7, 0.4, 0.0]], atol=1e-15
    )
    np.testing.assert_allclose(pursuers.by_age, [1.6 / 3, 0.6, 0.7])
    # Fading compares newer with older ancestors.
    assert pursuers.fading == pytest.approx(((0.5 - 0.4) + (1.0 - 0.7)) / 2)
    assert evaders.fading == pytest.approx(((0.5 - 0.8) + (0.0 - 0.7)) / 2)


@pytest.mark.parametrize("period", [3, 5])
def test_cycles_are_stripes_of_their_period(period: int) -> None:
    for triangle in analysis.ciao(circular(31, period)):
        assert triangle.period == period
        assert triangle.stripes == pytest.approx(1.0)
        assert abs(triangle.fading) < 0.12


# ---- kinds of progress --------------------------------------------------------------------------


def written_out(matrix: np.ndarray, met: str) -> tuple[list[float], list[float]]:
    """Return scores and gains of the pursuers against each kind of opponents."""
    rows, columns = matrix.shape
    generations = range(min(rows, columns) if met == "local" else rows)
    scores, gains = [], []
    for g in generations:
        opponents = [g] if met == "local" else [h for h in range(columns) if h <= g]
        scores.append(np.mean([matrix[g, h] for h in opponents]))
        if g:
            gains.append(np.mean([matrix[g, h] - matrix[g - 1, h] for h in opponents]))
    return scores, gains


@given(payoffs(most=7))
def test_local_and_historical_progress_agree_with_their_definition(matrix: np.ndarray) -> None:
    for met, found in (
        ("local", analysis.local_progress(matrix)),
        ("historical", analysis.historical_progress(matrix)),
    ):
        for team, own in zip(found, (matrix, 1 - matrix.T), strict=True):
            scores, gains = written_out(own, met)
            np.testing.assert_allclose(team.scores, scores)
            np.testing.assert_allclose(team.gains, gains, atol=1e-15)


def test_global_progress_is_against_other_runs_only() -> None:
    rng = np.random.default_rng(1)
    cross = rng.random((3, 3, 4, 5))
    cross[range(3), range(3)] = np.nan
    found = analysis.global_progress(cross)
    for r in range(3):
        others = [s for s in range(3) if s != r]
        for g in range(4):
            expected = np.mean([cross[r, s, g] for s in others])
            assert found.pursuers.scores[r, g] == pytest.approx(expected)
        for h in range(5):
            expected = 1 - np.mean([cross[s, r, :, h] for s in others])
            assert found.evaders.scores[r, h] == pytest.approx(expected)
    np.testing.assert_allclose(found.evaders.gains, np.diff(found.evaders.scores))


# ---- Dominance tournament ------------------------------------------------------------------------


def certain(matrix: list[list[float]]) -> np.ndarray:
    """Return two equal episodes, without noise."""
    return np.repeat(np.array(matrix)[:, :, None], 2, axis=2)


def test_a_dominant_generation_beats_all_earlier_dominant_ones() -> None:
    # Means of the pursuers: .5, .4, .6, .55, .6, .9; those of the evaders: escape .5, .5.
    means = np.array([0.5, 0.4, 0.6, 0.55, 0.6, 0.9])
    ladders = analysis.dominance_tournament(certain(np.stack([means, means], axis=1).tolist()))
    assert ladders.pursuers.generations == (0, 2, 5)
    assert ladders.evaders.generations == (0,)


def test_with_one_opponent_it_is_welchs_t_test() -> None:
    rng = np.random.default_rng(0)
    scores = rng.random((2, 1, 12)) * np.array([0.6, 1.0])[:, None, None]
    expected = stats.ttest_ind(scores[1, 0], scores[0, 0], equal_var=False, alternative="greater")
    p = float(expected.pvalue)
    assert 0.001 < p < 0.2
    joins = analysis.dominance_tournament(scores, level=p + 1e-6).pursuers
    assert joins.generations == (0, 1)
    assert joins.p_values == pytest.approx((p,))
    assert analysis.dominance_tournament(scores, level=p - 1e-6).pursuers.generations == (0,)


def test_noise_alone_rarely_gives_a_dominant_generation() -> None:
    rng = np.random.default_rng(1)
    false = [
        len(analysis.dominance_tournament(rng.random((2, 5, 8))).pursuers) - 1 for _ in range(600)
    ]
    assert 0.02 < np.mean(false) < 0.08


@pytest.mark.parametrize("seed", range(9))
def test_swapping_the_teams_swaps_the_ladders(seed: int) -> None:
    scores = np.random.default_rng(seed).integers(0, 5, (6, 5, 3)) / 4
    pursuers, evaders = analysis.dominance_tournament(scores)
    swapped = analysis.dominance_tournament(1 - scores.transpose(1, 0, 2))
    assert swapped.pursuers.generations == evaders.generations
    np.testing.assert_allclose(swapped.evaders.p_values, pursuers.p_values, atol=1e-9)
