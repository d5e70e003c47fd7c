"""Payoffs: matrices of capture rates, their checks, and their sources, arrays and files.

A *payoff matrix* M has the shape (n, m): ``M[g, h]`` is the capture rate of the pursuers of
generation g against the evaders of generation h.
"""

from __future__ import annotations

import csv
import itertools
import os
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Any, Generic, NamedTuple, TypeAlias, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld._util.checks import check_bool, check_floats, check_integer
from matrixworld._util.files import DamagedFileError, load_arrays, read_text
from matrixworld._util.readable import Parts, Readable, matrix_table
from matrixworld._util.teams import BOTH
from matrixworld.analysis.teams import names_of

Rates = NDArray[np.float64]  # capture rates, or other float64 numbers of the analysis
OfTeam = TypeVar("OfTeam")

ROUNDING = 1e-9  # sums of rates may leave [0, 1] by this
GENERATIONS_TO_JUDGE = 6  # fewest generations of each team in a window that is judged
EPISODES_TO_JUDGE = 4  # fewest episodes of each cell that show their noise: two in each half
EPISODES_TO_RECUR = 6  # fewest episodes for recurrence: three in each half, for a jackknife

PER_EPISODE = "scores"
"""Name of the array of an .npz file that holds all episodes, as in run directories."""
OTHERS = "others"
"""Name of the array with all episodes of the second team in a general-sum game."""
TEAMS = "teams"
"""Name of the array with what the teams are called, in files of other games than pursuit."""
MEANS = ("mean", "capture_rate", "payoff", "payoffs")
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
    """A part of a race: of each team its first generation, and the one after the last."""

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


class Side(NamedTuple):
    """Payoffs as a team sees them: its own, its generations in rows, its opponents in columns."""

    matrices: Rates  # (runs, k, j)
    scores: Rates | None  # (runs, k, j, episodes), if known
    noise: Rates  # (runs, k, j), variance of each cell


@dataclass(frozen=True, eq=False, repr=False)
class Payoffs(Readable):
    """Payoff matrices (runs, n, m) of independent runs, and their episodes if known.

    What the first team wins the second loses, unless this has payoffs of its own, `others`.
    """

    matrices: Rates
    scores: Rates | None = None  # (runs, n, m, episodes), capture rates of single episodes
    episodes: int | None = None
    teams: tuple[str, str] = BOTH
    exact: bool = False  # whether all episodes are equal, as in a game without chance
    others: Rates | None = None  # (runs, n, m, episodes), of the second team in a general-sum game
    extras: Mapping[str, Rates] = field(default_factory=dict)
    """Other means (runs, n, m) that a game tells of its matches, by name."""

    def __len__(self) -> int:
        return len(self.matrices)

    def _parts(self) -> Parts:
        pursuers, evaders = self.teams
        score = names_of(self.teams)["score"].capitalize()
        several = f", means of {len(self)} runs" if len(self) > 1 else ""
        against = "each other" if self.one_population else evaders
        head = f"{score}s of {pursuers} (rows) against {against}{several}:"
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
        nothing = [None] * len(self)
        scores = nothing if self.scores is None else self.scores[:, None]
        others = nothing if self.others is None else self.others[:, None]
        parts = zip(self.matrices[:, None], scores, others, strict=True)
        known = replace(self, extras={})
        return [replace(known, matrices=m, scores=one, others=other) for m, one, other in parts]

    def select(self, runs: list[int]) -> Payoffs:
        """Return the payoffs of some of the runs."""
        scores = None if self.scores is None else self.scores[runs]
        others = None if self.others is None else self.others[runs]
        matrices = self.matrices[runs]
        chosen = replace(self, matrices=matrices, scores=scores, others=others, extras={})
        # What is known of single runs stays known.
        vars(chosen)["_runs"] = [self.runs[run] for run in runs]
        return chosen

    @cached_property
    def computed(self) -> dict[tuple[Any, ...], Any]:
        """Numbers of a single run that have been computed, by what they are."""
        return {}

    @property
    def general(self) -> bool:
        """Whether the teams have payoffs of their own, as in a general-sum game."""
        return self.others is not None

    @property
    def one_population(self) -> bool:
        """Whether one population plays both sides, as in a symmetric game."""
        return self.teams[0] == self.teams[1]

    @cached_property
    def noise(self) -> Rates:
        """Variance of each cell: an estimate, of means a bound; zeros if it is 0 or unknown."""
        return self._noise_of(self.matrices, self.scores)

    def _noise_of(self, matrices: Rates, scores: Rates | None) -> Rates:
        episodes = self.episodes or 0
        # The variance of equal numbers is not quite 0 in floating point.
        if self.exact or episodes < 2:
            return np.zeros_like(matrices)
        if scores is not None:
            sampled: Rates = scores.var(axis=3, ddof=1) / episodes
            return sampled
        # Scores in [0, 1] vary at most as much as wins and losses with the same mean.
        return matrices * (1.0 - matrices) / (episodes - 1)

    def side(self, team: str) -> Side:
        """Return the payoffs as a team, ``"pursuers"`` or ``"evaders"``, sees them."""
        if team == "pursuers":
            return Side(self.matrices, self.scores, self.noise)
        if self.others is not None:
            scores = self.others.swapaxes(1, 2)
            matrices = scores.mean(axis=3)
            return Side(matrices, scores, self._noise_of(matrices, scores))
        matrices = 1.0 - self.matrices.swapaxes(1, 2)
        swapped = None if self.scores is None else 1.0 - self.scores.swapaxes(1, 2)
        return Side(matrices, swapped, self.noise.swapaxes(1, 2))

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


