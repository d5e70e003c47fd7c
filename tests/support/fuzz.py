"""Random use of everything, by one number: worlds, races, commands, files, kills, clocks.

    python tests/support/fuzz.py 7 --minutes 10
    python tests/support/fuzz.py 7 --step 123      # that step again, alone

Each step draws what it does from the seed and its own number, and has a right answer: the slow
world of the tests, the same bytes by another way, or one sentence and no change. Steps that fail
are printed with seed and number; the exit code is then 1. What was found becomes a test of its
subject, by ``fuzz.step_of(seed, number)`` where nothing shorter shows it.
"""

import argparse
import atexit
import contextlib
import os
import random
import shutil
import signal
import sys
import time
import traceback
import warnings
from collections.abc import Callable
from functools import cache
from pathlib import Path
from tempfile import mkdtemp
from unittest import mock

import numpy as np
from click.testing import CliRunner

TESTS = Path(__file__).resolve().parents[1]
sys.path[1:1] = [str(TESTS / folder) for folder in ("cli", "contract", "play")]

from test_borders import CASES, borders, make_template, problem_of, tree, usual  # noqa: E402
from test_lockstep import assert_same_one_by_one  # noqa: E402
from test_reference import compare  # noqa: E402

import matrixworld as mw  # noqa: E402
from command_line import READING  # noqa: E402
from killed import SETTINGS, play_run, run_until_killed  # noqa: E402
from matrixworld.cli import main as command  # noqa: E402
from matrixworld.coevolution import Run, create, finish  # noqa: E402
from matrixworld.coevolution.learners.learner import DivergedError  # noqa: E402
from right_of_way import play  # noqa: E402
from rows import archive  # noqa: E402
from scenes import FIELDS, random_scene  # noqa: E402
from tiny_race import (  # noqa: E402
    directory_in_memory,
    played,
    results,
    stop_and_continue,
    straight,
    tiny_race,
    tiny_single,
)

Rng = np.random.Generator
Step = Callable[[Rng, Path], None]


def pick(rng, choices):
    found = [*choices]
    return found[rng.integers(len(found))]


# ---- Worlds and races ----------------------------------------------------------------------------


def worlds(rng, place):
    """Steps as in the slow world, rollouts as worlds one by one, and right of way without fault."""
    for _ in range(20):
        compare(random_scene({name: pick(rng, values) for name, values in FIELDS.items()}, rng))
    rows, cols, n, m, most = (int(k) for k in rng.integers((3, 3, 1, 1, 1), (9, 9, 4, 4, 40)))
    config = mw.WorldConfig(
        pick(rng, mw.VARIANTS), rows=rows, cols=cols, n_pursuers=n, n_evaders=m, max_steps=most,
        fov=int(pick(rng, (5, 7))), diagonal=bool(rng.integers(2)),
    )  # fmt: skip
    matches = mw.Matches.of(0, 0, rng.integers(2**63, size=rng.integers(1, 8)))
    teams = (pick(rng, mw.SCRIPTS) for _ in range(2))
    assert_same_one_by_one(config, *teams, matches, episodes=2, threads=int(rng.integers(1, 3)))
    _, faults, _ = play(500, int(rng.integers(2**31)))
    assert faults == 0, f"{faults} agents with right of way at fault"


CHOICES = {
    "learner": ("es", "ga", "cma", "gp", "es"),
    "policy": ("cells", "rating", "program"),
    "schedule": ("specialist-specialist", "generalist-generalist", "hall-of-fame", "psro"),
    "policy.mask": ("none", "obstacles", "right-of-way"),
    "policy.memory": ("none", "gru"),
    "hidden": ((), (3,), (5, 4)),
    "rules": (*mw.VARIANTS,),
    "fov": (1, 3, 5),
    "n_pursuers": (1, 2, 5),
    "obstacles": (0.0, 0.1),
    "diagonal": (False, True),
    "learner.measure": ("captured-fraction", "capture-rate", "rewards", "guarantee"),
    "learner.cost_limit": (None, 20.0),
    "sigma": (0.1, 1e-9, 1e4, 1e16),
    "population": (2, 4, 7),
    "match_episodes": (1, 2),
    "retest_episodes": (0, 1),
    "seed": (0, 2**53 - 1),
}


