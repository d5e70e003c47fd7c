"""Replays of an episode: scenes, GIFs, contact sheets, terminal animations."""

from __future__ import annotations

import base64
import dataclasses
import io
import os
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import imageio_ffmpeg
import numpy as np
import pytest
from PIL import Image

import matrixworld as mw
from matrixworld._util import colors
from matrixworld.episodes import render
from matrixworld.episodes.episode import Episode
from matrixworld.episodes.render import terminal as term
from matrixworld.episodes.replay import (
    animate_terminal,
    animation,
    contact_sheet,
    print_moment,
    save,
    scene,
)
from rows import random_walks

EPISODE = random_walks()


# -- scenes ------------------------------------------------------------------------------------


def test_scenes_follow_the_episode() -> None:
    first, last = scene(EPISODE, 0), scene(EPISODE)
    assert first.title == "step 0 of 30    captured 0 of 7 (0%)"
    assert first.fault is None
    assert (first.positions == EPISODE.positions[0]).all()
    caught = round(EPISODE.capture_rate * 7)
    assert last.title == f"step 30 of 30    captured {caught} of 7 ({caught / 7:.0%})"
    assert (last.fault == EPISODE.fault[-1]).all()  # type: ignore[union-attr]
    assert (scene(EPISODE, 9, trail=4).trail == EPISODE.positions[5:9]).all()  # type: ignore[union-attr]
    with pytest.raises(IndexError):
        scene(EPISODE, 31)
    with pytest.raises(ValueError, match="trail: expected .*, got -1"):
        scene(EPISODE, 3, trail=-1)
    with pytest.raises(TypeError, match="step: expected an integer"):
        scene(EPISODE, 3.5)  # type: ignore[arg-type]


def test_the_capture_rate_is_of_the_moment_under_surround_only() -> None:
    captured = EPISODE.captured.copy()
    captured[-1] = False
    occupation = dataclasses.replace(EPISODE, captured=captured)
    assert occupation.capture_rate == EPISODE.capture_rate
    surround = dataclasses.replace(occupation, config={"rules": {"capture": "SURROUND"}})
    assert surround.capture_rate == 0
    assert scene(surround).title.endswith("captured 0 of 7 (0%)")


def tiny(
    before: list[list[int]], after: list[list[int]], alive: list[bool], captured: bool
) -> Episode:
    """Return one step of a pursuer and an evader on a 3 x 3 grid."""
    last_positions = np.array([before, after], np.int32)
    living = np.array([[True, True], alive])
    ever = np.array([[False], [captured]])
    return Episode(
        positions=np.where(living[..., None], last_positions, -1).astype(np.int32),
        last_positions=last_positions,
        alive=living,
        captured=ever,
        ever_captured=ever,
        actions=np.zeros((1, 2), np.int8),
        rewards=np.zeros((1, 2), np.float32),
        involved=np.zeros((1, 2, 3), bool),
        fault=np.zeros((1, 2, 3), bool),
        map=np.zeros((3, 3), bool),
        n_pursuers=1,
    )


@pytest.mark.parametrize("alive", [False, True])
def test_captures_and_other_deaths_are_marked_where_they_happened(alive: bool) -> None:
    caught = scene(tiny([[0, 0], [2, 2]], [[0, 0], [2, 1]], [True, alive], captured=True))
    assert caught.captures.tolist() == [[2, 1, 0]]  # type: ignore[union-attr]
    assert caught.deaths.tolist() == []  # type: ignore[union-attr]
    crashed = scene(tiny([[1, 1], [2, 2]], [[0, 1], [2, 2]], [False, alive], captured=False))
    assert crashed.captures.tolist() == []  # type: ignore[union-attr]
    deaths = [[0, 1, 0]] if alive else [[0, 1, 0], [2, 2, 0]]
    assert crashed.deaths.tolist() == deaths  # type: ignore[union-attr]


