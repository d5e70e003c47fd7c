"""Who acts when, and who meets whom, under turns, case by case.

Each case is written by hand from the rules and is played in the compiled world and in the slow
one.  A play is a round: one turn of everybody; see ``drawing.py``.
"""

from __future__ import annotations

from dataclasses import replace

import pytest

from drawing import UNITS, Case, Play, Start, case, check, conflict, rules, table

SWARM, AGENT = "swarm turns", "agent turns"
REPEATS = replace(UNITS, capture_repeats=True)

SWARM_TURNS = (
    case(
        "pursuers first: the evader is caught before it leaves",
        rules(SWARM, adversary="DR", capture="occupation"),
        "A a . b",
        Play("A> a>", ". A . b", captured="a", involved="adversary Aa"),
    ),
    case(
        "a whole team moves at once",
        rules(SWARM, teammate="B"),
        "A B . . . a",
        Play("A> B> a<", ". A B . a .", conflicts=[]),
    ),
    case(
        "the evaders find the pursuers where they went",
        rules(SWARM),
        "a A . .",
        Play("a> A>", ". a A .", conflicts=[]),
    ),
    case(
        "nobody swaps with an adversary: each enters the cell of one that stands",
        rules(SWARM),
        "A a . / . . .",
        Play(
            "A> a<",
            "A a . / . . .",
            fault="adversary Aa",
            conflicts=[
                conflict("adversary vertex", "Aa", (0, 1), held="A", fault="A", turn=0),
                conflict("adversary vertex", "Aa", (0, 0), held="a", fault="a", turn=1),
            ],
        ),
    ),
    case(
        "who heads for one cell does not meet: the pursuer has it",
        rules(SWARM),
        "A . a . .",
        Play(
            "A> a<",
            ". A a . .",
            conflicts=[conflict("adversary vertex", "Aa", (0, 1), held="a", fault="a", turn=1)],
        ),
    ),
    case(
        "teammates that stand together are in conflict in their own turn alone",
        rules(SWARM),
        "A B . . a",
        Play("A>", ". AB . . a"),
        Play(
            "",
            ". AB . . a",
            conflicts=[conflict("teammate vertex", "AB", (0, 1), fault="AB", turn=0)],
        ),
    ),
    case(
        "chains run within the team that moves",
        rules(SWARM, teammate="B"),
        "A B a . . / . . . . .",
        Play(
            "A> B> a>",
            "A B . a . / . . . . .",
            fault="teammate AB; adversary B",
            conflicts=[
                conflict("adversary vertex", "Ba", (0, 2), held="B", fault="B", turn=0),
                conflict("teammate chain", "AB", (0, 1), held="A", fault="AB", turn=0),
            ],
        ),
    ),
    case(
        "captured in the pursuers' turn and free after the evaders'",
        rules(SWARM, adversary="RR", capture="occupation"),
        "A a . b",
        Play("A> a>", ". A a b", captured="", ever="a", captors=""),
    ),
    case(
        "captured in the pursuers' turn, free in the evaders', and dead of something else",
        rules(SWARM, obstacle="D", adversary="RR", capture="occupation"),
        "a A b . . .",
        Play("A< a^", "A . b . . .", captured="", ever="a", captors=""),
    ),
    case(
        "the round ends at the turn in which the world terminates",
        rules(SWARM, adversary="RR", capture="occupation"),
        "A a . .",
        Play("A> a>", ". Aa . .", captured="a", captors="a1", ended=True),
    ),
    case(
        "surrounded in the pursuers' turn, and still after the evaders'",
        rules(SWARM),
        "a . A . / B . . b",
        Play("A< a> b^", "a A . b / B . . .", captured="a", captors="a2", fault="adversary a"),
    ),
    case(
        "captured in the evaders' turn: an evader walks into it",
        rules(SWARM, adversary="DR", capture="occupation"),
        "A . a . b",
        Play("A> a<", ". A . . b", captured="a", captors="a1"),
    ),
)


@table(*SWARM_TURNS)
def test_swarm_turns(start: Start, case: Case) -> None:
    check(start, case)


