"""Many worlds at once, in the manner of Gymnasium's vector environments."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from gymnasium import spaces
from gymnasium.vector import AutoresetMode
from gymnasium.vector import VectorEnv as GymnasiumVectorEnv
from gymnasium.vector.utils import batch_space
from numpy.typing import ArrayLike, DTypeLike, NDArray

from matrixworld._core import Autoreset
from matrixworld.arrays import array_specs, episode_specs
from matrixworld.batch import Batch
from matrixworld.checks import check_bool, check_integer
from matrixworld.config import WorldConfig
from matrixworld.render import rgb
from matrixworld.rules import KINDS, Rules
from matrixworld.world import World

OPTIONS = ("reset_mask", "episode", "pursuers", "evaders", "obstacles")
"""What ``options`` of a reset may hold."""

EPISODE_KEYS = {
    "return": "episode_return",
    "length": "episode_length",
    "capture_rate": "episode_capture_rate",
    "ever_capture_rate": "episode_ever_capture_rate",
    "survivors": "episode_survivors",
    "collisions": "episode_collisions",
    "faults": "episode_faults",
    "agent_steps": "episode_agent_steps",
}
"""The entries of ``infos["episode"]``, and the arrays of `episode_specs` that they are."""

_INFO_KEYS = (
    *("alive", "acted", "positions", "captured", "ever_captured", "captors"),
    *("involved", "fault", "cost", "capture_rate", "ever_capture_rate", "survival_rate"),
    *("terminated", "truncated", "seed"),
)


class VectorEnv(GymnasiumVectorEnv[NDArray[Any], NDArray[Any], NDArray[Any]]):
    """W worlds of A agents, P pursuers and then E evaders, stepped together.

    config: a `WorldConfig`, `Rules`, or the name of a variant; keywords change its fields
    n_worlds: W
    autoreset_mode: Gymnasium's ``AutoresetMode``, or its value. ``NextStep``: the step after an
        episode's last ignores that world's actions and starts its seed's next episode.
        ``SameStep``: the last step itself goes on to start it: observations, positions, alive, step,
        seed and state are then of the new episode, all else of the ended one, whose last
        observations are in ``infos["final_obs"]``. ``Disabled``: an ended world stands still, with
        rewards of 0, until ``reset(options={"reset_mask": ended})``.
    dtype: of the observations, uint8 or float32
    flatten: observations ``(W, A, 3 * fov * fov)`` instead of ``(W, A, 3, fov, fov)``
    state: whether to write the whole worlds, too, in ``infos["state"]``, ``(W, 3, rows, cols)``
    threads: how many work on a step; by default one a core. No result depends on it.
    render_mode: None, or "rgb_array" for `render`

    Differs from Gymnasium's vector environments of single agents in this: rewards, terminations and
    truncations are ``(W, A)``, one for each agent. An agent terminates when it is gone or its world
    terminates, and stays so; ``infos["acted"]`` tells whose transition of this step counts.

    **Nothing is copied.** Every array that `reset` and `step` return is the same at every step and
    is overwritten by the next one: copy what you keep. `pursuers` and `evaders` are the two teams'
    parts of the same arrays. `actions` may be filled in place for a `step` without arguments.

    The keys of ``infos`` are the same at every step:

    | key | shape | |
    |---|---|---|
    | ``alive`` | (W, A) bool | now |
    | ``acted`` | (W, A) bool | alive as the step began: its transition counts |
    | ``positions`` | (W, A, 2) int32 | row, column; -1, -1 when gone |
    | ``captured``, ``ever_captured`` | (W, E) bool | at this moment; in this episode |
    | ``captors`` | (W, E) int32 | pursuers with part in a capture of this step |
    | ``involved``, ``fault`` | (W, A, 3) bool | in a collision with obstacle, teammate, adversary |
    | ``cost`` | (W, A) float32 | the number of kinds in which it is at fault |
    | ``cost_obstacle``, ``cost_teammate``, ``cost_adversary`` | (W, A) bool | at fault in each |
    | ``capture_rate``, ``ever_capture_rate`` | (W,) float32 | shares of the evaders |
    | ``survival_rate`` | (W, 2) float32 | of pursuers, of evaders |
    | ``terminated``, ``truncated`` | (W,) bool | the worlds |
    | ``step`` | (W,) int32 | rounds played in the episode |
    | ``seed``, ``episode_number`` | (W,) uint64 | which episode it is: `World.reset` takes both |
    | ``final_obs``, ``_final_obs`` | as observations; (W,) bool | of an episode that ended in this step; where one did |
    | ``episode``, ``_episode`` | dict of `EPISODE_KEYS`; (W,) bool | what the last episode to end came to, as in `EpisodeStatistics`; where it ended in this step |

    Raises as `WorldConfig` and `Batch` do.
    """  # noqa: E501  (a table's row is one line)

    def __init__(
        self,
        config: WorldConfig | Rules | str = "O",
        n_worlds: int = 1,
        *,
        autoreset_mode: AutoresetMode | str = AutoresetMode.NEXT_STEP,
        dtype: DTypeLike = np.uint8,
        flatten: bool = False,
        state: bool = False,
        threads: int | None = None,
        render_mode: str | None = None,
        **changes: Any,
    ) -> None:
        self.config = WorldConfig.of(config, **changes)
        self.num_envs = check_integer("n_worlds", n_worlds, 1)
        if render_mode not in (None, "rgb_array"):
            raise ValueError(f"render_mode: expected None or 'rgb_array', got {render_mode!r}")
        self.render_mode = render_mode
        mode = _mode(autoreset_mode)
        self.metadata = {"autoreset_mode": mode, "render_modes": ["rgb_array"], "render_fps": 10}
        left_out = set() if check_bool("state", state) else {"state"}
        if mode is not AutoresetMode.SAME_STEP:
            left_out.add("final_views")  # the observations themselves are the last of an episode
        kept = _buffers(self.config, self.num_envs, _view_dtype(dtype), left_out)
        self._batch = Batch(
            self.num_envs,
            self.config,
            threads=threads,
            autoreset=Autoreset[mode.name],
            buffers=kept,
        )
        self._seeded = False
        self._name_arrays(kept, check_bool("flatten", flatten))
        self._make_spaces()
        self.actions = np.zeros((self.n_worlds, self.config.n_agents), np.int64)
        self.pursuers = TeamView(self, slice(0, self.config.n_pursuers))
        self.evaders = TeamView(self, slice(self.config.n_pursuers, None))

    def _name_arrays(self, kept: dict[str, NDArray[Any]], flatten: bool) -> None:
        shape = kept["views"].shape
        seen = (*shape[:2], -1) if flatten else shape
        self.observations = kept["views"].reshape(seen)
        self.rewards = kept["rewards"]
        self.terminations, self.truncations = kept["terminations"], kept["truncations"]
        self.infos: dict[str, Any] = {name: kept[name] for name in _INFO_KEYS}
        self.infos |= {f"cost_{kind}": kept["fault"][..., k] for k, kind in enumerate(KINDS)}
        self.infos |= {"step": kept["steps"], "episode_number": kept["episode"]}
        final = kept.get("final_views", kept["views"])
        self.infos |= {"final_obs": final.reshape(seen), "_final_obs": kept["ended"]}
        self.infos["episode"] = {key: kept[name] for key, name in EPISODE_KEYS.items()}
        self.infos["_episode"] = kept["ended"]
        if "state" in kept:
            self.infos["state"] = kept["state"]

    def _make_spaces(self) -> None:
        shape, dtype = self.observations.shape[1:], self.observations.dtype
        self.single_observation_space = spaces.Box(0, 1, shape, dtype.type)
        self.single_action_space = spaces.MultiDiscrete(
            [self.config.n_actions] * self.config.n_agents
        )
        self.observation_space = batch_space(self.single_observation_space, self.num_envs)
        self.action_space = batch_space(self.single_action_space, self.num_envs)

    @property
    def n_worlds(self) -> int:
        """W; also ``num_envs``, as Gymnasium calls it."""
        return self.num_envs

    def reset(
        self,
        *,
        seed: int | ArrayLike | None = None,
        options: Mapping[str, Any] | None = None,
    ) -> tuple[NDArray[Any], dict[str, Any]]:
        """Start an episode in every world and return observations and infos.

        seed: an int s, which gives world w the seed s + w, or ``(W,)`` ints. Without one each world
            goes on to its seed's next episode; worlds that never had a seed draw one from the
            operating system.
        options: any of `OPTIONS`: ``reset_mask``, ``(W,)`` bool, the worlds to reset; ``episode``,
            which one of the seed; ``pursuers`` and ``evaders``, positions ``(n, 2)`` or
            ``(W, n, 2)``; ``obstacles``, a map for these episodes

        Raises ValueError for other options and as `Batch.reset` does; then nothing has changed.
        """
        given = dict(options or {})
        unknown = set(given) - set(OPTIONS)
        if unknown:
            raise ValueError(f"options: expected some of {OPTIONS}, got {sorted(unknown)}")
        if seed is None and not self._seeded:
            seed = np.random.SeedSequence().generate_state(self.n_worlds, np.uint64)
        self._batch.reset(seed, mask=given.pop("reset_mask", None), **given)
        self._seeded = True
        return self.observations, self.infos

    def step(
        self, actions: ArrayLike | None = None
    ) -> tuple[NDArray[Any], NDArray[Any], NDArray[Any], NDArray[Any], dict[str, Any]]:
        """Play one round in every world.

        actions: ``(W, A)`` ints, see `Action`; by default what `actions` holds. Those of gone
            agents and ended worlds are not looked at.

        Returns observations, rewards ``(W, A)`` float32, terminations and truncations ``(W, A)``
        bool, infos. Raises RuntimeError before the first reset, and as `Batch.step` does.
        """
        if not self._seeded:
            raise RuntimeError("call reset() before the first step")
        self._batch.step(self.actions if actions is None else actions)
        return self.observations, self.rewards, self.terminations, self.truncations, self.infos

    def world(self, number: int) -> World:
        """A copy of one world, which goes on by itself: to draw it, or to plan in it."""
        return self._batch.world(number)

    def render(self) -> tuple[NDArray[np.uint8], ...] | None:
        """Pictures ``(height, width, 3)`` uint8 of all worlds; None without a render mode."""
        if self.render_mode is None:
            return None
        return tuple(rgb(self.world(number).scene()) for number in range(self.n_worlds))


class TeamView:
    """One team's part of a `VectorEnv`'s arrays, n its size. Nothing is copied.

    observations: ``(W, n, ...)``; actions: ``(W, n)`` int64, which may be written to; rewards,
    terminations, truncations, alive, acted, cost: ``(W, n)``; positions: ``(W, n, 2)``; involved,
    fault: ``(W, n, 3)``; observation_space, action_space: of one agent
    """

    def __init__(self, env: VectorEnv, agents: slice) -> None:
        self.agents = agents
        self.observations = env.observations[:, agents]
        self.actions = env.actions[:, agents]
        self.rewards = env.rewards[:, agents]
        self.terminations = env.terminations[:, agents]
        self.truncations = env.truncations[:, agents]
        self.alive: NDArray[np.bool_] = env.infos["alive"][:, agents]
        self.acted: NDArray[np.bool_] = env.infos["acted"][:, agents]
        self.cost: NDArray[np.float32] = env.infos["cost"][:, agents]
        self.positions: NDArray[np.int32] = env.infos["positions"][:, agents]
        self.involved: NDArray[np.bool_] = env.infos["involved"][:, agents]
        self.fault: NDArray[np.bool_] = env.infos["fault"][:, agents]
        shape, dtype = self.observations.shape[2:], self.observations.dtype
        self.observation_space = spaces.Box(0, 1, shape, dtype.type)
        self.action_space = spaces.Discrete(env.config.n_actions)

    @property
    def size(self) -> int:
        """n, the number of agents."""
        return int(self.actions.shape[1])


def _mode(given: AutoresetMode | str) -> AutoresetMode:
    for mode in AutoresetMode:
        if given in (mode, mode.value):
            return mode
    expected = ", ".join(mode.value for mode in AutoresetMode)
    raise ValueError(f"autoreset_mode: expected one of {expected}, got {given!r}")


def _view_dtype(dtype: DTypeLike) -> np.dtype[Any]:
    chosen = np.dtype(dtype)
    if chosen not in (np.uint8, np.float32):
        raise ValueError(f"dtype: expected uint8 or float32, got {chosen}")
    return chosen


def _buffers(
    config: WorldConfig, n_worlds: int, views: np.dtype[Any], left_out: set[str]
) -> dict[str, NDArray[Any]]:
    specs = array_specs(config) | episode_specs(config)
    return {
        name: np.zeros((n_worlds, *shape), views if name.endswith("views") else dtype)
        for name, (shape, dtype) in specs.items()
        if name not in left_out
    }
