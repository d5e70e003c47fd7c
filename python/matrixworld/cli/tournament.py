"""``matrixworld tournament``: all generations of a run, or of two, against each other."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import click

from matrixworld._util.files import save_arrays
from matrixworld.analysis import generalization, headline, judge
from matrixworld.cli.cluster import cluster_option, on_cluster
from matrixworld.cli.console import TERMS, print_head, progress, say
from matrixworld.cli.figures import draw, run_title
from matrixworld.cli.judge import counts, print_judgement
from matrixworld.cli.options import check_outputs, options, out_option
from matrixworld.cli.runs import run_in
from matrixworld.coevolution import Payoff, Progress, SavedRun, open_run, tournament
from matrixworld.coevolution.evaluation.tournament import team_size
from matrixworld.coevolution.groups import find_runs

SUFFIX = ".npz"


@click.command("tournament")
@click.argument("run", type=click.Path(path_type=Path))
@click.argument("other", required=False, metavar="[RUN2]")
@options("race", "episodes", "steps", "seed")
@out_option("the payoff, .npz  [default: in RUN, named after the options]")
@options("force", "threads")
@cluster_option
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
    rival = None if other is None else run_in(other, race=race)
    for each in runs:
        _one(each, rival, out, force, **chosen)


def _one(
    run: Path,
    other: Path | None,
    out: Path | None,
    force: bool,
    *,
    episodes: int,
    seed: int,
    steps: int | None,
    **runner: Any,
) -> None:
    ours = open_run(run)
    theirs = ours if other is None else open_run(other)
    _check_worlds(ours, theirs)
    steps = steps or ours.settings.world.max_steps
    against = "" if other is None else f"-against-{other.name}"
    name = f"tournament{against}-{episodes}x{steps}-seed{seed}{SUFFIX}"
    target = _checked(out or run / name, force)
    payoff = _play(ours, theirs, episodes, steps, seed, **runner)
    # Generations of two runs have no common order in time, and are not judged.
    judgement = judge(payoff.capture_rates, per_episode=True) if other is None else None
    title, rival = run_title(run, ours.settings), run_title(other or run, theirs.settings)
    shown = f"against evaders of {rival}" if judgement is None else headline(judgement)
    _save(payoff, target, f"{'pursuers of ' if other else ''}{title}\n{shown}")
    print_head(str(run))
    _print(payoff)
    if judgement is not None:
        print_head(counts(judgement))
        print_judgement(judgement)
        say(f"\n{TERMS}")
    say(f"\nWritten: {target}, {_figure(target).name}")


def _checked(target: Path, force: bool) -> Path:
    # With another suffix the figure could have the payoff's own name.
    if target.suffix.lower() != SUFFIX:
        raise click.UsageError(f"--out: expected a name that ends in {SUFFIX}, got {target}")
    check_outputs(target, _figure(target), force=force)
    return target


def _figure(target: Path) -> Path:
    return target.with_suffix(".png")


def _check_worlds(ours: SavedRun, theirs: SavedRun) -> None:
    # `world` wants a limit of steps, which may differ between the runs: any number serves.
    worlds = [replace(run.settings.world, max_steps=1).to_json() for run in (ours, theirs)]
    different = [name for name in worlds[0] if worlds[0][name] != worlds[1][name]]
    if different:
        values = "; ".join(
            f"{name} {worlds[0][name]!r} and {worlds[1][name]!r}" for name in different
        )
        raise click.UsageError(f"expected two runs in the same world, got {values}")


def _play(
    ours: SavedRun,
    theirs: SavedRun,
    episodes: int,
    steps: int,
    seed: int,
    threads: int | None,
    where: str | None,
) -> Payoff:
    pursuers, evaders = ours.teams["pursuer"], theirs.teams["evader"]
    total = team_size(pursuers) * team_size(evaders) * episodes
    with on_cluster(where, threads) as executor, progress() as report:
        # The first row may take minutes, and the bar should be there before.
        report(Progress("tournament", 0, total))
        return tournament(
            replace(ours.settings.world, max_steps=steps),
            pursuers,
            evaders,
            seed=seed,
            episodes=episodes,
            threads=threads,
            on_row=lambda played: report(Progress("tournament", played, total)),
            executor=executor,
        )


def _save(payoff: Payoff, target: Path, title: str) -> None:
    from matrixworld import plots

    save_arrays(target, payoff.arrays())
    draw({_figure(target): lambda: plots.payoff_heatmap(payoff.capture_rate, title=title)})


def _print(payoff: Payoff) -> None:
    matrix = payoff.capture_rate
    scores = generalization(matrix)
    say(
        f"{matrix.shape[0]} pursuer generations against {matrix.shape[1]} evader generations, "
        f"{payoff.lengths.size:,} episodes\n"
        f"  mean capture rate                           {matrix.mean():.3f}\n"
        f"  last pursuers against all evaders, capture  {scores.pursuers[-1]:.3f}\n"
        f"  last evaders against all pursuers, escape   {scores.evaders[-1]:.3f}\n"
        f"  last against last, capture rate             {matrix[-1, -1]:.3f}"
    )
