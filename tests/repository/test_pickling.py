"""Public objects go through `pickle` and `copy.deepcopy`, before and after their use."""

import contextlib
import copy
import copyreg
import importlib
import inspect
import io
import pickle
import pkgutil
import subprocess
import sys
from collections.abc import Callable, Iterator, Mapping
from dataclasses import fields, is_dataclass
from enum import Enum
from pathlib import Path
from types import ModuleType
from typing import Any, NamedTuple

import numpy as np
import pytest

import matrixworld as mw
from matrixworld import analysis, classroom, coevolution, explorer, solve
from matrixworld.analysis.games import META_SOLVERS
from matrixworld.analysis.runs import race_bands
from matrixworld.analysis.strength import strength_gain
from matrixworld.analysis.words import all_results
from matrixworld.coevolution import opponents, resume, start
from matrixworld.coevolution.jobs import job_of
from matrixworld.coevolution.learners.toolbox import Individual
from matrixworld.episodes import replay
from matrixworld.plots.game import SITUATIONS, resolve
from rows import random_walks
from tiny_race import results, tiny_race, tiny_single

INTERFACES = ("Archive", "Learner", "OpponentSampler", "Run", "Stateless")
NOT_COPIED = {
    **dict.fromkeys(INTERFACES, "an interface or a base class, which has no instances"),
    "Batch": "its buffers belong to the caller",
    "VectorEnv": "it holds a batch",
    "AgentVectorEnv": "it holds a `VectorEnv`",
    "ProgressBar": "it holds a terminal",
    "States": "its states are the engine's, and are computed again in less time",
    "Solution": "it holds `States`",
}
"""Public classes without a copy, each with the reason."""

ECHO = """
import pickle, sys
copies = [pickle.loads(data) for data in pickle.load(sys.stdin.buffer)]
pickle.dump([pickle.dumps(each) for each in copies], sys.stdout.buffer)
"""


class Copies(NamedTuple):
    """The classes in all examples, their pickles, and the names of those whose copies differ."""

    classes: set[str]
    pickles: list[bytes]
    changed: list[str]


def loaded(data: bytes) -> Any:
    return pickle.loads(data)  # noqa: S301  (made by this test)


def pickled(value: Any) -> Any:
    return loaded(pickle.dumps(value))


# Instances of the public classes

SMALL = {"rows": 6, "cols": 6, "n_pursuers": 2, "n_evaders": 3, "fov": 3, "max_steps": 8}


def public_packages() -> list[ModuleType]:
    """Return `matrixworld` and all packages and modules below it that have an ``__all__``."""
    found = pkgutil.walk_packages(mw.__path__, "matrixworld.")
    # Import neither the engine, which is compiled, nor the command, which would run.
    names = [each.name for each in found if not each.name.endswith(("_core", "__main__"))]
    modules = [mw, *map(importlib.import_module, names)]
    return [each for each in modules if hasattr(each, "__all__")]


def public_classes() -> dict[str, type]:
    """Return every class that a package exports, by its name."""
    exported = [getattr(module, name) for module in public_packages() for name in module.__all__]
    classes = [each for each in exported if inspect.isclass(each)]
    return {each.__name__: each for each in classes if each.__module__.startswith("matrixworld")}


def parts_of(value: Any) -> Iterator[Any]:
    """Yield an object and everything that it holds."""
    yield value
    if isinstance(value, Mapping):
        held = [*value.keys(), *value.values()]
    elif isinstance(value, list | tuple | set):
        held = list(value)
    elif is_dataclass(value):
        held = [getattr(value, item.name) for item in fields(value)]
    else:
        held = []
    for each in held:
        yield from parts_of(each)


def same(one: Any, other: Any) -> bool:
    """Whether two objects have the same type and the same content, bit for bit."""
    return content(one) == content(other)


def content(value: Any) -> bytes:
    """Return what pickle keeps of an object.

    Without references: whether equal parts are one object says nothing about their content.
    """
    out = io.BytesIO()
    pickler = pickle.Pickler(out)
    pickler.fast = True
    pickler.dump(value)
    return out.getvalue()


def examples(directory: Path) -> Iterator[Any]:
    """Yield objects that hold an instance of each public class, before and after their use.

    An object may be yielded several times, and changes between.
    """
    for group in (_by_default(), _of_worlds(), _of_analysis(), _of_teaching(), _of_learning()):
        yield from group
    for made in (_of_runs, _of_jobs, _of_classes):
        yield from made(directory)


def _by_default() -> Iterator[Any]:
    """Yield an instance of each class that needs no arguments, and all members of each `Enum`."""
    for name, kind in public_classes().items():
        if issubclass(kind, Enum):
            yield list(kind)
        elif name not in NOT_COPIED:
            with contextlib.suppress(TypeError, ValueError):  # Some need arguments.
                yield kind()


