"""The command ``matrixworld``.

==============  ==================================================================================
evolve.py       ``evolve``: start runs or go on with them
tournament.py   ``tournament``: payoff matrices, also of two runs
replay.py       ``replay``: watch a match
score.py        ``score``: a run against opponents that it has not met
exploit.py      ``exploit``: what a fresh best response takes from a champion
plot.py         ``plot``: figures of finished runs
diagnose.py     ``diagnose``: what happened in a race, and what to try
variants.py     ``variants``: the table of rules
bench.py        ``bench``: how fast this machine plays; `bench_report` prints it
options.py      options from the fields of the settings
arguments.py    run directories as arguments
jobs.py         several runs as one job
progress.py     a bar over the whole job
report.py       what is printed at the end
figures.py      figures of a run directory
==============  ==================================================================================
"""

from __future__ import annotations

import click

import matrixworld
from matrixworld.cli.bench import bench_command
from matrixworld.cli.diagnose import diagnose_command
from matrixworld.cli.evolve import evolve_command
from matrixworld.cli.exploit import exploit_command
from matrixworld.cli.plot import plot_command
from matrixworld.cli.replay import replay_command
from matrixworld.cli.score import score_command
from matrixworld.cli.tournament import tournament_command
from matrixworld.cli.variants import variants_command

__all__ = ["main"]


@click.group(context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100})
@click.version_option(matrixworld.__version__)
def main() -> None:
    """Pursuers and evaders on a grid that evolve against each other.

    Start with `matrixworld evolve`: it runs two races within minutes, shows which of them goes in
    circles and which makes progress, and says what to try next.
    """


for command in (
    evolve_command,
    replay_command,
    tournament_command,
    score_command,
    exploit_command,
    plot_command,
    diagnose_command,
    variants_command,
    bench_command,
):
    main.add_command(command)
