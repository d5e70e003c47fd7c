"""Generalization, and progress against current, past and unknown opponents."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from matrixworld.analysis.payoff import Mask, Rates, check_payoff, require, swap_teams


class Generalization(NamedTuple):
    """Mean payoff of each generation against all opponents of the matrix, in [0, 1].

    Parameters
    ----------
    pursuers : ndarray of float64, shape (n,)
        Mean capture rate: row means of the matrix.
    evaders : ndarray of float64, shape (m,)
        Mean escape rate: one minus column means.
    """

    pursuers: Rates
    evaders: Rates


@dataclass(frozen=True, eq=False)
class TeamProgress:
    """Payoff of one team against one kind of opponents, over its generations 0 to k - 1.

    Parameters
    ----------
    scores : ndarray of float64, shape (..., k)
        Mean payoff of each generation against its opponents, in [0, 1].
    gains : ndarray of float64, shape (..., k - 1)
        Score of generations 1, 2, ... minus the score of the previous generation against the same
        opponents, in [-1, 1].
    """

    scores: Rates
    gains: Rates

    @property
    def mean_gain(self) -> float:
        """Mean of the gains; positive for progress of this kind, NaN for a single generation."""
        return float(self.gains.mean()) if self.gains.size else float("nan")


class Progress(NamedTuple):
    """Progress of both teams, each measured by its own payoff: higher is better.

    Parameters
    ----------
    pursuers : TeamProgress
        Progress of the pursuers, in capture rates.
    evaders : TeamProgress
        Progress of the evaders, in escape rates.
    """

    pursuers: TeamProgress
    evaders: TeamProgress


def generalization(payoff: ArrayLike) -> Generalization:
    """Return the mean payoff of each generation against all opponents of the matrix.

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
        Payoff matrix.

    Returns
    -------
    Generalization
        Row means, and one minus column means.

    References
    ----------
    Floreano and Nolfi (1997), "Adaptive behavior in competing co-evolving species": the master
    tournament. Sun et al. (2023), "MatrixWorld", arXiv:2307.14854: the figure of generalization.
    """
    matrix = check_payoff(payoff)
    return Generalization(matrix.mean(axis=1), 1.0 - matrix.mean(axis=0))


def local_progress(payoff: ArrayLike) -> Progress:
    """Return progress against current opponents: those of the same generation.

    A race that only cycles has local progress, too: each generation beats the newest opponents and
    loses to others.

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
        Payoff matrix.

    Returns
    -------
    Progress
        Over the first ``min(n, m)`` generations. Gain of pursuers g: ``M[g, g] - M[g - 1, g]``.

    References
    ----------
    Miconi (2009), "Why coevolution doesn't 'work': superiority and progress in coevolution".
    Simione and Nolfi (2021), "Long-term progress and behavior complexification in competitive
    coevolution".
    """
    # Later generations of the longer team have no opponent of their own generation.
    matrix = check_payoff(payoff)
    k = min(matrix.shape)
    return _both_teams(matrix[:k, :k], np.eye(k, dtype=bool))


def historical_progress(payoff: ArrayLike) -> Progress:
    """Return progress against all opponents so far: those of the same and of earlier generations.

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
        Payoff matrix.

    Returns
    -------
    Progress
        Gain of pursuers g: mean over ``h <= g`` of ``M[g, h] - M[g - 1, h]``; for evaders the same
        on ``1 - M.T``. Generations of the longer team beyond the end of the shorter one play
        against all of its generations.

    References
    ----------
    Miconi (2009) and Simione and Nolfi (2021), as for `local_progress`.
    """
    matrix = check_payoff(payoff)
    # Square at the longer side, so that the same mask serves the matrix and the swapped one.
    return _both_teams(matrix, np.tri(max(matrix.shape)) > 0.0)


def global_progress(cross: ArrayLike) -> Progress:
    """Return progress against unknown opponents: all opponents of other independent runs.

    A race can make historical progress without global progress if a team learns the habits of its
    own opponents only.

    Parameters
    ----------
    cross : array_like of float, shape (runs, runs, n, m)
        Cross tests: capture rates of the pursuers of run r against the evaders of run s. Entries
        with ``r == s`` are not used and may be NaN.

    Returns
    -------
    Progress
        Scores have the shapes (runs, n) and (runs, m).

    Raises
    ------
    ValueError
        If the shape is another one, there are fewer than two runs, or rates are outside [0, 1].

    References
    ----------
    Miconi (2009) and Simione and Nolfi (2021), as for `local_progress`.
    """
    array = np.asarray(cross)
    require(
        array.ndim == 4 and array.shape[0] == array.shape[1],
        "cross tests of shape (runs, runs, n, m)",
        array.shape,
    )
    runs = len(array)
    require(runs >= 2, "cross tests between at least 2 runs", runs)
    # Opponents of the same run are no unknown opponents: the team has trained against them.
    others = ~np.eye(runs, dtype=bool)
    # Only the entries between different runs are checked; the diagonal may be NaN.
    flat = check_payoff(array[others].reshape(runs * (runs - 1), -1))
    played = np.zeros(array.shape)
    played[others] = flat.reshape(-1, *array.shape[2:])
    # Sum over the other runs (the diagonal holds 0), mean over the generations of their opponents.
    pursuers = played.sum(axis=1).mean(axis=-1) / (runs - 1)
    evaders = 1.0 - played.sum(axis=0).mean(axis=-2) / (runs - 1)
    return Progress(
        TeamProgress(pursuers, np.diff(pursuers, axis=-1)),
        TeamProgress(evaders, np.diff(evaders, axis=-1)),
    )


def _both_teams(matrix: Rates, opponents: Mask) -> Progress:
    """Return progress of both teams; ``opponents[g, h]``: generation g is scored against h."""
    return Progress(_progress(matrix, opponents), _progress(swap_teams(matrix), opponents))


def _progress(matrix: Rates, opponents: Mask) -> TeamProgress:
    rows, columns = matrix.shape
    met = opponents[:rows, :columns]
    weights = met / met.sum(axis=1, keepdims=True)
    scores = (weights * matrix).sum(axis=1)
    # Both generations of a difference are weighted by the opponents of the later one.
    gains = (weights[1:] * np.diff(matrix, axis=0)).sum(axis=1)
    return TeamProgress(scores, gains)
