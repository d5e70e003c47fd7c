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


def forked(script: str) -> str:
    return run(FORK + script)


def test_a_child_steps_like_its_parent() -> None:
    forked("""
expected = play_on(mw.Batch(100, threads=1))
batch = mw.Batch(100, threads=3)
for step in range(3):
    batch.step(actions[step])

def play():
    np.testing.assert_array_equal(play_on(batch, 3), expected)

assert in_child(play) == 0
play()  # the parent's threads are still there
assert in_child(lambda: batch.step(actions[0])) == 0
""")


@pytest.mark.slow
def test_a_child_plays_matches_while_its_parent_does() -> None:
    """The child is forked in the middle of a rollout of another thread."""
    forked("""
matches = mw.Matches.of(0, 0, np.arange(40))
done = threading.Event()

def rollout():
    return mw.rollout("O", "hunter", "dodger", matches, threads=3).length

def be_busy():
    while not done.is_set():
        rollout()

expected = rollout()
thread = threading.Thread(target=be_busy)
thread.start()
codes = [in_child(lambda: np.testing.assert_array_equal(rollout(), expected)) for _ in range(5)]
done.set()
thread.join()
assert codes == [0] * 5
""")
