"""The extension, compiled for WebAssembly, works in the Python of a page (Pyodide).

The compiler is not Pyodide's own, so such a file is for this test only. NumPy for Pyodide is in no
package registry, so nothing that takes or gives arrays is called; wheels for browsers play the
fingerprint where they are built (``.github/workflows/wheels.yml``).
"""

from __future__ import annotations

import re
import runpy
import shutil
import sys
import sysconfig
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from types import SimpleNamespace
from typing import Any
from zipfile import ZipFile

import pybind11
import pytest

from matrixworld import _core
from node import run_node

HERE = Path(__file__).parent
ROOT = HERE.parents[1]
PYODIDE = ROOT / "web/node_modules/pyodide"
NAME = "_core.cpython-311-wasm32-emscripten.so"
COMPILE = ("-fPIC", "-O1", "-fvisibility=hidden")
LINK = ("-O1", "-fexceptions", "-msimd128", "-sSIDE_MODULE=2", "-sWASM_BIGINT")

PROGRAM = """
import json

outcome = core.Outcome
rules = core.Rules(
    interaction=core.Interaction.SWARM_TURNS, obstacle=outcome.BOUNCE, teammate=outcome.BOUNCE,
    evader=outcome.DISAPPEAR, pursuer=outcome.REACH, capture=core.Capture.SURROUND,
    captured_disappear=True,
)
rewards = core.Rewards(
    capture=(1, -1), neighbor=(0, 0), collide=((0, 0, 0), (0, 0, 0)), step=(0, 0),
    blame=core.Blame.FAULT, capture_repeats=False,
)


def setup(rows):
    return core.Setup(
        rules=rules, rewards=rewards, rows=rows, cols=7, n_pursuers=3, n_evaders=2, fov=3,
        diagonal=False, max_steps=9, density=0.1, map=None,
    )


world = core.World(setup(5))
world.reset(2**40 + 1, 3, None, None, None)
try:
    setup(0)
except ValueError as error:
    refused = str(error)
told = json.dumps([
    [name for name in dir(core) if not name.startswith("__")],
    core.philox([2**63, 1, 2, 3], [4, 5]),
    setup(5).axis_sizes(),
    [world.n_turns(), world.turn(), world.actors(), world.conflicts()],
    refused,
])
told
"""


def write_headers(folder: Path) -> None:
    """Write Python's headers with the ``pyconfig.h`` of Pyodide's Python."""
    shutil.copytree(sysconfig.get_path("include"), folder)
    own = Path(sysconfig.get_config_h_filename()).read_text(encoding="utf-8")
    names = set(re.findall(r"# *(?:define|undef) (\w+)", own))
    known: dict[str, Any] = {}
    with ZipFile(PYODIDE / "python_stdlib.zip") as library:
        exec(library.read("_sysconfigdata__emscripten_wasm32-emscripten.py"), known)
    values = {k: v for k, v in known["build_time_vars"].items() if k in names and v not in (0, "")}
    lines = "".join(f"#define {k} {v}\n" for k, v in values.items())
    (folder / "pyconfig.h").write_text(lines, encoding="utf-8")


def compiled(folder: Path) -> Path:
    """Return the extension as a WebAssembly module that another one loads."""
    build = SimpleNamespace(**runpy.run_path(str(ROOT / "web/build_engine.py")))
    write_headers(folder / "python")
    headers = ["-I", folder / "python", "-isystem", pybind11.get_include()]
    flags = [*build.COMPILE, *COMPILE, *headers, "-isystem", build.eigen()]

    def to_object(path: Path) -> Path:
        out = folder / f"{path.parent.name}_{path.stem}.o"
        build.run("em++", *flags, "-c", path, "-o", out)
        return out

    sources = [path for path in (ROOT / "cpp").rglob("*.cpp") if path.parent.name != "tests"]
    with ThreadPoolExecutor() as pool:
        objects = list(pool.map(to_object, [*sources, HERE / "pyodide_library.cpp"]))
    exported = "-sEXPORTED_FUNCTIONS=_PyInit__core"
    build.run("em++", *LINK, exported, *objects, "-o", folder / NAME)
    return folder / NAME


@pytest.mark.nightly
@pytest.mark.skipif(not shutil.which("em++"), reason="needs emscripten")
@pytest.mark.skipif(not PYODIDE.exists(), reason="needs `npm ci` in web/")
@pytest.mark.skipif(sys.version_info[:2] != (3, 11), reason="this Pyodide is Python 3.11")
def test_the_extension_works_in_a_browser(tmp_path: Path) -> None:
    here: dict[str, Any] = {"core": _core}
    exec(PROGRAM, here)
    given = {
        "module": str(compiled(tmp_path)),
        "name": NAME,
        "program": f"import sys\nsys.path.append('.')\nimport _core as core\n{PROGRAM}",
    }
    assert run_node("pyodide.mjs", given) == here["told"]
