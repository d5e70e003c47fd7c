"""Settings: everything that defines a run. Runs with equal settings are equal bit for bit.

The number of threads is not a setting, because results do not depend on it.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import Field, dataclass, fields, replace
from functools import partial
from inspect import signature
from typing import Any

import numpy as np

from matrixworld._util.checks import (
    EPISODE_BYTES,
    PAYOFF_BYTES,
    OutOfMemoryError,
    available_memory,
    check_memory,
)
from matrixworld.coevolution.fitness import FITNESS, LEAST_VIRULENCE, SHARING
from matrixworld.coevolution.learners import BuiltInLearner
from matrixworld.coevolution.learners.evolution_strategy import EvolutionStrategySettings
from matrixworld.coevolution.learners.learner import (
    Learner,
    LearnerSettings,
    Task,
    table_length,
)
from matrixworld.coevolution.learners.masked_network import (
    FixedWeights,
    mask_weights,
    masked_network,
)
from matrixworld.coevolution.own_code import LEARNER, find, made
from matrixworld.coevolution.schedules import (
    SCHEDULES,
    Against,
    Alternating,
    Maps,
    Simultaneous,
    Yoked,
)
from matrixworld.coevolution.sections import (
    OwnCode,
    Section,
    by_path,
    documented,
    inside,
    kinds_in,
    merged,
    setting,
)
from matrixworld.coevolution.seeding import Purpose, keyed_generator
from matrixworld.coevolution.types import TEAMS, Genomes, Team
from matrixworld.world.config import WorldConfig
from matrixworld.world.masks import (
    MASKS,
    check_mask,
    check_script,
    forbidding_cells,
    leaves_captures,
)
from matrixworld.world.policy import GATES, Network
from matrixworld.world.rules import Outcome, Rewards, variant_name

OVERLAP_PENALTY, OVERLAP_PENALTY_ALONE = 0.2, 0.5
"""Default overlap penalties where teammates may share a cell: in general, and of evaders that learn
alone and from untrained genomes."""
MOST_SEED = 2**63 - 1
"""Largest seed: the largest integer of 64 bits with a sign."""
REDUCED = {
    "candidates": "policy.hidden or learner.population",
    "archive": "policy.hidden or schedule.generations",
    "noise": "policy.hidden",
    "episodes": "schedule.generations or evaluation_episodes",
    "views": "train_steps or match_episodes",
}
"""Which settings make the largest array of a run smaller."""
COPIES = 4
"""Of candidates: samples or parents and children of both teams. Of views: for actor and critic."""


@documented
@dataclass(frozen=True)
class PolicySettings(Section):
    """Settings of the policy networks: both teams have one of the same shape."""

    hidden: tuple[int, ...] = setting(
        (32,), "sizes of the hidden layers", by={"gradients": (400, 300)}
    )
    activation: str = setting(
        "relu", "activation of the hidden layers: relu or tanh", choices=("relu", "tanh")
    )
    memory: str = setting(
        "none",
        "recurrent layer after the first hidden layer: gru (gated recurrent units) or none",
        choices=tuple(GATES),
    )
    initial_weight: float = setting(
        0.05, "standard deviation of untrained hidden weights", by={"against pursuer": 0.2}
    )
    initial_head: float = setting(
        0.1, "standard deviation of untrained output weights", by={"against pursuer": 0.09}
    )
    mask: str = setting(
        "none",
        "moves that a policy never chooses: obstacles (into an obstacle or the border; needs a "
        "world.fov of 3), right-of-way (all that could put it at fault; needs a world.fov of 5 and "
        "rules under which pursuers that learn can capture so), or none; not with every learner",
        choices=MASKS,
    )


@documented
@dataclass(frozen=True)
class FitnessSettings(Section):
    """What candidates are selected by."""

    measure: str = setting("captured-fraction", f"one of {', '.join(FITNESS)}", choices=FITNESS)
    overlap_penalty: float | None = setting(
        None,
        "penalty of evaders that share a cell; default: 0.2 where teammates may share a cell (0.5 "
        "for evaders that learn alone from untrained genomes), else 0",
    )
    cost_limit: float | None = setting(
        None,
        "collisions at fault per 1000 agent-steps; candidates within it rank first; default: no "
        "limit",
    )
    sharing: str = setting(
        "none", f"fitness sharing over several opponents: {', '.join(SHARING)}", choices=SHARING
    )
    pursuer_virulence: float | None = setting(
        None,
        "reduced virulence of the pursuers, from 0.5 to 1; default: mean fitness",
        least=LEAST_VIRULENCE,
        most=1.0,
    )
    evader_virulence: float | None = setting(
        None,
        "reduced virulence of the evaders, from 0.5 to 1; default: mean fitness",
        least=LEAST_VIRULENCE,
        most=1.0,
    )

    def check(self) -> None:
        """Raise ValueError for sharing and virulence together, or of rewards."""
        given = [name for name in ("pursuer_virulence", "evader_virulence") if getattr(self, name)]
        if self.sharing != "none":
            if given:
                raise ValueError(
                    f"{given[0]}: expected no value beside sharing, got sharing {self.sharing!r}"
                )
            given = ["sharing"]
        if given and self.measure == "rewards":
            raise ValueError(f"{given[0]}: expected a measure from 0 to 1, got 'rewards'")

    def virulence(self, team: Team) -> float | None:
        """Return the reduced virulence of `team`, None for mean fitness."""
        return self.pursuer_virulence if team == "pursuer" else self.evader_virulence


@documented
@dataclass(frozen=True)
class OwnLearnerSettings(OwnCode, LearnerSettings):
    """A learner of your own (see `Learner`)."""

    @property
    def starting_genomes(self) -> int:
        """The population for a class that starts from `genomes`; imports its code."""
        parameters = signature(find(self.code, LEARNER)).parameters
        return self.population if "genomes" in parameters else 1

    def new(self, task: Task) -> Learner:
        """Return a new learner of a team; imports its code."""
        given = {
            "genome": task.genomes[0],
            "genomes": task.genomes,
            "samples": self.population,
            "epochs": task.epochs,
            "rng": task.rng,
        }
        learner: Learner = made(self.code, LEARNER, given, self.settings)
        return learner


@documented
@dataclass(frozen=True)
class RaceSettings(Section):
    """Settings of a run: a race, in which both teams learn, or one team `Against` fixed opponents.

    A text stands for the section of that kind with its defaults, as in ``learner="ga"`` or
    ``schedule="hall-of-fame"``. A field that is None takes the default that goes with the learner
    and the schedule. ValueError or TypeError on a bad field.
    """

    world: WorldConfig = setting(WorldConfig(), "the world; its max_steps are those of evaluation")
    policy: PolicySettings = setting(PolicySettings(), "the policy networks")
    learner: BuiltInLearner | OwnLearnerSettings = setting(
        EvolutionStrategySettings(),
        f"how teams learn: {', '.join(kinds_in(BuiltInLearner))} or module:object",
    )
    evader_learner: BuiltInLearner | OwnLearnerSettings | None = setting(
        None, "how the evaders learn, where it differs; learner is then that of the pursuers"
    )
    schedule: Alternating | Simultaneous | Against | Yoked | Maps = setting(
        SCHEDULES["generalist-generalist"], "whom teams meet while they learn, and for how long"
    )
    fitness: FitnessSettings = setting(FitnessSettings(), "what candidates are selected by")
    train_steps: int = setting(
        200,
        "maximum steps of a training episode",
        by={"gradients": 500, "against pursuer": 500, "against evader": 300},
        least=1,
    )
    match_episodes: int = setting(1, "episodes of each training match", least=1)
    evaluation_episodes: int = setting(
        10, "evaluation episodes of each pair", by={"against": 200}, least=1
    )
    seed: int = setting(0, "seed of the run", most=MOST_SEED)

    def check(self) -> None:
        """Fill in defaults, and raise ValueError unless all sections fit together."""
        # First the schedule: the steps of a learner may follow from its epochs.
        for item in sorted(fields(self), key=lambda each: each.name != "schedule"):
            value = getattr(self, item.name)
            if isinstance(value, Section):
                learner = value if isinstance(value, LearnerSettings) else self.learner
                unfilled = {
                    each.name: self._usual(each, learner)
                    for each in fields(value)
                    if each.metadata["by"] and getattr(value, each.name) is None
                }
                with inside(item.name):
                    value = replace(value, **unfilled)
            object.__setattr__(self, item.name, self._usual(item) if value is None else value)
        self._check_mask()
        self._check_idle()
        self._check_maps()
        if self.evader_learner and not isinstance(self.schedule, Alternating):
            why = "one team learns" if isinstance(self.schedule, Against) else "both learn at once"
            raise ValueError(
                f"evader_learner: expected no value with the schedule {self.schedule.kind}, in "
                f"which {why}, got {self.evader_learner.kind}"
            )
        for team in self.learning_teams:
            path = self.learner_path(team)
            self.learner_of(team).check_fits(path, self.world, self.network)

    def _usual(self, item: Field[Any], learner: LearnerSettings | None = None) -> Any:
        """Return the default of a field with a learner, by default `learner`, and this schedule."""
        by: Mapping[str, Any] = item.metadata["by"]
        conditions = (*(learner or self.learner).conditions, *self.schedule.conditions)
        usual = next((by[each] for each in conditions if each in by), item.metadata["default"])
        if callable(usual):
            usual = usual(self.schedule.total_epochs(self.learning_teams[0]))
        return usual

    def _check_mask(self) -> None:
        mask, rules = self.policy.mask, self.world.rules
        if isinstance(self.schedule, Against):
            check_script("schedule.opponent", self.schedule.opponent, self.world)
        check_mask("policy.mask", mask, self.world)
        masked = mask == "right-of-way" and "pursuer" in self.learning_teams
        if masked and rules.captures and not leaves_captures(self.world):
            raise ValueError(
                f"policy.mask: expected none or obstacles for pursuers whose captures are "
                f"collisions at fault (capture {rules.capture.name}, evader {rules.evader.name}, "
                f"pursuer {rules.pursuer.name}), got {mask!r}"
            )

    def _check_idle(self) -> None:
        """Raise ValueError for a value without effect where another section is the reason."""
        learners = [self.learner_of(team) for team in self.learning_teams]
        learner = " and ".join(dict.fromkeys(each.kind for each in learners))
        gradients = all(each.by_gradients for each in learners)
        masked = all(each.keeps_fixed_genes for each in learners)
        started = isinstance(self.schedule, Against) and self.schedule.start is not None
        rows: tuple[tuple[str, Iterable[str], bool, str], ...] = (
            ("policy", ("activation", "memory", "initial_weight"), not self.policy.hidden,
             "without hidden layers"),
            ("policy", ("initial_weight",), gradients, f"with {learner}"),
            ("policy", ("initial_weight", "initial_head"), started, "with a genome to start from"),
            ("policy", ("mask",), not masked, f"with {learner}"),
            ("fitness", ("sharing",), self.schedule.opponents_met < 2,
             "with one opponent an epoch"),
            ("fitness", ("overlap_penalty",), self.world.rules.teammate is not Outcome.REACH,
             "where teammates cannot share a cell"),
            ("fitness", ("overlap_penalty",), "evader" not in self.learning_teams, "of pursuers"),
            ("fitness", vars(self.fitness), gradients, f"with {learner}"),
        )  # fmt: skip
        for section, names, idle, why in rows:
            part = getattr(self, section)
            for item in fields(part):
                value, usual = getattr(part, item.name), self._usual(item)
                # Settings that were made from others may have the default of these.
                defaults = (usual, item.metadata["default"], *item.metadata["by"].values())
                if idle and item.name in names and value not in defaults:
                    expected = "no value" if usual is None else f"{usual!r}, the default"
                    raise ValueError(
                        f"{section}.{item.name}: expected {expected}, got {value!r}; it has no "
                        f"effect {why}"
                    )
        by_gradients = any(each.by_gradients for each in learners)
        rewarded = by_gradients or self.fitness.measure == "rewards"
        if not rewarded and self.world.rewards != Rewards():
            raise ValueError(
                f"world.rewards: expected the default rewards, got {self.world.rewards}; others "
                f"have an effect only with the fitness rewards or a learner by gradients"
            )

    def _check_maps(self) -> None:
        """Raise ValueError unless maps that evolve have room for all agents."""
        if isinstance(self.schedule, Maps):
            cells, agents = self.world.rows * self.world.cols, self.world.n_agents
            most = 1.0 - agents / cells
            if self.schedule.walls > most:
                raise ValueError(
                    f"schedule.walls: expected at most {most:.3g}, which leaves a cell for each of "
                    f"{agents} agents, got {self.schedule.walls:g}"
                )

    # What follows from the settings:

    @property
    def is_race(self) -> bool:
        """Whether both teams learn."""
        return not isinstance(self.schedule, Against)

    @property
    def method(self) -> RaceSettings:
        """The settings without what tells one seed from another: the seed, and whom it replays."""
        schedule = self.schedule
        if isinstance(schedule, Yoked):
            schedule = replace(schedule, race="another seed")
        return replace(self, seed=0, schedule=schedule)

    @property
    def variant(self) -> str:
        """Name of the variant whose rules these are, or "own-rules"."""
        return variant_name(self.world.rules) or "own-rules"

    @property
    def learning_teams(self) -> tuple[Team, ...]:
        """Teams that learn."""
        return self.schedule.learning_teams

    def learner_path(self, team: Team) -> str:
        """Return the name of the setting that says how a team learns."""
        own = team == "evader" and self.evader_learner is not None
        return "evader_learner" if own else "learner"

    def learner_of(self, team: Team) -> BuiltInLearner | OwnLearnerSettings:
        """Return how a team learns."""
        learner: BuiltInLearner | OwnLearnerSettings = getattr(self, self.learner_path(team))
        return learner

    def counted(self, trained: int, evaluated: int) -> int:
        """Return how many training matches take about as long as matches of both kinds."""
        learning = max(self.learner_of(team).learning_time for team in self.learning_teams)
        return trained + round(evaluated / learning)

    @property
    def training_world(self) -> WorldConfig:
        """The world, with episodes of `train_steps`."""
        return replace(self.world, max_steps=self.train_steps)

    @property
    def network(self) -> Network:
        """The policy network of a learning team, with its mask."""
        policy = self.policy
        shape = {"activation": policy.activation, "memory": policy.memory}
        network = Network.for_config(self.world, policy.hidden, **shape)
        return network if policy.mask == "none" else masked_network(network)

    @property
    def overlap_penalty(self) -> float:
        """The overlap penalty, with the default filled in."""
        if self.fitness.overlap_penalty is not None:
            return self.fitness.overlap_penalty
        # Without a penalty, evaders that may share a cell gather in one corner.
        if self.world.rules.teammate is not Outcome.REACH or self.fitness.measure == "rewards":
            return 0.0
        alone = isinstance(self.schedule, Against) and self.schedule.start is None
        return OVERLAP_PENALTY_ALONE if alone else OVERLAP_PENALTY

    def mask_weights(self, team: Team) -> FixedWeights | None:
        """Return the weights of the mask of a team's network, None without a mask."""
        if self.policy.mask == "none":
            return None
        return mask_weights(self.network, forbidding_cells(self.world, self.policy.mask, team))

    def untrained(self, team: Team, count: int) -> Genomes:
        """Return the first `count` untrained genomes (count, genes) of a team."""
        rng = keyed_generator(self.seed, Purpose.INITIAL, TEAMS.index(team))
        scales = {"weight": self.policy.initial_weight, "head": self.policy.initial_head}
        new = partial(self.learner_of(team).untrained, self.network, rng, **scales)
        # One after the other from one generator: the first genomes do not depend on `count`.
        return np.stack([new() for _ in range(count)])

    def new_learner(self, team: Team, genomes: Genomes) -> Learner:
        """Return a new learner of a team, from its `starting_genomes` genomes (n, genes).

        Raises ValueError if own code cannot be imported or refuses its settings, PluginError if it
        fails.
        """
        # The table is filled again from the same key when a run resumes, so no checkpoint holds it.
        rng = keyed_generator(self.seed, Purpose.NOISE, TEAMS.index(team))
        mask, epochs = self.mask_weights(team), self.schedule.total_epochs(team)
        start, fixed = (genomes, None) if mask is None else (mask.write(genomes), mask.fixed)
        return self.learner_of(team).new(Task(start, rng, self.world, self.network, epochs, fixed))

    def changed(self, changes: Mapping[str, Any]) -> RaceSettings:
        """Return the settings with other values by their paths.

        A section of another kind starts from its defaults. TypeError or ValueError if a path is
        unknown or has a bad value.

        Examples
        --------
        >>> from matrixworld.coevolution import RaceSettings
        >>> settings = RaceSettings().changed({"learner": "ga", "schedule.generations": 5})
        >>> settings.learner.kind, settings.schedule.generations
        ('ga', 5)
        """
        return RaceSettings(**merged(RaceSettings, vars(self), by_path(changes)))

    @classmethod
    def of(cls, *values: Mapping[str, Any]) -> RaceSettings:
        """Return settings from values by their paths, such as ``{"learner.sigma": 0.2}``.

        All other settings have their defaults; sections may be nested mappings, as `to_json`
        returns them, or texts that name their kinds, rules and rewards names. Later mappings change
        earlier ones. Code of your own is named only, and not imported. TypeError or ValueError as
        in `changed`; the message begins with the path.
        """
        given: dict[str, Any] = {}
        for each in values:
            given = merged(cls, given, by_path(each))
        return cls(**given)


