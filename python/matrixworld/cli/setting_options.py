"""Settings from the command line: a few options of their own, ``--set PATH=VALUE``, ``--config``.

Paths, types, defaults and help texts are those of the fields of `RaceSettings`; ``--help-all``
prints them.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import MISSING
from difflib import get_close_matches
from pathlib import Path
from typing import Any, get_args, get_origin

import click

from matrixworld._util import files, sections
from matrixworld._util.sections import HELP, NAMES, OWN, SettingError, UnknownSettingError
from matrixworld.cli import console, options
from matrixworld.coevolution import OtherVersionError, RaceSettings
from matrixworld.coevolution.games.game import GameSettings
from matrixworld.coevolution.runs.places import abbreviated, find_runs, place_in_job
from matrixworld.coevolution.runs.stored_files import FORMAT, OLDEST
from matrixworld.coevolution.settings.race_settings import kinds_of, paths_of
from matrixworld.coevolution.settings.schedules import Against, Schedule
from matrixworld.coevolution.settings.usual import COURTYARD, DEFAULTS, HALL, SCHEDULE, usual
from matrixworld.world.policy import SCRIPTS

OF_FILE = ""  # stands for the schedule of the file of --config
MAIN_JOB = ("specialist-specialist", "hall-of-fame", "generalist-generalist")

OPTIONS = (
    "game", "world", "variant", "rows", "cols", "n_pursuers", "n_evaders", "learner",
    "generations", "seed",
)  # fmt: skip
PATHS = {name: path for name in OPTIONS for path in paths_of(name)}
"""Options of their own, and the settings that they set."""
AS_BEFORE = ("schedule.evader_learner", "schedule.evaders_meet")
"""Settings that take the sections of another one that is listed."""
TYPES = {bool: "true|false", tuple: "LIST", int: "INTEGER", float: "NUMBER"}
"""How the help names the value of a setting; any other one is a text."""
OTHER_DEFAULTS: tuple[Mapping[str, str], ...] = (
    {"schedule": "hall-of-fame"},
    {"schedule": "against", "schedule.team": "pursuer"},
    {"schedule": "against", "schedule.team": "evader"},
    {"schedule": "against", "learner": "ga"},
    {"learner": "actor-critic"},
    {"learner": "actor-critic", "schedule": "hall-of-fame"},
    {"learner": "actor-critic", "schedule": "against"},
    {DEFAULTS: COURTYARD},
    {DEFAULTS: COURTYARD, "schedule": "hall-of-fame"},
)
"""Choices from which other defaults follow. The last ones are those of the command itself."""


# Values:


def parsed(text: str) -> Any:
    """Return the value of a text: a number, true, false, null, sizes such as 64,64, or the text."""
    # Numbers that JSON does not know; those that are not finite are refused as such.
    if re.fullmatch(r"[+-]?(\.\d+|\d+\.|nan|inf|infinity)", text, re.IGNORECASE):
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
    values = []
    for text in texts:
        path, equals, value = text.partition("=")
        if not equals or not path:
            expected = "PATH=VALUE, such as learner.sigma=0.1"
            raise click.BadParameter(f"expected {expected}, got {text!r}")
        values.append((path.strip(), parsed(value.strip())))
    return values


def configured(ctx: click.Context, param: click.Parameter, path: Path | None) -> dict[str, Any]:
    """Return the choices in the file of ``--config``, which may be the config.json of a run."""
    if path is None:
        return {}
    try:
        is_toml = path.suffix == ".toml"
        values = files.load_toml(path) if is_toml else json.loads(path.read_text(encoding="utf-8"))
    except (UnicodeDecodeError, ValueError) as error:
        raise click.BadParameter(f"expected TOML or JSON in {path}, got {error}") from error
    if not isinstance(values, dict):
        raise click.BadParameter(f"expected settings by name in {path}")
    if "format" not in values:
        return values
    if values["format"] not in range(OLDEST, FORMAT + 1):
        version = values.get("matrixworld", "unknown")
        got = f"format {values['format']}, which matrixworld {version} reads"
        raise click.BadParameter(f"expected a run of format {FORMAT} in {path}, got {got}")
    if not isinstance(values.get("settings"), dict):
        raise click.BadParameter(f"expected the settings of a run in {path}, got none")
    try:
        settings = RaceSettings.from_json(values["settings"])
    except SettingError as error:
        raise click.BadParameter(f"{path}: {error}") from error
    return {"schedule": SCHEDULE, **settings.choices()}


def chosen_values(given: Mapping[str, Any]) -> dict[str, Any]:
    """Return what options choose, by path; click.UsageError for what is chosen twice."""
    chosen = {path: given[name] for name, path in PATHS.items() if name in given}
    elsewhere = {name for name in ("schedule", "seeds") if name in given}
    for path, value in given.get("sets", ()):
        if path in chosen or path in elsewhere or (path == "seed" and "seeds" in elsewhere):
            raise click.UsageError(f"--set {path}: expected one value of a setting, got several")
        chosen[path] = value
    return chosen


def of_other_schedules(name: str, names: Sequence[str]) -> set[str]:
    """Return the paths of the settings that a schedule of a job lacks, and another one has."""
    others = set().union(*(_settings_in(other) for other in names)) - _settings_in(name)
    return {f"schedule.{setting}" for setting in others}


def is_below(path: str, sections: Iterable[str]) -> bool:
    """Return whether a path is one of some others, or that of a setting inside one."""
    return any(path == section or path.startswith(f"{section}.") for section in sections)


def _settings_in(schedule: str) -> set[str]:
    """Return the names of the settings of a schedule; none of an unknown one."""
    if schedule not in NAMES[Schedule]:
        return set()
    return {item.name for item in sections.settings_of(NAMES[Schedule][schedule].make)}


def settings_of(given: Mapping[str, Any]) -> list[RaceSettings]:
    """Return the settings of each run that options ask for; click.UsageError for a bad value.

    `given` has values by the names in `OPTIONS`, and perhaps ``schedule``, several names; ``sets``,
    paths and their values; ``config``, the settings of a file; and ``paper``.
    """
    file: Mapping[str, Any] = given.get("config", {})
    chosen = chosen_values(given)
    if "paper" in given:
        options.refuse_beside("--paper", {"config", "game"} & {*given, *chosen})
    start: dict[str, Any] = {DEFAULTS: COURTYARD}
    if "paper" in given or "config" in given or "game" in chosen:
        start = {}
    names: Sequence[str] = MAIN_JOB
    if "schedule" in given:
        names = given["schedule"]
    elif "schedule" in chosen:
        names = [str(chosen.pop("schedule"))]
    elif "schedule" in file:
        names = [OF_FILE]
    jobs = []
    with usage_errors():
        if names is MAIN_JOB and "game" in chosen and _is_symmetric(chosen["game"]):
            names = [HALL]
        # The order in which find_runs finds them, so that --resume prints and draws the same.
        for name in sorted(dict.fromkeys(names), key=place_in_job):
            others = of_other_schedules(name, names)
            choices = {path: v for path, v in chosen.items() if not is_below(path, others)}
            if name != OF_FILE:
                choices["schedule"] = name
            settings = RaceSettings.of(start, file, choices)
            if runs := _runs_of(settings.schedule):
                settings = settings.changed(runs)
            jobs.append(settings)
    return jobs


def _is_symmetric(game: Any) -> bool:
    """Return whether one population plays both sides of a game of your own, by its name."""
    return RaceSettings.of({"game": game}).game.symmetric


def _runs_of(schedule: Schedule) -> dict[str, str]:
    """Return the runs that a schedule names, where it names the directory of a job of one run."""
    if not isinstance(schedule, Against):
        return {}
    runs = {}
    # A directory that has the name of a script can be given as ./random.
    if schedule.opponent not in SCRIPTS and Path(schedule.opponent).is_dir():
        expected = f"{', '.join(SCRIPTS)} or a run directory"
        runs["schedule.opponent"] = _only_run("schedule.opponent", schedule.opponent, expected)
    if schedule.start is not None:
        expected = "a directory that holds a run"
        runs["schedule.start"] = _only_run("schedule.start", schedule.start, expected)
    return runs


def _only_run(path: str, directory: str, expected: str) -> str:
    """Return the only run in the directory that a setting names."""
    runs = find_runs(Path(directory))
    if not runs:
        raise click.UsageError(f"{path}: {options.refusal(directory, expected)}")
    if len(runs) > 1:
        names = abbreviated([str(run.relative_to(directory)) for run in runs])
        raise click.UsageError(f"{path}: expected one run, got a directory of several: {names}")
    return str(runs[0])


# Messages:


@contextmanager
def usage_errors() -> Iterator[None]:
    """Tell of a bad argument without a traceback, by the option that gives it."""
    try:
        yield
    except (files.DamagedFileError, OtherVersionError):
        # ValueErrors, too, but the fault of a file and not of an argument: see `FAILURES`.
        raise
    except SettingError as error:
        raise click.UsageError(_in_options(error)) from error
    except (FileNotFoundError, IndexError, TypeError, ValueError) as error:
        message = files.sentence_of(error)
        name, colon, rest = message.partition(":")
        option = _option_of(name)
        raise click.UsageError(f"{option}{colon}{rest}" if option else message) from error


def _option_of(path: str) -> str:
    """Return the option of the current command that sets a setting; empty if there is none."""
    context = click.get_current_context(silent=True)
    known = {option.name for option in context.command.params} if context else set()
    # A `WorldConfig` names its fields without the section, and the rules by their variant.
    field = path.removeprefix("world.")
    names = {setting.removeprefix("world."): name for name, setting in PATHS.items()}
    name = names.get(field, field)
    return options.option_name(name) if name in known and name != "learner" else ""


def _in_options(error: SettingError) -> str:
    """Return the sentence of an error with the option in place of the setting, and what helps."""
    if option := _option_of(error.path):
        return str(error.at(option))
    message = str(error)
    if error.path == "policy" and error.fits:
        context = click.get_current_context(silent=True)
        given = context.params if context else {}
        networks = error.fits == "cells" and not (given.get("paper") or given.get("config"))
        return f"{message}; give {'--paper' if networks else f'--set policy={error.fits}'}, too"
    if isinstance(error, UnknownSettingError):
        message += _meant(error.path)
    return message


def _meant(path: str) -> str:
    """Return what may be meant by an unknown path: one of another kind, or with the same end."""
    titles: dict[str, list[str]] = {}
    for title, rows in _help_sections().items():
        for row, _ in rows:
            titles.setdefault(row.split()[0], []).append(title)
    if path in titles:
        return f"; it is a setting of {' and '.join(titles[path])}"
    ends = {known: known.rpartition(".")[2] for known in titles}
    near = get_close_matches(path.rpartition(".")[2], ends.values(), 1)
    same = [known for known, end in ends.items() if end in near]
    return f"; did you mean {' or '.join(same)}?" if same else ""


# --help-all:


def _help_sections(
    cls: Any = RaceSettings, path: str = "", title: str = "settings"
) -> dict[str, list[tuple[str, str]]]:
    """Return path with type, and help text, of all settings in a section, by kinds of sections."""
    rows: list[tuple[str, str]] = []
    shown = {title: rows}
    for item in sections.settings_of(cls):
        hint = sections.hints_of(cls)[item.name]
        here = f"{path}{item.name}"
        base = sections.named_type(hint)
        if base is GameSettings:  # the settings of pursuit are written without its path
            rows.append((f"{here} TEXT", item.metadata["help"]))
            shown |= _help_sections(NAMES[base]["pursuit"].make, "", "pursuit and evasion")
        elif base in HELP:
            shown[here] = [(f"{here} NAME", item.metadata["help"])]
            shown[here] += [(f"{here}.{name}", text) for name, text in HELP[base].items()]
        elif base is None or here in AS_BEFORE:
            rows.append(_help_row(cls, item, here))
        else:
            rows.append(_help_row(cls, item, here))
            for kind in sections.classes_of(base):
                name = kind.kind or OWN
                shown |= _help_sections(kind, f"{here}.", f"{here}={name}")
    return shown


def _help_row(cls: Any, item: Any, path: str) -> tuple[str, str]:
    """Return the path of a section's field with its type, and its help text with its default."""
    hint = sections.hints_of(cls)[item.name]
    accepted = {hint, get_origin(hint), *get_args(hint)}
    kind = next((text for each, text in TYPES.items() if each in accepted), "TEXT")
    default = _shown(item.default)
    if not default:
        return f"{path} {kind}", item.metadata["help"]
    here, _, _ = path.rpartition(".")
    kind_here = {here: cls.kind} if here and cls.kind else {}
    follows = [usual(kinds_of({**choice, **kind_here})) for choice in OTHER_DEFAULTS]
    others = "; others below" if any(path in values for values in follows) else ""
    return f"{path} {kind}", f"{item.metadata['help']}  [default: {default}{others}]"


