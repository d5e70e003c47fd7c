"""Pursuit and evasion as a game of two populations: a world, and the policies of its teams.

The one module of races, learners and runs that knows worlds and rollouts; scores against held-out
opponents are in `evaluation.scores`.
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from numbers import Real
from typing import Any, ClassVar, TypeAlias

import numpy as np

from matrixworld._util import checks
from matrixworld.coevolution import sections
from matrixworld.coevolution.game import Game, Scores
from matrixworld.coevolution.sections import Section, by_race, setting
from matrixworld.coevolution.types import TEAMS, FloatArray, Genome, Genomes, Matches, Rng, Team
from matrixworld.episodes.episode import Episode
from matrixworld.episodes.record import record
from matrixworld.play.experience import Experience as Experience
from matrixworld.play.experience import Reals as Reals
from matrixworld.play.experience import Views as Views
from matrixworld.play.experience import experience
from matrixworld.play.policies import acting as acting
from matrixworld.play.policies import policy_of as policy_of
from matrixworld.play.rollout import rollout
from matrixworld.world import masks
from matrixworld.world.config import WORLDS
from matrixworld.world.config import WorldConfig as WorldConfig
from matrixworld.world.config import world_name as world_name
from matrixworld.world.policy import CHANNELS as CHANNELS
from matrixworld.world.policy import GATES, Policy, Population, TeamPolicy
from matrixworld.world.policy import SCRIPTS as SCRIPTS
from matrixworld.world.policy import Network as Network
from matrixworld.world.program import OPERATIONS as OPERATIONS
from matrixworld.world.program import Program as Program
from matrixworld.world.rating import INPUTS, Rating
from matrixworld.world.rules import REWARDS, VARIANTS, Outcome, Rules
from matrixworld.world.rules import Interaction as Interaction
from matrixworld.world.rules import Rewards as Rewards
from matrixworld.world.rules import variant_name as variant_name

FITNESS = ("captured-fraction", "capture-rate", "rewards")
"""Measures: of the captured evaders the share averaged over the steps, in which fast captures count
more, or the share at the end, both in [0, 1] (of the evaders 1 minus those of the pursuers); and
the rewards summed over the team and the steps (not zero-sum)."""

WORLD_HELP = {
    "kind": f"a world with a name, from which the other fields differ: {', '.join(WORLDS)}",
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


def _world(plain: Mapping[str, Any]) -> WorldConfig:
    """Return the world of some fields; rules and rewards may be names, or both given one by one."""
    fields = dict(plain)
    sections.check_names(plain, WORLD_HELP)
    if "kind" in fields:
        name = fields.pop("kind")
        checks.check_choice("kind", name, WORLDS)
        is_map = not isinstance(fields.get("obstacles"), Real | None)
        own_size = ("rows", "cols") if is_map else ()
        fields = {**{n: v for n, v in WORLDS[name].items() if n not in own_size}, **fields}
    values = dict(fields)
    rows: Any = (("rules", VARIANTS, "O"), ("rewards", REWARDS, "paper"))
    for row, kinds, usual in rows:
        given = fields.get(row)
        if given is None or isinstance(given, Rules | Rewards):
            continue
        parts = dict(given) if isinstance(given, Mapping) else {"kind": given}
        kind = parts.pop("kind", usual)
        checks.check_choice(row, kind, kinds)
        with sections.inside(row):
            sections.check_names(parts, vars(kinds[kind]))
            values[row] = replace(kinds[kind], **parts)
    return WorldConfig(**values)


sections.PLAIN[WorldConfig] = sections.Plain(_world, WORLD_HELP)


def world_of(other: Any, usual: Mapping[str, Any]) -> WorldConfig:
    """Return a world from what it has other than the `usual` fields, or from its name."""
    if isinstance(other, WorldConfig):
        return other
    changes = {"kind": other} if isinstance(other, str) else other
    if not isinstance(changes, Mapping):
        raise TypeError(f"expected the fields of a world, got {checks.shown(other)}")
    return _world({**usual, **WORLDS.get(changes.get("kind", ""), {}), **changes})


def _mask(default: str, more: str = "") -> Any:
    return setting(
        default,
        "moves that a policy never chooses: obstacles (into an obstacle or the border; needs a "
        "world.fov of 3), right-of-way (all that could put it at fault; needs a world.fov of 5 and "
        f"rules under which pursuers that learn can capture so), or none{more}",
        choices=masks.MASKS,
    )


@sections.section
class PolicySettings(Section):
    """Base of the settings of policies: both teams have policies of the same shape."""

    untrained: ClassVar[Mapping[str, str]] = {}
    """Settings of untrained genomes, by the arguments of `initial` of a policy."""

    mask: str = _mask("none")

    @abstractmethod
    def policy(self, world: WorldConfig) -> Policy:
        """Return the shape of the policies in a world."""

    def initial(self, policy: Any, rng: Rng) -> Genome:
        """Return an untrained genome."""
        scales = {name: getattr(self, field) for name, field in self.untrained.items()}
        genome: Genome = policy.initial(rng, **scales)
        return genome

    def fixed(self, world: WorldConfig, team: Team) -> masks.FixedWeights | None:
        """Return genes that do not change, and their values; None without any."""
        return None


@sections.section
class Cells(PolicySettings):
    """Networks that see the cells of the view."""

    kind: ClassVar[str] = "cells"
    untrained: ClassVar[Mapping[str, str]] = {"weight": "initial_weight", "head": "initial_head"}

    hidden: tuple[int, ...] = by_race((32,), "sizes of the hidden layers")
    activation: str = setting(
        "relu", "activation of the hidden layers: relu or tanh", choices=("relu", "tanh")
    )
    memory: str = setting(
        "none",
        "recurrent layer after the first hidden layer: gru (gated recurrent units) or none",
        choices=tuple(GATES),
    )
    initial_weight: float = by_race(0.05, "standard deviation of untrained hidden weights")
    initial_head: float = by_race(0.1, "standard deviation of untrained output weights")
    mask: str = _mask("none", "; not with every learner")

    def policy(self, world: WorldConfig) -> Network:
        """Return the network, with room for its mask."""
        shape: Any = {"activation": self.activation, "memory": self.memory}
        network = Network.for_config(world, self.hidden, **shape)
        return network if self.mask == "none" else masks.masked_network(network)

    def fixed(self, world: WorldConfig, team: Team) -> masks.FixedWeights | None:
        """Return the weights of the mask of a team's network, None without a mask."""
        if self.mask == "none":
            return None
        cells = masks.forbidding_cells(world, self.mask, team)
        return masks.mask_weights(self.policy(world), cells)


