"""Settings of races: schedule, generations, opponent samplers and fitness sharing."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from matrixworld._util.checks import check_choice, check_integer, check_number
from matrixworld.coevolution.fitness import LEAST_VIRULENCE, SHARING
from matrixworld.coevolution.opponents.registry import (
    ALTERNATING,
    HALL_OF_FAME,
    SAMPLERS,
    SCHEDULES,
)
from matrixworld.coevolution.plugins import OPPONENT, OwnSettings, check_name, own_settings
from matrixworld.coevolution.settings.training import (
    NO_SETTINGS,
    OWN_HELP,
    TrainingSettings,
    option,
    with_parameters,
)
from matrixworld.coevolution.types import Team

ALL_SCHEDULES = (*SCHEDULES, ALTERNATING, HALL_OF_FAME)
"""Names of all schedules."""

SCHEDULE_DEFAULTS: dict[str, dict[str, int]] = {
    **{name: {"population": 48} for name in (*SCHEDULES, ALTERNATING)},
    # Few samples and many epochs: with opponents that learn, too, more updates are worth more.
    HALL_OF_FAME: {"population": 24},
}
"""Values that learned best, by schedule, at the same number of matches."""


@with_parameters
@dataclass(frozen=True)
class RaceSettings(TrainingSettings):
    """Settings of a race, in which both teams learn; ValueError or TypeError on a bad field.

    A field that is None takes the value that its learner has for it (`LearnerEntry.defaults`), or
    that in `SCHEDULE_DEFAULTS`.
    """

    # A field of `TrainingSettings` again, with another default.
    population: int = option(None, "candidates (or matches, actor-critic) per epoch")

    schedule: str = option(
        "generalist-generalist", f"opponents of each team: {', '.join(ALL_SCHEDULES)}"
    )
    generations: int = option(30, "number of generations after the untrained generation 0")
    pursuer_epochs: int = option(
        60, "epochs per generation in which the pursuers learn", by_learner=True
    )
    evader_epochs: int = option(
        120, "epochs per generation in which the evaders learn", by_learner=True
    )
    joint_epochs: int = option(
        90, "hall-of-fame: epochs per generation, in which both teams learn", by_learner=True
    )
    contemporaries: int = option(2, "hall-of-fame: living opponents of each individual")
    hall_sample: int = option(1, "hall-of-fame: opponents of each individual from the hall of fame")
    pursuers_meet: str | None = option(
        None,
        f"alternating, hall-of-fame: opponent sampler of the pursuers: {', '.join(SAMPLERS)}, or "
        "one of your own, as module:object; default: uniform",
    )
    evaders_meet: str | None = option(None, "opponent sampler of the evaders; as for the pursuers")
    pursuers_meet_settings: Mapping[str, Any] = option(
        NO_SETTINGS, OWN_HELP.format("the pursuers' sampler")
    )
    evaders_meet_settings: Mapping[str, Any] = option(
        NO_SETTINGS, OWN_HELP.format("the evaders' sampler")
    )
    opponents: int = option(1, "alternating: opponents of each candidate in an epoch")
    archive_size: int = option(
        10, "maxsolve: candidates kept; lapca: layers; generalist: opponents kept"
    )
    archive_episodes: int = option(3, "matches of each pair that an archive compares")
    retention_episodes: int = option(
        0,
        "matches of the new and of the previous genome of a team against each archived opponent; "
        "the new one is discarded if it is worse; 0: each new genome is kept",
    )
    sharing: str = option("none", f"fitness sharing over several opponents: {', '.join(SHARING)}")
    pursuer_virulence: float | None = option(
        None, "reduced virulence of the pursuers, from 0.5 to 1; default: mean fitness"
    )
    evader_virulence: float | None = option(
        None, "reduced virulence of the evaders, from 0.5 to 1; default: mean fitness"
    )

    def __post_init__(self) -> None:
        # First, because other checks depend on it.
        check_choice("schedule", self.schedule, ALL_SCHEDULES)
        self._fill(SCHEDULE_DEFAULTS[self.schedule])
        self._check_opponents()
        self._check_sharing()
        for name in ("generations", "pursuer_epochs", "evader_epochs", "joint_epochs"):
            check_integer(name, getattr(self, name), 1)
        check_integer("contemporaries", self.contemporaries, 0)
        check_integer("hall_sample", self.hall_sample, 0)
        if self.contemporaries + self.hall_sample < 1:
            raise ValueError("contemporaries and hall_sample: expected at least 1 opponent, got 0")
        check_integer("retention_episodes", self.retention_episodes, 0)
        super().__post_init__()

    def _check_opponents(self) -> None:
        for name in ("pursuers_meet", "evaders_meet"):
            value = getattr(self, name)
            if value is not None:
                check_name(name, value, SAMPLERS, OPPONENT)
            own = f"{name}_settings"
            self._freeze(own, own_settings(own, getattr(self, own)))
        for name in ("opponents", "archive_size", "archive_episodes"):
            check_integer(name, getattr(self, name), 1)

    def _check_sharing(self) -> None:
        check_choice("sharing", self.sharing, SHARING)
        # Fitness sharing and reduced virulence exclude each other, and expect results in [0, 1].
        given = [] if self.sharing == "none" else ["sharing"]
        for name in ("pursuer_virulence", "evader_virulence"):
            if getattr(self, name) is not None:
                check_number(name, getattr(self, name), least=LEAST_VIRULENCE, most=1.0)
                given.append(name)
        if self.sharing != "none" and len(given) > 1:
            raise ValueError(
                f"{given[1]}: expected it with sharing 'none' only, got sharing {self.sharing!r}"
            )
        if given and self.fitness == "rewards":
            raise ValueError(f"{given[0]}: expected a fitness from 0 to 1, got 'rewards'")

    def sampler_name(self, team: Team) -> str:
        """Return the name of the opponent sampler of `team`."""
        if self.schedule in SCHEDULES:
            return SCHEDULES[self.schedule].sampler_name(team)
        return (self.pursuers_meet if team == "pursuer" else self.evaders_meet) or "uniform"

    def sampler_settings(self, team: Team) -> OwnSettings:
        """Return the settings of the opponent sampler of `team`, if it is one of your own."""
        own: OwnSettings = getattr(self, f"{team}s_meet_settings")
        return own

    @property
    def opponents_per_epoch(self) -> int:
        """Maximum number of archived opponents that a candidate meets in an epoch."""
        return self.hall_sample if self.schedule == HALL_OF_FAME else self.opponents

    def virulence(self, team: Team) -> float | None:
        """Return the reduced virulence of `team`, None for mean fitness."""
        return self.pursuer_virulence if team == "pursuer" else self.evader_virulence

    def epochs(self, team: Team) -> int:
        """Return the epochs of a generation in which `team` learns."""
        if self.schedule == HALL_OF_FAME:
            return self.joint_epochs
        return self.pursuer_epochs if team == "pursuer" else self.evader_epochs

    def total_epochs(self, team: Team) -> int:
        """Return the epochs of the whole run in which `team` learns."""
        return self.generations * self.epochs(team)
