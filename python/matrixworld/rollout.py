"""Whole episodes in the engine: matches in, scores out."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld import _core
from matrixworld.checks import INT_MAX, SEED_MAX, check_integer, check_naturals, check_threads
from matrixworld.config import WorldConfig
from matrixworld.episode import MOMENT_ARRAYS, STEP_ARRAYS, Episode
from matrixworld.policy import TeamPolicy, check_team
from matrixworld.rules import Rules
from matrixworld.world import World


class Matches(NamedTuple):
    """M matches: which pursuers meet which evaders, under which seed.

    pursuer, evader: ``(M,)`` int32 indices into the populations, 0 for a script
    seed: ``(M,)`` uint64; world j of a match is episode j of its seed
    """

    pursuer: NDArray[np.int32]
    evader: NDArray[np.int32]
    seed: NDArray[np.uint64]

    @classmethod
    def of(cls, pursuer: ArrayLike, evader: ArrayLike, seed: ArrayLike) -> Matches:
        """Matches from integers that broadcast against each other to ``(M,)``.

        Raises TypeError for other numbers, ValueError for numbers below 0 or too large and where
        they do not broadcast to one axis.
        """
        parts = (
            check_naturals("pursuer", pursuer, np.int32),
            check_naturals("evader", evader, np.int32),
            check_naturals("seed", seed, np.uint64),
        )
        broadcast = np.atleast_1d(*parts)
        if any(part.shape != broadcast[0].shape for part in broadcast):
            broadcast = np.broadcast_arrays(*broadcast)
        if broadcast[0].ndim != 1:
            raise ValueError(f"matches: expected one axis, got shape {broadcast[0].shape}")
        return cls(*(np.ascontiguousarray(part) for part in broadcast))


@dataclass(frozen=True, eq=False)
class EpisodeStatistics:
    """What the episodes of M matches, W worlds each, came to; every array begins ``(M, W)``.

    capture_rate: float32, share of the evaders that count as captured at the end (at some time
        under occupation, at that moment under surround)
    ever_capture_rate: float32, share of the evaders that were captured at some time
    captured_fraction: float32, the share that counts as captured as a mean over ``max_steps``;
        after an early end it stands as it was, so that fast captures score higher
    length: int32, steps
    pursuer_return, evader_return: float64, rewards summed over team and steps
    pursuer_survivors, evader_survivors: int32, agents alive at the end
    pursuer_overlap, evader_overlap: float32, (alive agents - distinct cells that they stand
        on) / team size, mean over ``max_steps``
    collisions, faults: ``(M, W, 2, 3)`` int32, agent-steps involved and at fault, by team
        (pursuers, evaders) and kind (obstacle, teammate, adversary)
    agent_steps: ``(M, W, 2)`` int64, steps by agents alive as they began, by team
    """

    capture_rate: NDArray[np.float32]
    ever_capture_rate: NDArray[np.float32]
    captured_fraction: NDArray[np.float32]
    length: NDArray[np.int32]
    pursuer_return: NDArray[np.float64]
    evader_return: NDArray[np.float64]
    pursuer_survivors: NDArray[np.int32]
    evader_survivors: NDArray[np.int32]
    pursuer_overlap: NDArray[np.float32]
    evader_overlap: NDArray[np.float32]
    collisions: NDArray[np.int32]
    faults: NDArray[np.int32]
    agent_steps: NDArray[np.int64]


Rollout = Callable[..., EpisodeStatistics]
"""Type of `rollout`, and of functions that stand in for it: same arguments, and pure."""


def rollout(
    config: WorldConfig | Rules | str,
    pursuers: TeamPolicy,
    evaders: TeamPolicy,
    matches: Matches,
    *,
    worlds: int = 1,
    threads: int | None = None,
) -> EpisodeStatistics:
    """Play every match in ``worlds`` worlds and score the episodes.

    A pure function: the same arguments give the same bits, for any number of threads and in any
    company of other matches. Where the rules take turns, an agent looks when its turn comes.

    config: a `WorldConfig`, `Rules`, or the name of a variant
    pursuers, evaders: a `Population`, or the name of a script
    threads: by default one a core

    Raises ValueError for an index beyond a population and for a network that does not fit the
    world, TypeError and ValueError for other bad arguments.
    """
    columns = _core.rollout(
        WorldConfig.of(config).setup,
        check_team("pursuers", pursuers),
        check_team("evaders", evaders),
        *Matches.of(*matches),
        n_worlds=check_integer("worlds", worlds, 1),
        n_threads=check_threads(threads),
    )
    return EpisodeStatistics(**columns)


def record(
    config: WorldConfig | Rules | str,
    pursuers: TeamPolicy,
    evaders: TeamPolicy,
    *,
    seed: int,
    pursuer: int = 0,
    evader: int = 0,
    episode: int = 0,
) -> Episode:
    """Play one episode and keep every moment of it.

    The episode is that of world ``episode`` in `rollout` of the match (pursuer, evader, seed).
    Raises as `rollout` does.
    """
    config = WorldConfig.of(config)
    arrays = _core.record(
        config.setup,
        check_team("pursuers", pursuers),
        check_team("evaders", evaders),
        pursuer=check_integer("pursuer", pursuer, 0, INT_MAX),
        evader=check_integer("evader", evader, 0, INT_MAX),
        seed=check_integer("seed", seed, 0, SEED_MAX),
        episode=check_integer("episode", episode, 0, SEED_MAX),
        of_moments=MOMENT_ARRAYS,
        of_steps=STEP_ARRAYS,
    )
    world = World(config)
    world.reset(seed, episode=episode)  # its map is the same at every moment of the episode
    return Episode(**arrays, map=world.map, n_pursuers=config.n_pursuers, config=config.to_json())


def match_seed(run_seed: int, *key: int) -> int:
    """The seed of a match, from the seed of a run and what tells the match from the others.

    By numpy.random.SeedSequence, whose numbers are the same on every machine and version. Raises
    ValueError for numbers below 0, TypeError for what is not an integer.
    """
    entropy = [check_integer("match seed", part, 0, SEED_MAX) for part in (run_seed, *key)]
    words = np.random.SeedSequence(entropy).generate_state(1, np.uint64)
    return int(words[0])
