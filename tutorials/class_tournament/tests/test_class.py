"""Submissions of a class, honest, broken and hostile: what they can do, and who gets a rank."""

import contextlib
import io
import os
import re
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import asdict
from itertools import product
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest

from class_submissions import (
    ACTS,
    HARMLESS_ATTACKS,
    REFUSED_PROGRAMS,
    honest_programs,
    past_the_list,
    problem_here,
    processes_of_programs,
    write_genomes,
    write_hostile_files,
    write_programs,
)
from class_tournament.policy_process import CAN_FORK, Limits, PolicyProcess, PolicyServer
from class_tournament.policy_server import FUNCTIONS, MODULES, NOT_CONFINED
from class_tournament.results import ClassResult
from class_tournament.round_robin import MatchPool, admit, play_class
from class_tournament.sandbox import ALLOWED, ANSWERED_BY_0
from class_tournament.submissions import Entry, Refusal, Submission
from matrixworld import Network, NetworkPolicy, World, WorldConfig, record_actions
from matrixworld.coevolution import TEAMS, Progress, Team
from matrixworld.coevolution.seeding import match_seed
from matrixworld.play import save_genome
from scripts import wait_until
from slow import quickly

pytestmark = pytest.mark.skipif(not CAN_FORK, reason="programs need fork")

FOLDER = Path(__file__).parents[1]
CONFIG = WorldConfig("O", rows=8, cols=8, n_pursuers=2, n_evaders=2, max_steps=10)
HOSTILE = ("endless", "memory", "writes", "exits", "segfault", "raises", "writes protocol")
"""Attacks in a class; each attack is tried alone, too."""
ENTRIES = {"program": 9, "genome": 2}
# As small as honest programs allow: hostile ones use all.
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


@pytest.fixture(scope="module")
def played(tmp_path_factory: pytest.TempPathFactory) -> Tournament:
    path = tmp_path_factory.mktemp("class")
    honest = honest_programs(ENTRIES["program"] - len(HARMLESS_ATTACKS))
    write_programs(path, HARMLESS_ATTACKS | honest)
    write_genomes(path, ENTRIES["genome"])
    write_programs(path, {name: REFUSED_PROGRAMS[name][0] for name in HOSTILE})
    reasons = write_hostile_files(path) | {f"{n}.py": REFUSED_PROGRAMS[n][1] for n in HOSTILE}
    files = {file.name for file in path.iterdir()}
    limits = Limits(seconds=1, wait=4.0, memory=128)
    result = play_class(path, CONFIG, episodes=3, limits=limits, threads=2)
    return Tournament(path, files, reasons, result)


def test_submissions_are_ranked_or_refused_and_leave_nothing(played: Tournament) -> None:
    refused = {refusal.file: refusal.reason for refusal in played.result.refusals}
    assert refused.keys() == played.reasons.keys()
    for file, pattern in played.reasons.items():
        told = refused[file], refused[file].replace("pursue: ", "")
        assert any(re.search(pattern, text) for text in told), (file, told)
    entries = played.result.entries
    ranked = {entry.file for team in TEAMS for entry in entries[team] if entry.file}
    assert ranked == played.files - refused.keys()
    assert len(ranked) == sum(ENTRIES.values())
    one, other = ({entry.name for entry in entries[team]} for team in TEAMS)
    assert {"student 02", "student 03"} <= one & other
    assert {path.name for path in played.directory.iterdir()} == played.files  # nothing was written
    assert processes_of_programs() == []


def test_stronger_policies_have_higher_scores(played: Tournament) -> None:
    scores = {
        (each.entry.team, each.entry.name): each.score.value
        for team in TEAMS
        for each in played.result.standings[team]
    }
    assert scores["pursuer", "student 00"] > scores["pursuer", "random"]
    assert scores["evader", "student 01"] > scores["evader", "random"]


def test_a_replay_is_the_match(played: Tournament) -> None:
    result = played.result
    for (g, h), actions in result.recordings.items():
        episode = record_actions(CONFIG, actions, seed=result.match_seed)
        assert episode.length == result.lengths[g, h, 0]
        assert episode.capture_rate == pytest.approx(result.capture_rates[g, h, 0])


