"""Payoffs: matrices of capture rates, their checks, and their sources, arrays and files.

A *payoff matrix* M has the shape (n, m): ``M[g, h]`` is the capture rate of the pursuers of
generation g against the evaders of generation h.
"""

from __future__ import annotations

import csv
import io
import itertools
import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any, Generic, TypeAlias, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld._util.checks import check_integer
from matrixworld._util.files import DamagedFileError, read_npz, read_text
from matrixworld._util.readable import Parts, Readable, matrix_table

Rates = NDArray[np.float64]
"""Capture rates, or other float64 numbers of the analysis."""
OfTeam = TypeVar("OfTeam")

SHRINKAGE = 0.01
"""Default shrinkage towards 1/2 before a logit: 0 and 1 become .01 and .99, logits -4.6 and 4.6."""
GENERATIONS_TO_JUDGE = 6
"""Fewest generations of each team in a window that is judged."""
EPISODES_TO_JUDGE = 4
"""Fewest episodes of each cell that show their noise: two in each half."""

PER_EPISODE = "capture_rates"
"""Name of the array of an .npz file that holds all episodes, as in run directories."""
MEANS = ("capture_rate", "payoff", "payoffs")
"""Names of arrays that hold payoff matrices; the first one in a file is taken."""


@dataclass(frozen=True, eq=False)
class ByTeam(Generic[OfTeam]):
    """What both teams have, each measured by its own payoff: higher is better."""

    pursuers: OfTeam
    evaders: OfTeam

    def __iter__(self) -> Iterator[OfTeam]:
        return iter((self.pursuers, self.evaders))


@dataclass(frozen=True)
class Window:
    """A part of a race: of each team its first generation, and the one after the last.

    The name is ``"whole"``, ``"first half"`` or ``"last half"``.
    """

    name: str
    pursuers: tuple[int, int]
    evaders: tuple[int, int]

    @property
    def generations(self) -> int:
        """Generations of the team that has fewer in the window."""
        return min(stop - start for start, stop in (self.pursuers, self.evaders))

    @property
    def cells(self) -> tuple[slice, slice]:
        """The part of the payoff matrix."""
        return slice(*self.pursuers), slice(*self.evaders)


