"""The figures of runs and of the game: which there are, what draws each, and into which file.

Matplotlib takes half a second to import, so functions import it when they draw: commands without
figures need not wait.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import nullcontext
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import click
import numpy as np
from numpy.typing import NDArray

from matrixworld.analysis import headline
from matrixworld.cli.runs import run_name
from matrixworld.coevolution import Against, RunDirectory, SavedRun, open_run, open_runs
from matrixworld.coevolution.evaluation.scores import scores_in_race, trained_team
from matrixworld.coevolution.groups import RunGroup
from matrixworld.coevolution.schedules import HallOfFame, curve_window
from matrixworld.coevolution.settings import RaceSettings
from matrixworld.coevolution.types import TEAMS, Payoff, Team

if TYPE_CHECKING:
    from matplotlib.figure import Figure

FORMATS = ("png", "pdf", "svg")
"""As in `matrixworld.plots.style`."""

OF_RUN = (
    "training", "payoff", "generalization", "lag_profile", "collisions", "dynamics", "spinning_top",
)  # fmt: skip
"""Figures of a race. A run of one team has the first one only."""
OF_GROUPS = ("comparison", "seeds", "verdicts", "held_out", "generalization")
"""Figures of several runs: side by side, or over the seeds."""
OF_GAME = {
    "rules": "rules_table",
    "conflicts": "conflict_outcomes",
    "interaction": "interaction_models",
    "right_of_way": "right_of_way",
}
"""Figures of the game, which need no run: the functions of `matrixworld.plots` that draw them."""

Baselines = Mapping[str, Sequence[SavedRun]]
"""Runs of one team by the name of the baseline: one for each seed of the races, or one in all."""
Draw = Callable[[], "Figure"]


@dataclass(frozen=True)
class Selection:
    """Which figures are drawn (all, or the one of this name), in which format, for which width.

    `each`: those of each run, too, beside those of several seeds.
    """

    name: str | None = None
    suffix: str = "png"
    baselines: Baselines = field(default_factory=dict)
    each: bool = False
    width: float | None = None


ALL = Selection()


def planned(groups: Sequence[RunGroup], root: Path, selection: Selection = ALL) -> dict[Path, Draw]:
    """Return the files of the selected figures, each with the function that draws it.

    The figures of a run go into its directory, those of several runs into `root`. Races of several
    seeds have figures of all seeds together in place of those of each run; several races of one
    seed are drawn side by side, too. Names of groups are shown as they are.
    """
    races = [group for group in groups if group.is_race]
    seeds = [group for group in races if group.several]
    names, baselines = _together(races, seeds, selection), selection.baselines
    of_run = selection.name in OF_RUN and selection.name not in names
    alone = groups if selection.each or of_run else [g for g in groups if g not in seeds]
    found: dict[Path, Draw] = {}
    for single in [single for group in alone for single in group.singles]:
        for name in _figures_of(single, selection):
            file = single.runs[0].path / f"{name}.{selection.suffix}"
            found[file] = partial(run_figure, name, single, baselines)
    drawn = {group.name: group for group in seeds or races}
    for name in names:
        file = root / f"{name}.{selection.suffix}"
        found[file] = partial(group_figure, name, drawn, baselines)
    return {file: draw for file, draw in found.items() if selection.name in (None, file.stem)}


def _figures_of(run: RunGroup, selection: Selection) -> tuple[str, ...]:
    if not run.is_race:
        return OF_RUN[:1]
    # A spinning top takes the noise of the episodes: of one there is none, unless it is asked for.
    known = selection.name or (run.payoffs.episodes or 0) > 1
    return OF_RUN if known else OF_RUN[:-1]


def _together(
    races: Sequence[RunGroup], seeds: Sequence[RunGroup], selection: Selection
) -> tuple[str, ...]:
    of_seeds = selection.name == "generalization" or selection.baselines
    if selection.name in OF_GROUPS and selection.name not in OF_RUN:
        return (selection.name,)
    if seeds:
        return ("seeds", "verdicts", "held_out", *(["generalization"] if of_seeds else []))
    return ("comparison",) if len(races) > 1 else ()


def draw(planned: Mapping[Path, Draw], width: float | None = None) -> None:
    """Draw figures into their files, each complete or not at all, perhaps for a width of paper."""
    from matrixworld import plots

    for file, figure in planned.items():
        with nullcontext() if width is None else plots.at_width(width):
            plots.save_figure(figure(), file)


def run_title(path: Path, settings: RaceSettings) -> str:
    """Return the name of a run in figures, with its schedule and its seed."""
    name = run_name(path)
    if settings.is_race and settings.schedule.name != name:
        name = f"{name} ({settings.schedule.name})"
    return f"{name}, seed {settings.seed}"


# What draws them:


def run_figure(name: str, group: RunGroup, baselines: Baselines) -> Figure:
    """Draw a figure of a single run."""
    from matrixworld import plots

    [run] = group.runs

    def title(shown: str) -> str:
        return f"{run_title(run.path, run.settings)}\n{shown}"

    if name == "training":
        return _training(run, title)
    if name == "payoff":
        shown = title(headline(group.judgement))
        return plots.payoff_heatmap(group.payoffs.matrices[0], title=shown)
    if name == "lag_profile":
        return plots.lag_profile_curve(group.payoffs.matrices[0], title=title("Lag profile"))
    if name == "dynamics":
        shown = title("Replicator dynamics of all generations")
        return plots.replicator_trajectories(group.payoffs.matrices[0], title=shown)
    if name == "spinning_top":
        shown = title("Strength and cycles of the generations")
        return plots.spinning_top(run.payoff().capture_rates, title=shown)
    if name == "collisions":
        shown = title("Collisions per 1000 agent-steps")
        return plots.collision_rates(collisions_per_1000(run.payoff()), title=shown)
    scores = baseline_scores(group, baselines)
    return plots.generalization_curves(
        run.payoff().capture_rates,
        per_episode=True,
        pursuer_baselines={name: score for name, [score] in scores["pursuer"].items()},
        evader_baselines={name: score for name, [score] in scores["evader"].items()},
        title=title("Mean score against all opponents"),
    )


def collisions_per_1000(payoff: Payoff) -> NDArray[np.float64]:
    """Return how often agents collide in 1000 agent-steps: (G, 2, 3), by generation, team, kind."""
    collisions, steps = payoff.collisions, payoff.agent_steps[..., np.newaxis]
    # A pursuer generation is a row of the payoff, an evader generation a column.
    pursuers = collisions[:, :, 0].sum(axis=1) / steps[:, :, 0].sum(axis=1)
    evaders = collisions[:, :, 1].sum(axis=0) / steps[:, :, 1].sum(axis=0)
    return 1000 * np.stack([pursuers, evaders], axis=1)


def _training(run: RunDirectory, title: Callable[[str], str]) -> Figure:
    from matrixworld import plots

    log, schedule = run.log(), run.settings.schedule
    rates, learners = log["capture_rate"], log["team"] == "evader"
    window = curve_window(schedule)
    if isinstance(schedule, Against):
        shown = title(f"Capture rate while {schedule.team}s learn")
        return plots.training_curve(rates, learners, window=window, title=shown)
    generations = log["generation"]
    if isinstance(schedule, HallOfFame):
        # Both teams learn from the same matches there, and each logs a row of them: keep one.
        once = ~learners
        shown = title("Capture rate while both teams learn")
        return plots.training_curve(
            rates[once], None, generations=generations[once], window=window, title=shown
        )
    shown = title("Capture rate while pursuers and evaders learn in turn")
    return plots.training_curve(
        rates, learners, generations=generations, window=window, title=shown
    )


def group_figure(name: str, groups: Mapping[str, RunGroup], baselines: Baselines) -> Figure:
    """Draw a figure of several runs, by the names of their groups."""
    from matrixworld import plots

    matrices = {name: group.payoffs.matrices for name, group in groups.items()}
    if name == "comparison":
        singles = {
            f"{name}, seed {single.seeds[0]}": single
            for name, group in groups.items()
            for single in group.singles
        }
        rates = {name: single.runs[0].payoff().capture_rates for name, single in singles.items()}
        each = {name: single.judgement for name, single in singles.items()}
        return plots.comparison(rates, each, per_episode=True)
    if name in ("seeds", "verdicts"):
        judgements = {name: group.judgement for name, group in groups.items()}
        if name == "seeds":
            return plots.seed_bands(matrices, judgements)
        seeds = {name: group.seeds for name, group in groups.items()}
        missing = {name: group.missing for name, group in groups.items()}
        return plots.verdict_strip(judgements, seeds, missing)
    if name == "held_out":
        return plots.seed_scores(
            {name: {team: each.held_out(team) for team in TEAMS} for name, each in groups.items()}
        )
    scores = {name: baseline_scores(group, baselines) for name, group in groups.items()}
    return plots.generalization_over_seeds(
        matrices,
        pursuer_baselines={name: each["pursuer"] for name, each in scores.items()},
        evader_baselines={name: each["evader"] for name, each in scores.items()},
    )


def game_figure(name: str) -> Figure:
    """Return a figure that needs no run."""
    from matrixworld import plots

    try:
        figure: Figure = getattr(plots, OF_GAME[name])()
    except ValueError as error:  # its texts need more than the width of --width
        raise click.UsageError(f"--{error}") from error
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
    opened = {}
    for name, path in baselines.items():
        try:
            opened[name] = open_runs(path)
            teams = {trained_team(run)[0] for run in opened[name]}
        except (FileNotFoundError, ValueError) as error:
            raise click.UsageError(f"--baseline {name}: {error}") from error
        if len(teams) != 1:
            got = "runs of both" if teams else "no finished run"
            raise click.UsageError(
                f"--baseline {name}: expected finished runs of one team, got {got} in {path}"
            )
    return opened


def baseline_scores(group: RunGroup, baselines: Baselines) -> dict[Team, dict[str, list[float]]]:
    """Return the mean score of each baseline against all opponents of each race of a group."""
    scores: dict[Team, dict[str, list[float]]] = {team: {} for team in TEAMS}
    races = [open_run(run.path) for run in group.runs] if baselines else []
    for name, runs in baselines.items():
        trained = [trained_team(_of_seed(name, runs, race.settings.seed)) for race in races]
        means = [
            float(scores_in_race(race, team, champion).mean())
            for race, (team, champion) in zip(races, trained, strict=True)
        ]
        # One run for all seeds tells nothing about other runs: its mean has no interval.
        scores[trained[0][0]][name] = means if len(runs) > 1 else [sum(means) / len(means)]
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
