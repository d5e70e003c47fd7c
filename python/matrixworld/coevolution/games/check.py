"""A check of games of your own, before the first race."""

from __future__ import annotations

import numpy as np

from matrixworld._util import checks
from matrixworld._util.plugins import no_exit
from matrixworld.coevolution.games.game import Game
from matrixworld.coevolution.types import TEAMS, FloatArray, Matches

CHECKED = 64  # matches of a check


@no_exit("check_game")
def check_game(game: Game) -> None:
    """Check that a `game` keeps the promises of `Game`.

    Untrained genomes have their shape and are finite; scores are finite numbers in [0, 1], one of
    each match; they do not depend on the order of the matches, nor on which others are played;
    equal generators give equal scores, whatever other random numbers are drawn meanwhile.
    ValueError says which is broken; an error in the game's own code is raised as it is.

    Examples
    --------
    >>> import matrixworld as mw
    >>> larger = mw.Game(lambda a, b, rng: (a > b).mean(1), genes=3, teams=("ones", "others"))
    >>> mw.coevolution.check_game(larger)
    """
    checks.check_instance("game", game, Game)
    rng = np.random.default_rng(0)
    first, second = (
        game.population(team, np.stack([game.untrained(team, rng) for _ in range(CHECKED)]))
        for team in TEAMS
    )
    everyone = np.arange(CHECKED)
    matches = everyone, everyone[::-1], everyone.astype(np.uint64)

    def played(matches: Matches, state: int) -> FloatArray:
        before = np.random.get_state()  # noqa: NPY002, to find games that use this generator
        np.random.seed(state)  # noqa: NPY002
        try:
            return game.scores(first, second, matches, episodes=2, threads=1).of("pursuer")
        finally:
            np.random.set_state(before)  # noqa: NPY002

    scores = played(matches, 1)
    if not np.array_equal(scores, played(matches, 2)):
        raise ValueError(
            "play: expected equal scores from equal generators, got others; random numbers must "
            "come from the rng that is passed, and nothing may change from call to call"
        )
    order = rng.permutation(CHECKED)[: CHECKED // 2]
    a, b, seeds = matches
    if not np.array_equal(scores[order], played((a[order], b[order], seeds[order]), 1)):
        raise ValueError(
            "play: expected scores of each match alone, got some that depend on other matches or "
            "their order"
        )
