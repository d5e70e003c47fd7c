"""Runs: training from the first epoch to the evaluation, in a directory that can be resumed.

=================  ===============================================================================
module             contents
=================  ===============================================================================
start              `start`, `resume` and `finish`: runs of any kind
run                `Run`: stages with a checkpoint after each, then an evaluation
alternating        `Race`: the teams learn in turns, by a schedule or by opponent samplers
hall_of_fame       `HallOfFameRace`: both teams learn at the same time
single             `SingleTeam`: one team learns against fixed opponents
best_response      `best_response`: how much a new opponent gains against a champion
matchmaking        `Matchmaking`: the opponent samplers of a race, and the matches of archives
team_phase         `TeamPhase`: epochs in which one team learns, as a loop over a DEAP toolbox
training           `Training`: plays training matches, counts and logs them
=================  ===============================================================================
"""

from __future__ import annotations

from matrixworld.coevolution.runs.alternating import DisengagementWarning, Race
from matrixworld.coevolution.runs.best_response import BestResponse, best_response
from matrixworld.coevolution.runs.hall_of_fame import HallOfFameRace
from matrixworld.coevolution.runs.matchmaking import Matchmaking
from matrixworld.coevolution.runs.run import Run
from matrixworld.coevolution.runs.single import SingleTeam
from matrixworld.coevolution.runs.start import finish, resume, start
from matrixworld.coevolution.runs.team_phase import Matchup, TeamPhase
from matrixworld.coevolution.runs.training import Training

__all__ = [
    "BestResponse",
    "DisengagementWarning",
    "HallOfFameRace",
    "Matchmaking",
    "Matchup",
    "Race",
    "Run",
    "SingleTeam",
    "TeamPhase",
    "Training",
    "best_response",
    "finish",
    "resume",
    "start",
]
