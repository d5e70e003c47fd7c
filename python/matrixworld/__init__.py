"""matrixworld: pursuit and evasion on a grid, for safe coordination and co-evolution.

==================  ===============================================================================
first calls         `make`, `make_vec`, `evolve`, `open_run`, `judge`, `compare`, `solve`
games               `Rules`, `VARIANTS`, `Rewards`, `WorldConfig`, `WORLDS`, `read_map`, `Action`
worlds              `World` (one), `Batch` (many)
environments        `parallel_env`, `aec_env` (PettingZoo), `AgentEnv` (one agent, Gymnasium),
                    `VectorEnv` (many worlds at once), `AgentVectorEnv` (many agents at once)
policies, matches   `Network`, `Rating`, `Program`, `INPUTS`, `Population`, `SCRIPTS`, `Matches`,
                    `rollout`, `EpisodeStatistics`, `NetworkPolicy`, `score_policy`,
                    `player`, `Player`
episodes            `record`, `Recorder`, `Episode`; modules `replay`, `render` and `colors`
safety              `SafetyMonitor`, `SafetySummary`, `Conflict`
evolution           `Game`, `evolve`, `open_runs`; packages `coevolution`, `analysis`, `plots`
ground truth        package `solver`; `grade`, `Grade`, `SUITE`
==================  ===============================================================================

Names and packages are imported when they are first used. Where Gymnasium or PettingZoo has been
imported before, the environments are registered at once; else ``import matrixworld.envs`` does it.
"""

import sys
from importlib import import_module

from matrixworld._util.imports import lazy
from matrixworld.version import __version__ as __version__

OTHER_NAMES = {
    **dict.fromkeys(("env", "Env", "make_env"), 'mw.make("O")'),
    **dict.fromkeys(("vec_env", "VecEnv"), 'mw.make_vec("O", num_envs=64)'),
    **dict.fromkeys(("train", "run", "race"), 'mw.evolve(variant="O")'),
    **dict.fromkeys(("load", "load_run"), "mw.open_run(directory)"),
    "load_runs": "mw.open_runs(directory)",
    "evaluate": 'mw.score_policy(policy, "pursuer", config, episodes=100)',
    "plot": "mw.plots.payoff_heatmap(run.payoff()) or mw.plots.ciao_triangles(run.payoff())",
}
"""What other libraries call things, and the right calls."""

__getattr__, __dir__, __all__ = lazy(__name__, __file__, OTHER_NAMES)

if {"gymnasium", "pettingzoo"} & sys.modules.keys():
    import_module("matrixworld.envs")
