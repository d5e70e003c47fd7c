"""Does a later generation play better, and against whom: ancestors, contemporaries, strangers?"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld.analysis.payoff import Rates, check_payoff, require, swap_teams


class Generalization(NamedTuple):
    """Mean payoff of each generation against all opponents of the matrix, in [0, 1]."""

    pursuers: Rates
    """Shape ``(n,)``: mean capture rate, the row means."""
    evaders: Rates
    """Shape ``(m,)``: mean escape rate, one minus the column means."""


class Forgetting(NamedTuple):
    """How far each generation has dropped below the best of its line so far, in [0, 1]."""

    pursuers: Rates
    """Shape ``(n,)``."""
    evaders: Rates
    """Shape ``(m,)``."""


@dataclass(frozen=True, eq=False)
class TeamProgress:
    """One team's payoff against one kind of opponents, over its generations 0, 1, ..., k - 1."""

    scores: Rates
    """Shape ``(..., k)``, in [0, 1]: mean payoff of each generation against its opponents."""
    gains: Rates
    """Shape ``(..., k - 1)``, in [-1, 1]: what generations 1, 2, ... score more than the generation
    before them scores against the same opponents."""

    @property
    def mean_gain(self) -> float:
        """Mean of the gains; above 0: progress of this kind. NaN for a single generation."""
        return float(self.gains.mean()) if self.gains.size else float("nan")


class Progress(NamedTuple):
    """Progress of both teams, each from its own point of view: higher is better."""

    pursuers: TeamProgress
    evaders: TeamProgress


def generalization(payoff: ArrayLike) -> Generalization:
    """Mean payoff of each generation against all opponents: row means, one minus column means.

    The master tournament of Floreano and Nolfi (1997), and the paper's generalisation figure.
    """
    matrix = check_payoff(payoff)
    return Generalization(matrix.mean(axis=1), 1.0 - matrix.mean(axis=0))


def forgetting(payoff: ArrayLike) -> Forgetting:
    """How far each generation falls below the best of its line so far, averaged over opponents.

    Pursuers of generation g: mean over h of ``max(M[:g + 1, h]) - M[g, h]``; evaders likewise on
    ``1 - M``. Zero where nothing was ever lost. The best of many noisy cells is too high by chance,
    so a few hundredths mean nothing. After Chaudhry et al. (2018), who look at the end only.
    """
    matrix = check_payoff(payoff)
    pursuers = np.maximum.accumulate(matrix, axis=0) - matrix
    evaders = matrix - np.minimum.accumulate(matrix, axis=1)
    return Forgetting(pursuers.mean(axis=1), evaders.mean(axis=0))


def local_progress(payoff: ArrayLike) -> Progress:
    """Progress against current opponents: those of the same generation; ``min(n, m)`` generations.

    Gain of pursuers g: ``M[g, g] - M[g - 1, g]``. A race that only cycles has it, too: each
    generation beats the newest opponents and forgets the others. Miconi (2009); Simione and Nolfi
    (2021).
    """
    matrix = check_payoff(payoff)
    k = min(matrix.shape)
    return _both_teams(matrix[:k, :k], np.eye(k, dtype=bool))


def historical_progress(payoff: ArrayLike) -> Progress:
    """Progress against all opponents so far: those of the same and of all earlier generations.

    Gain of pursuers g: mean over ``h <= g`` of ``M[g, h] - M[g - 1, h]``; evaders likewise on
    ``1 - M.T``. The longer team meets the whole of the shorter one from its end on. Miconi (2009);
    Simione and Nolfi (2021).
    """
    matrix = check_payoff(payoff)
    return _both_teams(matrix, np.tri(max(matrix.shape)) > 0.0)


def global_progress(cross: ArrayLike) -> Progress:
    """Progress against strangers: all opponents of the other independent runs.

    ``cross``, shape ``(runs, runs, n, m)``: capture rates of the pursuers of run r against the
    evaders of run s. Entries with ``r == s`` are not used and may be NaN. Scores are shaped
    ``(runs, n)`` and ``(runs, m)``. A race can make historical progress without it where it learns
    the habits of its own opponents. Miconi (2009); Simione and Nolfi (2021).

    Raises ValueError for another shape, fewer than two runs, rates outside [0, 1].
    """
    array = np.asarray(cross)
    require(
        array.ndim == 4 and array.shape[0] == array.shape[1],
        "cross tests of shape (runs, runs, n, m)",
        array.shape,
    )
    runs = len(array)
    require(runs >= 2, "cross tests between at least 2 runs", runs)
    others = ~np.eye(runs, dtype=bool)
    flat = check_payoff(array[others].reshape(runs * (runs - 1), -1))
    played = np.zeros(array.shape)
    played[others] = flat.reshape(-1, *array.shape[2:])
    pursuers = played.sum(axis=1).mean(axis=-1) / (runs - 1)
    evaders = 1.0 - played.sum(axis=0).mean(axis=-2) / (runs - 1)
    return Progress(
        TeamProgress(pursuers, np.diff(pursuers, axis=-1)),
        TeamProgress(evaders, np.diff(evaders, axis=-1)),
    )


def _both_teams(matrix: Rates, met: NDArray[np.bool_]) -> Progress:
    """``met[g, h]``: generation g is measured against opponents h; large enough for both teams."""
    return Progress(_progress(matrix, met), _progress(swap_teams(matrix), met))


def _progress(matrix: Rates, met: NDArray[np.bool_]) -> TeamProgress:
    rows, columns = matrix.shape
    weights = met[:rows, :columns] / met[:rows, :columns].sum(axis=1, keepdims=True)
    scores = (weights * matrix).sum(axis=1)
    gains = (weights[1:] * np.diff(matrix, axis=0)).sum(axis=1)
    return TeamProgress(scores, gains)
