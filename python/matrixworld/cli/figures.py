"""The figures of runs and of the game: which there are, what draws each, and into which file.

Matplotlib takes half a second to import, so each function imports it when it draws: commands
without figures need not wait.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import click
import numpy as np
from numpy.typing import NDArray

from matrixworld.analysis import headline
from matrixworld.cli.arguments import run_name
from matrixworld.cli.groups import Group, Result
from matrixworld.cli.score import play_held_out
from matrixworld.cli.tables import held_out
from matrixworld.coevolution import Against, SavedRun, open_run, open_runs
from matrixworld.coevolution.evaluation.scores import scores_in_race, trained_team
from matrixworld.coevolution.payoff import Payoff
from matrixworld.coevolution.schedules import HallOfFame
from matrixworld.coevolution.settings import RaceSettings
from matrixworld.coevolution.storage.saved_run import run_directories
from matrixworld.coevolution.types import TEAMS, Team

if TYPE_CHECKING:
    from matplotlib.figure import Figure

WINDOWS = 4
"""Windows of the moving average of a training curve in the shorter team phase of a generation."""
LONGEST = 100
"""Windows of the moving average in the run of one team alone."""
FORMATS = ("png", "pdf", "svg")
"""As in `matrixworld.plots.style`."""

Baselines = Mapping[str, Sequence[SavedRun]]
"""Runs of one team by the name of the baseline: one for each seed of the races, or one in all."""
Draw = Callable[[], "Figure"]


@dataclass(frozen=True)
class Selection:
    """Which figures are drawn (all, or the one of this name), and in which format.

    `each`: those of each run, too, beside those of several seeds.
    """

    name: str | None = None
    suffix: str = "png"
    baselines: Baselines = field(default_factory=dict)
    each: bool = False


ALL = Selection()


def planned(groups: Sequence[Group], root: Path, selection: Selection = ALL) -> dict[Path, Draw]:
    """Return the files of the selected figures, each with the function that draws it.

    The figures of a run go into its directory, those of several runs into `root`. Races of several
    seeds have figures of all seeds together in place of those of each run; several races of one
    seed are drawn side by side, too. Names of groups are shown as they are.
    """
    races = [group for group in groups if group.is_race]
    seeds = [group for group in races if group.several]
    names = _together(races, seeds, selection)
    of_run = selection.name in OF_RUN and selection.name not in names
    alone = groups if selection.each or of_run else [g for g in groups if g not in seeds]
    found: dict[Path, Draw] = {}
    for single in [single for group in alone for single in group.singles]:
        for name in [*OF_RUN] if single.is_race else [*OF_RUN][:1]:
            file = single.runs[0].path / f"{name}.{selection.suffix}"
            found[file] = partial(OF_RUN[name], single, selection.baselines)
    drawn = {group.name: group for group in seeds or races}
    for name in names:
        found[root / f"{name}.{selection.suffix}"] = partial(
            OF_GROUPS[name], drawn, selection.baselines
        )
    return {file: draw for file, draw in found.items() if selection.name in (None, file.stem)}


def _together(
    races: Sequence[Group], seeds: Sequence[Group], selection: Selection
) -> tuple[str, ...]:
    """Return the names of the figures that show several runs."""
    of_seeds = selection.name == "generalization" or selection.baselines
    if selection.name is not None and selection.name in {*OF_GROUPS} - {*OF_RUN}:
        return (selection.name,)
    if seeds:
        return ("seeds", "verdicts", "held_out", *(["generalization"] if of_seeds else []))
    return ("comparison",) if len(races) > 1 else ()


def draw(planned: Mapping[Path, Draw]) -> None:
    """Draw figures into their files, each complete or not at all."""
    from matrixworld import plots

    for file, figure in planned.items():
        plots.save_figure(figure(), file)


def format_of(option: str, file: Path) -> str:
    """Return the format of a figure's file by its suffix; click.UsageError for another one."""
    from matrixworld.plots import style

    try:
        return style.format_of(file)
    except ValueError as error:
        raise click.UsageError(f"{option}: {error}") from error


def run_title(path: Path, settings: RaceSettings) -> str:
    """Return the name of a run in figures, with its schedule and its seed."""
    name = run_name(path)
    if settings.is_race and settings.schedule.name != name:
        name = f"{name} ({settings.schedule.name})"
    return f"{name}, seed {settings.seed}"


# Figures of a run:


def _title(group: Group, shown: str) -> str:
    """Return the title of a figure: which run, and what the figure shows."""
    [run] = group.runs
    return f"{run_title(run.path, run.settings)}\n{shown}"


