"""The arrays of a vector environment: buffers, infos, copies, and the part of one team."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeVar, cast

import numpy as np
from gymnasium import spaces
from numpy.typing import DTypeLike, NDArray

from matrixworld.world.arrays import (
    BATCH_FIELDS,
    WORLD_FIELDS,
    Specs,
    array_specs,
    episode_specs,
    new_arrays,
)
from matrixworld.world.config import WorldConfig
from matrixworld.world.rules import COLLISION_KINDS

if TYPE_CHECKING:
    from matrixworld.envs.vector import VectorEnv

Results = TypeVar("Results", bound="tuple[Any, ...]")
"""What `reset` or `step` of a vector environment returns."""

EPISODE_KEYS = {
    name.removeprefix("episode_"): name for name in BATCH_FIELDS if name.startswith("episode_")
}
"""The keys of ``infos["episode"]``, and the arrays of `episode_specs` that they are."""

AGENT_KEYS = (
    *(name for name, field in WORLD_FIELDS.items() if field.axes[:1] == ("agents",)),
    *("acted", "final_obs", "action_mask", *(f"cost_{kind}" for kind in COLLISION_KINDS)),
)
"""The keys of infos whose arrays have an axis of agents after that of worlds."""

# Arrays that infos leave out: `reset` and `step` return them, or infos have them in another form.
_NOT_IN_INFOS = {
    *("rewards", "terminations", "truncations", "views", "last_positions"),
    *("ended", "final_views", *EPISODE_KEYS.values()),
}
# Gymnasium has its own meaning for ``infos["episode"]``.
_RENAMED = {"steps": "step", "episode": "episode_number"}


def view_dtype(dtype: DTypeLike) -> np.dtype[Any]:
    """Return the dtype of views; raise ValueError unless it is uint8 or float32."""
    chosen = np.dtype(dtype)
    if chosen not in (np.uint8, np.float32):
        raise ValueError(f"dtype: expected uint8 or float32, got {chosen}")
    return chosen


def make_buffers(
    config: WorldConfig, n_worlds: int, views: np.dtype[Any], left_out: set[str]
) -> dict[str, NDArray[Any]]:
    """Return an array of zeros for each output of a batch that is not left out."""
    specs = array_specs(config) | episode_specs(config)
    chosen: Specs = {
        name: (shape, views if name.endswith("views") else dtype)
        for name, (shape, dtype) in specs.items()
        if name not in left_out
    }
    return new_arrays(chosen, n_worlds)


def of_agents(buffers: dict[str, NDArray[Any]], agents: range) -> dict[str, NDArray[Any]]:
    """Return the same arrays with some agents only, without copies."""
    fields = WORLD_FIELDS | BATCH_FIELDS
    return {
        name: array[:, agents.start : agents.stop]
        if fields[name].axes[:1] == ("agents",)
        else array
        for name, array in buffers.items()
    }


def make_infos(buffers: dict[str, NDArray[Any]], observations: NDArray[Any]) -> dict[str, Any]:
    """Return the infos of a vector environment: its buffers under the names of `VectorEnv`."""
    infos: dict[str, Any] = {
        _RENAMED.get(name, name): array
        for name, array in buffers.items()
        if name not in _NOT_IN_INFOS
    }
    infos |= {f"cost_{kind}": buffers["fault"][..., k] for k, kind in enumerate(COLLISION_KINDS)}
    # Without an array of its own, the end of an episode is what the observations show then.
    final = buffers.get("final_views")
    infos["final_obs"] = observations if final is None else final.reshape(observations.shape)
    infos["episode"] = {key: buffers[name] for key, name in EPISODE_KEYS.items()}
    return infos | dict.fromkeys(("_final_obs", "_episode"), buffers["ended"])


def copied(results: Results) -> Results:
    """Return copies of arrays and infos; what was one array in two places is one copy in both."""
    copies: dict[int, Any] = {}

    def copy_of(value: Any) -> Any:
        if isinstance(value, dict):
            return {key: copy_of(each) for key, each in value.items()}
        if id(value) not in copies:
            copies[id(value)] = value.copy()
        return copies[id(value)]

    return cast("Results", tuple(map(copy_of, results)))


class TeamView:
    """One team's part of a `VectorEnv`'s arrays, without copies.

    Parameters
    ----------
    env : VectorEnv
        The environment.
    agents : slice
        The team's agents; n is their number.

    Attributes
    ----------
    observations : ndarray, shape (W, n, ...)
        What each agent sees.
    actions : ndarray of int64, shape (W, n)
        Actions of a `step` without arguments, to be filled in place.
    rewards, terminations, truncations, alive, acted, cost : ndarray, shape (W, n)
        As in `VectorEnv` and its infos.
    positions : ndarray of int32, shape (W, n, 2)
        Rows and columns.
    involved, fault : ndarray of bool, shape (W, n, 3)
        Collisions by kind.
    observation_space, action_space : gymnasium.spaces.Space
        Spaces of one agent.

    Notes
    -----
    Every step overwrites these arrays, also with ``copy=True``: copy what you keep.
    """

    def __init__(self, env: VectorEnv, agents: slice) -> None:
        self.agents: slice = agents
        self.observations: NDArray[Any] = env.observations[:, agents]
        self.actions: NDArray[np.int64] = env.actions[:, agents]
        self.rewards: NDArray[np.float32] = env.rewards[:, agents]
        self.terminations: NDArray[np.bool_] = env.terminations[:, agents]
        self.truncations: NDArray[np.bool_] = env.truncations[:, agents]
        self.alive: NDArray[np.bool_] = env.infos["alive"][:, agents]
        self.acted: NDArray[np.bool_] = env.infos["acted"][:, agents]
        self.cost: NDArray[np.float32] = env.infos["cost"][:, agents]
        self.positions: NDArray[np.int32] = env.infos["positions"][:, agents]
        self.involved: NDArray[np.bool_] = env.infos["involved"][:, agents]
        self.fault: NDArray[np.bool_] = env.infos["fault"][:, agents]
        shape, dtype = self.observations.shape[2:], self.observations.dtype
        self.observation_space: spaces.Box = spaces.Box(0, 1, shape, dtype.type)
        self.action_space: spaces.Discrete = spaces.Discrete(env.config.n_actions)

    @property
    def size(self) -> int:
        """The number of agents, n."""
        return int(self.actions.shape[1])
