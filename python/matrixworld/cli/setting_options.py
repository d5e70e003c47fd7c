"""Settings from the command line: a few options of their own, ``--set PATH=VALUE``, ``--config``.

Paths, types, defaults and help texts are those of the fields of `RaceSettings`; ``--help-all``
prints them.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import Field, dataclass, field, fields
from difflib import get_close_matches
from pathlib import Path
from typing import Any, get_args

import click

from matrixworld._util.files import load_toml
from matrixworld.cli.options import option_name
from matrixworld.coevolution import SCHEDULES, RaceSettings
from matrixworld.coevolution.own_code import LEARNER, OPPONENT, installed
from matrixworld.coevolution.sections import (
    WORLD_HELP,
    Section,
    hints_of,
    merged,
    put,
    sections_in,
)
from matrixworld.world.config import WorldConfig

MAIN_JOB = ("specialist-specialist", "hall-of-fame", "generalist-generalist")
ALL = "all"
HINTS = hints_of(RaceSettings)

PATHS = {
    "variant": "world.rules",
    **{name: f"world.{name}" for name in WORLD_HELP if name not in ("rules", "rewards")},
    "hidden": "policy.hidden",
    "learner": "learner",
    "generations": "schedule.generations",
    "against": "schedule.opponent",
    "team": "schedule.team",
    "seed": "seed",
}
"""Options of their own, and the settings that they set."""


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


def configured(path: Path) -> dict[str, Any]:
    """Return the settings in a file."""
    try:
        is_toml = path.suffix == ".toml"
        values = load_toml(path) if is_toml else json.loads(path.read_text(encoding="utf-8"))
    except (UnicodeDecodeError, ValueError) as error:
        raise click.UsageError(f"--config: expected TOML or JSON in {path}, got {error}") from error
    if not isinstance(values, dict):
        raise click.UsageError(f"--config: expected settings by name in {path}")
    # The config.json of a run has more than the settings.
    inside = values.get("settings", values)
    return inside if isinstance(inside, dict) else values


@dataclass(frozen=True)
class Asked:
    """Settings that a command line asks for.

    `options` has those that were given, by their names in `PATHS`, and perhaps ``schedule``; `sets`
    has paths of settings and their values.
    """

    options: Mapping[str, Any] = field(default_factory=dict)
    sets: Iterable[tuple[str, Any]] = ()
    config: Path | None = None

    def settings(self) -> list[RaceSettings]:
        """Return the settings of each run; click.UsageError for a bad value."""
        file = {} if self.config is None else configured(self.config)
        changes: dict[str, Any] = {}
        for name, path in PATHS.items():
            if name in self.options and name != "schedule":
                put(changes, path, self.options[name])
        for path, value in self.sets:
            put(changes, path, value)
        if isinstance(changes.get("schedule"), str):
            changes["schedule"] = {"kind": changes["schedule"]}
        return [_made(file, each) for each in self._by_schedule(changes, file)]

    def _by_schedule(
        self, changes: Mapping[str, Any], file: Mapping[str, Any]
    ) -> Iterator[dict[str, Any]]:
        """Yield the changes for each run: what its own schedule lacks belongs to another one."""
        given = changes.get("schedule", {})
        names = self._schedules(given, file)
        fields_of = {name: _names(sections_in(HINTS["schedule"])[name]) for name in names if name}
        for name in names:
            others = {each for other in fields_of.values() for each in other}
            foreign = others - fields_of[name] if name else set()
            kept = {key: value for key, value in given.items() if key not in foreign}
            kind = {"kind": name} if name else {}
            yield {**changes, **({"schedule": {**kept, **kind}} if kept or kind else {})}

    def _schedules(self, given: Mapping[str, Any], file: Mapping[str, Any]) -> list[str]:
        """Return the names of the schedules; "" for that of the file."""
        named = self.options.get("schedule", ())
        if "against" in self.options:
            if named:
                raise click.UsageError("--schedule: expected without --against only")
            return ["against"]
        if named:
            wanted = [*SCHEDULES] if ALL in named else []
            return list(dict.fromkeys([*wanted, *(name for name in named if name != ALL)]))
        if "kind" in given:
            return [str(given["kind"])] if given["kind"] in sections_in(HINTS["schedule"]) else [""]
        if "team" in self.options:
            raise click.UsageError("--team: expected together with --against only")
        return [""] if "schedule" in file else list(MAIN_JOB)


def asked(options: dict[str, Any]) -> Asked:
    """Return what the given options of a command ask for."""
    sets = []
    for text in options.pop("sets", ()):
        path, equals, value = text.partition("=")
        if not equals or not path:
            raise click.UsageError(
                f"--set: expected PATH=VALUE, such as learner.sigma=0.1, got {text!r}"
            )
        sets.append((path.strip(), parsed(value.strip())))
    return Asked(options, sets, options.pop("config", None))


def _names(cls: type[Section]) -> set[str]:
    return {item.name for item in fields(cls)}


def _made(file: Mapping[str, Any], changes: Mapping[str, Any]) -> RaceSettings:
    with usage_errors():
        return RaceSettings.from_json(merged(RaceSettings, file, changes), complete=False)


@contextmanager
def usage_errors() -> Iterator[None]:
    """Tell of a bad setting without a traceback."""
    try:
        yield
    except (OSError, TypeError, ValueError) as error:
        raise click.UsageError(in_options(str(error))) from error


def in_options(message: str) -> str:
    """Return an error's message with the option in place of the setting that it begins with."""
    path, colon, rest = message.partition(":")
    context = click.get_current_context(silent=True)
    options = {option.name for option in context.command.params} if context else set()
    # A `WorldConfig` names its fields without the section, and the rules by their variant.
    names = {setting: name for name, setting in PATHS.items()}
    name = names.get(path, names.get(f"world.{path}", path.removeprefix("world.")))
    if name in options and name != "learner":
        return f"{option_name(name)}{colon}{rest}"
    return message + _meant(path) if "expected one of the settings" in rest else message


