"""Generalist: progress against all opponents or none (Simione & Nolfi 2021)."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld.coevolution.opponents.pareto import Members, PayoffFunction, payoffs, protected
from matrixworld.coevolution.opponents.samplers import check_count
from matrixworld.coevolution.types import FloatArray, Indices, State


def maximally_different(outcomes: ArrayLike, count: int) -> Indices:
    """Return `count` opponents that do as differently as can be, in the order chosen.

    ::

        the first: the opponent with the highest mean payoff
        each next: the one farthest from the nearest of those chosen, by the mean absolute
                   difference of payoffs; of equals the first

    Parameters
    ----------
    outcomes : (m, n) payoffs of opponents against n members of the team that will meet them.
    count : opponents to choose; all, if there are fewer.
    """
    values = np.asarray(outcomes, dtype=np.float64)
    if values.ndim != 2:
        raise ValueError(f"outcomes: expected shape (m, n), got {values.shape}")
    chosen: list[int] = []
    distance = values.mean(axis=1)
    for _ in range(min(count, len(values))):
        chosen.append(int(np.argmax(distance)))
        nearest = np.abs(values[:, np.newaxis] - values[chosen]).mean(axis=2).min(axis=1)
        nearest[chosen] = -1.0
        distance = nearest
    return np.array(chosen, dtype=np.intp)


class Generalist:
    """A team of fixed size whose worst member makes way only for one better against everybody.

    ::

        opponents to learn against: a few that are maximally different
        submit:  for each variant that came of the learning, in turn:
                     worst = member with the lowest mean payoff against all opponents
                     if the variant's mean payoff against all opponents is higher:
                         it takes the place of the worst

    A variant that gains on those it has met and loses on others is thus filtered out. Source:
    Simione & Nolfi 2021, "Long-term progress and behavior complexification in competitive
    coevolution", Artificial Life 26(4).

    Parameters
    ----------
    members : (n, ...) the team at the start.
    sample : how many maximally different opponents to learn against.

    Attributes
    ----------
    candidates : (n, ...) the team, read-only.
    tests : (m, ...) the opponents to learn against next, out of those last submitted; read-only.
    graded : whether how clearly a candidate wins makes a difference; it does.
    anew : whether all tests are to be submitted each time; they are.
    """

    graded = True
    anew = True

    def __init__(self, members: ArrayLike, *, sample: int) -> None:
        check_count("sample", sample)
        self.candidates: Members = protected(members)
        check_count("members", len(self.candidates))
        self.tests: Members = protected([])
        self.sample = sample

    def submit(
        self, candidates: ArrayLike, tests: ArrayLike, outcome: PayoffFunction
    ) -> NDArray[np.bool_]:
        """Offer variants against all opponents; choose the opponents to be met next.

        Parameters
        ----------
        candidates : (v, ...) variants; may be empty.
        tests : (m, ...) the whole opposing team.

        Returns
        -------
        (v,) whether each variant has taken a place, even if it has lost it again to a later one.
        """
        variants, opponents = protected(candidates), protected(tests)
        check_count("tests", len(opponents))
        members = list(self.candidates)
        outcomes = payoffs(outcome, self.candidates, opponents)
        offered = payoffs(outcome, variants, opponents)
        taken = np.zeros(len(variants), dtype=np.bool_)
        for i, variant in enumerate(variants):
            worst = int(np.argmin(outcomes.mean(axis=1)))
            if offered[i].mean() > outcomes[worst].mean():
                outcomes[worst], members[worst], taken[i] = offered[i], variant, True
        self.candidates = protected(np.stack(members))
        self.tests = protected(opponents[self._next(outcomes)])
        return taken

    def _next(self, outcomes: FloatArray) -> Indices:
        return maximally_different(1.0 - outcomes.T, self.sample)

    def state(self) -> State:
        """Return the team, and the opponents to learn against next."""
        return {"candidates": self.candidates, "tests": self.tests}

    def restore(self, state: State) -> None:
        """Take up a state that `state` returned."""
        self.candidates = protected(state["candidates"])
        self.tests = protected(state["tests"])
