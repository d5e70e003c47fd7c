"""Co-evolution of pursuers and evaders: races, learners, opponents, evaluation and storage.

A race in a few lines::

    from matrixworld import coevolution

    settings = coevolution.RaceSettings(schedule="generalist-generalist", seed=1)
    with coevolution.ProgressBar() as bar:
        payoff = coevolution.start(settings, "my-race").run(bar)

``coevolution.resume("my-race").run()`` continues after an interruption.
``coevolution.finish(settings, "my-race")`` starts or continues the race, whichever is needed.
``coevolution.evolve([settings, ...], "my-races")`` does so for many, side by side.
``coevolution.open_run("my-race").record(pursuer=30, evader=10)`` plays an episode again.

====================  ============================================================================
package or module     contents
====================  ============================================================================
jobs                  runs that are asked for together, side by side or on other machines
runs                  races and other runs: training, checkpoints, evaluation at the end
evaluation            payoff matrices, and scores against held-out opponents
storage               run directories, to write and to read
settings              everything that defines a run, with help texts
learners              evolution strategy, genetic algorithm, CMA-ES; as DEAP toolboxes, too
opponents             opponent samplers, archives, and the schedules of races
fitness               from the results of matches to the fitness of candidates
conformance           checks of a learner or sampler of your own
plugins               learners and samplers from outside the package; `plugin_checks`
progress              progress bars
payoff                `Payoff`: results of two archives against each other
seeding               seeds of matches and random generators
types                 teams, and names for arrays
====================  ============================================================================

All matches are played by one pure function with the arguments of `matrixworld.rollout`. Each
package imports only from those below it in the table.
"""

from __future__ import annotations

from matrixworld._util.files import DamagedFileError, LockedError
from matrixworld.coevolution import opponents
from matrixworld.coevolution.conformance import check_learner, check_sampler
from matrixworld.coevolution.evaluation.held_out import held_out
from matrixworld.coevolution.evaluation.scores import (
    HeldOutScores,
    score,
    score_policy,
    score_population,
    scores_in_race,
)
from matrixworld.coevolution.evaluation.tournament import tournament
from matrixworld.coevolution.fitness import (
    FITNESS,
    competitive_sharing,
    fitness,
    reduced_virulence,
)
from matrixworld.coevolution.jobs.best_responses import best_responses
from matrixworld.coevolution.jobs.evolve import FailedRunsError, evolve
from matrixworld.coevolution.jobs.worker import StoppedError, WorkerDiedError
from matrixworld.coevolution.learners.cma_es import CmaEs
from matrixworld.coevolution.learners.evolution_strategy import EvolutionStrategy, centred_ranks
from matrixworld.coevolution.learners.genetic_algorithm import (
    GeneticAlgorithm,
    mate_uniform,
    mutate_from_table,
    mutate_gaussian,
    select_tournament,
    select_truncation,
)
from matrixworld.coevolution.learners.learner import Learner
from matrixworld.coevolution.learners.noise import NoiseTable
from matrixworld.coevolution.learners.optimizers import Adam, Momentum
from matrixworld.coevolution.learners.toolbox import (
    Candidates,
    Individual,
    generate_update_toolbox,
)
from matrixworld.coevolution.opponents.registry import (
    ALTERNATING,
    HALL_OF_FAME,
    SCHEDULES,
    Schedule,
    available,
)
from matrixworld.coevolution.payoff import Payoff
from matrixworld.coevolution.plugin_checks import PluginError
from matrixworld.coevolution.progress import Progress, ProgressBar, Report
from matrixworld.coevolution.runs.alternating import DisengagementWarning, Race
from matrixworld.coevolution.runs.best_response import BestResponse, best_response
from matrixworld.coevolution.runs.hall_of_fame import HallOfFameRace
from matrixworld.coevolution.runs.run import Run
from matrixworld.coevolution.runs.single import SingleTeam
from matrixworld.coevolution.runs.start import check_own_code, finish, resume, start
from matrixworld.coevolution.seeding import evaluation_seed, training_seeds
from matrixworld.coevolution.settings.effects import NoEffectError
from matrixworld.coevolution.settings.race import RaceSettings
from matrixworld.coevolution.settings.single import SINGLE_DEFAULTS, SingleSettings
from matrixworld.coevolution.settings.training import TrainingSettings
from matrixworld.coevolution.storage.run_directory import OtherVersionError, RunDirectory
from matrixworld.coevolution.storage.saved_run import (
    SavedRun,
    last_generation,
    open_run,
    open_runs,
)
from matrixworld.coevolution.types import TEAMS, Team
from matrixworld.play.rollout import Rollout

__all__ = [
    "ALTERNATING",
    "FITNESS",
    "HALL_OF_FAME",
    "SCHEDULES",
    "SINGLE_DEFAULTS",
    "TEAMS",
    "Adam",
    "BestResponse",
    "Candidates",
    "CmaEs",
    "DamagedFileError",
    "DisengagementWarning",
    "EvolutionStrategy",
    "FailedRunsError",
    "GeneticAlgorithm",
    "HallOfFameRace",
    "HeldOutScores",
    "Individual",
    "Learner",
    "LockedError",
    "Momentum",
    "NoEffectError",
    "NoiseTable",
    "OtherVersionError",
    "Payoff",
    "PluginError",
    "Progress",
    "ProgressBar",
    "Race",
    "RaceSettings",
    "Report",
    "Rollout",
    "Run",
    "RunDirectory",
    "SavedRun",
    "Schedule",
    "SingleSettings",
    "SingleTeam",
    "StoppedError",
    "Team",
    "TrainingSettings",
    "WorkerDiedError",
    "available",
    "best_response",
    "best_responses",
    "centred_ranks",
    "check_learner",
    "check_own_code",
    "check_sampler",
    "competitive_sharing",
    "evaluation_seed",
    "evolve",
    "finish",
    "fitness",
    "generate_update_toolbox",
    "held_out",
    "last_generation",
    "mate_uniform",
    "mutate_from_table",
    "mutate_gaussian",
    "open_run",
    "open_runs",
    "opponents",
    "reduced_virulence",
    "resume",
    "score",
    "score_policy",
    "score_population",
    "scores_in_race",
    "select_tournament",
    "select_truncation",
    "start",
    "tournament",
    "training_seeds",
]
