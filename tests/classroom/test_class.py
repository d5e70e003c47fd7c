"""Submissions of a class, honest, broken and hostile: what they can do, and who gets a rank."""

from __future__ import annotations

import contextlib
import io
import os
import re
import sys
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest

from class_submissions import (
    ACTS,
    HARMLESS_ATTACKS,
    REFUSED_PROGRAMS,
    honest_programs,
    problem_here,
    processes_of_programs,
    write_genomes,
    write_hostile_files,
    write_programs,
)
from matrixworld import WorldConfig, record_actions
from matrixworld.classroom import Limits, play_class, standings
from matrixworld.classroom.policy_process import CAN_FORK, PolicyServer
from matrixworld.classroom.policy_server import MODULES, NOT_CONFINED
from matrixworld.classroom.sandbox import ALLOWED
from matrixworld.classroom.submissions import MOST_BYTES, Entry, Refusal, Submission
from matrixworld.classroom.tournament import ClassResult, MatchPool, admit
from matrixworld.cli.classroom import play_command
from matrixworld.coevolution import TEAMS, Progress
from matrixworld.play.rollout import match_seed

pytestmark = pytest.mark.skipif(not CAN_FORK, reason="programs need fork")

CONFIG = WorldConfig("O", rows=8, cols=8, n_pursuers=2, n_evaders=2, max_steps=10)
HOSTILE = (
    "endless", "memory", "fork bomb", "subprocess", "writes", "reads", "socket", "exits",
    "segfault", "shape", "dtype", "range", "raises", "kills parent", "writes protocol", "thread",
    "deep source",
)  # fmt: skip
"""Attacks in a class; each attack is tried alone, too."""
ENTRIES = {"program": 14, "genome": 4}
LIMITS = Limits(seconds=1, wait=2.0, memory=128)


@pytest.fixture(scope="module", autouse=True)
def sandbox() -> None:
    problem = problem_here()
    assert problem != NOT_CONFINED
    if problem:
        pytest.skip(problem)


class Tournament(NamedTuple):
    directory: Path
    files: set[str]  # before it
    reasons: dict[str, str]  # patterns, by refused file
    result: ClassResult
    seconds: float


@pytest.fixture(scope="module")
def played(tmp_path_factory: pytest.TempPathFactory) -> Tournament:
    path = tmp_path_factory.mktemp("class")
    honest = honest_programs(ENTRIES["program"] - len(HARMLESS_ATTACKS) + 1)
    write_programs(path, {k: v for k, v in HARMLESS_ATTACKS.items() if k != "prints"} | honest)
    write_genomes(path, ENTRIES["genome"])
    write_programs(path, {name: REFUSED_PROGRAMS[name][0] for name in HOSTILE})
    reasons = write_hostile_files(path) | {f"{n}.py": REFUSED_PROGRAMS[n][1] for n in HOSTILE}
    files, began = {file.name for file in path.iterdir()}, time.monotonic()
    result = play_class(path, CONFIG, episodes=3, limits=Limits(seconds=2, wait=4.0, memory=128))
    return Tournament(path, files, reasons, result, time.monotonic() - began)


def test_fifty_submissions_are_ranked_or_refused_and_leave_nothing(played: Tournament) -> None:
    assert len(played.files) >= 50
    refused = {refusal.file: refusal.reason for refusal in played.result.refusals}
    assert refused.keys() == played.reasons.keys()
    for file, pattern in played.reasons.items():
        told = refused[file], refused[file].replace("pursue: ", "")
        assert any(re.search(pattern, text) for text in told), (file, told)
    entries = played.result.entries
    ranked = {entry.file for team in TEAMS for entry in entries[team] if entry.file}
    assert ranked == played.files - refused.keys()
    assert len(ranked) == sum(ENTRIES.values())
    assert played.seconds < 180.0  # about 15 on an idle machine
    assert {path.name for path in played.directory.iterdir()} == played.files
    assert processes_of_programs() == []


def test_stronger_policies_have_higher_scores(played: Tournament) -> None:
    scores = {
        (each.entry.team, each.entry.name): each.score.value
        for team in TEAMS
        for each in standings(played.result, team)
    }
    assert scores["pursuer", "student 00"] > scores["pursuer", "random"]
    assert scores["evader", "student 01"] > scores["evader", "random"]


def test_a_replay_is_the_match(played: Tournament) -> None:
    result = played.result
    for (g, h), actions in result.recordings.items():
        episode = record_actions(CONFIG, actions, seed=match_seed(0))
        assert episode.length == result.lengths[g, h, 0]
        assert episode.capture_rate == pytest.approx(result.capture_rates[g, h, 0])


def small(directory: Path, **changes: Any) -> ClassResult:
    given: dict[str, Any] = {"episodes": 2, "seed": 3, **changes}
    return play_class(directory, CONFIG, limits=Limits(seconds=5, wait=20.0), **given)