def _shown(value: Any) -> str:
    """Return a default as ``--set`` takes it; empty if there is none."""
    if isinstance(value, sections.Section):
        return getattr(value, "name", value.kind)
    if isinstance(value, tuple):
        return ",".join(map(str, value)) if {*map(type, value)} <= {int} else json.dumps(value)
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, float):
        return f"{value:.3g}"
    return "" if value is None or value is MISSING or isinstance(value, Mapping) else str(value)


def help_all(ctx: click.Context) -> None:
    """Print the help page and all settings."""
    formatter = ctx.make_formatter()
    ctx.command.format_help(ctx, formatter)
    formatter.write_paragraph()
    formatter.write_text(
        "All settings, for --set and for files. A kind, such as learner=ga, chooses among the "
        "sections of a name."
    )
    shown = _help_sections()
    for choice in OTHER_DEFAULTS:
        words = ", ".join(f"{path}={name}" for path, name in choice.items() if path != DEFAULTS)
        if DEFAULTS in choice:
            words = ", ".join(filter(None, [words, "without --paper, --config and --game"]))
        rows = [(path, _shown(value)) for path, value in usual(kinds_of(choice)).items()]
        shown[f"other defaults, {words}"] = rows
    for title, rows in shown.items():
        if rows:  # a sampler such as latest has no settings
            with formatter.section(title):
                formatter.write_dl(rows)
    console.say(formatter.getvalue().rstrip())
