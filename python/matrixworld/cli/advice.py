"""What to try next, from what is present in a race and from its settings."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from typing import Any

from matrixworld.analysis import Judgement
from matrixworld.analysis.judge import RULES
from matrixworld.cli.setting_options import option_of
from matrixworld.coevolution import Alternating, RaceSettings
from matrixworld.coevolution.schedules import HALL_OF_FAME, PSRO, RaceSchedule, Yoked
from matrixworld.coevolution.sections import values_of
from matrixworld.coevolution.types import TEAMS

TWICE = "twice"
"""New value of a setting: twice the present one."""


@dataclass(frozen=True)
class Advice:
    """A change of settings that may help if any of the conditions is present.

    The row is for races in any of its `situations` (see `situations_of`). `changes` has the new
    values by path, and `why` says what they do.
    """

    conditions: tuple[str, ...]
    situations: tuple[str, ...]
    changes: Mapping[str, Any]
    why: str

    def options(self, settings: RaceSettings) -> dict[str, Any]:
        """Return the settings that change, with their new values."""
        present = values_of(settings)
        values = {
            name: doubled(present.get(name)) if value == TWICE else value
            for name, value in self.changes.items()
        }
        return {name: value for name, value in values.items() if value != present.get(name)}

    def helps(self, settings: RaceSettings, present: Collection[str]) -> bool:
        """Return whether the row applies, changes something, and a race can have the result."""
        applies = not situations_of(settings).isdisjoint(self.situations)
        if not (applies and any(name in present for name in self.conditions)):
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


def doubled(value: Any) -> Any:
    """Return twice a number, or one hidden layer of twice the largest size."""
    return [2 * max((16, *value))] if isinstance(value, list) else 2 * max(1, value)


ANY, IN_TURNS, NEWEST_ONLY, PAST_ONES = "any", "in turns", "newest only", "past ones"
ONE_GENOME, FULL_VIRULENCE = "samples around one genome in turns", "full virulence"


def situations_of(settings: RaceSettings) -> set[str]:
    """Return what advice depends on: the name of the schedule, and what the settings have."""
    schedule, fitness = settings.schedule, settings.fitness
    found = {ANY, schedule.name}
    if isinstance(schedule, Alternating):
        found |= {IN_TURNS} if settings.learner.keeps_population else {IN_TURNS, ONE_GENOME}
    if isinstance(schedule, RaceSchedule) and schedule.name in (Alternating.kind, PSRO):
        rules = [getattr(schedule.opponents_of(team), "rule", None) for team in TEAMS]
        found.add(NEWEST_ONLY if "latest" in rules else PAST_ONES)
    reduced = fitness.pursuer_virulence is not None or fitness.evader_virulence is not None
    if not reduced and fitness.sharing == "none" and fitness.measure != "rewards":
        found.add(FULL_VIRULENCE)
    return found


NEWEST = ("specialist-specialist", "generalist-specialist")
CYCLES = ("intransitivity", "cycling", "forgetting")
PURSUERS_MEET, EVADERS_MEET = "schedule.pursuers_meet", "schedule.evaders_meet"

ADVICE = (
    Advice(CYCLES, NEWEST, {"schedule": "generalist-generalist"},
           "both teams meet opponents of all generations"),
    Advice(CYCLES, NEWEST, {"schedule": HALL_OF_FAME},
           "both teams meet living opponents and champions of all generations"),
    Advice(CYCLES, ("generalist-generalist",), {"schedule.opponents": 4},
           "candidates meet several opponents in each epoch"),
    Advice(CYCLES, ("generalist-generalist",),
           {PURSUERS_MEET: "maxsolve", EVADERS_MEET: "maxsolve"},
           "an archive keeps the opponents that tell candidates apart"),
    Advice(CYCLES, (NEWEST_ONLY,), {PURSUERS_MEET: "uniform", EVADERS_MEET: "uniform"},
           "both teams meet opponents of all generations"),
    Advice(CYCLES, (PAST_ONES,), {"schedule.opponents": TWICE},
           "candidates meet more opponents in each epoch"),
    Advice(CYCLES, (HALL_OF_FAME,), {"schedule.hall_sample": TWICE},
           "candidates meet more members of the halls of fame"),
    Advice(("disengagement",), (FULL_VIRULENCE,), {"fitness.pursuer_virulence": 0.75},
           "if pursuers win everything: candidates that win everything have no advantage"),
    Advice(("disengagement",), (FULL_VIRULENCE,), {"fitness.evader_virulence": 0.75},
           "the same for evaders, if they win everything"),
    Advice(("disengagement", "one-sided progress"), (IN_TURNS,), {"schedule.pursuer_epochs": TWICE},
           "if pursuers are the weaker team or the one that does not gain"),
    Advice(("disengagement", "one-sided progress"), (IN_TURNS,), {"schedule.evader_epochs": TWICE},
           "if evaders are the weaker team or the one that does not gain"),
    Advice(("one-sided progress",), (HALL_OF_FAME,), {"schedule.joint_epochs": TWICE},
           "more time for the team that does not gain"),
    Advice(("stagnation",), (ANY,), {"learner.population": TWICE},
           "the fitness of more candidates is less noisy"),
    Advice(("stagnation",), (ONE_GENOME,), {"learner": "ga"},
           "a population of different genomes instead of samples around one"),
    Advice(("stagnation",), (ANY,), {"policy.hidden": TWICE}, "a larger network"),
    Advice(("arms race", "rise"), (ANY,), {"schedule.generations": TWICE},
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
