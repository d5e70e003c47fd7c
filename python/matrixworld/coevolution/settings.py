"""What defines a run. Two runs of equal settings are equal bit for bit.

Each field carries its help text (``dataclasses.fields(RaceSettings)[i].metadata["help"]``), from
which the command line makes its options. The number of threads is no setting: results do not
depend on it.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from matrixworld import Outcome
from matrixworld.checks import check_choice, check_integer, check_number
from matrixworld.coevolution.fitness import FITNESS, LEAST_VIRULENCE, SHARING
from matrixworld.coevolution.learners.optimizers import OPTIMIZERS
from matrixworld.coevolution.learners.registry import LEARNERS, check_learner_settings
from matrixworld.coevolution.opponents.registry import (
    ALTERNATING,
    HALL_OF_FAME,
    SAMPLERS,
    SCHEDULES,
)
from matrixworld.coevolution.types import TEAMS, Team
from matrixworld.config import WorldConfig
from matrixworld.policy import SCRIPTS, Network
from matrixworld.rules import VARIANTS, Rules

SHARED_CELL_OVERLAP_PENALTY = 0.2
"""Default overlap_penalty penalty of a race where teammates may share a cell."""

SHARED_CELL_OVERLAP_PENALTY_ALONE = 0.5
"""The same where evaders learn alone from untrained genomes."""

ALL_SCHEDULES = (*SCHEDULES, ALTERNATING, HALL_OF_FAME)

MOST_SEED = 2**63 - 1


def option(default: Any, text: str) -> Any:
    """Return a dataclass field with a default and a help text."""
    return field(default=default, metadata={"help": text})


@dataclass(frozen=True)
class TrainingSettings:
    """World, policy, learner and budget of a run. ValueError or TypeError on a bad field."""

    variant: str | Rules = option("O", "game variant: a name of VARIANTS, or Rules")  # noqa: RUF009
    rows: int | None = option(None, "rows of the grid; default: the obstacle map's, or 40")
    cols: int | None = option(None, "columns of the grid; default: the obstacle map's, or 40")
    pursuers: int | None = option(None, "number of pursuers; default: the variant's own")
    evaders: int | None = option(None, "number of evaders; default: the variant's own")
    obstacles: Any = option(  # noqa: RUF009
        None, "obstacles: a density in [0, 1), rows of text, a bool array or a MovingAI .map file"
    )
    fov: int = option(11, "side of an agent's square view, in cells; odd")
    diagonal: bool = option(False, "allow diagonal moves (9 actions instead of 5)")

    hidden: tuple[int, ...] = option((32,), "sizes of the policy's hidden layers")
    activation: str = option("relu", "activation of the hidden layers: relu or tanh")
    initial_weight: float = option(0.05, "standard deviation of untrained hidden weights")
    initial_head: float = option(0.1, "standard deviation of untrained output weights")

    learner: str | None = option(
        None,
        "es (evolution strategy), ga (genetic algorithm) or cma (CMA-ES, for at most 1000 genes); "
        "default: ga for hall-of-fame",
    )
    population: int = option(48, "candidates an epoch")
    sigma: float = option(0.1, "es: standard deviation of the samples; cma: of the first ones")
    optimizer: str = option("adam", f"es: {' or '.join(OPTIMIZERS)}")
    learning_rate: float = option(0.02, "es: learning rate of the optimizer")
    momentum: float = option(0.9, "es: share of its last step that momentum keeps, in [0, 1)")
    anneal: bool = option(False, "es: let the learning rate fall linearly to a tenth over the run")
    mutation: float = option(0.05, "ga: standard deviation of a mutation")
    crossover: float = option(0.0, "ga: probability that a child has two parents")
    selection: str = option("tournament", "ga: tournament or truncation")
    tournament: int = option(5, "ga: individuals in a tournament")
    truncation: float = option(0.25, "ga: share of the population that truncation lets breed")
    elites: int = option(2, "ga: fittest individuals kept unchanged")

    fitness: str = option("captured-fraction", f"fitness: {', '.join(FITNESS)}")
    overlap_penalty: float | None = option(
        None,
        "penalty on evaders sharing cells; default: where teammates may share, 0.2, or 0.5 for "
        "evaders alone from untrained genomes; else 0",
    )
    train_steps: int = option(200, "most steps of an episode in training")
    worlds: int = option(1, "episodes of each match in training")
    eval_steps: int = option(500, "most steps of an episode in evaluation")
    eval_episodes: int = option(10, "episodes of each evaluated pair")
    seed: int = option(0, "seed of the run")

    def __post_init__(self) -> None:
        self._freeze("hidden", tuple(int(size) for size in self.hidden))
        self._check_budget()
        self._check_world()
        self._check_learner()

    def _freeze(self, name: str, value: Any) -> None:
        object.__setattr__(self, name, value)

    def _check_budget(self) -> None:
        for name in ("train_steps", "worlds", "eval_steps", "eval_episodes"):
            check_integer(name, getattr(self, name), 1)
        check_integer("seed", self.seed, 0, MOST_SEED)
        check_choice("fitness", self.fitness, FITNESS)
        if self.overlap_penalty is not None:
            check_number("overlap_penalty", self.overlap_penalty, least=0.0)

    def _check_learner(self) -> None:
        if self.learner is not None:
            check_choice("learner", self.learner, LEARNERS)
        check_integer("population", self.population, 2)
        check_learner_settings(self)

    def _check_world(self) -> None:
        check_number("initial_weight", self.initial_weight, least=0.0)
        check_number("initial_head", self.initial_head, least=0.0)
        config = self.world(self.train_steps)
        if config.map is not None:
            self._freeze("obstacles", map_as_text(config.map))
        # Only to check the layers and the activation.
        Network.for_config(config, hidden=self.hidden, activation=self.activation)

    @property
    def sharing(self) -> str:
        """How results against several opponents make a fitness: by their mean."""
        return "none"

    def virulence(self, team: Team) -> float | None:
        """Return the virulence to which `team` is reduced: not at all."""
        return None

    def world(self, max_steps: int) -> WorldConfig:
        """Return the world's configuration, its episodes ending after `max_steps`."""
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
            obstacles=list(self.obstacles) if isinstance(self.obstacles, tuple) else self.obstacles,
            max_steps=max_steps,
        )

    @property
    def network(self) -> Network:
        """The policy network of a learning team."""
        world = self.world(self.train_steps)
        return Network.for_config(world, hidden=self.hidden, activation=self.activation)

    @property
    def rules(self) -> Rules:
        """The rules of the variant."""
        return VARIANTS[self.variant] if isinstance(self.variant, str) else self.variant

    @property
    def learner_name(self) -> str:
        """The learner, with the default filled in."""
        return self.learner or "es"

    @property
    def resolved_overlap_penalty(self) -> float:
        """The overlap penalty, with the default filled in."""
        if self.overlap_penalty is not None:
            return self.overlap_penalty
        may_share = self.rules.teammate is Outcome.REACH and self.fitness != "rewards"
        return self.default_overlap_penalty if may_share else 0.0

    @property
    def default_overlap_penalty(self) -> float:
        """The overlap penalty where teammates may share a cell."""
        return SHARED_CELL_OVERLAP_PENALTY


