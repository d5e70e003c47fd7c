"""The playground: conflicts on a small board, step by step, under any rules.

>>> import matrixworld as mw
>>> from matrixworld.explorer import Playground
>>> world = mw.World("SB", rows=3, cols=5, n_pursuers=2, n_evaders=1)
>>> world.reset(0, pursuers=[[0, 0], [0, 2]], evaders=[[2, 4]])
>>> Playground(world, ["hunter", mw.Action.WEST, "fleer"]).url()
'playground.html#rules=SB&size=3x5&pursuers=0.0_0.2&evaders=2.4&next=f4d'
"""

from __future__ import annotations

import os
import re
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from enum import Enum
from inspect import cleandoc
from pathlib import Path
from typing import Any

from matrixworld.envs.variants import VARIANT_TEXTS
from matrixworld.episodes.render import png
from matrixworld.episodes.render.canvas import SMALLEST_NUMBERED, fitting_cell
from matrixworld.explorer.page import mime_bundle, render_page, write_page
from matrixworld.explorer.scenes import GALLERY, Command, drawn_world, scene_link
from matrixworld.world.policy import SCRIPT_TEXTS
from matrixworld.world.rules import (
    CAPTURE_TEXTS,
    INTERACTION_TEXTS,
    OUTCOME_TEXTS,
    REWARDS,
    VARIANTS,
    Capture,
    Interaction,
    Outcome,
    Rewards,
    Rules,
)
from matrixworld.world.world import World

PAGE = "playground.html"
"""Name of the page where no other is given."""
PIXELS = 400
"""Wanted length of the longer side of the picture of a scene."""

LABELS = {
    "interaction": "Agents move",
    "obstacle": "Obstacle or border: agent",
    "teammate": "Teammates collide: both",
    "evader": "Adversaries collide: evader",
    "pursuer": "Adversaries collide: pursuer",
    "capture": "Evaders are captured by",
    "captured_disappear": "A surrounded evader",
}
"""The fields of `Rules`, as the page names them."""

VALUES: Mapping[type, Mapping[Any, str]] = {
    Interaction: INTERACTION_TEXTS,
    Outcome: {outcome: text.split()[0] for outcome, text in OUTCOME_TEXTS.items()},
    Capture: CAPTURE_TEXTS,
    bool: {False: "stays", True: "disappears"},
}
"""The values of fields by their type, as the page names them."""

DOCUMENTED = re.compile(r"^([\w, ]+) : .*\n((?: {4}.+\n)+)", re.MULTILINE)
"""Names of parameters in a docstring, and their text."""


class Playground:
    """A scene of the playground: a link to it, a page that begins with it, a frame in a notebook.

    Parameters
    ----------
    world : World, optional
        A world between two rounds; in the playground it goes on as it would here. By default the
        page begins with its first example.
    actions : sequence, shape (A,), optional
        What each agent does next: an `Action`, or the name of a script. By default all stay.
    compare : Rules or str, optional
        Rules to compare with, or the name of a variant: a second board plays the same actions.

    Attributes
    ----------
    scene : str
        The scene as it stands in a link; see `matrixworld.explorer.scenes`.
    picture : bytes
        The scene as a PNG file: what a notebook shows where it shows no frame.

    Raises
    ------
    ValueError, TypeError
        If the world is in the middle of a round or too large, or another argument is not valid.
    """

    def __init__(
        self,
        world: World | None = None,
        actions: Sequence[Command] | None = None,
        *,
        compare: Rules | str | None = None,
    ) -> None:
        if world is None and (actions is not None or compare is not None):
            raise ValueError("world: expected a world together with actions or compare, got None")
        self.scene = "" if world is None else scene_link(world, actions, compare=compare)
        # Drawn now: the world may go on.
        shown = drawn_world(GALLERY[0].rules, GALLERY[0].drawing) if world is None else world
        cell = fitting_cell((shown.config.rows, shown.config.cols), PIXELS, SMALLEST_NUMBERED)
        self.picture = png(shown.scene(), cell=cell, numbers=True)

    def url(self, page: str | os.PathLike[str] = PAGE) -> str:
        """Return a link to the scene in a page that was written before.

        Parameters
        ----------
        page : str or path, optional
            Address of the page. The default is ``playground.html``.
        """
        return f"{os.fspath(page)}#{self.scene}"

    def html(self) -> str:
        """Return the page, which begins with the scene."""
        return render_page("playground", "matrixworld playground", page_data(self.scene))

    def save(self, path: str | os.PathLike[str], *, force: bool = False) -> None:
        """Write the page.

        Parameters
        ----------
        path : str or path
            The file.
        force : bool, optional
            Whether to replace a file that exists. The default is False.

        Raises
        ------
        FileExistsError
            If the file exists.
        """
        if Path(path).exists() and not force:
            raise FileExistsError(f"{os.fspath(path)}: exists; force=True replaces it")
        write_page(path, self.html())

    def __repr__(self) -> str:
        return f"<Playground: {self.scene or 'the first example'}>"

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> dict[str, str]:
        return mime_bundle(self.html(), "playground", self.picture)


def page_data(scene: str = "") -> dict[str, Any]:
    """Return what the page knows of the package: rules, scripts, rewards and examples."""
    return {
        "variants": {name: _plain(rules) for name, rules in VARIANTS.items()},
        "titles": {name: VARIANT_TEXTS[name].title for name in VARIANTS},
        "fields": [_field(name) for name in LABELS],
        "rewards": {name: _plain(rewards) for name, rewards in REWARDS.items()},
        "scripts": [{"name": name, "text": text} for name, text in SCRIPT_TEXTS.items()],
        "gallery": [
            {"title": each.title, "ask": each.ask, "text": each.text, "scene": each.scene}
            for each in GALLERY
        ],
        "scene": scene,
    }


def _plain(row: Rules | Rewards) -> dict[str, Any]:
    return {
        name: value.name if isinstance(value, Enum) else value
        for name, value in asdict(row).items()
    }


def _field(name: str) -> dict[str, Any]:
    """Return a field of `Rules`: its label, its documentation and its values."""
    texts = VALUES[type(getattr(Rules(), name))]
    values = [
        {"name": value.name if isinstance(value, Enum) else str(value).lower(), "label": text}
        for value, text in texts.items()
    ]
    text = _documented().get(name, "")  # without docstrings (python -OO) there are none
    return {"name": name, "label": LABELS[name], "text": text, "values": values}


def _documented() -> dict[str, str]:
    """Return the texts of the fields in the docstring of `Rules`."""
    texts: dict[str, str] = {}
    for names, text in DOCUMENTED.findall(cleandoc(Rules.__doc__ or "")):
        texts |= dict.fromkeys(names.split(", "), " ".join(text.split()))
    return texts
