"""Drawings: every agent is there, at its place and in its colour."""

import re
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from PIL import ImageColor

from matrixworld._util import colors
from matrixworld.episodes.render import Scene, ansi, rgb
from matrixworld.episodes.render.canvas import Layout, shape

OBSTACLES = np.zeros((4, 6), bool)
OBSTACLES[1, 2] = OBSTACLES[3, 5] = True


def scene(**changes: object) -> Scene:
    """Pursuers at (0, 0) and (2, 3); evaders at (1, 4), (3, 0), and one that is gone."""
    values = {
        "positions": np.array([[0, 0], [2, 3], [1, 4], [3, 0], [-1, -1]]),
        "alive": np.array([True, True, True, True, False]),
        "captured": np.array([False, False, True]),
        "map": OBSTACLES,
        "n_pursuers": 2,
        **changes,
    }
    return Scene(**values)  # type: ignore[arg-type]


def of(positions: object, n_pursuers: int, grid: tuple[int, int], **changes: object) -> Scene:
    """Living and free agents on an empty grid."""
    cells = np.array(positions)
    free = {
        "positions": cells,
        "alive": np.ones(len(cells), bool),
        "captured": np.zeros(len(cells) - n_pursuers, bool),
        "map": np.zeros(grid, bool),
    }
    return scene(**(free | changes), n_pursuers=n_pursuers)


def pixel(picture: NDArray[np.uint8], drawn: Scene, row: float, col: float) -> tuple[int, ...]:
    """Return the colour at the centre of a cell, or beside it for fractions of a cell."""
    x, y = Layout.of(drawn.shape).centre(row, col)  # type: ignore[arg-type]
    return tuple(picture[int(y), int(x)].tolist())


def count(picture: NDArray[np.uint8], colour: str) -> int:
    """Return how many pixels below the title have exactly this colour."""
    below = picture[Layout.header :]
    return int((below == np.array(ImageColor.getrgb(colour))).all(axis=2).sum())


# -- pictures ----------------------------------------------------------------------------------


def test_each_agent_has_its_colour_at_the_centre_of_its_cell() -> None:
    drawn = scene()
    picture = rgb(drawn)
    assert picture.dtype == np.uint8
    for cell, colour in {
        (0, 0): colors.PURSUER,
        (2, 3): colors.PURSUER,
        (1, 4): colors.EVADER,
        (3, 0): colors.EVADER,
        (1, 2): colors.OBSTACLE,
        (3, 5): colors.OBSTACLE,
        (0, 3): colors.PAPER,
    }.items():
        assert pixel(picture, drawn, *cell) == ImageColor.getrgb(colour), cell


@pytest.mark.parametrize(
    "grid", [(1, 2), (2, 1), (7, 5), (20, 30), (40, 40), (130, 90), (300, 500), (1024, 1024)]
)
def test_any_grid_is_drawn_at_a_fitting_size(grid: tuple[int, int]) -> None:
    drawn = of([[0, 0], [grid[0] - 1, grid[1] - 1]], 1, grid)
    picture = rgb(drawn)
    assert max(picture.shape[:2]) <= 1100  # fits a screen
    assert picture.shape[0] % 2 == picture.shape[1] % 2 == 0  # films need even sizes
    assert pixel(picture, drawn, 0, 0) == ImageColor.getrgb(colors.PURSUER)
    assert pixel(picture, drawn, grid[0] - 1, grid[1] - 1) == ImageColor.getrgb(colors.EVADER)


def test_cell_size_is_what_was_asked_for() -> None:
    assert rgb(scene(), cell=100).shape == (4 * 100 + 50, 6 * 100 + 24, 3)
    assert repr(scene()) == "<Scene: 4 x 6 cells, 2 pursuers, 2 evaders>"


def test_the_teams_differ_in_shape_as_well() -> None:
    pursuer = np.asarray(shape("triangle", 40)) > 127
    evader = np.asarray(shape("disc", 40)) > 127
    assert pursuer[:10].sum() < 0.4 * pursuer[-15:-5].sum()  # narrow above, wide below
    assert evader[:10].sum() == evader[-10:].sum()  # a disc is the same above and below


def test_a_title_does_not_change_the_size_and_is_cut_to_fit() -> None:
    plain, titled = rgb(scene()), rgb(scene(title="a very long title " * 20))
    assert plain.shape == titled.shape
    assert (plain[: Layout.header] != titled[: Layout.header]).any()
    assert (plain[Layout.header :] == titled[Layout.header :]).all()


