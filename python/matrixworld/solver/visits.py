"""Where a player gets in episodes against the best response to it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from matrixworld.play.tables import Table
from matrixworld.solver.solution import Solution
from matrixworld.world.policy import Team

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Visit:
    """The states of a turn with so many `rounds` left, this one included, as they come about.

    Parameters
    ----------
    rounds, turn : int
        When it is.
    reach : ndarray of float64, shape (S,)
        How often each state comes about in an episode against the best response.
    play : ndarray of float64, shape (S, joint actions)
        The player's probabilities, times how often it chooses by them.
    after : ndarray of float64, shape (S,)
        What perfect play is worth after the turn, as a mean over what both do, times `reach`.
    """

    rounds: int
    turn: int
    reach: Floats
    play: Floats
    after: Floats

    def times(self, share: float) -> Visit:
        """Return the visit in such a share of the episodes."""
        numbers = (share * each for each in (self.reach, self.play, self.after))
        return Visit(self.rounds, self.turn, *numbers)


def visits(perfect: Solution, play: Table, response: Solution, team: Team) -> Iterator[Visit]:
    """Yield the turns of an episode between a player's table and the best response to it."""
    states = perfect.states
    rival: Team = "evader" if team == "pursuer" else "pursuer"
    reach = np.bincount(states.starts, minlength=states.count()) / len(states.starts)
    for rounds in range(response.steps, 0, -1):
        for turn in range(states.n_turns):
            [met] = np.nonzero(reach)
            mine = play.probabilities(rounds, turn)[met]
            theirs = response.probabilities(rival, rounds, turn)[met]
            pursuers, evaders = (mine, theirs) if team == "pursuer" else (theirs, mine)
            ways = reach[met, None, None] * pursuers[:, :, None] * evaders[:, None]
            following = states.successors(turn)[met]
            after, played = np.zeros(len(reach)), np.zeros((len(reach), mine.shape[1]))
            after[met] = (ways * perfect.after(rounds, turn)[following]).sum(axis=(1, 2))
            played[met] = reach[met, None] * mine
            yield Visit(rounds, turn, reach, played, after)
            size = states.count((turn + 1) % states.n_turns)
            reach = np.bincount(following.ravel(), ways.ravel(), size).astype(np.float64)
