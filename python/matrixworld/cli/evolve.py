"""``matrixworld evolve``: start the runs of a job or continue them, and report their results."""

from __future__ import annotations

import time
import traceback
from collections.abc import Iterator, Mapping
from concurrent.futures import CancelledError, Executor
from contextlib import contextmanager
from itertools import groupby
from pathlib import Path, PurePath
from typing import Any, NamedTuple

import click

from matrixworld._util.exit_codes import INTERRUPTED
from matrixworld._util.files import DamagedFileError, LockedError
from matrixworld._util.sections import names_in
from matrixworld.cli import cluster, console, options, pages, setting_options
from matrixworld.cli.report import counted_runs, report
from matrixworld.coevolution import Progress, ProgressBar
from matrixworld.coevolution.jobs import job as jobs
from matrixworld.coevolution.jobs.job import Job
from matrixworld.coevolution.jobs.play import play_job
from matrixworld.coevolution.learners.learner import Learner
from matrixworld.coevolution.runs.places import check_empty, find_runs
from matrixworld.coevolution.settings.schedules import ALL_SCHEDULES, Against, AtOnce, SelfPlay
from matrixworld.explorer import evolve_page
from matrixworld.explorer.page import write_page
from matrixworld.explorer.runs_page import MOST_RUNS, PAGE, GrowingPage
from matrixworld.world.config import WORLDS, WorldConfig
from matrixworld.world.rules import RULES_HEAD, VARIANTS, rules_row, variant_name

PAGE_HINT = "Watch a small race evolve in your browser meanwhile: matrixworld evolve --page"


# The table of variants:

VARIANT_LEGEND = """\
Obstacle, teammate, adversary: what happens to an agent that collides with an obstacle or the
border, with a teammate, with an adversary. It reaches the cell, bounces back to its own cell, or
disappears.
Occupation: a pursuer captures an evader by reaching its cell. Surrounding: pursuers, obstacles and
the border on all four sides capture an evader.
Other rules can be made in Python: matrixworld.Rules(...)."""
WORLD_LEGEND = """\
In these worlds neither of two good teams wins nearly all matches: scripts, and ratings that raced.
Other options change them, as in --world NAME --n-pursuers 6. In Python: matrixworld.WORLDS."""


def _print_variants(ctx: click.Context) -> None:
    rows = [[*RULES_HEAD], *(rules_row(name, rules) for name, rules in VARIANTS.items())]
    console.print_table(rows, "<" * len(RULES_HEAD))
    console.say(f"\n{VARIANT_LEGEND}")


def _print_worlds(ctx: click.Context) -> None:
    rows = [["world", "variant", "cells", "pursuers", "evaders", "obstacles", "steps"]]
    for name, world in ((name, WorldConfig.of(name)) for name in WORLDS):
        numbers = (world.n_pursuers, world.n_evaders, f"{world.density:.0%}", world.max_steps)
        cells = f"{world.rows} x {world.cols}"
        rows.append([name, variant_name(world.rules), cells, *map(str, numbers)])
    console.print_table(rows, "<<<>>>>")
    console.say(f"\n{WORLD_LEGEND}")


def _write_page(ctx: click.Context) -> None:
    page = Path(evolve_page.PAGE)
    options.check_outputs(page, force=False)
    write_page(page, evolve_page.evolve_page())
    console.say(page)
    pages.open_page(page, opens=True)


SHOWS = {
    "page": (_write_page, f"write {evolve_page.PAGE}, on which a small race evolves, and open it"),
    "variants": (_print_variants, "print the nine variants of the game as a table of rules"),
    "worlds": (_print_worlds, "print the worlds that have names as a table"),
    "help_all": (setting_options.help_all, "print this page and all settings"),
}
"""Options that print or write something, and the command does nothing else."""


def _shows(function: Any) -> Any:
    for name, (_, text) in reversed(SHOWS.items()):
        function = click.option(options.option_name(name), is_flag=True, help=text)(function)
    return function


