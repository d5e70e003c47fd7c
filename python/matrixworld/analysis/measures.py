"""The measures of a race: one table, which the judgement, reports and tables of commands read.

A measure is a row of `MEASURES`: a name, words, and a function of the payoffs of one run or several
and of a window of the race, which returns an `Estimate`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from matrixworld._util.checks import check_choice
from matrixworld.analysis import progress
from matrixworld.analysis.cycles import (
    TOO_FEW_TO_RECUR,
    clear_checkerboards,
    recurrence_over_episodes,
    squared_intransitivity,
    transitive_share,
    transitive_share_over_episodes,
)
from matrixworld.analysis.engagement import one_sidedness
from matrixworld.analysis.games import effective_diversity_over_episodes, game_value
from matrixworld.analysis.intervals import (
    BIASED,
    LEVEL,
    UNBOUNDED,
    UNIT,
    Bounds,
    Estimate,
    check_level,
    interval_over_runs,
    linear_over_episodes,
    t_ends,
)
from matrixworld.analysis.payoffs import (
    EPISODES_TO_JUDGE,
    GENERATIONS_TO_JUDGE,
    ByTeam,
    Payoffs,
    Rates,
    Source,
    Window,
    read_payoffs,
    require,
    swap_teams,
)
from matrixworld.analysis.progress import TeamProgress
from matrixworld.analysis.ratings import ELO_POINTS, elo, elo_over_episodes, log_loss
from matrixworld.analysis.strength import (
    gain_of_runs,
    is_sustained,
    late_forgetting,
    late_forgetting_over_episodes,
    strength_change,
)

TOO_SHORT = f"it takes at least {GENERATIONS_TO_JUDGE} generations of each team"
NO_EPISODES = (
    f"it takes the number of episodes of each pair, at least {EPISODES_TO_JUDGE}, to tell it from "
    "noise"
)
TOO_FEW_FOR_DIVERSITY = f"it takes at least {EPISODES_TO_JUDGE} single episodes of each pair"

NOT_SUSTAINED = "not sustained: a jump or a setback makes much of the change"

Number = Callable[[Rates], float]
"""A number of the payoff matrix of a window, of at least 2 x 2 generations."""
Singles = Sequence[Estimate]
"""The same number of each single run, if it is known already."""
Estimator = Callable[[Payoffs, Window, float, Singles], Estimate]
"""Estimates a number of one run, with an interval over episodes if they are known, or of several,
with an interval over runs."""


@dataclass(frozen=True)
class Measure:
    """A named number of a race.

    Parameters
    ----------
    name : str
        Key in `MEASURES`.
    label : str
        Name in words, for tables.
    estimate : callable
        How it is estimated; use `of`.
    late : bool, optional
        Whether tables show it in the window that headlines speak of, and not of the whole race.
    form : str, optional
        How it is printed, as in an f-string.
    squared : bool, optional
        Whether it is a square, whose root is printed.
    """

    name: str
    label: str
    estimate: Estimator
    late: bool = False
    form: str = ".3f"
    squared: bool = False

    def of(self, source: Source, window: str | None = None, *, level: float = LEVEL) -> Estimate:
        """Return the number of one run or several in a window, by default that of tables.

        Windows are ``"whole"``, ``"first half"`` and ``"last half"``. Several runs have their mean
        with an interval over runs; a single run has one over its episodes, if they are known and
        their noise allows it. NaN where the payoffs do not hold what it takes; the note says what.
        """
        payoffs = read_payoffs(source)
        check_level(level)
        if window is not None:
            check_choice("window", window, payoffs.windows)
        part = payoffs.windows[window] if window else self.window_in(payoffs)
        if part.generations < 2:
            return Estimate(math.nan, note="it takes at least 2 generations of each team")
        return self.estimate(payoffs, part, level, ())

    def window_in(self, payoffs: Payoffs) -> Window:
        """Return the window in which tables show the number."""
        return payoffs.late if self.late else payoffs.windows["whole"]

    def shown(self, estimate: Estimate) -> str:
        """Return an estimate as text, with its interval in brackets."""
        if math.isnan(estimate.value):
            return "not known"
        if self.squared:
            # Noise is subtracted from a square, so it may be negative.
            low, high = (end and max(0.0, end) ** 0.5 for end in (estimate.low, estimate.high))
            estimate = Estimate(max(0.0, estimate.value) ** 0.5, low, high)
        return format(estimate, self.form)

    def __reduce__(self) -> str | tuple[Any, ...]:
        """Pickle a row of `MEASURES` by its name, because its functions may be closures."""
        return (_row, (self.name,)) if MEASURES.get(self.name) is self else super().__reduce__()


def _row(name: str) -> Measure:
    return MEASURES[name]


def measure_all(source: Source, *, level: float = LEVEL, **known: Any) -> dict[str, Estimate]:
    """Return all measures by name, each in the window in which tables show it; see `Measure.of`.

    Parameters
    ----------
    source : array_like, path, list of paths or Payoffs
        Payoffs of at least 2 x 2 generations.
    level : float, optional
        Confidence level of the intervals, in (0, 1).
    **known
        Other arguments of `read_payoffs`.
    """
    payoffs = read_payoffs(source, **known)
    require(min(payoffs.shape) >= 2, "at least 2 x 2 generations", payoffs.shape)
    return {name: measure.of(payoffs, level=level) for name, measure in MEASURES.items()}


# ---- Numbers of the matrix of a window -----------------------------------------------------------


def _of_matrix(
    number: Number, bounds: Bounds, over_episodes: Callable[[Rates, float], Estimate]
) -> Estimator:
    def estimate(payoffs: Payoffs, window: Window, level: float, singles: Singles) -> Estimate:
        # A single episode shows no variation.
        if len(payoffs) == 1 and payoffs.scores is not None and payoffs.scores.shape[3] >= 2:
            return over_episodes(payoffs.scores[0][window.cells], level)
        values = (number(matrix[window.cells]) for matrix in payoffs.matrices)
        return _over_runs(values, level, bounds)

    return estimate


def _linear(number: Number, bounds: Bounds = UNIT) -> Estimator:
    """Return how a sum of cells is estimated, which episode noise does not shift."""

    def over_episodes(scores: Rates, level: float) -> Estimate:
        return linear_over_episodes(scores, number, level=level, bounds=bounds)

    return _of_matrix(number, bounds, over_episodes)


def _biased(number: Number, bounds: Bounds = UNIT) -> Estimator:
    """Return how a number is estimated that noise shifts by an unknown amount."""

    def over_episodes(scores: Rates, level: float) -> Estimate:
        return Estimate(number(scores.mean(axis=2)), samples=scores.shape[2], note=BIASED)

    return _of_matrix(number, bounds, over_episodes)


def _over_runs(values: Iterable[float], level: float, bounds: Bounds) -> Estimate:
    """Return the estimate over the runs for which a number is defined."""
    known = [value for value in map(float, values) if math.isfinite(value)]
    if not known:
        return Estimate(math.nan, note="not defined for any run")
    return interval_over_runs(known, level=level, bounds=bounds)


# ---- Numbers that take single episodes, or tests between runs ------------------------------------


def _dominant(team: str) -> Estimator:

    def estimate(payoffs: Payoffs, window: Window, level: float, singles: Singles) -> Estimate:
        if payoffs.scores is None or payoffs.scores.shape[3] < 2:
            return Estimate(math.nan, note="it takes at least 2 single episodes of each pair")
        parts = (scores[window.cells] for scores in payoffs.scores)
        lengths = (len(getattr(progress.dominance_tournament(part), team)) for part in parts)
        return _over_runs(lengths, level, (0.0, math.inf))

    return estimate


def _global(team: str) -> Estimator:

    def estimate(payoffs: Payoffs, window: Window, level: float, singles: Singles) -> Estimate:
        if payoffs.cross is None:
            return Estimate(math.nan, note="it takes cross tests between runs")
        pursuers, evaders = window.cells
        found = getattr(progress.global_progress(payoffs.cross[..., pursuers, evaders]), team)
        return _over_runs(found.gains.mean(axis=1), level, GAIN)

    return estimate


# ---- Numbers that decide on conditions -----------------------------------------------------------

OfRun = Callable[[Payoffs, Window, float], Estimate]


def _deciding(of_run: OfRun) -> Estimator:
    """Return how a number of the judgement is estimated, for windows that are long enough.

    The mean over several runs has the lower end of Student's t interval of the values
    `biased_low`, and the upper end of that of the values `biased_high`.
    """

    def estimate(payoffs: Payoffs, window: Window, level: float, singles: Singles) -> Estimate:
        if window.generations < GENERATIONS_TO_JUDGE:
            return Estimate(math.nan, note=TOO_SHORT)
        if len(payoffs) == 1:
            return replace(of_run(payoffs, window, level), samples=payoffs.episodes or 0)
        each = singles or [estimate(run, window, level, ()) for run in payoffs.runs]
        found = [one for one in each if math.isfinite(one.value)]
        if len(found) < 2:
            return next(one for one in each if math.isnan(one.value))
        low, _ = t_ends([_or(one.biased_low, one.value) for one in found], level)
        _, high = t_ends([_or(one.biased_high, one.value) for one in found], level)
        return Estimate(float(np.mean([one.value for one in found])), low, high, "runs", len(found))

    return estimate


def _or(number: float | None, default: float) -> float:
    return default if number is None else number


def _courses(payoffs: Payoffs, window: Window, team: str) -> tuple[Rates, Rates]:
    """Return mean payoffs (runs, k) of a team against all opponents, and their noise."""
    axis, span = (2, window.cells[0]) if team == "pursuers" else (1, window.cells[1])
    means = payoffs.matrices.mean(axis=axis)[:, span]
    noise = payoffs.noise.mean(axis=axis)[:, span] / payoffs.matrices.shape[axis]
    if payoffs.scores is not None and payoffs.scores.shape[3] >= 2:
        # Pairs may share the worlds of an episode, so noise is that of a generation's whole mean.
        # What shifts all generations alike changes no strength.
        each = payoffs.scores.mean(axis=axis)[:, span]
        each = each - each.mean(axis=1, keepdims=True)
        generations, episodes = each.shape[1:]
        noise = each.var(axis=2, ddof=1) * generations / max(1, generations - 1) / episodes
    return (means if team == "pursuers" else 1.0 - means), noise


def _gain(team: str) -> Estimator:
    def estimate(payoffs: Payoffs, window: Window, level: float, singles: Singles) -> Estimate:
        if window.generations < GENERATIONS_TO_JUDGE:
            return Estimate(math.nan, note=TOO_SHORT)
        found = gain_of_runs(*_courses(payoffs, window, team), level=level)
        several = len(payoffs) > 1
        samples = len(payoffs) if several else payoffs.episodes or 0
        return replace(found, across="runs" if several else "episodes", samples=samples)

    return estimate


def _change(team: str) -> Estimator:
    def of_run(payoffs: Payoffs, window: Window, level: float) -> Estimate:
        [course], [noise] = _courses(payoffs, window, team)
        return strength_change(course, noise, level=level)

    deciding = _deciding(of_run)

    def estimate(payoffs: Payoffs, window: Window, level: float, singles: Singles) -> Estimate:
        found = deciding(payoffs, window, level, singles)
        if found.low is None or found.low <= 0.0 <= (found.high or 0.0):
            return found
        course = _courses(payoffs, window, team)[0].mean(axis=0)
        return found if is_sustained(course) else replace(found, note=NOT_SUSTAINED)

    return estimate


def _one_sidedness(payoffs: Payoffs, window: Window, level: float) -> Estimate:
    if not payoffs.shows_noise:
        return Estimate(math.nan, note=NO_EPISODES)
    # Later generations of the longer side have no opponent of their own generation.
    start, stop = min(window.pursuers, window.evaders, key=lambda span: span[1])
    # Row k - 1 of the team phase rates belongs to generation k; generation 0 has none.
    current = progress.team_phase_rates(payoffs.matrices[0])[max(0, start - 1) : stop - 1]
    return one_sidedness(current, _effective_episodes(payoffs, window), level=level)


def _effective_episodes(payoffs: Payoffs, window: Window) -> float:
    """Return how many wins and losses of each cell would have the noise of its episodes."""
    episodes, rates = payoffs.episodes or 0, payoffs.matrices[0][window.cells]
    wins_and_losses = float((rates * (1.0 - rates)).sum()) / (episodes - 1)
    noise = float(payoffs.noise[0][window.cells].sum())
    # Episodes without variation show none of their noise.
    return episodes * max(1.0, wins_and_losses / noise if noise else 1.0)


def _cyclic(third: int | None = None) -> Estimator:
    def of_run(payoffs: Payoffs, window: Window, level: float) -> Estimate:
        if not payoffs.shows_noise:
            return Estimate(math.nan, note=NO_EPISODES)
        matrix, noise = payoffs.matrices[0][window.cells], payoffs.noise[0][window.cells]
        found = squared_intransitivity(matrix, noise, third=third, level=level)
        if payoffs.scores is not None:
            return found
        # The noise of means is known up to a bound, and may be 0: all of the rest may be a cycle.
        most = squared_intransitivity(matrix, np.zeros_like(noise), third=third, level=level)
        return replace(found, high=most.high, biased_high=most.biased_high)

    return _deciding(of_run)


def _diversity() -> Estimator:
    def of_run(payoffs: Payoffs, window: Window, level: float) -> Estimate:
        if payoffs.scores is None or not payoffs.shows_noise:
            return Estimate(math.nan, note=TOO_FEW_FOR_DIVERSITY)
        return effective_diversity_over_episodes(payoffs.scores[0][window.cells], level=level)

    deciding = _deciding(of_run)

    def estimate(payoffs: Payoffs, window: Window, level: float, singles: Singles) -> Estimate:
        found = deciding(payoffs, window, level, singles)
        # Estimates without bias may be below 0, diversities not.
        low = None if found.low is None else max(0.0, found.low)
        return replace(found, value=found.value if low is None else max(0.0, found.value), low=low)

    return estimate


def _recurrence(team: str) -> Estimator:
    def of_run(payoffs: Payoffs, window: Window, level: float) -> Estimate:
        if payoffs.scores is None:
            return Estimate(math.nan, note=TOO_FEW_TO_RECUR)
        scores = payoffs.scores[0][window.cells]
        rows = scores if team == "pursuers" else 1.0 - scores.swapaxes(0, 1)
        return recurrence_over_episodes(rows, level=level)

    return _deciding(of_run)


def _forgetting(team: str) -> Estimator:
    """Return how late forgetting is estimated: without bias where single episodes are known."""
    rows = int(team == "evaders")

    def sides(matrix: Rates) -> Rates:
        return swap_teams(matrix) if rows else matrix

    def of_run(payoffs: Payoffs, window: Window, level: float) -> Estimate:
        assert payoffs.scores is not None
        # Episodes without a partner are left out, so that both halves are equally noisy.
        scores, even = payoffs.scores[0], payoffs.scores.shape[3] // 2 * 2
        one, other = (sides(scores[..., start:even:2].mean(axis=2)) for start in (0, 1))
        noise = payoffs.noise[0].T if rows else payoffs.noise[0]
        return late_forgetting_over_episodes((one, other), noise, window.cells[rows], level)

    held_out = _deciding(of_run)

    def estimate(payoffs: Payoffs, window: Window, level: float, singles: Singles) -> Estimate:
        long_enough = window.generations >= GENERATIONS_TO_JUDGE
        if payoffs.scores is not None and payoffs.shows_noise and long_enough:
            return held_out(payoffs, window, level, singles)
        each = (late_forgetting(sides(m), window.cells[rows]) for m in payoffs.matrices)
        found = _over_runs(each, level, UNIT)
        return found if len(payoffs) > 1 else replace(found, note=BIASED)

    return estimate


GAIN: Bounds = (-1.0, 1.0)
"""Bounds of a difference of two rates."""


def _of_teams(
    name: str, label: str, estimator: Callable[[str], Estimator], **look: Any
) -> list[Measure]:
    return [
        Measure(f"{team}_{name}", label.format(team=team), estimator(f"{team}s"), **look)
        for team in ("pursuer", "evader")
    ]


def _mean_gain(kind: Callable[[Rates], ByTeam[TeamProgress]]) -> Callable[[str], Estimator]:
    return lambda team: _linear(lambda m: getattr(kind(m), team).mean_gain, GAIN)


def _rating(team: str) -> Estimator:

    def number(matrix: Rates) -> float:
        return ELO_POINTS * float(getattr(elo(matrix), team)[-1])

    def over_episodes(scores: Rates, level: float) -> Estimate:
        found = getattr(elo_over_episodes(scores, level=level), team)
        ends = float(found.low[0, -1]), float(found.high[0, -1])
        if math.isnan(ends[0]):
            return Estimate(number(scores.mean(axis=2)), note="no interval: all episodes are equal")
        return Estimate(float(found.mean[0, -1]), *ends, "episodes", scores.shape[2])

    return _of_matrix(number, UNBOUNDED, over_episodes)


def _log_loss(cycles: int) -> Estimator:
    bounds = (0.0, math.inf)
    return _biased(lambda m: log_loss(m, elo(m, cycles=cycles).predict()), bounds)


ROWS = (
    # What the judgement rests on, in its window.
    Measure("one_sidedness", "payoff of the winning team", _deciding(_one_sidedness), late=True),
    *_of_teams("gain", "gain of the {team}s", _gain, late=True, form="+.3f"),
    *_of_teams("change", "change of the {team}s", _change, late=True, form="+.3f"),
    Measure(
        "squared_intransitivity", "intransitivity", _cyclic(), late=True, squared=True
    ),
    *_of_teams("recurrence", "recurrence of the {team}s", _recurrence, late=True, form="+.3f"),
    Measure(
        "checkerboards", "checkerboards", _biased(lambda m: clear_checkerboards(m).share),
        late=True, form=".1%",
    ),
    *_of_teams("forgetting", "forgetting of the {team}s", _forgetting, late=True),
    # Early generations mix untrained and trained teams.
    Measure(
        "transitive_share", "transitive share",
        _of_matrix(
            transitive_share, UNIT, lambda s, level: transitive_share_over_episodes(s, level=level)
        ),
        late=True,
    ),
    Measure(
        "transitive_share_logits", "transitive share on logits",
        _biased(lambda m: transitive_share(m, logits=True)), late=True,
    ),
    # Of the whole race.
    Measure("capture_rate", "mean capture rate", _linear(lambda m: float(m.mean()))),
    Measure("swing", "swing between team phases", _biased(progress.swing)),
    Measure("lag_rise", "gain of later over earlier pursuers", _linear(progress.lag_rise, GAIN)),
    Measure(
        "pursuer_generalization", "last pursuers against all evaders, capture",
        _linear(lambda m: float(progress.generalization(m).pursuers[-1])),
    ),
    Measure(
        "evader_generalization", "last evaders against all pursuers, escape",
        _linear(lambda m: float(progress.generalization(m).evaders[-1])),
    ),
    *_of_teams(
        "local_gain", "local progress of the {team}s per generation",
        _mean_gain(progress.local_progress),
    ),
    *_of_teams(
        "historical_gain", "historical progress of the {team}s per generation",
        _mean_gain(progress.historical_progress),
    ),
    *_of_teams("global_gain", "global progress of the {team}s per generation", _global),
    *_of_teams(
        "fading", "CIAO, fading of the {team}s",
        lambda team: _linear(lambda m: getattr(progress.ciao(m), team).fading, GAIN),
    ),
    *_of_teams(
        "stripes", "CIAO, stripes of the {team}s",
        lambda team: _biased(lambda m: getattr(progress.ciao(m), team).stripes),
    ),
    *_of_teams("rungs", "dominant {team} generations", _dominant, form=".1f"),
    Measure("game_value", "capture rate in the Nash equilibrium", _biased(game_value)),
    Measure("effective_diversity", "effective diversity of the equilibrium", _diversity()),
    *(
        Measure(
            f"{which}_intransitivity", f"intransitivity of the {which} third", _cyclic(third),
            squared=True,
        )
        for third, which in enumerate(("weakest", "middle", "strongest"))
    ),
    *_of_teams("rating", "Elo points of the last {team}s above their mean", _rating, form="+.0f"),
    Measure("elo_log_loss", "log loss of Elo, nats", _log_loss(cycles=0)),
    Measure("multi_elo_log_loss", "log loss of Elo with one cycle, nats", _log_loss(cycles=1)),
)  # fmt: skip
MEASURES = {row.name: row for row in ROWS}
"""All measures by name, in the order of tables."""
