"""The built scripts and style sheets of the pages, which the package keeps.

Their source is the directory ``web/`` of the repository; ``npm ci && npm run build`` there writes
them anew. The first line of each names a digest of the sources.
"""

from __future__ import annotations

import hashlib
import re
from pathlib import Path

BUILT = Path(__file__).parent / "built"
"""Directory of the built files."""
PAGES = ("explorer", "playground", "class")
KINDS = ("js", "css")
ENGINE = "engine"
"""Name of the script that holds the engine as WebAssembly, which all pages share."""

_FIRST_LINE = re.compile(r"sources ([0-9a-f]{64}) \*/")
SOURCES = ("src", "build.mjs", "package.json", "package-lock.json", "tsconfig.json")
"""What the pages are built from, in ``web/``."""


def built_text(page: str, kind: str) -> str:
    """Return the script (``"js"``) or the style sheet (``"css"``) of a page."""
    return (BUILT / f"{page}.{kind}").read_text(encoding="utf-8")


def recorded_digest(page: str, kind: str) -> str:
    """Return the digest of the sources from which a file was built; empty without one."""
    found = _FIRST_LINE.search(built_text(page, kind).partition("\n")[0])
    return found[1] if found else ""


def source_digest(web: Path) -> str:
    """Return the digest of the sources in a directory, as ``web/build.mjs`` computes it."""
    paths = [file for source in SOURCES for file in _files(web / source)]
    names = {path.relative_to(web).as_posix(): path for path in paths}
    digest = hashlib.sha256()
    for name in sorted(names):
        content = hashlib.sha256(names[name].read_bytes()).hexdigest()
        digest.update(f"{name} {content}\n".encode())
    return digest.hexdigest()


def _files(path: Path) -> list[Path]:
    """Return all files below a path; the path itself if it is a file."""
    return [file for file in path.rglob("*") if file.is_file()] if path.is_dir() else [path]
