"""Competitive fitness sharing and reduced virulence."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from matrixworld.coevolution import competitive_sharing, reduced_virulence


def test_sharing_by_hand():
    # Opponent 0 is beaten by 0 and 1, opponent 1 by 1 alone, opponent 2 by nobody.
    assert competitive_sharing([[1, 0, 0], [1, 1, 0], [0, 0, 0]]).tolist() == [0.5, 1.5, 0.0]
    # Half a win beside a whole one gets a third of the opponent.
    assert competitive_sharing([[0.5], [1.0]]) == pytest.approx([1 / 3, 2 / 3])
    assert competitive_sharing(np.zeros((2, 3))).tolist() == [0.0, 0.0]


@given(st.lists(st.lists(st.floats(0, 1), min_size=3, max_size=3), min_size=1, max_size=6))
def test_each_opponent_that_somebody_beats_is_worth_one(wins):
    fitness = competitive_sharing(wins)
    assert (fitness >= 0).all()
    assert fitness.sum() == pytest.approx(np.count_nonzero(np.any(np.array(wins) > 0, axis=0)))


def test_virulence_by_hand():
    # v = 3/4, x = 0, 1/2, 3/4, 1: 2x/v - x^2/v^2 = 0, 4/3 - 4/9, 2 - 1, 8/3 - 16/9.
    assert reduced_virulence([0, 2, 3, 4], 0.75) == pytest.approx([0, 8 / 9, 1, 8 / 9])
    # v = 1: 2x - x^2, the more the better.
    assert reduced_virulence([0, 1, 2], 1.0) == pytest.approx([0, 3 / 4, 1])
    # v = 1/2: 4x - 4x^2, those who win everything get nothing.
    assert reduced_virulence([0, 1, 2], 0.5) == pytest.approx([0, 1, 0])
    assert reduced_virulence([0, 0], 0.75).tolist() == [0.0, 0.0]


@given(
    st.lists(st.integers(0, 30), min_size=1, max_size=20),
    st.floats(0.5, 1.0),
    st.floats(0.1, 10.0),
)
def test_virulence_rewards_the_share_v_of_the_best(wins, v, scale):
    fitness = reduced_virulence(wins, v)
    assert (fitness <= 1 + 1e-12).all()
    assert (fitness >= -1e-12).all()
    assert reduced_virulence(np.array(wins) * scale, v) == pytest.approx(fitness)
    share = np.array(wins) / max(1, *wins)
    order = np.argsort(np.abs(share - v))
    if max(wins):
        assert (np.diff(fitness[order]) <= 1e-12).all()


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: competitive_sharing([1, 0]), "wins: expected (n, m) numbers >= 0"),
        (lambda: competitive_sharing([[-1.0]]), "wins: expected (n, m) numbers >= 0"),
        (lambda: reduced_virulence([[1.0]], 1.0), "wins: expected (n,) numbers >= 0"),
        (lambda: reduced_virulence([float("nan")], 1.0), "wins: expected (n,) numbers >= 0"),
        (lambda: reduced_virulence([1.0], 0.4), "virulence: expected 0.5 to 1, got 0.4"),
        (lambda: reduced_virulence([1.0], 1.1), "virulence: expected 0.5 to 1, got 1.1"),
    ],
)
def test_bad_values_are_refused(call, message):
    with pytest.raises(ValueError) as caught:  # noqa: PT011
        call()
    assert message in str(caught.value)