def small(directory: Path, **changes: Any) -> ClassResult:
    given: dict[str, Any] = {"episodes": 2, "seed": 3, "threads": 1, **changes}
    return play_class(directory, CONFIG, limits=Limits(seconds=5, wait=20.0), **given)


@pytest.mark.slow
def test_equal_results_with_any_threads_and_any_company(tmp_path: Path) -> None:
    write_programs(tmp_path, honest_programs(4))
    one, other = small(tmp_path, threads=1), small(tmp_path, threads=3)
    np.testing.assert_array_equal(one.capture_rates, other.capture_rates)
    assert all(
        np.array_equal(one.recordings[pair], other.recordings[pair]) for pair in one.recordings
    )
    different = small(tmp_path, seed=4)  # else equal results would show nothing
    assert not np.array_equal(one.capture_rates, different.capture_rates)
    # A student who comes later changes no result of the others.
    write_programs(tmp_path, {"another": HARMLESS_ATTACKS["catches"]})
    larger = small(tmp_path)
    kept = [n for n, e in enumerate(larger.entries["pursuer"]) if e.name != "another"]
    np.testing.assert_array_equal(larger.capture_rates[kept], one.capture_rates)


@pytest.mark.slow
def test_a_program_that_fails_in_the_tournament_is_left_out(tmp_path: Path) -> None:
    """Of two that count their calls: in all, and in the memory of one agent and one episode."""
    late = "calls = 0\ndef pursue(view, rng):\n    global calls\n    calls += 1\n"
    counts = (
        "def pursue(view, rng, memory):\n"
        "    memory['calls'] = memory.get('calls', 0) + 1\n"
        "    assert memory['calls'] <= 10, memory\n"
        "    return 0\n"
    )
    late += "    return [0][calls > 30]\n"  # after more calls than the trial of an entry makes
    write_programs(tmp_path, honest_programs(2) | {"late": late, "counts": counts})
    result = small(tmp_path, episodes=3)
    students = [entry.name for entry in result.entries["pursuer"] if entry.file]
    assert students == ["counts", "student 00"]
    [refusal] = result.refusals
    assert refusal.reason.startswith("pursue: line 5: IndexError: list index out of range (while")
    assert np.isfinite(result.capture_rates).all()


@pytest.mark.slow
def test_a_program_that_takes_too_long_in_all_is_left_out(tmp_path: Path) -> None:
    # 5 ms an answer: legal in a match, too much in all.
    busy = "import time\ndef pursue(view, rng):\n    end = time.process_time() + 0.005\n"
    busy += "    while time.process_time() < end: pass\n    return 0\n"
    write_programs(tmp_path, honest_programs(1) | {"busy": busy})
    result = play_class(
        tmp_path, CONFIG, episodes=2, limits=Limits(in_all=0.2, wait=20.0), threads=1
    )
    assert [(each.name, each.reason) for each in result.refusals] == [
        ("busy", "more than 0.2 seconds of processor time in all matches")
    ]


@pytest.mark.slow
def test_a_program_that_waits_ends_by_the_clock(tmp_path: Path) -> None:
    """Without processor time, and with answers that each come in time: in a match and in all."""
    waits = (
        "lock = _thread.allocate_lock()\nlock.acquire()\n"
        "def pursue(view, rng):\n    lock.acquire(timeout={})\n    return 0\n"
    )
    write_programs(
        tmp_path,
        honest_programs(1)
        | {
            "match": "import _thread\n" + waits.format(0.2),
            "all": "import _thread\n" + waits.format(0.06),
        },
    )
    began = time.monotonic()
    limits = Limits(wait=5.0, clock=3.0, clock_in_all=3.5)
    result = play_class(tmp_path, CONFIG, episodes=2, limits=limits, threads=1)
    reasons = {each.name: each.reason for each in result.refusals}
    # A slow machine may end the trial in time and the first match not, which the reason says.
    assert reasons["match"].startswith("pursue: more than 3 seconds by the clock in a match")
    assert reasons["all"].startswith("pursue: more than 3.5 seconds by the clock in all matches")
    assert time.monotonic() - began < 15.0


