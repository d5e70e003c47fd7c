"""What to try next, from what is present in a race and from its settings."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass, replace
from typing import Any

from matrixworld.analysis import Judgement
from matrixworld.cli.options import option_name
from matrixworld.coevolution.opponents.registry import ALTERNATING, HALL_OF_FAME
from matrixworld.coevolution.settings.race import RaceSettings

Value = Callable[[RaceSettings], Any]


@dataclass(frozen=True)
class Advice:
    """A change of settings that may help if any of the conditions is present.

    A new value may be a function of the settings, such as twice the present one.
    """

    conditions: tuple[str, ...]
    applies: Callable[[RaceSettings], bool]
    changes: Mapping[str, Any]
    why: str

    def options(self, settings: RaceSettings) -> dict[str, Any]:
        """Return the settings that change, with their new values."""
        values = {
            n: value(settings) if callable(value) else value for n, value in self.changes.items()
        }
        return {name: value for name, value in values.items() if value != getattr(settings, name)}

    def helps(self, settings: RaceSettings, present: Collection[str]) -> bool:
        """Return whether the row applies, changes something, and a race can have the result."""
        if not (self.applies(settings) and any(name in present for name in self.conditions)):
            return False
        options = self.options(settings)
        try:
            replace(settings, **options)
        except ValueError:
            # Such as a larger network with a learner that takes few genes only.
            return False
        return bool(options)

    def line(self, settings: RaceSettings) -> str:
        """Return the options to type, and why."""
        options = self.options(settings)
        typed = " ".join(f"{option_name(name)} {_typed(value)}" for name, value in options.items())
        return f"{typed}: {self.why}"


def _typed(value: Any) -> str:
    return ",".join(map(str, value)) if isinstance(value, tuple) else str(value)


def twice(name: str) -> Value:
    """Return a function that doubles a setting."""
    return lambda settings: 2 * getattr(settings, name)


def _is(*schedules: str) -> Callable[[RaceSettings], bool]:
    return lambda settings: settings.schedule in schedules


def _any(settings: RaceSettings) -> bool:
    return True


def _meets_newest_only(settings: RaceSettings) -> bool:
    samplers = {settings.sampler_name(team) for team in ("pursuer", "evader")}
    return settings.schedule == ALTERNATING and "latest" in samplers


def _meets_past_ones(settings: RaceSettings) -> bool:
    return settings.schedule == ALTERNATING and not _meets_newest_only(settings)


def _takes_turns(settings: RaceSettings) -> bool:
    return settings.schedule != HALL_OF_FAME


def _samples_near_one_genome(settings: RaceSettings) -> bool:
    return settings.schedule != HALL_OF_FAME and settings.learner_name != "ga"


def _full_virulence(settings: RaceSettings) -> bool:
    reduced = settings.pursuer_virulence is not None or settings.evader_virulence is not None
    return not reduced and settings.sharing == "none" and settings.fitness != "rewards"


NEWEST = ("specialist-specialist", "generalist-specialist")
CYCLES = ("cycling", "forgetting")

ADVICE = (
    Advice(CYCLES, _is(*NEWEST), {"schedule": "generalist-generalist"},
           "both teams meet opponents of all generations"),
    Advice(CYCLES, _is(*NEWEST), {"schedule": HALL_OF_FAME},
           "both teams meet living opponents and champions of all generations"),
    Advice(CYCLES, _is("generalist-generalist"), {"schedule": ALTERNATING, "opponents": 4},
           "candidates meet several opponents in each epoch"),
    Advice(CYCLES, _is("generalist-generalist"),
           {"schedule": ALTERNATING, "pursuers_meet": "maxsolve", "evaders_meet": "maxsolve"},
           "an archive keeps the opponents that tell candidates apart"),
    Advice(CYCLES, _meets_newest_only, {"pursuers_meet": "uniform", "evaders_meet": "uniform"},
           "both teams meet opponents of all generations"),
    Advice(CYCLES, _meets_past_ones, {"opponents": twice("opponents")},
           "candidates meet more opponents in each epoch"),
    Advice(CYCLES, _is(HALL_OF_FAME), {"hall_sample": lambda s: 2 * max(1, s.hall_sample)},
           "candidates meet more members of the halls of fame"),
    Advice(("disengagement",), _full_virulence, {"pursuer_virulence": 0.75},
           "if pursuers win everything: candidates that win everything have no advantage"),
    Advice(("disengagement",), _full_virulence, {"evader_virulence": 0.75},
           "the same for evaders, if they win everything"),
    Advice(("disengagement", "one-sided progress"), _takes_turns,
           {"pursuer_epochs": twice("pursuer_epochs")},
           "if pursuers are the weaker team or the one that does not gain"),
    Advice(("disengagement", "one-sided progress"), _takes_turns,
           {"evader_epochs": twice("evader_epochs")},
           "if evaders are the weaker team or the one that does not gain"),
    Advice(("one-sided progress",), _is(HALL_OF_FAME), {"joint_epochs": twice("joint_epochs")},
           "more time for the team that does not gain"),
    Advice(("stagnation",), _any, {"population": twice("population")},
           "the fitness of more candidates is less noisy"),
    Advice(("stagnation",), _samples_near_one_genome, {"learner": "ga"},
           "a population of different genomes instead of samples around one"),
    Advice(("stagnation",), _any, {"hidden": lambda s: (2 * max((16, *s.hidden)),)},
           "a larger network"),
    Advice(("arms race",), _any, {"generations": twice("generations")},
           "the race goes on; more generations show how long"),
)  # fmt: skip
"""What to try, in the order in which it is printed."""

GENERAL = {
    "cycling": "let both teams meet opponents of all generations, or a hall of fame",
    "forgetting": "let both teams meet opponents of all generations, or a hall of fame",
    "disengagement": "make the weaker team stronger, or reward no candidate for winning everything",
    "one-sided progress": "give the team that does not gain more time to learn",
    "stagnation": "more candidates, another learner or a larger network",
    "arms race": "more generations show how long it goes on",
}
"""What to try if the settings are not known."""


def advice(judgement: Judgement, settings: RaceSettings | None) -> list[str]:
    """Return what to try next, a line each: options with their values, and a reason.

    Nothing is advised that the race does already. Its settings are None if they are not known.
    """
    present = judgement.present()
    if settings is None:
        return list(dict.fromkeys(GENERAL[name] for name in present))
    return [row.line(settings) for row in ADVICE if row.helps(settings, present)]