@sections.section
class Ratings(PolicySettings):
    """Small networks that rate each move by named inputs of the cell that it leads to."""

    kind: ClassVar[str] = "rating"
    untrained: ClassVar[Mapping[str, str]] = {"weight": "initial_weight"}

    inputs: tuple[str, ...] = setting(Rating.inputs, f"inputs: some of {', '.join(INPUTS)}")
    hidden: tuple[int, ...] = setting((), "sizes of the hidden layers; none: a weighted sum")
    initial_weight: float = setting(0.5, "standard deviation of untrained weights")
    mask: str = _mask("obstacles")

    def policy(self, world: WorldConfig) -> Rating:
        """Return the shape of the ratings."""
        shape: Any = {"inputs": self.inputs, "hidden": self.hidden, "mask": self.mask}
        return Rating(fov=world.fov, n_actions=world.n_actions, **shape)


@sections.section
class Programs(PolicySettings):
    """Programs that rate each move by named inputs of the cell that it leads to."""

    kind: ClassVar[str] = "program"
    untrained: ClassVar[Mapping[str, str]] = {"depth": "initial_depth"}

    inputs: tuple[str, ...] = setting(Rating.inputs, f"inputs: some of {', '.join(INPUTS)}")
    length: int = setting(40, "most instructions of a program", least=1)
    initial_depth: int = setting(3, "most levels of an untrained program")
    mask: str = _mask("obstacles")

    def policy(self, world: WorldConfig) -> Program:
        """Return the shape of the programs."""
        shape: Any = {"inputs": self.inputs, "length": self.length, "mask": self.mask}
        return Program(fov=world.fov, n_actions=world.n_actions, **shape)


AnyPolicy: TypeAlias = Cells | Ratings | Programs  # the kinds of policies


def check_mask(mask: str, world: WorldConfig, learns: bool) -> None:
    """Raise ValueError unless a mask fits a world; `learns` says whether pursuers do."""
    rules = world.rules
    masks.check_mask("policy.mask", mask, world)
    masked = mask == "right-of-way" and learns and rules.captures
    expected = (
        f"none or obstacles for pursuers whose captures are collisions at fault (capture "
        f"{rules.capture.name}, evader {rules.evader.name}, pursuer {rules.pursuer.name})"
    )
    checks.expect(not masked or masks.leaves_captures(world), "policy.mask", expected, repr(mask))


OVERLAP_PENALTY, OVERLAP_PENALTY_ALONE = 0.2, 0.5
"""Penalties of evaders that share a cell: in general, and of evaders that learn alone and from
untrained genomes. Without one, evaders that may share a cell gather in one corner. Then pursuers
find either no evader or all of them at once, and evaders learn little from it."""


