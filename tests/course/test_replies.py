"""What the course replies to wrong answers, word for word, and answers that are right, too.

The replies stand in ``__snapshots__``; ``pytest --snapshot-update`` writes them anew. An answer is
named by its mistake; a reply helps, and does not give the answer away. So do the hints.
"""

import dataclasses
import re
from functools import partial
from typing import Any

import numpy as np
import pytest

import matrixworld as mw
import student_functions as student
from course import check
from course.chapter_1 import BUMPER_CARS
from course.chapter_2 import JAM_ACTIONS
from course.chapter_5 import ENDINGS
from course.chapter_9 import break_even
from matrixworld import Action, analysis

STAY, NORTH, EAST, SOUTH, WEST = list(Action)[:5]


bumper_cars = partial(dataclasses.replace, BUMPER_CARS)
LAGS = 0.1 * (np.arange(4)[:, None] - np.arange(4)[None, :])
ONE_TEAM = np.array(  # only the pursuers become stronger
    [[0.5, 0.1, 0.1, 0.1], [0.2, 0.5, 0.2, 0.2], [0.3, 0.3, 0.5, 0.3], [0.4, 0.6, 0.6, 0.5]]
)
BELOW_DIAGONAL = np.full((4, 4), 0.5) + np.tril(np.full((4, 4), 0.1), -1)
by_hand = partial(student.Later, student.hand_race)
GAINS = student.interval_of_gains("generalist_generalist")

WRONG: dict[str, dict[str, Any]] = {
    "1.1": {
        "into an obstacle": [SOUTH, SOUTH, SOUTH, EAST, EAST, EAST, EAST],
        "too short": [EAST, EAST, SOUTH, SOUTH, EAST, EAST, STAY],
    },
    "1.2": {"swaps": [EAST, WEST, EAST, WEST], "into the border": [WEST, EAST, WEST, EAST]},
    "1.3": {
        "simultaneous": bumper_cars(interaction=mw.Interaction.SIMULTANEOUS),
        "occupation": bumper_cars(capture=mw.Capture.OCCUPATION),
    },
    "1.4": {
        "no vertex conflicts": partial(student.conflicts, vertex=False),
        "no return": lambda cells, targets: None,
    },
    "2.1": {"nothing changed": JAM_ACTIONS, "still a chain": [EAST, EAST, WEST, STAY, SOUTH]},
    "2.2": {"no reward of the step": [-12, -12, 10, -10, -12]},
    "2.3": {"equal": 201, "too few": 100},
    "2.4": {"by index": student.by_index},
    "3.1": {
        "no biases": lambda side, hidden, moves: 3 * side**2 * hidden + hidden * moves,
        "one layer": lambda side, hidden, moves: (side**2 + 1) * hidden + (hidden + 1) * moves,
    },
    "3.2": {
        "no square": lambda spread, error: spread / error,
        "rounded down": lambda spread, error: int((spread / error) ** 2),
    },
    "3.3": {
        "no race": "race",
        "evaders want captures": by_hand(3, select=student.the_lowest),
        "payoff turned": by_hand(3, payoff=np.transpose),
    },
    "3.4": {
        "two scores": student.game(lambda a, b, rng: student.sums(a, b, rng) * 2),
        "a generator of its own": student.game(lambda a, b, rng: np.random.rand(len(a))),  # noqa: NPY002
        "nothing to select": student.game(lambda a, b, rng: 0 * student.sums(a, b, rng)),
    },
    "4.1": {"swapped": (0.5 - LAGS, 0.5 + LAGS), "one team only": (ONE_TEAM, 0.5 - LAGS)},
    "4.2": {
        "current evaders": lambda payoff, g: payoff[g, : g + 1].mean(),
        "a column": lambda payoff, g: payoff[:g, g].mean(),
    },
    "4.3": {
        "the most captured": lambda m: (m.mean(axis=1).argmax(), m.mean(axis=0).argmax()),
        "the other axis": lambda m: (m.mean(axis=0).argmax(), m.mean(axis=1).argmin()),
    },
    "4.4": {
        "the opponents win": lambda beats, a, b: beats(*student.pairs(a, b)[::-1]).mean(),
        "one opponent each": lambda beats, a, b: beats(a[: len(b)], b).mean(),
    },
    "5.1": {"two swapped": {**ENDINGS, "A": "cycle", "B": "one side only"}},
    "5.2": {"rule of the pursuers": lambda k, i: i % k, "the newest": lambda k, i: k},
    "5.3": {"the mean": GAINS.value, "the other sign": [-GAINS.high, -GAINS.low]},
    "5.4": {
        "always": lambda scores: True,
        "the diagonal": lambda scores: bool(np.diag(scores.mean(axis=2))[-1] > 0.5),
    },
    "6.1": {"strict losses": student.strict_losses},
    "6.2": {"the rest": lambda matrix: 1 - analysis.transitive_share(matrix)},
    "6.3": {"with repetition": student.hall(4, repeat=True), "too few": student.hall(3)},
    "7.1": {"of wins": lambda wins, v: 2 * wins / v - wins**2 / v**2},
    "7.2": {"below": 0.75, "above": 0.95},
    "7.3": {"the wins": lambda wins: wins},
    "8.1": {
        "the other order": student.rate_turned,
        "the last token": lambda tokens, inputs: inputs.get(tokens[-1], 0.0),
    },
    "8.2": {
        "one step": lambda program, shorter, score, least: next(
            (each for each in shorter(program) if score(each) >= least), program
        ),
        "the first": lambda program, shorter, score, least: shorter(program)[0],
    },
    "8.3": {
        "collides": "-open_side",
        "too long": "0.3 * teammate - open_side - must_yield + room",
        "no input": "distance",
    },
    "9.1": {"greedy": [6, 20, 0, 0, 0, 0], "careful": [3, 10, -10, -10, -6, 0]},
    "9.2": {"the paper's": 12, "low": 5.0},
    "9.3": {"few": 100, "one more": 300},
    "9.4": {"never": lambda own, other: False, "right before left": student.right_before_left},
}

