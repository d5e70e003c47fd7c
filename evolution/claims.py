"""Numbers in texts: each one that a run measured is a claim, and follows from a kept table.

    python evolution/claims.py              compares all texts with the tables
    python evolution/claims.py --write      writes the digits of the tables into the texts
    python evolution/claims.py README.md    tells the claims of a text: value, unit, setting

A text names the claim after its digits, in a comment that no reader of the page sees:

    In `SB` the team captures 0.58<!--one_team.crowd--> of the largest crowd.

The claim `crowd` stands in ``results/one_team/claims.toml``:

    unit = "share of evaders captured in the last step"

    [crowd]
    says = "{:.2f}"
    value = "cell('40 x 40, 1024 v 256', 'learned; SB', under='side by side')[0]"
    setting = "SB, 1024 v 256 on 40 x 40 cells, evaders at random, 20 episodes of five teams"

`says` is a format of `str.format`, and `value` a Python expression for its numbers. It knows
`numbers`, what ``numbers.npz`` or ``numbers.json`` beside it holds; `load(name)`, another file
there; `cell(row, column)`, the numbers of a cell of ``table.md`` (`Folder.cell`); `script`, the
module that made the folder; `interval(values)`, the mean over runs and the ends of its 95 %
interval; and `np`. `setting` and `unit` may stand once, above all claims.

Decimal fractions, percentages and "3 of 5" in a text need a claim. Those in code, in links and of
levels (95 %) need none. Others that no run measured say so after their sentence: `<!--set-->` if
somebody chose them, `<!--cited: SOURCE-->` if they are another's result.

A table in a text is a claim, too, whose value is the text of the table:

    <!--table: suite.worlds-->
    | ...
"""

from __future__ import annotations

import argparse
import csv
import json
import re
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache, cached_property
from importlib import import_module
from itertools import accumulate
from pathlib import Path
from string import Formatter
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from matrixworld._util.files import load_toml, replacing
from matrixworld.analysis import interval_over_runs

ROOT = Path(__file__).parents[1]
sys.path += [str(ROOT / name) for name in ("evolution", "evolution/validation", "tutorials/make")]
FOLDERS = {
    **{path.parent.name: path.parent for path in ROOT.glob("evolution/results/**/claims.toml")},
    "course": ROOT / "tutorials/course/data",
    "benchmarks": ROOT / "benchmarks",
}
"""By the name that claims begin with, the folder of their ``claims.toml``."""
SCRIPTS = {"data": "told"}
"""Scripts that have not the name of their folder."""
TEXTS = (
    "README.md", "docs/*.md", "docs/maintainers/*.md", "docs/lesson.toml", "evolution/**/README.md",
    "tutorials/README.md", "tutorials/class_tournament/README.md", "tutorials/*.ipynb",
    "tutorials/course/exercises.toml",
)  # fmt: skip
"""Texts whose measured numbers are claims."""

NUMBER = r"[-+]?(?:\d[\d,]*(?:\.\d+)?|\.\d+)"
MEASURED = re.compile(
    r"(?<![\w.,/-])[-+]?(?:\d[\d,]*)?\.\d+(?!\w|\.\d)"  # a decimal fraction
    r"|(?<![\w.])[-+]?[\d.]+ ?%"
    r"|(?<![\w.])\d+\s(?:of|in)\s(?:the\s|all\s)?\d+\b"
)
"""Numbers that look as if a run had measured them."""
FREE = re.compile(
    r"```.*?```|`[^`\n]*`|\]\([^)]*\)|<[!/a-z][^>]*>|https?://\S+"  # code, links, comments
    r"|\b(?:arXiv|doi)[: ]\S+|\b(?:Python|version|notebook|exercise|section) \d+\.\w+"
    r"|\b95 ?%(?! of)",
    re.DOTALL | re.IGNORECASE,
)
"""Passages that hold no measured numbers."""
MARK = re.compile(r"<!--(?:(?P<name>\w+\.\w+)|(?P<free>set|cited: [^>]+))-->")
TABLE = re.compile(
    r"^<!--table: (?P<name>\w+\.\w+)-->\n(?P<table>(?:\|.*(?:\n|\Z))*)", re.MULTILINE
)
SENTENCE = re.compile(r"[.:;]\s|\|\s|\n\s*\n|\n\s*[-*] ")
"""Ends of a sentence, a cell, a paragraph or an item."""