def check_payoff(payoff: ArrayLike) -> Rates:
    """Return a payoff matrix (n, m) of capture rates as float64, or say what is wrong."""
    return check_rates(payoff, ndim=2, what="a payoff matrix")


def check_rates(values: ArrayLike, *, ndim: int, what: str = "an array of rates") -> Rates:
    """Return rates as float64; sums that rounding has put just outside [0, 1] are clipped."""
    rates = _numbers(values, ndim, what)
    # The negated test also finds NaN, which compares as false with everything.
    bad = ~((rates >= -ROUNDING) & (rates <= 1.0 + ROUNDING))
    _refuse(bad, rates, f"{what} with finite values in [0, 1]")
    outside = rates.min() < 0.0 or rates.max() > 1.0
    return np.clip(rates, 0.0, 1.0) if outside else rates


def check_finite(values: ArrayLike, what: str, *, ndim: int, gaps: bool = False) -> Rates:
    """Return finite numbers, which need not be rates, as `check_rates`; `gaps` may be NaN."""
    numbers = _numbers(values, ndim, what)
    _refuse(np.isinf(numbers) if gaps else ~np.isfinite(numbers), numbers, f"finite {what}")
    return numbers


def _numbers(values: ArrayLike, ndim: int, what: str) -> Rates:
    # Not copied: a matrix in another order in memory may have another sum.
    is_checked = type(values) is np.ndarray and values.dtype == np.float64
    array: Rates = values if is_checked else check_floats(what, values)  # type: ignore[assignment]
    expected = f"{what} with {ndim} dimension(s), none of them empty"
    require(array.ndim == ndim and array.size > 0, expected, f"shape {array.shape}")
    return array


def _refuse(bad: NDArray[np.bool_], array: Rates, expected: str) -> None:
    """Raise a ValueError that names the first bad cell, if there is one."""
    if bad.any():
        where = tuple(int(i) for i in np.argwhere(bad)[0])
        raise ValueError(f"expected {expected}, got {array[where]} at index {where}")


def last_half(payoff: ArrayLike) -> Rates:
    """Return rows from ``n // 2`` on and columns from ``m // 2`` on of `payoff` (n, m).

    Early generations mix untrained and trained teams, so measures of the whole matrix mislead.
    """
    matrix = check_payoff(payoff)
    return matrix[Payoffs(matrix[None]).windows["last half"].cells]


def swap_teams(payoff: ArrayLike) -> Rates:
    """Return the payoff matrix of the same matches from the evaders' side: ``1 - M.T``."""
    swapped: Rates = 1.0 - check_payoff(payoff).T
    return swapped


def require(condition: bool, expected: str, received: object) -> None:
    """Raise ValueError with the expected and the received value unless the condition holds."""
    if not condition:
        raise ValueError(f"expected {expected}, got {received}")


