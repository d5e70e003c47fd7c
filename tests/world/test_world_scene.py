"""A world as a drawing."""

from __future__ import annotations

import io

import numpy as np
from PIL import Image

import matrixworld as mw
from matrixworld.episodes.render import ansi, rgb


def jam() -> mw.World:
    """Return a world in which two pursuers have just bounced."""
    world = mw.World("B", rows=3, cols=5, n_pursuers=3, n_evaders=2, obstacles=["....#"] * 3)
    world.reset(pursuers=[(0, 0), (0, 2), (2, 2)], evaders=[(2, 3), (1, 0)])
    world.step([2, 4, 2, 0, 0])
    return world


def test_the_scene_is_the_moment_of_the_world() -> None:
    world = jam()
    scene = world.scene("a jam")
    assert scene.title == "a jam"
    assert scene.n_pursuers == 3
    for name in ("alive", "captured", "map", "involved", "fault"):
        assert np.array_equal(getattr(scene, name), getattr(world, name)), name
    assert np.array_equal(scene.positions, world.last_positions)
    assert scene.collided()[0] == {(0, 0), (0, 2)}
    drawn = ansi(scene, color="none").splitlines()[1:]
    assert [line[::2] for line in drawn] == str(world).splitlines()


def test_a_notebook_shows_a_scene_as_its_picture() -> None:
    scene = jam().scene()
    shown = np.array(Image.open(io.BytesIO(scene._repr_png_())))
    assert np.array_equal(shown, rgb(scene))
