"""A tournament of policies that students hand in: programs and genomes.

Programs run in processes that can compute in memory and answer, and can do nothing else. The world
is played in the process of the teacher, which never runs a line of a program.
"""

from __future__ import annotations

from matrixworld.classroom.results import Standing
from matrixworld.classroom.round_robin import play_class
from matrixworld.classroom.sandbox import Limits
from matrixworld.classroom.submissions import save_genome

__all__ = ["Limits", "Standing", "play_class", "save_genome"]
