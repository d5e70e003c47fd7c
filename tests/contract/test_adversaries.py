"""Stage 3, case by case: collisions of a pursuer and an evader.

Each case is written by hand from the rules and is played in the compiled world and in the slow
one.  ``S`` has teammates that reach and evaders that bounce off pursuers; see ``drawing.py``.
"""

from __future__ import annotations

from drawing import Case, Play, Start, case, check, conflict, rules, table

# Both outcomes (evader, pursuer) -> the first row afterwards, who is held, and who is at fault
# when nobody is held and capture is by surrounding: whoever was moving.
MEETINGS = {
    ("both head for one cell", "A . a", "A> a<", "vertex", (0, 1)): """
        DD  . . .     -   Aa
        DR  . A .     -   Aa
        DB  A . .     A   A
        RD  . a .     -   Aa
        RR  . Aa .    -   Aa
        RB  A a .     A   A
        BD  . . a     a   a
        BR  . A a     a   a
        BB  A . a     Aa  Aa
    """,
    ("the pursuer enters", "A a .", "A>", "vertex", (0, 1)): """
        DD  . . .     -   A
        DR  . A .     -   A
        DB  A . .     A   A
        RD  . a .     -   A
        RR  . Aa .    -   A
        RB  A a .     A   A
        BD  . a .     -   A
        BR  A a .     A   A
        BB  A a .     A   A
    """,
    ("the evader enters", "A a .", "a<", "vertex", (0, 0)): """
        DD  . . .     -   a
        DR  A . .     -   a
        DB  A . .     -   a
        RD  a . .     -   a
        RR  Aa . .    -   a
        RB  A a .     a   a
        BD  . a .     a   a
        BR  A a .     a   a
        BB  A a .     a   a
    """,
    ("they swap", "A a .", "A> a<", "edge", (0, 1)): """
        DD  . . .     -   Aa
        DR  . A .     -   Aa
        DB  A . .     A   A
        RD  a . .     -   Aa
        RR  a A .     -   Aa
        RB  A a .     Aa  Aa
        BD  . a .     a   a
        BR  A a .     Aa  Aa
        BB  A a .     Aa  Aa
    """,
}


def meeting_cases() -> list[Case]:
    """Each row of the tables under both kinds of capture, with two bystanders."""
    cases = []
    for (name, before, moves, form, cell), rows in MEETINGS.items():
        for row in rows.strip().splitlines():
            adversary, *after, held, mover = row.replace("-", "nobody").split()
            held = held.replace("nobody", "")
            died = "".join(who for who, how in zip("aA", adversary, strict=True) if how == "D")
            for capture in ("surround", "occupation"):
                by_contact = capture == "occupation" and adversary in ("DD", "DR", "DB", "RR")
                fault = mover if capture == "surround" else held
                met = conflict(
                    f"adversary {form}",
                    "Aa",
                    cell,
                    held=held,
                    doomed="".join(sorted(died)),
                    fault=fault,
                )
                play = Play(
                    moves,
                    f"{' '.join(after)} . b / . . . . . / . . . . B",
                    captured="a" if by_contact else "",
                    captors="a1" if by_contact else "",
                    involved="adversary Aa",
                    fault=f"adversary {fault}" if fault else "",
                    conflicts=[met],
                )
                row_of_rules = rules(adversary=adversary, capture=capture)
                title = f"{adversary} {capture}: {name}"
                start_of_it = f"{before} . b / . . . . . / . . . . B"
                cases.append(case(title, row_of_rules, start_of_it, play))
    return cases


@table(*meeting_cases())
def test_adversaries_meet(start: Start, case: Case) -> None:
    check(start, case)


ADVERSARIES_AMONG_OTHERS = (
    case(
        "the evader was held by a wall: it is not touched",
        "S",
        "A a # / . . .",
        Play("A> a>", "A a # / . . .", fault="obstacle a; adversary A"),
    ),
    case(
        "an evader between a wall and two pursuers",
        "S",
        "A a # / . B .",
        Play(
            "A> a> B^",
            "A a # / . B .",
            captured="a",
            captors="a2",
            fault="obstacle a; teammate AB; adversary AB",
            ended=True,
        ),
    ),
    case(
        "the two pursuers stop each other before they meet the evader",
        "SB",
        "A a # / . B .",
        Play(
            "A> a> B^",
            "A a # / . B .",
            captured="a",
            captors="a2",
            fault="obstacle a; teammate AB",
            ended=True,
        ),
    ),
    case(
        "a contest lost among teammates stays lost: the evader gets the cell",
        "SB",
        "A . a / . B .",
        Play("A> B^ a<", "A a . / . B .", involved="teammate AB"),
    ),
    case(
        "two pursuers and an evader head for one cell",
        "S",
        "A . B . / . a . .",
        Play("A> B< a^", ". AB . . / . a . .", fault="teammate AB; adversary a"),
    ),
    case(
        "two evaders and a pursuer head for one cell",
        "S",
        "a . b . / . A . .",
        Play("a> b< A^", "a A b . / . . . .", fault="teammate ab; adversary ab"),
    ),
    case(
        "the two evaders stop each other before they meet the pursuer",
        "SB",
        "a . b . / . A . .",
        Play("a> b< A^", "a A b . / . . . .", involved="teammate ab"),
    ),
    case(
        "an evader enters the cell of one that is caught in the same step",
        "O",
        "A a b . . c",
        Play("A> b<", ". A . . . c", captured="ab", captors="a1 b1", fault="teammate ab"),
    ),
    case(
        "a teammate kept it out of that cell before",
        rules(teammate="B", adversary="DR", capture="occupation"),
        "A a b . . c",
        Play("A> b<", ". A b . . c", captured="a", fault="teammate ab"),
    ),
    case(
        "it enters the cell that the caught one had left",
        "O",
        "A . a b . . c",
        Play("A> a< b<", ". A b . . . c", captured="a", involved="adversary Aa"),
    ),
    case(
        "it enters the cell of one that is caught in a swap",
        "O",
        "A a b . . c",
        Play(
            "A> a< b<",
            ". A . . . c",
            captured="ab",
            fault="",
            conflicts=[
                conflict("adversary edge", "Aa", (0, 1), doomed="a"),
                conflict("adversary vertex", "Ab", (0, 1), doomed="b"),
            ],
        ),
    ),
)


@table(*ADVERSARIES_AMONG_OTHERS)
def test_adversaries_among_others(start: Start, case: Case) -> None:
    check(start, case)