Source: TypeAlias = (
    "ArrayLike | str | os.PathLike[str] | Sequence[str | os.PathLike[str]] | Payoffs"
)
"""An array, a file, several files of one run each, or payoffs that have been read."""


def read_payoffs(
    source: Source,
    *,
    per_episode: bool = False,
    episodes: int | None = None,
    exact: bool = False,
    teams: tuple[str, str] = BOTH,
    others: ArrayLike | None = None,
) -> Payoffs:
    """Read payoffs from an array, a file or several files.

    Parameters
    ----------
    source : array_like, path, list of paths or Payoffs
        An array of shape (n, m) or (runs, n, m); a ``.csv`` or ``.npz`` file, or a list of such
        files, one for each run; or the payoff of a saved run, with its episodes.
    per_episode : bool, optional
        Whether the last dimension of an array holds the episodes of each cell: shape
        (n, m, episodes) or (runs, n, m, episodes).
    episodes : int, optional
        Number of episodes behind each cell, at least 1, for payoffs that hold means only.
    exact : bool, optional
        Whether more episodes would have the same scores, as in a deterministic game: then one of
        each cell shows that there is no noise. The default is False.
    teams : tuple of str, optional
        What the teams are called in words; one population of a symmetric game has one name twice.
    others : array_like, optional
        Scores of the second team where it does not lose what the first one wins, in the shape of an
        array of single episodes.

    Notes
    -----
    A CSV file holds a matrix: line g has the capture rates of pursuers g against evaders 0, 1, ...;
    there may be a header, and a column of names. Or it holds one line for each pair: a header with
    ``pursuer, evader, capture_rate`` in any order, and ``run`` or ``episode`` if there are several.
    Empty lines and lines that begin with ``#`` are ignored. Cells are separated by commas,
    semicolons or tabs. Of several arrays in an .npz file ``scores`` is taken, which holds episodes,
    with ``others``, those of the second team, if there are any; or else ``mean``, ``capture_rate``,
    ``payoff`` or ``payoffs``.
    """
    check_bool("per_episode", per_episode)
    if isinstance(source, Payoffs):
        payoffs = source
    elif isinstance(source, (str, os.PathLike)):
        payoffs = _read_file(Path(source), per_episode)
    elif isinstance(source, (list, tuple)) and any(
        isinstance(path, (str, os.PathLike)) for path in source
    ):
        payoffs = _stacked([Path(path) for path in source], per_episode)
    elif hasattr(source, "payoffs"):
        payoffs = source.payoffs()
    else:
        payoffs = _payoffs(source, per_episode, others)
    if teams != BOTH:
        payoffs = replace(payoffs, teams=teams)
    if episodes is not None:
        number = check_integer("episodes", episodes, 1)
        held = payoffs.episodes or number
        require(held == number, f"the {held} episodes of each cell that the payoffs hold", number)
        payoffs = replace(payoffs, episodes=number)
    return payoffs if payoffs is source and not exact else _once_each(payoffs, exact)


