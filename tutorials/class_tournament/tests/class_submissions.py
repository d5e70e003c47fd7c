"""Submissions of a class: honest programs, broken ones and attacks, and what is said of them."""

import os
import re
from contextlib import suppress
from pathlib import Path

import numpy as np

from class_tournament.policy_process import CAN_FORK, NO_FORK, Limits, PolicyServer
from matrixworld.play import NetworkPolicy, save_genome
from matrixworld.world.policy import Network

CHASER = """
import numpy as np

NORTH, EAST, SOUTH, WEST = 1, 2, 3, 4

def pursue(view, rng):
    evaders = np.argwhere(view[0])
    if len(evaders) == 0 or rng.random() < {noise}:
        return rng.integers(5)
    cells = evaders - view.shape[1] // 2
    down, right = cells[np.abs(cells).sum(axis=1).argmin()]
    if abs(down) > abs(right):
        return SOUTH if down > 0 else NORTH
    return EAST if right > 0 else WEST
"""

FLEER = """
MOVES = [(0, 0), (-1, 0), (0, 1), (1, 0), (0, -1)]

def evade(view, rng):
    middle = view.shape[1] // 2
    pursuers = [(r - middle, c - middle) for r, c in zip(*view[1].nonzero())]
    if not pursuers or rng.random() < {noise}:
        return int(rng.integers(5))
    def distance(action):
        down, right = MOVES[action]
        free = not view[2, middle + down, middle + right]
        return free, min(abs(r - down) + abs(c - right) for r, c in pursuers)
    return max(range(5), key=distance)
"""

WALKER = """
def walk(view, rng, memory):
    if memory.get("left", 0) == 0:
        memory["left"], memory["to"] = {steps}, int(rng.integers(1, 5))
    memory["left"] -= 1
    return memory["to"]

pursue = walk
evade = walk
"""


