"""What to try next, from what is present in a race and from its settings."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass
from typing import Any

from matrixworld.analysis import Judgement
from matrixworld.analysis.judge import RULES
from matrixworld.cli.setting_options import option_of
from matrixworld.coevolution import Alternating, RaceSettings
from matrixworld.coevolution.schedules import HALL_OF_FAME, PSRO, RaceSchedule, Yoked
from matrixworld.coevolution.sections import leaves
from matrixworld.coevolution.types import TEAMS

Value = Callable[[Mapping[str, Any]], Any]
"""Returns the new value of a setting from the present values by path."""


@dataclass(frozen=True)
class Advice:
    """A change of settings that may help if any of the conditions is present.

    `conditions` are those of which any has to be present, `applies` says whether the row is for a
    race of these settings, `changes` has the new values by path (or functions that return them),
    and `why` says what the change does.
    """

    conditions: tuple[str, ...]
    applies: Callable[[RaceSettings], bool]
    changes: Mapping[str, Any]
    why: str

    def options(self, settings: RaceSettings) -> dict[str, Any]:
        """Return the settings that change, with their new values."""
        present = {leaf.path: leaf.value for leaf in leaves(settings)}
        values = {n: each(present) if callable(each) else each for n, each in self.changes.items()}
        return {name: value for name, value in values.items() if value != present.get(name)}

    def helps(self, settings: RaceSettings, present: Collection[str]) -> bool:
        """Return whether the row applies, changes something, and a race can have the result."""
        if not (self.applies(settings) and any(name in present for name in self.conditions)):
            return False
        options = self.options(settings)
        try:
            settings.changed(options)
        except ValueError:
            # Such as a larger network with a learner that takes few genes only.
            return False
        return bool(options)

    def line(self, settings: RaceSettings) -> str:
        """Return the options to type, and why."""
        typed = " ".join(option_of(*each) for each in self.options(settings).items())
        return f"{typed}: {self.why}"


def twice(path: str) -> Value:
    """Return a function that doubles a setting."""
    return lambda present: 2 * present[path]


def _named(*schedules: str) -> Callable[[RaceSettings], bool]:
    return lambda settings: settings.schedule.name in schedules


def _any(settings: RaceSettings) -> bool:
    return True


def _takes_turns(settings: RaceSettings) -> bool:
    return isinstance(settings.schedule, Alternating)


def _meets_newest_only(settings: RaceSettings) -> bool:
    schedule = settings.schedule
    if not isinstance(schedule, RaceSchedule) or schedule.name != Alternating.kind:
        return False
    return any(getattr(schedule.opponents_of(team), "rule", None) == "latest" for team in TEAMS)


def _meets_past_ones(settings: RaceSettings) -> bool:
    return _named(Alternating.kind, PSRO)(settings) and not _meets_newest_only(settings)


def _samples_near_one_genome(settings: RaceSettings) -> bool:
    return _takes_turns(settings) and not settings.learner.keeps_population


def _full_virulence(settings: RaceSettings) -> bool:
    fitness = settings.fitness
    reduced = fitness.pursuer_virulence is not None or fitness.evader_virulence is not None
    return not reduced and fitness.sharing == "none" and fitness.measure != "rewards"


NEWEST = ("specialist-specialist", "generalist-specialist")
CYCLES = ("intransitivity", "cycling", "forgetting")
PURSUERS_MEET, EVADERS_MEET = "schedule.pursuers_meet", "schedule.evaders_meet"

ADVICE = (
    Advice(CYCLES, _named(*NEWEST), {"schedule": "generalist-generalist"},
           "both teams meet opponents of all generations"),
    Advice(CYCLES, _named(*NEWEST), {"schedule": HALL_OF_FAME},
           "both teams meet living opponents and champions of all generations"),
    Advice(CYCLES, _named("generalist-generalist"), {"schedule.opponents": 4},
           "candidates meet several opponents in each epoch"),
    Advice(CYCLES, _named("generalist-generalist"),
           {PURSUERS_MEET: "maxsolve", EVADERS_MEET: "maxsolve"},
           "an archive keeps the opponents that tell candidates apart"),
    Advice(CYCLES, _meets_newest_only, {PURSUERS_MEET: "uniform", EVADERS_MEET: "uniform"},
           "both teams meet opponents of all generations"),
    Advice(CYCLES, _meets_past_ones, {"schedule.opponents": twice("schedule.opponents")},
           "candidates meet more opponents in each epoch"),
    Advice(CYCLES, _named(HALL_OF_FAME),
           {"schedule.hall_sample": lambda present: 2 * max(1, present["schedule.hall_sample"])},
           "candidates meet more members of the halls of fame"),
    Advice(("disengagement",), _full_virulence, {"fitness.pursuer_virulence": 0.75},
           "if pursuers win everything: candidates that win everything have no advantage"),
    Advice(("disengagement",), _full_virulence, {"fitness.evader_virulence": 0.75},
           "the same for evaders, if they win everything"),
    Advice(("disengagement", "one-sided progress"), _takes_turns,
           {"schedule.pursuer_epochs": twice("schedule.pursuer_epochs")},
           "if pursuers are the weaker team or the one that does not gain"),
    Advice(("disengagement", "one-sided progress"), _takes_turns,
           {"schedule.evader_epochs": twice("schedule.evader_epochs")},
           "if evaders are the weaker team or the one that does not gain"),
    Advice(("one-sided progress",), _named(HALL_OF_FAME),
           {"schedule.joint_epochs": twice("schedule.joint_epochs")},
           "more time for the team that does not gain"),
    Advice(("stagnation",), _any, {"learner.population": twice("learner.population")},
           "the fitness of more candidates is less noisy"),
    Advice(("stagnation",), _samples_near_one_genome, {"learner": "ga"},
           "a population of different genomes instead of samples around one"),
    Advice(("stagnation",), _any,
           {"policy.hidden": lambda present: [2 * max((16, *present["policy.hidden"]))]},
           "a larger network"),
    Advice(("arms race", "rise"), _any, {"schedule.generations": twice("schedule.generations")},
           "the race goes on; more generations show how long"),
)  # fmt: skip
"""What to try, in the order in which it is printed."""


def advice(judgement: Judgement, settings: RaceSettings | None) -> list[str]:
    """Return what to try next, a line each: options with their values, and a reason.

    Nothing is advised that the race does already. Its settings are None if they are not known.
    """
    present = judgement.present()
    if settings is not None and isinstance(settings.schedule, Yoked):
        return []  # its settings are those of the race that it replays
    if settings is None:
        general = (RULES[name].advice for name in present)
        return list(dict.fromkeys(filter(None, general)))
    return [row.line(settings) for row in ADVICE if row.helps(settings, present)]
