"""Why an agent bounced: the conflicts of a step, in words."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from matrixworld.config import WorldConfig
from matrixworld.rules import KINDS

_FORMS = ("vertex", "edge", "chain")


@dataclass(frozen=True)
class Conflict:
    """One conflict of a step.

    kind: "obstacle", "teammate" or "adversary"
    form: "vertex" (one target for both), "edge" (they swap) or "chain" (the first enters the cell
        of the second, who was held); obstacles are "vertex"
    agents: the two agents, or the one that met an obstacle
    cell: (row, col) of the common target, or where the first of ``agents`` headed
    at_fault: those to blame
    held: those that this conflict by itself kept where they were
    doomed: those that this conflict removes
    turn: 0, or the number of the turn within the round
    text: the same as a sentence; also ``str(conflict)``
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
    """A conflict from the engine's (turn, kind, form, first, second, cell, and bits by side)."""
    turn, kind, form, first, second, cell, *bits = record
    agents = (first,) if second < 0 else (first, second)
    at_fault, held, doomed = (
        tuple(agent for side, agent in enumerate(agents) if bit >> side & 1) for bit in bits
    )
    names = [config.agent_name(agent) for agent in agents]
    what = _WORDS[_FORMS[form]](names, cell) if second >= 0 else f"{names[0]} ran into {_a(cell)}"
    outcome = _outcome(agents, held, doomed, config)
    return Conflict(
        KINDS[kind], _FORMS[form], agents, cell, at_fault, held, doomed, turn, f"{what}: {outcome}"
    )


def _a(cell: tuple[int, int]) -> str:
    return f"the obstacle or border at {cell}"


_WORDS = {
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