@dataclass(frozen=True)
class RaceSettings(TrainingSettings):
    """Settings of co-evolution, both teams learning."""

    schedule: str = option("generalist-generalist", f"who meets whom: {', '.join(ALL_SCHEDULES)}")
    generations: int = option(30, "generations after the untrained one")
    pursuer_epochs: int = option(60, "epochs of a generation in which the pursuers learn")
    evader_epochs: int = option(120, "epochs of a generation in which the evaders learn")
    joint_epochs: int = option(15, "hall-of-fame: epochs of a generation, both teams learning")
    contemporaries: int = option(4, "hall-of-fame: living opponents that an individual meets")
    hall_sample: int = option(4, "hall-of-fame: opponents of the hall that an individual meets")
    pursuers_meet: str | None = option(
        None,
        f"alternating, hall-of-fame: how the pursuers' opponents are selected: "
        f"{', '.join(SAMPLERS)}; default: uniform",
    )
    evaders_meet: str | None = option(None, "the same for the evaders")
    opponents: int = option(1, "alternating: opponents that a candidate meets in an epoch")
    archive_size: int = option(
        10, "candidates of maxsolve, layers of lapca, opponents that generalist keeps"
    )
    archive_episodes: int = option(3, "matches of each pair that an archive compares")
    sharing: str = option(
        "none", f"fitness of candidates with several opponents: {', '.join(SHARING)}"
    )
    pursuer_virulence: float | None = option(
        None, "reduced virulence of the pursuers, from 0.5 to 1; default: mean fitness"
    )
    evader_virulence: float | None = option(None, "the same of the evaders")

    def __post_init__(self) -> None:
        check_choice("schedule", self.schedule, ALL_SCHEDULES)
        self._check_opponents()
        self._check_sharing()
        for name in ("generations", "pursuer_epochs", "evader_epochs", "joint_epochs"):
            check_integer(name, getattr(self, name), 1)
        check_integer("contemporaries", self.contemporaries, 0)
        check_integer("hall_sample", self.hall_sample, 0)
        if self.contemporaries + self.hall_sample < 1:
            raise ValueError("contemporaries and hall_sample: expected one opponent or more, got 0")
        if self.schedule == HALL_OF_FAME and self.learner not in (None, "ga"):
            raise ValueError(
                f"learner: expected ga for the hall-of-fame schedule, got {self.learner!r}"
            )
        super().__post_init__()

    def _check_opponents(self) -> None:
        for name in ("pursuers_meet", "evaders_meet"):
            value = getattr(self, name)
            if value is None:
                continue
            check_choice(name, value, SAMPLERS)
            if self.schedule in SCHEDULES:
                raise ValueError(
                    f"{name}: expected {ALTERNATING} or {HALL_OF_FAME} as the schedule, "
                    f"got {self.schedule!r}, which names its own"
                )
        for name in ("opponents", "archive_size", "archive_episodes"):
            check_integer(name, getattr(self, name), 1)
        if self.opponents > 1 and self.schedule != ALTERNATING:
            raise ValueError(
                f"opponents: expected 1 for the schedule {self.schedule}, got {self.opponents}"
            )

    def _check_sharing(self) -> None:
        check_choice("sharing", self.sharing, SHARING)
        given = [] if self.sharing == "none" else ["sharing"]
        for name in ("pursuer_virulence", "evader_virulence"):
            if getattr(self, name) is not None:
                check_number(name, getattr(self, name), least=LEAST_VIRULENCE, most=1.0)
                given.append(name)
        if self.sharing != "none" and len(given) > 1:
            raise ValueError(f"{given[1]}: expected sharing none beside it, got {self.sharing!r}")
        if given and self.fitness == "rewards":
            raise ValueError(f"{given[0]}: expected a fitness from 0 to 1, got 'rewards'")

    def meets(self, team: Team) -> str:
        """Return the name of the selection by which `team` meets its opponents."""
        if self.schedule in SCHEDULES:
            return SCHEDULES[self.schedule].sampler_name(team)
        return (self.pursuers_meet if team == "pursuer" else self.evaders_meet) or "uniform"

    def met(self, team: Team) -> int:
        """Return how many archived opponents a candidate of `team` meets in an epoch, at most."""
        return self.hall_sample if self.schedule == HALL_OF_FAME else self.opponents

    def virulence(self, team: Team) -> float | None:
        """Return the virulence to which `team` is reduced, None for mean fitness."""
        return self.pursuer_virulence if team == "pursuer" else self.evader_virulence

    @property
    def learner_name(self) -> str:
        """The learner, with the default of the schedule filled in."""
        return self.learner or ("ga" if self.schedule == HALL_OF_FAME else "es")

    def epochs(self, team: Team) -> int:
        """Return the epochs of a generation in which `team` learns."""
        if self.schedule == HALL_OF_FAME:
            return self.joint_epochs
        return self.pursuer_epochs if team == "pursuer" else self.evader_epochs

    def total_epochs(self, team: Team) -> int:
        """Return the epochs of the whole run in which `team` learns."""
        return self.generations * self.epochs(team)


