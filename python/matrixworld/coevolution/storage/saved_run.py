"""A run on disk, to look at: nothing here writes, and a run may go on meanwhile."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import cast

import numpy as np

from matrixworld.coevolution.payoff import Payoff
from matrixworld.coevolution.seeding import evaluation_seed
from matrixworld.coevolution.settings import RaceSettings, SingleSettings
from matrixworld.coevolution.storage.run_directory import RunDirectory
from matrixworld.coevolution.types import TEAMS, Team
from matrixworld.episode import Episode
from matrixworld.policy import SCRIPTS, Network, Population, Script, TeamPolicy
from matrixworld.rollout import record


def script_of(name: str) -> Script:
    """Return a name as that of a script; ValueError if it is none."""
    if name not in SCRIPTS:
        raise ValueError(f"script: expected one of {', '.join(SCRIPTS)}, got {name!r}")
    return name


def last_generation(directory: str | Path, team: Team) -> Population:
    """Return the last genome of a team in a run directory, as a population of one.

    ValueError if that team did not learn in that run.
    """
    files = RunDirectory.open(directory)
    genomes = files.archive()[team]
    if not len(genomes):
        raise ValueError(f"{directory}: expected a run with genomes of {team}s, got none")
    return Population(genomes[-1:], archive_network(files, team))


def archive_network(files: RunDirectory, team: Team) -> Network:
    """Return the network of a team's genomes in a run directory."""
    settings = files.settings()
    if not isinstance(settings, SingleSettings) or settings.team == team:
        return settings.network
    world, guest = settings.world(settings.train_steps), files.config()["opponent_network"]
    return Network.for_config(world, hidden=tuple(guest["hidden"]), activation=guest["activation"])


@dataclass(frozen=True)
class SavedRun:
    """What a run directory holds.

    Attributes
    ----------
    files : the directory; `files.log()` and `files.summary()` read further.
    settings : of the run.
    teams : per team its archive as a population, by generation, or the name of a script.
    """

    files: RunDirectory
    settings: RaceSettings | SingleSettings
    teams: Mapping[Team, TeamPolicy]

    def payoff(self) -> Payoff:
        """Return the payoff; FileNotFoundError while the run is not finished."""
        return Payoff.from_arrays(self.files.payoff())

    def generation_at(self, team: Team, matches: int) -> int:
        """Return the newest generation of `team` once so many training matches were played.

        Runs are compared at equal budgets by it: ``teams[team].genomes[generation_at(team, n)]``.
        Matches of both teams count, and those that archives compare. Generation 0 is untrained.
        """
        log = self.files.log()
        own = log["team"] == team
        generations, played = log["generation"][own], log["matches"][own]
        newest = int(generations.max(initial=0))
        ends = np.array([played[generations == g].max() for g in range(1, newest + 1)])
        return int(np.count_nonzero(ends <= matches))

    def record(self, pursuer: int = -1, evader: int = -1, episode: int = 0) -> Episode:
        """Play one episode of the evaluation again and keep every moment of it.

        Parameters
        ----------
        pursuer, evader : generations; negative ones count from the end. IndexError beyond the
            archive. The generation of a scripted team is not looked at.
        episode : of that pair.
        """
        g, h = self._generation("pursuer", pursuer), self._generation("evader", evader)
        return record(
            self.settings.world(self.settings.eval_steps),
            self.teams["pursuer"],
            self.teams["evader"],
            seed=evaluation_seed(self.settings.seed, g, h),
            pursuer=g,
            evader=h,
            episode=episode,
        )

    def _generation(self, name: Team, index: int) -> int:
        team = self.teams[name]
        if isinstance(team, str):
            return 0
        count = len(team.genomes)
        if not -count <= index < count:
            raise IndexError(f"{name}: expected a generation from 0 to {count - 1}, got {index}")
        return index % count


def open_run(directory: str | Path) -> SavedRun:
    """Return what a run directory holds, finished or not.

    FileNotFoundError if it holds no run, DamagedFileError if a file is cut or altered,
    OtherVersionError if it is of another version.
    """
    files = RunDirectory.open(directory)
    settings = files.settings()
    return SavedRun(files, settings, {team: _team(files, settings, team) for team in TEAMS})


def _team(files: RunDirectory, settings: RaceSettings | SingleSettings, team: Team) -> TeamPolicy:
    genomes = files.archive()[team]
    if len(genomes):
        return Population(genomes, archive_network(files, team))
    return script_of(cast(SingleSettings, settings).against)
