"""Everything that can be said of one run or several, with intervals."""

from __future__ import annotations

import math
from collections import Counter
from dataclasses import dataclass, fields, is_dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from matrixworld.analysis.bootstrap import (
    LEVEL,
    Band,
    Estimate,
    bootstrap_band,
    bootstrap_episodes,
    bootstrap_runs,
)
from matrixworld.analysis.measures import MEASURES
from matrixworld.analysis.payoff import Rates, require
from matrixworld.analysis.progress import Progress, global_progress
from matrixworld.analysis.single_run import RunAnalysis, analyze_run
from matrixworld.analysis.sources import Payoffs, Source, read_payoffs
from matrixworld.analysis.wording import describe

_OTHER_LABELS = {
    "elo_log_loss": "log loss of Elo, nats",
    "multi_elo_log_loss": "log loss of Elo with one cycle, nats",
    "pursuer_rungs": "dominance tournament, rungs of the pursuers",
    "evader_rungs": "dominance tournament, rungs of the evaders",
    "pursuer_global_gain": "global progress of the pursuers, a generation",
    "evader_global_gain": "global progress of the evaders, a generation",
}


@dataclass(frozen=True, eq=False)
class Analysis:
    """One run or several by every measure; `str` gives it in words, `to_json` as plain values."""

    runs: tuple[RunAnalysis, ...]
    estimates: dict[str, Estimate]
    """Headline numbers: mean over runs with an interval, or a single run's with one over its
    episodes, or without."""
    bands: dict[str, Band]
    """``pursuer_generalization`` ``(n,)``, ``evader_generalization`` ``(m,)`` and ``lag_profile``
    ``(n + m - 1,)``: means over runs with pointwise intervals."""
    global_progress: Progress | None
    """None without cross tests."""
    level: float
    """Of the intervals."""

    def to_json(self) -> dict[str, Any]:
        """The same as plain values that JSON can hold: arrays as lists, NaN as None."""
        plain: dict[str, Any] = _plain(self)
        return plain

    def __str__(self) -> str:
        n, m = self.runs[0].payoff.shape
        lines = [
            f"{len(self.runs)} run{'s' if len(self.runs) > 1 else ''}, {n} pursuer and {m} evader "
            "generations",
            self._intervals(),
            *(f"  {_label(name):53}{_told(one)}" for name, one in self.estimates.items()),
            *self._remarks(),
            *self._steps(),
            *self._verdicts(),
        ]
        return "\n".join(lines)

    def _intervals(self) -> str:
        first = next(iter(self.estimates.values()))
        if first.over == "runs":
            few = f"; {first.note}" if first.note else ""
            return f"Mean ({self.level:.0%} interval over runs{few}):"
        if first.over == "episodes":
            return (
                f"A single run ({self.level:.0%} interval over its episodes, which says nothing "
                "of other runs):"
            )
        return "A single run: no intervals."

    def _remarks(self) -> list[str]:
        if not any(_is_moved(one) for one in self.estimates.values()):
            return []
        return [
            "  * moved by the noise of the episodes; the interval, which makes up for it, is for "
            "the number without noise"
        ]

    def _steps(self) -> list[str]:
        """The dominance ladder of a single run; several have their mean length above."""
        ladders = self.runs[0].dominance
        if len(self.runs) > 1 or ladders is None:
            return []
        return [
            f"Dominant {team}: generations {', '.join(map(str, ladder.generations))}."
            for team, ladder in ladders._asdict().items()
        ]

    def _verdicts(self) -> list[str]:
        if len(self.runs) == 1:
            return [describe(self.runs[0].summary)]
        counts = Counter(run.summary.verdict for run in self.runs)
        told = ", ".join(f"{count} {verdict}" for verdict, count in counts.most_common())
        return [f"What the runs look like: {told}."]


