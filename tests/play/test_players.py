"""Scripted players: what they choose, in all that they see."""

import hashlib

import numpy as np
import pytest

import matrixworld as mw

GAMES = [
    {"rules": "O", "obstacles": 0.2},
    {"rules": "O", "diagonal": True},
    {"rules": "SB", "fov": 5, "obstacles": 0.1},
    {"rules": "TO", "n_pursuers": 5},  # pursuers act first, and evaders see it
    {"rules": "R", "rows": 40, "cols": 40, "n_pursuers": 1, "n_evaders": 1},  # nobody is in view
]
DIGESTS = {
    "random": "4c5c5a08", "still": "9df173c1", "chaser": "bc858cd6",
    "fleer": "7ed58406", "clumsy-chaser": "cb119d9d", "hunter": "a644d533",
    "surrounder": "e0c4f907", "clumsy-fleer": "1cef088a", "dodger": "363ab37c",
    "careful-random": "0c08eb86", "careful-chaser": "35f74c35", "careful-fleer": "3a553537",
    "careful-clumsy-chaser": "c27661fb", "careful-hunter": "c9c61f24",
    "careful-surrounder": "2f628f95", "careful-clumsy-fleer": "42477832",
    "careful-dodger": "2e2cdbed",
}  # fmt: skip
"""Digests of what scripts do. Slow readings of those that go by distances, and tests of the draws
of others, stood here at commit 8e1a8000: where all act at once, they have chosen the same moves."""


def actions_of(script):
    digest = hashlib.sha256()
    for changes in GAMES:
        usual = {"rows": 10, "cols": 10, "n_pursuers": 3, "n_evaders": 4, "fov": 7, "max_steps": 40}
        config = mw.WorldConfig(**{**usual, **changes})
        for teams in ((script, "random"), ("random", script)):
            for seed in range(3):
                episode = mw.record(config, *teams, seed=seed)
                digest.update((episode.actions * episode.alive[:-1]).astype(np.uint8).tobytes())
    return digest.hexdigest()[:8]


@pytest.mark.parametrize("script", DIGESTS)
def test_choices_stay(script):
    assert actions_of(script) == DIGESTS[script]


def test_every_script_has_a_digest():
    assert {*DIGESTS} == {name for name in mw.SCRIPTS if "team" not in name}
