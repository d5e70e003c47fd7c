"""Public objects go through `pickle` and `copy.deepcopy`, before and after their use."""

from __future__ import annotations

import copy
import copyreg
import pickle
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest

import matrixworld as mw
from examples import examples, parts_of, public_classes, same
from matrixworld.coevolution import Candidates, resume, start
from tiny_race import results, tiny_race

INTERFACE = "an interface or a base class, which has no instances"
NOT_COPIED = {
    "Archive": INTERFACE,
    "Learner": INTERFACE,
    "OpponentSampler": INTERFACE,
    "Optimizer": INTERFACE,
    "Run": INTERFACE,
    "Stateless": INTERFACE,
    "Batch": "its buffers belong to the caller",
    "VectorEnv": "it holds a batch",
    "AgentVectorEnv": "it holds a `VectorEnv`",
    "ClusterExecutor": "it holds connections",
    "LocalExecutor": "it holds processes",
    "ProgressBar": "it holds a terminal",
    "ProgressBars": "it holds a terminal",
    "RunLog": "only the run that holds the lock of the directory writes it",
    "TeamPhase": "it exists while a run learns, and calls the run",
    "VariantModule": "a module",
}
"""Public classes without a copy, each with the reason."""

ECHO = """
import pickle, sys
copies = [pickle.loads(data) for data in pickle.load(sys.stdin.buffer)]
pickle.dump([pickle.dumps(each) for each in copies], sys.stdout.buffer)
"""


class Copies(NamedTuple):
    """An object at one moment: the classes in it, its pickle, and whether its copies are equal."""

    kind: str
    classes: set[str]
    data: bytes
    pickle_is_equal: bool
    deepcopy_is_equal: bool


def loaded(data: bytes) -> Any:
    return pickle.loads(data)  # noqa: S301  (made by this test)


def pickled(value: Any) -> Any:
    return loaded(pickle.dumps(value))


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
def every(tmp_path_factory: pytest.TempPathFactory) -> list[Copies]:
    """Copies of every example, made when it is yielded, because its use goes on."""
    return [
        Copies(
            type(each).__name__,
            {type(part).__name__ for part in parts_of(each)},
            pickle.dumps(each),
            same(each, pickled(each)),
            same(each, copy.deepcopy(each)),
        )
        for each in examples(tmp_path_factory.mktemp("runs"))
    ]


def test_every_public_class_has_an_example_or_a_reason(every: list[Copies]) -> None:
    found = set().union(*(each.classes for each in every))
    assert public_classes().keys() - found == NOT_COPIED.keys()


def test_copies_are_equal(every: list[Copies]) -> None:
    assert [each.kind for each in every if not each.pickle_is_equal] == []
    assert [each.kind for each in every if not each.deepcopy_is_equal] == []


def test_a_fresh_process_reads_every_copy(every: list[Copies]) -> None:
    sent = pickle.dumps([each.data for each in every])
    ran = subprocess.run([sys.executable, "-c", ECHO], input=sent, capture_output=True, check=True)
    for each, data in zip(every, loaded(ran.stdout), strict=True):
        assert same(loaded(each.data), loaded(data)), each.kind


def test_a_changed_copy_is_not_equal() -> None:
    network = mw.Network((4,))
    assert same(network, pickled(network))
    assert not same(network, mw.Network((5,)))
    assert not same(np.zeros(2), np.zeros(2, np.float32))


def test_a_copied_population_plays_the_same() -> None:
    config = mw.WorldConfig("O", rows=6, cols=6, n_pursuers=2, n_evaders=3, fov=3, max_steps=20)
    network = mw.Network.for_config(config, (4,))
    team = mw.Population(network.initial(np.random.default_rng(0)), network)
    before = mw.rollout(config, team, "fleer", mw.Matches.of(0, 0, range(5)))
    after = mw.rollout(config, pickled(team), "fleer", mw.Matches.of(0, 0, range(5)))
    assert same(before, after)


def test_rows_of_copied_candidates_are_views_of_their_array() -> None:
    copies = copy.deepcopy(Candidates(np.zeros((2, 5), np.float32)))
    copies.genomes[1] = 3.0
    np.testing.assert_array_equal(copies[1].genome, copies.genomes[1])


def test_a_copied_run_continues_from_the_last_checkpoint(tmp_path: Path) -> None:
    straight = start(tiny_race(), tmp_path / "straight", threads=1)
    straight.run()
    pickled(start(tiny_race(), tmp_path / "copied", threads=1)).run()
    assert results(tmp_path / "straight") == results(tmp_path / "copied")
    assert resume(tmp_path / "copied").files.finished


@pytest.mark.parametrize("copied", [pickle.dumps, copy.deepcopy])
def test_batches_say_why_they_are_not_copied(copied: Callable[[Any], Any]) -> None:
    for live in (mw.Batch(2), mw.VectorEnv(n_worlds=2)):
        with pytest.raises(TypeError, match="its buffers belong to the caller"):
            copied(live)
