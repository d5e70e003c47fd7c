"""Archives of candidates and tests: MaxSolve, IPCA, LAPCA, Generalist; the paper's schedules."""

import itertools

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from matrixworld.coevolution.opponents.archives import layers_of, maximally_different

from matrixworld.coevolution import SCHEDULES, TEAMS, available
from matrixworld.coevolution.opponents import (
    IPCA,
    LAPCA,
    ArchiveSampler,
    Generalist,
    Latest,
    MaxSolve,
)


def looked_up(payoffs):
    """Return a payoff function for members that are numbers of rows and of columns."""
    matrix = np.asarray(payoffs, dtype=float)
    return lambda candidates, tests: matrix[np.ix_(candidates, tests)]


def submitted(archive, payoffs, *, candidates=None, tests=None):
    """Submit all members, or the given ones, and return the archive."""
    n, m = np.shape(payoffs)
    archive.submit(
        np.arange(n) if candidates is None else np.array(candidates, dtype=int),
        np.arange(m) if tests is None else np.array(tests, dtype=int),
        looked_up(payoffs),
    )
    return archive


def kept(archive):
    return archive.candidates.tolist(), archive.tests.tolist()


@st.composite
# Few levels, so that equal and dominated rows are common.
def histories(draw, levels=(0, 1), most=9):
    """Payoffs of candidates on tests, and both in batches, in the order of submission."""
    n, m = draw(st.integers(1, most)), draw(st.integers(1, most))
    cells = st.lists(st.sampled_from(levels), min_size=n * m, max_size=n * m)
    payoffs = np.array(draw(cells), dtype=float).reshape(n, m)
    batches = draw(st.integers(1, 4))
    of_candidate = draw(st.lists(st.integers(0, batches - 1), min_size=n, max_size=n))
    of_test = draw(st.lists(st.integers(0, batches - 1), min_size=m, max_size=m))
    return payoffs, [
        (np.flatnonzero(np.equal(of_candidate, b)), np.flatnonzero(np.equal(of_test, b)))
        for b in range(batches)
    ]


# MaxSolve


SOLVED = [
    [1, 1, 0, 0, 0],  # 0 solves two
    [1, 0, 0, 0, 0],  # 1 solves one
    [0, 0, 0, 0, 0],  # 2 solves none
    [1, 1, 0, 0, 0],  # 3 solves the same as 0
    [0, 0, 1, 1, 0],  # 4 solves two others
]


def test_maxsolve_by_hand():
    # 2 solves nothing and 3 is another 0. Test 4 is never solved. 0 and 1 solve test 0, 0 alone
    # test 1, 4 alone both 2 and 3, of which 2 is the older.
    assert kept(submitted(MaxSolve(9), SOLVED)) == ([0, 1, 4], [0, 1, 2])
    # With two places, 1 goes; then tests 0 and 1 are both solved by 0 alone.
    assert kept(submitted(MaxSolve(2), SOLVED)) == ([0, 4], [0, 2])
    # With one, the older of the two that solve two.
    assert kept(submitted(MaxSolve(1), SOLVED)) == ([0], [0])
    # A draw is not solved.
    assert kept(submitted(MaxSolve(2), [[0.5, 0.6]])) == ([0], [1])


@given(histories(), st.integers(1, 10))
def test_maxsolve_keeps_all_distinct_solved_vectors_up_to_its_limit(history, limit):
    """On archived and new tests together, of archived and new candidates."""
    payoffs, batches = history
    archive = MaxSolve(limit)
    for candidates, tests in batches:
        rows = np.append(archive.candidates, candidates).astype(int)
        columns = np.append(archive.tests, tests).astype(int)
        submitted(archive, payoffs, candidates=candidates, tests=tests)
        vectors = {tuple(row) for row in payoffs[np.ix_(rows, columns)] if row.any()}
        expected = sorted(map(sum, vectors), reverse=True)[:limit]
        on_all = payoffs[np.ix_(archive.candidates.astype(int), columns)]
        assert sorted(on_all.sum(axis=1), reverse=True) == expected
        assert len(set(map(tuple, on_all))) == len(expected)
        # The tests likewise: all distinct columns of the candidates kept that one of them solves.
        solved = {tuple(column) for column in on_all.T if column.any()}
        assert sorted(map(tuple, archive.payoffs.T)) == sorted(solved)


# IPCA


