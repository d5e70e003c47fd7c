"""What is no conflict, actions, and stage 1: collisions with obstacles, case by case.

Each case is written by hand from the rules and is played in the compiled world and in the slow
one.  ``S`` has teammates that reach and evaders that bounce off pursuers; see ``drawing.py``.
"""

from __future__ import annotations

import pytest

from drawing import Case, Play, Start, World, begin, case, check, conflict, rules, table

# Every conflict would be felt, and nobody is ever captured.
STRICT = rules(teammate="B", adversary="BB", capture="occupation")


NO_CONFLICT = (
    case("follow a teammate", STRICT, "A B . . a", Play("A> B>", ". A B . a", conflicts=[])),
    case("follow an evader", STRICT, "A a . .", Play("A> a>", ". A a .", conflicts=[])),
    case("follow a pursuer", STRICT, "a A . .", Play("A> a>", ". a A .", conflicts=[])),
    case("a ring of four", STRICT, "A a / b B", Play("A> av B< b^", "b A / B a", conflicts=[])),
    case(
        "a ring of three",
        STRICT,
        "A B / C . / . a",
        Play("A> B↙ C^", "C A / B . / . a", conflicts=[]),
        diagonal=True,
    ),
    case(
        "diagonals of adversaries cross",
        STRICT,
        "A a / . .",
        Play("A↘ a↙", ". . / a A", conflicts=[]),
        diagonal=True,
    ),
    case(
        "diagonals of teammates cross",
        STRICT,
        "A . / B . / . a",
        Play("A↘ B↗", ". B / . A / . a", conflicts=[]),
        diagonal=True,
    ),
    case(
        "cut the corner of obstacles",
        STRICT,
        "A # / # . / . a",
        Play("A↘", ". # / # A / . a", conflicts=[]),
        diagonal=True,
    ),
    case("side by side", STRICT, "A a / . .", Play("", "A a / . .", conflicts=[])),
)


@table(*NO_CONFLICT)
def test_no_conflict(start: Start, case: Case) -> None:
    check(start, case)


BUMP = conflict("obstacle vertex", "A", (0, 1), held="A", fault="A")


OBSTACLES = (
    case(
        "B bounces off an obstacle",
        "S",
        "A # . . a",
        Play("A>", "A # . . a", fault="obstacle A", conflicts=[BUMP]),
    ),
    case(
        "B bounces off the border",
        "S",
        "A . . a",
        Play(
            "A^",
            "A . . a",
            conflicts=[conflict("obstacle vertex", "A", (-1, 0), held="A", fault="A")],
        ),
    ),
    case(
        "D crashes into an obstacle",
        rules(obstacle="D"),
        "A # . . a / B . . . .",
        Play(
            "A>",
            ". # . . a / B . . . .",
            fault="obstacle A",
            conflicts=[conflict("obstacle vertex", "A", (0, 1), doomed="A", fault="A")],
        ),
    ),
    case(
        "D crashes into the border",
        rules(obstacle="D"),
        "A . . a / B . . .",
        Play("A<", ". . . a / B . . .", fault="obstacle A"),
    ),
    case(
        "the cell of one that crashed is free for a teammate",
        rules(obstacle="D", teammate="B"),
        "# A B . . a",
        Play(
            "A< B<",
            "# B . . . a",
            fault="obstacle A",
            conflicts=[conflict("obstacle vertex", "A", (0, 0), doomed="A", fault="A")],
        ),
    ),
    case(
        "one that crashed meets no adversary",
        rules(obstacle="D"),
        "# A a . / . . . B",
        Play("A< a<", "# a . . / . . . B", involved="obstacle A"),
    ),
    case(
        "R enters the cell of an obstacle, stays on it and leaves it",
        rules(obstacle="R"),
        "A # . . . a",
        Play(
            "A>",
            ". #A . . . a",
            fault="obstacle A",
            conflicts=[conflict("obstacle vertex", "A", (0, 1), fault="A")],
        ),
        Play("", ". #A . . . a", involved="", conflicts=[]),
        Play("A>", ". # A . . a", involved="", conflicts=[]),
    ),
    case(
        "R acts as B at the border",
        rules(obstacle="R"),
        "A . . a",
        Play(
            "A<",
            "A . . a",
            fault="obstacle A",
            conflicts=[conflict("obstacle vertex", "A", (0, -1), held="A", fault="A")],
        ),
    ),
    case(
        "R goes from obstacle to obstacle",
        rules(obstacle="R"),
        "A # # . a",
        Play("A>", ". #A # . a", fault="obstacle A"),
        Play("A>", ". # #A . a", fault="obstacle A"),
    ),
    case(
        "R, R: teammates share an obstacle",
        rules(obstacle="R"),
        "A # B . . a",
        Play("A> B<", ". #AB . . . a", fault="obstacle AB; teammate AB"),
    ),
    case(
        "R, B: teammates keep each other from an obstacle",
        rules(obstacle="R", teammate="B"),
        "A # B . . a",
        Play("A> B<", "A # B . . a", fault="obstacle AB; teammate AB"),
    ),
    case(
        "R, D: teammates die on an obstacle",
        rules(obstacle="R", teammate="D"),
        "A # B . a / . . . . C",
        Play("A> B<", ". # . . a / . . . . C", fault="obstacle AB; teammate AB"),
    ),
    case(
        "R: adversaries meet on an obstacle",
        rules(obstacle="R"),
        "A # a . .",
        Play("A> a<", ". #A a . .", fault="obstacle Aa; adversary a"),
    ),
    case(
        "one that an obstacle stopped stands still in the later stages",
        "SB",
        "# A B . . a",
        Play(
            "A< B<",
            "# A B . . a",
            fault="obstacle A; teammate AB",
            conflicts=[
                conflict("obstacle vertex", "A", (0, 0), held="A", fault="A"),
                conflict("teammate vertex", "AB", (0, 1), held="B", fault="AB"),
            ],
        ),
    ),
)


@table(*OBSTACLES)
def test_obstacles(start: Start, case: Case) -> None:
    check(start, case)


def test_an_unknown_action_of_a_living_agent(start: Start) -> None:
    for action in (-1, 5, 9):
        world = start_with_five_actions(start)
        with pytest.raises(ValueError, match=str(action)):
            world.step([0, action, 0])


def test_the_action_of_a_gone_agent_is_not_looked_at(start: Start) -> None:
    world = start_with_five_actions(start)
    world.step([2, 0, 0])
    world.step([99, 0, 0])
    assert world.alive.tolist() == [False, True, True]


def start_with_five_actions(start: Start) -> World:
    """Two pursuers, one of them beside an obstacle that kills, and an evader."""
    return begin(start, case("", rules(obstacle="D"), "A # . . a / B . . . ."))[0]
