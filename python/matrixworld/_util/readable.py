"""How results are shown: a line of code, a table in print, HTML in a notebook, JSON in a file."""

from __future__ import annotations

import html
import math
from collections.abc import Mapping, Sequence
from dataclasses import fields, is_dataclass
from itertools import chain, zip_longest
from typing import Any

import numpy as np
from numpy.typing import NDArray

Table = Sequence[Sequence[str]]
"""Rows of cells; the first row is the head."""
Parts = Sequence["str | Table"]
"""What a result shows: texts and tables."""

LONGEST = 60
"""Characters of a value that is shown as it is."""
MOST_ROWS, MOST_CELLS = 40, 12
"""Most rows of columns, and most rows and columns of a matrix, that are shown."""
NUMERIC = frozenset("0123456789.,%+-einaf")
"""Characters of cells that are aligned right."""


class Readable:
    """A dataclass, made with ``repr=False``, that people read.

    Its ``repr`` is one line. Its `_parts` are printed by ``str``, and shown by notebooks.
    """

    def __repr__(self) -> str:
        shown = (f"{name}={_short(value)}" for name, value in _values(self).items())
        return f"{type(self).__name__}({', '.join(shown)})"

    def __str__(self) -> str:
        return "\n".join(chain(*map(_lines, self._parts())))

    def _repr_html_(self) -> str:
        return "\n".join(map(html_of, self._parts()))

    def _parts(self) -> Parts:
        """Return what is shown: by default columns of all arrays (n,), and the other fields."""
        columns, others = dict[str, Any](), [(type(self).__name__, "")]
        for name, value in _values(self).items():
            if isinstance(value, np.ndarray) and value.ndim == 1:
                columns[name] = value
            else:
                others.append((name, _cell(value)))
        rows = _some(max(map(len, columns.values()), default=0), MOST_ROWS)
        cells = [[_cell(v[i]) if i < len(v) else "" for v in columns.values()] for i in rows]
        table = [["", *columns], *([str(i), *row] for i, row in zip(rows, cells, strict=True))]
        return [others, table] if columns else [others]


class Worded:
    """A dataclass whose ``str`` is a text; JSON holds this text, not the fields."""


def plain_values(value: Any) -> Any:
    """Return a result as JSON holds it: nested dictionaries and lists; None where not finite."""
    if isinstance(value, Worded):
        return str(value)
    if is_dataclass(value):
        return {item.name: plain_values(getattr(value, item.name)) for item in fields(value)}
    if hasattr(value, "_asdict"):  # a named tuple; before tuples, which lose the names
        return plain_values(value._asdict())
    if isinstance(value, Mapping):
        return {key: plain_values(item) for key, item in value.items()}
    if isinstance(value, np.ndarray):
        return plain_values(value.tolist())
    if isinstance(value, (list, tuple)):
        return [plain_values(item) for item in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def matrix_table(matrix: NDArray[Any]) -> Table:
    """Return a matrix as a table with the numbers of its rows and columns; a large one in part."""
    rows, columns = (_some(size, MOST_CELLS) for size in matrix.shape)
    body = [[str(i), *(f"{matrix[i, j]:.2f}" for j in columns)] for i in rows]
    return [["", *map(str, columns)], *body]


def table_lines(rows: Table, align: str) -> list[list[str]]:
    """Return the lines of each row, with columns aligned left (``<``) or right (``>``)."""
    columns = zip(*rows, strict=True)
    widths = [max(len(line) for cell in c for line in cell.split("\n")) for c in columns]
    return [
        [
            "  ".join(f"{c:{a}{w}}" for c, a, w in zip(line, align, widths, strict=True)).rstrip()
            for line in zip_longest(*(cell.split("\n") for cell in row), fillvalue="")
        ]
        for row in rows
    ]


def _some(count: int, most: int) -> list[int]:
    """Return the numbers of `count` rows, or so many at equal distances with the last one."""
    chosen: list[int] = np.linspace(0, count - 1, min(count, most)).round().astype(int).tolist()
    return chosen


def _values(result: Any) -> dict[str, Any]:
    return {item.name: getattr(result, item.name) for item in fields(result)}


def _short(value: Any) -> str:
    if isinstance(value, np.ndarray):
        return f"<{value.dtype} {value.shape}>"
    text = repr(value)
    if len(text) <= LONGEST:
        return text
    keys = ", ".join(map(str, value)) if isinstance(value, Mapping) else ""
    size = keys or (len(value) if isinstance(value, list | tuple) else 0)
    return f"<{type(value).__name__} of {size}>" if size else f"<{type(value).__name__}>"


def _cell(value: Any) -> str:
    if isinstance(value, np.ndarray) and value.size and value.dtype.kind in "bfiu":
        return f"mean {value.mean():.3f} of {' x '.join(map(str, value.shape))}"
    if isinstance(value, float | np.floating):
        return f"{value:.3f}"
    return str(value) if isinstance(value, np.generic | str) else _short(value)


def _lines(part: str | Table) -> list[str]:
    if isinstance(part, str):
        return [part]
    columns = zip(*part, strict=True)
    align = "".join("<>"[all(map(NUMERIC.issuperset, cells))] for _, *cells in columns)
    return list(chain(*table_lines(part, align)))


def html_of(part: str | Table) -> str:
    """Return a text or a table as HTML."""
    if isinstance(part, str):
        tag = "pre" if "\n" in part else "p"  # lines that stand below each other, such as a board
        return f"<{tag}>{html.escape(part)}</{tag}>"
    rows = []
    for tag, row in zip(["th", *["td"] * (len(part) - 1)], part, strict=True):
        cells = (html.escape(cell).replace("\n", "<br>") for cell in row)
        rows.append(f"<tr>{''.join(f'<{tag}>{cell}</{tag}>' for cell in cells)}</tr>")
    return f"<table>{''.join(rows)}</table>"