def test_ipca_by_hand():
    payoffs = [
        [1, 0, 0, 0],  # 0
        [0, 1, 0, 0],  # 1: neither of 0 and 1 dominates the other, by tests 0 and 1
        [1, 0, 1, 0],  # 2 dominates 0, which test 2 shows
        [0, 1, 0, 0],  # 3 does the same as 1
        [0, 0, 0, 0],  # 4 is dominated by all
    ]
    archive = submitted(IPCA(), payoffs, candidates=[0, 1, 4], tests=[0, 1, 3])
    assert kept(archive) == ([0, 1], [0, 1])
    submitted(archive, payoffs, candidates=[2, 3], tests=[2, 3])
    assert kept(archive) == ([1, 2], [0, 1, 2])


@given(histories(levels=(0, 1, 2)))
def test_ipca_is_monotone_and_its_tests_tell_its_candidates_apart(history):
    payoffs, batches = history
    archive, seen, tests = IPCA(), [], []
    for new_candidates, new_tests in batches:
        submitted(archive, payoffs, candidates=new_candidates, tests=new_tests)
        # No test is ever dropped.
        assert archive.tests.tolist()[: len(tests)] == tests
        tests = archive.tests.tolist()
        # For every submitted candidate, an archived one does as well on all tests of that time.
        seen += [(candidate, list(tests)) for candidate in new_candidates]
        seen += [(candidate, list(tests)) for candidate in archive.candidates]
        for candidate, then in seen:
            assert any(
                (payoffs[now, then] >= payoffs[candidate, then]).all() for now in archive.candidates
            )
        for one, another in itertools.permutations(archive.payoffs, 2):
            assert (one < another).any()


# LAPCA


LAYERED = [
    [2, 2, 0],  # 0
    [0, 2, 2],  # 1: first layer, with 0
    [1, 2, 0],  # 2: second, dominated by 0
    [0, 1, 0],  # 3: third, dominated by 2
    [1, 2, 0],  # 4 does the same as 2
]


def test_lapca_by_hand():
    assert layers_of(np.array(LAYERED, dtype=float)).tolist() == [0, 0, 1, 2, -1]
    # One layer: 0 and 1, told apart by tests 0 and 2.
    assert kept(submitted(LAPCA(1), LAYERED)) == ([0, 1], [0, 2])
    # Two: 0 over 2 and 2 over 1 by test 0, 1 over 2 by test 2.
    assert kept(submitted(LAPCA(2), LAYERED)) == ([0, 1, 2], [0, 2])
    # Three: 3 is told from its neighbour 2 by test 0, too.
    assert kept(submitted(LAPCA(3), LAYERED)) == ([0, 1, 2, 3], [0, 2])


@given(histories(levels=(0, 1, 2)), st.integers(1, 4))
def test_lapca_s_layers_hold_on_its_own_tests(history, layers):
    payoffs, batches = history
    archive = LAPCA(layers)
    for candidates, tests in batches:
        before = archive.candidates, archive.tests
        submitted(archive, payoffs, candidates=candidates, tests=tests)
        all_tests = np.sort(np.concatenate([before[1].astype(int), tests]))
        assert set(archive.candidates) <= {*before[0], *candidates}
        on_all = payoffs[np.ix_(archive.candidates.astype(int), all_tests)]
        layer = layers_of(on_all)
        assert layer.min(initial=0) == 0
        assert layer.max(initial=0) < layers
        for i, one in enumerate(on_all):
            for j, another in enumerate(on_all):
                if abs(layer[i] - layer[j]) <= 1 and (one > another).any():
                    assert (archive.payoffs[i] > archive.payoffs[j]).any()


# Generalist


def test_maximally_different_by_hand():
    payoffs = [
        [0.9, 0.9, 0.9],  # 0: the strongest
        [0.9, 0.9, 0.8],  # 1: nearly 0
        [0.0, 0.0, 0.1],  # 2: farthest from 0
        [0.9, 0.0, 0.1],  # 3: .57 from 0, .3 from 2
        [0.1, 0.9, 0.9],  # 4: .27 from 0, .57 from 2
    ]
    # After 0 and 2 the nearest of those is .3 away from 3, .27 from 4 and .03 from 1.
    assert maximally_different(payoffs, 4).tolist() == [0, 2, 3, 4]
    assert maximally_different(payoffs, 9).tolist() == [0, 2, 3, 4, 1]


def test_generalist_takes_only_variants_better_against_all():
    payoffs = [
        [0.6, 0.6, 0.6],  # 0
        [0.3, 0.3, 0.6],  # 1: the worst, mean .4
        [0.9, 0.1, 0.1],  # 2: best against test 0, mean .37
        [0.5, 0.4, 0.4],  # 3: mean .43
        [0.3, 0.3, 0.6],  # 4: as good as the worst
    ]
    archive = submitted(Generalist([0, 1], sample_size=1), payoffs, candidates=[2, 4])
    assert archive.candidates.tolist() == [0, 1]
    submitted(archive, payoffs, candidates=[3, 3])
    assert archive.candidates.tolist() == [0, 3]
    # The opponents' payoffs against 0 and 3 are .4 and .5; .4 and .6; .4 and .6: the first best.
    assert archive.tests.tolist() == [1]


