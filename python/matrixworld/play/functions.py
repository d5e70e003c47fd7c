"""Functions as players: the probabilities with which they choose, exactly.

A function gets views, or a view and random numbers. Where it draws whole numbers, items or orders,
or compares a uniform number with another one, every result of a draw is followed, so that its
probabilities have no noise.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Sequence
from typing import Any, NoReturn

import numpy as np
from numpy.typing import NDArray

from matrixworld._util import checks
from matrixworld.play.matches import checked_actions

MOST_BRANCHES = 5000
"""The most results of draws that are followed in one decision."""
MOST_DRAWS = 40
"""The most draws of one decision: more of them have too many results, or never end."""


class NotExactError(ValueError):
    """A function draws what cannot be followed."""


def probabilities_of(
    function: Callable[..., Any], views: NDArray[np.uint8], n_actions: int
) -> NDArray[np.float64]:
    """Return the probabilities, float64 (n, n_actions), with which a function chooses.

    Parameters
    ----------
    function : callable
        ``f(views)``, from uint8 (n, 3, fov, fov) to actions (n,) or from one view to one action; or
        ``f(view, rng)``, from one view and a generator with methods of `numpy.random.Generator`.
    views : ndarray of uint8, shape (n, 3, fov, fov)
        What the agents see. The function gets copies.
    n_actions : int
        The number of moves.

    Raises
    ------
    NotExactError
        If it uses random numbers other than ``integers``, ``choice``, ``permutation``, ``shuffle``
        and comparisons of ``random()``, or too many of them.
    TypeError, ValueError
        If it takes other arguments, or returns no legal actions.
    """
    n_arguments = _arguments(function)
    found = np.zeros((len(views), n_actions))
    if n_arguments == 1:
        found[np.arange(len(views)), checked_actions(function, views.copy(), n_actions)] = 1.0
        return found
    for row, view in zip(found, views, strict=True):
        for action, share in _branches(function, view):
            row[_checked(action, n_actions)] += share
    return found


def _arguments(function: Callable[..., Any]) -> int:
    """Return with how many arguments a function is called, 1 or 2."""
    try:
        signature = inspect.signature(function)
    except (TypeError, ValueError):  # some functions of C have none
        return 1
    required = [
        each.name
        for each in signature.parameters.values()
        if each.default is each.empty
        and each.kind in (each.POSITIONAL_ONLY, each.POSITIONAL_OR_KEYWORD)
    ]
    if "memory" in signature.parameters or len(required) > 2:
        raise TypeError(
            f"function: expected f(views) or f(view, rng), got {_name(function)}{signature}; what "
            "a function remembers is no part of a state"
        )
    return max(1, len(required))


def _name(function: Callable[..., Any]) -> str:
    return getattr(function, "__name__", type(function).__name__)


def _checked(action: Any, n_actions: int) -> int:
    return checks.check_integer("action of the function", action, 0, n_actions - 1)


def _branches(function: Callable[..., Any], view: NDArray[np.uint8]) -> list[tuple[Any, float]]:
    """Return what a function of a view and a generator chooses after each result of its draws."""
    found: list[tuple[Any, float]] = []
    path: list[int] = []
    while True:
        draws = FollowedDraws(path)
        action = function(view.copy(), draws)
        found.append((action, draws.share))
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
        self.taken: list[tuple[int, int]] = []

    def draw(self, shares: Sequence[float]) -> int:
        """Return the number of the next result of a draw with these probabilities."""
        place = len(self.taken)
        if place == MOST_DRAWS:
            raise NotExactError(f"draws: expected at most {MOST_DRAWS} in a decision, got more")
        result = self._path[place] if place < len(self._path) else 0
        self.taken.append((result, len(shares)))
        self.share *= shares[result]
        return result

    def _below(self, n: int) -> int:
        if n < 1:
            raise ValueError(f"draws: expected at least one possible result, got {n}")
        return self.draw([1.0 / n] * n)

    def integers(
        self, low: int, high: int | None = None, size: Any = None, *, endpoint: bool = False
    ) -> Any:
        """Return whole numbers from `low` to below `high`, as NumPy's generator does."""
        first, last = (0, low) if high is None else (low, high)
        n = int(last) - int(first) + endpoint
        if size is None:
            return int(first) + self._below(n)
        drawn = [int(first) + self._below(n) for _ in range(int(np.prod(size)))]
        return np.array(drawn).reshape(size)

    def choice(self, a: Any, size: Any = None, *, p: Any = None) -> Any:
        """Return one item of a sequence, or one number below `a`."""
        if size is not None:
            raise NotExactError("rng.choice: expected one item, got a size")
        items = np.arange(a) if isinstance(a, int | np.integer) else np.asarray(a)
        if p is None:
            return items[self._below(len(items))]
        shares = np.asarray(p, np.float64)
        if shares.shape != (len(items),) or abs(shares.sum() - 1) > 1e-8 or shares.min() < 0:
            raise ValueError(f"rng.choice: expected probabilities of {len(items)} items, got {p}")
        return items[self.draw(shares.tolist())]

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
            raise NotExactError("rng.random: expected one number, got a size")
        return Uniform(self)

    def __getattr__(self, name: str) -> NoReturn:
        raise NotExactError(f"rng.{name}: its results cannot all be followed")


class Uniform:
    """A number drawn from [0, 1), known to be in [`low`, `high`): each comparison is a draw."""

    def __init__(self, draws: FollowedDraws) -> None:
        self._draws = draws
        self._low, self._high = 0.0, 1.0

    def _is_below(self, other: Any) -> bool:
        limit = float(other)
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
        raise NotExactError("rng.random: expected a comparison with its number, got arithmetic")

    __float__ = __int__ = __array__ = __bool__ = __neg__ = _refused
    __add__ = __radd__ = __sub__ = __rsub__ = _refused
    __mul__ = __rmul__ = __truediv__ = __rtruediv__ = _refused
