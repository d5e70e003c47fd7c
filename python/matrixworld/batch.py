"""Batches of worlds."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld import _core
from matrixworld._core import Autoreset
from matrixworld.arrays import array_specs, integers
from matrixworld.checks import SEED_MAX, check_integer, check_naturals, check_threads
from matrixworld.config import WorldConfig
from matrixworld.maps import MapLike, read_map
from matrixworld.rules import Rules
from matrixworld.world import World


class Batch:
    """W worlds of one configuration, stepped together into arrays of the caller.

    n_worlds: W
    threads: how many work on a step; by default one a core. No result depends on it.
    autoreset: what becomes of a world whose episode has ended. ``DISABLED``: it stays as it is,
        with rewards of 0, until it is reset. ``NEXT_STEP``: the next step ignores its actions and
        starts its seed's next episode instead. ``SAME_STEP``: the very step that ends it goes on to
        start the next one: what `array_specs` calls of the last step is then still of the ended
        episode, what it calls of the moment is of the new one.
    buffers: arrays to write into, any of `array_specs` and `episode_specs` with W in front; by
        default all of `array_specs` but ``views`` and ``state`` are made. Views may also be
        float32. The same arrays are written at every step.

    Raises ValueError and TypeError for a buffer of another name, shape, dtype or layout, and for
    other bad arguments.
    """

    def __init__(
        self,
        n_worlds: int,
        config: WorldConfig | Rules | str = "O",
        *,
        threads: int | None = None,
        autoreset: Autoreset = Autoreset.DISABLED,
        buffers: dict[str, NDArray[Any]] | None = None,
        **changes: Any,
    ) -> None:
        self.config = WorldConfig.of(config, **changes)
        self.n_worlds = check_integer("n_worlds", n_worlds, 1)
        if not isinstance(autoreset, Autoreset):
            raise TypeError(f"autoreset: expected a matrixworld.Autoreset, got {autoreset!r}")
        self.buffers = self._default_buffers() if buffers is None else buffers
        if not isinstance(self.buffers, dict):
            raise TypeError(f"buffers: expected a dict of arrays, got {self.buffers!r}")
        self._core = _core.Batch(
            self.config.setup, self.n_worlds, check_threads(threads), autoreset, self.buffers
        )
        self.reset(0)

    def _default_buffers(self) -> dict[str, NDArray[Any]]:
        return {
            name: np.zeros((self.n_worlds, *shape), dtype)
            for name, (shape, dtype) in array_specs(self.config).items()
            if name not in ("views", "state")
        }

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
        """Start an episode in every world, or in some, and return the buffers.

        seed: an int s, which gives world w the seed s + w, or ``(W,)`` ints, one for each.
            World w then plays as `World` does after ``reset(seed of w, episode=episode)``.
            Without a seed each world starts the next episode of its own.
        mask: ``(W,)`` bool, which worlds to reset; by default all
        pursuers, evaders: where they start, ``(n, 2)`` ints (row, col) in every world or
            ``(W, n, 2)`` in each; drawn where not given
        obstacles: a map for this episode, as `read_map` takes it, instead of the config's

        No world is changed where an argument is refused, as `World.reset` does.
        """
        if seed is None and episode != 0:
            raise ValueError(f"episode: expected a seed with it, got episode {episode} alone")
        own_map = None if obstacles is None else read_map(obstacles)
        self.config.check_map(own_map)
        self._core.reset(
            None if seed is None else self._seeds(seed),
            check_integer("episode", episode, 0, SEED_MAX),
            mask=None if mask is None else self._mask(mask),
            pursuers=self._positions("pursuers", pursuers, self.config.n_pursuers),
            evaders=self._positions("evaders", evaders, self.config.n_evaders),
            map=None if own_map is None else own_map.astype(np.uint8),
        )
        return self.buffers

    def _seeds(self, seed: int | ArrayLike) -> NDArray[np.uint64]:
        if isinstance(seed, int | np.integer):
            first = check_integer("seed", seed, 0, SEED_MAX)
            return np.array([(first + w) % 2**64 for w in range(self.n_worlds)], np.uint64)
        return np.ascontiguousarray(check_naturals("seeds", seed, np.uint64))

    def _mask(self, given: ArrayLike) -> NDArray[np.bool_]:
        mask = np.ascontiguousarray(given)
        if mask.dtype != np.bool_:
            raise TypeError(f"mask: expected dtype bool, got {mask.dtype}")
        return mask

    def _positions(self, name: str, given: ArrayLike | None, n: int) -> NDArray[np.int32] | None:
        if given is None:
            return None
        array = integers(name, given)
        everywhere = (self.n_worlds, n, 2)
        if array.shape not in ((n, 2), everywhere):
            raise ValueError(f"{name}: expected shape {(n, 2)} or {everywhere}, got {array.shape}")
        whole = np.broadcast_to(array, everywhere).clip(-(2**31), 2**31 - 1)
        return np.ascontiguousarray(whole, dtype=np.int32)

    def step(self, actions: ArrayLike) -> dict[str, NDArray[Any]]:
        """Play one round in every world and return the buffers.

        actions: ``(W, A)`` integers; those of gone agents and ended worlds are not looked at

        Raises ValueError for an illegal action, naming world and agent, before anything is
        changed, or another shape; TypeError for actions that are not integers.
        """
        self._core.step(integers("actions", actions))
        return self.buffers

    def __getstate__(self) -> dict[str, Any]:
        """Refuse: the buffers are the caller's, and a copy's would not be."""
        raise TypeError(
            "a batch of worlds is not copied or pickled with its buffers: copy single worlds, "
            "which world(number) gives"
        )

    def world(self, number: int) -> World:
        """A copy of one of the worlds, which goes on by itself: to draw it, or to plan in it."""
        number = check_integer("world", number, 0, self.n_worlds - 1)
        return World.at(self.config, self._core.snapshot(number))
