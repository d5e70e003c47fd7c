"""A world as an environment of TorchRL, and as a task of BenchMARL: copy this file.

``pip install 'torchrl>=0.11'`` or ``pip install 'benchmarl>=1.5'``
"""

from functools import partial

import torch
from torchrl import envs

import matrixworld as mw


def env(config="O", *, seed=None, device=None, **settings):
    """Make an environment in which a team is the group ``"pursuer"`` or ``"evader"``.

    `settings` are arguments of `matrixworld.parallel_env`, such as ``evaders="clumsy-fleer"``: what
    plays that team. Observations of a group of n agents are float32 (..., n, 3 * fov * fov). An
    episode goes on without agents that are gone; ``("pursuer", "mask")`` marks the others.
    """
    worlds = mw.parallel_env(config, **settings)
    groups = {}
    for agent in worlds.possible_agents:
        groups.setdefault(agent.partition("_")[0], []).append(agent)
    wrapped = envs.PettingZooWrapper(
        worlds, group_map=groups, use_mask=True, done_on_any=False, seed=seed, device=device
    )
    seen = [(group, "observation") for group in groups]
    cast = envs.DTypeCastTransform(torch.uint8, torch.float32, in_keys=seen)
    flatten = envs.FlattenObservation(-3, -1, in_keys=seen)
    return envs.TransformedEnv(wrapped, envs.Compose(cast, flatten))


def benchmarl_task(config="O", **settings):
    """Make a task of BenchMARL with the arguments of `env`, for ``Experiment(task=...)``.

    BenchMARL does not leave out agents that are gone: choose rules in which the agents that learn
    cannot disappear.
    """
    from benchmarl.environments import PettingZooClass

    class Pursuit(PettingZooClass):
        """Experiments accept tasks of the library's class only."""

        def get_env_fun(self, num_envs, continuous_actions, seed, device):
            return lambda: env(config, seed=seed, device=device, **settings)

        def supports_discrete_actions(self):
            return True

        def __reduce__(self):  # experiments pickle their task
            return partial(benchmarl_task, config, **settings), ()

    world = mw.parallel_env(config, **settings).config
    return Pursuit("pursuit", {"max_steps": world.max_steps})
