"""``matrixworld evolve``: start runs, or continue them."""

from __future__ import annotations

from collections.abc import Iterator
from concurrent.futures import BrokenExecutor, Executor
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import click

from matrixworld.cli.arguments import can_resume, failures, resume_command, resumed_of
from matrixworld.cli.clusters import cluster_option, on_cluster, refuse_threads
from matrixworld.cli.console import INTERRUPTED, note, warnings_as_notes
from matrixworld.cli.jobs import default_directory, found_job, new_job, play_runs
from matrixworld.cli.options import (
    SectionedCommand,
    given_options,
    option_name,
    threads_option,
)
from matrixworld.cli.report import report
from matrixworld.cli.seeds import seeds_option
from matrixworld.cli.setting_options import asked, help_all, setting_options, usage_errors
from matrixworld.cli.variants import variants_option
from matrixworld.coevolution import (
    PluginError,
    RaceSettings,
    RunDirectory,
)
from matrixworld.coevolution.jobs.evolve import check_job
from matrixworld.coevolution.jobs.job import Job

# \b keeps click from wrapping the lines.
EXAMPLES = """\b
Examples:
  matrixworld evolve
  matrixworld evolve my-race --variant SB --schedule generalist-generalist
  matrixworld evolve my-races --seeds 0-9
  matrixworld evolve --against random --team evader
  matrixworld evolve my-race --learner ga --set learner.mutation=0.1
  matrixworld evolve my-races --seeds 0-999 --cluster tcp://head-node:8786
  matrixworld evolve --resume my-race
"""


@click.command(
    "evolve", cls=SectionedCommand, epilog=EXAMPLES, short_help="Start races, or continue them."
)
@click.argument("output", required=False, type=click.Path(path_type=Path, file_okay=False))
@click.option(
    "--resume",
    "resumed",
    metavar="DIR",
    callback=resumed_of,
    help="continue the run, or all runs, in this directory",
)
@seeds_option
@threads_option
@cluster_option
@setting_options
@click.option(
    "--help-all",
    is_flag=True,
    is_eager=True,
    expose_value=False,
    callback=help_all,
    help="print this page and all settings",
)
@variants_option
def evolve_command(
    output: Path | None,
    resumed: Path | None,
    seeds: tuple[int, ...] | None,
    threads: int | None,
    where: str | None,
    **options: Any,
) -> None:
    """Let pursuers and evaders evolve against each other.

    Without options: three races at equal numbers of training matches. In the first, each team
    learns against the newest opponents only (specialists), in the second against living ones and a
    hall of fame, in the third against all earlier generations (generalists). A race ends with a
    payoff matrix, a judgement, scores against held-out opponents and figures. With --against one
    team alone evolves against fixed opponents. With --seeds there is a run of each seed.

    OUTPUT is a new directory, which receives one run directory for each run:
    SCHEDULE/seed-NUMBER. The default is a directory in runs/, named after variant and seed. A run
    that exists is never replaced.

    Several runs play side by side, as many as --threads; threads that are left over are shared
    among them. Ctrl-C stops. --resume continues from the last checkpoint, with the same results.
    Results do not depend on --threads.

    With --cluster several runs play on the workers of a Dask cluster, one thread each. All workers
    must see OUTPUT under the same path; docs/cluster.md says how to start them.
    """
    given = given_options(options)
    with failures(), warnings_as_notes():
        if resumed:
            _refuse_settings(output, {**given, **({"seeds": seeds} if seeds else {})})
            _play_old(resumed, threads, where)
        else:
            _refuse_seed(seeds, given)
            _play_new(asked(given).settings(), seeds, output, threads, where)


def _refuse_seed(seeds: tuple[int, ...] | None, given: dict[str, Any]) -> None:
    if seeds is not None and "seed" in given:
        raise click.UsageError("--seeds: expected it without --seed, got both")


def _play_new(
    settings: list[RaceSettings],
    seeds: tuple[int, ...] | None,
    output: Path | None,
    threads: int | None,
    where: str | None,
) -> None:
    job = new_job(settings, seeds)
    elsewhere = _elsewhere(job, where, threads)
    root = _new_directory(output, default_directory(job))
    # Some settings can be checked only when opponents and start genomes have been read.
    with usage_errors():
        check_job(job, root, elsewhere, threads)
    with _resumable(root):
        _play(job, root, threads, where, new=True)


def _elsewhere(job: Job, where: str | None, threads: int | None) -> Executor | None:
    """Return an executor for checks if runs play on other machines; a single run cannot."""
    if where is None:
        return None
    refuse_threads(where, threads)
    if len(job.runs) == 1:
        raise click.UsageError(
            "--cluster: expected several runs, such as --seeds 0-9, got one, which cannot be shared"
        )
    return Executor()


def _play_old(root: Path, threads: int | None, where: str | None) -> None:
    # The job is read inside the block: reading it may fail or take some time.
    with _resumable(root):
        job = found_job(root)
        elsewhere = _elsewhere(job, where, threads)
        try:
            check_job(job, root, elsewhere, threads)
        except ValueError as error:
            # The package of a learner of the user's own may be missing, or have changed.
            raise click.ClickException(str(error)) from error
        _play(job, root, threads, where, new=False)


def _play(job: Job, root: Path, threads: int | None, where: str | None, *, new: bool) -> None:
    """Play a job, and report the results; exit code 1 if runs failed."""
    with on_cluster(where, threads, root, job.runs.values()) as executor:
        results, failed = play_runs(job, root, threads, executor, new=new)
    report(job, results, root, failed, threads)
    if failed:
        lines = "".join(f"\n  {path}: {problem}" for path, problem in failed.items())
        raise click.ClickException(
            f"{len(failed)} of {len(job.runs)} runs failed:{lines}\nTo try them again:\n"
            f"  {resume_command(root)}"
        )


@contextmanager
def _resumable(root: Path) -> Iterator[None]:
    """Tell the user how to continue after Ctrl-C, or an error such as a full disk.

    An error in the code of the user's own learner keeps its traceback.
    """
    hint = f"\nStopped. Finished parts are saved; to continue:\n  {resume_command(root)}"
    try:
        yield
    except KeyboardInterrupt:
        if not can_resume(root):  # stopped before anything was made: the command itself is repeated
            raise
        note(hint)
        raise click.exceptions.Exit(INTERRUPTED) from None
    except (BrokenExecutor, OSError, PluginError):
        note(hint)
        raise


def _refuse_settings(output: Path | None, given: dict[str, Any]) -> None:
    names = [*(["OUTPUT"] if output else []), *map(option_name, given)]
    if names:
        raise click.UsageError(
            f"--resume: expected no settings beside it, because a run keeps its own, got "
            f"{', '.join(names)}"
        )


def _new_directory(output: Path | None, default: Path) -> Path:
    """Return the directory of new runs, and print it if it is not `output`."""
    root = output or default
    if root.exists():
        _check_free(root)
    if output is None:
        note(f"Output directory: {root}")
    return root


def _check_free(root: Path) -> None:
    try:
        RunDirectory(root).check_empty()
    except FileExistsError as error:
        hint = (
            f"; {resume_command(root)} continues the run in it, or prints its result again"
            if can_resume(root)
            else ""
        )
        raise click.UsageError(
            f"OUTPUT: expected a new or empty directory, got {str(root)!r}{hint}"
        ) from error
