"""Settings of a run in which one team learns alone."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from matrixworld._util.checks import check_choice, check_integer, shown
from matrixworld.coevolution.settings.training import (
    OVERLAP_PENALTY,
    TrainingSettings,
    option,
    with_parameters,
)
from matrixworld.coevolution.types import TEAMS, Team
from matrixworld.world.policy import SCRIPTS

OVERLAP_PENALTY_ALONE = 0.5
"""Default overlap penalty of evaders that learn alone and from untrained genomes."""

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
"""Values that learned best against random opponents, by the team that learns."""


@with_parameters
@dataclass(frozen=True)
class SingleSettings(TrainingSettings):
    """Settings of a run in which one team learns against fixed opponents.

    A field that is None takes the value that its learner has for it (`LearnerEntry.defaults`), or
    that in `SINGLE_DEFAULTS`. ValueError or TypeError on a bad field.
    """

    # Fields of `TrainingSettings` again, with other defaults.
    initial_weight: float = option(None, "standard deviation of untrained hidden weights")
    initial_head: float = option(None, "standard deviation of untrained output weights")
    population: int = option(
        128, "candidates (or matches, actor-critic) per epoch", by_learner=True
    )
    sigma: float = option(None, "es: standard deviation of the samples; cma: its initial value")
    anneal: bool = option(True, "es: reduce the learning rate linearly to a tenth over the run")
    train_steps: int = option(None, "maximum steps of a training episode")
    eval_episodes: int = option(200, "evaluation episodes against each opponent")

    team: Team = option("pursuer", "team that learns: pursuer or evader")  # noqa: RUF009
    against: str = option(
        "random", f"opponent: {', '.join(SCRIPTS)}, or a run directory (its last generation)"
    )
    start: str | None = option(
        None, "run directory; start from its last generation instead of an untrained genome"
    )
    epochs: int = option(None, "epochs of the run")
    archive_every: int = option(100, "epochs between entries of the archive; each is a checkpoint")

    def __post_init__(self) -> None:
        check_choice("team", self.team, TEAMS)
        self._fill(SINGLE_DEFAULTS[self.team])
        for name in ("against", "start"):
            value = getattr(self, name)
            if not isinstance(value, str) and not (name == "start" and value is None):
                raise TypeError(f"{name}: expected a text, got {shown(value)}")
        check_integer("epochs", self.epochs, 1)
        check_integer("archive_every", self.archive_every, 1)
        super().__post_init__()

    @property
    def learning_teams(self) -> tuple[Team, ...]:
        """The one team that learns."""
        return (self.team,)

    def defaults(self, name: str) -> tuple[Any, ...]:
        """Return the values of a field that count as not given: those of either team."""
        # Both teams: `replace(settings, team=...)` keeps the values filled in for the first team.
        of_teams = [values[name] for values in SINGLE_DEFAULTS.values() if name in values]
        return (*super().defaults(name), *of_teams)

    @property
    def default_overlap_penalty(self) -> float:
        """The overlap penalty where teammates may share a cell."""
        return OVERLAP_PENALTY_ALONE if self.start is None else OVERLAP_PENALTY

    def total_epochs(self, team: Team) -> int:
        """Return the epochs of the whole run."""
        return self.epochs
