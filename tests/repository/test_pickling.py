"""Objects with state of their own go through `pickle` and `copy.deepcopy`, whenever that is."""

import copy
import importlib
import inspect
import io
import pickle
import pkgutil
from dataclasses import is_dataclass
from enum import Enum
from itertools import chain
from pathlib import Path

import numpy as np
import pytest

import matrixworld as mw
from matrixworld import coevolution, explorer
from matrixworld.coevolution import Run, create
from rows import random_walks
from tiny_race import results, straight, tiny_race, tiny_single

NOT_COPIED = {
    "Batch": "its buffers belong to the caller",
    "VectorEnv": "it holds a batch",
    "AgentVectorEnv": "it holds a `VectorEnv`",
    "ProgressBar": "it holds a terminal",
    "States": "its states are the engine's, and are computed again in less time",
    "Solution": "it holds `States`",
}
"""Public classes without a copy, each with the reason."""


def pickled(value):
    return pickle.loads(pickle.dumps(value))  # noqa: S301  (made by this test)


SMALL = {"rows": 6, "cols": 6, "n_pursuers": 2, "n_evaders": 3, "fov": 3, "max_steps": 8}


def public_classes():
    found = pkgutil.walk_packages(mw.__path__, "matrixworld.")
    # Import neither the engine, which is compiled, nor the command, which would run.
    names = [each.name for each in found if not each.name.endswith(("_core", "__main__"))]
    modules = [mw, *map(importlib.import_module, names)]
    exported = [getattr(each, name) for each in modules for name in getattr(each, "__all__", ())]
    plain = (Enum, Exception, tuple)
    return {
        each.__name__: each
        for each in exported
        if inspect.isclass(each) and each.__module__.startswith("matrixworld")
        if not issubclass(each, plain)
        if not is_dataclass(each) or "__getstate__" in vars(each)
    }


class Content(pickle.Pickler):
    """Keeps a method by its name: the training of a run calls methods of the run."""

    def persistent_id(self, value):
        return value.__qualname__ if inspect.ismethod(value) else None


def content(value):
    """Return what pickle keeps, whether or not equal parts are one object."""
    out = io.BytesIO()
    pickler = Content(out)
    pickler.fast = True
    pickler.dump(value)
    return out.getvalue()


# Objects before and after their use; one that is yielded again has changed.


def of_worlds():
    config = mw.WorldConfig("SB", **SMALL, obstacles=0.1)
    network = mw.Network.for_config(config, (4,))
    yield from (config, network)
    team = mw.Population(np.zeros((2, network.genome_size), np.float32), network)
    statistics = mw.rollout(config, team, "fleer", mw.Matches.of([0, 1], 0, 7), episodes=2)
    yield from (network, team, statistics, mw.NetworkPolicy(network, team.genomes[0]))
    yield mw.RatingPolicy(mw.Rating(("room",)), np.float32([1]), seed=1)
    world = mw.World(config)
    yield world
    world.step([mw.Action.EAST] * 5, explain=True)
    yield from (world, mw.Recorder(world), mw.record(config, "chaser", "fleer", seed=1))
    # Conflicts exist only where agents collide.
    crowd = mw.World("B", rows=2, cols=2, n_pursuers=2, n_evaders=2)
    crowd.step([mw.Action.EAST] * 4, explain=True)
    yield from (crowd.conflicts, explorer.Playground(crowd), explorer.Explorer(Path("page.html")))
    monitor = mw.SafetyMonitor()
    monitor.add_statistics(statistics)
    yield from (monitor, random_walks(), mw.AgentEnv(config))
    env = mw.parallel_env(config, evaders=["random", team])
    env.reset(seed=1)
    yield env
    env.step(dict.fromkeys(env.agents, 1))
    aec = mw.aec_env(config)
    aec.reset(seed=1)
    yield from (env, env.status, aec.unwrapped)


def of_runs(directory):
    joint = tiny_race(schedule="hall-of-fame")
    for name, settings in (("single", tiny_single()), ("joint", joint), ("race", tiny_race())):
        create(settings, directory / name)
        run = Run(directory / name, threads=1)
        yield from (settings, run)
        yield from (run.run(), run)
    yield coevolution.Training(tiny_race(), threads=1)
    saved = coevolution.open_run(directory / "race")
    yield from (saved, saved.policy("pursuer", -1, seed=0), saved.payoff(), saved)
    [group] = coevolution.open_groups(directory / "race")
    yield from (group, group.judgement, group)
    # Errors whose arguments are not their message.
    yield coevolution.DamagedFileError(Path("payoff.npz"), "cut or altered")
    yield coevolution.FailedRunsError({Path("seed-0"): OSError("full")}, [saved])


def test_copies_are_equal(tmp_path):
    changed, classes = [], set()
    for each in chain(of_worlds(), of_runs(tmp_path)):
        classes |= {type(part).__name__ for part in (each if isinstance(each, list) else [each])}
        if {content(pickled(each)), content(copy.deepcopy(each))} != {content(each)}:
            changed.append(type(each).__name__)
    assert changed == []
    assert public_classes().keys() - classes - NOT_COPIED.keys() == set()


@pytest.mark.parametrize("copied", [pickled, copy.deepcopy])
def test_a_copy_of_a_run_goes_on_by_itself(copied, tmp_path):
    create(tiny_race(), tmp_path / "run")
    run = Run(tmp_path / "run", threads=1)
    again = copied(run)
    assert results(again.run().path) == straight(tiny_race())
    assert (run.training.stage, again.training.stage) == (0, 4)


@pytest.mark.parametrize("copied", [pickle.dumps, copy.deepcopy])
def test_batches_say_why_they_are_not_copied(copied):
    for live in (mw.Batch(2), mw.VectorEnv(n_worlds=2)):
        with pytest.raises(TypeError, match="its buffers belong to the caller"):
            copied(live)
