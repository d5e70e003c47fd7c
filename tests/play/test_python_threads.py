"""Threads: Python's own that use one object at once, Python without a GIL, and how many."""

import os
import sys
import threading
import time

import numpy as np
import pytest

import matrixworld as mw
from scripts import run

ONE_CALL = "Batch or VectorEnv: expected one call at a time, got a second one"


def busy_batch():
    """A batch whose steps take some milliseconds, nearly all of them without the GIL."""
    views = np.zeros((40, 38, 3, 61, 61), np.uint8)  # large views take most of the time of a step
    return mw.Batch(40, fov=61, threads=1, buffers={"views": views})


CALLS = {
    "step": lambda batch: batch.step(np.zeros((40, 38), np.uint8)),
    "reset": lambda batch: batch.reset(0),
    "decide": lambda batch: batch.decide(
        ["hunter"], np.zeros(40, np.int32), range(8), np.zeros((40, 38), np.int64)
    ),
    "world": lambda batch: batch.world(0),
}


def is_refused(call, batch):
    try:
        call(batch)
    except RuntimeError as error:
        if ONE_CALL not in str(error):
            raise
        return True
    return False


@pytest.mark.parametrize("name", CALLS)
def test_a_second_caller_is_refused(name):
    batch = busy_batch()
    done = threading.Event()

    def step_until_done():
        while not done.is_set():
            if is_refused(CALLS["step"], batch):
                time.sleep(0.001)  # the other thread was first

    thread = threading.Thread(target=step_until_done)
    thread.start()
    end = time.monotonic() + 30
    while not (refused := is_refused(CALLS[name], batch)) and time.monotonic() < end:
        time.sleep(0.001)  # without a pause, this thread would hold the batch nearly all the time
    done.set()
    thread.join()
    assert refused
    assert not is_refused(CALLS[name], batch)


def test_a_refused_call_changes_nothing():
    """Whichever steps are refused, a batch is where one thread with the same steps would be."""
    batch = busy_batch()
    played = []

    def play():
        played.extend(not is_refused(CALLS["step"], batch) for _ in range(20))

    threads = [threading.Thread(target=play) for _ in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    alone = busy_batch()
    for _ in range(sum(played)):
        CALLS["step"](alone)
    np.testing.assert_array_equal(batch.buffers["views"], alone.buffers["views"])
    assert batch.world(3).steps == sum(played)


@pytest.mark.skipif(getattr(sys, "_is_gil_enabled", lambda: True)(), reason="this Python has a GIL")
def test_the_engine_does_not_switch_the_gil_on():
    run("""
world = mw.World()
world.step([0] * 38)
mw.rollout("O", "hunter", "fleer", mw.Matches.of(0, 0, [1, 2]))
assert not sys._is_gil_enabled()
""")


@pytest.mark.skipif(not hasattr(os, "sched_setaffinity"), reason="the system binds no processes")
def test_the_default_follows_the_affinity():
    """A batch starts a thread for each core of the process but one; the caller works, too."""
    output = run("""
from pathlib import Path
from matrixworld._util.checks import usable_cores

def threads_of(*cores):
    os.sched_setaffinity(0, cores)
    before = len(list(Path("/proc/self/task").iterdir()))
    batch = mw.Batch(100)
    return len(list(Path("/proc/self/task").iterdir())) - before, usable_cores()

cores = sorted(os.sched_getaffinity(0))
print(threads_of(cores[0]))
if len(cores) > 1:
    print(threads_of(*cores[:2]))
""")
    assert output.splitlines() in ([str((0, 1))], [str((0, 1)), str((1, 2))])
