"""Where an environment with render_mode="human" shows itself."""

from __future__ import annotations

import copy
import io
import pickle
import sys
from typing import Any

import matplotlib as mpl
import numpy as np
import pytest
from matplotlib import pyplot as plt
from matplotlib.backends.backend_agg import FigureCanvasAgg

import matrixworld as mw
from matrixworld import screen
from matrixworld.render import ansi, png, rgb
from matrixworld.render.screen import CLEAR, HOME
from rows import config_of


@pytest.fixture(autouse=True)
def naps(monkeypatch: pytest.MonkeyPatch) -> list[float]:
    """Collects the pauses, which are not taken."""
    taken: list[float] = []
    monkeypatch.setattr("time.sleep", taken.append)
    monkeypatch.setattr(mpl, "rcParams", mpl.rcParams.copy())
    mpl.use("agg")
    return taken


class TerminalStream(io.StringIO):
    encoding = "utf-8"

    def isatty(self) -> bool:
        return True


SCENE = mw.World(config_of("O")).scene("a title")


# ---- Terminals ---------------------------------------------------------------------------------


def test_without_display_or_terminal_it_is_plain_text(capsys: pytest.CaptureFixture[str]) -> None:
    env = mw.parallel_env(config_of("O"), render_mode="human")
    env.reset(seed=0)
    env.step(dict.fromkeys(env.agents, 0))
    assert env.render() is None
    env.close()
    told = capsys.readouterr().out
    assert told.isascii()
    assert [line for line in told.splitlines() if line.startswith("step")] == [
        "step 0    captured 0 of 4 (0%)   P 3  E 4",
        "step 1    captured 0 of 4 (0%)   P 3  E 4",
    ]


def test_a_terminal_is_drawn_in_place(naps: list[float], monkeypatch: pytest.MonkeyPatch) -> None:
    for name, value in {"COLUMNS": "99", "LINES": "40", "COLORTERM": "", "TERM": "xterm"}.items():
        monkeypatch.setenv(name, value)
    monkeypatch.delenv("NO_COLOR", raising=False)
    stream = TerminalStream()
    monkeypatch.setattr(sys, "stdout", stream)
    shown = screen.Screen()
    for _ in range(3):
        shown.show(SCENE)
    shown.close()
    monkeypatch.undo()
    pieces = stream.getvalue().split(HOME)
    assert pieces[0] == CLEAR
    assert len(pieces) == 4
    assert pieces[1].splitlines()[0].startswith(ansi(SCENE, color="256").splitlines()[0])
    assert len(naps) == 3
    assert max(naps) <= 1 / screen.FPS


# ---- Windows -----------------------------------------------------------------------------------


class DisplayCanvas(FigureCanvasAgg):
    """A canvas that says it stands on a display."""

    required_interactive_framework = "made up"
    flushed = 0

    def flush_events(self) -> None:
        type(self).flushed += 1


@pytest.fixture
def window(monkeypatch: pytest.MonkeyPatch) -> Any:
    figure = plt.figure("matrixworld", FigureClass=mpl.figure.Figure)
    DisplayCanvas(figure)
    DisplayCanvas.flushed = 0
    monkeypatch.setattr(figure, "show", lambda: None)
    yield screen._window()
    plt.close("all")


def test_a_window_shows_each_picture(window: Any) -> None:
    for cell in (None, None):
        window.show(SCENE, cell=cell, fov=5, viewers=[0])
    figure = plt.figure("matrixworld")
    (axes,) = figure.axes
    np.testing.assert_array_equal(axes.images[0].get_array(), rgb(SCENE, fov=5, viewers=[0]))
    assert DisplayCanvas.flushed == 2
    window.close()
    assert not plt.fignum_exists("matrixworld")


def test_a_window_closed_by_its_user_stays_closed(window: Any) -> None:
    window.show(SCENE)
    plt.close("matrixworld")
    window.show(SCENE)
    assert DisplayCanvas.flushed == 1
    window.close()


def test_no_window_is_left_where_there_is_no_display() -> None:
    assert screen._window() is None
    assert plt.get_fignums() == []


# ---- Notebooks ---------------------------------------------------------------------------------


def test_a_notebook_s_output_is_drawn_anew() -> None:
    drawn: list[tuple[str, Any]] = []

    class Handle:
        def update(self, data: Any, *, raw: bool) -> None:
            drawn.append(("update", data))

    def display(data: Any, *, raw: bool, display_id: bool) -> Handle:
        drawn.append(("display", data))
        return Handle()

    place = screen.Notebook(display)
    for _ in range(3):
        place.show(SCENE, viewers=[1])
    place.close()
    assert [how for how, _ in drawn] == ["display", "update", "update"]
    assert drawn[0][1] == {"image/png": png(SCENE, viewers=[1])}


def test_a_copied_environment_has_no_window() -> None:
    env = mw.parallel_env(config_of("O"), render_mode="human")
    env.reset(seed=0)
    for twin in (copy.deepcopy(env), pickle.loads(pickle.dumps(env))):  # noqa: S301
        twin.step(dict.fromkeys(twin.agents, 0))
        assert twin.recorded.length == 1
    assert env.recorded.length == 0
