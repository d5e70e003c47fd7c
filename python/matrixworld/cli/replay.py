"""``matrixworld replay``: watch an episode."""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import partial
from pathlib import Path
from typing import Any

import click

from matrixworld._util import checks
from matrixworld._util.files import replacing
from matrixworld.cli import options
from matrixworld.cli.console import say, warnings_as_notes
from matrixworld.cli.setting_options import usage_errors
from matrixworld.coevolution import TEAMS, ProgressBar, SavedRun, Team, open_run
from matrixworld.coevolution.seeding import evaluation_seed
from matrixworld.coevolution.storage import find_runs
from matrixworld.envs.opponents import SOLVED
from matrixworld.episodes import replay
from matrixworld.episodes.episode import Episode, step_number
from matrixworld.episodes.record import record
from matrixworld.play import read_genome
from matrixworld.solver import States, solve
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import SCRIPTS, EnginePolicy
from matrixworld.world.rules import VARIANTS, Rules, rules_of

SUFFIXES = (".gif", ".mp4", ".png", ".npz")
FRAMES = 100
"""About how many frames a GIF or film has: as many as are shown in 10 seconds."""
CHASER, FLEER = "chaser", "fleer"


def _out(ctx: click.Context, param: click.Parameter, path: Path | None) -> Path | None:
    if path is not None and path.suffix.lower() not in SUFFIXES:
        raise click.BadParameter(f"expected a name that ends in {', '.join(SUFFIXES)}: {path}")
    return path


def source_of(ctx: click.Context, param: click.Parameter, value: str) -> Path | Rules:
    """Return a file, else a directory that holds runs, else the rules of a variant."""
    # Paths come first: a run may be called O, and `O` in another directory is the variant.
    path = options.unpacked(Path(value))
    if path.is_file() or find_runs(path):
        return path
    try:
        return rules_of(value)
    except ValueError:
        expected = "the directory of a run, the file of an episode, or a variant"
        told = options.refusal(value, f"{expected} ({', '.join(VARIANTS)})")
        raise click.BadParameter(told) from None


@click.command("replay")
@click.argument("source", metavar="RUN|FILE|VARIANT", callback=source_of)
@options.shared("race")
@click.option(
    "--pursuer",
    metavar="WHO",
    help="generation of the run, script, .npz file of a genome, or solved: perfect play, in "
    f"small worlds  [default: the last; of a VARIANT {CHASER}]",
)
@click.option(
    "--evader", metavar="WHO", help=f"the same  [default: the last; of a VARIANT {FLEER}]"
)
@options.integer(
    "--episode", "which episode of the match or seed", least=0, most=checks.SEED_MAX, default=0
)
@options.shared("seed", "steps")
@options.out(
    "write the episode to a file instead of showing it: .gif, .mp4 (of a long episode some steps), "
    ".png (one moment: --step) or .npz (its data)",
    callback=_out,
)
@options.shared("force")
@click.option(
    "--step",
    type=int,
    metavar="STEP",
    help="the moment of a .png; without --out, the only one shown; negative numbers count from the "
    "end  [default: the end]",
)
@click.option(
    "--explain",
    is_flag=True,
    help="print why agents bounced or disappeared: in all steps instead of the animation, or in "
    "--step",
)
@click.option("--numbers", is_flag=True, help="agents carry their numbers in pictures")
@options.shared("rows", "cols", "obstacles")
def replay_command(
    source: Path | Rules,
    out: Path | None,
    force: bool,
    step: int | None,
    explain: bool,
    numbers: bool,
    **game: Any,
) -> None:
    """Watch an episode in the terminal, or write it to files.

    RUN: an episode of the run's payoff matrix, played again. WHO is a generation; negative numbers
    count from the last. FILE: an episode that --out or Episode.save has written. VARIANT (O, SB,
    ...): a new game between scripts, with --seed, --steps and the options of the world. WHO is
    the name of a script, such as chaser or fleer; an unknown name prints all of them.

    RUN of a game of your own: what the game shows of a match of two generations, --pursuer of its
    first team and --evader of the second. An image needs --out, a .png.

    \b
    Examples:
      matrixworld replay runs/courtyard-seed0/generalist-generalist --pursuer 30 --evader 15
      matrixworld replay my-race --out match.gif
      matrixworld replay SB --pursuer surrounder --obstacles 0.1
      matrixworld replay my-race --step 17 --explain
    """
    given = options.given(click.get_current_context().params)
    if isinstance(source, Path) and source.is_dir():
        run = open_run(options.run_in(source, given.get("race")))
        if run.settings.game:
            show_match(run, given, out, force=force)
            return
    suffix = out.suffix.lower() if out else ""
    if suffix in ("", ".npz"):  # the terminal shows no numbers
        options.refuse_beside("--out writes no picture", given.keys() & {"numbers"})
    if suffix not in ("", ".png"):
        options.refuse_beside("--out writes no .png", given.keys() & {"step"})
    options.check_outputs(out, force=force)
    with usage_errors():
        played = _match(source, options.given(game))(episode=game["episode"])
        step = None if step is None else step_number(step, played.length)
        steps = range(1, played.length + 1) if step is None else [step]
        lines = [f"step {now}  {why}" for now in steps if explain for why in played.explain(now)]
    if explain and not lines:
        lines = ["no conflicts" if step is None else f"step {step}  no conflicts"]
    every = max(1, round(played.length / FRAMES))
    if out and suffix == ".npz":
        played.save(out)
    elif out:
        moment = -1 if step is None else step
        replay.save(played, out, every=every, step=moment, numbers=numbers)
    if every > 1 and suffix in (".gif", ".mp4"):
        say(f"Every {every} steps are a frame.")
    if not out and step is not None:
        replay.print_moment(played, step=step)
    elif not (out or explain):
        replay.animate_terminal(played)
    for line in lines:
        say(line)
    caught, of = int(played.counted[-1].sum()), played.n_evaders
    say(f"{caught} of {of} evaders captured, {played.length} steps  {out or ''}".rstrip())


