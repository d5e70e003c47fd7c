"""Settings that all runs share: world, policy, learner and budget."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, fields, replace
from enum import Enum
from inspect import cleandoc
from typing import Any, TypeVar, get_type_hints

import numpy as np
from numpy.typing import NDArray

from matrixworld._util.checks import check_choice, check_integer, check_number
from matrixworld.coevolution.fitness import FITNESS
from matrixworld.coevolution.learners.learner import LearnerEntry
from matrixworld.coevolution.learners.masked_network import (
    MASKS,
    FixedWeights,
    mask_weights,
    masked_network,
)
from matrixworld.coevolution.learners.optimizers import OPTIMIZERS
from matrixworld.coevolution.learners.registry import LEARNERS, check_learner_settings
from matrixworld.coevolution.plugins import (
    LEARNER,
    OwnSettings,
    SavedName,
    check_name,
    own_settings,
)
from matrixworld.coevolution.settings.effects import check_effects
from matrixworld.coevolution.types import TEAMS, BoolArray, Team
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import Network
from matrixworld.world.rules import VARIANTS, Capture, Outcome, Rewards, Rules, rules_of

REWARDS = {"paper": Rewards.paper, "published": Rewards.published}
"""Rewards by name."""

Settings = TypeVar("Settings", bound="TrainingSettings")

LEAST_MASKED_FOV = 3
"""A smaller view shows no cell to move to."""
OVERLAP_PENALTY = 0.2
"""Default overlap penalty where teammates may share a cell."""
MOST_SEED = 2**63 - 1
"""Largest seed: the largest integer of 64 bits with a sign."""
NAMES = ("learner", "pursuers_meet", "evaders_meet")
"""Fields that name code, which is not imported to read a run."""
NO_SETTINGS = OwnSettings()
OWN_HELP = "settings of {} if it is one of your own: numbers, text, True or False by name"


def option(default: Any, text: str, *, by_learner: bool = False) -> Any:
    """Return a dataclass field with a default and a help text.

    With `by_learner` the default of the dataclass is None, so that a learner can have another one.
    """
    metadata = {"help": text, "default": default}
    return field(default=None if by_learner else default, metadata=metadata)


def with_parameters(cls: type[Settings]) -> type[Settings]:
    """Add the help texts of the fields to a docstring, as its section of parameters."""
    lines = [cleandoc(cls.__doc__ or ""), "", "Parameters", "----------"]
    for item in fields(cls):
        lines += [f"{item.name} : {item.type}, optional", f"    {item.metadata['help']}"]
    cls.__doc__ = "\n".join(lines)
    return cls


@with_parameters
@dataclass(frozen=True)
class TrainingSettings:
    """World, policy, learner and budget of a run; ValueError or TypeError on a bad field.

    A field that is None takes the value that its learner has for it (`LearnerEntry.defaults`).
    """

    variant: str | Rules = option("O", "game variant: a name in VARIANTS, or Rules")  # noqa: RUF009
    rows: int | None = option(None, "rows of the grid; default: those of the obstacle map, or 40")
    cols: int | None = option(
        None, "columns of the grid; default: those of the obstacle map, or 40"
    )
    pursuers: int | None = option(None, "number of pursuers; default: depends on the variant")
    evaders: int | None = option(None, "number of evaders; default: depends on the variant")
    obstacles: Any = option(  # noqa: RUF009
        None, "obstacles: a density in [0, 1), rows of text, a bool array or a MovingAI .map file"
    )
    fov: int = option(11, "side of an agent's square field of view, in cells; odd")
    diagonal: bool = option(False, "allow diagonal moves (9 actions instead of 5)")

    hidden: tuple[int, ...] = option((32,), "sizes of the policy's hidden layers", by_learner=True)
    activation: str = option("relu", "activation of the hidden layers: relu or tanh")
    initial_weight: float = option(0.05, "standard deviation of untrained hidden weights")
    initial_head: float = option(0.1, "standard deviation of untrained output weights")

    mask: str = option(
        "none",
        "moves that a policy never chooses: obstacles (into an obstacle or the border), occupied "
        "(also to a cell on which it sees an agent), or none",
    )

    learner: str | None = option(
        None,
        f"{', '.join(f'{name} ({entry.title})' for name, entry in LEARNERS.items())}, or one of "
        "your own, as module:object; default: es",
    )
    learner_settings: Mapping[str, Any] = option(NO_SETTINGS, OWN_HELP.format("the learner"))
    population: int = option(48, "candidates (or matches, actor-critic) per epoch", by_learner=True)
    sigma: float = option(0.1, "es: standard deviation of the samples; cma: its initial value")
    optimizer: str = option("adam", f"es: {' or '.join(OPTIMIZERS)}")
    learning_rate: float = option(0.02, "es: learning rate of the optimizer")
    momentum: float = option(0.9, "es: coefficient of the optimizer momentum, in [0, 1)")
    anneal: bool = option(False, "es: reduce the learning rate linearly to a tenth over the run")
    mutation: float = option(0.05, "ga: standard deviation of a mutation")
    crossover: float = option(0.0, "ga: probability that a child has two parents")
    selection: str = option("tournament", "ga: parent selection, tournament or truncation")
    tournament: int = option(5, "ga: individuals in a tournament")
    truncation: float = option(0.25, "ga: share of the population that truncation selects from")
    elites: int = option(2, "ga: fittest individuals kept unchanged")
    elite_episodes: int = option(
        0,
        "ga: new matches of each elite against each of its last opponents at the end of a "
        "generation, which decide the champion; 0: the fitness of the last epoch decides",
    )
    actor_rate: float = option(3e-4, "actor-critic: learning rate of the actor")
    critic_rate: float = option(1e-3, "actor-critic: learning rate of the critic")
    discount: float = option(0.99, "actor-critic: discount factor of rewards (gamma)")
    trace: float = option(0.97, "actor-critic: discount factor of advantages (lambda)")
    actor_updates: int = option(1, "actor-critic: updates of the actor in an epoch")
    critic_updates: int = option(5, "actor-critic: updates of the critic in an epoch")
    clip: float = option(0.0, "actor-critic: clip range of PPO; 0: plain policy gradient")
    entropy: float = option(0.0, "actor-critic: weight of the entropy bonus")
    central_critic: bool = option(False, "actor-critic: let the critic see the whole world")
    cost_rate: float = option(0.05, "actor-critic: learning rate of the multiplier")
    device: str = option("cpu", "actor-critic: device of PyTorch, such as cuda")

    rewards: str = option(
        "paper", f"rewards, for actor-critic and the fitness rewards: {' or '.join(REWARDS)}"
    )
    collision_penalty: float | None = option(
        None,
        "for actor-critic and the fitness rewards: penalty for each kind of collision at fault in "
        "a step; default: 12, as the rewards say",
    )
    cost_limit: float | None = option(
        None,
        "collisions at fault per 1000 agent-steps to stay within: actor-critic approaches it by a "
        "Lagrangian multiplier, other learners rank candidates within it first; default: no limit",
    )
    fitness: str = option("captured-fraction", f"fitness: {', '.join(FITNESS)}")
    overlap_penalty: float | None = option(
        None,
        "penalty on the fitness of evaders that share a cell; default: 0.2 where teammates may "
        "share a cell (0.5 for evaders that learn alone from untrained genomes), else 0",
    )
    train_steps: int = option(200, "maximum steps of a training episode", by_learner=True)
    worlds: int = option(1, "episodes of each training match")
    eval_steps: int = option(500, "maximum steps of an evaluation episode")
    eval_episodes: int = option(10, "evaluation episodes of each pair")
    seed: int = option(0, "seed of the run")

    def __post_init__(self) -> None:
        self._fill({})
        for item in fields(self):
            self._freeze(item.name, _native(getattr(self, item.name)))
        self._check_budget()
        self._check_world()
        self._check_learner()
        # Last: whether a setting has an effect depends on others, which must be valid.
        check_effects(self, self.defaults)

    def _fill(self, own: Mapping[str, Any]) -> None:
        """Set fields that are None to the learner's default, that in `own`, or the usual one."""
        entry = self.built_in_learner
        defaults = {**own, **(entry.defaults if entry else {})}
        for item in fields(self):
            if item.default is None and getattr(self, item.name) is None:
                self._freeze(item.name, defaults.get(item.name, item.metadata["default"]))

    def _freeze(self, name: str, value: Any) -> None:
        # The dataclass is frozen; its own __post_init__ has no other way to set a field.
        object.__setattr__(self, name, value)

    def _check_budget(self) -> None:
        for name in ("train_steps", "worlds", "eval_steps", "eval_episodes"):
            check_integer(name, getattr(self, name), 1)
        check_integer("seed", self.seed, 0, MOST_SEED)
        check_choice("fitness", self.fitness, FITNESS)
        check_choice("rewards", self.rewards, REWARDS)
        for name in ("overlap_penalty", "collision_penalty", "cost_limit"):
            if getattr(self, name) is not None:
                check_number(name, getattr(self, name), least=0.0)

    def _check_learner(self) -> None:
        if self.learner is not None:
            check_name("learner", self.learner, LEARNERS, LEARNER)
        self._freeze("learner_settings", own_settings("learner_settings", self.learner_settings))
        entry = self.built_in_learner
        # A single candidate cannot be compared, but gradients can be computed from its experience.
        check_integer("population", self.population, 1 if entry and entry.by_gradients else 2)
        check_learner_settings(self)

    def _check_world(self) -> None:
        check_number("initial_weight", self.initial_weight, least=0.0)
        check_number("initial_head", self.initial_head, least=0.0)
        # A map is kept as text, so that settings can be compared and saved, and do not depend on
        # the file that it was read from.
        config = self.world(self.train_steps)
        if config.map is not None:
            self._freeze("obstacles", map_as_text(config.map))
        network = Network.for_config(config, hidden=self.hidden, activation=self.activation)
        self._freeze("hidden", network.hidden)
        self._check_mask()

    def _check_mask(self) -> None:
        check_choice("mask", self.mask, MASKS)
        if self.mask != "none" and self.fov < LEAST_MASKED_FOV:
            raise ValueError(
                f"fov: expected at least {LEAST_MASKED_FOV} with the mask {self.mask}, "
                f"got {self.fov}"
            )
        meets = self.rules.capture is Capture.OCCUPATION and "pursuer" in self.learning_teams
        if "adversary" in MASKS[self.mask] and meets:
            raise ValueError(
                f"mask: expected obstacles or none where pursuers capture by entering cells of "
                f"evaders, got {self.mask!r}"
            )

    @property
    def learning_teams(self) -> tuple[Team, ...]:
        """Teams that learn."""
        return TEAMS

    def defaults(self, name: str) -> tuple[Any, ...]:
        """Return the values of a field that count as not given."""
        usual = [item.metadata["default"] for item in fields(self) if item.name == name]
        learners = (entry.defaults for entry in LEARNERS.values())
        return (*usual, *(values[name] for values in learners if name in values))

    @property
    def sharing(self) -> str:
        """Fitness sharing over several opponents; "none" is the mean."""
        return "none"

    def virulence(self, team: Team) -> float | None:
        """Return the reduced virulence of `team`, None for mean fitness."""
        return None

    def world(self, max_steps: int) -> WorldConfig:
        """Return the world's configuration, with episodes of at most `max_steps` steps."""
        if isinstance(self.variant, str):
            check_choice("variant", self.variant, VARIANTS)
        return WorldConfig(
            self.variant,
            rows=self.rows,
            cols=self.cols,
            n_pursuers=self.pursuers,
            n_evaders=self.evaders,
            fov=self.fov,
            diagonal=self.diagonal,
            # A tuple is a map as text; `WorldConfig` takes a list.
            obstacles=list(self.obstacles) if isinstance(self.obstacles, tuple) else self.obstacles,
            rewards=self._rewards,
            max_steps=max_steps,
        )

    @property
    def network(self) -> Network:
        """The policy network of a learning team, with its mask."""
        world = self.world(self.train_steps)
        network = Network.for_config(world, hidden=self.hidden, activation=self.activation)
        return masked_network(network, self.mask)

    def mask_weights(self, team: Team) -> FixedWeights | None:
        """Return the weights of the mask of a team's network, None without a mask."""
        return mask_weights(self.network, self.mask, team)

    def fixed_genes(self, team: Team) -> BoolArray | None:
        """Return which genes (genes,) of a team no learner changes, None for none."""
        weights = self.mask_weights(team)
        return None if weights is None else weights.fixed

    @property
    def _rewards(self) -> Rewards:
        rewards = REWARDS[self.rewards]()
        if self.collision_penalty is None:
            return rewards
        penalty = -self.collision_penalty
        return replace(rewards, pursuer_collide=penalty, evader_collide=penalty)

    @property
    def rules(self) -> Rules:
        """The rules of the variant."""
        return rules_of(self.variant)

    @property
    def learner_name(self) -> str:
        """Name of the learner, with the default filled in."""
        return self.learner or "es"

    @property
    def built_in_learner(self) -> LearnerEntry | None:
        """Registry entry of the learner; None for one from outside the package."""
        # A learner of another type than str is refused later, and cannot be looked up.
        return LEARNERS.get(self.learner_name) if isinstance(self.learner_name, str) else None

    @property
    def resolved_overlap_penalty(self) -> float:
        """The overlap penalty, with the default filled in."""
        if self.overlap_penalty is not None:
            return self.overlap_penalty
        # Without a penalty, evaders that may share a cell gather in one corner.
        may_share = self.rules.teammate is Outcome.REACH and self.fitness != "rewards"
        return self.default_overlap_penalty if may_share else 0.0

    @property
    def default_overlap_penalty(self) -> float:
        """The overlap penalty where teammates may share a cell."""
        return OVERLAP_PENALTY


