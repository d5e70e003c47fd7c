"""What an agent is paid, and who is involved without being at fault, case by case.

Each case is written by hand from the rules and is played in the compiled world and in the slow
one.  ``"A: capture step"`` names fields of ``Rewards``; see ``drawing.py``.
"""

from __future__ import annotations

from dataclasses import replace

from drawing import UNITS, Case, Play, Start, case, check, rules, table

REPEATS = replace(UNITS, capture_repeats=True)

CAPTURE = (
    case(
        "to the captor and to the captured",
        "O",
        "A . a . . b",
        Play(
            "A> a<", ". A . . . b", captured="a", paid="A: capture step; a: capture step; b: step"
        ),
        Play("", ". A . . . b", captured="a", paid="A: step; b: step"),
    ),
    case(
        "to each captor; a lasting one is no event after its first step",
        "S",
        "a A . . / B . . b",
        Play(
            "",
            "a A . . / B . . b",
            captured="a",
            paid="A: capture neighbor step; B: capture neighbor step;"
            "a: capture neighbor step; b: step",
        ),
        Play(
            "",
            "a A . . / B . . b",
            captured="a",
            paid="A: neighbor step; B: neighbor step; a: neighbor step; b: step",
        ),
    ),
    case(
        "once an episode: not when it comes again",
        "S",
        "a A . . / B . . . / . . . b",
        Play("", "a A . . / B . . . / . . . b", captured="a"),
        Play(
            "A>",
            "a . A . / B . . . / . . . b",
            ever="a",
            paid="A: step; B: neighbor step; a: neighbor step; b: step",
        ),
        Play(
            "A<",
            "a A . . / B . . . / . . . b",
            captured="a",
            paid="A: neighbor step; B: neighbor step; a: neighbor step; b: step",
        ),
    ),
    case(
        "capture_repeats: every step that it lasts",
        "S",
        "a A . . / B . . b",
        *[
            Play(
                "",
                "a A . . / B . . b",
                captured="a",
                paid="A: capture neighbor step; B: capture neighbor step;"
                "a: capture neighbor step; b: step",
            )
        ]
        * 2,
        rewards=REPEATS,
    ),
    case(
        "for each evader; who disappeared is nobody's neighbour",
        "SD",
        "a A b / B . C / . . . / . . c",
        Play(
            "",
            ". A . / B . C / . . . / . . c",
            captured="ab",
            paid="A: capture capture step; B: capture step; C: capture step;"
            "a: capture step; b: capture step; c: step",
        ),
    ),
    case(
        "also to captors that die of it",
        "D",
        "A a B . b / . . C . .",
        Play(
            "A> B<",
            ". . . . b / . . C . .",
            captured="a",
            paid="A: capture collide step; B: capture collide step; C: step;"
            "a: capture step; b: step",
        ),
    ),
    case(
        "an evader that crashes pays no capture",
        rules(obstacle="D", adversary="DR", capture="occupation"),
        "A . a # b",
        Play("a>", "A . . # b", paid="A: step; a: collide step; b: step"),
    ),
)


@table(*CAPTURE)
def test_capture(start: Start, case: Case) -> None:
    check(start, case)


NEIGHBOR = (
    case(
        "judged where they are after the step",
        "S",
        "A . a . / . . . .",
        Play("A>", ". A a . / . . . .", paid="A: neighbor step; a: neighbor step"),
        Play("a>", ". A . a / . . . .", paid="A: step; a: step"),
    ),
    case(
        "flat, however many there are",
        "S",
        "a A b . / . . . .",
        Play("", "a A b . / . . . .", paid="A: neighbor step; a: neighbor step; b: neighbor step"),
    ),
    case(
        "above and below",
        "S",
        "a . . / A . . / b . .",
        Play(
            "", "a . . / A . . / b . .", paid="A: neighbor step; a: neighbor step; b: neighbor step"
        ),
    ),
    case("not on a diagonal", "S", "A . / . a", Play("", "A . / . a", paid="A: step; a: step")),
    case(
        "not on a diagonal, whatever the moves",
        "S",
        "A . / . a",
        Play("", "A . / . a", paid="A: step; a: step"),
        diagonal=True,
    ),
    case(
        "not on one's own cell",
        rules(adversary="RR"),
        "A a . / . . .",
        Play("A>", ". Aa . / . . .", paid="A: collide step; a: step"),
    ),
    case(
        "teammates do not count",
        "S",
        "A B . . a b",
        Play("", "A B . . a b", paid="A: step; B: step; a: step; b: step"),
    ),
    case(
        "the dead have no neighbours and are none",
        rules(obstacle="D"),
        "A a . . . . / # B . . . .",
        Play("Av B>", ". a . . . . / # . B . . .", paid="A: collide step; B: step; a: step"),
    ),
)


@table(*NEIGHBOR)
def test_neighbor(start: Start, case: Case) -> None:
    check(start, case)


COLLIDE = (
    case(
        "once for a kind, however many there are",
        "SB",
        "A . B . a / . C . . .",
        Play(
            "A> B< C^",
            "A . B . a / . C . . .",
            paid="A: collide step; B: collide step; C: collide step; a: step",
        ),
    ),
    case(
        "once for each kind: obstacle, teammate, adversary",
        rules(obstacle="R", adversary="BB"),
        "A # a / . B . / . . .",
        Play(
            "A> B^ a<",
            "A # a / . B . / . . .",
            fault="obstacle ABa; teammate AB; adversary ABa",
            paid="A: collide collide collide step; B: collide collide collide step;"
            "a: collide collide step",
        ),
    ),
    case(
        "in a crash",
        rules(obstacle="D"),
        "A # . . a / B . . . .",
        Play("A>", ". # . . a / B . . . .", paid="A: collide step; B: step; a: step"),
    ),
    case(
        "not where occupation is the game",
        "R",
        "A . a . . b",
        Play(
            "A> a<",
            ". Aa . . . b",
            captured="a",
            involved="adversary Aa",
            fault="",
            paid="A: capture step; a: capture step; b: step",
        ),
    ),
    case(
        "under occupation, whoever was held",
        rules(adversary="BR", capture="occupation"),
        "A . a . .",
        Play(
            "A> a<",
            ". A a . .",
            involved="adversary Aa",
            fault="adversary a",
            paid="A: neighbor step; a: neighbor collide step",
        ),
    ),
    case(
        "adversaries that stand on one cell under surround: nobody was moving",
        rules(adversary="RR"),
        "A a . b / . . . .",
        Play("A>", ". Aa . b / . . . .", fault="adversary A"),
        Play(
            "",
            ". Aa . b / . . . .",
            involved="adversary Aa",
            fault="",
            paid="A: step; a: step; b: step",
        ),
    ),
)


@table(*COLLIDE)
def test_collide(start: Start, case: Case) -> None:
    check(start, case)


STEP = (
    case(
        "everybody, every round",
        "O",
        "A . . a",
        *[Play("", "A . . a", paid="A: step; a: step")] * 3,
    ),
    case(
        "also in the round that ends the episode",
        "O",
        "A a . .",
        Play("A>", ". A . .", captured="a", paid="A: capture step; a: capture step", ended=True),
    ),
    case(
        "also in the last round",
        "O",
        "A . . a",
        *[Play("", "A . . a", paid="A: step; a: step")] * 2,
        max_steps=2,
    ),
)


@table(*STEP)
def test_step(start: Start, case: Case) -> None:
    check(start, case)
