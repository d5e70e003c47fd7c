"""Tables of text, for terminals and for ``print``."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import zip_longest


def table_lines(rows: Sequence[Sequence[str]], align: str) -> list[list[str]]:
    """Return the lines of each row, with cells in columns; a cell may have several lines.

    `align` has a format character for each column: ``"<"`` left, ``">"`` right.
    """
    columns = zip(*rows, strict=True)
    widths = [max(len(line) for cell in c for line in cell.split("\n")) for c in columns]
    return [
        [
            "  ".join(f"{c:{a}{w}}" for c, a, w in zip(line, align, widths, strict=True)).rstrip()
            for line in zip_longest(*(cell.split("\n") for cell in row), fillvalue="")
        ]
        for row in rows
    ]
