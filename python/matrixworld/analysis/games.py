"""Games between generations: Nash averaging, exploitability, and meta-solvers."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld._util.readable import Readable
from matrixworld.analysis.payoffs import Rates, check_payoff, check_rates, require, swap_teams

# Capture rates closer than this count as equal: the tolerance of the linear programmes.
_TIE = 1e-7
# Weights below this count as 0, by the same tolerance.
_NOTHING = 1e-7
# A row that gets so much less than the value has no weight, for all tolerances of the solver.
_LESS = 1e-3
_RANK = 1e-9  # singular values below this share of the largest are 0
_STRICT = {"primal_feasibility_tolerance": 1e-10, "dual_feasibility_tolerance": 1e-10}
_MOST_STEPS = 200


@dataclass(frozen=True, eq=False, repr=False)
class Nash(Readable):
    """The maximum-entropy Nash equilibrium of a payoff matrix, and payoffs against it.

    The averages are capture rates, and escape rates, against the mixture of the other team.
    """

    value: float
    pursuers: Rates
    evaders: Rates
    pursuer_averages: Rates
    evader_averages: Rates


def nash_averaging(payoff: ArrayLike) -> Nash:
    """Find the maximum-entropy equilibrium, and the payoffs against it.

    Parameters
    ----------
    payoff : array_like, shape (n, m)
        Capture rates in [0, 1]. Those closer than 1e-7 count as equal.

    Returns
    -------
    Nash
        Its `value`, the mixtures `pursuers` (n,) and `evaders` (m,), and the averages against them.

    Notes
    -----
    The zero-sum game is solved by linear programming. The optimal mixtures of a team form a
    polytope; the one of maximum entropy is unique. Copies of a generation share its weight and
    change neither the value nor the averages.

    Balduzzi et al. (2018), "Re-evaluating evaluation": the case of agents against tasks. Dantzig
    (1951), "A proof of the equivalence of the programming problem and the game problem".
    """
    matrix = check_payoff(payoff)
    swapped = swap_teams(matrix)
    # Three steps: one optimal mixture of each team, one with the largest support, and among the
    # mixtures of that support the one of maximum entropy.
    p, q = _optimal(matrix), _optimal(swapped)
    # The payoffs that both mixtures guarantee; the two bounds are equal but for rounding.
    low, high = float((p @ matrix).min()), 1.0 - float((q @ swapped).min())
    # The largest support is needed because entropy has no finite slope at a weight of 0.
    inner_p, inner_q = _inner(matrix, low, p, q), _inner(swapped, 1.0 - high, q, p)
    p = _max_entropy(matrix, low, inner_p, inner_q > 0.0)
    q = _max_entropy(swapped, 1.0 - high, inner_q, inner_p > 0.0)
    return Nash((low + high) / 2.0, p, q, matrix @ q, 1.0 - p @ matrix)


def game_value(payoff: ArrayLike) -> float:
    """Return ``nash_averaging(payoff).value`` from one linear programme."""
    matrix = check_payoff(payoff)
    return float((_optimal(matrix) @ matrix).min())


def _optimal(matrix: Rates) -> Rates:
    """Return a mixture p of rows that guarantees the most: max v with ``p @ matrix >= v``."""
    rows, columns = matrix.shape
    # The variables are the weights p and the guaranteed payoff v.
    # Against each column the mixture guarantees v: v - (p @ matrix)_h <= 0.
    upper = np.hstack([-matrix.T, np.ones((columns, 1))])
    equal = np.append(np.ones(rows), 0.0)
    cost = np.append(np.zeros(rows), -1.0)
    bounds = [(0.0, None)] * rows + [(None, None)]
    return _mixture(_solve(cost, upper, np.zeros(columns), equal, bounds)[:rows])


def _inner(matrix: Rates, value: float, start: Rates, answer: Rates) -> Rates:
    """Return an optimal mixture of all rows that have a weight in any optimal mixture."""
    # The mean of `start` and of others with the most weight, up to 1 / rows each, on rows unused so
    # far. Rows that get less than the value against the optimal `answer` have none.
    rows, columns = matrix.shape
    kept = np.block([[-matrix.T, np.zeros((columns, rows))], [-np.eye(rows), np.eye(rows)]])
    limits = np.append(np.full(columns, -value), np.zeros(rows))
    equal = np.repeat([1.0, 0.0], rows)
    mixtures = [np.where(start > _NOTHING, start, 0.0)]
    possible = matrix @ answer > value - _LESS
    while True:
        unused = ~np.any(mixtures, axis=0)
        if not (possible & unused).any():
            break
        ends = np.where(unused, 1.0 / rows, 0.0)
        bounds = [(0.0, None)] * rows + [(0.0, float(end)) for end in ends]
        mixture = _solve(np.repeat([0.0, -1.0], rows), kept, limits, equal, bounds)[:rows]
        if not (mixture[unused] > _NOTHING).any():
            break
        mixtures.append(np.where(mixture > _NOTHING, mixture, 0.0))
    return _mixture(np.mean(mixtures, axis=0))


def _solve(
    cost: Rates,
    upper: Rates,
    limits: Rates,
    equal: Rates,
    bounds: Sequence[tuple[float | None, float | None]],
) -> Rates:
    """Return the x of least cost within bounds, ``upper @ x <= limits`` and ``equal @ x = 1``."""
    from scipy.optimize import linprog

    # If rounding leaves no solution within the strict tolerances, the default ones (1e-7) serve. To
    # simplify the programme first, as HiGHS does, can lose its only solution by rounding.
    for options in (_STRICT, None, {"presolve": False}):
        result = linprog(
            cost, upper, limits, equal[None], [1.0], bounds, method="highs", options=options
        )
        if result.status == 0:
            solution: Rates = result.x
            return solution
    raise RuntimeError(f"expected a solution of the linear programme, got: {result.message}")


def _mixture(weights: Rates) -> Rates:
    # The solver may return weights just below 0.
    positive = np.maximum(weights, 0.0)
    mixture: Rates = positive / positive.sum()
    return mixture


def _max_entropy(matrix: Rates, value: float, inner: Rates, tight: NDArray[np.bool_]) -> Rates:
    """Return the optimal mixture of maximum entropy, of the rows in the support of `inner`.

    Columns that the opponent may play are `tight`: they give exactly `value`, others more.
    """
    used = inner > 0.0
    margins = (matrix - value)[used]
    equations = np.vstack([margins[:, tight].T, np.ones(used.sum())])
    target = np.append(np.zeros(tight.sum()), 1.0)
    # The linear programme satisfies the equations to its tolerance only: project onto them.
    start = inner[used] - np.linalg.pinv(equations, rcond=_RANK) @ (
        equations @ inner[used] - target
    )
    if (start <= 0.0).any():  # weights close to the tolerance: keep those of the programme
        start = inner[used]
    _, sizes, right = np.linalg.svd(equations)
    # Orthonormal directions (rows, d) that keep all equations.
    directions = right[int(np.sum(sizes > _RANK * sizes[0])) :].T
    # Inequalities rarely bind, so Newton's method first tries without them.
    best = _newton(start, directions)
    slack = margins[:, ~tight].T
    if slack.size and (slack @ best).min() < -_TIE:
        best = _bounded(start, directions, slack)
    # Rows outside the support keep an exact 0.
    mixture = np.zeros(len(matrix))
    mixture[used] = best
    return _mixture(mixture)


def _newton(start: Rates, directions: Rates) -> Rates:
    """Maximise the entropy of ``start + directions @ z`` by Newton's method, keeping it > 0."""
    p = start
    for _ in range(_MOST_STEPS if directions.size else 0):
        gradient = directions.T @ np.log(p)
        curvature = directions.T @ (directions / p[:, None])
        step = -directions @ np.linalg.solve(curvature, gradient)
        falling = -np.min(step / p, initial=0.0)
        # Beyond a relative step of 1 a logarithm is no longer close to its tangent.
        p = p + step * min(1.0, 0.5 / falling if falling > 0.5 else 1.0)
        if np.abs(step / p).max() < 1e-12:
            break
    return p


