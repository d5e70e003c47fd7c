"""BenchMARL: a world as a task."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from matrixworld.envs import parallel_env
from matrixworld.integrations import opponents
from matrixworld.integrations.torchrl import env
from matrixworld.version import imported
from matrixworld.world.config import WorldConfig
from matrixworld.world.rules import Rules

__all__ = ["task"]


def task(config: WorldConfig | Rules | str = "O", **settings: Any) -> Any:
    """Make a task, for ``benchmarl.experiment.Experiment(task=...)``.

    BenchMARL does not leave out agents that are gone: choose rules in which the agents that learn
    cannot disappear.

    Parameters
    ----------
    config, **settings
        As for `matrixworld.integrations.torchrl.env`.
    """
    library = imported("benchmarl.environments", "benchmarl")
    world = parallel_env(config, **opponents(settings)).config  # refuses bad settings now

    class Pursuit(library.PettingZooClass):  # type: ignore[misc, name-defined]
        """Experiments accept tasks of the library's class only."""

        def get_env_fun(
            self, num_envs: int, continuous_actions: bool, seed: int | None, device: Any
        ) -> Callable[[], Any]:
            return lambda: env(config, seed=seed, device=device, **settings)

        def supports_discrete_actions(self) -> bool:
            return True

        def __reduce__(self) -> tuple[Any, ...]:  # experiments pickle their task
            return partial(task, config, **settings), ()

    return Pursuit("pursuit", {"max_cycles": world.max_steps})