def _meant(path: str) -> str:
    """Return what may be meant by an unknown path: one of another kind, or with the same end."""
    titles: dict[str, list[str]] = {}
    for title, rows in _help_sections():
        for row, _ in rows:
            titles.setdefault(row.split()[0], []).append(title)
    if path in titles:
        return f"; it is a setting of {' and '.join(titles[path])}"
    ends: dict[str, list[str]] = {}
    for each in titles:
        ends.setdefault(each.rpartition(".")[2], []).append(each)
    near = get_close_matches(path.rpartition(".")[2], ends, 1)
    return f"; did you mean {' or '.join(ends[near[0]])}?" if near else ""


def option_of(path: str, value: Any) -> str:
    """Return the option of ``evolve`` that sets a setting to a value."""
    text = ",".join(map(str, value)) if isinstance(value, list) else str(value)
    names = {setting: name for name, setting in PATHS.items()} | {"schedule": "schedule"}
    named = path in names and names[path] not in ("obstacles", "fov", "diagonal", "hidden")
    return f"{option_name(names[path])} {text}" if named else f"--set {path}={text}"


# --help-all:


def _help_sections() -> list[tuple[str, list[tuple[str, str]]]]:
    """Return the sections of all settings: title, and rows of path with type, and text."""
    world = [(f"world.{name}", f"{text}") for name, text in WORLD_HELP.items()]
    sections: list[tuple[str, list[tuple[str, str]]]] = [("world", world)]
    _add_sections(RaceSettings, "", "settings", sections)
    return sections


def _add_sections(
    cls: type[Section],
    path: str,
    title: str,
    sections: list[tuple[str, list[tuple[str, str]]]],
) -> None:
    rows: list[tuple[str, str]] = []
    sections.append((title, rows))
    for item in fields(cls):
        hint, here = hints_of(cls)[item.name], f"{path}{item.name}"
        kinds = dict.fromkeys(sections_in(hint).values())
        if hint is WorldConfig or here == "schedule.evaders_meet":
            continue
        for each in kinds:
            named = f"{here}={each.kind}" if each.kind else here
            _add_sections(each, f"{here}.", named, sections)
        if not kinds:
            rows.append((f"{here} {_type(hint)}", _text(item)))


def _type(hint: Any) -> str:
    accepted = {hint, *get_args(hint)}
    if bool in accepted:
        return "true|false"
    if Ellipsis in accepted:
        return "SIZES"
    return "INTEGER" if int in accepted else "NUMBER" if float in accepted else "TEXT"


def _text(item: Field[Any]) -> str:
    usual, by = item.metadata["default"], item.metadata["by"]
    shown = [_shown(usual), *(f"{kind}: {_shown(value)}" for kind, value in by.items())]
    return f"{item.metadata['help']}" + (f"  [default: {'; '.join(shown)}]" if shown[0] else "")


def _shown(value: Any) -> str:
    if isinstance(value, tuple):
        return ",".join(map(str, value))
    if isinstance(value, bool):
        return "true" if value else "false"
    return "" if value is None or isinstance(value, Mapping) else str(value)


def help_all(ctx: click.Context, param: click.Parameter, value: bool) -> None:
    """Print the help page and all settings."""
    if not value:
        return
    formatter = ctx.make_formatter()
    ctx.command.format_help(ctx, formatter)
    formatter.write_paragraph()
    formatter.write_text(
        "All settings, for --set and for files. A kind, such as learner=ga, chooses among the "
        f"sections of a name. Installed learners: {', '.join(installed(LEARNER)) or 'none'}. "
        f"Installed opponent samplers: {', '.join(installed(OPPONENT)) or 'none'}."
    )
    for title, rows in _help_sections():
        if rows:
            with formatter.section(title):
                formatter.write_dl(rows)
    click.echo(formatter.getvalue().rstrip())
    ctx.exit()
