"""Co-evolution: learners, schedules, races, and the directories they are kept in.

A race in a few lines::

    from matrixworld import coevolution

    settings = coevolution.RaceSettings(schedule="generalist-generalist", seed=1)
    with coevolution.ProgressBar() as bar:
        payoff = coevolution.start(settings, "my-race").run(bar)

``coevolution.resume("my-race").run()`` goes on after an interruption,
``coevolution.finish(settings, "my-race")`` does whatever is left to do, and
``coevolution.open_run("my-race").record(pursuer=30, evader=10)`` plays a match again.

=================  ===============================================================================
settings           what defines a run, with help texts
runs               start and resume; `saved_run` to look at one
race               races in which the teams learn in turns, by `schedules`
hall_of_fame       simultaneous races of two populations
matchmaking            whom the teams of a race meet, and what their archives compare
single             one team against opponents that stand still
tournament         payoff matrices
held_out           opponents that no run has met; `scoring` of a run against them
best_response      what can be taken from a champion, by a response evolved against it
learners           the interface of `evolution_strategy` (with `optimizers`), `genetic_algorithm`
                   and `cma_es`
toolbox            learners as DEAP toolboxes
fitness            from scores to fitness; `sharing` of it where opponents are scarce
opponents          whom to meet: selection among the past, and archives
run_directory      the files of a run (`files`, `lock`, `run_log`)
=================  ===============================================================================

Everything is scored through one pure function with the arguments of `matrixworld.rollout`.
"""

from __future__ import annotations

from matrixworld.coevolution import opponents
from matrixworld.coevolution.evaluation.held_out import held_out
from matrixworld.coevolution.evaluation.held_out_scores import (
    HeldOutScores,
    score,
    score_population,
)
from matrixworld.coevolution.evaluation.tournament import tournament
from matrixworld.coevolution.fitness import (
    FITNESS,
    competitive_sharing,
    fitness,
    reduced_virulence,
)
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
    learner_toolbox,
)
from matrixworld.coevolution.opponents.registry import (
    ALTERNATING,
    HALL_OF_FAME,
    SCHEDULES,
    Schedule,
    available,
)
from matrixworld.coevolution.payoff import Payoff
from matrixworld.coevolution.progress import ProgressBar, Report
from matrixworld.coevolution.runs.alternating import DisengagementWarning, Race
from matrixworld.coevolution.runs.best_response import BestResponse, best_response
from matrixworld.coevolution.runs.hall_of_fame import HallOfFameRace
from matrixworld.coevolution.runs.run import Run
from matrixworld.coevolution.runs.single import SingleTeam
from matrixworld.coevolution.runs.start import finish, resume, start
from matrixworld.coevolution.seeding import evaluation_seed, training_seeds
from matrixworld.coevolution.settings import (
    SINGLE_DEFAULTS,
    RaceSettings,
    SingleSettings,
    TrainingSettings,
)
from matrixworld.coevolution.storage.files import DamagedFileError, OtherVersionError
from matrixworld.coevolution.storage.lock import LockedError
from matrixworld.coevolution.storage.run_directory import RunDirectory
from matrixworld.coevolution.storage.saved_run import SavedRun, last_generation, open_run
from matrixworld.coevolution.types import TEAMS, Team
from matrixworld.rollout import Rollout

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
    "GeneticAlgorithm",
    "HallOfFameRace",
    "HeldOutScores",
    "Individual",
    "Learner",
    "LockedError",
    "Momentum",
    "NoiseTable",
    "OtherVersionError",
    "Payoff",
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
    "Team",
    "TrainingSettings",
    "available",
    "best_response",
    "centred_ranks",
    "competitive_sharing",
    "evaluation_seed",
    "finish",
    "fitness",
    "generate_update_toolbox",
    "held_out",
    "last_generation",
    "learner_toolbox",
    "mate_uniform",
    "mutate_from_table",
    "mutate_gaussian",
    "open_run",
    "opponents",
    "reduced_virulence",
    "resume",
    "score",
    "score_population",
    "select_tournament",
    "select_truncation",
    "start",
    "tournament",
    "training_seeds",
]