def _of_worlds() -> Iterator[Any]:
    config = mw.WorldConfig("SB", **SMALL, obstacles=0.1)
    fresh = mw.Network.for_config(config, (4,))
    yield from (config, fresh, mw.Rewards(pursuer_collide=(-1, -2, -3)))
    used = mw.Network.for_config(config, (4,))
    team = mw.Population(np.zeros((2, used.genome_size), np.float32), used)
    matches = mw.Matches.of([0, 1], 0, 7)
    statistics = mw.rollout(config, team, "fleer", matches, episodes=2)
    yield from (mw.Population(np.ones((1, fresh.genome_size), np.float32), fresh), used, team)
    yield from (matches, statistics, ("chaser", team))
    world = mw.World(config)
    yield world
    world.step([mw.Action.EAST] * 5, explain=True)
    played = mw.record(config, "chaser", "fleer", seed=1)
    yield from (world.conflicts, world, mw.Recorder(world), played, random_walks())
    yield from (replay.animation(played), replay.scene(played))
    # Conflicts exist only where agents collide.
    crowd = mw.World("B", rows=2, cols=2, n_pursuers=2, n_evaders=2)
    crowd.step([mw.Action.EAST] * 4, explain=True)
    yield from (crowd.conflicts, explorer.Playground(crowd), explorer.Explorer(Path("page.html")))
    monitor = mw.SafetyMonitor()
    monitor.add_statistics(statistics)
    yield from (monitor, monitor.summary())
    env = mw.parallel_env(config)
    env.reset(seed=1)
    yield env
    env.step(dict.fromkeys(env.agents, 1))
    monitor = mw.SafetyMonitor()
    monitor.observe(env.status)
    aec = mw.aec_env(config)
    aec.reset(seed=1)
    yield from (env, env.status, monitor, aec.unwrapped)


def _of_analysis() -> Iterator[Any]:
    rng = np.random.default_rng(0)
    scores = (rng.random((8, 8, 6)) < 0.5).astype(float)
    payoff = scores.mean(axis=2)
    functions = "alpha_rank checkerboards ciao elo forgetting generalization lag_profile"
    functions += " local_progress nash_averaging two_way_parts"
    yield from (getattr(analysis, name)(payoff) for name in functions.split())
    yield from (analysis.measure_all([payoff, payoff**2]), all_results(payoff))
    yield analysis.judge(scores, per_episode=True)
    yield (payoffs := analysis.read_payoffs(scores, per_episode=True))
    yield payoffs.late
    yield analysis.dominance_tournament(scores)
    yield from (analysis.spinning_top(scores), analysis.elo_over_episodes(scores))
    yield solve.Guarantees(0.5, payoff[0], payoff[1])
    yield analysis.replicator_dynamics(payoff)
    yield analysis.disengagements(np.ones((9, 2)))
    yield strength_gain(payoff[0], payoff[0])
    yield analysis.exploitability(payoff, np.full(8, 1 / 8), np.full(8, 1 / 8))
    yield analysis.response_gain(scores[0, 0], scores[1, 1], budget=9)
    yield from (analysis.band_over_runs(payoff), analysis.MEASURES)
    yield from (race_bands([payoff, payoff**2]), analysis.performance_profile(payoff))


def _of_teaching() -> Iterator[Any]:
    yield from (SITUATIONS, resolve(SITUATIONS[0], mw.Outcome.BOUNCE))


def _of_learning() -> Iterator[Any]:
    rng = np.random.default_rng(0)
    start = np.zeros(12, np.float32)
    table = coevolution.NoiseTable(12, rng, sigma=0.1)
    yield table
    for learner in (
        coevolution.EvolutionStrategy(start, table, samples=4),
        coevolution.GeneticAlgorithm(np.zeros((4, 12)), table),
        coevolution.CmaEs(start, samples=4, sigma=0.1),
    ):
        yield learner
        asked = learner.ask(rng)
        yield learner
        learner.tell(np.arange(len(asked)))
        yield learner
    individual = Individual(start)
    individual.fitness.values = (0.5,)
    yield individual
    yield coevolution.SCHEDULES
    race = coevolution.RaceSettings()
    yield from (race.schedule, race.schedule.evaders_meet, coevolution.Yoked(race="other"))
    own = {"code": "mine:Mine"}
    yield from (coevolution.OwnOpponents(**own), coevolution.OwnLearnerSettings(**own))
    yield [archive(3) for archive in coevolution.schedules.ARCHIVES.values()]
    yield opponents.ArchiveSampler(opponents.MaxSolve(3))
    yield [opponents.MetaStrategy(solver) for solver in META_SOLVERS.values()]
    yield opponents.Generalist(np.zeros(3, np.intp), sample_size=3)