@given(histories(levels=(0.0, 0.3, 1.0)))
def test_generalist_never_gets_worse_against_all(history):
    payoffs, batches = history
    all_tests = np.arange(payoffs.shape[1])
    archive = Generalist([0] * 3, sample_size=2)
    for candidates, _ in batches:
        before = np.sort(payoffs[archive.candidates].mean(axis=1))
        submitted(archive, payoffs, candidates=candidates, tests=all_tests)
        assert (np.sort(payoffs[archive.candidates].mean(axis=1)) >= before).all()
        assert len(archive.candidates) == 3
        assert len(set(archive.tests)) == len(archive.tests) == min(2, len(all_tests))


# All of them


BATCHES = [(np.arange(b, 12, 4), np.arange(b, 12, 4)) for b in range(4)]


@pytest.mark.parametrize("make", [lambda: MaxSolve(5), IPCA, lambda: LAPCA(3)])
def test_a_known_payoff_is_not_computed_again(make):
    payoffs = np.random.default_rng(7).integers(0, 2, (12, 12)).astype(float)
    counts = np.zeros((12, 12), dtype=int)

    def payoff(candidates, tests):
        counts[np.ix_(candidates, tests)] += 1
        return payoffs[np.ix_(candidates, tests)]

    archive = make()
    for candidates, tests in BATCHES:
        archive.submit(candidates, tests, payoff)
        rows, columns = archive.candidates.astype(int), archive.tests.astype(int)
        assert np.array_equal(archive.payoffs, payoffs[np.ix_(rows, columns)])
    assert counts.max() == 1  # each is a match that has to be played


def test_newest_opponent_is_met_beside_the_archive():
    payoffs = [[1, 0, 0, 0], [0, 1, 0, 0], [1, 0, 1, 0], [0, 0, 0, 1]]
    sampler = ArchiveSampler(IPCA(), 9)
    rng = np.random.default_rng(0)
    # The archive is empty.
    assert sampler.sample(3, 0, rng).tolist() == Latest().sample(3, 0, rng).tolist()
    submitted(sampler.archive, payoffs, candidates=[0, 1], tests=[0, 1, 3])
    # Test 3, which no candidate solves, is not kept; it is met while it is the newest.
    assert sampler.archive.tests.tolist() == [0, 1]
    assert sorted(sampler.sample(4, 0, rng)) == [0, 1, 3]
    submitted(sampler.archive, payoffs, candidates=[2], tests=[2])
    assert sorted(sampler.sample(3, 0, rng)) == [0, 1, 2]
    assert sampler.sample(4, 0, rng)[0] == 3
    with pytest.raises(ValueError, match="archive: expected generations below 2"):
        sampler.sample(2, 0, rng)


# ---- The paper's three schedules by hand ----


# The paper's pseudo-code, generations 1 to 3 with four epochs each, by hand:
# schedule: {k: (opponents of the pursuers, generations of e; of the evaders, generations of p)}
BY_HAND = {
    "specialist-specialist": {
        1: ([0, 0, 0, 0], [1, 1, 1, 1]),
        2: ([1, 1, 1, 1], [2, 2, 2, 2]),
        3: ([2, 2, 2, 2], [3, 3, 3, 3]),
    },
    "generalist-specialist": {
        1: ([0, 0, 0, 0], [1, 1, 1, 1]),
        2: ([0, 1, 0, 1], [2, 2, 2, 2]),
        3: ([0, 1, 2, 0], [3, 3, 3, 3]),
    },
    "generalist-generalist": {
        1: ([0, 0, 0, 0], [0, 1, 0, 1]),
        2: ([0, 1, 0, 1], [0, 1, 2, 0]),
        3: ([0, 1, 2, 0], [0, 1, 2, 3]),
    },
}


def opponents(name, team, k, epochs):
    """Return the opponents of a team in the first epochs of its generation k."""
    sampler, rng = SCHEDULES[name].new_sampler(team), np.random.default_rng(0)
    sampled = [sampler.sample(available(team, k), i, rng).tolist() for i in range(epochs)]
    assert all(len(each) == 1 for each in sampled)
    return [each[0] for each in sampled]


@pytest.mark.parametrize("name", BY_HAND)
@pytest.mark.parametrize("k", [1, 2, 3])
def test_schedule(name, k):
    met = tuple(opponents(name, team, k, 4) for team in TEAMS)
    assert met == BY_HAND[name][k]
