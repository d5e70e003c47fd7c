"""A tournament of policies that students hand in: programs and genomes.

Programs run in processes that can compute in memory and answer, and can do nothing else. The world
is played in the process of the teacher, which never runs a line of a program.
"""

from __future__ import annotations

from matrixworld.classroom.page import class_page
from matrixworld.classroom.sandbox import Limits
from matrixworld.classroom.standings import Standing, rank_ranges, standings
from matrixworld.classroom.submissions import Entry, Refusal, load_genome, save_genome
from matrixworld.classroom.tournament import ClassResult, play_class

__all__ = [
    "ClassResult",
    "Entry",
    "Limits",
    "Refusal",
    "Standing",
    "class_page",
    "load_genome",
    "play_class",
    "rank_ranges",
    "save_genome",
    "standings",
]
