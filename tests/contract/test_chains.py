"""Stage 4, case by case: what becomes of those who enter the cell of one held by an adversary.

Each case is written by hand from the rules and is played in the compiled world and in the slow
one.  ``S`` has teammates that reach and evaders that bounce off pursuers; see ``drawing.py``.
"""

from __future__ import annotations

from drawing import Case, Play, Start, case, check, conflict, rules, table

TEAMMATES_BEHIND_A_LINK = (
    case(
        "B: a pursuer behind one that an evader stopped",
        "SB",
        "A B a . / . . . .",
        Play(
            "A> B>",
            "A B a . / . . . .",
            fault="teammate AB; adversary B",
            conflicts=[
                conflict("adversary vertex", "Ba", (0, 2), held="B", fault="B"),
                conflict("teammate chain", "AB", (0, 1), held="A", fault="AB"),
            ],
        ),
    ),
    case(
        "B: the same with the indices turned round",
        "SB",
        "B A a . / . . . .",
        Play(
            "A> B>",
            "B A a . / . . . .",
            fault="teammate AB; adversary A",
            conflicts=[
                conflict("adversary vertex", "Aa", (0, 2), held="A", fault="A"),
                conflict("teammate chain", "BA", (0, 1), held="B", fault="AB"),
            ],
        ),
    ),
    case(
        "R: it goes on and shares the cell",
        "S",
        "A B a . / . . . .",
        Play(
            "A> B>",
            ". AB a . / . . . .",
            fault="teammate AB; adversary B",
            conflicts=[
                conflict("adversary vertex", "Ba", (0, 2), held="B", fault="B"),
                conflict("teammate chain", "AB", (0, 1), fault="AB"),
            ],
        ),
    ),
    case(
        "D: both die",
        rules(teammate="D"),
        "A B a . / . . . C",
        Play(
            "A> B>",
            ". . a . / . . . C",
            fault="teammate AB; adversary B",
            conflicts=[
                conflict("adversary vertex", "Ba", (0, 2), held="B", fault="B"),
                conflict("teammate chain", "AB", (0, 1), doomed="AB", fault="AB"),
            ],
        ),
    ),
    case(
        "B: an evader behind one that a pursuer stopped",
        "SB",
        "A . a b . .",
        Play("A> a< b<", ". A a b . .", fault="teammate ab; adversary a"),
    ),
    case(
        "R: an evader shares the cell of one that a pursuer stopped",
        "S",
        "A . a b . .",
        Play("A> a< b<", ". A ab . . .", fault="teammate ab; adversary a"),
    ),
    case(
        "D: evaders die, uncaptured",
        rules(teammate="D"),
        "A . a b . . c",
        Play("A> a< b<", ". A . . . . c", ever="", fault="teammate ab; adversary a"),
    ),
    case(
        "B: a long queue",
        "SB",
        "A B C D a . / . . . . . .",
        Play("A> B> C> D>", "A B C D a . / . . . . . .", fault="teammate ABCD; adversary D"),
    ),
)


@table(*TEAMMATES_BEHIND_A_LINK)
def test_teammates_behind_a_link(start: Start, case: Case) -> None:
    check(start, case)


ADVERSARIES_BEHIND_A_LINK = (
    case(
        "B, R: a pursuer behind an evader",
        "S",
        "A a B . / . . . .",
        Play(
            "A> a>",
            "A a B . / . . . .",
            fault="adversary Aa",
            conflicts=[
                conflict("adversary vertex", "Ba", (0, 2), held="a", fault="a"),
                conflict("adversary chain", "Aa", (0, 1), held="A", fault="A"),
            ],
        ),
    ),
    case(
        "B, R: an evader behind a pursuer",
        "S",
        "a A b . / . . . .",
        Play(
            "a> A>",
            "a A b . / . . . .",
            fault="adversary Aa",
            conflicts=[
                conflict("adversary vertex", "Ab", (0, 2), held="A", fault="A"),
                conflict("adversary chain", "aA", (0, 1), held="a", fault="a"),
            ],
        ),
    ),
    case(
        "B, R: pursuer, evader, pursuer, evader",
        "S",
        "B a A b . / . . . . .",
        Play(
            "B> a> A>",
            "B a A b . / . . . . .",
            fault="adversary ABa",
            conflicts=[
                conflict("adversary vertex", "Ab", (0, 3), held="A", fault="A"),
                conflict("adversary chain", "aA", (0, 2), held="a", fault="a"),
                conflict("adversary chain", "Ba", (0, 1), held="B", fault="B"),
            ],
        ),
    ),
    case(
        "D, B: an evader is captured by entering the cell of a pursuer that was stopped",
        rules(adversary="DB", capture="occupation"),
        "a A . b . c",
        Play(
            "a> A> b<",
            ". A . . . c",
            captured="ab",
            captors="a1 b1",
            fault="adversary A",
            conflicts=[
                conflict("adversary vertex", "Ab", (0, 2), held="A", doomed="b", fault="A"),
                conflict("adversary chain", "aA", (0, 1), doomed="a"),
            ],
        ),
    ),
    case(
        "R, B: an evader behind a pursuer",
        rules(adversary="RB"),
        "a A b . / . . . .",
        Play("a> A>", "a A b . / . . . .", fault="adversary Aa"),
    ),
    case(
        "B, B: an evader behind a pursuer",
        rules(adversary="BB"),
        "a A b . / . . . .",
        Play("a> A>", "a A b . / . . . .", fault="adversary Aa"),
    ),
    case(
        "B, D: a pursuer dies by entering the cell of an evader that was stopped",
        rules(adversary="BD"),
        "B a . A . . / . . . . C .",
        Play(
            "B> a> A<",
            ". a . . . . / . . . . C .",
            fault="adversary Ba",
            conflicts=[
                conflict("adversary vertex", "Aa", (0, 2), held="a", doomed="A", fault="a"),
                conflict("adversary chain", "Ba", (0, 1), doomed="B", fault="B"),
            ],
        ),
    ),
    case(
        "a queue of both teams: each pair by the outcome of its kind",
        "SB",
        "A B a C . / . . . . .",
        Play(
            "A> B> a>",
            "A B a C . / . . . . .",
            fault="teammate AB; adversary Ba",
            conflicts=[
                conflict("adversary vertex", "Ca", (0, 3), held="a", fault="a"),
                conflict("adversary chain", "Ba", (0, 2), held="B", fault="B"),
                conflict("teammate chain", "AB", (0, 1), held="A", fault="AB"),
            ],
        ),
    ),
)


