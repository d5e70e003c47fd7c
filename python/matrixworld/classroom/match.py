"""Matches of the tournament: two entries, some episodes side by side, the first one recorded.

The world is played here. A program gets the views of its agents and returns actions, whatever it
does in its own process.
"""

from __future__ import annotations

import queue
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack, contextmanager
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from matrixworld.classroom.policy_process import CAN_FORK, NO_FORK, PolicyProcess, PolicyServer
from matrixworld.classroom.sandbox import Limits
from matrixworld.classroom.submissions import Entry
from matrixworld.coevolution.types import TEAMS, Team
from matrixworld.episodes.record import record
from matrixworld.play.matches import Decide, Episodes, asked_agents, decide_by, play_episodes
from matrixworld.play.rollout import Matches, rollout
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import TeamPolicy

Servers: TypeAlias = dict[Team, PolicyServer]
"""Where the programs of the teams run; empty if there are no programs."""


class Played(NamedTuple):
    """The result of a match."""

    capture_rates: NDArray[np.float64]  # (episodes,)
    lengths: NDArray[np.int64]  # (episodes,), in steps
    actions: NDArray[np.uint8]  # (steps, A), of the first episode
    seconds: dict[Team, float]  # processor time of each program


class MatchPool:
    """Plays matches, several side by side, each with servers of its own.

    All pairs play the same starts, those of the seed, so that differences between entries are
    differences in play. The threads of `executor` wait for programs and for the engine, which both
    work outside of Python's lock. `problem` says why programs cannot play here.
    """

    def __init__(
        self,
        config: WorldConfig,
        *,
        seed: int,
        limits: Limits,
        trust: bool,
        threads: int,
        programs: bool,
    ) -> None:
        self.config, self._seed = config, seed
        self.executor = ThreadPoolExecutor(threads)
        self._all: list[PolicyServer] = []
        self._free: queue.SimpleQueue[Servers] = queue.SimpleQueue()
        self.problem = "" if CAN_FORK else NO_FORK
        if programs and CAN_FORK:
            for _ in range(threads):
                servers = {team: PolicyServer(limits, trust) for team in TEAMS}
                self._all += servers.values()
                self._free.put(servers)
            # All of them start at the same time, and find the same.
            self.problem = "".join({server.ready() for server in self._all})

    def close(self) -> None:
        """End all that was started, also where a match is played."""
        # The servers first: a thread that waits for a program gets the end of the connection.
        for server in self._all:
            server.close()
        self.executor.shutdown(cancel_futures=True)

    @contextmanager
    def _servers(self) -> Iterator[Servers]:
        """Hold a server of each team; there are as many as threads, so no thread waits."""
        if not self._all:
            yield {}
            return
        servers = self._free.get()
        try:
            yield servers
        finally:
            self._free.put(servers)

    def functions(self, code: bytes) -> tuple[bool, bool]:
        """Return whether a program has a function for pursuers, and one for evaders.

        RefusedError if it fails while it is loaded.
        """
        with self._servers() as servers:
            settings = self._settings("pursuer", (), ())
            program = PolicyProcess(servers["pursuer"], code, settings)
            program.close()
            return program.functions

    def play(self, pursuers: Entry, evaders: Entry, episodes: int) -> Played:
        """Play a match; RefusedError if a program fails or breaks a limit.

        The result depends on entries, seed and world only, as long as programs do so, too.
        """
        if isinstance(pursuers.policy, bytes) or isinstance(evaders.policy, bytes):
            with self._servers() as servers:
                return self._play_programs(pursuers, evaders, episodes, servers)
        return self._play_in_engine(pursuers.policy, evaders.policy, episodes)

    def _play_programs(
        self, pursuers: Entry, evaders: Entry, episodes: int, servers: Servers
    ) -> Played:
        lengths, steps = np.zeros(episodes, np.int64), []

        def record_round(actions: NDArray[np.int64], running: NDArray[np.bool_]) -> None:
            lengths[running] += 1
            if running[0]:
                steps.append(actions[0].astype(np.uint8))

        programs: dict[Team, PolicyProcess] = {}
        deciders: list[Decide] = []
        with ExitStack() as stack:
            for team, entry in zip(TEAMS, (pursuers, evaders), strict=True):
                if not isinstance(entry.policy, bytes):
                    deciders.append(decide_by(entry.policy))
                    continue
                settings = self._settings(team, pursuers.key, evaders.key)
                programs[team] = PolicyProcess(servers[team], entry.policy, settings)
                stack.callback(programs[team].close)
                deciders.append(_asking(programs[team]))
            rates = play_episodes(
                self.config, *deciders, seed=self._seed, episodes=episodes, on_round=record_round
            )
        seconds = {team: program.seconds for team, program in programs.items()}
        return Played(rates, lengths, np.stack(steps), seconds)

    def _play_in_engine(self, pursuers: TeamPolicy, evaders: TeamPolicy, episodes: int) -> Played:
        """Play a match without programs."""
        matches = Matches.of(0, 0, [self._seed])
        found = rollout(self.config, pursuers, evaders, matches, episodes=episodes, threads=1)
        first = record(self.config, pursuers, evaders, seed=self._seed)
        return Played(
            found.capture_rate[0].astype(np.float64),
            found.length[0].astype(np.int64),
            first.actions.astype(np.uint8),
            {},
        )

    def _settings(
        self, team: Team, pursuers: tuple[int, ...], evaders: tuple[int, ...]
    ) -> dict[str, object]:
        """Return what a program's process is told: its team, the form of views, its own seed."""
        return {
            "team": team,
            "fov": self.config.fov,
            "n_actions": self.config.n_actions,
            # Of what plays, not of its place in the class: it stays the same if others join.
            "seed": [
                TEAMS.index(team), self._seed % 2**32, self._seed >> 32, *pursuers, *evaders
            ],
        }  # fmt: skip


def _asking(program: PolicyProcess) -> Decide:
    """Return a program as what decides for a team."""

    def decide(played: Episodes, agents: range, actions: NDArray[np.int64]) -> None:
        arrays = played.arrays()
        asked = asked_agents(arrays, agents)
        if asked.any():
            actions[asked] = program.actions(np.flatnonzero(asked), arrays["views"][asked])

    return decide
