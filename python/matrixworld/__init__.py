"""matrixworld: pursuit and evasion on a grid, for safe coordination and co-evolution.

==================  ===============================================================================
games               `Rules`, `VARIANTS`, `Rewards`, `WorldConfig`, `read_map`, `Action`
worlds              `World` (one), `Batch` (many)
environments        `parallel_env`, `aec_env` (PettingZoo), `VectorEnv` (many worlds at once),
                    `AgentVectorEnv` (many agents at once)
policies, matches   `Network`, `Population`, `SCRIPTS`, `Matches`, `rollout`, `EpisodeStatistics`,
                    `NetworkPolicy`, `score_policy`
episodes            `record`, `Recorder`, `Episode`; modules `replay` and `render`
safety              `SafetyMonitor`, `SafetySummary`, `Conflict`
evolution           packages `coevolution` and `analysis`, module `plots`
==================  ===============================================================================
"""

from typing import TYPE_CHECKING, Any

from matrixworld._core import Autoreset, Blame, Capture, Interaction, Outcome
from matrixworld.agent_vector import AgentVectorEnv
from matrixworld.arrays import array_specs, episode_specs
from matrixworld.batch import Batch
from matrixworld.config import WorldConfig
from matrixworld.conflicts import Conflict
from matrixworld.envs import aec_env, parallel_env
from matrixworld.episode import Episode
from matrixworld.maps import read_map
from matrixworld.play import NetworkPolicy
from matrixworld.policy import SCRIPTS, Network, Population
from matrixworld.recorder import Recorder, record, record_actions
from matrixworld.rollout import EpisodeStatistics, Matches, rollout
from matrixworld.rules import KINDS, VARIANTS, Action, Rewards, Rules
from matrixworld.safety import SafetyMonitor, SafetySummary
from matrixworld.seeds import match_seed
from matrixworld.vector import VectorEnv
from matrixworld.version import __version__ as __version__
from matrixworld.world import World

if TYPE_CHECKING:
    from matrixworld.coevolution import score_policy

__all__ = [
    "KINDS",
    "SCRIPTS",
    "VARIANTS",
    "Action",
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
    "episode_specs",
    "match_seed",
    "parallel_env",
    "read_map",
    "record",
    "record_actions",
    "rollout",
    "score_policy",
]


def __getattr__(name: str) -> Any:
    # Co-evolution takes longer to import than all the rest, so it waits for its first use.
    if name == "score_policy":
        from matrixworld.coevolution import score_policy

        return score_policy
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
