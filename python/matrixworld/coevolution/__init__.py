"""Co-evolution of pursuers and evaders: races, learners, opponents, evaluation and storage.

A race in a few lines::

    from matrixworld import coevolution

    settings = coevolution.RaceSettings(schedule="generalist-generalist", learner="es", seed=1)
    with coevolution.ProgressBar() as bar:
        payoff = coevolution.start(settings, "my-race").run(bar)

``coevolution.resume("my-race").run()`` continues after an interruption.
``coevolution.finish(settings, "my-race")`` starts or continues the race, whichever is needed.
``coevolution.evolve([settings, ...], "my-races")`` does so for many, side by side.
``coevolution.open_run("my-race").record(pursuer=30, evader=10)`` plays an episode again.

All matches are played by one pure function with the arguments of `matrixworld.rollout`. `jobs` play
many `runs`; these train, save what they learn (`storage`) and end with an `evaluation`.
"""

from __future__ import annotations

from matrixworld._util.files import DamagedFileError, LockedError
from matrixworld.coevolution import opponents
from matrixworld.coevolution.evaluation.map_scores import (
    MapScores,
    held_out_maps,
    score_on_maps,
)
from matrixworld.coevolution.evaluation.scores import held_out, score, score_policy
from matrixworld.coevolution.evaluation.tournament import tournament
from matrixworld.coevolution.fitness import competitive_sharing, reduced_virulence
from matrixworld.coevolution.groups import RunGroup, open_groups
from matrixworld.coevolution.jobs import FailedRunsError, evolve
from matrixworld.coevolution.learners.cma_es import CmaEs
from matrixworld.coevolution.learners.evolution_strategy import EvolutionStrategy
from matrixworld.coevolution.learners.genetic_algorithm import GeneticAlgorithm
from matrixworld.coevolution.learners.learner import Learner, NoiseTable
from matrixworld.coevolution.learners.toolbox import generate_update_toolbox
from matrixworld.coevolution.own_code import PluginError, check_learner, check_sampler
from matrixworld.coevolution.progress import OnEpoch, Progress, ProgressBar, StopRun
from matrixworld.coevolution.responses import best_responses
from matrixworld.coevolution.runs import finish, resume, start
from matrixworld.coevolution.runs.race import DisengagementWarning, Race
from matrixworld.coevolution.runs.run import Run
from matrixworld.coevolution.runs.single import SingleTeam
from matrixworld.coevolution.schedules import (
    SCHEDULES,
    Against,
    Alternating,
    Maps,
    OwnOpponents,
    Simultaneous,
    Yoked,
    available,
)
from matrixworld.coevolution.settings import (
    FitnessSettings,
    OwnLearnerSettings,
    PolicySettings,
    RaceSettings,
)
from matrixworld.coevolution.storage import (
    OtherVersionError,
    SavedRun,
    open_run,
    open_runs,
)
from matrixworld.coevolution.types import TEAMS, Payoff, Team

__all__ = [
    "SCHEDULES",
    "TEAMS",
    "Against",
    "Alternating",
    "CmaEs",
    "DamagedFileError",
    "DisengagementWarning",
    "EvolutionStrategy",
    "FailedRunsError",
    "FitnessSettings",
    "GeneticAlgorithm",
    "Learner",
    "LockedError",
    "MapScores",
    "Maps",
    "NoiseTable",
    "OnEpoch",
    "OtherVersionError",
    "OwnLearnerSettings",
    "OwnOpponents",
    "Payoff",
    "PluginError",
    "PolicySettings",
    "Progress",
    "ProgressBar",
    "Race",
    "RaceSettings",
    "Run",
    "RunGroup",
    "SavedRun",
    "Simultaneous",
    "SingleTeam",
    "StopRun",
    "Team",
    "Yoked",
    "available",
    "best_responses",
    "check_learner",
    "check_sampler",
    "competitive_sharing",
    "evolve",
    "finish",
    "generate_update_toolbox",
    "held_out",
    "held_out_maps",
    "open_groups",
    "open_run",
    "open_runs",
    "opponents",
    "reduced_virulence",
    "resume",
    "score",
    "score_on_maps",
    "score_policy",
    "start",
    "tournament",
]
