"""The script careful-team-surrounder: what it decides, that it captures, and no faults."""

import hashlib

import pytest

import matrixworld as mw

NAME = "careful-team-surrounder"
# Where its pursuers went when each of their choices was that of a slow reading in Python.
PLAYED = {
    "1d7c9306": {"n_pursuers": 30, "n_evaders": 12, "max_steps": 30},  # a crowd
    "7b4b1efe": {"n_pursuers": 16, "obstacles": 0.1, "fov": 7},
    "7b0338c2": {"diagonal": True, "n_pursuers": 24, "n_evaders": 3, "max_steps": 30},
    # In one line, in several, and in swaths.
    "ab026001": {"rows": 30, "cols": 30, "n_pursuers": 4, "n_evaders": 1, "max_steps": 150},
    "c66e3872": {
        "rows": 50,
        "cols": 40,
        "n_pursuers": 11,
        "n_evaders": 3,
        "max_steps": 250,
        "fov": 9,
    },
    "42e268dd": {"rows": 40, "cols": 40, "n_pursuers": 40, "n_evaders": 2, "max_steps": 100},
}


def world_of(rules: object = "SB", **changes: object) -> mw.WorldConfig:
    usual = {"rows": 12, "cols": 14, "n_pursuers": 12, "n_evaders": 4, "max_steps": 60}
    return mw.WorldConfig(rules, **(usual | changes))


@pytest.mark.parametrize("fingerprint", PLAYED)
def test_it_plays_as_when_every_choice_was_checked(fingerprint: str) -> None:
    config, digest = world_of(**PLAYED[fingerprint]), hashlib.sha256()
    for seed in (0, 2**40 + 1):
        episode = mw.record(config, NAME, "random", seed=seed)
        digest.update(episode.positions[:, : config.n_pursuers].astype("<i8").tobytes())
    assert digest.hexdigest()[:8] == fingerprint


@pytest.mark.parametrize("diagonal", [False, True])
@pytest.mark.parametrize("rules", ["D", "R", "B", "O", "S", "SB", "SD", "SDB", "TO"])
def test_nobody_is_at_fault_in_any_variant(rules: str, diagonal: bool) -> None:
    for fov, rows in ((5, 12), (11, 12), (15, 3)):
        config = world_of(
            rules, diagonal=diagonal, fov=fov, rows=rows, obstacles=0.05, n_pursuers=9 + rows
        )
        played = mw.rollout(config, NAME, NAME, mw.Matches.of(0, 0, range(5)))
        assert not played.faults.any()


def test_it_captures_everybody_and_is_never_at_fault() -> None:
    for pursuers, evaders in ((4, 1), (64, 16)):
        config = mw.WorldConfig("SB", rows=40, cols=40, n_pursuers=pursuers, n_evaders=evaders)
        played = mw.rollout(config, NAME, "random", mw.Matches.of(0, 0, range(10)))
        assert played.capture_rate.min() == 1
        assert not played.faults[:, :, 0].any()
