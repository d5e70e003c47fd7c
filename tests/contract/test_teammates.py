"""Stage 2, case by case: collisions of teammates, and the queues behind them.

Each case is written by hand from the rules and is played in the compiled world and in the slow
one.  ``S`` has teammates that reach and evaders that bounce off pursuers; see ``drawing.py``.
"""

from __future__ import annotations

from drawing import Case, Play, Start, case, check, conflict, rules, table

TEAMMATES = (
    case(
        "R: they meet, stand together in conflict, and part",
        "S",
        "A . B . . a",
        Play(
            "A> B<",
            ". AB . . . a",
            fault="teammate AB",
            conflicts=[conflict("teammate vertex", "AB", (0, 1), fault="AB")],
        ),
        Play(
            "",
            ". AB . . . a",
            fault="teammate AB",
            conflicts=[conflict("teammate vertex", "AB", (0, 1), fault="AB")],
        ),
        Play("A<", "A B . . . a", involved="", conflicts=[]),
    ),
    case(
        "R: they swap",
        "S",
        "A B . . a",
        Play(
            "A> B<",
            "B A . . a",
            fault="teammate AB",
            conflicts=[conflict("teammate edge", "AB", (0, 1), fault="AB")],
        ),
    ),
    case(
        "R: one enters, the one that stood still is at fault too",
        "S",
        "A B . . a",
        Play("A>", ". AB . . a", fault="teammate AB"),
    ),
    case(
        "D: they meet",
        rules(teammate="D"),
        "a . b . c / . . . A .",
        Play(
            "a> b<",
            ". . . . c / . . . A .",
            fault="teammate ab",
            conflicts=[conflict("teammate vertex", "ab", (0, 1), doomed="ab", fault="ab")],
        ),
    ),
    case(
        "D: they swap",
        rules(teammate="D"),
        "a b . . c / . . . A .",
        Play("a> b<", ". . . . c / . . . A .", fault="teammate ab"),
    ),
    case(
        "D: one enters, both die",
        rules(teammate="D"),
        "a b . . c / . . . A .",
        Play("a>", ". . . . c / . . . A .", fault="teammate ab"),
    ),
    case(
        "B: they head for one cell",
        "SB",
        "A . B . . a",
        Play(
            "A> B<",
            "A . B . . a",
            fault="teammate AB",
            conflicts=[conflict("teammate vertex", "AB", (0, 1), held="AB", fault="AB")],
        ),
    ),
    case(
        "B: they would swap",
        "SB",
        "A B . . a",
        Play(
            "A> B<",
            "A B . . a",
            fault="teammate AB",
            conflicts=[conflict("teammate edge", "AB", (0, 1), held="AB", fault="AB")],
        ),
    ),
    case(
        "B: one enters, the other was staying and is not held",
        "SB",
        "A B . . a",
        Play(
            "A>",
            "A B . . a",
            fault="teammate AB",
            conflicts=[conflict("teammate vertex", "AB", (0, 1), held="A", fault="AB")],
        ),
    ),
    case(
        "B: three head for one cell",
        "SB",
        "A . B . a / . C . . .",
        Play(
            "A> B< C^",
            "A . B . a / . C . . .",
            fault="teammate ABC",
            conflicts=[
                conflict("teammate vertex", "AB", (0, 1), held="AB", fault="AB"),
                conflict("teammate vertex", "AC", (0, 1), held="AC", fault="AC"),
                conflict("teammate vertex", "BC", (0, 1), held="BC", fault="BC"),
            ],
        ),
    ),
    case(
        "R: three in one cell",
        "S",
        "A . B . a / . C . . .",
        Play("A> B< C^", ". ABC . . a / . . . . .", fault="teammate ABC"),
    ),
    case(
        "D: three in one cell",
        rules(teammate="D"),
        "A . B . a / . C . . D",
        Play("A> B< C^", ". . . . a / . . . . D", fault="teammate ABC"),
    ),
    case(
        "R: nobody queues",
        "S",
        "A B C D . . a",
        Play("A> B> C>", ". A B CD . . a", fault="teammate CD"),
    ),
    case(
        "two swap and a third follows one of them",
        "SB",
        "A B . . . a / C . . . . .",
        Play("A> B< C^", "A B . . . a / C . . . . .", fault="teammate ABC"),
    ),
)