WRONG |= {
    "10.1": {"all that is allowed": min, "always one": lambda stones, most: 1},
    "10.2": {
        "the best": lambda payoff, mixture: (mixture @ payoff).max(),
        "the mean": lambda payoff, mixture: (mixture @ payoff).mean(),
    },
    "10.3": {"equal": [1 / 3] * 3, "rock": [1, 0, 0]},
    "10.4": {"generalists": 0.843, "one team": 0.325},
}

RIGHT: dict[str, list[Any]] = {
    "10.3": [np.array([0.25, 0.5, 0.25]), (0.252, 0.498, 0.25)],
    "1.1": [np.array([2, 2, 3, 3, 2, 2, 3])],
    "1.2": [[EAST, SOUTH, NORTH, WEST], [SOUTH, WEST, EAST, NORTH]],
    "1.4": [student.careless],
    "2.3": [np.int64(202), 202.0],
    "2.4": [student.at_once],
    "3.3": [by_hand(5, payoff=np.ndarray.tolist)],
    "3.4": [student.game(student.sums), student.game(student.coin_of_sums, deterministic=False)],
    "4.1": [((0.5 + 0.5 * LAGS).tolist(), (0.5 - LAGS).tolist()), (BELOW_DIAGONAL, 0.5 - LAGS)],
    "5.3": [GAINS],
    "5.4": [student.both_rise],
    "6.1": [lambda matrix: analysis.checkerboards(matrix).count],
    "6.3": [student.hall(4), lambda available, rng: np.array(student.hall(4)(available, rng))],
    "7.3": [lambda wins: -abs(wins - 3)],
    "9.2": [-break_even(), np.float32(break_even())],
    "9.3": [np.ceil(298.07)],
    "8.3": ["0.2 * teammate - adversary - must_yield"],
    "9.4": [
        lambda own, other: own > other,
        lambda own, other: "nesw".index("wnse"[own - 1]) <= "nesw".index("wnse"[other - 1]),
        lambda own, other: np.bool_([3, 1, 4, 2][own - 1] < [3, 1, 4, 2][other - 1]),
    ],
}


def checked(name: str, answer: Any) -> Any:
    return check(name, answer() if isinstance(answer, student.Later) else answer)


@pytest.mark.parametrize("name", WRONG)
def test_replies_to_wrong_answers(name: str, snapshot: Any) -> None:
    replies = {mistake: checked(name, answer) for mistake, answer in WRONG[name].items()}
    # `None` would be an answer that is not judged.
    assert all(reply.right is False for reply in replies.values())
    told = {
        mistake: re.fullmatch(r"✗ Not yet\. (.+)  \(hint\('[\d.]+'\) gives a hint\.\)", reply.text)
        for mistake, reply in replies.items()
    }
    assert {mistake: found and found[1] for mistake, found in told.items()} == snapshot


@pytest.mark.parametrize("name", RIGHT)
def test_other_right_answers(name: str) -> None:
    for answer in RIGHT[name]:
        assert checked(name, answer).right is True


def test_the_errors_of_a_student_s_function_are_told_with_line_and_arguments() -> None:
    told = check("4.4", student.of_other_shapes).text
    assert "Your function raises ValueError: operands could not be broadcast" in told
    assert "in its line `return (individuals > opponents).mean()`" in told
    assert "individuals = an array of shape (7, 1), opponents = an array of shape (5, 1)" in told
    assert "ZeroDivisionError: division by zero" in check("1.4", lambda cells, targets: 1 / 0).text
    broken = student.game(lambda a, b, rng: a.missing)
    assert "AttributeError: " in check("3.4", broken).text


FUNCTIONS = [
    name
    for name, answers in WRONG.items()
    if any(callable(a) and not isinstance(a, type | student.Later) for a in answers.values())
]


@pytest.mark.parametrize("name", FUNCTIONS)
@pytest.mark.parametrize(
    "answer", [lambda: None, lambda a, b, c, d, e, f: None], ids=["none", "six"]
)
def test_a_wrong_number_of_parameters_is_told(name: str, answer: Any) -> None:
    told = check(name, answer)
    assert told.right is False
    assert re.search(r"Expected a function of \d arguments?, got <lambda>\(", told.text)


def test_replies_do_not_give_numbers_away() -> None:
    key = {"2.3": "202 ", "7.2": "0.9 ", "9.2": f"{break_even():.1f}", "9.3": "299", "10.4": "0.83"}
    for name, answer in key.items():
        assert not any(answer in check(name, wrong).text for wrong in WRONG[name].values())
