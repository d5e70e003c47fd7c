"""The words that the package has for its two teams: in the singular, and in the plural.

Games of your own have other words for texts; in keys and arguments their teams have these, too.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Literal, TypeAlias, get_args

Team: TypeAlias = Literal["pursuer", "evader"]
TEAMS: tuple[Team, Team] = get_args(Team)
"""The first and the second team of a game."""

BOTH = ("pursuers", "evaders")
"""What the teams are called, unless a game has other names."""

PLURALS: Mapping[str, str] = MappingProxyType(dict(zip(TEAMS, BOTH, strict=True)))
"""All members of a team, by one."""
SINGULARS: Mapping[str, str] = MappingProxyType(dict(zip(BOTH, TEAMS, strict=True)))
"""One member of a team, by all."""


def other(team: Team) -> Team:
    """Return the opposing team."""
    return "evader" if team == "pursuer" else "pursuer"
