"""A check of games of your own, before the first race."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from matrixworld._util import checks
from matrixworld._util.plugins import no_exit
from matrixworld.coevolution.games.game import Game
from matrixworld.coevolution.games.operators import as_genomes
from matrixworld.coevolution.games.toolbox import global_draws
from matrixworld.coevolution.types import TEAMS, FloatArray, Genomes, Matches, Rng, Team

MATCHES = 64  # of a check
ROUNDING = 1e-6  # of scores of float32
FEWEST = 8  # matches that tell whether a side has better chances
ERRORS = 6.0  # standard errors by which chance does not differ in any check

ALONE = (
    "random numbers must come from the rng that is passed, and nothing may change from call to call"
)


@no_exit("check_game")
def check_game(game: Game, matches: int = MATCHES) -> None:
    """Check that a `game` keeps the promises of `Game`.

    Genomes are of their kind, and can be shown. Scores are finite numbers in [0, 1], one of each
    match; they do not depend on the order of the matches, nor on which others are played. Equal
    generators give equal genomes and equal scores, whatever other random numbers are drawn
    meanwhile. Of objects also mutants and children are made and play; what `read` makes of a text
    has this text again, and `play` leaves them as they were. In a symmetric game it makes no
    difference which side a member plays, as far as so many matches can tell: of 64, a side that
    wins 70 % is found.

    Parameters
    ----------
    game : Game
        The game.
    matches : int, optional
        Matches of a check, at least 2. On average each is played in five episodes, in nine if the
        game is symmetric; without chance in half as many.

    Raises
    ------
    TypeError, ValueError
        If a promise is broken; the message says which. An error in the game's own code is raised as
        it is.

    Examples
    --------
    >>> import matrixworld as mw
    >>> larger = mw.Game(lambda a, b, rng: (a > b).mean(1), genes=3, teams=("ones", "others"))
    >>> mw.check_game(larger)
    """
    checks.check_instance("game", game, Game)
    checks.check_integer("matches", matches, 2)
    first, second = (game.population(team, _genomes(game, team, matches)) for team in TEAMS)
    if game.symmetric:
        second = first
    everyone = np.arange(matches)
    seeds = everyone.astype(np.uint64)

    def played(matches: Matches, state: int) -> FloatArray:
        with global_draws(state):
            return game.rollout(first, second, matches, episodes=2, threads=1).of("pursuer")

    scores = played((everyone, everyone[::-1], seeds), 1)
    if not np.array_equal(scores, played((everyone, everyone[::-1], seeds), 2)):
        raise ValueError(f"play: expected equal scores from equal generators, got others; {ALONE}")
    order = np.random.default_rng(0).permutation(matches)[: matches // 2]
    if not np.array_equal(
        scores[order], played((everyone[order], everyone[::-1][order], seeds[order]), 1)
    ):
        raise ValueError(
            "play: expected scores of each match alone, got some that depend on other matches or "
            "their order"
        )

    if game.shows:
        game.shown(first.genomes[0], second.genomes[0])
    if game.symmetric:
        _check_sides(game, first, (everyone, everyone[::-1], seeds))


def _check_sides(game: Game, members: Any, matches: Matches) -> None:
    """Check that it makes no difference which side of a symmetric game a member plays."""
    a, b, seeds = matches
    with global_draws(1):
        one = game.rollout(members, members, (a, b, seeds), episodes=2, threads=1)
        swapped = game.rollout(
            members, members, (b, a, seeds + np.uint64(len(a))), episodes=2, threads=1
        )
    differences = (one.of("pursuer") - swapped.of("evader")).mean(axis=1)
    if game.deterministic:
        wrong = np.abs(differences).max() > ROUNDING
    elif len(differences) < FEWEST:  # too few to tell chance from a side that is better
        return
    else:  # by chance, only as often as a mean is so many standard errors from 0
        error = differences.std(ddof=1) / np.sqrt(len(differences))
        wrong = abs(differences.mean()) > ERRORS * error + ROUNDING
    if wrong:
        raise ValueError(
            "play: expected a symmetric game, in which both sides have equal chances, got "
            f"{differences.mean():+.3f} for the first one"
        )


def _genomes(game: Game, team: Team, count: int) -> Genomes:
    """Return genomes (count, genes) of a team: untrained ones, and of objects also children."""
    untrained = _made_twice(
        "initial", lambda rng: np.stack([game.untrained(team, rng) for _ in range(count)])
    )
    if not game.texts:
        return untrained
    operators = game.operators[team]

    def bred(parents: int, rng: Rng) -> Genomes:
        pairs = [untrained[rng.permutation(count)[:parents]] for _ in range(count)]
        children = [operators.child(pair, rng, mutates=parents == 1) for pair in pairs]
        for text in children:
            operators.check_read(text, "mutate" if parents == 1 else "mate")
        return as_genomes(children)

    made = [untrained, _made_twice("mutate", lambda rng: bred(1, rng))]
    if operators.mate is not None:
        made.append(_made_twice("mate", lambda rng: bred(2, rng)))
    # Of each kind about equally many play.
    return np.stack([made[number % len(made)][number] for number in range(count)])


def _made_twice(name: str, make: Callable[[Rng], Genomes]) -> Genomes:
    """Return genomes that an operator makes; ValueError if others come from an equal generator."""
    genomes = []
    for state in (1, 2):
        with global_draws(state):
            genomes.append(make(np.random.default_rng(0)))
    if not np.array_equal(genomes[0], genomes[1]):
        raise ValueError(
            f"{name}: expected equal genomes from equal generators, got others; {ALONE}"
        )
    return genomes[0]
