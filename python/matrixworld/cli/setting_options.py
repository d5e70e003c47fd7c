"""Settings from the command line: a few options of their own, ``--set PATH=VALUE``, ``--config``.

Paths, types, defaults and help texts are those of the fields of `RaceSettings`; ``--help-all``
prints them.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import Field, fields, replace
from difflib import get_close_matches
from pathlib import Path
from typing import Any, get_args

import click

from matrixworld._util.files import DamagedFileError, load_toml, sentence_of
from matrixworld.cli.console import say
from matrixworld.cli.options import Existing, option_name
from matrixworld.cli.runs import run_in
from matrixworld.coevolution import (
    SCHEDULES,
    ActorCritic,
    Against,
    AtOnce,
    OtherVersionError,
    RaceSettings,
)
from matrixworld.coevolution.sections import WORLD_HELP, Section, hints_of, sections_in
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import SCRIPTS

MAIN_JOB = ("specialist-specialist", "hall-of-fame", "generalist-generalist")
ALL = "all"
HINTS = hints_of(RaceSettings)

PATHS = {
    "variant": "world.rules",
    "rows": "world.rows",
    "cols": "world.cols",
    "n_pursuers": "world.n_pursuers",
    "n_evaders": "world.n_evaders",
    "learner": "learner",
    "generations": "schedule.generations",
    "seed": "seed",
}
"""Options of their own, and the settings that they set."""
AS_BEFORE = {"evader_learner", "schedule.evaders_meet"}
"""Settings that have the sections of the setting before them."""


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


def _pairs(
    ctx: click.Context, param: click.Parameter, texts: Sequence[str]
) -> list[tuple[str, Any]]:
    pairs = []
    for text in texts:
        path, equals, value = text.partition("=")
        if not equals or not path:
            raise click.BadParameter(
                f"expected PATH=VALUE, such as learner.sigma=0.1, got {text!r}"
            )
        pairs.append((path.strip(), parsed(value.strip())))
    return pairs


def _configured(ctx: click.Context, param: click.Parameter, path: Path | None) -> dict[str, Any]:
    if path is None:
        return {}
    try:
        is_toml = path.suffix == ".toml"
        values = load_toml(path) if is_toml else json.loads(path.read_text(encoding="utf-8"))
    except (UnicodeDecodeError, ValueError) as error:
        raise click.BadParameter(f"expected TOML or JSON in {path}, got {error}") from error
    if not isinstance(values, dict):
        raise click.BadParameter(f"expected settings by name in {path}")
    # The config.json of a run has more than the settings.
    inside = values.get("settings", values)
    return inside if isinstance(inside, dict) else values


set_option = click.option(
    "--set",
    "sets",
    multiple=True,
    callback=_pairs,
    metavar="PATH=VALUE",
    help="any other setting, such as learner.sigma=0.1; evolve --help-all lists them; may be given "
    "several times",
)
config_option = click.option(
    "--config",
    type=Existing(dir_okay=False),
    callback=_configured,
    metavar="FILE",
    help="settings from a .toml file, or the config.json of a run; options replace them",
)


def settings_of(given: Mapping[str, Any]) -> list[RaceSettings]:
    """Return the settings of each run that options ask for; click.UsageError for a bad value.

    `given` has values by the names in `PATHS`, and perhaps ``schedule``, several names; ``sets``,
    paths and their values; and ``config``, the settings of a file.
    """
    file: Mapping[str, Any] = given.get("config", {})
    changes = {path: given[name] for name, path in PATHS.items() if name in given}
    changes |= given.get("sets", ())
    names: Sequence[str] = given.get("schedule", ())
    if ALL in names:
        names = [*SCHEDULES, *(name for name in names if name != ALL)]
    elif not names:
        # "" stands for the schedule of the file.
        usual = [""] if "schedule" in file else MAIN_JOB
        names = [changes.pop("schedule")] if "schedule" in changes else usual
    known = sections_in(HINTS["schedule"])
    own = {n: {item.name for item in fields(known[n])} if n in known else set() for n in names}
    settings = []
    with usage_errors():
        for name in own:
            # What this schedule lacks and another one of the job has belongs to that one.
            others = {f"schedule.{part}" for part in set().union(*own.values()) - own[name]}
            kept = {p: v for p, v in changes.items() if ".".join(p.split(".")[:2]) not in others}
            named = {"schedule": name} if name else {}
            settings.append(_with_runs(RaceSettings.of(file, {**named, **kept})))
    return settings


def _with_runs(settings: RaceSettings) -> RaceSettings:
    """Return the settings with the run itself where the directory of a job of one is given."""
    schedule = settings.schedule
    if not isinstance(schedule, Against):
        return settings
    runs: dict[str, Any] = {}
    # A directory that has the name of a script can be given as ./random.
    if schedule.opponent not in SCRIPTS:
        expected = f"{', '.join(SCRIPTS)} or a run directory"
        runs["opponent"] = str(run_in(schedule.opponent, "schedule.opponent", expected))
    if schedule.start is not None:
        runs["start"] = str(run_in(schedule.start, "schedule.start"))
    return replace(settings, schedule=replace(schedule, **runs))


# Messages:


@contextmanager
def usage_errors() -> Iterator[None]:
    """Tell of a bad argument without a traceback, by the option that gives it."""
    try:
        yield
    except (DamagedFileError, OtherVersionError):
        # ValueErrors, too, but the fault of a file and not of an argument: see `failures`.
        raise
    except (FileNotFoundError, IndexError, TypeError, ValueError) as error:
        raise click.UsageError(_in_options(sentence_of(error))) from error


def _in_options(message: str) -> str:
    """Return an error's message with the option in place of the setting that it begins with."""
    path, colon, rest = message.partition(":")
    context = click.get_current_context(silent=True)
    options = {option.name for option in context.command.params} if context else set()
    # A `WorldConfig` names its fields without the section, and the rules by their variant.
    names = {setting.removeprefix("world."): name for name, setting in PATHS.items()}
    field = path.removeprefix("world.")
    name = names.get(field, field)
    if name in options and name != "learner":
        return f"{option_name(name)}{colon}{rest}"
    return message + _meant(path) if "expected one of the settings" in rest else message