def races(rng, place):
    """Settings are refused in a sentence, or the run ends with the same bytes by three ways."""
    drawn = {name: pick(rng, CHOICES[name]) for name in CHOICES if rng.random() < 0.3}
    make = tiny_single if rng.random() < 0.2 else tiny_race
    try:
        settings = make(**drawn)
        played(settings, place / "one")
    except (DivergedError, TypeError, ValueError) as error:
        if "expected" not in str(error):
            raise
        return
    expected = results(place / "one")
    assert results(played(settings, place / "two", threads=2).path) == expected, drawn
    with contextlib.suppress(BaseException):  # it may end before it is stopped
        stop_and_continue(lambda path, **more: begin(settings, path), 3, place / "three")
    assert results(finish(create(settings, place / "three").path).path) == expected, drawn


def begin(settings, directory):
    create(settings, directory)
    return Run(directory, threads=1)


# ---- Commands and files --------------------------------------------------------------------------


@cache
def template():
    """A directory with a finished race, and files that are none."""
    root = Path(mkdtemp(prefix="fuzz-"))
    atexit.register(shutil.rmtree, root)
    played(tiny_race(), root / "race")
    make_template(root / "race", root / "here")
    return root / "here"


@contextlib.contextmanager
def here(place):
    """Work in a copy of the template, inside of a directory that must not change, either."""
    root, before = place / "case", os.getcwd()
    shutil.copytree(template(), root / "here", symlinks=True)
    os.chdir(root / "here")
    try:
        with mock.patch("webbrowser.open"), mock.patch("matrixworld.cli.evolve.report"):
            yield root
    finally:
        os.chdir(before)


def commands(rng, place):
    """A command with a few words at the borders of what it takes."""
    with here(place) as root:
        chosen, first = CASES[rng.integers(len(CASES))]
        tried = [first, *(p for p in chosen.params if p is not first and rng.random() < 0.1)]
        words = [w for p in chosen.params if p not in tried for w in usual(chosen, p)]
        tried.sort(key=lambda p: p.param_type_name, reverse=True)  # options, then arguments
        words += [word for p in tried for word in pick(rng, borders(p))]
        problem = problem_of([str(chosen.name), *words], root, tree(root))
        assert not problem, f"{chosen.name} {words}: {problem}"


def damaged(content, rng):
    """Return a content that is cut, altered, doubled or mixed up."""
    a, b = sorted(int(k) for k in rng.integers(0, len(content) + 1, 2))
    kind = rng.integers(6)
    if kind == 0:
        return content[:a]
    if kind == 1 and content:
        altered = bytearray(content)
        for _ in range(rng.integers(1, 4)):
            altered[rng.integers(len(altered))] ^= int(rng.integers(1, 256))
        return bytes(altered)
    if kind == 2:
        return content[:a] + content[b:]
    if kind == 3:
        return content[:b] + content[a:]
    if kind == 4:
        return content[:a] + bytes(b - a) + content[b:]
    return archive({"config.json": content[a:b], "payoff.npy": content[:a]})


QUICK = [words for words in READING if words[0] != "explore"]


@cache
def said_of_whole(words):
    """Return what a command says of whole files."""
    with directory_in_memory() as place, here(place):
        return CliRunner().invoke(command, words).stdout


def files(rng, place):
    """A reader of a damaged file says so in a sentence, or what it said of the whole one."""
    words = pick(rng, READING if rng.random() < 0.1 else QUICK)
    expected = said_of_whole(tuple(words))
    with here(place) as root:
        kept = [path for path in Path("RUN").iterdir() if path.is_file()]
        path = pick(rng, sorted(kept))
        path.write_bytes(damaged(path.read_bytes(), rng))
        problem = problem_of(words, root, tree(root))
        assert not problem or "--force" in words, f"{words}, {path}: {problem}"
        again = CliRunner().invoke(command, words)
        same = again.exit_code or again.stdout == expected
        assert same or path.suffix != ".npz", f"{words}, {path}: {again.stdout}"


