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
ASKED_AGAIN = 64
"""Of so many views, evenly spread, a function is asked twice: what it keeps or draws by itself, and
not by its arguments, shows in its answers."""


class NotExactError(ValueError):
    """A function draws what cannot be followed, or answers the same question differently."""


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
        and comparisons of ``random()``, or too many of them; or if it answers differently when it
        is asked again, of some of the views, because it remembers or draws by itself.
    TypeError, ValueError
        If it takes other arguments, or returns no legal actions.
    """
    ask = _asked_with_draws if _takes_draws(function) else _asked_without
    found = ask(function, views, n_actions)
    again = np.linspace(0, len(views) - 1, min(len(views), ASKED_AGAIN), dtype=np.intp)
    if not np.array_equal(ask(function, views[again], n_actions), found[again]):
        raise NotExactError(
            "function: expected one that chooses by its arguments alone, got other answers for the "
            "same views: it remembers, or draws other random numbers than those of rng"
        )
    return found


def _asked_without(
    function: Callable[..., Any], views: NDArray[np.uint8], n_actions: int
) -> NDArray[np.float64]:
    """Return the probabilities, 0 or 1, of a function of views."""
    return np.eye(n_actions)[checked_actions(function, views.copy(), n_actions)]


def _asked_with_draws(
    function: Callable[..., Any], views: NDArray[np.uint8], n_actions: int
) -> NDArray[np.float64]:
    """Return the probabilities of a function of a view and random numbers."""
    found = np.zeros((len(views), n_actions))
    for row, view in zip(found, views, strict=True):
        for given, share in _branches(function, view):
            action = checks.check_integer("action of the function", given, 0, n_actions - 1)
            row[action] += share
    return found


def _takes_draws(function: Callable[..., Any]) -> bool:
    """Return whether a function is called with random numbers; TypeError if it needs still more."""
    try:
        signature = inspect.signature(function)
    except (TypeError, ValueError):  # some functions of C have none
        return False
    required = [
        each.name
        for each in signature.parameters.values()
        if each.default is each.empty
        and each.kind in (each.POSITIONAL_ONLY, each.POSITIONAL_OR_KEYWORD)
    ]
    if "memory" in signature.parameters or len(required) > 2:
        name = getattr(function, "__name__", type(function).__name__)
        raise TypeError(
            f"function: expected f(views) or f(view, rng), got {name}{signature}; what a function "
            "remembers is no part of a state"
        )
    return "rng" in signature.parameters or len(required) == 2


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
        if result >= len(shares):
            raise NotExactError(
                "draws: expected the same ones after the same results, got others: the function "
                "remembers, or draws other random numbers than those of rng"
            )
        self.taken.append((result, len(shares)))
        self.share *= shares[result]
        return result

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
        first, last = (0, int(low)) if high is None else (int(low), int(high))
        n = last - first + endpoint
        count = 1 if size is None else int(np.prod(size))
        drawn = np.array([first + self._below(n) for _ in range(count)], dtype)
        return drawn[0] if size is None else drawn.reshape(size)

    def choice(self, a: Any, size: Any = None, replace: bool = True, p: Any = None) -> Any:
        """Return one item of a sequence, or one number below `a`."""
        if size is not None:
            raise NotExactError("rng.choice: expected one item, got a size")
        items = np.arange(a) if isinstance(a, int | np.integer) else np.asarray(a)
        if p is None:
            return items[self._below(len(items))]
        shares = np.asarray(p, np.float64)
        if shares.shape != (len(items),) or abs(shares.sum() - 1) > 1e-8 or shares.min() < 0:
            raise ValueError(f"rng.choice: expected probabilities of {len(items)} items, got {p}")
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
            raise NotExactError("rng.random: expected one number, got a size")
        return Uniform(self)

    def __getattr__(self, name: str) -> NoReturn:
        raise NotExactError(f"rng.{name}: its results cannot all be followed")


class Uniform:
    """A number drawn from [0, 1), known to be in [`low`, `high`): each comparison is a draw."""

    __array_ufunc__ = None  # so that a number of NumPy leaves the comparison to this class

    def __init__(self, draws: FollowedDraws) -> None:
        self._draws = draws
        self._low = 0.0
        self._high = 1.0

    def _is_below(self, other: Any) -> bool:
        if np.ndim(other) or np.isnan(limit := float(other)):
            raise NotExactError(f"rng.random: expected a comparison with a number, got {other!r}")
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
