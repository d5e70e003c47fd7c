"""Episodes and environments as they are shown: scenes, GIFs, films, terminals, notebooks."""

import base64
import io
import os
import re
import subprocess
import sys

import imageio_ffmpeg
import numpy as np
import pytest
from PIL import Image, ImageColor

import matrixworld as mw
from matrixworld._util import colors
from matrixworld.episodes import replay as term
from matrixworld.episodes.replay import animate_terminal, animation, save, scene
from matrixworld.world import render
from rows import config_of, random_walks

EPISODE = random_walks()


@pytest.fixture
def naps(monkeypatch):
    taken = []
    monkeypatch.setattr("time.sleep", taken.append)
    monkeypatch.setattr("time.monotonic", lambda: 5.0)
    return taken


@pytest.fixture
def terminal(naps, monkeypatch, capsys):
    """What is printed goes to a terminal of 100 columns, 50 lines and 256 colours."""
    variables = {"COLUMNS": "100", "LINES": "50", "TERM": "xterm"}
    for name, value in variables.items():
        monkeypatch.setenv(name, value)
    monkeypatch.delenv("NO_COLOR", raising=False)
    monkeypatch.setattr(type(sys.stdout), "isatty", lambda stream: True)
    return capsys


def test_scenes_follow_the_episode():
    first, last = scene(EPISODE, 0), scene(EPISODE)
    assert first.title == "step 0 of 30    captured 0 of 7 (0%)"
    assert first.fault is None
    assert (first.positions == EPISODE.positions[0]).all()
    caught = round(EPISODE.capture_rate * 7)
    assert last.title == f"step 30 of 30    captured {caught} of 7 ({caught / 7:.0%})"
    assert (last.fault == EPISODE.fault[-1]).all()
    assert (scene(EPISODE, 9, trail=4).trail == EPISODE.positions[5:9]).all()
    with pytest.raises(IndexError):
        scene(EPISODE, 31)
    with pytest.raises(ValueError, match="^trail: expected .*, got -1"):
        scene(EPISODE, 3, trail=-1)


def test_a_gif_shows_every_step(tmp_path):
    path, small = tmp_path / "episode.gif", np.uint8  # which would overflow in sums of pixels
    save(EPISODE, path, fps=small(8), cell=small(14))
    with Image.open(path) as image:
        assert image.n_frames == EPISODE.length + 1
        assert image.info["loop"] == 0
        for step in range(image.n_frames):
            image.seek(step)
            assert image.info["duration"] == (120 if step < 30 else 2120)
            picture = np.array(image.convert("RGB"))
            wanted = render.rgb(scene(EPISODE, step), cell=14)
            off = np.abs(picture.astype(int) - wanted.astype(int)).max(axis=2)
            assert (off > 48).mean() < 0.002, step  # blends at edges share a few colours
            for colour in (colors.PURSUER, colors.EVADER, colors.PAPER):
                exact = (wanted == ImageColor.getrgb(colour)).all(axis=2)
                assert (picture[exact] == ImageColor.getrgb(colour)).all(), step
    assert os.listdir(tmp_path) == ["episode.gif"]


def test_a_film_shows_every_step(tmp_path):
    path = tmp_path / "episode.mp4"
    save(EPISODE, path, fps=8, cell=14)
    height, width, _ = render.rgb(scene(EPISODE, 0), cell=14).shape
    ffmpeg = imageio_ffmpeg.get_ffmpeg_exe()
    decode = [ffmpeg, "-i", path, *("-f", "rawvideo", "-pix_fmt", "rgb24"), "-"]
    decoded = subprocess.run(decode, capture_output=True, check=True)
    report = decoded.stderr.decode()
    for fact in ("Video: h264", "yuv420p(tv, bt709", f" {width}x{height}", " 8 fps"):
        assert fact in report
    shown = np.frombuffer(decoded.stdout, np.uint8).reshape(-1, height, width, 3)
    assert len(shown) == EPISODE.length + 1 + 16
    for step, picture in enumerate(shown[: EPISODE.length + 1]):
        wanted = render.rgb(scene(EPISODE, step), cell=14)
        assert np.abs(picture.astype(int) - wanted).mean() < 4, step
        for name in (colors.PURSUER, colors.EVADER, colors.OBSTACLE, colors.PAPER):
            colour = ImageColor.getrgb(name)
            seen = np.median(picture[(wanted == colour).all(axis=2)], axis=0)
            assert np.abs(seen - colour).max() <= 4, (step, name)
    assert os.listdir(tmp_path) == ["episode.mp4"]


@pytest.mark.parametrize("suffix", ["gif", "mp4"])
def test_an_error_while_drawing_keeps_the_old_file(tmp_path, monkeypatch, suffix):
    path = tmp_path / f"old.{suffix}"
    path.write_bytes(b"kept")

    def draw(drawn, **look):
        if drawn.title.startswith("step 9 "):
            raise MemoryError("step 9")
        return render.rgb(drawn, cell=9)

    monkeypatch.setattr("matrixworld.episodes.episode.rgb", draw)
    with pytest.raises(MemoryError, match="step 9"):
        save(EPISODE, path)
    assert [(each.name, each.read_bytes()) for each in tmp_path.iterdir()] == [(path.name, b"kept")]


def test_a_picture_of_one_moment(tmp_path):
    save(EPISODE, tmp_path / "7.PNG", step=7, cell=9)
    with Image.open(tmp_path / "7.PNG") as image:
        assert (np.array(image) == render.rgb(scene(EPISODE, 7), cell=9)).all()


def test_a_notebook_shows_an_animation():
    shown = animation(random_walks(40, 40, 8, 30, steps=500))
    with Image.open(io.BytesIO(shown.data)) as image:
        assert (image.n_frames, image.size) == (101, (504, 530))
    assert len(shown.data) < 30_000 + 101 * 8_000  # a long episode is stored in a notebook, too
    encoded = re.fullmatch(r'<img src="data:image/gif;base64,(.*)" alt=".+">', shown._repr_html_())
    assert encoded is not None
    assert base64.b64decode(encoded[1]) == shown.data


def test_the_cursor_comes_back_after_ctrl_c(naps, terminal, monkeypatch):
    def stop(seconds):
        naps.append(seconds)
        if len(naps) == 3:
            raise KeyboardInterrupt

    monkeypatch.setattr("time.sleep", stop)
    animate_terminal(EPISODE)  # the viewer has seen enough
    printed = terminal.readouterr().out
    assert printed.count(term.HOME) == 3
    for step in range(3):
        assert render.ansi(scene(EPISODE, step)).replace("\n", term.CLEAR_LINE + "\n") in printed
    assert printed.endswith(term.WRAP_ON + term.SHOW_CURSOR + "\n")


def test_without_display_or_terminal_it_is_plain_text(naps, capsys):
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