@pytest.mark.slow
def test_limits_of_time_count_for_genomes(tmp_path: Path) -> None:
    """A file of 7.9 MB, whose network takes long for each match."""
    network = Network(hidden=(1400, 1000), fov=11)
    policy = NetworkPolicy(network, np.zeros(network.genome_size, np.float32))
    save_genome(tmp_path / "large.npz", "pursuer", policy)
    write_genomes(tmp_path, 1)
    limits = Limits(in_all=0.05)
    result = play_class(tmp_path, CONFIG, episodes=300, limits=limits, threads=1)
    [refusal] = result.refusals
    assert refusal.file == "large.npz"
    text = r"more than [\d.]+ seconds of processor time in all matches \(while"
    assert re.match(text, refusal.reason)


def test_submissions_with_names_of_modules_are_not_imported(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # What Python or the package imports later.
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


@pytest.mark.slow
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


@pytest.mark.slow
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
            "memory": "x = bytearray(1 << 40)",  # a terabyte
            "kills": "import os\nos.kill(os.getppid(), 9)\nwhile True: pass",
        },
    )
    limits = Limits(seconds=1, wait=3.0)
    result = play_class(tmp_path, CONFIG, episodes=2, limits=limits, trust=True, threads=1)
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
        small(tmp_path, threads=2, report=interrupt)
    wait_until(lambda: not processes_of_programs(), "end of all programs", 5.0)
    with ThreadPoolExecutor(1) as pool:  # the interpreter can still make threads
        assert pool.submit(int).result() == 0


@pytest.mark.slow
@pytest.mark.parametrize(
    "pause", [0.06, *(pytest.param(each, marks=pytest.mark.nightly) for each in (0.0, 0.3))]
)
def test_two_interruptions_end_the_command(tmp_path: Path, pause: float) -> None:
    with playing(tmp_path) as command:
        for _ in range(2):
            command.send_signal(signal.SIGINT)
            time.sleep(pause)
        # The second may meet the end of the interpreter, when nothing is left to end.
        assert command.wait(timeout=10.0) in (130, -signal.SIGINT)
    wait_until(lambda: not processes_of_programs(), "end of all programs", 5.0)


@pytest.mark.slow
def test_a_killed_command_leaves_no_process(tmp_path: Path) -> None:
    with playing(tmp_path) as command:
        command.kill()
    wait_until(lambda: not processes_of_programs(), "end of all programs", 5.0)


@contextlib.contextmanager
def playing(path: Path) -> Iterator[subprocess.Popen[bytes]]:
    """Run the command with programs that do not answer."""
    write_programs(path, dict.fromkeys("abc", REFUSED_PROGRAMS["deadlock"][0]))
    words = [sys.executable, str(FOLDER), str(path), "--wait", "60", "--no-open"]
    command = subprocess.Popen(
        [*words, "--threads", "2"],
        stderr=subprocess.DEVNULL,
        # A shell's background job ignores Ctrl-C, and what it starts inherits that.
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )
    try:
        last = time.monotonic() + 30.0
        while len(children(command.pid)) < 2 or not any(map(children, children(command.pid))):
            assert time.monotonic() < last
            time.sleep(0.05)
        time.sleep(0.5)
        yield command
    finally:
        command.kill()
        command.wait()


def children(parent: int) -> list[int]:
    found = Path(f"/proc/{parent}/task/{parent}/children")
    return [int(number) for number in found.read_text().split()] if found.exists() else []


# ---- Programs alone: they can compute and answer, and nothing else -------------------------------

USUAL = ("fork bomb", "reads", "socket", "by ctypes", "kills parent")
"""Attacks that are tried alone with each change; the others, with the slow tests."""


@pytest.fixture(scope="module")
def pool() -> Iterator[MatchPool]:
    with contextlib.closing(
        MatchPool(CONFIG, 0, LIMITS, trust=False, threads=1, programs=True)
    ) as made:
        yield made


