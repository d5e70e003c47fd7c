"""``matrixworld export``: a genome of a run as a file of its own."""

from __future__ import annotations

from pathlib import Path

import click

from matrixworld.classroom.submissions import save_genome
from matrixworld.cli.arguments import failures, run_of
from matrixworld.cli.options import force_option, refuse_existing
from matrixworld.coevolution import open_run
from matrixworld.coevolution.types import TEAMS, Team

SUFFIX = ".npz"


@click.command("export")
@click.argument("run", callback=run_of)
@click.option(
    "--team", type=click.Choice(TEAMS), required=True, metavar="TEAM", help="pursuer or evader"
)
@click.option(
    "--generation",
    type=int,
    default=-1,
    metavar="INTEGER",
    help="the generation; negative numbers count from the end  [default: the last one]",
)
@click.option(
    "--output",
    "-o",
    type=click.Path(path_type=Path, dir_okay=False),
    required=True,
    metavar="FILE",
    help="the file; its name ends in .npz",
)
@force_option
def export_command(run: Path, team: Team, generation: int, output: Path, force: bool) -> None:
    """Write a genome of RUN with its network to a file.

    The file holds numbers only, and can be handed in for a tournament: see matrixworld class.
    """
    if output.suffix.lower() != SUFFIX:
        raise click.UsageError(f"--output: expected a name that ends in {SUFFIX}, got {output}")
    refuse_existing(output, force=force)
    with failures():
        saved = open_run(run)
        try:
            policy = saved.policy(team, generation)
        except IndexError as error:
            raise click.UsageError(f"--generation: {str(error).partition(': ')[2]}") from error
        except ValueError as error:
            raise click.UsageError(f"--{error}") from error
        save_genome(output, team, policy)
        click.echo(output)