def _meant(path: str) -> str:
    """Return what may be meant by an unknown path: one of another kind, or with the same end."""
    sections = _help_sections().items()
    every = [(row.split()[0], title) for title, rows in sections for row, _ in rows]
    titles = [title for each, title in every if each == path]
    if titles:
        return f"; it is a setting of {' and '.join(titles)}"
    ends = [each.rpartition(".")[2] for each, _ in every]
    near = get_close_matches(path.rpartition(".")[2], ends, 1)
    same = dict.fromkeys(each for each, _ in every if each.rpartition(".")[2] in near)
    return f"; did you mean {' or '.join(same)}?" if near else ""


# --help-all:

Rows = list[tuple[str, str]]
"""Path with type, and help text, of each setting of a section."""


def _help_sections(
    cls: type[Section] = RaceSettings, path: str = "", title: str = "settings"
) -> dict[str, Rows]:
    """Return all settings in a section, those of each kind under a title of their own."""
    rows: Rows = []
    found = {title: rows}
    for item in fields(cls):
        hint, here = hints_of(cls)[item.name], f"{path}{item.name}"
        kinds = dict.fromkeys(sections_in(hint).values())
        if hint is WorldConfig:
            found[here] = [(f"{here}.{name}", text) for name, text in WORLD_HELP.items()]
        elif not kinds or here in AS_BEFORE:
            rows.append((f"{here} {_type(hint)}", _text(item)))
        else:
            for each in kinds:
                # The opponents of several schedules have the same sections.
                found |= _help_sections(each, f"{here}.", f"{here}={each.kind}".rstrip("="))
    return found


def _type(hint: Any) -> str:
    accepted = {hint, *get_args(hint)}
    if bool in accepted:
        return "true|false"
    if Ellipsis in accepted:
        return "SIZES"
    return "INTEGER" if int in accepted else "NUMBER" if float in accepted else "TEXT"


def _text(item: Field[Any]) -> str:
    usual = _shown(item.metadata["default"])
    others = "; others below" if item.metadata["by_race"] else ""
    return f"{item.metadata['help']}" + (f"  [default: {usual}{others}]" if usual else "")


def _shown(value: Any) -> str:
    if isinstance(value, tuple):
        return ",".join(map(str, value))
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float):
        return f"{value:.3g}"
    return "" if value is None or isinstance(value, Mapping) else str(value)


def _other_defaults() -> dict[str, Mapping[str, Any]]:
    """Return the defaults that kinds of races and learners have of their own, by these kinds."""
    pursuer, evader = Against(), Against(team="evader")
    return {
        "schedule=hall-of-fame": AtOnce().defaults,
        "schedule=against, schedule.team=pursuer": pursuer.defaults,
        "schedule=against, schedule.team=evader": evader.defaults,
        "learner=actor-critic": ActorCritic.defaults,
    }


def help_all(ctx: click.Context, param: click.Parameter, value: bool) -> None:
    """Print the help page and all settings."""
    if not value:
        return
    formatter = ctx.make_formatter()
    ctx.command.format_help(ctx, formatter)
    formatter.write_paragraph()
    formatter.write_text(
        "All settings, for --set and for files. A kind, such as learner=ga, chooses among the "
        "sections of a name."
    )
    for title, rows in _help_sections().items():
        if rows:  # a sampler such as latest has no settings
            with formatter.section(title):
                formatter.write_dl(rows)
    for title, defaults in _other_defaults().items():
        with formatter.section(f"other defaults, {title}"):
            formatter.write_dl([(path, _shown(value)) for path, value in defaults.items()])
    say(formatter.getvalue().rstrip())
    ctx.exit()