def admitted(pool: MatchPool, text: str) -> tuple[list[Entry], list[Refusal]]:
    content = past_the_list(text).encode()
    submission = Submission("student", "student.py", "program", content, Path("student.py"))
    return admit([submission], pool, lambda progress: None)


def assert_plays(pool: MatchPool, first_lines: str) -> None:
    """Check that a program which begins so is not refused."""
    entries, refusals = admitted(pool, first_lines + ACTS + "return 0")
    assert (len(entries), refusals) == (1, [])


@quickly("name", REFUSED_PROGRAMS, lambda name: name in USUAL, others=pytest.mark.slow)
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
    assert len(refusal.reason) < 400  # a program may raise an error of any length
    assert time.monotonic() - began < 20.0
    assert [path.name for path in tmp_path.iterdir()] == ["student 00.py"]
    assert processes_of_programs() == before


LEGAL = {
    "a dataclass with texts as annotations": (
        "from __future__ import annotations\nfrom dataclasses import dataclass\n"
        "@dataclass\nclass Plan:\n    move: int = 1\n" + ACTS + "return Plan().move"
    ),
    "all names of NumPy": "from numpy import *\n" + ACTS + "return int(argmax([0, 1]))",
    "a pause": "import time\n" + ACTS + "time.sleep(0.001)\n    return 1",
    "defaults": "def pursue(view=None, rng=None, depth=3):\n    return int(depth == 3)",
    "memory with a default": (
        "def pursue(view, rng, memory=None):\n    memory['calls'] = 1\n    return 1"
    ),
    "any arguments": "def pursue(*given):\n    return len(given) - 1",
    "a class": "class Agent:\n    def __call__(self, view, rng): return 1\npursue = Agent()",
}


@pytest.mark.parametrize("name", LEGAL)
def test_a_program_that_follows_the_rules_plays(pool: MatchPool, name: str) -> None:
    entries, refusals = admitted(pool, LEGAL[name])
    assert (len(entries), refusals) == (1, [])


def test_no_program_can_tell_how_many_matches_were_before(
    pool: MatchPool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """By the numbers of processes, which grow, in an order that it knows."""
    assert_plays(
        pool, "import os\nimport threading\nassert os.getpid() == threading.get_native_id() == 0\n"
    )
    students = [Entry(str(n), team, "program", "", bytes([n])) for n in range(4) for team in TEAMS]
    pairs = [*product(students[::2], students[1::2])]
    orders = []
    for seed in (1, 2):
        monkeypatch.setattr(pool, "_seed", seed)
        orders.append([pairs.index(pair) for pair in sorted(pairs, key=pool.order)])
    assert orders[0] != orders[1]
    assert sorted(pairs[:5], key=pool.order) == [
        p for p in sorted(pairs, key=pool.order) if p in pairs[:5]
    ]


@pytest.mark.parametrize("what", ["server", "program"])
def test_who_was_killed_from_outside_plays_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, what: str
) -> None:
    """In the trial, and in the tournament."""
    write_programs(tmp_path, honest_programs(2))
    expected, ask, asked = small(tmp_path), PolicyProcess.actions, []

    def actions(program: PolicyProcess, *given: Any) -> Any:
        asked.append(program)
        if len(asked) in (2, 60):
            server = program._server._process.pid
            os.kill(server if what == "server" else children(server)[0], signal.SIGKILL)
        return ask(program, *given)

    monkeypatch.setattr(PolicyProcess, "actions", actions)
    result = small(tmp_path)
    assert len(asked) > 60
    assert result.refusals == ()
    np.testing.assert_array_equal(result.capture_rates, expected.capture_rates)


def test_the_next_program_finds_nothing_of_the_one_before(pool: MatchPool) -> None:
    admitted(
        pool, "import builtins\nimport math\nbuiltins.left = math.left = 1\n" + ACTS + "return 0"
    )
    assert_plays(
        pool,
        "import builtins\nimport math\n"
        "assert not hasattr(builtins, 'left')\n"
        "assert not hasattr(math, 'left')\n",
    )