# ---- Kills and clocks ----------------------------------------------------------------------------


def kills(rng, place):
    """A run that is killed, at a write or at any moment, again and again, ends with equal bytes."""
    kind, run = pick(rng, sorted(SETTINGS)), place / "run"
    for _ in range(rng.integers(1, 4)):
        at, moment = int(rng.integers(60)), float(rng.uniform(0, 0.2))
        anytime = rng.random() < 0.5
        child = os.fork()
        if child == 0:
            with contextlib.suppress(BaseException):
                run_until_killed(kind, run, 10**9 if anytime else at)
            os._exit(0)
        if anytime:
            time.sleep(moment)
            os.kill(child, pick(rng, (signal.SIGKILL, signal.SIGINT, signal.SIGTERM)))
        os.waitpid(child, 0)
    play_run(kind, run)
    assert results(run) == straight(SETTINGS[kind]), f"{kind}: other bytes"
    left = [each.name for each in run.glob(".*.tmp")]
    assert not left, f"{kind}: {left}"


@contextlib.contextmanager
def jumping_clock(rng):
    """Let all clocks of Python jump, by seconds or by years, and those of files lie, too."""
    plain = {name: getattr(time, name) for name in ("time", "monotonic", "perf_counter")}
    jumps = [float(pick(rng, (0, 1, -1, 3600, -3600, 1e8, -1e8, 0.5))) for _ in range(97)]
    calls = iter(range(10**9))

    def jumps_of(read):
        return lambda: read() + jumps[next(calls) % len(jumps)]

    with mock.patch.multiple(time, **{name: jumps_of(read) for name, read in plain.items()}):
        yield


def clocks(rng, place):
    """Results do not depend on clocks, nor on the times of files."""
    kind = pick(rng, ("race", "single", "short hall-of-fame"))
    with jumping_clock(rng):
        path = played(SETTINGS[kind], place / "run").path
    assert results(path) == straight(SETTINGS[kind]), f"{kind}: other bytes"
    with here(place):
        words = pick(rng, [each for each in QUICK if each[0] in ("judge", "score")])
        expected = said_of_whole(tuple(words))
        for file in Path("RUN").iterdir():
            moment = float(rng.uniform(0, 2**33))
            os.utime(file, (moment, moment))
        with jumping_clock(rng):
            again = CliRunner().invoke(command, words)
        assert (again.exit_code, again.stdout) == (0, expected), words


# ---- The loop ------------------------------------------------------------------------------------

KINDS = {each.__name__: each for each in (worlds, races, commands, files, kills, clocks)}


def step_of(seed, number, kinds=KINDS):
    """Do a step; return what is wrong, with the seed and the number, or nothing."""
    rng = np.random.default_rng([seed, number])
    kind = pick(rng, kinds)
    random.seed(int(rng.integers(2**31)))
    with directory_in_memory() as place, warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            KINDS[kind](rng, place)
        except Exception as error:  # noqa: BLE001, whatever it is
            told = "".join(traceback.format_exception(error)[-2:])
            return f"seed {seed}, step {number} ({kind}): {told}"
    return ""


def fuzz(seed, *, minutes=np.inf, steps=10**9, kinds=KINDS):
    """Do one step after the other; return what the first one that fails says, or nothing."""
    end = time.monotonic() + 60 * minutes
    for number in range(steps):
        if time.monotonic() > end:
            break
        if problem := step_of(seed, number, kinds):
            return problem
    return ""


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("seed", type=int)
    parser.add_argument("--minutes", type=float, default=10.0)
    parser.add_argument("--step", type=int, help="do this step alone")
    args = parser.parse_args()
    number, end, found = args.step or 0, time.monotonic() + 60 * args.minutes, False
    while time.monotonic() < end or args.step is not None:
        if problem := step_of(args.seed, number):
            sys.stdout.write(f"{problem}\n")
            sys.stdout.flush()
            found = True
        if args.step is not None:
            break
        number += 1
    sys.stdout.write(f"seed {args.seed}: {number} steps\n")
    sys.exit(found)


if __name__ == "__main__":
    main()
