"""Processes that fork while batches and environments have threads."""

import os

import pytest

from scripts import run

pytestmark = pytest.mark.skipif(not hasattr(os, "fork"), reason="the system cannot fork")

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

EXPECTED = """
expected = play_on(mw.Batch(100, threads=1))
"""


def forked(script: str) -> str:
    return run(FORK + script)


@pytest.mark.parametrize("threads", [1, 3])
def test_a_child_steps_like_its_parent(threads: int) -> None:
    forked(f"""
{EXPECTED}
batch = mw.Batch(100, threads={threads})
for step in range(3):
    batch.step(actions[step])

def play():
    np.testing.assert_array_equal(play_on(batch, 3), expected)

assert in_child(play) == 0
play()  # the parent's threads are still there
assert in_child(lambda: batch.step(actions[0])) == 0
""")


FORK_OFTEN = """
def fork_often(busy, play, times):
    done = threading.Event()

    def be_busy():
        while not done.is_set():
            busy()

    thread = threading.Thread(target=be_busy)
    thread.start()
    codes = [in_child(play) for _ in range(times)]
    done.set()
    thread.join()
    assert codes == [0] * times
"""


@pytest.mark.slow
def test_a_child_plays_matches_while_its_parent_does() -> None:
    """The child is forked in the middle of a rollout of another thread."""
    forked(f"""
{FORK_OFTEN}
matches = mw.Matches.of(0, 0, np.arange(40))

def rollout():
    return mw.rollout("O", "hunter", "dodger", matches, threads=3).length

expected = rollout()
fork_often(rollout, lambda: np.testing.assert_array_equal(rollout(), expected), 10)
""")
