"""Scenes of the playground as text: what follows ``#`` in a link.

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

from collections.abc import Sequence
from dataclasses import astuple

from matrixworld._util.checks import check_choice, check_instance, check_integer
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import SCRIPTS
from matrixworld.world.rules import VARIANTS, Rewards, Rules, rules_of
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
    """Return the scene that a world is in.

    Parameters
    ----------
    world : World
        A world between two rounds. In the playground it goes on as it would here.
    actions : sequence, shape (A,), optional
        What each agent does next: an `Action`, or the name of a script. By default all stay.
    compare : Rules or str, optional
        Rules to compare with, or the name of a variant: a second board plays the same actions.

    Returns
    -------
    str
        The scene, which follows ``#`` in a link to the playground.

    Raises
    ------
    ValueError
        If the world is in the middle of a round or too large, or an action or a name is unknown.
    TypeError
        If an argument has another type.
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
    """Return the cells of both teams."""
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
    for name, known in VARIANTS.items():
        if rules == known:
            return name
    return ".".join(str(getattr(value, "name", value)).lower() for value in astuple(rules))


def _rewards_text(rewards: Rewards) -> str:
    for name, known in (("paper", Rewards.paper()), ("published", Rewards.published())):
        if rewards == known:
            return name
    return "_".join(_reward_text(value) for value in astuple(rewards))


def _reward_text(value: object) -> str:
    """Return a value as JavaScript writes it."""
    if isinstance(value, tuple):
        return ",".join(map(_reward_text, value))
    if isinstance(value, bool):
        return str(value).lower()
    return repr(value).removesuffix(".0") if isinstance(value, float) else str(value.name)  # type: ignore[attr-defined]
