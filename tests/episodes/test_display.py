"""Where an environment with render_mode="human" is shown."""

from types import SimpleNamespace
from unittest.mock import Mock, call

import pytest

import matrixworld as mw
from matrixworld.episodes.record import FPS, Drawing, Notebook
from matrixworld.episodes.replay import CLEAR, HOME, WRAP_OFF, WRAP_ON
from matrixworld.world.render import ansi, png
from rows import config_of

WORLD = mw.World(config_of("O"))
SCENE = WORLD.scene("a title")


def test_without_display_or_terminal_it_is_plain_text(
    naps: list[float], capsys: pytest.CaptureFixture[str]
) -> None:
    env = mw.parallel_env(config_of("O"), render_mode="human")
    env.reset(seed=0)
    env.step(dict.fromkeys(env.agents, 0))
    assert env.render() is None
    env.close()
    printed = capsys.readouterr().out
    assert printed.isascii()
    assert naps == []  # a file needs no time to be seen
    for step in (0, 1):
        assert f"step {step}    captured 0 of 4 (0%)   P 3  E 4\n" in printed


def test_a_terminal_is_drawn_in_place(
    naps: list[float], terminal: pytest.CaptureFixture[str]
) -> None:
    shown = Drawing(WORLD, "human")
    for _ in range(3):
        shown.show()
    start, *pieces = terminal.readouterr().out.split(HOME)
    assert start == WRAP_OFF + CLEAR
    assert len(pieces) == 3
    assert pieces[0].splitlines()[0].startswith(ansi(shown.scene(), color="256").splitlines()[0])
    assert pieces[0] == pieces[1] == pieces[2] + WRAP_OFF
    assert pieces[2].endswith(WRAP_ON + "\n")
    assert naps == pytest.approx([0, 1 / FPS, 1 / FPS])


def test_a_notebook_s_output_is_drawn_anew() -> None:
    shell, display = SimpleNamespace(execution_count=4), Mock()
    place = Notebook(shell, display)
    for _ in range(3):
        place.show(SCENE)
    data = {"image/png": png(SCENE)}
    redrawn = call().update(data, raw=True)
    assert display.mock_calls == [call(data, raw=True, display_id=True), redrawn, redrawn]
    shell.execution_count = 5  # another cell is run
    place.show(SCENE)
    assert display.call_count == 2
