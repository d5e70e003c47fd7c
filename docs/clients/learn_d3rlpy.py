"""Conservative Q-learning of d3rlpy from recorded episodes, by the recipe `minari_episodes.py`.

``pip install d3rlpy 'minari[hdf5]'``. Tried with d3rlpy 2.8.1, which needs Gymnasium 1.0.0, and
with Minari 0.5.4, PyTorch 2.14.1, PettingZoo 1.26.1 and NumPy 2.4.6.
"""

import d3rlpy
import minari
import numpy as np
import torch

import matrixworld as mw
from minari_episodes import to_minari

STEPS = 40_000  # of agents, in the data set
NAME = "pursuit/o/clumsy-chaser-v0"


def score():
    def best(seen):
        return learner.predict(seen.reshape(len(seen), -1).astype("float32"))

    fleer = {"clumsy-fleer": "clumsy-fleer"}
    return mw.score_policy(best, "pursuer", config, opponents=fleer).mean()


torch.set_num_threads(1)
d3rlpy.seed(0)
config = mw.WorldConfig("O", rows=10, cols=10, n_pursuers=4, n_evaders=4, fov=7, max_steps=50)
recorded, steps = [], 0
while steps < STEPS:
    number = len(recorded)
    recorded.append(mw.record(config, "clumsy-chaser", "clumsy-fleer", seed=1, episode=number))
    steps += recorded[-1].length * config.n_pursuers
to_minari(recorded, NAME, algorithm_name="clumsy-chaser", seed=1)

columns = []
for episode in minari.load_dataset(NAME):
    for agent, actions in episode.actions.items():
        seen = episode.observations[agent][:-1].reshape(len(actions), -1).astype("float32")
        rewards = episode.infos["reward"][agent][1:]
        columns.append((seen, actions, rewards, episode.terminations, episode.truncations))
dataset = d3rlpy.dataset.MDPDataset(*map(np.concatenate, zip(*columns, strict=True)))
encoder = d3rlpy.models.VectorEncoderFactory([64, 64])
settings = {"batch_size": 256, "learning_rate": 1e-3, "encoder_factory": encoder}
learner = d3rlpy.algos.DiscreteCQLConfig(**settings).create()
learner.build_with_dataset(dataset)
print("before", score())
quiet = {"logger_adapter": d3rlpy.logging.NoopAdapterFactory(), "show_progress": False}
learner.fit(dataset, n_steps=STEPS // 20, n_steps_per_epoch=STEPS // 20, **quiet)
print("after", score())
