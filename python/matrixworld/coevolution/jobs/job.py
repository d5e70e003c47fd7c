"""A job: runs that were asked for together, by name; its directory, and what it needs."""

from __future__ import annotations

import itertools
import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from matrixworld._util import checks, files
from matrixworld.coevolution.games.game import Game
from matrixworld.coevolution.games.pursuit import CHANNELS, PursuitSettings, world_name
from matrixworld.coevolution.learners.noise import table_length
from matrixworld.coevolution.runs import create, play
from matrixworld.coevolution.runs.places import abbreviated, check_empty, find_runs, new_directory
from matrixworld.coevolution.runs.stored import StoredRun
from matrixworld.coevolution.settings.race_settings import RaceSettings
from matrixworld.coevolution.types import TEAMS

NAME = re.compile(r"\w[\w.=+-]*(/\w[\w.=+-]*)?")
"""Names of runs: relative paths of one or two parts that every system accepts."""
ITSELF = "."  # name of the only run of a job whose directory is that of the run
FEW = 3
"""Most runs, such as those of a default `matrixworld evolve`, whose first one should end early."""

FLOAT = 4  # bytes of a float32, and of a character
DRAWN = 4  # genomes of each team of which the longest one is asked
COPIES = 4
"""Most arrays of all candidates, all archived genomes or all views in memory at one time."""
TRAINING_EPISODE = 240  # bytes: twice the statistics of an episode, as `rollout` holds them
EVALUATION_EPISODE = 90  # bytes: what a tournament keeps of an episode

RUNS = Path("runs")  # parent directory of runs for which no directory is given

Job = Mapping[str, RaceSettings]
"""Runs that were asked for together: settings by the path of a run's directory in the job's."""


def job_of(settings: Any) -> Job:
    """Return the job of these settings, perhaps by name; of several each gets a name.

    TypeError if they are anything else; ValueError if names are bad or runs equal, or there are no
    runs.
    """
    if isinstance(settings, RaceSettings):
        return {ITSELF: settings.with_absolute_paths()}
    job: dict[str, RaceSettings] = {}
    names: dict[RaceSettings, str] = {}
    if isinstance(settings, Mapping):
        items = [*settings.items()]
    elif isinstance(settings, Sequence):  # a set has no order
        items = [(None, of_run) for of_run in settings]
    else:
        expected = "RaceSettings, or a sequence or mapping of them"
        raise TypeError(f"settings: expected {expected}, got {checks.shown(settings)}")
    for key, of_run in items:
        if not isinstance(of_run, RaceSettings):
            raise TypeError(f"settings: expected RaceSettings, got {checks.shown(of_run)}")
        name = f"{of_run.schedule.name}/seed-{of_run.seed}" if key is None else key
        if not isinstance(name, str) or not NAME.fullmatch(name):
            expected = "names such as sigma-0.1 or sigma-0.1/seed-3"
            raise ValueError(f"settings: expected {expected}, got {checks.shown(name)}")
        if name in job:
            expected = "runs of different schedules or seeds, or a name for each"
            raise ValueError(f"settings: expected {expected}, got two of {name}")
        job[name] = of_run.with_absolute_paths()
        # Equal runs are no independent observations.
        other = names.setdefault(job[name], name)
        if other != name:
            raise ValueError(f"settings: expected different runs, got {other} and {name}, equal")
    if not job:
        raise ValueError("settings: expected at least one run, got none")
    return job


def default_directory(job: Job) -> Path:
    """Return a new directory named after a job, such as ``runs/O-seeds0-9`` or ``...-9-2``."""
    first = RUNS / _directory_name(job)
    others = (first.with_name(f"{first.name}-{number}") for number in itertools.count(2))
    return next(path for path in itertools.chain([first], others) if not path.exists())


def _directory_name(job: Job) -> str:
    """Return the world or game of a job, its schedule if that is no race, and its seeds."""
    settings = next(iter(job.values()))
    seeds = [*dict.fromkeys(of_run.seed for of_run in job.values())]
    seed = f"seed{seeds[0]}"
    if len(seeds) > 1:
        are_a_range = seeds == [*range(seeds[0], seeds[0] + len(seeds))]
        listed = abbreviated([*map(str, seeds)]).replace(", ", ",")
        seed = f"seeds{seeds[0]}-{seeds[-1]}" if are_a_range else f"seeds{listed}"
    what = "" if settings.is_race else f"-{settings.schedule.name}"
    world = ""
    if isinstance(settings.game, PursuitSettings):
        world = world_name(settings.game.world)
    return f"{world or settings.game.variant}{what}-{seed}"


def found_job(root: Path) -> Job:
    """Return the job in a directory: all runs in it. Errors are those of `StoredRun.settings`."""
    paths = find_runs(root)
    return {path.relative_to(root).as_posix(): StoredRun(path).settings for path in paths}


def change_settings(root: Path, *, generations: int | None = None, force: bool = False) -> None:
    """Accept a changed game by force, and let the races of a job become longer, all or none.

    ValueError if a race cannot become longer; see `SavedRun.extend`. No file is changed then.
    """
    paths = find_runs(root)
    if generations is not None:
        for path in paths:
            play.check_longer(StoredRun(path), generations)
            if not force:
                play.check_source(StoredRun(path))
    if force:
        for path in paths:
            play.accept_source(path)
    if generations is not None:
        for path in paths:
            play.lengthen(path, generations)


