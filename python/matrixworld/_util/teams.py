"""The names of the two teams, in the order of every team axis."""

from __future__ import annotations

from typing import Literal, TypeAlias

Team: TypeAlias = Literal["pursuer", "evader"]

TEAMS: tuple[Team, Team] = ("pursuer", "evader")


def other(team: Team) -> Team:
    """Return the opposing team."""
    return "evader" if team == "pursuer" else "pursuer"
