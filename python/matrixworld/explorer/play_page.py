"""The page on which a person plays one agent of a match, against scripts or generations.

>>> from matrixworld.explorer.play_page import play_page, shipped
>>> html = play_page("matrixworld play", *shipped("SB"))
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from matrixworld.coevolution.evaluation.scores import held_out
from matrixworld.coevolution.storage import SavedRun
from matrixworld.coevolution.types import TEAMS, Team
from matrixworld.explorer.page import render_page
from matrixworld.explorer.runs_page import kept_generations, packed, plain_network, step_of
from matrixworld.version import __version__
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import SCRIPT_TEXTS, Population, TeamPolicy
from matrixworld.world.rules import Capture, Rules, rules_of

PAGE = "play.html"
"""Name of the page where no other is given."""
LIVELY = "clumsy-fleer"
"""The evaders that a match begins with where they are there: the strongest are hardly caught."""
NETWORK_TEXT = "a network that evolved in a race"

Players = Mapping[Team, Mapping[str, TeamPolicy]]
"""What plays for each team, by name, roughly from weak to strong; populations have one genome."""


def shipped(variant: Rules | str) -> tuple[WorldConfig, Players]:
    """Return a world that suits a person, and the opponents that come with the package."""
    rules = rules_of(variant)
    # It takes up to four pursuers to surround an evader.
    sizes = (8, 4) if rules.capture is Capture.SURROUND else (4, 6)
    config = WorldConfig(
        rules, rows=20, cols=20, n_pursuers=sizes[0], n_evaders=sizes[1], max_steps=200
    )
    return config, {team: _by_strength(held_out(team, rules)) for team in TEAMS}


def _by_strength(players: Mapping[str, TeamPolicy]) -> dict[str, TeamPolicy]:
    """Return players with the networks between weak and strong scripts (docs/opponents.md)."""
    networks = [name for name, each in players.items() if isinstance(each, Population)]
    scripts = [name for name in players if name not in networks]
    return {name: players[name] for name in [*scripts[:2], *networks, *scripts[2:]]}


def of_run(run: SavedRun) -> tuple[WorldConfig, Players]:
    """Return the world of a run and its generations, as many as a page can hold."""
    step = step_of([run])
    return run.settings.world, {team: _generations(run.teams[team], step) for team in TEAMS}


def _generations(team: TeamPolicy, step: int) -> dict[str, TeamPolicy]:
    if isinstance(team, str):
        return {team: team}
    kept = kept_generations(len(team.genomes), step)
    return {f"generation {g}": Population(team.genomes[g], team.network) for g in kept}


def play_page(title: str, config: WorldConfig, players: Players) -> str:
    """Return the page as HTML."""
    teams, blobs = {}, {}
    for team in TEAMS:
        teams[team], blobs[str(team)] = _plain_players(players[team])
    data = {"version": __version__, "title": title, "world": config.to_json(), "teams": teams}
    return render_page("play", title, data, blobs)


def _plain_players(players: Mapping[str, TeamPolicy]) -> tuple[dict[str, Any], bytes]:
    """Return the players of a team as plain values, and their genomes, as `packed` does."""
    networks = [each for each in players.values() if isinstance(each, Population)]
    known = [plain_network(each) for each in networks[:1]]
    names = list(players)
    return {
        "names": names,
        "texts": [_text(name, each) for name, each in players.items()],
        "usual": names.index(LIVELY) if LIVELY in names else len(names) - 1,
        # None stands for the next genome.
        "scripts": [each if isinstance(each, str) else None for each in players.values()],
        "network": known[0] if known else None,
    }, packed(np.concatenate([each.genomes for each in networks])) if networks else b""


def _text(name: str, player: TeamPolicy) -> str:
    """Return what a player does; the generations of a run need no words."""
    if isinstance(player, str):
        return SCRIPT_TEXTS[player]
    return NETWORK_TEXT if name.startswith("evolved") else ""
