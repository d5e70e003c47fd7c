"""The public names, and where they are; `matrixworld._util.imports.lazy` reads them from here."""

from matrixworld._util.files import DamagedFileError as DamagedFileError
from matrixworld._util.files import LockedError as LockedError
from matrixworld._util.plugins import PluginError as PluginError
from matrixworld._util.sections import SettingError as SettingError
from matrixworld.coevolution.comparison import Comparison as Comparison
from matrixworld.coevolution.comparison import compare as compare
from matrixworld.coevolution.comparison import judge as judge
from matrixworld.coevolution.evaluation.held_out import held_out as held_out
from matrixworld.coevolution.evaluation.policy_scores import score_policy as score_policy
from matrixworld.coevolution.evaluation.scores import score as score
from matrixworld.coevolution.games.check import check_game as check_game
from matrixworld.coevolution.games.draws import uniforms as uniforms
from matrixworld.coevolution.games.game import Game as Game
from matrixworld.coevolution.games.policies import Cells as Cells
from matrixworld.coevolution.games.policies import Programs as Programs
from matrixworld.coevolution.games.policies import Ratings as Ratings
from matrixworld.coevolution.games.pursuit import Pursuit as Pursuit
from matrixworld.coevolution.games.pursuit import PursuitSettings as PursuitSettings
from matrixworld.coevolution.games.toolbox import by_toolbox as by_toolbox
from matrixworld.coevolution.games.tournament import tournament as tournament
from matrixworld.coevolution.groups import RunGroup as RunGroup
from matrixworld.coevolution.groups import open_groups as open_groups
from matrixworld.coevolution.jobs.play import FailedRunsError as FailedRunsError
from matrixworld.coevolution.jobs.play import evolve as evolve
from matrixworld.coevolution.learners import ActorCritic as ActorCritic
from matrixworld.coevolution.learners.breeding import Breeding as Breeding
from matrixworld.coevolution.learners.cma_es import CmaEs as CmaEs
from matrixworld.coevolution.learners.evolution_strategy import (
    EvolutionStrategy as EvolutionStrategy,
)
from matrixworld.coevolution.learners.genetic_algorithm import GeneticAlgorithm as GeneticAlgorithm
from matrixworld.coevolution.learners.genetic_programming import (
    GeneticProgramming as GeneticProgramming,
)
from matrixworld.coevolution.learners.learner import Evolutionary as Evolutionary
from matrixworld.coevolution.learners.learner import Learner as Learner
from matrixworld.coevolution.learners.learner import Results as Results
from matrixworld.coevolution.learners.learner import Task as Task
from matrixworld.coevolution.learners.promises import check_learner as check_learner
from matrixworld.coevolution.learners.promises import check_sampler as check_sampler
from matrixworld.coevolution.progress import Progress as Progress
from matrixworld.coevolution.progress import ProgressBar as ProgressBar
from matrixworld.coevolution.progress import StopRun as StopRun
from matrixworld.coevolution.runs.create import create as create
from matrixworld.coevolution.runs.play import DisengagementWarning as DisengagementWarning
from matrixworld.coevolution.runs.play import Run as Run
from matrixworld.coevolution.runs.stored_files import OtherVersionError as OtherVersionError
from matrixworld.coevolution.saved_run import SavedRun as SavedRun
from matrixworld.coevolution.saved_run import finish as finish
from matrixworld.coevolution.saved_run import open_run as open_run
from matrixworld.coevolution.saved_run import open_runs as open_runs
from matrixworld.coevolution.settings.race_settings import RaceSettings as RaceSettings
from matrixworld.coevolution.settings.race_settings import default_race as default_race
from matrixworld.coevolution.settings.schedules import SCHEDULES as SCHEDULES
from matrixworld.coevolution.settings.schedules import Against as Against
from matrixworld.coevolution.settings.schedules import AtOnce as AtOnce
from matrixworld.coevolution.settings.schedules import InTurns as InTurns
from matrixworld.coevolution.training.loops import available as available
from matrixworld.coevolution.training.loops import train as train
from matrixworld.coevolution.training.training import Training as Training
from matrixworld.coevolution.types import TEAMS as TEAMS
from matrixworld.coevolution.types import Payoff as Payoff
from matrixworld.coevolution.types import Team as Team

from . import opponents as opponents
