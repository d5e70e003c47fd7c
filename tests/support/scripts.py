"""Python scripts that tests run in a process of their own, and the end of processes."""

import os
import signal
import subprocess
import sys
import textwrap
import time

PREAMBLE = """
import os, signal, sys, threading, time, warnings
import numpy as np
import matrixworld as mw
"""

SECONDS = 60
"""A script that hangs is ended after this time."""


def start(script, *options):
    """Start a script; `np`, `mw` and usual modules are imported already."""
    return subprocess.Popen(
        [sys.executable, *options, "-c", PREAMBLE + textwrap.dedent(script)],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        # The script and the processes that it forks are a group, which can be ended together.
        start_new_session=True,
        # In a background job SIGINT may be ignored, and child processes inherit that.
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )


def python(*words, **options):
    """Run Python with the modules of this process; return its output, errors and exit code."""
    env = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    kept = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True, "timeout": 120}
    return subprocess.run([sys.executable, *map(str, words)], env=env, **{**kept, **options})


def finish(process):
    """Return the output of a script; fail if it hangs or ends with an error."""
    try:
        output, errors = process.communicate(timeout=SECONDS)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        output, errors = process.communicate()
        raise AssertionError(f"the script hangs:\n{output}{errors}") from None
    assert process.returncode == 0, f"exit code {process.returncode}:\n{output}{errors}"
    return output


def run(script, *options):
    """Run a script to its end and return its output."""
    return finish(start(script, *options))


def wait_until(happened, what, seconds=120.0):
    end = time.monotonic() + seconds
    while not happened():
        assert time.monotonic() < end, f"{what}: did not happen within {seconds} s"
        time.sleep(0.02)


def group_lives(leader):
    try:
        os.killpg(leader, 0)
    except ProcessLookupError:
        return False
    return True
