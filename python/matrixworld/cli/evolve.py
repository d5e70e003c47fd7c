"""``matrixworld evolve``: start the runs of a job or continue them, and report their results."""

from __future__ import annotations

import shlex
import time
import traceback
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import Executor
from contextlib import contextmanager
from dataclasses import replace
from itertools import groupby
from pathlib import Path, PurePath
from typing import Any

import click
from tqdm import tqdm

from matrixworld.__main__ import INTERRUPTED
from matrixworld._util import checks
from matrixworld._util.files import DamagedFileError, LockedError, save_json
from matrixworld.analysis import sentence
from matrixworld.cli import cluster, console, options, pages, setting_options
from matrixworld.coevolution import Progress, ProgressBar, SavedRun, jobs, storage
from matrixworld.coevolution.evaluation.explanation import sentence_of
from matrixworld.coevolution.evaluation.scores import kept_scores
from matrixworld.coevolution.groups import RunGroup, by_clarity, grouped
from matrixworld.coevolution.race import ALL_SCHEDULES, Against
from matrixworld.coevolution.sections import kinds_in
from matrixworld.coevolution.types import TEAMS, other
from matrixworld.explorer import evolve_page
from matrixworld.explorer.page import write_page
from matrixworld.explorer.runs_page import MOST_RUNS, PAGE, GrowingPage
from matrixworld.world.config import WORLDS, WorldConfig, world_name
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
In these worlds good teams of both sides win about half: the best scripts, and ratings that raced.
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
    help=f"a world in which good teams win about half: {', '.join(WORLDS)}; --worlds explains "
    "them  [default: courtyard]",
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
    type=click.Choice([*ALL_SCHEDULES, Against.kind]),
    multiple=True,
    metavar="NAME",
    help=f"opponents of each team: {', '.join(ALL_SCHEDULES)}; or {Against.kind}: one team evolves "
    f"alone; may be given several times  [default: {', '.join(setting_options.MAIN_JOB)}]",
)
@click.option(
    "--learner",
    metavar="NAME",
    help=f"{', '.join(kinds_in(setting_options.HINTS['learner']))}, or one of your own, as "
    "module:object  [default: es]",
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
    read, in a world in which good teams win about half. In the first, each team learns against the
    newest opponents only (specialists), in the second against living ones and a hall of fame, in
    the third against all earlier generations (generalists). A race ends with a
    payoff matrix, a judgement, scores against held-out opponents and figures. With --schedule
    against the team schedule.team evolves alone, against the fixed opponents schedule.opponent: a
    script, or the last generation of a run. With --seeds there is a run of each seed.

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
    everything = options.given(context.params)
    for name in SHOWS.keys() & everything:
        options.refuse_beside(options.option_name(name), [n for n in everything if n != name])
        SHOWS[name][0](context)
        return
    given = options.given({n: each for n, each in settings.items() if n not in SHOWS})
    with console.warnings_as_notes():
        if resumed is None:
            checks.expect(not force, "--force", "--resume beside it", "none", click.UsageError)
            root, job = _new_job(given, output)
        else:
            root, job = _found(resumed, given, output, force=force)
        # Some settings can be checked only when opponents and start genomes have been read.
        with setting_options.usage_errors():
            jobs.check_job(job, root, threads, elsewhere=where is not None)
        began = time.monotonic()
        with _resumable(root):
            with cluster.on_cluster(where, threads) as executor:
                jobs.create_job(job, root)
                console.note(f"{root / PAGE} shows the runs while they go on.")
                console.note(_plan(job, root))
                if resumed is None and not given:
                    console.note(PAGE_HINT)
                results, failed = play(job, root, threads, executor)
            report(job, root, results, failed, began, threads)
        if failed:
            lines = "".join(f"\n  {path}: {problem}" for path, problem in failed.items())
            raise click.ClickException(
                f"{len(failed)} of {len(job)} runs failed:{lines}\nTo try them again:\n"
                f"  {options.resume_command(root)}"
            )


@contextmanager
def _resumable(root: Path) -> Iterator[None]:
    """Tell the user how to continue after Ctrl-C, or an error such as a full disk."""
    try:
        yield
    except (Exception, KeyboardInterrupt) as error:
        # Stopped before anything was made, the command itself is repeated; damage stays.
        known = click.ClickException | DamagedFileError | LockedError
        if isinstance(error, known) or not storage.find_runs(root):
            raise
        again = options.resume_command(root)
        console.note(f"\nStopped. Finished parts are saved; to continue:\n  {again}")
        if isinstance(error, KeyboardInterrupt):
            raise click.exceptions.Exit(INTERRUPTED) from None
        raise


# Jobs:


def job_of(given: Mapping[str, Any]) -> jobs.Job:
    """Return the job of the runs that options ask for, of several schedules and seeds."""
    seeds, one = given.get("seeds"), "seeds" not in given or "seed" not in given
    checks.expect(one, "--seeds", "it without --seed", "both", click.UsageError)
    # The order in which find_runs finds them, so that --resume prints and draws the same.
    settings = setting_options.settings_of(given)
    settings.sort(key=lambda each: storage.place_in_job(each.schedule.name))
    if seeds is not None:
        settings = [replace(each, seed=seed) for each in settings for seed in seeds]
    with setting_options.usage_errors():
        return jobs.job_of(settings)


def _new_job(given: Mapping[str, Any], output: Path | None) -> tuple[Path, jobs.Job]:
    """Return a new directory, and the job that options ask for."""
    job = job_of(given)
    root = output or jobs.default_directory(job)
    try:
        storage.check_empty(root)
    except FileExistsError as error:
        told = f"--out: expected a new or empty directory, got {str(root)!r}"
        if storage.find_runs(root):
            again = "continues the run in it, or prints its result again"
            told = f"{told}; {options.resume_command(root)} {again}"
        raise click.UsageError(told) from error
    return root, job


def _found(
    root: Path, given: Mapping[str, Any], output: Path | None, *, force: bool
) -> tuple[Path, jobs.Job]:
    """Return a directory that holds runs, and its job; its races become longer if that is asked."""
    if not storage.find_runs(root):
        refused = options.refusal(root, "a directory that holds a run")
        raise click.UsageError(f"--resume: {refused}")
    generations = given.get("generations")
    beside = [*(["output"] if output else []), *(name for name in given if name != "generations")]
    options.refuse_beside("--resume", beside, ": a run keeps its own, all but --generations")
    with setting_options.usage_errors():
        jobs.change(root, generations=generations, force=force)
    return root, jobs.found_job(root)


def _plan(job: jobs.Job, root: Path) -> str:
    """Return what is going to be played, and where."""
    first, *_ = settings = [*job.values()]
    world, what = first.world, "race" if all(each.is_race for each in settings) else "run"
    teams = " and ".join(first.teams)
    if world:
        teams = f"{world.n_pursuers} pursuers and {world.n_evaders} evaders"
    count = f"{len(settings)} {what}{'s' * (len(settings) > 1)}"
    name = world and world_name(world)
    variant = f"{name} ({first.variant})" if name else first.variant
    return f"{variant}, {teams}, {count}, in {root}"


def shown(job: jobs.Job) -> list[str]:
    """Return the runs that go on and are shown: those of the page of finished runs."""
    groups = [[*names] for _, names in groupby(job, key=lambda name: PurePath(name).parent)]
    return pages.first_seeds(groups, MOST_RUNS)


def play(
    job: jobs.Job, root: Path, threads: int | None, executor: Executor | None
) -> tuple[list[SavedRun], dict[Path, str]]:
    """Play the runs of a job; return the finished ones, and why the others failed.

    The page shows the runs while they go on. The error of a single run is raised.
    """
    page = GrowingPage(root, shown(job))

    def tell(progress: Progress) -> None:
        bar(progress)
        page.write()

    with ProgressBar() as bar:
        errors = jobs.play_job(job, root, executor=executor, threads=threads, report=tell)
    for error in errors.values():
        if len(job) == 1:
            raise error  # as it is: one sentence, or the traceback of the user's own code
        if not isinstance(error, options.FAILURES):  # such as of the user's own code
            console.note("".join(traceback.format_exception(error)))
    failed = {root / name: jobs.described(root / name, error) for name, error in errors.items()}
    return [SavedRun(root / name) for name in job if name not in errors], failed


# The report at the end: what a newcomer asks first. Tables and intervals are those of `judge`.


def report(
    job: jobs.Job,
    root: Path,
    results: Sequence[SavedRun],
    failed: Mapping[Path, str],
    began: float,
    threads: int | None = None,
) -> None:
    """Score and judge the finished runs of a job, draw figures, and print the results.

    `failed` says why other runs of the job failed, by their directories; `began` is the time of
    `time.monotonic` when it began.
    """
    runs = [SavedRun(root / name) for name in job]
    for run, settings in zip(runs, job.values(), strict=True):
        run.settings = settings  # a run that has failed may have lost its own
    found = grouped(runs, finished=[run.path for run in results])
    groups = [group.inside(root) for group in found]
    finished = [group for group in groups if group.runs]
    races = [group for group in finished if group.is_race]
    with ProgressBar() as bar:
        of_pursuit = [group for group in races if not group.runs[0].settings.game]
        kept_scores([run for g in of_pursuit for run in g.runs], threads=threads, report=bar)
    if finished:
        draw(finished, root)
    took = tqdm.format_interval(time.monotonic() - began)
    # The summary of a run that was started by itself lies in the same directory.
    if root not in [run.path for run in results]:
        singles = [single for group in finished for single in group.singles]
        numbers = {
            "groups": {group.name: group.to_json() for group in groups},
            "runs": {_place(one.runs[0].path, root): one.run_to_json() for one in singles},
            "failed": {_place(path, root): problem for path, problem in failed.items()},
        }
        save_json(root / "summary.json", numbers)
    what = "races" if len(races) == len(finished) else "runs"
    done = f"1 {what[:-1]} done" if len(results) == 1 else f"{len(results)} {what} done"
    page = f" Open {root / PAGE}" if finished else ""
    console.say(f"{done} in {took}.{page}", bold=True)
    for group in by_clarity(groups):
        console.print_head(group.name)
        console.print_wrapped("\n".join(_lines(group)))
        console.print_missing(group)
    if any(group.several for group in races):
        clearest = by_clarity([single for group in races for single in group.singles])[0]
        console.print_head(f"The clearest race: {clearest.inside(root).name}")
        console.print_wrapped(sentence(clearest.judgement))
    if of_pursuit:
        console.say()
        console.print_table(_against_strangers(of_pursuit), "<<<")
    for group in of_pursuit:
        if words := [said for team in TEAMS if (said := sentence_of(group.runs[0], team))]:
            console.print_head(f"What evolved: {group.name}, seed {group.seeds[0]}")
            console.print_wrapped("\n".join(words))
    for path, problem in failed.items():
        console.print_wrapped(f"Failed: {path}: {problem}")
    for why, typed in _hints(finished, root) if finished else ():
        console.say(f"\n{why}\n  {typed}")


def _against_strangers(groups: Sequence[RunGroup]) -> list[list[str]]:
    """Return a table of the scores of races against held-out opponents, and what stands beside."""
    beside = [kept_scores(groups[0].runs)[0][f"{team}s"] for team in TEAMS]
    scripts = [each["best script"] for each in beside]
    return [
        ["score against strangers", "pursuers", "evaders"],
        *([g.name, *(f"{g.held_out(team).mean():.2f}" for team in TEAMS)] for g in groups),
        ["the best script", *(f"{value:.2f} {name}" for name, value in scripts)],
        ["untrained teams", *(f"{each['untrained']:.2f}" for each in beside)],
    ]


def draw(groups: Sequence[RunGroup], root: Path) -> None:
    """Draw the figures and write the page; figures of an earlier report are replaced."""
    from matrixworld import plots
    from matrixworld.plots.saved import figures_of

    files = figures_of(groups, root)
    with ProgressBar() as bar:
        for number, (file, figure) in enumerate(files.items()):
            bar(Progress("draw figures", number, len(files)))
            plots.save_figure(figure(), file)
    pages.write_explorer(groups, root / PAGE)


def _lines(group: RunGroup) -> list[str]:
    if not group.runs:
        return [console.seeds_finished(group)]
    if group.is_race:
        return [sentence(group.judgement)]
    settings, means = group.runs[0].settings, group.means()
    schedule = settings.schedule
    assert isinstance(schedule, Against)  # one team evolved
    team = settings.teams[TEAMS.index(schedule.team)]
    lines = [
        f"{settings.kind_of_game.score_words[0]} {next(iter(means.values()))}",
        f"{team} after {schedule.epochs:,} epochs against {schedule.opponent}",
    ]
    if "length" in means:
        lines.append(f"an episode takes {means['length'].value:.0f} steps")
    return lines


def _hints(groups: Sequence[RunGroup], root: Path) -> list[tuple[str, str]]:
    """Return what to do next, and the command for it."""
    last = groups[-1].runs[-1]
    schedule = last.settings.schedule
    path = root if sum(len(group.runs) for group in groups) == 1 else last.path
    if isinstance(schedule, Against):
        team = f"--set schedule.team={other(schedule.team)}"
        met = f"--set schedule.opponent={shlex.quote(str(path))}"
        same = ("evolve --config", last.path / "config.json", team, met)
        untrained = "--set schedule.start=null"
        opponent = console.command(*same, *([untrained] if schedule.start else []))
        return [("Watch it:", console.command("replay", path)), ("Its opponent learns:", opponent)]
    more = ("Verdict on each seed:", console.command("judge --each", root))
    if not any(group.several for group in groups):
        why = "One seed is one anecdote; with your other options:"
        more = (why, console.command("evolve --seeds 0-9"))
    return [more, ("Reasons and intervals:", console.command("judge --explain", root))]


def _place(path: Path, root: Path) -> str:
    return path.relative_to(root).as_posix()
