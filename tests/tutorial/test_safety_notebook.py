"""Notebook 9: its packs play as the text says, and numbers of the text hold."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import matrixworld as mw
from matrixworld.tutorial import kept
from matrixworld.tutorial.chapter_9 import (
    BRISK,
    WEIGHTS,
    WORLD,
    break_even,
    everything,
    pack,
    play_masked,
)
from student_functions import STEPS


def test_the_brisk_pack_captures_and_is_safe_in_most_episodes() -> None:
    played = play_masked(BRISK, everything, episodes=300, seed=5)
    assert played.captured.mean() > 0.95
    assert (played.safety.summary().safe_share[0] > 0.6).all()
    assert 8 < break_even() < 12


@pytest.fixture(scope="module")
def runs() -> dict[str, np.ndarray]:
    return dict(kept("safe_packs"))


def shares(runs: dict[str, np.ndarray], name: str) -> tuple[np.ndarray, np.ndarray]:
    """Return the shares of episodes with a capture, and of unsafe ones, of each run."""
    episodes = runs["episodes"]
    return runs[f"{name}_captured"] / episodes, 1 - runs[f"{name}_safe"] / episodes


def test_at_every_penalty_runs_that_capture_collide(runs: dict[str, np.ndarray]) -> None:
    for number in range(len(runs["penalties"])):
        captured, unsafe = shares(runs, f"penalty{number}")
        assert (unsafe[captured > 0.5] > 0).all()


def test_a_high_penalty_makes_two_kinds_of_runs(runs: dict[str, np.ndarray]) -> None:
    captured, _ = shares(runs, "penalty5")
    assert runs["penalties"][5] == 12
    assert (captured < 0.05).sum() >= 3
    assert (captured > 0.9).sum() >= 3
    without, _ = shares(runs, "penalty0")
    assert (without > 0.5).all()


def test_masks_rule_collisions_out(runs: dict[str, np.ndarray]) -> None:
    for name in ("mask", "late_mask"):
        assert not runs[f"{name}_faults"].any()
    assert not runs["mask_training_faults"].any()
    from_the_start, _ = shares(runs, "mask")
    afterwards, _ = shares(runs, "late_mask")
    assert from_the_start.min() > 0.9
    assert afterwards.mean() < from_the_start.mean() - 0.1


def test_a_limit_is_kept_at_the_end(runs: dict[str, np.ndarray]) -> None:
    rates = 1000 * runs["limit_faults"].sum(axis=1) / runs["limit_agent_steps"]
    assert (rates < 20).all()


# ---- Packs of six weights ----

EVADERS, PURSUERS, OBSTACLES = range(3)


def wishes(view: np.ndarray, weights: np.ndarray) -> list[float]:
    """Return the wishes for the five actions, cell by cell as the table says."""
    of = dict(zip(WEIGHTS, weights, strict=True))
    found = [of["stay"]]
    evaders = [(r - 5, c - 5) for r, c in np.argwhere(view[EVADERS])]
    found[0] += of["hold"] * sum(abs(r) + abs(c) == 1 for r, c in evaders)
    for row, col in STEPS[1:]:
        wish = of["wall"] * view[OBSTACLES, 5 + row, 5 + col]
        wish += of["teammate"] * view[PURSUERS, 5 + row, 5 + col]
        for r, c in evaders:
            wish += of["approach"] * (r * row + c * col) / max(abs(r) + abs(c), 1)
        for down, right in STEPS[1:]:
            r, c = row + down, col + right
            if (r, c) != (0, 0):
                wish += of["crowd"] * view[PURSUERS, 5 + r, 5 + c]
        found.append(wish)
    return found


def test_the_network_wishes_what_the_table_says() -> None:
    rng = np.random.default_rng(0)
    views = (rng.random((20, 3, 11, 11)) < 0.1).astype(np.uint8)
    weights = rng.normal(size=6)
    own = pack(weights)
    found = own.network.logits(own.genomes[0], views)
    expected = [wishes(view, weights) for view in views]
    np.testing.assert_allclose(found, expected, atol=1e-4)


def test_several_packs_are_one_population() -> None:
    both = pack([[1, 2, 3, 4, 5, 6], [0, 0, 0, 0, 0, 1]])
    np.testing.assert_array_equal(both.genomes[0], pack([1, 2, 3, 4, 5, 6]).genomes[0])
    assert len(both.genomes) == 2


@pytest.mark.parametrize("weights", [1.0, [1, 2], np.zeros((2, 7)), np.zeros((1, 1, 6))])
def test_other_shapes_are_refused(weights: Any) -> None:
    with pytest.raises(ValueError, match=r"weights: expected shape \(6,\) or \(n, 6\), got \("):
        pack(weights)


def test_without_a_mask_it_plays_like_a_rollout() -> None:
    weights = [6, 20, -10, -10, -2, 0]
    masked = play_masked(weights, everything, episodes=400, seed=1)
    played = mw.rollout(WORLD, pack(weights), "random", mw.Matches.of(0, 0, 2), episodes=400)
    # Means of 400 episodes each; the standard error of their difference is below 0.5 steps.
    assert abs(masked.steps.mean() - played.length.mean()) < 2
    assert abs(masked.captured.mean() - played.capture_rate.mean()) < 0.05
    assert masked.safety.episodes == 400
    assert masked.steps.max() <= WORLD.max_steps


def test_a_forbidden_action_is_never_chosen() -> None:
    def no_moves(views: np.ndarray) -> np.ndarray:
        return np.tile([True, False, False, False, False], (len(views), 1))

    def nothing(views: np.ndarray) -> np.ndarray:
        return np.zeros((len(views), 5), bool)

    for mask in (no_moves, nothing):  # where nothing is allowed, pursuers stay
        stayed = play_masked([6, 0, 0, 0, 0, 0], mask, episodes=20)
        assert not stayed.captured.any()
        assert (stayed.steps == WORLD.max_steps).all()
        assert stayed.safety.summary().fault_rate[0].sum() == 0


def test_a_mask_of_another_shape_is_refused() -> None:
    with pytest.raises(ValueError, match=r"mask: expected shape \(30, 5\), got \(30,\)"):
        play_masked([0] * 6, lambda views: np.ones(len(views), bool), episodes=5)
