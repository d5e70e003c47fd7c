"""What connects worlds and runs to other libraries: a module for each, named like the library.

========================  =========================================================================
`stable_baselines3`       `vec_env`, `policy`
`tianshou`                `vector_env`
`openspiel`               `world_game`, `matrix_game`
`minari`                  `to_minari`
`torchrl`                 `env`, and `benchmarl_task` for BenchMARL
`metrics`                 `tensorboard_writer` and `wandb_writer`, which give a callback for
                          `matrixworld.coevolution.finish`
========================  =========================================================================

A library is imported when one of these functions is called. If it is missing, they raise
MissingExtraError, which names the extra of this package that installs it.
"""

from __future__ import annotations

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