def test_several_on_one_cell_carry_their_number() -> None:
    def on_one_cell(size: int) -> NDArray[np.uint8]:
        return rgb(of([[1, 1]] * size, size, (4, 4)))[Layout.header :]

    assert count(rgb(scene()), colors.INK) == 0
    assert count(on_one_cell(2), colors.INK) > 50
    assert (on_one_cell(2) != on_one_cell(3)).any()  # the number is drawn, not a mere mark
    assert (on_one_cell(10) == on_one_cell(11)).all()  # from ten on, a plus


def numbered(scene: Scene) -> NDArray[np.uint8]:
    return rgb(scene, cell=24, numbers=True)


def test_agents_carry_their_numbers_on_request() -> None:
    # Two agents that change places look the same, but for their numbers.
    swapped = scene(positions=np.array([[2, 3], [0, 0], [1, 4], [3, 0], [-1, -1]]))
    assert (rgb(swapped, cell=24) == rgb(scene(), cell=24)).all()
    assert (numbered(swapped) != numbered(scene())).any()
    hollow = scene(captured=np.array([True, False, True]))
    assert (numbered(hollow) != rgb(hollow, cell=24)).any()


def test_agents_on_one_cell_carry_up_to_three_numbers() -> None:
    def together(*agents: int) -> NDArray[np.uint8]:
        alive = np.isin(np.arange(6), agents)
        return numbered(of([[0, 0]] * 6, 6, (4, 6), alive=alive))[Layout.header :]

    assert (together(0, 1) != together(0, 2)).any()
    assert (together(0, 1, 2) != together(0, 1)).any()
    assert (together(0, 1, 2, 3) != together(0, 1, 2)).any()
    assert (together(0, 1, 2, 3) == together(0, 1, 2, 3, 4)).all()


def test_numbers_need_cells_of_some_size() -> None:
    with pytest.raises(ValueError, match="cell: expected 20 to 1365 pixels .* got 19"):
        rgb(scene(), cell=19, numbers=True)
    assert rgb(of([[0, 0]], 1, (90, 60)), numbers=True).shape == (90 * 20 + 50, 60 * 20 + 24, 3)


def test_the_colours_of_teams_and_marks_differ_for_colour_blind_readers() -> None:
    """Lightness differs where hue may not: as grey levels, marks are far from both teams."""
    names = (colors.CAPTURE, colors.COLLISION)
    grey = {name: ImageColor.getcolor(name, "L") for name in (*colors.TEAMS, *names)}
    for mark in names:
        assert all(abs(grey[mark] - grey[team]) > 30 for team in colors.TEAMS)  # of 255


def test_trails_of_two_teams_on_the_same_cells_are_both_seen() -> None:
    trail = np.array([[[0, 5], [2, 3], [1, 4], [0, 5], [-1, -1]]])
    drawn = scene(positions=np.array([[0, 4], [2, 3], [1, 4], [0, 4], [-1, -1]]), trail=trail)
    picture = rgb(drawn)
    above, below = (pixel(picture, drawn, side, 4.7) for side in (-0.1, 0.1))
    assert above[0] > above[2]  # vermilion
    assert below[2] > below[0]  # blue


def test_both_teams_on_one_cell_are_both_seen() -> None:
    alone, shared = scene(), scene(positions=np.array([[0, 0], [1, 4], [1, 4], [3, 0], [-1, -1]]))
    # Of two, one is shared, and it is not hidden.
    assert count(rgb(shared), colors.PURSUER) > 1.5 * count(rgb(alone), colors.PURSUER) / 2
    assert count(rgb(shared), colors.EVADER) > 1.2 * count(rgb(alone), colors.EVADER) / 2


def test_a_captured_evader_is_hollow() -> None:
    drawn = scene(captured=np.array([True, False, True]))
    assert pixel(rgb(drawn), drawn, 1, 4) == ImageColor.getrgb(colors.PAPER)
    assert pixel(rgb(drawn), drawn, 1, 4.33) == ImageColor.getrgb(colors.EVADER)


