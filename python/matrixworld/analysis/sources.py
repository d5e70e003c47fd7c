"""What is analysed: arrays, files of them, one run or several."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld.analysis.payoff import Rates, check_rates, check_runs
from matrixworld.analysis.tables import read_table
from matrixworld.files import read_arrays

Source = ArrayLike | str | os.PathLike[str] | Sequence[str | os.PathLike[str]]
"""An array, a file, or several files of one run each."""

PER_EPISODE = "capture_rates"
"""The array of an .npz file that holds each episode; run directories write it."""
MEANS = ("capture_rate", "payoff", "payoffs")
"""Those that hold payoff matrices, if there are several arrays; the first one is taken."""


@dataclass(frozen=True, eq=False)
class Payoffs:
    """Payoff matrices of independent runs, and the episodes behind them if they are known."""

    matrices: Rates
    """Shape ``(runs, n, m)``."""
    scores: Rates | None
    """Shape ``(runs, n, m, episodes)``: capture rate of each episode."""

    def __iter__(self) -> Iterator[tuple[Rates, Rates | None]]:
        """Matrix ``(n, m)`` and scores ``(n, m, episodes)`` of each run."""
        for run, matrix in enumerate(self.matrices):
            yield matrix, None if self.scores is None else self.scores[run]


def read_payoffs(source: Source, *, episodes: bool = False) -> Payoffs:
    """Payoffs from an array, a file or several files, one of each run.

    An array has the shape ``(n, m)`` or ``(runs, n, m)``; with ``episodes=True`` its last dimension
    holds the episodes of a cell instead: ``(n, m, episodes)`` or ``(runs, n, m, episodes)``. A file
    is a ``.csv`` as :func:`~matrixworld.analysis.tables.read_table` reads it, or an ``.npz``: of
    several arrays in it ``capture_rates`` is taken, with episodes, or else ``capture_rate``,
    ``payoff`` or ``payoffs``. Nothing is ever unpickled.

    Raises ValueError, saying what was expected and what came and naming the file, for other shapes
    and suffixes, damaged files, rates that are not in [0, 1]; TypeError for an array of other than
    numbers; FileNotFoundError.
    """
    if isinstance(source, (str, os.PathLike)):
        return _read_file(Path(source), episodes)
    if isinstance(source, (list, tuple)) and any(isinstance(s, (str, os.PathLike)) for s in source):
        return _stacked([Path(path) for path in source], episodes)
    return _payoffs(source, episodes)


def _stacked(paths: list[Path], episodes: bool) -> Payoffs:
    runs = [_read_file(path, episodes) for path in paths]
    first = runs[0]
    for path, run in zip(paths, runs, strict=True):
        if len(run.matrices) != 1:
            raise ValueError(f"{path}: expected one run a file, got {len(run.matrices)}")
        if _shape(run) != _shape(first):
            raise ValueError(
                f"{path}: expected the shape of {paths[0]}, {_shape(first)}, got {_shape(run)}"
            )
    matrices = np.concatenate([run.matrices for run in runs])
    scores = [run.scores for run in runs if run.scores is not None]
    return Payoffs(matrices, np.concatenate(scores) if scores else None)


def _shape(run: Payoffs) -> tuple[int, ...]:
    return (run.matrices if run.scores is None else run.scores).shape[1:]


def _read_file(path: Path, episodes: bool) -> Payoffs:
    readers = {".csv": read_table, ".npz": _read_arrays}
    reader = readers.get(path.suffix.lower())
    if reader is None:
        raise ValueError(f"{path}: expected a .csv or an .npz file, got suffix {path.suffix!r}")
    values, per_episode = reader(path)
    try:
        return _payoffs(values, episodes or per_episode)
    except (TypeError, ValueError) as error:
        raise type(error)(f"{path}: {error}") from error


def _read_arrays(path: Path) -> tuple[NDArray[Any], bool]:
    arrays = read_arrays(path)
    name = _chosen(path, list(arrays))
    return arrays[name], name == PER_EPISODE


def _chosen(path: Path, names: list[str]) -> str:
    for name in (PER_EPISODE, *MEANS):
        if name in names:
            return name
    if len(names) == 1:
        return names[0]
    expected = ", ".join((PER_EPISODE, *MEANS))
    raise ValueError(f"{path}: expected one array, or one named {expected}; got {names}")


def _payoffs(values: Any, episodes: bool) -> Payoffs:
    if not episodes:
        return Payoffs(check_runs(values), None)
    array = np.asarray(values)
    if array.ndim == 3:
        array = array[None]
    what = "scores ([runs,] n, m, episodes)"
    scores = check_rates(array, ndim=4, what=what)
    return Payoffs(scores.mean(axis=3), scores)