def analyze(
    source: Source,
    *,
    episodes: bool = False,
    cross: ArrayLike | None = None,
    level: float = LEVEL,
    rng: int = 0,
) -> Analysis:
    """Every measure of the package, of one run or several.

    source : payoffs as an array ``(n, m)`` or ``(runs, n, m)``, a ``.csv`` or ``.npz`` file, or a
        list of such files, one a run; see `read_payoffs`. At least 2 x 2 generations.
    episodes : the last dimension of the array holds the episodes of each cell.
    cross : cross tests ``(runs, runs, n, m)`` between the runs, as `global_progress` takes them.
    level : of the intervals, in (0, 1).
    rng : seed of the bootstrap. The same seed gives the same intervals.

    Several runs get intervals over runs. A single one gets intervals over episodes if they are
    known, else none; its estimates say which.

    Raises ValueError, saying what was expected and what came, for other shapes, files or values;
    TypeError for arrays of other than numbers; FileNotFoundError.
    """
    require(0.0 < level < 1.0, "a level in (0, 1)", level)
    payoffs = read_payoffs(source, episodes=episodes)
    runs = tuple(analyze_run(matrix, scores) for matrix, scores in payoffs)
    strangers = None if cross is None else _global(cross, payoffs.matrices.shape)
    estimates = _estimates(runs, strangers, level, rng)
    if payoffs.scores is not None and len(runs) == 1:
        estimates |= _over_episodes(payoffs, level, rng)
    return Analysis(runs, estimates, _bands(runs, level, rng), strangers, level)


def _global(cross: ArrayLike, shape: tuple[int, ...]) -> Progress:
    expected = (shape[0], *shape)
    require(np.shape(cross) == expected, f"cross tests of shape {expected}", np.shape(cross))
    return global_progress(cross)


def _estimates(
    runs: tuple[RunAnalysis, ...], strangers: Progress | None, level: float, rng: int
) -> dict[str, Estimate]:
    values = {name: [run.numbers[name] for run in runs] for name in runs[0].numbers}
    ladders = [run.dominance for run in runs if run.dominance is not None]
    if ladders:
        values["pursuer_rungs"] = [len(ladder.pursuers) for ladder in ladders]
        values["evader_rungs"] = [len(ladder.evaders) for ladder in ladders]
    if strangers is not None:
        values["pursuer_global_gain"] = strangers.pursuers.gains.mean(axis=1).tolist()
        values["evader_global_gain"] = strangers.evaders.gains.mean(axis=1).tolist()
    return {name: _estimate(of_runs, level, rng) for name, of_runs in values.items()}


def _estimate(values: list[float], level: float, rng: int) -> Estimate:
    """Over the runs for which the measure is defined."""
    known = [value for value in values if math.isfinite(value)]
    if not known:
        return Estimate(math.nan, None, None, "nothing", 0, "not defined for any run")
    return bootstrap_runs(known, level=level, rng=rng)


def _over_episodes(payoffs: Payoffs, level: float, rng: int) -> dict[str, Estimate]:
    scores = payoffs.scores
    if scores is None or scores.shape[3] < 2:
        return {}
    return {
        name: bootstrap_episodes(
            scores[0], measure.of, level=level, bounds=(measure.low, measure.high), rng=rng
        )
        for name, measure in MEASURES.items()
    }


def _bands(runs: tuple[RunAnalysis, ...], level: float, rng: int) -> dict[str, Band]:
    curves: dict[str, list[Rates]] = {
        "pursuer_generalization": [run.generalization.pursuers for run in runs],
        "evader_generalization": [run.generalization.evaders for run in runs],
        "lag_profile": [run.lag_profile.means for run in runs],
    }
    return {name: bootstrap_band(of_runs, level=level, rng=rng) for name, of_runs in curves.items()}


def _label(name: str) -> str:
    return MEASURES[name].label if name in MEASURES else _OTHER_LABELS[name]


def _told(estimate: Estimate) -> str:
    if math.isnan(estimate.value):
        return "not defined"
    return f"{estimate} *" if _is_moved(estimate) else str(estimate)


def _is_moved(estimate: Estimate) -> bool:
    return estimate.over == "episodes" and bool(estimate.note)


def _plain(value: Any) -> Any:
    """Lists, dictionaries, numbers, strings and None all the way down."""
    if is_dataclass(value):
        return {item.name: _plain(getattr(value, item.name)) for item in fields(value)}
    if hasattr(value, "_asdict"):
        return _plain(value._asdict())
    if isinstance(value, dict):
        return {key: _plain(item) for key, item in value.items()}
    if isinstance(value, np.ndarray):
        return _plain(value.tolist())
    if isinstance(value, (list, tuple)):
        return [_plain(item) for item in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value
