"""One hash of what networks of several shapes compute and play, run as a script once a kernel."""

import hashlib
import sys
from dataclasses import fields

import numpy as np

import matrixworld as mw
from matrixworld import _core
from matrixworld.world.policy import GATES
from one_by_one import assert_same_one_by_one
from rows import random_genome

HIDDEN = [(), (1,), (7,), (16,), (32,), (64, 64), (40, 30, 20)]
"""Hidden layers that fill a processor's vectors, fall short of them and go beyond them."""


def _world_of(number: int) -> mw.WorldConfig:
    return mw.WorldConfig(
        ["O", "TO", "SB"][number % 3],
        rows=12,
        cols=11,
        n_pursuers=5,
        n_evaders=6,
        fov=[5, 11, 57][number % 3],
        diagonal=number % 2 == 1,
        max_steps=30,
        obstacles=0.1,
    )


def of_everything() -> str:
    """Of logits at the start of an episode, and of the scores of a few matches."""
    digest = hashlib.sha256()
    shapes = [
        (hidden, memory) for memory in GATES for hidden in HIDDEN if hidden or memory == "none"
    ]
    for number, (hidden, memory) in enumerate(shapes):
        config = _world_of(number)
        activation = ["tanh", "relu"][number % 2]
        network = mw.Network.for_config(config, hidden, activation=activation, memory=memory)
        genomes = np.stack([random_genome(network, seed) for seed in (number, 100 + number)])
        logits = mw.World(config)._core.logits(network.core, genomes[0])
        digest.update(logits.tobytes())
        team = mw.Population(genomes, network)
        matches = mw.Matches.of([0, 1], [1, 0], 7)
        scores = mw.rollout(config, team, team, matches, episodes=5)
        assert_same_one_by_one(config, team, team, matches, episodes=5)
        for item in fields(scores):
            digest.update(getattr(scores, item.name).tobytes())
    return digest.hexdigest()


if __name__ == "__main__":
    sys.stdout.write(f"{_core.kernel_level()} {of_everything()}\n")
