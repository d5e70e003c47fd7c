"""Figures of the game show what the engine does, and the rules that it plays."""

from pathlib import Path

import numpy as np
import pytest
from matplotlib.patches import Circle, Rectangle, RegularPolygon
from matplotlib.text import Annotation

import matrixworld as mw
from matrixworld import plots
from matrixworld.plots.game import (
    CROSSINGS,
    MOVES,
    PER_TEAM,
    SITUATIONS,
    Situation,
    actions_in,
    may_go,
    resolve,
    turns_of,
    world_of,
)
from matrixworld.plots.style import FORMATS
from matrixworld.world.rules import CAPTURE_TEXTS, INTERACTION_TEXTS, OUTCOME_TEXTS
from reference import ReferenceWorld, records
from right_of_way import from_the_right

PANELS = [
    pytest.param(situation, outcome, id=f"{situation.name}-{outcome.name}")
    for situation in SITUATIONS
    for outcome in OUTCOME_TEXTS
]


def played_by_the_reference(situation: Situation, outcome: mw.Outcome) -> ReferenceWorld:
    """Return the slow world in Python after one step of a situation."""
    world = world_of(situation, outcome)
    reference = ReferenceWorld(world.config)
    pursuers, evaders = np.split(world.positions, [world.config.n_pursuers])
    reference.place(pursuers.tolist(), evaders.tolist(), world.map)
    reference.step(actions_in(world, situation))
    return reference


@pytest.mark.parametrize(("situation", "outcome"), PANELS)
def test_the_outcomes_are_those_of_the_reference(situation: Situation, outcome: mw.Outcome) -> None:
    found = resolve(situation, outcome)
    reference = played_by_the_reference(situation, outcome)
    agents = range(len(situation.agents))
    assert found.alive == [agent in reference.where for agent in agents]
    assert found.cells == [reference.been[agent] for agent in agents]
    held = {agent for clash in reference.conflicts for agent in clash.held}
    assert found.held == held


def test_the_situations_are_of_the_forms_and_kinds_that_they_name() -> None:
    """In each named conflict the engine finds this form or kind, and in the others none."""
    found = {}
    for situation in SITUATIONS:
        world = world_of(situation, mw.Outcome.BOUNCE)
        world.step(actions_in(world, situation), explain=True)
        reference = played_by_the_reference(situation, mw.Outcome.BOUNCE)
        assert records(world.conflicts) == records(reference.conflicts)
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


def test_the_drawing_shows_the_resolution() -> None:
    figure = plots.conflict_outcomes()
    panels = np.reshape(figure.axes, (len(SITUATIONS), 4))
    for situation, row in zip(SITUATIONS, panels, strict=True):
        for axes, outcome in zip(row[1:], OUTCOME_TEXTS, strict=True):
            result = resolve(situation, outcome)
            names = {text.get_text() for text in axes.texts if text.get_text()}
            pursuers = len(situation.pursuers)
            living = [agent for agent, alive in enumerate(result.alive) if alive]
            assert names == {
                f"P{agent}" if agent < pursuers else f"E{agent - pursuers}" for agent in living
            }
            for text in axes.texts:
                team, number = text.get_text()[0], int(text.get_text()[1:])
                agent = number + (pursuers if team == "E" else 0)
                x, y = text.get_position()
                # Two agents on a cell are beside each other.
                assert (round(y), round(x)) == result.cells[agent]
            rings = [p for p in axes.patches if isinstance(p, Circle) and not p.get_fill()]
            held = {result.cells[agent] for agent in result.held}
            assert {(int(p.center[1]), int(p.center[0])) for p in rings} == held
            gone = set(range(len(result.cells))) - set(living)
            assert len(axes.lines) == len({result.cells[agent] for agent in gone})
            triangles = [p for p in axes.patches if isinstance(p, RegularPolygon)]
            assert len(triangles) == sum(agent < pursuers for agent in living)
            cells = [p for p in axes.patches if isinstance(p, Rectangle)]
            assert len(cells) == situation.rows * situation.cols
            assert axes.get_xlabel() == result.text