def check_job(job: Job, root: Path, threads: int | None, *, elsewhere: bool = False) -> None:
    """Raise an error if a job cannot be made, or played here if not `elsewhere`.

    Errors are FileExistsError, ValueError and OutOfMemoryError, and those of code of one's own.
    """
    checks.check_threads(threads)
    found = found_job(root)
    _check_names(found.keys(), job.keys(), root)
    left = []
    for name, settings in job.items():
        stored = StoredRun(root / name)
        if found:
            create.check_same(stored, settings)
        if not stored.finished:
            left.append(settings)
            if found:
                play.check_source(stored)
    if not elsewhere:
        needed = [sum(run_memory(settings).values()) for settings in left]
        _check_memory(needed, threads, in_threads=any(each.game.in_threads for each in left))
    # Seeds make no difference here, and a job may have a thousand.
    for method in dict.fromkeys(settings.method for settings in left):
        for team in method.learning_teams:  # imports code of your own
            learner = method.learner_of(team)
            method.schedule.sampler(team)
            if not elsewhere:
                learner.check_machine()
        if not method.is_race and not found:
            create.load_opponents(method)
            create.load_start(method)


def _check_names(found: Collection[str], job: Collection[str], root: Path) -> None:
    """Raise an error unless a directory is empty, or holds the runs of a job."""
    if not found:
        check_empty(root)
        return
    others = [name for name in found if name not in job]
    missing = [name for name in job if name not in found]
    if others:
        got = f"others: {abbreviated(others)}"
        raise ValueError(f"{root}: expected the runs of this job, got {got}")
    if missing:
        got = f"a directory without {abbreviated(missing)}"
        raise ValueError(f"{root}: expected all runs of this job, got {got}")


def _check_memory(needed: Sequence[int], threads: int | None, *, in_threads: bool) -> None:
    """Raise OutOfMemoryError if runs that need so many bytes have too little at one time."""
    at_once, _ = shares(len(needed), threads, in_threads=in_threads)
    largest = sorted(needed, reverse=True)[:at_once]
    sizes = {f"run {number}": size for number, size in enumerate(largest, 1)}
    checks.check_memory(f"{at_once} runs at one time" if at_once > 1 else "run", **sizes)


def run_memory(settings: RaceSettings) -> dict[str, int]:
    """Return about the bytes of a run's largest arrays, by what they hold."""
    schedule = settings.schedule
    game = settings.evaluation_game
    genes = longest_text(game) if game.texts else max(map(game.genome_size, TEAMS))
    learners = [settings.learner_of(team) for team in settings.learning_teams]
    population = max(learner.population for learner in learners)
    teams = len(learners)
    episodes = population * schedule.opponents_met * settings.match_episodes * teams
    pairs = schedule.entries**2 if settings.is_race else 1
    needed = {
        "candidates": COPIES * population * genes * FLOAT,
        # A file of it is made in memory.
        "archive": COPIES * teams * schedule.entries * genes * FLOAT,
        "noise": 0 if game.texts else teams * table_length(genes) * FLOAT,
        "episodes": TRAINING_EPISODE * episodes,
        "payoff": EVALUATION_EPISODE * pairs * settings.evaluation_episodes,
    }
    pursuit = settings.game
    if isinstance(pursuit, PursuitSettings) and any(learner.replays for learner in learners):
        worlds = pursuit.training_worlds or (replace(pursuit.world, max_steps=pursuit.train_steps),)
        steps = max(w.max_steps * max(w.n_pursuers, w.n_evaders) for w in worlds)
        needed["views"] = COPIES * episodes * steps * CHANNELS * pursuit.world.fov**2
    return needed


@cache
def longest_text(game: Game) -> int:
    """Return the characters of the longest of a few new genomes that are text.

    A character takes as much memory as a gene. Genomes may become longer in a race.
    """
    rng = np.random.default_rng(0)
    return max(len(game.untrained(team, rng)[0]) for team in TEAMS for _ in range(DRAWN))


def create_job(job: Job, root: Path) -> None:
    """Make the directories of all runs of a job, or none of them; a job that is there stays."""
    if ITSELF in job:
        create.create(job[ITSELF], root)
    elif not find_runs(root):
        with new_directory(root) as place:
            for name, settings in job.items():
                create.create(settings, place / name)


def shares(runs: int, threads: int | None, *, in_threads: bool = True) -> tuple[int, int]:
    """Return how many runs play at one time, and the threads of each.

    Runs of a game of your own are played side by side. It has no threads, and processes for its
    matches, if it is slow, wait for each other.
    """
    cores = checks.check_threads(threads)
    # A few runs more than cores share them from the beginning: the last one would play alone.
    workers = max(1, runs if runs < 2 * cores else cores)
    # Two threads each lose little, and the first run is there in half the time.
    if in_threads and runs <= FEW:
        workers = max(1, min(runs, cores // 2))
    return workers, max(1, cores // workers)


def described(path: Path, error: BaseException) -> str:
    """Return an error of a run in words, without the path if the message begins with it."""
    kind = type(error)
    text = files.sentence_of(error) or kind.__name__
    # Such as KeyError, in the user's own code: its message alone says little.
    if kind.__module__ == "builtins" and not isinstance(error, OSError | ValueError):
        text = f"{kind.__name__}: {error}"
    return text.removeprefix(f"{path.absolute()}: ").removeprefix(f"{path}: ")
