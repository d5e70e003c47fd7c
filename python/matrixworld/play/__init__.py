"""Policies choose actions outside of rollouts, for the environments.

A rollout plays whole episodes inside the engine. `World.decide` and `Batch.decide` choose the
actions of one moment for a network or a script. Here are the other policies: functions of the
user's own, and genomes that act on observations.

==============  ===================================================================================
module          contents
==============  ===================================================================================
functions       `ask`: the actions that a function chooses
network_policy  `NetworkPolicy`: a genome that acts on observations
matches         `capture_rates`: matches in which functions play
exports         networks for PyTorch and ONNX
==============  ===================================================================================
"""

from __future__ import annotations

from matrixworld.play.functions import Callback, Plays, ask
from matrixworld.play.matches import capture_rates
from matrixworld.play.network_policy import NetworkPolicy, check_fits

__all__ = ["Callback", "NetworkPolicy", "Plays", "ask", "capture_rates", "check_fits"]
