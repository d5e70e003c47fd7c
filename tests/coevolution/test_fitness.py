"""From scores to fitness."""

from __future__ import annotations

import numpy as np
import pytest

from matrixworld.coevolution import fitness
from tiny_race import constant_scores


def scores():
    """Two matches of two worlds each."""
    made = constant_scores(0.0, (2, 2))
    made.captured_fraction = np.array([[0.2, 0.4], [1.0, 0.0]], dtype=np.float32)
    made.capture_rate = np.array([[0.5, 0.5], [1.0, 0.0]], dtype=np.float32)
    made.evader_overlap = np.array([[0.1, 0.3], [0.0, 0.0]], dtype=np.float32)
    made.pursuer_return = np.array([[10.0, 20.0], [0.0, 0.0]])
    made.evader_return = np.array([[-10.0, -30.0], [0.0, 2.0]])
    return made


@pytest.mark.parametrize(
    ("measure", "team", "expected"),
    [
        ("captured-fraction", "pursuer", [0.3, 0.5]),
        ("captured-fraction", "evader", [0.7 - 0.5 * 0.2, 0.5]),
        ("capture-rate", "pursuer", [0.5, 0.5]),
        ("capture-rate", "evader", [0.5 - 0.5 * 0.2, 0.5]),
        ("rewards", "pursuer", [15.0, 0.0]),
        ("rewards", "evader", [-20.0 - 0.5 * 0.2, 1.0]),
    ],
)
def test_fitness(measure, team, expected):
    assert fitness(scores(), team, measure=measure, overlap_penalty=0.5) == pytest.approx(expected)


def test_without_overlap_penalty_the_teams_share_one():
    made = scores()
    pursuers = fitness(made, "pursuer", measure="captured-fraction", overlap_penalty=0.0)
    evaders = fitness(made, "evader", measure="captured-fraction", overlap_penalty=0.0)
    assert pursuers + evaders == pytest.approx([1.0, 1.0])
