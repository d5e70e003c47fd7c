"""Compile the engine to WebAssembly, into python/matrixworld/explorer/built/engine.js.

    python web/build_engine.py            compile, and write the file that the package keeps
    python web/build_engine.py --check    compile, and compare with the file that the package keeps

Needs emscripten 3.1.6 (Debian 12: ``apt-get install emscripten node-acorn``) and Eigen's headers
(``pip install cmeel-eigen==3.4.1``). Equal sources give equal bytes, so the kept file can be
compared. Its first line holds a digest of the sources: a test finds a stale file where emscripten
is missing.
"""

from __future__ import annotations

import argparse
import base64
import hashlib
import os
import re
import subprocess
import sys
import sysconfig
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
BUILT = ROOT / "python/matrixworld/explorer/built/engine.js"
OBJECTS = ROOT / "build/web_engine"
VERSION = "3.1.6"  # another one makes other bytes
UNUSED = {"bindings", "tests"}  # rooms of cpp/

# As CMakeLists.txt: products are fused with sums where the code says so and nowhere else.
COMPILE = [
    *("-std=c++17", "-O2", "-DNDEBUG", "-fexceptions", "-msimd128", "-ffp-contract=off"),
    *("-Wall", "-Wextra", f"-ffile-prefix-map={ROOT}=."),
    *("-DMATRIXWORLD_LEVEL=kernels_base", "-Icpp"),
]
LINK = [
    *("-O2", "-fexceptions", "-msimd128"),
    *("-sMODULARIZE=1", "-sEXPORT_NAME=matrixworldEngine", "-sENVIRONMENT=web,worker"),
    # The page passes the binary: nothing is fetched, and no text is evaluated as code.
    *("-sINCOMING_MODULE_JS_API=[wasmBinary]", "-sFILESYSTEM=0", "-sDYNAMIC_EXECUTION=0"),
    # Large boards need more memory; where there is none, `new` throws std::bad_alloc.
    *("-sALLOW_MEMORY_GROWTH=1", "-sABORTING_MALLOC=0", "-sMALLOC=emmalloc"),
    *("-sEXPORTED_FUNCTIONS=_malloc,_free", "-sSTRICT=1"),
]


def sources() -> list[Path]:
    """Return all files that the built engine is made of, sorted by path."""
    engine = [path for path in (ROOT / "cpp").rglob("*.?pp") if path.parent.name not in UNUSED]
    return sorted([*engine, *(ROOT / "web/engine").glob("*.?pp"), Path(__file__).resolve()])


def digest() -> str:
    """Return a digest of paths and contents of the sources."""
    total = hashlib.sha256()
    for path in sources():
        # Line ends may differ between checkouts.
        content = hashlib.sha256(path.read_bytes().replace(b"\r\n", b"\n")).hexdigest()
        total.update(f"{path.relative_to(ROOT).as_posix()} {content}\n".encode())
    return total.hexdigest()


def digest_of(built: Path) -> str:
    """Return the digest in the first line of a built engine."""
    first = built.read_text(encoding="utf-8").split("\n", 1)[0]
    found = re.search(r"sources ([0-9a-f]{64})", first)
    return found.group(1) if found else ""


def eigen() -> Path:
    """Return the folder of Eigen's headers."""
    roots = [Path(sysconfig.get_path(name)) for name in ("purelib", "platlib")]
    places = [
        *(root / "cmeel.prefix/include/eigen3" for root in roots),
        Path("/usr/include/eigen3"),
    ]
    for place in places:
        if (place / "Eigen/Core").exists():
            return place
    sys.exit("Eigen: expected its headers (pip install cmeel-eigen==3.4.1), got none")


def run(*command: str | Path) -> None:
    """Run a compiler; its messages go to the terminal."""
    # Debian's emscripten finds its JavaScript libraries here.
    environment = {"NODE_PATH": "/usr/share/nodejs", **os.environ}
    subprocess.run(list(map(str, command)), cwd=ROOT, env=environment, check=True)


def check_version() -> None:
    """Exit unless the installed emscripten is the one that the kept file was made with."""
    try:
        told = subprocess.run(["em++", "--version"], capture_output=True, text=True, check=True)
    except FileNotFoundError:
        sys.exit("em++: expected emscripten (apt-get install emscripten node-acorn), got none")
    if VERSION not in told.stdout.split("\n")[0].split():
        sys.exit(f"em++: expected version {VERSION}, got {told.stdout.splitlines()[0]}")


def compile_engine() -> str:
    """Return the text of the built engine."""
    check_version()
    OBJECTS.mkdir(parents=True, exist_ok=True)
    headers = eigen()

    def to_object(path: Path) -> Path:
        out = OBJECTS / f"{path.parent.name}_{path.stem}.o"
        run("em++", *COMPILE, "-isystem", headers, "-c", path.relative_to(ROOT), "-o", out)
        return out

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        objects = list(pool.map(to_object, [path for path in sources() if path.suffix == ".cpp"]))
    linked = OBJECTS / "engine.js"
    run("em++", *LINK, *objects, "-o", linked)
    loader = linked.read_text(encoding="utf-8").strip()
    binary = base64.b64encode(linked.with_suffix(".wasm").read_bytes()).decode("ascii")
    first = f"/* built from cpp/ and web/engine/ by web/build_engine.py; sources {digest()} */"
    return f'{first}\n{loader}\nmatrixworldEngine.binary = "{binary}";\n'


def main() -> None:
    """Compile, then write or compare."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--check", action="store_true", help="compare, and write nothing")
    check = parser.parse_args().check
    text = compile_engine()
    if not check:
        BUILT.write_text(text, encoding="utf-8")
    elif text != BUILT.read_text(encoding="utf-8"):
        sys.exit(f"{BUILT.relative_to(ROOT)}: expected what the sources give, got another file")
    print(f"{BUILT.relative_to(ROOT)}: {len(text.encode()) / 1000:.0f} kB")


if __name__ == "__main__":
    main()
