"""What environments share: observations, and a team that they play, as in ``evaders="fleer"``.

Of several opponents each episode draws one by its seed and number.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, Literal, TypeAlias

import numpy as np
from gymnasium import spaces
from numpy.typing import ArrayLike, DTypeLike, NDArray

from matrixworld import _core
from matrixworld._util.checks import check_bool, check_choice, check_sequence, check_shape
from matrixworld._util.teams import PLURALS
from matrixworld.play.functions import Function, Seats
from matrixworld.play.player import SOLVED as SOLVED
from matrixworld.play.player import Plays, placed
from matrixworld.world.arrays import array_specs, integers
from matrixworld.world.batch import Batch
from matrixworld.world.config import WorldConfig
from matrixworld.world.masks import ActionMasks
from matrixworld.world.policy import TEAMS, Network, Population, Team
from matrixworld.world.world import World

Opponents: TypeAlias = Any
"""One or several of what `matrixworld.player` takes; each episode draws one. Each genome of a
population or of a saved run is an opponent."""

Observation: TypeAlias = Literal["views", "named"]
"""What agents observe: their views, or the named inputs of their moves."""

# The array that agents observe, and its dtypes, of which the first is the default.
_OBSERVED: dict[Any, tuple[str, tuple[str, ...]]] = {
    "views": ("views", ("uint8", "float32")),
    "named": ("inputs", ("float32",)),
}

FIRST: dict[Any, tuple[str, Opponents]] = {
    "pursuer": ("evaders", "clumsy-fleer"),
    "evader": ("pursuers", "clumsy-chaser"),
}
"""By the team that the caller plays: the argument for the other one, and who plays it if nothing
else is said. Against these, first attempts learn."""

_PURPOSE = 2**32
"""What opponents' random numbers are drawn for; the engine's own purposes are small numbers."""


class BuiltInTeam:
    """The team of `agents` that an environment of W worlds plays itself, against `learners`.

    `playing` is the opponent of each world's episode; `chosen`, (W,), was its place in `opponents`.
    """

    def __init__(
        self, team: Team, opponents: Opponents, config: WorldConfig, n_worlds: int = 1
    ) -> None:
        pursuers = range(config.n_pursuers)
        evaders = range(config.n_pursuers, config.n_agents)
        if team == "pursuer":
            self.agents, self.learners = pursuers, evaders
        else:
            self.agents, self.learners = evaders, pursuers
        self._team = team
        self._config = config
        self.opponents = self.resolve(opponents)
        self._seats: dict[int, Seats] = {}  # by identity of the function
        self.chosen = np.zeros(n_worlds, np.int64)
        self.playing: list[Plays] = [self.opponents[0]] * n_worlds

    def resolve(self, opponents: Opponents) -> tuple[Plays, ...]:
        """Return opponents in the form that is played."""
        return resolved(self._team, opponents, self._config)

    @property
    def yields_in_turn(self) -> bool:
        """Whether what plays in the only world has the right of way in the order of the step."""
        [policy] = self.playing
        learned = isinstance(policy, Population) and not isinstance(policy.policy, Network)
        return learned or isinstance(policy, str)

    def draw(self, world: int, seed: int, episode: int) -> None:
        """Draw the opponent of an episode that begins in a world, all equally likely."""
        # Where both teams are played, their draws differ by the word that `learners` begin with.
        word = _core.philox([0, 0, _PURPOSE, self.learners.start], [seed, episode])[0]
        # The upper half of the product, as the engine draws integers below n.
        self.chosen[world] = word * len(self.opponents) >> 64
        plays = self.playing[world] = self.opponents[self.chosen[world]]
        if isinstance(plays, Function):
            self.seats(plays).begin(world, seed, episode)

    def seats(self, function: Function) -> Seats:
        """Return a function with its random numbers and memories in all worlds."""
        if id(function) not in self._seats:
            number, worlds = TEAMS.index(self._team), len(self.chosen)
            self._seats[id(function)] = Seats(function, self._config.n_actions, number, worlds)
        return self._seats[id(function)]

    def decide(self, world: World, agents: range, actions: NDArray[np.int64]) -> None:
        """Write the actions (A,) of the team's agents among `agents`, in the only world."""
        acting = range(max(agents.start, self.agents.start), min(agents.stop, self.agents.stop))
        [policy] = self.playing
        if not acting:
            return
        if not isinstance(policy, Function):
            world.decide(policy, acting, actions)
            return
        asked = np.zeros(actions.shape, np.bool_)
        asked[acting] = world.alive[acting]
        if asked.any():
            seen = world.inputs() if policy.reads == "inputs" else world.views()
            actions[asked] = self.seats(policy)(asked[np.newaxis], seen[asked])


