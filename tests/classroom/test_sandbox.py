"""What a submitted program can do: compute and answer, and nothing else."""

from __future__ import annotations

import os
import re
import time
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path

import pytest

from class_submissions import (
    ACTS,
    HARMLESS_ATTACKS,
    REFUSED_PROGRAMS,
    honest_programs,
    processes_of_programs,
)
from matrixworld import WorldConfig
from matrixworld.classroom import Limits
from matrixworld.classroom.policy_process import CAN_FORK
from matrixworld.classroom.policy_server import NOT_CONFINED
from matrixworld.classroom.submissions import Entry, Refusal, Submission
from matrixworld.classroom.tournament import MatchPool, admit

pytestmark = pytest.mark.skipif(not CAN_FORK, reason="programs need fork")

CONFIG = WorldConfig("O", rows=8, cols=8, n_pursuers=2, n_evaders=2, max_steps=5)
LIMITS = Limits(seconds=1, wait=2.0, memory=128)


@pytest.fixture(scope="module")
def pool() -> Iterator[MatchPool]:
    with closing(
        MatchPool(CONFIG, seed=0, limits=LIMITS, trust=False, threads=1, programs=True)
    ) as made:
        assert made.problem != NOT_CONFINED
        if made.problem:
            pytest.skip(made.problem)
        yield made


def admitted(pool: MatchPool, text: str) -> tuple[list[Entry], list[Refusal]]:
    submission = Submission("student", "student.py", "program", text.encode(), Path("student.py"))
    return admit([submission], pool, lambda what, done, total: None)


def assert_plays(pool: MatchPool, first_lines: str) -> None:
    """Check that a program which begins so is not refused."""
    entries, refusals = admitted(pool, first_lines + ACTS + "return 0")
    assert (len(entries), refusals) == (1, [])


@pytest.mark.parametrize("name", REFUSED_PROGRAMS)
def test_a_program_that_breaks_a_rule_is_refused(
    pool: MatchPool, name: str, tmp_path: Path
) -> None:
    (tmp_path / "student 00.py").write_text("")
    before = processes_of_programs()
    text, reason = REFUSED_PROGRAMS[name]
    text = text.replace("{mark}", str(tmp_path / "mark")).replace("{directory}", str(tmp_path))
    began = time.monotonic()
    entries, [refusal] = admitted(pool, text)
    assert entries == []
    assert re.search(reason, refusal.reason), refusal.reason
    assert len(refusal.reason) < 400
    assert time.monotonic() - began < 20.0
    assert [path.name for path in tmp_path.iterdir()] == ["student 00.py"]
    assert processes_of_programs() == before


@pytest.mark.parametrize("name", HARMLESS_ATTACKS)
def test_a_program_that_changes_its_own_process_only_plays(
    pool: MatchPool, name: str, tmp_path: Path
) -> None:
    text = HARMLESS_ATTACKS[name].replace("{mark}", str(tmp_path / "mark"))
    [entry], refusals = admitted(pool, text)
    assert (entry.team, refusals) == ("pursuer", [])
    assert list(tmp_path.iterdir()) == []


def test_the_next_program_finds_nothing_of_the_one_before(pool: MatchPool) -> None:
    admitted(pool, "import builtins, math\nbuiltins.left = math.left = 1\n" + ACTS + "return 0")
    assert_plays(
        pool,
        "import builtins, math\n"
        "assert not hasattr(builtins, 'left')\n"
        "assert not hasattr(math, 'left')\n",
    )


def test_a_program_sees_no_environment_and_no_other_open_file(pool: MatchPool) -> None:
    assert_plays(
        pool,
        "import os\n"
        "assert not os.environ, os.environ\n"
        "for handle in range(4, 100):\n"
        "    try:\n        os.read(handle, 1)\n"
        "    except OSError as error:\n        assert error.errno == 9\n"
        "    else:\n        raise AssertionError(handle)\n",
    )


@pytest.mark.parametrize("call", [0, 56, 57, 62, 101, 157, 160, 302, 321, 425, 435])
def test_system_calls_by_number_fail(pool: MatchPool, call: int) -> None:
    """By hand, as a program could do without Python: clone, kill, ptrace, limits, bpf, io_uring."""
    if os.uname().machine != "x86_64":
        pytest.skip("numbers of x86-64")
    number = call or 0x40000000 + 2  # open by its number in the x32 interface
    assert_plays(
        pool,
        "import ctypes\nlibrary = ctypes.CDLL(None, use_errno=True)\n"
        f"assert library.syscall({number}, 0, 0, 0, 0, 0) == -1\n"
        "assert ctypes.get_errno() == 1, ctypes.get_errno()\n",
    )


def test_honest_programs_play_both_teams(pool: MatchPool) -> None:
    teams = []
    for text in honest_programs(4).values():
        entries, refusals = admitted(pool, text)
        assert refusals == []
        teams.append([entry.team for entry in entries])
    assert teams == [["pursuer"], ["evader"], ["pursuer", "evader"], ["pursuer", "evader"]]
