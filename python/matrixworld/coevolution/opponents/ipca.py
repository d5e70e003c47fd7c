"""IPCA: the incremental Pareto-coevolution archive (de Jong 2004)."""

from __future__ import annotations

import numpy as np

from matrixworld.coevolution.opponents.distinctions import distinctions, fewest_tests, front
from matrixworld.coevolution.opponents.pareto import Archive
from matrixworld.coevolution.types import FloatArray, Indices


class IPCA(Archive):
    """The candidates that none dominates, and all tests that were ever needed to show it.

    ::

        C = archived and new candidates;  T = archived and new tests
        F = the candidates of C that none dominates on T, the oldest of those with equal outcomes
        for each c in F and each a, archived or in F, than which c does better on some test of T:
            unless an archived test shows it, add a new test that does (as few as the greedy
            choice finds)
        candidates = F;  no test is ever dropped

    Source: de Jong 2004, "The incremental Pareto-coevolution archive", GECCO; dominance as in
    Ficici & Pollack 2001. The archive is monotone: whatever it has held, some candidate in it does
    at least as well on every test that was held at the time. It grows without bound; `LAPCA` does
    not.
    """

    def select(self, outcomes: FloatArray, archived: tuple[int, int]) -> tuple[Indices, Indices]:
        """Return the candidates and tests to keep."""
        rows = front(outcomes)
        others = np.union1d(rows, np.arange(archived[0]))
        pairs = (len(rows) * len(others), outcomes.shape[1])
        shown = distinctions(outcomes)[np.ix_(rows, others)].reshape(pairs)
        known = shown[:, : archived[1]].any(axis=1)
        added = archived[1] + np.array(fewest_tests(shown[~known, archived[1] :]), dtype=np.intp)
        return rows, np.concatenate([np.arange(archived[1]), np.sort(added)])