# The match of a game of your own:


def show_match(run: SavedRun, given: Mapping[str, Any], out: Path | None, *, force: bool) -> None:
    """Print or write what the game of a run shows of two genomes."""
    known = {"source", "race", "out", "force", *TEAMS}
    options.refuse_beside(f"{run.path} is a run of a game of your own", given.keys() - known)
    options.check_outputs(out, force=force)
    with warnings_as_notes(), usage_errors():
        genomes = []
        for team, key in zip(TEAMS, run.settings.keys, strict=True):
            number = _generation(run, key, str(given.get(team, -1)), team)
            genomes.append(run.teams[key].genomes[number])
        shown = run.settings.evaluation_game.shown(*genomes)
    if isinstance(shown, str):
        options.refuse_beside("the game shows text", {"out"} & given.keys())
        say(shown)
        return
    if not out or out.suffix.lower() != ".png":
        expected = "expected a .png, because the game shows an image"
        raise click.UsageError(f"--out: {expected}, got {out or 'none'}")
    with replacing(out) as file:
        file.write(shown)
    say(out)


# The match of a source:


def _match(source: Path | Rules, given: dict[str, Any]) -> Any:
    """Return `record` for the episodes of a source; refuse options that say nothing about it."""
    if isinstance(source, Path) and source.is_file():
        options.refuse_beside(f"{source} is a single episode", given)
        return lambda episode: Episode.load(source)
    given.pop("episode", None)
    race = given.pop("race", None)
    named = {team: given.pop(team) for team in TEAMS if team in given}
    if isinstance(source, Rules):
        run, seed = None, given.pop("seed", 0)
        if "steps" in given:
            given["max_steps"] = given.pop("steps")
        config = WorldConfig(source, **given)
        named = {"pursuer": CHASER, "evader": FLEER, **named}
    else:
        run = open_run(options.run_in(source, race))
        options.refuse_beside(f"{run.path} is a run", given)
        config = run.settings.world
        named = {"pursuer": "-1", "evader": "-1", **named}
    pursuers, g = _player(config, run, "pursuer", named["pursuer"])
    evaders, h = _player(config, run, "evader", named["evader"])
    if run is not None:
        seed = evaluation_seed(run.settings.seed, g, h)
    return partial(record, config, pursuers, evaders, seed=seed, pursuer=g, evader=h)


def _player(
    config: WorldConfig, run: SavedRun | None, team: Team, who: str
) -> tuple[EnginePolicy, int]:
    """Return what plays for a team in the world of a run or a new one, and its generation or 0."""
    if who == SOLVED:
        with ProgressBar(after=1.0) as bar:
            return solve(States(config, report=bar.share)).policy(team), 0
    if who.lower().endswith(".npz"):
        found, population = read_genome(who)
        checks.expect(found == team, team, f"a file of {team}s", f"one of {found}s: {who}")
        return population, 0
    if run is None:
        checks.check_choice(team, who, (*SCRIPTS, SOLVED))
        return who, 0
    return run.teams[team], _generation(run, team, who, team)


def _generation(run: SavedRun, key: str, who: str, option: Team) -> int:
    is_number = re.fullmatch(r"-?\d+", who)
    checks.expect(is_number, option, "a generation of the run", repr(who))
    return run.generation(key, int(who), option)
