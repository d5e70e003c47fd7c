"""A team that an environment plays itself, against one or more policies.

``parallel_env("O", evaders="fleer")`` makes an environment of pursuers. An environment can have
several opponents: each episode draws one of them by its seed and number, so that the same seed
gives the same opponent.
"""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld import _core
from matrixworld.play import Callback, NetworkPolicy, Plays, ask, check_fits
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import SCRIPTS, Population
from matrixworld.world.world import World

if TYPE_CHECKING:
    from matrixworld.coevolution import SavedRun, Team

Opponent: TypeAlias = "str | Path | Population | NetworkPolicy | SavedRun | Callback"
"""What can play for a team: the name of a script or of a held-out opponent (``"evolved-2"``), a run
directory (its last generation), a population or a saved run (each genome is an opponent), a
`NetworkPolicy`, or a function from observations of n living agents, uint8 (n, 3, fov, fov), to
actions (n,)."""

Opponents: TypeAlias = "Opponent | Iterable[Opponent]"
"""One or several of them; each episode draws one."""


_PURPOSE = 2**32
"""What opponents' random numbers are drawn for; the engine's own purposes are small numbers."""


class BuiltInTeam:
    """The team that an environment of W worlds plays itself.

    Parameters
    ----------
    team : {"pursuer", "evader"}
        The team.
    opponents : Opponent or iterable of Opponent
        What can play for it.
    config : WorldConfig
        The settings of the worlds.
    n_worlds : int, optional
        W. The default is 1.

    Attributes
    ----------
    agents : range
        Its agents.
    learners : range
        The agents of the other team.
    chosen : ndarray of int64, shape (W,)
        The place in `opponents` of each world's opponent, when its episode began.
    playing : list
        The opponent of each world's episode. Opponents that are set later do not change it.

    Raises
    ------
    ValueError, TypeError
        If an opponent is unknown or has a network for other worlds.
    """

    def __init__(
        self, team: Team, opponents: Opponents, config: WorldConfig, n_worlds: int = 1
    ) -> None:
        teams = range(config.n_pursuers), range(config.n_pursuers, config.n_agents)
        self.agents, self.learners = teams if team == "pursuer" else teams[::-1]
        self._team, self._config = team, config
        self._opponents = self.resolve(opponents)
        self.chosen = np.zeros(n_worlds, np.int64)
        self.playing: list[Plays] = [self._opponents[0]] * n_worlds

    @property
    def opponents(self) -> tuple[Plays, ...]:
        """What can play for the team: scripts, populations of one genome, functions.

        Set it to change what episodes that begin from then on draw from.
        """
        return self._opponents

    @opponents.setter
    def opponents(self, opponents: Opponents) -> None:
        self._opponents = self.resolve(opponents)

    def resolve(self, opponents: Opponents) -> tuple[Plays, ...]:
        """Return opponents in the form that is played; raises as the class does."""
        name = f"{self._team}s"
        found = [
            policy
            for given in _several(opponents)
            for policy in _resolved(name, self._team, given, self._config)
        ]
        if not found:
            raise ValueError(f"{name}: expected at least one opponent, got none")
        return tuple(found)

    def begin(
        self, seed: ArrayLike, episode: ArrayLike, worlds: NDArray[np.bool_] | None = None
    ) -> None:
        """Draw the opponents of episodes that begin.

        Parameters
        ----------
        seed, episode : array_like of uint64, shape (W,)
            The episodes.
        worlds : ndarray of bool, shape (W,), optional
            The worlds in which an episode begins. The default is all.
        """
        seeds, episodes = (np.atleast_1d(np.asarray(key, np.uint64)) for key in (seed, episode))
        begun = np.arange(len(seeds)) if worlds is None else np.flatnonzero(worlds)
        for world in begun:
            place = _drawn(int(seeds[world]), int(episodes[world]), len(self.opponents))
            self.chosen[world] = place
            self.playing[world] = self.opponents[place]

    def decide(self, world: World, agents: range, actions: NDArray[np.int64]) -> None:
        """Write the actions of the team's agents among `agents` in the only world.

        Parameters
        ----------
        world : World
            The world.
        agents : range
            The agents that act.
        actions : ndarray of int64, shape (A,)
            Where to write.
        """
        acting = range(max(agents.start, self.agents.start), min(agents.stop, self.agents.stop))
        [policy] = self.playing
        if not acting:
            return
        if not callable(policy):
            world.decide(policy, acting, actions)
            return
        asked = np.zeros((1, len(actions)), np.bool_)
        asked[0, acting] = world.alive[acting]
        ask(policy, world.views()[None], asked, actions[None], self._config.n_actions)


