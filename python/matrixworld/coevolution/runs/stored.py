"""Runs in directories: their settings, how they stand, and the teams that they hold."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import cached_property
from pathlib import Path
from typing import Any

from matrixworld._util import files
from matrixworld._util.callers import warn_caller
from matrixworld._util.checks import check_choice
from matrixworld._util.teams import PLURALS
from matrixworld.coevolution.games.game import Game
from matrixworld.coevolution.games.own_game import OwnGame
from matrixworld.coevolution.games.pursuit import Pursuit, PursuitSettings, acting
from matrixworld.coevolution.runs.places import CONFIG
from matrixworld.coevolution.runs.stored_files import (
    PAYOFF,
    SUMMARY,
    OtherVersionError,
    StoredFiles,
)
from matrixworld.coevolution.settings.race_settings import RaceSettings
from matrixworld.coevolution.settings.schedules import Against
from matrixworld.coevolution.types import TEAMS, Genomes, Team, team_size
from matrixworld.version import __version__


class StoredRun(StoredFiles):
    """A run in a directory, finished or still training.

    Its directory is the `path`. The keys of `teams` are ``pursuer`` and ``evader``, or the names
    that a game of your own has.

    `archive`, `log`, `payoff`, `summary` and `newest` return what the files hold at that moment.
    `settings` and `teams` stay as they were first read, and with them all that is taken from them,
    such as `generation` and `policy`. Of a run that trains, or was extended, a new object reads
    what has come since.
    """

    @cached_property
    def settings(self) -> RaceSettings:
        """Settings of the run; OtherVersionError if this version cannot read them."""
        config = self.config
        try:
            return RaceSettings.from_json(config["settings"])
        except (AttributeError, KeyError, OverflowError, TypeError, ValueError) as error:
            got = f"those of {config.get('matrixworld', 'unknown')}: {error}"
            expected = f"{self.path / CONFIG}: expected settings of matrixworld {__version__}"
            raise OtherVersionError(f"{expected}, got {files.one_line(got)}") from error

    @property
    def title(self) -> str:
        """What the run is called, with its schedule and its seed."""
        path = self.path.absolute()
        # In a job the directory is that of the seed.
        name = path.parent.name if path.name == f"seed-{self.settings.seed}" else path.name
        if self.settings.is_race and self.settings.schedule.name != name:
            name = f"{name} ({self.settings.schedule.name})"
        return f"{name}, seed {self.settings.seed}"

    @property
    def finished(self) -> bool:
        """Whether the run has its results."""
        exist = (self.path / SUMMARY).exists() and (self.path / PAYOFF).exists()
        # A race that was made longer has results of its first stages.
        return exist and bool(self.summary()["stages"] >= self.settings.schedule.n_stages)

    # Teams that can play:

    @property
    def game(self) -> Game:
        """The game that is raced; a game of your own is imported.

        ValueError or PluginError if that is not possible, or if it is another game. If only its
        source has changed, a warning says so.
        """
        own = self.settings.game
        if isinstance(own, OwnGame) and (changed := own.changed()):
            warn_caller(f"{self.path}: {changed}")
        return self.settings.evaluation_game

    @property
    def pursuit(self) -> Pursuit:
        """The game, if it is pursuit and evasion; ValueError for another one."""
        self.check_pursuit()
        game = self.game
        assert isinstance(game, Pursuit)
        return game

    def check_pursuit(self, instead: str = "") -> None:
        """Raise ValueError, which says what serves `instead`, for another game than pursuit."""
        if not isinstance(self.settings.game, PursuitSettings):
            raise ValueError(
                f"{self.path}: expected a run of pursuers and evaders, got one of the game "
                f"{self.settings.game.source}{'; ' if instead else ''}{instead}"
            )

    @cached_property
    def teams(self) -> Mapping[str, Any]:
        """For each team its archive as a population, a genome a generation, or its script.

        Errors and the warning are those of `archive` and `game`.
        """
        game = self.game
        archive = self.archive()
        # One population has one key.
        teams = dict(zip(reversed(self.facts.keys), reversed(TEAMS), strict=True))
        return {key: self.player(game, teams[key], genomes) for key, genomes in archive.items()}

    @property
    def sides(self) -> tuple[Any, Any]:
        """The teams of both sides; one population of a symmetric game plays both."""
        first, second = self.facts.keys
        return self.teams[first], self.teams[second]

    def player(self, game: Game, team: Team, genomes: Genomes) -> Any:
        """Return what plays for a team: its genomes as a population; without any, its opponent.

        That is a script, or a player, such as the program that the run has kept, which is run.
        """
        schedule = self.settings.schedule
        if not len(genomes):
            assert isinstance(schedule, Against)
            assert isinstance(game, Pursuit)
            program = self.config.get("opponent_program")
            return game.opponent_without_genomes(team, schedule.opponent, program)
        if team in self.settings.learning_teams:
            return game.population(team, genomes)
        # Opponents of a single team may come from a run with other hidden layers.
        return game.opponents(team, genomes, self.config.get("opponent_policy", {}))

    def key_of(self, team: str) -> str:
        """Return the key of a team in `teams`, of its key or name; ValueError for another one."""
        keys = self.facts.keys
        if team in keys:
            return team
        check_choice("team", team, dict.fromkeys(self.facts.teams))
        return keys[self.facts.teams.index(team)]

    def last(self, team: str) -> Any:
        """Return the last generation of a team, as a population of one genome, or its opponent."""
        policy = self.teams[self.key_of(team)]
        if not hasattr(policy, "genomes"):
            return policy
        return replace(policy, genomes=policy.genomes[-1:])

    def generation_at(self, team: str, matches: int) -> int:
        """Return the newest generation of `team` after so many training matches of both teams.

        To compare runs at equal budgets: ``teams[team].genomes[generation_at(team, n)]``. It is at
        most the last one of `teams`.
        """
        key = self.key_of(team)
        ends: dict[int, int] = {}
        for row in self.rows(0):
            if row["team"] == key:  # counts never fall
                ends[row["generation"]] = row["matches"]
        finished = sum(end <= matches for end in ends.values())
        return min(finished, self.generation(team, -1))  # `teams` may have been read before the log

    def policy(
        self,
        team: Team,
        generation: int = -1,
        *,
        sampled: bool | None = None,
        seed: int | None = None,
    ) -> Any:
        """Return a genome of the run as a policy, which also plays as a team of an environment.

        Parameters
        ----------
        team : {"pursuer", "evader"}
            Team of the genome.
        generation : int, optional
            Its generation; negative numbers count from the end.
        sampled, seed : bool and int, optional
            As for the policies; `sampled` for networks alone.

        Returns
        -------
        NetworkPolicy or RatingPolicy
            What plays.

        Raises
        ------
        IndexError, ValueError
            If there is no such generation or team, a script plays for the team, or the game is
            one of your own.
        """
        self.check_pursuit("`genomes` returns its genomes")
        check_choice("team", team, TEAMS)
        policy = self.teams[team]
        if not hasattr(policy, "genomes"):
            raise ValueError(f"team: expected one that learned, got {team}: {policy} plays for it")
        genome = policy.genomes[self.generation(team, generation, "generation")]
        return acting(policy.policy, genome, sampled=sampled, seed=seed)

    def generation(self, team: str, index: int, name: str = "") -> int:
        """Return the number of a generation in `teams`, from 0 on; a script has one.

        Parameters
        ----------
        team : str
            Key or name of the team.
        index : int
            The generation; negative numbers count from the end.
        name : str, optional
            What the message of an error begins with. The default is the team.

        Raises
        ------
        IndexError, ValueError
            If there is no such generation or team.
        """
        policy = self.teams[self.key_of(team)]
        count = team_size(policy)
        if not -count <= index < count:
            expected = f"a generation from 0 to {count - 1}"
            raise IndexError(f"{name or team}: expected {expected}, got {index}")
        return index % count


def last_generation(directory: str | Path, team: Team) -> Any:
    """Return the last genome of a team in a run directory; ValueError if there is none."""
    run = StoredRun(directory)
    last = run.last(run.facts.keys[TEAMS.index(team)])
    if not hasattr(last, "genomes"):
        raise ValueError(f"{directory}: expected a run with genomes of {PLURALS[team]}, got none")
    return last