@dataclass(frozen=True)
class Folder:
    """The kept numbers of a result."""

    path: Path

    def load(self, name: str) -> Any:
        """Return what a file of the folder holds: arrays, plain values, or rows of a table."""
        path = self.path / name
        if path.suffix == ".npz":
            return dict(np.load(path))
        if path.suffix == ".csv":
            with path.open(newline="", encoding="utf-8") as file:
                return [*csv.DictReader(file)]
        text = path.read_text(encoding="utf-8")
        return json.loads(text) if path.suffix == ".json" else text

    @cached_property
    def numbers(self) -> Any:
        """What ``numbers.npz`` or ``numbers.json`` holds."""
        return self.load("numbers.npz" if (self.path / "numbers.npz").exists() else "numbers.json")

    @cached_property
    def script(self) -> Any:
        """The script of the same name, or that of `SCRIPTS`."""
        return import_module(SCRIPTS.get(self.path.name, self.path.name))

    def cell(self, row: str, column: str, under: str = "", file: str = "table.md") -> list[float]:
        """Return the numbers of the one cell with this head and these first cells of its row.

        First cells are joined by a semicolon, `'open; learned; still'`; of several lines in a
        cell the first one counts. `under` is part of what stands above the table, or of its heads,
        where several have such a cell.
        """
        found = [
            cells[head.index(column)]
            for above, head, rows in tables(self.load(file))
            if under in above and column in head
            for cells in rows
            if row in accumulate((cell.split("<br>")[0] for cell in cells), "{}; {}".format)
        ]
        if len(found) != 1:
            raise ValueError(
                f"expected one cell in row {row!r} and column {column!r} of {self.path.name}/{file}"
                f"{f' under {under!r}' if under else ''}, found {len(found)}"
            )
        return [float(each.replace(",", "")) for each in re.findall(NUMBER, found[0])]


def tables(text: str) -> Iterator[tuple[str, list[str], list[list[str]]]]:
    """Yield the tables of a text in Markdown: all that stands above the rows, heads, rows."""
    heading = paragraph = ""
    for block in re.split(r"\n\s*\n", text):
        lines = block.strip().split("\n")
        at = next((place for place, line in enumerate(lines) if line.startswith("|")), None)
        if at is None:
            heading = block if block.startswith("#") else heading
            paragraph = block
            continue
        above = "\n".join([heading, paragraph, *lines[: at + 1]])
        rows = [
            [cell.strip().replace("**", "") for cell in line.strip().strip("|").split("|")]
            for line in lines[at:]
        ]
        yield above, rows[0], rows[2:]


@dataclass(frozen=True)
class Claim:
    """Digits that follow from kept numbers."""

    folder: Folder
    value: str
    says: str = "{}"
    unit: str = ""
    setting: str = ""

    @cached_property
    def text(self) -> str:
        """The digits, as a text has to write them."""
        names = {"np": np, "load": self.folder.load, "cell": self.folder.cell, "interval": interval}
        for name in ("numbers", "script"):
            if re.search(rf"\b{name}\b", self.value):
                names[name] = getattr(self.folder, name)
        return self.says.format(*flat(eval(f"({self.value})", names)))

    @cached_property
    def pattern(self) -> re.Pattern[str]:
        """What stands before the name of this claim, with any digits."""
        parts = []
        for literal, field, *_ in Formatter().parse(self.says):
            parts.append(re.sub(r"(?:\\?\s)+", r"\\s+", re.escape(literal)))
            parts.append("" if field is None else NUMBER)
        return re.compile(rf"(?<![\w.,])(?:{''.join(parts)})\Z")


def interval(values: ArrayLike) -> list[float | None]:
    """Return the mean over runs and the ends of its 95 % interval (Student's t)."""
    found = interval_over_runs(values)
    return [found.value, found.low, found.high]


def flat(value: Any) -> list[Any]:
    """Return the plain values of an array, of a number, or of a sequence of such."""
    if isinstance(value, list | tuple):
        return [each for part in value for each in flat(part)]
    return np.ravel(value).tolist()


@cache
def claims() -> dict[str, Claim]:
    """Return all claims by ``folder.claim``.

    Raises
    ------
    ValueError
        if a claim has no unit or no setting.
    """
    found = {}
    for folder, path in FOLDERS.items():
        file = path / "claims.toml"
        if not file.exists():
            continue
        of_folder = Folder(path)
        read = load_toml(file)
        shared = {name: each for name, each in read.items() if isinstance(each, str)}
        for name, each in read.items():
            if isinstance(each, dict):
                claim = Claim(of_folder, **(shared | each))
                if not (claim.unit and claim.setting):
                    raise ValueError(f"expected unit and setting of {folder}.{name} in {file}")
                found[f"{folder}.{name}"] = claim
    return found


def claim_of(name: str) -> Claim:
    """Return the claim of a name; ValueError if there is none."""
    if name not in claims():
        raise ValueError(f"expected the name of a claim, got {name}")
    return claims()[name]