def test_captures_and_deaths_are_marked_where_they_happened_and_fade() -> None:
    assert count(rgb(scene()), colors.CAPTURE) == count(rgb(scene()), colors.COLLISION) == 0
    for name, colour in (("captures", colors.CAPTURE), ("deaths", colors.COLLISION)):
        drawn = scene(**{name: np.array([[2, 1, 0]])})
        assert pixel(rgb(drawn), drawn, 2, 1) == ImageColor.getrgb(colour)
        faded = scene(**{name: np.array([[2, 1, 2]])})
        assert pixel(rgb(faded), faded, 2, 1) not in map(ImageColor.getrgb, (colour, colors.PAPER))
        assert (rgb(scene(**{name: np.array([[2, 1, 9]])})) == rgb(scene())).all()


def test_agents_at_fault_have_a_ring_and_others_a_fainter_one() -> None:
    none, bump = np.zeros((5, 3), bool), np.zeros((5, 3), bool)
    bump[1, 0] = True
    assert count(rgb(scene(fault=bump, involved=bump)), colors.COLLISION) > 50
    assert count(rgb(scene(fault=none, involved=bump)), colors.COLLISION) == 0
    assert (rgb(scene(fault=none, involved=bump)) != rgb(scene())).any()
    contact = np.zeros((5, 3), bool)
    contact[1, 2] = True  # adversaries met and nobody is at fault: the game itself
    assert (rgb(scene(fault=none, involved=contact)) == rgb(scene())).all()


def test_a_deadly_collision_is_marked_at_the_last_position() -> None:
    bump = np.zeros((5, 3), bool)
    bump[4, 1] = True  # the agent that is gone
    for where, rings in (([3, 4], {(3, 4)}), ([-1, -1], set())):
        positions = scene().positions.copy()
        positions[4] = where
        drawn = scene(positions=positions, fault=bump, involved=bump)
        assert drawn.collided() == (rings, set())
        assert (count(rgb(drawn), colors.COLLISION) > 50) == bool(rings)


def test_a_trail_leads_to_each_living_agent_and_fades() -> None:
    before = np.array([[0, 2], [2, 3], [1, 4], [3, 0], [0, 5]])
    between = np.array([[0, 1], [2, 3], [1, 4], [3, 0], [-1, -1]])
    drawn = scene(trail=np.stack([before, between]))
    paper, new, old = (pixel(rgb(drawn), drawn, -0.1, col) for col in (2.4, 0.6, 1.6))
    assert paper == ImageColor.getrgb(colors.PAPER)
    assert new[2] < old[2] < paper[2]  # the less blue, the stronger the vermilion


def test_the_field_of_view_is_cut_to_the_grid() -> None:
    seen = rgb(scene(), viewers=[0], fov=3)
    changed = (seen != rgb(scene())).any(axis=2)
    left, top, _, _ = Layout.of((4, 6)).field
    cell = Layout.of((4, 6)).cell
    inside = np.zeros_like(changed)
    # 3 x 3 cells around (0, 0), of which 2 x 2 are on the grid.
    inside[top : top + 2 * cell, left : left + 2 * cell] = True
    assert changed.any()
    assert not (changed & ~inside).any()
    assert (rgb(scene(), viewers=[4], fov=3) == rgb(scene())).all()  # gone: sees nothing


def test_viewers_are_given_by_number_or_name() -> None:
    named = rgb(scene(), viewers=["pursuer_1", "evader_0"], fov=3)
    assert (named == rgb(scene(), viewers=[1, 2], fov=3)).all()
    for wrong in (5, -1, "pursuer_2", "evader_3"):
        expected = f"viewers: expected 0 to 4 or a name such as pursuer_0, got {wrong!r}"
        with pytest.raises(ValueError, match=expected):
            rgb(scene(), viewers=[wrong])


def test_a_picture_is_the_callers_own() -> None:
    first = rgb(scene())
    first[:] = 0
    assert rgb(scene()).any()


# -- text --------------------------------------------------------------------------------------


def test_plain_text() -> None:
    assert ansi(scene(title="step 3"), color="none").split("\n") == [
        "step 3   P 2  E 2",
        "P . . . . . ",
        ". . ##. E . ",
        ". . . P . . ",
        "E . . . . ##",
    ]


def test_plain_text_of_several_agents_captures_and_deaths() -> None:
    cells = [[0, 0], [0, 0], [0, 1], [0, 1], [0, 2], [0, 3], [0, 2], [0, 4]]
    captured = np.array([True, False, False, False, False])
    alive, deaths = np.array([True] * 7 + [False]), np.array([[0, 4, 0], [0, 3, 1]])
    drawn = of(cells, 3, (1, 5), captured=captured, alive=alive, deaths=deaths)
    assert ansi(drawn, color="none").split("\n")[1] == "P2X E2E x "
    alive = np.isin(np.arange(8), [1, 3])
    gone = of(cells, 3, (1, 5), captured=captured, alive=alive)
    assert ansi(gone, color="none").split("\n")[1] == "P e . . . "