SINGLE_DEFAULTS: dict[Team, dict[str, float]] = {
    "pursuer": {
        "sigma": 0.15,
        "initial_weight": 0.2,
        "initial_head": 0.09,
        "epochs": 6000,
        "train_steps": 500,
    },
    "evader": {
        "sigma": 0.1,
        "initial_weight": 0.05,
        "initial_head": 0.1,
        "epochs": 4000,
        "train_steps": 300,
    },
}
"""What was seen to learn best against random opponents, by the team that learns."""


@dataclass(frozen=True)
class SingleSettings(TrainingSettings):
    """Settings of the evolution of one team against opponents that stand still.

    What is None by default takes the team's value of `SINGLE_DEFAULTS`.
    """

    initial_weight: float = option(None, "standard deviation of untrained hidden weights")
    initial_head: float = option(None, "standard deviation of untrained output weights")
    population: int = option(128, "candidates an epoch")
    sigma: float = option(None, "es: standard deviation of the samples; cma: of the first ones")
    anneal: bool = option(True, "es: let the learning rate fall linearly to a tenth over the run")
    train_steps: int = option(None, "most steps of an episode in training")
    eval_episodes: int = option(200, "fresh episodes of the evaluation, against each opponent")

    team: Team = option("pursuer", "team that learns: pursuer or evader")  # noqa: RUF009
    against: str = option(
        "random", f"opponent: {', '.join(SCRIPTS)}, or a run directory (its last generation)"
    )
    start: str | None = option(
        None, "run directory whose last generation to start from; default: an untrained genome"
    )
    epochs: int = option(None, "epochs of the run")
    archive_every: int = option(100, "epochs between entries of the archive; each is a checkpoint")

    def __post_init__(self) -> None:
        check_choice("team", self.team, TEAMS)
        for name, value in SINGLE_DEFAULTS[self.team].items():
            if getattr(self, name) is None:
                self._freeze(name, value)
        check_integer("epochs", self.epochs, 1)
        check_integer("archive_every", self.archive_every, 1)
        super().__post_init__()

    @property
    def default_overlap_penalty(self) -> float:
        """The overlap penalty where teammates may share a cell."""
        return (
            SHARED_CELL_OVERLAP_PENALTY_ALONE if self.start is None else SHARED_CELL_OVERLAP_PENALTY
        )

    def total_epochs(self, team: Team) -> int:
        """Return the epochs of the whole run."""
        return self.epochs


def map_as_text(obstacles: NDArray[np.bool_]) -> tuple[str, ...]:
    """Return an obstacle map (rows, cols) as rows of text, '#' obstacle and '.' free."""
    return tuple("".join("#" if cell else "." for cell in row) for row in obstacles)
