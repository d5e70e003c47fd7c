"""Generalist: progress against all opponents or none (Simione & Nolfi 2021)."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from matrixworld.coevolution.opponents.pareto import PayoffFunction, checked_payoffs, read_only
from matrixworld.coevolution.opponents.samplers import check_count
from matrixworld.coevolution.types import BoolArray, FloatArray, Indices, Members, State


def maximally_different(payoffs: ArrayLike, count: int) -> Indices:
    """Return opponents whose payoffs differ as much as possible.

    ::

        first: the opponent with the highest mean payoff
        next:  the opponent farthest from the nearest chosen one, by the mean absolute difference
               of payoffs; of equals the first

    Parameters
    ----------
    payoffs : array_like of float, shape (m, n)
        Payoffs of m opponents against n members of the team that learns.
    count : int
        Opponents to choose; all, if there are fewer.

    Returns
    -------
    ndarray of intp, shape (min(count, m),)
        Opponents in the order chosen.

    Raises
    ------
    ValueError
        If `payoffs` has another number of axes.
    """
    values = np.asarray(payoffs, dtype=np.float64)
    if values.ndim != 2:
        raise ValueError(f"payoffs: expected shape (m, n), got {values.shape}")
    chosen: list[int] = []
    distance = values.mean(axis=1)
    for _ in range(min(count, len(values))):
        chosen.append(int(np.argmax(distance)))
        nearest = np.abs(values[:, np.newaxis] - values[chosen]).mean(axis=2).min(axis=1)
        # Below every distance, so that no opponent is chosen twice.
        nearest[chosen] = -1.0
        distance = nearest
    return np.array(chosen, dtype=np.intp)


class Generalist:
    """A team of fixed size whose worst member is replaced only by a variant better against all.

    ::

        opponents to learn against: a few that are maximally different
        submit:  for each variant that the learning has produced, in turn:
                     worst = member with the lowest mean payoff against all opponents
                     if the variant's mean payoff against all opponents is higher:
                         it replaces the worst

    A variant that gains on the opponents of its training and loses on others is filtered out. The
    interface is that of `Archive`.

    Parameters
    ----------
    members : array_like, shape (n, ...)
        The team at the start.
    sample_size : int
        Number of maximally different opponents to learn against.

    Attributes
    ----------
    candidates : ndarray, shape (n, ...)
        The team; read-only.
    tests : ndarray, shape (m, ...)
        Opponents to learn against next, among those last submitted; read-only.
    graded : bool
        True: the archive compares means of graded payoffs.
    needs_all_tests : bool
        True: each submission must contain the whole opposing team.

    References
    ----------
    Simione & Nolfi 2021, "Long-term progress and behavior complexification in competitive
    coevolution", Artificial Life 26(4).
    """

    graded = True
    needs_all_tests = True

    def __init__(self, members: ArrayLike, *, sample_size: int) -> None:
        check_count("sample_size", sample_size)
        self.candidates: Members = read_only(members)
        check_count("members", len(self.candidates))
        self.tests: Members = read_only([])
        self.sample_size = sample_size

    def submit(self, candidates: ArrayLike, tests: ArrayLike, payoff: PayoffFunction) -> BoolArray:
        """Submit variants, and choose the opponents to learn against next.

        Parameters
        ----------
        candidates : array_like, shape (v, ...)
            Variants; may be empty.
        tests : array_like, shape (m, ...)
            The whole opposing team.
        payoff : callable
            See `PayoffFunction`.

        Returns
        -------
        ndarray of bool, shape (v,)
            Whether each variant has replaced a member, even if a later variant has replaced it.
        """
        variants, opponents = read_only(candidates), read_only(tests)
        check_count("tests", len(opponents))
        # Opponents learn, too: payoffs of the last submission are of no use here.
        members = list(self.candidates)
        payoffs = checked_payoffs(payoff, self.candidates, opponents)
        offered = checked_payoffs(payoff, variants, opponents)
        replaced = np.zeros(len(variants), dtype=np.bool_)
        for i, variant in enumerate(variants):
            # The worst of the present team, in which earlier variants may have a place.
            worst = int(np.argmin(payoffs.mean(axis=1)))
            if offered[i].mean() > payoffs[worst].mean():
                payoffs[worst], members[worst], replaced[i] = offered[i], variant, True
        self.candidates = read_only(np.stack(members))
        self.tests = read_only(opponents[self._next_tests(payoffs)])
        return replaced

    def _next_tests(self, payoffs: FloatArray) -> Indices:
        # The opponents' own payoffs: the same matrix, seen from the other side.
        return maximally_different(1.0 - payoffs.T, self.sample_size)

    def state(self) -> State:
        """Return the team, and the opponents to learn against next."""
        return {"candidates": self.candidates, "tests": self.tests}

    def restore(self, state: State) -> None:
        """Restore a state returned by `state()`."""
        self.candidates = read_only(state["candidates"])
        self.tests = read_only(state["tests"])
