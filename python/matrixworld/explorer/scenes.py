"""Scenes of the playground as text, which follows ``#`` in a link, and the examples of the gallery.

A scene has the parts below, joined by ``&``; parts that have their default are left out.

==========  ========================================================================================
rules       a variant, or the fields of `Rules` in their order, joined by ``.``
others      the rules to compare with, likewise
rewards     ``paper``, ``published``, or the fields of `Rewards` in their order, joined by ``_``
size        rows and columns: ``3x5``
diagonal    ``1`` for eight directions
fov         side of the fields of view; the default is 11
limit       steps of an episode; the default is 500
seed        seed, episode and number of steps so far: ``0.0.0``
ended       ``1`` if the episode has ended
walls       cells of the obstacles: ``0.3_1.3``
pursuers    cells of the agents: ``0.0_0.2``; ``x`` marks one that is gone and disappeared there,
evaders     ``c`` an evader that is captured, ``e`` one that was
played      the steps since then, in each a character for each agent: an action, or a script's
            letter: ``a`` for the first of `SCRIPTS` and so on
next        what the agents do next, likewise
==========  ========================================================================================

>>> import matrixworld as mw
>>> world = mw.World("SB", rows=2, cols=4, n_pursuers=2, n_evaders=1)
>>> world.reset(0, pursuers=[[0, 0], [0, 2]], evaders=[[1, 3]])
>>> scene_link(world, [mw.Action.EAST, mw.Action.WEST, "fleer"])
'rules=SB&size=2x4&pursuers=0.0_0.2&evaders=1.3&next=24d'
"""

from __future__ import annotations

import json
import warnings
from collections.abc import Sequence
from dataclasses import astuple, dataclass
from enum import Enum
from pathlib import Path

import numpy as np

from matrixworld._util.checks import check_choice, check_instance, check_integer
from matrixworld._util.files import load_toml
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import SCRIPTS
from matrixworld.world.rules import REWARDS, Action, Rewards, Rules, rules_of, variant_name
from matrixworld.world.world import World

MOST_SIDE = 64
"""The most rows and columns of a scene."""
MOST_AGENTS = 100
"""The most agents of a team."""
DEFAULTS = {"diagonal": "0", "fov": "11", "limit": "500", "seed": "0.0.0", "rewards": "paper"}

Command = int | str
"""What an agent does in a step: an `Action`, or what a script decides."""


def scene_link(
    world: World,
    actions: Sequence[Command] | None = None,
    *,
    compare: Rules | str | None = None,
) -> str:
    """Return the scene that a world is in, between two rounds; it goes on there as it would here.

    An action is an `Action` or the name of a script; by default all agents stay. With rules to
    compare with, a second board plays the same actions.
    """
    check_instance("world", world, World)
    _check_size(world)
    config = world.config
    parts = {
        "rules": _rules_text(config.rules),
        "others": "" if compare is None else _rules_text(rules_of(compare)),
        "rewards": _rewards_text(config.rewards),
        "size": f"{config.rows}x{config.cols}",
        "diagonal": str(int(config.diagonal)),
        "fov": str(config.fov),
        "limit": str(config.max_steps),
        "seed": f"{world.seed}.{world.episode}.{world.steps}",
        "ended": "1" if world.terminated else "",
        "walls": "_".join(f"{row}.{col}" for row, col in zip(*world.map.nonzero(), strict=True)),
        **_agents_text(world),
        "next": "" if actions is None else _commands_text(config, actions),
    }
    return "&".join(
        f"{name}={text}" for name, text in parts.items() if text and text != DEFAULTS.get(name)
    )


def _check_size(world: World) -> None:
    config = world.config
    if world.turn:
        raise ValueError(f"world: expected the end of a round, got turn {world.turn}")
    for names, most in ((("rows", "cols"), MOST_SIDE), (("n_pursuers", "n_evaders"), MOST_AGENTS)):
        for name in names:
            check_integer(f"world, {name}", getattr(config, name), 1, most)


