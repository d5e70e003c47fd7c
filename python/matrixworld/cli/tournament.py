"""``matrixworld tournament``: every generation of a run against every other."""

from __future__ import annotations

from concurrent.futures import Executor
from pathlib import Path

import click

from matrixworld import analysis
from matrixworld._util.files import save_arrays
from matrixworld.cli import cluster, console, options
from matrixworld.cli.judge import print_judgement
from matrixworld.cli.setting_options import usage_errors
from matrixworld.coevolution import ProgressBar, SavedRun, open_run, tournament
from matrixworld.coevolution.groups import readable
from matrixworld.coevolution.runs.places import find_runs
from matrixworld.coevolution.types import Payoff


@click.command("tournament")
@click.argument("run", type=click.Path(path_type=Path))
@options.shared("race", "episodes", "seed")
@options.shared("force", "threads", "cluster")
def tournament_command(
    run: Path,
    race: str | None,
    episodes: int,
    seed: int,
    force: bool,
    threads: int | None,
    where: str | None,
) -> None:
    """Play every generation against every other.

    If RUN holds several races, each has its tournament, or --race chooses one. RUN need not be
    finished: the generations that it has are played. Its own files stay as they are.

    The payoff is written into RUN (.npz, named after the options), and a heat map (.png). With the
    seed of RUN the first episodes of each pair are those of RUN's own payoff. The race is judged.

    With --cluster the workers of a Dask cluster play blocks of the matrix. They need not see RUN.
    """
    with console.warnings_as_notes(), usage_errors():
        paths = find_runs(run) if race is None else []
        every = map(SavedRun, paths or [options.run_in(run, race)])
        races = [_open_to_play(saved.path) for saved in readable(every)]
    targets = [saved.path / f"tournament-{episodes}-seed{seed}.npz" for saved in races]
    options.check_outputs(*targets, *map(_figure_of, targets), force=force)
    with cluster.on_cluster(where, threads) as executor:
        for saved, target in zip(races, targets, strict=True):
            payoff = _play(saved, seed, episodes, threads, executor)
            _write(saved, payoff, target)


def _figure_of(target: Path) -> Path:
    return target.with_suffix(".png")


def _open_to_play(path: Path) -> SavedRun:
    """Return a run whose teams can play: a game of your own is imported, or this is an error."""
    run = open_run(path)
    run.teams  # noqa: B018, they are made now
    return run


def _play(
    run: SavedRun, seed: int, episodes: int, threads: int | None, executor: Executor | None
) -> Payoff:
    with ProgressBar() as bar:
        return tournament(
            run.settings.evaluation_game,
            *run.sides,
            seed=seed,
            episodes=episodes,
            threads=threads,
            report=bar,
            executor=executor,
        )


def _write(run: SavedRun, payoff: Payoff, target: Path) -> None:
    """Write a payoff and its heat map, and print its judgement."""
    from matrixworld import plots

    judgement = analysis.judge(payoff.payoffs())
    title = f"{run.title}\n{analysis.sentence(judgement)}"
    figure = _figure_of(target)
    save_arrays(target, payoff.arrays())
    general = payoff.others is not None
    heatmap = plots.payoff_heatmap(payoff.matrix, title=title, teams=payoff.teams, general=general)
    plots.save_figure(heatmap, figure)
    console.print_head(str(run.path))
    console.say(f"{payoff}\n")
    print_judgement(judgement)
    console.say(f"\n{console.TERMS}")
    console.say(f"\nWritten: {target}, {figure.name}")
