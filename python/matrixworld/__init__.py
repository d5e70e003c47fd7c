"""matrixworld: pursuit and evasion on a grid, for safe coordination and co-evolution.

==================  ===============================================================================
games               `Rules`, `VARIANTS`, `Rewards`, `WorldConfig`, `read_map`, `Action`
worlds              `World` (one), `Batch` (many)
environments        `parallel_env`, `aec_env` (PettingZoo), `AgentEnv` (one agent, Gymnasium),
                    `VectorEnv` (many worlds at once), `AgentVectorEnv` (many agents at once)
policies, matches   `Network`, `Population`, `SCRIPTS`, `Matches`, `rollout`, `EpisodeStatistics`,
                    `NetworkPolicy`, `score_policy`
episodes            `record`, `Recorder`, `Episode`; modules `replay`, `render` and `colors`
safety              `SafetyMonitor`, `SafetySummary`, `Conflict`
evolution           packages `coevolution` and `analysis`, module `plots`
ground truth        package `solve`
==================  ===============================================================================
"""

from typing import TYPE_CHECKING, Any

from matrixworld._core import Autoreset, Blame, Capture, Interaction, Outcome
from matrixworld._util import colors
from matrixworld.envs import aec_env, parallel_env
from matrixworld.envs.agent import AgentEnv
from matrixworld.envs.vector import AgentVectorEnv, VectorEnv
from matrixworld.episodes import render, replay
from matrixworld.episodes.episode import Episode
from matrixworld.episodes.record import Recorder, record, record_actions
from matrixworld.episodes.safety import SafetyMonitor, SafetySummary
from matrixworld.play import NetworkPolicy
from matrixworld.play.rollout import EpisodeStatistics, Matches, rollout
from matrixworld.version import __version__ as __version__
from matrixworld.world.arrays import array_specs, episode_specs
from matrixworld.world.batch import Batch
from matrixworld.world.config import WorldConfig
from matrixworld.world.conflicts import Conflict
from matrixworld.world.maps import read_map
from matrixworld.world.policy import SCRIPTS, Network, Population
from matrixworld.world.rules import COLLISION_KINDS, VARIANTS, Action, Rewards, Rules
from matrixworld.world.world import World

if TYPE_CHECKING:
    from matrixworld.coevolution import score_policy

__all__ = [
    "COLLISION_KINDS",
    "SCRIPTS",
    "VARIANTS",
    "Action",
    "AgentEnv",
    "AgentVectorEnv",
    "Autoreset",
    "Batch",
    "Blame",
    "Capture",
    "Conflict",
    "Episode",
    "EpisodeStatistics",
    "Interaction",
    "Matches",
    "Network",
    "NetworkPolicy",
    "Outcome",
    "Population",
    "Recorder",
    "Rewards",
    "Rules",
    "SafetyMonitor",
    "SafetySummary",
    "VectorEnv",
    "World",
    "WorldConfig",
    "aec_env",
    "array_specs",
    "colors",
    "episode_specs",
    "parallel_env",
    "read_map",
    "record",
    "record_actions",
    "render",
    "replay",
    "rollout",
    "score_policy",
]


def __getattr__(name: str) -> Any:
    # Co-evolution takes longer to import than all the rest, so it waits for its first use.
    if name == "score_policy":
        from matrixworld.coevolution import score_policy

        return score_policy
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
