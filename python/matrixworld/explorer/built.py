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
PAGES = ("explorer", "playground")
KINDS = ("js", "css")
ENGINE = "engine"
"""Name of the script that holds the engine as WebAssembly, which all pages share."""

_FIRST_LINE = re.compile(r"sources ([0-9a-f]{64}) \*/")
_INSTALLED = "node_modules"


def built_text(page: str, kind: str) -> str:
    """Return the script (``"js"``) or the style sheet (``"css"``) of a page."""
    return (BUILT / f"{page}.{kind}").read_text(encoding="utf-8")


def recorded_digest(page: str, kind: str) -> str:
    """Return the digest of the sources from which a file was built; empty without one."""
    found = _FIRST_LINE.search(built_text(page, kind).partition("\n")[0])
    return found[1] if found else ""


def source_digest(web: Path) -> str:
    """Return the digest of the sources in a directory, as ``web/build.mjs`` computes it."""
    files = {file.relative_to(web).as_posix(): file for file in web.rglob("*") if file.is_file()}
    digest = hashlib.sha256()
    for name in sorted(files):
        if _INSTALLED not in name.split("/"):
            content = hashlib.sha256(files[name].read_bytes()).hexdigest()
            digest.update(f"{name} {content}\n".encode())
    return digest.hexdigest()
