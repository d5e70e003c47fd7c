"""Runs that take a fraction of a second, and a way to interrupt them."""

import json
import os
import shutil
import tempfile
from contextlib import contextmanager
from dataclasses import replace
from functools import cache, partial
from pathlib import Path

import pytest

from matrixworld.coevolution import RaceSettings, Run, SavedRun, StopRun, create, evolve, finish
from matrixworld.play.rollout import Matches, rollout

TINY = {
    "rows": 6,
    "cols": 6,
    "n_pursuers": 2,
    "n_evaders": 3,
    "fov": 3,
    "max_steps": 12,  # longer than training, which ends after 8
    "hidden": (4,),
    "population": 4,
    "train_steps": 8,
    "evaluation_episodes": 3,
    "seed": 5,
}

SCHEDULES = ("specialist-specialist", "generalist-generalist")
LONG = {"generations": 12, "pursuer_epochs": 1, "evader_epochs": 1, "evaluation_episodes": 4}
"""Settings of short races that have enough generations to be judged."""

WORLDS = [{"n_pursuers": 1, "n_evaders": 1}, {"rows": 5}, {"obstacles": 0.1, "max_steps": 5}]
"""Worlds of training."""

SHARED = "/dev/shm"
LEAST_FREE = 2**30
MEMORY = (
    SHARED if os.access(SHARED, os.W_OK) and shutil.disk_usage(SHARED).free >= LEAST_FREE else None
)
"""A directory in memory where there is one (Linux) with room; containers often give it 64 MB."""
GENOMES = ("pursuers.npy", "evaders.npy")
RESULTS = ("config.json", *GENOMES, "log.csv", "payoff.npz", "summary.json")
STAGES = ("stage-*.npz", "checkpoint-*.npz")


def settings_of(**values):
    """Return settings from values by the names of their fields, wherever these stand."""
    named = {"learner": "es", "schedule": "generalist-generalist", **values}
    if named.get("policy") == "program":
        named.pop("hidden", None)  # programs have no layers
    if not isinstance(named["learner"], str) or ":" in named["learner"]:
        named.pop("population", None)  # a learner of one's own has what it declares
    return RaceSettings.of(**named)


def tiny_race(**changes):
    """Return settings of two generations: 2 pursuer and 3 evader epochs, or 2 joint ones."""
    joint = changes.get("schedule") == "hall-of-fame"
    epochs = {"joint_epochs": 2} if joint else {"pursuer_epochs": 2, "evader_epochs": 3}
    return settings_of(**{**TINY, "generations": 2, **epochs, **changes})


def tiny_single(**changes):
    """Return settings of one team alone: five epochs, with an entry of the archive every two."""
    alone = {"schedule": "against", "epochs": 5, "archive_every": 2}
    return settings_of(**{**TINY, **alone, **changes})


def alternating(sampler=None, **changes):
    """Return a race whose teams meet two opponents of a sampler in every epoch."""
    usual = {"schedule": "alternating", "opponents": 2, "generations": 4, **_meeting(sampler)}
    return tiny_race(**{**usual, **changes})


def hall_of_fame(sampler=None, **changes):
    """Return a race with halls of fame: two contemporaries and two older ones in every epoch."""
    usual = {"contemporaries": 2, "hall_sample": 2, "generations": 3, **_meeting(sampler)}
    return tiny_race(schedule="hall-of-fame", **{**usual, **changes})


def _meeting(sampler):
    return {} if sampler is None else {"pursuers_meet": sampler, "evaders_meet": sampler}


def begun(settings, directory, *, opponents=None, start=None, play=rollout, **options):
    """Make a run, or take the one that is there; return it before it goes on."""
    create(settings, directory, opponents=opponents, start=start)
    return playing(Run(directory, **options), play)


def playing(run, play):
    """Let a function with the arguments of `rollout` play all matches of a run."""
    run.training.game = replace(run.training.game, play=play)
    evaluation = replace(run.settings.evaluation_game, play=play)
    vars(run.settings)["evaluation_game"] = evaluation
    return run


def played(settings, directory, play=rollout, **options):
    """Make a run and play it to its end, or to that of the one that is there."""
    create(settings, directory)
    if play is rollout:
        return finish(directory, **{"threads": 1, **options})
    threads = options.pop("threads", 1)
    playing(Run(directory, threads=threads), play).run(**options)
    return SavedRun(directory)


def results(directory):
    """Return all files that must be equal for a resumed run and for one that was never stopped."""
    # A team that a script plays has no genomes.
    found = [name for name in RESULTS if (directory / name).exists() or name not in GENOMES]
    found += [path.name for pattern in STAGES for path in directory.glob(pattern)]
    return {name: (directory / name).read_bytes() for name in found}


@contextmanager
def directory_in_memory():
    """Yield a temporary directory, in memory if possible, where syncing costs nothing."""
    with tempfile.TemporaryDirectory(dir=MEMORY) as directory:
        yield Path(directory)


class Listening:
    """Plays matches like `rollout`, and keeps what it was asked for, and the scores."""

    def __init__(self):
        self.calls = []

    def __call__(self, config, pursuers, evaders, matches, **more):
        scores = rollout(config, pursuers, evaders, matches, **more)
        self.calls.append((config, pursuers, evaders, Matches.of(*matches), scores))
        return scores


class StopAt:
    """Plays matches like `rollout`, but raises KeyboardInterrupt at a given call."""

    def __init__(self, call):
        self.left = call

    def __call__(self, *args, **options):
        self.left -= 1
        if self.left < 0:
            raise KeyboardInterrupt
        return rollout(*args, **options)


def straight(settings):
    """Return the results of a run that was never stopped."""
    return _straight(settings, json.dumps(settings.to_json()))


@cache
def _straight(settings, plain):
    # Equal settings may have been chosen by other words, which config.json keeps.
    with directory_in_memory() as directory:
        return results(played(settings, directory / "run", threads=2).path)


def check_resumes(settings, call, directory):
    """Stop a run at a call of `rollout`, continue it, and compare it with one never stopped."""
    stop_and_continue(partial(begun, settings), call, directory)
    assert results(directory) == straight(settings)


def stop_and_continue(make, call, directory):
    """Stop a run at a call of `rollout`, and continue it."""
    run = playing(make(directory, threads=1), StopAt(call))
    with pytest.raises(KeyboardInterrupt):
        run.run()
    # Both ways to continue: by the same object, and by a new one.
    if call % 2:
        playing(run, rollout).run()  # not `StopAt`, which would stop it again
    else:
        make(directory, threads=1).run()


def stopped(settings, directory, generation=3):
    """Run a race until the first epoch of a generation."""

    def stop(row):
        if row["generation"] == generation:
            raise StopRun

    with pytest.raises(StopRun):
        evolve(settings, directory, on_epoch=stop)
