"""The measures of a race: one table, which the judgement, reports and tables of commands read.

A measure is a row of `MEASURES`: a name, words, and a plain function of the payoffs of one run or
several, of a window of the race, and of the level of the interval, which returns an `Estimate`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np

from matrixworld._util.checks import check_choice
from matrixworld.analysis import cycles, games, intervals, progress, ratings, strength
from matrixworld.analysis import payoffs as payoff_module
from matrixworld.analysis.intervals import LEVEL, UNIT, Bounds, Estimate
from matrixworld.analysis.payoffs import Payoffs, Rates, Source, Window, require

TOO_SHORT = f"it takes at least {payoff_module.GENERATIONS_TO_JUDGE} generations of each team"
NO_EPISODES = (
    "it takes the number of episodes of each pair, at least "
    f"{payoff_module.EPISODES_TO_JUDGE}, to tell it from noise"
)
NOT_SUSTAINED = "not sustained: a jump or a setback makes much of the change"
FALLS_BACK = "loses again, against some opponents, what it had gained"

GAIN: Bounds = (-1.0, 1.0)  # bounds of a difference of two rates


@dataclass(frozen=True)
class Measure:
    """A named number of a race, in a row of `MEASURES`; use `of`."""

    name: str
    label: str  # in tables of measures
    estimate: Callable[[Payoffs, Window, float], Estimate]
    short: str = ""  # in the table of a judgement
    late: bool = False  # whether tables show it in the last half, not of the whole race
    form: str = ".3f"  # as in an f-string
    squared: bool = False  # whether its root is shown

    def of(self, source: Source, window: str | None = None, *, level: float = LEVEL) -> Estimate:
        """Return the number of one run or several in a window, by default that of tables.

        Windows are ``"whole"``, ``"first half"`` and ``"last half"``. Several runs have their mean
        with an interval over runs; a single run has one over its episodes, if they are known and
        their noise allows it. NaN where the payoffs do not hold what it takes; the note says what.
        """
        payoffs = payoff_module.read_payoffs(source)
        intervals.check_level(level)
        if window is not None:
            check_choice("window", window, payoffs.windows)
        part = payoffs.windows[window] if window else self.window_in(payoffs)
        if part.generations < 2:
            return Estimate(math.nan, note="it takes at least 2 generations of each team")
        return self.estimate(payoffs, part, level)

    def window_in(self, payoffs: Payoffs) -> Window:
        """Return the window in which tables show the number; of short races the whole."""
        half = payoffs.windows["last half"]
        is_long = half.generations >= payoff_module.GENERATIONS_TO_JUDGE
        return half if self.late and is_long else payoffs.windows["whole"]

    def shown(self, estimate: Estimate) -> str:
        """Return an estimate as text, with its interval in brackets."""
        if math.isnan(estimate.value):
            return "not known"
        if self.squared:
            # Noise is subtracted from a square, so it may be negative.
            low, high = (end and max(0.0, end) ** 0.5 for end in (estimate.low, estimate.high))
            estimate = Estimate(max(0.0, estimate.value) ** 0.5, low, high)
        return format(estimate, self.form)


def measure_all(source: Source, *, level: float = LEVEL, **known: Any) -> dict[str, Estimate]:
    """Return all measures by name, each in the window in which tables show it; see `Measure.of`.

    Of a `source` of at least 2 x 2 generations, with `known` arguments of `read_payoffs`; intervals
    have a `level` in (0, 1).
    """
    payoffs = payoff_module.read_payoffs(source, **known)
    require(min(payoffs.shape) >= 2, "at least 2 x 2 generations", payoffs.shape)
    return {name: measure.of(payoffs, level=level) for name, measure in MEASURES.items()}


def measure_table(source: Source, *, level: float = LEVEL, **known: Any) -> str:
    """Return all measures as text, by window; `source`, `level`, `known` as for `measure_all`."""
    payoffs = payoff_module.read_payoffs(source, **known)
    estimates = measure_all(payoffs, level=level)
    notes = _footnotes(payoffs, estimates)
    lines, last = [_heading(payoffs, estimates, level)], ""
    for name, estimate in estimates.items():
        window = MEASURES[name].window_in(payoffs).name
        if window != last:
            lines.append(f"  {'whole race' if window == 'whole' else window}")
            last = window
        text = f"{MEASURES[name].label:53}{MEASURES[name].shown(estimate)}"
        lines.append(f"    {text} {notes.get(estimate.note, '')}".rstrip())
    lines += [f"  {mark} {note}" for note, mark in notes.items()]
    return payoff_module.in_words_of(payoffs.teams, "\n".join(lines))


def _heading(payoffs: Payoffs, estimates: Mapping[str, Estimate], level: float) -> str:
    if len(payoffs) > 1:
        few = "; few runs make it wide" if len(payoffs) < intervals.FEW_RUNS else ""
        return f"Mean ({level:.0%} interval over runs{few}):"
    if any(one.across == "episodes" for one in estimates.values()):
        return (
            f"A single run ({level:.0%} interval over its episodes, which says nothing about other "
            "runs):"
        )
    return "A single run: no intervals."


def _footnotes(payoffs: Payoffs, estimates: Mapping[str, Estimate]) -> dict[str, str]:
    """Return the notes that the heading does not say, with a mark for each."""
    said = (intervals.SINGLE_RUN, intervals.few_runs(len(payoffs)), "")
    notes = dict.fromkeys(one.note for one in estimates.values() if one.note not in said)
    return {note: f"[{number}]" for number, note in enumerate(notes, 1)}


Number = Callable[[Rates], float]
"""A number of the payoff matrix of a window, of at least 2 x 2 generations."""


def _of_matrix(
    payoffs: Payoffs,
    window: Window,
    level: float,
    *,
    number: Number,
    bounds: Bounds = UNIT,
    of_episodes: Callable[[Rates], Estimate] | None = None,
) -> Estimate:
    """Estimate a number by the episodes (n, m, episodes) of a single run, else by the matrices.

    Without `of_episodes` it is a sum of cells, which episode noise does not shift.
    """
    if len(payoffs) == 1 and payoffs.scores is not None and payoffs.has_episodes:
        scores = payoffs.scores[0][window.cells]
        if of_episodes is not None:
            return of_episodes(scores)
        return intervals.linear_over_episodes(scores, number, level=level, bounds=bounds)
    return _mean_of((number(each[window.cells]) for each in payoffs.matrices), level, bounds)


def _biased(payoffs: Payoffs, window: Window, level: float, *, number: Number) -> Estimate:
    """Estimate a number that noise shifts by an unknown amount."""

    def of_episodes(scores: Rates) -> Estimate:
        return Estimate(number(scores.mean(axis=2)), samples=scores.shape[2], note=intervals.BIASED)

    return _of_matrix(payoffs, window, level, number=number, of_episodes=of_episodes)


def _rating(payoffs: Payoffs, window: Window, level: float, *, team: str) -> Estimate:
    def of_episodes(scores: Rates) -> Estimate:
        band = getattr(ratings.elo_over_episodes(scores, level=level), team)
        value, low, high = (float(each[-1]) for each in (band.mean, band.low, band.high))
        if math.isnan(low):
            return Estimate(value, note="no interval: all episodes are equal")
        return Estimate(value, low, high, "episodes", scores.shape[2])

    options: Any = {"bounds": intervals.UNBOUNDED, "of_episodes": of_episodes}
    number = partial(_last_rating, team=team)
    return _of_matrix(payoffs, window, level, number=number, **options)


def _mean_of(values: Iterable[float], level: float, bounds: Bounds) -> Estimate:
    """Return the estimate over the runs for which a number is defined."""
    known = [value for value in map(float, values) if math.isfinite(value)]
    if not known:
        return Estimate(math.nan, note="not defined for any run")
    return intervals.interval_over_runs(known, level=level, bounds=bounds)


def _last_score(matrix: Rates, team: str) -> float:
    return float(getattr(progress.generalization(matrix), team)[-1])


def _last_rating(matrix: Rates, team: str) -> float:
    return ratings.ELO_POINTS * float(getattr(ratings.elo(matrix), team)[-1])


def _of_triangle(matrix: Rates, team: str, number: str) -> float:
    return float(getattr(getattr(progress.ciao(matrix), team), number))


def _checkerboards(matrix: Rates) -> float:
    matrix = cycles.thinned(matrix)
    return cycles.checkerboards(matrix, margin=cycles.MARGIN, level=None).share


def _deciding(
    payoffs: Payoffs,
    window: Window,
    level: float,
    *,
    of_run: Callable[..., Estimate],
    **options: Any,
) -> Estimate:
    """Estimate a number of the judgement by a function of one run, a window and the level.

    The judgement asks for single runs and for all together, so numbers of single runs are kept.
    """
    if window.generations < payoff_module.GENERATIONS_TO_JUDGE:
        return Estimate(math.nan, note=TOO_SHORT)
    key, singles = (of_run, window, level, *options.values()), []
    for run in payoffs.runs:
        if key not in run.known:
            found = of_run(run, window, level, **options)
            run.known[key] = replace(found, samples=run.episodes or 0)
        singles.append(run.known[key])
    return singles[0] if len(singles) == 1 else over_runs(singles, level)


def over_runs(singles: list[Estimate], level: float) -> Estimate:
    """Return the mean, the low end of the interval of `biased_low`, and the high one likewise.

    Of few runs the interval contains those of all of them: what is said of them holds for each.
    """
    found = [one for one in singles if math.isfinite(one.value)]
    if len(found) < 2:
        return next(one for one in singles if math.isnan(one.value))
    lows = [one.value if one.biased_low is None else one.biased_low for one in found]
    highs = [one.value if one.biased_high is None else one.biased_high for one in found]
    if len(found) < intervals.RUNS_FOR_T:
        return replace(intervals.around(found), samples=len(found))
    ends = intervals.t_ends(lows, level)[0], intervals.t_ends(highs, level)[1]
    return Estimate(float(np.mean([one.value for one in found])), *ends, "runs", len(found))


def _courses(payoffs: Payoffs, window: Window, team: str) -> tuple[Rates, Rates]:
    """Return mean payoffs (runs, k) of a team against all opponents, and their noise."""
    axis, span = (2, window.cells[0]) if team == "pursuers" else (1, window.cells[1])
    means = payoffs.matrices.mean(axis=axis)[:, span]
    noise = payoffs.noise.mean(axis=axis)[:, span] / payoffs.matrices.shape[axis]
    if payoffs.scores is not None and payoffs.has_episodes:
        # Pairs may share the worlds of an episode, so noise is that of a generation's whole mean.
        # What shifts all generations alike changes no strength.
        each = payoffs.scores.mean(axis=axis)[:, span]
        each = each - each.mean(axis=1, keepdims=True)
        generations, episodes = each.shape[1:]
        noise = each.var(axis=2, ddof=1) * generations / max(1, generations - 1) / episodes
    return (means if team == "pursuers" else 1.0 - means), noise


def _gain(payoffs: Payoffs, window: Window, level: float, *, team: str) -> Estimate:
    if window.generations < payoff_module.GENERATIONS_TO_JUDGE:
        return Estimate(math.nan, note=TOO_SHORT)
    found = strength.gain_of_runs(*_courses(payoffs, window, team), level=level)
    several = ("runs", len(payoffs)) if len(payoffs) > 1 else ("episodes", payoffs.episodes or 0)
    seen = _from_side(payoffs.matrices.mean(axis=0), team)[window.cells[team == "evaders"]]
    note = FALLS_BACK if strength.falls_back(seen) else ""
    return replace(found, across=several[0], samples=several[1], note=note)


def _change(payoffs: Payoffs, window: Window, level: float, *, team: str) -> Estimate:
    found = _deciding(payoffs, window, level, of_run=_change_of_run, team=team)
    if found.low is None or found.low <= 0.0 <= (found.high or 0.0):
        return found
    course = _courses(payoffs, window, team)[0].mean(axis=0)
    return found if strength.is_sustained(course) else replace(found, note=NOT_SUSTAINED)


def _change_of_run(run: Payoffs, window: Window, level: float, team: str) -> Estimate:
    [course], [noise] = _courses(run, window, team)
    return strength.strength_change(course, noise, level=level)


def _one_sidedness(run: Payoffs, window: Window, level: float) -> Estimate:
    if not run.shows_noise:
        return Estimate(math.nan, note=NO_EPISODES)
    # Later generations of the longer side have no opponent of their own generation.
    start, stop = min(window.pursuers, window.evaders, key=lambda span: span[1])
    # Row k - 1 of the team phase rates belongs to generation k; generation 0 has none.
    current = progress.team_phase_rates(run.matrices[0])[max(0, start - 1) : stop - 1]
    return progress.one_sidedness(current, _effective_episodes(run, window), level=level)


def _effective_episodes(run: Payoffs, window: Window) -> float:
    """Return how many wins and losses of each cell would have the noise of its episodes."""
    episodes, rates = run.episodes or 0, run.matrices[0][window.cells]
    wins_and_losses = float((rates * (1.0 - rates)).sum()) / (episodes - 1)
    noise = float(run.noise[0][window.cells].sum())
    # Episodes that are all equal have no noise.
    return episodes * max(1.0, wins_and_losses / noise) if noise else math.inf


def _intransitivity(run: Payoffs, window: Window, level: float) -> Estimate:
    if not run.shows_noise:
        return Estimate(math.nan, note=NO_EPISODES)
    matrix, noise = run.matrices[0][window.cells], run.noise[0][window.cells]
    found = cycles.squared_intransitivity(matrix, noise, level=level)
    if run.scores is not None:
        return found
    # The noise of means is known up to a bound, and may be 0: all of the rest may be a cycle.
    most = cycles.squared_intransitivity(matrix, np.zeros_like(noise), level=level)
    return replace(found, high=most.high, biased_high=most.biased_high)


def _recurrence(run: Payoffs, window: Window, level: float, team: str) -> Estimate:
    if run.scores is None:
        return Estimate(math.nan, note=cycles.TOO_FEW_TO_RECUR)
    scores = run.scores[0][window.cells]
    rows = scores if team == "pursuers" else 1.0 - scores.swapaxes(0, 1)
    return cycles.recurrence_over_episodes(rows, level=level)


def _forgetting(payoffs: Payoffs, window: Window, level: float, *, team: str) -> Estimate:
    """Estimate late forgetting: without bias where single episodes are known."""
    long_enough = window.generations >= payoff_module.GENERATIONS_TO_JUDGE
    if payoffs.scores is not None and payoffs.shows_noise and long_enough:
        return _deciding(payoffs, window, level, of_run=_forgetting_of_run, team=team)
    span = window.cells[team == "evaders"]
    each = (strength.late_forgetting(_from_side(m, team), span) for m in payoffs.matrices)
    found = _mean_of(each, level, UNIT)
    return found if len(payoffs) > 1 else replace(found, note=intervals.BIASED)


def _forgetting_of_run(run: Payoffs, window: Window, level: float, team: str) -> Estimate:
    assert run.scores is not None
    # Episodes without a partner are left out, so that both halves are equally noisy.
    scores, even = run.scores[0], run.scores.shape[3] // 2 * 2
    one, other = (_from_side(scores[..., k:even:2].mean(axis=2), team) for k in (0, 1))
    noise = run.noise[0] if team == "pursuers" else run.noise[0].T
    span = window.cells[team == "evaders"]
    return strength.late_forgetting_over_episodes((one, other), noise, span, level)


def _from_side(matrix: Rates, team: str) -> Rates:
    return matrix if team == "pursuers" else payoff_module.swap_teams(matrix)


def _of_teams(
    name: str,
    label: str,
    estimate: Callable[..., Estimate],
    *,
    number: Callable[[Rates, str], float] | None = None,
    short: str = "",
    **look: Any,
) -> list[Measure]:
    """Return the rows of both teams; the estimate takes the team, or else its number does."""
    rows = []
    for words in WORDS:
        of_team: dict[str, Any] = {"team": f"{words['team']}s"}
        if number is not None:
            of_team = {"number": partial(number, **of_team)}
        key, long, brief = (text.format(**words) for text in (f"{{team}}_{name}", label, short))
        rows.append(Measure(key, long, partial(estimate, **of_team), brief, **look))
    return rows


WORDS = (
    {"team": "pursuer", "other": "evader", "score": "capture"},
    {"team": "evader", "other": "pursuer", "score": "escape"},
)


ROWS = (
    # What the judgement rests on, in its window.
    Measure(
        "one_sidedness", "payoff of the winning team", partial(_deciding, of_run=_one_sidedness),
        short="winning team", late=True,
    ),
    *_of_teams("gain", "gain of the {team}s", _gain, short="{team}s", late=True, form="+.3f"),
    *_of_teams("change", "change of the {team}s", _change, short="{team}s", late=True, form="+.3f"),
    Measure(
        "squared_intransitivity", "intransitivity", partial(_deciding, of_run=_intransitivity),
        short="deviation", late=True, squared=True,
    ),
    *_of_teams(
        "recurrence", "recurrence of the {team}s", partial(_deciding, of_run=_recurrence),
        short="{team}s", late=True, form="+.3f",
    ),
    Measure(
        "checkerboards", "checkerboards", partial(_biased, number=_checkerboards),
        late=True, form=".1%",
    ),
    *_of_teams("forgetting", "forgetting of the {team}s", _forgetting, short="{team}s", late=True),
    # Early generations mix untrained and trained teams.
    Measure(
        "transitive_share", "transitive share",
        partial(
            _of_matrix, number=cycles.transitive_share,
            of_episodes=cycles.transitive_share_over_episodes,
        ),
        late=True,
    ),
    # Of the whole race.
    Measure("capture_rate", "mean capture rate", partial(_of_matrix, number=np.mean)),
    Measure(
        "lag_rise", "gain of later over earlier pursuers",
        partial(_of_matrix, number=progress.lag_rise, bounds=GAIN),
    ),
    *_of_teams(
        "generalization", "last {team}s against all {other}s, {score}", _of_matrix,
        number=_last_score,
    ),
    *_of_teams(
        "fading", "CIAO, fading of the {team}s", partial(_of_matrix, bounds=GAIN),
        number=partial(_of_triangle, number="fading"),
    ),
    *_of_teams(
        "stripes", "CIAO, stripes of the {team}s", _biased,
        number=partial(_of_triangle, number="stripes"),
    ),
    Measure(
        "game_value", "capture rate in the Nash equilibrium",
        partial(_biased, number=games.game_value),
    ),
    *_of_teams("rating", "Elo points of the last {team}s above their mean", _rating, form="+.0f"),
)  # fmt: skip
MEASURES = {row.name: row for row in ROWS}
"""All measures by name, in the order of tables."""
