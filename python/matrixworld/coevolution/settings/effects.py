"""When each setting has an effect; elsewhere a value other than the default is refused.

The table `CONDITIONS` has a row for each setting that has no effect in some runs. The learners'
registry adds which learners read a setting. A setting without a condition always has an effect.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, fields
from typing import Any

from matrixworld.coevolution.learners.learner import RunSettings
from matrixworld.coevolution.learners.registry import LEARNERS
from matrixworld.coevolution.opponents.registry import ALTERNATING, HALL_OF_FAME, SAMPLERS
from matrixworld.coevolution.types import TEAMS, Team
from matrixworld.world.rules import Outcome


@dataclass(frozen=True)
class Condition:
    """A condition on the settings of a run.

    Parameters
    ----------
    words : str
        The condition, as the end of "it has an effect only ...".
    holds : callable
        ``holds(settings)`` returns whether it is met.
    """

    words: str
    holds: Callable[[RunSettings], bool]


class NoEffectError(ValueError):
    """A setting differs from its default where it has no effect.

    Parameters
    ----------
    name : str
        The field.
    message : str
        The error message.
    """

    def __init__(self, name: str, message: str) -> None:
        # All arguments, so that the error can be pickled.
        super().__init__(name, message)
        self.name = name

    def __str__(self) -> str:
        return str(self.args[1])


SIZED = ("maxsolve", "lapca", "generalist")
"""Samplers with an archive of a given size."""
ARCHIVES = (*SIZED, "ipca")
"""Samplers with an archive, which plays matches to compare candidates."""


def _samples_with(settings: RunSettings, names: tuple[str, ...]) -> bool:
    return any(settings.sampler_name(team) in names for team in TEAMS)


def _own_sampler(team: Team) -> Condition:
    # In other schedules the samplers are built-in ones.
    return Condition(
        f"with a sampler of your own for the {team}s",
        lambda s: _names_samplers(s) and s.sampler_name(team) not in SAMPLERS,
    )


def _meets_several(settings: RunSettings) -> bool:
    if settings.schedule == HALL_OF_FAME:
        return bool(settings.contemporaries + settings.hall_sample > 1)
    return bool(settings.opponents > 1)


def _names_samplers(settings: RunSettings) -> bool:
    joint = settings.schedule == HALL_OF_FAME and settings.hall_sample > 0
    return bool(settings.schedule == ALTERNATING or joint)


# A run of one team alone has no schedule.
IN_TURNS = Condition(
    f"with a schedule other than {HALL_OF_FAME}",
    lambda s: getattr(s, "schedule", None) != HALL_OF_FAME,
)
JOINT = Condition(f"with the schedule {HALL_OF_FAME}", lambda s: s.schedule == HALL_OF_FAME)
NAMED_SAMPLERS = Condition(
    f"with the schedule {ALTERNATING}, or with {HALL_OF_FAME} and a hall_sample above 0",
    _names_samplers,
)
OWN_LEARNER = Condition("with a learner of your own", lambda s: s.learner_name not in LEARNERS)
HIDDEN = Condition("with hidden layers", lambda s: bool(s.hidden))
# Races have no field `start`: both teams start untrained.
UNTRAINED = Condition("without start", lambda s: getattr(s, "start", None) is None)

BY_FITNESS = Condition(
    "with a learner that learns from fitness",
    lambda s: s.built_in_learner is None or not s.built_in_learner.by_gradients,
)

MASKED = [name for name, entry in LEARNERS.items() if entry.keeps_fixed_genes]
"""Learners that leave the weights of a mask as they are."""

REWARDED = Condition(
    "with the fitness rewards or the learner actor-critic",
    lambda s: s.fitness == "rewards" or not BY_FITNESS.holds(s),
)

CONDITIONS: dict[str, tuple[Condition, ...]] = {
    "pursuer_epochs": (IN_TURNS,),
    "evader_epochs": (IN_TURNS,),
    "joint_epochs": (JOINT,),
    "contemporaries": (JOINT,),
    "hall_sample": (JOINT,),
    "opponents": (
        Condition(f"with the schedule {ALTERNATING}", lambda s: s.schedule == ALTERNATING),
    ),
    "pursuers_meet": (NAMED_SAMPLERS,),
    "evaders_meet": (NAMED_SAMPLERS,),
    "pursuers_meet_settings": (_own_sampler("pursuer"),),
    "evaders_meet_settings": (_own_sampler("evader"),),
    "learner_settings": (OWN_LEARNER,),
    "archive_size": (
        Condition(f"with the samplers {', '.join(SIZED)}", lambda s: _samples_with(s, SIZED)),
    ),
    "archive_episodes": (
        Condition(f"with the samplers {', '.join(ARCHIVES)}", lambda s: _samples_with(s, ARCHIVES)),
    ),
    "sharing": (
        BY_FITNESS,
        Condition("with several opponents of each candidate in an epoch", _meets_several),
    ),
    "activation": (HIDDEN,),
    "initial_weight": (HIDDEN, UNTRAINED, BY_FITNESS),
    "initial_head": (UNTRAINED,),
    "momentum": (Condition("with the optimizer momentum", lambda s: s.optimizer == "momentum"),),
    "tournament": (
        Condition("with the selection tournament", lambda s: s.selection == "tournament"),
    ),
    "truncation": (
        Condition("with the selection truncation", lambda s: s.selection == "truncation"),
    ),
    "elite_episodes": (Condition("with at least 2 elites", lambda s: s.elites >= 2),),
    "cost_rate": (Condition("with a cost_limit", lambda s: s.cost_limit is not None),),
    "mask": (
        Condition(f"with the learner {' or '.join(MASKED)}", lambda s: s.learner_name in MASKED),
    ),
    "rewards": (REWARDED,),
    "collision_penalty": (REWARDED,),
    "fitness": (BY_FITNESS,),
    "pursuer_virulence": (BY_FITNESS,),
    "evader_virulence": (BY_FITNESS,),
    "overlap_penalty": (
        BY_FITNESS,
        Condition("where evaders learn", lambda s: "evader" in s.learning_teams),
        Condition("where teammates may share a cell", lambda s: s.rules.teammate is Outcome.REACH),
    ),
}
"""Setting -> conditions, all of which must hold for it to have an effect."""


def conditions_of(name: str) -> tuple[Condition, ...]:
    """Return the conditions under which a setting has an effect; none: it always has one."""
    readers = [learner for learner, entry in LEARNERS.items() if name in entry.settings]
    if not readers:
        return CONDITIONS.get(name, ())
    read = Condition(
        f"with the learner {' or '.join(readers)}", lambda s: s.learner_name in readers
    )
    return (read, *CONDITIONS.get(name, ()))


def check_effects(settings: RunSettings, defaults: Callable[[str], tuple[Any, ...]]) -> None:
    """Raise NoEffectError if a setting without effect differs from its default.

    Parameters
    ----------
    settings : RaceSettings or SingleSettings
        Settings whose values have been checked already.
    defaults : callable
        ``defaults(name)`` returns the values of a field that count as not given.
    """
    for item in fields(settings):
        value, allowed = getattr(settings, item.name), defaults(item.name)
        unmet = [each.words for each in conditions_of(item.name) if not each.holds(settings)]
        if unmet and value not in allowed:
            expected = " or ".join("no value" if v is None else repr(v) for v in allowed)
            raise NoEffectError(
                item.name,
                f"{item.name}: expected {expected} (the default), got {value!r}; it has an effect "
                f"only {' and '.join(unmet)}",
            )
