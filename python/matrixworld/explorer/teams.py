"""Teams and games as plain values: policies, genomes as bytes, and what games of your own show."""

from __future__ import annotations

import base64
import zlib
from collections.abc import Sequence
from itertools import product
from math import isqrt
from typing import Any

import numpy as np

from matrixworld.coevolution.games.game import Game
from matrixworld.coevolution.games.own_game import OwnGame
from matrixworld.coevolution.saved_run import SavedRun
from matrixworld.coevolution.types import TEAMS, Genomes
from matrixworld.episodes.episode import animation
from matrixworld.play.player import Player
from matrixworld.world.policy import SCRIPTS, Population, TeamPolicy
from matrixworld.world.program import Program

MOST_BYTES = 48 * 2**20
"""Genomes of a page, in bytes; base64 adds a third. A race of networks has 2.9 MB."""


def step_of(runs: Sequence[SavedRun], most: int = MOST_BYTES) -> int:
    """Return the step between generations, one for all runs, whose genomes fit in `most` bytes."""
    learned = [team for run in runs for team in run.sides if isinstance(team, Population)]
    longest = max((len(team.genomes) for team in learned), default=1)

    def size(step: int) -> int:
        kept = (len(kept_generations(len(team.genomes), step)) for team in learned)
        return sum(n * team.genomes[0].nbytes for n, team in zip(kept, learned, strict=True))

    return next((step for step in range(1, longest) if size(step) <= most), longest)


def kept_generations(count: int, step: int) -> list[int]:
    """Return every generation by a step, and the last one."""
    return sorted({*range(0, count, step), count - 1})


def plain_team(
    team: TeamPolicy | Player, identifier: str, step: int, genomes: dict[str, bytes]
) -> dict[str, Any]:
    """Return a team as plain values, and add its genomes to the others."""
    if not isinstance(team, Population):
        script = team if isinstance(team, str) else None
        if isinstance(team, Player):  # the page does not play it: see `plain_game`
            script = team.name
        return {"script": script, "policy": None, "kept": [0], "genomes": ""}
    kept = kept_generations(len(team.genomes), step)
    policy, shown = team.policy, team.genomes[kept]
    genomes[identifier] = packed(shown)
    return {
        "script": None,
        "policy": plain_policy(team),
        "kept": kept,
        "genomes": identifier,
        "expressions": [policy.expression(g) for g in shown] if isinstance(policy, Program) else [],
        "weights": [policy.weights(g) for g in shown] if isinstance(policy, Program) else [],
        "words": "",
    }


def plain_policy(team: Population) -> dict[str, Any]:
    """Return the policy of a population as a page reads it, without genomes."""
    return {**team.policy.to_json(), "genome_size": team.policy.genome_size}


def packed(genomes: Genomes) -> bytes:
    """Return genomes (generations, genes) as bytes, of which a page makes the same numbers."""
    # A generation differs from the one before in the low bits of its numbers: each is joined by
    # exclusive or with that one, equal places of the float32 come together, and are compressed.
    bits = np.ascontiguousarray(genomes, dtype="<f4").view("<u4")
    bits = np.concatenate([bits[:1], bits[1:] ^ bits[:-1]])
    planes = bits.view(np.uint8).reshape(-1, bits.itemsize).T
    return zlib.compress(planes.tobytes(), 9)


# ---- Games of your own -------------------------------------------------------------------------

MOST_SHOWN = 200  # the most cells of a page whose pairs are shown
MOST_SHOWN_BYTES = 5 * 2**20  # the most bytes of what a page shows of them
WHY_NOT = {
    "none": "The game has no function show(a, b): the page tells its scores.",
    "program": "{name} plays, which the page cannot ask. `matrixworld replay` shows its matches.",
    "later": "What the game shows of a pair is here when the run has ended.",
    "few": "What the game shows of this pair was not computed: the page has {n} pairs, those of "
    "the last generations and of an even grid.",
}


def plain_game(run: SavedRun, share: int = 1, *, ended: bool = True) -> dict[str, Any] | None:
    """Return facts of a game that the page cannot play, and what it shows of some cells, or None.

    It cannot play games of your own, nor in pursuit programs and best responses. The page is one of
    `share` runs with such games.
    """
    own = run.settings.game
    if not isinstance(own, OwnGame):
        return _plain_pursuit(run, ended)
    game = run.settings.evaluation_game
    shows: dict[str, dict[str, str]] = {}
    if game.shows and ended:
        most = MOST_SHOWN // share, MOST_SHOWN_BYTES // share
        shows = shows_of(game, [team.genomes for team in run.sides], *most)
    why = WHY_NOT["none" if not game.shows else "few" if ended else "later"]
    return {
        "teams": list(own.teams),
        "exact": own.deterministic,
        "shows": shows,
        "missing": why.format(n=len(shows)),
    }


def _plain_pursuit(run: SavedRun, ended: bool) -> dict[str, Any] | None:
    """Return the same of pursuit with a team that is neither genomes nor a script; else None.

    The page shows a recorded episode of it.
    """
    others = [team for team in run.sides if not isinstance(team, Population)]
    names = [team.name if isinstance(team, Player) else team for team in others]
    names = [name for name in names if name not in SCRIPTS]
    if not names:
        return None
    shows = {}
    if ended:
        last = [run.generation(team, -1) for team in TEAMS]
        picture = animation(run.record()).data
        image = f"data:image/gif;base64,{base64.b64encode(picture).decode()}"
        shows["{} {}".format(*last)] = {"image": image}
    return {
        "teams": list(run.settings.game.teams),
        "exact": run.facts.exact,
        "shows": shows,
        "missing": WHY_NOT["program"].format(name=names[0]),
    }


def shows_of(
    game: Game, archives: list[Genomes], cells: int, most: int
) -> dict[str, dict[str, str]]:
    """Return ``text`` or ``image`` of cells such as ``"12 7"``, the newest first, within bytes."""
    first, second = archives
    found: dict[str, dict[str, str]] = {}
    for g, h in shown_cells(len(first), len(second), cells):
        shown = game.shown(first[g], second[h])
        kind = "text" if isinstance(shown, str) else "image"
        if not isinstance(shown, str):
            shown = f"data:{shown.kind};base64,{base64.b64encode(shown.content).decode()}"
        most -= len(shown.encode())
        if most < 0:
            break
        found[f"{g} {h}"] = {kind: shown}
    return found


def shown_cells(rows: int, columns: int, most: int) -> list[tuple[int, int]]:
    """Return at most so many cells: those of the last generations, and an even grid."""
    side = most if rows * columns <= most else isqrt(most // 2)
    last = [range(n - 1, max(-1, n - 1 - side), -1) for n in (rows, columns)]
    even = [np.linspace(n - 1, 0, min(n, side)).round().astype(int) for n in (rows, columns)]
    return [*dict.fromkeys((int(g), int(h)) for two in (last, even) for g, h in product(*two))]
