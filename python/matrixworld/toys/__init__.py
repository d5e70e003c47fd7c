"""Toys with known answers: co-evolution in plain NumPy that takes seconds.

They use the schedules, opponent samplers and fitness sharing of the real races. What these do here
they do there, too.

>>> from matrixworld import toys
>>> toys.numbers_game("scalar", seed=0).final_objective.round()
array([99., 99.])
"""

from __future__ import annotations

from matrixworld.toys.bit_strings import GAMES, hosts_and_parasites, numbers_game
from matrixworld.toys.rock_paper_scissors import alternate, capture_probabilities
from matrixworld.toys.synthetic_races import SYNTHETIC, play_episodes, synthetic_race

__all__ = [
    "GAMES",
    "SYNTHETIC",
    "alternate",
    "capture_probabilities",
    "hosts_and_parasites",
    "numbers_game",
    "play_episodes",
    "synthetic_race",
]
