"""The public names, and where they are; `matrixworld._util.imports.lazy` reads them from here."""

from matrixworld._util.files import DamagedFileError as DamagedFileError
from matrixworld._util.files import LockedError as LockedError
from matrixworld.coevolution.evaluation.scores import held_out as held_out
from matrixworld.coevolution.evaluation.scores import score as score
from matrixworld.coevolution.evaluation.scores import score_policy as score_policy
from matrixworld.coevolution.evaluation.tournament import tournament as tournament
from matrixworld.coevolution.fitness import FitnessSettings as FitnessSettings
from matrixworld.coevolution.game import Game as Game
from matrixworld.coevolution.game import check_game as check_game
from matrixworld.coevolution.groups import Comparison as Comparison
from matrixworld.coevolution.groups import RunGroup as RunGroup
from matrixworld.coevolution.groups import compare as compare
from matrixworld.coevolution.groups import judge as judge
from matrixworld.coevolution.groups import open_groups as open_groups
from matrixworld.coevolution.jobs import FailedRunsError as FailedRunsError
from matrixworld.coevolution.jobs import evolve as evolve
from matrixworld.coevolution.learners import ActorCritic as ActorCritic
from matrixworld.coevolution.learners.cma_es import CmaEs as CmaEs
from matrixworld.coevolution.learners.evolution_strategy import (
    EvolutionStrategy as EvolutionStrategy,
)
from matrixworld.coevolution.learners.genetic_algorithm import GeneticAlgorithm as GeneticAlgorithm
from matrixworld.coevolution.learners.genetic_programming import (
    GeneticProgramming as GeneticProgramming,
)
from matrixworld.coevolution.learners.learner import Learner as Learner
from matrixworld.coevolution.learners.learner import Results as Results
from matrixworld.coevolution.learners.learner import Task as Task
from matrixworld.coevolution.own_code import check_learner as check_learner
from matrixworld.coevolution.own_code import check_sampler as check_sampler
from matrixworld.coevolution.progress import Progress as Progress
from matrixworld.coevolution.progress import ProgressBar as ProgressBar
from matrixworld.coevolution.progress import StopRun as StopRun
from matrixworld.coevolution.pursuit import Cells as Cells
from matrixworld.coevolution.pursuit import Programs as Programs
from matrixworld.coevolution.pursuit import Pursuit as Pursuit
from matrixworld.coevolution.pursuit import Ratings as Ratings
from matrixworld.coevolution.race import SCHEDULES as SCHEDULES
from matrixworld.coevolution.race import Against as Against
from matrixworld.coevolution.race import AtOnce as AtOnce
from matrixworld.coevolution.race import InTurns as InTurns
from matrixworld.coevolution.race import available as available
from matrixworld.coevolution.run import DisengagementWarning as DisengagementWarning
from matrixworld.coevolution.run import Run as Run
from matrixworld.coevolution.run import RunInMemory as RunInMemory
from matrixworld.coevolution.run import create as create
from matrixworld.coevolution.run import finish as finish
from matrixworld.coevolution.sections import PluginError as PluginError
from matrixworld.coevolution.settings import RaceSettings as RaceSettings
from matrixworld.coevolution.settings import default_race as default_race
from matrixworld.coevolution.storage import OtherVersionError as OtherVersionError
from matrixworld.coevolution.storage import SavedRun as SavedRun
from matrixworld.coevolution.storage import open_run as open_run
from matrixworld.coevolution.storage import open_runs as open_runs
from matrixworld.coevolution.types import TEAMS as TEAMS
from matrixworld.coevolution.types import Payoff as Payoff
from matrixworld.coevolution.types import Team as Team

from . import opponents as opponents
