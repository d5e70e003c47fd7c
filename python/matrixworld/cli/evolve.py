"""``matrixworld evolve``: the main job."""

from __future__ import annotations

import shlex
from pathlib import Path
from typing import Any

import click

from matrixworld.cli.arguments import (
    check_made,
    failures,
    find_runs,
    runs_of,
    threads_option,
)
from matrixworld.cli.jobs import create_runs, fresh_directory, play_runs
from matrixworld.cli.options import (
    SectionedCommand,
    given_settings,
    option_name,
    setting_options,
    settings_from,
)
from matrixworld.cli.progress import note, warnings_as_notes
from matrixworld.cli.report import report
from matrixworld.coevolution import RunDirectory

INTERRUPTED = 130
"""Exit code of a program that Ctrl-C has ended."""


@click.command("evolve", cls=SectionedCommand)
@click.argument("output", required=False, type=click.Path(path_type=Path, file_okay=False))
@click.option(
    "--resume",
    metavar="DIR",
    callback=runs_of,
    help="go on with the run, or with all runs, in this directory",
)
@threads_option
@setting_options
def evolve_command(
    output: Path | None, resume: list[Path], threads: int | None, **options: Any
) -> None:
    """Let pursuers and evaders evolve against each other.

    Without options: two races side by side, in one the teams learn against the newest opponents
    only (specialists), in the other against all earlier ones (generalists). They end with payoff
    matrices, numbers and figures, in a new directory in runs/ unless OUTPUT names another. OUTPUT
    is the run directory of a single run, and holds one for each of several.

    With --against one team alone evolves against opponents that stay as they are.

    Ctrl-C stops, and --resume goes on from the last half of a generation that was finished.
    """
    given = given_settings(options)
    with failures(), warnings_as_notes():
        if resume:
            _refuse_settings(output, given)
            paths, root = resume, _root(resume)
        else:
            paths, root = _new_runs(output, threads, given)
        try:
            play_runs(paths, threads)
            report(paths, root)
        except KeyboardInterrupt:
            _say_how_to_go_on(root)
            raise click.exceptions.Exit(INTERRUPTED) from None
        except OSError:
            _say_how_to_go_on(root)
            raise


def _say_how_to_go_on(root: Path) -> None:
    note(
        "\nStopped. What was finished is kept; to go on:\n"
        f"  matrixworld evolve --resume {shlex.quote(str(root))}"
    )


def _refuse_settings(output: Path | None, given: dict[str, Any]) -> None:
    names = [*(["OUTPUT"] if output else []), *map(option_name, given)]
    if names:
        raise click.UsageError(
            f"--resume: expected no settings beside it, as a run keeps its own, got "
            f"{', '.join(names)}"
        )


def _root(paths: list[Path]) -> Path:
    return paths[0] if len(paths) == 1 else paths[0].parent


def _new_runs(
    output: Path | None, threads: int | None, given: dict[str, Any]
) -> tuple[list[Path], Path]:
    settings = settings_from(given)
    root = fresh_directory(settings[0]) if output is None else output
    if root.exists():
        _check_free(root)
    try:
        return create_runs(settings, root, threads), root
    except ValueError as error:
        raise click.UsageError(str(error)) from error


def _check_free(root: Path) -> None:
    check_made(root)
    try:
        RunDirectory(root).check_empty()
    except FileExistsError as error:
        hint = f"; --resume {shlex.quote(str(root))} goes on" if find_runs(root) else ""
        raise click.UsageError(
            f"OUTPUT: expected a new or empty directory, got {str(root)!r}{hint}"
        ) from error
