"""Packs of pursuers whose policy has six weights, for the notebook on safety.

A pack is a network without a hidden layer, so the engine plays it as fast as any other policy. Its
genome follows from six numbers, see `WEIGHTS`.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld._util.checks import check_floats
from matrixworld.envs.vector import VectorEnv
from matrixworld.episodes.safety import SafetyMonitor
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import Network, Population

WORLD = WorldConfig("S", rows=10, cols=10, n_pursuers=6, n_evaders=1, max_steps=60)
"""Six pursuers have to surround one evader. In -S pursuers may share a cell; it is a collision."""

WEIGHTS = ("approach", "hold", "wall", "teammate", "crowd", "stay")
"""What a pack weighs. The wish for an action is the sum of each weight times what it counts:

approach    for a move: how much it leads towards the evaders in view, -1 to 1 each
hold        for staying: evaders on the four cells around
wall        for a move: 1 if an obstacle or the border is there
teammate    for a move: teammates on that cell
crowd       for a move: teammates on the other three cells around that cell
stay        for staying: always 1
"""

_STEPS = np.array([(0, 0), (-1, 0), (0, 1), (1, 0), (0, -1)])  # rows, columns of each `Action`
_EVADERS, _PURSUERS, _OBSTACLES = range(3)  # channels of views

Mask = Callable[[NDArray[np.uint8]], ArrayLike]
"""Takes views, (n, 3, fov, fov), and returns which actions are allowed, (n, n_actions)."""


def pack(weights: ArrayLike) -> Population:
    """Return packs as a population of networks.

    Parameters
    ----------
    weights : array_like of float, shape (6,) or (n, 6)
        The weights of one or several packs, in the order of `WEIGHTS`.

    Returns
    -------
    Population
        Its genomes are linear in the weights. Actions are drawn with the softmax of the wishes.

    Raises
    ------
    ValueError
        If the shape is another, or a weight is not finite.
    TypeError
        If the weights are not numbers.
    """
    given = np.atleast_2d(check_floats("weights", weights, np.float64))
    if given.ndim != 2 or given.shape[1] != len(WEIGHTS):
        raise ValueError(f"weights: expected shape (6,) or (n, 6), got {np.shape(weights)}")
    network = Network.for_config(WORLD, hidden=())
    return Population((given @ _genomes(network)).astype(np.float32), network)


def _genomes(network: Network) -> NDArray[np.float32]:
    """Return the genome of each weight alone, (6, genome_size)."""
    half = network.fov // 2
    cells = np.indices((network.fov, network.fov)) - half
    distance = abs(cells).sum(axis=0)
    genomes = np.zeros((len(WEIGHTS), network.genome_size), np.float32)
    shape = (3, network.fov, network.fov, network.n_actions)
    layers = [network.layers(genome)[0] for genome in genomes]
    approach, hold, wall, teammate, crowd, _ = (inputs.reshape(shape) for inputs, _ in layers)
    for action, step in enumerate(_STEPS[1:], start=1):
        along = np.tensordot(step, cells, axes=1)
        from_target = abs(cells - step[:, None, None]).sum(axis=0)
        approach[_EVADERS, ..., action] = along / np.maximum(distance, 1)
        wall[_OBSTACLES, ..., action] = from_target == 0
        teammate[_PURSUERS, ..., action] = from_target == 0
        crowd[_PURSUERS, ..., action] = (from_target == 1) & (distance > 0)
    hold[_EVADERS, ..., 0] = distance == 1
    layers[-1][1][0] = 1.0
    return genomes


class MaskedEpisodes(NamedTuple):
    """Episodes of a pack under a mask.

    Parameters
    ----------
    safety : SafetyMonitor
        Their collisions.
    steps : ndarray of int64, shape (episodes,)
        Their lengths.
    captured : ndarray of bool, shape (episodes,)
        Whether the evader was surrounded.
    """

    safety: SafetyMonitor
    steps: NDArray[np.int64]
    captured: NDArray[np.bool_]


def play_masked(
    weights: ArrayLike,
    mask: Mask,
    *,
    episodes: int = 100,
    seed: int = 0,
    config: WorldConfig = WORLD,
    evaders: str = "random",
) -> MaskedEpisodes:
    """Play a pack that never chooses an action that a mask forbids.

    Parameters
    ----------
    weights : array_like of float, shape (6,)
        The pack.
    mask : callable
        Takes the views of n pursuers, (n, 3, fov, fov), and returns for each action whether it is
        allowed, (n, 5). A pursuer that is allowed nothing stays.
    episodes : int, optional
        Number of episodes.
    seed : int, optional
        Seed of the worlds and of the actions.
    config : WorldConfig, optional
        The world. The default is `WORLD`.
    evaders : str, optional
        Script of the evaders.

    Returns
    -------
    MaskedEpisodes
        What happened.

    Raises
    ------
    ValueError
        If the mask returns another shape.
    """
    (genome,), network = (own := pack(weights)).genomes, own.network
    envs = VectorEnv(config, n_worlds=episodes, evaders=evaders, autoreset_mode="Disabled")
    views, _ = envs.reset(seed=seed)
    rng, safety = np.random.default_rng(seed), SafetyMonitor()
    steps, captured = np.zeros(episodes, np.int64), np.zeros(episodes, bool)
    running = np.ones(episodes, bool)
    while running.any():
        actions = np.zeros((episodes, config.n_pursuers), np.int64)
        seen = views[running].reshape(-1, *views.shape[2:])
        wishes = network.logits(genome, seen)
        wishes[~_allowed(mask, seen)] = -np.inf
        # The largest of wishes with Gumbel noise is a draw with their softmax.
        chosen = (wishes + rng.gumbel(size=wishes.shape)).argmax(axis=1)
        actions[running] = chosen.reshape(-1, config.n_pursuers)
        views, *_, infos = envs.step(actions)
        safety.add_infos(infos)
        ended = running & infos["_episode"]
        steps[ended] = infos["episode"]["length"][ended]
        captured[ended] = infos["episode"]["capture_rate"][ended] == 1
        running &= ~ended
    return MaskedEpisodes(safety, steps, captured)


def _allowed(mask: Mask, views: NDArray[np.uint8]) -> NDArray[np.bool_]:
    allowed = np.array(mask(views), bool)
    expected = (len(views), len(_STEPS))
    if allowed.shape != expected:
        raise ValueError(f"mask: expected shape {expected}, got {allowed.shape}")
    allowed[~allowed.any(axis=1), 0] = True
    return allowed


def everything(views: NDArray[np.uint8]) -> NDArray[np.bool_]:
    """Allow every action: the mask that masks nothing."""
    return np.ones((len(views), len(_STEPS)), bool)
