"""matrixworld: pursuit and evasion on a grid, for safe coordination and co-evolution.

==================  ===============================================================================
games               `Rules`, `VARIANTS`, `Rewards`, `WorldConfig`, `read_map`, `Action`
worlds              `World` (one), `Batch` (many)
environments        `parallel_env`, `aec_env` (PettingZoo), `AgentEnv` (one agent, Gymnasium),
                    `VectorEnv` (many worlds at once), `AgentVectorEnv` (many agents at once)
policies, matches   `Network`, `Rating`, `Program`, `INPUTS`, `Population`, `SCRIPTS`, `Matches`,
                    `rollout`, `EpisodeStatistics`, `NetworkPolicy`, `score_policy`
episodes            `record`, `Recorder`, `Episode`; modules `replay`, `render` and `colors`
safety              `SafetyMonitor`, `SafetySummary`, `Conflict`
evolution           packages `coevolution`, `analysis` and `plots`
ground truth        package `solve`
==================  ===============================================================================

Names and packages are imported when they are first used. So are Gymnasium and PettingZoo, in which
the environments are registered as soon as both they and this package have been imported.
"""

from matrixworld._util.imports import ImportedWith, lazy
from matrixworld.version import __version__ as __version__

__getattr__, __dir__, __all__ = lazy(__name__, __file__)

ImportedWith({"gymnasium", "pettingzoo"}, "matrixworld.envs")
