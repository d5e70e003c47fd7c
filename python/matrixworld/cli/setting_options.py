"""Options from the fields of a run's settings, and settings from the options.

Every field of `RaceSettings` and `SingleSettings` is an option of ``matrixworld evolve``; name,
type, help text and default are those of the field. Other commands take some of these options.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import Field, fields
from pathlib import Path
from typing import Any, TypeVar, get_args, get_type_hints

import click

from matrixworld.cli.arguments import opponent_of, run_of
from matrixworld.cli.options import SEED, option_name
from matrixworld.coevolution import (
    ALTERNATING,
    HALL_OF_FAME,
    SCHEDULES,
    SINGLE_DEFAULTS,
    NoEffectError,
    RaceSettings,
    SingleSettings,
)
from matrixworld.coevolution.learners import LEARNERS
from matrixworld.coevolution.plugins import LEARNER, OPPONENT, installed
from matrixworld.coevolution.settings.race import SCHEDULE_DEFAULTS
from matrixworld.world.policy import SCRIPTS
from matrixworld.world.rules import VARIANTS

AnyFunction = TypeVar("AnyFunction", bound=Callable[..., Any])

WORLD = "World"
SECTIONS: dict[str, tuple[str, ...]] = {
    "Races": (
        "schedule", "generations", "pursuer_epochs", "evader_epochs",
        "joint_epochs", "contemporaries", "hall_sample", "pursuers_meet", "evaders_meet",
        "pursuers_meet_settings", "evaders_meet_settings",
        "opponents", "archive_size", "archive_episodes", "retention_episodes", "sharing",
        "pursuer_virulence", "evader_virulence",
    ),
    "One team alone": ("against", "team", "start", "epochs", "archive_every"),
    WORLD: (
        "variant", "rows", "cols", "pursuers", "evaders", "obstacles", "fov", "diagonal",
    ),
    "Policy": ("hidden", "activation", "initial_weight", "initial_head", "mask"),
    "Learner": (
        "learner", "learner_settings",
        "population", "sigma", "optimizer", "learning_rate", "momentum", "anneal",
        "mutation", "crossover", "selection", "tournament", "truncation", "elites",
        "elite_episodes", "fitness", "rewards", "overlap_penalty", "collision_penalty",
        "cost_limit",
    ),
    "Actor-critic (extra torch)": (
        "actor_rate", "critic_rate", "discount", "trace", "actor_updates", "critic_updates",
        "clip", "entropy", "central_critic", "cost_rate", "device",
    ),
    "Episodes and seed": ("train_steps", "worlds", "eval_steps", "eval_episodes", "seed"),
}  # fmt: skip
"""The settings in the order of the help page."""

MAIN_JOB = ("specialist-specialist", "hall-of-fame", "generalist-generalist")
ALL = "all"
HELP = {
    "variant": f"game variant: {', '.join(VARIANTS)}; see matrixworld variants",
    "obstacles": "density of obstacles in [0, 1), or a MovingAI .map file",
    "against": f"evolve one team alone against {', '.join(SCRIPTS)}, or the last generation of a "
    "run",
}
"""Help texts that replace those of the fields."""
MORE_HELP = {
    "schedule": f"; may be given several times; {ALL}: the first three",
    "hidden": ", such as 32 or 64,64; none: no hidden layer",
}
"""What the command line adds to the help texts of the fields."""
DEFAULTS = {"schedule": ", ".join(MAIN_JOB), "against": ""}
"""Defaults that are not those of the fields."""
OTHER_NAMES = {
    "n_pursuers": "pursuers",
    "n_evaders": "evaders",
    "obstacle density": "obstacles",
    "obstacle map": "obstacles",
}
"""Names of settings in the errors of `WorldConfig`: the fields."""
GROUPS = {
    "learner": LEARNER,
    "pursuers_meet": OPPONENT,
    "evaders_meet": OPPONENT,
}
"""Settings that take names of installed entry points: their groups."""
METAVARS = {int: "INTEGER", float: "NUMBER", str: "TEXT"}
RACE = {item.name: item for item in fields(RaceSettings)}
SINGLE = {item.name: item for item in fields(SingleSettings)}


class SettingOption(click.Option):
    """An option that belongs to a section of the help page."""

    def __init__(self, *args: Any, section: str, **attributes: Any) -> None:
        super().__init__(*args, **attributes)
        self.section = section

    def get_help_record(self, ctx: click.Context) -> tuple[str, str] | None:
        """Return option and help text, with the names of installed learners or samplers."""
        record = super().get_help_record(ctx)
        # Here, not where options are declared: other commands need not search the packages.
        names = ", ".join(installed(GROUPS[self.name])) if self.name in GROUPS else ""
        if record is None or not names:
            return record
        return record[0], f"{record[1]}; installed: {names}"


def setting_options(function: AnyFunction) -> AnyFunction:
    """Give a command an option for every setting."""
    # Decorators are applied from the last to the first, so the sections are, too.
    for title, names in reversed(SECTIONS.items()):
        function = _section_options(title, names)(function)
    return function


def world_options(*names: str) -> Callable[[AnyFunction], AnyFunction]:
    """Return a decorator that gives a command the named options of a world, or all but variant."""
    every = [name for name in SECTIONS[WORLD] if name != "variant"]
    return _section_options(WORLD, names or every)


def _section_options(title: str, names: Sequence[str]) -> Callable[[AnyFunction], AnyFunction]:
    def decorate(function: AnyFunction) -> AnyFunction:
        for name in reversed(names):
            function = click.option(
                *_declaration(name), cls=SettingOption, section=title, **_attributes(name)
            )(function)
        return function

    return decorate


def _declaration(name: str) -> tuple[str, str]:
    flag = option_name(name)
    is_flag = _kind(name) is bool  # such as --anneal/--no-anneal
    return f"{flag}/--no-{flag.removeprefix('--')}" if is_flag else flag, name


def _attributes(name: str) -> dict[str, Any]:
    attributes: dict[str, Any] = {"default": None, "help": _help(name)}
    # Settings whose option has its own type or callback, because a field does not say enough.
    special = _SPECIAL.get(name)
    if special is not None:
        return {**attributes, **special}
    kind = _kind(name)
    return attributes if kind is bool else {**attributes, "type": kind, "metavar": METAVARS[kind]}


def _kind(name: str) -> type:
    """Return the simplest type that a field accepts."""
    owner = RaceSettings if name in RACE else SingleSettings
    hint = get_type_hints(owner)[name]
    # `int | None` and `float | None` are options that take a number; None is "not given".
    accepted = {hint, *get_args(hint)}
    return next((kind for kind in (bool, int, float) if kind in accepted), str)


def _help(name: str) -> str:
    item = RACE.get(name) or SINGLE[name]
    text = HELP.get(name, item.metadata["help"]) + MORE_HELP.get(name, "")
    shown = DEFAULTS.get(name, _default(name))
    return f"{text}  [default: {shown}]" if shown else text


def _default(name: str) -> str:
    """Return a race's default and, where it differs, one team's alone; empty for none."""
    race = (_by_schedule(name) or _shown(RACE[name])) if name in RACE else ""
    # SingleSettings leaves some fields to the learning team: the defaults of both are shown.
    by_team = [
        f"{values[name]} for {t}s" for t, values in SINGLE_DEFAULTS.items() if name in values
    ]
    alone = ", ".join(by_team) or (_shown(SINGLE[name]) if name in SINGLE else race)
    usual = alone if name not in RACE or race == alone else f"{race}; with --against {alone}"
    learners = [
        f"{_as_text(entry.defaults[name])} for {learner}"
        for learner, entry in LEARNERS.items()
        if name in entry.defaults
    ]
    return "; ".join([usual, *learners])


def _by_schedule(name: str) -> str:
    """Return the defaults of a field that RaceSettings leaves to the schedule; empty for others."""
    values = {kind: each[name] for kind, each in SCHEDULE_DEFAULTS.items() if name in each}
    if not values:
        return ""
    # One value serves most schedules.
    usual, *_ = values.values()
    others = [f"{value} for {kind}" for kind, value in values.items() if value != usual]
    return ", ".join([str(usual), *others])


def _shown(item: Field[Any]) -> str:
    return _as_text(item.metadata["default"])


def _as_text(value: Any) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, tuple):
        return ",".join(str(part) for part in value)
    return "" if value is None or isinstance(value, Mapping) else str(value)


def own_settings_of(
    ctx: click.Context, param: click.Parameter, values: Sequence[str]
) -> dict[str, bool | int | float | str]:
    """Return settings such as sigma=0.1,tries=3 by name; the option may be given several times."""
    found: dict[str, bool | int | float | str] = {}
    for part in ",".join(values).split(",") if values else ():
        name, equals, value = (word.strip() for word in part.partition("="))
        if not equals or not name.isidentifier() or name in found:
            raise click.BadParameter(
                f"expected settings such as sigma=0.1,tries=3, each once, got {','.join(values)!r}"
            )
        found[name] = _own_value(value)
    return found


def _own_value(text: str) -> bool | int | float | str:
    """Return True, False or a number if a text is one, else the text."""
    if text in ("true", "false"):
        return text == "true"
    try:
        return int(text) if re.fullmatch(r"[+-]?\d+", text) else float(text)
    except ValueError:
        return text


def sizes_of(
    ctx: click.Context, param: click.Parameter, value: str | None
) -> tuple[int, ...] | None:
    """Return layer sizes such as 32 or 64,64."""
    if value is None or value == "none":
        return None if value is None else ()
    if not re.fullmatch(r"\d{1,9}(,\d{1,9})*", value):
        raise click.BadParameter(f"expected sizes such as 32 or 64,64, or none, got {value!r}")
    return tuple(int(size) for size in value.split(","))


def obstacles_of(ctx: click.Context, param: click.Parameter, value: str | None) -> Any:
    """Return a density, or the path of a map."""
    if value is None:
        return None
    # A file that is named like a number can be given as ./0.1.
    try:
        return float(value)
    except ValueError:
        if Path(value).is_file():
            return value
    raise click.BadParameter(f"expected a density in [0, 1) or a .map file, got {value!r}")


OWN: dict[str, Any] = {
    "callback": own_settings_of,
    "multiple": True,
    "metavar": "NAME=VALUE,...",
}
_SPECIAL: Mapping[str, dict[str, Any]] = {
    "schedule": {
        "type": click.Choice([*SCHEDULES, ALTERNATING, HALL_OF_FAME, ALL]),
        "multiple": True,
        "metavar": "NAME",
    },
    "team": {"type": click.Choice(["pursuer", "evader"]), "metavar": "TEAM"},
    "variant": {"type": click.types.FuncParamType(str.upper), "metavar": "NAME"},
    "learner_settings": OWN,
    "pursuers_meet_settings": OWN,
    "evaders_meet_settings": OWN,
    "hidden": {"callback": sizes_of, "metavar": "SIZES"},
    "obstacles": {"callback": obstacles_of, "metavar": "DENSITY|FILE"},
    "against": {"callback": opponent_of, "metavar": "SCRIPT|RUN"},
    "start": {"callback": run_of, "metavar": "RUN"},
    "seed": SEED,
}


def settings_from(given: Mapping[str, Any]) -> list[RaceSettings] | list[SingleSettings]:
    """Return the settings of each run that the options ask for.

    Parameters
    ----------
    given : mapping of str to object
        The options that the user has given, by the names of the fields.

    Raises
    ------
    click.UsageError
        If an option has a bad value or does not apply to the kind of run.
    """
    if "against" in given:
        _refuse(given, set(SINGLE), "without --against")
        if "start" in given:
            given = {**given, "start": str(given["start"])}
        return [_made(SingleSettings, given)]
    _refuse(given, set(RACE), "together with --against")
    return _races(given)


def _races(given: Mapping[str, Any]) -> list[RaceSettings]:
    """Return a race of each schedule, all with the given settings that have an effect in it."""
    schedules = _schedules(given.get("schedule", MAIN_JOB))
    made = [_race({**given, "schedule": schedule}) for schedule in schedules]
    # A setting may be idle in some of the races, but not in all of them.
    for name, error in made[0][1].items():
        if all(name in idle for _, idle in made):
            raise click.UsageError(in_options(str(error)))
    return [settings for settings, _ in made]


def _race(given: Mapping[str, Any]) -> tuple[RaceSettings, dict[str, NoEffectError]]:
    """Return a race, and why each setting without effect in it has been left out."""
    try:
        return RaceSettings(**given), {}
    except NoEffectError as error:
        race, idle = _race({name: given[name] for name in given if name != error.name})
        return race, {error.name: error, **idle}
    except (OSError, TypeError, ValueError) as error:
        raise click.UsageError(in_options(str(error))) from error


def _refuse(given: Mapping[str, Any], known: set[str], how: str) -> None:
    for name in given:
        if name not in known:
            raise click.UsageError(f"{option_name(name)}: expected {how} only")


def _schedules(named: Sequence[str]) -> list[str]:
    # A dictionary keeps the order and drops what is named twice.
    wanted = [*SCHEDULES] if ALL in named else []
    return list(dict.fromkeys([*wanted, *(name for name in named if name != ALL)]))


def _made(kind: Callable[..., Any], given: Mapping[str, Any]) -> Any:
    try:
        return kind(**given)
    except (OSError, TypeError, ValueError) as error:
        raise click.UsageError(in_options(str(error))) from error


def in_options(message: str) -> str:
    """Return an error's message with the options in place of the fields that it begins with."""
    begin, colon, rest = message.partition(":")
    names = [OTHER_NAMES.get(name, name) for name in begin.split(" and ")]
    if not all(name in RACE or name in SINGLE for name in names):
        return message
    return f"{' and '.join(map(option_name, names))}{colon}{rest}"
