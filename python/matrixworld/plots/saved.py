"""The figures of saved runs: which there are, what draws each, and into which file.

``figures_of(open_groups("my-races"), "my-races")`` returns those of a job.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from itertools import combinations
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from matrixworld._util.checks import check_choice
from matrixworld._util.teams import PLURALS
from matrixworld.analysis import Estimate, Judgement
from matrixworld.analysis.intervals import UNIT, level_of_each
from matrixworld.coevolution.comparison import compare, score_name
from matrixworld.coevolution.games.own_game import OwnGame
from matrixworld.coevolution.groups import RunGroup
from matrixworld.coevolution.settings.schedules import Against
from matrixworld.coevolution.types import TEAMS
from matrixworld.plots import race as of_race
from matrixworld.plots import style
from matrixworld.plots.runs import differences, run_dots, verdict_strip


def figures_of(
    groups: Sequence[RunGroup],
    root: str | Path,
    *,
    suffix: str = "png",
    each: bool = False,
    column: bool = False,
) -> dict[Path, Callable[[], Figure]]:
    """Return the files of the figures of runs, each with the function that draws it.

    Figures of a run go into its directory, those of several runs into `root`. Seeds of a race are
    drawn together, and with `each` alone, too. In a `column` of a paper figures are 3.4 inches
    wide; races side by side take both columns.
    """
    check_choice("suffix", suffix, style.FORMATS)
    races = [group for group in groups if group.is_race]
    seeds = [group for group in races if group.several]
    together = ["comparison"] if len(races) > 1 or seeds else []
    if seeds:
        own_games = any(isinstance(group.runs[0].settings.game, OwnGame) for group in groups)
        together += ["verdicts", *([] if own_games else ["held_out"])]
        if len(seeds) > 1 and not own_games and _in_one_world(seeds):
            together.append("differences")
    found: dict[Path, Callable[[], Figure]] = {}
    alone = [group for group in groups if each or group not in seeds]
    for single in [single for group in alone for single in group.singles]:
        for figure, draw in OF_RUN.items():
            # A run of one team alone has the curve of its training only.
            own_game = isinstance(single.runs[0].settings.game, OwnGame)
            missing = figure in OF_PURSUIT and own_game
            if (single.is_race and not missing) or figure == "training":
                found[single.runs[0].path / f"{figure}.{suffix}"] = partial(draw, single)
    drawn = {group.name: group for group in seeds or races}
    for figure in together:
        found[Path(root) / f"{figure}.{suffix}"] = partial(OF_GROUPS[figure], drawn)
    return {file: partial(_in_column, draw) for file, draw in found.items()} if column else found


def _in_one_world(groups: Sequence[RunGroup]) -> bool:
    """Return whether scores of groups can be compared."""
    return len({group.runs[0].pursuit.world for group in groups if group.runs}) == 1


def _in_column(draw: Callable[[], Figure]) -> Figure:
    with style.column():
        figure = draw()
        figure.draw_without_rendering()  # ticks take the size of type when they are drawn first
    return figure


def _title(group: RunGroup, shown: str) -> str:
    return f"{group.runs[0].title}\n{shown}"


def _training(group: RunGroup) -> Figure:
    [run] = group.runs
    log = run.log()
    schedule = run.settings.schedule
    teams = run.settings.teams
    first, second = run.settings.keys
    evaders = (log["team"] == second) & (first != second)
    score, *_ = run.settings.game.known.columns
    learning: NDArray[np.bool_] | None = evaders
    generations: NDArray[np.int64] | None = log["generation"]
    kept = np.ones(len(evaders), bool)
    shown = f"{' and '.join(teams)} learn in turn"
    if isinstance(schedule, Against):
        shown = f"{teams[TEAMS.index(schedule.team)]} learn"
        generations = None
    elif first == second:
        shown = f"{first} learn"
        learning = None
    elif schedule.at_once:
        # Both teams learn from the same matches there, and each logs a row of them: keep one.
        shown = "both teams learn"
        learning = None
        kept = ~evaders
    return of_race.training_curve(
        log[score][kept],
        learning,
        generations=None if generations is None else generations[kept],
        window=schedule.curve_window,
        teams=teams,
        title=_title(group, style.words_of(teams).begin(f" while {shown}")),
    )


def _teams(*groups: RunGroup) -> tuple[str, str]:
    """Return what the game of runs calls its teams, of several games what fits all."""
    found = {group.runs[0].settings.teams for group in groups}
    return found.pop() if len(found) == 1 else ("first teams", "second teams")


def collisions_per_1000(group: RunGroup) -> NDArray[np.float64]:
    """Return how often agents collide in 1000 agent-steps: (G, 2, 3), by generation, team, kind."""
    payoff = group.runs[0].payoff()
    collisions, steps = (payoff.extras[name] for name in ("collisions", "agent_steps"))
    steps = steps[..., np.newaxis]
    # A pursuer generation is a row of the payoff, an evader generation a column.
    pursuers = collisions[:, :, 0].sum(axis=1) / steps[:, :, 0].sum(axis=1)
    evaders = collisions[:, :, 1].sum(axis=0) / steps[:, :, 1].sum(axis=0)
    return 1000 * np.stack([pursuers, evaders], axis=1)


def _collisions(group: RunGroup) -> Figure:
    title = _title(group, "Collisions per 1000 agent-steps")
    return of_race.collision_rates(collisions_per_1000(group), title=title)


def _payoff(group: RunGroup) -> Figure:
    return _comparison({group.runs[0].title: group})


OF_RUN: dict[str, Callable[[RunGroup], Figure]] = {
    "training": _training,
    "payoff": _payoff,
    "collisions": _collisions,
}
"""Figures of a race. A run of one team has the first one only."""
OF_PURSUIT = ("collisions", "held_out", "differences")  # figures that games of your own have not


Groups = Mapping[str, RunGroup]


def _comparison(groups: Groups) -> Figure:
    teams = _teams(*groups.values())
    payoffs = {name: group.payoffs for name, group in groups.items()}
    return of_race.comparison(payoffs, _judgements(groups), teams=teams)


def _verdicts(groups: Groups) -> Figure:
    return verdict_strip(
        _judgements(groups),
        {name: group.seeds for name, group in groups.items()},
        {name: group.missing for name, group in groups.items()},
    )


def _held_out(groups: Groups) -> Figure:
    scores = {
        f"{name}, {PLURALS[team]}": group.held_out(team).mean(axis=1)
        for name, group in groups.items()
        for team in TEAMS
    }
    label = "score of the last generation against held-out opponents"
    return run_dots(scores, label=label, bounds=UNIT)


def _differences(groups: Groups) -> Figure:
    """Draw how the scores of each two groups differ; all intervals hold together."""
    pairs = [*combinations(groups.items(), 2)]
    level = level_of_each(len(pairs) * len(TEAMS))
    found: dict[str, dict[str, Estimate]] = {PLURALS[team]: {} for team in TEAMS}
    singles: dict[str, dict[str, NDArray[np.float64]]] = {PLURALS[team]: {} for team in TEAMS}
    for (first, one), (second, other) in pairs:
        compared = compare(one, other, level=level)
        name = f"{first} minus {second}"
        for team in TEAMS:
            found[PLURALS[team]][name] = compared.differences[score_name(team)]
            if one.seeds == other.seeds:
                pair = [group.held_out(team).mean(axis=1) for group in (one, other)]
                singles[PLURALS[team]][name] = pair[0] - pair[1]
    return differences(
        found,
        label="difference of scores of last generations against held-out opponents",
        singles=singles,
        interval="95% interval, all together",
    )


def _judgements(groups: Groups) -> dict[str, Judgement]:
    return {name: group.judgement for name, group in groups.items()}


OF_GROUPS: dict[str, Callable[[Groups], Figure]] = {
    "comparison": _comparison,
    "verdicts": _verdicts,
    "held_out": _held_out,
    "differences": _differences,
}
"""Figures of several runs: side by side, or over the seeds."""
