"""The command ``matrixworld``.

==================  ================================================================================
evolve.py           ``evolve``: start runs or continue them
tournament.py       ``tournament``: payoff matrices, also of two runs
replay.py           ``replay``: watch a match
score.py            ``score``: a run against held-out opponents
exploit.py          ``exploit``: evolve a best response to a champion
explore.py          ``explore``: a page of finished runs that plays their matches
playground.py       ``playground``: a page on which conflicts are played by hand
plot.py             ``plot``: draw the figures of finished runs again
diagnose.py         ``diagnose``: what happened in a race, and what to try
analyze.py          ``analyze``: all measures of payoffs, also of a matrix of one's own
class_tournament.py ``class``: a tournament of policies that students have handed in
export.py           ``export``: a genome of a run as a file for that tournament
variants.py         ``variants``: the table of rules
bench.py            ``bench``: how fast this machine plays
options.py          options that several commands share, and old names of options
setting_options.py  options from the fields of the settings
arguments.py        run directories as arguments
jobs.py             runs that a command plays: a single one, or several as one job
seeds.py            the option ``--seeds``
figures.py          the figures of a run
report.py           what ``evolve`` prints at the end
seed_report.py      the same of a job with several seeds
race_tables.py      tables over the races of one job
held_out.py         held-out scores of finished races, kept in run directories
seed_report.py      what ``evolve`` prints at the end of a job of several seeds
seed_tables.py      tables over the seeds of a job
seed_figures.py     figures over the seeds of a job
seed_responses.py   best responses over the seeds of a job
seed_scores.py      held-out scores over the seeds of a job
run_groups.py       runs in groups that differ in their seed only
race_groups.py      races to judge: runs grouped by settings, and payoff files
judgements.py       the table of a judgement, and what limits it
advice.py           what to try, from a judgement and the settings of the race
job_progress.py     progress of several runs at one time
console.py          progress, notes, wrapped text and tables
==================  ================================================================================
"""

from __future__ import annotations

import click

from matrixworld.cli.analyze import analyze_command
from matrixworld.cli.bench import bench_command
from matrixworld.cli.class_tournament import class_command
from matrixworld.cli.diagnose import diagnose_command
from matrixworld.cli.evolve import evolve_command
from matrixworld.cli.exploit import exploit_command
from matrixworld.cli.explore import explore_command
from matrixworld.cli.export import export_command
from matrixworld.cli.options import Commands
from matrixworld.cli.playground import playground_command
from matrixworld.cli.plot import plot_command
from matrixworld.cli.replay import replay_command
from matrixworld.cli.score import score_command
from matrixworld.cli.tournament import tournament_command
from matrixworld.cli.variants import variants_command
from matrixworld.version import __version__

__all__ = ["main"]


@click.group(
    cls=Commands, context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100}
)
@click.version_option(__version__)
def main() -> None:
    """Pursuers and evaders on a grid that evolve against each other.

    Start with `matrixworld evolve`: it runs three races in some minutes, judges and compares them,
    and says what to try next.
    """


for command in (
    evolve_command,
    replay_command,
    tournament_command,
    score_command,
    exploit_command,
    explore_command,
    playground_command,
    plot_command,
    diagnose_command,
    analyze_command,
    class_command,
    export_command,
    variants_command,
    bench_command,
):
    main.add_command(command)