class BuiltInWorlds(BuiltInTeam):
    """A built-in team in all worlds of a batch; ended ones wait for a step or a reset, or do not.

    `last`, (W,), is the place in `opponents` of the opponent in each world's last ended episode.
    """

    def __init__(self, team: Team, opponents: Opponents, batch: Batch, waits: bool) -> None:
        self._batch = batch
        self._buffers = batch.buffers
        super().__init__(team, opponents, batch.config, batch.n_worlds)
        self.last = np.zeros_like(self.chosen)
        self._waits = waits
        self._actions: NDArray[np.int64] = np.zeros(self._buffers["alive"].shape, np.int64)
        self.begin(np.zeros(batch.n_worlds, np.bool_))

    def begin(self, worlds: NDArray[np.bool_]) -> None:
        """Draw the opponents of the worlds of a mask (W,), whose episodes have begun."""
        self._episodes = self._keys()
        for world in np.flatnonzero(worlds).tolist():
            self.draw(world, *self._episodes[:, world].tolist())
        # The policies that play, and the place in this list of each world's policy. By identity:
        # equality of functions of the user may be anything.
        places: dict[int, int] = {}
        numbers = [places.setdefault(id(policy), len(places)) for policy in self.playing]
        self._numbers = np.array(numbers, np.int32)
        self._policies: list[Plays] = list({id(policy): policy for policy in self.playing}.values())

    def resolve(self, opponents: Opponents) -> tuple[Plays, ...]:
        """Return opponents in the form that is played; ValueError for what batches do not write."""
        policies = super().resolve(opponents)
        for policy in policies:
            if isinstance(policy, Function) and policy.reads not in self._buffers:
                raise ValueError(
                    f"{policy.name}: expected a function of views, got one of inputs, which this "
                    "environment does not write; name it when the environment is made"
                )
        return policies

    def _keys(self) -> NDArray[np.uint64]:
        """Return a copy of seed and episode of every world, (2, W)."""
        return np.stack([self._buffers["seed"], self._buffers["episode"]])

    def actions(self, learners: ArrayLike) -> NDArray[np.int64]:
        """Return the actions of all agents, (W, A), with those of the caller's agents."""
        chosen = integers("actions", learners)
        check_shape("actions", chosen, len(self._actions), len(self.learners))
        self._actions[:, self.learners.start : self.learners.stop] = chosen
        engine = [None if isinstance(policy, Function) else policy for policy in self._policies]
        self._batch.decide(engine, self._numbers, self.agents, self._actions)
        acting = np.zeros_like(self._buffers["alive"])
        acting[:, self.agents] = self._buffers["alive"][:, self.agents]
        if self._waits:
            acting[self._buffers["terminated"] | self._buffers["truncated"]] = False
        for number, policy in enumerate(self._policies):
            asked = acting & (self._numbers == number)[:, None]
            if isinstance(policy, Function) and asked.any():
                seen = self._buffers[policy.reads][asked]
                if policy.reads == "views":
                    seen = seen.astype(np.uint8, copy=False)
                self._actions[asked] = self.seats(policy)(asked, seen)
        return self._actions

    def note_step(self) -> None:
        """Draw opponents of the episodes that the batch began by itself; call it after a step."""
        ended = self._buffers["ended"]
        self.last[ended] = self.chosen[ended]
        begun = (self._keys() != self._episodes).any(axis=0)
        if begun.any():
            self.begin(begun)


