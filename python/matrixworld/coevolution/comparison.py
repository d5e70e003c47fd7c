"""Judgements of groups of runs, and what tells two groups from each other."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any, TypeAlias

import numpy as np

from matrixworld import analysis
from matrixworld._util.readable import Parts, Readable
from matrixworld._util.teams import PLURALS
from matrixworld.analysis import Estimate, Judgement, intervals
from matrixworld.analysis.judgement import CANNOT_TELL
from matrixworld.analysis.payoffs import Payoffs
from matrixworld.coevolution.evaluation.scores import SCORE, score
from matrixworld.coevolution.games.game import GameSettings
from matrixworld.coevolution.games.own_game import OwnGame
from matrixworld.coevolution.games.pursuit import PursuitSettings
from matrixworld.coevolution.groups import RunGroup, group_of
from matrixworld.coevolution.types import FloatArray, Team

Pair: TypeAlias = tuple[FloatArray, FloatArray]
"""Values of two groups that are compared, each of its runs or episodes."""


def judge(source: Any, **known: Any) -> Judgement:
    """Judge a race, or several with the same settings; see `analysis.judge`.

    Parameters
    ----------
    source : SavedRun, list of SavedRun, RunGroup, str or Path, or payoffs
        Finished runs that differ in their seed only, or a directory that holds such runs; or
        payoffs as `analysis.judge` takes them.
    **known
        Other arguments of `analysis.judge`, for payoffs.

    Returns
    -------
    Judgement
        What happened in the races.

    Raises
    ------
    ValueError
        If runs differ in more than their seed, or none is finished.
    """
    group = group_of("source", source)
    return analysis.judge(source if group is None else group.payoffs, **known)


@dataclass(frozen=True, repr=False)
class Comparison(Readable):
    """What tells one group of runs from another one: `means` of both, and their `differences`."""

    means: dict[str, tuple[float, float]]
    differences: dict[str, Estimate]

    def verdict(self, name: str) -> str:
        """Return "higher" or "lower", as the first group is, or "cannot tell"."""
        return (CANNOT_TELL, "higher", "lower")[self.differences[name].sign]

    def _parts(self) -> Parts:
        rows = []
        for name, difference in self.differences.items():
            first, second = (f"{mean:.3f}" for mean in self.means[name])
            rows.append((name, first, second, str(difference), self.verdict(name)))
        return [[("", "first", "second", "difference", ""), *rows]]


def compare(one: Any, other: Any, *, level: float = intervals.LEVEL) -> Comparison:
    """Compare two groups of runs, or two runs, or the payoffs of any races.

    Teams are compared by the scores of their last generations against held-out opponents, races by
    the measures that a judgement rests on. Groups with the same seeds are compared pair by pair.
    Two single runs have scores only, with intervals over episodes, not over seeds.

    Parameters
    ----------
    one, other
        As `source` of `judge`; payoffs have no scores.
    level : float, optional
        Level of each interval, in (0, 1); who asks many questions takes a higher one.

    Returns
    -------
    Comparison
        Means of both groups, and their differences.

    Raises
    ------
    ValueError
        If the worlds of the runs differ: scores are of a world.
    """
    groups = [group_of("one", one), group_of("other", other)]
    of_runs = [group for group in groups if group is not None]
    scores = _compared_scores(*of_runs) if len(of_runs) == 2 else {}
    if scores and not any(group.several for group in of_runs):
        return _comparison(scores, intervals.difference_over_episodes, level)
    measures: dict[str, Pair] = {}
    if all(group.is_race for group in of_runs):
        first, second = (
            analysis.read_payoffs(source) if group is None else group.payoffs
            for group, source in zip(groups, (one, other), strict=True)
        )
        measures = _compared_measures(first, second)
    paired = len(of_runs) == 2 and of_runs[0].seeds == of_runs[1].seeds
    difference = partial(analysis.difference_of_runs, paired=paired)
    return _comparison(scores | measures, difference, level)


def score_name(team: Team) -> str:
    """Return what a comparison calls the scores of a team."""
    return f"{PLURALS[team]} against held-out opponents, {SCORE[team]}"


def _compared_scores(one: RunGroup, other: RunGroup) -> dict[str, Pair]:
    """Return the scores of the teams of two groups by what they are called.

    They are those of runs, or of the episodes of two single runs.
    """
    first = one.runs[0].settings
    second = other.runs[0].settings
    if _place(first.game) != _place(second.game):
        raise ValueError("other: expected runs in the same world or game as one, got another")
    if isinstance(first.game, OwnGame):
        return {}
    scores_of = _by_run if one.several or other.several else _by_episode
    scores = {}
    if not set(first.learning_teams) & set(second.learning_teams):
        raise ValueError("other: expected runs in which the same team learns as in one")
    for team in first.learning_teams:
        if team in second.learning_teams:
            scores[score_name(team)] = (scores_of(one, team), scores_of(other, team))
    return scores


def _place(game: GameSettings) -> Any:
    """Return where teams play: a world, or a game of one's own."""
    return game.world if isinstance(game, PursuitSettings) else game


def _by_run(group: RunGroup, team: Team) -> FloatArray:
    """Return the mean score (runs,) of the last generation of a team in each run."""
    return np.asarray(group.held_out(team).mean(axis=1))


def _by_episode(group: RunGroup, team: Team) -> FloatArray:
    """Return the mean score (episodes,) of the last generation of a team of a single run."""
    [run] = group.runs
    return np.asarray(score(run)[team].rates[-1].mean(axis=0))


def _compared_measures(one: Payoffs, other: Payoffs) -> dict[str, Pair]:
    """Return the measures that a judgement rests on, of each run, where all are known."""
    measures = {}
    for measure in analysis.MEASURES.values():
        if not measure.short or not (measure.has_meaning(one) and measure.has_meaning(other)):
            continue
        first = np.array([measure.of(run).value for run in one.runs])
        second = np.array([measure.of(run).value for run in other.runs])
        if np.isfinite(first).all() and np.isfinite(second).all():
            measures[measure.label(one.teams)] = (first, second)
    return measures


def _comparison(
    values: Mapping[str, Pair], difference: Callable[..., Estimate], level: float
) -> Comparison:
    """Return the means of two groups and their differences, of values by name."""
    means = {}
    differences = {}
    for name, (one, other) in values.items():
        means[name] = (float(one.mean()), float(other.mean()))
        differences[name] = difference(one, other, level=level)
    return Comparison(means, differences)
