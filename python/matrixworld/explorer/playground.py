"""The playground: an agent to play, and conflicts on a small board, step by step, under any rules.

>>> import matrixworld as mw
>>> from matrixworld.explorer import Playground
>>> world = mw.World("SB", rows=3, cols=5, n_pursuers=2, n_evaders=1)
>>> world.reset(0, pursuers=[[0, 0], [0, 2]], evaders=[[2, 4]])
>>> Playground(world, ["hunter", mw.Action.WEST, "fleer"]).url()
'playground.html#rules=SB&size=3x5&pursuers=0.0_0.2&evaders=2.4&next=f4d'

A scene follows ``#`` in a link. It has the parts below, joined by ``&``; parts that have their
default are left out.

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
"""

from __future__ import annotations

import json
import os
import re
import warnings
from collections.abc import Mapping, Sequence
from dataclasses import astuple
from enum import Enum
from inspect import cleandoc
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from matrixworld._util.checks import check_choice, check_instance, check_integer
from matrixworld._util.files import load_toml
from matrixworld.coevolution.evaluation.held_out import held_out
from matrixworld.coevolution.saved_run import SavedRun
from matrixworld.coevolution.types import TEAMS, Team
from matrixworld.envs import VARIANT_TEXTS
from matrixworld.explorer.page import mime_bundle, render_page, write_page
from matrixworld.explorer.teams import kept_generations, packed, plain_policy, step_of
from matrixworld.version import __version__
from matrixworld.world.canvas import SMALLEST_NUMBERED, fitting_cell
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import SCRIPT_TEXTS, SCRIPTS, Population, Script, TeamPolicy
from matrixworld.world.render import png
from matrixworld.world.rules import (
    CAPTURE_TEXTS,
    INTERACTION_TEXTS,
    OUTCOME_TEXTS,
    REWARDS,
    VARIANTS,
    Action,
    Capture,
    Interaction,
    Outcome,
    Rewards,
    Rules,
    rules_of,
    variant_name,
)
from matrixworld.world.world import World

PAGE = "playground.html"  # name of the page where no other is given
DATA = load_toml(Path(__file__).with_name("playground.toml"))
"""Its examples, the rounds of its game, and what it calls the fields of `Rules`."""
PIXELS = 400  # wanted length of the longer side of the picture of a scene

Command = int | str  # what an agent does in a step: an `Action`, or what a script decides


