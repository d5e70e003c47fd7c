"""The command ``matrixworld``: its commands, and what they share.

Commands print what the library computes. Runs that differ in their seed only are told together, as
a `matrixworld.coevolution.RunGroup`.
"""

from __future__ import annotations

import click

from matrixworld.cli.classroom import class_command
from matrixworld.cli.evaluate import score_command, tournament_command
from matrixworld.cli.evolve import evolve_command
from matrixworld.cli.exploit import exploit_command, solve_command
from matrixworld.cli.judge import judge_command
from matrixworld.cli.options import Commands
from matrixworld.cli.pages import explore_command, play_command, playground_command
from matrixworld.cli.replay import replay_command
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
    judge_command,
    explore_command,
    replay_command,
    score_command,
    tournament_command,
    exploit_command,
    solve_command,
    class_command,
    play_command,
    playground_command,
):
    main.add_command(command)
