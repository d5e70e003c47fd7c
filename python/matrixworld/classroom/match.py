"""One match of the tournament: two entries, some episodes side by side, the first one recorded.

The world is played here. A program gets the views of its agents and returns actions, whatever it
does in its own process.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from matrixworld.classroom.limits import Limits
from matrixworld.classroom.program import Program
from matrixworld.classroom.seat import RefusedError, Seat
from matrixworld.classroom.submissions import Entry
from matrixworld.coevolution.types import TEAMS, Team
from matrixworld.episodes.record import record
from matrixworld.play.matches import Decide, Worlds, asked_agents, decide_by, play_episodes
from matrixworld.play.rollout import Matches, rollout
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import TeamPolicy

Seats: TypeAlias = dict[Team, Seat]
"""For each team where a program runs; empty if there are no programs."""


@dataclass(frozen=True, eq=False)
class Played:
    """The result of a match.

    Parameters
    ----------
    capture_rates : ndarray of float64, shape (episodes,)
        Capture rate of each episode.
    lengths : ndarray of int64, shape (episodes,)
        Steps of each episode.
    actions : ndarray of uint8, shape (steps, A)
        All actions of the first episode.
    seconds : dict of str to float
        Processor time of each program, by team.
    """

    capture_rates: NDArray[np.float64]
    lengths: NDArray[np.int64]
    actions: NDArray[np.uint8]
    seconds: dict[Team, float]


class FailedError(Exception):
    """An entry broke a rule or a limit in a match.

    Parameters
    ----------
    team : {"pursuer", "evader"}
        Its team in the match.
    reason : str
        What it did.
    """

    def __init__(self, team: Team, reason: str) -> None:
        # All arguments, so that the error can be pickled.
        super().__init__(team, reason)
        self.team, self.reason = team, reason

    def __str__(self) -> str:
        return self.reason


def play_match(
    config: WorldConfig,
    pursuers: Entry,
    evaders: Entry,
    *,
    seed: int,
    episodes: int,
    limits: Limits,
    seats: Seats,
) -> Played:
    """Play a match.

    Parameters
    ----------
    config : WorldConfig
        The settings of the world.
    pursuers, evaders : Entry
        What plays for the teams.
    seed : int
        Seed of the match: episode j is the seed's episode j.
    episodes : int
        Number of episodes.
    limits : Limits
        Limits of programs.
    seats : dict of str to Seat
        For each team where a program runs.

    Returns
    -------
    Played
        The result. It depends on the arguments only, as long as programs do so, too.

    Raises
    ------
    FailedError
        If a program fails or breaks a limit.
    """
    if not isinstance(pursuers.policy, bytes) and not isinstance(evaders.policy, bytes):
        return _in_engine(config, pursuers.policy, evaders.policy, seed, episodes)
    entries: dict[Team, Entry] = {"pursuer": pursuers, "evader": evaders}
    noted = _Record(episodes)
    programs: dict[Team, Program] = {}
    deciders: list[Decide] = []
    with ExitStack() as stack:
        for team in TEAMS:
            policy = entries[team].policy
            if not isinstance(policy, bytes):
                deciders.append(decide_by(policy))
                continue
            with failing(team):
                rivals = seed, entries["pursuer"].key, entries["evader"].key
                programs[team] = Program(
                    seats[team], limits, policy, program_settings(config, team, rivals)
                )
            stack.callback(programs[team].close)
            deciders.append(_asking(team, programs[team]))
        rates = play_episodes(config, *deciders, seed=seed, episodes=episodes, on_round=noted.note)
    seconds = {team: program.seconds for team, program in programs.items()}
    return Played(rates, noted.lengths, np.stack(noted.steps), seconds)


class _Record:
    """Lengths of the episodes of a match, and the actions of the first one."""

    def __init__(self, episodes: int) -> None:
        self.lengths = np.zeros(episodes, np.int64)
        self.steps: list[NDArray[np.uint8]] = []

    def note(self, actions: NDArray[np.int64], running: NDArray[np.bool_]) -> None:
        """Note a round."""
        self.lengths[running] += 1
        if running[0]:
            self.steps.append(actions[0].astype(np.uint8))


def program_settings(
    config: WorldConfig, team: Team, rivals: tuple[int, tuple[int, ...], tuple[int, ...]]
) -> dict[str, object]:
    """Return what a program's process is told: its team, the form of views, and its own seed."""
    seed, *keys = rivals
    return {
        "team": team,
        "fov": config.fov,
        "n_actions": config.n_actions,
        # Of what plays, not of its place in the class: it stays the same if others join.
        "seed": [TEAMS.index(team), seed % 2**32, seed >> 32, *keys[0], *keys[1]],
    }


@contextmanager
def failing(team: Team) -> Iterator[None]:
    """Turn the refusal of a program into the failure of its team."""
    try:
        yield
    except RefusedError as error:
        raise FailedError(team, str(error)) from error


def _asking(team: Team, program: Program) -> Decide:
    """Return a program as what decides for a team."""

    def decide(worlds: Worlds, agents: range, actions: NDArray[np.int64]) -> None:
        moment = worlds.moment()
        asked = asked_agents(moment, agents)
        if asked.any():
            with failing(team):
                actions[asked] = program.actions(np.flatnonzero(asked), moment["views"][asked])

    return decide


def _in_engine(
    config: WorldConfig, pursuers: TeamPolicy, evaders: TeamPolicy, seed: int, episodes: int
) -> Played:
    """Play a match without programs, all of it in the engine."""
    statistics = rollout(
        config, pursuers, evaders, Matches.of(0, 0, [seed]), worlds=episodes, threads=1
    )
    first = record(config, pursuers, evaders, seed=seed)
    return Played(
        statistics.capture_rate[0].astype(np.float64),
        statistics.length[0].astype(np.int64),
        first.actions.astype(np.uint8),
        {},
    )
