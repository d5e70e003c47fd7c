"""``matrixworld evolve``: start runs, or continue them."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import click

from matrixworld.cli.arguments import (
    check_made,
    failures,
    find_runs,
    resume_command,
    runs_of,
)
from matrixworld.cli.console import INTERRUPTED, note, warnings_as_notes
from matrixworld.cli.jobs import (
    Settings,
    create_runs,
    default_directory,
    play_runs,
    resume_runs,
)
from matrixworld.cli.options import (
    SectionedCommand,
    given_options,
    option_name,
    threads_option,
)
from matrixworld.cli.report import report
from matrixworld.cli.setting_options import in_options, setting_options, settings_from
from matrixworld.coevolution import PluginError, Run, RunDirectory

# \b keeps click from wrapping the lines.
EXAMPLES = """\b
Examples:
  matrixworld evolve
  matrixworld evolve my-race --variant SB --schedule generalist-generalist
  matrixworld evolve --against random --team evader
  matrixworld evolve --resume my-race
"""


@click.command("evolve", cls=SectionedCommand, epilog=EXAMPLES)
@click.argument("output", required=False, type=click.Path(path_type=Path, file_okay=False))
@click.option(
    "--resume",
    metavar="DIR",
    callback=runs_of,
    help="continue the run, or all runs, in this directory",
)
@threads_option
@setting_options
def evolve_command(
    output: Path | None, resume: list[Path], threads: int | None, **options: Any
) -> None:
    """Let pursuers and evaders evolve against each other.

    Without options: three races at equal numbers of training matches. In the first, each team
    learns against the newest opponents only (specialists), in the second against living ones and a
    hall of fame, in the third against all earlier generations (generalists). A race ends with a
    payoff matrix, a judgement, scores against held-out opponents and figures. With --against one
    team alone evolves against fixed opponents.

    OUTPUT is a new directory: the run directory of a single run, or the parent of several. The
    default is a directory in runs/, named after variant and seed. A run that exists is never
    replaced.

    Ctrl-C stops. --resume continues from the last checkpoint, with the same results. Results do
    not depend on --threads.
    """
    given = given_options(options)
    with failures(), warnings_as_notes():
        if resume:
            _refuse_settings(output, given)
            root = resume[0] if len(resume) == 1 else resume[0].parent
            # The runs are restored inside the block: reading them may fail or take some time.
            with _resumable(root):
                report(play_runs(_old_runs(resume, threads)), root, threads)
        else:
            settings = settings_from(given)
            root = _new_directory(settings[0], output)
            # Outside the block: a job that is not completely created cannot be resumed.
            runs = _new_runs(settings, root, threads)
            with _resumable(root):
                report(play_runs(runs), root, threads)


@contextmanager
def _resumable(root: Path) -> Iterator[None]:
    """Tell the user how to continue after Ctrl-C, or an error such as a full disk.

    An error in the code of the user's own learner keeps its traceback.
    """
    hint = f"\nStopped. Finished parts are saved; to continue:\n  {resume_command(root)}"
    try:
        yield
    except KeyboardInterrupt:
        note(hint)
        raise click.exceptions.Exit(INTERRUPTED) from None
    except (OSError, PluginError):
        note(hint)
        raise


def _refuse_settings(output: Path | None, given: dict[str, Any]) -> None:
    names = [*(["OUTPUT"] if output else []), *map(option_name, given)]
    if names:
        raise click.UsageError(
            f"--resume: expected no settings beside it, because a run keeps its own, got "
            f"{', '.join(names)}"
        )


def _new_directory(settings: Settings, output: Path | None) -> Path:
    """Return the directory of new runs, and print it if it is not `output`."""
    root = output or default_directory(settings)
    if root.exists():
        _check_free(root)
    if output is None:
        note(f"Output directory: {root}")
    return root


def _check_free(root: Path) -> None:
    # First, because an incomplete job is not empty, and its own message says more.
    check_made(root)
    try:
        RunDirectory(root).check_empty()
    except FileExistsError as error:
        hint = (
            f"; {resume_command(root)} continues the run in it, or prints its result again"
            if find_runs(root)
            else ""
        )
        raise click.UsageError(
            f"OUTPUT: expected a new or empty directory, got {str(root)!r}{hint}"
        ) from error


def _new_runs(settings: list[Any], root: Path, threads: int | None) -> list[Run[Any]]:
    # Some settings can be checked only when opponents and start genomes have been read.
    try:
        return create_runs(settings, root, threads)
    except ValueError as error:
        raise click.UsageError(in_options(str(error))) from error


def _old_runs(paths: list[Path], threads: int | None) -> list[Run[Any]]:
    # The package of a learner of the user's own may be missing, or have changed.
    try:
        return resume_runs(paths, threads)
    except ValueError as error:
        raise click.ClickException(str(error)) from error
