"""Settings from the command line: a few options of their own, ``--set PATH=VALUE``, ``--config``.

Paths, types, defaults and help texts are those of the fields of `RaceSettings`; ``--help-all``
prints them.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import fields, replace
from difflib import get_close_matches
from pathlib import Path
from typing import Any, get_args, get_origin

import click

from matrixworld._util import files
from matrixworld.cli import console, options
from matrixworld.coevolution import ActorCritic, OtherVersionError, RaceSettings
from matrixworld.coevolution.pursuit import WORLD_HELP
from matrixworld.coevolution.race import Against, AtOnce
from matrixworld.coevolution.sections import Section, hints_of, sections_in
from matrixworld.coevolution.settings import DEFAULT_RACE, default_race, paths_of
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import SCRIPTS

MAIN_JOB = ("specialist-specialist", "hall-of-fame", "generalist-generalist")
HINTS = hints_of(RaceSettings)

NAMES = (
    "game", "world", "variant", "rows", "cols", "n_pursuers", "n_evaders", "learner",
    "generations", "seed",
)  # fmt: skip
PATHS = {name: path for name in NAMES for path in paths_of(name)}
"""Options of their own, and the settings that they set."""
AS_BEFORE = {"evader_learner", "schedule.evaders_meet"}
"""Settings that have the sections of the setting before them."""
TYPES = {bool: "true|false", WorldConfig: "WORLDS", tuple: "LIST", int: "INTEGER", float: "NUMBER"}
"""How the help names the value of a setting; any other one is a text."""
OTHER_DEFAULTS = {
    "schedule=hall-of-fame": AtOnce().defaults,
    "schedule=against, schedule.team=pursuer": Against().defaults,
    "schedule=against, schedule.team=evader": Against(team="evader").defaults,
    "learner=actor-critic": ActorCritic.defaults,
    "without --paper, --config and --game": DEFAULT_RACE,
}
"""The defaults that kinds of races and learners have of their own, and those of the command."""


# Values:


def parsed(text: str) -> Any:
    """Return the value of a text: a number, true, false, null, sizes such as 64,64, or the text."""
    if re.fullmatch(r"[+-]?\.\d+|[+-]?\d+\.", text):  # numbers that JSON does not know
        return float(text)
    try:
        value = json.loads(f"[{text}]" if re.fullmatch(r"\d+(,\d+)+", text) else text)
    except ValueError:
        return text
    return text if isinstance(value, str | dict) else value


def pairs(
    ctx: click.Context, param: click.Parameter, texts: Sequence[str]
) -> list[tuple[str, Any]]:
    """Return the paths and values of ``--set``."""
    found = []
    for text in texts:
        path, equals, value = text.partition("=")
        if not equals or not path:
            expected = "PATH=VALUE, such as learner.sigma=0.1"
            raise click.BadParameter(f"expected {expected}, got {text!r}")
        found.append((path.strip(), parsed(value.strip())))
    return found


def configured(ctx: click.Context, param: click.Parameter, path: Path | None) -> dict[str, Any]:
    """Return the settings of the file of ``--config``."""
    if path is None:
        return {}
    try:
        is_toml = path.suffix == ".toml"
        values = files.load_toml(path) if is_toml else json.loads(path.read_text(encoding="utf-8"))
    except (UnicodeDecodeError, ValueError) as error:
        raise click.BadParameter(f"expected TOML or JSON in {path}, got {error}") from error
    if not isinstance(values, dict):
        raise click.BadParameter(f"expected settings by name in {path}")
    # The config.json of a run has more than the settings.
    inside = values.get("settings", values)
    return inside if isinstance(inside, dict) else values


def settings_of(given: Mapping[str, Any]) -> list[RaceSettings]:
    """Return the settings of each run that options ask for; click.UsageError for a bad value.

    `given` has values by the names in `PATHS`, and perhaps ``schedule``, several names; ``sets``,
    paths and their values; and ``config``, the settings of a file.
    """
    file: Mapping[str, Any] = given.get("config", {})
    changes = {path: given[name] for name, path in PATHS.items() if name in given}
    names: Sequence[str] = given.get("schedule", ())
    taken = {*changes, *(["schedule"] if names else []), *(["seed"] if "seeds" in given else [])}
    for path, value in given.get("sets", ()):
        if path in taken:
            raise click.UsageError(f"--set {path}: expected one value of a setting, got several")
        taken.add(path)
        changes[path] = value
    if not names:
        # "" stands for the schedule of the file.
        usual = [""] if "schedule" in file else MAIN_JOB
        names = [str(changes.pop("schedule"))] if "schedule" in changes else usual
    if "paper" in given:
        options.refuse_beside("--paper", {"config", "game"} & {*given, *changes})
    is_plain = given.keys() & {"config", "paper"} or "game" in changes
    known = sections_in(HINTS["schedule"])
    own = {n: {item.name for item in fields(known[n])} if n in known else set() for n in names}
    settings = []
    with usage_errors():
        for name in own:
            start = file if is_plain else default_race(name)
            # What this schedule lacks and another one of the job has belongs to that one.
            others = {f"schedule.{part}" for part in set().union(*own.values()) - own[name]}
            kept = {p: v for p, v in changes.items() if ".".join(p.split(".")[:2]) not in others}
            kept = {"schedule": name, **kept} if name else kept
            settings.append(_with_runs(RaceSettings.of(start, kept)))
    return settings


def _with_runs(settings: RaceSettings) -> RaceSettings:
    """Return the settings with the run itself where the directory of a job of one is given."""
    schedule = settings.schedule
    if not isinstance(schedule, Against):
        return settings
    runs: dict[str, Any] = {}
    # A directory that has the name of a script can be given as ./random.
    if schedule.opponent not in SCRIPTS:
        expected, name = f"{', '.join(SCRIPTS)} or a run directory", "schedule.opponent"
        runs["opponent"] = str(options.run_in(schedule.opponent, setting=name, expected=expected))
    if schedule.start is not None:
        runs["start"] = str(options.run_in(schedule.start, setting="schedule.start"))
    return replace(settings, schedule=replace(schedule, **runs))


# Messages:


@contextmanager
def usage_errors() -> Iterator[None]:
    """Tell of a bad argument without a traceback, by the option that gives it."""
    try:
        yield
    except (files.DamagedFileError, OtherVersionError):
        # ValueErrors, too, but the fault of a file and not of an argument: see `FAILURES`.
        raise
    except (FileNotFoundError, IndexError, TypeError, ValueError) as error:
        raise click.UsageError(_in_options(files.sentence_of(error))) from error


def _in_options(message: str) -> str:
    """Return an error's message with the option in place of the setting that it begins with."""
    path, colon, rest = message.partition(":")
    context = click.get_current_context(silent=True)
    known = {option.name for option in context.command.params} if context else set()
    # A `WorldConfig` names its fields without the section, and the rules by their variant.
    names = {setting.removeprefix("world."): name for name, setting in PATHS.items()}
    field = path.removeprefix("world.")
    name = names.get(field, field)
    if name in known and name != "learner":
        return f"{options.option_name(name)}{colon}{rest}"
    if path == "policy" and (needed := re.match(r" expected (\w+) with the learner", rest)):
        given = context.params if context else {}
        networks = needed[1] == "cells" and not (given.get("paper") or given.get("config"))
        return f"{message}; give {'--paper' if networks else f'--set policy={needed[1]}'}, too"
    return message + _meant(path) if "expected one of the settings" in rest else message


