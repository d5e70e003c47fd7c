"""Rollouts: whole episodes in the engine, from matches and their seeds to statistics."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld import _core
from matrixworld._util import checks
from matrixworld._util.readable import Readable
from matrixworld._util.teams import PLURALS, TEAMS
from matrixworld.play.functions import Function
from matrixworld.play.matches import match_statistics, member_of
from matrixworld.play.player import Plays
from matrixworld.play.tables import in_engine
from matrixworld.world.config import WorldConfig
from matrixworld.world.masks import check_team
from matrixworld.world.rules import Rules


class Matches(NamedTuple):
    """M matches of pursuers against evaders.

    `pursuer` and `evader` (M,) int32 are indices into the populations, 0 for a script; episode j of
    a match is episode j of its `seed`, of (M,) uint64.
    """

    pursuer: NDArray[np.int32]
    evader: NDArray[np.int32]
    seed: NDArray[np.uint64]

    @classmethod
    def of(cls, pursuer: ArrayLike, evader: ArrayLike, seed: ArrayLike) -> Matches:
        """Return matches of integers, each (M,), (1,) or (), which broadcast against each other.

        Raises
        ------
        ValueError, TypeError
            If the values are no integers from 0 on, or the shapes do not broadcast to one axis.
        """
        parts = (
            checks.check_integers("pursuer", pursuer, np.int32),
            checks.check_integers("evader", evader, np.int32),
            checks.check_integers("seed", seed, np.uint64),
        )
        broadcast = np.atleast_1d(*parts)
        # `broadcast_arrays` is slow beside a short rollout, and rarely needed.
        if any(part.shape != broadcast[0].shape for part in broadcast):
            broadcast = np.broadcast_arrays(*broadcast)
        if broadcast[0].ndim != 1:
            raise ValueError(f"matches: expected one axis, got shape {broadcast[0].shape}")
        return cls(*(np.ascontiguousarray(part) for part in broadcast))


@dataclass(frozen=True, eq=False, repr=False)
class EpisodeStatistics(Readable):
    """Statistics of M matches with N episodes each. Every shape begins with (M, N).

    Parameters
    ----------
    capture_rate : ndarray of float32, shape (M, N)
        Share of the evaders that count as captured at the end: captured at some time under
        occupation, at that moment under surround.
    ever_capture_rate : ndarray of float32, shape (M, N)
        Share of the evaders that were captured at some time.
    captured_fraction : ndarray of float32, shape (M, N)
        Share that counts as captured, as a mean over ``max_steps``. After an early end it counts as
        it was at the end, so fast captures score higher.
    length : ndarray of int32, shape (M, N)
        Steps.
    pursuer_return, evader_return : ndarray of float64, shape (M, N)
        Rewards summed over team and steps.
    pursuer_survivors, evader_survivors : ndarray of int32, shape (M, N)
        Agents alive at the end.
    pursuer_overlap, evader_overlap : ndarray of float32, shape (M, N)
        (Living agents - distinct cells that they are on) / team size, as a mean over ``max_steps``.
    collisions, faults : ndarray of int32, shape (M, N, 2, 3)
        Agent-steps in a collision, and at fault in one, by team (pursuers, evaders) and kind
        (obstacle, teammate, adversary).
    agent_steps : ndarray of int64, shape (M, N, 2)
        Steps of agents that were alive when the step began, by team.
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
"""Type of `rollout` and of pure functions with the same arguments that replace it."""


def rollout(
    config: WorldConfig | Rules | str,
    pursuers: Any,
    evaders: Any,
    matches: Matches,
    *,
    episodes: int = 1,
    threads: int | None = None,
) -> EpisodeStatistics:
    """Play every match in one or more episodes and return their statistics, arrays (M, N, ...).

    Parameters
    ----------
    config : WorldConfig, Rules or str
        A configuration, rules, or the name of a variant.
    pursuers, evaders : player
        The teams' candidates: a population, or one of what else `matrixworld.player` takes.
    matches : Matches
        M matches of these candidates.
    episodes : int, optional
        Episodes of each match, N. The default is 1.
    threads : int, optional
        Threads that share the episodes. The default is one for each core that the process may use.

    Raises
    ------
    ValueError, TypeError
        If an index is beyond its population, or a player does not fit the world; and as
        `player`, `WorldConfig` and `Matches.of` do.

    Notes
    -----
    A pure function: the same arguments give the same bits, for any number of threads and whatever
    other matches are played with a match. Where the rules take turns, an agent decides when its
    turn begins, and sees what earlier turns did.

    In a world of few states a function becomes a table (`solver.table`), which the engine plays. It
    is asked once for each different view then, and its draws are those of the table. Elsewhere, and
    if it remembers something or draws what cannot be followed, it is asked in every step, which is
    50 to 1000 times slower, in one thread; a warning says so.

    Ctrl-C ends a rollout of the main thread within about 0.1 s with KeyboardInterrupt.
    """
    config, n_threads = WorldConfig.of(config), checks.check_threads(threads)
    columns = Matches.of(*matches)
    each = checks.check_integer("episodes", episodes, 1)
    teams = [
        in_engine(given, team, config)
        for team, given in zip(TEAMS, (pursuers, evaders), strict=True)
    ]
    if any(isinstance(plays, Function) for plays in teams):
        return _asked(config, teams, columns, each)
    first, second = (
        check_team(PLURALS[team], plays, config, team)
        for team, plays in zip(TEAMS, teams, strict=True)
    )
    arrays = _core.rollout(
        config.setup,
        first,
        second,
        columns.pursuer,
        columns.evader,
        columns.seed,
        n_worlds=each,
        n_threads=n_threads,
    )
    return EpisodeStatistics(**arrays)


def _asked(
    config: WorldConfig, teams: list[Plays], matches: Matches, episodes: int
) -> EpisodeStatistics:
    """Play matches in which functions are asked in every step."""
    if not len(matches.seed):
        one = _asked(config, teams, Matches.of(0, 0, 0), episodes)
        return EpisodeStatistics(**{name: array[:0] for name, array in vars(one).items()})
    played = []
    for *numbers, seed in zip(*(column.tolist() for column in matches), strict=True):
        members = [
            member_of(PLURALS[team], plays, number)
            for team, plays, number in zip(TEAMS, teams, numbers, strict=True)
        ]
        played.append(match_statistics(config, *members, seed=seed, episodes=episodes))
    return EpisodeStatistics(
        **{name: np.stack([each[name] for each in played]) for name in played[0]}
    )