def one_team(
    pursuers: Opponents | None, evaders: Opponents | None
) -> tuple[Team, Opponents] | None:
    """Return the team that an environment plays itself, and its opponents, if there is one."""
    if pursuers is not None and evaders is not None:
        raise ValueError(
            "pursuers, evaders: expected one team that the environment plays, got both; "
            "matrixworld.rollout plays matches of both"
        )
    if pursuers is not None:
        return "pursuer", pursuers
    if evaders is not None:
        return "evader", evaders
    return None


def with_opponent(team: Team | None, opponent: Opponents | None, settings: Any) -> Any:
    """Return settings of an environment in which the caller plays `team`, if there is one."""
    if team is None and opponent is None:
        return settings
    check_choice("team", team, FIRST)
    name, usual = FIRST[team]
    return {name: usual if opponent is None else opponent, **settings}


class PlaysTeam:
    """What environments of one world and of many share: settings, and a team that they play."""

    _team: BuiltInTeam | None = None
    _observed: str  # the array of `array_specs` that agents observe

    def _set_up(
        self, config: Any, changes: Any, action_mask: bool | str, mode: str | None, *modes: str
    ) -> None:
        if mode not in (None, *modes):
            raise ValueError(f"render_mode: expected None or one of {modes}, got {mode!r}")
        self.config: WorldConfig = WorldConfig.of(config, **changes)
        self._masks = ActionMasks(action_mask, self.config)
        self.render_mode = mode
        self.metadata: dict[str, Any] = {"render_modes": list(modes), "render_fps": 10}

    def _space_of(
        self, observation: Observation, dtype: DTypeLike | None, flatten: bool
    ) -> spaces.Box:
        """Return the space of one agent's observation, and keep which array that is."""
        check_choice("observation", observation, _OBSERVED)
        self._observed, dtypes = _OBSERVED[observation]
        kind: np.dtype[Any] = np.dtype(dtypes[0] if dtype is None else dtype)
        check_choice("dtype", kind.name, dtypes)
        (_, *shape), _ = array_specs(self.config)[self._observed]
        most = [bound or np.inf for *_, bound in _core.inputs()] if observation == "named" else 1
        high = np.full(shape, most, kind)
        flat = check_bool("flatten", flatten)
        return spaces.Box(0, high.ravel() if flat else high, dtype=kind.type)

    @property
    def opponents(self) -> tuple[Plays, ...]:
        """What can play for the built-in team; episodes that begin draw from it. May be set."""
        return () if self._team is None else self._team.opponents

    @opponents.setter
    def opponents(self, opponents: Opponents) -> None:
        if self._team is None:
            raise ValueError(
                "opponents: expected an environment that plays a team (pursuers= or evaders=), got "
                "one whose caller plays both"
            )
        self._team.opponents = self._team.resolve(opponents)


def resolved(team: Team, opponents: Opponents, config: WorldConfig) -> tuple[Plays, ...]:
    """Return opponents, who play for a team, in the form that is played."""
    name = PLURALS[team]
    policies: list[Plays] = []
    for opponent in _several(name, opponents):
        policies += _resolved(name, team, opponent, config)
    if not policies:
        raise ValueError(f"{name}: expected at least one opponent, got none")
    return tuple(policies)


def _several(name: str, opponents: Any) -> list[Any]:
    # Functions can be iterable: torch.nn.Sequential iterates over its layers.
    one = isinstance(opponents, str) or callable(opponents) or not isinstance(opponents, Iterable)
    return [opponents] if one else list(check_sequence(name, opponents, "opponents"))


def _resolved(name: str, team: Team, opponent: Any, config: WorldConfig) -> list[Plays]:
    """Return the policies that an opponent stands for."""
    plays = placed(name, opponent, team, config)
    if not isinstance(plays, Population):
        return [plays]
    return [Population(genome, plays.policy) for genome in plays.genomes]