def _once_each(payoffs: Payoffs, exact: bool) -> Payoffs:
    """Return payoffs without copies: what is there several times tells no more than once."""
    copies = 1
    scores = payoffs.scores
    others = payoffs.others
    if scores is not None:
        both = scores if others is None else np.concatenate([scores, others])
        episodes = both.reshape(-1, scores.shape[3]).T
        _, first, counts = np.unique(episodes, axis=0, return_index=True, return_counts=True)
        copies = int(np.gcd.reduce(counts))
        exact = exact or (copies > 1 and len(counts) == 1)
    if exact:  # what any number of episodes would be
        scores = np.repeat(payoffs.matrices[..., np.newaxis], EPISODES_TO_RECUR, axis=3)
        if others is not None:
            others = np.repeat(others[..., :1], EPISODES_TO_RECUR, axis=3)
    elif scores is not None and copies > 1:
        kept = np.sort(np.repeat(first, counts // copies))
        scores = scores[..., kept]
        others = None if others is None else others[..., kept]
    else:
        return payoffs
    episodes_left = scores.shape[3]
    return replace(payoffs, scores=scores, others=others, episodes=episodes_left, exact=exact)


def _stacked(paths: list[Path], per_episode: bool) -> Payoffs:
    runs = [_read_file(path, per_episode) for path in paths]
    # Episodes are part of the shape: a mix of runs with and without them is refused.
    shapes = [(run.matrices if run.scores is None else run.scores).shape for run in runs]
    for path, shape in zip(paths, shapes, strict=True):
        if shape[0] != 1:
            raise ValueError(f"{path}: expected one run a file, got {shape[0]}")
        if shape != shapes[0]:
            expected = f"the shape of {paths[0]}, {shapes[0][1:]}"
            raise ValueError(f"{path}: expected {expected}, got {shape[1:]}")
    matrices = np.concatenate([run.matrices for run in runs])
    scores = [run.scores for run in runs if run.scores is not None]
    others = [run.others for run in runs if run.others is not None]
    if 0 < len(others) < len(runs):
        raise ValueError(f"{paths[0]}: expected scores of both teams in all files or in none")
    joined = np.concatenate(scores) if scores else None
    of_second = np.concatenate(others) if others else None
    teams = runs[0].teams
    return Payoffs(matrices, joined, runs[0].episodes, teams, others=of_second)


def _read_file(path: Path, per_episode: bool) -> Payoffs:
    suffix = path.suffix.lower()
    others = None
    teams = BOTH
    if suffix == ".csv":
        values, has_episodes = _read_table(path)
    elif suffix == ".npz":
        values, has_episodes, others, teams = _read_arrays(path)
    else:
        raise ValueError(f"{path}: expected a .csv or an .npz file, got suffix {path.suffix!r}")
    try:
        payoffs = _payoffs(values, per_episode or has_episodes, others)
    except (TypeError, ValueError) as error:
        raise type(error)(f"{path}: {error}") from error
    return payoffs if teams == BOTH else replace(payoffs, teams=teams)


def _read_arrays(path: Path) -> tuple[NDArray[Any], bool, NDArray[Any] | None, tuple[str, str]]:
    arrays = load_arrays(path)
    # Episodes first: the means follow from them.
    preferred = (PER_EPISODE, *MEANS)
    name = next((name for name in preferred if name in arrays), None)
    if name is None:
        if len(arrays) != 1:
            names = ", ".join(preferred)
            raise ValueError(
                f"{path}: expected one array, or one named {names}; got {list(arrays)}"
            )
        [name] = arrays
    if name != PER_EPISODE:
        return arrays[name], False, None, BOTH
    called = arrays.get(TEAMS, np.array(BOTH))
    require(called.shape == (2,) and called.dtype.kind == "U", f"two names as {TEAMS}", called)
    first, second = called.tolist()
    return arrays[name], True, arrays.get(OTHERS), (first, second)


def _payoffs(values: Any, per_episode: bool, others: Any = None) -> Payoffs:
    """Return the payoffs of an array; one without the axis of runs is a single run."""
    array = check_floats("payoff matrices", values)
    if others is not None:
        second = check_floats("others", others)
        expected = f"others of the shape of single episodes, {array.shape}"
        require(per_episode and second.shape == array.shape, expected, f"shape {second.shape}")
        several = second[None] if second.ndim == 3 else second
        rates = check_rates(several, ndim=4, what="others ([runs,] n, m, episodes)")
        return replace(_payoffs(values, per_episode), others=rates)
    if per_episode:
        several = array[None] if array.ndim == 3 else array
        scores = check_rates(several, ndim=4, what="scores ([runs,] n, m, episodes)")
        return Payoffs(scores.mean(axis=3), scores, scores.shape[3])
    if array.ndim == 2:
        return Payoffs(check_payoff(array)[None])
    return Payoffs(check_rates(array, ndim=3, what="payoff matrices (runs, n, m)"))


_PAIR = ("pursuer", "evader")
_RATE = "capture_rate"
_KEYS = ("run", *_PAIR, "episode")
_NUMBER = re.compile(r"[+-]?(\d+[.,]?\d*|[.,]\d+)(e[+-]?\d+)?", re.IGNORECASE)

Line: TypeAlias = tuple[str, list[str]]  # a line of a table: where it is, and its cells


def _read_table(path: Path) -> tuple[Rates, bool]:
    """Return the capture rates of a CSV file, and whether their last dimension is episodes."""
    lines = _lines(path)
    where, head = lines[0]
    names = [cell.lower().replace(" ", "_") for cell in head]
    for at, row in lines:
        if len(row) != len(head):
            raise ValueError(
                f"{at}: expected {len(head)} cells as in the first line, got {len(row)}"
            )
    is_long = set(_PAIR) <= set(names) or _RATE in names
    if is_long and any(names.count(name) != 1 for name in (*_PAIR, _RATE)):
        expected = f"the columns {', '.join(_PAIR)} and {_RATE} once each"
        raise ValueError(f"{where}: expected {expected}, got {', '.join(head)}")
    corner, *above = names
    has_labels = corner in ("", "pursuer") and (_are_names(above) or _count_up(above))
    has_header = is_long or has_labels or _are_names(names)
    body = lines[1:] if has_header else lines
    if not body:
        raise ValueError(f"{path}: expected lines of capture rates, got a header only")
    if is_long:
        return _long(path, names, body), "episode" in names
    first_column = 1 if has_labels else 0
    rates = [[_rate(at, cell) for cell in row[first_column:]] for at, row in body]
    return np.array(rates), False


def _lines(path: Path) -> list[Line]:
    """Return the lines of a CSV file without comments."""
    # A comment becomes an empty line, so that the numbers of lines stay.
    text = read_text(path, "CSV").split("\n")
    raw = ["" if line.lstrip().startswith("#") else line.strip(" ") for line in text]
    first = next(filter(None, raw), "")
    delimiter = next((mark for mark in "\t;" if mark in first), ",")
    reader = csv.reader(raw, delimiter=delimiter, skipinitialspace=True, strict=True)
    try:
        rows = [(reader.line_num, [cell.strip() for cell in row]) for row in reader]
    except csv.Error as error:
        problem = f"line {reader.line_num}: expected a CSV file, got: {error}"
        raise DamagedFileError(path, problem) from error
    while rows and not any(rows[-1][1]):  # spreadsheets end with rows of empty cells
        rows.pop()
    if not rows:
        raise ValueError(f"{path}: expected a table of capture rates, got no lines")
    return [(f"{path}, line {number}", row) for number, row in rows if row]


def _long(path: Path, names: list[str], lines: list[Line]) -> Rates:
    """Return the array of a table of one line for each pair, whose axes are its keys."""
    keys = [key for key in _KEYS if key in names]
    rates: dict[tuple[int, ...], float] = {}
    for where, row in lines:
        cells = [row[names.index(key)] for key in keys]
        if not all(map(str.isdecimal, cells)):
            raise ValueError(f"{where}: expected numbers of {', '.join(keys)}, got {cells}")
        place = tuple(map(int, cells))
        if place in rates:
            hint = "" if "episode" in keys else "; number the matches of a pair in a column episode"
            raise ValueError(f"{where}: expected {_named(keys, place)} once, got it twice{hint}")
        rates[place] = _rate(where, row[names.index(_RATE)])
    axes = [sorted(set(numbers)) for numbers in zip(*rates, strict=True)]
    for place in itertools.product(*axes):
        if place not in rates:
            expected = f"a line for every combination, got none for {_named(keys, place)}"
            raise ValueError(f"{path}: expected {expected}")
    return np.array([rates[place] for place in sorted(rates)]).reshape([*map(len, axes)])


def _named(keys: list[str], place: tuple[int, ...]) -> str:
    return ", ".join(f"{name} {value}" for name, value in zip(keys, place, strict=True))


def _are_names(cells: list[str]) -> bool:
    """Return whether cells name columns: each is there once, and is no number."""
    names = {cell for cell in cells if cell not in ("", "nan") and not _is_number(cell)}
    return 0 < len(cells) == len(names)


def _count_up(cells: list[str]) -> bool:
    """Return whether cells are ascending whole numbers, as those of generations."""
    numbers = [int(cell) if cell.isdecimal() else -1 for cell in cells]
    return bool(numbers) and numbers[0] >= 0 and numbers == sorted(set(numbers))


def _is_number(cell: str) -> bool:
    return _NUMBER.fullmatch(cell) is not None


def _rate(where: str, cell: str) -> float:
    # Checked here as well as in `check_rates`, where the line number is not known any more.
    if _is_number(cell):
        rate = float(cell.replace(",", "."))
        if -ROUNDING <= rate <= 1.0 + ROUNDING:
            return rate
    raise ValueError(f"{where}: expected a capture rate in [0, 1], got {cell!r}")