@click.command("evolve")
@click.option(
    "--out",
    "-o",
    "output",
    type=click.Path(path_type=Path, file_okay=False),
    metavar="DIR",
    help="a new directory for the runs  [default: in runs/, named after world and seed]",
)
@click.option(
    "--game",
    metavar="MODULE:OBJECT",
    help="a game of your own, a matrixworld.Game in a module that can be imported  [default: "
    "pursuit and evasion]",
)
@click.option(
    "--world",
    type=click.Choice([*WORLDS]),
    metavar="NAME",
    help=f"a balanced world: {', '.join(WORLDS)}; --worlds explains them  [default: courtyard]",
)
@options.shared("variant", "rows", "cols", "n_pursuers", "n_evaders")
@click.option(
    "--paper",
    is_flag=True,
    help="networks over cells in the paper's world, O on 40 x 40 cells, in place of ratings in the "
    "courtyard",
)
@click.option(
    "--schedule",
    type=click.Choice([*ALL_SCHEDULES, SelfPlay.kind, Against.kind]),
    multiple=True,
    metavar="NAME",
    help=f"opponents of each team: {', '.join(ALL_SCHEDULES)}; {SelfPlay.kind}: one population "
    f"meets its past; or {Against.kind}: one team evolves alone; may be given several times  "
    f"[default: {', '.join(setting_options.MAIN_JOB)}; of one population {AtOnce.kind}]",
)
@click.option(
    "--learner",
    metavar="NAME",
    help=f"{', '.join(names_in(Learner))}, or one of your own, as module:object  [default: cma "
    "for ratings, es for other policies and with --paper]",
)
@click.option(
    "--generations",
    type=int,
    metavar="INTEGER",
    help="generations of a race; with --resume, a race goes on until it has as many  [default: 30]",
)
@options.shared("seed", "seeds", "threads", "cluster")
@click.option(
    "--resume",
    "resumed",
    type=click.Path(path_type=Path),
    metavar="DIR",
    help="continue the run, or all runs, in this directory",
)
@click.option(
    "--force", is_flag=True, help="with --resume: go on although the source of the game has changed"
)
@click.option(
    "--set",
    "sets",
    multiple=True,
    callback=setting_options.pairs,
    metavar="PATH=VALUE",
    help="any other setting, such as learner.sigma=0.1; evolve --help-all lists them; may be given "
    "several times",
)
@click.option(
    "--config",
    type=click.Path(exists=True, dir_okay=False, path_type=Path),
    callback=setting_options.configured,
    metavar="FILE",
    help="settings from a .toml file, or the config.json of a run, in place of those of --paper; "
    "options replace them",
)
@_shows
def evolve_command(
    output: Path | None,
    resumed: Path | None,
    force: bool,
    threads: int | None,
    where: str | None,
    **settings: Any,
) -> None:
    """Let two populations evolve against each other: pursuers and evaders, or those of your game.

    Without options: three races at equal numbers of training matches, of policies that one can
    read, in a balanced world. In the first, each team learns against the newest opponents only
    (specialists), in the second against living ones and a hall of fame, in the third against all
    earlier generations (generalists). A race ends with a payoff matrix, a judgement, scores against
    held-out opponents and figures. With --schedule against the team schedule.team evolves alone,
    against the fixed opponents schedule.opponent: a script, the last generation of a run, or
    another player, such as a file of Python (which is run) or a line of text. With --seeds there is
    a run of each seed.

    The directory of --out receives one run directory for each run: SCHEDULE/seed-NUMBER. A run that
    exists is never replaced. Several runs play side by side, as many as --threads, on which results
    do not depend. Ctrl-C stops; --resume continues from the last checkpoint, with the same results.
    explorer.html in the directory shows the first runs while they go on.

    With --cluster several runs play on the workers of a Dask cluster, one thread each. All workers
    must see the directory under the same path; docs/cluster.md says how to start them.

    \b
    Examples:
      matrixworld evolve
      matrixworld evolve --out my-race --variant SB --schedule generalist-generalist
      matrixworld evolve --out my-races --seeds 0-9
      matrixworld evolve --out my-evaders --schedule against --set schedule.team=evader
      matrixworld evolve --out my-race --learner ga --set learner.mutation=0.1
      matrixworld evolve --resume my-race
    """
    context = click.get_current_context()
    names = options.names_given()
    shows = SHOWS.keys() & names
    if shows:
        name = min(shows)
        options.refuse_beside(options.option_name(name), names - {name})
        show, _ = SHOWS[name]
        show(context)
        return
    chosen = {name: value for name, value in settings.items() if name in names}
    with console.warnings_as_notes():
        if resumed is None:
            plan = _new_plan(chosen, output, force=force)
        else:
            plan = _stored_plan(resumed, chosen, output, force=force)
        # Some settings can be checked only when opponents and start genomes have been read.
        with setting_options.usage_errors():
            jobs.check_job(plan.job, plan.root, threads, elsewhere=where is not None)
        began = time.monotonic()
        with _resumable(plan.root, where):
            with cluster.on_cluster(where, threads) as executor:
                jobs.create_job(plan.job, plan.root)
                console.note(f"{plan.root / PAGE} shows the runs while they go on.")
                console.note(plan.sentence)
                if resumed is None and not chosen:
                    console.note(PAGE_HINT)
                failed = play(plan, threads, executor)
            finished = [path for path in plan.paths if path not in failed]
            report(plan.job, plan.root, finished, failed, began, threads)
        if failed:
            lines = "".join(f"\n  {path}: {problem}" for path, problem in failed.items())
            raise click.ClickException(
                f"{len(failed)} of {console.counted(len(plan.job), 'run')} failed:{lines}\n"
                f"To try them again:\n  {options.resume_command(plan.root)}"
            )