def _native(value: Any) -> Any:
    """Return a number of NumPy, or of a subclass of int or float, as Python's own."""
    # A bool of NumPy is refused as everywhere.
    if isinstance(value, np.number):
        return value.item()
    kinds = (kind for kind in (bool, int, float) if isinstance(value, kind))
    return next((kind(value) for kind in kinds), value)


def map_as_text(obstacles: NDArray[np.bool_]) -> tuple[str, ...]:
    """Return an obstacle map (rows, cols) as rows of text, '#' obstacle and '.' free."""
    return tuple("".join("#" if cell else "." for cell in row) for row in obstacles)


def settings_to_json(settings: TrainingSettings) -> dict[str, Any]:
    """Return the settings as values that JSON can hold."""
    return {item.name: _plain(getattr(settings, item.name)) for item in fields(settings)}


def settings_from_json(kind: type[Settings], values: dict[str, Any]) -> Settings:
    """Return settings of class `kind`; ValueError names missing and unknown fields.

    Names of learners and samplers are data: nothing is imported.
    """
    expected = {item.name for item in fields(kind)}
    missing, unknown = sorted(expected - set(values)), sorted(set(values) - expected)
    if missing or unknown:
        raise ValueError(f"{kind.__name__}: missing fields {missing}, unknown fields {unknown}")
    return kind(**{name: _restored(name, value) for name, value in values.items()})


def _plain(value: Any) -> Any:
    """Return a value as one that JSON can hold: rules and enums by names."""
    if isinstance(value, Rules):
        return {item.name: _plain(getattr(value, item.name)) for item in fields(value)}
    if isinstance(value, Enum):
        return value.name
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, OwnSettings):
        return dict(value)
    return list(value) if isinstance(value, tuple) else value


def _restored(name: str, value: Any) -> Any:
    """Return the value of a field from what `_plain` returned for it."""
    if name == "variant" and isinstance(value, dict):
        kinds = get_type_hints(Rules)
        return Rules(
            **{
                key: kinds[key][item] if issubclass(kinds[key], Enum) else item
                for key, item in value.items()
            }
        )
    if name in NAMES and isinstance(value, str):
        return SavedName(value)
    return tuple(value) if isinstance(value, list) else value
