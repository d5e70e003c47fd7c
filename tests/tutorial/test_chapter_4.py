"""Replies of notebook 4 to right and wrong answers, and what its text says of kept results."""

from __future__ import annotations

import numpy as np
import pytest

from matrixworld import analysis
from matrixworld.tutorial import check, kept


def reply(name: str, answer: object) -> str:
    found = check(name, answer)
    assert found.right is False
    return found.text


@pytest.mark.parametrize("name", ["4.1", "4.2", "4.3", "4.4"])
@pytest.mark.parametrize("answer", [None, 0.5, "text", [1, 2], np.zeros((4, 4))])
def test_a_wrong_type_gets_a_sentence(name: str, answer: object) -> None:
    assert "xpected" in reply(name, answer)


# Two races

STEPS = 0.1 * (np.arange(4)[:, None] - np.arange(4)[None, :])


def test_any_two_races_with_these_trends_are_right() -> None:
    better = 0.5 + 0.5 * STEPS
    assert check("4.1", (better.tolist(), (0.5 - STEPS).tolist())).right


def test_the_order_of_the_two_matters() -> None:
    text = reply("4.1", (0.5 - STEPS, 0.5 + STEPS))
    assert "better: the means of the rows" in text
    assert "grow from row to row" in text


def test_one_team_alone_is_not_enough() -> None:
    only_pursuers = np.full((4, 4), 0.5) + np.tril(np.full((4, 4), 0.1), -1)
    only_pursuers[np.triu_indices(4, 1)] = 0.5
    mirrored = np.array(
        [[0.5, 0.1, 0.1, 0.1], [0.2, 0.5, 0.2, 0.2], [0.3, 0.3, 0.5, 0.3], [0.4, 0.6, 0.6, 0.5]]
    )
    assert "columns" in reply("4.1", (mirrored, 0.5 - STEPS))
    assert check("4.1", (only_pursuers, 0.5 - STEPS)).right  # the columns fall, too


@pytest.mark.parametrize(
    ("matrix", "expected"),
    [
        (np.full((4, 4), 0.5), "means of the rows"),
        (0.6 + STEPS, "on the diagonal"),
        (0.5 + 3 * STEPS, "between 0 and 1"),
        (np.full((3, 3), 0.5), "4 x 4"),
        ([["a"] * 4] * 4, "4 x 4 numbers"),
    ],
)
def test_wrong_matrices(matrix: object, expected: str) -> None:
    assert expected in reply("4.1", (matrix, matrix))


# Ancestors


@pytest.mark.parametrize(
    ("answer", "expected"),
    [
        (lambda payoff, g: payoff[g, : g + 1].mean(), "current evaders"),
        (lambda payoff, g: payoff[:g, g].mean(), "a column"),
        (lambda payoff, g: payoff[g].mean(), "later evaders"),
        (lambda payoff, g: payoff[:g, :g].mean() + 1, "one row"),
        (lambda payoff, g: payoff[g, :g], "Expected a number"),
    ],
)
def test_other_parts_of_the_matrix(answer: object, expected: str) -> None:
    assert expected in reply("4.2", answer)


# The best generations


@pytest.mark.parametrize(
    ("answer", "expected"),
    [
        (lambda m: (m.mean(axis=1).argmax(), m.mean(axis=0).argmax()), "captured most often"),
        (lambda m: (m.mean(axis=0).argmax(), m.mean(axis=1).argmin()), "Which axis"),
        (lambda m: (len(m) - 1, m.shape[1] - 1), "Expected other generations"),
        (lambda m: (len(m), 0), "There are not so many generations"),
        (lambda m: m.mean(axis=1).argmax(), "Expected two generations"),
    ],
)
def test_other_generations(answer: object, expected: str) -> None:
    assert expected in reply("4.3", answer)


# Held-out opponents


def pairs(individuals, opponents):
    n, m = len(individuals), len(opponents)
    return np.repeat(individuals, m, axis=0), np.tile(opponents, (n, 1))


@pytest.mark.parametrize(
    ("answer", "expected"),
    [
        (lambda beats, a, b: beats(*pairs(a, b)[::-1]).mean(), "the opponents win"),
        (lambda beats, a, b: beats(a[: len(b)], b).mean(), "every individual against all"),
        (lambda beats, a, b: beats(*pairs(a, b)).sum(), "between 0 and 1"),
        (lambda beats, a, b: beats(*pairs(a, b)), "Expected a number"),
        (lambda beats, a, b: 0.5, "there are 35 pairs"),
    ],
)
def test_other_shares(answer: object, expected: str) -> None:
    assert expected in reply("4.4", answer)


# What the text says of the kept races


def test_the_red_queen_in_the_kept_races() -> None:
    saved = kept("chapter_4")
    races = saved["captured"] / saved["evaders_met"]
    when = saved["generations"].tolist()
    assert races.shape == (10, 25, 25)
    assert (races.min(), races.max()) >= (0, 0)
    assert races.max() <= 1
    diagonal = np.array([np.diag(race) for race in races])[:, when]

    def change(scores: np.ndarray, begin: int, end: int) -> analysis.Estimate:
        found = scores[:, when.index(end)] - scores[:, when.index(begin)]
        return analysis.interval_over_runs(found.astype(float))

    whole = change(diagonal, 0, 24)
    assert whole.low < 0 < whole.high
    assert change(diagonal, 0, 6).high < 0 < change(diagonal, 6, 24).low
    assert change(saved["pursuer"], 0, 24).low > 0
    assert change(saved["evader"], 0, 24).low > 0
    assert change(saved["evader"], 0, 6).low > 0
    later = change(saved["evader"], 6, 24)
    assert later.low < 0 < later.high
    assert change(saved["pursuer"], 6, 24).low > 0
    assert (saved["evader"][:, -1] > saved["evader"][:, 0]).all()