AGENT_TURNS = (
    case(
        "in the order of the index: the first runs into the second",
        rules(AGENT, teammate="B"),
        "A B . . a",
        Play(
            "A> B>",
            "A . B . a",
            fault="teammate AB",
            conflicts=[conflict("teammate vertex", "AB", (0, 1), held="A", fault="AB", turn=0)],
        ),
    ),
    case(
        "in the order of the index: the second follows the first",
        rules(AGENT, teammate="B"),
        "B A . . a",
        Play("A> B>", ". B A . a", conflicts=[]),
    ),
    case(
        "evaders in the order of the index, after the pursuers",
        rules(AGENT, teammate="B"),
        "a b . . A",
        Play("a> b> A<", "a . b A .", fault="teammate ab"),
    ),
    case(
        "R: one passes through the cell of the other",
        rules(AGENT),
        "A B . . a",
        Play(
            "A> B<",
            "B A . . a",
            fault="teammate AB",
            conflicts=[conflict("teammate vertex", "AB", (0, 1), fault="AB", turn=0)],
        ),
    ),
    case(
        "standing together is a conflict in the turns of the two",
        rules(AGENT),
        "A B . . a",
        Play("A>", ". AB . . a"),
        Play(
            "",
            ". AB . . a",
            conflicts=[
                conflict("teammate vertex", "AB", (0, 1), fault="AB", turn=0),
                conflict("teammate vertex", "AB", (0, 1), fault="AB", turn=1),
            ],
        ),
    ),
    case(
        "one that does not act may die",
        rules(AGENT, teammate="D"),
        "A B . . a / . . . . C",
        Play("A> B>", ". . . . a / . . . . C", fault="teammate AB"),
    ),
    case(
        "the cell of one that crashed is free in the next turn",
        rules(AGENT, obstacle="D", teammate="B"),
        "# A B . . a",
        Play("A< B<", "# B . . . a", involved="obstacle A"),
    ),
    case(
        "an evader is caught before its turn comes",
        "TO",
        "A a . b",
        Play("A> a>", ". A . b", captured="a", involved="adversary Aa"),
    ),
    case(
        "later turns of a terminated world are not played",
        "TO",
        "A a . B",
        Play("A> B<", ". A . B", captured="a", captors="a1", ended=True),
    ),
    case(
        "R, R: sharing a cell is a capture also in the turn of a third",
        rules(AGENT, adversary="RR", capture="occupation"),
        "A a . b",
        Play("A>", ". Aa . b", captured="a", captors="a1"),
    ),
    case(
        "an evader between turns: it walks away from the second pursuer",
        "TO",
        "A . a B .",
        Play("A> B> a<", ". A . . B", captured="a", captors="a1", ended=True),
    ),
)


@table(*AGENT_TURNS)
def test_agent_turns(start: Start, case: Case) -> None:
    check(start, case)


REWARDS = (
    case(
        "neighbours count after one's own turn",
        rules(SWARM),
        "A . a . .",
        Play("A> a>", ". A . a .", paid="A: neighbor step; a: step"),
    ),
    case(
        "step is paid to one that dies in its turn, not to one whose turn does not come",
        rules(AGENT, adversary="DD", capture="occupation"),
        "A a . b B",
        Play(
            "A> a> B< b>",
            ". . . . .",
            captured="ab",
            paid="A: capture step; a: capture; B: capture step; b: capture",
            ended=True,
        ),
    ),
    case(
        "a terminated round pays no step for the turns that are not played",
        "TO",
        "A a . B",
        Play("A> B<", ". A . B", captured="a", paid="A: capture step; a: capture", ended=True),
    ),
    case(
        "collide is paid once for a kind and a round",
        rules(AGENT, teammate="B"),
        "B A C . . a",
        Play(
            "B> C<",
            "B A C . . a",
            fault="teammate ABC",
            paid="A: collide step; B: collide step; C: collide step; a: step",
        ),
    ),
    case(
        "a capture is paid at the first turn in which it is one",
        rules(SWARM, adversary="RR", capture="occupation"),
        "A a . b",
        Play(
            "A> a>", ". A a b", ever="a", paid="A: capture step; a: capture neighbor step; b: step"
        ),
    ),
)


@table(*REWARDS)
def test_rewards_under_turns(start: Start, case: Case) -> None:
    check(start, case)


@pytest.mark.parametrize("rewards", [UNITS, REPEATS], ids=["once", "repeats"])
def test_a_capture_that_lasts_over_two_turns_is_paid_once_a_round(start: Start, rewards) -> None:
    play = Play(
        "A< a>",
        "a A . . / B . . b",
        captured="a",
        paid="A: capture neighbor step; B: capture neighbor step;"
        "a: capture neighbor collide step; b: step",
    )
    check(start, case("", rules(SWARM), "a . A . / B . . b", play, rewards=rewards))
