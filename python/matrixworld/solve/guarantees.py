"""What each generation of a race guarantees, and so how far it is from perfect play."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from matrixworld._util.checks import shown
from matrixworld._util.readable import Readable
from matrixworld.solve.solution import Champion, best_response, solve
from matrixworld.solve.states import States
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import TEAMS, Population, Team


@dataclass(frozen=True, eq=False, repr=False)
class Guarantees(Readable):
    """The value of a world, and the capture rates when generations meet best responses.

    Parameters
    ----------
    value : float
        The capture rate under perfect play.
    pursuers : ndarray of float64, shape (n,)
        The capture rate that each generation of pursuers guarantees: against the best evaders.
    evaders : ndarray of float64, shape (m,)
        The capture rate that each generation of evaders cannot prevent: by the best pursuers.
    """

    value: float
    pursuers: NDArray[np.float64]
    evaders: NDArray[np.float64]

    @property
    def exploitability(self) -> dict[Team, NDArray[np.float64]]:
        """By how much each generation of a team falls short of the value, (n,) and (m,)."""
        return {"pursuer": self.value - self.pursuers, "evader": self.evaders - self.value}

    @property
    def nash_conv(self) -> NDArray[np.float64]:
        """The NashConv (n,) of the pair of each generation; ValueError if n and m differ.

        The sum of what both teams gain by a best response (Lanctot et al. 2017, "A unified
        game-theoretic approach to multiagent reinforcement learning"); 0 in a Nash equilibrium.
        """
        return self.evaders - self.pursuers


def guarantees(
    world: WorldConfig | States, teams: Mapping[Team, Champion], *, steps: int | None = None
) -> Guarantees:
    """Return what each generation of both teams guarantees against any opponent.

    Parameters
    ----------
    world : WorldConfig or States
        The world, or its states.
    teams : mapping of str to Population or Champion
        What each team plays, such as ``open_run("my-race").teams``: one genome for each generation,
        or another champion, such as the name of a script, which is one generation.
    steps : int, optional
        As in `solve`.
    """
    if not isinstance(teams, Mapping) or teams.keys() != set(TEAMS):
        raise TypeError(f"teams: expected a mapping with the keys {TEAMS}, got {shown(teams)}")
    states = States.of(world)
    pursuers, evaders = (
        [best_response(states, each, team, steps=steps).value for each in _generations(teams[team])]
        for team in TEAMS
    )
    return Guarantees(solve(states, steps=steps).value, np.array(pursuers), np.array(evaders))


def _generations(team: Champion) -> list[Champion]:
    if not isinstance(team, Population):
        return [team]
    return [Population(genome[None], team.network) for genome in team.genomes]
