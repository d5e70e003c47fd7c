"""Figures as files: pixels for a screen, vectors for a paper."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import matplotlib as mpl
from matplotlib.figure import Figure

from matrixworld._util.files import replacing

FORMATS = ("png", "pdf", "svg")
"""Formats of figures, which are the suffixes of their files; pdf and svg are vector graphics."""

# TrueType fonts: journals refuse the other kind that Matplotlib writes. No date and no random names
# of parts, so that files under version control change with the figure only.
_LOOK: dict[Any, Any] = {"pdf.fonttype": 42, "svg.hashsalt": "matrixworld"}
_NO_DATE: dict[str, dict[str, Any]] = {"pdf": {"CreationDate": None}, "svg": {"Date": None}}


def format_of(path: Path) -> str:
    """Return the format of a figure's file by its suffix.

    Parameters
    ----------
    path : Path
        The file.

    Returns
    -------
    str
        One of `FORMATS`.

    Raises
    ------
    ValueError
        If the suffix is another one.
    """
    suffix = path.suffix.lower().removeprefix(".")
    if suffix not in FORMATS:
        expected = ", ".join(f".{each}" for each in FORMATS)
        raise ValueError(f"{path}: expected a name that ends in {expected}, got {path.name!r}")
    return suffix


def save_figure(figure: Figure, path: Path) -> Path:
    """Write a figure, complete or not at all, in the format of the file's suffix.

    Parameters
    ----------
    figure : matplotlib.figure.Figure
        The figure.
    path : Path
        The file: ``.png``, ``.pdf`` or ``.svg``. An older file is replaced.

    Returns
    -------
    Path
        The file.

    Raises
    ------
    ValueError
        If the file has another suffix.
    """
    kind = format_of(path)
    with mpl.rc_context(_LOOK), replacing(path) as file:
        figure.savefig(file, format=kind, metadata=_NO_DATE.get(kind))
    return path
