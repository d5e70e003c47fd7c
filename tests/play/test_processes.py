"""Ctrl-C in the middle of long calls, and processes that fork while batches have threads."""

import os
import signal
import sys
import threading
import time

import pytest

from scripts import finish, run, start

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="signals of POSIX systems")

SECONDS = 1.0
"""The engine looks for signals every 50 ms; a busy machine gets more time here."""


def interrupt(process, after=0.3):
    """Send Ctrl-C to a script that prints "begins", and return the seconds until it prints."""
    watch = threading.Timer(60, process.kill)  # the script may not listen
    watch.start()
    assert process.stdout is not None
    assert process.stdout.readline() == "begins\n"
    time.sleep(after)
    os.kill(process.pid, signal.SIGINT)
    begin = time.perf_counter()
    assert process.stdout.readline() == "interrupted\n"
    watch.cancel()
    return time.perf_counter() - begin


def test_a_rollout_ends_soon_and_leaves_all_as_it_was():
    process = start("""
network = mw.Network()
genomes = [network.initial(np.random.default_rng(seed)) for seed in range(3)]
team = mw.Population(np.array(genomes), network)
few = mw.Matches.of([0, 1, 2], [2, 0, 1], [5, 6, 7])

def play(matches, threads):
    return mw.rollout("SB", team, team, matches, episodes=3, threads=threads)

expected = play(few, 1)
print("begins", flush=True)
try:
    play(mw.Matches.of(0, 1, np.arange(100_000)), 3)
except KeyboardInterrupt:
    print("interrupted", flush=True)
got = play(few, 3)
for name, column in vars(expected).items():
    np.testing.assert_array_equal(getattr(got, name), column)
assert threading.active_count() == 1
""")
    assert interrupt(process) < SECONDS
    finish(process)


@pytest.mark.parametrize(
    "call",
    [
        # The calling thread waits for the thread that plays the only match.
        "mw.rollout(world, *still, mw.Matches.of(0, 0, [1, 2]), threads=2)",
        "mw.record(world, *still, seed=1)",
    ],
    ids=["match", "recording"],
)
def test_one_long_episode_ends_soon(call):
    process = start(f"""
still = "still", "still"
world = mw.WorldConfig("SB", max_steps=2**22, n_pursuers=1, n_evaders=1)
print("begins", flush=True)
try:
    {call}
except KeyboardInterrupt:
    print("interrupted", flush=True)
""")
    assert interrupt(process, 0.1) < SECONDS
    finish(process)


# In the child an exception or a wrong result must end the child, not go on as a second parent.
FORK = """
warnings.simplefilter("ignore", DeprecationWarning)  # Python warns of forks beside threads

def in_child(play):
    number = os.fork()
    if number:
        return os.waitstatus_to_exitcode(os.waitpid(number, 0)[1])
    try:
        play()
    except BaseException:
        sys.excepthook(*sys.exc_info())
        os._exit(1)
    os._exit(0)

actions = np.random.default_rng(0).integers(0, 5, (6, 100, 38))

def play_on(batch, first=0):
    for step in range(first, 6):
        batch.step(actions[step])
    return batch.buffers["positions"].copy()
"""


def test_a_child_steps_like_its_parent():
    run(
        FORK
        + """
expected = play_on(mw.Batch(100, threads=1))
batch = mw.Batch(100, threads=3)
for step in range(3):
    batch.step(actions[step])

def play():
    np.testing.assert_array_equal(play_on(batch, 3), expected)

assert in_child(play) == 0
play()  # the parent's threads are still there
assert in_child(lambda: batch.step(actions[0])) == 0
"""
    )
