"""``matrixworld playground``: write the page on which conflicts are played by hand, and open it."""

from __future__ import annotations

import webbrowser
from pathlib import Path

import click

from matrixworld.cli.arguments import failures
from matrixworld.cli.console import note
from matrixworld.cli.options import force_option, refuse_existing
from matrixworld.explorer.page import write_page
from matrixworld.explorer.playground import PAGE, Playground


@click.command("playground")
@click.option(
    "--output",
    "-o",
    type=click.Path(path_type=Path, dir_okay=False),
    default=Path(PAGE),
    show_default=True,
    metavar="FILE",
    help="the page",
)
@click.option("--open/--no-open", "opens", default=True, help="open the page in a browser")
@force_option
def playground_command(output: Path, opens: bool, force: bool) -> None:
    """Write the playground, one page that plays conflicts by hand, and open it.

    Choose a variant or rules of your own, place agents and obstacles, give each agent a move or a
    script, and read every conflict of a step in words. The page is a single file that needs no
    network and no installation; it holds the engine.
    """
    with failures():
        html = Playground().html()
        if not _holds(output, html):
            refuse_existing(output, force=force)
            write_page(output, html)
        click.echo(output)
        if opens and not webbrowser.open(output.absolute().as_uri()):
            note("No browser was found here; open the file in one.")


def _holds(file: Path, html: str) -> bool:
    """Return whether a file is this very page already: then there is nothing to replace."""
    return file.is_file() and file.read_bytes() == html.encode()
