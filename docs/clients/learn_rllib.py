"""PPO of RLlib on `parallel_env`, with flat observations.

``pip install "ray[rllib]" torch``. Tried with Ray 2.60.0, which needs Gymnasium 1.2.2, and with
PyTorch 2.14.1, PettingZoo 1.27.0 and NumPy 2.4.6.
"""

import ray
import torch
from ray.rllib.algorithms.ppo import PPOConfig
from ray.rllib.core.columns import Columns
from ray.rllib.core.rl_module.default_model_config import DefaultModelConfig
from ray.rllib.env.wrappers.pettingzoo_env import ParallelPettingZooEnv
from ray.tune.registry import register_env
from torch.distributions import Categorical

import matrixworld as mw

STEPS = 98_304  # of agents
ROLLOUT = 4096  # steps of agents


def make(_):
    flat = {"dtype": "float32", "flatten": True}
    return ParallelPettingZooEnv(mw.parallel_env(config, evaders="clumsy-fleer", **flat))


def score():
    module = learner.get_module("pursuer")

    def sample(seen):
        x = torch.from_numpy(seen).flatten(1).float()
        with torch.no_grad():
            logits = module.forward_inference({Columns.OBS: x})[Columns.ACTION_DIST_INPUTS]
        return Categorical(logits=logits).sample()

    fleer = {"clumsy-fleer": "clumsy-fleer"}
    return mw.score_policy(sample, "pursuer", config, opponents=fleer).mean()


torch.set_num_threads(1)
config = mw.WorldConfig("O", rows=10, cols=10, n_pursuers=4, n_evaders=4, fov=7, max_steps=50)
register_env("pursuit", make)
settings = (
    PPOConfig()
    .environment("pursuit")
    .env_runners(num_env_runners=0)
    .multi_agent(
        policies={"pursuer"},
        policy_mapping_fn=lambda agent, episode, **_: agent.split("_")[0],
        count_steps_by="agent_steps",
    )
    .rl_module(model_config=DefaultModelConfig(fcnet_hiddens=[64, 64], fcnet_activation="tanh"))
    .training(
        lr=1e-3,
        gamma=0.99,
        lambda_=0.95,
        clip_param=0.2,
        entropy_coeff=0.01,
        grad_clip=0.5,
        train_batch_size_per_learner=ROLLOUT,
        minibatch_size=512,
        num_epochs=4,
    )
    .debugging(seed=0)
)
ray.init(num_cpus=1, include_dashboard=False, log_to_driver=False)
learner = settings.build_algo()
print("before", score())
for _ in range(STEPS // ROLLOUT):
    learner.train()
print("after", score())
learner.stop()
ray.shutdown()