@dataclass(frozen=True, eq=False, repr=False)
class Payoffs(Readable):
    """Payoff matrices of one run or of several independent runs, and their episodes if known.

    `matrices` (runs, n, m); `scores` (runs, n, m, episodes), the capture rate of each episode;
    `episodes` behind each cell; `cross` tests, as `global_progress` takes them.
    """

    matrices: Rates
    scores: Rates | None = None
    episodes: int | None = None
    cross: Rates | None = None

    def __len__(self) -> int:
        return len(self.matrices)

    def _parts(self) -> Parts:
        of = "" if len(self) == 1 else f", means of {len(self)} runs"
        head = f"Capture rates of pursuers (rows) against evaders{of}:"
        return [head, matrix_table(self.matrices.mean(axis=0))]

    @property
    def shape(self) -> tuple[int, int]:
        """Pursuer and evader generations of each run."""
        _, pursuers, evaders = self.matrices.shape
        return pursuers, evaders

    @property
    def runs(self) -> list[Payoffs]:
        """The payoffs of each run alone."""
        return [self] if len(self) == 1 else self._runs

    @cached_property
    def _runs(self) -> list[Payoffs]:
        each = [slice(run, run + 1) for run in range(len(self))]
        scores = [None if self.scores is None else self.scores[run] for run in each]
        return [
            Payoffs(self.matrices[run], of_run, self.episodes)
            for run, of_run in zip(each, scores, strict=True)
        ]

    def select(self, runs: list[int]) -> Payoffs:
        """Return the payoffs of some of the runs, without cross tests."""
        scores = None if self.scores is None else self.scores[runs]
        chosen = Payoffs(self.matrices[runs], scores, self.episodes)
        # What is known of single runs stays known.
        vars(chosen)["_runs"] = [self.runs[run] for run in runs]
        return chosen

    @cached_property
    def known(self) -> dict[tuple[Any, ...], Any]:
        """Numbers of a single run that have been computed, by what they are."""
        return {}

    @cached_property
    def noise(self) -> Rates:
        """Variance of each cell: an estimate, of means a bound; zeros if it is unknown."""
        episodes = self.episodes or 0
        if episodes < 2:
            return np.zeros_like(self.matrices)
        if self.scores is not None:
            sampled: Rates = self.scores.var(axis=3, ddof=1) / episodes
            return sampled
        # Scores in [0, 1] vary at most as much as wins and losses with the same mean.
        return self.matrices * (1.0 - self.matrices) / (episodes - 1)

    @property
    def has_episodes(self) -> bool:
        """Whether there are at least two single episodes of each cell."""
        return self.scores is not None and self.scores.shape[3] >= 2

    @property
    def shows_noise(self) -> bool:
        """Whether there are enough episodes of each cell to tell a number from their noise."""
        return (self.episodes or 0) >= EPISODES_TO_JUDGE

    @property
    def windows(self) -> Mapping[str, Window]:
        """Whole race, first half and last half by their names."""
        n, m = self.shape
        # Of an odd number of generations the middle one belongs to the last half.
        windows = (
            Window("whole", (0, n), (0, m)),
            Window("first half", (0, n // 2), (0, m // 2)),
            Window("last half", (n // 2, n), (m // 2, m)),
        )
        return {window.name: window for window in windows}

    @property
    def late(self) -> Window:
        """The window that headlines and tables speak of: last half, of short races the whole."""
        half = self.windows["last half"]
        return half if half.generations >= GENERATIONS_TO_JUDGE else self.windows["whole"]


def check_payoff(payoff: ArrayLike) -> Rates:
    """Return a payoff matrix (n, m) of capture rates as float64, or say what is wrong."""
    return check_rates(payoff, ndim=2, what="a payoff matrix")


def check_rates(values: ArrayLike, *, ndim: int, what: str = "an array of rates") -> Rates:
    """Return rates in [0, 1] as float64, with `ndim` dimensions of which none is empty.

    Raises ValueError or TypeError, which call the array `what`.
    """
    array = _as_array(values, what)
    # Booleans count as rates of 0 and 1: single matches are stored this way.
    if array.dtype.kind not in "biuf":
        raise TypeError(f"expected {what} of real numbers, got dtype {array.dtype}")
    expected = f"{what} with {ndim} dimension(s), none of them empty"
    require(array.ndim == ndim and array.size > 0, expected, f"shape {array.shape}")
    # float32 rates are widened: sums over many cells would lose digits.
    rates = array.astype(np.float64, copy=False)
    with np.errstate(invalid="ignore"):
        # The negated test also finds NaN, which compares as false with everything.
        bad = np.argwhere(~((rates >= 0.0) & (rates <= 1.0)))
    if len(bad):
        where = tuple(int(i) for i in bad[0])
        raise ValueError(
            f"expected {what} with finite values in [0, 1], got {rates[where]} at index {where}"
        )
    return rates


def check_finite(values: ArrayLike, name: str, shape: str, *, ndim: int) -> Rates:
    """Return finite numbers, which need not be rates, as float64, or raise a ValueError."""
    array = np.asarray(values, dtype=np.float64)
    require(array.ndim == ndim and array.size > 0, f"{name} {shape}", array.shape)
    bad = array[~np.isfinite(array)]
    require(not len(bad), f"finite {name}", bad[:1])
    return array


def last_half(payoff: ArrayLike) -> Rates:
    """Return rows from ``n // 2`` on and columns from ``m // 2`` on.

    Early generations mix untrained and trained teams, so measures of the whole matrix mislead.

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
    """
    matrix = check_payoff(payoff)
    return matrix[Payoffs(matrix[None]).windows["last half"].cells]


def swap_teams(payoff: ArrayLike) -> Rates:
    """Return the payoff matrix of the same matches from the evaders' side: ``1 - M.T``."""
    swapped: Rates = 1.0 - check_payoff(payoff).T
    return swapped


def logits(payoff: ArrayLike, *, shrinkage: float = SHRINKAGE) -> Rates:
    """Return the logits ``log(x / (1 - x))`` of ``x = s + (1 - 2 s) M``, with the shrinkage s.

    Shrinking keeps the order of all cells; clipping would make cells near 0 or 1 equal.
    """
    x = shrink(check_payoff(payoff), shrinkage)
    # log1p keeps its digits for rates close to 0.
    odds: Rates = np.log(x) - np.log1p(-x)
    return odds


def shrink(rates: Rates, shrinkage: float) -> Rates:
    """Return rates moved towards 1/2, away from 0 and 1."""
    require(0.0 < shrinkage < 0.5, "a shrinkage in (0, 0.5)", shrinkage)
    return shrinkage + (1.0 - 2.0 * shrinkage) * rates


def require(condition: bool, expected: str, received: object) -> None:
    """Raise ValueError with the expected and the received value unless the condition holds."""
    if not condition:
        raise ValueError(f"expected {expected}, got {received}")


def _as_array(values: ArrayLike, what: str) -> NDArray[np.generic]:
    # NumPy refuses ragged lists with a message about "inhomogeneous shape"; ours says what to
    # change.
    try:
        return np.asarray(values)
    except ValueError as error:
        raise ValueError(f"expected {what} with rows of equal length, got: {error}") from error


# ---- Sources -------------------------------------------------------------------------------------

Source: TypeAlias = (
    "ArrayLike | str | os.PathLike[str] | Sequence[str | os.PathLike[str]] | Payoffs"
)
"""An array, a file, several files of one run each, or payoffs that have been read."""


def read_payoffs(
    source: Source,
    *,
    per_episode: bool = False,
    episodes: int | None = None,
    cross: ArrayLike | None = None,
) -> Payoffs:
    """Read payoffs from an array, a file or several files.

    Parameters
    ----------
    source : array_like, path, list of paths or Payoffs
        An array of shape (n, m) or (runs, n, m); a ``.csv`` or ``.npz`` file, or a list of such
        files, one for each run; or payoffs, which are returned as they are.
    per_episode : bool, optional
        Whether the last dimension of an array holds the episodes of each cell: shape
        (n, m, episodes) or (runs, n, m, episodes).
    episodes : int, optional
        Number of episodes behind each cell, at least 1, for payoffs that hold means only.
    cross : array_like of float, shape (runs, runs, n, m), optional
        Cross tests between these runs, as `global_progress` takes them.

    Notes
    -----
    A CSV file holds a matrix: line g has the capture rates of pursuers g against evaders 0, 1, ...;
    a first line that is not numbers is a header, and if its first cell is empty, the first cell of
    each line is a label. Or it holds one line for each pair: a header with ``pursuer, evader,
    capture_rate`` in any order, and ``run`` or ``episode`` if there are several; every combination
    of these whole numbers has one line. Other columns, empty lines and lines that begin with ``#``
    are ignored. Of several arrays in an .npz file ``capture_rates`` is taken, which holds episodes,
    or else ``capture_rate``, ``payoff`` or ``payoffs``.
    """
    if isinstance(source, Payoffs):
        payoffs = source
    elif isinstance(source, (str, os.PathLike)):
        payoffs = _read_file(Path(source), per_episode)
    elif isinstance(source, (list, tuple)) and any(
        isinstance(each, (str, os.PathLike)) for each in source
    ):
        payoffs = _stacked([Path(path) for path in source], per_episode)
    else:
        payoffs = _payoffs(source, per_episode)
    if cross is not None:
        # Cross tests have to be between the runs that are analysed.
        expected = (len(payoffs), *payoffs.matrices.shape)
        require(np.shape(cross) == expected, f"cross tests of shape {expected}", np.shape(cross))
        payoffs = replace(payoffs, cross=np.asarray(cross))
    if episodes is None:
        return payoffs
    check_integer("episodes", episodes, 1)
    held = payoffs.episodes or episodes
    require(held == episodes, f"the {held} episodes of each cell that the payoffs hold", episodes)
    return replace(payoffs, episodes=episodes)


def _stacked(paths: list[Path], per_episode: bool) -> Payoffs:
    runs = [_read_file(path, per_episode) for path in paths]
    # Episodes are part of the shape: a mix of runs with and without them is refused.
    shapes = [(run.matrices if run.scores is None else run.scores).shape for run in runs]
    for path, shape in zip(paths, shapes, strict=True):
        if shape[0] != 1:
            raise ValueError(f"{path}: expected one run a file, got {shape[0]}")
        if shape != shapes[0]:
            raise ValueError(
                f"{path}: expected the shape of {paths[0]}, {shapes[0][1:]}, got {shape[1:]}"
            )
    matrices = np.concatenate([run.matrices for run in runs])
    scores = [run.scores for run in runs if run.scores is not None]
    return Payoffs(matrices, np.concatenate(scores) if scores else None, runs[0].episodes)


def _read_file(path: Path, per_episode: bool) -> Payoffs:
    readers = {".csv": _read_table, ".npz": _read_arrays}
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
    # Episodes first: the means follow from them.
    known = (PER_EPISODE, *MEANS)
    name = next((each for each in known if each in arrays), None)
    if name is None:
        if len(arrays) != 1:
            names = ", ".join(known)
            raise ValueError(f"{path}: expected one array, or one named {names}; got {[*arrays]}")
        [name] = arrays
    return arrays[name], name == PER_EPISODE


def _payoffs(values: Any, per_episode: bool) -> Payoffs:
    """Return the payoffs of an array; one without the axis of runs is a single run."""
    ndim = np.ndim(_as_array(values, "payoff matrices"))
    if per_episode:
        array = np.asarray(values)[None] if ndim == 3 else values
        scores = check_rates(array, ndim=4, what="scores ([runs,] n, m, episodes)")
        return Payoffs(scores.mean(axis=3), scores, scores.shape[3])
    if ndim == 2:
        return Payoffs(check_payoff(values)[None])
    return Payoffs(check_rates(values, ndim=3, what="payoff matrices (runs, n, m)"))


# ---- CSV files -----------------------------------------------------------------------------------

_LONG = ("pursuer", "evader", "capture_rate")
_KEYS = ("run", "pursuer", "evader", "episode")


def _read_table(path: Path) -> tuple[Rates, bool]:
    """Return the capture rates of a CSV file, and whether their last dimension is episodes."""
    # utf-8-sig: spreadsheets write a byte order mark.
    text = io.StringIO(read_text(path, "CSV", encoding="utf-8-sig"), newline="")
    try:
        rows = [[cell.strip() for cell in row] for row in csv.reader(text)]
    except csv.Error as error:
        raise DamagedFileError(path, f"expected a CSV file of text, got: {error}") from error
    lines = [
        (f"{path}, line {number}", row)
        for number, row in enumerate(rows, 1)
        if any(row) and not row[0].startswith("#")
    ]
    if not lines:
        raise ValueError(f"{path}: expected a table of capture rates, got no lines")
    names = [cell.lower() for cell in lines[0][1]]
    is_long = set(_LONG) <= set(names)
    # A header is recognised by a cell that is not a number.
    body = lines if all(map(_is_number, names)) else lines[1:]
    if not body:
        raise ValueError(f"{path}: expected lines of capture rates, got a header only")
    width = len(names if is_long else body[0][1])
    for where, row in body:
        if len(row) != width:
            before = "in the header" if is_long else "in the lines before"
            raise ValueError(f"{where}: expected {width} cells as {before}, got {len(row)}")
    if is_long:
        return _long(path, names, body), "episode" in names
    start = int(names[0] == "")  # labels
    return np.array([[_number(at, cell) for cell in row[start:]] for at, row in body]), False


def _long(path: Path, names: list[str], lines: list[tuple[str, list[str]]]) -> Rates:
    """Return the array of a table of one line for each pair, whose axes are its keys."""
    keys = [key for key in _KEYS if key in names]
    places, place = [names.index(key) for key in keys], names.index("capture_rate")
    found: dict[tuple[int, ...], float] = {}
    for where, row in lines:
        try:
            key = tuple(int(row[i]) for i in places)
        except ValueError:
            cells = ", ".join(repr(row[i]) for i in places)
            raise ValueError(f"{where}: expected whole numbers, got {cells}") from None
        if key in found:
            raise ValueError(f"{where}: expected {_combination(keys, key)} once, got it twice")
        found[key] = _number(where, row[place])
    # Numbers of generations may start anywhere; their ranks are the indices.
    axes = [sorted({key[axis] for key in found}) for axis in range(len(keys))]
    for key in itertools.product(*axes):
        if key not in found:
            missing = _combination(keys, key)
            raise ValueError(
                f"{path}: expected a line for every combination, got none for {missing}"
            )
    rates = [found[key] for key in itertools.product(*axes)]
    return np.array(rates).reshape([len(axis) for axis in axes])


def _combination(keys: list[str], key: tuple[int, ...]) -> str:
    return ", ".join(f"{name} {value}" for name, value in zip(keys, key, strict=True))


def _is_number(cell: str) -> bool:
    try:
        float(cell)
    except ValueError:
        return False
    return True


def _number(where: str, cell: str) -> float:
    # Checked here as well as in `check_rates`, where the line number is not known any more.
    if not (_is_number(cell) and 0.0 <= float(cell) <= 1.0):
        raise ValueError(f"{where}: expected a capture rate in [0, 1], got {cell!r}")
    return float(cell)
