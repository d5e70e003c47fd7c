"""Drawings: every agent is there, at its place and in its colour."""

import re

import numpy as np
import pytest
from PIL import ImageColor

from matrixworld._util import colors
from matrixworld.world.canvas import Layout
from matrixworld.world.render import Scene, ansi, rgb

OBSTACLES = np.zeros((4, 6), bool)
OBSTACLES[1, 2] = OBSTACLES[3, 5] = True


def scene(**changes):
    """Pursuers at (0, 0) and (2, 3); evaders at (1, 4), (3, 0), and one that is gone."""
    values = {
        "positions": np.array([[0, 0], [2, 3], [1, 4], [3, 0], [-1, -1]]),
        "alive": np.array([True, True, True, True, False]),
        "captured": np.array([False, False, True]),
        "map": OBSTACLES,
        "n_pursuers": 2,
        **changes,
    }
    return Scene(**values)


def of(positions, n_pursuers, grid, **changes):
    cells = np.array(positions)
    free = {
        "positions": cells,
        "alive": np.ones(len(cells), bool),
        "captured": np.zeros(len(cells) - n_pursuers, bool),
        "map": np.zeros(grid, bool),
    }
    return scene(**(free | changes), n_pursuers=n_pursuers)


def pixel(picture, drawn, row, col):
    """Return the colour at the centre of a cell, or beside it for fractions of a cell."""
    x, y = Layout.of(drawn.shape).centre(row, col)
    return tuple(picture[int(y), int(x)].tolist())


def count(picture, colour):
    below = picture[Layout.header :]
    return int((below == np.array(ImageColor.getrgb(colour))).all(axis=2).sum())


def test_each_agent_has_its_colour_at_the_centre_of_its_cell():
    drawn = scene()
    picture = rgb(drawn)
    assert picture.dtype == np.uint8
    for colour, cells in {
        colors.PURSUER: [(0, 0), (2, 3)],
        colors.EVADER: [(1, 4), (3, 0)],
        colors.OBSTACLE: [(1, 2), (3, 5)],
        colors.PAPER: [(0, 3)],
    }.items():
        for cell in cells:
            assert pixel(picture, drawn, *cell) == ImageColor.getrgb(colour), cell


@pytest.mark.parametrize("grid", [(1, 2), (7, 5), (130, 90), (1024, 1024)])
def test_any_grid_is_drawn_at_a_fitting_size(grid):
    drawn = of([[0, 0], [grid[0] - 1, grid[1] - 1]], 1, grid)
    picture = rgb(drawn)
    assert max(picture.shape[:2]) <= 1100  # fits a screen
    assert picture.shape[0] % 2 == picture.shape[1] % 2 == 0  # films need even sizes
    assert pixel(picture, drawn, 0, 0) == ImageColor.getrgb(colors.PURSUER)
    assert pixel(picture, drawn, grid[0] - 1, grid[1] - 1) == ImageColor.getrgb(colors.EVADER)


def test_captured_evaders_are_hollow_and_several_agents_on_a_cell_are_told():
    drawn = scene(captured=np.array([True, False, True]))
    assert pixel(rgb(drawn), drawn, 1, 4) == ImageColor.getrgb(colors.PAPER)
    assert pixel(rgb(drawn), drawn, 1, 4.33) == ImageColor.getrgb(colors.EVADER)
    several = of([[1, 1]] * 3, 3, (4, 4))
    assert count(rgb(several), colors.INK) > 50  # how many there are
    assert (rgb(several, cell=24, numbers=True) != rgb(several, cell=24)).any()


def test_captures_and_deaths_are_marked_where_they_happened_and_fade():
    assert count(rgb(scene()), colors.CAPTURE) == count(rgb(scene()), colors.COLLISION) == 0
    for name, colour in (("captures", colors.CAPTURE), ("deaths", colors.COLLISION)):
        drawn = scene(**{name: np.array([[2, 1, 0]])})
        assert pixel(rgb(drawn), drawn, 2, 1) == ImageColor.getrgb(colour)
        faded = scene(**{name: np.array([[2, 1, 2]])})
        assert pixel(rgb(faded), faded, 2, 1) not in map(ImageColor.getrgb, (colour, colors.PAPER))
        assert (rgb(scene(**{name: np.array([[2, 1, 9]])})) == rgb(scene())).all()


def test_agents_at_fault_have_a_ring_and_others_a_fainter_one():
    none, bump = np.zeros((5, 3), bool), np.zeros((5, 3), bool)
    bump[1, 0] = True
    assert count(rgb(scene(fault=bump, involved=bump)), colors.COLLISION) > 50
    assert count(rgb(scene(fault=none, involved=bump)), colors.COLLISION) == 0
    assert (rgb(scene(fault=none, involved=bump)) != rgb(scene())).any()
    contact = np.zeros((5, 3), bool)
    contact[1, 2] = True  # adversaries met and nobody is at fault: the game itself
    assert (rgb(scene(fault=none, involved=contact)) == rgb(scene())).all()


def test_plain_text_of_several_agents_captures_and_deaths():
    cells = [[0, 0], [0, 0], [0, 1], [0, 1], [0, 2], [0, 3], [0, 2], [0, 4]]
    captured = np.array([True, False, False, False, False])
    alive, deaths = np.array([True] * 7 + [False]), np.array([[0, 4, 0], [0, 3, 1]])
    drawn = of(cells, 3, (1, 5), captured=captured, alive=alive, deaths=deaths)
    assert ansi(drawn, color=False).split("\n")[1] == "P2X E2E x "
    alive = np.isin(np.arange(8), [1, 3])
    gone = of(cells, 3, (1, 5), captured=captured, alive=alive)
    assert ansi(gone, color=False).split("\n")[1] == "P e . . . "


def test_colours_are_codes_around_the_same_cells():
    text = ansi(scene(title="step 3"))
    bare = re.sub(r"\x1b\[[0-9;]*m", "", text).split("\n")
    assert bare[0] == "step 3   ▲ 2  ● 2"
    assert bare[1:] == ["▲ · · · · · ", "· · ██· ● · ", "· · · ▲ · · ", "● · · · · ██"]
    assert text.count("38;5;166") == 3  # two agents and the legend
    assert all(line.endswith("\x1b[0m") for line in text.split("\n")[1:])
