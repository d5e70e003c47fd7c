"""Nash averaging: each generation judged by the opponents that matter, however many copies."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld.analysis.payoff import Rates, check_payoff, swap_teams

Mask = NDArray[np.bool_]

_TIE = 1e-7
"""Capture rates closer than this are the same: the tolerance of the linear programmes."""
_NOTHING = 1e-7
"""Weights below it are the tolerance's, too."""
_RANK = 1e-9  # singular values below this share of the largest are 0
_STRICT = {"primal_feasibility_tolerance": 1e-10, "dual_feasibility_tolerance": 1e-10}
_MOST_STEPS = 200


@dataclass(frozen=True, eq=False)
class Nash:
    """The maximum-entropy Nash equilibrium of a payoff matrix, and what it says of everybody."""

    value: float
    """Capture rate when both teams play their equilibrium mixtures."""
    pursuers: Rates
    """Shape ``(n,)``, sum 1: how often the pursuers should play each of their generations."""
    evaders: Rates
    """Shape ``(m,)``, sum 1."""
    pursuer_averages: Rates
    """Shape ``(n,)``: capture rate of each generation against the mixture of the evaders; `value`
    at most. This is the Nash average."""
    evader_averages: Rates
    """Shape ``(m,)``: escape rate of each against the mixture of the pursuers; ``1 - value`` at
    most."""


def nash_averaging(payoff: ArrayLike) -> Nash:
    """Nash averaging for two teams ("agent against task", Balduzzi et al., 2018).

    Solves the zero-sum game M by linear programming (Dantzig, 1951) and takes of each team's
    optimal mixtures, which form a polytope, the one of maximum entropy: it is unique, swapping the
    teams swaps it, and copies of a generation share the weight of one and change nothing else in
    the value and the averages.

    M is not embedded into one symmetric game: with a capture rate, which is not centred, that game
    favours one role and its equilibrium collapses onto one side.

    Payoffs that differ by less than 1e-7 are treated as equal. Raises RuntimeError should the
    solver fail.
    """
    matrix = check_payoff(payoff)
    swapped = swap_teams(matrix)
    p, q = _optimal(matrix), _optimal(swapped)
    # What either mixture guarantees; the two bounds meet but for rounding.
    low, high = float((p @ matrix).min()), 1.0 - float((q @ swapped).min())
    inner_p, inner_q = _inner(matrix, low, p), _inner(swapped, 1.0 - high, q)
    p = _max_entropy(matrix, low, inner_p, inner_q > 0.0)
    q = _max_entropy(swapped, 1.0 - high, inner_q, inner_p > 0.0)
    return Nash((low + high) / 2.0, p, q, matrix @ q, 1.0 - p @ matrix)


def game_value(payoff: ArrayLike) -> float:
    """Capture rate of the zero-sum game M under optimal play: one linear programme, no mixtures."""
    matrix = check_payoff(payoff)
    return float((_optimal(matrix) @ matrix).min())


def _optimal(matrix: Rates) -> Rates:
    """A mixture of rows that guarantees the most: max v with ``p @ matrix >= v``."""
    rows, columns = matrix.shape
    upper = np.hstack([-matrix.T, np.ones((columns, 1))])
    equal = np.append(np.ones(rows), 0.0)
    cost = np.append(np.zeros(rows), -1.0)
    bounds = [(0.0, None)] * rows + [(None, None)]
    return _mixture(_solve(cost, upper, np.zeros(columns), equal, bounds)[:rows])


def _inner(matrix: Rates, value: float, start: Rates) -> Rates:
    """An optimal mixture of every row that has a weight in any optimal mixture; 0 for the others.

    The mean of ``start``, which is one, and of others, each of which gives as many rows as possible
    that none before has used a share t, up to ``1 / rows``.
    """
    rows, columns = matrix.shape
    kept = np.vstack(
        [
            np.hstack([-matrix.T, np.zeros((columns, rows))]),
            np.hstack([-np.eye(rows), np.eye(rows)]),
        ]
    )
    limits = np.append(np.full(columns, -value), np.zeros(rows))
    equal = np.repeat([1.0, 0.0], rows)
    found = [np.where(start > _NOTHING, start, 0.0)]
    while True:
        unused = ~np.any(found, axis=0)
        ends = np.where(unused, 1.0 / rows, 0.0)
        bounds = [(0.0, None)] * rows + [(0.0, float(end)) for end in ends]
        mixture = _solve(np.repeat([0.0, -1.0], rows), kept, limits, equal, bounds)[:rows]
        if not (mixture[unused] > _NOTHING).any():
            return _mixture(np.mean(found, axis=0))
        found.append(np.where(mixture > _NOTHING, mixture, 0.0))


def _solve(
    cost: Rates,
    upper: Rates,
    limits: Rates,
    equal: Rates,
    bounds: Sequence[tuple[float | None, float | None]],
) -> Rates:
    """The x in its bounds with ``upper @ x <= limits`` and ``equal @ x = 1`` of least cost."""
    from scipy.optimize import linprog

    # Where rounding leaves no solution within the strict tolerances, the usual 1e-7 will do.
    for options in (_STRICT, None):
        result = linprog(
            cost, upper, limits, equal[None], [1.0], bounds, method="highs", options=options
        )
        if result.status == 0:
            solution: Rates = result.x
            return solution
    raise RuntimeError(f"expected a solution of the linear programme, got: {result.message}")


def _mixture(weights: Rates) -> Rates:
    positive = np.maximum(weights, 0.0)
    mixture: Rates = positive / positive.sum()
    return mixture


def _max_entropy(matrix: Rates, value: float, inner: Rates, tight: Mask) -> Rates:
    """The optimal mixture of maximum entropy.

    In every optimal mixture the columns ``tight``, which the opponent may play, give exactly
    ``value``, the others at least that; rows outside the support of ``inner`` have no weight.
    """
    used = inner > 0.0
    margins = (matrix - value)[used]
    equations = np.vstack([margins[:, tight].T, np.ones(used.sum())])
    target = np.append(np.zeros(tight.sum()), 1.0)
    start = inner[used] - np.linalg.pinv(equations, rcond=_RANK) @ (
        equations @ inner[used] - target
    )
    if (start <= 0.0).any():  # weights next to the tolerance: as the programme left them
        start = inner[used]
    directions = _null_space(equations)
    best = _newton(start, directions)
    slack = margins[:, ~tight].T
    if slack.size and (slack @ best).min() < -_TIE:
        best = _bounded(start, directions, slack)
    mixture = np.zeros(len(matrix))
    mixture[used] = best
    return _mixture(mixture)


def _null_space(equations: Rates) -> Rates:
    """Orthonormal directions, shape ``(rows, d)``, that keep all equations."""
    _, sizes, right = np.linalg.svd(equations)
    directions: Rates = right[int(np.sum(sizes > _RANK * sizes[0])) :].T
    return directions


def _newton(start: Rates, directions: Rates) -> Rates:
    """Maximises the entropy of ``start + directions @ z`` by Newton's method; stays positive."""
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
    """The same where columns outside the opponent's support become binding: ``slack @ p >= 0``."""
    from scipy.optimize import minimize

    def negative_entropy(z: Rates) -> tuple[float, Rates]:
        p = np.maximum(start + directions @ z, 1e-300)
        return float(p @ np.log(p)), directions.T @ np.log(p)

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
