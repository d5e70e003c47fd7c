"""Who is captured, by whom, and when an episode ends, case by case.

Each case is written by hand from the rules and is played in the compiled world and in the slow
one.  ``S`` captures by surrounding, ``O`` and ``R`` by occupation; see ``drawing.py``.
"""

from __future__ import annotations

import warnings
from itertools import product
from pathlib import Path

import pytest

import matrixworld as mw
from drawing import Case, Play, Start, begin, case, check, rules, table

OCCUPATION = (
    case("on one cell", "O", "A . a . b", Play("A> a<", ". A . . b", captured="a", captors="a1")),
    case("in a swap", "O", "A a . b", Play("A> a<", ". A . b", captured="a", captors="a1")),
    case(
        "by two",
        "O",
        "A . B . b / . a . . .",
        Play(
            "A> B< a^",
            ". AB . . b / . . . . .",
            captured="a",
            captors="a2",
            fault="teammate AB",
            involved="teammate AB; adversary ABa",
        ),
    ),
    case(
        "by two that die of it",
        "D",
        "A a B . b / . . C . .",
        Play("A> B<", ". . . . b / . . C . .", captured="a", captors="a2", fault="teammate AB"),
    ),
    case(
        "one pursuer captures two",
        "O",
        "a . b . c / . A . . .",
        Play("a> b< A^", ". A . . c / . . . . .", captured="ab", captors="a1 b1"),
    ),
    case(
        "R, R: as long as they share a cell",
        "R",
        "A a . b",
        Play("A>", ". Aa . b", captured="a", captors="a1", fault=""),
        Play("", ". Aa . b", captured="a", captors="a1", fault=""),
        Play("a>", ". A a b", captured="", ever="a", captors="", fault=""),
    ),
    case("R, R: in a swap", "R", "A a . b", Play("A> a<", "a A . b", captured="a", captors="a1")),
    case(
        "R, R: doomed by a teammate in the same step",
        rules(teammate="D", adversary="RR", capture="occupation"),
        "A a b . . c",
        Play("A> b<", ". A . . . c", captured="ab", captors="a1 b1", fault="teammate ab"),
    ),
    case(
        "R, R: the captor is doomed by a teammate in the same step",
        rules(teammate="D", adversary="RR", capture="occupation"),
        "A a B . b / . . C . .",
        Play("A> B<", ". a . . b / . . C . .", captured="a", captors="a2", fault="teammate AB"),
    ),
    case(
        "no captor: an evader that crashes",
        rules(obstacle="D", adversary="DR", capture="occupation"),
        "A a # b",
        Play("A> a>", ". A # b", ever="", fault="obstacle a"),
    ),
    case(
        "no captor: evaders that die of each other",
        "D",
        "a b . c . A",
        Play("a>", ". . . c . A", ever="", captors="", fault="teammate ab"),
    ),
    case(
        "evaders that die of each other, and a pursuer meets them",
        rules(teammate="D", adversary="DR", capture="occupation"),
        "A a b . . c",
        Play("A> b<", ". A . . . c", captured="ab", captors="a1 b1"),
    ),
    case(
        "captured_disappear is not read",
        rules(adversary="RR", capture="occupation", disappear=True),
        "A a . b",
        Play("A>", ". Aa . b", captured="a"),
    ),
)


@table(*OCCUPATION)
def test_occupation(start: Start, case: Case) -> None:
    check(start, case)


SURROUND = (
    case(
        "in the open",
        "S",
        ". A . / B a C / . D .",
        Play("", ". A . / B a C / . D .", captured="a", captors="a4", ended=True),
    ),
    case("a way out", "S", ". A . / B a C / . . .", Play("", ". A . / B a C / . . .", captors="")),
    case(
        "in a corner",
        "S",
        "a A / B .",
        Play("", "a A / B .", captured="a", captors="a2", ended=True),
    ),
    case(
        "at the border",
        "S",
        "A a B / . C .",
        Play("", "A a B / . C .", captured="a", captors="a3", ended=True),
    ),
    case(
        "by closing the last gap",
        "S",
        "A a . B / . C . .",
        Play("B<", "A a B . / . C . .", captured="a", captors="a3", ended=True),
    ),
    case(
        "between obstacles",
        "S",
        "# a # / . A .",
        Play("", "# a # / . A .", captured="a", captors="a1", ended=True),
    ),
    case("obstacles alone", "S", "# a # / . # . / . . A", Play("", "# a # / . # . / . . A")),
    case("evaders do not count", "S", ". A . / B a b / . C .", Play("", ". A . / B a b / . C .")),
    case(
        "a pursuer on the evader's own cell does not count: a gap",
        rules(adversary="RR"),
        "a A / B .",
        Play("A<", "Aa . / B ."),
    ),
    case(
        "a pursuer on the evader's own cell does not count: no captor",
        rules(adversary="RR"),
        "a A / B C",
        Play("A< C^", "Aa C / B .", captured="a", captors="a2", ended=True),
    ),
    case(
        "a pursuer on the cell of an obstacle counts",
        rules(obstacle="R"),
        "a # A / # . .",
        Play("A<", "a #A . / # . .", captured="a", captors="a1", ended=True),
    ),
    case(
        "all on one cell are captors",
        "S",
        "a A C / B . .",
        Play("C<", "a AC . / B . .", captured="a", captors="a3", ended=True),
    ),
    case(
        "diagonal: four are not enough",
        "S",
        ". A . / B a C / . D .",
        Play("", ". A . / B a C / . D ."),
        diagonal=True,
    ),
    case(
        "diagonal: eight are",
        "S",
        "E A F / B a C / G D H",
        Play("", "E A F / B a C / G D H", captured="a", captors="a8", ended=True),
        diagonal=True,
    ),
    case(
        "diagonal: in a corner",
        "S",
        "a A / B C",
        Play("", "a A / B C", captured="a", captors="a3", ended=True),
        diagonal=True,
    ),
    case("diagonal: a way out", "S", "a A / B .", Play("", "a A / B ."), diagonal=True),
    case(
        "the doomed are removed before",
        rules(teammate="D"),
        "a A C / B . .",
        Play("C<", "a . . / B . ."),
    ),
    case(
        "a doomed evader is not captured",
        rules(teammate="D"),
        "a b A . / B . . c",
        Play("b< A<", ". A . . / B . . c", ever="", captors=""),
    ),
    case(
        "one that an adversary kills is not captured",
        rules(adversary="DR"),
        "A a . b",
        Play("A>", ". A . b", ever="", fault="adversary A"),
    ),
    case(
        "as long as it lasts",
        "S",
        "a A . . / B . . . / . . . b",
        Play("", "a A . . / B . . . / . . . b", captured="a"),
        Play("", "a A . . / B . . . / . . . b", captured="a"),
        Play("A>", "a . A . / B . . . / . . . b", captured="", ever="a", captors=""),
    ),
    case(
        "disappears",
        "SD",
        "a A . . / B . . . / . . . b",
        Play("", ". A . . / B . . . / . . . b", captured="a", captors="a2"),
        Play("A<", "A . . . / B . . . / . . . b", captured="a", captors=""),
    ),
    case(
        "two at once, by one pursuer between them",
        "SD",
        "a A b / B . C / . . . / . . c",
        Play("", ". A . / B . C / . . . / . . c", captured="ab", captors="a2 b2"),
    ),
)