def _drawn(seed: int, episode: int, n: int) -> int:
    """Return the place of an episode's opponent among n, all equally likely."""
    word = _core.philox([0, 0, _PURPOSE, 0], [seed, episode])[0]
    return word * n >> 64  # the upper half of the product, as the engine draws integers below n


def built_in_team(
    config: WorldConfig,
    pursuers: Opponents | None,
    evaders: Opponents | None,
    n_worlds: int = 1,
) -> BuiltInTeam | None:
    """Return the team that an environment plays itself; None if the caller plays both.

    Parameters
    ----------
    config : WorldConfig
        The settings of the worlds.
    pursuers, evaders : Opponent or iterable of Opponent, optional
        What plays for a team; None for the caller's team.
    n_worlds : int, optional
        Number of worlds. The default is 1.

    Raises
    ------
    ValueError, TypeError
        As `BuiltInTeam` does, and if both teams are given.
    """
    if pursuers is not None and evaders is not None:
        raise ValueError(
            "pursuers, evaders: expected one team that the environment plays, got both; "
            "matrixworld.rollout plays matches of both"
        )
    if pursuers is not None:
        return BuiltInTeam("pursuer", pursuers, config, n_worlds)
    return None if evaders is None else BuiltInTeam("evader", evaders, config, n_worlds)


def set_opponents(team: BuiltInTeam | None, opponents: Opponents) -> None:
    """Set the opponents of an environment; raise ValueError if it plays no team itself."""
    if team is None:
        raise ValueError(
            "opponents: expected an environment that plays a team (pursuers= or evaders=), got one "
            "whose caller plays both"
        )
    team.opponents = opponents


def _several(opponents: Any) -> list[Any]:
    # Functions can be iterable: torch.nn.Sequential iterates over its layers.
    one = isinstance(opponents, str) or callable(opponents) or not isinstance(opponents, Iterable)
    return [opponents] if one else list(opponents)


def _resolved(name: str, team: Team, given: Any, config: WorldConfig) -> Iterable[Plays]:
    """Return the policies that an opponent stands for."""
    if isinstance(given, str) and given in SCRIPTS:
        return [given]
    if isinstance(given, str | Path):
        given = _named(name, team, given, config)
    elif isinstance(given, NetworkPolicy):
        given = given.population()
    elif hasattr(given, "teams"):  # a saved run; its class is not imported here
        return _resolved(name, team, given.teams[team], config)
    if isinstance(given, Population):
        return _genomes(name, given, config)
    if callable(given):
        return [given]
    raise TypeError(
        f"{name}: expected the name of a script or held-out opponent, a run directory, a "
        f"Population, a NetworkPolicy, a SavedRun or a function, got {given!r}"
    )


def _named(name: str, team: Team, given: str | Path, config: WorldConfig) -> Population:
    # Co-evolution needs more packages and time to import than environments do.
    from matrixworld.coevolution import held_out, last_generation

    evolved = {
        each: policy
        for each, policy in held_out(team, config.rules).items()
        if isinstance(policy, Population)
    }
    if str(given) in evolved:
        return evolved[str(given)]
    if not Path(given).is_dir():
        known = ", ".join([*SCRIPTS, *evolved])
        raise ValueError(f"{name}: expected one of {known}, or a run directory, got {str(given)!r}")
    return last_generation(given, team)


def _genomes(name: str, population: Population, config: WorldConfig) -> list[Plays]:
    check_fits(name, population.network, config)
    return [Population(genome, population.network) for genome in population.genomes]