def _meant(path: str) -> str:
    """Return what may be meant by an unknown path: one of another kind, or with the same end."""
    titles: dict[str, list[str]] = {}
    for title, rows in _help_sections().items():
        for row, _ in rows:
            titles.setdefault(row.split()[0], []).append(title)
    if path in titles:
        return f"; it is a setting of {' and '.join(titles[path])}"
    ends = {each: each.rpartition(".")[2] for each in titles}
    near = get_close_matches(path.rpartition(".")[2], ends.values(), 1)
    same = [each for each, end in ends.items() if end in near]
    return f"; did you mean {' or '.join(same)}?" if same else ""


# --help-all:


def _help_sections(
    cls: type[Section] = RaceSettings, path: str = "", title: str = "settings"
) -> dict[str, list[tuple[str, str]]]:
    """Return path with type, and help text, of all settings in a section, by kinds of sections."""
    rows: list[tuple[str, str]] = []
    found = {title: rows}
    for item in fields(cls):
        hint, here = hints_of(cls)[item.name], f"{path}{item.name}"
        kinds = dict.fromkeys(sections_in(hint).values())
        if hint is WorldConfig:
            found[here] = [(f"{here}.{name}", text) for name, text in WORLD_HELP.items()]
        elif kinds and here not in AS_BEFORE:
            for each in kinds:
                # The opponents of several schedules have the same sections.
                found |= _help_sections(each, f"{here}.", f"{here}={each.kind}".rstrip("="))
        else:
            accepted = {hint, get_origin(hint), *get_args(hint)}
            usual = _shown(item.metadata["default"])
            kind = next((text for each, text in TYPES.items() if each in accepted), "TEXT")
            others = "; others below" if item.metadata["by_race"] else ""
            default = f"  [default: {usual}{others}]" if usual else ""
            rows.append((f"{here} {kind}", f"{item.metadata['help']}{default}"))
    return found


def _shown(value: Any) -> str:
    """Return a default as ``--set`` takes it; empty if there is none."""
    if isinstance(value, tuple):
        return ",".join(map(str, value)) if {*map(type, value)} <= {int} else json.dumps(value)
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, float):
        return f"{value:.3g}"
    return "" if value is None or isinstance(value, Mapping) else str(value)


def help_all(ctx: click.Context) -> None:
    """Print the help page and all settings."""
    formatter = ctx.make_formatter()
    ctx.command.format_help(ctx, formatter)
    formatter.write_paragraph()
    formatter.write_text(
        "All settings, for --set and for files. A kind, such as learner=ga, chooses among the "
        "sections of a name."
    )
    sections = _help_sections()
    for title, defaults in OTHER_DEFAULTS.items():
        rows = [(path, _shown(usual)) for path, usual in defaults.items()]
        sections[f"other defaults, {title}"] = rows
    for title, rows in sections.items():
        if rows:  # a sampler such as latest has no settings
            with formatter.section(title):
                formatter.write_dl(rows)
    console.say(formatter.getvalue().rstrip())
