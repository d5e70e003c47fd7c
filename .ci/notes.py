"""Print the release notes: the changelog's section of the version that the sources name.

    python .ci/notes.py           whenever they are wanted
    python .ci/notes.py v0.3.0    of a tag, which must be this version's; the section needs its date

Changelog, citation and recipe must name the same version.
"""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).parents[1]
# Each file that names the version, and how. The build reads the first.
VERSIONS = {
    "python/matrixworld/version.py": r'^__version__ = "(.+)"$',
    "CITATION.cff": r"^version: (.+)$",
    ".ci/recipe.yaml": r'^  version: "(.+)"$',
    "CHANGELOG.md": r"^## \[(\d.*?)\]",
}
SECTION = re.compile(
    r"^## \[(?P<version>\d.*?)\] - (?P<date>\S+)\n(?P<notes>.*?)(?=^## \[|\Z)", re.M | re.S
)


def read(name: str) -> str:
    return (ROOT / name).read_text(encoding="utf-8")


def version() -> str:
    """Return the version that all files name."""
    named = {name: re.search(how, read(name), re.M) for name, how in VERSIONS.items()}
    told = {name: found[1] if found else "none" for name, found in named.items()}
    if len(set(told.values())) > 1:
        sys.exit(f"expected one version, got {told}")
    return told["CITATION.cff"]


def check_tag(tag: str, date: str) -> None:
    """Exit unless the tag is the version's, and changelog and citation have the same date."""
    if tag != f"v{version()}":
        sys.exit(f"expected the tag v{version()}, got {tag!r}")
    if not re.fullmatch(r"\d{4}-\d\d-\d\d", date):
        sys.exit(f"CHANGELOG.md: expected a date beside [{version()}], got {date!r}")
    if f"\ndate-released: {date}\n" not in read("CITATION.cff"):
        sys.exit(f"CITATION.cff: expected 'date-released: {date}'")


def main(tag: str | None = None) -> None:
    expected = version()
    section = SECTION.search(read("CHANGELOG.md"))
    if section is None or section["version"] != expected:
        sys.exit(f"CHANGELOG.md: expected '## [{expected}] - DATE'")
    if tag:
        check_tag(tag, section["date"])
    print(section["notes"].strip())


if __name__ == "__main__":
    main(*sys.argv[1:])
