"""A saved run, to read: nothing here writes, and the run may still be training."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, cast

import numpy as np

from matrixworld._util.checks import check_choice
from matrixworld._util.files import DamagedFileError
from matrixworld.coevolution.payoff import Payoff
from matrixworld.coevolution.schedules import Against
from matrixworld.coevolution.seeding import evaluation_seed
from matrixworld.coevolution.settings import RaceSettings
from matrixworld.coevolution.storage.run_directory import CONFIG, RunDirectory
from matrixworld.coevolution.types import TEAMS, Genomes, Team
from matrixworld.episodes.episode import Episode
from matrixworld.episodes.record import record
from matrixworld.play import NetworkPolicy
from matrixworld.world.policy import SCRIPTS, Network, Population, Script, TeamPolicy


def script_of(name: str) -> Script:
    """Return `name` as the name of a script; ValueError if there is no such script."""
    check_choice("script", name, SCRIPTS)
    return cast(Script, name)


def last_generation(directory: str | Path, team: Team) -> Population:
    """Return the last genome of a team in a run directory; ValueError if there is none."""
    files = RunDirectory.open(directory)
    genomes = files.archive()[team]
    if not len(genomes):
        raise ValueError(f"{directory}: expected a run with genomes of {team}s, got none")
    return _population(files, team, genomes[-1:])


def archive_network(files: RunDirectory, team: Team) -> Network:
    """Return the network of a team's genomes in a run directory."""
    settings = files.settings
    if team in settings.learning_teams:
        return settings.network
    # Opponents of a single team may come from a run with other hidden layers.
    guest: Any = files.config.get("opponent_network")
    try:
        hidden, activation = tuple(guest["hidden"]), guest["activation"]
        return Network.for_config(settings.world, hidden=hidden, activation=activation)
    except (KeyError, OverflowError, TypeError, ValueError) as error:
        problem = f"opponent_network: expected hidden and activation ({error})"
        raise DamagedFileError(files.path / CONFIG, problem) from error


@dataclass(frozen=True)
class SavedRun:
    """The contents of a run directory.

    Parameters
    ----------
    files : RunDirectory
        The directory; its methods `log` and `summary` read further files.
    settings : RaceSettings
        Settings of the run.
    teams : mapping of str to Population or str
        For each team its archive as a population, one genome per generation, or the name of a
        script.
    """

    files: RunDirectory
    settings: RaceSettings
    teams: Mapping[Team, TeamPolicy]

    def __repr__(self) -> str:
        """Return directory, kind and seed of the run, and the size of each team's archive."""
        sizes = ", ".join(
            f"{team}s: {each if isinstance(each, str) else len(each.genomes)}"
            for team, each in self.teams.items()
        )
        kind = self.settings.schedule.name
        return f"SavedRun({str(self.files.path)!r}, {kind}, seed {self.settings.seed}, {sizes})"

    def payoff(self) -> Payoff:
        """Return the payoff; FileNotFoundError while the run is not finished."""
        return Payoff.from_arrays(self.files.payoff())

    def generation_at(self, team: Team, matches: int) -> int:
        """Return the newest generation of `team` after a number of training matches.

        Parameters
        ----------
        team : {"pursuer", "evader"}
            The team.
        matches : int
            Matches of both teams, including those that archives play to compare candidates.

        Returns
        -------
        int
            The generation; 0, the untrained one, if no other was finished.

        Notes
        -----
        For comparing runs at equal budgets: ``teams[team].genomes[generation_at(team, n)]``.
        """
        log = self.files.log()
        own = log["team"] == team
        generations, played = log["generation"][own], log["matches"][own]
        newest = int(generations.max(initial=0))
        ends = np.array([played[generations == g].max() for g in range(1, newest + 1)])
        return int(np.count_nonzero(ends <= matches))

    def record(self, pursuer: int = -1, evader: int = -1, episode: int = 0) -> Episode:
        """Play one episode of the evaluation again and record every step.

        Parameters
        ----------
        pursuer, evader : int, optional
            Generations; negative numbers count from the end. Ignored for a scripted team.
        episode : int, optional
            Number of the episode of this pair.

        Returns
        -------
        Episode
            The recorded episode.

        Raises
        ------
        IndexError
            If there is no such generation.
        """
        g, h = self._generation("pursuer", pursuer), self._generation("evader", evader)
        return record(
            self.settings.world,
            self.teams["pursuer"],
            self.teams["evader"],
            seed=evaluation_seed(self.settings.seed, g, h),
            pursuer=g,
            evader=h,
            episode=episode,
        )

    def policy(
        self,
        team: Team,
        generation: int = -1,
        *,
        sampled: bool | None = None,
        seed: int | None = None,
    ) -> NetworkPolicy:
        """Return a genome of the run as a policy that acts on observations.

        Parameters
        ----------
        team : {"pursuer", "evader"}
            The team.
        generation : int, optional
            The generation; negative numbers count from the end. The default is the last one.
        sampled, seed : optional
            As for `NetworkPolicy`.

        Returns
        -------
        NetworkPolicy
            The policy. It also plays as a built-in team of an environment, and exports its network
            to PyTorch and ONNX.

        Raises
        ------
        ValueError
            If there is no such team, or a script plays for it.
        IndexError
            If there is no such generation.
        """
        check_choice("team", team, TEAMS)
        policy = self.teams[team]
        if isinstance(policy, str):
            raise ValueError(f"team: expected one that learned, got {team}: {policy} plays for it")
        genome = policy.genomes[self._generation(team, generation)]
        return NetworkPolicy(policy.network, genome, sampled=sampled, seed=seed)

    def _generation(self, name: Team, index: int) -> int:
        team = self.teams[name]
        if isinstance(team, str):
            return 0
        count = len(team.genomes)
        if not -count <= index < count:
            raise IndexError(f"{name}: expected a generation from 0 to {count - 1}, got {index}")
        return index % count


