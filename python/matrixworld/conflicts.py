"""The conflicts of a step, in words: why an agent bounced or disappeared."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from matrixworld.config import WorldConfig
from matrixworld.rules import KINDS

_FORMS = ("vertex", "edge", "chain")


@dataclass(frozen=True)
class Conflict:
    """A conflict of a step, between two agents or between an agent and an obstacle.

    Parameters
    ----------
    kind : str
        ``"obstacle"``, ``"teammate"`` or ``"adversary"``.
    form : str
        ``"vertex"``: both head for one cell. ``"edge"``: they swap cells. ``"chain"``: the first
        agent enters the cell of the second, which has to stay. Obstacles are ``"vertex"``.
    agents : tuple of int
        The two agents, or the agent that ran into an obstacle.
    cell : tuple of int
        Row and column of the common target, or of the cell that the first of `agents` headed for.
    at_fault : tuple of int
        The agents at fault.
    held : tuple of int
        The agents that have to stay where they are because of this conflict alone.
    doomed : tuple of int
        The agents that this conflict removes.
    turn : int
        The turn of the round, from 0; always 0 where all agents move at once.
    text : str
        The conflict as a sentence, which is also ``str(conflict)``.
    """

    kind: str
    form: str
    agents: tuple[int, ...]
    cell: tuple[int, int]
    at_fault: tuple[int, ...]
    held: tuple[int, ...]
    doomed: tuple[int, ...]
    turn: int
    text: str

    def __str__(self) -> str:
        return self.text


def conflict_of(record: tuple[Any, ...], config: WorldConfig) -> Conflict:
    """Return a conflict from the engine's record of it.

    Parameters
    ----------
    record : tuple
        Turn, kind, form, first agent, second agent (negative for an obstacle), cell, and three
        ints (at fault, held, doomed) whose bits 0 and 1 stand for the first and the second agent.
    config : WorldConfig
        The settings of the world, for the names of the agents.

    Returns
    -------
    Conflict
        The same with names.
    """
    turn, kind, form, first, second, cell, *bits = record
    agents = (first,) if second < 0 else (first, second)
    # Bit 0 of each number stands for the first agent, bit 1 for the second.
    at_fault, held, doomed = (
        tuple(agent for side, agent in enumerate(agents) if bit >> side & 1) for bit in bits
    )
    names = [config.agent_name(agent) for agent in agents]
    if second < 0:
        event = f"{names[0]} ran into the obstacle or border at {cell}"
    else:
        event = _EVENTS[_FORMS[form]](names, cell)
    outcome = _outcome(agents, held, doomed, config)
    return Conflict(
        KINDS[kind], _FORMS[form], agents, cell, at_fault, held, doomed, turn, f"{event}: {outcome}"
    )


_EVENTS = {
    "vertex": lambda names, cell: f"{names[0]} and {names[1]} both headed for {cell}",
    "edge": lambda names, cell: f"{names[0]} and {names[1]} meant to swap, {names[0]} to {cell}",
    "chain": lambda names, cell: f"{names[0]} headed for {cell}, where {names[1]} had to stay",
}


def _outcome(
    agents: tuple[int, ...], held: tuple[int, ...], doomed: tuple[int, ...], config: WorldConfig
) -> str:
    if len(agents) == 2 and held == agents:
        return "both bounce"
    if len(agents) == 2 and doomed == agents:
        return "both disappear"
    parts = [f"{config.agent_name(agent)} bounces" for agent in held]
    parts += [f"{config.agent_name(agent)} disappears" for agent in doomed]
    return ", ".join(parts) or "nobody is stopped"
