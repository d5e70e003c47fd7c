"""Payoffs to analyse: from arrays or files, of one run or several."""

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
"""Name of the array of an .npz file that holds all episodes, as in run directories."""
MEANS = ("capture_rate", "payoff", "payoffs")
"""Names of arrays that hold payoff matrices; the first one in a file is taken."""


@dataclass(frozen=True, eq=False)
class Payoffs:
    """Payoff matrices of independent runs, and their episodes if they are known.

    Parameters
    ----------
    matrices : ndarray of float64, shape (runs, n, m)
        Payoff matrices.
    scores : ndarray of float64, shape (runs, n, m, episodes), or None
        Capture rate of each episode.
    """

    matrices: Rates
    scores: Rates | None

    def __iter__(self) -> Iterator[tuple[Rates, Rates | None]]:
        """Iterate over matrix (n, m) and scores (n, m, episodes) or None of each run."""
        for run, matrix in enumerate(self.matrices):
            yield matrix, None if self.scores is None else self.scores[run]


def read_payoffs(source: Source, *, episodes: bool = False) -> Payoffs:
    """Read payoffs from an array, a file or several files.

    Parameters
    ----------
    source : array_like, path or list of paths
        An array of shape (n, m) or (runs, n, m). A ``.csv`` file as
        `matrixworld.analysis.tables.read_table` reads it. An ``.npz`` file: of several arrays
        ``capture_rates`` is taken, which holds episodes, or else ``capture_rate``, ``payoff`` or
        ``payoffs``; nothing is unpickled. Or a list of such files, one for each run.
    episodes : bool, optional
        Whether the last dimension of an array holds the episodes of each cell: shape
        (n, m, episodes) or (runs, n, m, episodes).

    Returns
    -------
    Payoffs
        The matrices, and the episodes if they are known.

    Raises
    ------
    ValueError
        If a shape or suffix is another one, a file is damaged, or rates are outside [0, 1]. The
        message names the file.
    TypeError
        If an array does not hold numbers.
    FileNotFoundError
        If a file does not exist.
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
        # Episodes are part of the shape: a mix of runs with and without them is refused here.
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
    # Episodes first: the means follow from them.
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
    if array.ndim == 3:  # a single run
        array = array[None]
    what = "scores ([runs,] n, m, episodes)"
    scores = check_rates(array, ndim=4, what=what)
    return Payoffs(scores.mean(axis=3), scores)
