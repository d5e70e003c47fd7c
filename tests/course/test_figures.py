"""Figures of the game show what the engine does, and the rules that it plays."""

import numpy as np
import pytest
from matplotlib.patches import Circle, RegularPolygon
from matplotlib.text import Annotation

import matrixworld as mw
from course import figures
from course.figures import CROSSINGS, MOVES, PER_TEAM, SITUATIONS, resolve
from matrixworld.world.rules import INTERACTION_TEXTS, OUTCOME_TEXTS
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


def test_an_arrow_leads_in_and_a_bar_keeps_out() -> None:
    for axes, (*_, moves) in zip(figures.right_of_way().axes, CROSSINGS, strict=True):
        steps = {move: tuple(MOVES[move]) for move in moves}

        def first(one: int, other: int, steps=steps) -> bool:
            faces = np.add(steps[one], steps[other]).any() == 0
            return one < other if faces else from_the_right(steps[other], steps[one])

        ways = [each for each in axes.texts if isinstance(each, Annotation)]
        arrows = [each.arrowprops["arrowstyle"] == "-|>" for each in ways]
        assert arrows == [all(first(m, o) for o in moves if o != m) for m in moves]
        for way, move, leads_in in zip(ways, moves, arrows, strict=True):
            # Both cross, or end at, the border over which the move leads.
            (x, y), (down, right) = np.mean([way.xy, way.xyann], axis=0), MOVES[move]
            along = (1 - x) * right + (1 - y) * down
            assert along == pytest.approx(0.35 if leads_in else 0.5)
            assert (1 - x) * down + (1 - y) * right == pytest.approx(0)


def test_each_turn_shows_who_acts() -> None:
    everyone = list(range(2 * PER_TEAM))
    turns = {
        mw.Interaction.SIMULTANEOUS: [everyone],
        mw.Interaction.SWARM_TURNS: [everyone[:PER_TEAM], everyone[PER_TEAM:]],
        mw.Interaction.AGENT_TURNS: [[agent] for agent in everyone],
    }
    for axes, (interaction, found) in zip(
        figures.interaction_models().axes, turns.items(), strict=True
    ):
        assert axes.get_title().strip() == INTERACTION_TEXTS[interaction]
        marks = [line for line in axes.lines if line.get_marker() in ("o", "^")]
        drawn = [(float(line.get_xdata()[0]), int(line.get_ydata()[0])) for line in marks]
        assert drawn == [(turn + 0.5, agent) for turn, each in enumerate(found) for agent in each]
