"""Opponent samplers: by hand, and properties that hold for any input."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from matrixworld.analysis.games import nash_averaging
from matrixworld.coevolution import opponents
from matrixworld.coevolution.opponents import shared_sample

SAMPLERS = {
    "latest": opponents.Latest(),
    "uniform": opponents.Uniform(),
    "round-robin": opponents.RoundRobin(),
    "newest-and-older": opponents.NewestAndOlder(),
    "hard": opponents.Prioritized("hard"),
    "even": opponents.Prioritized("even", decay=0.5),
    "shared": opponents.SharedSampling(),
}


def rng(seed=0):
    return np.random.default_rng(seed)


def chosen(sampler, available, count=1, epoch=0, seed=0, state=None):
    state = sampler.start() if state is None else state
    return sampler.sample(state, available, count, epoch, rng(seed)).tolist()


def told(sampler, *results):
    """Return the state after results: opponents, and the scores of candidates against them."""
    state = sampler.start()
    for met, scores in results:
        state = sampler.tell(state, np.array(met), np.array(scores, float))
    return state


def test_latest():
    assert chosen(opponents.Latest(), 5) == [4]
    assert chosen(opponents.Latest(), 5, 3) == [4, 3, 2]
    assert chosen(opponents.Latest(), 2, 3) == [1, 0]


def turns(sampler, generations, epochs, count=1):
    """Return whom a team meets in each epoch of generations that have so many opponents."""
    state, found = sampler.start(), []
    for available in generations:
        state = sampler.update(state, available, available, None)
        found.append([])
        for epoch in range(epochs):
            met = sampler.sample(state, available, count, epoch, rng())
            state = sampler.tell(state, met, np.full((4, len(met)), 0.5))
            found[-1].append(met.tolist())
    return found


def test_round_robin_takes_turns():
    for available, met in enumerate(turns(opponents.RoundRobin(), range(1, 6), 12), start=1):
        assert met == [[epoch % available] for epoch in range(12)]
    assert turns(opponents.RoundRobin(), [3], 3, 2) == [[[0, 1], [2, 0], [1, 2]]]
    assert turns(opponents.RoundRobin(), [3], 2, 5) == [[[0, 1, 2], [0, 1, 2]]]


def test_round_robin_meets_all_opponents_in_short_generations():
    met = turns(opponents.RoundRobin(), range(1, 31), 4)
    assert met[:5] == [[[0]] * 4, [[0], [1]] * 2, [[0], [1], [2], [0]], [[0], [1], [2], [3]],
                       [[0], [1], [2], [3]]]  # fmt: skip
    assert met[5] == [[4], [5], [0], [1]]
    for generation in range(10, 31):
        late = [
            one for of_generation in met[generation - 10 : generation] for [one] in of_generation
        ]
        assert set(late) >= set(range(generation - 9)), "all older ones within ten generations"


def test_uniform_draws_all_opponents_equally_often():
    draw, counts = rng(), np.zeros(5)
    for epoch in range(1000):
        sample = opponents.Uniform().sample({}, 5, 2, epoch, draw)
        assert len(set(sample.tolist())) == 2
        counts[sample] += 1
    # 1000 epochs, two of five: a deviation of 15.
    assert counts.tolist() == pytest.approx([400] * 5, rel=0.15)
    assert sorted(chosen(opponents.Uniform(), 3, 9)) == [0, 1, 2]


def test_newest_and_a_sample_of_the_older_ones():
    sampler = opponents.NewestAndOlder()
    for seed in range(20):
        sample = chosen(sampler, 10, 5, seed=seed)
        assert sample[:2] == [9, 8]
        assert len(set(sample)) == 5
        assert max(sample[2:]) < 8
    assert chosen(sampler, 1, 5) == [0]
    assert sorted(chosen(sampler, 4, 9)) == [0, 1, 2, 3]
    assert {chosen(sampler, 3, seed=seed)[0] for seed in range(30)} == {0, 1, 2}


@pytest.mark.parametrize(
    ("weighting", "weight"), [("hard", lambda x: (1 - x) ** 2), ("even", lambda x: x - x**2)]
)
@pytest.mark.parametrize("decay", [1.0, 0.5])
def test_prioritized_weighs_opponents_by_games_of_which_earlier_ones_count_less(
    weighting, weight, decay
):
    sampler, draws = opponents.Prioritized(weighting, decay=decay), rng()
    # In three epochs two candidates meet some of four opponents; the last one is new.
    games = [(met, draws.integers(0, 2, (2, len(met)))) for met in ([0, 1], [2, 1, 0], [2])]
    state = told(sampler, *games)
    wins, played = np.zeros(4), np.zeros(4)
    for met, scores in games:
        wins[met] = decay * wins[met] + scores.mean(axis=0)
        played[met] = decay * played[met] + 1
    weights = weight(np.divide(wins, played, out=np.full(4, 0.5), where=played > 0))
    expected = weights / weights.sum()
    assert sampler.probabilities(state, 4) == pytest.approx(expected)
    first = [sampler.sample(state, 4, 1, 0, draws)[0] for _ in range(800)]
    assert np.bincount(first, minlength=4) / 800 == pytest.approx(expected, abs=0.06)


def test_opponents_of_weight_0_are_sampled_only_if_the_others_do_not_suffice():
    sampler = opponents.Prioritized()
    state = told(sampler, ([0, 1, 2], [[1, 1, 0]]))
    for seed in range(20):
        sample = chosen(sampler, 4, 3, seed=seed, state=state)
        assert {2, 3} < set(sample)
        assert sample[2] in (0, 1)
    assert sampler.probabilities(told(sampler, ([0, 1], [[1, 1]])), 2).tolist() == [0.5, 0.5]


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
    sampler = opponents.SharedSampling()
    # The scores are those of the candidates: opponent 0 beats none of two, 1 beats both.
    state = told(sampler, ([1, 0], [[0, 1], [0, 1]]))
    assert state["beats"].tolist() == [[0, 0], [1, 1]]
    assert {chosen(sampler, 3, seed=seed, state=state)[0] for seed in range(20)} == {1, 2}
    state = sampler.tell(state, np.array([2]), np.array([[0.5], [1.0]]))
    assert state["beats"].tolist() == [[0, 0], [1, 1], [0.5, 0]]
    assert {chosen(sampler, 3, seed=seed, state=state)[0] for seed in range(20)} == {1}
    # Of another number of candidates.
    assert sampler.tell(state, np.array([0]), np.array([[1.0]]))["beats"].tolist() == [[0]]


def test_nash_adds_each_generation_once_and_draws_from_the_mixture():
    matrix, asked = rng().random((5, 6)), np.zeros((5, 6), int)

    def payoff(own, rivals):
        asked[np.ix_(own, rivals)] += 1
        return matrix[np.ix_(own, rivals)]

    sampler = opponents.NashOpponents()
    state = sampler.start()
    assert chosen(sampler, 3, state=state) == [2]  # the newest, before the first game
    for own, available in ((1, 1), (2, 3), (5, 6)):
        state = sampler.update(state, own, available, payoff)
    assert (asked == 1).all()
    assert np.array_equal(state["payoffs"], matrix)
    expected = nash_averaging(matrix).evaders
    assert state["weights"] == pytest.approx(expected, abs=1e-6)
    draws = [chosen(sampler, 6, seed=seed, state=state)[0] for seed in range(600)]
    assert np.bincount(draws, minlength=6) / 600 == pytest.approx(expected, abs=0.08)
    assert {*chosen(sampler, 6, 9, state=state)} == {*np.flatnonzero(state["weights"])}


@pytest.mark.parametrize("sampler", SAMPLERS.values(), ids=SAMPLERS)
@given(
    available=st.integers(1, 12), count=st.integers(1, 4), epoch=st.integers(0, 40),
    seed=st.integers(0, 9),
)  # fmt: skip
def test_a_sample_holds_available_opponents_once_each(sampler, available, count, epoch, seed):
    state, draw = sampler.start(), rng(seed)
    for known in (*range(1, 9), available):  # as the archive grows, and at any size
        sample = sampler.sample(state, known, count, epoch, draw)
        state = sampler.tell(state, sample, draw.random((3, len(sample))))
        assert sample.dtype.kind == "i"
        assert 1 <= len(sample) <= min(count, known)
        assert len(set(sample.tolist())) == len(sample)
        assert 0 <= sample.min() <= sample.max() < known
