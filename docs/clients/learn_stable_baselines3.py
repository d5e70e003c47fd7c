"""PPO of Stable-Baselines3: the pursuers of all worlds are environments that share a policy.

``pip install 'matrixworld-pursuit[stable-baselines3]'``. Tried with Stable-Baselines3 2.9.2,
PyTorch 2.13.0, Gymnasium 1.4.0 and NumPy 2.4.6.
"""

import torch
from stable_baselines3 import PPO

import matrixworld as mw
from matrixworld.envs.stable_baselines3 import policy, vec_env

STEPS = 160_000  # of agents

torch.set_num_threads(1)
config = mw.WorldConfig("O", rows=10, cols=10, n_pursuers=4, n_evaders=4, fov=7, max_steps=50)
envs = vec_env(config, evaders="clumsy-fleer")
settings = {"learning_rate": 1e-3, "n_steps": 128, "batch_size": 1024}
learner = PPO("MlpPolicy", envs, seed=0, device="cpu", **settings)


def score():
    fleer = {"clumsy-fleer": "clumsy-fleer"}
    return mw.score_policy(policy(learner), "pursuer", config, opponents=fleer).mean()


print("before", score())
learner.learn(STEPS)
print("after", score())
