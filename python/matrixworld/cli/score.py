"""``matrixworld score``: teams against opponents that no run has met."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import click

from matrixworld._util.readable import plain_values
from matrixworld.analysis.runs import fewest_runs
from matrixworld.cli.cluster import cluster_option, on_cluster
from matrixworld.cli.console import print_head, print_wrapped, progress, say
from matrixworld.cli.options import check_outputs, options, write_json
from matrixworld.cli.runs import finished_groups, print_missing, runs_argument, seeds_finished
from matrixworld.cli.setting_options import usage_errors
from matrixworld.coevolution.evaluation.scores import (
    HELD_OUT_VERSION,
    HeldOutScores,
    estimates_of,
    score_runs,
    score_table,
)
from matrixworld.coevolution.groups import RunGroup

ALL = "all"
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
    default="-1",
    callback=_generation,
    metavar="NUMBER|all",
    help="which one, negative numbers from the last; all: means of every one  [default: the last]",
)
@options("episodes", "steps", "seed", "json", "force", "threads")
@cluster_option
def score_command(
    runs: list[Path],
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
    differ in their seed only the table shows mean and interval over the seeds.

    With --cluster the workers of a Dask cluster play blocks of the matches. It pays with
    --generation all and many episodes. The workers need not see RUN.
    """
    check_outputs(json_file, force=force)
    with usage_errors():
        groups = finished_groups(runs, unfinished=True)
        every = [run for group in groups for run in group.runs]
        with on_cluster(where, threads) as executor, progress() as bar:
            played = score_runs(every, threads=threads, executor=executor, report=bar, **chosen)
    found, matches = {}, 0
    for group in groups:
        of_runs = [played.pop(0) for _ in group.runs]
        teams = [[scores[team] for scores in of_runs] for team in of_runs[0]]
        _print(group, teams)
        found[group.name] = _plain(group, teams)
        matches += sum(each.matches for scores in teams for each in scores)
    say()
    print_wrapped(LEGEND if max(len(group.runs) for group in groups) == 1 else SEEDS_LEGEND)
    say(f"{matches:,} matches were played.")
    write_json(json_file, {"seed": chosen["seed"], "groups": found})


def _print(group: RunGroup, teams: Sequence[Sequence[HeldOutScores]]) -> None:
    several = f": {seeds_finished(group)}" if group.several else ""
    print_head(f"{group.name}{several}")
    for scores in teams:
        say(score_table(scores))
        if scores[0].left_out:
            print_wrapped(f"Left out: {scores[0].left_out}.")
    print_missing(group)


def _plain(group: RunGroup, teams: Sequence[Sequence[HeldOutScores]]) -> dict[str, Any]:
    plain: dict[str, Any] = {
        "seeds": list(group.seeds),
        "missing": list(group.missing),
        "held_out": HELD_OUT_VERSION,
    }
    for scores in teams:
        generations = scores[0].generations
        rows = range(len(generations))
        by_seed = zip(group.seeds, scores, strict=True)
        plain[f"{scores[0].team}s"] = {
            "generations": list(generations),
            "estimates": [plain_values(estimates_of(scores, row)) for row in rows],
            "by_seed": {str(seed): each.to_json() for seed, each in by_seed},
        }
    return plain
