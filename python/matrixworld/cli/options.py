"""Options that several commands share, each declared once, and old names of options.

The options of a run's settings are in `setting_options`.
"""

from __future__ import annotations

import shlex
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import click
from click.core import ParameterSource

from matrixworld._util.checks import INT_MAX, MOST_THREADS
from matrixworld._util.files import check_replaceable, save_json
from matrixworld.cli.arguments import failures
from matrixworld.cli.console import INTERRUPTED, note
from matrixworld.coevolution.settings import MOST_SEED

TYPED = "matrixworld.typed"
"""Key of the words after ``matrixworld`` in the group's context."""


def _seed(ctx: click.Context, param: click.Parameter, value: int) -> int:
    # Not click.IntRange, which would print the 19 digits of the limit in every help page.
    if not 0 <= value <= MOST_SEED:
        raise click.BadParameter(f"expected 0 to {MOST_SEED}, got {value}")
    return value


# A dictionary, because --seed of `evolve` is a setting and is declared among the settings.
SEED: dict[str, Any] = {
    "type": int,
    "callback": _seed,
    "default": 0,
    "show_default": True,
    "metavar": "INTEGER",
    "help": "seed of all random numbers; equal seeds give equal results",
}
seed_option = click.option("--seed", **SEED)

# At least 2: intervals over episodes do not exist for one. 100 episodes bring the interval of a
# mean capture rate to about +-0.1 at worst, and are what `coevolution.score` plays by default.
episodes_option = click.option(
    "--episodes",
    type=click.IntRange(2, INT_MAX),
    default=100,
    show_default=True,
    metavar="INTEGER",
    help="fresh episodes of each pair of opponents",
)
known_episodes_option = click.option(
    "--episodes",
    type=click.IntRange(1, INT_MAX),
    metavar="INTEGER",
    help="episodes behind each cell of a file that holds means only",
)
steps_option = click.option(
    "--steps",
    type=click.IntRange(1, INT_MAX),
    metavar="INTEGER",
    help="most steps of an episode  [default: as in the evaluation of RUN, or 500]",
)
threads_option = click.option(
    "--threads",
    type=click.IntRange(1, MOST_THREADS),
    metavar="INTEGER",
    help="threads that play matches  [default: one per usable core]",
)
json_option = click.option(
    "--json",
    "json_file",
    type=click.Path(path_type=Path),
    metavar="FILE",
    help="write the numbers to this file, too",
)
force_option = click.option("--force", is_flag=True, help="replace files that exist")


def out_option(help: str, **attributes: Any) -> Callable[[Any], Any]:
    """Return the option of the file or directory that a command writes."""
    return click.option(
        "--out", "-o", type=click.Path(path_type=Path), metavar="PATH", help=help, **attributes
    )


def option_name(field_name: str) -> str:
    """Return the option of a settings field."""
    return "--" + field_name.replace("_", "-")


def given_options(options: Mapping[str, Any]) -> dict[str, Any]:
    """Return those options of the current command that the user has given."""
    # Not by comparing values with defaults: a default may be given, too, and settings such as
    # --seed must be refused beside --resume even then.
    source = click.get_current_context().get_parameter_source
    return {
        name: value for name, value in options.items() if source(name) != ParameterSource.DEFAULT
    }


def refuse_existing(*files: Path | None, force: bool) -> None:
    """Raise click.UsageError for the first output file that must not, or cannot, be written.

    To be called before anything is played or written, so that a refusal costs no time and leaves
    no part of the output behind.
    """
    for file in filter(None, files):
        if not file.parent.is_dir():
            raise click.UsageError(
                f"{file}: expected a directory that exists, got {str(file.parent)!r}"
            )
        try:
            check_replaceable(file)
        except FileExistsError as error:
            # Even with --force: a directory may hold a run, and a link may point to any file.
            raise click.UsageError(str(error)) from error
        if file.exists() and not force:
            raise click.UsageError(f"{file}: exists; give --force to replace it")


def write_json(file: Path | None, values: Mapping[str, Any]) -> None:
    """Write values to the file that --json names, if it is given, and print its name."""
    if file is not None:
        save_json(file, values)
        click.echo(f"\nWritten: {file}")


class Commands(click.Group):
    """A group of commands; Ctrl-C says how to go on."""

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Return the command's name, the command, and its arguments, which are kept."""
        ctx.meta[TYPED] = list(args)
        return super().resolve_command(ctx, args)

    def invoke(self, ctx: click.Context) -> Any:
        """Run the command; after Ctrl-C, print the command that starts it again."""
        try:
            with failures():  # options are read here, too, and name files
                return super().invoke(ctx)
        except KeyboardInterrupt:
            again = shlex.join(["matrixworld", *ctx.meta.get(TYPED, [])])
            note(f"\nStopped. No file is half written. To start again:\n  {again}")
            raise click.exceptions.Exit(INTERRUPTED) from None


class SettingOption(click.Option):
    """An option that belongs to a section of the help page."""

    def __init__(self, *args: Any, section: str, **attributes: Any) -> None:
        super().__init__(*args, **attributes)
        self.section = section


class SectionedCommand(click.Command):
    """A command whose help page lists the options by section."""

    def format_options(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write the options, those without a section first."""
        sections: dict[str, list[tuple[str, str]]] = {"Options": []}
        for param in self.get_params(ctx):
            record = param.get_help_record(ctx) if isinstance(param, click.Option) else None
            if record is not None:
                sections.setdefault(getattr(param, "section", "Options"), []).append(record)
        for title, records in sections.items():
            with formatter.section(title):
                formatter.write_dl(records)
