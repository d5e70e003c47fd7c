"""A tournament of policies that students hand in: programs and genomes.

Programs run in processes that can compute in memory and answer, and can do nothing else. The world
is played in the process of the teacher, which never runs a line of a program.
"""
