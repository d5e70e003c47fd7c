"""One number for everything that happens in a fixed set of random episodes.

After a change of what the engine does, run
``PYTHONPATH=tests/support python tests/contract/test_fingerprint.py`` to write the new number;
CONTRIBUTING says what else such a change must do.
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterator
from pathlib import Path

import numpy as np

import matrixworld as mw
from rows import CUSTOM, config_of, random_actions, random_genome

FILE = Path(__file__).parent / "fingerprint.txt"
N_WORLDS = 24
STEPS = 25
CENTS = 100  # rewards are counted in hundredths
# A list of its own instead of all of VARIANTS, so that a new variant leaves the number as it is.
NAMES = ("D", "R", "B", "O", "S", "SB", "SD", "SDB", "TO", *CUSTOM)

# What is told of the play, and follows from nothing else here; new ways of telling it change no
# fingerprint.
ARRAYS = (
    *("positions", "alive", "captured", "ever_captured", "captors", "involved", "fault"),
    *("rewards", "steps", "terminated", "truncated", "views", "state"),
)
SCORES = (
    *("capture_rate", "captured_fraction", "length", "pursuer_return", "evader_return"),
    *("pursuer_survivors", "evader_survivors", "pursuer_overlap", "evader_overlap"),
    *("collisions", "faults"),
)


def configs() -> Iterator[mw.WorldConfig]:
    """The variants and other rows of rules, in several sizes and crowds."""
    for number, name in enumerate(NAMES):
        yield config_of(name, max_steps=STEPS - 8)
        yield config_of(name, rows=1, cols=13, fov=3, obstacles=0.1, max_steps=9)
        yield config_of(
            name,
            rows=12,
            cols=19,
            n_pursuers=20 + number,
            n_evaders=30 - number,
            fov=9,
            diagonal=True,
            obstacles=0.15,
            rewards=mw.Rewards(capture_repeats=number % 2 == 0),
        )


def whole_numbers(array: np.ndarray) -> bytes:
    """An array's numbers, rewards in hundredths, as bytes that are the same on every machine."""
    if array.dtype.kind == "f":
        array = np.rint(CENTS * array.astype(float))
    return array.astype("<i8").tobytes()


def batches(digest: hashlib._Hash) -> None:
    """Whatever batches write, step by step."""
    for number, config in enumerate(configs()):
        specs = mw.array_specs(config)
        buffers = {name: np.zeros((N_WORLDS, *specs[name][0]), specs[name][1]) for name in ARRAYS}
        mode = mw.Autoreset.SAME_STEP
        batch = mw.Batch(N_WORLDS, config, threads=1, autoreset=mode, buffers=buffers)
        batch.reset(1000 * number)
        actions = random_actions(number, config.n_actions, STEPS, N_WORLDS, config.n_agents)
        for step in range(STEPS):
            batch.step(actions[step])
            for array in buffers.values():
                digest.update(whole_numbers(array))


def rollouts(digest: hashlib._Hash) -> None:
    """The scores of scripts and of networks."""
    matches = mw.Matches.of(0, 0, np.arange(6))
    for config in configs():
        network = mw.Network.for_config(config, (9, 7))
        team = mw.Population(random_genome(network, 1), network)
        for pursuers, evaders in ((team, "fleer"), ("chaser", team), ("random", "still")):
            scores = mw.rollout(config, pursuers, evaders, matches, episodes=2, threads=1)
            for name in SCORES:
                digest.update(whole_numbers(getattr(scores, name)))


def fingerprint() -> str:
    digest = hashlib.sha256()
    batches(digest)
    rollouts(digest)
    return digest.hexdigest()[:8]


def test_fingerprint() -> None:
    assert fingerprint() == FILE.read_text(encoding="ascii").strip()


if __name__ == "__main__":
    FILE.write_text(fingerprint() + "\n", encoding="ascii")
