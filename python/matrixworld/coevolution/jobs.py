"""Jobs: runs that were asked for together, played side by side, here or by any executor.

All runs of a job are made before any of them begins, so that a job that is stopped, even at once,
is the directories of its runs: what is missing is what is not finished. Runs go on from their last
stage, whether they were stopped, crashed, or lost their worker. Their progress is what they have
saved.
"""

from __future__ import annotations

import concurrent.futures
import itertools
import multiprocessing
import os
import re
import signal
import threading
import warnings
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import BrokenExecutor, Executor, Future, ProcessPoolExecutor, wait
from contextlib import contextmanager, nullcontext
from dataclasses import replace
from multiprocessing import connection, resource_tracker
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

from matrixworld._util import checks, files, imports
from matrixworld.coevolution import progress, pursuit, run, storage, types
from matrixworld.coevolution.learners.learner import table_length
from matrixworld.coevolution.progress import SECONDS, OnEpoch, Progress, Report, StopRun, silent
from matrixworld.coevolution.settings import RaceSettings

NAME = re.compile(r"\w[\w.=+-]*(/\w[\w.=+-]*)?")
"""Names of runs: relative paths of one or two parts that every system accepts."""
ITSELF = "."  # name of the only run of a job whose directory is that of the run
FEW = 3
"""Most runs, such as those of a default `matrixworld evolve`, whose first one should end early."""

RUNS = Path("runs")  # parent directory of runs for which no directory is given

Job = Mapping[str, RaceSettings]
"""Runs that were asked for together: settings by the path of a run's directory in the job's."""


def job_of(settings: RaceSettings | Sequence[RaceSettings] | Mapping[str, RaceSettings]) -> Job:
    """Return the job of these settings, perhaps by name; of several each gets a name."""
    if isinstance(settings, RaceSettings):
        return {ITSELF: _from_anywhere(settings)}
    given: Any = settings
    if not isinstance(given, Sequence | Mapping):  # a set has no order
        expected = "RaceSettings, or a sequence or mapping of them"
        raise TypeError(f"settings: expected {expected}, got {checks.shown(given)}")
    named = given.items() if isinstance(given, Mapping) else ((None, each) for each in given)
    runs: dict[str, RaceSettings] = {}
    names: dict[RaceSettings, str] = {}
    for key, each in named:
        checks.check_instance("settings", each, RaceSettings)
        name = f"{each.schedule.name}/seed-{each.seed}" if key is None else key
        fits, expected = NAME.fullmatch(str(name)), "names such as sigma-0.1 or sigma-0.1/seed-3"
        checks.expect(fits and name == str(name), "settings", expected, checks.shown(name))
        expected = "runs of different schedules or seeds, or a name for each"
        checks.expect(name not in runs, "settings", expected, f"two of {name}")
        runs[name] = _from_anywhere(each)
        # Equal runs are no independent observations.
        other = names.setdefault(runs[name], name)
        got = f"{other} and {name}, equal"
        checks.expect(other == name, "settings", "different runs", got)
    checks.expect(len(runs), "settings", "at least one run", "none")
    return runs


def _from_anywhere(settings: RaceSettings) -> RaceSettings:
    """Return settings whose paths mean the same in another current directory, as workers have."""
    paths = {name: getattr(settings.schedule, name, None) for name in ("opponent", "start")}
    absolute: dict[str, Any] = {
        name: str(Path(path).absolute())
        for name, path in paths.items()
        if path is not None and path not in pursuit.SCRIPTS
    }
    return replace(settings, schedule=replace(settings.schedule, **absolute))


def default_directory(job: Job) -> Path:
    """Return a new directory named after a job, such as ``runs/O-seeds0-9`` or ``...-9-2``."""
    settings = next(iter(job.values()))
    seeds = [*dict.fromkeys(each.seed for each in job.values())]
    named = f"{seeds[0]}-{seeds[-1]}"
    if seeds != [*range(seeds[0], seeds[0] + len(seeds))]:
        named = storage.some([*map(str, seeds)]).replace(", ", ",")
    seed = f"seeds{named}" if len(seeds) > 1 else f"seed{seeds[0]}"
    what = "" if settings.is_race else f"-{settings.schedule.name}"
    world = settings.world and pursuit.world_name(settings.world)
    first = RUNS / f"{world or settings.variant}{what}-{seed}"
    others = (first.with_name(f"{first.name}-{number}") for number in itertools.count(2))
    return next(path for path in itertools.chain([first], others) if not path.exists())


