"""Vector environment of Gymnasium: many worlds, stepped together."""

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
from matrixworld.arrays import BATCH_FIELDS, Specs, array_specs, episode_specs, new_arrays
from matrixworld.batch import Batch
from matrixworld.checks import check_bool, check_integer
from matrixworld.config import WorldConfig
from matrixworld.render import rgb
from matrixworld.rules import KINDS, Rules
from matrixworld.world import World

OPTIONS = ("reset_mask", "episode", "pursuers", "evaders", "obstacles")
"""Keys that ``options`` of a reset may have."""

EPISODE_KEYS = {
    name.removeprefix("episode_"): name for name in BATCH_FIELDS if name.startswith("episode_")
}
"""The keys of ``infos["episode"]``, and the arrays of `episode_specs` that they are."""

# Arrays that infos leave out: `reset` and `step` return them, or infos have them in another form.
_NOT_IN_INFOS = {
    *("rewards", "terminations", "truncations", "views", "last_positions"),
    *("ended", "final_views", *EPISODE_KEYS.values()),
}
# Gymnasium has its own meaning for ``infos["episode"]``.
_RENAMED = {"steps": "step", "episode": "episode_number"}


class VectorEnv(GymnasiumVectorEnv[NDArray[Any], NDArray[Any], NDArray[Any]]):
    """Vector environment of W worlds with A agents each, pursuers first.

    Parameters
    ----------
    config : WorldConfig, Rules or str, optional
        A configuration, rules, or the name of a variant. The default is "O".
    n_worlds : int, optional
        W. The default is 1.
    autoreset_mode : gymnasium.vector.AutoresetMode or str, optional
        What happens after the end of an episode. ``NextStep`` (the default): the next step ignores
        that world's actions and starts its seed's next episode. ``SameStep``: the last step also
        starts the next episode. Observations, positions, alive, step, seed and state are then of
        the new episode and everything else of the ended one; its last observations are in
        ``infos["final_obs"]``. ``Disabled``: an ended world stays as it is, with rewards of 0,
        until ``reset(options={"reset_mask": ended})``.
    dtype : dtype, optional
        Dtype of the observations, uint8 (the default) or float32.
    flatten : bool, optional
        Whether observations are ``(W, A, 3 * fov * fov)`` instead of ``(W, A, 3, fov, fov)``. The
        default is False.
    state : bool, optional
        Whether ``infos["state"]`` holds the whole worlds, ``(W, 3, rows, cols)``. The default is
        False.
    threads : int, optional
        Threads that share the worlds of a step. The default is one for each core that the process
        may use. No result depends on it.
    render_mode : {None, "rgb_array"}, optional
        What `render` returns. The default is None.
    **changes
        Fields of the configuration to change.

    Attributes
    ----------
    observations : ndarray
        What each agent sees.
    rewards, terminations, truncations : ndarray, shape (W, A)
        Results of the last step: float32, bool, bool.
    actions : ndarray of int64, shape (W, A)
        Actions for a `step` without arguments, to be filled in place.
    infos : dict
        See Notes.
    pursuers, evaders : TeamView
        The teams' parts of these arrays.

    Raises
    ------
    ValueError, TypeError
        As `WorldConfig` and `Batch` do, and for an unknown mode or dtype.

    Notes
    -----
    Rewards, terminations and truncations are ``(W, A)``, one for each agent; Gymnasium's vector
    environments of single agents have ``(W,)``. An agent terminates when it disappears or its world
    terminates, and stays terminated. ``infos["acted"]`` marks the agents that acted in this step: a
    learner uses the transitions of these.

    **Nothing is copied.** `reset` and `step` return the same arrays every time, and the next step
    overwrites them: copy what you keep. `pursuers` and `evaders` are views of the same arrays.

    **One thread of Python at a time.** A call while another thread's call is in progress raises
    RuntimeError. Forked processes may go on with an environment, see `Batch`.

    ``infos`` has the same keys at every step:

    | key | shape | |
    |---|---|---|
    | ``alive`` | (W, A) bool | whether the agent is in its world now |
    | ``acted`` | (W, A) bool | alive when the step began: its transition counts |
    | ``positions`` | (W, A, 2) int32 | row and column; (-1, -1) when gone |
    | ``captured``, ``ever_captured`` | (W, E) bool | captured at this moment; at some time of the episode |
    | ``captors`` | (W, E) int32 | pursuers that took part in a capture of this step |
    | ``involved``, ``fault`` | (W, A, 3) bool | in a collision with obstacle, teammate, adversary; at fault in it |
    | ``cost`` | (W, A) float32 | number of kinds of collision in which it is at fault |
    | ``cost_obstacle``, ``cost_teammate``, ``cost_adversary`` | (W, A) bool | at fault in a collision of this kind |
    | ``capture_rate``, ``ever_capture_rate`` | (W,) float32 | shares of the evaders |
    | ``survival_rate`` | (W, 2) float32 | shares of pursuers and of evaders that are alive |
    | ``terminated``, ``truncated`` | (W,) bool | of the worlds |
    | ``step`` | (W,) int32 | rounds played in the episode |
    | ``seed``, ``episode_number`` | (W,) uint64 | the episode, as `World.reset` takes it |
    | ``final_obs``, ``_final_obs`` | as observations; (W,) bool | last observations of an episode; whether it ended in this step |
    | ``episode``, ``_episode`` | dict of `EPISODE_KEYS`; (W,) bool | statistics of the last ended episode, as in `EpisodeStatistics`; whether it ended in this step |

    A further array of `array_specs` or `episode_specs` appears under its own name.
    """  # noqa: E501  (a row of a table is one line)

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
            # In the other modes the observations stay those of the episode's end for one step.
            left_out.add("final_views")
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
        # `reshape` of a contiguous array makes a view, so the batch writes into observations.
        seen = (*shape[:2], -1) if flatten else shape
        self.observations = kept["views"].reshape(seen)
        self.rewards = kept["rewards"]
        self.terminations, self.truncations = kept["terminations"], kept["truncations"]
        self.infos: dict[str, Any] = {
            _RENAMED.get(name, name): array
            for name, array in kept.items()
            if name not in _NOT_IN_INFOS
        }
        self.infos |= {f"cost_{kind}": kept["fault"][..., k] for k, kind in enumerate(KINDS)}
        # Without a copy of its own, the end of an episode is what the observations show then.
        final = kept.get("final_views", kept["views"])
        self.infos |= {"final_obs": final.reshape(seen), "_final_obs": kept["ended"]}
        self.infos["episode"] = {key: kept[name] for key, name in EPISODE_KEYS.items()}
        self.infos["_episode"] = kept["ended"]

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
        """The number of worlds, W; Gymnasium's name is ``num_envs``."""
        return self.num_envs

    def reset(
        self,
        *,
        seed: int | ArrayLike | None = None,
        options: Mapping[str, Any] | None = None,
    ) -> tuple[NDArray[Any], dict[str, Any]]:
        """Start an episode in every world, or in some.

        Parameters
        ----------
        seed : int or array_like of int, shape (W,), optional
            An int s gives world w the seed s + w. Without a seed each world starts its seed's next
            episode; worlds that never had a seed draw one from the operating system.
        options : mapping, optional
            Any of `OPTIONS`: ``reset_mask``, bool, shape (W,), the worlds to reset; ``episode``,
            the number of the seed's episode; ``pursuers`` and ``evaders``, positions, shape (n, 2)
            or (W, n, 2); ``obstacles``, a map for these episodes.

        Returns
        -------
        observations : ndarray
            What each agent sees.
        infos : dict
            See `VectorEnv`.

        Raises
        ------
        ValueError
            For other options, and as `Batch.reset` does; then no world has changed.
        """
        given = dict(options or {})
        unknown = set(given) - set(OPTIONS)
        if unknown:
            raise ValueError(f"options: expected some of {OPTIONS}, got {sorted(unknown)}")
        # The batch starts with fixed seeds, which would make every unseeded run the same.
        if seed is None and not self._seeded:
            seed = np.random.SeedSequence().generate_state(self.n_worlds, np.uint64)
        self._batch.reset(seed, mask=given.pop("reset_mask", None), **given)
        self._seeded = True
        return self.observations, self.infos

    def step(
        self, actions: ArrayLike | None = None
    ) -> tuple[NDArray[Any], NDArray[Any], NDArray[Any], NDArray[Any], dict[str, Any]]:
        """Play one round in every world.

        Parameters
        ----------
        actions : array_like of int, shape (W, A), optional
            See `Action`. The default is what the attribute `actions` holds. Actions of gone agents
            and in ended worlds are ignored.

        Returns
        -------
        observations : ndarray
            What each agent sees.
        rewards : ndarray of float32, shape (W, A)
            Rewards of the step.
        terminations, truncations : ndarray of bool, shape (W, A)
            Whether agents have terminated; whether their world was truncated.
        infos : dict
            See `VectorEnv`.

        Raises
        ------
        RuntimeError
            Before the first reset.
        ValueError, TypeError
            As `Batch.step` does.
        """
        if not self._seeded:
            raise RuntimeError("call reset() before the first step")
        self._batch.step(self.actions if actions is None else actions)
        return self.observations, self.rewards, self.terminations, self.truncations, self.infos

    def world(self, number: int) -> World:
        """Return an independent copy of one world, to draw it or to plan in it."""
        return self._batch.world(number)

    def render(self) -> tuple[NDArray[np.uint8], ...] | None:
        """Return a picture of each world, (height, width, 3) uint8; None without a render mode."""
        if self.render_mode is None:
            return None
        return tuple(rgb(self.world(number).scene()) for number in range(self.n_worlds))


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
        """The number of agents, n."""
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
    chosen: Specs = {
        name: (shape, views if name.endswith("views") else dtype)
        for name, (shape, dtype) in specs.items()
        if name not in left_out
    }
    return new_arrays(chosen, n_worlds)
