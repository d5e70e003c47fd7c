"""Co-evolution of pursuers and evaders: races, learners, opponents, evaluation and storage.

A race in a few lines::

    from matrixworld import coevolution

    with coevolution.ProgressBar() as bar:
        run = coevolution.evolve("O", "my-race", learner="es", seed=1, report=bar)

The same call continues after an interruption. ``coevolution.evolve("O", "my-races", seeds=[1, 2])``
does so for many, side by side. ``coevolution.open_run("my-race").record(pursuer=30, evader=10)``
plays an episode again.

All matches are played by one pure function with the arguments of `matrixworld.rollout`. A race is
its settings and its loop (`race`), a learner its settings and three functions of its state
(`learners`), and so is a sampler of opponents (`opponents`). A `run` is what a loop works with, and
`jobs` play many of them.
"""

from __future__ import annotations

from matrixworld._util.files import DamagedFileError, LockedError
from matrixworld.coevolution import opponents
from matrixworld.coevolution.evaluation.scores import held_out, score, score_policy
from matrixworld.coevolution.evaluation.tournament import tournament
from matrixworld.coevolution.fitness import FitnessSettings
from matrixworld.coevolution.game import Game as Game  # `matrixworld.Game`
from matrixworld.coevolution.game import check_game
from matrixworld.coevolution.groups import Comparison, RunGroup, compare, judge, open_groups
from matrixworld.coevolution.jobs import FailedRunsError, evolve
from matrixworld.coevolution.learners import ActorCritic
from matrixworld.coevolution.learners.cma_es import CmaEs
from matrixworld.coevolution.learners.evolution_strategy import EvolutionStrategy
from matrixworld.coevolution.learners.genetic_algorithm import GeneticAlgorithm
from matrixworld.coevolution.learners.genetic_programming import GeneticProgramming
from matrixworld.coevolution.learners.learner import Learner, Results, Task
from matrixworld.coevolution.own_code import check_learner, check_sampler
from matrixworld.coevolution.progress import Progress, ProgressBar, StopRun
from matrixworld.coevolution.pursuit import Cells, Programs, Pursuit, Ratings
from matrixworld.coevolution.race import SCHEDULES, Against, AtOnce, InTurns, available
from matrixworld.coevolution.run import DisengagementWarning, Run, RunInMemory, create, finish
from matrixworld.coevolution.sections import PluginError
from matrixworld.coevolution.settings import RaceSettings
from matrixworld.coevolution.storage import OtherVersionError, SavedRun, open_run, open_runs
from matrixworld.coevolution.types import TEAMS, Payoff, Team

__all__ = [
    "SCHEDULES",
    "TEAMS",
    "ActorCritic",
    "Against",
    "AtOnce",
    "Cells",
    "CmaEs",
    "Comparison",
    "DamagedFileError",
    "DisengagementWarning",
    "EvolutionStrategy",
    "FailedRunsError",
    "FitnessSettings",
    "GeneticAlgorithm",
    "GeneticProgramming",
    "InTurns",
    "Learner",
    "LockedError",
    "OtherVersionError",
    "Payoff",
    "PluginError",
    "Programs",
    "Progress",
    "ProgressBar",
    "Pursuit",
    "RaceSettings",
    "Ratings",
    "Results",
    "Run",
    "RunGroup",
    "RunInMemory",
    "SavedRun",
    "StopRun",
    "Task",
    "Team",
    "available",
    "check_game",
    "check_learner",
    "check_sampler",
    "compare",
    "create",
    "evolve",
    "finish",
    "held_out",
    "judge",
    "open_groups",
    "open_run",
    "open_runs",
    "opponents",
    "score",
    "score_policy",
    "tournament",
]
