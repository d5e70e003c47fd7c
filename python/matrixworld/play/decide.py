"""The actions of a team at one moment of some worlds."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld.arrays import integers
from matrixworld.config import WorldConfig
from matrixworld.play.draws import Moments, decision_draws, unit
from matrixworld.play.scripts import Sight, script_actions
from matrixworld.policy import Network, Population, TeamPolicy

MOMENT = ("views", "positions", "alive", "state", "seed", "episode", "steps")
"""World arrays that `decide` reads."""

Moment: TypeAlias = Mapping[str, NDArray[Any]]
"""The arrays of `MOMENT` of W worlds, each with a leading axis of worlds."""

Callback: TypeAlias = Callable[[NDArray[np.uint8]], ArrayLike]
"""A policy as a function: observations uint8 (n, 3, fov, fov) of n living agents of one team, to
actions (n,), integers."""

Plays: TypeAlias = TeamPolicy | Callback
"""What chooses a team's actions: a population of one genome, the name of a script, a function."""


def decide(
    policy: Plays,
    config: WorldConfig,
    moment: Moment,
    agents: range,
    actions: NDArray[np.int64],
    worlds: NDArray[np.bool_] | None = None,
) -> None:
    """Choose actions for living agents of one team and write them into an array.

    Parameters
    ----------
    policy : Population, str or callable
        What chooses. A population has one genome.
    config : WorldConfig
        The settings of the worlds.
    moment : mapping of str to ndarray
        The worlds' present moment: arrays of `MOMENT`, each with a leading axis of W worlds.
    agents : range
        The agents that act; all are of one team.
    actions : ndarray of int64, shape (W, A)
        Where to write. Entries of gone agents and of other agents stay as they are.
    worlds : ndarray of bool, shape (W,), optional
        The worlds in which the policy plays. The default is all.

    Raises
    ------
    ValueError, TypeError
        If a callable returns something else than one legal action for each agent.

    Notes
    -----
    Scripts and sampled networks use the random numbers that a rollout uses at the same moment of
    the same episode. A script therefore acts as in a rollout. So does a network, except where
    outputs differ in the last digit: they are computed by NumPy here, by the engine there.
    """
    alive = moment["alive"][:, agents.start : agents.stop]
    world, place = np.nonzero(alive if worlds is None else alive & worlds[:, None])
    if not len(world):
        return
    agent = place + agents.start
    at = Moments(*(moment[name][world].astype(np.uint64) for name in ("seed", "episode", "steps")))
    if isinstance(policy, str):
        is_pursuer = agents.start < config.n_pursuers
        sight = Sight(moment, world, agent, is_pursuer, config.n_actions)
        chosen = script_actions(policy, sight, at)
    elif isinstance(policy, Population):
        views, units = moment["views"][world, agent], unit(decision_draws(at, agent))
        chosen = network_actions(policy.network, policy.genomes[0], views, units)
    else:
        views = moment["views"][world, agent].astype(np.uint8, copy=False)
        chosen = called(policy, views, config.n_actions)
    actions[world, agent] = chosen


def check_fits(name: str, network: Network, config: WorldConfig) -> None:
    """Raise ValueError unless a network has the views and actions of a world."""
    if (network.fov, network.n_actions) != (config.fov, config.n_actions):
        raise ValueError(
            f"{name}: expected a network for fov {config.fov} and {config.n_actions} actions, "
            f"got fov {network.fov} and {network.n_actions} actions"
        )


def network_actions(
    network: Network,
    genome: NDArray[np.float32],
    views: NDArray[np.uint8],
    units: NDArray[np.floating[Any]],
) -> NDArray[np.int64]:
    """Return the actions of a network, (n,); `units` are numbers in [0, 1), one for each view."""
    logits = network.logits(genome, views)
    if not network.sampled:
        return np.asarray(np.argmax(logits, axis=1))
    # The action is the number of cumulated weights that do not exceed unit * total.
    cumulated = np.exp(logits - logits.max(axis=1, keepdims=True)).cumsum(axis=1)
    threshold = units * cumulated[:, -1]
    return np.asarray((cumulated[:, :-1] <= threshold[:, None]).sum(axis=1))


def called(policy: Callback, views: NDArray[np.uint8], n_actions: int) -> NDArray[Any]:
    """Return the actions of a callable for n views, checked."""
    chosen = integers("actions of the policy", policy(views))
    if chosen.shape != (len(views),):
        raise ValueError(
            f"actions of the policy: expected shape {(len(views),)}, got {chosen.shape}"
        )
    if chosen.min() < 0 or chosen.max() >= n_actions:
        wrong = chosen[(chosen < 0) | (chosen >= n_actions)][0]
        raise ValueError(f"actions of the policy: expected 0 to {n_actions - 1}, got {wrong}")
    return chosen
