"""The command: a tournament of policies that students hand in, and a file to hand in."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import fields
from pathlib import Path
from typing import Any

import click

from class_tournament.policy_process import Limits
from class_tournament.results import class_json, class_page
from class_tournament.round_robin import play_class
from matrixworld._util.files import one_line
from matrixworld.cli import Commands
from matrixworld.cli import options as cli_options
from matrixworld.cli.console import TERMS, note, say
from matrixworld.cli.pages import open_page
from matrixworld.cli.setting_options import usage_errors
from matrixworld.coevolution import ProgressBar, open_run
from matrixworld.coevolution.settings.race_settings import MOST_SEED
from matrixworld.explorer.page import write_page
from matrixworld.play import save_genome
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import TEAMS, Team

GAME: dict[str, Any] = {"variant": "O", "n_pursuers": 4, "n_evaders": 4, "steps": 100}
"""The game where options do not say otherwise: smaller and shorter than that of `evolve`."""
SIZE: dict[str, Any] = {"rows": 16, "cols": 16}
"""Its grid, if no map gives one."""
SUFFIX = ".npz"


class ClassCommands(Commands):
    """``DIR`` plays a tournament; what else there is has a name."""

    format_commands = click.Group.format_commands  # its own, not those of the package

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Take words that do not begin with the name of a command for those of ``play``."""
        if args and args[0] not in {*self.commands, *ctx.help_option_names}:
            args = ["play", *args]
        return super().parse_args(ctx, args)


def limit_options(command: Callable[..., Any]) -> Callable[..., Any]:
    """Give a command an option for each of the limits."""
    for limit in reversed(fields(Limits)):
        command = click.option(
            cli_options.option_name(limit.name),
            type=type(limit.default),
            default=limit.default,
            show_default=True,
            metavar="NUMBER",
            help=f"limit: {limit.metadata['help']}",
        )(command)
    return command


@click.group(
    cls=ClassCommands,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
)
def main() -> None:
    """Play a tournament of policies that students have handed in, or write one to hand in.

    `class_tournament DIR` is `class_tournament play DIR`.
    """


@main.command("play")
@click.argument(
    "directory", metavar="DIR", type=click.Path(exists=True, file_okay=False, path_type=Path)
)
@cli_options.integer(
    "--episodes", "episodes of each pair; all pairs play the same starts", least=2, default=10
)
@cli_options.integer(
    "--seed",
    "repeat the tournament that printed this seed  [default: one that nobody can know before]",
    least=0,
    most=MOST_SEED,
)
@cli_options.out("the page  [default: DIR.html, beside DIR]")
@cli_options.shared("open", "json", "force", "threads", "variant", "obstacles", "fov", "diagonal")
@cli_options.shared("rows", "cols", "n_pursuers", "n_evaders")
@cli_options.integer("--steps", "most steps of an episode  [default: 100]")
@limit_options
@click.option(
    "--trust",
    is_flag=True,
    help="run programs with the rights of your own: only if you have read all of them",
)
def play_command(
    directory: Path,
    out: Path | None,
    opens: bool,
    json_file: Path | None,
    force: bool,
    **options: Any,
) -> None:
    """Play a class tournament: every pursuer that was handed in against every evader.

    DIR holds NAME.py, a program with a function pursue(view, rng) or evade(view, rng) or both, or
    NAME.npz, a genome that `export` writes. NAME.jsonl, a student's predictions in the course, is a
    vote that the page counts. Files may also lie in a directory for each student, DIR/NAME/.
    Programs run in processes of their own, without files, network or other processes, with limits
    of time and memory. What breaks a rule is left out, and the page says why; README.md tells the
    rules.

    By default 4 pursuers play against 4 evaders in O, on 16 x 16 cells or a map, for at most 100
    steps.
    """
    page = out or directory.absolute().with_name(f"{directory.absolute().name}.html")
    # The page is the only record of a tournament whose files may have changed.
    cli_options.check_outputs(page, json_file, force=force, redraws=False)
    given = {name: options.pop(name) for name in ("episodes", "seed", "trust", "threads")}
    config, limits = _checked(options)
    if given["trust"]:
        note("Programs run with the rights of your own (--trust).")
    try:
        with ProgressBar() as bar:
            result = play_class(directory, config, limits=limits, report=bar, **given)
    except ValueError as error:
        raise click.ClickException(str(error)) from error
    say(result)  # first: a page that cannot be written must not lose the results
    say(f"\nA range of ranks: the episodes cannot tell more. {TERMS}")
    say(f"--seed {result.seed} plays this tournament again.")
    write_page(page, class_page(result, title=one_line(directory.absolute().name)))
    say(f"\nWritten: {page}")
    cli_options.write_json(json_file, class_json(result))
    open_page(page, opens)


def _checked(options: dict[str, Any]) -> tuple[WorldConfig, Limits]:
    limits = {limit.name: options.pop(limit.name) for limit in fields(Limits)}
    given = {name: value for name, value in options.items() if value is not None}
    size = {} if isinstance(given.get("obstacles"), str) else SIZE
    settings = {**size, **GAME, **given}
    with usage_errors():
        config = WorldConfig.of(
            settings.pop("variant"), max_steps=settings.pop("steps"), **settings
        )
        return config, Limits(**limits)


@main.command("export")
@click.argument("run")
@cli_options.shared("race")
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
@cli_options.out("the file; its name ends in .npz", required=True)
@cli_options.shared("force")
def export_command(
    run: str, race: str | None, team: Team, generation: int, out: Path, force: bool
) -> None:
    """Write a genome of RUN with its network to a file.

    RUN is the directory of a run, or of a job of one. The file holds numbers only, and can be
    handed in for a tournament.
    """
    if out.suffix.lower() != SUFFIX:
        raise click.UsageError(f"--out: expected a name that ends in {SUFFIX}, got {out}")
    cli_options.check_outputs(out, force=force)
    with usage_errors():
        policy = open_run(cli_options.run_in(run, race)).policy(team, generation)
    save_genome(out, team, policy)
    say(out)