def _payoff(group: Group, baselines: Baselines) -> Figure:
    from matrixworld import plots

    title = _title(group, headline(group.judgement))
    return plots.payoff_heatmap(group.payoffs.matrices[0], title=title)


def _generalization(group: Group, baselines: Baselines) -> Figure:
    from matrixworld import plots

    [run] = group.runs
    scores = baseline_scores(run, baselines)
    return plots.generalization_curves(
        run.payoff.capture_rates,
        per_episode=True,
        pursuer_baselines=scores["pursuer"],
        evader_baselines=scores["evader"],
        title=_title(group, "Mean score against all opponents"),
    )


def _lag_profile(group: Group, baselines: Baselines) -> Figure:
    from matrixworld import plots

    return plots.lag_profile_curve(group.payoffs.matrices[0], title=_title(group, "Lag profile"))


def _collisions(group: Group, baselines: Baselines) -> Figure:
    from matrixworld import plots

    title = _title(group, "Collisions per 1000 agent-steps")
    return plots.collision_rates(collisions_per_1000(group.runs[0].payoff), title=title)


def collisions_per_1000(payoff: Payoff) -> NDArray[np.float64]:
    """Return how often agents collide in 1000 agent-steps: (G, 2, 3), by generation, team, kind."""
    collisions, steps = payoff.collisions, payoff.agent_steps[..., np.newaxis]
    # A pursuer generation is a row of the payoff, an evader generation a column.
    pursuers = collisions[:, :, 0].sum(axis=1) / steps[:, :, 0].sum(axis=1)
    evaders = collisions[:, :, 1].sum(axis=0) / steps[:, :, 1].sum(axis=0)
    return 1000 * np.stack([pursuers, evaders], axis=1)