def test_three_agents_of_both_teams_on_a_cell_show_their_number() -> None:
    drawn = scene(positions=np.array([[1, 4], [1, 4], [1, 4], [3, 0], [-1, -1]]))
    assert ansi(drawn, color="none").split("\n")[2] == ". . ##. X3. "
    assert "2" in ansi(drawn, color="true").split("\n")[2]


@pytest.mark.parametrize("color", ["true", "256"])
def test_colours_are_codes_around_the_same_cells(color: str) -> None:
    text = ansi(scene(title="step 3"), color=color)
    bare = re.sub(r"\x1b\[[0-9;]*m", "", text).split("\n")
    assert bare[0] == "step 3   ▲ 2  ● 2"
    assert bare[1:] == [
        "▲ · · · · · ",
        "· · ██· ● · ",
        "· · · ▲ · · ",
        "● · · · · ██",
    ]
    pursuer = "38;2;213;94;0" if color == "true" else "38;5;166"
    assert text.count(pursuer) == 3  # two agents and the legend
    assert all(line.endswith("\x1b[0m") for line in text.split("\n")[1:])


def test_half_blocks_put_two_rows_into_a_line() -> None:
    lines = ansi(scene(), compact=True).split("\n")
    bare = [re.sub(r"\x1b\[[0-9;]*m", "", line) for line in lines]
    assert bare[1:] == ["▀" * 6] * 2
    assert lines[1].startswith("\x1b[38;2;213;94;0;48;2;255;255;255m▀")  # pursuer over paper
    odd = of([[2, 0]], 0, (3, 1))
    assert ansi(odd, compact=True).split("\n")[2] == "\x1b[38;2;0;114;178m▀\x1b[0m"


def test_what_happened_in_the_last_step_colours_the_ground() -> None:
    quiet = ansi(scene())
    captures, deaths = np.array([[2, 1, 0]]), np.array([[2, 1, 0]])
    assert ansi(scene(captures=captures)) != quiet
    assert "× " in ansi(scene(deaths=deaths))
    assert ansi(scene(captures=np.array([[2, 1, 1]]))) == quiet
    fault = np.zeros((5, 3), bool)
    fault[0, 1] = True
    assert ansi(scene(fault=fault)) != quiet


# -- refusals ----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "value", "says"),
    [
        ("positions", np.zeros((4, 2), int), r"expected shape \(5, 2\), got \(4, 2\)"),
        ("positions", np.full((5, 2), 4), r"expected cells of a 4 x 6 map, got \(4, 4\) for .* 0"),
        ("alive", np.ones((5, 1), bool), r"expected shape \(any,\), got \(5, 1\)"),
        ("captured", np.zeros(2, bool), ""),
        ("map", np.zeros(4, bool), r"expected shape \(any, any\), got \(4,\)"),
        ("n_pursuers", 6, "expected 0 to 5"),
        ("fault", np.zeros((5, 2), bool), ""),
        ("involved", np.zeros(5, bool), ""),
        ("trail", np.zeros((5, 2), int), r"expected shape \(any, 5, 2\)"),
        ("captures", np.zeros((1, 2), int), ""),
        ("deaths", np.zeros(3, int), ""),
    ],
)
def test_a_scene_refuses_arrays_that_do_not_fit(name: str, value: object, says: str) -> None:
    with pytest.raises(ValueError, match=f"^{name}: {says}"):
        scene(**{name: value})


def test_a_scene_wants_arrays() -> None:
    with pytest.raises(TypeError, match="alive: expected a NumPy array, got list"):
        scene(alive=[True] * 5)


@pytest.mark.parametrize(
    ("draw", "options", "says"),
    [
        (rgb, {"cell": 0}, "cell: expected 1 to 1365 pixels for 4 x 6 cells, got 0"),
        (rgb, {"cell": 5000}, "cell:"),
        (rgb, {"fov": 4}, "fov:"),
        (ansi, {"color": "red"}, "color:"),
        (ansi, {"color": "none", "compact": True}, "compact:"),
    ],
)
def test_options_that_are_refused(draw: Any, options: dict[str, object], says: str) -> None:
    with pytest.raises(ValueError, match=f"^{says}"):
        draw(scene(), **options)
