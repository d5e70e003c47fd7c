"""Races and tournaments on a real Dask cluster, whose workers and scheduler are killed and frozen.

Each test gets the workers that it asks for, in processes of their own.
"""

import operator
import os
import signal
import socket
import threading
import time
from collections.abc import Callable
from concurrent.futures import Future
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from dask_cluster import DaskCluster, dask_cluster
from matrixworld.cluster import ClusterLostError, cluster
from matrixworld.cluster import executor as module
from matrixworld.coevolution import (
    TEAMS,
    DamagedFileError,
    FailedRunsError,
    RaceSettings,
    WorkerDiedError,
    evolve,
    finish,
    tournament,
)
from matrixworld.world.policy import Population
from scripts import wait_until
from tiny_race import results, tiny_race

pytest.importorskip("distributed")

SLOW = {"learner": "dying:Slow", "generations": 4}


def races(count: int, **changes: Any) -> dict[str, RaceSettings]:
    """Settings of races by name."""
    return {f"race-{seed}": tiny_race(seed=seed, **changes) for seed in range(count)}


def check_equal(directory: Path, settings: dict[str, RaceSettings], alone: Path) -> None:
    """All races have the bytes that they have without a cluster."""
    for name, each in settings.items():
        finish(each, alone / name, threads=1)
        assert results(directory / name) == results(alone / name), name


def in_background(play: Callable[[], Any]) -> Future[Any]:
    """The result of a function that runs in another thread."""
    future: Future[Any] = Future()

    def run() -> None:
        try:
            future.set_result(play())
        except BaseException as error:  # noqa: BLE001, raised by the future
            future.set_exception(error)

    threading.Thread(target=run, daemon=True).start()
    return future


def have_begun(directory: Path, count: int) -> Callable[[], bool]:
    """Whether so many races have begun to learn."""
    return lambda: len(list(directory.glob("*/stage-0001.npz"))) >= count


def test_errors_of_the_work_come_back(dask: DaskCluster) -> None:
    dask.workers(2)
    with cluster(dask.address) as executor:
        wrong = executor.submit(operator.truediv, 1, 0)
        right = [executor.submit(operator.add, 1, number) for number in range(20)]
        assert [each.result() for each in right] == list(range(1, 21))
        with pytest.raises(ZeroDivisionError):
            wrong.result()
    with pytest.raises(RuntimeError, match="submit: expected an executor that is not shut down"):
        executor.submit(operator.add, 1, 2)


def test_a_tournament_in_blocks_is_the_one_of_this_process(dask: DaskCluster) -> None:
    dask.workers(2)
    settings = tiny_race()
    sides = [Population(settings.untrained(team, 5), settings.network) for team in TEAMS]
    play = partial(tournament, settings.world, *sides, seed=3, episodes=2)
    rows: list[int] = []
    with cluster(dask.address) as executor:
        # So little time that each of the 25 pairs is a block.
        found = play(executor=executor, block_seconds=1e-9, on_row=rows.append)
    assert len(rows) == 25  # told after each block
    for name, array in play().arrays().items():
        np.testing.assert_array_equal(found.arrays()[name], array)


@pytest.mark.slow  # that work goes on when all workers were lost is tried by each run
def test_a_killed_worker_is_replaced_by_another(dask: DaskCluster, tmp_path: Path) -> None:
    first, _ = dask.workers(2)
    settings, place = races(4, **SLOW), tmp_path / "many"
    with cluster(dask.address, directory=place) as executor:
        played = in_background(lambda: evolve(settings, place, executor=executor))
        wait_until(have_begun(place, 2), "two races")
        dask.kill(first)
        dask.workers(2)
        assert len(played.result()) == len(settings)
    check_equal(place, settings, tmp_path / "alone")