def found_job(root: Path) -> Job:
    """Return the job in a directory: all runs in it. Errors are those of `SavedRun.settings`."""
    paths = storage.find_runs(root)
    return {path.relative_to(root).as_posix(): storage.SavedRun(path).settings for path in paths}


def change(root: Path, *, generations: int | None = None, force: bool = False) -> None:
    """Let the races of a job become longer, all or none, and accept a changed game by force."""
    paths = storage.find_runs(root)
    if force:
        for path in paths:
            run.accept_source(path)
    if generations is not None:
        for only_check, path in itertools.product((True, False), paths):
            run.lengthen(path, generations, only_check=only_check)


class FailedRunsError(RuntimeError):
    """Some runs of a job have failed (`failures`, by directory); the others are `finished`."""

    def __init__(
        self, failures: Mapping[Path, BaseException], finished: Sequence[storage.SavedRun] = ()
    ) -> None:
        super().__init__(failures, finished)
        self.failures: dict[Path, BaseException] = dict(failures)
        self.finished: list[storage.SavedRun] = list(finished)

    def __str__(self) -> str:
        """Return a line for each failed run."""
        lines = [f"{path}: {described(path, error)}" for path, error in self.failures.items()]
        return "\n".join([f"{len(lines)} runs failed:", *lines])


def described(path: Path, error: BaseException) -> str:
    """Return an error of a run in words, without the path if the message begins with it."""
    kind, text = type(error), files.sentence_of(error) or type(error).__name__
    # Such as KeyError, in the user's own code: its message alone says little.
    if kind.__module__ == "builtins" and not isinstance(error, OSError | ValueError):
        text = f"{kind.__name__}: {error}"
    return text.removeprefix(f"{path.absolute()}: ").removeprefix(f"{path}: ")


# Jobs as a whole:


def evolve(
    settings: RaceSettings
    | Sequence[RaceSettings]
    | Mapping[str, RaceSettings]
    | str
    | None = None,
    out: str | Path | None = None,
    *,
    seeds: Sequence[int] | None = None,
    executor: Executor | None = None,
    threads: int | None = None,
    report: Report = silent,
    on_epoch: OnEpoch | None = None,
    **named: Any,
) -> Any:
    """Return the finished runs of these settings: start them, continue them, or only open them.

    The runs are in the order of the settings. After Ctrl-C, a crash or a failure, the same call
    continues. Each run directory has the same bytes, whatever the executor, the threads and the
    order.

    In a script, call it below ``if __name__ == "__main__":``, as everything that starts processes.

    Parameters
    ----------
    settings : RaceSettings, or a sequence or mapping of them; or str, optional
        Settings of a run, which is then made in `out` itself; or of each run, by the names of their
        directories in it, such as ``sigma-0.1/seed-3``, without names ``<schedule>/seed-<n>``. By
        default the run has the settings that are `named`; a text is then its variant.
    out : str or Path, optional
        A new or empty directory, or that of the same runs, which are continued. By default one in
        ``runs/`` that is named after variant and seeds.
    seeds : sequence of int, optional
        Seeds, of each of which there is a run of the same settings.
    executor : concurrent.futures.Executor, optional
        Plays the runs, one thread each, wherever the directory has the same path:
        `concurrent.futures`, MPI, loky and Dask (``Client.get_executor(pure=False)``) serve. By
        default the runs have processes of this machine; a single run is played in this one.
    threads : int, optional
        Threads in all, without an executor. By default one per usable core.
    report : callable, optional
        Called often with a `Progress`, such as a `ProgressBar`.
    on_epoch : callable, optional
        Called in this process after each epoch with a dict: the columns of ``log.csv``, ``run``
        (its name in the job, or that of the directory) and ``seed``. With several runs the rows of
        a stage come when it has been saved. What it raises, such as `StopRun`, ends this call.
    **named
        Settings by the last part of their path, such as ``learner="ga"`` or ``population=32``; see
        `RaceSettings.of`.

    Returns
    -------
    SavedRun or list of SavedRun
        The run of settings without `seeds`, else those of all settings and seeds.

    Raises
    ------
    FileExistsError, TypeError, ValueError
        If settings are bad or need too much memory, two runs have the same name, or the directory
        holds something else, such as other runs. Nothing is written then.
    FailedRunsError, BrokenExecutor
        If runs failed, after all others have ended, or a process or worker has died.
    """
    job = job_of(_asked(settings, seeds, named))
    root = default_directory(job) if out is None else Path(out)
    if executor is not None:
        checks.check_instance("executor", executor, Executor)
        checks.expect(threads is None, "threads", "None with an executor", threads)
    check_job(job, root, threads, elsewhere=executor is not None)
    create_job(job, root)
    errors = play_job(
        job, root, executor=executor, threads=threads, report=report, on_epoch=on_epoch
    )
    if ITSELF in errors:
        raise errors[ITSELF]
    runs = [storage.open_run(root / name) for name in job if name not in errors]
    if errors:
        failures = {root / name: error for name, error in errors.items()}
        raise FailedRunsError(failures, runs) from next(iter(errors.values()))
    return runs[0] if ITSELF in job else runs


