"""Opponent samplers: by hand, and properties that hold for any input."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from matrixworld.coevolution.opponents.samplers import shared_sample

from matrixworld.coevolution import opponents

SAMPLERS = {
    "latest": lambda: opponents.Latest(2),
    "uniform": lambda: opponents.Uniform(2),
    "all": lambda: opponents.Uniform(None),
    "round robin": opponents.RoundRobin,
    "hall of fame": lambda: opponents.HallOfFame(newest=1, sampled=2),
    "hard": lambda: opponents.Prioritized(opponents.hard(2.0), count=2),
    "even": lambda: opponents.Prioritized(opponents.even, count=2),
    "shared": lambda: opponents.SharedSampling(2),
}


def rng(seed=0):
    return np.random.default_rng(seed)


def chosen(sampler, available, epoch=0, seed=0):
    return sampler.sample(available, epoch, rng(seed)).tolist()


def test_latest():
    assert chosen(opponents.Latest(), 5) == [4]
    assert chosen(opponents.Latest(3), 5) == [4, 3, 2]
    assert chosen(opponents.Latest(3), 2) == [1, 0]


def test_round_robin_takes_turns():
    for available in range(1, 6):
        for epoch in range(12):
            assert chosen(opponents.RoundRobin(), available, epoch) == [epoch % available]
    two = [chosen(opponents.RoundRobin(2), 3, epoch) for epoch in range(3)]
    assert two == [[0, 1], [2, 0], [1, 2]]
    assert chosen(opponents.RoundRobin(5), 3, 1) == [2, 0, 1]


def test_uniform_draws_all_opponents_equally_often():
    draw, counts = rng(), np.zeros(5)
    for epoch in range(1000):
        sample = opponents.Uniform(2).sample(5, epoch, draw)
        assert len(set(sample.tolist())) == 2
        counts[sample] += 1
    # 1000 epochs, two of five: a deviation of 15.
    assert counts.tolist() == pytest.approx([400] * 5, rel=0.15)
    assert chosen(opponents.Uniform(None), 4) == [0, 1, 2, 3]
    assert sorted(chosen(opponents.Uniform(9), 3)) == [0, 1, 2]


def test_hall_of_fame_is_the_newest_and_a_sample_of_the_older_ones():
    sampler = opponents.HallOfFame(newest=2, sampled=3)
    for seed in range(20):
        sample = chosen(sampler, 10, seed=seed)
        assert sample[:2] == [9, 8]
        assert len(set(sample)) == 5
        assert max(sample[2:]) < 8  # the hall holds the older ones only
    assert chosen(sampler, 1) == [0]
    assert sorted(chosen(sampler, 4)) == [0, 1, 2, 3]
    assert len(chosen(opponents.HallOfFame(newest=0, sampled=2), 6)) == 2


def test_prioritized_by_hand():
    # Two games each: opponent 0 was beaten by all (x = 1), 1 by half (1/2), 2 by none (0); 3 is
    # new (1/2). (1 - x)^2 = 0, 1/4, 1, 1/4, in all 3/2; x (1 - x) = 0, 1/4, 0, 1/4.
    for weighting, expected in (
        (opponents.hard(2.0), [0, 1 / 6, 4 / 6, 1 / 6]),
        (opponents.hard(1.0), [0, 1 / 4, 2 / 4, 1 / 4]),
        (opponents.even, [0, 1 / 2, 0, 1 / 2]),
    ):
        sampler = opponents.Prioritized(weighting)
        sampler.tell([0, 1], [[1, 1], [1, 0]])
        sampler.tell([2, 1, 0], [[0, 0, 1], [0, 1, 1]])
        sampler.tell([2], [[0], [0]])
        assert sampler.probabilities(4) == pytest.approx(expected)
        draws = rng()
        counts = np.bincount([sampler.sample(4, 0, draws)[0] for _ in range(800)], minlength=4)
        assert counts / 800 == pytest.approx(expected, abs=0.06)
    # Wins 1, then 0, at decay 1/2: wins = 1/2, games = 1/2 + 1, so x = 1/3.
    sampler = opponents.Prioritized(decay=0.5)
    for score in (1.0, 0.0):
        sampler.tell([0], [[score]])
    assert sampler.win_rates(2) == pytest.approx([1 / 3, 1 / 2])


def test_opponents_of_weight_0_are_sampled_only_if_the_others_do_not_suffice():
    sampler = opponents.Prioritized(opponents.hard(), count=3)
    sampler.tell([0, 1, 2], [[1, 1, 0]])
    for seed in range(20):
        sample = chosen(sampler, 4, seed=seed)
        assert {2, 3} < set(sample)
        assert sample[2] in (0, 1)
    beaten = opponents.Prioritized(opponents.hard())
    beaten.tell([0, 1], [[1, 1]])
    assert beaten.probabilities(2).tolist() == [0.5, 0.5]


def test_shared_sample_by_hand():
    # Opponent 0 beats individuals 0, 1, 2; 1 beats 0, 1; 2 beats 3; 3 beats none.
    beats = [[1, 1, 1, 0], [1, 1, 0, 0], [0, 0, 0, 1], [0, 0, 0, 0]]
    # First 0, worth 3. Then 0, 1, 2 are covered once: 1 is worth 1/2 + 1/2, and so is 2, worth 1.
    # Ties are drawn: 30 seeds show both.
    orders = {tuple(shared_sample(beats, 4, rng(seed))) for seed in range(30)}
    assert orders == {(0, 1, 2, 3), (0, 2, 1, 3)}
    # Had 1 beaten one individual only, it would be worth 1/2, and 2 would come before it.
    beats[1] = [1, 0, 0, 0]
    orders = {tuple(shared_sample(beats, 3, rng(seed))) for seed in range(30)}
    assert orders == {(0, 2, 1)}


def test_shared_sampling_keeps_the_last_scores_and_tries_new_opponents():
    sampler = opponents.SharedSampling(1)
    # The scores are those of the candidates: opponent 0 beats none of two, 1 beats both.
    sampler.tell([1, 0], [[0, 1], [0, 1]])
    assert sampler.beats(3).tolist() == [[0, 0], [1, 1], [1, 1]]
    assert {chosen(sampler, 3, seed=seed)[0] for seed in range(20)} == {1, 2}
    sampler.tell([2], [[0.5], [1.0]])
    assert sampler.beats(3).tolist() == [[0, 0], [1, 1], [0.5, 0]]
    assert {chosen(sampler, 3, seed=seed)[0] for seed in range(20)} == {1}
    sampler.tell([0], [[1.0]])
    assert sampler.beats(2).tolist() == [[0], [1]]


@pytest.mark.parametrize("make", SAMPLERS.values(), ids=SAMPLERS)
@given(available=st.integers(1, 12), epoch=st.integers(0, 40), seed=st.integers(0, 9))
def test_a_sample_holds_available_opponents_once_each(make, available, epoch, seed):
    sampler, draw = make(), rng(seed)
    for known in (*range(1, 9), available):  # as the archive grows, and at any size
        sample = sampler.sample(known, epoch, draw)
        sampler.tell(sample, draw.random((3, len(sample))))
        assert sample.dtype.kind == "i"
        assert 1 <= len(sample) <= known
        assert len(set(sample.tolist())) == len(sample)
        assert 0 <= sample.min() <= sample.max() < known


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: opponents.Latest(0), "count: expected at least 1, got 0"),
        (lambda: opponents.HallOfFame(0, 0), r"newest \+ sampled: "),
        (lambda: opponents.Prioritized(decay=0.0), "decay: "),
        (lambda: opponents.hard(-1.0), "power: "),
        (lambda: opponents.SharedSampling().tell([0], [[2.0]]), "scores: expected numbers in"),
        (lambda: opponents.Prioritized().tell([0, 1], [[0.5]]), r"scores: expected shape \(n, 2\)"),
        (lambda: opponents.Latest().sample(0, 0, rng()), "available: expected at least 1, got 0"),
    ],
)  # fmt: skip
def test_bad_values_are_refused(call, message):
    with pytest.raises(ValueError, match=f"^{message}"):
        call()
