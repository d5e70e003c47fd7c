"""From the scores of matches to the fitness of candidates."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from matrixworld.coevolution.keys import Team
from matrixworld.rollout import Scores

Values = NDArray[np.float64]


def captured_fraction(scores: Scores, team: Team) -> Values:
    """Share of evaders captured, averaged over the steps: fast captures count more. In [0, 1]."""
    captured = np.asarray(scores.captured_fraction, dtype=np.float64)
    return captured if team == "pursuer" else 1.0 - captured


def capture_rate(scores: Scores, team: Team) -> Values:
    """Share of evaders captured at the end of the episode. In [0, 1]."""
    captured = np.asarray(scores.capture_rate, dtype=np.float64)
    return captured if team == "pursuer" else 1.0 - captured


def rewards(scores: Scores, team: Team) -> Values:
    """Rewards summed over the team and the steps (not zero-sum)."""
    returns = scores.pursuer_return if team == "pursuer" else scores.evader_return
    return np.asarray(returns, dtype=np.float64)


FITNESS: dict[str, Callable[[Scores, Team], Values]] = {
    "captured-fraction": captured_fraction,
    "capture-rate": capture_rate,
    "rewards": rewards,
}


def fitness(scores: Scores, team: Team, *, measure: str, crowding: float) -> Values:
    """Return the fitness (M,) of `team` in M matches, averaged over the worlds of each.

    Parameters
    ----------
    scores : of M matches, arrays (M, worlds).
    team : whose fitness.
    measure : key of `FITNESS`. The capture measures are 1 minus for evaders.
    crowding : penalty on evaders that stand on one another's cells, times the crowding in [0, 1].
        Without it, where teammates may share a cell, evaders pile up in one corner: either nobody
        finds them or all are lost at once.
    """
    values = FITNESS[measure](scores, team)
    if team == "evader":
        values = values - crowding * np.asarray(scores.evader_crowding, dtype=np.float64)
    means: Values = values.mean(axis=1)
    return means
