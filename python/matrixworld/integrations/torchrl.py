"""TorchRL, and BenchMARL on top of it: an environment whose observations are flat, and a task."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from matrixworld.envs import parallel_env
from matrixworld.integrations import opponents
from matrixworld.version import imported
from matrixworld.world.config import WorldConfig
from matrixworld.world.rules import Rules

__all__ = ["benchmarl_task", "env"]


def env(
    config: WorldConfig | Rules | str = "O",
    *,
    seed: int | None = None,
    device: Any = None,
    **settings: Any,
) -> Any:
    """Make an environment of TorchRL, in which a team is the group ``"pursuer"`` or ``"evader"``.

    Parameters
    ----------
    config : WorldConfig, Rules or str, optional
        The world, its rules, or the name of a variant. The default is ``"O"``.
    seed : int, optional
        The first seed.
    device : torch.device or str, optional
        Where its tensors are.
    **settings
        Other arguments of `matrixworld.parallel_env`: ``pursuers`` or ``evaders`` (what plays that
        team, by default ``evaders="clumsy-fleer"``; ``evaders=None`` to learn both teams), and
        fields of `WorldConfig` to change.

    Returns
    -------
    torchrl.envs.TransformedEnv
        Observations of a group of n agents are float32 (..., n, 3 * fov * fov). An episode goes on
        without agents that are gone; ``("pursuer", "mask")`` marks the others.
    """
    library, torch = imported("torchrl.envs", "torchrl"), imported("torch", "torchrl")
    worlds = parallel_env(config, **opponents(settings))
    groups: dict[str, list[str]] = {}
    for agent in worlds.possible_agents:
        groups.setdefault(agent.partition("_")[0], []).append(agent)
    wrapped = library.PettingZooWrapper(
        worlds, group_map=groups, use_mask=True, done_on_any=False, seed=seed, device=device
    )
    seen = [(group, "observation") for group in groups]
    flat = library.Compose(
        library.DTypeCastTransform(torch.uint8, torch.float32, in_keys=seen),
        library.FlattenObservation(-3, -1, in_keys=seen),
    )
    return library.TransformedEnv(wrapped, flat)


def benchmarl_task(config: WorldConfig | Rules | str = "O", **settings: Any) -> Any:
    """Make a task of BenchMARL, for ``benchmarl.experiment.Experiment(task=...)``.

    BenchMARL does not leave out agents that are gone: choose rules in which the agents that learn
    cannot disappear.

    Parameters
    ----------
    config, **settings
        As for `env`.
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
            return partial(benchmarl_task, config, **settings), ()

    return Pursuit("pursuit", {"max_cycles": world.max_steps})