def _asked(settings: Any, seeds: Sequence[int] | None, named: Mapping[str, Any]) -> Any:
    """Return the settings that `evolve` was asked for, perhaps of several seeds."""
    if isinstance(settings, str):
        settings, named = None, {"variant": settings, **named}
    if settings is None:
        settings = RaceSettings.of(**named)
    elif named:
        expected = "RaceSettings alone, or a variant and settings by name"
        raise TypeError(f"settings: expected {expected}, got both: {', '.join(named)}")
    if seeds is None:
        return settings
    checks.check_instance("settings", settings, RaceSettings)
    every = checks.check_sequence("seeds", seeds, "integers")
    return [replace(settings, seed=seed) for seed in every]


def check_job(job: Job, root: Path, threads: int | None, *, elsewhere: bool = False) -> None:
    """Raise an error if a job cannot be made, or played here if not `elsewhere`."""
    checks.check_threads(threads)
    found = found_job(root)
    if not found:
        storage.check_empty(root)
    others = storage.some(sorted(found.keys() ^ job.keys())) if found else ""
    checks.expect(not others, str(root), "the runs of this job", f"others: {others}")
    for name in found:
        saved = storage.SavedRun(root / name)
        run.check_same(saved, job[name])
        if not saved.finished:
            run.check_source(saved)
    left = {n: each for n, each in job.items() if not storage.SavedRun(root / n).finished}
    if not elsewhere:
        at_once = shares(len(left), threads)[0]
        needed = sorted((sum(run_memory(each).values()) for each in left.values()), reverse=True)
        sizes = {f"run {i + 1}": size for i, size in enumerate(needed[:at_once])}
        checks.check_memory(f"{at_once} runs at one time" if at_once > 1 else "run", **sizes)
    # Seeds make no difference here, and a job may have a thousand.
    for method in dict.fromkeys(each.method for each in left.values()):
        for team in method.learning_teams:  # imports code of your own
            learner = method.learner_of(team)
            method.schedule.sampler(team)
            if not elsewhere:
                learner.check_machine()
        if not method.is_race and not found:
            run.check_sources(method)


def run_memory(settings: RaceSettings) -> dict[str, int]:
    """Return the bytes of a run's largest arrays, by what they hold."""
    schedule, game = settings.schedule, settings.evaluation_game
    genes = max(map(game.genome_size, types.TEAMS))
    learners = [settings.learner_of(team) for team in settings.learning_teams]
    population, teams = max(each.population for each in learners), len(learners)
    episodes = population * schedule.opponents_met * settings.match_episodes * teams
    pairs = schedule.entries**2 if settings.is_race else 1
    needed = {
        "candidates": 4 * population * 4 * genes,
        # A file of it is made in memory.
        "archive": 4 * teams * schedule.entries * 4 * genes,
        "noise": teams * 4 * table_length(genes),
        "episodes": 240 * episodes,  # twice their statistics, as `rollout` holds them
        "payoff": 90 * pairs * settings.evaluation_episodes,  # what a tournament keeps
    }
    if any("fitness" in each.ignores for each in learners):  # views, for actor and critic
        assert isinstance(game, pursuit.Pursuit)  # as these learners need
        worlds = settings.training_worlds or [replace(game.world, max_steps=settings.train_steps)]
        steps = max(w.max_steps * max(w.n_pursuers, w.n_evaders) for w in worlds)
        needed["views"] = 4 * episodes * steps * pursuit.CHANNELS * game.world.fov**2
    return needed


