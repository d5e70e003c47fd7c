"""The conflicts of a step, in words: why an agent bounced or disappeared."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

COLLISION_KINDS = ("obstacle", "teammate", "adversary")
"""The kinds of collision, in the order of the last axis of ``involved`` and ``fault``."""

FORMS = ("vertex", "edge", "chain")
"""The forms of a conflict, in the order of their numbers in the engine."""

CONFLICT_COLUMNS = (
    *("turn", "kind", "form", "first", "second"),
    *("row", "col", "at_fault", "held", "doomed"),
)
"""What the numbers of a conflict mean. The second agent is -1 for an obstacle; the last three
numbers have bit 0 set for the first agent and bit 1 for the second."""

AGENT_NAMES = ("pursuer_{number}", "evader_{number}")
"""Names of a team's agents, which count from 0 in each team."""

EVENTS = {
    "obstacle": "{first} ran into the obstacle or border at {cell}",
    "vertex": "{first} and {second} both headed for {cell}",
    "edge": "{first} and {second} meant to swap, {first} to {cell}",
    "chain": "{first} headed for {cell}, where {second} had to stay",
}
"""What happened in a conflict, by its form; with an obstacle it is always the first."""

OUTCOMES = {
    "both held": "both bounce",
    "both doomed": "both disappear",
    "held": "{agent} bounces",
    "doomed": "{agent} disappears",
    "none": "nobody is stopped",
}
"""How a conflict ended; the texts of single agents are joined by commas."""

SENTENCE = "{event}: {outcome}"
"""A conflict in words. Pages fill the same templates (`web/src/engine/tables.ts`)."""


@dataclass(frozen=True)
class Conflict:
    """A conflict of a step, between two agents or between an agent and an obstacle.

    Its `kind` is "obstacle", "teammate" or "adversary", its `form` "vertex", if both head for one
    cell, "edge", if they swap cells, or "chain", if the first agent enters the cell of the second,
    which has to stay. Obstacles are "vertex". It is between the `agents`, two, or the one that ran
    into an obstacle, about a `cell`: row and column of the common target, or of what the first of
    them headed for. Of agents there are those `at_fault`, those that have to stay where they are
    because of this conflict alone (`held`), and those that it removes (`doomed`). The `turn` of the
    round is 0 where all agents move at once. The `text` is the conflict as a sentence, which is
    also ``str(conflict)``.
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


def agent_name(agent: int, n_pursuers: int) -> str:
    """Return the name of an agent: ``pursuer_0`` and so on, then ``evader_0`` and so on."""
    if agent < n_pursuers:
        return AGENT_NAMES[0].format(number=agent)
    return AGENT_NAMES[1].format(number=agent - n_pursuers)


def conflict_of(numbers: Sequence[int], n_pursuers: int) -> Conflict:
    """Return a conflict from the numbers that `CONFLICT_COLUMNS` names."""
    turn, kind, form, first, second, row, col, *bits = numbers
    agents, cell = (first,) if second < 0 else (first, second), (row, col)
    at_fault, held, doomed = (
        tuple(agent for side, agent in enumerate(agents) if bit >> side & 1) for bit in bits
    )
    names = [agent_name(agent, n_pursuers) for agent in agents]
    event = EVENTS["obstacle" if second < 0 else FORMS[form]].format(
        first=names[0], second=names[-1], cell=cell
    )
    text = SENTENCE.format(event=event, outcome=_outcome(agents, held, doomed, n_pursuers))
    return Conflict(
        COLLISION_KINDS[kind], FORMS[form], agents, cell, at_fault, held, doomed, turn, text
    )


def _outcome(
    agents: tuple[int, ...], held: tuple[int, ...], doomed: tuple[int, ...], n_pursuers: int
) -> str:
    if len(agents) == 2 and held == agents:
        return OUTCOMES["both held"]
    if len(agents) == 2 and doomed == agents:
        return OUTCOMES["both doomed"]
    stopped = [*(("held", agent) for agent in held), *(("doomed", agent) for agent in doomed)]
    parts = [OUTCOMES[how].format(agent=agent_name(agent, n_pursuers)) for how, agent in stopped]
    return ", ".join(parts) or OUTCOMES["none"]
