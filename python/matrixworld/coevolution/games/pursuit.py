"""Pursuit and evasion as a game of two populations: a world, and the policies of its teams.

It stands between co-evolution and worlds: besides `games.policies`, and `evaluation`, which plays
against held-out opponents, no module of co-evolution imports `matrixworld.world` or
`matrixworld.play`. What others need of them, such as `WorldConfig` or `Network`, they import from
here.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cache, cached_property
from typing import Any, ClassVar

import numpy as np

from matrixworld._util import sections
from matrixworld._util.checks import shown
from matrixworld._util.constraints import Instance, Whole
from matrixworld._util.sections import HELP, NAMES, Named, SettingError, section, setting
from matrixworld.coevolution.games.game import Game, GameSettings, Scores
from matrixworld.coevolution.games.policies import Cells, PolicySettings
from matrixworld.coevolution.types import (
    BOTH,
    TEAMS,
    FloatArray,
    Genome,
    Genomes,
    Matches,
    Rng,
    Team,
)
from matrixworld.episodes.episode import Episode
from matrixworld.episodes.record import record
from matrixworld.play.experience import Experience as Experience
from matrixworld.play.experience import Reals as Reals
from matrixworld.play.experience import Views as Views
from matrixworld.play.experience import experience
from matrixworld.play.functions import Function
from matrixworld.play.player import Player as Player
from matrixworld.play.player import PythonFile as PythonFile
from matrixworld.play.player import is_path as is_path
from matrixworld.play.player import placed
from matrixworld.play.player import player as player
from matrixworld.play.policies import acting as acting
from matrixworld.play.policies import policy_of as policy_of
from matrixworld.play.rollout import rollout
from matrixworld.world import masks
from matrixworld.world.config import WORLDS
from matrixworld.world.config import WorldConfig as WorldConfig
from matrixworld.world.config import world_name as world_name
from matrixworld.world.policy import CHANNELS as CHANNELS
from matrixworld.world.policy import SCRIPTS as SCRIPTS
from matrixworld.world.policy import Network as Network
from matrixworld.world.policy import Policy, Population, TeamPolicy
from matrixworld.world.program import OPERATIONS as OPERATIONS
from matrixworld.world.program import Program as Program
from matrixworld.world.rules import REWARDS, VARIANTS, Outcome, Rewards, Rules, variant_name
from matrixworld.world.rules import Interaction as Interaction

REWARDED = "rewards"
GUARANTEE = "guarantee"
FITNESS = ("captured-fraction", "capture-rate", REWARDED, GUARANTEE)
"""Measures: of the captured evaders the share averaged over the steps, in which fast captures count
more, or the share at the end, both in [0, 1] (of the evaders 1 minus those of the pursuers); the
rewards summed over the team and the steps (not zero-sum); and the share at the end against the best
response, exactly (`games.guarantee`)."""
BEST_RESPONSE = "best-response"
"""The opponent of a team that learns on what it guarantees: the best that anybody can do."""

WORLD_HELP = {
    "rules": "game variant, a name such as O, or its rules one by one",
    "rows": "rows of the grid; default: those of the world or its map, or 40, in solve 6",
    "cols": "columns of the grid; default: those of the world or its map, or 40, in solve 6",
    "n_pursuers": "number of pursuers; default: depends on rules and command",
    "n_evaders": "number of evaders; default: depends on rules and command",
    "fov": "side of an agent's square field of view, in cells; odd",
    "diagonal": "allow diagonal moves (9 actions instead of 5)",
    "max_steps": "maximum steps of an evaluation episode",
    "obstacles": "obstacles: a density in [0, 1), rows of text, or a MovingAI .map file",
    "rewards": f"rewards: {' or '.join(REWARDS)}, or one by one",
}
"""What the fields of a `WorldConfig` mean in the settings of a run."""


NAMES[WorldConfig] = {name: Named(WorldConfig, fields) for name, fields in WORLDS.items()}
# Rules and rewards without a name begin from the first ones.
NAMES[Rules] = {name: Named(Rules, vars(VARIANTS[name])) for name in ("O", *VARIANTS)}
NAMES[Rewards] = {name: Named(Rewards, vars(rewards)) for name, rewards in REWARDS.items()}
HELP[WorldConfig] = WORLD_HELP


@section("pursuit")
class PursuitSettings(GameSettings):
    """Pursuit and evasion: its world, what decides for agents, and the worlds of training."""

    in_threads: ClassVar[bool] = True

    world: WorldConfig = setting(
        WorldConfig(),
        f"the world; its max_steps are those of evaluation; some have names: {', '.join(WORLDS)}",
    )
    policy: PolicySettings = setting(
        Cells(), f"what decides: {', '.join(sections.names_in(PolicySettings))}"
    )
    train_steps: int = setting(200, "maximum steps of a training episode", Whole(1))
    training_worlds: tuple[WorldConfig, ...] = setting(
        (),
        "worlds in which teams learn, each by what it has other than the world; an epoch plays one "
        "of them, drawn at random; none: they learn in the world",
        Instance(tuple, "a sequence of mappings"),
    )
    training_shares: tuple[int, ...] = setting(
        (), "of how many epochs each training world is one, in the mean; none: of equally many"
    )

    def check(self) -> None:
        """Set training worlds to worlds, of what they have other than `world`.

        SettingError if a world, the mask or the shares do not fit.
        """
        masks.check_mask("policy.mask", self.policy.mask, self.world)
        worlds = tuple(self._training_world(world) for world in self.training_worlds)
        object.__setattr__(self, "training_worlds", worlds)
        if len(self.training_shares) not in (0, len(worlds)):
            expected = f"{len(worlds)} or none"
            raise SettingError("training_shares", expected, str(len(self.training_shares)))

    def _training_world(self, changes: Any) -> WorldConfig:
        """Return a world from what it has other than `world`; SettingError if it does not fit."""
        with sections.below("training_worlds"):
            if isinstance(changes, WorldConfig):
                world = changes
            elif isinstance(changes, str):
                world = self._with(changes)
            elif isinstance(changes, Mapping):
                fields = dict(changes)
                world = self._with(fields.pop("kind", None), **fields)
            else:
                raise SettingError("", "the fields of a world", shown(changes))
            for name in ("rules", "fov", "diagonal"):
                expected = getattr(self.world, name)
                if getattr(world, name) != expected:
                    raise SettingError(name, f"{expected}, as in world", str(getattr(world, name)))
        return world

    def _with(self, name: str | None, **fields: Any) -> WorldConfig:
        """Return the world with other fields, and those of a world with a name."""
        if name is not None and name not in WORLDS:
            raise SettingError("", f"one of {', '.join(WORLDS)}", shown(name))
        usual = {**self.world.to_json(), "max_steps": self.train_steps}
        values = {**usual, **WORLDS.get(name or "", {}), **fields}
        world: WorldConfig = sections.build(WorldConfig, sections.flat(values), WorldConfig)
        return world

    def check_script(self, name: str, player: str) -> None:
        """Raise ValueError for a script that sees too little in this world."""
        masks.check_script(name, player, self.world)

    @property
    def usual_rewards(self) -> bool:
        """Whether the rewards of the world are those of the paper, the default."""
        return self.world.rewards == Rewards()

    def check_learning(self, *, pursuers_learn: bool) -> None:
        """Raise SettingError for a mask with which pursuers that learn could capture nobody."""
        rules = self.world.rules
        if self.policy.mask != "right-of-way" or not pursuers_learn or not rules.captures:
            return
        if not masks.leaves_captures(self.world):
            raise SettingError(
                "policy.mask",
                f"none or obstacles for pursuers whose captures are collisions at fault (capture "
                f"{rules.capture.name}, evader {rules.evader.name}, pursuer {rules.pursuer.name})",
                repr(self.policy.mask),
            )

    @property
    def variant(self) -> str:
        """Name of the variant whose rules these are, or "own-rules"."""
        return variant_name(self.world.rules) or "own-rules"

    @property
    def source(self) -> str:
        """Where the game is found: in the package."""
        return self.kind

    @property
    def keys(self) -> tuple[str, str]:
        """Names of the teams in logs and mappings."""
        return TEAMS

    @property
    def known(self) -> Game:
        """What is known of the game without an import: all of it."""
        return self.evaluation()

    def evaluation(self) -> Pursuit:
        """Return the game as it is evaluated."""
        return Pursuit(world=self.world, settings=self.policy)

    def training(self, *, alone: bool) -> Pursuit:
        """Return the game in which teams learn, with episodes of `train_steps`."""
        world = replace(self.world, max_steps=self.train_steps)
        return Pursuit(
            world=world, settings=self.policy, penalty=overlap_penalty(world, alone=alone)
        )

    def drawn_world(self, rng: Rng) -> WorldConfig:
        """Return the world of an epoch, one of `training_worlds`."""
        shares = self.training_shares or (1,) * len(self.training_worlds)
        return self.training_worlds[rng.choice(len(shares), p=np.divide(shares, sum(shares)))]


OVERLAP_PENALTY = 0.2
"""Penalty of evaders that share a cell. Without one, evaders that may share a cell gather in one
corner. Then pursuers find either no evader or all of them at once, and evaders learn little."""
OVERLAP_PENALTY_ALONE = 0.5
"""The penalty of evaders that learn alone and from untrained genomes."""


def overlap_penalty(world: WorldConfig, *, alone: bool) -> float:
    """Return the penalty of evaders that share a cell; 0 where teammates may not."""
    if world.rules.teammate is not Outcome.REACH:
        return 0.0
    return OVERLAP_PENALTY_ALONE if alone else OVERLAP_PENALTY


@cache
def _opponent(given: str | PythonFile, team: Team) -> Player:
    """Return a player, one for all epochs: it keeps its tables of worlds."""
    return player(given, team)


@dataclass(frozen=True, eq=False)
class Pursuit(Game):
    """Pursuit and evasion: episodes of a `world`, in which both teams have policies of one kind.

    The `settings` are those of the policies. `play` is a pure function with the arguments of
    `matrixworld.rollout`. Evaders that share cells have a `penalty`, multiplied by their overlap.
    """

    play: Any = rollout  # not `Play` of a game of vectors: `scores` calls it otherwise
    genes: Any = ()  # those of the policy: see `genome_size`
    teams: tuple[str, str] = BOTH
    world: WorldConfig = PursuitSettings.world
    settings: PolicySettings = PursuitSettings.policy
    penalty: float = 0.0

    score_words: ClassVar[tuple[str, str]] = ("capture rate", "escape rate")
    single: ClassVar[tuple[str, ...]] = ("length",)
    counters: ClassVar[tuple[str, ...]] = ("steps", "agent_steps")

    def __post_init__(self) -> None:
        """Check nothing: world and settings are checked, and the fields of vectors are not used."""

    @property
    def columns(self) -> Mapping[str, type]:
        """Columns that logs have of an epoch, and their types."""
        rates = ("capture_rate", "length", "pursuer_faults", "evader_faults")
        return {**dict.fromkeys(rates, float), "matches": int, "steps": int}

    @property
    def means(self) -> tuple[str, ...]:
        """What a payoff holds means of."""
        return "collisions", "faults", "agent_steps", "pursuer_survivors", "evader_survivors"

    def genome_size(self, team: Team) -> int:
        """Return the number of genes of a team."""
        return self.policies[team].genome_size

    @cached_property
    def policies(self) -> Mapping[Team, Policy]:
        """The shapes of the teams' policies, if they learn, with their mask."""
        return {team: self.settings.policy(self.world, team) for team in TEAMS}

    def mask(self, team: Team) -> masks.FixedWeights | None:
        """Return genes of a team that do not change, and their values; None without any."""
        return self.settings.fixed(self.world, team)

    def untrained(self, team: Team, rng: Rng) -> Genome:
        """Return a new untrained genome."""
        return self.settings.initial(self.policies[team], rng)

    def population(self, team: Team, genomes: Genomes) -> Population:
        """Return genomes (n, genes) as a population; ValueError unless they are finite."""
        return Population(genomes, self.policies[team])

    def shape_of(self, opponents: TeamPolicy | Player) -> dict[str, Any]:
        """Return what tells the policy of opponents from elsewhere, as JSON holds it."""
        return opponents.policy.to_json() if isinstance(opponents, Population) else {}

    def opponent_named(self, team: Team, name: str) -> TeamPolicy | Player:
        """Return an opponent, who plays for `team`, by what `matrixworld.player` takes as text.

        Genomes and scripts are as the engine plays them. Others are made anew for each world.
        """
        opponent = player(name, team)
        plays = opponent.at(self.world)
        if isinstance(plays, Function):
            plays.check(self.world, team)  # before a run is written
        return plays if isinstance(plays, str | Population) else opponent

    def opponent_kept(self, team: Team, given: Any) -> Population | Player:
        """Return opponents that are given in place of a setting; TypeError if no run can keep them.

        A run goes on in other processes, and needs all of what plays in it.
        """
        plays = placed("opponents", given, team, self.world)
        if isinstance(plays, Population):
            return plays
        opponent = player(given, team)
        if not isinstance(opponent.given, PythonFile):
            raise TypeError(
                f"opponents: expected what a run keeps, genomes or a file of Python, got {opponent}"
            )
        return opponent

    def opponent_without_genomes(
        self, team: Team, name: str, program: Mapping[str, str] | None
    ) -> TeamPolicy | Player:
        """Return the opponent of a run that has kept no genomes of it, but maybe its program."""
        if name in SCRIPTS and program is None:
            return name
        return _opponent(name if program is None else PythonFile(**program), team)

    def opponents(self, team: Team, genomes: Genomes, shape: Mapping[str, Any]) -> Population:
        """Return genomes of opponents that may have policies of another shape."""
        return Population(genomes, policy_of(shape))

    def check_opponents(self, team: Team, opponents: TeamPolicy | Player) -> None:
        """Raise ValueError if opponents, who play for `team`, do not fit the world."""
        if isinstance(opponents, Population):
            opponents.policy.check_fits("opponents", self.world)
            masks.check_team("opponents", opponents, self.world, team)

    def check_start(self, team: Team, population: Population) -> None:
        """Raise ValueError if a genome that a team starts from has another policy."""
        expected, got = self.policies[team], population.policy
        if got != expected:
            raise ValueError(f"start: expected a genome of {expected}, got {got}")

    def rollout(
        self, first: Any, second: Any, matches: Matches, *, episodes: int, threads: int | None
    ) -> Scores:
        """Play M matches; the extras are those of `EpisodeStatistics`."""
        played = self.play(self.world, first, second, matches, episodes=episodes, threads=threads)
        return Scores(played.capture_rate, vars(played))

    def values(self, scores: Scores, team: Team, measure: str, *, raw: bool = False) -> FloatArray:
        """Return what a team is selected by, (M, N), of a measure of `FITNESS`.

        The penalty on evaders that share cells is subtracted, unless `raw`; rewards have penalties
        of their own.
        """
        if measure == REWARDED:
            return np.asarray(scores.extras[f"{team}_return"], dtype=np.float64)
        captured = scores.extras[measure.replace("-", "_")]
        values = Scores(captured).of(team)
        if team == "evader" and not raw:
            overlap = np.asarray(scores.extras["evader_overlap"], dtype=np.float64)
            values = values - self.penalty * overlap
        return values

    def costs(self, scores: Scores, team: Team) -> FloatArray:
        """Return the collisions (M,) at fault of `team` in each match, per 1000 agent-steps."""
        t = TEAMS.index(team)
        # (M, worlds, teams, kinds); a rate over all worlds of a match, as `SafetyMonitor` counts.
        faults = np.asarray(scores.extras["faults"])[:, :, t].sum(axis=(1, 2))
        steps = np.asarray(scores.extras["agent_steps"])[:, :, t].sum(axis=1)
        return np.asarray(1000.0 * faults / np.maximum(steps, 1), dtype=np.float64)

    def row(self, scores: Scores) -> dict[str, float]:
        """Return the values of an epoch in `columns`, without what is counted."""
        # (M, worlds, teams, kinds of collision) -> (teams,)
        faults = scores.extras["faults"].sum(axis=3).mean(axis=(0, 1))
        return {
            "capture_rate": float(scores.scores.mean(dtype=np.float64)),
            "length": float(scores.extras["length"].mean()),
            **{f"{t}_faults": float(n) for t, n in zip(TEAMS, faults, strict=True)},
        }

    def counted(self, scores: Scores) -> dict[str, int]:
        """Return what the matches add to `counters`."""
        return {
            "steps": int(scores.extras["length"].sum()),
            "agent_steps": int(scores.extras["agent_steps"].sum()),
        }

    def experience(self, team: Team, *matches: Any, **options: Any) -> Experience:
        """Play matches again for a learner by gradients; see `matrixworld.play.experience`."""
        return experience(self.world, team, *matches, **options)

    def record(self, pursuers: Any, evaders: Any, **match: Any) -> Episode:
        """Record an episode; see `matrixworld.record`."""
        return record(self.world, pursuers, evaders, **match)