def _bounded(start: Rates, directions: Rates, slack: Rates) -> Rates:
    """Maximise the entropy under ``slack @ p >= 0``: some columns outside the support bind."""
    from scipy.optimize import minimize

    def negative_entropy(z: Rates) -> tuple[float, Rates]:
        p = np.maximum(start + directions @ z, 1e-300)
        return float(p @ np.log(p)), directions.T @ np.log(p)

    # Weights stay at least 0, too: SLSQP has no limit on steps as `_newton` has.
    inequalities = np.vstack([slack, np.eye(len(start))])
    result = minimize(
        negative_entropy,
        np.zeros(directions.shape[1]),
        jac=True,
        method="SLSQP",
        constraints={
            "type": "ineq",
            "fun": lambda z: inequalities @ (start + directions @ z),
            "jac": lambda z: inequalities @ directions,
        },
        options={"ftol": 1e-14, "maxiter": 1000},
    )
    best: Rates = start + directions @ result.x
    if (inequalities @ best).min() < -1e-6:
        raise RuntimeError(f"expected a mixture of maximum entropy, got: {result.message}")
    return best


_ROUNDING = 1e-9  # tolerance of the sum of a mixture


class Exploitability(NamedTuple):
    """How much the best evaders lower, and the best pursuers raise, the capture rate."""

    pursuers: float
    evaders: float

    @property
    def total(self) -> float:
        """Sum of both gains (NashConv); 0 if and only if the mixtures are a Nash equilibrium."""
        return self.pursuers + self.evaders


def exploitability(payoff: ArrayLike, pursuers: ArrayLike, evaders: ArrayLike) -> Exploitability:
    """Return the gains of the best generations of the matrix against two mixtures.

    Parameters
    ----------
    payoff : array_like, shape (n, m)
        Capture rates M in [0, 1].
    pursuers, evaders : array_like, shapes (n,) and (m,)
        The mixtures p and q: weights of at least 0 with sum 1.

    Returns
    -------
    Exploitability
        ``p M q - min_h (p M)_h`` of the pursuers and ``max_g (M q)_g - p M q`` of the evaders, and
        their `total`. Opponents outside the matrix may gain more: see `solver.best_response`.

    Notes
    -----
    Lanctot et al. (2017), "A unified game-theoretic approach to multiagent reinforcement learning",
    where the sum is called NashConv.
    """
    matrix = check_payoff(payoff)
    p = check_mixture(pursuers, matrix.shape[0], "pursuers")
    q = check_mixture(evaders, matrix.shape[1], "evaders")
    # A mixture has a best response among the pure generations, so one minimum or maximum is enough.
    rate = float(p @ matrix @ q)
    lowest, highest = float((p @ matrix).min()), float((matrix @ q).max())
    # A best response never loses; rounding may put the difference just below 0.
    return Exploitability(max(0.0, rate - lowest), max(0.0, highest - rate))


def check_mixture(weights: ArrayLike, length: int, team: str) -> Rates:
    """Return weights of at least 0 with sum 1, or raise a ValueError that names the team."""
    mixture = check_rates(weights, ndim=1, what=f"weights of the {team}")
    require(len(mixture) == length, f"{length} weights of the {team}", len(mixture))
    total = float(mixture.sum())
    require(math.isclose(total, 1.0, abs_tol=_ROUNDING), f"weights of the {team} with sum 1", total)
    return mixture
