"""``matrixworld tournament``: all generations of a run, or of two, against each other."""

from __future__ import annotations

from pathlib import Path

import click
import numpy as np

from matrixworld.analysis import Generalization, describe, generalization, summarize
from matrixworld.cli.arguments import failures, run_of, threads_option
from matrixworld.cli.figures import save_figure
from matrixworld.cli.progress import progress
from matrixworld.cli.report import print_wrapped
from matrixworld.coevolution import Payoff, SavedRun, open_run, tournament
from matrixworld.files import save_arrays
from matrixworld.policy import Population

SHORTEST_RACE = 2
"""Generations of each team that a summary needs."""


@click.command("tournament")
@click.argument("run", callback=run_of)
@click.argument("other", required=False, metavar="[RUN2]", callback=run_of)
@click.option(
    "--episodes", type=click.IntRange(min=1), metavar="INTEGER",
    help="episodes of each pair  [default: as in the evaluation of RUN]",
)  # fmt: skip
@click.option(
    "--steps", type=click.IntRange(min=1), metavar="INTEGER",
    help="most steps of an episode  [default: as in the evaluation of RUN]",
)  # fmt: skip
@click.option(
    "--seed", type=click.IntRange(0, 2**63 - 1), metavar="INTEGER",
    help="seed of the episodes  [default: that of RUN, whose own episodes come first]",
)  # fmt: skip
@click.option(
    "--output", type=click.Path(path_type=Path, dir_okay=False),
    help="where to write the payoff (.npz), and beside it a heat map (.png)  "
    "[default: in RUN, named after the options]",
)  # fmt: skip
@click.option("--yes", is_flag=True, help="replace an existing output without asking")
@threads_option
def tournament_command(
    run: Path,
    other: Path | None,
    episodes: int | None,
    steps: int | None,
    seed: int | None,
    output: Path | None,
    yes: bool,
    threads: int | None,
) -> None:
    """Play every generation against every other.

    Those are the pursuers of RUN, and the evaders of RUN or, if given, of RUN2. RUN need not be
    finished: the generations that it has are played. Its own files stay as they are.
    """
    with failures():
        ours = open_run(run)
        theirs = ours if other is None else open_run(other)
        _check_worlds(ours, theirs)
        settings = ours.settings
        episodes = episodes or settings.eval_episodes
        steps = steps or settings.eval_steps
        seed = settings.seed if seed is None else seed
        against = "" if other is None else f"-against-{other.name}"
        target = output or run / f"tournament{against}-{episodes}x{steps}-seed{seed}.npz"
        if target.exists() and not yes:
            click.confirm(f"{target} exists. Replace it?", abort=True)
        payoff = _play(ours, theirs, episodes, steps, seed, threads)
        _save(payoff, target, _title(run, other))
    _print(payoff, summary=other is None)
    click.echo(f"\nWritten: {target}, {target.with_suffix('.png').name}")


def _check_worlds(ours: SavedRun, theirs: SavedRun) -> None:
    worlds = [run.settings.world(1).to_json() for run in (ours, theirs)]
    different = [name for name in worlds[0] if worlds[0][name] != worlds[1][name]]
    if different:
        values = "; ".join(
            f"{name} {worlds[0][name]!r} and {worlds[1][name]!r}" for name in different
        )
        raise click.UsageError(f"expected two runs in the same world, got {values}")


def _play(
    ours: SavedRun, theirs: SavedRun, episodes: int, steps: int, seed: int, threads: int | None
) -> Payoff:
    pursuers, evaders = ours.teams["pursuer"], theirs.teams["evader"]
    sizes = [len(t.genomes) if isinstance(t, Population) else 1 for t in (pursuers, evaders)]
    total = sizes[0] * sizes[1] * episodes
    with progress() as report:
        report("tournament", 0, total)
        return tournament(
            ours.settings.world(steps),
            pursuers,
            evaders,
            seed=seed,
            episodes=episodes,
            threads=threads,
            on_row=lambda played: report("tournament", played, total),
        )


def _save(payoff: Payoff, target: Path, title: str) -> None:
    from matrixworld import plots

    save_arrays(target, payoff.arrays())
    figure = plots.payoff_heatmap(payoff.capture_rate, title=title)
    save_figure(figure, target.with_suffix(".png"))


def _title(run: Path, other: Path | None) -> str:
    return run.name if other is None else f"pursuers of {run.name}\nagainst evaders of {other.name}"


def _print(payoff: Payoff, *, summary: bool) -> None:
    matrix = payoff.capture_rate
    scores: Generalization = generalization(matrix)
    last = matrix[-1, -1]
    click.echo(
        f"{matrix.shape[0]} pursuer generations against {matrix.shape[1]} evader generations, "
        f"{np.size(payoff.lengths):,} episodes\n"
        f"  mean capture rate                           {matrix.mean():.3f}\n"
        f"  last pursuers against all evaders, capture  {scores.pursuers[-1]:.3f}\n"
        f"  last evaders against all pursuers, escape   {scores.evaders[-1]:.3f}\n"
        f"  last against last, capture rate             {last:.3f}"
    )
    if summary and min(matrix.shape) >= SHORTEST_RACE:
        click.echo()
        print_wrapped(describe(summarize(matrix)))
