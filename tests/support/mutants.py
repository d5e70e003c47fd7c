"""The mutation score of the referee: how many small changes of its source the tests notice.

    python tests/support/mutants.py ../mutants game/resolve.cpp

copies the sources to a new directory and builds them with all changes of the file at once, of which
a number chooses one: a comparison, a constant, a condition, an operator, a line left out, two lines
in another order. Each then plays the episodes of the fingerprint, dense worlds of all 972 rows, and
teams with right of way, in a process of its own; the changes that are the same in all of these are
printed. A person reads them: are they equal, or is a test missing? Run by hand.
"""

import ctypes
import hashlib
import itertools
import os
import re
import shutil
import signal
import subprocess
import sys
import warnings
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SECONDS = 120
"""A change that takes longer does not end."""
CHOSEN = "matrixworld_mutant"
HEAD = f'extern "C" {{ __attribute__((visibility("default"))) volatile int {CHOSEN} = -1; }}\n'
SWAPS = [
    *((rf" {re.escape(a)} ", f" {b} ") for pair in ("== !=", "< <=", "> >=", "&& ||", "+ -")
      for a, b in (pair.split(), pair.split()[::-1])),
    ("true", "false"), ("false", "true"), (r"!(?=[\w(])", ""), (r"(?<![\w.])\d+(?![\w.])", "+1"),
]  # fmt: skip
PARTS = [
    re.compile(r"(?P<head>^ +(?:if|while) \()(?P<it>.*)(?P<tail>\)(?: \{| \w+( \w+)?;|)$)"),
    re.compile(r"(?P<head>^ +if \()(?P<it>[^()]*(?:\([^()]*\)[^()]*)*)(?P<tail>\) .*;$)"),
    re.compile(r"(?P<head>^ +for \([^;]*; )(?P<it>[^;]*)(?P<tail>;.*\{?$)"),
    re.compile(r"(?P<head>^ +return )(?P<it>[^;{]*)(?P<tail>;$)"),
    re.compile(
        r"(?P<head>^ +(?!constexpr|static|using)[^=;{]* [|&+-]?= )(?P<it>[^;{]*)(?P<tail>;$)"
    ),
]
"""Lines with an expression."""
DOES = re.compile(r" +(?!return|const|auto|break|continue|using)[\w.\->\[\]]+(\(.*\)| \S?= .*);$")
"""Lines that do something, and may be left out."""


def part_of(line):
    """Return the expression of a line, with what stands around it."""
    found = next(filter(None, (each.match(line) for each in PARTS)), None)
    whole = found and found["it"].count("(") == found["it"].count(")") and " = " not in found["it"]
    return found if whole else None


def changed(part):
    """Yield the expression with one change each."""
    it = part["it"]
    for pattern, new in SWAPS:
        for found in re.finditer(pattern, it):
            to = str(int(found[0]) + 1) if new == "+1" else new
            yield it[: found.start()] + to + it[found.end() :]
    if part["head"].strip() == "if (":
        yield from (f"!({it})", "true", "false")


def with_mutants(text, left_out):
    """Return a source with all changes, but those of some lines; and what they are, by number."""
    lines, what, out, before = text.split("\n"), {}, [], ""
    for number, line in enumerate(lines):
        code, new = line.partition("//")[0].rstrip(), line
        if number not in left_out and code.startswith("    "):
            if part := part_of(code):
                kind = "bool" if part["head"].strip().startswith(("if", "while", "for")) else ""
                choices = ""
                for it in dict.fromkeys(changed(part)):
                    choices += f"{CHOSEN} == {len(what)} ? {kind}({it}) : "
                    what[len(what)] = f"{number + 1}: {part['it']}  ->  {it}"
                if choices:
                    new = f"{part['head']}({choices}{kind}({part['it']})){part['tail']}"
            if DOES.match(code) and before.endswith((";", "{", "}")):
                new = f"if ({CHOSEN} != {len(what)}) {{ {new.partition('//')[0].strip()} }}"
                what[len(what)] = f"{number + 1}: {code.strip()}  left out"
        out.append(new)
        before = code or before
    return HEAD + "\n".join(out), what


class Compared:
    """Takes what is played; ends the process at the first bytes that are others."""

    def __init__(self):
        self.found, self.expected = [], []

    def update(self, content):
        self.found.append(hashlib.sha256(content).digest()[:8])
        if self.expected and self.expected[len(self.found) - 1] != self.found[-1]:
            os._exit(3)