def honest_programs(count: int) -> dict[str, str]:
    """Programs of different strength that play by the rules, by the name of the student."""
    kinds = (
        lambda n: CHASER.format(noise=round(0.05 * n, 2)),
        lambda n: FLEER.format(noise=round(0.05 * n, 2)),
        lambda n: WALKER.format(steps=n + 1),
        lambda n: CHASER.format(noise=round(0.02 * n, 2)) + FLEER.format(noise=round(0.02 * n, 2)),
    )
    return {f"student {n:02}": kinds[n % 4](n // 4) for n in range(count)}


ACTS = "def pursue(view, rng):\n    "

REFUSED_PROGRAMS: dict[str, tuple[str, str]] = {
    # Never ends, or takes all there is.
    "endless": (ACTS + "while True: pass", r"pursue: (no answer within|more than \d+ seconds)"),
    "endless import": ("while True: pass", r"^(no answer within|more than \d+ seconds)"),
    "sleeper": (ACTS + "import time; time.sleep(1000)", "pursue: no answer within"),
    "deadlock": (
        "import _thread\nlock = _thread.allocate_lock()\nlock.acquire(); lock.acquire()",
        "no answer within",
    ),
    "ignores signals": (
        "import signal\nfor n in (2, 15, 24): signal.signal(n, signal.SIG_IGN)\nwhile True: pass",
        r"no answer within|more than \d+ seconds",
    ),
    "memory": (ACTS + "return len(bytearray(1 << 40))", "line 2: MemoryError: more memory than"),
    "slow memory": (ACTS + "x = [0]\n    while True: x = x + x", "line 3: MemoryError"),
    "recursion": (ACTS + "return pursue(view, rng)", "RecursionError"),
    "deep source": ("x = " + "(" * 100_000, "line 1: SyntaxError|MemoryError|crashed"),
    # Other processes and threads.
    "fork bomb": (ACTS + "import os\n    while True: os.fork()", "line 3: PermissionError"),
    "spawns": ("import os\nos.posix_spawn('/bin/sh', ['sh'], {})", "line 2: PermissionError"),
    "subprocess": (
        "import subprocess\nsubprocess.run(['touch', '{mark}'])",
        "line 1: .*No module named 'subprocess'",
    ),
    "shell": ("import os\nif os.system('touch {mark}'): raise OSError", "line 2: OSError"),
    "executes": ("import os\nos.execv('/bin/sh', ['sh', '-c', 'touch {mark}'])", "PermissionError"),
    "thread": (
        "import threading\nthreading.Thread(target=print).start()",
        "can't start new thread",
    ),
    "kills parent": ("import os\nos.kill(os.getppid(), 9)", "line 2: PermissionError"),
    "kills all": ("import os\nos.kill(-1, 9)", "line 2: PermissionError"),
    # Files and network.
    "writes": ("open('{mark}', 'w').write('x')", "line 1: PermissionError.*not allowed"),
    "reads": ("open('/etc/passwd').read()", "line 1: PermissionError"),
    "lists": ("import os\nos.listdir('/')", "line 2: PermissionError"),
    "removes": ("import os\nos.remove('{directory}/student 00.py')", "line 2: PermissionError"),
    "links": ("import os\nos.symlink('/', '{mark}')", "line 2: PermissionError"),
    "socket": ("import socket\nsocket.socket()", "line 2: PermissionError"),
    "by ctypes": (
        "import ctypes\nlibrary = ctypes.CDLL(None, use_errno=True)\n"
        "assert library.open(b'{mark}', 0o101, 0o644) >= 0, 'no file'",
        "line 3: AssertionError: no file",
    ),
    # Ends itself, or breaks the process.
    "exits": ("import os\nos._exit(0)", r"ended its own process \(exit code 0\)"),
    "exits late": (
        ACTS + "import os; os._exit(7)",
        r"pursue: ended its own process \(exit code 7\)",
    ),
    "sys exit": (ACTS + "raise SystemExit", r"line 2: the program ends itself"),
    "segfault": (ACTS + "import ctypes; ctypes.string_at(1)", r"its process crashed \(SIGSEGV\)"),
    "hostile error": (
        "class E(Exception):\n    def __str__(self): raise SystemExit\nraise E",
        "^E$",
    ),
    "error without a text": (ACTS + "assert rng is None", "^pursue: line 2: AssertionError$"),
    "long error": ("raise ValueError('<b>' + 'x' * 10**6)", r"line 1: ValueError: <b>x+ \.\.\.$"),
    # Answers that are none.
    "shape": (ACTS + "return view", r"pursue returned an array of shape \(3, \d+, \d+\) and dtype"),
    "dtype": (ACTS + "return 1.0", r"pursue returned the float 1\.0, expected an action 0 to 4"),
    "none": (ACTS + "pass", r"pursue returned None \(a return is missing\)"),
    "range": (ACTS + "return 5", "pursue returned 5, expected an action 0 to 4"),
    "negative": (ACTS + "return -1", "pursue returned -1, expected an action 0 to 4"),
    "boolean": (ACTS + "return True", "pursue returned a bool"),
    "raises": (ACTS + "return [][3]", "line 2: IndexError: list index out of range"),
    "writes protocol": ("import os\nos.write(3, b'A' + bytes(100))", "wrote into the connection"),
    "empty error": ("import os\nos.write(3, b'E' + bytes(4))", "^failed without a message$"),
    "floods protocol": (
        ACTS + "import os\n    while True: os.write(3, bytes(1 << 20))",
        "connection",
    ),
    "forges actions": (
        ACTS + "import os\n    os.write(3, b'A' + (1).to_bytes(4, 'little') + bytes([77]))",
        "wrote into the connection",
    ),
    # Not what was asked for.
    "no function": ("def chase(view, rng): return 0", "expected a function pursue"),
    "parameters": (
        "def pursue(view): return 0",
        r"or pursue\(view, rng, memory\), got pursue\(view\)",
    ),
    "null byte": ("x = 1\0", "^(SyntaxError|ValueError): source code"),
    "generator": (ACTS + "yield 1", "pursue returned a generator, expected an action"),
    "no python": ("def pursue(view, rng) return 0", "line 1: SyntaxError"),
    "imports torch": ("import torch", "cannot be imported .class_tournament/README.md lists"),
}
"""Programs that are refused: the text, and a pattern of the reason. {mark} is a file that must not
appear."""

HARMLESS_ATTACKS: dict[str, str] = {
    # They change their own process only, and then play.
    "prints": "for n in range(200): print('x' * 100_000)\n" + ACTS + "print(view); return 1",
    "patches": (
        "import numpy\nimport sys\n"
        "policy_server = sys.modules['class_tournament.policy_server']\n"
        "numpy.random.default_rng = lambda *a: None\n"
        "policy_server._action = lambda *a: 3\n"
        "sys.modules.clear()\n" + ACTS + "return 'a very good action'"
    ),
    "catches": ("try: open('{mark}', 'w')\nexcept OSError: pass\n" + ACTS + "return 2"),
    "<img src=x onerror=alert(1)>": ACTS + "return 0",
    "finds no environment and no other open file": (
        "import os\nassert not os.environ, os.environ\n"
        "for handle in range(4, 100):\n"
        "    try: os.read(handle, 1)\n"
        "    except OSError as error: assert error.errno == 9\n"
        "    else: raise AssertionError(handle)\n" + ACTS + "return 0"
    ),
}


def past_the_list(text: str) -> str:
    """Return a program that gets modules which are not on the list, as an attacker would."""
    real = "__import__('random')._os.sys.modules['builtins'].__import__"
    names = "builtins|ctypes|_ctypes|gc|os|signal|socket|subprocess|sys|threading|_thread"
    return re.sub(rf"import ({names})\b", lambda found: f"{found[1]} = {real}('{found[1]}')", text)


def write_hostile_files(directory: Path) -> dict[str, str]:
    """Write files that are no submissions; return a pattern of the reason for each."""
    network = Network(hidden=(4,), fov=11)
    genome = network.initial(np.random.default_rng(0))

    reasons: dict[str, str] = {}

    def save(name: str, reason: str, **changes: object) -> None:
        reasons[name] = reason
        arrays: dict[str, object] = {
            "kind": "cells", "genome": genome, "hidden": np.array([4]), "activation": "relu",
            "fov": 11, "n_actions": 5, "sampled": True, "memory": "none", "team": "pursuer",
        }  # fmt: skip
        np.savez_compressed(
            directory / name, **{k: v for k, v in {**arrays, **changes}.items() if v is not None}
        )

    def write(name: str, reason: str, content: bytes) -> None:
        reasons[name] = reason
        (directory / name).write_bytes(content)

    save("other size.npz", "genomes: expected shape", genome=genome[:-1])
    whole = genome.astype(np.int64)
    save("other dtype.npz", "expected an array 'genome' of floats", genome=whole)
    save("not finite.npz", "expected finite numbers", genome=genome * np.nan)
    narrow = Network((4,), fov=3).initial(np.random.default_rng(0))
    view = "expected a policy for fov 11 and 5 actions, got fov 3"
    save("other view.npz", view, genome=narrow, fov=3)
    team = "team: expected one of pursuer, evader, got 'referee'"
    save("other team.npz", team, team="referee")
    save("no team.npz", "expected an array 'team'", team=None)
    layers = "hidden: expected at most 16 values, got 1000"
    save("many layers.npz", layers, hidden=np.ones(1000, int))
    write("large.npz", "expected at most 8,388,608 bytes", bytes(9 << 20))
    write("long.py", "expected at most 262,144 bytes", b"#" * (300 << 10))
    write("notes.txt", r"expected a file that ends in \.py or \.npz", b"hello")
    for name in ("twice", "TWICE"):
        twice = f"expected one policy for the pursuers of {name}, got 2: TWICE.py, twice.py"
        write(f"{name}.py", twice, ACTS.encode() + b"return 0")
    for name, target in (("linked.py", "/etc/passwd"), ("linked directory", "/etc")):
        reasons[name] = "expected a file, got a symbolic link"
        (directory / name).symlink_to(target)
    os.mkfifo(directory / "pipe.py")
    return {**reasons, "pipe.py": "expected a file, got a FIFO"}


def write_programs(directory: Path, programs: dict[str, str]) -> None:
    """Write programs as files of their students."""
    for name, text in programs.items():
        text = (
            past_the_list(text)
            .replace("{mark}", str(directory / "mark"))
            .replace("{directory}", str(directory))
        )
        (directory / f"{name}.py").write_text(text)


def write_genomes(directory: Path, count: int) -> None:
    """Write untrained genomes, of both teams in turn."""
    network = Network(hidden=(8,), fov=11)
    for n in range(count):
        policy = NetworkPolicy(network, network.initial(np.random.default_rng(n)))
        save_genome(directory / f"genome {n:02}.npz", ("pursuer", "evader")[n % 2], policy)


def problem_here() -> str:
    """Return why programs cannot play on this system; empty if they can."""
    if not CAN_FORK:
        return NO_FORK
    server = PolicyServer(Limits())
    try:
        return server.ready()
    finally:
        server.close()


def processes_of_programs() -> list[int]:
    """Processes that this one has made for programs, and such processes without a parent."""
    parents: dict[int, int] = {}
    for entry in Path("/proc").glob("[0-9]*"):
        with suppress(OSError):  # it has just ended
            state, parent = (entry / "stat").read_text().rpartition(")")[2].split()[:2]
            if "class_tournament.policy_server" in (entry / "cmdline").read_text() and state != "Z":
                parents[int(entry.name)] = int(parent)
    ours = {number for number, parent in parents.items() if parent in (1, os.getpid())}
    return sorted(ours | {number for number, parent in parents.items() if parent in ours})