def _agents_text(world: World) -> dict[str, str]:
    texts = [f"{row}.{col}" for row, col in world.last_positions.tolist()]
    first = world.config.n_pursuers
    for evader, (now, ever) in enumerate(zip(world.captured, world.ever_captured, strict=True)):
        texts[first + evader] += "c" if now else "e" if ever else ""
    texts = [text + ("" if alive else "x") for text, alive in zip(texts, world.alive, strict=True)]
    return {"pursuers": "_".join(texts[:first]), "evaders": "_".join(texts[first:])}


def _commands_text(config: WorldConfig, actions: Sequence[Command]) -> str:
    if len(actions) != config.n_agents:
        raise ValueError(f"actions: expected {config.n_agents} (agents), got {len(actions)}")
    text = "".join(_command_text(config, action) for action in actions)
    return text if text.strip("0") else ""


def _command_text(config: WorldConfig, action: Command) -> str:
    if isinstance(action, str):
        check_choice("actions", action, SCRIPTS)
        return chr(ord("a") + [str(script) for script in SCRIPTS].index(action))
    return str(check_integer("actions", action, 0, config.n_actions - 1))


def _rules_text(rules: Rules) -> str:
    return variant_name(rules) or ".".join(map(_field_text, astuple(rules))).lower()


def _rewards_text(rewards: Rewards) -> str:
    known = (name for name, each in REWARDS.items() if each == rewards)
    return next(known, "_".join(map(_field_text, astuple(rewards))))


def _field_text(value: object) -> str:
    """Return a value as JavaScript writes it."""
    if isinstance(value, tuple):
        return ",".join(map(_field_text, value))
    if isinstance(value, Enum):
        return value.name
    return json.dumps(value).removesuffix(".0")


# ---- The gallery ---------------------------------------------------------------------------------

ARROWS = {"^": Action.NORTH, ">": Action.EAST, "v": Action.SOUTH, "<": Action.WEST}


@dataclass(frozen=True)
class Example:
    """A scene of the gallery, which teaches one thing."""

    title: str
    ask: str  # what to predict
    text: str  # what happens, and what to try
    rules: str
    drawing: str
    moves: str  # what agents do next, such as "A> b^", or a script: "A=chaser"; the others stay
    compare: str | None = None

    @property
    def commands(self) -> list[int | str]:
        """What each agent does next."""
        letters = sorted(letter for letter in self.drawing if letter.isalpha())
        moves = {move[0]: move[1:] for move in self.moves.split()}
        return [_command(moves.get(letter, "")) for letter in letters]

    @property
    def scene(self) -> str:
        """The scene as it stands in a link."""
        world = drawn_world(self.rules, self.drawing)
        return scene_link(world, self.commands, compare=self.compare)


def _command(text: str) -> int | str:
    return text[1:] if text.startswith("=") else ARROWS.get(text, Action.STAY)


def drawn_world(rules: Rules | str, drawing: str) -> World:
    """Return the world of a drawing.

    Rows are lines, or separated by slashes, and cells by spaces: ``.`` is free, ``#`` an obstacle;
    ``A``, ``B``, ... are pursuers and ``a``, ``b``, ... evaders, in the order of their numbers.
    """
    cells = [row.split() for row in drawing.replace("/", "\n").splitlines()]
    agents = {
        cell: (row, col)
        for row, line in enumerate(cells)
        for col, cell in enumerate(line)
        if cell.isalpha()
    }
    teams = [
        [agents[letter] for letter in sorted(agents) if letter.isupper() == upper]
        for upper in (True, False)
    ]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # rules that capture no evader may be what a scene is about
        world = World(
            rules,
            n_pursuers=len(teams[0]),
            n_evaders=len(teams[1]),
            obstacles=np.array([[cell == "#" for cell in line] for line in cells]),
        )
    world.reset(0, pursuers=teams[0], evaders=teams[1])
    return world


GALLERY = tuple(
    Example(**{**row, **{name: " ".join(row[name].split()) for name in ("ask", "text")}})
    for row in load_toml(Path(__file__).with_name("gallery.toml"))["example"]
)
"""The examples, in the order of the page."""