def create_job(job: Job, root: Path) -> None:
    """Make the directories of all runs of a job, or none of them; a job that is there stays."""
    if ITSELF in job:
        run.create(job[ITSELF], root)
    elif not storage.find_runs(root):
        with storage.new_directory(root) as place:
            for name, settings in job.items():
                run.create(settings, place / name)


def shares(runs: int, threads: int | None) -> tuple[int, int]:
    """Return how many runs play at one time, and the threads of each."""
    cores = checks.check_threads(threads)
    # A few runs more than cores share them from the beginning: the last one would play alone.
    workers = max(1, runs if runs < 2 * cores else cores)
    if runs <= FEW:  # two threads each lose little, and the first run is there in half the time
        workers = max(1, min(runs, cores // 2))
    return workers, max(1, cores // workers)


def play_job(
    job: Job,
    root: Path,
    *,
    executor: Executor | None = None,
    threads: int | None = None,
    report: Report = silent,
    on_epoch: OnEpoch | None = None,
) -> dict[str, BaseException]:
    """Play what is unfinished of a job that has been made; return the errors by name."""
    watch = _Watch(job, root, report, on_epoch)
    # If the job is stopped, its groups have about equally many seeds.
    left = sorted((n for n in job if n not in watch.ended), key=lambda n: job[n].seed)
    # No other process can import what is in a notebook.
    here = any(each.game and each.game.code.startswith("__main__:") for each in job.values())
    if executor is None and (len(left) == 1 or here or not imports.HAS_PROCESSES):
        for name in left:
            _play_here(watch, name, threads)
    elif left:
        workers, each = shares(len(left), threads) if executor is None else (1, 1)
        pool = processes(workers) if executor is None else nullcontext(executor)
        with pool as players, _submitted(players, root, left, each) as futures:
            pending = {*futures}
            while pending:
                done, pending = wait(pending, SECONDS, concurrent.futures.FIRST_COMPLETED)
                watch.look()
                for future in done:
                    _take(watch, futures[future], future)
    watch.look()
    return watch.failures


def _play_here(watch: _Watch, name: str, threads: int | None) -> None:
    """Play a run in this process: another one takes half a second to start, and hides errors."""
    on_epoch = watch.on_epoch if len(watch.job) == 1 else None  # the watch tells of several runs
    called = {} if name == ITSELF else {"run": name}
    try:
        run.finish(
            watch.root / name,
            threads=threads,
            report=lambda now: watch.tell({name: now}),
            on_epoch=on_epoch and (lambda row: on_epoch({**row, **called})),
        )
        watch.end(name)
    except StopRun:
        raise
    except Exception as error:  # noqa: BLE001, of the run
        watch.fail(name, error)


@contextmanager
def _submitted(
    executor: Executor, root: Path, names: Sequence[str], threads: int
) -> Iterator[dict[Future[storage.SavedRun], str]]:
    """Yield the futures of runs, which end with the block, and their names."""
    futures: dict[Future[storage.SavedRun], str] = {}
    try:
        with without_interrupts():  # which the processes inherit that this starts
            for name in names:
                path = (root / name).absolute()
                futures[executor.submit(run.finish, path, threads=threads)] = name
        yield futures
    except BaseException:
        # After Ctrl-C or an error: what has not begun does not begin.
        wait([future for future in futures if not future.cancel()], 0)
        raise


def _take(watch: _Watch, name: str, future: Future[storage.SavedRun]) -> None:
    """Take the result of a run that has ended."""
    try:
        future.result()
        numbers = watch.end(name)
    except BrokenExecutor as error:
        raise BrokenExecutor(
            f"{name}: expected a worker that plays it, got: {error!r}; perhaps memory or the "
            "number of processes has too low a limit, or a script has no `if __name__ == "
            '"__main__":`; finished parts are saved'
        ) from error
    except Exception as error:  # noqa: BLE001, of one run: the others go on
        watch.fail(name, error)
    else:
        progress.LOG.info("%s: ended", watch.root / name)  # its process has told it to nobody
        # The warning of the run itself stayed in its process.
        for text in numbers.get("disengagement", []):
            warnings.warn(f"{name}: {text}", run.DisengagementWarning, stacklevel=4)


class _Watch:
    """A job while it is played: what has ended, and the progress of the rest."""

    def __init__(self, job: Job, root: Path, report: Report, on_epoch: OnEpoch | None) -> None:
        self.job, self.root, self.on_epoch = job, root, on_epoch
        self._report: Callable[[Progress], None] = report
        self.failures: dict[str, BaseException] = {}
        self.ended: set[str] = set()
        # Of each run: the newest stage that was looked at, and its progress.
        self._stages: dict[str, int] = {}
        self._work: dict[str, Progress] = {}
        for name in job:
            self._begin(name)

    def _begin(self, name: str) -> None:
        """Look at what a run has saved before this start."""
        try:
            self._look_at(name)
            # A run that is a job of its own is restored in any case, to tell of any damage.
            if name != ITSELF and storage.SavedRun(self.root / name).finished:
                self.end(name)
        except (files.DamagedFileError, storage.OtherVersionError, OSError, ValueError) as error:
            self.fail(name, error)

    def fail(self, name: str, error: BaseException) -> None:
        """Count a run as failed."""
        self.failures[name] = error
        self.ended.add(name)

    def end(self, name: str) -> dict[str, Any]:
        """Count a run as finished; return its summary."""
        numbers = storage.SavedRun(self.root / name).summary()
        self.ended.add(name)
        self._look_at(name)
        return numbers

    def _look_at(self, name: str) -> None:
        """Take what a run has saved since the last look, and tell its epochs."""
        saved, settings = storage.SavedRun(self.root / name), self.job[name]
        stage, stages = saved.newest(), settings.schedule.n_stages
        total = run.total_epochs(settings)
        done = total if saved.finished else settings.schedule.epochs_until(stage)
        before = self._work[name].before if name in self._work else done
        what = f"stage {stage} of {stages}" if stage < stages else "tournament"
        self._work[name] = Progress(what, done, total, before)
        if self.on_epoch is not None and len(self.job) > 1:
            for row in saved.rows(self._stages.get(name, stage)):
                stage = row["stage"]  # it may have saved one more meanwhile
                self.on_epoch({"run": name, "seed": settings.seed, **row})
        self._stages[name] = stage

    def look(self) -> None:
        """Tell what the runs that go on have saved since the last look."""
        for name in self.job.keys() - self.ended:
            if storage.SavedRun(self.root / name).newest() > self._stages[name]:
                self._look_at(name)
        self.tell({})

    def tell(self, told: Mapping[str, Progress]) -> None:
        """Report the progress of all runs, with what those in work have told."""
        self._work |= told
        work = [each for name, each in self._work.items() if name not in self.failures]
        failed = f", {len(self.failures)} failed" if self.failures else ""
        what = f"{len(self.ended) - len(self.failures)} of {len(self.job)} runs{failed}"
        if len(self.job) == 1 and work:
            what = work[0].what
        parts = ("done", "total", "before")
        done, total, before = (sum(getattr(each, part) for each in work) for part in parts)
        self._report(Progress(what, done, max(total, 1), before))


# Processes of this machine:


@contextmanager
def processes(count: int) -> Iterator[Executor]:
    """Yield an executor with processes, which end with the block, or if this process is killed."""
    # spawn: a fork would copy locks that other threads of this process hold.
    context = multiprocessing.get_context("spawn")
    # A pipe that nothing is sent through: its end shows, also when either process is killed. An
    # Event would wait for ever for a process that died while it waited for the Event.
    reader, writer = context.Pipe(duplex=False)
    with reader, writer, ProcessPoolExecutor(count, context, _begin, (reader,)) as pool:
        try:
            yield pool
        except BaseException:
            writer.close()
            # Until they have ended, they hold the locks of their runs.
            pool.shutdown(cancel_futures=True)
            raise


@contextmanager
def without_interrupts() -> Iterator[None]:
    """Keep Ctrl-C, which a terminal sends to all, from processes that are started here."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    # Started later, it would unblock Ctrl-C in the thread that starts it.
    resource_tracker.ensure_running()
    before = signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGINT])
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _begin(parent: Connection) -> None:
    """Begin a process that ends when it is stopped, or with the process that has started it."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    # The main process warns when a run has ended, with its name.
    warnings.simplefilter("ignore", run.DisengagementWarning)
    threading.Thread(target=_end_with, args=(parent,), daemon=True).start()


def _end_with(parent: Connection) -> None:
    connection.wait([parent])
    os._exit(1)  # not sys.exit, which ends this thread only; files are safe at any moment
