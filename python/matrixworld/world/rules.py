"""The rules and the rewards of a game, as data."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from enum import IntEnum
from types import MappingProxyType
from typing import Any, TypeAlias

import numpy as np

from matrixworld._core import Blame as Blame
from matrixworld._core import Capture as Capture
from matrixworld._core import Interaction as Interaction
from matrixworld._core import Outcome as Outcome
from matrixworld._util.checks import check_bool, check_choice, check_instance, check_real, shown
from matrixworld.world.conflicts import COLLISION_KINDS as COLLISION_KINDS


class Action(IntEnum):
    """The actions of an agent; the last four exist only in a world with ``diagonal=True``."""

    STAY = 0
    NORTH = 1
    EAST = 2
    SOUTH = 3
    WEST = 4
    NORTHEAST = 5
    SOUTHEAST = 6
    SOUTHWEST = 7
    NORTHWEST = 8


OUTCOME_TEXTS = {
    Outcome.DISAPPEAR: "disappears",
    Outcome.REACH: "reaches the cell",
    Outcome.BOUNCE: "bounces back",
}
"""What happens to an agent, as it stands in tables of rules."""

INTERACTION_TEXTS = {
    Interaction.SIMULTANEOUS: "all at once",
    Interaction.SWARM_TURNS: "team by team",
    Interaction.AGENT_TURNS: "one at a time",
}
"""Which agents move together, as it stands in tables of rules."""

CAPTURE_TEXTS = {Capture.OCCUPATION: "occupation", Capture.SURROUND: "surrounding"}
"""What captures an evader, as it stands in tables of rules."""

DISAPPEARING = {Outcome.DISAPPEAR}
"""The outcomes that remove an agent."""

Penalty: TypeAlias = float | tuple[float, float, float]
"""One number for collisions of all kinds, or one for each of `COLLISION_KINDS`."""

# Rewards are float32 in the engine; a larger number would become infinite there.
_LARGEST = float(np.finfo(np.float32).max)


def _member(name: str, value: Any, kind: Any) -> Any:
    """Return a member of an enumeration, of itself or of its name in capitals or not."""
    if not isinstance(value, str):
        check_instance(name, value, kind)
        return value
    member = value.upper().replace("-", "_")
    if member not in kind.__members__:
        check_choice(name, value, kind.__members__)
    return kind[member]


@dataclass(frozen=True)
class Rules:
    """One row of the table of rules. A game variant is nothing else.

    A text stands for the member of that name, as in ``obstacle="bounce"``.

    Parameters
    ----------
    interaction : Interaction or str, optional
        Which agents move together: all of them, the agents of a team, or one at a time.
    obstacle : Outcome or str, optional
        What happens to an agent that runs into an obstacle or the border.
    teammate : Outcome or str, optional
        What happens to both agents in a collision of teammates.
    evader, pursuer : Outcome or str, optional
        What happens to the evader and to the pursuer in a collision of adversaries.
    capture : Capture or str, optional
        Whether an evader is captured by being reached (occupation) or by being surrounded.
    captured_disappear : bool, optional
        Whether a surrounded evader is removed. Occupation does not read it.

    Notes
    -----
    Every combination is legal. Under occupation an evader can be captured only if its outcome is
    ``DISAPPEAR``, or if both outcomes are ``REACH``; a `WorldConfig` with other rules warns.

    Examples
    --------
    Pursuers surround evaders, and teams take turns:

    >>> from matrixworld import Rules
    >>> rules = Rules("swarm-turns", evader="bounce", capture="surround")
    >>> rules.captures
    True
    """

    interaction: Interaction = Interaction.SIMULTANEOUS
    obstacle: Outcome = Outcome.BOUNCE
    teammate: Outcome = Outcome.REACH
    evader: Outcome = Outcome.DISAPPEAR
    pursuer: Outcome = Outcome.REACH
    capture: Capture = Capture.OCCUPATION
    captured_disappear: bool = False

    def __post_init__(self) -> None:
        kinds: dict[str, Any] = {"interaction": Interaction, "capture": Capture}
        kinds |= dict.fromkeys(("obstacle", "teammate", "evader", "pursuer"), Outcome)
        for name, kind in kinds.items():
            # The only way to set a field of a frozen dataclass.
            object.__setattr__(self, name, _member(name, getattr(self, name), kind))
        check_bool("captured_disappear", self.captured_disappear)

    @property
    def captures(self) -> bool:
        """Whether an evader can be captured at all."""
        both_reach = self.evader is Outcome.REACH and self.pursuer is Outcome.REACH
        occupied = self.evader in DISAPPEARING or both_reach
        return self.capture is Capture.SURROUND or occupied

    @property
    def removes_captured(self) -> bool:
        """Whether a captured evader leaves the grid."""
        if self.capture is Capture.SURROUND:
            return self.captured_disappear
        return self.evader in DISAPPEARING


def _variants() -> dict[str, Rules]:
    d, r, b = Outcome.DISAPPEAR, Outcome.REACH, Outcome.BOUNCE
    together, in_turns = Interaction.SIMULTANEOUS, Interaction.AGENT_TURNS
    occupation, surround = Capture.OCCUPATION, Capture.SURROUND
    # One variant per line. A new line needs a text in `envs/variants.toml`; tests name the rest.
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


# Read-only: another row under a known name would make results incomparable.
VARIANTS: Mapping[str, Rules] = MappingProxyType(_variants())
"""The nine variants of Sun et al. (2023), Table "Task definition", by their letters."""


@dataclass(frozen=True)
class Rewards:
    """The rewards of a game. The defaults are those of the paper's table "Reward function".

    Parameters
    ----------
    pursuer_capture, evader_capture : float, optional
        For each evader captured, to each captor and to the evader. Paid once per evader and
        episode, or with `capture_repeats` in every step that the capture lasts.
    pursuer_neighbor, evader_neighbor : float, optional
        In a step after which a living adversary is on the cell to the north, east, south or west.
        The number of such adversaries does not matter.
    pursuer_collide, evader_collide : float or sequence of 3 floats, optional
        The penalty, once for each kind of collision for which `blame` charges the agent in a step.
        Three numbers are penalties for collisions with an obstacle, a teammate, an adversary.
    pursuer_step, evader_step : float, optional
        For every step. Where agents take turns, it is paid in the agent's own turn.
    blame : Blame or str, optional
        Which agents pay the penalty: those at fault, or all agents involved. Under occupation a
        contact of adversaries involves both, and neither is at fault, because contact is the aim
        of the game. With ``Blame.INVOLVED`` you may want ``pursuer_collide=(-12, -12, 0)``.
    capture_repeats : bool, optional
        Whether a capture is paid in every step that it lasts.

    Notes
    -----
    While `evader_step` is negative, an evader that is caught at once (-10) scores better than one
    that survives 500 steps (-25). The published code pays evaders +0.05 per step instead.
    """

    pursuer_capture: float = 10.0
    evader_capture: float = -10.0
    pursuer_neighbor: float = 0.1
    evader_neighbor: float = -0.1
    pursuer_collide: Penalty = -12.0
    evader_collide: Penalty = -12.0
    pursuer_step: float = -0.05
    evader_step: float = -0.05
    blame: Blame = Blame.FAULT
    capture_repeats: bool = False

    def __post_init__(self) -> None:
        check_bool("capture_repeats", self.capture_repeats)
        object.__setattr__(self, "blame", _member("blame", self.blame, Blame))
        for name in (item.name for item in fields(self)):
            value = getattr(self, name)
            if name.endswith("_collide") and isinstance(value, tuple | list):
                if len(value) != len(COLLISION_KINDS):
                    raise ValueError(
                        f"{name}: expected 1 or {len(COLLISION_KINDS)} numbers, got {value!r}"
                    )
                object.__setattr__(self, name, tuple(_reward(name, part) for part in value))
            elif name not in ("blame", "capture_repeats"):
                object.__setattr__(self, name, _reward(name, value))

    @classmethod
    def published(cls) -> Rewards:
        """Return the rewards of the code that the paper's authors published."""
        return cls(evader_step=0.05, capture_repeats=True)

    def by_team(self, name: str) -> tuple[Any, Any]:
        """Return the reward `name` of a pursuer and of an evader; ``collide`` as three numbers."""
        by_team = getattr(self, f"pursuer_{name}"), getattr(self, f"evader_{name}")
        if name != "collide":
            return by_team
        pursuer, evader = (part if isinstance(part, tuple) else (part,) * 3 for part in by_team)
        return pursuer, evader