def _of_runs(directory: Path) -> Iterator[Any]:
    yield from (tiny_race(), tiny_single(), tiny_race(learner="ga"))
    yield tiny_race(obstacles=("......",) * 6)
    for name, settings in (
        ("single", tiny_single()),
        ("joint", tiny_race(schedule="hall-of-fame")),
        ("race", tiny_race()),
    ):
        run = coevolution.start(settings, directory / name, threads=1)
        yield run
        yield from (run.run(), run)
    yield run.training
    saved = coevolution.open_run(directory / "race")
    yield saved
    yield saved.policy("pursuer", -1, seed=0)
    yield from (saved.payoff(), saved, coevolution.score(saved, episodes=2))
    [group] = coevolution.open_groups(directory / "race")
    yield from (group, group.judgement, group)
    yield coevolution.best_responses(
        {"a": saved}, "pursuer", 100, directory / "response", evaluation_episodes=5
    )
    yield from (
        coevolution.DamagedFileError(Path("payoff.npz"), "cut or altered"),
        coevolution.PluginError("learner mine:Learner: ask: ValueError: no"),
    )


def _of_classes(directory: Path) -> Iterator[Any]:
    submissions = directory / "class"
    submissions.mkdir(parents=True)
    network = mw.Network((2,), fov=5)
    policy = mw.NetworkPolicy(network, network.initial(np.random.default_rng(0)))
    classroom.save_genome(submissions / "ann.npz", "evader", policy)
    (submissions / "bo.npz").write_bytes(b"")
    config = mw.WorldConfig("O", rows=6, cols=6, n_pursuers=1, n_evaders=1, fov=5, max_steps=3)
    result = classroom.play_class(submissions, config, episodes=2, threads=1)
    assert result.refusals
    yield from (result, result.standings)


def _of_jobs(directory: Path) -> Iterator[Any]:
    yield job_of([tiny_race(), tiny_race(seed=1)])
    running = {"seed-0": coevolution.Progress("generation 1", 1, 9, 0)}
    yield coevolution.Progress("1 of 2 runs", 10, 18, 0, running)
    failed = {Path("seed-0"): OSError("full")}
    yield coevolution.FailedRunsError(failed, [coevolution.open_run(directory / "race")])


# Copies of them


@pytest.fixture(scope="module", autouse=True)
def own_pickles() -> Iterator[None]:
    """Pickles of exceptions as Python makes them: Dask has changed that once it is imported."""
    before = dict(copyreg.dispatch_table)
    for kind, reduce in before.items():
        if reduce.__module__.startswith("tblib"):
            del copyreg.dispatch_table[kind]
    yield
    copyreg.dispatch_table.update(before)


@pytest.fixture(scope="module")
def every(tmp_path_factory: pytest.TempPathFactory) -> Copies:
    """Copies of every example, made when it is yielded, because its use goes on."""
    made = Copies(set(), [], [])
    for each in examples(tmp_path_factory.mktemp("runs")):
        # What an example holds counts too.
        made.classes.update(type(part).__name__ for part in parts_of(each))
        made.pickles.append(pickle.dumps(each))
        if not same(each, pickled(each)) or not same(each, copy.deepcopy(each)):
            made.changed.append(type(each).__name__)
    return made


def test_every_public_class_has_an_example_or_a_reason(every: Copies) -> None:
    assert public_classes().keys() - every.classes == NOT_COPIED.keys()


def test_copies_are_equal(every: Copies) -> None:
    assert every.changed == []


def test_a_fresh_process_reads_every_copy(every: Copies) -> None:
    sent = pickle.dumps(every.pickles)
    ran = subprocess.run([sys.executable, "-c", ECHO], input=sent, capture_output=True, check=True)
    for here, there in zip(every.pickles, loaded(ran.stdout), strict=True):
        assert same(loaded(here), loaded(there)), type(loaded(here))


def test_a_changed_copy_is_not_equal() -> None:
    network = mw.Network((4,))
    assert same(network, pickled(network))
    assert not same(network, mw.Network((5,)))
    assert not same(np.zeros(2), np.zeros(2, np.float32))


def test_a_copied_run_continues_from_the_last_stage(tmp_path: Path) -> None:
    straight = start(tiny_race(), tmp_path / "straight", threads=1)
    straight.run()
    # The copy writes where the original would.
    pickled(start(tiny_race(), tmp_path / "copied", threads=1)).run()
    assert results(tmp_path / "straight") == results(tmp_path / "copied")
    assert resume(tmp_path / "copied").files.finished


@pytest.mark.parametrize("copied", [pickle.dumps, copy.deepcopy])
def test_batches_say_why_they_are_not_copied(copied: Callable[[Any], Any]) -> None:
    for live in (mw.Batch(2), mw.VectorEnv(n_worlds=2)):
        with pytest.raises(TypeError, match="its buffers belong to the caller"):
            copied(live)
