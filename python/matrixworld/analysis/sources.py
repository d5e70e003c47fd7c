"""Payoffs to analyse: from arrays or files, of one run or several."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld._util.checks import check_integer
from matrixworld._util.reading import read_npz
from matrixworld._util.short_repr import short_repr
from matrixworld.analysis.payoff import Rates, check_rates, check_runs, require
from matrixworld.analysis.tables import read_table

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
    episodes : int or None
        Number of episodes behind each cell; None if it is unknown.
    """

    matrices: Rates
    scores: Rates | None
    episodes: int | None

    __repr__ = short_repr

    def __iter__(self) -> Iterator[tuple[Rates, Rates | None]]:
        """Iterate over matrix (n, m) and scores (n, m, episodes) or None of each run."""
        for run, matrix in enumerate(self.matrices):
            yield matrix, None if self.scores is None else self.scores[run]


def read_payoffs(
    source: Source, *, per_episode: bool = False, episodes: int | None = None
) -> Payoffs:
    """Read payoffs from an array, a file or several files.

    Parameters
    ----------
    source : array_like, path or list of paths
        An array of shape (n, m) or (runs, n, m). A ``.csv`` file as
        `matrixworld.analysis.tables.read_table` reads it. An ``.npz`` file: of several arrays
        ``capture_rates`` is taken, which holds episodes, or else ``capture_rate``, ``payoff`` or
        ``payoffs``; nothing is unpickled. Or a list of such files, one for each run.
    per_episode : bool, optional
        Whether the last dimension of an array holds the episodes of each cell: shape
        (n, m, episodes) or (runs, n, m, episodes).
    episodes : int, optional
        Number of episodes behind each cell, at least 1, for payoffs that hold means only.

    Returns
    -------
    Payoffs
        The matrices, and the episodes if they are known.

    Raises
    ------
    ValueError
        If a shape or suffix is another one, a file is damaged or beyond the limits in
        `matrixworld._util.reading` (both as DamagedFileError), rates are outside [0, 1], or
        `episodes` is below 1 or not the number of episodes that the source holds. The message
        names the file.
    TypeError
        If an array does not hold numbers, or `episodes` is not an integer.
    FileNotFoundError
        If a file does not exist.
    """
    if isinstance(source, (str, os.PathLike)):
        return _counted(_read_file(Path(source), per_episode), episodes)
    if isinstance(source, (list, tuple)) and any(isinstance(s, (str, os.PathLike)) for s in source):
        return _counted(_stacked([Path(path) for path in source], per_episode), episodes)
    return _counted(_payoffs(source, per_episode), episodes)


def _counted(payoffs: Payoffs, episodes: int | None) -> Payoffs:
    """Return the payoffs with the number of their episodes, if the user has given it."""
    if episodes is None:
        return payoffs
    check_integer("episodes", episodes, 1)
    held = payoffs.episodes or episodes
    require(held == episodes, f"the {held} episodes of each cell that the payoffs hold", episodes)
    return replace(payoffs, episodes=episodes)


def _stacked(paths: list[Path], per_episode: bool) -> Payoffs:
    runs = [_read_file(path, per_episode) for path in paths]
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
    # All runs have the same shape, so also the same number of episodes.
    return Payoffs(matrices, np.concatenate(scores) if scores else None, first.episodes)


def _shape(run: Payoffs) -> tuple[int, ...]:
    return (run.matrices if run.scores is None else run.scores).shape[1:]


def _read_file(path: Path, per_episode: bool) -> Payoffs:
    readers = {".csv": read_table, ".npz": _read_arrays}
    reader = readers.get(path.suffix.lower())
    if reader is None:
        raise ValueError(f"{path}: expected a .csv or an .npz file, got suffix {path.suffix!r}")
    values, has_episodes = reader(path)
    try:
        return _payoffs(values, per_episode or has_episodes)
    except (TypeError, ValueError) as error:
        raise type(error)(f"{path}: {error}") from error


def _read_arrays(path: Path) -> tuple[NDArray[Any], bool]:
    arrays = read_npz(path)
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


def _payoffs(values: Any, per_episode: bool) -> Payoffs:
    if not per_episode:
        return Payoffs(check_runs(values), None, None)
    array = np.asarray(values)
    if array.ndim == 3:  # a single run
        array = array[None]
    what = "scores ([runs,] n, m, episodes)"
    scores = check_rates(array, ndim=4, what=what)
    return Payoffs(scores.mean(axis=3), scores, scores.shape[3])
