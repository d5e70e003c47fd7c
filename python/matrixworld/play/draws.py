"""Draws whose results are all followed, so that what depends on them is known without noise."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NoReturn, TypeVar

import numpy as np
from numpy.typing import NDArray

MOST_BRANCHES = 5000
"""The most results of draws that are followed in one decision."""
MOST_DRAWS = 40
"""The most draws of one decision: more of them have too many results, or never end."""

Answer = TypeVar("Answer")


class NotExactError(ValueError):
    """What a function chooses cannot be known exactly, such as by the draws that it makes."""


def branches(ask: Callable[[Any], Answer]) -> list[tuple[Answer, float]]:
    """Return what a function of a generator answers after each result of its draws.

    With each answer comes the probability of these results. `ask` gets a `FollowedDraws`.
    """
    found: list[tuple[Answer, float]] = []
    path: list[int] = []
    while True:
        draws = FollowedDraws(path)
        answer = ask(draws)
        if draws.refused is not None:  # the function has caught it
            raise draws.refused
        found.append((answer, draws.share))
        if len(found) > MOST_BRANCHES:
            raise NotExactError(f"draws: expected at most {MOST_BRANCHES:,} results, got more")
        taken = draws.taken
        while taken and taken[-1][0] + 1 == taken[-1][1]:  # its last result has been followed
            taken.pop()
        if not taken:
            return found
        path = [result for result, _ in taken]
        path[-1] += 1


class FollowedDraws:
    """A generator whose draws have the results of a path, and then the first ones.

    `share` is the probability of all results so far; `taken` has each of them, as its number and of
    how many.
    """

    def __init__(self, path: Sequence[int]) -> None:
        self._path = path
        self.share = 1.0
        self.refused: NotExactError | None = None
        self.taken: list[tuple[int, int]] = []

    def draw(self, shares: Sequence[float]) -> int:
        """Return the number of the next result of a draw with these probabilities."""
        place = len(self.taken)
        if place == MOST_DRAWS:
            self.refuse(f"draws: expected at most {MOST_DRAWS} in a decision, got more")
        result = self._path[place] if place < len(self._path) else 0
        if result >= len(shares):
            self.refuse(
                "draws: expected the same ones after the same results, got others: the function "
                "remembers, or draws other random numbers than those of rng"
            )
        self.taken.append((result, len(shares)))
        self.share *= shares[result]
        return result

    def refuse(self, reason: str) -> NoReturn:
        """Raise NotExactError, of which `branches` hears also if the function catches it."""
        self.refused = self.refused or NotExactError(reason)
        raise self.refused

    def _below(self, n: int) -> int:
        if n < 1:
            raise ValueError(f"draws: expected at least one possible result, got {n}")
        return self.draw([1.0 / n] * n)

    def integers(
        self,
        low: int,
        high: int | None = None,
        size: Any = None,
        dtype: Any = np.int64,
        endpoint: bool = False,
    ) -> Any:
        """Return whole numbers from `low` to below `high`, as NumPy's generator does."""
        if np.ndim(low) or (high is not None and np.ndim(high)):
            self.refuse("rng.integers: expected bounds that are integers, got arrays")
        first, last = (0, int(low)) if high is None else (int(low), int(high))
        n = last - first + endpoint
        count = 1 if size is None else int(np.prod(size))
        drawn = np.array([first + self._below(n) for _ in range(count)], dtype)
        return drawn[0] if size is None else drawn.reshape(size)

    def choice(
        self, a: Any, size: Any = None, replace: bool = True, p: Any = None, **more: Any
    ) -> Any:
        """Return one item of a sequence, or one number below `a`."""
        if size is not None:
            self.refuse("rng.choice: expected one item, got a size")
        items = np.arange(a) if isinstance(a, int | np.integer) else np.asarray(a)
        if p is None:
            return items[self._below(len(items))]
        given = np.asarray(p)
        # As NumPy's generator: what a type of numbers can carry.
        rounding = float(np.sqrt(np.finfo(given.dtype).eps)) if given.dtype.kind == "f" else 1e-8
        shares = given.astype(np.float64)
        if shares.shape != (len(items),) or abs(shares.sum() - 1) > rounding or shares.min() < 0:
            raise ValueError(f"rng.choice: expected probabilities of {len(items)} items, got {p}")
        shares /= shares.sum()
        possible = np.flatnonzero(shares)  # what never comes is not followed
        return items[possible[self.draw(shares[possible].tolist())]]

    def permutation(self, x: Any) -> NDArray[Any]:
        """Return items in random order."""
        left = list(range(x)) if isinstance(x, int | np.integer) else list(x)
        return np.array([left.pop(self._below(len(left))) for _ in range(len(left))])

    def shuffle(self, x: Any) -> None:
        """Put the items of a list or array into random order."""
        x[:] = [x[place] for place in self.permutation(len(x))]

    def random(self, size: Any = None) -> Uniform:
        """Return a number from [0, 1) that can only be compared."""
        if size is not None:
            self.refuse("rng.random: expected one number, got a size")
        return Uniform(self)

    def __getattr__(self, name: str) -> NoReturn:
        self.refuse(f"rng.{name}: its results cannot all be followed")


class Uniform:
    """A number drawn from [0, 1), known to be in [`low`, `high`): each comparison is a draw."""

    __array_ufunc__ = None  # so that a number of NumPy leaves the comparison to this class

    def __init__(self, draws: FollowedDraws) -> None:
        self._draws = draws
        self._low = 0.0
        self._high = 1.0

    def _is_below(self, other: Any) -> bool:
        if np.ndim(other) or np.isnan(limit := float(other)):
            self._draws.refuse(f"rng.random: expected a comparison with a number, got {other!r}")
        if limit <= self._low:
            return False
        if limit >= self._high:
            return True
        share = (limit - self._low) / (self._high - self._low)
        below = self._draws.draw([share, 1.0 - share]) == 0
        if below:
            self._high = limit
        else:
            self._low = limit
        return below

    # Equality has the probability 0.
    def __lt__(self, other: Any) -> bool:
        return self._is_below(other)

    def __le__(self, other: Any) -> bool:
        return self._is_below(other)

    def __gt__(self, other: Any) -> bool:
        return not self._is_below(other)

    def __ge__(self, other: Any) -> bool:
        return not self._is_below(other)

    def _refused(self, *others: Any) -> NoReturn:
        self._draws.refuse("rng.random: expected a comparison with its number, got arithmetic")

    __float__ = __int__ = __array__ = __bool__ = __neg__ = _refused
    __add__ = __radd__ = __sub__ = __rsub__ = _refused
    __mul__ = __rmul__ = __truediv__ = __rtruediv__ = __floordiv__ = __rfloordiv__ = _refused
    __mod__ = __rmod__ = __pow__ = __rpow__ = __abs__ = __round__ = __divmod__ = _refused
    __floor__ = __ceil__ = __trunc__ = __index__ = _refused
