"""What a program does, in a sentence, case by case.

A program without conditions has one case, and is told by the effects of its inputs, as a rating is.
One with conditions is told as a list: the first case that holds for the cell of a move rates it.
Moves of one state may be of different cases; how often a move of each is taken is counted.
"""

from __future__ import annotations

from functools import partial
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from matrixworld.coevolution.evaluation.effects import deed, effect_of, in_words, listed, sentence
from matrixworld.coevolution.types import Team
from matrixworld.play.policies import RatingPolicy
from matrixworld.world.program import Call, Constant, Input, Node, Program, cases_of, expression_of

MOST_CASES = 5  # the most cases that a sentence tells; conditions in them are told by effects
ALIKE = "rates all alike"


class Test(NamedTuple):
    """What it means that an input is at most so much, and that it is more."""

    at_most: str
    more: str
    unit: str = ""  # what is counted; empty for an input that is 0 or 1


TESTS: dict[str, Test] = {
    "adversary": Test(
        "the nearest {foe} in view is within {n}", "no {foe} in view is within {n}", "move"
    ),
    "unclaimed": Test(
        "a {foe} that no teammate is nearer to is within {n}",
        "no {foe} that no teammate is nearer to is within {n}",
        "move",
    ),
    "open_side": Test(
        "a free side of {foe}s in view is within {n}",
        "no free side of {foe}s in view is within {n}",
        "move",
    ),
    "teammate": Test(
        "a teammate in view is within {n}", "no teammate in view is within {n}", "move"
    ),
    "exits": Test("at most {n} around it are free", "more than {n} around it are free", "cell"),
    "room": Test(
        "an obstacle in its row or column is within {n}",
        "no obstacle in its row or column is within {n}",
        "move",
    ),
    "must_yield": Test("right of way allows the move", "right of way forbids the move"),
    "ahead": Test("the move leaves its direction", "the move keeps its direction"),
    "search": Test("the move leaves its way of searching", "the move follows its way of searching"),
    "escapes": Test("at most {n} are ways out", "more than {n} are ways out", "cell"),
    "parity": Test(
        "the distance to the nearest {foe} is not odd", "the distance to the nearest {foe} is odd"
    ),
}
"""Tests of single inputs; all others are told as expressions."""


def sentence_of_program(team: Team, policy: RatingPolicy, seen: NDArray[np.float32]) -> str:
    """Return in a sentence what a program does, by inputs (n, moves, inputs) that it has seen."""
    program = policy.policy
    assert isinstance(program, Program)
    tree = program.tree(program.simplified(policy.genome))
    allowed = policy.allowed(seen)
    left = allowed.copy()
    found = []
    for case in cases_of(tree, MOST_CASES):
        moves = left.copy()
        for test in case.tests:
            moves &= program.values(test, seen) > 0
        left &= ~moves
        if moves.any():
            found.append((case, moves))
    deeds = [_deed_of(program, case.tree, seen, moves) for case, moves in found]
    if len(found) == 1:
        return sentence(team, deeds[0])
    told = []
    for number, ((case, moves), does) in enumerate(zip(found, deeds, strict=True), start=1):
        tests = " and ".join(_test_in_words(team, program, test) for test in case.tests)
        does = does or _rated_by(program, case.tree, seen, moves)
        told.append(f"({number}) {f'if {tests}' if tests else 'otherwise'}, it {does}")
    text = in_words(
        team,
        f"{{A}} {team} goes by the first case that holds for the cell of a move: "
        f"{'; '.join(told)}.",
    )
    ratings = np.where(allowed, policy.rate(seen), -np.inf)
    best = ratings == ratings.max(axis=1, keepdims=True)
    shares = _shares_taken(best, [moves for _, moves in found])
    if shares is not None:
        taken = listed([f"({number}) in {_percent(each)}" for number, each in enumerate(shares, 1)])
        text += f" Where it can choose between cases, it takes {taken} of states."
    return text


def _deed_of(
    program: Program, tree: Node, seen: NDArray[np.float32], moves: NDArray[np.bool_]
) -> str:
    """Return what an agent does that rates these moves by a tree."""
    rate = partial(program.values, tree)
    return deed({name: effect_of(rate, seen, moves, name) for name in program.inputs})


def _rated_by(
    program: Program, tree: Node, seen: NDArray[np.float32], moves: NDArray[np.bool_]
) -> str:
    """Return what a case rates by whose moves of one state are alike, or of which it has one."""
    rated = program.values(tree, seen)[moves]
    return ALIKE if (rated == rated[0]).all() else f"rates by {expression_of(tree)}"


def _shares_taken(
    best: NDArray[np.bool_], cases: list[NDArray[np.bool_]]
) -> NDArray[np.float64] | None:
    """Return how often a move of each case is taken in states that offer moves of several cases.

    Moves are bool (n, moves). Of equally good ones each is taken equally often. None if no state
    offers any.
    """
    several = np.sum([moves.any(axis=1) for moves in cases], axis=0) > 1
    if not several.any():
        return None
    of_case = np.array([(best & moves)[several].sum(axis=1) for moves in cases])
    shares: NDArray[np.float64] = (of_case / of_case.sum(axis=0)).mean(axis=1)
    return shares


def _percent(share: float) -> str:
    """Return a share in percent, as 0 or 100 only if it is so exactly."""
    rounded = round(100 * share)
    return f"{rounded if share in (0.0, 1.0) else min(max(rounded, 1), 99)} %"


def _test_in_words(team: Team, program: Program, test: Node) -> str:
    """Return what it means that the value of a test is more than 0."""
    match test:
        case Call("less", (Input(name), Constant(limit))):
            text = _limit_in_words(team, program, name, limit, below=True)
        case Call("less", (Constant(limit), Input(name))):
            text = _limit_in_words(team, program, name, limit, below=False)
        case Input(name):
            text = _limit_in_words(team, program, name, 0.0, below=False)
        case _:
            text = ""
    if text:
        return text
    if isinstance(test, Call) and test.operation == "less":
        return expression_of(test)
    told = expression_of(test)
    return f"({told}) > 0" if isinstance(test, Call) else f"{told} > 0"


def _limit_in_words(team: Team, program: Program, name: str, limit: float, *, below: bool) -> str:
    """Return what it means that an input is below, or above, a limit; empty if no words tell it."""
    if name not in TESTS:
        return ""
    test = TESTS[name]
    values = _values_of(program, name)
    at_most = values < np.float32(limit) if below else values <= np.float32(limit)
    number = int(at_most.sum()) - 1  # the greatest count of what the input tells
    if not 0 <= number < len(values) - 1:
        return ""  # so it is always, or never
    n = f"{number} {test.unit}{'' if number == 1 else 's'}"
    return in_words(team, (test.at_most if below else test.more).replace("{n}", n))


def _values_of(program: Program, name: str) -> NDArray[np.float32]:
    """Return the values that an input can have, those of counts from 0 on."""
    if TESTS[name].unit == "cell":
        most = program.n_actions - (name == "exits")
        return np.asarray(np.arange(most + 1, dtype=np.float32) / np.float32(most))
    unit, most = np.float32(1), 1
    if TESTS[name].unit == "move":
        unit, most = np.float32(2) / np.float32(program.fov), program.fov
    if name == "room":
        most //= 2
    return np.asarray(np.arange(most + 1, dtype=np.float32) * unit)
