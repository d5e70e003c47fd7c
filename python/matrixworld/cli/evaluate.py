"""``matrixworld score`` and ``tournament``: finished runs play more matches."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import click

from matrixworld._util.files import save_arrays
from matrixworld._util.readable import plain_values
from matrixworld.analysis import headline, judge
from matrixworld.analysis.runs import fewest_runs
from matrixworld.cli.cluster import on_cluster
from matrixworld.cli.console import TERMS, print_head, print_wrapped, progress, say
from matrixworld.cli.judge import print_judgement
from matrixworld.cli.options import check_outputs, options, out_option, write_json
from matrixworld.cli.runs import (
    dashed_name,
    finished_groups,
    print_missing,
    run_in,
    runs_argument,
    seeds_finished,
)
from matrixworld.cli.setting_options import usage_errors
from matrixworld.coevolution import Progress, SavedRun, open_run, tournament
from matrixworld.coevolution.evaluation.scores import (
    HELD_OUT_VERSION,
    HeldOutScores,
    estimates_of,
    score_runs,
    score_table,
)
from matrixworld.coevolution.evaluation.tournament import team_size
from matrixworld.coevolution.groups import RunGroup
from matrixworld.coevolution.storage import find_runs

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


@click.command("score")
@runs_argument()
@click.option(
    "--generation",
    default="-1",
    callback=_generation,
    metavar="NUMBER|all",
    help="which one, negative numbers from the last; all: means of every one  [default: the last]",
)
@options("episodes", "steps", "seed", "json", "force", "threads", "cluster")
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
        _print_scores(group, teams)
        found[group.name] = _plain(group, teams)
        matches += sum(each.matches for scores in teams for each in scores)
    say()
    print_wrapped(LEGEND if max(len(group.runs) for group in groups) == 1 else SEEDS_LEGEND)
    say(f"{matches:,} matches were played.")
    write_json(json_file, {"seed": chosen["seed"], "groups": found})


def _print_scores(group: RunGroup, teams: Sequence[Sequence[HeldOutScores]]) -> None:
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


# Tournaments:

SUFFIX = ".npz"


@click.command("tournament")
@click.argument("run", type=click.Path(path_type=Path))
@click.argument("other", required=False, metavar="[RUN2]")
@options("race", "episodes", "steps", "seed")
@out_option("the payoff, .npz  [default: in RUN, named after the options]")
@options("force", "threads", "cluster")
def tournament_command(
    run: Path, other: str | None, race: str | None, out: Path | None, force: bool, **chosen: Any
) -> None:
    """Play every generation against every other.

    The pursuers are those of RUN, the evaders those of RUN or, if given, of RUN2. If RUN holds
    several races, each has its tournament, or --race chooses one. RUN need not be
    finished: the generations that it has are played. Its own files stay as they are.

    The payoff is written to an .npz file, and a heat map beside it (.png). With the seed and the
    evaluation steps of RUN the first episodes of each pair are those of RUN's own payoff. The race
    of a single run is judged.

    With --cluster the workers of a Dask cluster play blocks of the matrix. They need not see RUN.
    """
    runs = (find_runs(run) if race is None else []) or [run_in(run, race=race)]
    for option, given in (("RUN2", other), ("--out", out)):
        if given is not None and len(runs) > 1:
            raise click.UsageError(
                f"{option}: expected one race in RUN, got {len(runs)}; --race NAME chooses one"
            )
    rival = None if other is None else open_run(run_in(other, race=race))
    for each in runs:
        _play_one(open_run(each), rival, out, force, **chosen)


def _play_one(
    ours: SavedRun,
    rival: SavedRun | None,
    out: Path | None,
    force: bool,
    *,
    episodes: int,
    seed: int,
    steps: int | None,
    threads: int | None,
    where: str | None,
) -> None:
    from matrixworld import plots

    theirs = rival or ours
    _check_worlds(ours, theirs)
    steps = steps or ours.settings.world.max_steps
    against = f"-against-{dashed_name(rival.path)}" if rival else ""
    name = f"tournament{against}-{episodes}x{steps}-seed{seed}{SUFFIX}"
    target = out or ours.path / name
    # With another suffix the figure could have the payoff's own name.
    if target.suffix.lower() != SUFFIX:
        raise click.UsageError(f"--out: expected a name that ends in {SUFFIX}, got {target}")
    figure = target.with_suffix(".png")
    check_outputs(target, figure, force=force)
    pursuers, evaders = ours.teams["pursuer"], theirs.teams["evader"]
    total = team_size(pursuers) * team_size(evaders) * episodes
    with on_cluster(where, threads) as executor, progress() as bar:
        # The first row may take minutes, and the bar should be there before.
        bar(Progress("tournament", 0, total))
        payoff = tournament(
            replace(ours.settings.world, max_steps=steps),
            pursuers,
            evaders,
            seed=seed,
            episodes=episodes,
            threads=threads,
            on_row=lambda played: bar(Progress("tournament", played, total)),
            executor=executor,
        )
    # Generations of two runs have no common order in time, and are not judged.
    judgement = None if rival else judge(payoff.capture_rates, per_episode=True)
    shown = f"against evaders of {theirs.title}" if judgement is None else headline(judgement)
    title = f"{'pursuers of ' if rival else ''}{ours.title}\n{shown}"
    save_arrays(target, payoff.arrays())
    plots.save_figure(plots.payoff_heatmap(payoff.capture_rate, title=title), figure)
    print_head(str(ours.path))
    say(payoff)
    if judgement is not None:
        say()
        print_judgement(judgement)
        say(f"\n{TERMS}")
    say(f"\nWritten: {target}, {figure.name}")


def _check_worlds(ours: SavedRun, theirs: SavedRun) -> None:
    # The limit of steps may differ between the runs.
    mine, other = (replace(run.settings.world, max_steps=1).to_json() for run in (ours, theirs))
    for name, value in mine.items():
        if other[name] != value:
            got = f"{name} {value!r} and {other[name]!r}"
            raise click.UsageError(f"expected two runs in the same world, got {got}")
