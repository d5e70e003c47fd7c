"""Matchmaking of a race: the opponent samplers of both teams, and the matches of archives."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from matrixworld.coevolution.opponents.own import archive_of
from matrixworld.coevolution.opponents.pareto import PayoffFunction
from matrixworld.coevolution.opponents.registry import new_sampler
from matrixworld.coevolution.opponents.samplers import OpponentSampler
from matrixworld.coevolution.runs.training import Training
from matrixworld.coevolution.seeding import Phase, training_seeds
from matrixworld.coevolution.settings.race import RaceSettings
from matrixworld.coevolution.types import TEAMS, FloatArray, Genome, Genomes, Members, Team, other
from matrixworld.play.rollout import Matches
from matrixworld.world.policy import Population

EVEN = 0.5
"""Capture rate at which neither team wins."""
DECIMALS = 6
"""Capture rates are float32: differences beyond this decimal are rounding errors."""


class Matchmaking:
    """The opponent samplers of both teams of a race.

    Parameters
    ----------
    settings : RaceSettings
        Settings of the race, with the names of the samplers.
    training : Training
        Plays and counts the matches that archives need to compare candidates.
    archive : mapping of str to list of ndarray of float32, shape (genes,)
        Genomes of generations 0, 1, ... of each team. The lists grow during the race.

    Attributes
    ----------
    samplers : dict of str to OpponentSampler
        Sampler of each team, which chooses among the archived generations of the other team.
    """

    def __init__(
        self, settings: RaceSettings, training: Training, archive: Mapping[Team, list[Genome]]
    ) -> None:
        self.settings: RaceSettings = settings
        self.training: Training = training
        self.archive: Mapping[Team, list[Genome]] = archive
        self.samplers: dict[Team, OpponentSampler] = {
            team: new_sampler(settings, team) for team in TEAMS
        }

    def admit(self, team: Team, new: range, opponents: range) -> None:
        """Add new generations to a team's archive, if its sampler keeps one.

        Parameters
        ----------
        team : {"pursuer", "evader"}
            The team.
        new : range
            Generations of the team since the last call.
        opponents : range
            Generations of the other team since the last call.
        """
        sampler = archive_of(self.samplers[team])
        if sampler is not None:
            payoff = self._payoff_function(team, graded=sampler.graded)
            sampler.update(np.array(new), np.array(opponents), payoff)

    def max_admission_matches(self, team: Team, new: int, opponents: int) -> int:
        """Return an upper bound of the episodes that `admit` plays in a call.

        Parameters
        ----------
        team : {"pursuer", "evader"}
            The team.
        new, opponents : int
            Number of generations of the team and of the other team so far.
        """
        sampler = archive_of(self.samplers[team])
        if sampler is None:
            return 0
        pairs = sampler.max_pairs(new, opponents)
        return pairs * self.settings.archive_episodes * self.settings.worlds

    def _payoff_function(self, team: Team, *, graded: bool) -> PayoffFunction:
        """Return a function that plays generations (n,) against opponents (m,).

        Its payoffs (n, m) are rates if `graded`, otherwise 1 for a win, 0.5 for a draw and 0.
        """

        def payoff(candidates: Members, tests: Members) -> FloatArray:
            generations = {team: candidates, other(team): tests}
            captured = self._capture_rates(generations["pursuer"], generations["evader"])
            # Archives are the same for both teams: rows are candidates, and higher is better.
            rates = captured if team == "pursuer" else 1.0 - captured.T
            return rates if graded else (1.0 + np.sign(np.round(rates - EVEN, DECIMALS))) / 2.0

        return payoff

    def _capture_rates(self, pursuers: Members, evaders: Members) -> FloatArray:
        """Return mean capture rates (n, m); the seeds of a pair depend on that pair only."""
        episodes, seed = self.settings.archive_episodes, self.settings.seed
        seeds = [
            training_seeds(seed, int(g), int(h), Phase.ARCHIVE, 0, episodes)
            for g in pursuers
            for h in evaders
        ]
        # Matches in the order of the seeds: all episodes of a pair, then the next pair.
        n, m = len(pursuers), len(evaders)
        g, h = np.repeat(np.arange(n), m * episodes), np.tile(np.arange(m).repeat(episodes), n)
        scores = self.training.play(
            self._population("pursuer", pursuers),
            self._population("evader", evaders),
            Matches.of(g, h, np.concatenate(seeds)),
        )
        rates = scores.capture_rate.mean(axis=1, dtype=np.float64)
        return np.asarray(rates.reshape(n, m, episodes).mean(axis=2))

    def _population(self, team: Team, generations: Members) -> Population:
        genomes: Genomes = np.stack([self.archive[team][int(g)] for g in generations])
        return self.training.population(genomes)
