"""``matrixworld play``: a page on which a person plays one agent of a match."""

from __future__ import annotations

from pathlib import Path

import click

from matrixworld.cli.arguments import race_option
from matrixworld.cli.console import say
from matrixworld.cli.explore import open_option, open_page
from matrixworld.cli.options import force_option, out_option, refuse_existing
from matrixworld.cli.replay import source_of
from matrixworld.coevolution import open_run
from matrixworld.explorer.page import write_page
from matrixworld.explorer.play_page import PAGE, of_run, play_page, shipped
from matrixworld.world.rules import Rules

# \b keeps click from wrapping the lines.
EXAMPLES = """\b
Examples:
  matrixworld play
  matrixworld play SB
  matrixworld play runs/O-seed0 --race hall-of-fame
"""


def _source(ctx: click.Context, param: click.Parameter, value: str) -> Path | Rules:
    if Path(value).is_file():
        raise click.BadParameter(
            f"expected the directory of a run, or a variant, got a file: {value}; "
            "a match that you have played opens in the page, and with matrixworld replay"
        )
    return source_of(ctx, param, value)


@click.command("play", epilog=EXAMPLES, short_help="Play an agent yourself on a page.")
@click.argument("source", metavar="[RUN|VARIANT]", default="O", callback=_source)
@race_option
@out_option(f"the page  [default: {PAGE}, of a RUN in its directory]")
@open_option
@force_option
def play_command(source: Path | Rules, out: Path | None, opens: bool, force: bool) -> None:
    """Write a page on which you play one agent of a match, and open it.

    With RUN, you play against its generations, in its world. With VARIANT (default O), you play
    against scripts and the evolved opponents that come with the package, in a small world. "Can you
    escape it?" is a game of three rounds: you are the only evader, and each round has stronger
    pursuers.

    The page keeps a played match as a file; matrixworld replay FILE shows it, and --out of that
    command makes a GIF of it.
    """
    page = out or (Path(PAGE) if isinstance(source, Rules) else source / PAGE)
    refuse_existing(page, force=force)
    write_page(page, _page(source))
    say(page)
    if opens:
        open_page(page)


def _page(source: Path | Rules) -> str:
    if isinstance(source, Rules):
        return play_page("matrixworld play", *shipped(source))
    return play_page(f"{source.absolute().name} - matrixworld play", *of_run(open_run(source)))