@table(*TEAMMATES)
def test_teammates(start: Start, case: Case) -> None:
    check(start, case)


QUEUES_OF_TEAMMATES = (
    case(
        "behind one who stands still",
        "SB",
        "A B C D . . a",
        Play(
            "A> B> C>",
            "A B C D . . a",
            fault="teammate ABCD",
            conflicts=[
                conflict("teammate vertex", "CD", (0, 3), held="C", fault="CD"),
                conflict("teammate chain", "BC", (0, 2), held="B", fault="BC"),
                conflict("teammate chain", "AB", (0, 1), held="A", fault="AB"),
            ],
        ),
    ),
    case(
        "the same with the indices turned round",
        "SB",
        "D C B A . . a",
        Play(
            "D> C> B>",
            "D C B A . . a",
            fault="teammate ABCD",
            conflicts=[
                conflict("teammate vertex", "AB", (0, 3), held="B", fault="AB"),
                conflict("teammate chain", "CB", (0, 2), held="C", fault="BC"),
                conflict("teammate chain", "DC", (0, 1), held="D", fault="CD"),
            ],
        ),
    ),
    case(
        "behind two who meet",
        "SB",
        "A B . C . . a",
        Play("A> B> C<", "A B . C . . a", fault="teammate ABC"),
    ),
    case(
        "behind one whom an obstacle stopped",
        "SB",
        "# A B C . . a",
        Play("A< B< C<", "# A B C . . a", fault="obstacle A; teammate ABC"),
    ),
    case(
        "a ring of which one cell is contested",
        "SB",
        "A B . / D C E / . . a",
        Play("A> Bv C< D^ E<", "A B . / D C E / . . a", fault="teammate ABCDE"),
    ),
    case(
        "evaders queue as well",
        "SB",
        "a b # . A",
        Play("a> b>", "a b # . A", fault="obstacle b; teammate ab"),
    ),
)


@table(*QUEUES_OF_TEAMMATES)
def test_queues_of_teammates(start: Start, case: Case) -> None:
    check(start, case)


DOOMED_COUNT_UNTIL_THE_END = (
    case(
        "doomed pursuers hold an evader",
        rules(teammate="D"),
        "A . B . / . a . C",
        Play(
            "A> B< a^",
            ". . . . / . a . C",
            fault="teammate AB; adversary a",
            conflicts=[
                conflict("teammate vertex", "AB", (0, 1), doomed="AB", fault="AB"),
                conflict("adversary vertex", "Aa", (0, 1), held="a", fault="a"),
                conflict("adversary vertex", "Ba", (0, 1), held="a", fault="a"),
            ],
        ),
    ),
    case(
        "doomed evaders hold a pursuer, and one of them is held by it",
        rules(teammate="D"),
        "A a b . . c",
        Play(
            "A> b<",
            "A . . . . c",
            fault="teammate ab; adversary Ab",
            conflicts=[
                conflict("teammate vertex", "ab", (0, 1), doomed="ab", fault="ab"),
                conflict("adversary vertex", "Aa", (0, 1), held="A", fault="A"),
                conflict("adversary vertex", "Ab", (0, 1), held="b", fault="b"),
            ],
        ),
    ),
    case(
        "one that is doomed leaves its cell",
        "O",
        "b a . A . c",
        Play("a> A< b>", ". b A . . c", captured="a", fault=""),
    ),
)


@table(*DOOMED_COUNT_UNTIL_THE_END)
def test_doomed_count_until_the_end(start: Start, case: Case) -> None:
    check(start, case)