def overlap_penalty(world: WorldConfig, measure: str, alone: bool) -> float:
    """Return the penalty of evaders that share a cell; 0 where teammates may not."""
    if world.rules.teammate is not Outcome.REACH or measure == "rewards":
        return 0.0
    return OVERLAP_PENALTY_ALONE if alone else OVERLAP_PENALTY


check_script = masks.check_script
DEFAULT_WORLD, DEFAULT_POLICY = WorldConfig(), Cells()


@dataclass(frozen=True, eq=False)
class Pursuit(Game):
    """Pursuit and evasion: episodes of a `world`, in which both teams have policies of one shape.

    The `settings` are those of the policies. `play` is a pure function with the arguments of
    `matrixworld.rollout`. Evaders that share cells have a `penalty`, multiplied by their overlap.
    """

    play: Any = rollout
    genes: Any = ()  # those of the policy
    teams: tuple[str, str] = ("pursuers", "evaders")
    world: WorldConfig = DEFAULT_WORLD
    settings: PolicySettings = DEFAULT_POLICY
    penalty: float = 0.0

    columns: ClassVar[Mapping[str, type]] = {
        "capture_rate": float, "length": float, "pursuer_faults": float, "evader_faults": float,
        "matches": int, "steps": int,
    }  # fmt: skip
    score_words: ClassVar[tuple[str, str]] = ("capture rate", "escape rate")
    single: ClassVar[tuple[str, ...]] = ("length",)
    means: ClassVar[tuple[str, ...]] = (
        "collisions", "faults", "agent_steps", "pursuer_survivors", "evader_survivors",
    )  # fmt: skip
    counters: ClassVar[tuple[str, ...]] = ("steps", "agent_steps")

    def __post_init__(self) -> None:
        """Its fields are checked already."""

    def genome_size(self, team: Team) -> int:
        """Return the number of genes of a team."""
        return self.policy.genome_size

    @cached_property
    def policy(self) -> Policy:
        """The shape of the policies of learning teams, with their mask."""
        return self.settings.policy(self.world)

    def mask(self, team: Team) -> masks.FixedWeights | None:
        """Return genes of a team that do not change, and their values; None without any."""
        return self.settings.fixed(self.world, team)

    def untrained(self, team: Team, rng: Rng) -> Genome:
        """Return a new untrained genome."""
        return self.settings.initial(self.policy, rng)

    def population(self, team: Team, genomes: Genomes) -> Population:
        """Return genomes (n, genes) as a population; ValueError unless they are finite."""
        return Population(genomes, self.policy)

    def shape_of(self, opponents: TeamPolicy) -> dict[str, Any]:
        """Return what tells the policy of opponents from elsewhere, as JSON holds it."""
        return {} if isinstance(opponents, str) else opponents.policy.to_json()

    def opponents(self, team: Team, genomes: Genomes, shape: Mapping[str, Any]) -> Population:
        """Return genomes of opponents that may have policies of another shape."""
        return Population(genomes, policy_of(shape))

    def check_opponents(self, team: Team, opponents: TeamPolicy) -> None:
        """Raise ValueError if opponents, who play for `team`, do not fit the world."""
        if isinstance(opponents, Population):
            opponents.policy.check_fits("opponents", self.world)
            masks.check_team("opponents", opponents, self.world, team)

    def check_start(self, population: Population) -> None:
        """Raise ValueError if a genome to start from has another policy."""
        if population.policy != self.policy:
            got = population.policy
            raise ValueError(f"start: expected a genome of {self.policy}, got {got}")

    def scores(
        self, first: Any, second: Any, matches: Matches, *, episodes: int, threads: int | None
    ) -> Scores:
        """Play M matches; the extras are those of `EpisodeStatistics`."""
        played = self.play(self.world, first, second, matches, episodes=episodes, threads=threads)
        return Scores(played.capture_rate, vars(played))

    def values(self, scores: Scores, team: Team, measure: str, *, raw: bool = False) -> FloatArray:
        """Return what a team is selected by, (M, N), of a measure of `FITNESS`.

        The penalty on evaders that share cells is subtracted, unless `raw`.
        """
        if measure == "rewards":
            returns = scores.extras[f"{team}_return"]
            values = np.asarray(returns, dtype=np.float64)
        else:
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
        steps, agent_steps = (scores.extras[name].sum() for name in ("length", "agent_steps"))
        return {"steps": int(steps), "agent_steps": int(agent_steps)}

    def experience(self, team: Team, *matches: Any, **options: Any) -> Experience:
        """Play matches again for a learner by gradients; see `matrixworld.play.experience`."""
        return experience(self.world, team, *matches, **options)

    def record(self, pursuers: TeamPolicy, evaders: TeamPolicy, **match: Any) -> Episode:
        """Record an episode; see `matrixworld.record`."""
        return record(self.world, pursuers, evaders, **match)
