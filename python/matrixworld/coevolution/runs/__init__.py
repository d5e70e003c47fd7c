"""Runs: training from the first epoch to the evaluation, in a directory that can be resumed.

Read `run` first: what a stage is, how a team learns in it, and what is saved. Each kind of run says
how its stages are played: `race` and `single`. `start` makes, resumes and
finishes runs of any kind.
"""
