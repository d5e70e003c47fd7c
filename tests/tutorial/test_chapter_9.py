"""Exercises of notebook 9: typical mistakes get a sentence that helps; numbers of the text hold."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from matrixworld.tutorial import check, kept
from matrixworld.tutorial.chapter_9 import BRISK, GREEDY, _break_even
from matrixworld.tutorial.packs import everything, play_masked

STEPS = [(0, 0), (-1, 0), (0, 1), (1, 0), (0, -1)]


def free_cells(views: np.ndarray) -> np.ndarray:
    """Allow moves to cells on which nothing stands."""
    allowed = np.ones((len(views), 5), bool)
    for action, (row, col) in enumerate(STEPS[1:], start=1):
        allowed[:, action] = ~views[:, :, 5 + row, 5 + col].any(axis=1)
    return allowed


def timid(views: np.ndarray) -> np.ndarray:
    """Allow moves to free cells without any teammate around."""
    allowed = free_cells(views)
    for action, target in enumerate(STEPS[1:], start=1):
        for side in STEPS[1:]:
            row, col = 5 + np.array(target) + side
            allowed[:, action] &= views[:, 1, row, col] == 0
    return allowed


def still(views: np.ndarray) -> np.ndarray:
    """Allow moves on an empty grid only."""
    allowed = np.ones((len(views), 5), bool)
    allowed[views.any(axis=(1, 2, 3)), 1:] = False
    return allowed


def no_teammate(views: np.ndarray) -> np.ndarray:
    """Forget the walls."""
    allowed = np.ones((len(views), 5), bool)
    for action, (row, col) in enumerate(STEPS[1:], start=1):
        allowed[:, action] = views[:, 1, 5 + row, 5 + col] == 0
    return allowed


WRONG: list[tuple[str, Any, str]] = [
    ("9.1", "greedy", "six numbers"),
    ("9.1", [6, 20, 0], "six numbers"),
    ("9.1", [6, 20, 0, 0, 0, float("nan")], "six numbers"),
    ("9.1", GREEDY, "Both numbers are too large"),
    ("9.1", [6, 20, -10, -10, -2, 0], "more careful"),
    ("9.1", [3, 10, -10, -10, -6, 0], "more determined"),
    ("9.2", 12, "the idle pack is larger"),
    ("9.2", 5.0, "the brisk pack is larger"),
    ("9.2", [1.0, 2.0], "one number"),
    ("9.2", "ten", "one number"),
    ("9.3", 100, "more than 5%"),
    ("9.3", 298, "more than 5%"),
    ("9.3", 1000, "not the smallest"),
    ("9.3", 298.07, "whole number"),
    ("9.3", 0, "At least one episode"),
    ("9.4", True, "function itself"),
    ("9.4", np.ones((2, 5)), "function itself"),
    ("9.4", lambda views: np.ones(5, bool), "(n, 5)"),
    ("9.4", lambda views: np.zeros((len(views), 5), bool), "empty grid"),
    ("9.4", everything, "walls"),
    ("9.4", no_teammate, "walls"),
    ("9.4", free_cells, "collide with teammates"),
    ("9.4", still, "forbids too much"),
]


@pytest.mark.parametrize(("name", "answer", "part"), WRONG)
def test_wrong_answers_get_a_sentence(name: str, answer: Any, part: str) -> None:
    reply = check(name, answer)
    assert reply.right is False
    assert part in reply.text
    assert "Right" not in reply.text


def test_replies_do_not_give_answers_away() -> None:
    assert f"{_break_even():.1f}" not in check("9.2", 12).text
    assert "299" not in check("9.3", 100).text


def test_any_convention_that_works_is_right() -> None:
    def other_order(views: np.ndarray) -> np.ndarray:
        allowed = free_cells(views)
        for action, target in enumerate(STEPS[1:], start=1):
            for side in [(0, 1), (1, 0), (0, -1), (-1, 0)]:
                if side == (-target[0], -target[1]):
                    break
                row, col = 5 + np.array(target) + side
                allowed[:, action] &= views[:, 1, row, col] == 0
        return allowed

    assert check("9.4", other_order).right
    assert check("9.4", timid).right


def test_both_signs_of_a_penalty_are_understood() -> None:
    assert check("9.2", -_break_even()).right
    assert check("9.2", np.float32(_break_even())).right


def test_the_brisk_pack_captures_and_is_safe_in_most_episodes() -> None:
    played = play_masked(BRISK, everything, episodes=300, seed=5)
    assert played.captured.mean() > 0.95
    assert (played.safety.summary().safe_share[0] > 0.6).all()
    assert 8 < _break_even() < 12


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