@pytest.mark.slow
def test_work_goes_on_when_all_workers_were_lost_and_another_joins(dask: DaskCluster) -> None:
    [only] = dask.workers(1)
    told: list[str] = []
    with cluster(dask.address, tell=told.append) as executor:
        asked = [executor.submit(time.sleep, 0.5) for _ in range(3)]
        wait_until(asked[0].running, "begin of the work")  # so that the kill loses work
        dask.kill(only)
        wait_until(lambda: len(told) == 1, "sentence for the user")
        assert not asked[-1].done()
        dask.workers(1)
        assert [each.result(timeout=60) for each in asked] == [None] * 3
    assert told[0].startswith("No worker is left at the scheduler tcp://")


@pytest.mark.slow
def test_a_frozen_worker_does_no_harm(dask: DaskCluster, tmp_path: Path) -> None:
    first, _ = dask.workers(2)
    settings, place = races(3, **SLOW), tmp_path / "many"
    with cluster(dask.address, directory=place) as executor:
        played = in_background(lambda: evolve(settings, place, executor=executor))
        wait_until(have_begun(place, 2), "two races")
        first.send_signal(signal.SIGSTOP)
        # It still holds the lock of its race when the scheduler has given it up.
        wait_until(lambda: dask.given_up(first), "loss of the worker")
        time.sleep(1)
        assert not played.done()
        first.send_signal(signal.SIGCONT)
        assert len(played.result()) == len(settings)
    check_equal(place, settings, tmp_path / "alone")
    dask.kill(first)  # it may live on, but no scheduler knows it


@pytest.mark.slow
def test_a_race_that_kills_workers_is_named(dask: DaskCluster, tmp_path: Path) -> None:
    dask.workers(3)
    place = tmp_path / "many"
    good = races(4, **SLOW)
    settings = {"deadly": tiny_race(learner="dying:Deadly"), **good}
    with (
        cluster(dask.address, directory=place) as executor,
        pytest.raises(FailedRunsError, match="deadly: 2 workers died") as error,
    ):
        evolve(settings, place, executor=executor)
    [(path, reason)] = error.value.failures.items()
    assert path == place / "deadly"
    assert isinstance(reason, WorkerDiedError)
    assert len(error.value.finished) == len(good)
    check_equal(place, good, tmp_path / "alone")


@pytest.mark.slow
def test_a_vanished_cluster_leaves_files_to_continue(tmp_path: Path) -> None:
    settings, place = races(3, **SLOW), tmp_path / "many"
    with dask_cluster(tmp_path / "dask", workers=2) as dask:
        with cluster(dask.address, directory=place) as executor:
            played = in_background(lambda: evolve(settings, place, executor=executor))
            wait_until(have_begun(place, 2), "two races")
            os.kill(dask.scheduler.pid, signal.SIGKILL)
            with pytest.raises(ClusterLostError, match="the scheduler tcp://.* was lost"):
                played.result()
            with pytest.raises(ClusterLostError):
                executor.submit(operator.add, 1, 2)
        # Workers without a scheduler end by themselves.
        wait_until(lambda: not dask.left(), "end of all workers")
    evolve(settings, place, threads=1)
    check_equal(place, settings, tmp_path / "alone")


def test_a_scheduler_that_does_not_answer_is_given_up(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "CONNECT_SECONDS", 1)  # many seconds otherwise
    with socket.create_server(("127.0.0.1", 0)) as silent:
        address = f"tcp://127.0.0.1:{silent.getsockname()[1]}"
        answer = pytest.raises(
            OSError, match=r"expected a Dask scheduler, got no answer within 1 s"
        )
        with answer, cluster(address):
            pass


@pytest.mark.parametrize("content", ["{}", '{"address": 3}', "no json"])
def test_a_file_of_no_scheduler_is_refused(tmp_path: Path, content: str) -> None:
    (tmp_path / "scheduler.json").write_text(content)
    refused = pytest.raises(DamagedFileError, match=r"scheduler\.json: ")
    with refused, cluster(str(tmp_path / "scheduler.json")):
        pass
