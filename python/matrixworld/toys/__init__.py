"""Toys with known answers: co-evolution in plain NumPy that takes seconds.

They use the schedules, opponent samplers and fitness sharing of the real races. What these do here
they do there, too.

>>> from matrixworld import toys
>>> toys.numbers_game("scalar", seed=0).final_objective.round()
array([99., 99.])

====================  ============================================================================
rock_paper_scissors   specialists cycle; averages of fictitious play approach the equilibrium
numbers               numbers games: scalar, focusing, intransitive (Watson & Pollack 2001)
virulence             hosts that disengage, and parasites that wait (Cartlidge & Bullock 2004)
populations           the loop that numbers and virulence share
labelled_races        races of all toys, with matches, and with labels: what is true of each race
synthetic_races       capture rates by formula, from pure races to noise only: a table of kinds
race_formulas         the formulas of these kinds
race_truths           what is true of known capture rates, by window; matches with noise
====================  ============================================================================
"""

from __future__ import annotations

from matrixworld.toys.labelled_races import RACES, LabelledRace, labelled_race
from matrixworld.toys.numbers import GAMES, numbers_game
from matrixworld.toys.populations import Game, History, Side, evolve
from matrixworld.toys.race_formulas import SyntheticRace
from matrixworld.toys.rock_paper_scissors import (
    alternate,
    average_strategies,
    capture_probabilities,
    exploitability,
    play_together,
)
from matrixworld.toys.synthetic_races import synthetic_races
from matrixworld.toys.virulence import hosts_and_parasites

__all__ = [
    "GAMES",
    "RACES",
    "Game",
    "History",
    "LabelledRace",
    "Side",
    "SyntheticRace",
    "alternate",
    "average_strategies",
    "capture_probabilities",
    "evolve",
    "exploitability",
    "hosts_and_parasites",
    "labelled_race",
    "numbers_game",
    "play_together",
    "synthetic_races",
]
