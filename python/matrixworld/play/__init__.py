"""Policies choose actions outside of rollouts, for the environments.

A rollout plays whole episodes inside the engine. Here a team policy chooses the actions of one
moment, from arrays that a `World` or a `Batch` writes. It uses the engine's random numbers, so that
an episode continues as a rollout of the same match does.

==============  ===================================================================================
module          contents
==============  ===================================================================================
draws           the engine's random numbers, by seed, episode, purpose, agent and step
scripts         the scripted policies, for many agents at once
decide          `decide`: the actions of a team
network_policy  `NetworkPolicy`: a genome that acts on observations
matches         `capture_rates`: matches in which functions play
exports         networks for PyTorch and ONNX
==============  ===================================================================================
"""

from __future__ import annotations

from matrixworld.play.decide import MOMENT, Callback, Moment, Plays, check_fits, decide
from matrixworld.play.matches import capture_rates
from matrixworld.play.network_policy import NetworkPolicy

__all__ = [
    "MOMENT",
    "Callback",
    "Moment",
    "NetworkPolicy",
    "Plays",
    "capture_rates",
    "check_fits",
    "decide",
]