class Playground:
    """A scene of the playground: a link to it, a page that begins with it, a frame in a notebook.

    In the playground a `world` between two rounds goes on as it would here; by default the page
    begins with its game "Can you escape it?". `actions` (A,) are what each agent does next, an
    `Action` or the name of a script; by default all stay. With rules to `compare` with, or the name
    of a variant, a second board plays the same actions.

    ValueError or TypeError if the world is in the middle of a round or too large, or another
    argument is not valid.
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
        # As it stands in a link, and as a notebook shows it where it shows no frame.
        self.scene = "" if world is None else scene_link(world, actions, compare=compare)
        first = DATA["example"][0]
        shown = world or drawn_world(first["rules"], first["drawing"])
        cell = fitting_cell((shown.config.rows, shown.config.cols), PIXELS, SMALLEST_NUMBERED)
        self.picture = png(shown.scene(), cell=cell, numbers=True)

    def url(self, page: str | os.PathLike[str] = PAGE) -> str:
        """Return a link to the scene in a `page` that was written before."""
        return f"{os.fspath(page)}#{self.scene}"

    def html(self) -> str:
        """Return the page, which begins with the scene if there is one."""
        return playground_page(self.scene, shipped("O"))

    def save(self, path: str | os.PathLike[str], *, force: bool = False) -> None:
        """Write the page at `path`; with `force` it may replace a file, else FileExistsError."""
        write_page(path, self.html(), force=force)

    def __repr__(self) -> str:
        return f"<Playground: {self.scene or 'Can you escape it?'}>"

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> dict[str, str]:
        return mime_bundle(self.html(), "playground", self.picture)


def playground_page(
    scene: str = "", opponents: Opponents | None = None, title: str = "matrixworld playground"
) -> str:
    """Return the page as HTML; it begins with the scene, if there is one.

    Without opponents it has no games, as where the explorer opens a step of a match in it.
    """
    play, genomes = (None, {}) if opponents is None else plain_opponents(opponents)
    data = {**page_data(scene), "title": title, "version": __version__, "play": play}
    return render_page("playground", title, data, genomes)


# ---- Opponents of a person -----------------------------------------------------------------------

LIVELY = "clumsy-fleer"
"""The evaders that a match begins with where they are there: the strongest are hardly caught."""
NETWORK_TEXT = "a network that evolved in a race"


class Opponents(NamedTuple):
    """A world, and what plays for each team in it, by name, roughly from weak to strong.

    Populations have one genome. Without rounds, three kinds of pursuers play in a smaller world.
    """

    world: WorldConfig
    players: Mapping[Team, Mapping[str, TeamPolicy]]
    rounds: Sequence[tuple[WorldConfig, Script]] = ()
    """Worlds of the game "Can you escape it?", each with the name of its pursuers."""


def shipped(variant: Rules | str) -> Opponents:
    """Return a world that suits a person, and the opponents that come with the package."""
    rules = rules_of(variant)
    # It takes up to four pursuers to surround an evader.
    sizes = (8, 4) if rules.capture is Capture.SURROUND else (4, 6)
    config = WorldConfig(
        rules, rows=20, cols=20, n_pursuers=sizes[0], n_evaders=sizes[1], max_steps=200
    )
    players = {team: _by_strength(held_out(team, rules)) for team in TEAMS}
    if rules.capture is Capture.SURROUND:
        return Opponents(config, players)
    rounds = [
        (WorldConfig(rules, n_evaders=1, **each["world"]), each["pursuers"])
        for each in DATA["round"]
    ]
    return Opponents(config, players, rounds)


def _by_strength(players: Mapping[str, TeamPolicy]) -> dict[str, TeamPolicy]:
    """Return players with the networks between weak and strong scripts (see docs/opponents.md)."""
    networks = [name for name, each in players.items() if isinstance(each, Population)]
    scripts = [name for name in players if name not in networks]
    return {name: players[name] for name in [*scripts[:2], *networks, *scripts[2:]]}


def of_run(run: SavedRun) -> Opponents:
    """Return the world of a run and its generations, as many as a page can hold."""
    step = step_of([run])
    players = {team: _generations(run.teams[team], step) for team in TEAMS}
    return Opponents(run.pursuit.world, players)


def _generations(team: TeamPolicy, step: int) -> dict[str, TeamPolicy]:
    if isinstance(team, str):
        return {team: team}
    kept = kept_generations(len(team.genomes), step)
    return {f"generation {g}": Population(team.genomes[g], team.policy) for g in kept}


def plain_opponents(opponents: Opponents) -> tuple[dict[str, Any], dict[str, bytes]]:
    """Return opponents as plain values, and the genomes of each team, as `packed` does."""
    teams, genomes = {}, dict[str, bytes]()
    for team in TEAMS:
        players = opponents.players[team]
        learned = [each for each in players.values() if isinstance(each, Population)]
        names = list(players)
        teams[team] = {
            "names": names,
            "texts": [_text(name, each) for name, each in players.items()],
            "usual": names.index(LIVELY) if LIVELY in names else len(names) - 1,
            # None stands for the next genome.
            "scripts": [each if isinstance(each, str) else None for each in players.values()],
            "policy": plain_policy(learned[0]) if learned else None,
        }
        if learned:
            genomes[team] = packed(np.concatenate([each.genomes for each in learned]))
    rounds = [
        {"world": world.to_json(), "pursuers": name, "text": SCRIPT_TEXTS[name]}
        for world, name in opponents.rounds
    ]
    return {"world": opponents.world.to_json(), "teams": teams, "rounds": rounds}, genomes


def _text(name: str, player: TeamPolicy) -> str:
    """Return what a player does; the generations of a run need no words."""
    if isinstance(player, str):
        return SCRIPT_TEXTS[player]
    return NETWORK_TEXT if name.startswith("evolved") else ""


# ---- What the page knows of the package ----------------------------------------------------------

VALUES: Mapping[type, Mapping[Any, str]] = {
    Interaction: INTERACTION_TEXTS,
    Outcome: {outcome: text.split()[0] for outcome, text in OUTCOME_TEXTS.items()},
    Capture: CAPTURE_TEXTS,
    bool: {False: "stays", True: "disappears"},
}
"""The values of fields by their type, as the page names them."""


def page_data(scene: str = "") -> dict[str, Any]:
    """Return what the page knows of the package: rules, scripts, rewards and examples."""
    documented = _documented()
    return {
        "variants": {name: _plain(rules) for name, rules in VARIANTS.items()},
        "titles": {name: VARIANT_TEXTS[name]["title"] for name in VARIANTS},
        "fields": [
            {
                "name": name,
                "label": label,
                "text": documented.get(name, ""),
                "values": [
                    {"name": getattr(value, "name", str(value).lower()), "label": text}
                    for value, text in VALUES[type(getattr(Rules(), name))].items()
                ],
            }
            for name, label in DATA["fields"].items()
        ],
        "rewards": {name: _plain(rewards) for name, rewards in REWARDS.items()},
        "scripts": [{"name": name, "text": text} for name, text in SCRIPT_TEXTS.items()],
        "gallery": [plain_example(example) for example in DATA["example"]],
        "scene": scene,
    }


def _plain(row: Rules | Rewards) -> dict[str, Any]:
    return {name: getattr(value, "name", value) for name, value in vars(row).items()}


def _documented() -> dict[str, str]:
    """Return the texts of the fields in the docstring of `Rules`; python -OO leaves none."""
    texts: dict[str, str] = {}
    parameter = re.compile(r"^([\w, ]+) : .*\n((?: {4}.+\n)+)", re.MULTILINE)
    for names, text in parameter.findall(cleandoc(Rules.__doc__ or "")):
        texts |= dict.fromkeys(names.split(", "), " ".join(text.split()))
    return texts


# ---- A scene as text -----------------------------------------------------------------------------

MOST = {"rows": 64, "cols": 64, "n_pursuers": 100, "n_evaders": 100}
"""The largest worlds of the playground."""
DEFAULTS = {"diagonal": "0", "fov": "11", "limit": "500", "seed": "0.0.0", "rewards": "paper"}


def scene_link(
    world: World, actions: Sequence[Command] | None = None, *, compare: Rules | str | None = None
) -> str:
    """Return the scene that a world is in, between two rounds; by default all agents stay next.

    With rules to compare with, a second board plays the same actions.
    """
    check_instance("world", world, World)
    config = world.config
    if world.turn:
        raise ValueError(f"world: expected the end of a round, got turn {world.turn}")
    for name, most in MOST.items():
        check_integer(f"world, {name}", getattr(config, name), 1, most)
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
    told = {name: text for name, text in parts.items() if text and text != DEFAULTS.get(name)}
    return "&".join(f"{name}={text}" for name, text in told.items())


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
    text = ""
    for action in actions:
        if isinstance(action, str):
            check_choice("actions", action, SCRIPTS)
            text += chr(ord("a") + SCRIPTS.index(action))
        else:
            text += str(check_integer("actions", action, 0, config.n_actions - 1))
    return text if text.strip("0") else ""


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


def drawn_world(rules: Rules | str, drawing: str) -> World:
    """Return the world of a drawing: rows between slashes or line ends, cells between spaces.

    ``#`` is an obstacle, ``A``, ``B``, ... are pursuers and ``a``, ``b``, ... evaders by number.
    """
    cells = np.array([row.split() for row in drawing.replace("/", "\n").splitlines()])
    found = {str(cells[cell]): cell for cell in np.ndindex(cells.shape) if cells[cell].isalpha()}
    pursuers, evaders = (
        [found[letter] for letter in sorted(found) if letter.isupper() == upper]
        for upper in (True, False)
    )
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # rules that capture no evader may be what a scene is about
        world = World(
            rules, n_pursuers=len(pursuers), n_evaders=len(evaders), obstacles=cells == "#"
        )
    world.reset(0, pursuers=pursuers, evaders=evaders)
    return world


ARROWS = {"^": Action.NORTH, ">": Action.EAST, "v": Action.SOUTH, "<": Action.WEST}


def plain_example(example: Mapping[str, str]) -> dict[str, str]:
    """Return the texts of an example in one line each, and its scene as it stands in a link."""
    letters = sorted(letter for letter in example["drawing"] if letter.isalpha())
    moves = {move[0]: move[1:] for move in example["moves"].split()}
    commands = [
        move[1:] if move.startswith("=") else ARROWS.get(move, Action.STAY)
        for move in (moves.get(letter, "") for letter in letters)
    ]
    world = drawn_world(example["rules"], example["drawing"])
    texts = {name: " ".join(example[name].split()) for name in ("title", "ask", "text")}
    return {**texts, "scene": scene_link(world, commands, compare=example.get("compare"))}
