"""Batches: many worlds that are stepped together."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray
from typing_extensions import Unpack

from matrixworld import _core
from matrixworld._core import Autoreset
from matrixworld._util import checks
from matrixworld.world.arrays import LARGE, array_specs, check_written, integers, new_arrays
from matrixworld.world.config import MapLike, WorldConfig, WorldSettings
from matrixworld.world.masks import check_team
from matrixworld.world.policy import TEAMS, EnginePolicy, check_agents
from matrixworld.world.rules import Rules
from matrixworld.world.world import Turns, World, start_of


class Batch(Turns):
    """W worlds of one configuration, stepped together into the caller's arrays.

    Parameters
    ----------
    n_worlds : int
        W.
    config, **changes
        As for `World`.
    threads : int, optional
        Threads that share the worlds of a step. The default is one for each core that the process
        may use. No result depends on it.
    autoreset : Autoreset, optional
        What happens to a world whose episode has ended. ``DISABLED`` (the default): the world stays
        as it is, with rewards of 0, until it is reset. ``NEXT_STEP``: the next step ignores the
        world's actions and starts its seed's next episode. ``SAME_STEP``: the step that ends the
        episode also starts the next one. The arrays of the last step are then of the ended episode,
        and the arrays of the present moment (see `array_specs`) of the new one.
    buffers : dict of str to ndarray, optional
        The arrays that `reset`, `step` and `play_turn` write into: any of `array_specs` and
        `episode_specs`, each with a leading axis of W worlds. Views may also be float32. The
        default is new arrays for all of `array_specs` but ``views``, ``inputs`` and ``state``.

    Notes
    -----
    One thread of Python at a time may use a batch: what plays, resets or decides raises
    RuntimeError, and changes nothing, while another thread's call is in progress. After a fork the
    child's batch goes on where the parent's was, unless another thread was using it then.
    """

    def __init__(
        self,
        n_worlds: int,
        config: WorldConfig | Rules | str = "O",
        *,
        threads: int | None = None,
        autoreset: Autoreset = Autoreset.DISABLED,
        buffers: dict[str, NDArray[Any]] | None = None,
        **changes: Unpack[WorldSettings],
    ) -> None:
        checks.check_keywords(changes, WorldSettings.__annotations__, Batch)
        self.config: WorldConfig = WorldConfig.of(config, **changes)
        self.n_worlds: int = checks.check_integer("n_worlds", n_worlds, 1)
        checks.check_instance("autoreset", autoreset, Autoreset)
        self.autoreset: Autoreset = autoreset
        n_threads = checks.check_threads(threads)
        if buffers is None:
            specs = array_specs(self.config)
            few = {name: spec for name, spec in specs.items() if name not in LARGE}
            buffers = new_arrays(few, self.n_worlds)
        checks.check_instance("buffers", buffers, dict)
        self._buffers = buffers
        # The engine checks the buffers and keeps them alive.
        self._core = _core.Batch(self.config.setup, self.n_worlds, n_threads, autoreset, buffers)
        self.reset(0)

    @property
    def buffers(self) -> dict[str, NDArray[Any]]:
        """The arrays that the engine writes into; another array put into the dict is not one."""
        return self._buffers

    def reset(
        self,
        seed: int | ArrayLike | None = None,
        *,
        episode: int = 0,
        mask: ArrayLike | None = None,
        pursuers: ArrayLike | None = None,
        evaders: ArrayLike | None = None,
        obstacles: MapLike | None = None,
    ) -> dict[str, NDArray[Any]]:
        """Start an episode in every world, or in some.

        Parameters
        ----------
        seed : int or array_like of int, shape (W,), optional
            A seed s gives world w the seed s + w. World w then plays as a `World` does after
            ``reset(seed of w, episode=episode)``. By default each world starts its own seed's next
            episode.
        mask : array_like of bool, shape (W,), optional
            The worlds to reset. The default is all.
        pursuers, evaders : array_like of int, shape (n, 2) or (W, n, 2), optional
            Start cells, the same in every world or not. By default they are drawn.
        episode, obstacles
            As for `World.reset`, which also says what is refused; then no world has changed.

        Returns
        -------
        dict of str to ndarray
            The buffers.
        """
        if seed is None and episode != 0:
            raise ValueError(f"episode: expected a seed with it, got episode {episode} alone")
        if mask is not None:
            self._require_no_round("reset with a mask")
        self._core.reset(
            None if seed is None else self._seeds(seed),
            checks.check_integer("episode", episode, 0, checks.SEED_MAX),
            mask=None if mask is None else _mask(mask),
            **start_of(self.config, pursuers, evaders, obstacles, self.n_worlds),
        )
        return self.buffers

    def _seeds(self, seed: int | ArrayLike) -> NDArray[np.uint64]:
        if isinstance(seed, int | np.integer):
            first = checks.check_integer("seed", seed, 0, checks.SEED_MAX)
            # Seeds are 64 bits wide and wrap around after the largest one.
            return np.add(np.arange(self.n_worlds, dtype=np.uint64), first, dtype=np.uint64)
        return np.ascontiguousarray(checks.check_integers("seed", seed, np.uint64))

    def step(self, actions: ArrayLike) -> dict[str, NDArray[Any]]:
        """Play one round in every world, and return the buffers.

        Parameters
        ----------
        actions : array_like of int, shape (W, A)
            Those of gone agents and in ended worlds are ignored. If one is refused (ValueError
            names its world and agent, TypeError what is no integer), no world has changed.
        """
        self._require_no_round("step")
        self._core.step(integers("actions", actions))
        return self.buffers

    def play_turn(self, actions: ArrayLike) -> dict[str, NDArray[Any]]:
        """Play the next turn of a round in every world, and return the buffers.

        Only the actions of `actors` are read. Rewards, costs and all that belongs to a round are
        written as they are so far, and what belongs to an episode after the last turn. A world that
        ends in the middle of a round waits for the others. ValueError with automatic resets.
        """
        if self.autoreset is not Autoreset.DISABLED:
            raise ValueError(f"autoreset: expected DISABLED to play turns, got {self.autoreset}")
        self._core.play_turn(integers("actions", actions))
        return self.buffers

    def _require_no_round(self, call: str) -> None:
        if self.turn:
            raise RuntimeError(
                f"turn {self.turn} of {self.n_turns} is next: finish the round by play_turn() "
                f"before {call}"
            )

    def decide(
        self,
        policies: Sequence[EnginePolicy | None],
        chosen: ArrayLike,
        agents: range,
        actions: NDArray[np.int64],
    ) -> None:
        """Write the actions that policies choose at this moment for agents of one team.

        A policy uses the random numbers that it has in a rollout for the same seed, episode, step
        and agent. The worlds stay as they are, and if something does not fit them, so do `actions`.

        `chosen` (W,) is the place in `policies` of each world's policy, which may be None. They act
        for `agents` of one team; entries of `actions`, int64 (W, A), of gone agents, other agents
        and ended worlds stay as they are.
        """
        first, last = check_agents(agents)
        side = TEAMS[first >= self.config.n_pursuers]
        teams = [
            None if policy is None else check_team("policies", policy, self.config, side)
            for policy in policies
        ]
        check_written("actions", actions)
        numbers = np.ascontiguousarray(checks.check_integers("chosen", chosen, np.int32))
        self._core.decide(teams, numbers, first, last, actions)

    def __getstate__(self) -> dict[str, Any]:
        """Refuse copies and pickles."""
        raise TypeError(
            "a batch cannot be copied or pickled, because its buffers belong to the caller: "
            "copy single worlds with world(number)"
        )

    def world(self, number: int) -> World:
        """Return an independent copy of one world, to draw it or to plan in it."""
        number = checks.check_integer("world", number, 0, self.n_worlds - 1)
        return World.at(self.config, self._core.snapshot(number))


def _mask(worlds: ArrayLike) -> NDArray[np.bool_]:
    mask = np.ascontiguousarray(checks.unmasked("mask", worlds))
    if mask.dtype != np.bool_:
        raise TypeError(f"mask: expected dtype bool, got {mask.dtype}")
    return mask
