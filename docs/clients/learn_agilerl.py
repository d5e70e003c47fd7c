"""PPO of AgileRL on `AgentVectorEnv`.

``pip install agilerl peft``. Tried with AgileRL 2.58.0, PEFT 0.21.2, PyTorch 2.14.1, Gymnasium
1.0.0, PettingZoo 1.26.1 and NumPy 2.4.6.
"""

import numpy as np
import torch
from agilerl.algorithms import PPO
from agilerl.training.train_on_policy import train_on_policy
from gymnasium.wrappers.vector import NormalizeReward

import matrixworld as mw

STEPS = 163_840  # of agents
ROLLOUT = 4096  # steps of agents


def score():
    def sample(seen):
        actions, *_ = learner.get_action(seen.reshape(len(seen), -1).astype("float32"))
        return actions

    fleer = {"clumsy-fleer": "clumsy-fleer"}
    return mw.score_policy(sample, "pursuer", config, opponents=fleer).mean()


torch.set_num_threads(1)
torch.manual_seed(0)
np.random.seed(0)  # noqa: NPY002 (the library draws from it)
config = mw.WorldConfig("O", rows=10, cols=10, n_pursuers=4, n_evaders=4, fov=7, max_steps=50)
worlds = mw.VectorEnv(config, 8, evaders="clumsy-fleer", dtype="float32", flatten=True, threads=1)
envs = NormalizeReward(mw.AgentVectorEnv(worlds))
envs.reset(seed=0)
hidden = {"hidden_size": [64], "activation": "Tanh"}
learner = PPO(
    envs.single_observation_space,
    envs.single_action_space,
    net_config={"latent_dim": 64, "encoder_config": hidden, "head_config": hidden},
    lr=1e-3,
    batch_size=512,
    learn_step=ROLLOUT,
    num_envs=envs.num_envs,
)
print("before", score())
[learner], _ = train_on_policy(
    envs, "pursuit", "PPO", [learner], max_steps=STEPS, evo_steps=ROLLOUT, verbose=False
)
print("after", score())
