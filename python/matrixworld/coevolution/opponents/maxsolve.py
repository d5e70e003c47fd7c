"""MaxSolve: the candidates that solve the most tests (de Jong 2005)."""

from __future__ import annotations

import numpy as np

from matrixworld.coevolution.opponents.pareto import Archive
from matrixworld.coevolution.opponents.samplers import check_count
from matrixworld.coevolution.types import FloatArray, Indices

SOLVED_ABOVE = 0.5
"""The payoff above which a candidate solves a test; at it neither team beats the other."""


class MaxSolve(Archive):
    """Up to `limit` candidates that solve the most tests, and the tests that they solve.

    ::

        C = archived and new candidates;  T = archived and new tests
        drop candidates that solve no test of T
        of candidates that solve the same tests of T keep one, the oldest
        keep the `limit` candidates that solve the most tests of T, of equals the oldest
        drop tests that no candidate kept solves
        of tests that are solved by the same candidates keep one, the oldest

    Source: de Jong 2005, "The MaxSolve algorithm for coevolution", GECCO. Sameness is that of the
    outcomes. Since candidates kept differ on a test that one of them solves, they differ on the
    tests kept.

    Parameters
    ----------
    limit : the most candidates to keep.
    """

    def __init__(self, limit: int) -> None:
        check_count("limit", limit)
        super().__init__()
        self.limit = limit

    def select(self, outcomes: FloatArray, archived: tuple[int, int]) -> tuple[Indices, Indices]:
        """Return the candidates and tests to keep."""
        solved = outcomes > SOLVED_ABOVE
        distinct = _first_of_equals(solved)
        most_first = distinct[np.argsort(-solved[distinct].sum(axis=1), kind="stable")]
        rows = np.sort(most_first[: self.limit])
        return rows, _first_of_equals(solved[rows].T)


def _first_of_equals(solved: np.ndarray) -> Indices:
    """Return the first of each kind of row that is not all False, in ascending order."""
    seen: dict[bytes, int] = {}
    for i, row in enumerate(solved):
        seen.setdefault(row.tobytes(), i)
    return np.array([i for i in seen.values() if solved[i].any()], dtype=np.intp)