def test_a_deadly_collision_is_marked_at_the_last_positions() -> None:
    world = mw.World("D", rows=3, cols=5, n_pursuers=4, n_evaders=1)
    recorder = mw.Recorder(world)
    world.reset(pursuers=[(1, 0), (1, 2), (0, 4), (2, 0)], evaders=[(2, 4)])
    recorder.begin()
    east, west, north = 2, 4, 1
    for actions in ([east, west, north, 0, 0], [0] * 5):
        world.step(actions)
        recorder.note(actions)
    met, crashed = (1, 1), (0, 4)
    first, second = (scene(recorder.episode(), step) for step in (1, 2))
    assert first.deaths.tolist() == [[*met, 0], [*met, 0], [*crashed, 0]]  # type: ignore[union-attr]
    assert first.collided() == ({met, crashed}, set())
    assert second.deaths.tolist() == [[*met, 1], [*met, 1], [*crashed, 1]]  # type: ignore[union-attr]
    assert second.collided() == (set(), set())


def test_marks_stay_for_a_few_steps() -> None:
    step = int(EPISODE.ever_captured.any(axis=1).argmax())
    ages = [scene(EPISODE, t).captures for t in range(step, step + render.MARK_STEPS + 1)]
    seen = [
        min((age for *_, age in each.tolist()), default=None) for each in ages if each is not None
    ]
    assert seen[0] == 0
    first = ages[0].tolist()[0][:2]  # type: ignore[union-attr]
    where = [[mark[:2] for mark in each.tolist()] for each in ages if each is not None]
    assert all(first in marks for marks in where[:-1])


@pytest.mark.parametrize("variant", list(mw.VARIANTS))
def test_recorded_episodes_are_drawn_and_counted_as_rollouts_count_them(variant: str) -> None:
    config = mw.WorldConfig(
        variant, rows=9, cols=9, n_pursuers=8, n_evaders=6, obstacles=0.1, max_steps=40
    )
    episode = mw.record(config, "chaser", "random", seed=5)
    scores = mw.rollout(config, "chaser", "random", mw.Matches.of(0, 0, 5))
    assert episode.capture_rate == pytest.approx(scores.capture_rate[0, 0])
    assert episode.length == scores.length[0, 0]
    for step in range(episode.length + 1):
        drawn = scene(episode, step)
        assert drawn.team_sizes() == (
            episode.alive[step, :8].sum(),
            episode.alive[step, 8:].sum(),
        )
        assert all(not episode.map[row, col] for row, col, _ in drawn.captures.tolist())  # type: ignore[union-attr]
    assert render.rgb(scene(episode)).any()


# -- GIF and sheet -----------------------------------------------------------------------------


def frames(path: Path) -> Iterator[tuple[np.ndarray, int]]:
    """Yield each picture of an animation and its duration in milliseconds."""
    with Image.open(path) as image:
        for index in range(image.n_frames):
            image.seek(index)
            yield np.array(image.convert("RGB")), image.info["duration"]


def test_a_gif_shows_every_step(tmp_path: Path) -> None:
    path = tmp_path / "episode.gif"
    save(EPISODE, path, fps=8, hold=1.5, cell=14)
    shown = list(frames(path))
    assert len(shown) == EPISODE.length + 1
    assert [duration for _, duration in shown] == [120] * 30 + [1620]
    for step, (picture, _) in enumerate(shown):
        wanted = render.rgb(scene(EPISODE, step), cell=14)
        assert picture.shape == wanted.shape
        off = np.abs(picture.astype(int) - wanted.astype(int)).max(axis=2)
        assert (off > 48).mean() < 0.002, step  # blends at edges share a few colours
        for colour in (render_color("PURSUER"), render_color("EVADER"), render_color("PAPER")):
            exact = (wanted == colour).all(axis=2)
            assert (picture[exact] == colour).all(), step
    with Image.open(path) as image:
        assert image.info["loop"] == 0
    assert os.listdir(tmp_path) == ["episode.gif"]


def render_color(name: str) -> np.ndarray:
    """A colour of the project as three numbers."""
    text = getattr(colors, name)
    return np.array([int(text[i : i + 2], 16) for i in (1, 3, 5)])


def test_a_gif_of_fewer_frames_still_shows_the_last_step(tmp_path: Path) -> None:
    save(EPISODE, tmp_path / "all.gif", every=1)
    save(EPISODE, tmp_path / "some.gif", every=7)
    every, some = list(frames(tmp_path / "all.gif")), list(frames(tmp_path / "some.gif"))
    assert len(some) == 6  # steps 0, 7, 14, 21, 28, 30
    assert (np.abs(every[-1][0].astype(int) - some[-1][0]) > 60).mean() < 0.001
    assert (tmp_path / "some.gif").stat().st_size < (tmp_path / "all.gif").stat().st_size


