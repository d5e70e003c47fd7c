"""The public names, and where they are; `matrixworld._util.imports.lazy` reads them from here."""

from matrixworld._core import Autoreset as Autoreset
from matrixworld._core import Blame as Blame
from matrixworld._core import Capture as Capture
from matrixworld._core import Interaction as Interaction
from matrixworld._core import Outcome as Outcome
from matrixworld._util import colors as colors
from matrixworld.coevolution import score_policy as score_policy
from matrixworld.envs import aec_env as aec_env
from matrixworld.envs import parallel_env as parallel_env
from matrixworld.envs.single import AgentEnv as AgentEnv
from matrixworld.envs.vector import AgentVectorEnv as AgentVectorEnv
from matrixworld.envs.vector import VectorEnv as VectorEnv
from matrixworld.episodes import replay as replay
from matrixworld.episodes.episode import Episode as Episode
from matrixworld.episodes.record import Recorder as Recorder
from matrixworld.episodes.record import record as record
from matrixworld.episodes.record import record_actions as record_actions
from matrixworld.episodes.safety import SafetyMonitor as SafetyMonitor
from matrixworld.episodes.safety import SafetySummary as SafetySummary
from matrixworld.play import NetworkPolicy as NetworkPolicy
from matrixworld.play.rollout import EpisodeStatistics as EpisodeStatistics
from matrixworld.play.rollout import Matches as Matches
from matrixworld.play.rollout import rollout as rollout
from matrixworld.world import render as render
from matrixworld.world.arrays import array_specs as array_specs
from matrixworld.world.arrays import episode_specs as episode_specs
from matrixworld.world.batch import Batch as Batch
from matrixworld.world.config import WorldConfig as WorldConfig
from matrixworld.world.config import read_map as read_map
from matrixworld.world.conflicts import Conflict as Conflict
from matrixworld.world.policy import SCRIPTS as SCRIPTS
from matrixworld.world.policy import Network as Network
from matrixworld.world.policy import Population as Population
from matrixworld.world.rating import INPUTS as INPUTS
from matrixworld.world.rating import Program as Program
from matrixworld.world.rating import Rating as Rating
from matrixworld.world.rules import COLLISION_KINDS as COLLISION_KINDS
from matrixworld.world.rules import VARIANTS as VARIANTS
from matrixworld.world.rules import Action as Action
from matrixworld.world.rules import Rewards as Rewards
from matrixworld.world.rules import Rules as Rules
from matrixworld.world.world import World as World

from . import analysis as analysis
from . import coevolution as coevolution
from . import envs as envs
from . import episodes as episodes
from . import explorer as explorer
from . import play as play
from . import plots as plots
from . import solve as solve
from . import world as world

__version__: str
