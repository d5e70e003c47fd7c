"""The rules of a game and its rewards, as data."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from enum import Enum, IntEnum
from numbers import Real
from types import MappingProxyType
from typing import Any, TypeAlias

import numpy as np

from matrixworld._core import Blame, Capture, Interaction, Outcome
from matrixworld.checks import check_bool

__all__ = [
    "KINDS",
    "VARIANTS",
    "Action",
    "Blame",
    "Capture",
    "Interaction",
    "Outcome",
    "Rewards",
    "Rules",
    "rules_of",
]

KINDS = ("obstacle", "teammate", "adversary")
"""The kinds of collision, in the order of the last axis of ``involved`` and ``fault``."""


class Action(IntEnum):
    """What an agent can do; the last four only in a world with ``diagonal=True``."""

    STAY = 0
    NORTH = 1
    EAST = 2
    SOUTH = 3
    WEST = 4
    NORTHEAST = 5
    SOUTHEAST = 6
    SOUTHWEST = 7
    NORTHWEST = 8


Fine: TypeAlias = float | tuple[float, float, float]
"""For collisions of every kind, or for those with an obstacle, a teammate, an adversary."""

_LARGEST = float(np.finfo(np.float32).max)


def _require(name: str, value: object, kind: type[Enum]) -> None:
    if not isinstance(value, kind):
        raise TypeError(f"{name}: expected a matrixworld.{kind.__name__}, got {value!r}")


@dataclass(frozen=True)
class Rules:
    """One row of the rules table; a game variant is nothing else.

    interaction: who moves together
    obstacle: outcome of an agent that runs into an obstacle or the border
    teammate: outcome of a collision of two agents of one team, for both
    evader, pursuer: outcomes of the two sides of a collision of adversaries
    capture: by being reached (occupation) or by being surrounded
    captured_disappear: whether a surrounded evader is removed

    Every combination is legal. Under occupation only an evader's outcome ``DISAPPEAR``, or
    ``REACH`` on both sides, captures anybody; a `WorldConfig` of another row warns.

    Raises TypeError for a field of another type.
    """

    interaction: Interaction = Interaction.SIMULTANEOUS
    obstacle: Outcome = Outcome.BOUNCE
    teammate: Outcome = Outcome.REACH
    evader: Outcome = Outcome.DISAPPEAR
    pursuer: Outcome = Outcome.REACH
    capture: Capture = Capture.OCCUPATION
    captured_disappear: bool = False

    def __post_init__(self) -> None:
        _require("interaction", self.interaction, Interaction)
        _require("capture", self.capture, Capture)
        for name in ("obstacle", "teammate", "evader", "pursuer"):
            _require(name, getattr(self, name), Outcome)
        check_bool("captured_disappear", self.captured_disappear)

    @property
    def captures(self) -> bool:
        """Whether an evader can be captured at all."""
        both_reach = self.evader is Outcome.REACH and self.pursuer is Outcome.REACH
        occupied = self.evader is Outcome.DISAPPEAR or both_reach
        return self.capture is Capture.SURROUND or occupied


def _variants() -> dict[str, Rules]:
    d, r, b = Outcome.DISAPPEAR, Outcome.REACH, Outcome.BOUNCE
    together, in_turns = Interaction.SIMULTANEOUS, Interaction.AGENT_TURNS
    occupation, surround = Capture.OCCUPATION, Capture.SURROUND
    #          interaction, obstacle, teammate, evader, pursuer, capture, captured disappear
    return {
        "D": Rules(together, d, d, d, d, occupation),
        "R": Rules(together, b, r, r, r, occupation),
        "B": Rules(together, b, b, r, r, occupation),
        "O": Rules(together, b, r, d, r, occupation),
        "S": Rules(together, b, r, b, r, surround),
        "SB": Rules(together, b, b, b, r, surround),
        "SD": Rules(together, b, r, b, r, surround, True),
        "SDB": Rules(together, b, b, b, r, surround, True),
        "TO": Rules(in_turns, b, r, d, r, occupation),
    }


VARIANTS: Mapping[str, Rules] = MappingProxyType(_variants())
"""The nine variants of Sun et al., Table "Task definition", by the letters after the dash."""


@dataclass(frozen=True)
class Rewards:
    """What is paid to an agent; the defaults are those of the paper's table "Reward function".

    capture: to each captor for each evader captured, and to the captured evader; once per evader
        and episode, or with ``capture_repeats`` in every step that the capture lasts
    neighbor: flat, while at least one living adversary is north, east, south or west of it
    collide: once for each kind of collision in which it is to blame in a step; one number, or one
        for each of obstacle, teammate, adversary
    step: for every step, on the agent's own turn where turns are taken
    blame: who pays ``collide``: those at fault, or everybody involved. Under occupation a contact
        of adversaries involves both and is nobody's fault: it is the game. Who pays for being
        involved may want ``collide=(-12, -12, 0)``.

    With an evader's ``step`` below 0 it scores better by being caught at once (-10) than by
    surviving 500 steps (-25). The published code pays it +0.05 instead, and pays a lasting
    capture in every step: `Rewards.published`.

    Raises ValueError for a number that is not finite as a float32 and for other than 1 or 3
    numbers to ``collide``, TypeError for other values.
    """

    pursuer_capture: float = 10.0
    evader_capture: float = -10.0
    pursuer_neighbor: float = 0.1
    evader_neighbor: float = -0.1
    pursuer_collide: Fine = -12.0
    evader_collide: Fine = -12.0
    pursuer_step: float = -0.05
    evader_step: float = -0.05
    blame: Blame = Blame.FAULT
    capture_repeats: bool = False

    def __post_init__(self) -> None:
        check_bool("capture_repeats", self.capture_repeats)
        _require("blame", self.blame, Blame)
        for name in (item.name for item in fields(self)):
            value = getattr(self, name)
            if name.endswith("_collide") and isinstance(value, tuple | list):
                if len(value) != len(KINDS):
                    raise ValueError(f"{name}: expected 1 or {len(KINDS)} numbers, got {value!r}")
                object.__setattr__(self, name, tuple(_paid(name, part) for part in value))
            elif name not in ("blame", "capture_repeats"):
                object.__setattr__(self, name, _paid(name, value))

    @classmethod
    def paper(cls) -> Rewards:
        """Those of Sun et al., Table "Reward function": the defaults."""
        return cls()

    @classmethod
    def published(cls) -> Rewards:
        """Those of the code that its authors published."""
        return cls(evader_step=0.05, capture_repeats=True)

    def by_team(self, name: str) -> tuple[Any, Any]:
        """(pursuer's, evader's) reward called ``name``; ``collide`` as three numbers each."""
        paid = getattr(self, f"pursuer_{name}"), getattr(self, f"evader_{name}")
        if name != "collide":
            return paid
        pursuer, evader = (part if isinstance(part, tuple) else (part,) * 3 for part in paid)
        return pursuer, evader


def _paid(name: str, value: object) -> float:
    if isinstance(value, bool) or not isinstance(value, Real):
        raise TypeError(f"{name}: expected a number, got {value!r}")
    number = float(value)
    if not abs(number) <= _LARGEST:
        raise ValueError(f"{name}: expected a finite number, got {value!r}")
    return number


def rules_of(variant: Rules | str) -> Rules:
    """The row called ``variant`` ("O", "-O" or "pursuit-evasion-o"), or the row itself.

    Raises ValueError for an unknown name and TypeError for another type.
    """
    if isinstance(variant, Rules):
        return variant
    if not isinstance(variant, str):
        raise TypeError(f"rules: expected Rules or the name of a variant, got {variant!r}")
    name = variant.upper().removeprefix("PURSUIT-EVASION").removeprefix("-")
    if name not in VARIANTS:
        raise ValueError(f"variant: expected one of {', '.join(VARIANTS)}, got {variant!r}")
    return VARIANTS[name]