def _reward(name: str, value: object) -> float:
    number = check_real(name, value)
    if not abs(number) <= _LARGEST:  # true for NaN as well
        raise ValueError(f"{name}: expected a finite number, got {shown(value)}")
    return number


REWARDS = {"paper": Rewards(), "published": Rewards.published()}
"""Rewards by the names that files and options take."""


def variant_name(rules: Rules) -> str:
    """Return the name of the variant with these rules; empty for other rules."""
    return next((name for name, each in VARIANTS.items() if each == rules), "")


def rules_of(variant: Rules | str) -> Rules:
    """Return rules as they are, or those of a name such as ``"O"`` or ``"pursuit-evasion-o"``."""
    if isinstance(variant, Rules):
        return variant
    if not isinstance(variant, str):
        raise TypeError(f"rules: expected Rules or the name of a variant, got {variant!r}")
    name = variant.upper().removeprefix("PURSUIT-EVASION").removeprefix("-")
    if name not in VARIANTS:
        raise ValueError(f"variant: expected one of {', '.join(VARIANTS)}, got {variant!r}")
    return VARIANTS[name]


RULES_HEAD = (
    "variant", "agents move", "obstacle", "teammate", "adversary:\nthe evader",
    "adversary:\nthe pursuer", "capture by", "the captured",
)  # fmt: skip
"""Heads of a table of rules; those in the middle are what a collision is with."""


def rules_row(name: str, rules: Rules) -> list[str]:
    """Return the cells of rules in a table, below `RULES_HEAD`."""
    outcomes = (rules.obstacle, rules.teammate, rules.evader, rules.pursuer)
    fate = ("disappear" if rules.removes_captured else "stay") if rules.captures else "none"
    return [
        name,
        INTERACTION_TEXTS[rules.interaction],
        *(OUTCOME_TEXTS[outcome].split()[0] for outcome in outcomes),
        CAPTURE_TEXTS[rules.capture],
        fate,
    ]
