"""IPPO of BenchMARL, by the recipe `torchrl_envs.py`: a world is one of its tasks.

``pip install 'benchmarl>=1.5'``. Tried with BenchMARL 1.5.2, which needs TorchRL before 0.12
(0.11.1 here), and with PyTorch 2.13.0, Gymnasium 1.4.0, PettingZoo 1.27.0 and NumPy 2.4.6.
"""

import torch
from benchmarl.algorithms import IppoConfig
from benchmarl.experiment import Experiment, ExperimentConfig
from benchmarl.models import MlpConfig
from tensordict import TensorDict

import matrixworld as mw
from torchrl_envs import benchmarl_task

STEPS = 57_344  # of agents
ROLLOUT = 4096  # steps of agents
SEEN = ("pursuer", "observation")


def score():
    def sample(seen):
        # The policy takes teams, and each agent's action depends on this agent only.
        x = torch.from_numpy(seen).flatten(1).float()
        team = x[:, None].expand(-1, config.n_pursuers, -1)
        played = TensorDict({SEEN: team}, batch_size=len(seen))
        with torch.no_grad():
            return experiment.policy(played)["pursuer", "action"][:, 0]

    fleer = {"clumsy-fleer": "clumsy-fleer"}
    return mw.score_policy(sample, "pursuer", config, opponents=fleer).mean()


torch.set_num_threads(1)
config = mw.WorldConfig("O", rows=10, cols=10, n_pursuers=4, n_evaders=4, fov=7, max_steps=50)
settings = ExperimentConfig.get_from_yaml()
settings.lr = 1e-3
settings.max_n_frames = STEPS // config.n_pursuers
settings.on_policy_collected_frames_per_batch = ROLLOUT // config.n_pursuers
settings.on_policy_n_envs_per_worker = 1
settings.on_policy_n_minibatch_iters = 4
settings.on_policy_minibatch_size = 128
settings.evaluation = settings.create_json = False
settings.loggers = []
learner = IppoConfig.get_from_yaml()
learner.entropy_coef = 0.01
network = MlpConfig.get_from_yaml()
network.num_cells = [64, 64]
experiment = Experiment(
    task=benchmarl_task(config, evaders="clumsy-fleer"),
    algorithm_config=learner,
    model_config=network,
    critic_model_config=network,
    seed=0,
    config=settings,
)
print("before", score())
experiment.run()
print("after", score())
