"""Figures of the game show what the engine does, and the rules that it plays."""

import numpy as np
from matplotlib.patches import Circle, RegularPolygon

import matrixworld as mw
from course import figures
from course.figures import CROSSINGS, MOVES, PER_TEAM, SITUATIONS, may_go, resolve, turns_of
from matrixworld.world.rules import OUTCOME_TEXTS
from right_of_way import from_the_right


def test_the_situations_are_of_the_forms_and_kinds_that_they_name() -> None:
    """In each named conflict the engine finds this form or kind, and in the others none."""
    found = {
        situation.name: {
            (each.kind, each.form) for each in resolve(situation, mw.Outcome.BOUNCE).conflicts
        }
        for situation in SITUATIONS
    }
    assert found == {
        "vertex": {("teammate", "vertex")},
        "edge": {("teammate", "edge")},
        "following": set(),
        "cycle": set(),
        "blocked": {("obstacle", "vertex"), ("teammate", "vertex")},
        "obstacle": {("obstacle", "vertex")},
        "adversary": {("adversary", "vertex")},
    }


def test_the_drawing_shows_what_the_engine_made_of_each_situation() -> None:
    panels = np.reshape(figures.conflict_outcomes().axes, (len(SITUATIONS), 4))
    for situation, row in zip(SITUATIONS, panels, strict=True):
        for axes, outcome in zip(row[1:], OUTCOME_TEXTS, strict=True):
            world = resolve(situation, outcome)
            agents = [*situation.agents]
            alive, cells = world.alive[: len(agents)], world.last_positions.tolist()
            drawn = {text.get_text(): text.get_position() for text in axes.texts}
            assert [*drawn] == [name for name, lives in zip(agents, alive, strict=True) if lives]
            for name, (x, y) in drawn.items():  # two agents on a cell are beside each other
                assert [round(y), round(x)] == cells[agents.index(name)]
            held = {tuple(cells[agent]) for each in world.conflicts for agent in each.held}
            rings = [p for p in axes.patches if isinstance(p, Circle) and not p.get_fill()]
            assert {(int(p.center[1]), int(p.center[0])) for p in rings} == held
            gone = {tuple(cells[agent]) for agent in np.flatnonzero(~alive)}
            assert len(axes.lines) == len(gone)
            triangles = [p for p in axes.patches if isinstance(p, RegularPolygon)]
            assert len(triangles) == sum(name[0] == "P" for name in drawn)


def test_those_go_first_who_come_from_the_right() -> None:
    for *_, moves in CROSSINGS:
        steps = {move: tuple(MOVES[move]) for move in moves}

        def first(one: int, other: int, steps=steps) -> bool:
            faces = np.add(steps[one], steps[other]).any() == 0
            return one < other if faces else from_the_right(steps[other], steps[one])

        assert may_go(moves) == [all(first(m, o) for o in moves if o != m) for m in moves]


def test_each_turn_shows_who_acts() -> None:
    everyone = list(range(2 * PER_TEAM))
    turns = {
        mw.Interaction.SIMULTANEOUS: [everyone],
        mw.Interaction.SWARM_TURNS: [everyone[:PER_TEAM], everyone[PER_TEAM:]],
        mw.Interaction.AGENT_TURNS: [[agent] for agent in everyone],
    }
    assert {each: [*map(list, turns_of(each))] for each in mw.Interaction} == turns
