"""``matrixworld explain``: what teams do, in words and numbers."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from matrixworld._util.teams import PLURALS
from matrixworld.cli import console, options
from matrixworld.cli.setting_options import usage_errors
from matrixworld.coevolution import TEAMS, ProgressBar, Team, open_run
from matrixworld.coevolution.evaluation.trials import EPISODES
from matrixworld.coevolution.games.own_game import OwnGame


@click.command("explain")
@click.argument("run", type=click.Path(path_type=Path))
@options.shared("race")
@click.option(
    "--team",
    type=click.Choice(TEAMS),
    metavar="TEAM",
    help="pursuer or evader  [default: each that learned]",
)
@click.option("--generation", default=-1, metavar="NUMBER", help="which one  [default: the last]")
@options.integer("--episodes", "episodes against each opponent", least=2, default=EPISODES)
@options.shared("seed", "json", "force", "threads")
def explain_command(
    run: Path,
    race: str | None,
    team: Team | None,
    json_file: Path | None,
    force: bool,
    **chosen: Any,
) -> None:
    """Say what teams do.

    Ratings: what is lost in matches without each of their named inputs, and a sentence of what
    agents do that is worth something. Programs: what they do case by case. Networks over cells: a
    decision tree that imitates them, with its own score beside theirs, since trees that mostly
    agree may still play badly. Trees need the extra `explain`.

    RUN is the directory of a run, or of a job of one, which need not be finished. Scores are
    against held-out opponents, in episodes that no other command plays. Of a game of your own
    it prints the genomes of the last generation, and whom they win and lose against.
    """
    options.check_outputs(json_file, force=force)
    plain: dict[str, Any] = {}
    with usage_errors():
        saved = open_run(options.run_in(run, race))
        is_own = isinstance(saved.settings.game, OwnGame)
        for explained in [team] if team else saved.settings.learning_teams:
            if is_own:
                key = saved.facts.keys[TEAMS.index(explained)]
                explanation = saved.explain(key, chosen["generation"])
                name = saved.facts.teams[TEAMS.index(explained)]
            else:
                with ProgressBar() as bar:
                    explanation = saved.explain(explained, **chosen, report=bar)
                name = PLURALS[explained]
            console.print_head(f"{saved.path}: {name} of generation {explanation.generation}")
            console.say(explanation)
            plain[name] = explanation.to_json()
    options.write_json(json_file, {"run": str(saved.path), "seed": chosen["seed"], **plain})
