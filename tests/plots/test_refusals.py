"""What cannot be drawn is refused in one sentence."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from matrixworld import analysis, plots

SQUARE = np.full((7, 7), 0.5)
NO_RUNS = "expected at least one group of runs to draw, got none"
NO_RACE = "expected at least one race to draw, got none"
training, collisions = plots.training_curve, plots.collision_rates
over_seeds = plots.generalization_over_seeds


@pytest.mark.parametrize(
    ("draw", "message"),
    [
        (lambda: training([0.5, 2.0], [0, 1]), r"values in \[0, 1\], got 2.0"),
        (lambda: training([[0.5]], [0]), r"1 dimension.*got shape \(1, 1\)"),
        (
            lambda: training([0.5, 0.6], [0, 2]),
            r"shape \(2,\), 0 for pursuers.*values \[0, 2\]",
        ),
        (lambda: training([0.5, 0.6], [0]), r"learners of shape \(2,\).*got shape \(1,\)"),
        (lambda: training([0.5], [0], window=0), "window of at least 1 point, got 0"),
        (
            lambda: training([0.5, 0.5], [0, 1], generations=[1, 1, 1]),
            r"generations of shape \(2,\), got \(3,\)",
        ),
        (lambda: collisions(np.zeros((4, 3))), r"shape \(G, 2, 3\), got \(4, 3\)"),
        (lambda: collisions(np.zeros((0, 2, 3))), r"got \(0, 2, 3\)"),
        (lambda: collisions(np.full((1, 2, 3), -1.0)), "at least 0, got -1.0"),
        (lambda: collisions(np.full((1, 2, 3), np.nan)), "at least 0, got nan"),
        (
            lambda: plots.generalization_curves(SQUARE, evader_baselines={"far off": 1.2}),
            r"baseline 'far off' with finite values.*got 1.2",
        ),
        (
            lambda: over_seeds({"one": [SQUARE]}, pursuer_baselines={"two": {"x": [0.5]}}),
            "baselines: expected names of one, got 'two'",
        ),
        (lambda: over_seeds({}), NO_RACE),
        (lambda: plots.comparison({}), NO_RACE),
        (lambda: plots.seed_bands({}), NO_RUNS),
        (lambda: plots.verdict_strip({}, {}), NO_RUNS),
        (lambda: plots.seed_scores({}), NO_RUNS),
        (lambda: plots.run_dots({}, label="score"), NO_RUNS),
        (lambda: plots.run_curves({}, label="score"), NO_RUNS),
        (lambda: plots.seed_bands({"a": []}), "at least one run, got none"),
        (lambda: plots.seed_scores({"a": {"pursuer": [0.5]}}), "scores of a with 2 dimension"),
        (
            lambda: plots.verdict_strip({"a": analysis.judge([SQUARE] * 3)}, {"a": (0, 1)}),
            "seeds: expected 3 of a, got 2",
        ),
        (lambda: plots.rules_table({}), "rules: expected at least one row, got none"),
    ],
)
def test_what_cannot_be_drawn_is_refused(draw: Callable[[], object], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        draw()
