"""Whom the teams of a race meet: their samplers, and what archives compare."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from matrixworld.coevolution.opponents.archive_sampler import ArchiveSampler
from matrixworld.coevolution.opponents.pareto import PayoffFunction
from matrixworld.coevolution.opponents.registry import SAMPLERS
from matrixworld.coevolution.opponents.samplers import OpponentSampler
from matrixworld.coevolution.runs.training import Training
from matrixworld.coevolution.seeding import Phase, training_seeds
from matrixworld.coevolution.settings import RaceSettings
from matrixworld.coevolution.types import TEAMS, FloatArray, Genome, Genomes, Members, Team, other
from matrixworld.policy import Population
from matrixworld.rollout import Matches

EVEN = 0.5
"""The capture rate at which neither team wins."""
DECIMALS = 6
"""Differences of capture rates, which are float32, count up to this one."""


class Matchmaking:
    """The samplers of both teams of a race, each among the other's archived generations.

    Parameters
    ----------
    settings : name the samplers.
    training : plays and counts the matches that archives compare.
    archive : per team the genomes of generations 0, 1, ..., as they grow.

    Attributes
    ----------
    samplers : per team whom it meets.
    """

    def __init__(
        self, settings: RaceSettings, training: Training, archive: Mapping[Team, list[Genome]]
    ) -> None:
        self.settings, self.training, self.archive = settings, training, archive
        self.samplers: dict[Team, OpponentSampler] = {
            team: SAMPLERS[settings.meets(team)](max(1, settings.met(team)), settings.archive_size)
            for team in TEAMS
        }

    def admit(self, team: Team, new: range, opponents: range) -> None:
        """Let the archive of a team, if it keeps one, compare generations with opponents.

        Parameters
        ----------
        new : generations of the team that there are since it was last called.
        opponents : the same of the other team.
        """
        selection = self.samplers[team]
        if isinstance(selection, ArchiveSampler):
            outcome = self._outcome(team, graded=selection.graded)
            selection.update(np.array(new), np.array(opponents), outcome)

    def most_admitted(self, team: Team, new: int, opponents: int) -> int:
        """Return the most episodes that admitting costs a team of so many generations."""
        selection = self.samplers[team]
        if not isinstance(selection, ArchiveSampler):
            return 0
        pairs = selection.max_pairs(new, opponents)
        return pairs * self.settings.archive_episodes * self.settings.worlds

    def _outcome(self, team: Team, *, graded: bool) -> PayoffFunction:
        """Return payoffs of generations (n,) against opponents (m,): rates, or who wins."""

        def outcome(candidates: Members, tests: Members) -> FloatArray:
            sides = {team: candidates, other(team): tests}
            captured = self._capture_rates(sides["pursuer"], sides["evader"])
            payoff = captured if team == "pursuer" else 1.0 - captured.T
            return payoff if graded else (1.0 + np.sign(np.round(payoff - EVEN, DECIMALS))) / 2.0

        return outcome

    def _capture_rates(self, pursuers: Members, evaders: Members) -> FloatArray:
        """Return (n, m) mean capture rates; a pair's seeds depend on the pair alone."""
        episodes, seed = self.settings.archive_episodes, self.settings.seed
        seeds = [
            training_seeds(seed, int(g), int(h), Phase.ARCHIVE, 0, episodes)
            for g in pursuers
            for h in evaders
        ]
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