@contextmanager
def _resumable(root: Path, where: str | None) -> Iterator[None]:
    """Tell the user how to continue after Ctrl-C, or an error such as a full disk.

    `where` is the cluster that plays, if there is one.
    """
    try:
        yield
    except (Exception, KeyboardInterrupt) as error:
        # Stopped before anything was made, the command itself is repeated; damage stays.
        known = click.ClickException | DamagedFileError | LockedError | cluster.OtherWorkerError
        if isinstance(error, known) or not find_runs(root):
            raise
        again = options.resume_command(root)
        console.note(f"\nStopped. Finished parts are saved; to continue:\n  {again}")
        if where not in (None, cluster.AUTO):
            console.note(
                "Runs that have begun go on at the workers; wait for them before --resume."
            )
        if isinstance(error, KeyboardInterrupt):
            raise click.exceptions.Exit(INTERRUPTED) from None
        raise


# Plans:


class Plan(NamedTuple):
    """What is going to be played, and where."""

    root: Path
    job: Job

    @property
    def paths(self) -> list[Path]:
        """The directories of the runs."""
        return [self.root / name for name in self.job]

    @property
    def sentence(self) -> str:
        """The plan in words."""
        settings = next(iter(self.job.values()))
        count = counted_runs(len(self.job), self.job.values())
        return f"{console.place_of(settings)}, {count}, in {self.root}"


def job_of(chosen: Mapping[str, Any]) -> Job:
    """Return the job of the runs that options ask for, of several schedules and seeds."""
    seeds = chosen.get("seeds")
    if seeds is not None and "seed" in chosen:
        raise click.UsageError("--seeds: expected it without --seed, got both")
    settings = setting_options.settings_of(chosen)
    if seeds is not None:
        settings = [each.changed({"seed": seed}) for each in settings for seed in seeds]
    with setting_options.usage_errors():
        return jobs.job_of(settings)


def _new_plan(chosen: Mapping[str, Any], output: Path | None, *, force: bool) -> Plan:
    """Return the job that options ask for, in a new directory."""
    if force:
        raise click.UsageError("--force: expected --resume beside it, got none")
    job = job_of(chosen)
    root = output or jobs.default_directory(job)
    try:
        check_empty(root)
    except FileExistsError as error:
        message = f"--out: expected a new or empty directory, got {str(root)!r}"
        if find_runs(root):
            again = "continues the run in it, or prints its result again"
            message = f"{message}; {options.resume_command(root)} {again}"
        raise click.UsageError(message) from error
    return Plan(root, job)


def _stored_plan(
    root: Path, chosen: Mapping[str, Any], output: Path | None, *, force: bool
) -> Plan:
    """Return the job of a directory that holds runs; its races become longer if that is asked."""
    if not find_runs(root):
        refused = options.refusal(root, "a directory that holds a run")
        raise click.UsageError(f"--resume: {refused}")
    beside = [name for name in chosen if name != "generations"]
    if output is not None:
        beside.append("output")
    options.refuse_beside("--resume", beside, ": a run keeps its own, all but --generations")
    with setting_options.usage_errors():
        jobs.change_settings(root, generations=chosen.get("generations"), force=force)
        job = jobs.found_job(root)
        for game in {settings.game for settings in job.values()}:
            game.evaluation()  # the page plays it, even if all runs are finished
    return Plan(root, job)


# Playing:


def shown(job: Job) -> list[str]:
    """Return the runs that go on and are shown: those of the page of finished runs."""
    groups = [[*names] for _, names in groupby(job, key=lambda name: PurePath(name).parent)]
    return pages.first_seeds(groups, MOST_RUNS)


def play(plan: Plan, threads: int | None, executor: Executor | None) -> dict[Path, str]:
    """Play the runs of a job; return why runs failed, by their directories.

    The page shows the runs while they go on. The error of a single run is raised, and that of a
    cluster that is lost.
    """
    page = GrowingPage(plan.root, shown(plan.job))
    with ProgressBar() as bar:

        def tell(progress: Progress) -> None:
            bar(progress)
            page.write()

        errors = play_job(plan.job, plan.root, executor=executor, threads=threads, report=tell)
    if errors and len(plan.job) == 1:
        [error] = errors.values()
        raise error  # as it is: one sentence, or the traceback of the user's own code
    cancelled = [error for error in errors.values() if isinstance(error, CancelledError)]
    if cancelled:  # the cluster is lost, and all runs with it
        raise cancelled[0]
    for error in errors.values():
        if not isinstance(error, options.FAILURES):  # such as of the user's own code
            console.note("".join(traceback.format_exception(error)))
    failures = {plan.root / name: error for name, error in errors.items()}
    return {path: jobs.described(path, error) for path, error in failures.items()}