@pytest.mark.slow
def test_equal_results_with_any_threads_and_any_company(tmp_path: Path) -> None:
    write_programs(tmp_path, honest_programs(4))
    one, other = small(tmp_path, threads=1), small(tmp_path, threads=3)
    np.testing.assert_array_equal(one.capture_rates, other.capture_rates)
    assert all(
        np.array_equal(one.recordings[pair], other.recordings[pair]) for pair in one.recordings
    )
    different = small(tmp_path, seed=4)
    assert not np.array_equal(one.capture_rates, different.capture_rates)
    # A student who comes later changes no result of the others.
    write_programs(tmp_path, {"another": HARMLESS_ATTACKS["catches"]})
    larger = small(tmp_path)
    kept = [n for n, e in enumerate(larger.entries["pursuer"]) if e.name != "another"]
    np.testing.assert_array_equal(larger.capture_rates[kept], one.capture_rates)


def test_a_program_that_fails_in_the_tournament_is_left_out(tmp_path: Path) -> None:
    """Of two that count their calls: in all, and in the memory of one agent and one episode."""
    late = "calls = 0\ndef pursue(view, rng):\n    global calls\n    calls += 1\n"
    counts = (
        "def pursue(view, rng, memory):\n"
        "    memory['calls'] = memory.get('calls', 0) + 1\n"
        "    assert memory['calls'] <= 10, memory\n"
        "    return 0\n"
    )
    late += "    return [0][calls > 30]\n"
    write_programs(tmp_path, honest_programs(2) | {"late": late, "counts": counts})
    result = small(tmp_path, episodes=3)
    students = [entry.name for entry in result.entries["pursuer"] if entry.file]
    assert students == ["counts", "student 00"]
    [refusal] = result.refusals
    assert refusal.reason.startswith("pursue: line 5: IndexError: list index out of range (in the")
    assert np.isfinite(result.capture_rates).all()


def test_a_program_that_takes_too_long_in_all_is_left_out(tmp_path: Path) -> None:
    busy = "import time\ndef pursue(view, rng):\n    end = time.process_time() + 0.005\n"
    busy += "    while time.process_time() < end: pass\n    return 0\n"
    write_programs(tmp_path, honest_programs(1) | {"busy": busy})
    result = play_class(tmp_path, CONFIG, episodes=2, limits=Limits(in_all=0.2, wait=20.0))
    assert [(each.name, each.reason) for each in result.refusals] == [
        ("busy", "more than 0.2 seconds of processor time in all matches")
    ]


def test_directories_of_students(tmp_path: Path) -> None:
    for name in ("Ann Lee", "bo"):
        (tmp_path / name).mkdir()
        write_programs(tmp_path / name, {"policy": honest_programs(1)["student 00"]})
    (tmp_path / "bo/deeper").mkdir()
    result = small(tmp_path)
    assert [e.name for e in result.entries["pursuer"] if e.file] == ["Ann Lee", "bo"]
    assert [(each.file, each.reason) for each in result.refusals] == [
        ("bo/deeper", "expected a file, got a directory")
    ]