def test_a_gif_of_a_long_episode_stays_small(tmp_path: Path) -> None:
    episode = random_walks(rows=40, cols=40, pursuers=8, evaders=30, steps=100)
    save(episode, tmp_path / "long.gif", cell=12)
    assert (tmp_path / "long.gif").stat().st_size < 101 * 8_000  # 4 MB for 500 steps


def test_an_episode_that_stands_still_is_a_gif_too(tmp_path: Path) -> None:
    save(random_walks(steps=0), tmp_path / "still.gif")
    assert len(list(frames(tmp_path / "still.gif"))) == 1


@pytest.mark.parametrize(
    "options",
    [
        {"fps": 0},
        {"fps": 60},
        {"every": 0},
        {"hold": -1},
        {"cell": 0},
        {"fov": 2, "viewers": [0]},
        {"viewers": ["evader_7"]},
    ],
)
def test_what_is_refused_leaves_no_file(tmp_path: Path, options: dict[str, Any]) -> None:
    field = f"^{next(iter(options))}: expected"
    with pytest.raises(ValueError, match=field):
        save(EPISODE, tmp_path / "no.gif", **options)
    with pytest.raises(TypeError, match=f"keywords: .* got {next(iter(options))}s; did you mean"):
        save(EPISODE, tmp_path / "no.gif", **{f"{next(iter(options))}s": 1})  # type: ignore[arg-type]
    assert os.listdir(tmp_path) == []
    if options.keys() & {"fps", "every"} and options != {"fps": 60}:
        with pytest.raises(ValueError, match=field):
            animate_terminal(EPISODE, io.StringIO(), **options)


# -- films, pictures, notebooks ------------------------------------------------------------------


def test_a_film_shows_every_step(tmp_path: Path) -> None:
    path = tmp_path / "episode.mp4"
    save(EPISODE, path, fps=8, hold=1.5, cell=14)
    height, width, _ = render.rgb(scene(EPISODE, 0), cell=14).shape
    ffmpeg = imageio_ffmpeg.get_ffmpeg_exe()
    decode = [ffmpeg, "-i", path, *("-f", "rawvideo", "-pix_fmt", "rgb24"), "-"]
    decoded = subprocess.run(decode, capture_output=True, check=True)
    report = decoded.stderr.decode()
    for fact in ("Video: h264", "yuv420p(tv, bt709", f" {width}x{height}", " 8 fps"):
        assert fact in report
    shown = np.frombuffer(decoded.stdout, np.uint8).reshape(-1, height, width, 3)
    assert len(shown) == EPISODE.length + 1 + 12
    for step, picture in enumerate(shown[: EPISODE.length + 1]):
        wanted = render.rgb(scene(EPISODE, step), cell=14)
        assert np.abs(picture.astype(int) - wanted).mean() < 4, step
        for name in ("PURSUER", "EVADER", "OBSTACLE", "PAPER"):
            colour = render_color(name)
            seen = np.median(picture[(wanted == colour).all(axis=2)], axis=0)
            assert np.abs(seen - colour).max() <= 4, (step, name)
    assert os.listdir(tmp_path) == ["episode.mp4"]


@pytest.mark.parametrize("suffix", ["gif", "mp4"])
def test_an_error_while_drawing_keeps_the_old_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, suffix: str
) -> None:
    path = tmp_path / f"old.{suffix}"
    path.write_bytes(b"kept")

    def draw(drawn: render.Scene, **look: object) -> np.ndarray:
        if drawn.title.startswith("step 9 "):
            raise MemoryError("step 9")
        return render.rgb(drawn, cell=9)

    monkeypatch.setattr("matrixworld.episodes.replay.rgb", draw)
    with pytest.raises(MemoryError, match="step 9"):
        save(EPISODE, path)
    assert [(each.name, each.read_bytes()) for each in tmp_path.iterdir()] == [(path.name, b"kept")]


def test_a_film_needs_the_extra(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "imageio_ffmpeg", None)
    (tmp_path / "old.mp4").write_bytes(b"kept")
    with pytest.raises(ImportError, match=r"pip install 'matrixworld-pursuit\[video\]'"):
        save(EPISODE, tmp_path / "old.mp4")
    assert [(path.name, path.read_bytes()) for path in tmp_path.iterdir()] == [("old.mp4", b"kept")]


