"""What games of your own show of pairs of genomes, as a page keeps it."""

from __future__ import annotations

import base64
from itertools import product
from math import isqrt
from typing import Any

import numpy as np

from matrixworld.coevolution.game import Game
from matrixworld.coevolution.storage import SavedRun
from matrixworld.coevolution.types import TEAMS, Genomes

MOST_SHOWN = 200
"""The most cells of a page whose pairs are shown."""
MOST_BYTES = 5 * 2**20
"""The most bytes of what a page shows of them."""
WHY_NOT = {
    "none": "The game has no function show(a, b): the page tells its scores.",
    "later": "What the game shows of a pair is here when the run has ended.",
    "few": "What the game shows of this pair was not computed: the page has {n} pairs, those of "
    "the last generations and of an even grid.",
}


def plain_game(run: SavedRun, share: int = 1, *, ended: bool = True) -> dict[str, Any] | None:
    """Return facts of a game of your own, and what it shows of some cells; None of pursuit.

    The page is one of `share` runs with such games.
    """
    own = run.settings.game
    if own is None:
        return None
    game, shows = run.settings.evaluation_game, dict[str, dict[str, str]]()
    if game.show is not None and ended:
        shows = shows_of(game, [*run.archive().values()], MOST_SHOWN // share, MOST_BYTES // share)
    why = WHY_NOT["none" if game.show is None else "few" if ended else "later"]
    facts = {"teams": list(own.teams), "exact": own.deterministic}
    return {**facts, "shows": shows, "missing": why.format(n=len(shows))}


def shows_of(
    game: Game, archives: list[Genomes], cells: int, most: int
) -> dict[str, dict[str, str]]:
    """Return ``text`` or ``image`` of cells such as ``"12 7"``, the newest first, within bytes."""
    pairs = zip(TEAMS, archives, strict=True)
    first, second = (game.population(team, genomes).genomes for team, genomes in pairs)
    found: dict[str, dict[str, str]] = {}
    for g, h in shown_cells(len(first), len(second), cells):
        shown = game.shown(first[g], second[h])
        kind = "text" if isinstance(shown, str) else "image"
        if isinstance(shown, bytes):
            shown = f"data:image/png;base64,{base64.b64encode(shown).decode()}"
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