def test_submissions_with_names_of_modules_are_not_imported(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    names = ("random", "numpy", "json", "matrixworld", "jinja2", "scipy", "sitecustomize")
    mark = tmp_path / "mark"
    text = f"try:\n    open({str(mark)!r}, 'w')\nexcept OSError:\n    pass\n" + ACTS + "return 0\n"
    directory = tmp_path / "class"
    directory.mkdir()
    write_programs(directory, dict.fromkeys(names, text))
    monkeypatch.chdir(directory)
    result = small(Path())
    assert len([e for e in result.entries["pursuer"] if e.file]) == len(names)
    assert not mark.exists()
    for place in (str(directory), ""):
        with monkeypatch.context() as patched:
            patched.setattr("sys.path", [place, *sys.path])
            with pytest.raises(ValueError, match="directory from which Python imports nothing"):
                small(Path())
    assert not mark.exists()


def test_nothing_that_can_play_is_an_error_with_all_reasons(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="expected a submission that can play, got none$"):
        small(tmp_path)
    write_programs(tmp_path, {"a": "1 / 0", "b": "pass"})
    with pytest.raises(
        ValueError, match="a.py: line 1: ZeroDivisionError(.|\n)*b.py: expected a f"
    ):
        small(tmp_path)


def test_genomes_play_where_programs_cannot(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(PolicyServer, "ready", lambda server: server._reply() and "no filters here")
    write_genomes(tmp_path, 2)
    write_programs(tmp_path, honest_programs(1))
    result = small(tmp_path)
    assert [e.kind for e in result.entries["pursuer"]] == ["genome", "script", "script", "script"]
    [refusal] = result.refusals
    assert refusal.reason == "programs are not played here: no filters here"


def test_trusted_programs_have_limits_but_no_filter(tmp_path: Path) -> None:
    mark = tmp_path / "mark"
    reads = f"import os\nassert os.listdir({str(tmp_path)!r})\n"
    write_programs(
        tmp_path,
        {
            "reads": reads + ACTS + "return 0",
            "endless": "while True: pass",
            "writes": f"open({str(mark)!r}, 'w').write('x' * 100)",
            "forks": "import os\nif os.fork() == 0:\n    while True: pass\nraise OSError",
            "memory": "x = bytearray(1 << 40)",
            "kills": "import os\nos.kill(os.getppid(), 9)\nwhile True: pass",
        },
    )
    limits = Limits(seconds=1, wait=3.0)
    result = play_class(tmp_path, CONFIG, episodes=2, limits=limits, trust=True)
    assert [e.name for e in result.entries["pursuer"] if e.file] == ["reads"]
    refused = {each.name for each in result.refusals}
    assert refused == {"endless", "writes", "forks", "memory", "kills"}
    assert mark.stat().st_size == 100
    assert processes_of_programs() == []


def test_an_interruption_ends_all_processes(tmp_path: Path) -> None:
    write_programs(tmp_path, honest_programs(4))

    def interrupt(progress: Progress) -> None:
        if progress.what == "round robin":
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        small(tmp_path, threads=2, progress=lambda unit: contextlib.nullcontext(interrupt))
    time.sleep(0.2)
    assert processes_of_programs() == []
    with ThreadPoolExecutor(1) as pool:  # the interpreter can still make threads
        assert pool.submit(int).result() == 0


# ---- Programs alone: they can compute and answer, and nothing else -------------------------------


@pytest.fixture(scope="module")
def pool() -> Iterator[MatchPool]:
    with contextlib.closing(
        MatchPool(CONFIG, seed=0, limits=LIMITS, trust=False, threads=1, programs=True)
    ) as made:
        yield made


def admitted(pool: MatchPool, text: str) -> tuple[list[Entry], list[Refusal]]:
    submission = Submission("student", "student.py", "program", text.encode(), Path("student.py"))
    return admit([submission], pool, lambda progress: None)


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


# ---- docs/class.md: its examples work, and its numbers are those of the code ---------------------

PAGE = (Path(__file__).parents[2] / "docs" / "class.md").read_text(encoding="utf-8")
PROGRAM, TRIAL = re.findall(r"```python\n(.*?)```", PAGE, re.S)
LISTED = set(
    re.findall(r"`([\w.]+)`", PAGE.partition("A program can import")[2].partition("\n\n")[0])
)
"""The modules that a program can import."""
HEADERS = (
    Path("/usr/include/x86_64-linux-gnu/asm/unistd_64.h"),
    Path("/usr/include/asm-generic/unistd.h"),
)
"""Numbers of system calls, as Linux has them: of x86-64, and of aarch64."""


def test_the_program_of_the_page_plays(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "anna.py").write_text(PROGRAM)
    monkeypatch.syspath_prepend(tmp_path)
    with contextlib.redirect_stdout(io.StringIO()) as printed:
        exec(TRIAL, {})
    assert 0.1 < float(printed.getvalue()) < 0.9


def test_programs_as_on_the_page_can_be_handed_in(tmp_path: Path) -> None:
    """The page's own, and one that imports all that the page lists."""
    imports = "".join(f"import {name}\n" for name in sorted(LISTED))
    write_programs(tmp_path, {"anna": PROGRAM, "bo": imports + ACTS + "return 0"})
    result = small(tmp_path)
    students = [entry.name for entry in result.entries["pursuer"] if entry.file]
    assert (students, result.refusals) == (["anna", "bo"], ())


def test_limits_and_options_are_those_of_the_command() -> None:
    rows = dict(re.findall(r"^\| `(--[\w-]+)` \| (\d+) \|", PAGE, re.M))
    options = {param.opts[0]: param.default for param in play_command.params}
    assert {name: float(value) for name, value in rows.items()} == {
        name: float(options[name]) for name in ("--seconds", "--wait", "--in-all", "--memory")
    }
    assert set(re.findall(r"`(--[\w-]+)", PAGE)) <= {*options, "--no-open"}
    assert f"allows {len(ALLOWED)} of them" in PAGE
    assert (MOST_BYTES["program"], MOST_BYTES["genome"]) == (256 << 10, 8 << 20)


def test_all_modules_that_programs_may_import_are_listed() -> None:
    hidden = {name for name in MODULES if name.startswith(("__", "numpy.", "encodings."))}
    assert {name.removesuffix(".abc") for name in set(MODULES) - hidden} | {"numpy"} == LISTED


@pytest.mark.parametrize("column", [0, 1])
def test_numbers_of_system_calls_are_those_of_linux(column: int) -> None:
    if not HEADERS[column].exists():
        pytest.skip("needs the headers of Linux")
    text = HEADERS[column].read_text(encoding="utf-8")
    numbers = dict(re.findall(r"#define __NR(?:3264)?_(\w+)\s+(\d+)", text))
    assert {name: int(numbers[name]) for name in ALLOWED} == {
        name: row[column] for name, row in ALLOWED.items()
    }
