"""The measures of a race: one table, which the judgement, reports and tables of commands read.

A measure is a row of `MEASURES`: a name, words, and a plain function of the payoffs of one run or
several, of a window of the race, and of the level of the interval, which returns an `Estimate`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from matrixworld._util.checks import check_choice
from matrixworld._util.teams import BOTH
from matrixworld.analysis import cycles, games, intervals, progress, ratings, strength
from matrixworld.analysis.intervals import LEVEL, UNBOUNDED, UNIT, Band, Bounds, Estimate
from matrixworld.analysis.payoffs import (
    GENERATIONS_TO_JUDGE,
    Payoffs,
    Rates,
    Source,
    Window,
    read_payoffs,
    require,
)
from matrixworld.analysis.reasons import NOTHING, Reason, Why
from matrixworld.analysis.teams import keys_of, names_of

GAIN: Bounds = (-1.0, 1.0)  # bounds of a difference of two rates
LABEL_WIDTH = 53  # least width of the first column of `measure_table`


@dataclass(frozen=True)
class Measure:
    """A named number of a race, in a row of `MEASURES`; use `of`.

    Its texts may name ``{pursuers}``, ``{evaders}`` and ``{score}``, for which a game has words.
    """

    name: str
    text: str  # in tables of measures
    estimate: Callable[[Payoffs, Window, float], Estimate]
    short: str = ""  # in the table of a judgement
    late: bool = False  # whether tables show it in the last half, not of the whole race
    form: str = ".3f"  # as in an f-string
    squared: bool = False  # whether its root is shown
    general: bool = False  # whether it has a meaning where teams have payoffs of their own
    constant: bool = True  # whether it has one where one wins what the other loses
    alone: bool = False  # whether it has one for one population
    bounds: Bounds = UNBOUNDED  # smallest and largest value, to which intervals are clipped

    def of(self, source: Source, window: str | None = None, *, level: float = LEVEL) -> Estimate:
        """Return the number of one run or several in a window, by default that of tables.

        Windows are ``"whole"``, ``"first half"`` and ``"last half"``. Several runs have their mean
        with an interval over runs; a single run has one over its episodes, if they are known and
        their noise allows it. NaN where the payoffs do not hold what it takes; the note says what.
        """
        payoffs = read_payoffs(source)
        intervals.check_level(level)
        if not self.has_meaning(payoffs):
            raise ValueError(f"{self.name}: {self._refusal(payoffs)}")
        if window is None:
            part = self.window_in(payoffs)
        else:
            check_choice("window", window, payoffs.windows)
            part = payoffs.windows[window]
        if part.generations < 2:
            return Estimate(math.nan, note=Reason(Why.ONE_GENERATION))
        return self.estimated(payoffs, part, level)

    def estimated(self, payoffs: Payoffs, window: Window, level: float) -> Estimate:
        """Return the `estimate` inside the bounds."""
        return self.estimate(payoffs, window, level).clipped(self.bounds)

    def has_meaning(self, payoffs: Payoffs) -> bool:
        """Return whether the number has a meaning for games of this kind."""
        of_kind = self.general if payoffs.general else self.constant
        return of_kind and (self.alone or not payoffs.one_population)

    def _refusal(self, payoffs: Payoffs) -> str:
        """Return why the number has no meaning for games of this kind."""
        if payoffs.one_population and not self.alone:
            return "expected a game of two teams, got one of one population"
        if payoffs.general:
            return "expected a game in which one team wins what the other loses, got another one"
        return "expected the scores of both teams, got those of the first one"

    def window_in(self, payoffs: Payoffs) -> Window:
        """Return the window in which tables show the number; of short races the whole."""
        half = payoffs.windows["last half"]
        is_long = half.generations >= GENERATIONS_TO_JUDGE
        return half if self.late and is_long else payoffs.windows["whole"]

    def label(self, teams: tuple[str, str] = BOTH) -> str:
        """Return what tables of measures call the number, in the words of a game."""
        return self.text.format(**names_of(teams))

    def brief(self, teams: tuple[str, str] = BOTH) -> str:
        """Return what the table of a judgement calls the number, in the words of a game."""
        return (self.short or self.text).format(**names_of(teams))

    def shown(self, estimate: Estimate) -> str:
        """Return an estimate as text, with its interval in brackets."""
        if math.isnan(estimate.value):
            return "cannot tell"
        if self.squared:
            # Noise is subtracted from a square, so it may be negative.
            low = None if estimate.low is None else _root(estimate.low)
            high = None if estimate.high is None else _root(estimate.high)
            estimate = Estimate(_root(estimate.value), low, high)
        return format(estimate, self.form)


def _root(square: float) -> float:
    return math.sqrt(max(0.0, square))


def measure_all(source: Source, *, level: float = LEVEL, **known: Any) -> dict[str, Estimate]:
    """Return all measures by name, each in the window in which tables show it; see `Measure.of`.

    Those without a meaning in such games, as Nash equilibria in a general-sum game, are left out.
    Of a `source` of at least 2 x 2 generations, with `known` arguments of `read_payoffs`; intervals
    have a `level` in (0, 1).
    """
    payoffs = read_payoffs(source, **known)
    require(min(payoffs.shape) >= 2, "at least 2 x 2 generations", payoffs.shape)
    return {
        name: measure.of(payoffs, level=level)
        for name, measure in MEASURES.items()
        if measure.has_meaning(payoffs)
    }


def measure_table(source: Source, *, level: float = LEVEL, **known: Any) -> str:
    """Return all measures as text, by window; `source`, `level`, `known` as for `measure_all`."""
    payoffs = read_payoffs(source, **known)
    teams = payoffs.teams
    estimates = measure_all(payoffs, level=level)
    marks = _footnotes(payoffs, estimates)
    labels = {name: MEASURES[name].label(teams) for name in estimates}
    width = max(LABEL_WIDTH, 1 + max(map(len, labels.values())))
    lines = [_heading(payoffs, estimates, level)]
    last = ""
    for name, estimate in estimates.items():
        window = MEASURES[name].window_in(payoffs).name
        if window != last:
            lines.append(f"  {'whole race' if window == 'whole' else window}")
            last = window
        text = f"{labels[name]:{width}}{MEASURES[name].shown(estimate)}"
        lines.append(f"    {text} {marks.get(estimate.note, '')}".rstrip())
    lines += [f"  {mark} {note.in_words(teams)}" for note, mark in marks.items()]
    return "\n".join(lines)


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


def _footnotes(payoffs: Payoffs, estimates: Mapping[str, Estimate]) -> dict[Reason, str]:
    """Return the notes that the heading does not say, with a mark for each."""
    in_heading = (Reason(Why.SINGLE_RUN), intervals.few_runs(len(payoffs)))
    notes = [one.note for one in estimates.values() if one.note and one.note not in in_heading]
    return {note: f"[{number}]" for number, note in enumerate(dict.fromkeys(notes), 1)}


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
    team: str = "pursuers",
) -> Estimate:
    """Estimate a number by the episodes (n, m, episodes) of a single run, else by the matrices.

    The team has the rows. Without `of_episodes` the number is a sum of cells, which episode noise
    does not shift.
    """
    side = payoffs.side(team)
    cells = window.cells if team == "pursuers" else window.cells[::-1]
    if len(payoffs) == 1 and side.scores is not None and payoffs.has_episodes:
        scores = side.scores[0][cells]
        if of_episodes is not None:
            return of_episodes(scores)
        return intervals.linear_over_episodes(scores, number, level=level, bounds=bounds)
    numbers = (number(matrix[cells]) for matrix in side.matrices)
    return _mean_of(numbers, level, bounds)


def _biased(
    payoffs: Payoffs, window: Window, level: float, *, number: Number, team: str = "pursuers"
) -> Estimate:
    """Estimate a number that noise shifts by an unknown amount."""

    def of_episodes(scores: Rates) -> Estimate:
        value = number(scores.mean(axis=2))
        return Estimate(value, samples=scores.shape[2], note=Reason(Why.BIASED))

    return _of_matrix(payoffs, window, level, number=number, of_episodes=of_episodes, team=team)


def _rating(payoffs: Payoffs, window: Window, level: float, *, team: str) -> Estimate:
    def of_episodes(scores: Rates) -> Estimate:
        band = getattr(ratings.elo_over_episodes(scores, level=level), team)
        value = float(band.mean[-1])
        low = float(band.low[-1])
        if math.isnan(low):
            return Estimate(value, note=Reason(Why.EQUAL_EPISODES))
        return Estimate(value, low, float(band.high[-1]), "episodes", scores.shape[2])

    number = partial(_last_rating, team=team)
    return _of_matrix(
        payoffs, window, level, number=number, bounds=UNBOUNDED, of_episodes=of_episodes
    )


def _mean_of(values: Iterable[float], level: float, bounds: Bounds) -> Estimate:
    """Return the estimate over the runs for which a number is defined."""
    known = [value for value in map(float, values) if math.isfinite(value)]
    if not known:
        return Estimate(math.nan, note=Reason(Why.NO_RUN_HAS_IT))
    return intervals.interval_over_runs(known, level=level, bounds=bounds)


def _last_score(matrix: Rates) -> float:
    return float(matrix.mean(axis=1)[-1])


class Lead(NamedTuple):
    """How much better late generations of a team are than its generation 0.

    `size` is the mean payoff of the last half of its generations against all opponents, minus that
    of generation 0. `reached` is the first generation that begins three whose mean has nine tenths
    of it; None if that is in the last half, or if the mean of three moves by a quarter of it or
    more afterwards: then it was not learned early.
    """

    size: Estimate
    reached: int | None


def leads_of(payoffs: Payoffs, level: float = LEVEL) -> dict[str, Lead]:
    """Return the leads of the teams; of two or three runs, what each of them shows."""
    teams = ["pursuers"] if payoffs.one_population else ["pursuers", "evaders"]
    return {team: _lead(payoffs, payoffs.windows["whole"], level, team) for team in teams}


def _lead(payoffs: Payoffs, window: Window, level: float, team: str) -> Lead:
    courses = payoffs.side(team).matrices.mean(axis=2)[:, _span(window, team)]
    singles = [_lead_of_course(course, level) for course in courses]
    if len(singles) == 1:
        return singles[0]
    if len(singles) < intervals.RUNS_FOR_T:
        reached = [single.reached for single in singles]
        latest = None if None in reached else max(filter(None, reached))
        return Lead(over_runs([single.size for single in singles], level), latest)
    sizes = [single.size.value for single in singles]
    size = intervals.interval_over_runs(sizes, level=level, bounds=GAIN)
    return Lead(size, _lead_of_course(courses.mean(axis=0), level).reached)


def _lead_size(payoffs: Payoffs, window: Window, level: float, *, team: str) -> Estimate:
    if window.generations < GENERATIONS_TO_JUDGE:
        return Estimate(math.nan, note=Reason(Why.TOO_SHORT))
    return _lead(payoffs, window, level, team).size


def _lead_of_course(course: Rates, level: float) -> Lead:
    """Return the lead in the mean payoffs (k,) of a team against all opponents.

    Its interval is that of a prediction: generation 0 as another one of the last half.
    """
    half = len(course) // 2
    late = course[half:]
    lead = float(late.mean() - course[0])
    reach = intervals.prediction_reach(late, level)
    size = Estimate(lead, lead - reach, lead + reach, "generations", len(late)).clipped(GAIN)
    means = np.convolve(course[1:], np.full(3, 1 / 3), "valid")
    enough = np.flatnonzero(means >= course[0] + 0.9 * lead)
    if lead <= 0.0 or not len(enough) or enough[0] + 1 >= half:
        return Lead(size, None)
    moves = float(np.ptp(means[enough[0] :]))
    return Lead(size, 1 + int(enough[0]) if moves < lead / 4.0 else None)


LEAST_LEARNED = 0.25
"""A team learned to beat an opponent if it wins more than half, and by so much more than before."""


def learned_to_beat(payoffs: Payoffs, window: Window, level: float) -> dict[str, tuple[int, ...]]:
    """Return the opponents' generations that a team learned to beat in a window, by team.

    The last third of its generations score more against them than the first third, in a t interval
    that holds for all opponents of both teams (Bonferroni). Of several runs each has to show some.
    """
    return learned_in_all(
        [
            {
                team: opponents
                for team in (("pursuers",) if payoffs.one_population else BOTH)
                if (opponents := _beaten(run, window, level, team))
            }
            for run in payoffs.runs
        ]
    )


def learned_in_all(runs: Sequence[Mapping[str, tuple[int, ...]]]) -> dict[str, tuple[int, ...]]:
    """Return the teams that learned in all runs, and the opponents that they beat in each."""
    first, *others = runs
    return {
        team: tuple(one for one in opponents if all(one in other[team] for other in others))
        for team, opponents in first.items()
        if all(team in other for other in others)
    }


def _beaten(run: Payoffs, window: Window, level: float, team: str) -> tuple[int, ...]:
    scores = run.side(team).matrices[0][_span(window, team)]
    third = len(scores) // 3
    before, after = scores[:third], scores[-third:]
    rises = after.mean(axis=0) - before.mean(axis=0)
    errors = np.sqrt((before.var(axis=0, ddof=1) + after.var(axis=0, ddof=1)) / third)
    each = 1.0 - (1.0 - level) / sum(run.shape)
    # The fewest degrees of freedom that Welch's t may have.
    reach = intervals.t_quantile(each, third - 1) * errors
    learned = (rises > np.maximum(LEAST_LEARNED, reach)) & (after.mean(axis=0) > 0.5)
    return tuple(np.flatnonzero(learned).tolist())


def _last_rating(matrix: Rates, team: str) -> float:
    return ratings.ELO_POINTS * float(getattr(ratings.elo(matrix), team)[-1])


def _of_triangle(matrix: Rates, number: str) -> float:
    return float(getattr(progress.triangle(matrix), number))


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
    if window.generations < GENERATIONS_TO_JUDGE:
        return Estimate(math.nan, note=Reason(Why.TOO_SHORT))
    key = (of_run, window, level, *options.values())
    for run in payoffs.runs:
        if key not in run.computed:
            estimate = of_run(run, window, level, **options)
            run.computed[key] = replace(estimate, samples=run.episodes or 0)
    singles = [run.computed[key] for run in payoffs.runs]
    return singles[0] if len(singles) == 1 else over_runs(singles, level)


def over_runs(singles: list[Estimate], level: float) -> Estimate:
    """Return the mean, the low end of the interval of `biased_low`, and the high one likewise.

    Of few runs the interval contains those of all of them: what is said of them holds for each.
    """
    defined = [one for one in singles if math.isfinite(one.value)]
    if len(defined) < 2:
        return next(one for one in singles if math.isnan(one.value))
    if len(defined) < intervals.RUNS_FOR_T:
        return replace(intervals.around(defined), samples=len(defined))
    lows = [one.value if one.biased_low is None else one.biased_low for one in defined]
    highs = [one.value if one.biased_high is None else one.biased_high for one in defined]
    low, _ = intervals.t_ends(lows, level)
    _, high = intervals.t_ends(highs, level)
    mean = float(np.mean([one.value for one in defined]))
    return Estimate(mean, low, high, "runs", len(defined))


def _courses(payoffs: Payoffs, window: Window, team: str) -> tuple[Rates, Rates]:
    """Return mean payoffs (runs, k) of a team against all opponents, and their noise."""
    side = payoffs.side(team)
    span = _span(window, team)
    means = side.matrices.mean(axis=2)[:, span]
    noise = side.noise.mean(axis=2)[:, span] / side.matrices.shape[2]
    if side.scores is not None and payoffs.has_episodes and not payoffs.exact:
        # Pairs may share the worlds of an episode, so noise is that of a generation's whole mean.
        # What shifts all generations alike changes no strength.
        noise = _noise_of_course(side.scores.mean(axis=2)[:, span])
    return means, noise


def _noise_of_course(scores: Rates) -> Rates:
    """Return the variance (runs, k) of the means of a course (runs, k, episodes) of episodes."""
    deviations = scores - scores.mean(axis=1, keepdims=True)
    generations, episodes = deviations.shape[1:]
    variances = deviations.var(axis=2, ddof=1)
    return np.asarray(variances * generations / max(1, generations - 1) / episodes)


def _joint_courses(payoffs: Payoffs, window: Window) -> tuple[Rates, Rates]:
    """Return the mean (runs, k) of both teams' payoffs against contemporaries, and its noise.

    Contemporaries of generation k are k itself and, of either team, the generation before.
    """
    first, second = payoffs.side("pursuers"), payoffs.side("evaders")
    both = (first.matrices + second.matrices.swapaxes(1, 2)) / 2.0
    begin, end = _span(window, "pursuers").start, min(span[1] for span in _spans(window))
    means = _near_diagonal(both, begin, end)
    if first.scores is None or second.scores is None or payoffs.exact or not payoffs.has_episodes:
        return means, np.zeros_like(means)
    scores = (first.scores + second.scores.swapaxes(1, 2)) / 2.0
    return means, _noise_of_course(_near_diagonal(scores, begin, end))


def joint_scores(source: Source) -> Band:
    """Return the mean of both teams' scores against contemporaries, by generation.

    Of a `source` as `read_payoffs` takes it. The interval is over runs; of a single run over its
    episodes. ValueError without scores of both teams.
    """
    payoffs = read_payoffs(source)
    require(payoffs.general, "scores of both teams", "those of the first one")
    window = payoffs.windows["whole"]
    means, _ = _joint_courses(payoffs, window)
    first, second = payoffs.side("pursuers").scores, payoffs.side("evaders").scores
    if len(payoffs) > 1 or first is None or second is None:
        return intervals.band_over_runs(means, bounds=UNIT)
    scores = (first + second.swapaxes(1, 2)) / 2.0
    course = _near_diagonal(scores, 0, min(payoffs.shape))
    return intervals.band_over_runs(course[0].T, bounds=UNIT)


def ends_of_extras(payoffs: Payoffs) -> dict[str, tuple[float, float]]:
    """Return the means of a game's own numbers among contemporaries, by name.

    They are those of the first third of the generations, and of the last third.
    """
    end = min(payoffs.shape)
    third = -(-end // 3)
    ends = {}
    for name, values in payoffs.extras.items():
        course = _near_diagonal(values, 0, end).mean(axis=0)
        ends[name] = float(course[:third].mean()), float(course[-third:].mean())
    return ends


def _near_diagonal(cells: Rates, begin: int, end: int) -> Rates:
    """Return the means (runs, k, ...) of the cells of contemporaries in cells (runs, n, m, ...)."""
    course = []
    for k in range(begin, end):
        near = [cells[:, k, k]]
        if k:
            near += [cells[:, k, k - 1], cells[:, k - 1, k]]
        course.append(np.mean(near, axis=0))
    return np.stack(course, axis=1)


def _joint_change(payoffs: Payoffs, window: Window, level: float) -> Estimate:
    change = _deciding(payoffs, window, level, of_run=_joint_change_of_run)
    if change.low is None or change.low <= 0.0 <= (change.high or 0.0):
        return change
    course = _joint_courses(payoffs, window)[0].mean(axis=0)
    if strength.is_sustained(course):
        return change
    return replace(change, note=Reason(Why.NOT_SUSTAINED))


def _joint_change_of_run(run: Payoffs, window: Window, level: float) -> Estimate:
    [course], [noise] = _joint_courses(run, window)
    return strength.strength_change(course, noise, level=level)


def _joint_mean(payoffs: Payoffs, window: Window, level: float) -> Estimate:
    means = _joint_courses(payoffs, window)[0].mean(axis=1)
    if len(means) == 1:
        return Estimate(float(means[0]), note=Reason(Why.SINGLE_RUN))
    return _mean_of(means, level, UNIT)


def _gain(payoffs: Payoffs, window: Window, level: float, *, team: str) -> Estimate:
    if window.generations < GENERATIONS_TO_JUDGE:
        return Estimate(math.nan, note=Reason(Why.TOO_SHORT))
    scores, noise = _without_outliers(payoffs, window, team)
    gain = strength.gain_of_runs(scores.mean(axis=2), noise, level=level)
    note = Reason(Why.FALLS_BACK) if strength.falls_back(scores.mean(axis=0)) else NOTHING
    if len(payoffs) > 1:
        return replace(gain, across="runs", samples=len(payoffs), note=note)
    return replace(gain, across="episodes", samples=payoffs.episodes or 0, note=note)


def _without_outliers(payoffs: Payoffs, window: Window, team: str) -> tuple[Rates, Rates]:
    """Return payoffs (runs, k, m) of a team without outlying generations, and noise of means."""
    matrices = payoffs.side(team).matrices[:, _span(window, team)]
    _, noise = _courses(payoffs, window, team)
    runs = zip(matrices, noise, strict=True)
    return np.stack([strength.without_outliers(*run) for run in runs]), noise


def failed_at_last(payoffs: Payoffs) -> dict[str, int]:
    """Return of each team in how many runs its last generation is far weaker than those before.

    Gains leave such a generation out, as `strength.outlying` says.
    """
    whole = payoffs.windows["whole"]
    found = {}
    for team in ["pursuers"] if payoffs.one_population else ["pursuers", "evaders"]:
        courses, noise = _courses(payoffs, whole, team)
        runs = zip(courses, noise, strict=True)
        found[team] = sum(strength.fails_at_last(*run) for run in runs)
    return {team: count for team, count in found.items() if count}


def _change(payoffs: Payoffs, window: Window, level: float, *, team: str) -> Estimate:
    change = _deciding(payoffs, window, level, of_run=_change_of_run, team=team)
    if change.low is None or change.low <= 0.0 <= (change.high or 0.0):
        return change
    scores, _ = _without_outliers(payoffs, window, team)
    if strength.is_sustained(scores.mean(axis=(0, 2))):
        return change
    return replace(change, note=Reason(Why.NOT_SUSTAINED))


def _change_of_run(run: Payoffs, window: Window, level: float, team: str) -> Estimate:
    [course], [noise] = _courses(run, window, team)
    return strength.strength_change(course, noise, level=level)


def _one_sidedness(run: Payoffs, window: Window, level: float) -> Estimate:
    if not run.shows_noise:
        return Estimate(math.nan, note=Reason(Why.EPISODES_UNKNOWN))
    # Later generations of the longer side have no opponent of their own generation.
    start, stop = min(window.pursuers, window.evaders, key=lambda span: span[1])
    # Row k - 1 of the team phase rates belongs to generation k; generation 0 has none.
    current = progress.team_phase_rates(run.matrices[0])[max(0, start - 1) : stop - 1]
    return progress.one_sidedness(current, _effective_episodes(run, window), level=level)


def _effective_episodes(run: Payoffs, window: Window) -> float:
    """Return how many wins and losses of each cell would have the noise of its episodes."""
    episodes = run.episodes or 0
    rates = run.matrices[0][window.cells]
    wins_and_losses = float((rates * (1.0 - rates)).sum()) / (episodes - 1)
    noise = float(run.noise[0][window.cells].sum())
    # Episodes that are all equal have no noise.
    return episodes * max(1.0, wins_and_losses / noise) if noise else math.inf


def _intransitivity(run: Payoffs, window: Window, level: float) -> Estimate:
    if not run.shows_noise:
        return Estimate(math.nan, note=Reason(Why.EPISODES_UNKNOWN))
    matrix = run.matrices[0][window.cells]
    noise = run.noise[0][window.cells]
    estimate = cycles.squared_intransitivity(matrix, noise, level=level)
    if run.scores is not None:
        return estimate
    # The noise of means is known up to a bound, and may be 0: all of the rest may be a cycle.
    most = cycles.squared_intransitivity(matrix, np.zeros_like(noise), level=level)
    return replace(estimate, high=most.high, biased_high=most.biased_high)


def _interaction(run: Payoffs, window: Window, level: float, team: str) -> Estimate:
    """Return the mean square of a team's scores beside the means of rows and columns.

    It is what the strength of each generation on either side does not explain. The noise of the
    episodes is subtracted; it alone makes the interval.
    """
    if not run.shows_noise:
        return Estimate(math.nan, note=Reason(Why.EPISODES_UNKNOWN))
    side = run.side(team)
    cells = window.cells if team == "pursuers" else window.cells[::-1]
    scores, noise = side.matrices[0][cells], float(side.noise[0][cells].mean())
    rest = scores - scores.mean(axis=0) - scores.mean(axis=1, keepdims=True) + scores.mean()
    n, m = scores.shape
    free = (n - 1) * (m - 1)
    value = float((rest**2).sum()) / free - noise
    # Of a sum of squares of normal errors, beside squares that are no errors.
    reach = intervals.normal_quantile(level) * math.sqrt(
        (2.0 * noise**2 + 4.0 * noise * max(0.0, value)) / free
    )
    low, high = value - reach, value + reach
    return Estimate(value, low, high, "episodes", biased_low=low, biased_high=high)


def _recurrence(run: Payoffs, window: Window, level: float, team: str) -> Estimate:
    scores = run.side(team).scores
    if scores is None:
        return Estimate(math.nan, note=Reason(Why.TOO_FEW_TO_RECUR))
    cells = window.cells if team == "pursuers" else window.cells[::-1]
    # Where no intransitivity is asked for, new styles could be taken for a return.
    return cycles.recurrence_over_episodes(scores[0][cells], level=level, at_one_lag=run.general)


def _forgetting(payoffs: Payoffs, window: Window, level: float, *, team: str) -> Estimate:
    """Estimate late forgetting: without bias where single episodes are known."""
    long_enough = window.generations >= GENERATIONS_TO_JUDGE
    if payoffs.scores is not None and payoffs.shows_noise and long_enough:
        return _deciding(payoffs, window, level, of_run=_forgetting_of_run, team=team)
    span = _span(window, team)
    drops = (strength.late_forgetting(m, span) for m in payoffs.side(team).matrices)
    drop = _mean_of(drops, level, UNIT)
    return drop if len(payoffs) > 1 else replace(drop, note=Reason(Why.BIASED))


def _forgetting_of_run(run: Payoffs, window: Window, level: float, team: str) -> Estimate:
    side = run.side(team)
    assert side.scores is not None
    # Episodes without a partner are left out, so that both halves are equally noisy.
    even = side.scores.shape[3] // 2 * 2
    halves = tuple(side.scores[0, ..., first:even:2].mean(axis=2) for first in (0, 1))
    span = _span(window, team)
    return strength.late_forgetting_over_episodes(halves, side.noise[0], span, level)


def _spans(window: Window) -> tuple[tuple[int, int], tuple[int, int]]:
    return window.pursuers, window.evaders


def _span(window: Window, team: str) -> slice:
    """Return the generations of a team in a window."""
    pursuers, evaders = window.cells
    return pursuers if team == "pursuers" else evaders


def _of_teams(
    name: str, text: str, estimate: Callable[..., Estimate], *, short: str = "", **look: Any
) -> list[Measure]:
    """Return the rows of both teams, whose estimate takes the team; one population has the first.

    Their texts may name the ``{team}``, the ``{other}`` one, and what it means to ``{win}``.
    """
    rows = []
    for team, key in keys_of(name).items():
        words = WORDS[team]
        rows.append(
            Measure(
                key,
                text.format(**words),
                partial(estimate, team=team),
                short.format(**words),
                alone=team == "pursuers",
                **look,
            )
        )
    return rows


WORDS = {
    "pursuers": {"team": "{pursuers}", "other": "{evaders}", "win": "{capture}"},
    "evaders": {"team": "{evaders}", "other": "{pursuers}", "win": "{escape}"},
}
"""The placeholders of `_of_teams`, filled by those of `Measure`."""


ROWS = (
    # What the judgement rests on, in its window.
    Measure(
        "one_sidedness", "payoff of the winning team", partial(_deciding, of_run=_one_sidedness),
        short="winning team", late=True, bounds=UNIT,
    ),
    Measure(
        "joint_change", "change of the mean of both sides", _joint_change,
        short="mean of both sides", late=True, form="+.3f", general=True, constant=False,
        alone=True, bounds=GAIN,
    ),
    *_of_teams(
        "gain", "gain of the {team}", _gain, short="{team}", late=True, form="+.3f", general=True,
        bounds=GAIN,
    ),
    *_of_teams(
        "change", "change of the {team}", _change, short="{team}", late=True, form="+.3f",
        general=True, bounds=GAIN,
    ),
    Measure(
        "squared_intransitivity", "intransitivity", partial(_deciding, of_run=_intransitivity),
        short="deviation", late=True, squared=True, alone=True,
    ),
    *_of_teams(
        "recurrence", "recurrence of the {team}", partial(_deciding, of_run=_recurrence),
        short="{team}", late=True, form="+.3f", general=True, bounds=GAIN,
    ),
    *_of_teams(
        "squared_interaction", "interaction of the {team}",
        partial(_deciding, of_run=_interaction), short="interaction of the {team}", late=True,
        squared=True, general=True, constant=False,
    ),
    Measure(
        "checkerboards", "checkerboards", partial(_biased, number=_checkerboards),
        late=True, form=".1%", alone=True,
    ),
    *_of_teams(
        "forgetting", "forgetting of the {team}", _forgetting, short="{team}", late=True,
        general=True, bounds=UNIT,
    ),
    # Early generations mix untrained and trained teams.
    Measure(
        "transitive_share", "transitive share",
        partial(
            _of_matrix, number=cycles.transitive_share,
            of_episodes=cycles.transitive_share_over_episodes,
        ),
        late=True, alone=True,
    ),
    # Of the whole race.
    Measure(
        "joint_score", "mean of both sides", _joint_mean, general=True, constant=False, alone=True
    ),
    Measure("capture_rate", "mean {score}", partial(_of_matrix, number=np.mean)),
    Measure(
        "lag_rise", "gain of later over earlier {pursuers}",
        partial(_of_matrix, number=progress.lag_rise, bounds=GAIN),
    ),
    *_of_teams(
        "generalization", "last {team} against all {other}, {win}",
        partial(_of_matrix, number=_last_score), general=True,
    ),
    *_of_teams(
        "lead", "lead of the late {team} over generation 0", _lead_size, form="+.3f", general=True
    ),
    *_of_teams(
        "fading", "CIAO, fading of the {team}",
        partial(_of_matrix, bounds=GAIN, number=partial(_of_triangle, number="fading")),
        general=True,
    ),
    *_of_teams(
        "stripes", "CIAO, stripes of the {team}",
        partial(_biased, number=partial(_of_triangle, number="stripes")), general=True,
    ),
    Measure(
        "game_value", "{score} in the Nash equilibrium",
        partial(_biased, number=games.game_value),
    ),
    *_of_teams("rating", "Elo points of the last {team} above their mean", _rating, form="+.0f"),
)  # fmt: skip
MEASURES = {row.name: row for row in ROWS}
"""All measures by name, in the order of tables."""
