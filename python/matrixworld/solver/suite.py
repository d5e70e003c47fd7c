"""Suites of solved worlds in which players are graded: MW-25, and worlds of your own."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any

from matrixworld._util import checks
from matrixworld._util.files import read_json, read_text
from matrixworld.solver.solution import Solution, best_response, solve
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import SCRIPTS, TEAMS, Team

FILE = Path(__file__).with_name("mw25.json")


@dataclass(frozen=True, eq=False)
class SuiteWorld:
    """A world in which players are graded.

    Parameters
    ----------
    name : str
        What it is called.
    config : WorldConfig
        Its settings. The episodes that are graded have its `max_steps`.
    value : float
        The capture rate if both teams play perfectly.
    second : float or None
        What it is worth to the pursuers to move second in every round; None if it is not known.
    known : mapping
        What scripts guarantee, as capture rates by team and script; empty if it is not known.
    """

    name: str
    config: WorldConfig
    value: float
    second: float | None
    known: Mapping[Team, Mapping[str, float]]

    @classmethod
    def of(cls, config: WorldConfig) -> SuiteWorld:
        """Return a world of your own, which is solved now; ValueError if it is too large."""
        checks.check_instance("worlds", config, WorldConfig)
        board = f"{config.rows} x {config.cols}"
        teams = f"{config.n_pursuers} v {config.n_evaders}"
        perfect = solve(config)
        name = f"{teams}; {board}; {config.max_steps} steps"
        world = cls(name, config, perfect.value, None, {})
        world.__dict__["perfect"] = perfect  # as if it had been asked for
        return world

    @cached_property
    def _scripts(self) -> dict[Team, Mapping[str, float]]:
        return dict(self.known)

    @cached_property
    def _views(self) -> dict[int, SuiteWorld]:
        return {}

    @cached_property
    def perfect(self) -> Solution:
        """Perfect play of both teams."""
        return solve(self.config)

    @property
    def in_turns(self) -> bool:
        """Whether the teams, or all agents, move in turns."""
        return self.perfect.states.n_turns > 1

    def scripts(self, team: Team) -> Mapping[str, float]:
        """Return what scripts guarantee, as capture rates: those that can be graded exactly."""
        if team not in self._scripts:
            found = {}
            for script in SCRIPTS:
                with suppress(ValueError):  # such as one that searches
                    found[script] = best_response(self.perfect.states, script, team).value
            self._scripts[team] = found
        return self._scripts[team]

    def with_fov(self, fov: int) -> SuiteWorld:
        """Return the same world with other views."""
        if fov == self.config.fov:
            return self
        if fov not in self._views:
            self._views[fov] = replace(self, config=replace(self.config, fov=fov))
        return self._views[fov]


@dataclass(frozen=True, eq=False)
class Suite:
    """Worlds in which players are graded, with a name and a version.

    A version never changes its meaning: grades of the same suite and version can be compared.

    Parameters
    ----------
    name : str
        Its name.
    version : int
        Its version; 0 for worlds of your own.
    worlds : tuple of SuiteWorld
        The worlds.
    """

    name: str
    version: int
    worlds: tuple[SuiteWorld, ...]

    @cached_property
    def marks(self) -> dict[Team, Any]:
        """Grades of others in these worlds, once they are known."""
        return {}

    def __repr__(self) -> str:
        return f"<{self.name}, version {self.version}: {len(self.worlds)} worlds>"

    @classmethod
    def of(cls, worlds: Any) -> Suite:
        """Return a suite of a `WorldConfig`, of several, or of what already is one."""
        if isinstance(worlds, Suite):
            return worlds
        one = isinstance(worlds, WorldConfig | SuiteWorld)
        several = [worlds] if one else list(checks.check_sequence("worlds", worlds, "WorldConfig"))
        if not several:
            raise ValueError("worlds: expected at least one, got none")
        found = tuple(
            each if isinstance(each, SuiteWorld) else SuiteWorld.of(each) for each in several
        )
        return cls("own worlds", 0, found)


def _read(path: Path) -> Suite:
    """Return the suite that a file of the package holds."""
    plain = read_json(path, read_text(path, "suite"))
    worlds = [
        SuiteWorld(
            each["name"],
            WorldConfig.from_json(each["world"]),
            each["value"],
            each["second"],
            {team: each["scripts"][team] for team in TEAMS},
        )
        for each in plain["worlds"]
    ]
    return Suite(plain["name"], plain["version"], tuple(worlds))


SUITE = _read(FILE)
"""MW-25: 25 solved worlds (``docs/suite.md``)."""
