"""A tournament of policies that students hand in: programs and genomes.

Programs run in processes that can compute in memory and answer, and can do nothing else. The world
is played in the process of the teacher, which never runs a line of a program.

==================  ================================================================================
untrusted.py        reading files that may be anything
submissions.py      what lies in the directory of a class
genome_file.py      a genome with its network as a file
admission.py        who may play: programs are loaded and tried
round_robin.py      ``play_class``: every pursuer against every evader
referee.py          the conditions that are the same for all matches
match.py            one match
program.py          a program during a match: what it is told and answers
seat.py             the place of a program in a match: a host, which makes its process
wire.py             messages between the two sides
host.py             the process that makes processes of programs
policy_process.py   the process of a program
limits.py           limits of time, memory, files and processes
system_calls.py     the filter of system calls
standings.py        scores with intervals, and ranges of ranks
report.py           results as plain values
page.py             the page
==================  ================================================================================
"""

from __future__ import annotations

from matrixworld.classroom.genome_file import load_genome, save_genome
from matrixworld.classroom.limits import Limits
from matrixworld.classroom.page import class_page
from matrixworld.classroom.round_robin import ClassResult, play_class
from matrixworld.classroom.standings import Standing, rank_ranges, standings
from matrixworld.classroom.submissions import Entry, Refusal

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
