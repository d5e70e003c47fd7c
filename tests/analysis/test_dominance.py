"""The dominance tournament on hand-worked cases, and its test against SciPy's."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays
from scipy import stats

from matrixworld import analysis

scores_of_races = arrays.arrays(
    np.float64,
    st.tuples(st.integers(1, 6), st.integers(1, 6), st.integers(2, 5)),
    elements=st.integers(0, 4).map(lambda n: n / 4),
)


def certain(matrix: list[list[float]]) -> np.ndarray:
    """Return two equal episodes, without noise."""
    return np.repeat(np.array(matrix)[:, :, None], 2, axis=2)


def test_a_dominant_generation_beats_all_earlier_dominant_ones() -> None:
    # Means of the pursuers: .5, .4, .6, .55, .6, .9; those of the evaders: escape .5, .5.
    means = np.array([0.5, 0.4, 0.6, 0.55, 0.6, 0.9])
    ladders = analysis.dominance_tournament(certain(np.stack([means, means], axis=1).tolist()))
    assert ladders.pursuers.generations == (0, 2, 5)
    assert ladders.pursuers.p_values == (0.0, 0.0)
    assert ladders.evaders.generations == (0,)
    assert len(ladders.pursuers) == 3


def test_evaders_are_ranked_by_escapes() -> None:
    ladders = analysis.dominance_tournament(certain([[0.9, 0.5, 0.7, 0.1], [0.9, 0.5, 0.7, 0.1]]))
    assert ladders.evaders.generations == (0, 1, 3)


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
        len(analysis.dominance_tournament(rng.random((2, 5, 8))).pursuers) - 1 for _ in range(2000)
    ]
    assert 0.035 < np.mean(false) < 0.065


def test_dominance_of_counts() -> None:
    # By hand: q = 2/12 and 10/12, variance 20/144/10 each, z = .8 / sqrt(2 * .01389) = 4.8.
    ladders = analysis.dominance_of_counts([[1], [9], [9]], 10)
    assert ladders.pursuers.generations == (0, 1)
    expected = float(stats.norm.sf(0.8 / np.sqrt(2 * (2 / 12) * (10 / 12) / 10)))
    assert ladders.pursuers.p_values == pytest.approx((expected,))
    # Two of two against none of two: p = .042 by the shrunken variance; one of one is no evidence.
    assert len(analysis.dominance_of_counts([[0], [2]], 2).pursuers) == 2
    assert len(analysis.dominance_of_counts([[0], [1]], [[1], [1]], level=0.02).pursuers) == 1


@given(scores_of_races)
def test_swapping_the_teams_swaps_the_ladders(scores: np.ndarray) -> None:
    ladders = analysis.dominance_tournament(scores)
    swapped = analysis.dominance_tournament(1 - scores.transpose(1, 0, 2))
    assert swapped.pursuers.generations == ladders.evaders.generations
    assert swapped.evaders.generations == ladders.pursuers.generations
    np.testing.assert_allclose(swapped.evaders.p_values, ladders.pursuers.p_values, atol=1e-9)
