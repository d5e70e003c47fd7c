"""The mutation score of the referee: how many small changes of its source the tests notice.

    python tests/support/mutants.py /tmp/mutants game/resolve.cpp 4

copies the sources to a new directory, builds them, and then changes one place of a file at a time:
a comparison, a constant, a condition, an operator, a line left out, two lines in another order;
here every fourth. It prints each change that no test notices. Run by hand: a change takes some
seconds, and minutes where the tests have to run that play more than the fingerprint.
"""

from __future__ import annotations

import hashlib
import os
import re
import shlex
import shutil
import subprocess
import sys
import warnings
from collections.abc import Iterator
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
TESTS = {
    "game/resolve.cpp": "tests/contract",
    "observe/right_of_way.cpp": "tests/world/test_masks.py",
    "play/lockstep.cpp": "tests/play tests/world/test_memory.py tests/world/test_network.py",
}
"""Files, and the tests that are run where the fingerprint is the same."""
SWAPS = [
    *((rf" {a} ", f" {b} ") for one in ("== !=", "< <=", "> >=", "&& \\|\\|", "\\+ -", "\\+= -=")
      for a, b in (one.split(), one.split()[::-1])),
    ("true", "false"), ("false", "true"), (r"\bcontinue;", "break;"), (r"!(?=\w)", ""),
    (r"(?<![\w.])(\d+)(?![\w.])", "<next>"),
    (r"if \((?!constexpr)(.*)\)( |$)", r"if (true)\2"), (r"if \((.*)\)( |$)", r"if (false)\2"),
    (r"return (?!false|true)([^;]*);", r"return !(\1);"),
    (r"^( +)(?!return|const|auto|break|continue|using)([\w.\->\[\](){}!&* ,]+[^{]);$", r"\1;"),
]  # fmt: skip


def mutants(text: str) -> Iterator[tuple[int, str, str]]:
    """Yield the number of a changed line, what it became, and the whole text with it."""
    lines = text.split("\n")

    def with_line(number: int, *new: str) -> str:
        return "\n".join([*lines[:number], *new, *lines[number + len(new) :]])

    for number, line in enumerate(lines):
        code = line.partition("//")[0]
        if not code.strip() or code.startswith(("#", "namespace", "}")):
            continue
        for pattern, new in SWAPS:
            for found in re.finditer(pattern, code):
                to = (
                    str(int(found[0]) + 1)
                    if new == "<next>"
                    else found.expand(new.replace("\\|", "|"))
                )
                changed = code[: found.start()] + to + code[found.end() :]
                yield number + 1, changed.strip(), with_line(number, changed)
        below = lines[number + 1] if number + 1 < len(lines) else ""
        pair = [each.strip() for each in (line, below)]
        same = len(line) - len(pair[0]) == len(below) - len(pair[1])
        if same and all(each.endswith(";") and "return" not in each for each in pair):
            yield number + 1, f"after the next: {pair[0]}", with_line(number, below, line)


class Compared:
    """Takes the bytes of a fingerprint; ends the process at the first other ones."""

    def __init__(self, expected: list[str]) -> None:
        self.expected, self.found = expected, list[str]()

    def update(self, content: bytes) -> None:
        self.found.append(hashlib.sha256(content).hexdigest()[:8])
        if self.expected and self.expected[len(self.found) - 1] != self.found[-1]:
            os._exit(3)


