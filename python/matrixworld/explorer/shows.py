"""What games of your own show of pairs of genomes, as a page keeps it."""

from __future__ import annotations

import base64
import io
from itertools import product
from math import isqrt
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from matrixworld._util import checks
from matrixworld.coevolution.game import Game
from matrixworld.coevolution.storage import SavedRun
from matrixworld.coevolution.types import TEAMS

MOST_SHOWN = 200
"""The most cells of a page whose pairs are shown."""
MOST_BYTES = 5 * 2**20
"""The most bytes of what a page shows of them."""
WHY_NOT = {
    "none": "The game has no function show(a, b): the page tells its scores.",
    "later": "What the game shows of a pair is here when the run has ended.",
    "few": "The page does not hold what the game shows of this pair: only that of {n} pairs, of "
    "the last generations and of an even grid.",
}


def plain_game(run: SavedRun, share: int = 1, *, ended: bool = True) -> dict[str, Any] | None:
    """Return teams of a game of your own, and what it shows of some cells; None of pursuit.

    The page is one of `share` runs with such games. Cells are keys such as ``"12 7"``.
    """
    own = run.settings.game
    if own is None:
        return None
    game, shows = own.load(), dict[str, dict[str, str]]()
    if game.show is not None and ended:
        shows = shows_of(game, [*run.archive().values()], MOST_SHOWN // share, MOST_BYTES // share)
    why = WHY_NOT["none" if game.show is None else "few" if ended else "later"]
    return {"teams": list(own.teams), "shows": shows, "missing": why.format(n=len(shows))}


def shows_of(
    game: Game, archives: list[NDArray[np.float32]], cells: int, most: int
) -> dict[str, dict[str, str]]:
    """Return what a game shows of some cells, the newest first, within `most` bytes."""
    pairs = zip(TEAMS, archives, strict=True)
    first, second = (game.population(team, genomes).genomes for team, genomes in pairs)
    found: dict[str, dict[str, str]] = {}
    for g, h in shown_cells((len(first), len(second)), cells):
        shown = plain_show(game, first[g], second[h])
        most -= sum(map(len, shown.values()))
        if most < 0:
            break
        found[f"{g} {h}"] = shown
    return found


def shown_cells(shape: tuple[int, int], most: int) -> list[tuple[int, int]]:
    """Return at most so many cells: those of the last generations, and an even grid.

    Of a small matrix these are all.
    """
    side = isqrt(most // 2)
    last = (range(n - 1, max(-1, n - 1 - side), -1) for n in shape)
    even = (np.linspace(n - 1, 0, min(n, side)).round().astype(int).tolist() for n in shape)
    every = [*product(*(range(n - 1, -1, -1) for n in shape))] if np.prod(shape) <= most else []
    return every or [*dict.fromkeys([*product(*last), *product(*even)])]


def plain_show(game: Game, a: NDArray[np.float32], b: NDArray[np.float32]) -> dict[str, str]:
    """Return ``text`` or ``image``, a data URI, of genomes (genes,); ValueError for neither."""
    assert game.show is not None
    shown = game.show(a, b)
    if isinstance(shown, str):
        return {"text": shown}
    image = np.asarray(shown)
    if image.dtype != np.uint8 or image.ndim != 3 or image.shape[2] != 3 or not image.size:
        expected = "text or an image (rows, columns, 3) of uint8"
        raise ValueError(f"show of the game: expected {expected}, got {checks.shown(shown)}")
    buffer = io.BytesIO()
    Image.fromarray(image).save(buffer, "PNG", optimize=True)
    return {"image": f"data:image/png;base64,{base64.b64encode(buffer.getvalue()).decode()}"}
