"""All measures of one run or several, with intervals."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from matrixworld._util.short_repr import short_repr
from matrixworld.analysis.generalization import Progress, global_progress
from matrixworld.analysis.intervals import (
    FEW_RUNS,
    LEVEL,
    SINGLE_RUN,
    Band,
    Bounds,
    Estimate,
    few_runs,
    interval_over_runs,
    without_interval,
)
from matrixworld.analysis.judgement import Judgement, judge_payoffs
from matrixworld.analysis.measures import MEASURES, measure_over_episodes
from matrixworld.analysis.payoff import Rates, require
from matrixworld.analysis.plain_values import plain_values
from matrixworld.analysis.race_bands import race_bands
from matrixworld.analysis.single_run import RunAnalysis, analyze_run
from matrixworld.analysis.sources import Source, read_payoffs
from matrixworld.analysis.wording import explain, headline

_OTHERS = {
    "elo_log_loss": ("log loss of Elo, nats", 0.0, math.inf),
    "multi_elo_log_loss": ("log loss of Elo with one cycle, nats", 0.0, math.inf),
    "pursuer_rungs": ("dominant pursuer generations", 0.0, math.inf),
    "evader_rungs": ("dominant evader generations", 0.0, math.inf),
    "pursuer_global_gain": ("global progress of the pursuers per generation", -1.0, 1.0),
    "evader_global_gain": ("global progress of the evaders per generation", -1.0, 1.0),
}
"""Labels and bounds of numbers that are not in `MEASURES`."""
BANDS = (
    "pursuer_generalization", "evader_generalization", "pursuer_ratings", "evader_ratings",
    "lag_profile",
)  # fmt: skip
"""Bands of `RaceBands` that an analysis contains."""


@dataclass(frozen=True, eq=False)
class Analysis:
    """All measures of one run or several; ``str`` prints them as a table.

    Parameters
    ----------
    runs : tuple of RunAnalysis
        Measures of each run.
    estimates : dict of str to Estimate
        Headline numbers: mean over runs with an interval over runs; or the numbers of a single run,
        with an interval over its episodes if they are known.
    bands : dict of str to Band
        Mean curves over runs with pointwise intervals: ``pursuer_generalization``, shape (n,),
        ``evader_generalization``, shape (m,), the Elo ratings ``pursuer_ratings`` and
        ``evader_ratings`` in points, and ``lag_profile``, shape (n + m - 1,).
    global_progress : Progress or None
        Progress against opponents of other runs; None without cross tests.
    judgement : Judgement
        What `judge` says of the same runs.
    level : float
        Confidence level of the intervals.
    """

    runs: tuple[RunAnalysis, ...]
    estimates: dict[str, Estimate]
    bands: dict[str, Band]
    global_progress: Progress | None
    judgement: Judgement
    level: float

    __repr__ = short_repr

    def to_json(self) -> dict[str, Any]:
        """Return plain values that JSON can represent: arrays as lists, NaN as None."""
        plain: dict[str, Any] = plain_values(self)
        return plain

    def __str__(self) -> str:
        n, m = self.runs[0].payoff.shape
        lines = [
            f"{len(self.runs)} run{'s' if len(self.runs) > 1 else ''}, {n} pursuer and {m} evader "
            "generations",
            self._intervals(),
            *(f"  {_label(name):53}{self._printed(one)}" for name, one in self.estimates.items()),
            *(f"  {mark} {note}" for note, mark in self._footnotes().items()),
            *self._dominant(),
            *self._verdicts(),
        ]
        return "\n".join(lines)

    def _intervals(self) -> str:
        if len(self.runs) > 1:
            few = "; few runs make it wide" if len(self.runs) < FEW_RUNS else ""
            return f"Mean ({self.level:.0%} interval over runs{few}):"
        if any(one.over == "episodes" for one in self.estimates.values()):
            return (
                f"A single run ({self.level:.0%} interval over its episodes, which says nothing "
                "about other runs):"
            )
        return "A single run: no intervals."

    def _footnotes(self) -> dict[str, str]:
        """Return the notes that the heading does not say, with a mark for each."""
        said = (SINGLE_RUN, few_runs(len(self.runs)), "")
        notes = dict.fromkeys(one.note for one in self.estimates.values() if one.note not in said)
        return {note: "*" * (number + 1) for number, note in enumerate(notes)}

    def _printed(self, estimate: Estimate) -> str:
        if math.isnan(estimate.value):
            return "not defined"
        return f"{estimate} {self._footnotes().get(estimate.note, '')}".rstrip()

    def _dominant(self) -> list[str]:
        # Several runs have the mean number of dominant generations among the estimates.
        ladders = self.runs[0].dominance
        if len(self.runs) > 1 or ladders is None:
            return []
        return [
            f"Dominant {team}: generations {', '.join(map(str, ladder.generations))}."
            for team, ladder in ladders._asdict().items()
        ]

    def _verdicts(self) -> list[str]:
        return [f"Judgement: {headline(self.judgement)}", explain(self.judgement)]


def analyze(
    source: Source,
    *,
    per_episode: bool = False,
    episodes: int | None = None,
    cross: ArrayLike | None = None,
    level: float = LEVEL,
) -> Analysis:
    """Compute all measures of one run or several, with intervals.

    Parameters
    ----------
    source : array_like, path or list of paths
        Payoffs as an array of shape (n, m) or (runs, n, m), a ``.csv`` or ``.npz`` file, or a list
        of such files, one for each run; see `read_payoffs`. At least 2 x 2 generations.
    per_episode : bool, optional
        Whether the last dimension of the array holds the episodes of each cell.
    episodes : int, optional
        Number of episodes behind each cell of a matrix of means.
    cross : array_like of float, shape (runs, runs, n, m), optional
        Cross tests between the runs, as for `global_progress`.
    level : float, optional
        Confidence level of the intervals, in (0, 1).

    Returns
    -------
    Analysis
        Several runs have intervals over runs. A single run has intervals over episodes if they are
        known, else none; its estimates say which.

    Raises
    ------
    ValueError
        If a shape, file or value is not as described.
    TypeError
        If an array does not hold numbers.
    FileNotFoundError
        If a file does not exist.
    """
    require(0.0 < level < 1.0, "a level in (0, 1)", level)
    payoffs = read_payoffs(source, per_episode=per_episode, episodes=episodes)
    runs = tuple(analyze_run(matrix, scores) for matrix, scores in payoffs)
    globally = None if cross is None else _global(cross, payoffs.matrices.shape)
    estimates = _estimates(runs, globally, level)
    # Intervals over runs are the better ones; episodes serve only where there is a single run.
    if payoffs.scores is not None and len(runs) == 1:
        estimates |= _over_episodes(payoffs.scores[0], level)
    judgement = judge_payoffs(payoffs, level=level)
    return Analysis(runs, estimates, _bands(runs, level), globally, judgement, level)


def _global(cross: ArrayLike, shape: tuple[int, ...]) -> Progress:
    # Cross tests have to be between the runs that are analysed.
    expected = (shape[0], *shape)
    require(np.shape(cross) == expected, f"cross tests of shape {expected}", np.shape(cross))
    return global_progress(cross)


def _estimates(
    runs: tuple[RunAnalysis, ...], globally: Progress | None, level: float
) -> dict[str, Estimate]:
    values = {name: [run.numbers[name] for run in runs] for name in runs[0].numbers}
    ladders = [run.dominance for run in runs if run.dominance is not None]
    if ladders:
        values["pursuer_rungs"] = [len(ladder.pursuers) for ladder in ladders]
        values["evader_rungs"] = [len(ladder.evaders) for ladder in ladders]
    if globally is not None:
        values["pursuer_global_gain"] = globally.pursuers.gains.mean(axis=1).tolist()
        values["evader_global_gain"] = globally.evaders.gains.mean(axis=1).tolist()
    return {name: _estimate(of_runs, level, _bounds(name)) for name, of_runs in values.items()}


def _estimate(values: list[float], level: float, bounds: Bounds) -> Estimate:
    """Return the estimate over the runs for which the measure is defined."""
    known = [value for value in values if math.isfinite(value)]
    if not known:
        return without_interval(math.nan, 0, "not defined for any run")
    return interval_over_runs(known, level=level, bounds=bounds)


def _over_episodes(scores: Rates, level: float) -> dict[str, Estimate]:
    # A single episode shows no variation.
    if scores.shape[2] < 2:
        return {}
    return {name: measure_over_episodes(one, scores, level=level) for name, one in MEASURES.items()}


def _bands(runs: tuple[RunAnalysis, ...], level: float) -> dict[str, Band]:
    bands = race_bands([run.payoff for run in runs], level=level)
    return {name: getattr(bands, name) for name in BANDS}


def _label(name: str) -> str:
    return MEASURES[name].label if name in MEASURES else _OTHERS[name][0]


def _bounds(name: str) -> Bounds:
    if name in MEASURES:
        return MEASURES[name].low, MEASURES[name].high
    return _OTHERS[name][1:]