def test_a_picture_of_one_moment(tmp_path: Path) -> None:
    save(EPISODE, tmp_path / "7.PNG", step=7, cell=9, fov=5, viewers=["evader_0", 1])
    wanted = render.rgb(scene(EPISODE, 7), cell=9, fov=5, viewers=[5, 1])
    with Image.open(tmp_path / "7.PNG") as image:
        assert (np.array(image) == wanted).all()


def test_pictures_with_numbers(tmp_path: Path) -> None:
    save(EPISODE, tmp_path / "7.png", step=7, numbers=True)
    wanted = render.rgb(scene(EPISODE, 7), numbers=True)
    with Image.open(tmp_path / "7.png") as image:
        assert (np.array(image) == wanted).all()
    save(EPISODE, tmp_path / "all.gif", every=30, numbers=True)
    assert (next(frames(tmp_path / "all.gif"))[0].shape) == wanted.shape
    wide = random_walks(rows=40, cols=40, steps=2)
    with Image.open(io.BytesIO(animation(wide, numbers=True).data)) as image:
        assert image.size == (40 * 20 + 24, 40 * 20 + 50)
    assert contact_sheet(wide, numbers=True).width == 3 * (40 * 20 + 24)


def test_a_moment_in_a_terminal_or_a_file() -> None:
    file = io.StringIO()
    print_moment(EPISODE, file, step=-3)
    assert file.getvalue() == render.ansi(scene(EPISODE, 28), color="none") + "\n"


def test_a_field_of_view_is_as_large_as_the_world_says(tmp_path: Path) -> None:
    episode = mw.record(mw.WorldConfig(rows=12, cols=12, fov=5), "still", "still", seed=0)
    save(episode, tmp_path / "own.png", viewers=[0])
    save(episode, tmp_path / "five.png", viewers=[0], fov=5)
    save(episode, tmp_path / "seven.png", viewers=[0], fov=7)
    own, five, seven = ((tmp_path / f"{n}.png").read_bytes() for n in ("own", "five", "seven"))
    assert own == five != seven


def test_save_refuses_another_kind_of_file_and_moment(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match=r"^path: .* ends in .gif, .mp4 or .png, got episode.avi"):
        save(EPISODE, "episode.avi")
    with pytest.raises(IndexError):
        save(EPISODE, tmp_path / "no.png", step=31)
    assert os.listdir(tmp_path) == []


def test_a_notebook_shows_an_animation() -> None:
    long = random_walks(rows=40, cols=40, pursuers=8, evaders=30, steps=500)
    shown = animation(long)
    with Image.open(io.BytesIO(shown.data)) as image:
        assert image.n_frames == 101
        assert image.size == (504, 530)
    assert len(shown.data) < 1_500_000
    assert repr(shown) == f"<Animation: a GIF of {len(shown.data) / 1000:.0f} kB>"
    encoded = re.fullmatch(r'<img src="data:image/gif;base64,(.*)" alt=".+">', shown._repr_html_())
    assert encoded is not None
    assert base64.b64decode(encoded[1]) == shown.data
    with Image.open(io.BytesIO(animation(EPISODE, every=7).data)) as image:
        assert image.n_frames == 6
    with Image.open(io.BytesIO(animation(random_walks(3, 3, 1, 1, steps=2)).data)) as image:
        assert image.size == (464, 3 * 48 + 50)  # not larger than any other picture


def test_a_contact_sheet_runs_from_first_to_last() -> None:
    sheet = contact_sheet(EPISODE, rows=2, cols=3, cell=14)
    single = render.rgb(scene(EPISODE, 0), cell=14)
    height, width, _ = single.shape
    assert isinstance(sheet, Image.Image)  # which a notebook shows
    sheet = np.array(sheet)
    assert sheet.shape == (2 * height, 3 * width, 3)
    assert (sheet[:height, :width] == single).all()
    assert (sheet[height:, 2 * width :] == render.rgb(scene(EPISODE), cell=14)).all()
    views = np.array(contact_sheet(EPISODE, cell=14, trail=0, fov=3, viewers=["evader_1"]))
    seen = render.rgb(scene(EPISODE, 0, trail=0), cell=14, fov=3, viewers=[6])
    assert (views[:height, :width] == seen).all()
    with pytest.raises(ValueError, match="rows: expected at least 1, got 0"):
        contact_sheet(EPISODE, rows=0)


