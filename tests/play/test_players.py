"""Scripted players: what they choose, in all that they see; team-surrounder with no fault."""

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


NAME = "careful-team-surrounder"


def world_of(rules="SB", **changes):
    usual = {"n_pursuers": 12, "n_evaders": 4, "max_steps": 60}
    usual |= {} if "size" in changes else {"rows": 12, "cols": 14}
    return mw.WorldConfig(rules, **(usual | changes))


WORLDS = {
    "ce62fdea4c4326e1": {"n_pursuers": 30, "n_evaders": 12, "max_steps": 30},  # a crowd
    "58db425fc26f47ae": {"n_pursuers": 16, "obstacles": 0.1, "fov": 7},
    "e817ef0fb844a8f2": {"diagonal": True, "n_pursuers": 24, "n_evaders": 3, "max_steps": 30},
    # One line that searches, several, and swaths.
    "c8e89845b14bb5a1": {"size": 30, "n_pursuers": 4, "n_evaders": 1, "max_steps": 150},
    "dc25c357400b76b2": {
        "rows": 50,
        "cols": 40,
        "n_pursuers": 11,
        "n_evaders": 3,
        "max_steps": 250,
        "fov": 9,
    },
    "6f9795913f9545a5": {"size": 40, "n_pursuers": 40, "n_evaders": 2, "max_steps": 100},
}
"""Worlds by a digest of the pursuers' actions there. A slow reading of the script, which stood here
at commit 9f2e3880, has chosen the same actions, brought up to date where the script has changed."""


@pytest.mark.parametrize("digest", WORLDS)
def test_choices_are_those_of_a_slow_reading(digest):
    config, found = world_of(**WORLDS[digest]), hashlib.sha256()
    for seed in (0, 2**40 + 1):
        actions = mw.record(config, NAME, "random", seed=seed).actions[:, : config.n_pursuers]
        found.update(actions.astype(np.uint8).tobytes())
    assert found.hexdigest()[:16] == digest


@pytest.mark.parametrize("digest", [*WORLDS][1:])  # in the crowd, everybody sees somebody
def test_who_sees_no_adversary_moves_as_the_input_search_says(digest: str) -> None:
    config, choices = world_of(**WORLDS[digest]), []
    team = range(config.n_pursuers)
    for seed in range(4):
        world = mw.World(config)
        world.reset(seed)
        while not (world.terminated or world.truncated):
            moves = world.inputs()[team, :, list(mw.INPUTS).index("search")] == 1
            searches = ~world.views()[team, 0].any(axis=(1, 2))
            actions = np.zeros(config.n_agents, np.int64)
            world.decide("team-surrounder", team, actions)
            assert moves[searches, actions[team][searches]].all()
            choices += zip(moves[searches], actions[team][searches], strict=True)
            world.decide("random", range(config.n_pursuers, config.n_agents), actions)
            world.step(actions)
    assert len(choices) > 50
    assert np.mean([moves.sum() for moves, _ in choices]) < 2


@pytest.mark.parametrize("diagonal", [False, True])
@pytest.mark.parametrize("rules", ["D", "R", "B", "O", "S", "SB", "SD", "SDB", "TO"])
def test_nobody_is_at_fault_in_any_variant(rules, diagonal):
    for fov, rows in ((5, 12), (11, 12), (15, 3)):
        config = world_of(
            rules, diagonal=diagonal, fov=fov, rows=rows, obstacles=0.05, n_pursuers=9 + rows
        )
        played = mw.rollout(config, NAME, NAME, mw.Matches.of(0, 0, range(5)))
        assert not played.faults.any()


def test_it_captures_everybody_and_is_never_at_fault():
    for pursuers, evaders in ((4, 1), (64, 16)):
        config = mw.WorldConfig("SB", rows=40, cols=40, n_pursuers=pursuers, n_evaders=evaders)
        played = mw.rollout(config, NAME, "random", mw.Matches.of(0, 0, range(10)))
        assert played.capture_rate.min() == 1
        assert not played.faults[:, :, 0].any()
