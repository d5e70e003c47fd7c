"""Archives: the candidates to keep, and the tests that tell them apart.

For a team, its own members are the candidates and its opponents the tests. Members are rows of
arrays of any dtype: genomes, or numbers that stand for them, such as generations
(`ArchiveSampler`). Archives compare members by their payoffs (n, m) alone: row a *dominates* row b
if its payoff is nowhere lower and somewhere higher.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike

from matrixworld._util.checks import check_floats, check_integer
from matrixworld.coevolution.opponents.samplers import Stateless, check_available
from matrixworld.coevolution.types import BoolArray, FloatArray, Indices, Members, Saved, State

PayoffFunction = Callable[[Members, Members], ArrayLike]
"""(candidates (n, ...), tests (m, ...)) -> payoffs (n, m) of the candidates, in [0, 1].

A pure function: one pair always has the same payoff.
"""

WEIGHT_DECIMALS = 6
"""Decimals of the weights of a meta-strategy."""
SOLVED_ABOVE = 0.5
"""Payoff above which a candidate solves a test; at it neither team wins."""


def read_only(rows: ArrayLike) -> Members:
    """Return a read-only copy of an array of members (n, ...)."""
    members = np.array(rows)
    # Payoff functions of users get these arrays and could otherwise change the archive.
    members.flags.writeable = False
    return members


def checked_payoffs(payoff: PayoffFunction, candidates: Members, tests: Members) -> FloatArray:
    """Return the payoffs (n, m) of candidates on tests; does not call `payoff` for no pairs."""
    shape = (len(candidates), len(tests))
    if 0 in shape:
        return np.zeros(shape)
    values = check_floats("payoff", payoff(candidates, tests))
    if values.shape != shape:
        raise ValueError(f"payoff: expected an array of shape {shape}, got {values.shape}")
    if not np.isfinite(values).all():
        raise ValueError(f"payoff: expected finite numbers, got {values}")
    return values


class Archive(Saved):
    """Candidates, tests, and the payoffs of all pairs; base of the archives. It keeps all.

    ::

        submit:  candidates = archived and new ones;  tests = archived and new ones
                 payoffs of all these candidates on all these tests
                 keep some of both, by the rule of the subclass

    Known payoffs are not computed again, unless each submission has to contain all tests.

    Attributes
    ----------
    candidates, tests : ndarray, shape (n, ...) and (m, ...)
        Members of both kinds, oldest first; read-only copies.
    payoffs : ndarray of float64, shape (n, m)
        Payoffs of the candidates on the tests; read-only.
    """

    saved: ClassVar[tuple[str, ...]] = ("candidates", "tests", "payoffs")
    graded = False
    """Whether the archive should get graded payoffs, instead of win, draw or loss (1, 1/2, 0). By
    noisy graded payoffs hardly any candidate dominates another one."""
    needs_all_tests = False
    """Whether each submission must contain all tests, not only the new ones."""

    def __init__(self) -> None:
        self.candidates: Members = read_only([])
        self.tests: Members = read_only([])
        self.payoffs: FloatArray = read_only(np.zeros((0, 0)))

    def keep(self, payoffs: FloatArray, archived: tuple[int, int]) -> tuple[Indices, Indices]:
        """Return the candidates and the tests to keep.

        `payoffs` (n, m) are those of archived and new candidates on archived and new tests, of
        which `archived` says how many of the first rows and of the first columns are archived.
        """
        return np.arange(payoffs.shape[0]), np.arange(payoffs.shape[1])

    def submit(self, candidates: ArrayLike, tests: ArrayLike, payoff: PayoffFunction) -> None:
        """Submit new candidates (n, ...) and tests (m, ...), of which either may be empty.

        The archive keeps some of these and of its own. For `payoff` see `PayoffFunction`.
        """
        new_candidates, new_tests = read_only(candidates), read_only(tests)
        known, old_tests = self.payoffs, self.tests
        if self.needs_all_tests:
            # Tests learn, too: payoffs of the last submission are of no use.
            known, old_tests = known[:, :0], old_tests[:0]
        all_candidates = _joined(self.candidates, new_candidates)
        all_tests = _joined(old_tests, new_tests)
        # The payoffs of archived candidates on archived tests are known; two blocks are missing.
        on_new_tests = checked_payoffs(payoff, self.candidates, new_tests)
        of_new_candidates = checked_payoffs(payoff, new_candidates, all_tests)
        of_archived = np.concatenate([known, on_new_tests], axis=1)
        union = np.concatenate([of_archived, of_new_candidates])
        rows, columns = self.keep(union, (len(known), len(old_tests)))
        self.candidates = read_only(all_candidates[rows])
        self.tests = read_only(all_tests[columns])
        self.payoffs = read_only(union[np.ix_(rows, columns)])

    def restore(self, state: State) -> None:
        """Restore a state returned by `state()`."""
        for name in self.saved:
            setattr(self, name, read_only(state[name]))


def _joined(archived: Members, new: Members) -> Members:
    # The dtype and the shape of a row are those of the first members; no archive fixes them before.
    if not len(archived) or not len(new):
        return archived if len(archived) else new
    return read_only(np.concatenate([archived, new]))


class MaxSolve(Archive):
    """Up to `limit` candidates that solve the most tests, and the tests that they solve.

    ::

        C = archived and new candidates;  T = archived and new tests
        drop candidates that solve no test of T
        of candidates that solve the same tests of T keep the oldest
        keep the `limit` candidates that solve the most tests of T; of equals the oldest
        drop tests that no kept candidate solves
        of tests that are solved by the same candidates keep the oldest

    de Jong 2005, "The MaxSolve algorithm for coevolution", GECCO.
    """

    def __init__(self, limit: int) -> None:
        self.limit = check_integer("limit", limit, 1)
        super().__init__()

    def keep(self, payoffs: FloatArray, archived: tuple[int, int]) -> tuple[Indices, Indices]:
        """Return the candidates and tests to keep."""
        solved = payoffs > SOLVED_ABOVE
        distinct = _first_of_equals(solved)
        # Stable: of candidates that solve equally many tests the oldest comes first.
        most_first = distinct[np.argsort(-solved[distinct].sum(axis=1), kind="stable")]
        rows = np.sort(most_first[: self.limit])
        # Kept candidates differ on a test that one of them solves, so they differ on kept tests.
        return rows, _first_of_equals(solved[rows].T)


class IPCA(Archive):
    """The incremental Pareto-coevolution archive.

    It holds the candidates that no other one dominates, and all tests that were ever needed to show
    this.

    ::

        C = archived and new candidates;  T = archived and new tests
        F = candidates of C that none dominates on T; of those with equal payoffs the oldest
        for each c in F and each a, archived or in F, such that c beats a on some test of T:
            unless an archived test shows it, add a new test that does (as few as the greedy
            choice finds)
        candidates = F;  no test is ever dropped

    The archive is monotone: for every candidate that it has ever held, some candidate in it does at
    least as well on every test that was held at the time. It grows without bound; `LAPCA` does not.

    de Jong 2004, "The incremental Pareto-coevolution archive", GECCO; dominance as in Ficici &
    Pollack 2001, "Pareto optimality in coevolutionary learning".
    """

    def keep(self, payoffs: FloatArray, archived: tuple[int, int]) -> tuple[Indices, Indices]:
        """Return the candidates and tests to keep."""
        rows = _front(payoffs)
        # Archived candidates that leave the archive count, too: tests must show why they left.
        others = np.union1d(rows, np.arange(archived[0]))
        pairs = (len(rows) * len(others), payoffs.shape[1])
        shown = _distinctions(payoffs)[np.ix_(rows, others)].reshape(pairs)
        # Columns up to archived[1] are archived tests, the rest are new ones.
        known = shown[:, : archived[1]].any(axis=1)
        added = archived[1] + np.array(_fewest_tests(shown[~known, archived[1] :]), dtype=np.intp)
        return rows, np.concatenate([np.arange(archived[1]), np.sort(added)])


class LAPCA(Archive):
    """The layered Pareto-coevolution archive.

    It holds the first layers of candidates, and the tests that tell neighbours apart.

    ::

        C = archived and new candidates;  T = archived and new tests
        of candidates with equal payoffs on T keep the oldest
        F1 = candidates of C that none dominates on T;  F2 = those of C - F1;  ... up to `layers`
        candidates = F1 + ... + Fn
        tests = as few as the greedy choice finds, archived ones first, such that for any two
                candidates of one layer or of neighbouring layers: if a test of T shows that one
                beats the other, so does a kept test

    Tests are dropped. The archive is therefore bounded in practice, and not strictly monotone; the
    more layers, the closer it is to `IPCA`.

    de Jong 2004, "Towards a bounded Pareto-coevolution archive", CEC.
    """

    def __init__(self, layers: int) -> None:
        self.layers = check_integer("layers", layers, 1)
        super().__init__()

    def keep(self, payoffs: FloatArray, archived: tuple[int, int]) -> tuple[Indices, Indices]:
        """Return the candidates and tests to keep."""
        layer = layers_of(payoffs)
        rows = np.flatnonzero((layer >= 0) & (layer < self.layers))
        # Both orders of each pair, since either candidate may be the better one on some test.
        near = np.abs(layer[rows, np.newaxis] - layer[rows]) <= 1
        shown = _distinctions(payoffs[rows])[near]
        old = _fewest_tests(shown[:, : archived[1]])
        # New tests are needed only for pairs that no kept archived test tells apart.
        left = shown[~shown[:, old].any(axis=1), archived[1] :]
        new = [archived[1] + test for test in _fewest_tests(left)]
        return rows, np.sort(np.array(old + new, dtype=np.intp))


def layers_of(payoffs: FloatArray) -> Indices:
    """Return the Pareto layer of each candidate of payoffs (n, m), 0 the best.

    -1 stands for a candidate whose payoffs equal those of an earlier one.
    """
    layer = np.full(len(payoffs), -1, dtype=np.intp)
    # `unique` returns the first row of each kind, in the order of the values; sort by age again.
    left = np.sort(np.unique(payoffs, axis=0, return_index=True)[1])
    for number in range(len(payoffs)):
        best = left[_front(payoffs[left])]
        layer[best] = number
        left = np.setdiff1d(left, best)
    return layer


def _first_of_equals(solved: BoolArray) -> Indices:
    """Return the first of each kind of row that is not all False, in ascending order."""
    first = np.sort(np.unique(solved, axis=0, return_index=True)[1])
    return first[solved[first].any(axis=1)]


def _distinctions(payoffs: FloatArray) -> BoolArray:
    """Return (n, n, m): at [a, b, t] whether test t shows that a beats b."""
    return payoffs[:, np.newaxis] > payoffs[np.newaxis]


def _front(payoffs: FloatArray) -> Indices:
    """Return the rows that none dominates; of rows with equal payoffs the first."""
    better = _distinctions(payoffs).any(axis=2)
    # better[a, b]: a beats b on some test. Neither beats the other: all payoffs are equal.
    equal = ~better & ~better.T
    earlier = np.tri(len(payoffs), k=-1, dtype=np.bool_)
    superfluous = ~better & (better.T | (equal & earlier))
    return np.flatnonzero(~superfluous.any(axis=1))


def _fewest_tests(needed: BoolArray) -> list[int]:
    """Return few tests such that each pair that some test tells apart is told apart by one of them.

    `needed` is (pairs, m): which tests tell each pair apart. Greedy: while pairs are left, take the
    test that tells the most of them apart, the first of equals.
    """
    chosen: list[int] = []
    # Pairs that no test tells apart would never leave the loop.
    left = needed[needed.any(axis=1)]
    while len(left):
        chosen.append(int(np.argmax(left.sum(axis=0))))
        left = left[~left[:, chosen[-1]]]
    return chosen


def maximally_different(payoffs: ArrayLike, count: int) -> Indices:
    """Return opponents, in the order chosen, whose payoffs (m, n) differ as much as possible.

    ::

        first: the opponent with the highest mean payoff
        next:  the opponent farthest from the nearest chosen one, by the mean absolute difference
               of payoffs; of equals the first
    """
    values = np.asarray(payoffs, dtype=np.float64)
    chosen: list[int] = []
    distance = values.mean(axis=1)
    for _ in range(min(count, len(values))):
        chosen.append(int(np.argmax(distance)))
        nearest = np.abs(values[:, np.newaxis] - values[chosen]).mean(axis=2).min(axis=1)
        # Below every distance, so that no opponent is chosen twice.
        nearest[chosen] = -1.0
        distance = nearest
    return np.array(chosen, dtype=np.intp)


class Generalist(Archive):
    """A team of fixed size whose worst member is replaced only by a variant better against all.

    ::

        opponents to learn against: `sample_size` ones that are maximally different
        submit:  for each variant that the learning has produced, in turn:
                     worst = member with the lowest mean payoff against all opponents
                     if the variant's mean payoff against all opponents is higher:
                         it replaces the worst

    A variant that gains on the opponents of its training and loses on others is filtered out. The
    candidates are the team, at the start `members` (n, ...), in the order of their places, and the
    tests the opponents to learn against next. Each submission must contain the whole opposing team,
    and payoffs are graded, since their means are compared.

    Simione & Nolfi 2021, "Long-term progress and behavior complexification in competitive
    coevolution", Artificial Life 26(4).
    """

    graded = True
    needs_all_tests = True

    def __init__(self, members: ArrayLike, *, sample_size: int) -> None:
        self.sample_size = check_integer("sample_size", sample_size, 1)
        super().__init__()
        self.candidates = read_only(members)
        self.payoffs = read_only(np.zeros((check_integer("members", len(self.candidates), 1), 0)))

    def keep(self, payoffs: FloatArray, archived: tuple[int, int]) -> tuple[Indices, Indices]:
        """Return the members in their places, and the opponents to learn against next."""
        check_integer("tests", payoffs.shape[1], 1)
        strength, places = payoffs.mean(axis=1), np.arange(archived[0])
        for variant in range(archived[0], len(payoffs)):
            # The worst of the present team, in which earlier variants may have a place.
            worst = int(np.argmin(strength[places]))
            if strength[variant] > strength[places[worst]]:
                places[worst] = variant
        # The opponents' own payoffs: the same matrix, seen from the other side.
        return places, maximally_different(1.0 - payoffs[places].T, self.sample_size)


# Samplers of what an archive keeps:


class ArchiveSampler(Stateless):
    """The newest opponent, beside the tests of an archive.

    ::

        one opponent an epoch:  the newest and a test of the archive in turns
        several:                the newest, and tests of the archive, drawn evenly

    An opponent that no candidate beats yet tells none apart, so MaxSolve and the Pareto archives
    drop it: a team that played against the archive alone could never learn to beat it. In the
    schemes of de Jong (2007, "A monotonic archive for Pareto-coevolution", Evolutionary Computation
    15(1)) individuals meet both the living opponents and the archive; here the newest generation
    stands for the living ones. While the archive holds no other test, it alone is the sample.

    The archive holds numbers, shape (m,); the genomes of all generations stay with the caller, who
    updates the archive before the next sample::

        sampler.update([generation], [generation], payoff)    # `payoff` looks up the genomes

    Parameters
    ----------
    archive : Archive
        Keeps numbers of generations; saved and restored with the sampler.
    count : int, optional
        Opponents an epoch; fewer, if the archive holds fewer.
    """

    def __init__(self, archive: Archive, count: int = 1) -> None:
        self.archive: Archive = archive
        self.count: int = check_integer("count", count, 1)

    def update(self, new: Members, opponents: Members, payoff: PayoffFunction) -> None:
        """Submit new generations (n,) of the team and (m,) of its opponents to the archive.

        An archive that needs all tests gets all opponents up to the newest one. For `payoff` see
        `PayoffFunction`.
        """
        if self.archive.needs_all_tests and len(opponents):
            # Generations are numbered without gaps.
            opponents = np.arange(opponents.max() + 1)
        self.archive.submit(new, opponents, payoff)

    def max_pairs(self, candidates: int, tests: int) -> int:
        """Return the largest number of pairs that an update compares.

        There are so many generations of the team and of its opponents, of which one each is new.
        """
        if self.archive.needs_all_tests:
            # Generalist computes all payoffs again: of its team and of the new generation.
            return (len(self.archive.candidates) + 1) * tests
        # A Pareto archive computes the new row and the new column, at most of all generations.
        return candidates + tests

    def sample(self, available: int, epoch: int, rng: np.random.Generator) -> Indices:
        """Return the newest opponent and tests of the archive, or one of both."""
        check_available(available)
        # Sorted, so that the sample does not depend on the order inside the archive.
        kept = np.unique(self.archive.tests).astype(np.intp)
        if len(kept) and (kept[0] < 0 or kept[-1] >= available):
            raise ValueError(f"archive: expected generations below {available}, got {kept}")
        newest, older = np.array([available - 1], dtype=np.intp), kept[kept < available - 1]
        # `available` grows by one in each generation: the turns alternate with one epoch, too.
        places = self.count - 1 if self.count > 1 else (epoch + available) % 2
        drawn: Indices = rng.choice(older, size=min(places, len(older)), replace=False)
        alone = self.count == 1 and len(drawn)
        return drawn if alone else np.concatenate([newest, drawn])

    def state(self) -> State:
        """Return the state of the archive."""
        return self.archive.state()

    def restore(self, state: State) -> None:
        """Restore a state returned by `state()`."""
        self.archive.restore(state)


class MetaStrategy(ArchiveSampler):
    """Opponents drawn from a meta-strategy: policy-space response oracles (PSRO).

    ::

        update:  M = payoffs of all generations of the team against all of its opponents
                 weights = solver(M)
        sample:  opponent j with probability weights[j]

    With several opponents an epoch they are drawn without replacement, so that all have a more
    equal share than their weights say. Before the first update the newest opponent is met.

    Lanctot et al. 2017, "A unified game-theoretic approach to multiagent reinforcement learning",
    NeurIPS 30.

    Parameters
    ----------
    solver : callable
        Payoffs (n, m) of the team -> weights (m,) of its opponents, such as those of
        `matrixworld.analysis.games.META_SOLVERS`.
    count : int, optional
        Opponents an epoch; fewer, if fewer have a weight.
    """

    def __init__(self, solver: Callable[[FloatArray], FloatArray], count: int = 1) -> None:
        super().__init__(Archive(), count)
        self.archive.graded = True
        self.solver = solver
        self.weights = np.zeros(0)

    def update(self, new: Members, opponents: Members, payoff: PayoffFunction) -> None:
        """Add new generations to the game, and solve it. For the arguments see the base class."""
        super().update(new, opponents, payoff)
        # Rounded, since the last bits of a solution differ from processor to processor.
        rounded = np.round(self.solver(self.archive.payoffs), WEIGHT_DECIMALS)
        self.weights = rounded / rounded.sum()

    def sample(self, available: int, epoch: int, rng: np.random.Generator) -> Indices:
        """Return opponents drawn by their weights."""
        check_available(available)
        if not len(self.weights):
            return np.array([available - 1], dtype=np.intp)
        if len(self.weights) != available:
            raise ValueError(f"available: expected {len(self.weights)} opponents, got {available}")
        support = np.flatnonzero(self.weights)
        size, weights = min(self.count, len(support)), self.weights[support]
        return rng.choice(support, size=size, replace=False, p=weights)

    def state(self) -> State:
        """Return the game and the meta-strategy."""
        return {**super().state(), "weights": self.weights.copy()}

    def restore(self, state: State) -> None:
        """Restore a state returned by `state()`."""
        super().restore(state)
        self.weights = state["weights"].copy()
