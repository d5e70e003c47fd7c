"""Figures of generalization: mean scores against all opponents, of one run and over seeds."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import ArrayLike

from matrixworld import analysis
from matrixworld._util import colors
from matrixworld.analysis.intervals import Band, generalization_over_episodes
from matrixworld.analysis.payoffs import Rates, check_payoff, check_rates
from matrixworld.analysis.runs import race_bands
from matrixworld.plots import style

Baselines = Mapping[str, Mapping[str, ArrayLike]]
"""Scores (seeds,) of teams that were trained in another way, by race and by their name."""

TEAMS = ("pursuer", "evader")
SCORES = ("pursuers (score: capture rate)", "evaders (score: 1 - capture rate)")
OVER_SEEDS = "95% interval of the mean over seeds"


def generalization_curves(
    payoff: ArrayLike,
    *,
    per_episode: bool = False,
    pursuer_baselines: Mapping[str, float] | None = None,
    evader_baselines: Mapping[str, float] | None = None,
    title: str = "Generalization: mean score against all opponents",
) -> Figure:
    """Draw the mean score of each generation against all opponents.

    The score of pursuers is the capture rate, that of evaders is 1 minus the capture rate.

    Parameters
    ----------
    payoff : array_like of float, shape (n, m) or (n, m, episodes)
    per_episode : bool, optional
        Whether the capture rates are those of single episodes. If there are several of each pair,
        a band shows the 95% interval over episodes of each score.
    pursuer_baselines, evader_baselines : mapping of str to float, optional
        Mean scores in [0, 1] of teams that were trained in another way, against the same opponents.
        Each is drawn as a level line with its name.
    title : str, optional
    """
    figure = style.new_figure(6.4, 4.2)
    axes = figure.add_subplot()
    draw_generalization(axes, payoff, per_episode)
    teams = [
        {name: [score] for name, score in baselines.items()}
        for baselines in (pursuer_baselines or {}, evader_baselines or {})
    ]
    _draw_baselines(axes, teams)
    axes.set_title(style.fitting(figure, title))
    style.legend_below(figure, style.labelled(axes))
    return figure


def generalization_over_seeds(
    payoffs: Mapping[str, Iterable[ArrayLike]],
    *,
    pursuer_baselines: Baselines | None = None,
    evader_baselines: Baselines | None = None,
    title: str = "Generalization: mean score against all opponents",
) -> Figure:
    """Draw the mean score of each generation against all opponents, with 95% intervals over seeds.

    Parameters
    ----------
    payoffs : mapping of str to iterable of array_like of float, shape (n, m)
        Payoff matrix of each seed, by the name of the race, such as its schedule. Each name has a
        panel.
    pursuer_baselines, evader_baselines : mapping of str to mapping of str to array_like, optional
        As for `generalization_curves`, for the races named in `payoffs`: scores of each seed. Each
        is a level line at its mean, and a band for its interval.
    title : str, optional
    """
    style.check_some(payoffs, "race")
    baselines = (pursuer_baselines or {}, evader_baselines or {})
    for name in [name for team in baselines for name in team if name not in payoffs]:
        raise ValueError(f"baselines: expected names of {', '.join(payoffs)}, got {name!r}")
    figure = style.new_figure(max(5.6, 1.0 + 3.6 * len(payoffs)), 4.4)
    lines, columns = style.rows_of(len(payoffs), style.beside(len(payoffs)))
    panels = figure.subplots(lines, columns, sharey=True, squeeze=False).ravel()
    for axes in panels[len(payoffs) :]:
        axes.remove()
    for axes, (name, matrices) in zip(panels, payoffs.items(), strict=False):
        bands = race_bands(matrices)
        draw_teams(axes, (bands[f"{team}_generalization"] for team in TEAMS), OVER_SEEDS)
        style.unit_axis(axes)
        _draw_baselines(axes, [team.get(name, {}) for team in baselines])
        axes.set_title(
            style.wrapped(name, style.room(figure, columns, 1.2)), size="medium", fontweight="bold"
        )
    for axes in panels[::columns]:
        axes.set_ylabel("mean score (0 to 1)")
    style.legend_below(figure, style.labelled(*panels[: len(payoffs)]))
    figure.suptitle(style.fitting(figure, title))
    return figure


def _draw_baselines(axes: Axes, teams: Sequence[Mapping[str, ArrayLike]]) -> None:
    """Draw the levels of both teams, each with dashes of its own: in grey colours are equal."""
    of_teams = zip(teams, colors.TEAMS, strict=True)
    each = [(name, scores, color) for team, color in of_teams for name, scores in team.items()]
    for index, (name, scores, color) in enumerate(each):
        values = check_rates(scores, ndim=1, what=f"baseline {name!r}")
        level = analysis.interval_over_runs(values, bounds=(0.0, 1.0))
        dashes = style.LEVELS[index % len(style.LEVELS)]
        axes.axhline(level.value, color=color, linestyle=dashes, linewidth=1.3, label=name)
        if level.low is not None and level.high is not None:
            axes.axhspan(level.low, level.high, color=color, alpha=0.1, linewidth=0)


def mean_of(payoff: ArrayLike, per_episode: bool) -> Rates:
    """Return the checked payoff matrix of a race, from capture rates of its episodes if given."""
    if not per_episode:
        return check_payoff(payoff)
    # In float64: the sum of many float32 rates would round.
    return check_payoff(np.asarray(payoff).mean(axis=2, dtype=np.float64))


def draw_generalization(axes: Axes, payoff: ArrayLike, per_episode: bool) -> None:
    """Draw the mean scores of both teams, with bands over episodes if they are known."""
    curves = analysis.generalization(mean_of(payoff, per_episode))
    bands = [analysis.band_over_runs([curve]) for curve in curves]
    if per_episode and np.shape(payoff)[2] >= 2:
        bands = [*generalization_over_episodes(payoff)]
    draw_teams(axes, bands, "95% interval over episodes")
    axes.set_ylabel("mean score")
    style.unit_axis(axes)


def draw_teams(axes: Axes, bands: Iterable[Band], interval: str) -> None:
    """Draw the curves of both teams, evaders dashed, and the intervals if they have some."""
    looks = zip(bands, colors.TEAMS, ("-", style.EVADERS), SCORES, strict=True)
    for band, color, line, label in looks:
        style.draw_band(axes, band, color, line, label=label)
    if band.low is not None:
        # An empty band for the legend, whose entry is of both teams.
        axes.fill_between([], [], [], color=colors.MUTED, alpha=0.22, linewidth=0, label=interval)
    axes.set_xlabel("generation")
    axes.xaxis.set_major_locator(style.whole_numbers())
    axes.margins(x=0.02)
