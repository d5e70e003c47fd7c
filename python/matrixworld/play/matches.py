"""Matches in which functions play: the engine's rollouts know networks, tables and scripts only."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld._util.checks import SEED_MAX, check_instance, check_integer
from matrixworld._util.teams import PLURALS, TEAMS
from matrixworld.play.functions import Function, Seats
from matrixworld.play.player import Plays, placed
from matrixworld.world.arrays import BATCH_FIELDS, array_specs, episode_specs, new_arrays
from matrixworld.world.batch import Batch
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import EnginePolicy, Population

Chooser: TypeAlias = Callable[[NDArray[np.bool_], NDArray[np.uint8]], ArrayLike]
"""What chooses outside of the engine: it is told who asks, bool (episodes, A) with n agents that
have to act, and what they see, uint8 (n, 3, fov, fov)."""

OnRound: TypeAlias = Callable[[NDArray[np.int64], NDArray[np.bool_]], None]
"""Called after each round with the actions, int64 (episodes, A), and the episodes that played it,
bool (episodes,); both change in the next round."""

Arrays: TypeAlias = Mapping[str, NDArray[Any]]
"""Arrays of the present moment, each with a leading axis of worlds."""

_READ = ("alive", "terminated", "truncated", "capture_rate")


def capture_rates(
    config: WorldConfig, pursuers: Any, evaders: Any, *, seed: int, episodes: int
) -> NDArray[np.float64]:
    """Play the episodes of a match side by side and return their capture rates.

    Functions are asked in every step, whatever the size of the world (see `matrixworld.rollout`).

    Parameters
    ----------
    config : WorldConfig
        The world.
    pursuers, evaders : player
        What `matrixworld.player` takes, each of one genome.
    seed : int
        Seed of the match. Episode j is the seed's episode j.
    episodes : int
        Number of episodes.

    Returns
    -------
    ndarray of float64, shape (episodes,)
        The capture rates.
    """
    check_instance("config", config, WorldConfig)
    seed = check_integer("seed", seed, 0, SEED_MAX)
    episodes = check_integer("episodes", episodes, 1)
    first, second = (
        placed(PLURALS[team], given, team, config)
        for team, given in zip(TEAMS, (pursuers, evaders), strict=True)
    )
    return play_episodes(config, first, second, seed=seed, episodes=episodes)


def play_episodes(
    config: WorldConfig,
    pursuers: Plays | Chooser,
    evaders: Plays | Chooser,
    *,
    seed: int,
    episodes: int,
    first: int = 0,
    on_round: OnRound | None = None,
    on_decision: Callable[[int, float], None] | None = None,
    threads: int | None = None,
) -> NDArray[np.float64]:
    """Play the episodes of a match side by side and return their capture rates, (episodes,).

    They are the seed's episodes from number `first` on.

    `on_decision` is called when a population or a script has decided, with its team, 0 or 1, and
    the processor time in seconds that it took in this thread.
    """
    batch, seats = _begin(config, (pursuers, evaders), seed, episodes, _READ, first, threads)
    _play(batch, seats, on_round, on_decision)
    return np.asarray(batch.buffers["capture_rate"], np.float64)


def match_statistics(
    config: WorldConfig, pursuers: Plays, evaders: Plays, *, seed: int, episodes: int
) -> dict[str, NDArray[Any]]:
    """Play the episodes of a match and return what `EpisodeStatistics` has, arrays (episodes, ...).

    They are those of the engine's rollout where both play the same.
    """
    names = (*_READ, "positions", *(name for name in BATCH_FIELDS if name.startswith("episode_")))
    batch, seats = _begin(config, (pursuers, evaders), seed, episodes, names)
    buffers = batch.buffers
    sizes = np.array([config.n_pursuers, config.n_evaders])
    captured = np.zeros(episodes)
    overlapping = np.zeros((episodes, len(TEAMS)))

    def count(actions: NDArray[np.int64], running: NDArray[np.bool_]) -> None:
        # After its end an episode counts as it was then.
        captured[:] += np.rint(buffers["capture_rate"] * config.n_evaders)
        for team, members in enumerate(_teams(config)):
            alive = buffers["alive"][:, members]
            places = buffers["positions"][:, members] @ [config.cols, 1]
            together = np.tril(places[:, :, None] == places[:, None], -1)
            together &= alive[:, :, None] & alive[:, None]
            overlapping[running, team] += together.any(axis=2).sum(axis=1)[running]

    _play(batch, seats, count, None)
    played = {name: buffers[f"episode_{name}"] for name in ("capture_rate", "ever_capture_rate")}
    played |= {name: buffers[f"episode_{name}"] for name in ("length", "collisions", "faults")}
    idle = config.max_steps - int(played["length"].max())  # rounds that no episode has played
    captured += idle * np.rint(played["capture_rate"] * config.n_evaders)
    shares = overlapping / config.max_steps / sizes
    played["agent_steps"] = buffers["episode_agent_steps"]
    played["captured_fraction"] = captured / config.max_steps / config.n_evaders
    for number, team in enumerate(TEAMS):
        played[f"{team}_return"] = buffers["episode_return"][:, number]
        played[f"{team}_survivors"] = buffers["episode_survivors"][:, number]
        played[f"{team}_overlap"] = shares[:, number]
    floats = ("captured_fraction", "pursuer_overlap", "evader_overlap")
    return {name: _as(array, np.float32, name in floats) for name, array in played.items()}


def member_of(name: str, plays: Plays, number: int) -> Plays:
    """Return one candidate; ValueError if there are not so many."""
    size = len(plays.genomes) if isinstance(plays, Population) else 1
    if number >= size:
        raise ValueError(f"{name}: expected an index below {size}, got {number}")
    return (
        Population(plays.genomes[number], plays.policy) if isinstance(plays, Population) else plays
    )


def _as(array: NDArray[Any], dtype: Any, converted: bool) -> NDArray[Any]:
    return array.astype(dtype) if converted else array


def _teams(config: WorldConfig) -> tuple[range, range]:
    return range(config.n_pursuers), range(config.n_pursuers, config.n_agents)


def _begin(
    config: WorldConfig,
    players: tuple[Plays | Chooser, Plays | Chooser],
    seed: int,
    episodes: int,
    names: tuple[str, ...],
    first: int = 0,
    threads: int | None = None,
) -> tuple[Batch, list[EnginePolicy | Seats | Chooser]]:
    """Return worlds at the start of the episodes, which write some arrays, and the players."""
    specs = {**array_specs(config), **episode_specs(config)}
    seats: list[EnginePolicy | Seats | Chooser] = []
    for number, each in enumerate(players):
        if isinstance(each, Function):
            seats.append(Seats(each, config.n_actions, number, episodes))
        else:
            seats.append(each)
    read = {getattr(each, "reads", "views") for each in seats if callable(each)}
    wanted = {name: specs[name] for name in (*names, *sorted(read))}
    batch = Batch(episodes, config, buffers=new_arrays(wanted, episodes), threads=threads)
    for world in range(episodes):
        chosen = np.arange(episodes) == world
        batch.reset(np.full(episodes, seed, np.uint64), episode=first + world, mask=chosen)
        for each in seats:
            if isinstance(each, Seats):
                each.begin(world, seed, first + world)
    return batch, seats


def _play(
    batch: Batch,
    seats: list[EnginePolicy | Seats | Chooser],
    on_round: OnRound | None,
    on_decision: Callable[[int, float], None] | None,
) -> None:
    """Play the episodes of a batch to their ends."""
    config, buffers = batch.config, batch.buffers
    first = np.zeros(batch.n_worlds, np.int32)  # of one policy
    actions = np.zeros((batch.n_worlds, config.n_agents), np.int64)
    while (running := _running(buffers)).any():
        for _ in range(batch.n_turns):
            turn = batch.actors
            for number, (team, policy) in enumerate(zip(_teams(config), seats, strict=True)):
                acting = range(max(team.start, turn.start), min(team.stop, turn.stop))
                if not acting:
                    continue
                if callable(policy):
                    _ask(policy, buffers, acting, actions)
                    continue
                began = time.thread_time()
                batch.decide([policy], first, acting, actions)
                if on_decision is not None:
                    on_decision(number, time.thread_time() - began)
            batch.play_turn(actions)
        if on_round is not None:
            on_round(actions, running)


def _ask(
    policy: Seats | Chooser, arrays: Arrays, agents: range, actions: NDArray[np.int64]
) -> None:
    """Write what is chosen for the living agents among `agents`; there may be none."""
    asked = np.zeros(actions.shape, np.bool_)
    asked[:, agents] = arrays["alive"][:, agents] & _running(arrays)[:, None]
    if asked.any():
        actions[asked] = policy(asked, arrays[getattr(policy, "reads", "views")][asked])


def _running(arrays: Arrays) -> NDArray[np.bool_]:
    return np.asarray(~(arrays["terminated"] | arrays["truncated"]))
