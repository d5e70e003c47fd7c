"""``matrixworld score``: teams against opponents that no run has met."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any

import click
import numpy as np

from matrixworld._util.files import save_json
from matrixworld._util.readable import plain_values
from matrixworld.analysis import Estimate, interquartile_mean
from matrixworld.analysis.runs import fewest_runs
from matrixworld.cli.cluster import cluster_option, on_cluster
from matrixworld.cli.console import print_wrapped, progress, say
from matrixworld.cli.groups import (
    SCORED_BY,
    SCORED_EPISODES,
    SCORED_SEED,
    SCORES,
    Group,
    Result,
    groups_of,
    kept_scores,
    owner_of_scores,
    runs_argument,
)
from matrixworld.cli.options import (
    episodes_option,
    force_option,
    json_option,
    refuse_existing,
    seed_option,
    steps_option,
    threads_option,
    write_json,
)
from matrixworld.cli.setting_options import usage_errors
from matrixworld.cli.tables import over_seeds, print_head, print_missing
from matrixworld.coevolution import Progress, Team, open_run, score
from matrixworld.coevolution.evaluation.scores import HELD_OUT_VERSION, HeldOutScores

ALL = "all"
LAST = -1
LEGEND = (
    "In brackets: 95% interval over the episodes. Runs with other seeds may differ by more. In the "
    "mean every opponent has the same weight."
)
SEEDS_LEGEND = (
    "In brackets: 95% interval of the mean over seeds. In the mean every opponent has the same "
    f"weight. The interval of an interquartile mean takes {fewest_runs()} seeds."
)


def _generation(ctx: click.Context, param: click.Parameter, value: str) -> int | None:
    if value == ALL:
        return None
    try:
        return int(value)
    except ValueError:
        raise click.BadParameter(f"expected a generation or {ALL}, got {value!r}") from None


@click.command("score", short_help="Play against held-out opponents.")
@runs_argument()
@click.option(
    "--generation",
    default=str(LAST),
    callback=_generation,
    metavar="NUMBER|all",
    help="which one, negative numbers from the last; all: means of every one  [default: the last]",
)
@episodes_option
@steps_option
@seed_option
@json_option
@force_option
@threads_option
@cluster_option
def score_command(
    runs: list[Path],
    json_file: Path | None,
    force: bool,
    threads: int | None,
    where: str | None,
    **options: Any,
) -> None:
    """Score teams against held-out opponents.

    The opponents are scripts of different skill and, in worlds with the default views and actions,
    small networks that come with the package. No run has learnt against them, and with one --seed
    all runs meet them in the same episodes: runs can be compared.

    RUN is the directory of a job or of a run. A single run need not be finished. Of runs that
    differ in their seed only the table shows mean and interval over the seeds.

    With --cluster the workers of a Dask cluster play blocks of the matches. It pays with
    --generation all and many episodes. The workers need not see RUN.
    """
    refuse_existing(json_file, force=force)
    with on_cluster(where, threads) as executor:
        groups = groups_of(runs, unfinished=True)
        paths = [run.path for group in groups for run in group.runs]
        with usage_errors():
            played = score_all(paths, threads=threads, executor=executor, **options)
        plain = {}
        for group in groups:
            of_runs = [played[run.path] for run in group.runs]
            teams = [[scores[team] for scores in of_runs] for team in of_runs[0]]
            _print(group, teams)
            plain[group.name] = _plain(group, teams)
        legend = LEGEND if max(len(group.runs) for group in groups) == 1 else SEEDS_LEGEND
        say()
        print_wrapped(legend)
        matches = sum(scores.matches for teams in played.values() for scores in teams.values())
        say(f"{matches:,} matches were played.")
        write_json(json_file, {"seed": options["seed"], "groups": plain})


TeamScores = Sequence[HeldOutScores]
"""Scores of one team, of each seed."""


def estimates_of(scores: TeamScores, row: int) -> dict[str, Estimate]:
    """Return the estimates of one generation against each opponent, and over all of them."""
    first, opponents = scores[0], scores[0].opponents
    if len(scores) == 1:
        # The mean has its own interval: it is narrower than those of its parts.
        return {**{name: first.against(name, row) for name in opponents}, "mean": first.mean(row)}
    rates = np.array([each.rates[row].mean(axis=1) for each in scores])
    against = {name: over_seeds(rates[:, k]) for k, name in enumerate(opponents)}
    found = {**against, "mean": over_seeds(rates.mean(axis=1))}
    known = {name: each for name, each in found.items() if each is not None}
    return {**known, "interquartile mean": interquartile_mean(rates)}


def _print(group: Group, teams: Sequence[TeamScores]) -> None:
    several = f": {group.finished_of_asked()} seeds finished" if group.several else ""
    print_head(f"{group.name}{several}")
    for scores in teams:
        say(scores[0].table(partial(estimates_of, scores)))
        if scores[0].left_out:
            print_wrapped(f"Left out: {scores[0].left_out}.")
    print_missing(group)


def _plain(group: Group, teams: Sequence[TeamScores]) -> dict[str, Any]:
    return {
        "seeds": list(group.seeds),
        "missing": list(group.missing),
        "held_out": HELD_OUT_VERSION,
        **{
            f"{scores[0].team}s": {
                "generations": list(scores[0].generations),
                "estimates": [
                    plain_values(estimates_of(scores, row))
                    for row in range(len(scores[0].generations))
                ],
                "by_seed": {
                    str(seed): each.to_json()
                    for seed, each in zip(group.seeds, scores, strict=True)
                },
            }
            for scores in teams
        },
    }


# Playing, also at the end of ``evolve``:


def score_all(paths: Sequence[Path], **options: Any) -> dict[Path, Mapping[Team, HeldOutScores]]:
    """Score runs one after the other, with one progress for all; options as those of `score`."""
    found: dict[Path, Mapping[Team, HeldOutScores]] = {}
    with progress() as report:
        for number, path in enumerate(paths):
            # Runs of a job play about equally many matches.
            def part(one: Progress, number: int = number) -> None:
                place = f"[{number + 1}/{len(paths)}] " if len(paths) > 1 else ""
                done = number * one.total + one.done
                report(Progress(place + one.what, done, len(paths) * one.total))

            found[path] = score(open_run(path), report=part, **options)
    return found


def play_held_out(races: Sequence[Result], threads: int | None) -> None:
    """Play the scores of the last generations of races that have none, and keep them.

    They are those of ``matrixworld score`` without options.
    """
    missing = {race.path: race.files for race in races if kept_scores(race.files) is None}
    if not missing:
        return
    played = score_all([*missing], episodes=SCORED_EPISODES, seed=SCORED_SEED, threads=threads)
    for path, files in missing.items():
        teams = {f"{team}s": each.to_json() for team, each in played[path].items()}
        save_json(path / SCORES, {**SCORED_BY, **teams}, owner=owner_of_scores(files))