@pytest.mark.parametrize("moves", [moves for *_, moves in CROSSINGS], ids=len)
def test_who_may_go_is_read_from_the_moves(moves: tuple[int, ...]) -> None:
    ways = {move: tuple(MOVES[move]) for move in moves}

    def first(one: int, other: int) -> bool:
        faces = np.add(ways[one], ways[other]).any() == 0
        return one < other if faces else from_the_right(ways[other], ways[one])

    assert may_go(moves) == [all(first(m, o) for o in moves if o != m) for m in moves]


def test_an_arrow_leads_in_and_a_bar_keeps_out() -> None:
    for axes, (title, text, moves) in zip(plots.right_of_way().axes, CROSSINGS, strict=True):
        assert (axes.get_title(), axes.get_xlabel()) == (title, text)
        ways = [each for each in axes.texts if isinstance(each, Annotation)]
        arrows = [each.arrowprops["arrowstyle"] == "-|>" for each in ways]
        assert arrows == may_go(moves)
        for way, move in zip(ways, moves, strict=True):
            # Both cross, or end at, the border over which the move leads.
            (x, y), (down, right) = np.mean([way.xy, way.xyann], axis=0), MOVES[move]
            along = (1 - x) * right + (1 - y) * down
            assert along == pytest.approx(0.35 if arrows[ways.index(way)] else 0.5)
            assert (1 - x) * down + (1 - y) * right == pytest.approx(0)


def test_the_table_shows_the_rules() -> None:
    own = mw.Rules(mw.Interaction.SWARM_TURNS, teammate=mw.Outcome.DISAPPEAR)
    figure = plots.rules_table({**mw.VARIANTS, "mine": own})
    (axes,) = figure.axes
    rows: dict[int, list[str]] = {}
    for text in axes.texts:
        rows.setdefault(round(text.get_position()[1]), []).append(text.get_text())
    for row, (name, rules) in enumerate({**mw.VARIANTS, "mine": own}.items()):
        outcomes = (rules.obstacle, rules.teammate, rules.evader, rules.pursuer)
        assert rows[row] == [
            "mine" if name == "mine" else f"-{name}",
            INTERACTION_TEXTS[rules.interaction],
            *(OUTCOME_TEXTS[outcome].split()[0] for outcome in outcomes),
            CAPTURE_TEXTS[rules.capture],
            "disappear" if rules.removes_captured else "stay",
        ]


def test_the_turns_are_those_of_the_engine() -> None:
    everyone = list(range(2 * PER_TEAM))
    turns = {each: [list(turn) for turn in turns_of(each)] for each in mw.Interaction}
    assert turns == {
        mw.Interaction.SIMULTANEOUS: [everyone],
        mw.Interaction.SWARM_TURNS: [everyone[:PER_TEAM], everyone[PER_TEAM:]],
        mw.Interaction.AGENT_TURNS: [[agent] for agent in everyone],
    }
    figure = plots.interaction_models()
    for axes, (interaction, found) in zip(figure.axes, turns.items(), strict=True):
        assert axes.get_title().strip() == INTERACTION_TEXTS[interaction]
        marks = [line for line in axes.lines if line.get_marker() in ("o", "^")]
        drawn = [(float(line.get_xdata()[0]), int(line.get_ydata()[0])) for line in marks]
        assert drawn == [(turn + 0.5, agent) for turn, each in enumerate(found) for agent in each]


@pytest.mark.parametrize(
    ("draw", "suffix"),
    [
        *((plots.rules_table, suffix) for suffix in FORMATS),
        (plots.conflict_outcomes, "pdf"),
        (plots.interaction_models, "svg"),
        (plots.right_of_way, "svg"),
    ],
)
def test_figures_are_files_of_their_suffix(draw, suffix: str, tmp_path: Path) -> None:
    begins = {"png": b"\x89PNG\r\n\x1a\n", "pdf": b"%PDF-", "svg": b"<?xml"}
    file = plots.save_figure(draw(), tmp_path / f"figure.{suffix}")
    content = file.read_bytes()
    assert content.startswith(begins[suffix])
    assert b"<image" not in content  # vectors only
    assert b"Date" not in content


def test_another_suffix_is_refused(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match=r"expected a name that ends in \.png, \.pdf, \.svg, got"):
        plots.save_figure(plots.rules_table(), tmp_path / "figure.bmp")
    assert not list(tmp_path.iterdir())