@table(*SURROUND)
def test_surround(start: Start, case: Case) -> None:
    check(start, case)


TERMINATION = (
    case("all evaders are gone", "O", "A a . .", Play("A>", ". A . .", captured="a", ended=True)),
    case(
        "all are gone or captured",
        rules(obstacle="D"),
        "a A . b / B . . .",
        Play("b^", "a A . . / B . . .", captured="a", ended=True),
    ),
    case(
        "occupation: each has been captured, one is free again",
        "R",
        "A a . . . b B",
        Play("A>", ". Aa . . . b B", captured="a"),
        Play("a> B<", ". A a . . Bb .", captured="b", ever="ab", ended=True),
    ),
    case(
        "surround: each has been captured, but one is free again",
        "S",
        "a A . b / B . C .",
        Play("", "a A . b / B . C .", captured="a"),
        Play("A> C>", "a . A b / B . . C", captured="b", ever="ab", ended=False),
    ),
    case("no pursuer is left", rules(obstacle="D"), "A # . a", Play("A>", ". # . a", ended=True)),
    case("nobody is left", "D", "A . a", Play("A> a<", ". . .", captured="a", ended=True)),
)


@table(*TERMINATION)
def test_termination(start: Start, case: Case) -> None:
    check(start, case)


def test_truncation(start: Start) -> None:
    world, _ = begin(start, case("", "O", "A . . a", max_steps=2))
    seen = []
    for _ in range(2):
        world.step([0, 0])
        seen.append((int(world.steps), bool(world.truncated), bool(world.terminated)))
    assert seen == [(1, False, False), (2, True, False)]
    with pytest.raises(RuntimeError):
        world.step([0, 0])


def test_a_terminated_world_does_not_step(start: Start) -> None:
    world, _ = begin(start, case("", "O", "A a"))
    world.step([2, 0])
    assert world.terminated
    with pytest.raises(RuntimeError):
        world.step([0, 0])


S, T, D, R, B = "simultaneous", "agent turns", "D", "R", "B"


@pytest.mark.parametrize(
    ("name", "row"),
    {
        "D": rules(S, obstacle=D, teammate=D, adversary=D + D, capture="occupation"),
        "R": rules(S, obstacle=B, teammate=R, adversary=R + R, capture="occupation"),
        "B": rules(S, obstacle=B, teammate=B, adversary=R + R, capture="occupation"),
        "O": rules(S, obstacle=B, teammate=R, adversary=D + R, capture="occupation"),
        "S": rules(S, obstacle=B, teammate=R, adversary=B + R, capture="surround"),
        "SB": rules(S, obstacle=B, teammate=B, adversary=B + R, capture="surround"),
        "SD": rules(S, teammate=R, adversary=B + R, capture="surround", disappear=True),
        "SDB": rules(S, teammate=B, adversary=B + R, capture="surround", disappear=True),
        "TO": rules(T, obstacle=B, teammate=R, adversary=D + R, capture="occupation"),
    }.items(),
)
def test_the_nine_variants_of_the_paper(name: str, row: mw.Rules) -> None:
    assert mw.VARIANTS[name] == row


@pytest.mark.parametrize("adversary", ["".join(pair) for pair in product("DRB", repeat=2)])
@pytest.mark.parametrize("capture", ["occupation", "surround"])
def test_a_row_that_captures_nobody_warns(adversary: str, capture: str) -> None:
    can_capture = capture == "surround" or adversary in ("DD", "DR", "DB", "RR")
    with warnings.catch_warnings(record=True) as seen:
        warnings.simplefilter("always")
        mw.WorldConfig(rules(adversary=adversary, capture=capture))
    assert bool(seen) != can_capture
    for warning in seen:
        assert "never capture" in str(warning.message)
        assert Path(warning.filename) == Path(__file__)  # the line that made the configuration