def _training(group: Group, baselines: Baselines) -> Figure:
    from matrixworld import plots

    [run] = group.runs
    log, settings = run.files.log(), run.settings
    rates, learners = log["capture_rate"], log["team"] == "evader"
    schedule = settings.schedule
    if isinstance(schedule, Against):
        title = _title(group, f"Capture rate while {schedule.team}s learn")
        window = max(1, schedule.epochs // LONGEST)
        return plots.training_curve(rates, learners, window=window, title=title)
    # The same window for both teams, so it must fit into the shorter team phase.
    window = max(1, min(schedule.epochs(team) for team in TEAMS) // WINDOWS)
    generations = log["generation"]
    if isinstance(schedule, HallOfFame):
        # Both teams learn from the same matches there, and each logs a row of them: keep one.
        once = ~learners
        title = _title(group, "Capture rate while both teams learn")
        return plots.training_curve(
            rates[once], None, generations=generations[once], window=window, title=title
        )
    title = _title(group, "Capture rate while pursuers and evaders learn in turn")
    return plots.training_curve(
        rates, learners, generations=generations, window=window, title=title
    )


OF_RUN: Mapping[str, Callable[[Group, Baselines], Figure]] = {
    "training": _training,
    "payoff": _payoff,
    "generalization": _generalization,
    "lag_profile": _lag_profile,
    "collisions": _collisions,
}
"""Figures of a race. A run of one team has the first one only."""


# Figures of several runs:


def _comparison(groups: Mapping[str, Group], baselines: Baselines) -> Figure:
    from matrixworld import plots

    named = {
        f"{name}, seed {single.seeds[0]}": single
        for name, group in groups.items()
        for single in group.singles
    }
    payoffs = {name: single.runs[0].payoff.capture_rates for name, single in named.items()}
    judgements = {name: single.judgement for name, single in named.items()}
    return plots.comparison(payoffs, judgements, per_episode=True)


def _seeds(groups: Mapping[str, Group], baselines: Baselines) -> Figure:
    from matrixworld import plots

    return plots.seed_bands(
        {name: group.payoffs.matrices for name, group in groups.items()},
        {name: group.judgement for name, group in groups.items()},
    )


def _verdicts(groups: Mapping[str, Group], baselines: Baselines) -> Figure:
    from matrixworld import plots

    return plots.verdict_strip(
        {name: group.judgement for name, group in groups.items()},
        {name: group.seeds for name, group in groups.items()},
        {name: group.missing for name, group in groups.items()},
    )


def _held_out(groups: Mapping[str, Group], baselines: Baselines) -> Figure:
    from matrixworld import plots

    play_held_out([run for group in groups.values() for run in group.runs], None)
    return plots.seed_scores(
        {name: {team: held_out(group, team) for team in TEAMS} for name, group in groups.items()}
    )


def _generalization_over_seeds(groups: Mapping[str, Group], baselines: Baselines) -> Figure:
    from matrixworld import plots

    scores = {name: _over_seeds(group, baselines) for name, group in groups.items()}
    return plots.generalization_over_seeds(
        {name: group.payoffs.matrices for name, group in groups.items()},
        pursuer_baselines={name: each["pursuer"] for name, each in scores.items()},
        evader_baselines={name: each["evader"] for name, each in scores.items()},
    )


OF_GROUPS: Mapping[str, Callable[[Mapping[str, Group], Baselines], Figure]] = {
    "comparison": _comparison,
    "seeds": _seeds,
    "verdicts": _verdicts,
    "held_out": _held_out,
    "generalization": _generalization_over_seeds,
}
"""Figures of several runs: side by side, or over the seeds."""

OF_GAME = {
    "rules": "rules_table",
    "conflicts": "conflict_outcomes",
    "interaction": "interaction_models",
}
"""Figures of the game, which need no run: the functions of `matrixworld.plots` that draw them."""


def game_figure(name: str) -> Figure:
    """Return a figure that needs no run."""
    from matrixworld import plots

    figure: Figure = getattr(plots, OF_GAME[name])()
    return figure


# Baselines: teams that were trained in another way, against the races' opponents


def _parsed(ctx: click.Context, param: click.Parameter, values: Sequence[str]) -> dict[str, Path]:
    named: dict[str, Path] = {}
    for value in values:
        name, separator, path = value.partition("=")
        if not (name and separator and path):
            raise click.BadParameter(f"expected NAME=RUN, got {value!r}")
        if name in named:
            raise click.BadParameter(f"expected each name once, got {name!r} twice")
        named[name] = Path(path)
    return named


baseline_option = click.option(
    "--baseline",
    "baselines",
    multiple=True,
    callback=_parsed,
    metavar="NAME=RUN",
    help="a team that was trained in another way (evolve --schedule against): its last generation "
    "plays against the race's opponents, and is a level line in the figure of generalization. RUN "
    "may hold a run for each seed of the races. May be repeated",
)


def open_baselines(baselines: Mapping[str, Path]) -> dict[str, list[SavedRun]]:
    """Return the runs of each baseline; click.UsageError if one is no run of one team."""
    for name, path in baselines.items():
        if not run_directories(path):
            raise click.UsageError(
                f"--baseline {name}: expected a directory that holds runs: {path}"
            )
    opened = {name: open_runs(path) for name, path in baselines.items()}
    for name, runs in opened.items():
        if not runs:
            raise click.UsageError(f"--baseline: expected a finished run, got {baselines[name]}")
        try:
            teams = {trained_team(run)[0] for run in runs}
        except ValueError as error:
            raise click.UsageError(f"--baseline: {error}") from error
        if len(teams) > 1:
            raise click.UsageError(
                f"--baseline: expected runs of one team, got both teams in {baselines[name]}"
            )
    return opened


def baseline_scores(race: Result, baselines: Baselines) -> dict[Team, dict[str, float]]:
    """Return the mean score of each baseline against all opponents of a race."""
    scores: dict[Team, dict[str, float]] = {team: {} for team in TEAMS}
    if not baselines:
        return scores
    opponents = open_run(race.path)
    for name, runs in baselines.items():
        team, champion = trained_team(_of_seed(name, runs, race.settings.seed))
        scores[team][name] = float(scores_in_race(opponents, team, champion).mean())
    return scores


def _of_seed(name: str, runs: Sequence[SavedRun], seed: int) -> SavedRun:
    """Return the run with the seed of the race; the only one, if there is only one."""
    if len(runs) == 1:
        return runs[0]
    found = [run for run in runs if run.settings.seed == seed]
    if len(found) != 1:
        raise click.UsageError(
            f"--baseline {name}: expected one run of seed {seed}, or one in all, got {len(found)}"
        )
    return found[0]


def _over_seeds(group: Group, baselines: Baselines) -> dict[Team, dict[str, list[float]]]:
    """Return the score of each baseline for each seed of a group, by team and name."""
    seeds = [baseline_scores(run, baselines) for run in group.runs]
    scores: dict[Team, dict[str, list[float]]] = {}
    for team in TEAMS:
        scores[team] = {name: [seed[team][name] for seed in seeds] for name in seeds[0][team]}
        for name, values in scores[team].items():
            # One run for all seeds tells nothing about other runs: its mean has no interval.
            if len(baselines[name]) == 1:
                scores[team][name] = [sum(values) / len(values)]
    return scores