def play(parts):
    """Play what a change may show in."""
    import numpy as np
    import test_fingerprint

    import matrixworld as mw
    import right_of_way
    from matrixworld.world.masks import right_of_way_cells

    warnings.simplefilter("ignore")  # rows in which nobody can be captured
    for row, team, diagonal in itertools.product(
        right_of_way.ROWS, ("pursuer", "evader"), (False, True)
    ):
        # Of networks; those of scripts show in what they play.
        config = mw.WorldConfig(row, rows=9, cols=9, fov=5, diagonal=diagonal)
        parts.update(repr(right_of_way_cells(config, team)).encode())
    for number, row in enumerate(right_of_way.ROWS):
        rng = np.random.default_rng(number)
        config = mw.WorldConfig(
            row, rows=4, cols=4, n_pursuers=4, n_evaders=3, obstacles=0.2, fov=5, max_steps=8,
            diagonal=bool(number % 2),
        )  # fmt: skip
        world = mw.World(config)
        while not (world.terminated or world.truncated):
            world.step(rng.integers(config.n_actions, size=7), explain=True)
            arrays = world.read("positions", "fault", "involved", "captured", "captors", "rewards")
            table = world.conflict_table()
            parts.update(
                b"".join(each.tobytes() for each in (*arrays.values(), np.unique(table, axis=0)))
            )
        teams = [("careful-random", "careful-chaser"), ("chaser", "random")][number % 2]
        found = mw.rollout(config, *teams, mw.Matches.of(0, 0, [number]), episodes=3, threads=1)
        parts.update(b"".join(each.tobytes() for each in vars(found).values()))
    for number, row in enumerate(right_of_way.ROWS[::9]):  # two networks: in lockstep
        config = mw.WorldConfig(
            row, rows=5, cols=6, n_pursuers=4, n_evaders=3, obstacles=number % 2 / 10, fov=5,
            max_steps=9, diagonal=number % 4 > 1,
        )  # fmt: skip
        network = mw.Network.for_config(config, (9, 7), memory=("none", "gru")[number % 3 // 2])
        genomes = [test_fingerprint.random_genome(network, n) for n in range(3)]
        team = mw.Population(np.stack(genomes), network)
        matches = mw.Matches.of([0, 1, 2], [2, 2, 0], [number, 7, 8])
        found = mw.rollout(config, team, team, matches, episodes=35, threads=1)
        parts.update(b"".join(each.tobytes() for each in vars(found).values()))
    test_fingerprint.batches(parts)
    test_fingerprint.rollouts(parts)


def built(place, name):
    """Build the copy with all changes of a file; return what they are."""
    tree, build = place / "tree", place / "build"
    if not tree.exists():
        kept = shutil.ignore_patterns("*.so", "build", "node_modules", ".git", "__pycache__")
        shutil.copytree(ROOT, tree, ignore=kept)
    for path in (ROOT / "cpp").rglob("*.cpp"):
        copy = tree / path.relative_to(ROOT)
        if copy.read_bytes() != path.read_bytes():
            shutil.copy(path, copy)
    # One object for each file, and no optimization of the link: to build one again is quick.
    slow = (ROOT / "CMakeLists.txt").read_text().replace("UNITY_BUILD ON", "UNITY_BUILD OFF")
    slow = slow.replace("if(NOT has_ipo)", "set(has_ipo OFF)\nif(NOT has_ipo)")
    if (cmake := tree / "CMakeLists.txt").read_text() != slow:
        cmake.write_text(slow)
    pybind11 = subprocess.check_output([sys.executable, "-m", "pybind11", "--cmakedir"], text=True)
    packages = next(path for path in sys.path if path.endswith("site-packages"))  # Eigen's
    options = [f"-Dpybind11_DIR={pybind11.strip()}", f"-DCMAKE_PREFIX_PATH={packages}"]
    options += ["-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG", f"-DPython_EXECUTABLE={sys.executable}"]
    subprocess.run(
        ["cmake", "-S", tree, "-B", build, *options], check=True, stdout=subprocess.DEVNULL
    )
    source, left_out = tree / "cpp" / name, set()
    while True:
        text, what = with_mutants((ROOT / "cpp" / name).read_text(), left_out)
        source.write_text(text)
        done = subprocess.run(["make", "-C", build], capture_output=True, text=True, check=False)
        if done.returncode == 0:
            break
        # What is no program: its lines stay as they are.
        wrong = {int(n) - 2 for n in re.findall(rf"{source.name}:(\d+):\d+: error", done.stderr)}
        if not wrong - left_out:
            sys.exit(done.stderr[-3000:])
        left_out |= wrong
    [library] = build.glob("_core*.so")
    shutil.copy(library, tree / "python" / "matrixworld" / library.name)
    told = f"{name}: {len(what)} changes; no program with changes in lines "
    sys.stdout.write(f"{told}{sorted(n + 1 for n in left_out)}\n")
    return what


def main():
    place, name = Path(sys.argv[1]).absolute(), sys.argv[2]
    what = built(place, name)
    sys.path[:0] = [str(place / "tree" / part) for part in ("python", "tests/contract")]
    from matrixworld import _core

    assert str(place) in _core.__file__, _core.__file__
    chosen = ctypes.c_int.in_dll(ctypes.CDLL(_core.__file__), CHOSEN)
    parts = Compared()
    play(parts)
    survived = 0
    for number, words in what.items():
        child = os.fork()
        if child == 0:
            signal.alarm(SECONDS)
            os.dup2(os.open(os.devnull, os.O_WRONLY), 2)
            chosen.value, parts.expected, parts.found = number, parts.found, []
            play(parts)
            os._exit(0)
        if os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 0:
            survived += 1
            sys.stdout.write(f"{name}:{words}\n")
            sys.stdout.flush()
    sys.stdout.write(f"{name}: {len(what) - survived} of {len(what)} changes noticed\n")


if __name__ == "__main__":
    main()
