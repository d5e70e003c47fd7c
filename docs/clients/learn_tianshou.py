"""PPO of Tianshou, by the recipe `tianshou_envs.py`: agents that share a policy.

``pip install 'tianshou>=2'``. Tried with Tianshou 2.0.1, PyTorch 2.13.0, Gymnasium 1.4.0,
PettingZoo 1.27.0 and NumPy 2.4.6.
"""

import numpy as np
import torch
from tianshou.algorithm import PPO
from tianshou.algorithm.modelfree.reinforce import ProbabilisticActorPolicy
from tianshou.algorithm.optim import AdamOptimizerFactory
from tianshou.data import Collector, VectorReplayBuffer
from tianshou.trainer import OnPolicyTrainerParams
from tianshou.utils.net.common import Net
from tianshou.utils.net.discrete import DiscreteActor, DiscreteCritic
from torch.distributions import Categorical

import matrixworld as mw
from tianshou_envs import AgentEnvs

STEPS = 160_000  # of agents


def score():
    def sample(seen):
        with torch.no_grad():
            logits, _ = actor(seen.reshape(len(seen), -1).astype("float32"))
        return Categorical(logits=logits).sample()

    fleer = {"clumsy-fleer": "clumsy-fleer"}
    return mw.score_policy(sample, "pursuer", config, opponents=fleer).mean()


torch.set_num_threads(1)
torch.manual_seed(0)
np.random.seed(0)  # noqa: NPY002 (the library draws from it)
config = mw.WorldConfig("O", rows=10, cols=10, n_pursuers=4, n_evaders=4, fov=7, max_steps=50)
envs = AgentEnvs(config, evaders="clumsy-fleer")
envs.seed(0)


def net():
    return Net(
        state_shape=envs.agents.single_observation_space.shape,
        hidden_sizes=[64, 64],
        activation=torch.nn.Tanh,
    )


actor = DiscreteActor(preprocess_net=net(), action_shape=config.n_actions, softmax_output=False)
policy = ProbabilisticActorPolicy(
    actor=actor,
    dist_fn=lambda logits: Categorical(logits=logits),
    action_space=envs.agents.single_action_space,
    action_scaling=False,
    action_bound_method=None,
)
learner = PPO(
    policy=policy,
    critic=DiscreteCritic(preprocess_net=net()),
    optim=AdamOptimizerFactory(lr=1e-3),
    max_grad_norm=0.5,
)
print("before", score())
learner.run_training(
    OnPolicyTrainerParams(
        training_collector=Collector(learner, envs, VectorReplayBuffer(4096, len(envs))),
        max_epochs=1,
        epoch_num_steps=STEPS,
        collection_step_num_env_steps=4096,
        batch_size=512,
        update_step_num_repetitions=4,
        show_progress=False,
        verbose=False,
    )
)
print("after", score())
