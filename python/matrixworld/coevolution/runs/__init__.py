"""Runs: training from the first epoch to the evaluation, in a directory that can be resumed.

=================  ===============================================================================
module             contents
=================  ===============================================================================
start              `start`, `resume` and `finish`: runs of any kind
run                `Run`: what a stage is, how a team learns, what is saved
alternating        `Race`: the teams learn in turns, by a schedule or by opponent samplers
hall_of_fame       `HallOfFameRace`: both teams learn at the same time
single             `SingleTeam`: one team learns against fixed opponents
best_response      `best_response`: how much a new opponent gains against a champion
training_matches   `TrainingMatches`: plays, counts and logs matches, and computes fitness
=================  ===============================================================================
"""
