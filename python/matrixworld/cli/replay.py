"""``matrixworld replay``: watch an episode."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import click

from matrixworld._util import checks
from matrixworld._util.files import replacing
from matrixworld._util.teams import PLURALS
from matrixworld.cli import options
from matrixworld.cli.console import counted, say, warnings_as_notes
from matrixworld.cli.setting_options import usage_errors
from matrixworld.coevolution import TEAMS, ProgressBar, SavedRun, Team, open_run
from matrixworld.coevolution.games.own_game import OwnGame
from matrixworld.coevolution.runs.places import find_runs
from matrixworld.coevolution.seeding import evaluation_seed
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
        refused = options.refusal(value, f"{expected} ({', '.join(VARIANTS)})")
        raise click.BadParameter(refused) from None


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
    first team and --evader of the second. An image needs --out, a .png, and a film a .gif.

    \b
    Examples:
      matrixworld replay runs/courtyard-seed0/generalist-generalist --pursuer 30 --evader 15
      matrixworld replay my-race --out match.gif
      matrixworld replay SB --pursuer surrounder --obstacles 0.1
      matrixworld replay my-race --step 17 --explain
    """
    chosen = options.given(click.get_current_context().params)
    run = None
    if isinstance(source, Path) and source.is_dir():
        with usage_errors():
            run = open_run(options.run_in(source, chosen.get("race")))
        if isinstance(run.settings.game, OwnGame):
            show_match(run, chosen, out, force=force)
            return
    suffix = out.suffix.lower() if out else ""
    if suffix in ("", ".npz"):  # the terminal shows no numbers
        options.refuse_beside("--out", chosen.keys() & {"numbers"}, fact="writes no picture")
    if suffix not in ("", ".png"):
        options.refuse_beside("--out", chosen.keys() & {"step"}, fact="writes no .png")
    options.check_outputs(out, force=force)
    of_game = options.given(game)
    episode = game["episode"]
    with usage_errors():
        if run is not None:
            played = _match_of_run(run, of_game, episode)
        elif isinstance(source, Rules):
            played = _new_match(source, of_game, episode)
        else:
            played = _saved_episode(source, of_game)
        step = None if step is None else step_number(step, played.length)
        lines = _explained(played, step) if explain else []
    if out:
        _write(played, out, step, numbers=numbers)
    elif step is not None:
        replay.print_moment(played, step=step)
    elif not explain:
        replay.animate_terminal(played)
    for line in lines:
        say(line)
    captured = int(played.counted[-1].sum())
    evaders = counted(played.n_evaders, "evader")
    steps = counted(played.length, "step")
    say(f"{captured} of {evaders} captured, {steps}  {out or ''}".rstrip())


def _write(played: Episode, out: Path, step: int | None, *, numbers: bool) -> None:
    """Write an episode as data, as a film, or as the picture of a step, by default the last."""
    suffix = out.suffix.lower()
    if suffix == ".npz":
        played.save(out)
        return
    every = max(1, round(played.length / FRAMES))
    moment = -1 if step is None else step
    replay.save(played, out, every=every, step=moment, numbers=numbers)
    if every > 1 and suffix in (".gif", ".mp4"):
        say(f"Every {every} steps are a frame.")


def _explained(played: Episode, step: int | None) -> list[str]:
    """Return why agents bounced or disappeared in a step, or in all of them."""
    lines = []
    for now in range(1, played.length + 1) if step is None else [step]:
        lines += [f"step {now}  {reason}" for reason in played.explain(now)]
    if not lines:
        lines.append("no conflicts" if step is None else f"step {step}  no conflicts")
    return lines


# The match of a game of your own:


def show_match(run: SavedRun, chosen: Mapping[str, Any], out: Path | None, *, force: bool) -> None:
    """Print or write what the game of a run shows of two genomes."""
    others = chosen.keys() - {"source", "race", "out", "force", *TEAMS}
    options.refuse_beside(str(run.path), others, fact="is a run of a game of your own")
    options.check_outputs(out, force=force)
    with warnings_as_notes(), usage_errors():
        genomes = []
        for team, key in zip(TEAMS, run.settings.keys, strict=True):
            number = _generation(run, key, str(chosen.get(team, -1)), team)
            genomes.append(run.teams[key].genomes[number])
        shown = run.settings.evaluation_game.shown(*genomes)
    if isinstance(shown, str):
        options.refuse_beside("the game", {"out"} & chosen.keys(), fact="shows text")
        say(shown)
        return
    if not out or out.suffix.lower() != shown.suffix:
        what = {".png": "an image", ".gif": "a film"}[shown.suffix]
        expected = f"expected a {shown.suffix}, because the game shows {what}"
        raise click.UsageError(f"--out: {expected}, got {out or 'none'}")
    with replacing(out) as file:
        file.write(shown.content)
    say(out)


# The episode of a source; each function refuses options that say nothing about it:


def _saved_episode(file: Path, chosen: Mapping[str, Any]) -> Episode:
    """Return the episode in a file."""
    options.refuse_beside(str(file), chosen, fact="is a single episode")
    return Episode.load(file)


def _match_of_run(run: SavedRun, chosen: Mapping[str, Any], episode: int) -> Episode:
    """Play an episode of a run's payoff matrix, perhaps with others in place of generations."""
    others = chosen.keys() - {"race", "episode", *TEAMS}
    options.refuse_beside(str(run.path), others, fact="is a run")
    config = run.pursuit.world
    pursuers, g = _player(config, run, "pursuer", chosen.get("pursuer", "-1"))
    evaders, h = _player(config, run, "evader", chosen.get("evader", "-1"))
    seed = evaluation_seed(run.settings.seed, g, h)
    sides = pursuers, evaders
    return run.pursuit.record(*sides, seed=seed, pursuer=g, evader=h, episode=episode)


def _new_match(rules: Rules, chosen: Mapping[str, Any], episode: int) -> Episode:
    """Play an episode under some rules, of scripts or what files hold."""
    world = {name: chosen[name] for name in ("rows", "cols", "obstacles") if name in chosen}
    if "steps" in chosen:
        world["max_steps"] = chosen["steps"]
    config = WorldConfig(rules, **world)
    pursuers, _ = _player(config, None, "pursuer", chosen.get("pursuer", CHASER))
    evaders, _ = _player(config, None, "evader", chosen.get("evader", FLEER))
    return record(config, pursuers, evaders, seed=chosen.get("seed", 0), episode=episode)


def _player(
    config: WorldConfig, run: SavedRun | None, team: Team, who: str
) -> tuple[EnginePolicy, int]:
    """Return what plays for a team in the world of a run or a new one, and its generation or 0."""
    if who == SOLVED:
        with ProgressBar(after=1.0) as bar:
            return solve(States(config, report=bar.share)).policy(team), 0
    if who.lower().endswith(".npz"):
        of_team, population = read_genome(who)
        if of_team != team:
            got = f"one of {PLURALS[of_team]}: {who}"
            raise ValueError(f"{team}: expected a file of {PLURALS[team]}, got {got}")
        return population, 0
    if run is None:
        checks.check_choice(team, who, (*SCRIPTS, SOLVED))
        return who, 0
    return run.teams[team], _generation(run, team, who, team)


def _generation(run: SavedRun, key: str, who: str, option: Team) -> int:
    if not re.fullmatch(r"-?\d+", who):
        raise ValueError(f"{option}: expected a generation of the run, got {who!r}")
    return run.generation(key, int(who), option)