def open_run(directory: str | Path) -> SavedRun:
    """Return the contents of a run directory, whether the run is finished or not.

    Parameters
    ----------
    directory : str or Path
        The run directory.

    Returns
    -------
    SavedRun
        Its settings, teams and files.

    Raises
    ------
    FileNotFoundError
        If the directory holds no run.
    DamagedFileError
        If a file is cut or altered.
    OtherVersionError
        If the run is of another version of the package.
    """
    files = RunDirectory.open(directory)
    settings, archive = files.settings, files.archive()

    def policy(team: Team) -> TeamPolicy:
        if len(archive[team]):
            return _population(files, team, archive[team])
        schedule = settings.schedule
        if isinstance(schedule, Against) and schedule.team != team:
            return script_of(schedule.opponent)
        raise DamagedFileError(files.path, f"expected genomes of {team}s, got none")

    return SavedRun(files, settings, {team: policy(team) for team in TEAMS})


def run_directories(path: Path) -> list[Path]:
    """Return `path` if it is a run directory, else the run directories one or two levels below."""
    # config.json is the last file of a new run: without it the run was not completely created.
    if (path / CONFIG).is_file():
        return [path]
    found = [file.parent for file in path.glob(f"*/{CONFIG}")]
    # A response to a champion lies in its run, and is no run of the job.
    nested = [file.parent for file in path.glob(f"*/*/{CONFIG}") if file.parents[1] not in found]
    return [*found, *nested]


def open_runs(directory: str | Path, *, finished: bool = True) -> list[SavedRun]:
    """Return the runs of a job, or of any directory that holds runs.

    Parameters
    ----------
    directory : str or Path
        A run directory, or one with run directories one or two levels below, such as
        ``<schedule>/seed-<n>``.
    finished : bool, optional
        Whether runs that are not finished are left out.

    Returns
    -------
    list of SavedRun
        The runs by schedule or other name, then by seed.

    Raises
    ------
    FileNotFoundError
        If the directory holds no run.
    DamagedFileError, OtherVersionError
        As for `open_run`.
    """
    paths = run_directories(Path(directory))
    if not paths:
        raise FileNotFoundError(f"{directory}: expected a directory that holds runs, got none")
    runs = [open_run(path) for path in paths if not finished or RunDirectory(path).finished]
    return sorted(runs, key=lambda run: (run.files.path.parent, run.settings.seed, run.files.path))


def _population(files: RunDirectory, team: Team, genomes: Genomes) -> Population:
    """Return genomes of an archive as a population; DamagedFileError if they do not fit."""
    network = archive_network(files, team)
    try:
        return Population(genomes, network)
    except (TypeError, ValueError) as error:
        raise DamagedFileError(files.path, f"{team}s: {error}") from error
