"""Ctrl-C in the middle of long calls of the engine."""

import os
import signal
import sys
import threading
import time
from subprocess import Popen

import pytest

from scripts import finish, start

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="signals of POSIX systems")

SECONDS = 1.0
"""The engine looks for signals every 50 ms; a busy machine gets more time here."""

MATCHES = """
network = mw.Network()
genomes = [network.initial(np.random.default_rng(seed)) for seed in range(3)]
team = mw.Population(np.array(genomes), network)
few = mw.Matches.of([0, 1, 2], [2, 0, 1], [5, 6, 7])
many = mw.Matches.of(0, 1, np.arange(100_000))

def play(matches, threads):
    return mw.rollout("SB", team, team, matches, episodes=3, threads=threads)
"""

INTERRUPTED = """
print("begins", flush=True)
try:
    {call}
except KeyboardInterrupt:
    print("interrupted", flush=True)
"""


def interrupt(process: Popen[str], after: float = 0.3) -> float:
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


@pytest.mark.parametrize("threads", [1, 3])
def test_a_rollout_ends_soon_and_leaves_all_as_it_was(threads: int) -> None:
    process = start(f"""
{MATCHES}
expected = play(few, 1)
matches = many._replace(seed=many.seed.copy())
{INTERRUPTED.format(call=f"play(matches, {threads})")}
got = play(few, {threads})
for name, column in vars(expected).items():
    np.testing.assert_array_equal(getattr(got, name), column)
for ours, theirs in zip(matches, many):
    np.testing.assert_array_equal(ours, theirs)
assert threading.active_count() == 1
""")
    assert interrupt(process) < SECONDS
    finish(process)


@pytest.mark.parametrize(
    ("max_steps", "call", "after"),
    [
        # The calling thread waits for the thread that plays the only match.
        (2**30, "mw.rollout(world, *still, mw.Matches.of(0, 0, [1, 2]), threads=2)", 0.3),
        (2**20, "mw.record(world, *still, seed=1)", 0.1),
    ],
    ids=["match", "recording"],
)
def test_one_long_episode_ends_soon(max_steps: int, call: str, after: float) -> None:
    process = start(f"""
still = "still", "still"
world = mw.WorldConfig("SB", max_steps={max_steps}, n_pursuers=1, n_evaders=1)
{INTERRUPTED.format(call=call)}
""")
    assert interrupt(process, after) < SECONDS
    finish(process)
