"""``matrixworld score``: teams of runs against held-out opponents."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import click

from matrixworld._util.readable import plain_values
from matrixworld._util.teams import PLURALS
from matrixworld.analysis import intervals
from matrixworld.cli import cluster, console, options
from matrixworld.cli.setting_options import usage_errors
from matrixworld.coevolution import ProgressBar, RunGroup, Team
from matrixworld.coevolution.evaluation.held_out import HELD_OUT_VERSION
from matrixworld.coevolution.evaluation.scores import (
    HeldOutScores,
    best_scripts,
    estimates_of,
    met_in_training,
    score_runs,
    score_table,
)
from matrixworld.coevolution.games.pursuit import PursuitSettings
from matrixworld.world.config import WorldConfig

ALL = "all"
LEGEND = (
    "In brackets: 95% interval over the episodes. Runs with other seeds may differ by more. In the "
    "mean every opponent has the same weight."
)
SEEDS_LEGEND = (
    "In brackets: 95% interval of the mean over seeds. In the mean every opponent has the same "
    f"weight. The interval of an interquartile mean takes {intervals.fewest_runs()} seeds."
)

Scores = Sequence[Mapping[Team, HeldOutScores]]
"""Scores by team, of each run of a group."""


class GroupScores(NamedTuple):
    """Scores of a group in its own world, and in the worlds of its training if it has any."""

    group: RunGroup
    scores: Scores
    in_worlds: Sequence[tuple[WorldConfig, Scores]]

    @property
    def matches(self) -> int:
        """How many matches were played."""
        parts = [self.scores, *(scores for _, scores in self.in_worlds)]
        return sum(map(_matches, parts))


def _matches(scores: Scores) -> int:
    return sum(of_team.matches for of_run in scores for of_team in of_run.values())


def _generation(ctx: click.Context, param: click.Parameter, value: str) -> int | None:
    try:
        return None if value == ALL else int(value)
    except ValueError:
        raise click.BadParameter(f"expected a generation or {ALL}, got {value!r}") from None


@click.command("score")
@options.runs()
@click.option(
    "--generation",
    default="-1",
    callback=_generation,
    metavar="NUMBER|all",
    help="which one, negative numbers from the last; all: means of every one  [default: the last]",
)
@click.option("--scripts", is_flag=True, help="the best of all scripts in the same episodes, too")
@options.shared("episodes", "seed", "json", "force", "threads", "cluster")
def score_command(
    runs: list[Path],
    scripts: bool,
    json_file: Path | None,
    force: bool,
    threads: int | None,
    where: str | None,
    **chosen: Any,
) -> None:
    """Score teams against held-out opponents.

    The opponents are scripts of different skill and, in worlds with the default views and actions,
    small networks that come with the package. No run has learnt against them, and with one --seed
    all runs meet them in the same episodes: runs can be compared.

    RUN is the directory of a job or of a run. A single run need not be finished. Of runs that
    differ in their seed only the table shows mean and interval over the seeds. Runs with
    training_worlds are also scored in each of these.

    With --scripts all scripts that can play in the world of the runs play the same episodes,
    careful ones, too, and the best of each team is named, with what it knows beyond its view.

    With --cluster the workers of a Dask cluster play blocks of the matches. It pays with
    --generation all and many episodes. The workers need not see RUN.
    """
    options.check_outputs(json_file, force=force)
    scored = []
    with usage_errors():
        groups = options.finished_groups(runs, unfinished=True)
        with cluster.on_cluster(where, threads) as executor, ProgressBar() as bar:
            play = {"threads": threads, "executor": executor, "report": bar, **chosen}
            for group in groups:
                scores = score_runs(group.runs, **play)
                in_worlds = [
                    (world, score_runs(group.runs, world=world, **play))
                    for world in _training_worlds(group)
                ]
                scored.append(GroupScores(group, scores, in_worlds))
    plain = {}
    for of_group in scored:
        plain[of_group.group.name] = _print_in_own_world(of_group)
        if scripts:
            played = {"episodes": chosen["episodes"], "seed": chosen["seed"], "threads": threads}
            _print_best_scripts(of_group, played, plain[of_group.group.name])
    for of_group in scored:
        if of_group.in_worlds:
            plain[of_group.group.name]["training_worlds"] = _print_in_worlds(of_group)
    console.say()
    console.print_wrapped(LEGEND if max(len(group.runs) for group in groups) == 1 else SEEDS_LEGEND)
    console.say(f"{sum(of_group.matches for of_group in scored):,} matches of teams were played.")
    options.write_json(json_file, {"seed": chosen["seed"], "groups": plain})


def _training_worlds(group: RunGroup) -> tuple[WorldConfig, ...]:
    game = group.runs[0].settings.game
    return game.training_worlds if isinstance(game, PursuitSettings) else ()


def _print_in_own_world(scored: GroupScores) -> dict[str, Any]:
    """Print the scores of a group in its own world; return them as values of JSON."""
    group = scored.group
    finished = f": {console.seeds_finished(group)}" if group.several else ""
    console.print_head(f"{group.name}{finished}")
    first = next(iter(scored.scores[0].values()))
    place = console.place_of(group.runs[0].settings)
    console.print_wrapped(f"{place}: {first.rates.shape[2]} episodes against each opponent")
    plain = {
        "seeds": list(group.seeds),
        "missing": list(group.missing),
        "held_out": HELD_OUT_VERSION,
        **_print_scores(group, scored.scores),
    }
    console.print_missing(group)
    return plain


def _print_best_scripts(
    scored: GroupScores, played: Mapping[str, Any], plain: Mapping[str, Any]
) -> None:
    """Print the best script of each team that learned, and add it to values of JSON."""
    group = scored.group
    run = group.runs[0]
    every = best_scripts(run.pursuit.world, met_in_training(run), **played)
    scripts = {team: every[team] for team in scored.scores[0]}
    for team, script in scripts.items():
        told = f"{script.score:.3f} {script.name}, of {script.among} that can play"
        console.say(f"the best script of {PLURALS[team]}: {told}")
        plain[PLURALS[team]]["best script"] = script._asdict()
    console.print_wrapped(console.beyond_views(group, scripts))


def _print_in_worlds(scored: GroupScores) -> list[dict[str, Any]]:
    """Print the scores of a group in each world of training; return them as values of JSON."""
    plain = []
    for world, scores in scored.in_worlds:
        size = f"{world.rows} x {world.cols}, {world.n_pursuers} v {world.n_evaders}"
        walls = ", with obstacles" if world.density or world.map is not None else ""
        console.print_head(f"{scored.group.name} in a world of training: {size}{walls}")
        plain.append({"world": world.to_json(), **_print_scores(scored.group, scores)})
    return plain


def _print_scores(group: RunGroup, scores: Scores) -> dict[str, Any]:
    """Print the scores of the runs of a group, and return them as values of JSON by team."""
    plain = {}
    for team, first in scores[0].items():
        of_team = [of_run[team] for of_run in scores]
        console.say(score_table(of_team))
        if first.left_out:
            console.print_wrapped(f"Left out: {first.left_out}.")
        rows = range(len(first.generations))
        by_seed = zip(group.seeds, of_team, strict=True)
        plain[PLURALS[team]] = {
            "generations": list(first.generations),
            "estimates": plain_values([estimates_of(of_team, row) for row in rows]),
            "by_seed": {str(seed): one.to_json() for seed, one in by_seed},
        }
    return plain
