"""What connects worlds and runs to other libraries: a module for each, named like the library.

========================  =========================================================================
`stable_baselines3`       `vec_env`, `policy`
`tianshou`                `vector_env`
`torchrl`                 `env`
`benchmarl`               `task`
`tensorboard`, `wandb`    `epoch_writer`, a callback for `matrixworld.coevolution.finish`
========================  =========================================================================

A library is imported when one of these functions is called. If it is missing, they raise
MissingExtraError, which names the extra of this package that installs it.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from matrixworld.envs.vector import AgentVectorEnv, VectorEnv
from matrixworld.world.config import WorldConfig
from matrixworld.world.rules import Rules

EASY = "clumsy-fleer"
"""What plays the evaders if no team is named: an opponent against which first attempts learn."""


def opponents(settings: dict[str, Any]) -> dict[str, Any]:
    """Return settings of an environment, which plays easy evaders if no team is named."""
    return settings if settings.keys() & {"pursuers", "evaders"} else {**settings, "evaders": EASY}


def agents(
    config: WorldConfig | Rules | str, n_worlds: int, mode: str, settings: dict[str, Any]
) -> AgentVectorEnv:
    """Return the agents of one team as sub-environments, which see flat rows of float32."""
    flat = {"dtype": "float32", "flatten": True, **opponents(settings)}
    return AgentVectorEnv(VectorEnv(config, n_worlds, autoreset_mode=mode, **flat))


def scalars(row: Mapping[str, Any]) -> dict[str, float]:
    """Return what a row of an epoch measures, by names such as ``pursuer/capture_rate``."""
    places = {"run", "seed", "stage", "team", "epoch", "opponent", "matches"}
    return {f"{row['team']}/{key}": value for key, value in row.items() if key not in places}
