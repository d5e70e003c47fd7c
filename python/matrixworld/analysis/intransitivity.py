"""How far capture rates are from any order of strength: the amplitude of policy cycles.

A race is *transitive* if its generations can be ordered by strength: sorted by it, capture rates
never fall along the pursuers and never rise along the evaders. Strength need not grow in the order
of time, and it may saturate. A checkerboard (see `checkerboards`) contradicts every such order.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from matrixworld.analysis.cycles import checkerboards, transitive_share
from matrixworld.analysis.measurement import Measurement
from matrixworld.analysis.payoff import Rates, check_payoff, check_rates, require

MOST_GENERATIONS = 40
"""More generations of a team are thinned out evenly, which keeps a fit below a second."""
SORTING = 1.5
"""Share of the noise that sorting hides, in units of (n + m) / (n m). Simulated: 1 to 1.3."""
ITERATIONS = 200
"""Most iterations of a fit; 20 to 100 suffice."""
_CONVERGED = 1e-4  # largest change of a cell in the last iteration


def transitive_fit(payoff: ArrayLike) -> Rates:
    """Return the transitive matrix that is nearest to a payoff matrix.

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
        Payoff matrix.

    Returns
    -------
    ndarray of float64, shape (n, m)
        The least-squares fit among the matrices that never fall along the pursuers and along the
        evaders, both sorted by their mean capture rate.

    Notes
    -----
    Isotonic regression in both directions by Dykstra's alternating projections. Among transitive
    matrices the mean of a row gives its place in the order.

    References
    ----------
    Dykstra and Robertson (1982), "An algorithm for isotonic regression for two or more independent
    variables", Annals of Statistics 10(3).
    """
    matrix = check_payoff(payoff)
    order = np.ix_(*(np.argsort(matrix.mean(axis=axis), kind="stable") for axis in (1, 0)))
    fit = np.empty_like(matrix)
    fit[order] = _monotone(matrix[order])
    return fit


def cyclic_amplitude(payoff: ArrayLike, noise: ArrayLike, *, level: float = 0.95) -> Measurement:
    """Return the mean square of what no order of strength explains, without episode noise.

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
        Payoff matrix, at least 3 x 3. More than `MOST_GENERATIONS` generations are thinned out.
    noise : array_like of float, shape (n, m)
        Unbiased estimate of the variance of each cell by episode noise.
    level : float, optional
        Confidence level, in (0, 1).

    Returns
    -------
    Measurement
        The *squared* amplitude, in units of the capture rate squared: mean squared residual of
        `transitive_fit` minus the mean noise. It may be negative. `over` and `high` allow for what
        the fit hides.

    Raises
    ------
    ValueError
        If the shapes differ or the matrix is smaller.

    Notes
    -----
    A test of lack of fit against pure error, with an order as the null hypothesis. The residuals of
    a transitive race contain its noise only, and less than all of it: a cell in a level set of b
    cells loses 1/b, since the number of level sets is the degrees of freedom of a monotone fit
    (Meyer and Woodroofe 2000), and sorting by noisy means loses some more. So a transitive race has
    an expected value of 0 or less. The standard error is that of a sum of independent cells. Where
    generations hardly differ in strength their order is chance, and with it the small part of a
    cycle that lies along the order.

    References
    ----------
    Robertson, Wright and Dykstra (1988), "Order restricted statistical inference". Meyer and
    Woodroofe (2000), "On the degrees of freedom in shape-restricted regression", Annals of
    Statistics 28(4).
    """
    matrix, variances = check_payoff(payoff), np.asarray(noise, dtype=np.float64)
    require(min(matrix.shape) >= 3, "at least 3 x 3 generations", matrix.shape)
    require(variances.shape == matrix.shape, f"noise of shape {matrix.shape}", variances.shape)
    matrix, variances = thinned(matrix), thinned(variances)
    fit = transitive_fit(matrix)
    excess = (matrix - fit) ** 2 - variances * (1.0 - _leverages(fit))
    value = float(excess.mean())
    from scipy.special import ndtri

    error = float(np.sqrt((excess**2).sum())) / excess.size
    reach = float(ndtri((1.0 + level) / 2.0)) * error
    over = value + SORTING * sum(matrix.shape) / matrix.size * float(variances.mean())
    return Measurement(value, value - reach, over + reach, over=over)


class NoiseReference(NamedTuple):
    """What a transitive race with the same noise has, at most and at least.

    Parameters
    ----------
    checkerboards : float
        Share of checkerboards that such a race exceeds rarely; NaN below 2 x 2 generations.
    transitive_share : float
        Transitive share below which such a race lies rarely; NaN if it is constant.
    """

    checkerboards: float
    transitive_share: float


def noise_reference(
    scores: ArrayLike, *, margin: float, level: float = 0.95, simulations: int = 100, rng: int = 0
) -> NoiseReference:
    """Simulate how many checkerboards a transitive race has by episode noise alone.

    Parameters
    ----------
    scores : array_like of float, shape (n, m, episodes)
        Capture rate of each episode; at least two episodes of each cell.
    margin : float
        Margin of a checkerboard, in [0, 1).
    level : float, optional
        Share of the simulated races that lie on the usual side, in (0, 1).
    simulations : int, optional
        Number of simulated races.
    rng : int, optional
        Seed.

    Returns
    -------
    NoiseReference
        Quantiles of the simulated races. They help to read the two numbers; `cyclic_amplitude`
        decides whether a race cycles.

    Raises
    ------
    ValueError
        If scores have another shape or are outside [0, 1].

    Notes
    -----
    Parametric bootstrap: `transitive_fit` of the race plus normal noise with the variance of each
    cell's mean.
    """
    array = check_rates(scores, ndim=3, what="scores (n, m, episodes)")
    episodes = array.shape[2]
    require(episodes >= 2, "at least 2 episodes of each cell", episodes)
    fit = transitive_fit(array.mean(axis=2))
    error = array.std(axis=2, ddof=1) / np.sqrt(episodes)
    generator = np.random.default_rng(rng)
    races = [
        np.clip(fit + error * generator.standard_normal(fit.shape), 0.0, 1.0)
        for _ in range(simulations)
    ]
    boards = [checkerboards(race, margin=margin, level=None).share for race in races]
    shares = [transitive_share(race) for race in races]
    return NoiseReference(
        float(np.quantile(boards, level)), float(np.quantile(shares, 1.0 - level))
    )


def thinned(matrix: Rates) -> Rates:
    """Return all generations of each team, or `MOST_GENERATIONS` of them at even distances."""
    kept = (np.linspace(0, size - 1, min(size, MOST_GENERATIONS)) for size in matrix.shape)
    return matrix[np.ix_(*(each.round().astype(np.intp) for each in kept))]


def _leverages(fit: Rates) -> Rates:
    """Return for each cell one over the number of cells that share its value."""
    # Converged values of one level set differ in the last digits only.
    _, member, counts = np.unique(
        np.round(fit / (10 * _CONVERGED)), return_inverse=True, return_counts=True
    )
    shares: Rates = 1.0 / counts[member.reshape(fit.shape)]
    return shares


def _monotone(matrix: Rates) -> Rates:
    """Return the least-squares fit that does not fall along rows and columns."""
    # Dykstra: each projection starts from the last one plus its own correction.
    fit, along_rows, along_columns = matrix, np.zeros_like(matrix), np.zeros_like(matrix)
    for _ in range(ITERATIONS):
        start = fit + along_rows
        half = _isotonic_rows(start)
        along_rows = start - half
        start = half + along_columns
        after = _isotonic_rows(start.T).T
        along_columns = start - after
        change, fit = float(np.abs(after - fit).max()), after
        if change < _CONVERGED:
            break
    return fit


def _isotonic_rows(values: Rates) -> Rates:
    from scipy.optimize import isotonic_regression

    return np.stack([isotonic_regression(row).x for row in values])
