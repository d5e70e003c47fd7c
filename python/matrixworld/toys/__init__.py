"""Toys with known answers: co-evolution in plain NumPy, over in seconds.

They are played by the schedules, opponent selection and fitness sharing of the real races, so
that what is seen here of these holds there.

>>> from matrixworld import toys
>>> toys.numbers_game("scalar", seed=0).final_objective.round()
array([99., 99.])

====================  ============================================================================
rock_paper_scissors   specialists cycle, and averages of fictitious play approach the equilibrium
numbers               numbers games: scalar, focusing, intransitive (Watson & Pollack 2001)
virulence             hosts that lose touch, and parasites that wait (Cartlidge & Bullock 2004)
populations           the loop that numbers and virulence share
known_races           races of all of these, matched, with what is known to be true of each
====================  ============================================================================
"""

from __future__ import annotations

from matrixworld.toys.known_races import RACES, KnownRace, known_race
from matrixworld.toys.numbers import GAMES, numbers_game
from matrixworld.toys.populations import Game, History, Side, evolve
from matrixworld.toys.rock_paper_scissors import (
    alternate,
    chances,
    exploitability,
    play_together,
    shares,
)
from matrixworld.toys.virulence import hosts_and_parasites

__all__ = [
    "GAMES",
    "RACES",
    "Game",
    "History",
    "KnownRace",
    "Side",
    "alternate",
    "chances",
    "evolve",
    "exploitability",
    "hosts_and_parasites",
    "known_race",
    "numbers_game",
    "play_together",
    "shares",
]
