"""What a player does in every state of a small world."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from matrixworld.play.functions import probabilities_of
from matrixworld.play.policies import GenomePolicy
from matrixworld.solver.states import States
from matrixworld.world.policy import Population, Script, Team


def table(
    states: States, player: Population | GenomePolicy | Script | Callable[..., Any], team: Team
) -> tuple[NDArray[np.float64], ...]:
    """Return the probabilities with which a player plays, for each turn (S, its joint actions).

    Parameters
    ----------
    states : States
        All states of a world.
    player : Population, NetworkPolicy, RatingPolicy, str or callable
        What `States.decisions` takes, or a function: ``f(views)``, from uint8 (n, 3, fov, fov) to
        actions (n,), or from one view to one action; or ``f(view, rng)``, from one view to one
        action, with a generator whose draws are all followed (see
        `matrixworld.play.functions.probabilities_of`). It is asked once for each different view, so
        it has to choose by the view and by `rng` alone.
    team : {"pursuer", "evader"}
        The team that it plays for.

    Raises
    ------
    NotExactError
        A ValueError: if a function draws what cannot be followed, or does not choose by its
        arguments alone.
    TypeError, ValueError
        If a function takes other arguments or returns no legal actions; and as
        `States.decisions` does.
    """
    if isinstance(player, GenomePolicy) or not callable(player):
        return states.decisions(player, team)
    views, places = states.views(team)
    chosen = probabilities_of(player, views, states.config.n_actions)
    gone = np.eye(1, states.config.n_actions)  # in the row that -1 finds: they act 0
    by_view = np.concatenate([chosen, gone])
    joint = []
    for of_turn in places:
        play = np.ones((len(of_turn), 1))
        # Members decide independently of each other; the first one is the highest digit.
        for numbers in of_turn.T:
            play = (play[:, :, np.newaxis] * by_view[numbers][:, np.newaxis]).reshape(len(play), -1)
        joint.append(play)
    return tuple(joint)