def test_system_calls_by_number_fail(pool: MatchPool) -> None:
    """By hand, as a program could do without Python: clone, kill, ptrace, limits, bpf, io_uring."""
    if os.uname().machine != "x86_64":
        pytest.skip("numbers of x86-64")
    of_x32 = 0x40000000 + 2  # open by its number in the x32 interface
    numbers = (of_x32, 56, 57, 62, 101, 157, 160, 302, 321, 425, 435)
    assert_plays(
        pool,
        "import ctypes\nlibrary = ctypes.CDLL(None, use_errno=True)\n"
        f"for number in {numbers}:\n"
        "    assert library.syscall(number, 0, 0, 0, 0, 0) == -1, number\n"
        "    assert ctypes.get_errno() == 1, (number, ctypes.get_errno())\n",
    )


def test_the_memory_of_a_program_holds_no_world(pool: MatchPool) -> None:
    assert_plays(
        pool,
        "import gc\nimport sys\n"
        "seen = [*gc.get_objects(), *sys.modules]\n"
        "for kind in [type(each) for each in seen] + object.__subclasses__():\n"
        "    place = getattr(kind, '__module__', '')\n"
        "    assert not str(place).startswith(('matrixworld.world', 'matrixworld._core')), kind\n"
        "ours = sorted(name for name in sys.modules if name.startswith(('class_', 'matrix')))\n"
        "assert ours == ['class_tournament', 'class_tournament.policy_server',\n"
        "                'class_tournament.sandbox'], ours\n",
    )


@pytest.mark.parametrize("name", ["matrixworld", "os", "ctypes"])
def test_what_is_not_on_the_list_cannot_be_imported(pool: MatchPool, name: str) -> None:
    text = (
        f"try:\n    import {name} as it\nexcept ImportError as error:\n    raise ValueError(error)"
    )
    submission = Submission("a", "a.py", "program", text.encode(), Path("a.py"))
    _, [refusal] = admit([submission], pool, lambda progress: None)
    assert refusal.reason == f"line 4: ValueError: {name} cannot be imported"


def test_late_imports_of_numpy_work(pool: MatchPool) -> None:
    """In calls, in C code that imports as its caller, in texts of errors, and in copies."""
    calls = (
        "a.mean(), a.std(axis=0), np.median(a), repr(a), str(np.array(['x'])), np.linalg.svd(a)",
        "np.dtype([('a', 'f4')]).newbyteorder(), np.datetime64('2020-01-01').astype(object)",
        "np.einsum('ij,kj->ik', a, a, optimize=True), np.char.add('a', 'b'), np.fft.fft(a)",
        "copy.deepcopy(np.random.default_rng(0)).choice(5), np.polynomial.Polynomial([1, 2])(3)",
        "np.pad(a, 1), np.unique(a), a.ctypes, a.__array_interface__, np.histogram(a)",
        "np.rec.array([(1,)]), np.cov(a), np.array(1) / np.array(0), np.ma.array(a).mean()",
    )
    wrong = ("np.add('a', 1)", "np.zeros(1 << 50)", "np.ones(2) @ np.ones(3)")
    tries = "try: {}\nexcept (TypeError, MemoryError, ValueError) as e: str(e)\nelse: 1 / 0\n"
    assert_plays(
        pool,
        "import copy\nimport numpy as np\na = np.arange(6.0).reshape(2, 3)\n"
        + "".join(f"{call}\n" for call in calls)
        + "".join(map(tries.format, wrong)),
    )


