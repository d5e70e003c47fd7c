"""The two teams of a race: their names in arrays and measures, and their names in texts.

The first team of any game is called ``"pursuers"`` in arrays, measures and findings, and the second
one ``"evaders"``. Texts for people use the names that a game gives its teams.
"""

from __future__ import annotations

from collections.abc import Sequence

from matrixworld._util.teams import BOTH, SINGULARS


def keys_of(number: str) -> dict[str, str]:
    """Return the names of a number of both teams by team, such as ``"pursuer_gain"``."""
    return {team: f"{member}_{number}" for team, member in SINGULARS.items()}


def names_of(teams: tuple[str, str]) -> dict[str, str]:
    """Return the words of a game for the placeholders of texts: both teams and their scores."""
    pursuers, evaders = teams
    score, capture, escape = "score", "score", "score"
    if teams == BOTH:
        score, capture, escape = "capture rate", "capture", "escape"
    words = {"score": score, "capture": capture, "escape": escape}
    return {"pursuers": pursuers, "evaders": evaders, **words}


def listed(members: Sequence[str], teams: tuple[str, str]) -> str:
    """Return some of the teams in the words of a game: "the foxes and the hens"."""
    names = names_of(teams)
    return " and ".join(f"the {names[team]}" for team in members)