def fast(file: Path) -> None:
    """Write the parts of the fingerprint, and of play by careful teams, or compare them."""
    sys.path[:0] = [str(ROOT / "tests" / "contract")]
    import numpy as np
    import test_fingerprint

    import matrixworld as mw
    import right_of_way

    parts: Any = Compared(file.read_text().split() if file.exists() else [])
    test_fingerprint.batches(parts)
    test_fingerprint.rollouts(parts)
    for config in test_fingerprint.configs():
        if config.fov >= 5:
            teams = "careful-random", "careful-chaser"
            for pair in (teams, teams[::-1]):
                found = mw.rollout(config, *pair, mw.Matches.of(0, 0, [1, 2]), threads=1)
                parts.update(found.faults.tobytes() + found.pursuer_return.tobytes())
    for number, row in enumerate(right_of_way.ROWS):
        rng = np.random.default_rng(number)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # rows in which nobody can be captured
            world = mw.World(
                row, rows=4, cols=4, n_pursuers=4, n_evaders=3, obstacles=0.2, fov=5,
                max_steps=8, diagonal=bool(number % 2),
            )  # fmt: skip
        while not (world.terminated or world.truncated):
            world.step(rng.integers(world.config.n_actions, size=7), explain=True)
            arrays = world.read("positions", "fault", "captured", "rewards", "views")
            parts.update(b"".join(each.tobytes() for each in arrays.values()))
            parts.update(np.sort(world.conflict_table(), axis=0).tobytes())
    if not parts.expected:
        file.write_text("\n".join(parts.found))


def main() -> None:
    place, name = Path(sys.argv[1]), sys.argv[2]
    tree, build = place / "tree", place / "build"
    if not tree.exists():
        kept = shutil.ignore_patterns("*.so", "build", "node_modules", ".git", "__pycache__")
        shutil.copytree(ROOT, tree, ignore=kept)
    cmake = tree / "CMakeLists.txt"
    # One object for each file, and no optimization of the link: to build one again is quick.
    slow = (ROOT / "CMakeLists.txt").read_text().replace("UNITY_BUILD ON", "UNITY_BUILD OFF")
    cmake.write_text(slow.replace("if(NOT has_ipo)", "set(has_ipo OFF)\nif(NOT has_ipo)"))
    options = ["-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG", f"-DPython_EXECUTABLE={sys.executable}"]
    pybind11 = subprocess.check_output([sys.executable, "-m", "pybind11", "--cmakedir"], text=True)
    packages = next(path for path in sys.path if path.endswith("site-packages"))  # Eigen's
    options += [f"-Dpybind11_DIR={pybind11.strip()}", f"-DCMAKE_PREFIX_PATH={packages}"]
    subprocess.run(
        ["cmake", "-S", tree, "-B", build, *options], check=True, stdout=subprocess.DEVNULL
    )
    environment = {**os.environ, "PYTHONPATH": f"{tree}/python:{tree}/tests/support"}
    expected, source = place / "expected.txt", tree / "cpp" / name

    def does(*words: object, limit: int = 900) -> int:
        try:
            return subprocess.run(
                [*map(str, words)], env=environment, cwd=tree, capture_output=True, timeout=limit,
                check=False,
            ).returncode  # fmt: skip
        except subprocess.TimeoutExpired:
            return -1

    def built() -> bool:
        if does("make", "-j1", "-C", build, limit=7200):
            return False
        [library] = build.glob("_core*.so")
        shutil.copy(library, tree / "python" / "matrixworld" / library.name)
        return True

    original = source.read_text()
    assert built()
    check = (sys.executable, tree / "tests/support/mutants.py", "--fast", expected)
    assert does(*check) == 0
    counts = {"no program": 0, "noticed": 0, "noticed by tests": 0, "survived": 0}
    try:
        for number, changed, text in [*mutants(original)][:: int(sys.argv[3])]:
            source.write_text(text)
            pytest = (
                sys.executable,
                "-m",
                "pytest",
                "-x",
                "-q",
                "-n",
                "0",
                *shlex.split(TESTS[name]),
            )
            if not built():
                end = "no program"
            elif does(*check, limit=120):
                end = "noticed"
            elif does(*pytest):
                end = "noticed by tests"
            else:
                end = "survived"
            counts[end] += 1
            if end == "survived":
                sys.stdout.write(f"{name}:{number}: {changed}\n")
                sys.stdout.flush()
    finally:
        source.write_text(original)
        sys.stdout.write(f"{name}: {counts}\n")


if __name__ == "__main__":
    if sys.argv[1] == "--fast":
        fast(Path(sys.argv[2]))
    else:
        main()