def test_random_numbers_tell_nothing_of_the_tournament(tmp_path: Path) -> None:
    """A program reads its seed, and a hostile one all that is in its process."""
    tells = (
        "def pursue(view, rng):\n"
        "    seen = [rng.bit_generator.seed_seq.entropy]\n"
        "    frame = FRAME\n"
        "    while frame:\n"
        "        for each in list(frame.f_locals.values()):\n"
        "            seen += each.values() if isinstance(each, dict) else [each]\n"
        "        frame = frame.f_back\n"
        "    raise ValueError(sorted({each for each in seen if type(each) is int and each > 99}))\n"
    )
    write_programs(tmp_path, {"a": "import sys\n" + tells.replace("FRAME", "sys._getframe()")})
    write_genomes(tmp_path, 2)
    seeds = set()
    for _ in range(2):
        result = small(tmp_path, seed=None)
        [refusal] = result.refusals
        [told] = map(int, re.findall(r"\d{9,}", refusal.reason))
        assert told not in (result.seed, result.match_seed)
        # Nor is a start that of the seed that it has, or of what NumPy makes of it.
        worlds = [World(CONFIG) for _ in range(3)]
        for world, seed in zip(worlds, (result.match_seed, told, match_seed(told)), strict=True):
            world.reset(seed)
        starts = [world.read("positions")["positions"].tobytes() for world in worlds]
        assert starts[0] not in starts[1:]
        seeds |= {result.seed, result.match_seed, told}
    assert len(seeds) == 6


# ---- README.md: its examples work, and its numbers are those of the code -------------------------

PAGE = (FOLDER / "README.md").read_text(encoding="utf-8")
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


def test_programs_as_on_the_page_play_and_can_be_handed_in(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The page's own, and one that imports all that the page lists."""
    imports = "".join(f"import {name}\n" for name in sorted(LISTED))
    write_programs(tmp_path, {"anna": PROGRAM, "bo": imports + ACTS + "return 0"})
    result = small(tmp_path)
    students = [entry.name for entry in result.entries["pursuer"] if entry.file]
    assert (students, result.refusals) == (["anna", "bo"], ())
    monkeypatch.chdir(tmp_path)
    with contextlib.redirect_stdout(io.StringIO()) as printed:
        exec(TRIAL, {})
    assert 0.1 < float(printed.getvalue()) < 0.9


def test_limits_and_modules_are_those_of_the_page() -> None:
    rows = dict(re.findall(r"^\| `--([\w-]+)` \| (\d+) \|", PAGE, re.M))
    limits = {name.replace("-", "_"): float(value) for name, value in rows.items()}
    assert limits == asdict(Limits())
    hidden = {name for name in MODULES if name.startswith(("__", "numpy.", "encodings."))}
    assert {name.removesuffix(".abc") for name in set(MODULES) - hidden} | {"numpy"} == LISTED


@pytest.mark.parametrize("column", [0, 1])
def test_numbers_of_system_calls_are_those_of_linux(column: int) -> None:
    if not HEADERS[column].exists():
        pytest.skip("needs the headers of Linux")
    text = HEADERS[column].read_text(encoding="utf-8")
    numbers = dict(re.findall(r"#define __NR(?:3264)?_(\w+)\s+(\d+)", text))
    known = ALLOWED | ANSWERED_BY_0
    assert {name: int(numbers[name]) for name in known} == {
        name: row[column] for name, row in known.items()
    }


def test_names_that_look_alike_are_students_of_their_own(tmp_path: Path) -> None:
    names = ["Ann\x07", "Ann\x08", "Bo  Lee", "Bo Lee", "c\udcff", "d" * 70 + "1", "d" * 70 + "2"]
    for name in names:
        (tmp_path / name).mkdir()
        write_genomes(tmp_path / name, 1)
    result = small(tmp_path)
    assert result.refusals == ()
    shown = [each.name for each in result.entries["pursuer"] if each.file]
    begins = [r"Ann\x07 #", r"Ann\x08 #", "Bo Lee #", "Bo Lee", r"c\udcff #", "d" * 60 + " #"]
    assert all(map(str.startswith, shown, [*begins, begins[-1]]))
    assert len(set(shown)) == len(names)


@pytest.mark.parametrize("team", TEAMS)
def test_a_program_for_one_team_enters_that_team_only(pool: MatchPool, team: Team) -> None:
    [entry], refusals = admitted(pool, f"def {FUNCTIONS[team]}(view, rng):\n    return 0\n")
    assert (entry.team, refusals) == (team, [])