# -- terminal ----------------------------------------------------------------------------------


class Terminal(io.StringIO):
    """A stream that says it is a terminal."""

    encoding = "utf-8"

    def isatty(self) -> bool:
        return True


@pytest.fixture
def naps(monkeypatch: pytest.MonkeyPatch) -> list[float]:
    """Collect the pauses instead of taking them; the terminal has 100 columns and 50 lines."""
    taken: list[float] = []
    monkeypatch.setattr("time.sleep", taken.append)
    for name, value in {"COLUMNS": "100", "LINES": "50", "COLORTERM": "", "TERM": "xterm"}.items():
        monkeypatch.setenv(name, value)
    monkeypatch.delenv("NO_COLOR", raising=False)
    return taken


def test_animation_in_a_terminal(naps: list[float]) -> None:
    out = Terminal()
    animate_terminal(EPISODE, out, fps=20)
    pictures = out.getvalue().split(term.HOME)
    assert pictures[0] == term.HIDE_CURSOR + term.WRAP_OFF + term.CLEAR
    assert len(pictures) - 1 == len(naps) == EPISODE.length + 1
    assert all(0 <= nap <= 0.05 * (i + 1) for i, nap in enumerate(naps))
    for step, picture in enumerate(pictures[1:]):
        drawn = render.ansi(scene(EPISODE, step), color="256")
        assert picture.startswith(drawn.replace("\n", term.CLEAR_LINE + "\n"))
        bare = re.sub(r"\x1b\[[0-9;?]*[A-Za-z]", "", picture).rstrip("\n").split("\n")
        assert bare[0].startswith(f"step {step} of 30")
        assert len(bare) == 1 + 12
        assert {len(line) for line in bare[1:]} == {2 * 16}
    assert out.getvalue().endswith(term.WRAP_ON + term.SHOW_CURSOR + "\n")


def test_ctrl_c_ends_cleanly(naps: list[float], monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(_: float) -> None:
        naps.append(0)
        if len(naps) == 3:
            raise KeyboardInterrupt

    monkeypatch.setattr("time.sleep", interrupted)
    out = Terminal()
    animate_terminal(EPISODE, out)
    assert out.getvalue().count(term.HOME) == 3
    assert out.getvalue().endswith(term.WRAP_ON + term.SHOW_CURSOR + "\n")


def test_the_cursor_comes_back_after_an_error(
    naps: list[float], monkeypatch: pytest.MonkeyPatch
) -> None:
    def broken(_: float) -> None:
        raise OSError("gone")

    monkeypatch.setattr("time.sleep", broken)
    out = Terminal()
    with pytest.raises(OSError, match="gone"):
        animate_terminal(EPISODE, out)
    assert out.getvalue().endswith(term.SHOW_CURSOR + "\n")


def test_a_small_terminal_gets_half_blocks_cut_to_its_height(
    naps: list[float], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "20")
    monkeypatch.setenv("LINES", "6")
    out = Terminal()
    animate_terminal(EPISODE, out, every=30)
    last = re.sub(r"\x1b\[[0-9;?]*[A-Za-z]", "", out.getvalue().split(term.HOME)[-1])
    assert last.rstrip("\n").split("\n")[1:] == ["▀" * 16] * 4
    assert len(naps) == 2


def test_no_terminal_gets_the_last_moment_as_plain_text(capsys: pytest.CaptureFixture[str]) -> None:
    animate_terminal(EPISODE)
    printed = capsys.readouterr().out
    assert printed == render.ansi(scene(EPISODE), color="none") + "\n"
    assert printed.isascii()


def test_which_colours_a_stream_may_have() -> None:
    terminal = Terminal()
    assert term.color_mode(terminal, {}) == "256"
    assert term.color_mode(terminal, {"COLORTERM": "truecolor"}) == "true"
    assert term.color_mode(terminal, {"COLORTERM": "truecolor", "NO_COLOR": "1"}) == "none"
    assert term.color_mode(terminal, {"TERM": "dumb"}) == "none"
    assert term.color_mode(io.StringIO(), {"COLORTERM": "truecolor"}) == "none"
    terminal.encoding = "ascii"
    assert term.color_mode(terminal, {}) == "none"