def check_run_memory(what: str, runs: Sequence[RaceSettings]) -> None:
    """Raise OutOfMemoryError if runs that are played at one time need more than is available."""
    parts: Counter[str] = Counter()
    for each in runs:
        parts.update(run_memory(each))
    try:
        check_memory(what, **parts)
    except OutOfMemoryError as error:
        largest = max(parts, key=parts.__getitem__)
        share = (available_memory() or 0) / parts.total()
        raise OutOfMemoryError(
            f"{error}; about {share:.2g} of this would fit, with less {REDUCED[largest]}"
        ) from error


def run_memory(settings: RaceSettings) -> dict[str, int]:
    """Return the bytes of a run's largest arrays, by what they hold."""
    schedule = settings.schedule
    learners = [settings.learner_of(team) for team in settings.learning_teams]
    population = max(each.population for each in learners)
    genome, teams = 4 * settings.network.genome_size, len(settings.learning_teams)
    archives = 2 if isinstance(schedule, Yoked) else 1
    # Both teams of a hall-of-fame race meet each other and their own samples of the archive.
    extra = schedule.hall_sample if isinstance(schedule, Simultaneous) else 0
    episodes = population * (schedule.opponents_met + extra) * settings.match_episodes
    pairs = schedule.entries**2 if settings.is_race else 1
    needed = {
        "candidates": COPIES * population * genome,
        # A file of it is made in memory.
        "archive": (archives + 3) * teams * schedule.entries * genome,
        "noise": teams * 4 * table_length(settings.network.genome_size),
        "episodes": max(
            EPISODE_BYTES * episodes, PAYOFF_BYTES * pairs * settings.evaluation_episodes
        ),
    }
    if any(each.by_gradients for each in learners):
        agents = max(settings.world.n_pursuers, settings.world.n_evaders)
        transitions = episodes * settings.train_steps * agents
        needed["views"] = COPIES * transitions * settings.network.sizes[0]
    return needed