def texts() -> list[Path]:
    """Return the texts whose measured numbers are claims."""
    return sorted(path for pattern in TEXTS for path in ROOT.glob(pattern))


def said(text: str) -> Iterator[tuple[re.Match[str], Claim, re.Match[str]]]:
    """Yield each name of a claim in a text, the claim, and the digits before the name.

    Raises
    ------
    ValueError
        if there is no such claim, or other words than those of `says` stand before its name.
    """
    for mark in MARK.finditer(text):
        if mark["name"] is None:
            continue
        claim = claim_of(mark["name"])
        digits = claim.pattern.search(text, max(0, mark.start() - 200), mark.start())
        if digits is None:
            before = text[max(0, mark.start() - 40) : mark.start()]
            raise ValueError(f"expected {claim.says!r} before {mark['name']}, got {before!r}")
        yield mark, claim, digits


def written(text: str) -> str:
    """Return a text with the digits and tables of its claims."""
    parts = []
    end = 0
    for mark, claim, digits in said(text):
        same = re.sub(r"\s+", " ", digits[0]) == claim.text
        parts += [text[end : digits.start()], digits[0] if same else claim.text]
        end = mark.start()

    def with_table(found: re.Match[str]) -> str:
        head = found[0].removesuffix(found["table"])
        return f"{head}{claim_of(found['name']).text.strip()}\n"

    return TABLE.sub(with_table, "".join([*parts, text[end:]]))


def unclaimed(text: str) -> list[str]:
    """Return numbers in a text that look measured and have no claim, each with what is around."""
    blank = bytearray(len(text))  # 1 where a number needs no claim

    def free(start: int, end: int) -> None:
        blank[start:end] = b"\1" * (end - start)

    for found in (*FREE.finditer(text), *TABLE.finditer(text)):
        free(*found.span())
    for _, _, digits in said(text):
        free(*digits.span())
    for mark in MARK.finditer(text):
        if mark["free"]:
            ends = [0, *(each.end() for each in SENTENCE.finditer(text, 0, mark.start()))]
            free(ends[-1], mark.start())
    return [
        re.sub(r"\s+", " ", text[max(0, found.start() - 40) : found.end() + 20])
        for found in MEASURED.finditer(text)
        if not blank[found.start()]
    ]


def passages(path: Path) -> list[str]:
    """Return what people read: pages, cells and pictures of notebooks, texts of TOML files."""
    text = path.read_text(encoding="utf-8")
    if path.suffix == ".ipynb":
        if "<!--table: " in text:  # its lines are strings of JSON
            raise ValueError(f"expected no table that is a claim in a notebook, got one in {path}")
        cells = json.loads(text)["cells"]
        pictures = [cell["metadata"].get("alt", "") for cell in cells]
        read = ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "markdown"]
        return [*read, *pictures]
    if path.suffix == ".toml":  # a single word is a name
        return [each for each in strings(load_toml(path)) if " " in each]
    return [text]


def strings(value: Any) -> Iterator[str]:
    """Yield all texts inside of a plain value."""
    if isinstance(value, str):
        yield value
    elif isinstance(value, dict | list):
        for each in value.values() if isinstance(value, dict) else value:
            yield from strings(each)


def main() -> None:
    """Compare texts with tables, write the digits of tables into texts, or tell claims."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n", 1)[0])
    parser.add_argument("texts", nargs="*", type=Path, help="tell the claims of these texts")
    parser.add_argument("--write", action="store_true", help="write the digits into all texts")
    args = parser.parse_args()
    for path in args.texts:
        for mark, claim, _ in said(path.read_text(encoding="utf-8")):
            print(f"{mark['name']}: {claim.text} ({claim.unit}; {claim.setting})")
    if args.texts:
        return
    wrong = 0
    for path in texts():
        name, text = path.relative_to(ROOT), path.read_text(encoding="utf-8")
        try:
            told = written(text)
        except ValueError as error:
            raise SystemExit(f"Error: {name}: {error}") from None
        if told != text and args.write:
            with replacing(path) as file:
                file.write(told.encode())
        wrong += told != text and not args.write
        missing = [each for passage in passages(path) for each in unclaimed(passage)]
        wrong += len(missing)
        state = "" if told == text else "written" if args.write else "digits differ from tables"
        print(*filter(None, [f"{name}: {len(missing)} without a claim", state]), sep="; ")
        print(*(f"    ... {each}" for each in missing), sep="\n", end="\n" if missing else "")
    sys.exit(bool(wrong))


if __name__ == "__main__":
    main()
