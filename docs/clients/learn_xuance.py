"""IPPO of XuanCe on `parallel_env`, as its tutorial of new multi-agent environments says.

``pip install xuance``. Tried with XuanCe 1.4.4, PyTorch 2.14.1, PettingZoo 1.27.0, Gymnasium 1.2.3
and NumPy 1.26.4.
"""

from argparse import Namespace
from pathlib import Path

import numpy as np
import torch
import xuance
from xuance.common import load_yaml
from xuance.environment import REGISTRY_MULTI_AGENT_ENV, RawMultiAgentEnv, make_envs
from xuance.torch.agents import IPPO_Agents

import matrixworld as mw

STEPS = 163_840  # of agents


class Pursuit(RawMultiAgentEnv):
    """The pursuers; in this game none disappears."""

    def __init__(self, settings):
        super().__init__()
        flat = {"dtype": "float32", "flatten": True}
        self.env = mw.parallel_env(config, evaders="clumsy-fleer", **flat)
        self.agents = self.env.possible_agents
        self.num_agents = len(self.agents)
        self.state_space = self.env.state_space
        self.observation_space = self.env.observation_spaces
        self.action_space = self.env.action_spaces
        self.max_episode_steps = config.max_steps
        self.seed = settings.env_seed

    def state(self):
        """Return the whole world."""
        return self.env.state()

    def reset(self):
        """Start an episode."""
        observations, infos = self.env.reset(self.seed)
        self.seed = None
        return observations, {"infos": infos}

    def step(self, actions):
        """Play a round."""
        chosen = {agent: int(action) for agent, action in actions.items()}
        seen, rewards, terminated, truncated, infos = self.env.step(chosen)
        return seen, rewards, terminated, all(truncated.values()), {"infos": infos}

    def render(self, *args):
        """Draw the present moment."""
        return self.env.render()

    def close(self):
        """End."""
        self.env.close()


def score():
    def sample(seen):
        # The policy knows an agent by its number; all agents share one here.
        rows = [dict(zip(envs.agents, part, strict=True)) for part in in_worlds(seen)]
        chosen = learner.get_actions(rows, test_mode=True)["actions"]
        return np.array([[row[agent] for agent in envs.agents] for row in chosen]).ravel()

    fleer = {"clumsy-fleer": "clumsy-fleer"}
    return mw.score_policy(sample, "pursuer", config, opponents=fleer).mean()


def in_worlds(seen):
    return seen.reshape(-1, config.n_pursuers, 3 * config.fov**2).astype(np.float32)


torch.set_num_threads(1)
config = mw.WorldConfig("O", size=10, n_pursuers=4, n_evaders=4, fov=7, max_steps=50)
REGISTRY_MULTI_AGENT_ENV["pursuit"] = Pursuit
folder = Path(xuance.__file__).parent / "configs"
settings = {
    **load_yaml(folder / "basic.yaml"),
    **load_yaml(folder / "ippo/mpe/simple_spread_v3.yaml"),
    "env_name": "pursuit",
    "env_id": "O",
    "continuous_action": False,
    "policy": "Categorical_MAAC_Policy",
    "vectorize": "DummyVecMultiAgentEnv",
    "parallels": 8,
    "buffer_size": 1024,
    "n_epochs": 4,
    "n_minibatch": 2,
    "learning_rate": 1e-3,
    "gain": 1.0,
    "activation": "tanh",
    "device": "cpu",
    "seed": 0,
    "env_seed": 0,
}
envs = make_envs(Namespace(**settings))
learner = IPPO_Agents(config=Namespace(**settings), envs=envs)
print("before", score())
learner.train(STEPS // config.n_pursuers // settings["parallels"])
print("after", score())
learner.finish()
