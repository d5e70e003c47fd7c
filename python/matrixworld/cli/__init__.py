"""The command ``matrixworld``: its commands, and what they share.

Commands print what the library computes. Runs that differ in their seed only are told together, as
a `matrixworld.coevolution.RunGroup`.
"""

from __future__ import annotations

from collections import UserDict
from importlib import import_module
from typing import Any

import click

from matrixworld._util.exit_codes import INTERRUPTED
from matrixworld.version import __version__

__all__ = ["main"]

COMMANDS = {
    "evolve": ("evolve", "Start races, or continue them."),
    "explain": ("explain", "Say what teams do, input by input."),
    "explore": ("pages", "Show runs as a page or as figures."),
    "grade": ("grade", "Say what players guarantee, exactly."),
    "judge": ("judge", "Say what happened in races."),
    "playground": ("pages", "Play an agent or conflicts on a page."),
    "replay": ("replay", "Watch an episode, or write it to files."),
    "score": ("score", "Play against held-out opponents."),
    "solve": ("solve", "Solve a small world exactly."),
    "tournament": ("tournament", "Play every generation against every other."),
}
"""Module and summary of each command."""


class Imported(UserDict[str, Any]):
    """The commands by their names, each imported when it is looked up: all take half a second."""

    def __getitem__(self, name: str) -> click.Command:
        module, _ = self.data[name]
        command: click.Command = getattr(import_module(f"{__name__}.{module}"), f"{name}_command")
        return command


class Commands(click.Group):
    """A group of commands whose failures are messages, and which Ctrl-C stops."""

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write what the commands do, for the help text."""
        with formatter.section("Commands"):
            formatter.write_dl([(name, text) for name, (_, text) in COMMANDS.items()])

    def invoke(self, ctx: click.Context) -> Any:
        """Run the command; Ctrl-C stops it."""
        try:
            return self._invoke(ctx)
        except KeyboardInterrupt:
            click.echo("\nStopped. No file is half written.", err=True)
            raise click.exceptions.Exit(INTERRUPTED) from None

    def _invoke(self, ctx: click.Context) -> Any:
        """Run the command; failures become messages."""
        from matrixworld._util.files import printable, sentence_of
        from matrixworld.cli.options import FAILURES  # half a second

        try:
            return super().invoke(ctx)
        except click.ClickException as error:
            # It may quote a name or a file.
            error.message = printable(error.message)  # type: ignore[misc]  # Final
            raise
        except BrokenPipeError:  # the reader of the output has gone, which click handles
            raise
        except MemoryError as error:
            problem = "this machine has too little memory for these sizes"
            raise click.ClickException(problem) from error
        except FAILURES as error:
            raise click.ClickException(printable(sentence_of(error))) from error


@click.group(
    cls=Commands,
    commands=Imported(COMMANDS),
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
)
@click.version_option(__version__)
def main() -> None:
    """Pursuers and evaders on a grid that evolve against each other.

    Start with `matrixworld evolve`: it runs three races in a minute, judges and compares them,
    and says what to try next.
    """
