"""The agents of one team as a vector environment of Tianshou: copy this file.

``pip install 'tianshou>=2'``
"""

import numpy as np
from tianshou.env import BaseVectorEnv

import matrixworld as mw


class AgentEnvs(BaseVectorEnv):
    """The agents of one team in many worlds, which share the policy that learns.

    Arguments are those of `matrixworld.VectorEnv`, with ``pursuers`` or ``evaders``: what plays the
    other team. The attribute ``agents`` is the `AgentVectorEnv`, which has the spaces of one agent.
    """

    def __init__(self, config="O", n_worlds=8, **settings):
        # Collectors reset environments that have ended, so the worlds do not.
        flat = {"autoreset_mode": "Disabled", "dtype": "float32", "flatten": True, **settings}
        self.agents = mw.AgentVectorEnv(mw.VectorEnv(config, n_worlds, **flat))
        self.env_num = self.agents.num_envs
        self.is_async = self.is_closed = False

    def get_env_attr(self, key, id=None):
        """Return a space of each agent."""
        return [getattr(self.agents, f"single_{key}")] * self.env_num

    def seed(self, seed=None):
        """Start episodes of a seed."""
        self.agents.reset(seed=seed)

    def reset(self, env_id=None, **kwargs):
        """Start episodes; the agents of a world end together."""
        chosen = np.arange(self.env_num) if env_id is None else np.asarray(env_id)
        mask = np.isin(np.arange(self.env_num), chosen)
        observations, _ = self.agents.reset(options={"reset_mask": mask}, **kwargs)
        return observations[chosen], np.array([{} for _ in chosen])

    def step(self, action, id=None):
        """Play a round."""
        *results, _ = self.agents.step(action)
        return (*results, np.array([{} for _ in action]))

    def close(self):
        """Close the worlds."""
        self.agents.close()
