"""Figures of the game show what the engine does, and the rules that it plays."""

import numpy as np

import matrixworld as mw
from course.figures import CROSSINGS, MOVES, SITUATIONS, may_go, moves_of, world_of
from right_of_way import from_the_right


def test_the_situations_are_of_the_forms_and_kinds_that_they_name() -> None:
    """In each named conflict the engine finds this form or kind, and in the others none."""
    found = {}
    for situation in SITUATIONS:
        world = world_of(situation, mw.Outcome.BOUNCE)
        world.step(moves_of(situation), explain=True)
        found[situation.name] = {(each.kind, each.form) for each in world.conflicts}
    assert found == {
        "vertex": {("teammate", "vertex")},
        "edge": {("teammate", "edge")},
        "following": set(),
        "cycle": set(),
        "blocked": {("obstacle", "vertex"), ("teammate", "vertex")},
        "obstacle": {("obstacle", "vertex")},
        "adversary": {("adversary", "vertex")},
    }


def test_those_go_first_who_come_from_the_right() -> None:
    for *_, moves in CROSSINGS:
        steps = {move: tuple(MOVES[move]) for move in moves}

        def first(one: int, other: int, steps=steps) -> bool:
            faces = np.add(steps[one], steps[other]).any() == 0
            return one < other if faces else from_the_right(steps[other], steps[one])

        assert may_go(moves) == [all(first(m, o) for o in moves if o != m) for m in moves]
