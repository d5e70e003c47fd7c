"""One team learns for some epochs while its opponents stand still."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from deap import algorithms
from numpy.typing import NDArray

from matrixworld.coevolution.fitness import win_rates
from matrixworld.coevolution.learners.learner import Learner
from matrixworld.coevolution.learners.toolbox import Candidates, generate_update_toolbox
from matrixworld.coevolution.opponents.samplers import OpponentSampler, Stateless
from matrixworld.coevolution.runs.training import Training
from matrixworld.coevolution.seeding import (
    Purpose,
    keyed_generator,
    learning_phase,
    training_seeds,
)
from matrixworld.coevolution.storage.run_log import SEVERAL
from matrixworld.coevolution.types import TEAMS, Indices, Seeds, Team
from matrixworld.policy import TeamPolicy


class Matchup(NamedTuple):
    """Whom the candidates of an epoch meet: some opponents, each candidate on seeds (n, c)."""

    epoch: int
    opponents: Indices
    seeds: Seeds


@dataclass(frozen=True)
class TeamPhase:
    """Epochs of one team in one generation.

    Parameters
    ----------
    training : plays, counts and logs.
    learner : of `team`; improved in place.
    team : that learns.
    generation : of `team`, the one that is being learned.
    opponents : all that there are, a population or a script.
    selection : which of them are met in an epoch.
    on_epoch : called after each epoch has been scored.
    """

    training: Training
    learner: Learner
    team: Team
    generation: int
    opponents: TeamPolicy
    selection: OpponentSampler
    on_epoch: Callable[[], None]

    def run(self, epochs: range) -> None:
        """Let DEAP's generate-update loop drive the learner through `epochs`."""
        matchups: Iterator[Matchup] = (self._matchup(epoch) for epoch in epochs)
        if isinstance(self.selection, Stateless):
            # All of them now: between matches, which leave nothing of it in the caches, this takes
            # several times as long.
            matchups = iter(list(matchups))
        generators = [self._generator(Purpose.LEARN, epoch) for epoch in epochs]
        toolbox = generate_update_toolbox(
            self.learner,
            lambda candidates: self.score(candidates, next(matchups)),
            iter(generators),
        )
        algorithms.eaGenerateUpdate(toolbox, ngen=len(epochs), verbose=False)

    def score(self, candidates: Candidates, meeting: Matchup) -> NDArray[np.float64]:
        """Return the fitness (n,) of an epoch's candidates against the opponents of that epoch."""
        met, team = meeting.opponents, self.team
        scores = self.training.play_candidates(
            team, candidates.genomes, self.opponents, met, meeting.seeds
        )

        def table(values: NDArray[np.float64]) -> NDArray[np.float64]:
            return values.reshape(meeting.seeds.shape)

        if not isinstance(self.selection, Stateless):
            self.selection.tell(met, table(win_rates(scores, team)))
        values = self.training.fitness(scores, team, table)
        self.training.record(
            scores,
            values,
            team=team,
            generation=self.generation,
            epoch=meeting.epoch,
            opponent=int(met[0]) if len(met) == 1 else SEVERAL,
        )
        self.on_epoch()
        return values

    def _matchup(self, epoch: int) -> Matchup:
        available = 1 if isinstance(self.opponents, str) else len(self.opponents.genomes)
        met = self.selection.sample(available, epoch, self._generator(Purpose.OPPONENTS, epoch))
        match = self.learner.match_of_candidate
        seeds = np.stack([self._seeds(int(index), epoch)[match] for index in met], axis=1)
        return Matchup(epoch, met, seeds)

    def _seeds(self, opponent: int, epoch: int) -> Seeds:
        """Return the seeds of an epoch's matches with one opponent."""
        own, seed = self.generation, self.training.settings.seed
        generations = (own, opponent) if self.team == "pursuer" else (opponent, own)
        count = int(self.learner.match_of_candidate.max()) + 1
        return training_seeds(seed, *generations, learning_phase(self.team), epoch, count)

    def _generator(self, purpose: Purpose, epoch: int) -> np.random.Generator:
        key = (TEAMS.index(self.team), self.generation, epoch)
        return keyed_generator(self.training.settings.seed, purpose, *key)