@table(*ADVERSARIES_BEHIND_A_LINK)
def test_adversaries_behind_a_link(start: Start, case: Case) -> None:
    check(start, case)


PAIRS = (
    case(
        "a pair that was in conflict before is not judged again",
        rules(adversary="RB"),
        "a A B . / . . . .",
        Play(
            "a> A> B<",
            ". a AB . / . . . .",
            fault="teammate AB; adversary B",
            conflicts=[
                conflict("teammate edge", "AB", (0, 2), fault="AB"),
                conflict("adversary vertex", "Ba", (0, 1), held="B", fault="B"),
            ],
        ),
    ),
    case(
        "one enters the cell of two links: both pairs count",
        "S",
        "A a . b B . . / . . . . . . .",
        Play("A> a> b< B<", ". A ab B . . . / . . . . . . .", fault="teammate ab"),
        Play(
            "A> a> b>",
            ". A ab B . . . / . . . . . . .",
            fault="teammate ab; adversary Aab",
            conflicts=[
                conflict("teammate vertex", "ab", (0, 3), fault="ab"),
                conflict("adversary vertex", "Ba", (0, 3), held="a", fault="a"),
                conflict("adversary vertex", "Bb", (0, 3), held="b", fault="b"),
                conflict("adversary chain", "Aa", (0, 2), held="A", fault="A"),
                conflict("adversary chain", "Ab", (0, 2), held="A", fault="A"),
            ],
        ),
    ),
    case(
        "a pair counts also when the one that enters became a link before",
        "S",
        ". B C . . / A a b c . / . . . . .",
        Play("b< Cv", ". B . . . / A ab C c . / . . . . .", fault="teammate ab"),
        Play(
            "A> a^ b> C>",
            ". B . . . / A ab C c . / . . . . .",
            fault="adversary ACab",
            conflicts=[
                conflict("adversary vertex", "Ba", (0, 1), held="a", fault="a"),
                conflict("adversary vertex", "Cc", (1, 3), held="C", fault="C"),
                conflict("adversary chain", "bC", (1, 2), held="b", fault="b"),
                conflict("adversary chain", "Aa", (1, 1), held="A", fault="A"),
                conflict("adversary chain", "Ab", (1, 1), held="A", fault="A"),
            ],
        ),
    ),
    case(
        "links that share a cell are not in conflict with each other",
        "S",
        "A a . b B . . / . . . . . . .",
        Play("A> a> b< B<", ". A ab B . . . / . . . . . . ."),
        Play(
            "a< b>",
            ". A ab B . . . / . . . . . . .",
            involved="adversary ABab",
            conflicts=[
                conflict("adversary vertex", "Aa", (0, 1), held="a", fault="a"),
                conflict("adversary vertex", "Bb", (0, 3), held="b", fault="b"),
            ],
        ),
    ),
    case(
        "a contest lost in stage 3 stays lost when the winner is held in stage 4",
        "S",
        "A b B . / . a . .",
        Play(
            "A> b> a^",
            "A b B . / . a . .",
            fault="adversary Aab",
            conflicts=[
                conflict("adversary vertex", "Aa", (0, 1), held="a", fault="a"),
                conflict("adversary vertex", "Bb", (0, 2), held="b", fault="b"),
                conflict("adversary chain", "Ab", (0, 1), held="A", fault="A"),
            ],
        ),
    ),
)


@table(*PAIRS)
def test_pairs(start: Start, case: Case) -> None:
    check(start, case)
